#include "operations/kinds/ball_end_milling.h"

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/k401_ball_end_hardened_steel_forces.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::margin_of;
using verstat::test::value_of;

TEST_CASE("ball-end milling: a feed that follows the force along the surface saves time",
          "[ball_end_milling]") {
  const auto gallery = test::Gallery("ball_end_milling");
  BallEndMilling spec = gallery.spec<BallEndMilling>();
  const CutPlan patchwise = plan(spec, gallery.context());
  spec.feed = BallFeed::constant;
  const CutPlan constant = plan(spec, gallery.context());
  spec.feed = BallFeed::given;
  const CutPlan given = plan(spec, gallery.context());

  CHECK(margin_of(given, "normal_force_n") < 0);
  CHECK(patchwise.feasible());
  CHECK(constant.feasible());
  CHECK(patchwise.main_time_min < 0.8 * constant.main_time_min);
  CHECK(patchwise.main_time_min > given.main_time_min);
  // Both obey the wall, where the limit binds.
  CHECK(value_of(patchwise, "feed_low_mm") == value_of(constant, "feed_low_mm"));
  CHECK(margin_of(patchwise, "normal_force_n") == Approx(0).margin(1e-6));
  CHECK(value_of(patchwise, "feed_high_mm") > value_of(patchwise, "feed_low_mm"));
  CHECK(patchwise.edge.has_value());
}

TEST_CASE("ball-end milling: forces are those of K401, bending shows on slopes only", "[ball_end_milling]") {
  const auto gallery = test::Gallery("ball_end_milling");
  BallEndMilling spec = gallery.spec<BallEndMilling>();
  spec.feed = BallFeed::given;
  spec.feed_per_tooth_mm = 0.08;
  spec.patches = {{10, 0, 0.21}};
  const CutPlan level = plan(spec, gallery.context());
  CHECK(value_of(level, "feed_force_n") == Approx(14.74).margin(0.005));
  CHECK(value_of(level, "axial_force_n") == Approx(28.74).margin(0.005));
  CHECK(value_of(level, "normal_force_n") == Approx(33.93).margin(0.005));
  CHECK(value_of(level, "form_error_um") == 0);
  CHECK(level.main_time_min == Approx(10 / (0.45 * 20'018 * 2 * 0.08 / 100)));
  const double tip = models::k401::tool_deflection({std::hypot(14.74, 33.93), 6, 24, 600'000}).deflection_um;
  CHECK(value_of(level, "deflection_um") == Approx(tip).epsilon(1e-3));

  spec.patches = {{10, 90, 0.21}};
  const CutPlan wall = plan(spec, gallery.context());
  // On a wall the push-off bends the mill straight out of it.
  const double push = models::k401::tool_deflection({28.74, 6, 24, 600'000}).deflection_um;
  CHECK(value_of(wall, "form_error_um") == Approx(push).epsilon(1e-3));
  CHECK(value_of(wall, "cutting_speed_m_min") > value_of(level, "cutting_speed_m_min"));
}

TEST_CASE("ball-end milling: the energy model agrees with the regressions at the centre of their plan",
          "[ball_end_milling]") {
  const auto gallery = test::Gallery("ball_end_milling");
  BallEndMilling spec = gallery.spec<BallEndMilling>();
  spec.feed = BallFeed::given;
  spec.feed_per_tooth_mm = 0.08;
  spec.patches = {{10, 0, 0.21}};
  spec.force_model = BallForceModel::energy;
  const CutPlan energy = plan(spec, gallery.context());
  const double resultant =
      std::hypot(value_of(energy, "in_plane_force_n"), value_of(energy, "axial_force_n"));
  CHECK(resultant == Approx(46.8).epsilon(0.25));  // K406 gives 44.6 N at one angle; these are maxima apart
  spec.stress_scale = 2;
  CHECK(value_of(plan(spec, gallery.context()), "feed_force_n") ==
        Approx(2 * value_of(energy, "feed_force_n")).epsilon(1e-9));
  spec.feed = BallFeed::patchwise;
  CHECK(test::refusal(spec).find("feed = \"patchwise\", the energy model takes the feed as given") == 0);
}

TEST_CASE("ball-end milling: patchwise is never slower than constant and keeps the limits when any feed does",
          "[ball_end_milling]") {
  const auto gallery = test::Gallery("ball_end_milling");
  test::property([&] {
    BallEndMilling spec = gallery.spec<BallEndMilling>();
    spec.hardness_hrc = *rc::gen::inRange(40, 56);
    spec.normal_force_max_n = *rc::gen::inRange(20, 90);
    for (SurfacePatch& patch : spec.patches) {
      patch.depth_mm = *rc::gen::inRange(6, 37) * 0.01;
      patch.inclination_deg = *rc::gen::inRange(0, 91);
    }
    const CutPlan patchwise = plan(spec, gallery.context());
    bool any_feed_keeps = true;
    for (const SurfacePatch& patch : spec.patches) {
      models::k401::LimitedCut cut;
      static_cast<models::k401::CutWidth&>(cut) = {spec.spindle_speed_rpm, patch.depth_mm, spec.step_over_mm,
                                                   spec.relief_deg, spec.hardness_hrc};
      cut.px_max_n = *spec.feed_force_max_n;
      cut.py_max_n = *spec.axial_force_max_n;
      cut.pz_max_n = *spec.normal_force_max_n;
      any_feed_keeps = any_feed_keeps && models::k401::max_feed_for_force_limits(cut).feasible;
    }
    RC_CLASSIFY(any_feed_keeps);
    for (const char* force : {"feed_force_n", "axial_force_n", "normal_force_n"})
      RC_ASSERT(!any_feed_keeps || margin_of(patchwise, force) >= 0);
    RC_ASSERT(any_feed_keeps || !patchwise.feasible());
    spec.feed = BallFeed::constant;
    RC_ASSERT(patchwise.main_time_min <= plan(spec, gallery.context()).main_time_min * (1 + 1e-12));
    RC_ASSERT(*patchwise.value_of("form_error_um") <= *patchwise.value_of("deflection_um") * (1 + 1e-12));
  });
}

TEST_CASE("ball-end milling: errors name what is wrong", "[ball_end_milling]") {
  BallEndMilling spec = test::Gallery("ball_end_milling").spec<BallEndMilling>();
  spec.feed_force_max_n.reset();
  CHECK(test::refusal(spec) ==
        "a feed limited by force needs feed_force_max_n, axial_force_max_n and normal_force_max_n");
  spec.spindle_speed_rpm = 5000;
  CHECK(test::refusal(spec).find("spindle_speed_rpm = 5000, outside the regime") == 0);
}
