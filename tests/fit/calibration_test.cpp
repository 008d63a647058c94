// Calibration against posteriors in closed form and against months of a shop with known inputs.
#include "fit/calibration.h"

#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "fit/fit_error.h"
#include "fit/shop_calibration.h"
#include "models/math/normal.h"
#include "sim/kernel/random_stream.h"
#include "sim/shop/run.h"

using namespace verstat::fit;
using verstat::sim::RandomStream;

namespace {

double noise(RandomStream& stream) {
  return verstat::models::normal_quantile(stream.uniform());
}

// y1 = 10 a + 4 b, y2 = 3 b - a, with normal months.
SimulateMonths linear_months(std::uint64_t seed) {
  return [seed](const std::vector<std::vector<double>>& points, std::uint64_t first) {
    std::vector<std::vector<double>> months;
    for (std::size_t k = 0; k < points.size(); ++k) {
      RandomStream stream(seed, "shop", "month", first + k);
      const double a = points[k][0];
      const double b = points[k][1];
      const double e1 = noise(stream);
      const double e2 = noise(stream);
      months.push_back({10 * a + 4 * b + 2 * e1, 3 * b - a + 0.5 * e2});
    }
    return months;
  };
}

}  // namespace

TEST_CASE("linear totals with normal scatter: the posterior is the one of textbooks", "[fit]") {
  // Flat knowledge: the posterior is normal with mean A^-1 y and covariance A^-1 S A^-T (limits far away).
  Eigen::Matrix2d a;
  a << 10, 4, -1, 3;
  const Eigen::Vector2d y(10 * 5 + 4 * 2, 3 * 2 - 5);
  const Eigen::Matrix2d s = Eigen::Vector2d(4, 0.25).asDiagonal();
  const Eigen::Matrix2d covariance = a.inverse() * s * a.inverse().transpose();
  CalibrationOptions options;
  options.points_per_round = 200;
  options.chain_steps = 10'000;
  const Calibration c = calibrate({{.name = "a", .low = 0, .high = 10}, {.name = "b", .low = -3, .high = 7}},
                                  {{.name = "y1", .value = y[0]}, {.name = "y2", .value = y[1]}}, {1, 1},
                                  linear_months(1), options);
  CHECK(c.inputs[0].mean == Approx(5).margin(4 * std::sqrt(covariance(0, 0) / 20)));
  CHECK(c.inputs[1].mean == Approx(2).margin(4 * std::sqrt(covariance(1, 1) / 20)));
  CHECK(c.inputs[0].sd == Approx(std::sqrt(covariance(0, 0))).epsilon(0.15));
  CHECK(c.inputs[1].sd == Approx(std::sqrt(covariance(1, 1))).epsilon(0.15));
  CHECK(c.correlation[0][1] ==
        Approx(covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1))).margin(0.12));
  CHECK(c.largest_r_hat < 1.05);
  CHECK(c.misfit_p_value > 0.05);
  CHECK(c.totals[0].inside);
  CHECK_FALSE(std::abs(c.totals[0].start_mean - y[0]) < 20);  // it was far off at the start
  CHECK(c.months == 3 * 200 + 2 * options.check_points);
}

TEST_CASE("knowledge and month weigh as their precisions", "[fit]") {
  // One input known to 5 +- 1, one month that says 6.5 +- 1: 5.75 +- 0.707.
  CalibrationOptions options;
  options.points_per_round = 300;
  const Calibration c = calibrate(
      {{.name = "a", .low = 0, .high = 10, .mean = 5, .sd = 1}}, {{.name = "y", .value = 6.5}}, {5},
      [](const std::vector<std::vector<double>>& points, std::uint64_t first) {
        std::vector<std::vector<double>> months;
        for (std::size_t k = 0; k < points.size(); ++k) {
          RandomStream stream(4, "shop", "month", first + k);
          months.push_back({points[k][0] + noise(stream)});
        }
        return months;
      },
      options);
  CHECK(c.inputs[0].mean == Approx(5.75).margin(0.1));
  CHECK(c.inputs[0].sd == Approx(std::sqrt(0.5)).epsilon(0.08));
  CHECK(c.inputs[0].prior_sd == Approx(1).epsilon(0.01));
  CHECK(c.inputs[0].sd_ratio == Approx(std::sqrt(0.5)).epsilon(0.08));
}

TEST_CASE("what only a product shows, and what nothing shows, is said", "[fit]") {
  const SimulateMonths product = [](const std::vector<std::vector<double>>& points, std::uint64_t first) {
    std::vector<std::vector<double>> months;
    for (std::size_t k = 0; k < points.size(); ++k) {
      RandomStream stream(6, "shop", "month", first + k);
      months.push_back({std::log(points[k][0]) + std::log(points[k][1]) + 0.02 * noise(stream)});
    }
    return months;
  };
  const UncertainInput free{.name = "a", .low = 1, .high = 4, .logarithmic = true};
  UncertainInput second = free;
  second.name = "b";
  UncertainInput silent = free;
  silent.name = "c";
  const Calibration c =
      calibrate({free, second, silent}, {{.name = "ab", .value = std::log(4.0)}}, {2, 1, 2}, product, {});
  CHECK(c.correlation[0][1] < -0.95);
  CHECK(c.inputs[2].sd_ratio == Approx(1).margin(0.1));
  REQUIRE(c.directions.size() == 3);
  CHECK(c.directions[0].sd_ratio < 0.1);  // the product is known
  CHECK(c.directions[0].weights[0] == Approx(c.directions[0].weights[1]).epsilon(0.1));
  CHECK(c.directions[2].sd_ratio > 0.8);  // the quotient is not
  // A month that no input can make.
  const Calibration impossible =
      calibrate({free, second, silent}, {{.name = "ab", .value = 6}}, {2, 1, 2}, product, {});
  CHECK(impossible.misfit_p_value < 0.01);
  CHECK_FALSE(impossible.totals[0].inside);
  // A total that never changes.
  CHECK_THROWS_WITH(calibrate({free}, {{.name = "n", .value = 3}}, {2},
                              [](const auto& points, std::uint64_t) {
                                return std::vector<std::vector<double>>(points.size(), {3.0});
                              },
                              {}),
                    Catch::Contains("\"n\" is 3 in every simulated month"));
}

TEST_CASE("intervals cover the truth in 93 to 97 % of the months", "[fit]") {
  CalibrationOptions options;
  options.points_per_round = 60;
  options.rounds = 2;
  options.check_points = 5;
  options.chain_steps = 2'000;
  int covered = 0;
  int of = 0;
  for (int k = 0; k < 600; ++k) {
    RandomStream stream(8, "truth", "month", static_cast<std::uint64_t>(k));
    const double a = stream.uniform(3, 7);
    const double b = stream.uniform(0, 4);
    const auto month = linear_months(1000 + static_cast<std::uint64_t>(k))({{a, b}}, 999'999)[0];
    options.seed = static_cast<std::uint64_t>(k);
    const Calibration c =
        calibrate({{.name = "a", .low = 0, .high = 10}, {.name = "b", .low = -3, .high = 7}},
                  {{.name = "y1", .value = month[0]}, {.name = "y2", .value = month[1]}}, {1, 1},
                  linear_months(2000 + static_cast<std::uint64_t>(k)), options);
    for (const auto& [truth, in] : {std::pair{a, c.inputs[0]}, std::pair{b, c.inputs[1]}}) {
      covered += in.bounds.low <= truth && truth <= in.bounds.high ? 1 : 0;
      ++of;
    }
  }
  INFO(covered << " of " << of);  // 1140 of 1200 expected, standard error 7.5
  CHECK(covered > 0.93 * of);
  CHECK(covered < 0.97 * of);
}

TEST_CASE("a month of the heavy-lathe cell with shorter lives is traced back to them", "[fit]") {
  using nlohmann::json;
  using verstat::scenarios::Change;
  json scenario =
      verstat::scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
  scenario["simulation"]["warmup_min"] = 1000;
  const double counted_min = 20'000;
  json truth = verstat::scenarios::apply(
      scenario,
      {Change{"/inserts/0/edge_life/mean_ref_min", 48.0}, Change{"/tools/0/change/positioning_min", 4.0},
       Change{"/simulation/horizon_min", 1000 + counted_min}, Change{"/simulation/replications", 1},
       Change{"/simulation/seed", "77"}});
  const auto month = verstat::shop::run_scenario(verstat::scenarios::load(truth), 1);
  CalibrationSpec spec{.file = "month", .counted_min = counted_min, .totals = {}, .inputs = {}};
  for (const char* kpi : {"parts_good", "tool/roughing tool/failures", "tool/roughing tool/planned_changes",
                          "machine/lathe 1/state/planned_change"})
    spec.totals.push_back({.name = kpi, .value = *month.values[0][*month.index_of(kpi)]});
  spec.inputs = {{.name = "/inserts/0/edge_life/mean_ref_min", .low = 30, .high = 90},
                 {.name = "/tools/0/change/positioning_min", .low = 0.5, .high = 8}};
  CalibrationOptions options;
  options.points_per_round = 60;
  options.rounds = 2;
  options.check_points = 20;
  options.chain_steps = 5'000;
  const Report one = calibrate_shop(scenario, spec, options, 1, {});
  const auto& inputs = one.json["inputs"];
  CHECK(inputs[0]["bounds"]["low"].get<double>() < 48);
  CHECK(inputs[0]["bounds"]["high"].get<double>() > 48);
  CHECK(inputs[0]["mean"].get<double>() == Approx(48).margin(5));
  CHECK(inputs[1]["bounds"]["low"].get<double>() < 4);
  CHECK(inputs[1]["bounds"]["high"].get<double>() > 4);
  CHECK(inputs[0]["sd_ratio"].get<double>() < 0.3);
  CHECK(one.changes.size() == 2);
  for (const auto& total : one.json["totals"]) CHECK(total["inside"].get<bool>());
  // The same on any number of threads.
  CHECK(calibrate_shop(scenario, spec, options, 3, {}).json == one.json);
  spec.totals[0].name = "parts_god";
  CHECK_THROWS_WITH(calibrate_shop(scenario, spec, options, 1, {}), Catch::Contains("no KPI \"parts_god\""));
  spec.inputs[0].high = 1e9;
  CHECK_THROWS_WITH(calibrate_shop(scenario, spec, options, 1, {}),
                    Catch::Contains("/inserts/0/edge_life/mean_ref_min"));
}
