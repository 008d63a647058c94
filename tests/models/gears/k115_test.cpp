// The checks of card K115; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/gears/k115_hyperboloid_roller.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k115;
namespace crossed = verstat::models::k115::detail;

namespace {

constexpr double rad = std::numbers::pi / 180;

RollerFlank random_flank() {
  RollerFlank in;
  in.tool_teeth = *rc::gen::inRange(20, 101);
  in.module_mm = *rc::gen::inRange(5, 50) * 0.1;
  in.pressure_angle_deg = *rc::gen::inRange(14, 29);
  in.roller_starts = *rc::gen::inRange(13, 34);
  in.shaft_angle_deg = *rc::gen::inRange(0, 500) * 0.1;
  in.roll_angle_deg = *rc::gen::inRange(1, 400) * 0.1;
  in.axial_position_mm = *rc::gen::inRange(-200, 201) * 0.1;
  in.branch = *rc::gen::element(-1, 1);
  in.flank = *rc::gen::element(-1, 1);
  return in;
}

double base_radius(const RollerFlank& in) {
  return 0.5 * in.module_mm * static_cast<double>(in.tool_teeth) * std::cos(in.pressure_angle_deg * rad);
}

PitchGeometry pitch(const RollerFlank& in) {
  return roller_pitch_geometry({in.roller_starts, in.module_mm, in.shaft_angle_deg, in.tool_teeth});
}

// Flank of the tool gear and its derivative over the roll angle.
struct Involute {
  double x, y, dx, dy;
  Involute(const RollerFlank& in, double psi) {
    const double r = base_radius(in);
    const auto f = static_cast<double>(in.flank);
    x = r * (std::cos(psi) + psi * std::sin(psi));
    y = f * r * (std::sin(psi) - psi * std::cos(psi));
    dx = r * psi * std::cos(psi);
    dy = f * r * psi * std::sin(psi);
  }
};

// A point of the flank carried to the roller at any turn of the tool gear, in mesh or not.
crossed::Point carried(const RollerFlank& in, double psi, double z, double phi1) {
  const Involute flank(in, psi);
  const auto geometry = pitch(in);
  return crossed::to_roller({flank.x, flank.y, z}, crossed::Turn(phi1),
                            crossed::Turn(geometry.ratio_u21 * phi1), crossed::Turn(in.shaft_angle_deg * rad),
                            geometry.centre_distance_mm, 0);
}

}  // namespace

TEST_CASE("K115: the repaired transformation preserves distances at any angles", "[K115]") {
  verstat::test::property([] {
    const auto angle = [] { return *rc::gen::inRange(-3600, 3600) * 0.1 * rad; };
    const auto length = [] { return *rc::gen::inRange(-1000, 1000) * 0.1; };
    const crossed::Point p{length(), length(), length()};
    const crossed::Point q{length(), length(), length()};
    const crossed::Turn phi1(angle());
    const crossed::Turn phi2(angle());
    const crossed::Turn gamma(angle());
    const double a = length();
    const double shift = length();
    const auto p2 = crossed::to_roller(p, phi1, phi2, gamma, a, shift);
    const auto q2 = crossed::to_roller(q, phi1, phi2, gamma, a, shift);
    RC_ASSERT(std::hypot(p2.x - q2.x, p2.y - q2.y, p2.z - q2.z) ==
              Approx(std::hypot(p.x - q.x, p.y - q.y, p.z - q.z)).margin(1e-10));
  });
}

TEST_CASE("K115: every generated point satisfies the equation of meshing", "[K115]") {
  verstat::test::property([] {
    const auto in = random_flank();
    const auto point = hyperboloid_roller_point(in);
    RC_ASSERT(point.tool_turn_deg.has_value());
    const double phi1 = *point.tool_turn_deg * rad;
    const Involute f(in, in.roll_angle_deg * rad);
    const auto geometry = pitch(in);
    const double u = geometry.ratio_u21;
    const double a = geometry.centre_distance_mm;
    const double gamma = in.shaft_angle_deg * rad;
    const double residual =
        (u * std::cos(gamma) - 1) * (f.y * f.dy + f.x * f.dx) -
        in.axial_position_mm * u * std::sin(gamma) * (f.dy * std::cos(phi1) + f.dx * std::sin(phi1)) -
        a * u * std::cos(gamma) * (f.dy * std::sin(phi1) - f.dx * std::cos(phi1));
    RC_ASSERT(std::abs(residual) < 1e-13 * a * base_radius(in) * (1 + std::abs(u)));
  });
}

TEST_CASE("K115: at contact the motion over the turn lies in the tangent plane", "[K115]") {
  verstat::test::property([] {
    const auto in = random_flank();
    const double psi = in.roll_angle_deg * rad;
    const double z = in.axial_position_mm;
    const double phi1 = *hyperboloid_roller_point(in).tool_turn_deg * rad;
    const auto slope = [&](double dpsi, double dz, double dphi) {
      const auto p = carried(in, psi + dpsi, z + dz, phi1 + dphi);
      const auto q = carried(in, psi - dpsi, z - dz, phi1 - dphi);
      const double n = std::hypot(p.x - q.x, p.y - q.y, p.z - q.z);
      return crossed::Point{(p.x - q.x) / n, (p.y - q.y) / n, (p.z - q.z) / n};
    };
    const auto across = slope(1e-5, 0, 0);
    const auto along = slope(0, 1e-4, 0);
    const auto motion = slope(0, 0, 1e-5);
    const double volume = motion.x * (across.y * along.z - across.z * along.y) +
                          motion.y * (across.z * along.x - across.x * along.z) +
                          motion.z * (across.x * along.y - across.y * along.x);
    RC_ASSERT(std::abs(volume) < 1e-6);
  });
}

TEST_CASE("K115: on parallel axes the section is an involute of base radius r over the ratio", "[K115]") {
  for (const std::int64_t flank : {-1, 1})
    for (const double psi : {5.0, 12.0, 30.0}) {
      RollerFlank in{34, 2, 20, 17, 0, psi, 0, 1, flank, {}, 0};
      const double step = 1e-4;
      const auto at = [&](double roll_deg) {
        in.roll_angle_deg = roll_deg;
        const auto p = hyperboloid_roller_point(in);
        return crossed::Point{*p.x_mm, *p.y_mm, *p.z_mm};
      };
      const auto p = at(psi);
      const auto ahead = at(psi + step);
      const auto behind = at(psi - step);
      const double tx = ahead.x - behind.x;
      const double ty = ahead.y - behind.y;
      // Distance of the normal through p from the axis: |p . t| / |t|.
      CHECK(std::abs(p.x * tx + p.y * ty) / std::hypot(tx, ty) == Approx(base_radius(in) / 2).epsilon(1e-6));
    }
}

TEST_CASE("K115: the pressure angle is recovered in the middle plane", "[K115]") {
  verstat::test::property([] {
    RollerFlank in = random_flank();
    in.axial_position_mm = 0;
    in.branch = 1;
    const auto point = hyperboloid_roller_point(in);
    // theta = f phi1 + psi = 180 deg + alpha
    const double theta = static_cast<double>(in.flank) * *point.tool_turn_deg + in.roll_angle_deg;
    RC_ASSERT(std::remainder(theta - 180 - in.pressure_angle_deg, 360) == Approx(0).margin(1e-9));
  });
}

TEST_CASE("K115: the flanks map into each other by a half turn about x2", "[K115]") {
  verstat::test::property([] {
    RollerFlank in = random_flank();
    in.flank = 1;
    const auto left = hyperboloid_roller_point(in);
    in.flank = -1;
    in.axial_position_mm = -in.axial_position_mm;
    const auto right = hyperboloid_roller_point(in);
    RC_PRE(*left.tool_turn_deg > 1e-6);
    RC_ASSERT(*left.tool_turn_deg + *right.tool_turn_deg == Approx(360));
    RC_ASSERT(*left.radius_mm == Approx(*right.radius_mm).epsilon(1e-10));
    RC_ASSERT(*left.z_mm == Approx(-*right.z_mm).margin(1e-9));
    // The reduction of phi1 leaves a turn of u21 * 360 deg between them.
    const double turn = pitch(in).ratio_u21 * 360 * rad;
    const double x = *right.x_mm * std::cos(turn) - *right.y_mm * std::sin(turn);
    const double y = *right.x_mm * std::sin(turn) + *right.y_mm * std::cos(turn);
    RC_ASSERT(x == Approx(*left.x_mm).margin(1e-8));
    RC_ASSERT(-y == Approx(*left.y_mm).margin(1e-8));
  });
}

TEST_CASE("K115: on parallel axes the radius falls to its minimum r/|u21| and grows again", "[K115]") {
  RollerFlank in{34, 2, 20, 17, 0, 0, 0, 1, 1, {}, 0};
  const double least_psi = pitch(in).centre_distance_mm / base_radius(in) * std::sin(20 * rad) / rad;
  const auto radius = [&](double psi) {
    in.roll_angle_deg = psi;
    return *hyperboloid_roller_point(in).radius_mm;
  };
  CHECK(radius(least_psi) == Approx(base_radius(in) / 2).epsilon(1e-12));
  for (double psi = 1; psi < least_psi; psi += 1) CHECK(radius(psi) < radius(psi - 1));
  for (double psi = least_psi + 1; psi < 60; psi += 1) CHECK(radius(psi) > radius(psi - 1));
}

TEST_CASE("K115: a section point lies in its plane and on the surface", "[K115]") {
  verstat::test::property([] {
    const auto in = random_flank();
    const auto point = hyperboloid_roller_point(in);
    const RollerSection plane{in.tool_teeth,
                              in.module_mm,
                              in.pressure_angle_deg,
                              in.roller_starts,
                              in.shaft_angle_deg,
                              in.roll_angle_deg,
                              *point.z_mm,
                              in.branch,
                              in.flank,
                              {},
                              0};
    const auto section = hyperboloid_roller_section_point(plane);
    RC_PRE(section.radius_mm.has_value());
    RollerFlank again = in;
    again.axial_position_mm = *section.axial_position_mm;
    const auto found = hyperboloid_roller_point(again);
    RC_ASSERT(*found.z_mm == Approx(*point.z_mm).margin(1e-9));
    RC_ASSERT(*found.radius_mm == Approx(*section.radius_mm).epsilon(1e-12));
    RC_ASSERT(*found.x_mm == Approx(*section.x_mm).margin(1e-9));
  });
  // Working branch, common sizes: the plane of a point gives the point back.
  const auto point = hyperboloid_roller_point({34, 2, 20, 17, 30, 20, 4, 1, 1, {}, 0.5});
  const auto section = hyperboloid_roller_section_point({34, 2, 20, 17, 30, 20, *point.z_mm, 1, 1, {}, 0.5});
  REQUIRE(section.axial_position_mm.has_value());
  CHECK(*section.axial_position_mm == Approx(4).epsilon(1e-10));
  CHECK(*section.y_mm == Approx(*point.y_mm));
}

TEST_CASE("K115: a large roller meets its section although 1e-12 mm is below its rounding", "[K115]") {
  for (double z = 1; z < 300; z += 7)
    CHECK(hyperboloid_roller_section_point({100, 50, 20, 33, 40, 22, z, 1, 1, {}, 0}).radius_mm.has_value());
}

TEST_CASE("K115: too small a centre distance has no contact", "[K115]") {
  RollerFlank in{34, 2, 20, 17, 30, 20, 0, 1, 1, 20.0, 0};
  const auto nothing = hyperboloid_roller_point(in);
  CHECK_FALSE(nothing.tool_turn_deg.has_value());
  CHECK_FALSE(nothing.radius_mm.has_value());
  CHECK_FALSE(
      hyperboloid_roller_section_point({34, 2, 20, 17, 30, 20, 5, 1, 1, 20.0, 0}).radius_mm.has_value());
  // The default centre distance, given, changes nothing; a tangential shift moves z2 only.
  in.centre_distance_mm = pitch(in).centre_distance_mm;
  in.tangential_shift_mm = 3;
  const auto shifted = hyperboloid_roller_point(in);
  in.centre_distance_mm.reset();
  in.tangential_shift_mm = 0;
  const auto plain = hyperboloid_roller_point(in);
  CHECK(*shifted.x_mm == Approx(*plain.x_mm).epsilon(1e-12));
  CHECK(*shifted.z_mm == Approx(*plain.z_mm + 3).epsilon(1e-12));
}

TEST_CASE("K115: the blank is even along its axis with the throat in the middle", "[K115]") {
  CHECK(ruled_hyperboloid_radius({20, 30, 0}).radius_mm == 20);
  CHECK(ruled_hyperboloid_radius({20, 30, -7}).radius_mm == ruled_hyperboloid_radius({20, 30, 7}).radius_mm);
  CHECK(ruled_hyperboloid_radius({3, 45, 4}).radius_mm == Approx(5));
}

TEST_CASE("K115: published rollers and results", "[K115]") {
  // 31 mm with 13 starts and 82 mm with 33 starts fit module 2 with helix 33 and 36 deg.
  CHECK(roller_pitch_geometry({13, 2, 33, 50}).pitch_diameter_mm == Approx(31).margin(0.5));
  CHECK(roller_pitch_geometry({33, 2, 36, 50}).pitch_diameter_mm == Approx(82).margin(0.5));
  const auto made = roller_design_range({});
  CHECK(made.starts_min == 13);
  CHECK(made.starts_max == 33);
  CHECK(made.pitch_diameter_max_mm == 82);
  CHECK(made.helix_max_deg == 44);
  CHECK(gear_rolling_quality({Roller::hyperboloid}).accuracy_grade == 7);
  CHECK_FALSE(gear_rolling_quality({Roller::conventional}).accuracy_grade.has_value());
}

TEST_CASE("K115: bad input names itself", "[K115]") {
  RollerFlank in{34, 2, 20, 17, 30, 20, 0, 0, 1, {}, 0};
  CHECK_THROWS_WITH(hyperboloid_roller_point(in),
                    "K115.hyperboloid_roller_point: branch = 0, must be 1 or -1");
  in.branch = 1;
  in.centre_distance_mm = 0;
  CHECK_THROWS_WITH(hyperboloid_roller_point(in),
                    Catch::Contains("K115.hyperboloid_roller_point: centre_distance_mm = 0, allowed "
                                    "centre_distance_mm > 0"));
}
