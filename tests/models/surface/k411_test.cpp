// The checks of card K411; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/surface/k411_finish_turning_roughness.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k411;

namespace {

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

// Height of the tool contour above the nose bottom at a distance x from it, for one side.
double contour(double x, double radius, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const double reach = radius * std::sin(angle);
  if (x <= reach) return radius - std::sqrt(radius * radius - x * x);
  return radius * (1 - std::cos(angle)) + (x - reach) * std::tan(angle);
}

struct Sampled {
  double height, mean_deviation;  // mm
};
// Profile over one feed: lower envelope of the tool contour and its copy one feed further, sampled.
Sampled sampled_profile(double feed, double radius, double kr_deg, double kr1_deg, int samples) {
  std::vector<double> z;
  double height = 0;
  double mean = 0;
  for (int k = 0; k < samples; ++k) {
    const double x = feed * (k + 0.5) / samples;
    z.push_back(std::min(contour(x, radius, kr_deg), contour(feed - x, radius, kr1_deg)));
    height = std::max(height, z.back());
    mean += z.back() / samples;
  }
  double deviation = 0;
  for (double value : z) deviation += std::abs(value - mean) / samples;
  return {height, deviation};
}

TurnedSurface surface(double feed, double radius, double kr, double kr1) {
  return {{radius, kr, kr1}, feed};
}

}  // namespace

TEST_CASE("K411: height and mean deviation are those of the sampled profile", "[K411]") {
  verstat::test::property([] {
    const double feed = *rc::gen::inRange(20, 1500) * 1e-3;
    const double radius = *rc::gen::inRange(100, 3000) * 1e-3;
    const double kr = *rc::gen::inRange(10, 88);
    const double kr1 = *rc::gen::inRange(2, 81);
    const auto exact = theoretical_roughness(surface(feed, radius, kr, kr1));
    const Sampled sampled = sampled_profile(feed, radius, kr, kr1, 20'000);
    // The highest sample misses the peak by at most half a step along the steepest side.
    const double step = feed / 20'000 * std::max(tangent(kr), tangent(kr1));
    RC_ASSERT(std::abs(exact.height_um * 1e-3 - sampled.height) <= step);
    RC_ASSERT(std::abs(exact.ra_profile_um * 1e-3 / sampled.mean_deviation - 1) < 1e-4);
  });
}

TEST_CASE("K411: mean deviation is 0.2566 h for the nose arc and 0.25 h for a triangle", "[K411]") {
  const auto arc = theoretical_roughness(surface(0.15, 2, 45, 45));
  CHECK(arc.ra_profile_um / arc.height_um == Approx(0.2566).margin(5e-5));
  const auto triangle = theoretical_roughness(surface(1.5, 0.1, 10, 2));
  CHECK(triangle.ra_profile_um / triangle.height_um == Approx(0.25).margin(2e-3));
  verstat::test::property([] {
    const auto p =
        theoretical_roughness(surface(*rc::gen::inRange(10, 1500) * 1e-3, *rc::gen::inRange(1, 51) * 0.1,
                                      *rc::gen::inRange(30, 76), *rc::gen::inRange(5, 46)));
    RC_ASSERT((p.ra_profile_um / p.height_um > 0.24 && p.ra_profile_um / p.height_um < 0.29));
  });
}

TEST_CASE("K411: the height is continuous, falls with the nose radius and does not know kr on the nose",
          "[K411]") {
  for (double kr : {30.0, 45.0, 60.0, 75.0, 90.0})
    for (double kr1 : {5.0, 15.0, 45.0}) {
      const double radius = 0.4;
      const auto at = theoretical_roughness(surface(0.1, radius, kr, kr1));
      for (double limit : {at.feed_limit_nose_mm, at.feed_limit_edge_mm}) {
        if (limit < 0.02 || limit > 1.4) continue;
        const double below = theoretical_roughness(surface(limit * (1 - 1e-9), radius, kr, kr1)).height_um;
        const double above = theoretical_roughness(surface(limit * (1 + 1e-9), radius, kr, kr1)).height_um;
        CHECK(below == Approx(above).epsilon(1e-7));
      }
      double previous = 1e9;
      for (double r : {0.1, 0.2, 0.4, 0.8, 1.6, 3.2}) {
        const double height = theoretical_roughness(surface(0.3, r, kr, kr1)).height_um;
        CHECK(height < previous);
        previous = height;
      }
    }
  CHECK(turning_ra({surface(0.33, 2, 45, 45)}).ra_um ==
        Approx(turning_ra({surface(0.33, 2, 75, 15)}).ra_um).epsilon(1e-14));
  // Straight edges alone as r -> 0: the edge-edge height is linear in r, extrapolated to r = 0.
  const double half = theoretical_roughness(surface(1.5, 0.1, 60, 30)).height_um;
  const double whole = theoretical_roughness(surface(1.5, 0.2, 60, 30)).height_um;
  CHECK(2 * half - whole == Approx(1500 / (1 / tangent(60) + 1 / tangent(30))).epsilon(1e-12));
}

TEST_CASE("K411: the limits name the lower regime", "[K411]") {
  const auto square = theoretical_roughness(surface(0.5, 0.5, 30, 30));
  CHECK(square.feed_limit_nose_mm == square.feed_limit_edge_mm);
  CHECK(theoretical_roughness(surface(square.feed_limit_edge_mm, 0.5, 30, 30)).regime ==
        ProfileRegime::nose_nose);
  const auto sharp = theoretical_roughness(surface(0.5, 0.4, 75, 15));
  CHECK(theoretical_roughness(surface(sharp.feed_limit_nose_mm, 0.4, 75, 15)).regime ==
        ProfileRegime::nose_nose);
  CHECK(sharp.regime == ProfileRegime::nose_edge);
}

TEST_CASE("K411: Ra and Ra + z sigma rise with feed, so the inverses are unique", "[K411]") {
  verstat::test::property([] {
    const double feed = *rc::gen::inRange(10, 1490) * 1e-3;
    const double radius = *rc::gen::inRange(1, 51) * 0.1;
    const double kr = *rc::gen::inRange(10, 91);
    const double kr1 = *rc::gen::inRange(2, 81);
    const double next = feed + 0.005;
    RC_ASSERT(turning_ra({surface(next, radius, kr, kr1)}).ra_um >
              turning_ra({surface(feed, radius, kr, kr1)}).ra_um);
    const auto low = ra_scatter({surface(feed, radius, kr, kr1)});
    const auto high = ra_scatter({surface(next, radius, kr, kr1)});
    const double z = 3.0902;  // gamma 0.999
    RC_ASSERT(high.ra_um + z * high.sigma_um > low.ra_um + z * low.sigma_um);
    RC_ASSERT(turning_ra({surface(next, 2, 45, 45), FactorPolicy::printed}).ra_um >
              turning_ra({surface(feed, 2, 45, 45), FactorPolicy::printed}).ra_um);
  });
}

TEST_CASE("K411: feeds for a limit of Ra", "[K411]") {
  RaLimit limit;
  limit.ra_max_um = 3.2;
  CHECK(max_feed_for_ra(limit).feed_mm_rev == Approx(0.3456).margin(5e-5));
  limit.ra_max_um = 2.5;
  limit.nose_radius_mm = 0.8;
  limit.kr_deg = 80;
  limit.kr1_deg = 15;
  const double feed = max_feed_for_ra(limit).feed_mm_rev;
  CHECK(feed == Approx(0.1760).margin(5e-5));
  CHECK(turning_ra({surface(feed, 0.8, 80, 15)}).ra_um == Approx(2.5).epsilon(1e-12));

  RaReliability reliable;
  reliable.ra_limit_um = 3.2;
  reliable.gamma = 0.95;
  const double safe = max_feed_for_ra_reliability(reliable).feed_mm_rev;
  CHECK(safe == Approx(0.3270).margin(5e-5));
  CHECK(ra_exceed_probability({surface(safe, 2, 45, 45), 3.2}).probability == Approx(0.05).epsilon(1e-9));
  reliable.gamma = 0.5;
  limit = {};
  limit.ra_max_um = 3.2;
  const double even = max_feed_for_ra(limit).feed_mm_rev;
  CHECK(max_feed_for_ra_reliability(reliable).feed_mm_rev == Approx(even).epsilon(1e-12));
  CHECK(ra_exceed_probability({surface(even, 2, 45, 45), 3.2}).probability == Approx(0.5).margin(1e-9));
}

TEST_CASE("K411: regular polygons, half-width, infeasible pass", "[K411]") {
  CHECK(insert_angles({4, 75}).kr1_deg == Approx(15));
  CHECK(insert_angles({3, 60}).corner_deg == Approx(60));
  CHECK(insert_angles({5, 60}).corner_deg == Approx(108));
  CHECK(insert_angles({6, 45}).corner_deg == Approx(120));
  CHECK(ra_confidence_half_width({0.007128, 2, 192, 0.95}).half_width_um == Approx(0.1178).margin(5e-5));
  FinishPass pass;
  pass.ra_limit_um = 0.1;
  pass.cutting_speed_m_min = 120;
  pass.diameter_mm = 35;
  pass.length_mm = 200;
  const auto none = finish_pass_time(pass);
  CHECK(none.status == FeedStatus::infeasible);
  CHECK(none.feed_mm_rev == 0);
  CHECK(none.main_time_min == 1e9);
}

TEST_CASE("K411: handbook feeds of one class leave about one height", "[K411]") {
  // s^2/8r along the rows is constant within 10 %, except at the smallest radii where the table is rounded.
  for (auto rough : {RoughnessClass::ra_1_25, RoughnessClass::rz_20}) {
    const double feed = handbook_finish_feed({rough, 2.0}).feed_mm_rev;
    const double other = handbook_finish_feed({rough, 1.2}).feed_mm_rev;
    CHECK(feed * feed / 2.0 == Approx(other * other / 1.2).epsilon(0.1));
  }
  CHECK(handbook_finish_feed({RoughnessClass::rz_80, 0.1}).feed_mm_rev == Approx(0.47));
  CHECK(handbook_finish_feed({RoughnessClass::rz_80, 2.4}).feed_mm_rev == Approx(1.14));
}

TEST_CASE("K411: bad input names itself", "[K411]") {
  CHECK_THROWS_WITH(insert_angles({8, 60}),
                    "K411.insert_angles: kr_deg = 60, must be below 360/n_faces, or the insert has no minor "
                    "edge angle left");
  RaLimit limit;
  limit.ra_max_um = 3.2;
  limit.feed_min_mm_rev = 0.6;
  CHECK_THROWS_WITH(max_feed_for_ra(limit),
                    "K411.max_feed_for_ra: feed_min = 0.6, must not be above feed_max");
}
