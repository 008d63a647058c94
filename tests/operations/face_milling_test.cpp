#include "operations/kinds/face_milling.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/reliability/k109_face_mill_replacement.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::margin_of;
using verstat::test::value_of;

namespace k109 = models::k109;

namespace {

// The mission that a tooth survives with 0.9, K109's worked example with z = 10, cut as one part.
FaceMilling mission_of_worked_example(const test::Gallery& gallery) {
  FaceMilling spec = gallery.spec<FaceMilling>();
  spec.parts_per_mission = 1;
  const CutPlan before = plan(spec, gallery.context());
  k109::ToothMission mission;
  mission.t_mean_min = value_of(before, "tooth_life_min");
  mission.beta = models::weibull_shape(gallery.file.edge_life->cv);
  mission.r_tooth = 0.9;
  const double minutes = k109::mission_time(mission).t_min;
  spec.length_mm += (minutes - before.main_time_min) * value_of(before, "table_feed_mm_min");
  return spec;
}

}  // namespace

TEST_CASE("face milling: the mill pulled at m failed teeth has K109's reliability", "[face_milling]") {
  const auto gallery = test::Gallery("face_milling");
  FaceMilling spec = mission_of_worked_example(gallery);
  spec.reliability_min = 0.95;
  const CutPlan global = plan(spec, gallery.context());
  CHECK(value_of(global, "mission_min") == Approx(16.1).margin(0.05));
  CHECK(value_of(global, "tooth_reliability") == Approx(0.9).epsilon(1e-9));
  CHECK(value_of(global, "mill_reliability") == Approx(0.961946).margin(1e-6));
  CHECK(value_of(global, "required_replace_at") == 4);
  CHECK(global.feasible());

  spec.sharing = LoadSharing::local;
  const CutPlan local = plan(spec, gallery.context());
  CHECK(value_of(local, "mill_reliability") == Approx(0.944687).margin(1e-6));
  CHECK(margin_of(local, "mill_reliability") < 0);
  CHECK(value_of(local, "thickest_chip_per_tooth_mm") == Approx(4 * 0.18));

  spec.sharing = LoadSharing::global;
  spec.load_exponent = 0;
  CHECK(value_of(plan(spec, gallery.context()), "mill_reliability") == Approx(0.987205).margin(1e-6));
}

TEST_CASE("face milling: edge life is K109's mean time to the m-th failure", "[face_milling]") {
  const auto gallery = test::Gallery("face_milling");
  FaceMilling spec = gallery.spec<FaceMilling>();
  const double card_min[] = {13.91, 20.01, 23.96, 26.74, 28.76, 30.20, 31.21, 31.87, 32.25, 32.40};
  double cv = 1;
  for (std::int64_t m = 1; m <= 10; ++m) {
    spec.replace_at_failed_teeth = m;
    const CutPlan p = plan(spec, gallery.context());
    REQUIRE(p.edge);
    CHECK(p.edge->mean_min == Approx(card_min[m - 1]).margin(0.006));
    CHECK(p.edge->cv < cv);  // later failures scatter less
    cv = p.edge->cv;
  }
  spec.replace_at_failed_teeth = 1;
  // The first of ten failures: the Weibull law of a tooth on a shorter scale.
  CHECK(plan(spec, gallery.context()).edge->cv == Approx(gallery.file.edge_life->cv).epsilon(1e-9));
}

TEST_CASE("face milling: a feed reduced with the working teeth costs time and saves teeth",
          "[face_milling]") {
  const auto gallery = test::Gallery("face_milling");
  FaceMilling spec = gallery.spec<FaceMilling>();
  const CutPlan kept = plan(spec, gallery.context());
  spec.feed_after_failure = FeedAfterFailure::reduce;
  const CutPlan reduced = plan(spec, gallery.context());
  CHECK(reduced.main_time_min > kept.main_time_min);
  CHECK(value_of(reduced, "slowdown") < 10.0 / 7);  // the slowest state before the change
  CHECK(reduced.edge->mean_min > kept.edge->mean_min);
  CHECK(value_of(reduced, "thickest_chip_per_tooth_mm") == spec.feed_per_tooth_mm);
  CHECK(kept.main_time_min == Approx((800 + 25) / value_of(kept, "table_feed_mm_min")));
}

TEST_CASE("face milling: local sharing is never the safer one, later replacement never the shorter life",
          "[face_milling]") {
  const auto gallery = test::Gallery("face_milling");
  test::property([&] {
    FaceMilling spec = gallery.spec<FaceMilling>();
    spec.teeth = *rc::gen::inRange(2, 13);
    spec.replace_at_failed_teeth = *rc::gen::inRange(1, static_cast<int>(spec.teeth));
    spec.parts_per_mission = *rc::gen::inRange(1, 40);
    spec.load_exponent = *rc::gen::inRange(10, 30) * 0.1;
    const CutPlan global = plan(spec, gallery.context());
    spec.sharing = LoadSharing::local;
    const CutPlan local = plan(spec, gallery.context());
    RC_ASSERT(*local.value_of("mill_reliability") <= *global.value_of("mill_reliability") + 1e-12);
    RC_ASSERT(global.edge->cv > 0 && global.edge->cv < 1);
    spec.sharing = LoadSharing::global;
    spec.replace_at_failed_teeth += 1;
    const CutPlan later = plan(spec, gallery.context());
    RC_ASSERT(later.edge->mean_min > global.edge->mean_min);
    RC_ASSERT(*later.value_of("mill_reliability") >= *global.value_of("mill_reliability") - 1e-12);
  });
}

TEST_CASE("face milling: limits and errors name what is wrong", "[face_milling]") {
  const auto gallery = test::Gallery("face_milling");
  FaceMilling spec = gallery.spec<FaceMilling>();
  const CutPlan p = plan(spec, gallery.context());
  CHECK(margin_of(p, "power_kw") > 0);
  CHECK(value_of(p, "cutting_power_kw") == Approx(1700 * std::pow(0.18 * 0.8 / std::asin(0.8), -0.25) *
                                                  value_of(p, "removal_rate_cm3_min") / 6e4));
  spec.depth_of_cut_mm = 12;
  CHECK(margin_of(plan(spec, gallery.context()), "power_kw") < 0);
  spec.replace_at_failed_teeth = 11;
  CHECK(test::refusal(spec) == "replace_at_failed_teeth = 11, must not exceed the number of teeth");
  spec.replace_at_failed_teeth = 1;
  spec.width_mm = 126;
  CHECK(test::refusal(spec) == "width_mm = 126, must not exceed the diameter of the mill");
}
