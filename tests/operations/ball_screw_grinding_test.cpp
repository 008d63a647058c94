// Ball-screw grinding: passes and tilts of the narrow wheel, form errors, dressing against a copying wheel.

#include "operations/kinds/ball_screw_grinding.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

namespace verstat::operations {
namespace {

using test::limit_of;

BallScrewGrinding narrow() {
  return test::Gallery("ball_screw_grinding").spec<BallScrewGrinding>();
}
BallScrewGrinding copying() {
  return test::Gallery("ball_screw_copying").spec<BallScrewGrinding>();
}

TEST_CASE("ball screw grinding: the examples are feasible and survive JSON") {
  for (const char* name : {"ball_screw_grinding", "ball_screw_copying"}) {
    const MachineLimits machine = test::Gallery(name).file.machine_limits;
    PlanContext context;
    context.machine = &machine;
    CHECK(plan(test::Gallery(name).spec<BallScrewGrinding>(), context).feasible());
  }
}

TEST_CASE("ball screw grinding: passes, tilt and time are those of K203") {
  const BallScrewGrinding s = narrow();
  const CutPlan p = plan(s, {});
  const auto schedule = models::k203::pass_schedule({.groove_center_radius_mm = 20,
                                                     .final_profile_radius_mm = 3.1,
                                                     .stock_mm = 0.2,
                                                     .infeed_mm = 0.05,
                                                     .lead_mm = 10,
                                                     .wheel_outer_radius_mm = 150,
                                                     .wheel_profile_radius_mm = 2.7,
                                                     .internal = 0});
  CHECK(*p.value_of("passes") == 5);  // four of 0.05 mm and one spark-out
  REQUIRE(schedule.tilt_deg.size() == 4);
  CHECK(*p.value_of("first_tilt_deg") == schedule.tilt_deg.front());
  CHECK(*p.value_of("tilt_deg") == schedule.tilt_deg.back());
  for (std::size_t k = 1; k < schedule.tilt_deg.size(); ++k)
    CHECK(schedule.tilt_deg[k] > schedule.tilt_deg[k - 1]);  // tilted more at every pass
  // 320 mm at 200 mm/min, return three times as fast, 0.2 min of setting.
  CHECK(p.main_time_min == Approx(5 * (1.6 * (1 + 1 / 3.0) + 0.2)));
}

TEST_CASE("ball screw grinding: form error vanishes in the last pass of an exact wheel only") {
  BallScrewGrinding s = narrow();
  const CutPlan exact = plan(s, {});
  CHECK(*exact.value_of("form_error_um") < 1e-3);
  CHECK(*exact.value_of("form_error_before_last_um") > 0.05);
  s.wheel_arc = WheelArc::toroidal;
  const CutPlan torus = plan(s, {});
  CHECK(*torus.value_of("form_error_um") > *exact.value_of("form_error_um"));
  s.form_error_max_um = *torus.value_of("form_error_um") * 0.99;
  CHECK_FALSE(limit_of(plan(s, {}), "form_error_um").met());
  s.form_error_max_um = *torus.value_of("form_error_um") * 1.01;
  CHECK(limit_of(plan(s, {}), "form_error_um").met());
}

TEST_CASE("ball screw grinding: a copying wheel is dressed deeper and loses more abrasive") {
  const CutPlan n = plan(narrow(), {});
  const CutPlan c = plan(copying(), {});
  CHECK(*c.value_of("first_tilt_deg") == *c.value_of("tilt_deg"));
  CHECK(*c.value_of("dressing_depth_mm") > *n.value_of("dressing_depth_mm"));
  const double per_dressing_narrow = n.consumables.at(0).value / *n.value_of("dressings_per_part");
  const double per_dressing_copying = c.consumables.at(0).value / *c.value_of("dressings_per_part");
  CHECK(per_dressing_copying > per_dressing_narrow);
  // The flanks get their depth only after 0.2 / cos 40 deg: six passes and one spark-out instead of four.
  CHECK(*c.value_of("infeed_path_mm") == Approx(0.261081));
  CHECK(*c.value_of("passes") == 7);
  CHECK(c.main_time_min / n.main_time_min == Approx(7.0 / 5));
  CHECK(*c.value_of("removed_volume_mm3") > *n.value_of("removed_volume_mm3"));
}

TEST_CASE("ball screw grinding: dressing life and time with dressing") {
  const BallScrewGrinding s = narrow();
  const CutPlan p = plan(s, {});
  REQUIRE(p.more_elements.size() == 1);
  CHECK(p.more_elements[0].mean_min * *p.value_of("dressings_per_part") == Approx(p.main_time_min));
  CHECK(*p.value_of("time_with_dressing_min") ==
        Approx(p.main_time_min + 3 * *p.value_of("dressings_per_part")));
}

TEST_CASE("ball screw grinding: a nut is ground from inside") {
  BallScrewGrinding s = narrow();
  s.part = ThreadPart::nut;
  s.wheel_outer_radius_mm = 15;
  const CutPlan p = plan(s, {});
  CHECK(*p.value_of("center_distance_mm") == Approx(20 + 3.1 - 15));
  CHECK(*p.value_of("form_error_um") < 1e-3);
}

TEST_CASE("ball screw grinding: bad specifications name the place") {
  BallScrewGrinding s = narrow();
  s.wheel_width_mm = 6;
  CHECK(test::refusal(s) == "wheel_width_mm = 6, must not be above twice wheel_profile_radius_mm");
  s = narrow();
  s.wheel_profile_radius_mm = 3.5;
  CHECK(test::refusal(s).find("K203.pass_schedule: final_profile_radius_mm") != std::string::npos);
  s = copying();
  s.wheel_width_mm = 3;
  CHECK(test::refusal(s).find("must cover the groove") != std::string::npos);
  nlohmann::json json = test::Gallery("ball_screw_grinding").json.at("process");
  json["method"] = "wide";
  CHECK(test::refusal(json).find("\"narrow\", \"copying\"") != std::string::npos);
}

TEST_CASE("ball screw grinding: finer infeed never takes fewer passes") {
  test::property("infeed", [] {
    BallScrewGrinding s = narrow();
    s.infeed_mm = 0.001 * *rc::gen::inRange(10, 100);
    const CutPlan coarse = plan(s, {});
    s.infeed_mm /= 2;
    const CutPlan fine = plan(s, {});
    RC_ASSERT(*fine.value_of("passes") >= *coarse.value_of("passes"));
    RC_ASSERT(std::abs(*fine.value_of("tilt_deg") - *coarse.value_of("tilt_deg")) < 1e-6);
    RC_ASSERT(*fine.value_of("removal_rate_mm3_min") < *coarse.value_of("removal_rate_mm3_min"));
  });
}

}  // namespace
}  // namespace verstat::operations
