// The checks of card S4; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>
#include <numeric>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/s4_rotating_tools.h"

using namespace verstat::models;
using namespace verstat::models::s4;

namespace {

using std::numbers::pi;
constexpr double rad = pi / 180;

double speed(double a, double r, double rho_deg, double n1, double n2, double f, MillingMode mode) {
  return resultant_speed({{{a, r}, rho_deg}, n1, n2, f, mode}).resultant_speed_m_min;
}

}  // namespace

TEST_CASE("S4: contact radius on the line of centres and at the engagement limit", "[S4]") {
  CHECK(rc::check([] {
    const double a = *rc::gen::inRange(5, 100), r1 = *rc::gen::inRange(1, 60), r2 = *rc::gen::inRange(1, 60);
    const ContactRadius on_line = contact_radius({{a, r1}, 0});
    RC_ASSERT(std::abs(on_line.contact_radius_mm - std::abs(a - r1)) < 1e-12);
    if (a > r1) RC_ASSERT(on_line.work_angle_deg == 0);
    const EngagementLimit limit = engagement_limit({{a, r1}, r2});
    const bool apart = a >= r1 + r2 || r1 >= a + r2;
    RC_ASSERT(limit.engaged == !apart);
    if (limit.engaged && limit.tool_angle_deg < 180) {
      const ContactRadius edge = contact_radius({{a, r1}, limit.tool_angle_deg});
      RC_ASSERT(std::abs(edge.contact_radius_mm - r2) < 1e-9);
      RC_ASSERT(std::abs(edge.work_angle_deg - limit.work_angle_deg) < 1e-9);
      // Eq. (2), the sine theorem.
      RC_ASSERT(std::abs(r2 * std::sin(edge.work_angle_deg * rad) -
                         r1 * std::sin(limit.tool_angle_deg * rad)) < 1e-9);
    }
  }));
  const EngagementLimit inside = engagement_limit({{10, 3}, 40});
  CHECK(inside.engaged);
  CHECK(inside.tool_angle_deg == 180);
  CHECK(inside.work_angle_deg == 0);
}

TEST_CASE("S4: the resultant is the speed of the edge track in the part frame", "[S4]") {
  CHECK(rc::check([] {
    const double a = *rc::gen::inRange(15, 60), r = *rc::gen::inRange(2, 14),
                 rho = *rc::gen::inRange(-80, 80);
    const double n1 = *rc::gen::inRange(100, 5000), n2 = *rc::gen::inRange(0, 400);
    const double f = *rc::gen::inRange(-3000, 3000);
    for (const MillingMode mode : {MillingMode::down, MillingMode::up}) {
      // The part turns so that its material moves with the edge (down) or against it; t in minutes.
      const double part = (mode == MillingMode::down ? -1 : 1) * 2 * pi * n2;
      const auto track = [&](double t) {
        const double angle = rho * rad - pi / 2 + 2 * pi * n1 * t;  // of the edge at the tool centre
        const double x = r * std::cos(angle), y = a - f * t + r * std::sin(angle);
        return std::pair{x * std::cos(part * t) + y * std::sin(part * t),
                         -x * std::sin(part * t) + y * std::cos(part * t)};
      };
      const double h = 1e-9;
      const auto [x1, y1] = track(-h);
      const auto [x2, y2] = track(h);
      const double by_track = std::hypot(x2 - x1, y2 - y1) / (2 * h) / 1000;
      RC_ASSERT(std::abs(speed(a, r, rho, n1, n2, f, mode) - by_track) < 1e-4 * (1 + by_track));
    }
  }));
}

TEST_CASE("S4: limits of the resultant speed", "[S4]") {
  CHECK(speed(25, 10, 30, 1000, 0, 0, MillingMode::down) == Approx(2 * pi * 10));
  const double down = speed(25, 10, 0, 3000, 100, 0, MillingMode::down);
  const double up = speed(25, 10, 0, 3000, 100, 0, MillingMode::up);
  CHECK((down + up) / 2 == Approx(2 * pi * 30));
  // At rho = 0 the two feeds are perpendicular: Pythagoras.
  const ResultantSpeed s = resultant_speed({{{25, 10}, 0}, 1000, 100, 5000, MillingMode::up});
  CHECK(s.feed_speed_m_min == Approx(std::hypot(5.0, s.work_speed_m_min)));
  CHECK(resultant_speed({{{25, 10}, 20}, 0, 100, 300, MillingMode::up}).deviation_deg == 0);
}

TEST_CASE("S4: published numbers", "[S4]") {
  CHECK(block_feed_limit({0.01, 2}).max_feed_mm_min == Approx(300));
  CHECK(edge_speed_components({100, 45}).tangential_speed_m_min == Approx(70.7).margin(0.02));
  CHECK(flat_layer({16, 0.2}).edge_angle_deg == Approx(9.07).margin(5e-3));
  CHECK(flat_layer({16, 1}).edge_angle_deg == Approx(20.36).margin(5e-3));
  CHECK(flat_layer({16, 1}).width_mm == Approx(11.14).margin(5e-3));
  CHECK(flat_layer({16, 16}).edge_angle_deg == Approx(90));
  CHECK(kinematic_inclination({0, 0.01, 90}).turn_deg == Approx(0.57).margin(5e-3));
  CHECK(kinematic_inclination({0, 0.1, 90}).turn_deg == Approx(5.7).margin(0.02));
  CHECK(kinematic_inclination({0, 0.5, 90}).turn_deg == Approx(26.6).margin(0.05));
  CHECK(kinematic_inclination({0, 0.6, 90}).turn_deg == Approx(31.0).margin(0.05));
  CHECK(finishing_rule({600, 0.2}).applies);
  CHECK_FALSE(finishing_rule({599, 0.2}).applies);
  CHECK_FALSE(finishing_rule({600, 0.21}).ra_min_um.has_value());
  CHECK(finishing_rule({600, 4, 5}).applies);
}

TEST_CASE("S4: a block of the admissible length misses the arc by the tolerance", "[S4]") {
  const double length = block_length_for_tolerance({16, 0.01}).block_length_mm;
  CHECK(16 - std::sqrt(16 * 16 - length * length / 4) == Approx(0.01).epsilon(1e-9));
}

TEST_CASE("S4: the axis law keeps a cylinder tangent to the flat and the feed along it", "[S4]") {
  CHECK(rc::check([] {
    const double r = *rc::gen::inRange(0, 20), d = *rc::gen::inRange(1, 40);
    const double theta = *rc::gen::inRange(-70, 70), feed = 400;
    const FlatAxes here = flat_axis_law({{r, d}, theta, feed});
    // The tool centre lies R1 above the flat.
    RC_ASSERT(std::abs(here.x_mm * std::cos(theta * rad) - (d + r)) < 1e-9);
    const double h_deg = 1e-4;
    const FlatAxes next = flat_axis_law({{r, d}, theta + h_deg, feed});
    const double minutes = h_deg / 360 / here.work_speed_rpm;
    RC_ASSERT(std::abs((next.flat_position_mm - here.flat_position_mm) / minutes - feed) < 0.02);
    RC_ASSERT(std::abs((next.x_mm - here.x_mm) / minutes - here.x_feed_mm_min) < 0.02);
  }));
}

TEST_CASE("S4: X increments are antisymmetric, sum to zero and shrink to the middle", "[S4]") {
  for (const std::int64_t steps : {1, 2, 7, 100}) {
    const auto moves = flat_x_increments({{10, 15}, 40, steps}).increments_mm;
    REQUIRE(moves.size() == static_cast<std::size_t>(steps));
    for (std::size_t i = 0; i < moves.size(); ++i) CHECK(moves[i] == -moves[moves.size() - 1 - i]);
    CHECK(std::accumulate(moves.begin(), moves.end(), 0.0) == Approx(0).margin(1e-12));
    for (std::size_t i = 1; i <= moves.size() / 2; ++i)
      CHECK(std::abs(moves[i]) < std::abs(moves[i - 1]) + 1e-12);
  }
}

TEST_CASE("S4: step errors against their defining differences", "[S4]") {
  CHECK(rc::check([] {
    const double r = *rc::gen::inRange(1, 20), d = *rc::gen::inRange(1, 40);
    const double theta = *rc::gen::inRange(-60, 60), step = *rc::gen::inRange(1, 40) * 0.5;
    const auto x = [&](double deg) { return (d + r) / std::cos(deg * rad); };
    const StepErrors e = flat_step_error({{r, d}, theta, step});
    const double error = ((x(theta + step / 2) + x(theta - step / 2)) / 2 - x(theta)) * std::cos(theta * rad);
    const double along = (d + r) * (std::tan((theta + step / 2) * rad) - std::tan((theta - step / 2) * rad));
    RC_ASSERT(std::abs(e.interpolation_error_mm - error) < 1e-10);
    RC_ASSERT(std::abs(e.step_along_flat_mm - along) < 1e-10);
    RC_ASSERT(e.imprint_scallop_mm.has_value() == (along < 2 * r));
    if (e.imprint_scallop_mm)
      RC_ASSERT(std::abs(*e.imprint_scallop_mm - (r - std::sqrt(r * r - along * along / 4))) < 1e-9);
  }));
}

TEST_CASE("S4: layers that divide evenly are not rounded up", "[S4]") {
  CHECK(flat_milling_time({16, 0.9, 0.3, 0.9, 0.3, 10, 400}).layers == 3);
  CHECK(flat_milling_time({16, 0.9, 0.3, 0.9, 0.3, 10, 400}).axial_passes == 3);
  CHECK(flat_milling_time({16, 0.91, 0.3, 1, 1, 10, 400}).layers == 4);
}

TEST_CASE("S4: speeds along a flat are the resultant speed at the contact", "[S4]") {
  CHECK(rc::check([] {
    const double big = *rc::gen::inRange(5, 40), t = big * *rc::gen::inRange(1, 90) * 0.01;
    const double r = *rc::gen::inRange(1, 20), n1 = *rc::gen::inRange(500, 6000),
                 feed = *rc::gen::inRange(50, 3000);
    for (const MillingMode mode : {MillingMode::down, MillingMode::up}) {
      const FlatSpeeds s = flat_milling_speeds({{big, t}, r, n1, feed, mode});
      const double edge_deg = std::atan2(std::sqrt(big * big - (big - t) * (big - t)), big - t + r) / rad;
      const auto at = [&](double theta) {
        const FlatAxes axes = flat_axis_law({{r, big - t}, theta, feed});
        const double rho = mode == MillingMode::down ? -theta : theta;
        return speed(axes.x_mm, r, rho, n1, axes.work_speed_rpm, -axes.x_feed_mm_min, mode);
      };
      RC_ASSERT(std::abs(at(-edge_deg) - s.entry_speed_m_min) < 1e-9);
      RC_ASSERT(std::abs(at(0) - s.middle_speed_m_min) < 1e-9);
      RC_ASSERT(std::abs(at(edge_deg) - s.exit_speed_m_min) < 1e-9);
    }
  }));
}

TEST_CASE("S4: bad input names itself", "[S4]") {
  CHECK_THROWS_WITH(flat_layer({16, 17}), "S4.flat_layer: depth_mm = 17, must not be above blank_radius_mm");
  CHECK_THROWS_WITH(flat_axis_law({{5, -6}, 0, 100}), Catch::Contains("flat_distance_mm = -6"));
  CHECK_THROWS_WITH(flat_step_error({{5, 6}, 80, 30}), Catch::Contains("step_deg = 30"));
  CHECK_THROWS_WITH(block_length_for_tolerance({1, 2}), Catch::Contains("chord_tolerance_mm = 2"));
  CHECK_THROWS_WITH(kinematic_inclination({0, 1, 180}), Catch::Contains("cancel"));
}
