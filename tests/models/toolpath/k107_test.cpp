// The checks of card K107; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/toolpath/k107_round_insert_notch_clashes.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k107;

namespace {

double real(int low, int high, double scale) {
  return *rc::gen::inRange(low, high) * scale;
}

}  // namespace

TEST_CASE("K107: forbidden feed and depth undo the notch angles", "[K107]") {
  verstat::test::property([] {
    const double r = real(20, 160, 0.1);
    const double s = r * real(1, 1999, 0.001);
    const double t = r * real(1, 1001, 0.001);
    const NotchAngles angles = notch_angles({r, s, t});
    RC_ASSERT(std::abs(forbidden_feed({r, angles.trail_deg}).feed_mm_rev - s) < 1e-12 * r);
    RC_ASSERT(std::abs(forbidden_depth({r, angles.lead_deg}).depth_mm - t) < 1e-12 * r);
  });
}

TEST_CASE("K107: the notch angles are where circles and lines meet", "[K107]") {
  // Two positions of the circle shifted by the feed meet at half the feed; the uncut surface is t above the
  // tip.
  const NotchAngles a = notch_angles({3.5, 0.3, 0.2});
  CHECK(3.5 * std::sin(a.trail_deg * std::numbers::pi / 180) == Approx(0.15));
  CHECK(3.5 * (1 - std::cos(a.lead_deg * std::numbers::pi / 180)) == Approx(0.2));
  CHECK(a.trail_deg == Approx(2.4563).margin(5e-5));
  CHECK(a.lead_deg == Approx(19.4630).margin(5e-5));
}

TEST_CASE("K107: forbidden values rise with the slope, scale with the radius, and have their limits",
          "[K107]") {
  double feed = 0;
  double depth = 0;
  for (double slope = 0.5; slope <= 90; slope += 0.5) {
    CHECK(forbidden_feed({3.5, slope}).feed_mm_rev > feed);
    CHECK(forbidden_depth({3.5, slope}).depth_mm > depth);
    feed = forbidden_feed({3.5, slope}).feed_mm_rev;
    depth = forbidden_depth({3.5, slope}).depth_mm;
    CHECK(forbidden_feed({7, slope}).feed_mm_rev == Approx(2 * feed));
    CHECK(forbidden_depth({7, slope}).depth_mm == Approx(2 * depth));
  }
  CHECK(forbidden_feed({3.5, 0}).feed_mm_rev == 0);
  CHECK(forbidden_depth({3.5, 0}).depth_mm == 0);
  CHECK(forbidden_feed({3.5, 90}).feed_mm_rev == 7);
  CHECK(forbidden_depth({3.5, 90}).depth_mm == 3.5);
}

TEST_CASE("K107: an interval holds its forbidden value and collapses without a guard", "[K107]") {
  verstat::test::property([] {
    const double slope = real(1, 90, 1);
    const double w = real(1, 100, 0.001);
    const FeedInterval s = forbidden_feed_interval({{3.5, slope}, w});
    const double feed = forbidden_feed({3.5, slope}).feed_mm_rev;
    RC_ASSERT(s.low_mm_rev < feed);
    RC_ASSERT(feed < s.high_mm_rev);
    const DepthInterval t = forbidden_depth_interval({{3.5, slope}, w});
    const double depth = forbidden_depth({3.5, slope}).depth_mm;
    RC_ASSERT(t.low_mm < depth);
    RC_ASSERT(depth < t.high_mm);
    RC_ASSERT(forbidden_feed_interval({{3.5, slope}, 0}).low_mm_rev == feed);
    RC_ASSERT(forbidden_depth_interval({{3.5, slope}, 0}).high_mm == depth);
  });
}

TEST_CASE("K107: the allowed feed is the largest one outside every interval", "[K107]") {
  verstat::test::property([] {
    WantedFeed in{real(0, 300, 0.01), 3.5, {}, real(0, 200, 0.001)};
    const int n = *rc::gen::inRange(0, 8);
    for (int k = 0; k < n; ++k) in.slopes_deg.push_back(real(1, 300, 0.1));
    const double s = allowed_feed(in).feed_mm_rev;
    RC_ASSERT(s >= 0);
    RC_ASSERT(s <= in.feed_mm_rev);
    const auto forbidden = [&](double x) {
      for (const double slope : in.slopes_deg) {
        const FeedInterval i = forbidden_feed_interval({{3.5, slope}, in.half_width_mm});
        if (i.low_mm_rev < x && x < i.high_mm_rev) return true;
      }
      return false;
    };
    RC_ASSERT(s == 0 || !forbidden(s));
    // Brute force: nothing above it up to the wanted feed is free.
    for (int k = 1; k <= 200; ++k) {
      const double x = s + (in.feed_mm_rev - s) * k / 200;
      RC_ASSERT(x <= s || forbidden(x));
    }
  });
}

TEST_CASE("K107: the example profile clashes where the card says", "[K107]") {
  const ProfileClashes found = profile_clashes({{0, -2.5, 0, 20, 0}, 3.5, 0.3, 0.2, 0.05, false});
  CHECK(found.clashes ==
        std::vector<Clash>{{0, 1, NotchZone::trail}, {0, 3, NotchZone::lead}, {2, 3, NotchZone::lead}});
  CHECK(found.margin_deg == Approx(-0.775).margin(0.0005));
  CHECK(profile_clashes({{0, -30, 0, 30, 0}, 3.5, 0.3, 0.2, 0.05, false}).clashes.empty());
  // Return from a descending flank to the groove bottom: theta_lead = omega_in.
  const double lead = notch_angles({3.5, 0.3, 0.2}).lead_deg;
  CHECK(profile_clashes({{-lead, 0}, 3.5, 0.3, 0.2, 0.05, false}).clashes ==
        std::vector<Clash>{{0, 1, NotchZone::lead}});
}

TEST_CASE("K107: an edge that has cut whole parts is marked by later segments too", "[K107]") {
  const Profile once{{20, 0}, 3.5, 0.3, 0.2, 0.05, false};
  CHECK(profile_clashes(once).clashes.empty());
  Profile always = once;
  always.persistent = true;
  const ProfileClashes found = profile_clashes(always);
  CHECK(found.clashes == std::vector<Clash>{{1, 0, NotchZone::lead}});
  CHECK(found.margin_deg < profile_clashes(once).margin_deg);
}

TEST_CASE("K107: the end of a forbidden interval used as feed or depth passes with margin 0", "[K107]") {
  verstat::test::property([] {
    const double slope = real(10, 300, 0.1);
    const FeedInterval s = forbidden_feed_interval({{3.5, slope}, 0.05});
    for (const double feed : {s.low_mm_rev, s.high_mm_rev}) {
      if (feed < 0.05) continue;
      const ProfileClashes found = profile_clashes({{0, -slope}, 3.5, feed, 3.0, 0.05, false});
      RC_ASSERT(found.clashes.empty());
      RC_ASSERT(std::abs(found.margin_deg) < 1e-9);
    }
    const DepthInterval t = forbidden_depth_interval({{3.5, slope}, 0.05});
    const ProfileClashes found = profile_clashes({{0, slope}, 3.5, 6.9, t.high_mm, 0.05, false});
    RC_ASSERT(found.clashes.empty());
    RC_ASSERT(std::abs(found.margin_deg) < 1e-9);
  });
}

TEST_CASE("K107: ridge height and edge length", "[K107]") {
  CHECK(scallop_height({3.5, 0.3}).height_um == Approx(3.216).margin(0.0005));
  CHECK(scallop_height({3.5, 0.3}).height_um == Approx(125 * 0.09 / 3.5).epsilon(1e-3));
  CHECK(active_edge_length({4, 7.9999999, 4}).length_mm == Approx(4 * std::numbers::pi).epsilon(1e-3));
  CHECK(concave_radius_ok({3.5, 3.5}).ok == false);
  CHECK(concave_radius_ok({3.5, 3.6}).ok);
}

TEST_CASE("K107: bad input names itself", "[K107]") {
  CHECK_THROWS_WITH(notch_angles({3.5, 7, 1}), "K107.notch_angles: s = 7, must be below 2 r");
  CHECK_THROWS_WITH(notch_angles({3.5, 1, 3.6}), "K107.notch_angles: t = 3.6, must not be above r");
  CHECK_THROWS_WITH(allowed_feed({0.3, 3.5, {0.0}, 0.05}), Catch::Contains("omegas_in/0 = 0"));
  CHECK_THROWS_WITH(profile_clashes({{0, 95}, 3.5, 0.3, 0.2}), Catch::Contains("slopes/1 = 95"));
}
