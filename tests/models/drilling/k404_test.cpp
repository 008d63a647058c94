// The checks of card K404; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k404_step_drill_delamination.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k404;

namespace {
constexpr double gd_paper = 29.48;  // recovered from the table of the paper
constexpr double nu_paper = 0.32;
}  // namespace

TEST_CASE("K404: the printed table of the next stage and the first-stage thrust", "[K404]") {
  // Ratio, force; the first three rows are printed to fewer digits.
  constexpr std::array rows{std::pair{0.1, 90.0},   std::pair{0.2, 92.4},   std::pair{0.3, 105.0},
                            std::pair{0.4, 131.1},  std::pair{0.5, 186.5},  std::pair{0.6, 396.07},
                            std::pair{0.7, 332.82}, std::pair{0.8, 229.83}, std::pair{0.9, 200.37},
                            std::pair{1.0, 188.25}};
  for (const auto& [xi, force_n] : rows) {
    INFO(xi);
    const auto next = critical_thrust_next_stage({gd_paper, nu_paper, xi});
    CHECK(next.thrust_n == Approx(force_n).epsilon(xi < 0.35 ? 0.0024 : 0.0003));
    CHECK(next.valid == (xi < 0.65));
  }
  CHECK(critical_thrust_first_stage({gd_paper, nu_paper}).thrust_n == Approx(61.5).epsilon(0.015));
}

TEST_CASE("K404: every critical thrust grows with the root of gd", "[K404]") {
  const double gd = 3.7;
  CHECK(critical_thrust_first_stage({4 * gd, 0.2}).thrust_n ==
        Approx(2 * critical_thrust_first_stage({gd, 0.2}).thrust_n));
  CHECK(critical_thrust_next_stage({4 * gd, 0.2, 0.3}).thrust_n ==
        Approx(2 * critical_thrust_next_stage({gd, 0.2, 0.3}).thrust_n));
  CHECK(critical_thrust_clamped({4 * gd, 0.2, 0.3}).thrust_n ==
        Approx(2 * critical_thrust_clamped({gd, 0.2, 0.3}).thrust_n));
}

TEST_CASE("K404: eq. (1) is the energy release of a simply supported disc", "[K404]") {
  // G = P^2/2 dC/dA with the centre compliance C = (3+nu) a^2 / (16 pi (1+nu) D), A = pi a^2.
  const double nu = 0.25;
  const double d = 140;
  const double g = 0.2;
  const double dc_da = (3 + nu) / (16 * std::numbers::pi * std::numbers::pi * (1 + nu) * d);
  CHECK(critical_thrust_first_stage({g * d, nu}).thrust_n == Approx(std::sqrt(2 * g / dc_da)));
  // The compliance is that of plate_deflection at the centre.
  CHECK(plate_deflection({1, d, nu, 3, 0}).deflection_mm ==
        Approx((3 + nu) * 9 / (16 * std::numbers::pi * (1 + nu) * d)));
}

TEST_CASE("K404: the small-ratio limit of eq. (2) is the one of the card", "[K404]") {
  for (const double nu : {0.0, 0.1, 0.32, 0.45}) {
    const double disc = 4 * std::numbers::pi * std::sqrt(2 * gd_paper);
    CHECK(critical_thrust_next_stage({gd_paper, nu, 1e-6}).thrust_n ==
          Approx(disc / std::sqrt((1 - nu * nu) * (1 + 2 * nu * nu))).epsilon(1e-9));
  }
}

TEST_CASE("K404: the pole separates valid from invalid", "[K404]") {
  constexpr std::array poles{std::pair{0.0, 0.535}, std::pair{0.2, 0.600}, std::pair{0.32, 0.637},
                             std::pair{0.4, 0.657}};
  for (const auto& [nu, pole] : poles) CHECK(next_stage_pole({nu}).ratio == Approx(pole).margin(5e-4));
  verstat::test::property([] {
    const double nu = *rc::gen::inRange(0, 4500) * 1e-4;
    const double pole = next_stage_pole({nu}).ratio;
    RC_ASSERT(critical_thrust_next_stage({1, nu, pole * (1 - 1e-9)}).valid);
    RC_ASSERT(!critical_thrust_next_stage({1, nu, pole * (1 + 1e-9)}).valid);
    RC_ASSERT_THROWS_AS((void)critical_thrust_next_stage({1, nu, pole}), ModelError);
  });
}

TEST_CASE("K404: the clamped plate meets the printed row, its limit and its minimum", "[K404]") {
  constexpr std::array forces{96.5, 91.1, 85.9, 85.2, 89.7, 100.7, 121.1, 158.4, 236.6, 476.1};
  for (std::size_t k = 0; k < forces.size(); ++k)
    CHECK(critical_thrust_clamped({gd_paper, nu_paper, 0.1 * static_cast<double>(k)}).thrust_n ==
          Approx(forces[k]).margin(0.051));
  CHECK(critical_thrust_clamped({gd_paper, 0.1, 1e-9}).thrust_n ==
        Approx(4 * std::numbers::pi * std::sqrt(2 * gd_paper)));
  const auto force = [](double xi) { return critical_thrust_clamped({gd_paper, nu_paper, xi}).thrust_n; };
  double least = 0;
  for (int k = 0; k < 1000; ++k)
    if (force(k * 1e-3) < force(least)) least = k * 1e-3;
  CHECK(least == Approx(0.27).margin(0.01));
}

TEST_CASE("K404: (C1) is the energy release of a clamped annulus loaded on its hole edge", "[K404]") {
  // Deflection of the edge r = b under the ring load P of an annulus clamped at r = a, from the plate
  // equation w = P/(8 pi D) r^2 ln r + A r^2 + B ln r + C with w(a) = w'(a) = 0 and M_r(b) = 0.
  const double d = 1;
  const double nu = 0.28;
  const double b = 0.4;
  const auto compliance = [&](double a) {
    const double q = 1 / (8 * std::numbers::pi * d);
    // w' = q (2 r ln r + r) + 2 A r + B/r; w'' = q (2 ln r + 3) + 2 A - B/r^2
    // Clamped: 2 A a + B/a = -q (2 a ln a + a). Free moment: w'' + nu w'/r = 0 at b.
    const double a11 = 2 * a;
    const double a12 = 1 / a;
    const double r1 = -q * (2 * a * std::log(a) + a);
    const double a21 = 2 * (1 + nu);
    const double a22 = -(1 - nu) / (b * b);
    const double r2 = -q * ((2 * std::log(b) + 3) + nu * (2 * std::log(b) + 1));
    const double det = a11 * a22 - a12 * a21;
    const double ca = (r1 * a22 - a12 * r2) / det;
    const double cb = (a11 * r2 - r1 * a21) / det;
    const double cc = -(q * a * a * std::log(a) + ca * a * a + cb * std::log(a));
    return q * b * b * std::log(b) + ca * b * b + cb * std::log(b) + cc;
  };
  const double a = 1;
  const double step = 1e-4;
  const double dc_da =
      (compliance(a + step) - compliance(a - step)) / (2 * step) / (2 * std::numbers::pi * a);
  const double g = 1.7;
  CHECK(critical_thrust_clamped({g * d, nu, b / a}).thrust_n ==
        Approx(std::sqrt(2 * g / std::abs(dc_da))).epsilon(1e-6));
}

TEST_CASE("K404: the deflection vanishes at the support, and its inverse keeps the limit", "[K404]") {
  CHECK(plate_deflection({60, 160, 0.32, 10, 10}).deflection_mm == 0);
  verstat::test::property([] {
    const double nu = *rc::gen::inRange(0, 45) * 1e-2;
    const double a = *rc::gen::inRange(1, 400) * 0.1;
    const double w_centre = plate_deflection({60, 160, nu, a, 0}).deflection_mm;
    const double limit = w_centre * *rc::gen::inRange(1, 999) * 1e-3;
    const double r = stage_radius_for_deflection({60, 160, nu, a, limit}).radius_mm;
    RC_ASSERT(plate_deflection({60, 160, nu, a, r}).deflection_mm == Approx(limit).epsilon(1e-9));
    RC_ASSERT(plate_deflection({60, 160, nu, a, r * 0.99}).deflection_mm > limit);
  });
  const double at_centre = plate_deflection({60, 160, 0.32, 10, 0}).deflection_mm;
  CHECK(stage_radius_for_deflection({60, 160, 0.32, 10, at_centre * 1.0001}).radius_mm == 0);
  CHECK(stage_radius_for_deflection({60, 160, 0.32, 10, 0}).radius_mm == 10);
}

TEST_CASE("K404: at the feed limit the thrust of each stage times safety is the critical one", "[K404]") {
  const StepDrillLoad load{10, 0.35, 61.5, 131.1, 90, 45, 0.7, 1.5};
  const auto limit = step_drill_feed_limit(load);
  CHECK(90 * 3.5 * std::pow(limit.feed_first_mm_rev, 0.7) * 1.5 == Approx(61.5));
  CHECK(45 * 6.5 * std::pow(limit.feed_next_mm_rev, 0.7) * 1.5 == Approx(131.1));
  CHECK(limit.binding_stage == 1);
  const auto other = step_drill_feed_limit({10, 0.35, 61.5, 10, 90, 45, 0.7, 1.5});
  CHECK(other.binding_stage == 2);
  CHECK(other.feed_max_mm_rev == other.feed_next_mm_rev);
  CHECK(step_drill_feed_limit({10, 0.5, 60, 60, 90, 90, 0.8, 1}).binding_stage == 1);  // a tie
}

TEST_CASE("K404: no ratio on a fine scan allows more feed than the best one", "[K404]") {
  verstat::test::property([] {
    const double nu = *rc::gen::inRange(0, 46) * 1e-2;
    const double c_1 = *rc::gen::inRange(5, 300);
    const double c_2 = *rc::gen::inRange(5, 300);
    const auto best = best_step_ratio({gd_paper, nu, 10, c_1, c_2, 0.8, 1.5});
    const double f_c1 = critical_thrust_clamped({gd_paper, nu, 0}).thrust_n;
    double scanned = 0;
    for (int k = 0; k <= 400; ++k) {
      const double xi = 0.1 + 0.002 * k;
      const double f_c2 = critical_thrust_clamped({gd_paper, nu, xi}).thrust_n;
      scanned =
          std::max(scanned, step_drill_feed_limit({10, xi, f_c1, f_c2, c_1, c_2, 0.8, 1.5}).feed_max_mm_rev);
    }
    RC_ASSERT(scanned <= best.feed_max_mm_rev * (1 + 1e-12));
    RC_ASSERT(scanned >= best.feed_max_mm_rev * 0.96);  // the scan comes near it
  });
  CHECK(best_step_ratio({gd_paper, nu_paper, 10, 90, 45, 0.8, 1.5}).ratio == Approx(0.36).margin(0.005));
  CHECK(best_step_ratio({gd_paper, nu_paper, 10, 1, 900, 0.8, 1.5}).ratio == 0.9);
}

TEST_CASE("K404: the probability of delamination is one half at the critical thrust", "[K404]") {
  CHECK(delamination_probability({80, 0.1, 80, 0.2}).probability == 0.5);
  CHECK(delamination_probability({80, 0, 80, 0}).probability == 0.5);
  CHECK(delamination_probability({79, 0, 80, 0}).probability == 0);
  CHECK(delamination_probability({81, 0, 80, 0}).probability == 1);
  CHECK(delamination_probability({81, 0.1, 80, 0}).probability > 0.5);
}

TEST_CASE("K404: stiffness and energy release rate of the worked numbers", "[K404]") {
  CHECK(energy_release_rate({1.6, 14000, 0.32}).g_ic_n_mm == Approx(0.1641).margin(5e-5));
  CHECK(bending_stiffness({14000, 1.0, 0.32}).stiffness_n_mm ==
        Approx(8 * bending_stiffness({14000, 0.5, 0.32}).stiffness_n_mm));
}

TEST_CASE("K404: the working relief tends to the static one at large radii", "[K404]") {
  CHECK(working_relief({10, 0.1, 1e6, 60}).relief_deg == Approx(10).margin(1e-5));
  CHECK(working_relief({10, 0.2, 0.6, 60}).relief_deg < working_relief({10, 0.1, 0.6, 60}).relief_deg);
}

TEST_CASE("K404: flat points leave only the lengths in the travel", "[K404]") {
  CHECK(step_drilling_time({6, 10, 0.4, 180, 180, 8, 1, 2, 0.1, 2000}).travel_mm == Approx(17));
  CHECK(step_drilling_time({6, 10, 0.4, 90, 180, 8, 1, 2, 0.1, 2000}).travel_mm == Approx(19));
  CHECK(step_drilling_time({6, 10, 0.4, 180, 90, 8, 1, 2, 0.1, 2000}).time_min == Approx(0.1));
}

TEST_CASE("K404: bad input names itself", "[K404]") {
  CHECK_THROWS_WITH(plate_deflection({60, 160, 0.32, 10, 11}),
                    "K404.plate_deflection: r = 11, must not be above a");
  CHECK_THROWS_WITH(critical_thrust_clamped({1, 0.3, 1}),
                    "K404.critical_thrust_clamped: xi = 1, allowed 0 <= xi < 1 (ratio of the stage "
                    "diameters, 0 for the first stage)");
}
