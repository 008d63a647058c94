// The checks of card S2; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/rolling_profile.h"
#include "models/milling/s2_rolling_generation.h"

using namespace verstat::models;
using namespace verstat::models::s2;

namespace {

using std::numbers::pi;
constexpr double rad = pi / 180;

Profile arc(double zc, double yc, double r, double z_min, double z_max) {
  Profile p;
  p.kind = ProfileKind::arc;
  p.zc = zc;
  p.yc = yc;
  p.r = r;
  p.z_min = z_min;
  p.z_max = z_max;
  return p;
}
Profile poly(std::vector<double> coeff, double z_min, double z_max) {
  Profile p;
  p.kind = ProfileKind::poly;
  p.coeff = std::move(coeff);
  p.z_min = z_min;
  p.z_max = z_max;
  return p;
}
Profile points(std::vector<double> z, std::vector<double> y) {
  Profile p;
  p.kind = ProfileKind::points;
  p.z_min = z.front();
  p.z_max = z.back();
  p.z = std::move(z);
  p.y = std::move(y);
  return p;
}

Stroke stroke(const Profile& profile, double alpha, double start, double end, std::int64_t steps,
              double slip) {
  return {{profile, alpha}, start, end, steps, slip};
}

// Two domes of radius 30 that meet at the origin at the angle beta.
CornerStroke domes(double beta_deg, double alpha_deg, double end_mm, std::int64_t steps, double slip) {
  const double zc = 30 * std::cos(beta_deg / 2 * rad), yc = -30 * std::sin(beta_deg / 2 * rad);
  return {stroke(arc(zc, yc, 30, 0, zc + 27), alpha_deg, 0, end_mm, steps, slip),
          arc(-zc, yc, 30, -zc - 27, 0)};
}

const Profile example_poly = poly({5, 1.5, -0.02, -0.0004}, -20, 30);

}  // namespace

TEST_CASE("S2: p = 1 does not slide at the contact, p = 0 slides with the feed", "[S2]") {
  CHECK(rc::check([] {
    const double slip = *rc::gen::inRange(-5, 15) * 0.1;
    const double alpha = *rc::gen::inRange(20, 120);
    const double z = *rc::gen::inRange(-4, 14);
    const Profile& side = *rc::gen::arbitrary<bool>() ? example_poly : arc(12, 20, 30, -17.9, 41.9);
    // The material point at z, before and after a small step of the contact.
    const auto place = [&](double contact) {
      const StrokeMotion m = rolling_path(stroke(side, alpha, -5, contact, 2, slip));
      const double phi = m.rotation_deg * rad;
      const ProfileSide f(side, "profile");
      // Rotation is relative to the start; the start itself is rotated by phi_0.
      const double phi0 = (90 - alpha / 2) * rad - std::atan(f.slope(-5));
      const double y = f.y(z);
      return std::pair{z * std::cos(phi + phi0) - y * std::sin(phi + phi0) + m.s_z_mm,
                       z * std::sin(phi + phi0) + y * std::cos(phi + phi0) + m.s_y_mm};
    };
    const double h = 1e-4;
    const auto [z1, y1] = place(z - h);
    const auto [z2, y2] = place(z + h);
    const double feed = ProfileSide(side, "profile").arc_length(z - h, z + h);
    const double along = std::sin(alpha / 2 * rad), across = std::cos(alpha / 2 * rad);
    // The material moves against the edge by (1 - p) of the feed.
    RC_ASSERT(std::abs((z2 - z1) / feed + (1 - slip) * along) < 1e-6);
    RC_ASSERT(std::abs((y2 - y1) / feed + (1 - slip) * across) < 1e-6);
  }));
}

TEST_CASE("S2: a circle about O1 is translated by p L u", "[S2]") {
  for (const double slip : {0.0, 0.4, 1.0}) {
    const StrokeMotion m = rolling_path(stroke(arc(0, 0, 30, -29, 29), 40, -20, 15, 10, slip));
    CHECK(m.s_z_mm == Approx(slip * m.arc_length_mm * std::sin(20 * rad)).margin(1e-12));
    CHECK(m.s_y_mm == Approx(slip * m.arc_length_mm * std::cos(20 * rad)).margin(1e-12));
    CHECK(m.arc_length_mm == Approx(30 * m.rotation_deg * rad));
  }
}

TEST_CASE("S2: one transfer equals the path from z1 to z2, and passes smoothly through z1", "[S2]") {
  CHECK(rc::check([] {
    const double alpha = *rc::gen::inRange(60, 95), slip = *rc::gen::inRange(-10, 15) * 0.1;
    const Worked worked{example_poly, alpha};
    const double z1 = rolling_transfer({worked, 5, slip, ArcMode::exact}).z1_mm;
    const double z2 = z1 + *rc::gen::inRange(1, 90) * 0.1;
    const TransferMotion t = rolling_transfer({worked, z2, slip, ArcMode::exact});
    const StrokeMotion m = rolling_path(stroke(example_poly, alpha, z1, z2, 2, slip));
    RC_ASSERT(std::abs(t.rotation_deg - m.rotation_deg) < 1e-9);
    RC_ASSERT(std::abs(t.ds_z_mm - m.s_z_mm) < 1e-9);
    RC_ASSERT(std::abs(t.ds_y_mm - m.s_y_mm) < 1e-9);
    const TransferMotion before = rolling_transfer({worked, z1 - 1e-4, slip, ArcMode::exact});
    const TransferMotion after = rolling_transfer({worked, z1 + 1e-4, slip, ArcMode::exact});
    RC_ASSERT(before.arc_length_mm < 0 && after.arc_length_mm > 0);
    RC_ASSERT(std::abs(before.ds_z_mm + after.ds_z_mm) < 1e-6);
    RC_ASSERT(std::abs(before.ds_y_mm + after.ds_y_mm) < 1e-6);
  }));
}

TEST_CASE("S2: corner threshold of 90 deg", "[S2]") {
  CHECK(vertex_gouge(domes(92, 60, 6, 60, 1)).max_gouge_mm == 0);
  CHECK(vertex_gouge(domes(120, 60, 6, 60, 1)).max_gouge_mm == 0);
  CHECK(vertex_gouge(domes(88, 60, 6, 60, 1)).max_gouge_mm == Approx(0.0003).margin(5e-5));
  CHECK(vertex_gouge(domes(80, 60, 6, 60, 1)).max_gouge_mm == Approx(0.036).margin(5e-4));
  CHECK(vertex_gouge(domes(60, 40, 6, 60, 1)).max_gouge_mm == Approx(0.78).margin(5e-3));
}

TEST_CASE("S2: the limited path leaves no gouge and never slips less than asked", "[S2]") {
  CHECK(rc::check([] {
    const double slip = *rc::gen::inRange(1, 12) * 0.1;
    const CornerStroke in = domes(*rc::gen::inRange(50, 110), 40, *rc::gen::inRange(1, 12),
                                  *rc::gen::inRange<std::int64_t>(2, 80), slip);
    const LimitedStroke s = rolling_path_limited(in);
    RC_ASSERT(s.max_gouge_mm < 1e-11);
    RC_ASSERT(s.min_step_slip <= slip + 1e-12);
    RC_ASSERT(s.mean_slip >= s.min_step_slip - 1e-12);
    RC_ASSERT(std::abs(s.mean_slip * s.arc_length_mm - s.vertex_offset_mm) < 1e-12);
    if (vertex_gouge(in).max_gouge_mm == 0) {
      const Stroke free = stroke(in.profile, 40, 0, in.z_end_mm, 2, slip);
      RC_ASSERT(std::abs(rolling_path(free).s_z_mm - s.s_z_mm) < 1e-9);
    }
  }));
  CHECK(rolling_path_limited(domes(60, 40, 6, 60, 1)).min_step_slip == Approx(0.94).margin(5e-3));
}

TEST_CASE(
    "S2: the limiting vertex lies on the opposite side, on the tangent; at the corner it is the contact",
    "[S2]") {
  const CornerStroke in = domes(60, 40, 6, 60, 1);
  for (const double z2 : {1.0, 3.0, 10.0}) {
    const VertexLimit v = vertex_limit({{in.profile, 40}, in.opposite, z2});
    REQUIRE(v.limited);
    const double phi = -v.rotation_deg * rad;
    const double z = *v.vertex_z_mm * std::cos(phi) - *v.vertex_y_mm * std::sin(phi);
    const double y = *v.vertex_z_mm * std::sin(phi) + *v.vertex_y_mm * std::cos(phi);
    const ProfileSide worked(in.profile, "profile"), opposite(in.opposite, "opposite");
    CHECK(opposite.y(z) == Approx(y).margin(1e-10));
    CHECK((worked.y(z2) - y) / (z2 - z) == Approx(worked.slope(z2)).epsilon(1e-10));
    CHECK(std::hypot(z2 - z, worked.y(z2) - y) == Approx(*v.max_offset_mm).epsilon(1e-10));
  }
  const VertexLimit corner = vertex_limit({{in.profile, 40}, in.opposite, 0});
  CHECK(corner.limited);
  CHECK(*corner.max_offset_mm == 0);
  const VertexLimit away = vertex_limit({{in.profile, 40}, arc(60, 0, 5, 58, 62), 3});
  CHECK_FALSE(away.limited);
  CHECK_FALSE(away.max_offset_mm.has_value());
  // The same opposite side as a polynomial through a finely sampled arc.
  std::vector<double> z, y;
  const ProfileSide opposite(in.opposite, "opposite");
  for (double k = -20; k <= 0; k += 0.1) {
    z.push_back(k);
    y.push_back(opposite.y(std::min(k, 0.0)));
  }
  const VertexLimit spline = vertex_limit({{in.profile, 40}, points(z, y), 3});
  CHECK(*spline.max_offset_mm == Approx(5.048544654635139).epsilon(1e-5));
}

TEST_CASE("S2: chord against arc differs by (L/r)^2/24", "[S2]") {
  const Worked worked{arc(0, 0, 30, -29, 29), 60};
  const TransferMotion exact = rolling_transfer({worked, -10, 1, ArcMode::exact});
  const TransferMotion chord = rolling_transfer({worked, -10, 1, ArcMode::chord});
  const double angle = exact.arc_length_mm / 30;
  CHECK(1 - chord.arc_length_mm / exact.arc_length_mm == Approx(angle * angle / 24).epsilon(0.02));
}

TEST_CASE("S2: sides of all kinds agree on one curve", "[S2]") {
  // y = 2 z - 0.03 z^2 as polynomial and as spline with its ends cut off (natural ends are straight).
  const Profile exact = poly({0, 2, -0.03}, 0, 20);
  std::vector<double> z, y;
  for (int k = -400; k <= 800; ++k) {
    z.push_back(0.05 * k);
    y.push_back(2 * z.back() - 0.03 * z.back() * z.back());
  }
  Profile spline = points(z, y);
  spline.z_min = 0;
  spline.z_max = 20;
  const ProfileSide a(exact, "profile"), b(spline, "profile");
  for (double at = 0; at <= 20; at += 0.37) {
    CHECK(a.y(at) == Approx(b.y(at)).margin(1e-9));
    CHECK(a.slope(at) == Approx(b.slope(at)).margin(1e-9));
  }
  CHECK(a.arc_length(3, 17) == Approx(b.arc_length(3, 17)).epsilon(1e-10));
  CHECK(a.arc_length(17, 3) == -a.arc_length(3, 17));
  CHECK(a.nearest_with_slope(1.4, 0).value() == Approx(10));
  CHECK(b.nearest_with_slope(1.4, 0).value() == Approx(10).epsilon(1e-7));
  CHECK_FALSE(a.nearest_with_slope(3, 0).has_value());
  CHECK(a.last_on_line(0, 0, 1.7, 20).value() == Approx(10));
  CHECK(a.last_on_line(0, 0, 1.7, 9).value() == Approx(0).margin(1e-12));
  // Arc length of the parabola in closed form.
  const auto primitive = [](double s) { return (s * std::sqrt(1 + s * s) + std::asinh(s)) / 2; };
  CHECK(a.arc_length(3, 17) == Approx((primitive(2 - 0.18) - primitive(2 - 1.02)) / 0.06).epsilon(1e-12));
  // Two points make a straight line, every point of which has its slope.
  const ProfileSide line(points({0, 10}, {0, 10}), "profile");
  CHECK(line.nearest_with_slope(1, 4).value() == 4);
}

TEST_CASE("S2: of several points with the edge's slope the nearest to the contact is taken", "[S2]") {
  // f' = 1 at z = 0, 2, 4.
  const Worked worked{poly({0, 1, 4, -2, 0.25}, -1, 5), 90};
  CHECK(rolling_transfer({worked, 0.4, 1, ArcMode::exact}).z1_mm == Approx(0).margin(1e-12));
  CHECK(rolling_transfer({worked, 1.6, 1, ArcMode::exact}).z1_mm == Approx(2));
  CHECK(rolling_transfer({worked, 4.9, 1, ArcMode::exact}).z1_mm == Approx(4));
}

TEST_CASE("S2: a range that ends at the contact with the edge's slope holds it", "[S2]") {
  const double z1 = rolling_transfer({{example_poly, 70}, 8, 1, ArcMode::exact}).z1_mm;
  Profile cut = example_poly;
  cut.z_min = z1;
  CHECK(rolling_transfer({{cut, 70}, 8, 1, ArcMode::exact}).z1_mm == Approx(z1));
  const double z_arc = 12 - 30 * std::sin(70 * rad);
  CHECK(rolling_transfer({{arc(12, 20, 30, z_arc, 41), 40}, 0, 1, ArcMode::exact}).z1_mm == Approx(z_arc));
}

TEST_CASE("S2: facets and their inverse, time limits, wear spread", "[S2]") {
  CHECK(rc::check([] {
    const double r = *rc::gen::inRange(1, 200), e = *rc::gen::inRange(1, 500) * 1e-4;
    const double step = rotation_step_for_tolerance({r, e}).rotation_step_deg;
    RC_ASSERT(std::abs(facet_error({r, step}).facet_error_mm - e) < 1e-12);
    RC_ASSERT(std::abs(facet_error({r, step}).facet_error_mm - r * (1 / std::cos(step / 2 * rad) - 1)) <
              1e-9);
  }));
  TimedStroke timed;
  static_cast<Stroke&>(timed) = stroke(arc(0, 0, 30, -29, 29), 40, -14, 5, 20, 0);
  timed.feed_mm_min = 200;
  timed.max_rotation_rpm = 1e9;
  timed.max_axis_feed_mm_min = 1e9;
  const StrokeMotion m = rolling_path(timed);
  CHECK(rolling_time(timed).time_min == Approx(m.arc_length_mm / 200));
  timed.feed_mm_min = 1e9;
  timed.max_rotation_rpm = 2;
  CHECK(rolling_time(timed).time_min == Approx(m.rotation_deg / 360 / 2));
  CHECK(edge_wear_spread({0, 40, 5}).life_factor == 1);
  CHECK(edge_wear_spread({-0.5, 40, 5}).contact_travel_mm == 20);
}

TEST_CASE("S2: bad input names itself", "[S2]") {
  CHECK_THROWS_WITH(rolling_path(stroke(example_poly, 40, 0, 5, 3, 1)),
                    "S2.rolling_path: steps = 3, must be even");
  CHECK_THROWS_WITH(rolling_path(stroke(example_poly, 40, 0, 50, 4, 1)),
                    Catch::Contains("z_end_mm = 50, must lie between z_min and z_max"));
  CHECK_THROWS_WITH(rolling_path(stroke(arc(0, 0, 30, -30, 5), 40, 0, 5, 4, 1)),
                    Catch::Contains("profile/z_min = -30, must be above zc - r"));
  CHECK_THROWS_WITH(rolling_path(stroke(points({0, 2, 1}, {0, 1, 2}), 40, 0, 1, 4, 1)),
                    Catch::Contains("profile/z/2 = 1, must be above the point before it"));
  CHECK_THROWS_WITH(rolling_path(stroke(poly({}, 0, 5), 40, 0, 1, 4, 1)),
                    Catch::Contains("profile/coeff is missing"));
  CHECK_THROWS_WITH(rolling_transfer({{poly({0, 0.1}, 0, 5), 40}, 1, 1, ArcMode::exact}),
                    Catch::Contains("no point of the profile has the slope of the edge"));
}
