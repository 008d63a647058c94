// The checks of card K104; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k104_cutoff_wheel_sides.h"
#include "models/math/solve.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k104;

namespace {

// The example of the card.
const SideGrains example{.layer_mm = 0.165,
                         .radial_feed_mm_s = 10,
                         .workpiece_diameter_mm = 75.5,
                         .grain_tip_radius_mm = 0.05,
                         .relative_depth = 0.08,
                         .wheel_speed_m_s = 80};

}  // namespace

TEST_CASE("K104: the printed coefficient and the example", "[K104]") {
  CHECK(density_coefficient({}).coefficient == Approx(3.530170).margin(5e-7));
  const double gamma_1_5 = std::sqrt(std::numbers::pi) / 2;
  CHECK(density_coefficient({}).coefficient ==
        Approx(std::numbers::ln2 * 6 / (1.5 * gamma_1_5 * gamma_1_5)).epsilon(1e-14));
  CHECK(density_coefficient({2.2, 0.7, 2}).coefficient ==
        Approx(density_coefficient({2.2, 0.7}).coefficient * 2 / std::numbers::ln2));
  CHECK(max_side_grain_density(example).density_mm2 == Approx(0.0213).margin(5e-5));
}

TEST_CASE("K104: eq. (1) is the double integral it is derived from", "[K104]") {
  // Width removed per unit time at depth delta, integrated over the grain heights and over time.
  const SideContact c{0.03, 60, 0.025, 0.2, 0.009, 0.04, 0.75, 1.7, 0.6};
  const double profile = 2 * std::numbers::sqrt2 * std::pow(c.grain_tip_radius_mm, 1 - c.m);
  const auto rate = [&](double delta) {
    // (delta-u)^m u^(k-1) with u = delta s^(1/k), which leaves no singularity at u = 0
    const double inner = integrate(
        [&](double s) {
          return std::pow(delta * (1 - std::pow(s, 1 / c.k)), c.m) * std::pow(delta, c.k) / c.k;
        },
        0, 1, 1e-9);
    return c.grain_density_mm2 * 1000 * c.wheel_speed_m_s * c.chip_coefficient * profile * c.k /
           std::pow(c.active_depth_mm, c.k) * inner;
  };
  const double a = integrate([&](double t) { return rate(c.side_feed_mm_s * t); }, 0, c.contact_time_s, 1e-9);
  CHECK(side_removal_exponent(c).exponent == Approx(a).epsilon(1e-7));
}

TEST_CASE("K104: the largest density gives the median at t and nearly all of the layer at 2t", "[K104]") {
  verstat::test::property([] {
    SideGrains grains = example;
    grains.relative_depth = *rc::gen::inRange(1, 50) * 1e-2;
    grains.grain_tip_radius_mm = *rc::gen::inRange(10, 150) * 1e-3;
    grains.k = *rc::gen::inRange(100, 300) * 1e-2;
    grains.m = *rc::gen::inRange(30, 101) * 1e-2;
    const double t = grains.relative_depth * grains.grain_tip_radius_mm;
    const double feed =
        side_feed({grains.layer_mm, grains.radial_feed_mm_s, grains.workpiece_diameter_mm}).feed_mm_s;
    const auto removal = [&](double path_mm) {
      return side_removal_exponent({max_side_grain_density(grains).density_mm2, grains.wheel_speed_m_s, feed,
                                    path_mm / feed, 2 * t, grains.grain_tip_radius_mm, 0.8, grains.k,
                                    grains.m});
    };
    RC_ASSERT(removal(t).exponent == Approx(std::numbers::ln2).epsilon(1e-10));
    RC_ASSERT(removal(t).probability == Approx(0.5).epsilon(1e-10));
    RC_ASSERT(removal(2 * t).exponent ==
              Approx(std::numbers::ln2 * std::pow(2, grains.k + grains.m + 1)).epsilon(1e-10));
  });
  // k = 1.5, m = 0.5: 8 ln 2
  const double t = 0.004;
  const double feed = side_feed({0.165, 10, 75.5}).feed_mm_s;
  const auto whole = side_removal_exponent(
      {max_side_grain_density(example).density_mm2, 80, feed, 2 * t / feed, 2 * t, 0.05});
  CHECK(whole.exponent == Approx(5.545).margin(5e-4));
  CHECK(whole.probability == Approx(0.996).margin(5e-4));
}

TEST_CASE("K104: density, depth and feed are mutual inverses", "[K104]") {
  verstat::test::property([] {
    const double layer = *rc::gen::inRange(50, 300) * 1e-3;
    const double feed = *rc::gen::inRange(5, 300) * 0.1;
    const double d = *rc::gen::inRange(20, 120);
    const double rho = *rc::gen::inRange(10, 150) * 1e-3;
    const double depth = *rc::gen::inRange(1, 50) * 1e-2;
    const double speed = *rc::gen::inRange(20, 120);
    const double n = max_side_grain_density({layer, feed, d, rho, depth, speed, 0.7}).density_mm2;
    RC_ASSERT(relative_cut_depth({n, layer, feed, d, rho, speed, 0.7}).relative_depth == Approx(depth));
    const auto least = min_radial_feed({n, layer, d, rho, depth, speed, 0.7});
    RC_ASSERT(least.feed_mm_s == Approx(feed));
    RC_ASSERT(least.feed_mm_min == Approx(60 * feed));
  });
}

TEST_CASE("K104: the density follows the powers of its inputs", "[K104]") {
  const double n = max_side_grain_density(example).density_mm2;
  const auto changed = [&](double SideGrains::*member, double factor) {
    SideGrains grains = example;
    grains.*member *= factor;
    return max_side_grain_density(grains).density_mm2 / n;
  };
  CHECK(changed(&SideGrains::layer_mm, 2) == Approx(2));
  CHECK(changed(&SideGrains::radial_feed_mm_s, 2) == Approx(2));
  CHECK(changed(&SideGrains::workpiece_diameter_mm, 2) == Approx(0.5));
  CHECK(changed(&SideGrains::chip_coefficient, 2) == Approx(0.5));
  CHECK(changed(&SideGrains::wheel_speed_m_s, 2) == Approx(0.5));
  CHECK(changed(&SideGrains::relative_depth, 4) == Approx(1.0 / 8));
  SideGrains sharper = example;  // the same depth t with a radius four times as large
  sharper.grain_tip_radius_mm *= 4;
  sharper.relative_depth /= 4;
  CHECK(max_side_grain_density(sharper).density_mm2 / n == Approx(0.5));
}

TEST_CASE("K104: the layer of the table stays within its share of the diameter", "[K104]") {
  struct Row {
    double d, wheel, layer_um;
  };
  constexpr Row rows[] = {{33.5, 300, 80},  {42.3, 300, 110}, {48, 300, 135},   {48, 400, 130},
                          {60, 400, 150},   {60, 500, 145},   {60, 600, 140},   {75.5, 400, 170},
                          {75.5, 500, 165}, {75.5, 600, 160}, {88.5, 500, 190}, {88.5, 600, 185}};
  for (const Row& row : rows) {
    const double layer = side_layer_thickness({row.d, row.wheel}).layer_mm;
    CHECK(layer * 1000 == Approx(row.layer_um).epsilon(1e-12));
    CHECK(layer / row.d == Approx(0.00245).margin(0.0004));  // 0.0021 to 0.0028, rounded
  }
  verstat::test::property([] {
    const double d = *rc::gen::inRange(200, 1200) * 0.1;
    const double wheel = *rc::gen::inRange(300, 600);
    const double layer = side_layer_thickness({d, wheel}).layer_mm;
    RC_ASSERT(layer >= 0.002 * d);
    RC_ASSERT(layer <= 0.003 * d);
    RC_ASSERT(side_layer_thickness({d, wheel + 1}).layer_mm <= layer);
    if (d < 119.9) RC_ASSERT(side_layer_thickness({d + 0.1, wheel}).layer_mm > layer);
  });
  CHECK(side_layer_thickness({60, 100}).layer_mm == side_layer_thickness({60, 300}).layer_mm);
  CHECK(side_layer_thickness({60, 900}).layer_mm == side_layer_thickness({60, 600}).layer_mm);
  CHECK(side_layer_thickness({30, 300}).layer_mm == Approx(0.080 * 30 / 33.5));
  CHECK(side_layer_thickness({100, 300}).layer_mm == Approx(0.200 * 100 / 88.5));
}

TEST_CASE("K104: removal rises with contact time from nothing", "[K104]") {
  const auto p = [](double time_s) {
    return side_removal_exponent({0.02, 80, 0.02, time_s, 0.02, 0.05}).probability;
  };
  CHECK(p(0) == 0);
  for (int k = 0; k < 100; ++k) CHECK(p((k + 1) * 0.01) > p(k * 0.01));
  CHECK(p(1.0) > 0.99);  // the path equals the active depth: legal
}

TEST_CASE("K104: the thresholds belong to the next regime", "[K104]") {
  CHECK(grain_cut_regime({0}).regime == CutRegime::plastic);
  CHECK(grain_cut_regime({0.04}).regime == CutRegime::transition);
  CHECK(grain_cut_regime({0.08}).regime == CutRegime::cutting);
  CHECK(grain_cut_regime({0.25}).regime == CutRegime::intensive_cutting);
  CHECK(grain_cut_regime({std::nextafter(0.25, 0)}).regime == CutRegime::cutting);
}

TEST_CASE("K104: bad input names itself", "[K104]") {
  CHECK_THROWS_WITH(side_removal_exponent({0.02, 80, 0.02, 0.5, 0.008, 0.05}),
                    "K104.side_removal_exponent: contact_time_s = 0.5, must not carry side_feed_mm_s * "
                    "contact_time_s beyond active_depth_mm");
  CHECK_THROWS_WITH(
      cutoff_time_and_kerf({75, 0, 4, 0.1}),
      "K104.cutoff_time_and_kerf: radial_feed_mm_s = 0, allowed radial_feed_mm_s > 0 (radial feed, "
      "usually 0.5-30)");
}
