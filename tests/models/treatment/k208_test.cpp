// The checks of card K208; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k208_drill_flank_kinematics.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k208;

namespace {

constexpr double rad = std::numbers::pi / 180;

// Residual of the cone of flank 1; flank 2 is flank 1 turned half round.
double cone_residual(int surface, double x, double y, double z) {
  const ConeSetup s = cone_grind_setup({});
  if (surface == 2) {
    x = -x;
    y = -y;
  }
  const double c = std::cos(s.delta_z_deg * rad), sn = std::sin(s.delta_z_deg * rad);
  const double cx = (x + s.l0_mm) * c - (z + s.b_mm) * sn;
  const double cy = y + s.k0_mm;
  const double cz = (x + s.l0_mm) * sn + (z + s.b_mm) * c;
  const double t = std::tan(15 * rad);
  return cx * cx + cy * cy - t * t * cz * cz;
}

CycleInputs cycle(double azimuth, double spin, double radius = 10) {
  CycleInputs in;
  in.azimuth_deg = azimuth;
  in.spin_rpm = spin;
  in.position_mm = radius;
  return in;
}

}  // namespace

TEST_CASE("K208: both flanks lie on their cones and are half a turn apart", "[K208]") {
  verstat::test::property([] {
    FlankParameters in;
    in.u_mm = 0.1 * *rc::gen::inRange(1, 200);
    in.v_deg = *rc::gen::inRange(-180, 180);
    const Point one = flank_point(in);
    RC_ASSERT(std::abs(cone_residual(1, one.x_mm, one.y_mm, one.z_mm)) < 1e-9);
    in.surface = 2;
    in.v_deg += 180;
    const Point two = flank_point(in);
    RC_ASSERT(std::abs(cone_residual(2, two.x_mm, two.y_mm, two.z_mm)) < 1e-9);
    RC_ASSERT(std::hypot(one.x_mm + two.x_mm, one.y_mm + two.y_mm, one.z_mm - two.z_mm) < 1e-9);
  });
}

TEST_CASE("K208: flank 2 by the printed equation (6)", "[K208]") {
  const ConeSetup s = cone_grind_setup({});
  const double h = 9, t = 185 * rad, d = s.delta_z_deg * rad, axial = h / std::tan(15 * rad);
  FlankParameters in;
  in.surface = 2;
  in.u_mm = h;
  in.v_deg = 185;
  const Point p = flank_point(in);
  CHECK(p.x_mm == Approx(h * std::cos(t) * std::cos(d) - axial * std::sin(d) + s.l0_mm));
  CHECK(p.y_mm == Approx(h * std::sin(t) + s.k0_mm));
  CHECK(p.z_mm == Approx(axial * std::cos(d) + h * std::sin(d) * std::cos(t) - s.b_mm));
}

TEST_CASE("K208: chisel edge lies on both cones, is odd and ends at the web", "[K208]") {
  for (double x = -1.5; x <= 1.5; x += 0.25) {
    ChiselPosition in;
    in.x_mm = x;
    const ChiselPoint p = chisel_edge_point(in);
    CHECK(cone_residual(1, x, p.y_mm, p.z_mm) == Approx(0).margin(1e-10));
    CHECK(cone_residual(2, x, p.y_mm, p.z_mm) == Approx(0).margin(1e-10));
    in.x_mm = -x;
    CHECK(chisel_edge_point(in).y_mm == Approx(-p.y_mm).margin(1e-12));
  }
  const ChiselEdge e = chisel_edge({});
  ChiselPosition end;
  end.x_mm = e.x_end_mm;
  CHECK(chisel_edge_point(end).y_mm == Approx(-1.5));
  ChiselPosition near;
  near.x_mm = 1e-5;
  CHECK(std::atan(-chisel_edge_point(near).y_mm / 1e-5) / rad ==
        Approx(e.chisel_angle_true_deg).epsilon(1e-6));
  CHECK(e.chisel_angle_true_deg == Approx(52.8).margin(0.05));
}

TEST_CASE("K208: the clearance of the ground corner is nearly the one asked", "[K208]") {
  // Slope of the flank across the cutting edge, in the plane through the corner square to its radius.
  EdgeRadius corner;
  corner.radius_mm = 10;
  const Point p = cutting_edge_point(corner);
  FlankLocation at;
  at.x_mm = p.x_mm;
  at.y_mm = p.y_mm;
  at.z_mm = p.z_mm;
  const Normal n = flank_normal(at);
  // circumferential direction (-y, x)/R at the corner; the surface rises to z by -(n.t)/nz
  const double across = (-p.y_mm * n.nx + p.x_mm * n.ny) / 10;
  CHECK(std::atan(std::abs(across / n.nz)) / rad == Approx(12.03).margin(0.05));
}

TEST_CASE("K208: normals point out of the flank, to the tip", "[K208]") {
  verstat::test::property([] {
    FlankParameters f;
    f.surface = *rc::gen::inRange(1, 3);
    f.u_mm = 8.0 + 0.01 * *rc::gen::inRange(0, 300);
    f.v_deg = *rc::gen::inRange(-20, 20) + (f.surface == 2 ? 180 : 0);
    const Point p = flank_point(f);
    FlankLocation at;
    at.surface = f.surface;
    at.x_mm = p.x_mm;
    at.y_mm = p.y_mm;
    at.z_mm = p.z_mm;
    const Normal n = flank_normal(at);
    RC_ASSERT(std::abs(std::hypot(n.nx, n.ny, n.nz) - 1) < 1e-12);
    RC_ASSERT(n.nz < 0);
    f.v_deg += 1e-4;  // along the surface
    const Point q = flank_point(f);
    RC_ASSERT(std::abs(n.nx * (q.x_mm - p.x_mm) + n.ny * (q.y_mm - p.y_mm) + n.nz * (q.z_mm - p.z_mm)) <
              1e-9);
  });
}

TEST_CASE("K208: attack angle over a revolution", "[K208]") {
  const AttackCycle plain = attack_angle_cycle(cycle(0, 0));
  CHECK(plain.chi_max_deg == Approx(82).margin(3));
  CHECK(plain.chi_min_deg == Approx(20).margin(3));
  CHECK(plain.chi_max_deg == Approx(83.8).margin(0.05));
  CHECK(plain.active_fraction == 1);
  CHECK(attack_angle_cycle(cycle(15, 0)).chi_max_deg == Approx(76.5).margin(0.3));
  CHECK(attack_angle_cycle(cycle(180, 0)).active_fraction == 0);
  for (const double azimuth : {-30.0, -15.0})
    CHECK(attack_angle_cycle(cycle(azimuth, 0)).active_fraction == 1);
  CHECK(attack_angle_cycle(cycle(0, 5)).chi_min_deg > plain.chi_min_deg);
  CHECK(attack_angle_cycle(cycle(0, -60)).chi_mean_deg < plain.chi_mean_deg);
  CHECK(std::abs(attack_angle_cycle(cycle(0, 5)).chi_max_deg - plain.chi_max_deg) < 1);
}

TEST_CASE("K208: effect of the azimuth on the mean attack angle", "[K208]") {
  const auto mean = [](double azimuth, double tx, double tz) {
    CycleInputs in = cycle(azimuth, 0);
    in.offset_x_mm = tx;
    in.offset_z_mm = tz;
    return attack_angle_cycle(in).chi_mean_deg;
  };
  CHECK(mean(-30, -45, 0) / mean(0, -45, 0) - 1 == Approx(0.14).margin(0.01));
  CHECK(mean(-30, -10, 6.3) / mean(0, -10, 6.3) - 1 == Approx(-0.10).margin(0.01));
  CHECK(mean(30, -10, 6.3) / mean(0, -10, 6.3) - 1 == Approx(-0.21).margin(0.01));
}

TEST_CASE("K208: a rigid rotation of the whole bath does not change the attack angle", "[K208]") {
  // Without offset and with azimuth feed only, the speed of the point is its distance from the station axis.
  AttackInputs in;
  in.position_mm = 8;
  in.rotor_rpm = 0;
  in.azimuth_rpm = 30;
  in.azimuth_deg = 0;
  const Attack a = edge_attack_angle(in);
  in.azimuth_deg = 77;
  const Attack b = edge_attack_angle(in);
  CHECK(a.chi_deg == Approx(b.chi_deg).margin(1e-9));
  CHECK(a.speed_m_s == Approx(b.speed_m_s));
}

TEST_CASE("K208: offsets of the drill", "[K208]") {
  CHECK(azimuth_offset_x_max({40, 4, 20, 60, 60}).tx_max_mm == Approx(11));
  // Both branches meet at tilt = half point angle.
  CHECK(azimuth_offset_x_max({40, 4, 20, 60, 60.000001}).tx_max_mm == Approx(11).margin(1e-5));
  // The reach of the tip: D/2 cot(phi) sin(xi).
  const double tip = 10 / std::tan(60 * rad) * std::sin(75 * rad);
  CHECK(azimuth_offset_x_max({40, 4, 20, 60, 75}).tx_max_mm == Approx(16 - tip));
  CHECK(azimuth_offset_x_max({10, 4, 20, 60, 60}).tx_max_mm < 0);
  CHECK(azimuth_offset_z({30, 20, 60}).tz_mm == Approx(6.3).margin(0.06));
}

TEST_CASE("K208: bad input names itself", "[K208]") {
  Drill thick;
  thick.core_radius_mm = 10;
  CHECK_THROWS_WITH(cone_grind_setup(thick),
                    "K208.cone_grind_setup: core_radius_mm = 10, must be below half of the drill diameter");
  Drill steep;
  steep.clearance_deg = 40;
  CHECK_THROWS_WITH(cone_grind_setup(steep), Catch::Contains("no cone position gives this clearance"));
  CycleInputs in = cycle(0, 0);
  in.step_deg = 7;
  CHECK_THROWS_WITH(attack_angle_cycle(in), "K208.attack_angle_cycle: step_deg = 7, must divide 360");
  AttackInputs still;
  still.position_mm = 8;
  still.rotor_rpm = 0;
  CHECK_THROWS_WITH(edge_attack_angle(still), Catch::Contains("does not move"));
  EdgeRadius core;
  core.radius_mm = 1.5;
  CHECK_THROWS_WITH(cutting_edge_point(core),
                    "K208.cutting_edge_point: radius_mm = 1.5, must be above the core radius");
}
