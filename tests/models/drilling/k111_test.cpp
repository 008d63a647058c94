// The checks of card K111; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k111_reverse_tilt_chisel_edge.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k111;

namespace {

constexpr double deg = std::numbers::pi / 180;
constexpr DrillPoint usual{59, 12, 1.5, 10};

double real(int low, int high, double scale) {
  return *rc::gen::inRange(low, high) * scale;
}

DrillPoint any_point() {
  const double radius = real(10, 300, 0.1);
  return {real(450, 751, 0.1), real(50, 301, 0.1), radius * real(5, 40, 0.01), radius};
}

// Rotation of the cutting plane from vectors: the flank edge of the slotted chisel in the frame of the card
// (z away from the workpiece, x along the main edge at y = r, cutting from x to y), the velocity of its point
// projected on the plane normal to the edge.
double tau_by_vectors_deg(const WorkingPoint& in, double half_point_deg) {
  const double psi = in.reverse_tilt_deg * deg;
  const double half = in.slot_width_mm / 2;
  const double along = std::sqrt(in.radius_mm * in.radius_mm - half * half);
  // Slot direction u away from the axis, wall normal n; the wall lags the axis by half the slot.
  const Eigen::Vector3d u(std::sin(psi), -std::cos(psi), 0);
  const Eigen::Vector3d n(std::cos(psi), std::sin(psi), 0);
  const Eigen::Vector3d point = along * u - half * n;
  const Eigen::Vector3d rotation(0, 0, 1);
  const Eigen::Vector3d velocity =
      rotation.cross(point) - in.feed_mm_rev / (2 * std::numbers::pi) * Eigen::Vector3d::UnitZ();
  // The edge rises towards the axis at its half point angle.
  const double phi = half_point_deg * deg;
  const Eigen::Vector3d edge = std::sin(phi) * u - std::cos(phi) * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d across = n;                // direction of cutting without feed, normal to the edge
  const Eigen::Vector3d inwards = -edge.cross(n);  // in the normal section, square to it
  const double into_work = velocity.dot(inwards.z() < 0 ? inwards : Eigen::Vector3d(-inwards));
  return std::atan2(into_work, velocity.dot(across)) / deg;
}

}  // namespace

TEST_CASE("K111: the worked example", "[K111]") {
  const StandardChisel c = standard_chisel_geometry(usual);
  CHECK(c.mu_deg == Approx(8.627).margin(0.0005));
  CHECK(c.theta_p_deg == Approx(11.645).margin(0.0005));
  CHECK(c.chisel_tilt_deg == Approx(78.355).margin(0.0005));
  CHECK(c.chisel_clearance_deg == Approx(31.53).margin(0.005));
  CHECK(c.chisel_rake_deg == Approx(-58.47).margin(0.005));
  struct Row {
    double psi, tilt, half_point, axial, normal;
  };
  for (const Row row : {Row{0, 11.64, 82.94, 31.00, 30.81}, Row{20, 31.64, 72.16, 27.58, 26.43},
                        Row{40, 51.64, 64.31, 20.84, 18.93}, Row{60, 71.64, 59.79, 10.93, 9.48}}) {
    const SlottedChisel s = slotted_chisel_geometry({usual, row.psi});
    CHECK(s.tilt_from_standard_deg == Approx(row.tilt).margin(0.0051));
    CHECK(s.chisel_half_point_deg == Approx(row.half_point).margin(0.0051));
    CHECK(s.clearance_axial_deg == Approx(row.axial).margin(0.0051));
    CHECK(s.clearance_normal_deg == Approx(row.normal).margin(0.0051));
  }
}

TEST_CASE("K111: main edge clearance at the periphery and at the junction with the chisel", "[K111]") {
  verstat::test::property([] {
    const DrillPoint p = any_point();
    const double at_corner = main_edge_clearance({p, p.drill_radius_mm}).clearance_deg;
    RC_ASSERT(std::abs(at_corner - p.clearance_periphery_deg) < 1e-10);
    const StandardChisel c = standard_chisel_geometry(p);
    RC_ASSERT(std::abs(c.chisel_tilt_deg + c.theta_p_deg - 90) < 1e-12);
    RC_PRE(c.theta_p_deg >= 0 && c.chisel_half_length_mm <= p.drill_radius_mm);
    RC_ASSERT(std::abs(main_edge_clearance({p, c.chisel_half_length_mm}).clearance_deg -
                       c.chisel_clearance_deg) < 1e-5);
  });
  // Thick web, small clearance: the tilt passes 90 deg and the edge starts at the core radius.
  const DrillPoint thick{45, 5, 4, 10};
  CHECK(standard_chisel_geometry(thick).theta_p_deg < 0);
  CHECK_NOTHROW(main_edge_clearance({thick, 4}));
  CHECK_THROWS_WITH(main_edge_clearance({thick, 3.9}), Catch::Contains("radius_mm = 3.9"));
}

TEST_CASE("K111: equation (2) is the slope of the flank in the tangent plane", "[K111]") {
  // z = x cot(phi) + b (y - r), b = tan(mu) cot(phi) - tan(alpha)/cos(mu), along the tangent (-y, x)/r_x.
  const double mu = std::asin(0.15);
  const double b = std::tan(mu) / std::tan(59 * deg) - std::tan(12 * deg) / std::cos(mu);
  for (const double radius : {1.6, 2.0, 3.0, 6.0, 10.0}) {
    const double y = 1.5 / radius;
    const double x = std::sqrt(1 - y * y);
    const double slope = -y / std::tan(59 * deg) + b * x;
    CHECK(main_edge_clearance({usual, radius}).clearance_deg ==
          Approx(-std::atan(slope) / deg).epsilon(1e-10));
  }
}

TEST_CASE("K111: limits of the slot along the standard chisel and along the main edge", "[K111]") {
  const StandardChisel c = standard_chisel_geometry(usual);
  const SlottedChisel along = slotted_chisel_geometry({usual, -c.theta_p_deg + 1e-7});
  CHECK(along.chisel_half_point_deg == Approx(90).margin(1e-5));
  CHECK(along.clearance_axial_deg == Approx(c.chisel_clearance_deg).epsilon(1e-6));
  CHECK(along.clearance_normal_deg == Approx(c.chisel_clearance_deg).epsilon(1e-6));
  // (5) at psi = 90 gives phi_pk = phi; reached here with a negative Theta, where the point is allowed.
  const DrillPoint thick{45, 5, 4, 10};
  CHECK(slotted_chisel_geometry({thick, 90}).chisel_half_point_deg == Approx(45).epsilon(1e-10));
}

TEST_CASE("K111: clearances fall with the tilt and vanish at 90 deg", "[K111]") {
  verstat::test::property([] {
    const DrillPoint p = any_point();
    const double theta = standard_chisel_geometry(p).theta_p_deg;
    double axial = 90;
    double normal = 90;
    for (double tilt = 5; tilt < 90; tilt += 5) {
      const SlottedChisel s = slotted_chisel_geometry({p, tilt - theta});
      RC_ASSERT(s.clearance_normal_deg <= s.clearance_axial_deg);
      RC_ASSERT(s.clearance_axial_deg < axial);
      RC_ASSERT(s.clearance_normal_deg < normal);
      axial = s.clearance_axial_deg;
      normal = s.clearance_normal_deg;
      // The two printed forms of (6) and (6c).
      const double sum = s.tilt_from_standard_deg * deg;
      RC_ASSERT(
          std::abs(1 / std::tan(axial * deg) - std::tan(sum) * std::tan(s.chisel_half_point_deg * deg)) <
          1e-8 * (1 + 1 / std::tan(axial * deg)));
      RC_ASSERT(std::abs(std::tan(normal * deg) - std::cos(s.chisel_half_point_deg * deg) / std::tan(sum)) <
                1e-10);
    }
    RC_ASSERT(slotted_chisel_geometry({p, 90 - theta - 1e-6}).clearance_normal_deg < 1e-5);
  });
}

TEST_CASE("K111: the rotation of the cutting plane is that of the velocity vector", "[K111]") {
  verstat::test::property([] {
    const DrillPoint p = any_point();
    const double theta = standard_chisel_geometry(p).theta_p_deg;
    WorkingPoint in{
        {p, real(1, 90, 1) - theta}, p.core_radius_mm * 0.2, real(0, 100, 0.01), p.core_radius_mm};
    const double half_point = slotted_chisel_geometry(in).chisel_half_point_deg;
    const SlottedKinematics k = slotted_chisel_kinematics(in);
    RC_ASSERT(std::abs(k.tau_deg - tau_by_vectors_deg(in, half_point)) < 1e-9);
    // The wedge is conserved, tau grows with the feed.
    RC_ASSERT(std::abs(k.kinematic_clearance_deg + k.kinematic_rake_deg -
                       slotted_chisel_geometry(in).clearance_normal_deg) < 1e-10);
    in.feed_mm_rev += 0.1;
    RC_ASSERT(slotted_chisel_kinematics(in).tau_deg > k.tau_deg);
  });
}

TEST_CASE("K111: no feed turns the plane back, and the turn vanishes at S tan(phi_pk) = pi Delta", "[K111]") {
  const double half_point = slotted_chisel_geometry({usual, 30}).chisel_half_point_deg;
  CHECK(slotted_chisel_kinematics({{usual, 30}, 0.3, 0, 1}).tau_deg < 0);
  CHECK(slotted_chisel_kinematics({{usual, 30}, 1e-9, 0, 1}).tau_deg == Approx(0).margin(1e-7));
  const double feed = std::numbers::pi * 0.3 / std::tan(half_point * deg);
  CHECK(slotted_chisel_kinematics({{usual, 30}, 0.3, feed, 1}).tau_deg == Approx(0).margin(1e-12));
}

TEST_CASE("K111: largest feed and rubbing radius invert the kinematics", "[K111]") {
  verstat::test::property([] {
    const DrillPoint p = any_point();
    const double theta = standard_chisel_geometry(p).theta_p_deg;
    const SlottedPoint slot{p, real(5, 80, 1) - theta};
    const double width = p.core_radius_mm * 0.2;
    const double radius = p.core_radius_mm * real(15, 100, 0.01);
    const double least = slotted_chisel_geometry(slot).clearance_normal_deg * real(0, 95, 0.01);
    const double feed = slotted_chisel_max_feed({slot, width, radius, least}).max_feed_mm_rev;
    RC_ASSERT(feed > 0);
    RC_ASSERT(std::abs(slotted_chisel_kinematics({slot, width, feed, radius}).kinematic_clearance_deg -
                       least) < 1e-8);
    RC_ASSERT(std::abs(slotted_chisel_rubbing_radius({slot, width, feed, least}).rubbing_radius_mm / radius -
                       1) < 1e-8);
  });
  // A wanted clearance above the static one needs a negative feed: infeasible, not an error.
  CHECK(slotted_chisel_max_feed({{usual, 30}, 0.1, 1, 60}).max_feed_mm_rev < 0);
  CHECK(slotted_chisel_rubbing_radius({{usual, 30}, 0.6, 0.1, 0}).rubbing_radius_mm == Approx(0.3));
}

TEST_CASE("K111: usual points have a chisel rake of -50 to -60 deg", "[K111]") {
  for (const double clearance : {8.0, 12.0, 16.0})
    for (const double core : {0.8, 1.5, 2.0}) {
      const double rake = standard_chisel_geometry({59, clearance, core, 10}).chisel_rake_deg;
      CHECK(rake < -50);
      CHECK(rake > -60);
    }
  // A neighbouring paper: psi_st = 55 deg gives -53.74 for 118 deg. The clearance that makes psi_st 55 deg:
  const double mu = std::asin(0.15);
  const double alpha =
      std::atan((std::tan(35 * deg) + std::tan(mu)) * std::cos(mu) / std::tan(59 * deg)) / deg;
  CHECK(standard_chisel_geometry({59, alpha, 1.5, 10}).chisel_rake_deg == Approx(-53.74).margin(0.005));
}

TEST_CASE("K111: thrust shares", "[K111]") {
  CHECK(drill_thrust_ratio({0.5, 1}).thrust_ratio == 1);
  CHECK(drill_thrust_ratio({0.5, 0}).thrust_ratio == 0.5);
  CHECK(drill_thrust_ratio({1, 0.3}).thrust_ratio == Approx(0.3));
}

TEST_CASE("K111: bad input names itself", "[K111]") {
  CHECK_THROWS_WITH(standard_chisel_geometry({59, 12, 10, 10}),
                    "K111.standard_chisel_geometry: core_radius_mm = 10, must be below drill_radius_mm");
  CHECK_THROWS_WITH(slotted_chisel_geometry({usual, 80}), Catch::Contains("reverse_tilt_deg = 80"));
  CHECK_THROWS_WITH(slotted_chisel_geometry({usual, -12}), Catch::Contains("reverse_tilt_deg = -12"));
  CHECK_THROWS_WITH(slotted_chisel_kinematics({{usual, 30}, 0.3, 0.1, 0.15}),
                    Catch::Contains("radius_mm = 0.15, must be above slot_width_mm / 2"));
  CHECK_THROWS_WITH(slotted_chisel_rubbing_radius({{usual, 30}, 0.3, 0.1, 40}),
                    Catch::Contains("min_kinematic_clearance_deg = 40"));
}
