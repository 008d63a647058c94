#include "operations/kinds/through_hole_drilling.h"

#include <array>
#include <cmath>

#include "models/drilling/k114_sharpened_chisel_edge.h"
#include "models/drilling/k308_hole_pair_tooling.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using models::k113::ExitStrategy;
using operations::DrillBushing;
using operations::DrillPoint;
using operations::ThroughHoleDrilling;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("through-hole drilling: the example of the paper, four exit strategies") {
  // D 20 mm, P 6600 N, S 0.3 mm/rev, 400 rpm, spring 400 N/mm, part 40 mm: 0.408, 0.510, 0.435, 0.535 min.
  ThroughHoleDrilling s;
  s.diameter_mm = 20;
  s.thickness_mm = 40;
  s.cutting_speed_m_min = 0.4 * std::acos(-1.0) * 20;
  s.feed_mm_rev = 0.3;
  s.thrust_coefficient_n = 6600 / (20 * std::pow(0.3, 0.7));
  s.spring_rate_n_mm = 400;
  const std::array expected{
      std::pair{ExitStrategy::constant, 0.408}, std::pair{ExitStrategy::reduced_full_depth, 0.510},
      std::pair{ExitStrategy::reduced_exit, 0.435}, std::pair{ExitStrategy::spring_exit, 0.535}};
  for (const auto& [strategy, time_min] : expected) {
    s.exit_strategy = strategy;
    CHECK(plan(s, {}).main_time_min == Approx(time_min).margin(0.0006));
  }
  s.exit_strategy = ExitStrategy::spring_exit;
  CHECK(value_of(plan(s, {}), "spring_compression_mm") == Approx(16.5));
  s.spring_rate_n_mm = 549;
  CHECK_NOTHROW(plan(s, {}));
  s.spring_rate_n_mm = 551;  // stalls: softest need is 550 N/mm
  CHECK_THROWS_WITH(plan(s, {}), Catch::Contains("spring_rate_n_mm") && Catch::Contains("551"));
}

TEST_CASE("through-hole drilling: time against breakage") {
  GalleryExample<ThroughHoleDrilling> e;
  const auto at = [&](ExitStrategy strategy) {
    e.spec.exit_strategy = strategy;
    return e.plan();
  };
  const auto constant = at(ExitStrategy::constant);
  const auto full = at(ExitStrategy::reduced_full_depth);
  const auto exit = at(ExitStrategy::reduced_exit);
  const auto spring = at(ExitStrategy::spring_exit);
  CHECK(constant.main_time_min < exit.main_time_min);
  CHECK(exit.main_time_min < full.main_time_min);
  CHECK(full.main_time_min < spring.main_time_min);
  CHECK(constant.breakage_probability > exit.breakage_probability);
  CHECK(exit.breakage_probability >= full.breakage_probability);
  CHECK(full.breakage_probability > spring.breakage_probability);
  CHECK(limit_of(constant, "breakage_probability").margin() < 0);
  CHECK(limit_of(spring, "breakage_probability").margin() > 0);
  CHECK(spring.feasible());
  // The peak is that of the jump, j^y.
  CHECK(value_of(constant, "load_factor") == Approx(std::pow(value_of(constant, "feed_jump"), 0.8)));
  // Eight independent holes.
  e.spec.holes = 1;
  const double one = at(ExitStrategy::constant).breakage_probability;
  CHECK(constant.breakage_probability == Approx(1 - std::pow(1 - one, 8)));
}

TEST_CASE("through-hole drilling: a soft machine pulls the drill through") {
  GalleryExample<ThroughHoleDrilling> e;
  e.spec.exit_strategy = ExitStrategy::constant;
  e.spec.axial_stiffness_n_mm = 1500;
  const auto p = e.plan();
  CHECK(p.breakage_probability == 1);
  CHECK(limit_of(p, "springback_mm").margin() < 0);
  CHECK_FALSE(p.feasible());
}

TEST_CASE("through-hole drilling: multi-spindle head") {
  GalleryExample<ThroughHoleDrilling> e("through_hole_drilling_head");
  const auto two = e.plan();
  CHECK(two.feasible());
  CHECK(value_of(two, "strokes") == 4);
  const auto arms =
      models::k308::head_angle({.pinion_diameter_mm = 40, .gear_diameter_mm = 24, .distance_mm = 40});
  CHECK(value_of(two, "head_angle_deg") == arms.angle_deg);
  CHECK(arms.angle_deg == Approx(77.4).margin(0.05));
  auto single = e;
  single.spec.head.reset();
  const auto one = single.plan();
  CHECK(value_of(one, "strokes") == 8);
  CHECK(two.main_time_min < 0.51 * one.main_time_min);
  CHECK(value_of(two, "power_kw") == Approx(2 * value_of(one, "power_kw")));
  CHECK(value_of(two, "springback_mm") == Approx(2 * value_of(one, "springback_mm")));
  CHECK(two.breakage_probability > one.breakage_probability);
  CHECK(limit_of(two, "feed_force_n").value == Approx(2 * limit_of(one, "feed_force_n").value));
  // Constant feed through the head is K308's own main time.
  e.spec.exit_strategy = ExitStrategy::constant;
  const auto p = e.plan();
  const double rpm = value_of(p, "spindle_speed_rpm");
  const auto job = models::k308::multi_spindle_drilling({.depth_mm = 25 + value_of(p, "point_height_mm"),
                                                         .approach_mm = 2,
                                                         .overrun_mm = 1,
                                                         .feed_mm_rev = 0.2,
                                                         .machine_rpm = rpm * 12 / 20,
                                                         .pinion_teeth = 20,
                                                         .gear_teeth = 12,
                                                         .holes = 8,
                                                         .drills = 2,
                                                         .index_min = 0.05});
  CHECK(p.main_time_min == Approx(job.time_min));
  e.spec.head->centre_distance_mm = 27;  // tips of the gears touch below 28 mm
  CHECK(limit_of(e.plan(), "centre_distance_min_mm").margin() < 0);
}

TEST_CASE("through-hole drilling: points and bushings") {
  GalleryExample<ThroughHoleDrilling> e("through_hole_drilling_head");
  const auto sharp = e.plan();
  CHECK(value_of(sharp, "thrust_ratio") == Approx(1 - 0.5 * 0.6));
  const auto settings = models::k114::chisel_edge_setting_angles({{50, 85}, 12, 20});
  CHECK(value_of(sharp, "face_setting_deg") == settings.eps2_deg);
  CHECK(settings.eps2_deg == Approx(30.4).margin(0.1));
  e.spec.chisel_slope_deg = 80;
  e.spec.chisel_half_angle_deg = 35;  // the clearance is then at least 77.9 deg
  CHECK(limit_of(e.plan(), "chisel_clearance_deg").margin() < 0);

  e.spec.point = DrillPoint::standard;
  const auto standard = e.plan();
  CHECK(value_of(standard, "thrust_n") > value_of(sharp, "thrust_n"));
  CHECK(value_of(standard, "chisel_rake_deg") < -50);
  e.spec.point = DrillPoint::slotted_chisel;
  const auto slotted = e.plan();
  CHECK(value_of(slotted, "chisel_rake_deg") == 0);
  const auto& feed = limit_of(slotted, "chisel_clearance_feed_mm_rev");
  CHECK(feed.margin() > 0);
  // At the feed limit the clearance in work is the least one allowed.
  e.spec.feed_mm_rev = feed.allowed;
  CHECK(value_of(e.plan(), "chisel_kinematic_clearance_deg") == Approx(e.spec.kinematic_clearance_min_deg));

  REQUIRE(sharp.more_elements.size() == 1);
  auto fixed = GalleryExample<ThroughHoleDrilling>("through_hole_drilling_head");
  fixed.spec.bushing = DrillBushing::fixed;
  CHECK(sharp.more_elements[0].mean_min > 20 * fixed.plan().more_elements[0].mean_min);
  // 8000 holes of a fixed bushing are 2000 parts of four strokes.
  CHECK(fixed.plan().more_elements[0].mean_min == Approx(2000 * sharp.main_time_min));
}

TEST_CASE("through-hole drilling: what the specification must say") {
  GalleryExample<ThroughHoleDrilling> e;
  e.spec.spring_rate_n_mm.reset();
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("spring_rate_n_mm"));
  e = GalleryExample<ThroughHoleDrilling>();
  e.spec.overhang_mm.reset();
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("torsion_allow_mpa") && Catch::Contains("together"));
  e = GalleryExample<ThroughHoleDrilling>();
  e.spec.thickness_mm = 5;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("part_thickness_mm"));
}

TEST_CASE("through-hole drilling: breakage grows with the feed, time falls") {
  const GalleryExample<ThroughHoleDrilling> e;
  test::property([&](bool constant) {
    auto at = e;
    at.spec.exit_strategy = constant ? ExitStrategy::constant : ExitStrategy::reduced_exit;
    at.spec.feed_mm_rev = *rc::gen::inRange(5, 40) / 100.0;
    const auto slow = at.plan();
    at.spec.feed_mm_rev *= 1.1;
    const auto fast = at.plan();
    RC_ASSERT(fast.main_time_min < slow.main_time_min);
    RC_ASSERT(fast.breakage_probability >= slow.breakage_probability);
    RC_ASSERT(fast.edge->mean_min < slow.edge->mean_min);
  });
}
