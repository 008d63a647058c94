// The checks of card K202; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/gears/k202_hyperboloid_forming.h"
#include "models/math/solve.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k202;

namespace {

constexpr double pi = std::numbers::pi;

double rad(double deg) {
  return deg * pi / 180;
}

double distance(const GearPoint& a, const GearPoint& b) {
  return std::hypot(a.x2_mm - b.x2_mm, a.y2_mm - b.y2_mm, a.z2_mm - b.z2_mm);
}

}  // namespace

TEST_CASE("K202: the transformation keeps every distance", "[K202]") {
  verstat::test::property([] {
    const auto any = [] { return 0.37 * *rc::gen::inRange(-500, 500); };
    const double phi = any(), u = 0.01 * any(), a = any(), gamma = any();
    const ToolPoint p{any(), any(), any(), phi, u, a, gamma};
    const ToolPoint q{any(), any(), any(), phi, u, a, gamma};
    const double before = std::hypot(p.x1_mm - q.x1_mm, p.y1_mm - q.y1_mm, p.z1_mm - q.z1_mm);
    RC_ASSERT(std::abs(distance(tool_to_gear_transform(p), tool_to_gear_transform(q)) - before) < 1e-9);
  });
}

TEST_CASE("K202: normal and curvature of the involute", "[K202]") {
  verstat::test::property([] {
    const double t = 0.01 * *rc::gen::inRange(1, 120);
    const std::int64_t z = *rc::gen::inRange(12, 80);
    const InvoluteProfile f = involute_tool_profile({3, z, 20, t});
    const SurfaceGeometry s = producing_surface_geometry({f.df1, f.df2, f.d2f1, f.d2f2});
    RC_ASSERT(std::abs(std::hypot(s.nx, s.ny, s.nz) - 1) < 1e-12);
    RC_ASSERT(std::abs(s.nx * f.df1 + s.ny * f.df2) < 1e-9);
    const double rb = 1.5 * static_cast<double>(z) * std::cos(rad(20));
    RC_ASSERT(std::abs(std::abs(s.k_mu) * rb * t - 1) < 1e-9);
    RC_ASSERT(s.k_lambda == 0);
    RC_ASSERT(std::abs(normal_curvature({s.l1, s.e1, s.g1, 2, 0}).k - s.k_mu) < 1e-12);
    RC_ASSERT(normal_curvature({s.l1, s.e1, s.g1, 0, 1}).k == 0);
    // Derivatives against differences of the profile.
    RC_PRE(t > 0.02 && t < 1.18);
    const double h = 1e-5;
    const InvoluteProfile up = involute_tool_profile({3, z, 20, t + h});
    const InvoluteProfile down = involute_tool_profile({3, z, 20, t - h});
    RC_ASSERT(std::abs((up.f1_mm - down.f1_mm) / (2 * h) - f.df1) < 1e-6 * rb);
    RC_ASSERT(std::abs((up.f2_mm - down.f2_mm) / (2 * h) - f.df2) < 1e-6 * rb);
    RC_ASSERT(std::abs((up.df1 - down.df1) / (2 * h) - f.d2f1) < 1e-6 * rb);
    RC_ASSERT(std::abs((up.df2 - down.df2) / (2 * h) - f.d2f2) < 1e-6 * rb);
  });
}

TEST_CASE("K202: the pitch point touches at the throat", "[K202]") {
  ToothInputs in{{3, 20, 40, 25}, 20, std::tan(rad(20)), 0};
  const ToothPoint p = gear_tooth_point(in);
  CHECK(p.mu_mm == Approx(0).margin(1e-9));
  CHECK(p.x2_mm == Approx(generating_setup(in).gear_throat_radius_mm));
  CHECK(p.y2_mm == Approx(0).margin(1e-9));
  CHECK(p.z2_mm == Approx(0).margin(1e-9));
}

TEST_CASE("K202: at a contact point the relative velocity lies in the surface", "[K202]") {
  verstat::test::property([] {
    const double t = 0.01 * *rc::gen::inRange(15, 80);
    const double phi = 0.5 * *rc::gen::inRange(-10, 31);
    const double gamma = *rc::gen::inRange(10, 60);
    const Setup s = generating_setup({3, 20, 40, gamma});
    const InvoluteProfile f = involute_tool_profile({3, 20, 20, t});
    const double x1 = f.f1_mm - s.tool_pitch_radius_mm;
    RC_PRE(std::abs(f.df2 * std::cos(rad(phi)) + f.df1 * std::sin(rad(phi))) > 0.05);  // away from the pole
    const double mu =
        contact_mu({x1, f.f2_mm, f.df2, -f.df1, phi, s.ratio_u21, s.center_distance_mm, gamma}).mu_mm;
    const auto at = [&](double x, double y, double z, double angle) {
      return tool_to_gear_transform({x, y, z, angle, s.ratio_u21, s.center_distance_mm, gamma});
    };
    // Velocity of the tool point in the gear's frame, mm per degree, and the unit normal moved there.
    const double h = 1e-3;
    const GearPoint up = at(x1, f.f2_mm, mu, phi + h);
    const GearPoint down = at(x1, f.f2_mm, mu, phi - h);
    const SurfaceGeometry g = producing_surface_geometry({f.df1, f.df2, f.d2f1, f.d2f2});
    const GearPoint here = at(x1, f.f2_mm, mu, phi);
    const GearPoint tip = at(x1 + g.nx, f.f2_mm + g.ny, mu, phi);
    const double residual = ((up.x2_mm - down.x2_mm) * (tip.x2_mm - here.x2_mm) +
                             (up.y2_mm - down.y2_mm) * (tip.y2_mm - here.y2_mm) +
                             (up.z2_mm - down.z2_mm) * (tip.z2_mm - here.z2_mm)) /
                            (2 * h);
    RC_ASSERT(std::abs(residual) < 1e-6);
  });
}

TEST_CASE("K202: cutting speed is the velocity of the pitch point", "[K202]") {
  const Setup s = generating_setup({3, 20, 40, 25});
  const double h = 1e-4;
  const auto at = [&](double phi) {
    return tool_to_gear_transform(
        {-s.tool_pitch_radius_mm, 0, 0, phi, s.ratio_u21, s.center_distance_mm, 25});
  };
  const double mm_per_deg = distance(at(h), at(-h)) / (2 * h);
  CHECK(sliding_cutting_speed({s.tool_pitch_radius_mm, 500, 25}).vc_m_min ==
        Approx(mm_per_deg * 360 * 500 / 1000).epsilon(1e-6));
  CHECK(sliding_cutting_speed({30, 500, 0}).vc_m_min == 0);
}

TEST_CASE("K202: the blank is narrowest and even at the throat, and the tool cylinder leaves less",
          "[K202]") {
  const auto radius = [](double z) { return hyperboloid_blank_radius({z, 93.378, 30, 25}).radius_mm; };
  CHECK(radius(0) == Approx(63.378));
  CHECK(radius(20) == radius(-20));
  CHECK(radius(20) == Approx(64.06).margin(0.005));
  CHECK(radius(35) == Approx(65.45).margin(0.005));
  // The generator itself lies on the hyperboloid.
  for (const double z1 : {-30.0, 10.0, 40.0}) {
    const GearPoint p = tool_to_gear_transform({-30, 0, z1, 0, -0.5, 93.378, 25});
    CHECK(std::hypot(p.x2_mm, p.y2_mm) == Approx(radius(p.z2_mm)));
  }
  const double gamma = rad(25);
  for (const double z : {20.0, 35.0}) {
    const double envelope =
        minimize_global(
            [&](double theta) {
              return std::hypot(93.378 - 30 * std::cos(theta),
                                30 * std::sin(theta) / std::cos(gamma) - z * std::tan(gamma));
            },
            -pi, pi)
            .value;
    CHECK(envelope == Approx(z == 20 ? 63.81 : 64.70).margin(0.005));
    CHECK(envelope < radius(z));
  }
}

TEST_CASE("K202: time is proportional to passes and to 1 / feed", "[K202]") {
  GenerationInputs in{25, 8, 25, 0.3, 500, 20, 40, 1};
  const double once = gear_generation_time(in).time_min;
  in.passes = 3;
  CHECK(gear_generation_time(in).time_min == Approx(3 * once));
  in.feed_mm_rev = 0.6;
  CHECK(gear_generation_time(in).time_min == Approx(1.5 * once));
}

TEST_CASE("K202: bad input names itself", "[K202]") {
  CHECK_THROWS_WITH(generating_setup({3, 11, 40, 25}),
                    "K202.generating_setup: tool_teeth = 11, allowed tool_teeth >= 12 (teeth of the tool)");
  CHECK_THROWS_WITH(contact_mu({-30, 0, 0, 1, 0, -0.5, 90, 25}), Catch::Contains("no x component"));
  CHECK_THROWS_WITH(hyperboloid_blank_radius({0, 30, 30, 25}),
                    "K202.hyperboloid_blank_radius: tool_radius_mm = 30, must be below center_distance_mm");
  CHECK_THROWS_WITH(producing_surface_geometry({0, 0, 1, 1}), Catch::Contains("df1 = df2 = 0"));
}
