// The checks of card K406; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/k406_ball_end_energy_forces.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k406;

namespace {

constexpr double degree = std::numbers::pi / 180;
double sine(double d) {
  return std::sin(d * degree);
}
double cosine(double d) {
  return std::cos(d * degree);
}

BallEndMillTurn mill(CutMode mode) {
  BallEndMillTurn in;
  in.mode = mode;
  return in;
}
// Radius of the section at the depth of cut.
double top_radius(const BallEndMill& in) {
  return std::sqrt(in.depth_mm * (in.diameter_mm - in.depth_mm));
}

}  // namespace

TEST_CASE("K406: an orthogonal edge without flow gives Merchant's force", "[K406]") {
  for (double rake : {-10.0, 0.0, 10.0, 25.0}) {
    EnergyInputs in;
    in.cutting_speed_m_min = 30;
    in.feed_mm = 0.1;
    in.normal_rake_deg = rake;
    const auto e = specific_energy(in);
    const double phi = e.shear_angle_deg, beta = e.friction_angle_deg;
    CHECK(e.total_n_mm2 ==
          Approx(e.shear_stress_mpa * cosine(beta - rake) / (sine(phi) * cosine(phi + beta - rake)))
              .epsilon(1e-12));
    CHECK(e.area_factor == Approx(1 / sine(phi)).epsilon(1e-12));
  }
}

TEST_CASE("K406: shear area and effective rake are those of the velocity vectors", "[K406]") {
  verstat::test::property([] {
    const double i = *rc::gen::inRange(-60, 61), eta = *rc::gen::inRange(-50, 61);
    const double rake = *rc::gen::inRange(-20, 31), phi = *rc::gen::inRange(10, 50);
    // x along the cutting velocity, y away from the work, the edge inclined in the x-z plane.
    const Eigen::Vector3d edge(sine(i), 0, cosine(i));
    const Eigen::Vector3d across(cosine(i), 0, -sine(i));
    const Eigen::Vector3d up = cosine(rake) * Eigen::Vector3d::UnitY() + sine(rake) * across;
    const Eigen::Vector3d chip = cosine(eta) * up + sine(eta) * edge;
    const double effective = effective_rake({rake, i, eta}).effective_rake_deg;
    RC_ASSERT(std::abs(sine(effective) - chip.x()) < 1e-12);
    // Chip speed from eq. (11); shear velocity = chip - work.
    const Eigen::Vector3d shear =
        (sine(phi) / cosine(phi - effective) * chip - Eigen::Vector3d::UnitX()).normalized();
    const Eigen::Vector3d normal = shear.cross(edge);
    const double area = normal.norm() / shear.y();
    const double factor = shear_area_factor({{rake, i, eta}, phi}).factor;
    RC_ASSERT(std::abs(factor - area) < 1e-9 * area);
    // What flows through the shear surface is what the edge cuts.
    RC_ASSERT(std::abs(factor * std::abs(normal.normalized().x()) - cosine(i)) < 1e-9);
  });
}

TEST_CASE("K406: the chip flows where the power is least, and the forces close", "[K406]") {
  verstat::test::property([] {
    ObliqueInputs in;
    in.cutting_speed_m_min = *rc::gen::inRange(5, 100);
    in.feed_mm = *rc::gen::inRange(20, 200) * 1e-3;
    in.normal_rake_deg = *rc::gen::inRange(-10, 16);
    in.inclination_deg = *rc::gen::inRange(0, 41);
    const auto k = oblique_specific_forces(in);
    EnergyInputs at;
    at.cutting_speed_m_min = in.cutting_speed_m_min;
    at.feed_mm = in.feed_mm;
    at.normal_rake_deg = in.normal_rake_deg;
    at.inclination_deg = in.inclination_deg;
    double least = 1e300;
    for (double eta = -50; eta <= 60; eta += 0.01) {
      at.flow_deg = eta;
      least = std::min(least, specific_energy(at).total_n_mm2);
    }
    const double found = k.k_m * cosine(in.inclination_deg);
    RC_ASSERT(found <= least * (1 + 1e-12));
    RC_ASSERT(found >= least * (1 - 1e-6));
    const double rake_side = k.k_n * k.k_n + k.k_f * k.k_f;
    RC_ASSERT(std::abs(k.k_m * k.k_m + k.k_t * k.k_t + k.k_v * k.k_v - rake_side) < 1e-9 * rake_side);
  });
}

TEST_CASE("K406: chip flow, size effect and rake", "[K406]") {
  const auto at = [](double v, double f, double rake, double i) {
    ObliqueInputs in;
    in.cutting_speed_m_min = v;
    in.feed_mm = f;
    in.normal_rake_deg = rake;
    in.inclination_deg = i;
    return oblique_specific_forces(in);
  };
  CHECK(at(30, 0.1, 5, 0).flow_deg == Approx(0).margin(1e-4));
  for (double i : {10.0, 20.0, 30.0}) {
    const double share = at(30, 0.1, 0, i).flow_deg / i;
    CHECK((share > 0.455 && share < 0.555));
    CHECK(at(30, 0.1, 0, i).k_t < 0);
  }
  CHECK(at(60, 0.1, 5, 20).k_m < at(30, 0.1, 5, 20).k_m);
  CHECK(at(30, 0.1, 10, 20).k_m < at(30, 0.1, 5, 20).k_m);
  const auto right = at(30, 0.1, 5, 20), left = at(30, 0.1, 5, -20);
  CHECK(left.flow_deg == -right.flow_deg);
  CHECK(left.k_t == -right.k_t);
  CHECK(left.k_m == right.k_m);
  CHECK(right.valid);
  CHECK_FALSE(at(400, 0.2, 0, 20).valid);
}

TEST_CASE("K406: inclination on the ball is the angle of the edge curve to the meridian", "[K406]") {
  const double ball = 5, helix = 35;
  const auto point = [&](double z) {
    const auto g = ball_geometry({2 * ball, helix, z});
    return Eigen::Vector3d(g.radius_mm * cosine(g.lag_deg), g.radius_mm * sine(g.lag_deg), z);
  };
  for (double z : {0.2, 1.0, 3.0, 4.5}) {
    const auto g = ball_geometry({2 * ball, helix, z});
    const double step = 1e-6;
    const Eigen::Vector3d along = (point(z + step) - point(z - step)).normalized();
    const Eigen::Vector3d meridian(cosine(g.kappa_deg) * cosine(g.lag_deg),
                                   cosine(g.kappa_deg) * sine(g.lag_deg), sine(g.kappa_deg));
    CHECK(std::acos(along.dot(meridian)) / degree == Approx(g.inclination_deg).margin(1e-4));
  }
}

TEST_CASE("K406: mean torque of a slot carries the chip volume", "[K406]") {
  // Without helix the specific force is one number, so the work per tooth over it is the volume cut.
  auto in = mill(CutMode::slot);
  in.helix_deg = 0;
  in.slices = 400;
  const auto sum = ball_end_force_summary(in);
  ObliqueInputs element;
  element.cutting_speed_m_min = mean_edge_speed({10, 2000, 0.5}).speed_m_min;
  element.feed_mm = 0.1;
  element.normal_rake_deg = 5;
  const double work_n_mm = sum.torque_mean_nm * 1000 * 2 * std::numbers::pi / 2;
  const double angle = 2 * std::acos(1 - 0.5 / 5);
  const double volume_mm3 = 0.1 * 25.0 / 2 * (angle - std::sin(angle));
  CHECK(volume_mm3 == Approx(0.14681).margin(5e-6));
  CHECK(work_n_mm / oblique_specific_forces(element).k_m == Approx(volume_mm3).epsilon(1e-5));
}

TEST_CASE("K406: forces are linear in the stress scale and converged in slices", "[K406]") {
  for (CutMode mode : {CutMode::down, CutMode::up, CutMode::slot}) {
    const auto base = ball_end_force_summary(mill(mode));
    auto scaled = mill(mode);
    scaled.stress_scale = 1.7;
    CHECK(ball_end_force_summary(scaled).resultant_peak_n ==
          Approx(1.7 * base.resultant_peak_n).epsilon(1e-9));
    auto fine = mill(mode);
    fine.slices = 160;
    const auto converged = ball_end_force_summary(fine);
    // Up-milling cuts off at the thick end of the chip: a slice more or less there is 1.1 %.
    const double close = mode == CutMode::up ? 0.012 : 0.01;
    CHECK(base.x_peak_n == Approx(converged.x_peak_n).epsilon(close));
    CHECK(base.y_peak_n == Approx(converged.y_peak_n).epsilon(close));
    CHECK(base.z_peak_n == Approx(converged.z_peak_n).epsilon(close));
  }
}

TEST_CASE("K406: peaks of the default mill in the three modes", "[K406]") {
  const auto down = ball_end_force_summary(mill(CutMode::down));
  CHECK(down.x_peak_n == Approx(60.8).margin(0.06));
  CHECK(down.y_peak_n == Approx(116.5).margin(0.06));
  CHECK(down.z_peak_n == Approx(68.0).margin(0.06));
  const auto up = ball_end_force_summary(mill(CutMode::up));
  CHECK(up.x_peak_n == Approx(91.3).margin(0.06));
  CHECK(up.y_peak_n == Approx(96.5).margin(0.06));
  CHECK(up.z_peak_n == Approx(70.5).margin(0.06));
}

TEST_CASE("K406: direction of the mean forces", "[K406]") {
  auto in = mill(CutMode::up);
  for (double share : {0.2, 0.5, 0.75}) {
    in.step_over_mm = share * top_radius(in);
    in.mode = CutMode::up;
    const auto up = ball_end_force_summary(in);
    CHECK(up.x_mean_n < 0);
    CHECK(up.z_mean_n > 0);
    in.mode = CutMode::down;
    CHECK(ball_end_force_summary(in).x_mean_n > 0);
  }
  in.step_over_mm = 2 * top_radius(in);
  in.mode = CutMode::down;
  CHECK(ball_end_force_summary(in).x_mean_n < 0);
}

TEST_CASE("K406: the independent regression for hardened steel is met", "[K406]") {
  auto in = mill(CutMode::down);
  in.diameter_mm = 6;
  in.normal_rake_deg = 0;
  in.spindle_rpm = 20018;
  in.feed_mm_tooth = 0.08;
  in.depth_mm = 0.21;
  in.step_over_mm = 0.45;
  CHECK(ball_end_force_summary(in).resultant_peak_n == Approx(44.6).margin(0.06));
  in.vf_scale = 1.0 / 60000;
  CHECK(ball_end_force_summary(in).resultant_peak_n == Approx(60.2).margin(0.06));
}

TEST_CASE("K406: rotation keeps the length of the force", "[K406]") {
  const auto f = rotate_forces({50, 80, 30, 37, -21});
  CHECK(std::hypot(f.x_n, f.y_n, f.z_n) == Approx(std::hypot(50.0, 80.0, 30.0)).epsilon(1e-14));
}

TEST_CASE("K406: bad input names itself", "[K406]") {
  auto deep = mill(CutMode::down);
  deep.depth_mm = 6;
  CHECK_THROWS_WITH(ball_end_force_summary(deep),
                    "K406.ball_end_force_summary: a_p = 6, must not be above d/2");
  CHECK_THROWS_WITH(ball_geometry({10, 30, 5.5}), "K406.ball_geometry: z = 5.5, must not be above d/2");
}
