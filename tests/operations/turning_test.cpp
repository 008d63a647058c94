#include "operations/kinds/turning.h"

#include <cmath>
#include <numbers>

#include "models/surface/k411_finish_turning_roughness.h"
#include "models/thermal/k403_unsteady_cutting_temperature.h"
#include "operations/taylor.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::limit_of;
using verstat::test::refusal;
using verstat::test::value_of;

namespace {

Turning plain() {
  Turning t;
  t.diameter_mm = 500;
  t.length_mm = 1000;
  t.cutting_speed_m_min = 60;
  t.feed_mm_rev = 1;
  t.depth_of_cut_mm = 10;
  return t;
}

Turning finishing() {
  return test::Gallery("turning").spec<Turning>();
}

double part(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) * 1e-3;
}

}  // namespace

TEST_CASE("turning: nothing but the regime gives time, speed and life, as before") {
  const EdgeLife edge;
  const CutPlan p = plan(plain(), {.edge = &edge});
  CHECK(p.main_time_min == Approx(std::numbers::pi * 500 * 1000 / (1000 * 60 * 1.0)).epsilon(1e-14));
  REQUIRE(p.quantities.size() == 2);
  CHECK(value_of(p, "spindle_speed_rpm") == Approx(60'000 / (std::numbers::pi * 500)).epsilon(1e-14));
  CHECK(p.limits.empty());
  CHECK(p.scrap_probability == 0);
  REQUIRE(p.edge);
  CHECK(p.edge->mean_min == taylor_life(edge, 60, 1, 10).mean_min);
}

TEST_CASE("turning: Kienzle's force of a straight edge, by hand") {
  Turning t = plain();
  t.material = TurningMaterial{.kc11_n_mm2 = 1800, .mc = 0.25, .tensile_strength_mpa = {}};
  t.feed_mm_rev = 0.25;
  t.depth_of_cut_mm = 4;
  const CutPlan p = plan(t, {});
  const double force_n = 1800 * std::pow(0.25, -0.25) * 0.25 * 4;
  CHECK(value_of(p, "cutting_force_n") == Approx(force_n).epsilon(1e-13));
  CHECK(value_of(p, "power_kw") == Approx(force_n * 60 / 60'000).epsilon(1e-13));
  CHECK(value_of(p, "torque_nm") == Approx(force_n * 0.25).epsilon(1e-13));
}

TEST_CASE("turning: the example's numbers are those of the models") {
  const test::Gallery example("turning");
  const Turning& t = *example.file.process.as<Turning>();
  const CutPlan p = example.file.process.plan(example.context());
  CHECK(p.feasible());
  // Card K411: Ra 3.023 um at 0.33 mm/rev with a nose of 2 mm.
  CHECK(value_of(p, "roughness_ra_um") == Approx(3.023).margin(6e-4));
  const auto force = models::k102::handbook_turning_force({.depth_mm = 1,
                                                           .feed_mm_rev = 0.33,
                                                           .speed_m_min = 120,
                                                           .nose_radius_mm = 2,
                                                           .lead_angle_deg = 45,
                                                           .material_factor = 1});
  CHECK(value_of(p, "radial_force_n") == force.py_n);
  CHECK(value_of(p, "feed_force_n") == force.px_n);
  models::k403::ContinuousCut cut;
  cut.cutting_speed_m_min = 120;
  cut.feed_mm_rev = 0.33;
  cut.depth_mm = 1;
  cut.flank_wear_mm = 0.1;
  cut.kr_deg = 45;
  cut.tool_conductivity_w_mk = 27;
  cut.tool_diffusivity_mm2_s = 11;
  const auto theta = models::k403::cutting_temperature(cut);
  CHECK(value_of(p, "rake_temperature_c") == theta.rake_c);
  CHECK(value_of(p, "mean_temperature_c") == theta.mean_c);
  CHECK(p.edge->mean_min == taylor_life(*example.file.edge_life, t.cutting_speed_m_min, 0.33, 1).mean_min);
}

TEST_CASE("turning: each limit changes sign where its model says") {
  const test::Gallery example("turning");
  Turning t = finishing();

  SECTION("roughness: at the largest feed for Ra of K411") {
    const double feed_mm_rev =
        models::k411::max_feed_for_ra({models::k411::FeedBounds{{2, 45, 45}, 0.05, 0.55}, 3.2}).feed_mm_rev;
    CHECK(feed_mm_rev == Approx(0.3456).margin(6e-5));
    t.feed_mm_rev = feed_mm_rev * 0.999;
    CHECK(limit_of(plan(t, example.context()), "roughness_ra_um").margin() > 0);
    t.feed_mm_rev = feed_mm_rev * 1.001;
    CHECK(limit_of(plan(t, example.context()), "roughness_ra_um").margin() < 0);
    CHECK_FALSE(plan(t, example.context()).feasible());
  }
  SECTION("temperature: at the speed for the limit of K403") {
    t.temperature_max_c = 900;
    models::k403::TemperatureLimit limit;
    limit.feed_mm_rev = 0.33;
    limit.depth_mm = 1;
    limit.flank_wear_mm = 0.1;
    limit.kr_deg = 45;
    limit.tool_conductivity_w_mk = 27;
    limit.tool_diffusivity_mm2_s = 11;
    limit.limit_c = 900;
    const auto speed = models::k403::speed_for_temperature(limit);
    REQUIRE(speed.feasible);
    REQUIRE(speed.speed_m_min < 600);
    t.cutting_speed_m_min = speed.speed_m_min * 0.999;
    CHECK(limit_of(plan(t, {}), "mean_temperature_c").met());
    t.cutting_speed_m_min = speed.speed_m_min * 1.001;
    CHECK_FALSE(limit_of(plan(t, {}), "mean_temperature_c").met());
  }
  SECTION("power and force: at the load they allow") {
    const CutPlan p = plan(t, example.context());
    const double force_n = value_of(p, "cutting_force_n");
    const double power_kw = value_of(p, "power_kw");
    MachineLimits machine;
    machine.power_kw = power_kw * 1.001;
    t.force_max_n = force_n * 0.999;
    CHECK(limit_of(plan(t, {.machine = &machine}), "power_kw").met());
    CHECK_FALSE(limit_of(plan(t, {.machine = &machine}), "cutting_force_n").met());
    machine.power_kw = power_kw * 0.999;
    t.force_max_n = force_n * 1.001;
    CHECK_FALSE(limit_of(plan(t, {.machine = &machine}), "power_kw").met());
    CHECK(limit_of(plan(t, {.machine = &machine}), "cutting_force_n").met());
  }
}

TEST_CASE("turning: scrap by roughness is one half at the limit") {
  Turning t = finishing();
  t.roughness_max_um = value_of(plan(t, {}), "roughness_ra_um");
  CHECK(plan(t, {}).scrap_probability == 0);
  t.scrap_above_roughness = true;
  CHECK(plan(t, {}).scrap_probability == Approx(0.5).margin(1e-12));
  t.roughness_max_um = 3.2;
  CHECK(plan(t, {}).scrap_probability < 0.5);
}

TEST_CASE("turning: the rake face scales the force as K102's Table 5") {
  Turning t = finishing();
  const double flat_n = value_of(plan(t, {}), "cutting_force_n");
  t.insert->rake_shape = models::k102::RakeShape::peripheral_groove;
  CHECK(value_of(plan(t, {}), "cutting_force_n") / flat_n == Approx(6160.0 / 8620).epsilon(1e-12));
}

TEST_CASE("turning: force, power and temperature rise with feed, depth and speed") {
  test::property([] {
    Turning low = finishing();
    low.feed_mm_rev = part(0.05, 0.5);
    low.depth_of_cut_mm = part(0.3, 5);
    low.cutting_speed_m_min = part(30, 200);
    Turning high = low;
    const double more = part(1.05, 1.5);
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        high.feed_mm_rev *= more;
        break;
      case 1:
        high.depth_of_cut_mm *= more;
        break;
      default:
        high.cutting_speed_m_min *= more;
    }
    const CutPlan a = plan(low, {});
    const CutPlan b = plan(high, {});
    RC_ASSERT(*b.value_of("cutting_force_n") >= *a.value_of("cutting_force_n") * (1 - 1e-12));
    RC_ASSERT(*b.value_of("power_kw") > *a.value_of("power_kw"));
    RC_ASSERT(*b.value_of("rake_temperature_c") > *a.value_of("rake_temperature_c"));
  });
}

TEST_CASE("turning: a limit on something unknown is an error that names it") {
  Turning t = plain();
  t.roughness_max_um = 3.2;
  CHECK(refusal(t) == "roughness_max_um = 3.2, needs the member \"insert\"");
  t = plain();
  t.temperature_max_c = 900;
  CHECK(refusal(t) == "temperature_max_c = 900, needs the member \"heat\"");
  t = plain();
  t.feed_mm_rev = 0;
  CHECK(refusal(t).find("feed") != std::string::npos);
}
