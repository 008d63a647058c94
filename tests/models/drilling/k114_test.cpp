// The checks of card K114; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/drilling/k111_reverse_tilt_chisel_edge.h"
#include "models/drilling/k114_sharpened_chisel_edge.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k114;

namespace {

constexpr double deg = std::numbers::pi / 180;

double real(int low, int high, double scale) {
  return *rc::gen::inRange(low, high) * scale;
}

// Normal of a plane through the chisel edge and the trace of its setting angle, in the card's axes
// (h along the edge in plan, v cutting direction, z the axis).
Eigen::Vector3d plane_normal(double psi, double phi, double eps) {
  const Eigen::Vector3d edge(std::sin(phi), 0, -std::cos(phi));
  const Eigen::Vector3d trace(std::sin(eps) * std::sin(psi), std::sin(eps) * std::cos(psi), std::cos(eps));
  return edge.cross(trace).normalized();
}

double between_planes_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::min(1.0, std::abs(a.normalized().dot(b.normalized())))) / deg;
}

}  // namespace

TEST_CASE("K114: vertical planes give 90 deg of clearance and no rake", "[K114]") {
  for (const double psi : {10.0, 40.0, 80.0})
    for (const double phi : {10.0, 60.0, 90.0}) {
      CHECK(chisel_edge_clearance({{psi, phi}, 0}).alpha_c_deg == 90);
      CHECK(chisel_edge_rake({{psi, phi}, 0}).gamma_c_deg == 0);
    }
}

TEST_CASE("K114: clearance falls, rake grows, and they are complementary", "[K114]") {
  verstat::test::property([] {
    const Edge edge{real(1, 90, 1), real(1, 91, 1)};
    double alpha = 91;
    double gamma = -1;
    for (double eps = 0; eps <= 90; eps += 5) {
      const double a = chisel_edge_clearance({edge, eps}).alpha_c_deg;
      const double g = chisel_edge_rake({edge, eps}).gamma_c_deg;
      RC_ASSERT(a < alpha);
      RC_ASSERT(g > gamma);
      RC_ASSERT(std::abs(a + g - 90) < 1e-10);
      alpha = a;
      gamma = g;
    }
    const Limits limits = chisel_edge_limits(edge);
    RC_ASSERT(std::abs(limits.alpha_min_deg - alpha) < 1e-10);
    RC_ASSERT(std::abs(limits.gamma_max_deg - gamma) < 1e-10);
  });
}

TEST_CASE("K114: the angles are those between the ground planes and the cutting and base planes", "[K114]") {
  verstat::test::property([] {
    const double psi = real(1, 90, 1);
    const double phi = real(1, 90, 1);
    const double eps = real(1, 90, 1);
    const Eigen::Vector3d edge(std::sin(phi * deg), 0, -std::cos(phi * deg));
    const Eigen::Vector3d cutting = edge.cross(Eigen::Vector3d::UnitY());  // holds edge and cutting direction
    const Eigen::Vector3d normal = plane_normal(psi * deg, phi * deg, eps * deg);
    const double alpha = chisel_edge_clearance({{psi, phi}, eps}).alpha_c_deg;
    RC_ASSERT(std::abs(alpha - between_planes_deg(normal, cutting)) < 1e-5);
    // The base plane holds the edge and the axis.
    const double gamma = chisel_edge_rake({{psi, phi}, eps}).gamma_c_deg;
    RC_ASSERT(std::abs(gamma - between_planes_deg(normal, Eigen::Vector3d::UnitY())) < 1e-5);
  });
}

TEST_CASE("K114: the printed and the compact clearance agree", "[K114]") {
  for (double psi = 10; psi <= 80; psi += 10)
    for (double phi = 10; phi <= 85; phi += 5)
      for (double eps = 1; eps < 90; eps += 4) {
        const double s = std::sin(eps * deg);
        const double root =
            std::sqrt(std::pow(std::cos(psi * deg), 2) +
                      std::pow(s / std::tan(phi * deg) + std::cos(eps * deg) * std::sin(psi * deg), 2));
        const double printed = std::acos(s * std::cos(psi * deg) / (std::sin(phi * deg) * root)) / deg;
        CHECK(chisel_edge_clearance({{psi, phi}, eps}).alpha_c_deg == Approx(printed).margin(1e-6));
      }
}

TEST_CASE("K114: the printed rake folds back where its arcsine does", "[K114]") {
  // psi = 80, phi_c = 35: peak of 90 deg at tan(eps2) = tan(phi_c)/sin(psi), eps2 = 35.4 deg.
  CHECK(chisel_edge_rake({{80, 35}, 35.4, -1}).gamma_c_deg == Approx(90).margin(0.5));
  CHECK(chisel_edge_rake({{80, 35}, 60, -1}).gamma_c_deg > 90);
  CHECK(chisel_edge_rake({{50, 85}, 30.38, 1}).gamma_c_deg == Approx(20).margin(0.01));
  CHECK(chisel_edge_rake({{50, 85}, 28.53, -1}).gamma_c_deg == Approx(20).margin(0.01));
}

TEST_CASE("K114: settings return their targets whenever feasible", "[K114]") {
  verstat::test::property([] {
    const Edge edge{real(1, 90, 1), real(1, 91, 1)};
    const Targets in{edge, real(0, 91, 1), real(0, 91, 1)};
    const Settings s = chisel_edge_setting_angles(in);
    const Limits limits = chisel_edge_limits(edge);
    RC_ASSERT(s.feasible ==
              (in.alpha_target_deg >= limits.alpha_min_deg && in.gamma_target_deg <= limits.gamma_max_deg &&
               in.alpha_target_deg + in.gamma_target_deg < 90));
    if (!s.feasible) return;
    // A target on its limit may land a rounding above 90 deg.
    RC_ASSERT(s.eps1_deg <= 90 + 1e-9);
    RC_ASSERT(s.eps2_deg <= 90 + 1e-9);
    RC_ASSERT(std::abs(chisel_edge_clearance({edge, std::min(90.0, s.eps1_deg)}).alpha_c_deg -
                       in.alpha_target_deg) < 1e-8);
    RC_ASSERT(std::abs(chisel_edge_rake({edge, std::min(90.0, s.eps2_deg)}).gamma_c_deg -
                       in.gamma_target_deg) < 1e-8);
    RC_ASSERT(s.eps1_deg > s.eps2_deg);  // the wedge is positive
  });
  CHECK_FALSE(chisel_edge_setting_angles({{80, 35}, 12, 20}).feasible);
  CHECK(chisel_edge_limits({80, 35}).alpha_min_deg == Approx(77.9).margin(0.05));
}

TEST_CASE("K114: a flat chisel edge has full freedom", "[K114]") {
  for (const double psi : {10.0, 50.0, 89.0}) {
    CHECK(chisel_edge_limits({psi, 90}).alpha_min_deg == 0);
    CHECK(chisel_edge_limits({psi, 90}).gamma_max_deg == 90);
    CHECK(chisel_edge_setting_angles({{psi, 90}, 0, 0}).feasible);
  }
}

TEST_CASE("K114: extremes of the studied range", "[K114]") {
  CHECK(chisel_edge_limits({10, 85}).alpha_min_deg == Approx(0.9).margin(0.05));
  CHECK(chisel_edge_limits({80, 35}).gamma_max_deg == Approx(12).margin(0.15));
  CHECK(chisel_edge_limits({10, 85}).gamma_max_deg == Approx(89).margin(0.15));
}

TEST_CASE("K114: conventional points", "[K114]") {
  CHECK(flat_flank_chisel_rake({118, 55}).gamma_c_deg == Approx(-53.74).margin(0.005));
  CHECK(flat_flank_chisel_rake({120, 55}).gamma_c_deg == Approx(-54.82).margin(0.005));
  CHECK(two_plane_chisel_plan_angle({120, 55, 12, 0.15}).phi_c_deg == Approx(77.2).margin(0.05));
  // The same one-plane point by the other school: the chisel angle is 90 deg less Theta.
  const k111::StandardChisel c = k111::standard_chisel_geometry({60, 12, 1.5, 10});
  CHECK(c.chisel_tilt_deg == Approx(77.6).margin(0.05));
  CHECK(flat_flank_chisel_rake({120, c.chisel_tilt_deg}).gamma_c_deg ==
        Approx(c.chisel_rake_deg).epsilon(1e-12));
}

TEST_CASE("K114: the two-plane chisel lies on the second flank of both teeth", "[K114]") {
  verstat::test::property([] {
    const TwoPlanePoint in{real(90, 151, 1), real(5, 90, 1), real(0, 31, 1), real(0, 60, 0.01)};
    const TwoPlaneChisel out = two_plane_chisel_plan_angle(in);
    const double a = 1 / std::tan(in.two_phi_deg / 2 * deg);
    // Periphery clearance from the first plane z = a x - b_1 (y - w/2) at the corner (R = 1).
    const double w = in.core_ratio;
    const double cos_mu = std::sqrt(1 - w * w);
    RC_ASSERT(std::abs(a * w + out.flank1_slope * cos_mu - std::tan(in.alpha_periphery_deg * deg)) < 1e-12);
    // The chisel edge, at psi to the main edge, is where the planes a x - b_2 y and -a x + b_1 y meet.
    const double x = std::cos(in.psi_deg * deg);
    const double y = std::sin(in.psi_deg * deg);
    RC_ASSERT(std::abs((a * x - out.flank2_slope * y) - (-a * x + out.flank1_slope * y)) < 1e-10);
    RC_ASSERT(std::abs(1 / std::tan(out.phi_c_deg * deg) - (a * x - out.flank1_slope * y)) < 1e-10);
  });
}

TEST_CASE("K114: bad input names itself", "[K114]") {
  CHECK_THROWS_WITH(chisel_edge_rake({{50, 85}, 30, 0}),
                    "K114.chisel_edge_rake: sign = 0, must be 1 or -1 (the printed sign)");
  CHECK_THROWS_WITH(chisel_edge_clearance({{90, 85}, 30}),
                    Catch::Contains("psi_deg = 90, allowed 0 < psi_deg < 90"));
}
