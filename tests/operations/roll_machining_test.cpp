#include "operations/kinds/roll_machining.h"

#include <cmath>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::limit_of;
using verstat::test::refusal;
using verstat::test::value_of;

namespace {

RollMachining example() {
  return test::Gallery("roll_machining").spec<RollMachining>();
}

double part(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) * 1e-3;
}

}  // namespace

TEST_CASE("roll machining: the worked example of K412") {
  const test::Gallery gallery("roll_machining");
  const CutPlan p = gallery.file.process.plan(gallery.context());
  CHECK(p.feasible());
  CHECK(value_of(p, "contour_length_mm") == Approx(286.53).margin(5e-3));
  CHECK(value_of(p, "max_diameter_mm") == Approx(233.30).margin(5e-3));
  CHECK(value_of(p, "cylinder_passes") == 5);
  CHECK(value_of(p, "cylinder_depth_mm") == Approx(2.953).margin(5e-4));
  CHECK(value_of(p, "contour_passes") == 6);
  CHECK(value_of(p, "contour_depth_mm") == Approx(2.773).margin(5e-4));
  CHECK(value_of(p, "rough_cut_length_mm") == Approx(2635.8).margin(0.05));
  CHECK(value_of(p, "rough_time_min") == Approx(54.79).margin(5e-3));
  CHECK(value_of(p, "rough_rapid_min") == Approx(0.63).margin(5e-3));
  CHECK(value_of(p, "removed_cm3") == Approx(5070).margin(0.5));
  CHECK(value_of(p, "finish_time_min") == Approx(6.90).margin(5e-3));
  CHECK(value_of(p, "facing_time_min") == Approx(2 * 4.35).margin(1e-2));
  CHECK(value_of(p, "dressing_radius_max_mm") == Approx(239.2).margin(0.05));
  CHECK(value_of(p, "throat_curvature_radius_mm") == Approx(420));  // 130 cot^2 30 + 30
  CHECK(p.main_time_min == Approx(value_of(p, "rough_time_min") + value_of(p, "finish_time_min") +
                                  value_of(p, "facing_time_min") + value_of(p, "grinding_time_min")));
  CHECK(value_of(p, "piece_time_min") == Approx(p.main_time_min + value_of(p, "rough_rapid_min") + 3 * 6));
  CHECK(value_of(p, "time_per_part_min") == Approx(value_of(p, "piece_time_min") + (3 * 40 + 20) / 10.0));
  REQUIRE(p.edge);
  CHECK(p.edge->mean_min == Approx(60));
}

TEST_CASE("roll machining: turning and grinding add up to the roll") {
  RollMachining r = example();
  const CutPlan whole = plan(r, {});
  r.stage = RollStage::turning;
  const CutPlan turning = plan(r, {});
  r.stage = RollStage::grinding;
  const CutPlan grinding = plan(r, {});
  CHECK(turning.main_time_min + grinding.main_time_min == Approx(whole.main_time_min).epsilon(1e-13));
  CHECK_FALSE(turning.value_of("grinding_time_min"));
  CHECK_FALSE(grinding.value_of("rough_time_min"));
  r.grind_allowance_mm = 0;
  CHECK(plan(r, {}).main_time_min == 0);
}

TEST_CASE("roll machining: a wheel dressed flatter grinds faster until it grinds with its side") {
  RollMachining r = example();
  r.stage = RollStage::grinding;
  const double largest_mm = value_of(plan(r, {}), "dressing_radius_max_mm");
  double before_min = 1e300;
  for (const double share : {0.4, 0.6, 0.8, 0.999}) {
    r.grinding.dressed_radius_mm = share * largest_mm;
    const CutPlan p = plan(r, {});
    CHECK(p.feasible());
    CHECK(p.main_time_min < before_min);
    before_min = p.main_time_min;
  }
  r.grinding.dressed_radius_mm = 1.001 * largest_mm;
  CHECK_FALSE(limit_of(plan(r, {}), "dressing_radius_mm").met());
}

TEST_CASE("roll machining: more allowance, more time; deeper passes, fewer of them") {
  test::property([] {
    RollMachining r = example();
    r.profile_points = 41;
    r.rough.depth_max_mm = part(1, 5);
    r.finish_allowance_mm = part(0.2, 1.5);
    r.grind_allowance_mm = part(0.1, 0.5);
    const CutPlan p = plan(r, {});
    RollMachining deeper = r;
    deeper.rough.depth_max_mm *= 1.3;
    const CutPlan d = plan(deeper, {});
    RC_ASSERT(*d.value_of("cylinder_passes") <= *p.value_of("cylinder_passes"));
    RC_ASSERT(*d.value_of("contour_passes") <= *p.value_of("contour_passes"));
    RollMachining more = r;
    more.grind_allowance_mm += 0.2;
    // A larger allowance narrows the dressing radius and so the feed, and adds passes.
    RC_ASSERT(*plan(more, {}).value_of("grinding_time_min") > *p.value_of("grinding_time_min"));
    RC_ASSERT(*plan(more, {}).value_of("dressing_radius_max_mm") < *p.value_of("dressing_radius_max_mm"));
  });
}

TEST_CASE("roll machining: the NC program runs along the contour that leaves the grinding allowance") {
  const RollMachining r = example();
  const auto program = finishing_program(r, 1, 2);
  REQUIRE(program.lines.size() > 150);
  CHECK(program.lines.front() == "%");
  CHECK(program.lines.at(5) == "N40 G96 S140 M03");
  // The throat: 200 mm, and the allowance of 0.3 mm on each side.
  bool throat = false;
  for (const std::string& line : program.lines)
    throat = throat || line.find("X200.600 Z0.000") != std::string::npos;
  CHECK(throat);
}

TEST_CASE("roll machining: facing to the centre runs at the cap, facing to a bore does not") {
  RollMachining r = example();
  MachineLimits machine;
  machine.spindle_speed_max_rpm = 700;
  machine.spindle_speed_min_rpm = 100;
  const PlanContext context{.machine = &machine};
  CHECK(limit_of(plan(r, context), "spindle_speed_max_rpm").value == 800);
  CHECK_FALSE(plan(r, context).feasible());
  r.facing.inner_diameter_mm = 100;
  CHECK(limit_of(plan(r, context), "spindle_speed_max_rpm").value ==
        Approx(90'000 / (3.14159265358979 * 100)));
  CHECK(limit_of(plan(r, context), "spindle_speed_min_rpm").value ==
        Approx(90'000 / (3.14159265358979 * 265)));
  CHECK(plan(r, context).feasible());
}

TEST_CASE("roll machining: more points, less chord error") {
  RollMachining r = example();
  CHECK(limit_of(plan(r, {}), "chord_error_um").value == Approx(1000 * 4.0 / (8 * 420)));
  r.profile_points = 61;
  CHECK_FALSE(limit_of(plan(r, {}), "chord_error_um").met());
}

TEST_CASE("roll machining: a blank below the roll is an error that names it") {
  RollMachining r = example();
  r.blank_diameter_mm = 230;
  CHECK(refusal(r).find("D_blank_mm = 230") != std::string::npos);
  r = example();
  r.profile_points = 120;
  CHECK(refusal(r).find("n_points = 120") != std::string::npos);
}
