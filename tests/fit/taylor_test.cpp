// Wear curves into the extended Taylor equation: the 674 measured readings, known laws, least squares.
#include <cmath>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "fit/taylor_fit.h"
#include "models/math/normal.h"
#include "sim/kernel/random_stream.h"

using namespace verstat::fit;
using verstat::sim::RandomStream;

namespace {

WearData measured(double criterion_mm) {
  WearOptions options;
  options.criterion_mm = criterion_mm;
  return read_wear(VERSTAT_SOURCE_DIR "/tests/data/turning_wear.csv", options);
}

// Least squares of ln T by the normal equations, written on its own: speed and laboratory levels only.
struct LeastSquares {
  double speed_exponent = 0;
  double residual_variance = 0;  ///< sum of squares / runs, as maximum likelihood has it
};
LeastSquares least_squares(const WearGroup& group) {
  std::vector<std::string> laboratories;
  for (const WearRun& run : group.runs)
    if (std::find(laboratories.begin(), laboratories.end(), run.laboratory) == laboratories.end())
      laboratories.push_back(run.laboratory);
  // Centred within laboratories the levels drop out.
  double sxx = 0;
  double sxy = 0;
  double syy = 0;
  for (const std::string& laboratory : laboratories) {
    double x = 0;
    double y = 0;
    int n = 0;
    for (const WearRun& run : group.runs) {
      if (run.laboratory != laboratory) continue;
      x += std::log(run.cutting_speed_m_min);
      y += std::log(run.life.low);
      ++n;
    }
    for (const WearRun& run : group.runs) {
      if (run.laboratory != laboratory) continue;
      const double dx = std::log(run.cutting_speed_m_min) - x / n;
      const double dy = std::log(run.life.low) - y / n;
      sxx += dx * dx;
      sxy += dx * dy;
      syy += dy * dy;
    }
  }
  return {-sxy / sxx, (syy - sxy * sxy / sxx) / static_cast<double>(group.runs.size())};
}

}  // namespace

TEST_CASE("a wear curve meets the criterion between two readings, before the first, or never", "[fit]") {
  const std::vector<WearReading> curve = {{1, 0.1}, {2, 0.2}, {4, 0.4}};
  CHECK(life_at(curve, 0.3).low == Approx(3));
  CHECK(life_at(curve, 0.3).exact());
  CHECK(life_at(curve, 0.2).low == 2);
  CHECK(life_at(curve, 0.05).low == 0);
  CHECK(life_at(curve, 0.05).high == 1);
  CHECK(life_at(curve, 0.5).low == 4);
  CHECK_FALSE(life_at(curve, 0.5).failed());
}

TEST_CASE("all 674 measured readings are used, and every group is fitted or says why not", "[fit]") {
  const WearData data = measured(0.2);
  CHECK(data.table.rows_in_file == 674);
  CHECK(data.rows_used == 674);
  CHECK(data.table.dropped.empty());
  std::size_t readings = 0;
  std::size_t fitted = 0;
  std::size_t compared = 0;
  for (const WearGroup& group : data.groups) {
    bool complete = true;
    for (const WearRun& run : group.runs) {
      readings += run.readings;
      complete = complete && run.life.exact();
    }
    INFO(group.material << " / " << group.tool);
    try {
      const TaylorFit fit = fit_taylor(group, ErrorLaw::normal, {});
      ++fitted;
      CHECK(fit.exact + fit.left_censored + fit.right_censored == fit.runs);
      CHECK(fit.exponents[0].bounds.low < fit.exponents[0].value);
      CHECK(fit.exponents[0].value < fit.exponents[0].bounds.high);
      CHECK_FALSE(fit.exponents[2].fitted);  // the depth never changes within a group
      const TaylorPrediction p = predict(fit, fit.center, 0.95);
      CHECK(p.one_edge_bounds.low < p.median_bounds.low);
      CHECK(p.median_bounds.low < p.median_min);
      CHECK(p.median_min < p.median_bounds.high);
      CHECK(p.median_bounds.high < p.one_edge_bounds.high);
      if (!complete || fit.exponents[1].fitted) continue;
      ++compared;
      const LeastSquares other = least_squares(group);
      CHECK(fit.exponents[0].value == Approx(other.speed_exponent).epsilon(1e-6).margin(1e-8));
      CHECK(fit.regression.sigma * fit.regression.sigma == Approx(other.residual_variance).epsilon(1e-5));
    } catch (const FitError& e) {
      CHECK(std::string(e.what()).size() > 20);
    }
  }
  CHECK(readings == 674);
  CHECK(fitted >= 8);
  CHECK(fitted < data.groups.size());  // much of it cannot be fitted, and says so
  CHECK(compared >= 2);
}

TEST_CASE("what differs only between laboratories is no exponent", "[fit]") {
  WearGroup group{"steel", "P20", {}};
  for (const auto& [laboratory, feed] : {std::pair{"A", 0.1}, std::pair{"B", 0.2}})
    for (const double v : {100.0, 150.0, 200.0, 250.0}) {
      WearRun run{
          .laboratory = laboratory, .cutting_speed_m_min = v, .feed_mm_rev = feed, .depth_of_cut_mm = 1};
      run.life = exact_life(1e6 * std::pow(v, -2.5) * (v > 180 ? 1.1 : 1));
      run.last_time_min = run.life.low;
      group.runs.push_back(run);
    }
  const TaylorFit fit = fit_taylor(group, ErrorLaw::normal, {});
  CHECK_FALSE(fit.exponents[1].fitted);
  CHECK_THAT(fit.exponents[1].why_not, Catch::Contains("only together with the laboratory"));
  CHECK(fit.exponents[2].why_not == "the same in all runs");
  TaylorOptions pooled;
  pooled.pool_laboratories = true;
  CHECK(fit_taylor(group, ErrorLaw::normal, pooled).exponents[1].fitted);
  // Beyond the runs, and by how much nobody knows.
  const TaylorPrediction far = predict(fit, {400, 0.1, 1}, 0.95);
  REQUIRE_FALSE(far.warnings.empty());
  CHECK_THAT(far.warnings[0], Catch::Contains("400 m/min is outside the 100 to 250"));
  CHECK(predict(fit, {150, 0.1, 1}, 0.95).warnings.empty());
  group.runs.resize(2);
  CHECK_THROWS_WITH(fit_taylor(group, ErrorLaw::normal, {}),
                    Catch::Contains("2 of 2 runs crossed the criterion"));
}

TEST_CASE("known Taylor law with censored runs: exponents unbiased, intervals cover", "[fit]") {
  int repeats = 1000;
  int speed_covered = 0;
  int median_covered = 0;
  int feed_covered = 0;
  int edge_covered = 0;
  int of = 0;
  double speed_mean = 0;
  for (int k = 0; k < repeats; ++k) {
    RandomStream stream(17, "wear", "taylor", static_cast<std::uint64_t>(k));
    const auto life = [&](double v, double f, double a) {
      return 40 * std::pow(v / 150, -3.0) * std::pow(f / 0.2, -1.2) * std::pow(a, -0.5) *
             std::exp(0.3 * verstat::models::normal_quantile(stream.uniform()));
    };
    WearGroup group{"steel", "P20", {}};
    for (const double v : {100.0, 150.0, 220.0})
      for (const double f : {0.1, 0.2, 0.3})
        for (const double a : {0.5, 2.0}) {
          WearRun run{.cutting_speed_m_min = v, .feed_mm_rev = f, .depth_of_cut_mm = a};
          const double t = life(v, f, a);
          run.life = t < 150 ? exact_life(t) : survived(150);  // the slow ones outlast the test
          run.last_time_min = std::min(t, 150.0);
          group.runs.push_back(run);
        }
    const TaylorFit fit = fit_taylor(group, ErrorLaw::normal, {});
    speed_mean += fit.exponents[0].value / repeats;
    const auto covers = [](const Interval& b, double x) { return b.low <= x && x <= b.high; };
    speed_covered += covers(fit.exponents[0].bounds, 3.0) ? 1 : 0;
    feed_covered += covers(fit.exponents[1].bounds, 1.2) ? 1 : 0;
    const TaylorPrediction at = predict(fit, {150, 0.2, 1}, 0.95);
    median_covered += covers(at.median_bounds, 40) ? 1 : 0;
    for (int i = 0; i < 5; ++i, ++of) edge_covered += covers(at.one_edge_bounds, life(150, 0.2, 1)) ? 1 : 0;
  }
  INFO(speed_mean << " " << speed_covered << " " << feed_covered << " " << median_covered << " "
                  << edge_covered << " of " << of);
  CHECK(speed_mean == Approx(3).margin(0.06));
  for (const int covered : {speed_covered, feed_covered, median_covered}) {  // standard error 0.7 %
    CHECK(covered > 0.93 * repeats);
    CHECK(covered < 0.97 * repeats);
  }
  CHECK(edge_covered > 0.93 * of);
  CHECK(edge_covered < 0.97 * of);
}

TEST_CASE("without censoring the prediction interval is Student's", "[fit]") {
  // Four runs at two speeds: by hand, mean of ln T at each speed, s^2 with 2 degrees of freedom.
  WearGroup group{"steel", "P20", {}};
  for (const auto& [v, t] :
       {std::pair{100.0, 40.0}, std::pair{100.0, 60.0}, std::pair{200.0, 5.0}, std::pair{200.0, 8.0}}) {
    WearRun run{.cutting_speed_m_min = v, .feed_mm_rev = 0.2, .depth_of_cut_mm = 1};
    run.life = exact_life(t);
    run.last_time_min = 60;
    group.runs.push_back(run);
  }
  const TaylorFit fit = fit_taylor(group, ErrorLaw::normal, {});
  const double d1 = std::log(60.0 / 40.0);
  const double d2 = std::log(8.0 / 5.0);
  const double s2 = (d1 * d1 / 2 + d2 * d2 / 2) / 2;
  const TaylorPrediction p = predict(fit, {100, 0.2, 1}, 0.95);
  CHECK(p.median_min == Approx(std::sqrt(40.0 * 60.0)).epsilon(1e-8));
  CHECK(fit.scatter() == Approx(std::sqrt(s2)).epsilon(1e-6));
  CHECK(fit.cv() == Approx(std::sqrt(std::expm1(s2))).epsilon(1e-6));
  const double half = 4.302652729911275 * std::sqrt(s2 * (1 + 0.5));
  CHECK(std::log(p.one_edge_bounds.high / p.median_min) == Approx(half).epsilon(1e-5));
  CHECK(std::log(p.median_bounds.high / p.median_min) ==
        Approx(4.302652729911275 * std::sqrt(s2 / 2)).epsilon(1e-5));
  CHECK(fit.exponents[0].value == Approx(std::log(std::sqrt(2400.0 / 40.0)) / std::log(2.0)).epsilon(1e-7));
}
