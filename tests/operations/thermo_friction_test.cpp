#include "operations/kinds/thermo_friction.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using models::k305::Steel;
using verstat::test::limit_of;
using verstat::test::refusal;
using verstat::test::value_of;

namespace {

ThermoFriction example() {
  return test::Gallery("thermo_friction").spec<ThermoFriction>();
}

double part(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) * 1e-3;
}

}  // namespace

TEST_CASE("thermo-friction: the example lies at a corner of the published regimes") {
  const test::Gallery gallery("thermo_friction");
  const CutPlan p = gallery.file.process.plan(gallery.context());
  CHECK(p.feasible());
  CHECK(value_of(p, "in_envelope") == 1);
  CHECK(p.main_time_min == Approx(2 * 660 / 160.0));
  CHECK(value_of(p, "disc_speed_m_s") == Approx(50).margin(0.01));
  CHECK(value_of(p, "feed_limit_mm_min") == Approx(160));
  CHECK(value_of(p, "removal_rate_mm3_min") == Approx(26'000));
  CHECK(value_of(p, "power_kw") == Approx(26'000 * 20 / 60'000.0));
}

TEST_CASE("thermo-friction: leaving the envelope on any side is a limit that is not met") {
  const auto unmet = [](const ThermoFriction& t, const char* name) {
    const CutPlan p = plan(t, {});
    return !limit_of(p, name).met() && value_of(p, "in_envelope") == 0 && !p.feasible();
  };
  ThermoFriction t = example();
  t.depth_of_cut_mm = 2.6;
  CHECK(unmet(t, "published_depth_max_mm"));
  t = example();
  t.spindle_speed_rpm = 1500;
  CHECK(unmet(t, "published_spindle_speed_min_rpm"));
  t = example();
  t.disc_width_mm = t.part_width_mm = 75;  // between the bands
  CHECK(unmet(t, "published_width_min_mm"));
  t = example();
  t.feed_mm_min = 320;
  CHECK(unmet(t, "published_feed_max_mm_min"));
}

TEST_CASE("thermo-friction: the feed limit falls with depth and the plan sees it") {
  ThermoFriction t = example();
  t.depth_of_cut_mm = 1;
  t.feed_mm_min = 314;
  CHECK(limit_of(plan(t, {}), "feed_mm_min").met());
  t.depth_of_cut_mm = 2;
  CHECK_FALSE(limit_of(plan(t, {}), "feed_mm_min").met());
}

TEST_CASE("thermo-friction: the drive is loaded fully at the energy that the plan names") {
  ThermoFriction t = example();
  const double energy = value_of(plan(t, {}), "energy_limit_j_mm3");
  CHECK(energy > 20);
  t.specific_energy_j_mm3 = energy * 0.999;
  CHECK(limit_of(plan(t, {}), "drive_power_kw").met());
  t.specific_energy_j_mm3 = energy * 1.001;
  CHECK_FALSE(limit_of(plan(t, {}), "drive_power_kw").met());
}

TEST_CASE("thermo-friction: the state handed on decides what the next operation takes") {
  ThermoFriction t = example();
  const CutPlan removed = plan(t, {});
  CHECK(value_of(removed, "following_allowance_mm") == Approx(0.58));
  CHECK(value_of(removed, "surface_hardness_ratio") == 1.4);
  CHECK(value_of(removed, "next_hardness_ratio") < 1.03);
  CHECK(value_of(removed, "surface_stress_mpa") == Approx(450 + 720 * 0.5));  // tension
  CHECK(value_of(removed, "next_surface_stress_mpa") == 0);
  CHECK(limit_of(removed, "next_allowance_mm").met());
  t.next_allowance_mm = 0.5;
  CHECK_FALSE(plan(t, {}).feasible());

  // Keeping the layer: less to take, harder and under compression below the tension of the surface.
  t.hardened_layer = HardenedLayer::kept;
  const CutPlan kept = plan(t, {});
  CHECK(kept.feasible());
  CHECK(value_of(kept, "following_allowance_mm") == Approx(0.08));
  CHECK(value_of(kept, "next_hardness_ratio") == Approx(1.4));
  CHECK(value_of(kept, "next_surface_stress_mpa") < 0);
}

TEST_CASE("thermo-friction: alloy steel is left under compression, steel 45 under tension") {
  ThermoFriction t = example();
  t.surface_stress_max_mpa = 0;
  CHECK_FALSE(limit_of(plan(t, {}), "surface_stress_mpa").met());
  t.steel = Steel::steel_09kh15n8yu;
  CHECK(limit_of(plan(t, {}), "surface_stress_mpa").met());
  t.steel = Steel::steel_12kh13;
  CHECK(refusal(t) == "surface_stress_max_mpa = 0, is known for the steels 45 and 09Kh15N8Yu only");
}

TEST_CASE("thermo-friction: passes are rows times layers") {
  test::property([] {
    ThermoFriction t = example();
    const int rows = *rc::gen::inRange(1, 5);
    const int layers = *rc::gen::inRange(1, 6);
    t.overlap_mm = part(0, 10);
    t.part_width_mm = t.disc_width_mm + (rows - 1) * (t.disc_width_mm - t.overlap_mm);
    t.stock_mm = layers * t.depth_of_cut_mm;
    t.feed_mm_min = part(50, 400);
    const CutPlan p = plan(t, {});
    RC_ASSERT(*p.value_of("passes") == rows * layers);
    RC_ASSERT(std::abs(p.main_time_min * t.feed_mm_min / (rows * layers * 660.0) - 1) < 1e-12);
  });
}

TEST_CASE("thermo-friction: bad specifications are named") {
  ThermoFriction t = example();
  t.overlap_mm = 70;
  CHECK(refusal(t).find("overlap_mm = 70") != std::string::npos);
  t = example();
  t.feed_mm_min = 0;
  CHECK(refusal(t).find("feed_mm_min = 0") != std::string::npos);
}
