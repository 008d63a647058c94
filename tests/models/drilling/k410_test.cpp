// The checks of card K410; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k410_drilling_fem.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k410;

TEST_CASE("K410: the printed thrust is the handbook's without the material", "[K410]") {
  const auto plain = drilling_loads({10, 0.35, 600});
  CHECK(plain.thrust_n == Approx(3261).margin(0.5));
  CHECK(plain.torque_nm == Approx(14.9).margin(0.05));
  CHECK(plain.power_kw == Approx(0.94).margin(0.005));
  CHECK(drilling_loads({10, 0.35, 600, 731}).thrust_n == Approx(3200).margin(2));
  CHECK(drilling_loads({10, 0.35, 600, 410}).thrust_n == Approx(2073).margin(0.5));
  CHECK(cutting_speed({10, 600}).speed_m_min == Approx(18.85).margin(0.005));
}

TEST_CASE("K410: handbook speeds", "[K410]") {
  CHECK(drilling_handbook_speed({10, 0.35, 25}).speed_m_min == Approx(21.9).margin(0.05));
  CHECK(drilling_handbook_speed({10, 0.35, 45}).speed_m_min == Approx(19.4).margin(0.05));
  // At 0.2 mm/rev the first line holds; the second is 1.5 % away.
  const double at = drilling_handbook_speed({10, 0.2, 25}).speed_m_min;
  CHECK(at == Approx(drilling_handbook_speed({10, 0.2 - 1e-9, 25}).speed_m_min).epsilon(1e-7));
  CHECK(drilling_handbook_speed({10, 0.2 + 1e-9, 25}).speed_m_min / at == Approx(1.0147).margin(5e-4));
}

TEST_CASE("K410: loads rise with diameter, feed and strength, time falls with n s", "[K410]") {
  verstat::test::property([] {
    const double d = *rc::gen::inRange(20, 590) * 0.1, s = *rc::gen::inRange(20, 1150) * 1e-3;
    const double strength = *rc::gen::inRange(300, 1190);
    const auto base = drilling_loads({d, s, 500, strength});
    for (const auto& more :
         {drilling_loads({d + 0.5, s, 500, strength}), drilling_loads({d, s + 0.01, 500, strength}),
          drilling_loads({d, s, 500, strength + 5})}) {
      RC_ASSERT(more.thrust_n > base.thrust_n);
      RC_ASSERT(more.torque_nm > base.torque_nm);
    }
    const DrilledHole hole{d, 30, 118, 2, 1, 500, s, true};
    auto faster = hole;
    faster.spindle_rpm = 510;
    RC_ASSERT(drilling_main_time(faster).main_time_min < drilling_main_time(hole).main_time_min);
  });
  // A blind hole reaches its depth with the tip; a point of 180 degrees has no cone.
  CHECK(drilling_main_time({10, 25, 118, 2, 9, 600, 0.35, false}).path_mm == 27);
  CHECK(drilling_main_time({10, 25, 179.9999, 2, 1, 600, 0.35, true}).path_mm == Approx(28).margin(1e-4));
}

TEST_CASE("K410: an exact power law is recovered, whatever the runs", "[K410]") {
  verstat::test::property([] {
    const double c = *rc::gen::inRange(1, 1000), p = *rc::gen::inRange(-20, 21) * 0.1,
                 q = *rc::gen::inRange(-20, 21) * 0.1;
    Runs runs;
    for (int k = 0; k < 6; ++k) {
      // Far from collinear: the first factor doubles every run, the second alternates.
      const double x = std::pow(2.0, k) * (1 + 0.01 * *rc::gen::inRange(0, 10)), y = k % 2 == 0 ? 0.1 : 0.35;
      runs.factors.push_back({x, y});
      runs.response.push_back(c * std::pow(x, p) * std::pow(y, q));
    }
    const auto fit = fit_power_law(runs);
    RC_ASSERT(std::abs(fit.coefficient / c - 1) < 1e-10);
    RC_ASSERT(std::abs(fit.exponents[0] - p) < 1e-11);
    RC_ASSERT(std::abs(fit.exponents[1] - q) < 1e-11);
    RC_ASSERT(fit.max_relative_error < 1e-11);
    const auto value = power_law_value({fit.coefficient, fit.exponents, runs.factors[3]}).value;
    RC_ASSERT(std::abs(value / runs.response[3] - 1) < 1e-11);
  });
  const auto table = fit_power_law(
      {{{6, 0.15}, {6, 0.35}, {10, 0.15}},
       {680 * 6 * std::pow(0.15, 0.7), 680 * 6 * std::pow(0.35, 0.7), 6800 * std::pow(0.15, 0.7)}});
  CHECK(table.coefficient == Approx(680).epsilon(1e-12));
  CHECK(table.exponents[0] == Approx(1).epsilon(1e-12));
  CHECK(table.exponents[1] == Approx(0.7).epsilon(1e-12));
  CHECK(table.rms_log_error == 0);  // no degree of freedom left
}

TEST_CASE("K410: the fit is the least squares", "[K410]") {
  const Runs runs{{{6}, {8}, {10}, {14}}, {1.0, 1.5, 1.6, 2.9}};
  const auto fit = fit_power_law(runs);
  const auto squares = [&](double c, double e) {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
      sum += std::pow(std::log(c) + e * std::log(runs.factors[k][0]) - std::log(runs.response[k]), 2);
    return sum;
  };
  const double best = squares(fit.coefficient, fit.exponents[0]);
  CHECK(fit.rms_log_error == Approx(std::sqrt(best / 2)).epsilon(1e-12));
  for (double change : {-1e-3, 1e-3}) {
    CHECK(squares(fit.coefficient * (1 + change), fit.exponents[0]) > best);
    CHECK(squares(fit.coefficient, fit.exponents[0] + change) > best);
  }
}

TEST_CASE("K410: the scale calibrates the model", "[K410]") {
  const Comparison in{{110, 231, 99}, {100, 210, 90}};
  const auto off = model_agreement(in);
  CHECK(off.scale == Approx(1 / 1.1).epsilon(1e-12));
  CHECK(off.mean_relative_error == Approx(0.1));
}

TEST_CASE("K410: bad input names itself", "[K410]") {
  CHECK_THROWS_WITH(fit_power_law({{{6, 0.15}, {6, 0.25}, {6, 0.35}}, {1, 2, 3}}),
                    "K410.fit_power_law: factors = 6, in every run: factor 1 must vary between the runs");
  CHECK_THROWS_WITH(
      fit_power_law({{{2, 4}, {3, 9}, {4, 16}, {5, 25}}, {1, 2, 3, 4}}),
      "K410.fit_power_law: factors: two or more are collinear in logarithms, their exponents are lost");
  CHECK_THROWS_WITH(model_agreement({{1, 2}, {1}}),
                    "K410.model_agreement: reference = 1, entries: must be as many as model");
}
