// The checks of card K405; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/gears/k405_hyperboloid_contact.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k405;

TEST_CASE("K405: the pair is the pitch-point value of the kinematics, sliding along the tooth", "[K405]") {
  verstat::test::property([] {
    const double beta_gear = *rc::gen::inRange(-60, 61);
    const double beta_tool = *rc::gen::inRange(-60, 61);
    const std::int64_t z_gear = *rc::gen::inRange(10, 80);
    const std::int64_t z_tool = *rc::gen::inRange(1, 60);
    const CrossedPair p = crossed_pair({{2, z_gear, beta_gear, z_tool, beta_tool}, 300});
    const ContactVelocities v = contact_velocities(
        {p.gear_diameter_mm / 2, 0, 0, p.centre_distance_mm, p.shaft_angle_deg, p.gear_rpm, -300});
    RC_ASSERT(std::abs(v.rel_m_min - p.sliding_m_min) < 1e-9 * (1 + v.gear_m_min + v.tool_m_min));
    RC_ASSERT(std::abs(v.gear_m_min - p.pitch_gear_m_min) < 1e-9 * v.gear_m_min);
    if (p.shaft_angle_deg == 0) {
      RC_ASSERT(p.sliding_m_min < 1e-12);
      return;
    }
    const double tan = std::tan(beta_gear * std::numbers::pi / 180);
    RC_ASSERT(sliding_contact_angle({v.rel_x_m_min, v.rel_y_m_min, v.rel_z_m_min, 0, tan, 1}).angle_deg <
              1e-4);
    const double n =
        tool_speed_for_sliding({{2, z_gear, beta_gear, z_tool, beta_tool}, p.sliding_m_min}).tool_rpm;
    RC_ASSERT(std::abs(n - 300) < 1e-7);
  });
}

TEST_CASE("K405: sliding grows with shaft angle and speed", "[K405]") {
  double before = -1;
  for (double beta = 0; beta <= 60; beta += 5) {
    const double now = crossed_pair({{2, 40, 0, 25, beta}, 300}).sliding_m_min;
    CHECK(now > before);
    before = now;
  }
  CHECK(crossed_pair({{2, 40, 0, 25, 20}, 600}).sliding_m_min ==
        Approx(2 * crossed_pair({{2, 40, 0, 25, 20}, 300}).sliding_m_min));
}

TEST_CASE("K405: angle to the contact line", "[K405]") {
  CHECK(sliding_contact_angle({1, 0, 0, -5, 0, 0}).angle_deg == Approx(0).margin(1e-12));
  CHECK(sliding_contact_angle({1, 0, 0, 0, 1e-200, 0}).angle_deg == Approx(90));
  CHECK(sliding_contact_angle({1, 1, 0, 0, -2, 0}).angle_deg == Approx(45));
}

TEST_CASE("K405: equal paths roll without sliding", "[K405]") {
  const ContactPointSpeeds s = contact_point_speeds({0.8, 0.8, 5, 100});
  CHECK(s.slide_m_min == 0);
  CHECK(s.sum_m_min == Approx(2 * s.gear_m_min));
}

TEST_CASE("K405: the published roll-over, and the mesh that it interrupts", "[K405]") {
  CHECK(rolling_window({-40, 40, 100, 9}).window_deg == 80);
  CHECK(rolling_window({-40, 40, 100, 9}).pairs_in_contact == Approx(2));
  CHECK(rolling_window({-40, 40, 100, 4}).pairs_in_contact < 1);
  CHECK(rolling_window({-40, 40, 100, 5}).pairs_in_contact > 1);
}

TEST_CASE("K405: conformal and interfering surfaces", "[K405]") {
  CHECK(reduced_curvature({15, 15, true}).curvature_per_mm == 0);
  CHECK(reduced_curvature({15, 15, true}).radius_mm == 1e300);
  CHECK(reduced_curvature({10, 15, true}).radius_mm < 0);
  CHECK(reduced_curvature({20, 15, true}).radius_mm == Approx(60));
}

TEST_CASE("K405: statistics of deviations", "[K405]") {
  const DeviationStatistics s = surface_deviation({{3, -1, 4, -2}});
  CHECK(s.range == 6);
  CHECK(s.mean == 1);
  CHECK(s.rms == Approx(std::sqrt(30.0 / 4)));
}

TEST_CASE("K405: Hertz pressure carries the load", "[K405]") {
  const LineContactPressure p = line_contact_pressure({100, 10, 210000, 0.3, 600000, 0.22});
  CHECK(std::numbers::pi / 2 * p.p_max_mpa * p.half_width_mm == Approx(100));
}

TEST_CASE("K405: bad input names itself", "[K405]") {
  CHECK_THROWS_WITH(tool_speed_for_sliding({{2, 40, 20, 25, -20}, 60}),
                    "K405.tool_speed_for_sliding: beta_tool = -20, must not be -beta_gear: without a shaft "
                    "angle nothing slides");
  CHECK_THROWS_WITH(rolling_window({40, 40, 100, 9}),
                    "K405.rolling_window: phi_to = 40, must be above phi_from");
  CHECK_THROWS_WITH(sliding_contact_angle({0, 0, 0, 1, 0, 0}), Catch::Contains("vx = vy = vz = 0"));
  CHECK_THROWS_WITH(surface_deviation({{}}), Catch::Contains("deviations has 0 entries"));
}
