// Sources that give one effect each to an operation: the hot contact of chip and rake (K110), the controller
// of the grinding feed (K207), loads fitted to finite-element runs (K410). Then the states that plans leave.
#include <cmath>
#include <numbers>

#include "models/drilling/k410_drilling_fem.h"
#include "models/grinding/k207_longitudinal_feed_controller.h"
#include "models/thermal/k110_contact_hot_spots.h"
#include "operations/kinds/blade_finishing.h"
#include "operations/kinds/cylindrical_grinding.h"
#include "operations/kinds/gear_rolling.h"
#include "operations/kinds/through_hole_drilling.h"
#include "operations/kinds/tool_steel_finishing.h"
#include "operations/kinds/turning.h"
#include "tests/operations/gallery.h"

using namespace verstat;
using namespace verstat::operations;
using Catch::Matchers::Contains;
using namespace verstat::test;

TEST_CASE("turning: hot spots limit the speed and shorten the life of the edge", "[K110]") {
  // Titanium, as the card takes it: 1400 h^-0.23 N/mm2, calibrated coefficient.
  Turning t;
  t.diameter_mm = 60;
  t.length_mm = 200;
  t.cutting_speed_m_min = 60;
  t.feed_mm_rev = 0.2;
  t.depth_of_cut_mm = 2;
  t.material = TurningMaterial{.kc11_n_mm2 = 1400, .mc = 0.23, .tensile_strength_mpa = {}};
  const EdgeLife edge{
      .mean_ref_min = 15, .cutting_speed_ref_m_min = 60, .feed_ref_mm_rev = 0.2, .depth_of_cut_ref_mm = 2};
  const CutPlan cold = plan(t, {.edge = &edge});
  t.contact = TurningContact{
      .heat_capacity_n_mm2_k = 2.33, .diffusivity_mm2_s = 2.9, .temperature_coefficient = 0.24};
  const CutPlan mean = plan(t, {.edge = &edge});
  CHECK(mean.edge->mean_min == cold.edge->mean_min);
  const double u = 1400 * std::pow(0.2, -0.23);
  const double rise_k = 0.24 * u / 2.33 * std::cbrt(1000 * 0.2 / 2.9);  // 60 m/min is 1000 mm/s
  CHECK(value_of(mean, "contact_temperature_c") == Approx(20 + rise_k));
  CHECK(value_of(mean, "hot_spot_temperature_c") == value_of(mean, "contact_temperature_c"));

  t.contact->hot_spot_factor = 2;
  t.contact->hot_spot_max_c = 20 + rise_k;  // the hot spots may be as hot as the mean was
  const CutPlan limited = plan(t, {.edge = &edge});
  CHECK(value_of(limited, "hot_spot_temperature_c") == Approx(20 + 2 * rise_k));
  CHECK(value_of(limited, "hot_spot_speed_limit_m_min") == Approx(60.0 / 8));  // falls with its cube
  CHECK_FALSE(limit_of(limited, "cutting_speed_m_min").met());
  CHECK_FALSE(limited.feasible());
  t.cutting_speed_m_min = 7;
  CHECK(limit_of(plan(t, {.edge = &edge}), "cutting_speed_m_min").met());

  t.cutting_speed_m_min = 60;
  t.contact->hot_spot_max_c.reset();
  t.contact->hot_area_fraction = 0.05;
  t.contact->activation_energy_kj_mol = 80;
  const CutPlan worn = plan(t, {.edge = &edge});
  const double hot_c = 20 + 2 * rise_k;
  const double local = std::exp(80 / 8.314462618e-3 * (1 / (293.15 + rise_k) - 1 / (hot_c + 273.15)));
  CHECK(value_of(worn, "hot_spot_wear_multiplier") == Approx(1 + 0.05 * (local - 1)));
  CHECK(worn.edge->mean_min == Approx(cold.edge->mean_min / (1 + 0.05 * (local - 1))));
  t.material.reset();
  CHECK_THAT(refusal(t), Contains("contact/heat_capacity_n_mm2_k") && Contains("material"));
}

TEST_CASE("cylindrical grinding: the feed comes to its value over the first passes", "[K207]") {
  GalleryExample<CylindricalGrinding> example;
  const CutPlan at_once = example.plan();
  const double rpm = value_of(at_once, "part_speed_rpm");
  const double feed_m_min = 20 * rpm / 1000;
  auto& controller = example.spec.feed_controller.emplace();
  controller.feed_from_m_min = feed_m_min;  // nothing changes
  CHECK(example.plan().main_time_min == Approx(at_once.main_time_min));
  controller.feed_from_m_min = feed_m_min / 2;
  const CutPlan faster = example.plan();
  models::k207::FeedChange change;
  change.length_mm = 140;
  change.feed_from_m_min = feed_m_min / 2;
  change.feed_to_m_min = feed_m_min;
  change.n_passes = 31;
  CHECK(faster.main_time_min == Approx(models::k207::feed_change_time(change).time_min));
  CHECK(faster.main_time_min > at_once.main_time_min);
  // The first two passes run at the old feed: one pass each of 31 is lost, less what the overshoot gains.
  CHECK(faster.main_time_min < at_once.main_time_min * (31 + 8) / 31);
  CHECK(value_of(faster, "feed_settle_passes") == 14);
  CHECK(value_of(faster, "peak_traverse_feed_mm_rev") == Approx(20 * (1 + 0.0883 / 2)).epsilon(1e-3));
  CHECK(faster.feasible());
  // The overshoot takes the feed beyond the width of the wheel.
  example.spec.wheel_width_mm = 20.2;
  CHECK_FALSE(limit_of(example.plan(), "peak_traverse_feed_mm_rev").met());
  example.spec.wheel_width_mm = 40;
  // The card's largest stable gain at a delay of two passes is 2.747.
  controller.plant_gain = 2.7;
  CHECK(limit_of(example.plan(), "feed_loop_radius").met());
  controller.plant_gain = 2.8;
  CHECK_FALSE(limit_of(example.plan(), "feed_loop_radius").met());
  example.spec.traverse_feed_mm_rev.reset();
  example.spec.length_mm = 30;
  CHECK_THAT(refusal(example.spec), Contains("feed_controller"));
}

TEST_CASE("through-hole drilling: loads fitted to runs take the place of the handbook's", "[K410]") {
  GalleryExample<ThroughHoleDrilling> example;
  const CutPlan by_law = example.plan();
  // Runs that obey the law of the specification change nothing.
  const auto run = [&](double d, double s, double factor) {
    return DrillRun{d, s, factor * 680 * d * std::pow(s, 0.7), factor * 0.345 * d * d * std::pow(s, 0.8)};
  };
  example.spec.runs = {run(10, 0.1, 1), run(10, 0.3, 1), run(20, 0.2, 1), run(25, 0.35, 1)};
  const CutPlan same = example.plan();
  CHECK(value_of(same, "thrust_n") == Approx(value_of(by_law, "thrust_n")));
  CHECK(value_of(same, "torque_nm") == Approx(value_of(by_law, "torque_nm")));
  CHECK(value_of(same, "thrust_fit_error") < 1e-9);
  CHECK(value_of(same, "thrust_against_handbook") == Approx(0).margin(1e-9));  // C 68, 1.0, 0.7 at 750 MPa
  CHECK(same.breakage_probability == Approx(by_law.breakage_probability));
  // A harder steel: half as much again. The drive feels it.
  for (DrillRun& r : example.spec.runs) {
    r.thrust_n *= 1.5;
    r.torque_nm *= 1.5;
  }
  example.spec.spring_rate_n_mm = 480 * 1.5;
  const CutPlan harder = example.plan();
  CHECK(value_of(harder, "thrust_n") == Approx(1.5 * value_of(by_law, "thrust_n")));
  CHECK(value_of(harder, "power_kw") == Approx(1.5 * value_of(by_law, "power_kw")));
  CHECK(value_of(harder, "thrust_against_handbook") == Approx(0.5));
  CHECK(limit_of(harder, "feed_force_n").margin() < limit_of(by_law, "feed_force_n").margin());
  CHECK(harder.breakage_probability > by_law.breakage_probability);
  // Runs of the drill itself, one diameter: the feed's exponent is fitted, the diameter's stays.
  example.spec.runs = {run(20, 0.1, 1), run(20, 0.2, 1), run(20, 0.35, 1)};
  example.spec.spring_rate_n_mm = 480;
  CHECK(value_of(example.plan(), "thrust_n") == Approx(value_of(by_law, "thrust_n")));
  // One run is too little for a law, falling loads are none.
  example.spec.runs = {run(20, 0.1, 1)};
  CHECK_FALSE(refusal(example.spec, example.context()).empty());
  example.spec.runs = {run(20, 0.35, 1), run(20, 0.2, 2), run(20, 0.1, 4)};
  CHECK_THAT(refusal(example.spec, example.context()), Contains("runs"));
}

TEST_CASE("plans name the state in which the part leaves, with its scatter", "[leaves]") {
  const auto state = [](const CutPlan& p, const char* quantity) {
    INFO(quantity);
    const PartState* left = p.left(quantity);
    REQUIRE(left != nullptr);
    REQUIRE(p.value_of(quantity));  // the value stands among the quantities
    return left->sd;
  };
  const auto blade = GalleryExample<BladeFinishing>().plan();
  CHECK(state(blade, "endurance_limit_mpa") == 13);
  CHECK(state(blade, "microhardness_mpa") == 224.36);
  CHECK(state(blade, "ra_um") == 0);
  CHECK(state(GalleryExample<GearRolling>().plan(), "profile_error_um") == 0);
  const auto steel = GalleryExample<ToolSteelFinishing>().plan();
  state(steel, "fatigue_limit_mpa");
  state(steel, "tempered_depth_um");
  CHECK(steel.left("main_time_min") == nullptr);
  REQUIRE(steel.lot);
  CHECK(steel.lot->life_factor == value_of(steel, "service_life_factor"));
  for (const auto& kind : kinds().all()) {
    INFO(kind->name);
    const CutPlan p = test::Gallery(kind->name).file.plan();
    for (const PartState& left : p.leaves) CHECK(p.value_of(left.quantity));
  }
}
