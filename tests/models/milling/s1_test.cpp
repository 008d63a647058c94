// The checks of card S1; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/s1_cam_milling.h"

using namespace verstat::models;
using namespace verstat::models::s1;

namespace {

constexpr double rad = std::numbers::pi / 180;
constexpr Cam sharp{18, 8, 18, 60};
constexpr Cam blunt{30, 20, 22, 120};

CamSupport at(const Cam& cam, double normal_deg) {
  CamAtNormal in;
  in.cam = cam;
  in.normal_angle_deg = normal_deg;
  return cam_support(in);
}

ToolSetting setting(const Cam& cam, double normal_deg, double radius_mm, double alpha_deg) {
  CamSetting in;
  in.cam = cam;
  in.normal_angle_deg = normal_deg;
  in.tool_radius_mm = radius_mm;
  in.orientation_deg = alpha_deg;
  return cam_tool_setting(in);
}

RotationLaw rotation(const Cam& cam, double normal_deg, double feed_mm_min) {
  CamFeed in;
  in.cam = cam;
  in.normal_angle_deg = normal_deg;
  in.contour_feed_mm_min = feed_mm_min;
  return cam_rotation_law(in);
}

MovingTool moving(double z_mm, double radius_mm, double alpha_deg, double part_deg) {
  MovingTool in;
  in.tool_z_mm = z_mm;
  in.tool_radius_mm = radius_mm;
  in.orientation_deg = alpha_deg;
  in.part_angle_deg = part_deg;
  return in;
}

}  // namespace

TEST_CASE("S1: on the concentric section X = 0, Y and the speed are constant", "[S1]") {
  const double n_rpm = rotation(sharp, 180, 1500).part_speed_rpm;
  for (double normal_deg = 66; normal_deg <= 294; normal_deg += 6) {
    const ToolSetting s = setting(sharp, normal_deg, 40, 20);
    CHECK(s.y_mm == 18 + 40);
    CHECK(s.x_vertical_mm == Approx(0).margin(1e-14));
    CHECK(s.x_model_mm == Approx(0).margin(1e-14));
    CHECK(rotation(sharp, normal_deg, 1500).part_speed_rpm == n_rpm);
  }
}

TEST_CASE("S1: with the setting law the pivot contact of eq. (8) is the cam point", "[S1]") {
  CHECK(rc::check([] {
    const Cam& cam = *rc::gen::arbitrary<bool>() ? sharp : blunt;
    const double normal_deg = *rc::gen::inRange(0, 3600) * 0.1 + 0.013;
    const double alpha_deg = *rc::gen::inRange(-60, 60);
    const double radius_mm = 40;
    const auto setting_at = [&](double deg) { return setting(cam, deg, radius_mm, alpha_deg); };
    const ToolSetting s = setting_at(normal_deg);
    MovingTool tool = moving(0, radius_mm, alpha_deg, normal_deg - 90);
    tool.x_mm = s.x_model_mm;
    tool.y_mm = s.y_mm;
    tool.z_mm = 0.3 + s.x_model_mm * std::sin(alpha_deg * rad);
    const double h_rad = 1e-4 * rad;
    const auto [left, right] = std::pair{setting_at(normal_deg - 1e-4), setting_at(normal_deg + 1e-4)};
    tool.dx_mm_rad = (right.x_model_mm - left.x_model_mm) / (2 * h_rad);
    tool.dy_mm_rad = at(cam, normal_deg).support_derivative_mm_rad;
    tool.dz_mm_rad = tool.dx_mm_rad * std::sin(alpha_deg * rad);
    const ContactPoint contact = contact_point(tool);
    const CamSupport point = at(cam, normal_deg);
    RC_ASSERT(std::abs(contact.tool_angle_deg - 180) < 1e-9);
    RC_ASSERT(std::hypot(contact.x_part_mm - point.x_mm, contact.y_part_mm - point.y_mm) < 1e-10);
    RC_ASSERT(std::abs(contact.z_part_mm - 0.3) < 1e-10);
  }));
}

TEST_CASE("S1: eq. (8) holds: the numeric triple product vanishes at the contact", "[S1]") {
  CHECK(rc::check([] {
    const auto pick = [](int low, int high) { return *rc::gen::inRange(low * 100, high * 100) * 0.01; };
    MovingTool tool = moving(pick(-10, 10), pick(5, 60), pick(-40, 40), pick(-180, 180));
    tool.x_mm = pick(-8, 8);
    tool.y_mm = pick(50, 80);
    tool.z_mm = pick(-5, 5);
    tool.dx_mm_rad = pick(-6, 6);
    tool.dy_mm_rad = pick(-6, 6);
    tool.dz_mm_rad = pick(-1, 1);
    const double contact_deg = contact_point(tool).tool_angle_deg;
    const auto point = [&](double dz_tool, double dtheta_rad, double dpart_rad) {
      ToolPoint p;
      static_cast<ToolPlacement&>(p) = tool;
      p.tool_z_mm += dz_tool;
      p.tool_angle_deg = contact_deg + dtheta_rad / rad;
      p.part_angle_deg += dpart_rad / rad;
      p.x_mm += tool.dx_mm_rad * dpart_rad;
      p.y_mm += tool.dy_mm_rad * dpart_rad;
      p.z_mm += tool.dz_mm_rad * dpart_rad;
      const PartPoint r = tool_point_in_part(p);
      return std::array{r.x_part_mm, r.y_part_mm, r.z_part_mm};
    };
    const auto derivative = [](const auto& plus, const auto& minus, double h) {
      return std::array{(plus[0] - minus[0]) / (2 * h), (plus[1] - minus[1]) / (2 * h),
                        (plus[2] - minus[2]) / (2 * h)};
    };
    const double h = 1e-5;
    const auto k = derivative(point(h, 0, 0), point(-h, 0, 0), h);
    const auto t = derivative(point(0, h, 0), point(0, -h, 0), h);
    const auto p = derivative(point(0, 0, h), point(0, 0, -h), h);
    const double triple = (k[1] * t[2] - k[2] * t[1]) * p[0] + (k[2] * t[0] - k[0] * t[2]) * p[1] +
                          (k[0] * t[1] - k[1] * t[0]) * p[2];
    RC_ASSERT(std::abs(triple) < 1e-5);
  }));
}

TEST_CASE("S1: h and h' are continuous at the joints, the radius jumps; perimeter = integral of h", "[S1]") {
  for (const Cam& cam : {sharp, blunt}) {
    const CamGeometry g = cam_geometry({cam});
    for (const double joint_deg : {g.nose_joint_deg, g.base_joint_deg}) {
      const CamSupport before = at(cam, joint_deg);  // belongs to the arc nearer the nose
      const CamSupport after = at(cam, joint_deg + 1e-9);
      CHECK(before.support_mm == Approx(after.support_mm).margin(1e-8));
      CHECK(before.support_derivative_mm_rad == Approx(after.support_derivative_mm_rad).margin(1e-8));
      CHECK(std::abs(before.curvature_radius_mm - after.curvature_radius_mm) > 5);
    }
    CHECK(at(cam, g.nose_joint_deg).curvature_radius_mm == cam.r_nose_mm);
    CHECK(at(cam, -g.base_joint_deg).curvature_radius_mm == cam.r_flank_mm);
    double integral_mm = 0;
    constexpr int n = 200'000;
    for (int k = 0; k < n; ++k)
      integral_mm += at(cam, 360 * (k + 0.5) / n).support_mm * 2 * std::numbers::pi / n;
    CHECK(integral_mm == Approx(g.perimeter_mm).epsilon(1e-9));
  }
  const CamGeometry g = cam_geometry({sharp});
  CHECK(g.nose_joint_deg == Approx(47.529).margin(5e-4));
  CHECK(g.base_joint_deg == Approx(65.958).margin(5e-4));
  CHECK(g.perimeter_mm == Approx(123.524).margin(5e-4));
}

TEST_CASE("S1: a nearly straight flank stops the part and travels vertically", "[S1]") {
  const double alpha = std::acos((18.0 - 8.0) / 18.0);  // normal of the straight flank
  Cam straight = sharp;
  straight.r_flank_mm = 1e7;
  const RotationLaw law = rotation(straight, alpha / rad, 1500);
  CHECK(law.part_speed_rpm < 1e-4);
  CHECK(law.feed_x_mm_min == Approx(-1500).epsilon(1e-4));
}

TEST_CASE("S1: the usual scheme against finite differences and the published example", "[S1]") {
  UniformRotation in;
  in.cam = sharp;
  in.tool_radius_mm = 60;
  in.part_speed_rpm = 10;
  double least = 1e9, most = 0;
  for (int k = 0; k < 36'000; ++k) {
    in.normal_angle_deg = 0.005 + 0.01 * k;
    const double v = conventional_state(in).contour_feed_mm_min;
    least = std::min(least, v);
    most = std::max(most, v);
    if (k % 300 != 7) continue;
    UniformRotation next = in;
    next.normal_angle_deg += 1e-4;
    const double rho = at(sharp, in.normal_angle_deg).curvature_radius_mm;
    const double turn_deg = conventional_state(next).part_angle_deg - conventional_state(in).part_angle_deg;
    CHECK(v == Approx(rho * 1e-4 * rad / (turn_deg / 360 / 10)).epsilon(1e-4));
  }
  const FeedNonuniformity swing = conventional_feed_nonuniformity({{sharp}, 60});
  CHECK(swing.max_to_min_feed == Approx(most / least).epsilon(1e-4));
  CHECK(swing.max_to_min_feed == Approx(4.25).epsilon(1e-12));
  CHECK(swing.time_factor == Approx(2.09).margin(5e-3));
}

TEST_CASE("S1: the wear form error is the largest over the contour", "[S1]") {
  for (const double radius_mm : {5.0, 20.0, 60.0}) {
    double worst = 0;
    for (int k = 0; k < 36'000; ++k) {
      const CamSupport s = at(sharp, 0.01 * k);
      worst =
          std::max(worst, 1 - std::cos(std::atan(s.support_derivative_mm_rad / (s.support_mm + radius_mm))));
    }
    const WornTool worn{{{sharp}, radius_mm}, 0.1, WearScheme::centre_plane};
    CHECK(tool_wear_form_error(worn).form_error_mm == Approx(0.1 * worst).epsilon(2e-4));
    CHECK(tool_wear_form_error({{{sharp}, radius_mm}, 0.1, WearScheme::normal_contact}).form_error_mm == 0);
  }
}

TEST_CASE("S1: axial roughness limits, trends and inverse", "[S1]") {
  CHECK(axial_roughness({{40, 18}, 90, 1}).effective_radius_mm.value() == Approx(40));
  CHECK_FALSE(axial_roughness({{40, 18}, 0, 1}).effective_radius_mm.has_value());
  CHECK(rc::check([] {
    const double radius_mm = *rc::gen::inRange(5, 100), part_mm = *rc::gen::inRange(5, 100);
    const double alpha_deg = *rc::gen::inRange(1, 89), feed_mm = *rc::gen::inRange(1, 30) * 0.1;
    const double ra = axial_roughness({{radius_mm, part_mm}, alpha_deg, feed_mm}).ra_um;
    RC_ASSERT(axial_roughness({{radius_mm, part_mm}, alpha_deg + 0.5, feed_mm}).ra_um > ra);
    RC_ASSERT(axial_roughness({{radius_mm + 1, part_mm}, alpha_deg, feed_mm}).ra_um < ra);
    RC_ASSERT(axial_roughness({{radius_mm, part_mm + 1}, alpha_deg, feed_mm}).ra_um < ra);
    RC_ASSERT(std::abs(axial_roughness({{radius_mm, part_mm}, alpha_deg, 2 * feed_mm}).ra_um - 4 * ra) <
              1e-12 * ra);
    const double back_deg =
        max_orientation_for_roughness({{radius_mm, part_mm}, feed_mm, ra}).orientation_deg;
    RC_ASSERT(std::abs(back_deg - alpha_deg) < 1e-8);
  }));
  CHECK(max_orientation_for_roughness({{40, 18}, 0.1, 5}).orientation_deg == 90);
}

TEST_CASE("S1: the effective radius is that of the swept cylinder, by brute force", "[S1]") {
  // Concentric section: the cylinder, its axis at R + rho and turned by alpha, against coaxial part points.
  const double radius_mm = 40, part_mm = 18, alpha = 25 * rad, z_mm = 0.05;
  const auto depth_mm = [&](double z) {
    // Smallest distance from the part axis, over the turn of the part, of cylinder points at height z.
    double least = 1e9;
    for (int k = -20'000; k <= 20'000; ++k) {
      const double x = 1e-3 * k * z;  // across
      const double along = x * std::cos(alpha) - z * std::sin(alpha);
      const double y = radius_mm + part_mm - std::sqrt(radius_mm * radius_mm - along * along);
      least = std::min(least, std::hypot(x, y));
    }
    return least;
  };
  const double r_eff = z_mm * z_mm / (2 * (depth_mm(z_mm) - part_mm));
  CHECK(axial_roughness({{radius_mm, part_mm}, 25, 1}).effective_radius_mm.value() ==
        Approx(r_eff).epsilon(1e-4));
}

TEST_CASE("S1: roundness falls as 1/n^2 and 1/z^2, with larger D and rho", "[S1]") {
  const auto delta = [](double n, std::int64_t z, double d, double rho) {
    return roundness_deviation({2000, n, z, d, rho, 20}).roundness_deviation_um;
  };
  const double base = delta(3000, 8, 80, 18);
  CHECK(delta(6000, 8, 80, 18) == Approx(base / 4));
  CHECK(delta(3000, 16, 80, 18) == Approx(base / 4));
  CHECK(delta(3000, 8, 100, 18) < base);
  CHECK(delta(3000, 8, 80, 20) < base);
}

TEST_CASE("S1: the end-face split is the exact minimum over the circle, to second order", "[S1]") {
  const double radius_mm = 40, part_mm = 18, edge_mm = 8;
  for (const auto& [alpha_deg, tolerance] : {std::pair{20.0, 2e-3}, std::pair{30.0, 7e-3}}) {
    const double alpha = alpha_deg * rad;
    double least_mm = 1e9;
    for (int k = 0; k < 400'000; ++k) {
      const double turn = std::numbers::pi + (k - 200'000) * 1e-6;
      const PartPoint p =
          tool_point_in_part({{edge_mm, radius_mm, alpha_deg, 0, radius_mm + part_mm, 0, 0}, turn / rad});
      least_mm = std::min(least_mm, std::hypot(p.x_part_mm, p.y_part_mm) - part_mm);
    }
    INFO(alpha);
    const AllowanceSplit split = allowance_split({{radius_mm, part_mm}, 5, edge_mm, alpha_deg});
    CHECK(split.periphery_mm == Approx(least_mm).epsilon(tolerance));
    CHECK(split.periphery_mm + split.end_face_mm == Approx(5));
  }
  CHECK(allowance_split({{40, 18}, 0.5, 8, 0}).end_face_mm == 0.5);
}

TEST_CASE("S1: bad input names itself", "[S1]") {
  CHECK_THROWS_WITH(cam_geometry({{18, 8, 18, 12}}),
                    "S1.cam_geometry: cam/r_flank_mm = 12, must be larger than r_base_mm and r_nose_mm");
  CHECK_THROWS_WITH(cam_geometry({{18, 8, 5, 60}}), Catch::Contains("the arcs do not join"));
  CHECK_THROWS_WITH(contact_point(moving(0, 40, 0, 0)), Catch::Contains("the contact is undefined"));
}
