#include "operations/kinds/lathe_milling.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using models::k301::FeedStrategy;
using verstat::test::GalleryExample;
using verstat::test::margin_of;
using verstat::test::refusal;
using verstat::test::value_of;

TEST_CASE("lathe milling: the force-stabilised feed saves time at equal peak force", "[lathe_milling]") {
  const auto gallery = test::Gallery("lathe_milling");
  LatheMilling spec = gallery.spec<LatheMilling>();
  const CutPlan stabilised = plan(spec, gallery.context());
  spec.feed = FeedStrategy::constant;
  const CutPlan constant = plan(spec, gallery.context());
  CHECK(stabilised.main_time_min == Approx(1.4003347788).epsilon(0.01));
  CHECK(constant.main_time_min == Approx(2.3097705181).epsilon(0.01));
  CHECK(value_of(stabilised, "peak_force_n") == Approx(900));
  CHECK(value_of(constant, "peak_force_n") == Approx(900));
  CHECK(value_of(stabilised, "feed_high_mm_min") == Approx(600));
  CHECK(stabilised.feasible());
  CHECK(constant.feasible());
}

TEST_CASE("lathe milling: short blocks hold the feed down", "[lathe_milling]") {
  const auto gallery = test::Gallery("lathe_milling_flat");
  LatheMilling spec = gallery.spec<LatheMilling>();
  const CutPlan held = plan(spec, gallery.context());
  CHECK(value_of(held, "block_feed_limit_mm_min") == Approx(300));  // published: 0.3 m/min
  CHECK(value_of(held, "feed_high_mm_min") == Approx(300));
  spec.block_length_mm = 0.02;
  const CutPlan free = plan(spec, gallery.context());
  CHECK(value_of(free, "feed_high_mm_min") == Approx(500));
  CHECK(held.main_time_min / free.main_time_min == Approx(5.0 / 3));

  // A tolerance instead of a length: the sagitta of the block about the part axis.
  spec.block_length_mm.reset();
  spec.chord_tolerance_mm = 1e-6;
  const double length = value_of(plan(spec, gallery.context()), "block_length_mm");
  CHECK(23 - std::sqrt(23.0 * 23 - length * length / 4) == Approx(1e-6).epsilon(1e-6));
}

TEST_CASE("lathe milling: a flat's path, force and speeds", "[lathe_milling]") {
  const auto gallery = test::Gallery("lathe_milling_flat");
  LatheMilling spec = gallery.spec<LatheMilling>();
  spec.approach_mm = 0;
  const CutPlan p = plan(spec, gallery.context());
  double path_mm = 0;
  for (int layer = 1; layer <= 5; ++layer)
    path_mm += 2 * std::sqrt(24.0 * 24 - std::pow(16 - 0.2 * layer + 8, 2));
  CHECK(p.main_time_min == Approx(path_mm / 300));
  CHECK(value_of(p, "entry_speed_m_min") == Approx(150.8).margin(0.5));  // 2 pi 3000 rpm 8 mm
  CHECK(value_of(p, "peak_force_n") < 600);
  // With a small force limit the force law decides the feed, and meets the limit.
  spec.force_limit_n = 0.5 * value_of(p, "peak_force_n");
  const CutPlan gentle = plan(spec, gallery.context());
  CHECK(value_of(gentle, "peak_force_n") == Approx(spec.force_limit_n));
  CHECK(gentle.feasible());
  CHECK(gentle.main_time_min == Approx(p.main_time_min * std::pow(2, 1 / 0.75)));
  // The smallest feed goes before the force: the plan says so.
  spec.feed_min_mm_min = 250;
  CHECK(margin_of(plan(spec, gallery.context()), "peak_force_n") < 0);
}

TEST_CASE("lathe milling: stabilised is never slower than constant", "[lathe_milling]") {
  const auto gallery = test::Gallery("lathe_milling");
  test::property([&] {
    LatheMilling spec = gallery.spec<LatheMilling>();
    spec.faces = *rc::gen::inRange(3, 9);
    spec.blank_diameter_mm = 2 * spec.apothem_mm * (*rc::gen::inRange(102, 130) * 0.01);
    spec.force_limit_n = *rc::gen::inRange(200, 2000);
    const CutPlan stabilised = plan(spec, {});
    spec.feed = FeedStrategy::constant;
    const CutPlan constant = plan(spec, {});
    RC_ASSERT(stabilised.main_time_min <= constant.main_time_min * (1 + 1e-9));
  });
}

TEST_CASE("lathe milling: errors name what is wrong", "[lathe_milling]") {
  LatheMilling spec = test::Gallery("lathe_milling").spec<LatheMilling>();
  spec.chord_tolerance_mm.reset();
  CHECK(test::refusal(spec) ==
        "the feed limit of the control needs block_time_ms and one of block_length_mm, chord_tolerance_mm");
  spec.block_time_ms.reset();
  spec.faces = 2;
  CHECK(test::refusal(spec) == "faces = 2, a polygon has 3 faces or more");
  spec.shape = LatheShape::flats;
  CHECK(test::refusal(spec) == "feed = \"stabilized\" belongs to shape \"polygon\"");
  spec.apothem_mm = 25;
  CHECK(test::refusal(spec) == "apothem_mm = 25, must be below the blank radius: otherwise nothing is cut");
}

TEST_CASE("lathe milling: passes without end are refused, not counted", "[lathe_milling]") {
  GalleryExample<LatheMilling> example;
  for (const double depth_mm : {1e-300, 1e-6}) {
    example.spec.axial_depth_mm = depth_mm;
    CHECK_THAT(refusal(example.spec), Catch::Matchers::Contains("axial_depth_mm"));
  }
}
