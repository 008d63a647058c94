// The checks of card K302; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k302_combined_grinding_roughness.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k302;

namespace {

// The worked magnitudes of the card: rounded tips, 20 grains per mm2, 30 m/s, 10 m/min, D 250 mm.
MarkGeometry wheel() {
  return {.profile_exponent = 0.5,
          .tip_exponent = 1.5,
          .chip_coefficient = 0.9,
          .width_coefficient = 0.283,
          .grains_per_mm2 = 20,
          .wheel_speed_m_s = 30,
          .work_speed_m_min = 10,
          .up_grinding = true,
          .wheel_diameter_mm = 250,
          .wheel_layer_mm = 0.03};
}

MarkField field(double shift_um, std::int64_t contacts, std::int64_t sparkout = 0,
                const MarkGeometry& geometry = wheel()) {
  const MarkIntensity marks = abrasive_mark_intensity(geometry);
  return {marks.g_per_mm_nu, marks.nu, shift_um, contacts, sparkout};
}

double ra_at_median(const MarkField& f) {
  return roughness_ra({f, median_depth(f).median_depth_um}).ra_um;
}

}  // namespace

TEST_CASE("K302: the table of typical magnitudes", "[K302]") {
  struct Row {
    double shift_um;
    std::int64_t contacts;
    double w_m, h, ra, ra_half_layer, ra_exact, rmax, rz;
  };
  constexpr std::array rows{Row{0, 1, 2.741, 5.845, 1.007, 0.914, 0.974, 5.295, 4.853},
                            Row{2, 1000, 2.704, 5.222, 0.907, 0.973, 0.876, 4.672, 4.229},
                            Row{0.5, 1000, 2.172, 3.898, 0.630, 0.803, 0.613, 3.348, 2.905},
                            Row{0.1, 1000, 1.473, 2.565, 0.399, 0.557, 0.389, 2.015, 1.573}};
  const double theta = abrasive_mark_intensity(wheel()).theta;
  for (const Row& row : rows) {
    const MarkField f = field(row.shift_um, row.contacts);
    INFO("Q = " << row.shift_um);
    const double height_um = layer_height_steady({f, 0.99}).mechanical_height_um;
    CHECK(median_depth(f).median_depth_um == Approx(row.w_m).margin(6e-4));
    CHECK(height_um == Approx(row.h).margin(6e-4));
    CHECK(ra_at_median(f) == Approx(row.ra).margin(6e-4));
    CHECK(roughness_ra({f, height_um / 2}).ra_um == Approx(row.ra_half_layer).margin(6e-4));
    CHECK(roughness_ra_exact(f).ra_um == Approx(row.ra_exact).margin(6e-4));
    const ExtremeRoughness extremes = roughness_extremes({height_um, theta, 1.5, 0.8});
    CHECK(extremes.rmax_um == Approx(row.rmax).margin(6e-4));
    CHECK(extremes.rz_um == Approx(row.rz).margin(6e-4));
  }
}

TEST_CASE("K302: the mean line halves the removal probability, and the density is its slope", "[K302]") {
  verstat::test::property([] {
    const double shift_um = *rc::gen::inRange(0, 300) * 0.01;
    const MarkField f = field(shift_um, *rc::gen::inRange(1, 2000), *rc::gen::inRange(0, 10));
    const double w_m = median_depth(f).median_depth_um;
    RC_ASSERT(std::abs(profile_distribution({{f, w_m}, 0}).probability_removed - 0.5) < 1e-9);
    const double y_um = *rc::gen::inRange(-90, 90) * 0.01 * w_m;
    const double step_um = 1e-5;
    const double slope = (profile_distribution({{f, w_m}, y_um + step_um}).probability_removed -
                          profile_distribution({{f, w_m}, y_um - step_um}).probability_removed) /
                         (2 * step_um);
    const double density = profile_distribution({{f, w_m}, y_um}).density_per_um;
    RC_ASSERT(std::abs(slope - density) < 1e-5 * std::max(1.0, density));
  });
  CHECK(profile_distribution({{field(0, 1), 2}, -2}).probability_removed == 0);
}

TEST_CASE("K302: a single contact has closed forms", "[K302]") {
  verstat::test::property([] {
    const double nu = *rc::gen::inRange(11, 60) * 0.1;
    const MarkField f{1e6, nu, 0.7, 1, 0};
    const double w_mm = std::pow(std::numbers::ln2 / 1e6, 1 / nu);
    RC_ASSERT(std::abs(median_depth(f).median_depth_um / (1000 * w_mm) - 1) < 1e-12);
    RC_ASSERT(std::abs(ra_at_median(f) / (2000 * w_mm / (std::numbers::pi * nu * std::numbers::ln2)) - 1) <
              1e-12);
  });
}

TEST_CASE("K302: many contacts with a small shift", "[K302]") {
  const MarkField f = field(1e-4, 1'000'000);
  const double expected_um =
      1000 * std::pow((f.nu + 1) * 1e-7 * std::numbers::ln2 / f.g_per_mm_nu, 1 / (f.nu + 1));
  CHECK(median_depth(f).median_depth_um == Approx(expected_um).epsilon(1e-3));
}

TEST_CASE("K302: Ra falls with finer shift, slower work, spark-out, more grains, larger and faster wheels",
          "[K302]") {
  verstat::test::property([] {
    const double shift_um = *rc::gen::inRange(5, 300) * 0.01;
    const double ra = ra_at_median(field(shift_um, 1000));
    RC_ASSERT(ra_at_median(field(shift_um * 0.9, 1000)) <= ra);
    RC_ASSERT(ra_at_median(field(shift_um, 1000, 3)) < ra);
    const auto with = [&](auto change) {
      MarkGeometry g = wheel();
      change(g);
      return ra_at_median(field(shift_um, 1000, 0, g));
    };
    RC_ASSERT(with([](MarkGeometry& g) { g.work_speed_m_min = 8; }) < ra);
    RC_ASSERT(with([](MarkGeometry& g) { g.grains_per_mm2 = 25; }) < ra);
    RC_ASSERT(with([](MarkGeometry& g) { g.wheel_diameter_mm = 300; }) < ra);
    RC_ASSERT(with([](MarkGeometry& g) { g.wheel_speed_m_s = 35; }) < ra);
  });
}

TEST_CASE("K302: the normal Ra exceeds the exact one by a few per cent", "[K302]") {
  for (const double shift_um : {0.0, 0.1, 0.5, 2.0}) {
    const MarkField f = field(shift_um, shift_um == 0 ? 1 : 1000);
    const double excess = ra_at_median(f) / roughness_ra_exact(f).ra_um - 1;
    CHECK(excess > 0.0265);
    CHECK(excess < 0.0375);
  }
  for (const double nu : {2.0, 3.0, 4.5})
    for (const double shift_um : {0.05, 0.5, 3.0}) {
      const MarkField f{5e6, nu, shift_um, 1000, 0};
      const double excess = ra_at_median(f) / roughness_ra_exact(f).ra_um - 1;
      CHECK(excess > 0.005);
      // 5 %, and up to 7 % for nu = 2 where an older contact ends just above the mean line.
      CHECK(excess < (nu == 2.0 ? 0.07 : 0.05));
    }
}

TEST_CASE("K302: the exact moments equal 20000 midpoints, where nu is small too", "[K302]") {
  for (const double nu : {0.7, 1.0, 1.5, 2.5})
    for (const double shift_um : {0.0, 0.3, 2.0}) {
      const MarkField f{1.76e6 * std::pow(1e-3, 2.5 - nu), nu, shift_um, 200, 2};
      INFO("nu = " << nu << ", Q = " << shift_um);
      const auto marks = [&](double u_um) {
        double sum = 2 * std::pow(u_um / 1000, nu);
        for (int i = 0; i < 200 && u_um > i * shift_um; ++i)
          sum += std::pow((u_um - i * shift_um) / 1000, nu);
        return f.g_per_mm_nu * sum;
      };
      const auto left = [&](double u_um) { return std::exp(-marks(u_um)); };
      double top_um = 1e9;
      for (double low_um = 0, k = 0; k < 200; ++k)
        (marks((low_um + top_um) / 2) < 40 ? low_um : top_um) = (low_um + top_um) / 2;
      double mean_um = 0;
      double square_um2 = 0;
      for (int k = 0; k < 20000; ++k) {
        const double u = top_um * (k + 0.5) / 20000;
        mean_um += left(u) * top_um / 20000;
        square_um2 += 2 * u * left(u) * top_um / 20000;
      }
      double ra_um = 0;
      for (int k = 0; k < 20000; ++k) ra_um += 2 * (1 - left(mean_um * (k + 0.5) / 20000)) * mean_um / 20000;
      const ExactRoughness exact = roughness_ra_exact(f);
      const double close = nu < 1 ? 3e-5 : 2e-6;  // of both sums, where S has cusps
      CHECK(exact.mean_depth_um == Approx(mean_um).epsilon(close));
      CHECK(exact.ra_um == Approx(ra_um).epsilon(close));
      CHECK(exact.rq_um == Approx(std::sqrt(square_um2 - mean_um * mean_um)).epsilon(close));
    }
}

TEST_CASE("K302: H > Rmax > Rz, closer over a longer base", "[K302]") {
  verstat::test::property([] {
    const double chi = *rc::gen::inRange(5, 40) * 0.1;
    const double length_mm = *rc::gen::inRange(1, 100) * 0.1;
    const ExtremeRoughness shorter = roughness_extremes({6, 1e7, chi, length_mm});
    const ExtremeRoughness longer = roughness_extremes({6, 1e7, chi, 2 * length_mm});
    RC_ASSERT(6 > shorter.rmax_um);
    RC_ASSERT(shorter.rmax_um > shorter.rz_um);
    RC_ASSERT(longer.rmax_um > shorter.rmax_um);
    RC_ASSERT(longer.rmax_um - longer.rz_um < shorter.rmax_um - shorter.rz_um);
  });
}

TEST_CASE("K302: chi = 1.5 with a layer as deep as the cut is the special case", "[K302]") {
  MarkGeometry g = wheel();
  g.wheel_layer_mm = 0.008;
  const ExtremeRoughness general = roughness_extremes({6, abrasive_mark_intensity(g).theta, 1.5, 0.8});
  const ExtremeRoughness special = roughness_extremes_chi15({6, 8, 20, 30, 10, true, 250, 0.8});
  CHECK(special.rmax_um == Approx(general.rmax_um).epsilon(1e-12));
  CHECK(6 - special.rz_um == Approx(6 - general.rz_um).epsilon(4e-4));  // 2.948 printed, 2.94704 exact
  CHECK(extreme_height_coefficients({1.5}).rz == Approx(2.94704).margin(5e-6));
}

TEST_CASE("K302: equal dissolution leaves Ra alone, full dissolution levels it", "[K302]") {
  CHECK(combined_ra({0.63, 4, 0.8, 0.8}).ra_um == 0.63);
  CHECK(combined_ra({0.63, 4, 9, 1}).ra_um == 0);
}

TEST_CASE("K302: the defect layer falls by the removal and stays at what each pass brings", "[K302]") {
  verstat::test::property([] {
    const double removed = *rc::gen::inRange(1, 30);
    const double introduced = *rc::gen::inRange(0, 20);
    const double initial = *rc::gen::inRange(0, 100);
    const double target = *rc::gen::inRange(0, 60);
    const std::int64_t passes = passes_to_reach_defect({initial, removed, introduced, target}).passes;
    // Brute force: repeat the recursion.
    std::int64_t counted = -1;
    double depth = initial;
    for (int i = 0; i <= 200 && counted < 0; ++i) {
      if (depth <= target) counted = i;
      depth = defect_depth_after_pass({depth, removed, introduced}).depth_um;
    }
    RC_ASSERT(passes == counted);
    RC_ASSERT(depth >= introduced);
  });
  CHECK(defect_depth_after_pass({2, 15, 10}).depth_um == 10);
}

TEST_CASE("K302: eq. (16) is near the exact solution as the card says", "[K302]") {
  struct Row {
    double ratio, deviation;
  };
  for (const Row row :
       {Row{1.05, -0.19}, Row{1.2, -0.15}, Row{1.5, -0.10}, Row{2, -0.06}, Row{3, -0.006}, Row{5, 0.03}}) {
    const DefectFromTemperature d = defect_depth_temperature({row.ratio * 700, 700, 0, 8, 0.01});
    CHECK(d.depth_um / d.depth_exact_um - 1 == Approx(row.deviation).margin(0.0055));
  }
  CHECK(defect_depth_temperature({700, 700, 0, 8, 0.01}).depth_um == 0);
}

TEST_CASE("K302: bad input names itself", "[K302]") {
  MarkGeometry g = wheel();
  g.up_grinding = false;
  g.work_speed_m_min = 1800;
  CHECK_THROWS_WITH(
      abrasive_mark_intensity(g),
      "K302.abrasive_mark_intensity: work_speed_m_min = 1800, must stay below the wheel speed in "
      "down grinding");
  CHECK_THROWS_WITH(median_depth({1e6, 0, 0, 1, 0}),
                    "K302.median_depth: nu = 0, allowed nu > 0 (exponent m + chi + 1/2)");
  CHECK_THROWS_WITH(defect_depth_temperature({900, 20, 20, 8, 0.01}),
                    Catch::Contains("transform_temp_c = 20, must be above ambient_c"));
}
