// The checks of card K102; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/cutting/k102_insert_nose_radius_forces.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k102;

namespace {

constexpr double deg = std::numbers::pi / 180;

// Width of the tool outline at height y as the card states it, for a brute-force section.
double side(double y, double psi, double r) {
  const double h = r * (1 - std::cos(psi));
  return y <= h ? std::sqrt(2 * r * y - y * y) : r * std::sin(psi) + (y - h) / std::tan(psi);
}

// Chip area as the paper's strip integral, A = integral of min(W, S) over the depth.
double brute_area(const ChipSectionInputs& in) {
  constexpr int strips = 40000;
  double sum = 0;
  for (int k = 0; k < strips; ++k) {
    const double y = (k + 0.5) * in.depth_mm / strips;
    const double width = side(y, in.lead_angle_deg * deg, in.nose_radius_mm) +
                         side(y, in.end_angle_deg * deg, in.nose_radius_mm);
    sum += std::min(width, in.feed_mm_rev);
  }
  return sum * in.depth_mm / strips;
}

}  // namespace

TEST_CASE("K102: a sharp nose has the closed section", "[K102]") {
  verstat::test::property([] {
    const double t = *rc::gen::inRange(100, 500) * 0.01;
    const double s = *rc::gen::inRange(5, 60) * 0.01;
    const double phi = *rc::gen::inRange(30, 90) * deg;
    const double phi1 = *rc::gen::inRange(30, 90) * deg;
    const ChipSection c = uncut_chip_section({t, s, phi / deg, phi1 / deg, 0});
    RC_ASSERT(std::abs(c.edge_length_mm - (t / std::sin(phi) + s * std::sin(phi) / std::sin(phi + phi1))) <
              1e-10);
    RC_ASSERT(std::abs(c.chip_area_mm2 - (t * s - s * s * std::sin(phi) * std::sin(phi1) /
                                                      (2 * std::sin(phi + phi1)))) < 1e-10);
  });
}

TEST_CASE("K102: the section agrees with strips for any angles and radius", "[K102]") {
  for (const double lead : {10.0, 45.0, 75.0, 90.0})
    for (const double end : {1.0, 10.0, 60.0, 90.0})
      for (const double r : {0.2, 0.8, 3.0})
        for (const double feed : {0.05, 0.6, 2.5}) {
          const ChipSectionInputs in{0.7, feed, lead, end, r};
          INFO(lead << " " << end << " " << r << " " << feed);
          const ChipSection c = uncut_chip_section(in);
          CHECK(c.chip_area_mm2 == Approx(brute_area(in)).epsilon(1e-6));
          CHECK(c.mean_chip_thickness_mm == Approx(c.chip_area_mm2 / c.edge_length_mm));
          // At the residual height the outline is as wide as the feed, unless the depth ends first.
          const double width =
              side(c.residual_height_mm, lead * deg, r) + side(c.residual_height_mm, end * deg, r);
          if (c.residual_height_mm < 0.7)
            CHECK(width == Approx(feed).epsilon(1e-10));
          else
            CHECK(width <= feed * (1 + 1e-12));
        }
}

TEST_CASE("K102: area grows with the nose radius towards t S; the edge first shortens", "[K102]") {
  double last = 0;
  for (const double r : {0.0, 0.1, 0.3, 0.5, 1.0, 2.0, 5.0, 50.0}) {
    const double area = uncut_chip_section({3, 0.5, 60, 60, r}).chip_area_mm2;
    CHECK(area > last);
    CHECK(area < 1.5);
    last = area;
  }
  CHECK(last == Approx(1.5).epsilon(1e-3));
  const auto length = [](double r) { return uncut_chip_section({3, 0.5, 60, 60, r}).edge_length_mm; };
  CHECK(length(0.3) == Approx(3.90).margin(0.005));
  CHECK(length(0.3) < length(0));
  CHECK(length(0.3) < length(0.5));
  CHECK(length(1) < length(2));
}

TEST_CASE("K102: small feeds leave t S and the ridge S^2 / 8r", "[K102]") {
  const ChipSection c = uncut_chip_section({3, 1e-4, 60, 60, 1});
  CHECK(c.chip_area_mm2 / 1e-4 == Approx(3).epsilon(1e-6));
  CHECK(c.residual_height_mm == Approx(1e-8 / 8).epsilon(1e-6));
}

TEST_CASE("K102: Table 4 but its last row, which leaves out the straight part", "[K102]") {
  struct Row {
    double r, length, area;
  };
  for (const Row row : {Row{0, 3.964, 1.391}, Row{0.5, 3.961, 1.489}, Row{1, 4.188, 1.494},
                        Row{1.5, 4.420, 1.496}, Row{2, 4.655, 1.497}, Row{2.5, 4.894, 1.497}}) {
    const ChipSection c = uncut_chip_section({3, 0.5, 60, 60, row.r});
    CHECK(c.edge_length_mm == Approx(row.length).epsilon(0.0015));
    CHECK(c.chip_area_mm2 == Approx(row.area).epsilon(0.0015));
  }
  CHECK(3 * 60 * deg + 0.0104348 / std::sin(60 * deg) < 3.391);  // the printed value is arc alone ...
  CHECK(uncut_chip_section({3, 0.5, 60, 60, 3}).edge_length_mm == Approx(3.391 + 1.732).epsilon(1e-3));
}

TEST_CASE("K102: all 28 handbook values of Table 3 to 1 N", "[K102]") {
  struct Row {
    double r, pz, py, px, p;
  };
  for (const Row row :
       {Row{0, 3302, 823, 2604, 4285}, Row{0.5, 3547, 1132, 2604, 4543}, Row{1, 3791, 1407, 2604, 4809},
        Row{1.5, 3914, 1578, 2604, 4958}, Row{2, 4077, 1715, 2604, 5132}, Row{2.5, 4158, 1835, 2604, 5238},
        Row{3, 4240, 1955, 2604, 5346}}) {
    const TurningForce f = handbook_turning_force({3, 0.5, 100, row.r});
    CHECK(f.pz_n == Approx(row.pz).margin(1.6));
    CHECK(f.py_n == Approx(row.py).margin(1.6));
    CHECK(f.px_n == Approx(row.px).margin(1.6));
    CHECK(f.p_n == Approx(row.p).margin(1.6));
  }
}

TEST_CASE("K102: the material factor is a factor, P_x ignores the nose, clamped ends", "[K102]") {
  TurningInputs in{3, 0.5, 100, 0.7};
  const TurningForce one = handbook_turning_force(in);
  in.material_factor *= 2;
  const TurningForce two = handbook_turning_force(in);
  CHECK(two.p_n == Approx(2 * one.p_n));
  CHECK(two.py_n == Approx(2 * one.py_n));
  double last_z = 0;
  double last_y = 0;
  for (const double r : {0.0, 0.4, 0.8, 1.2, 1.6, 2.4, 3.0}) {
    const TurningForce f = handbook_turning_force({3, 0.5, 100, r});
    CHECK(f.px_n == Approx(handbook_turning_force({3, 0.5, 100, 0}).px_n));
    CHECK(f.pz_n > last_z);
    CHECK(f.py_n > last_y);
    last_z = f.pz_n;
    last_y = f.py_n;
  }
  CHECK(handbook_turning_force({3, 0.5, 100, 3}).pz_n == handbook_turning_force({3, 0.5, 100, 8}).pz_n);
  CHECK(handbook_turning_force({3, 0.5, 100, 1, 30}).p_n == handbook_turning_force({3, 0.5, 100, 1, 20}).p_n);
  CHECK(handbook_turning_force({3, 0.5, 100, 1, 60, -40}).p_n ==
        handbook_turning_force({3, 0.5, 100, 1, 60, -15}).p_n);
}

TEST_CASE("K102: the FEM table, its misprint at 0.5 mm, its peak at 1.0, clamped outside", "[K102]") {
  CHECK(fem_turning_force({0.5}).p_n == Approx(5186).margin(0.5));
  CHECK(fem_turning_force({0.25}).pz_n == Approx((6720 + 4690) / 2.0));
  CHECK(fem_turning_force({7}).p_n == fem_turning_force({3}).p_n);
  CHECK(fem_turning_force({1}).p_n > fem_turning_force({0.75}).p_n);
  CHECK(fem_turning_force({1}).p_n > fem_turning_force({1.25}).p_n);
}

TEST_CASE("K102: smallest discrepancy is 12.4 % at 0.5 mm", "[K102]") {
  const auto relative = [](double r) {
    return force_model_discrepancy({fem_turning_force({r}).p_n, handbook_turning_force({3, 0.5, 100, r}).p_n})
        .relative_to_fem;
  };
  CHECK(relative(0.5) == Approx(0.124).margin(0.0005));
  CHECK(relative(1.0) == Approx(0.604).margin(0.001));
  CHECK(relative(2.5) == Approx(0.383).margin(0.001));
  for (const double r : {0.0, 1.0, 1.5, 2.0, 2.5, 3.0}) CHECK(relative(r) > relative(0.5));
}

TEST_CASE("K102: chip splitter at its limit works", "[K102]") {
  for (const double l : {0.3, 0.5, 0.6, 0.7, 1.1, 2.3}) {
    const double t = chip_splitter_depth_limit({l}).max_depth_mm;
    CHECK(chip_splitter_force_factor({t, l, 0.25}).effective);
    CHECK(chip_splitter_force_factor({t, l, 0.25}).force_factor == 0.75);
    CHECK(chip_splitter_force_factor({t * 1.000001, l, 0.25}).force_factor == 1);
  }
  CHECK_FALSE(chip_splitter_force_factor({1, 0.5}).effective);  // the paper's own simulation
}

TEST_CASE("K102: rake shapes, resultant and power", "[K102]") {
  CHECK(rake_shape_force({RakeShape::peripheral_groove}).factor_p == Approx(0.707).margin(0.0005));
  CHECK(rake_shape_force({RakeShape::bevelled_land}).factor_p == Approx(0.311).margin(0.0005));
  CHECK(rake_shape_force({RakeShape::flat}).factor_p == 1);
  CHECK(resultant_force({2, 3, 6}).p_n == 7);
  CHECK(turning_power({6000, 10}).power_kw == Approx(1));
}

TEST_CASE("K102: bad input names itself", "[K102]") {
  CHECK_THROWS_WITH(
      uncut_chip_section({3, 0.5, 90, 90, 0}),
      "K102.uncut_chip_section: nose_radius_mm = 0, must be above 0 when both angles are 90: the "
      "tool has no width");
  CHECK_NOTHROW(uncut_chip_section({3, 0.5, 90, 90, 0.4}));
  CHECK_THROWS_WITH(chip_splitter_force_factor({1, 0.5, 0.3}), Catch::Contains("reduction = 0.3"));
}
