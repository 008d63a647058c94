// Cylindrical grinding: burn removed by finishing, roughness lowered by spark-out, protrusion and dressing.

#include "operations/kinds/cylindrical_grinding.h"

#include <numbers>

#include "models/grinding/k302_combined_grinding_roughness.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

namespace verstat::operations {
namespace {

using test::limit_of;

CylindricalGrinding example() {
  return test::Gallery("cylindrical_grinding").spec<CylindricalGrinding>();
}

TEST_CASE("cylindrical grinding: the example is feasible and survives JSON") {
  const MachineLimits machine = test::Gallery("cylindrical_grinding").file.machine_limits;
  PlanContext context;
  context.machine = &machine;
  const CutPlan p = plan(example(), context);
  CHECK(p.feasible());
  CHECK(p.quantities.front().name == std::string("main_time_min"));
  // 18 + 10 + 3 passes of (120 + 20)/20 revolutions at 106.1 rpm.
  CHECK(p.main_time_min == Approx(31 * 7 / (20'000 / (std::numbers::pi * 60))));
}

TEST_CASE("cylindrical grinding: roughing burns, finishing must remove it") {
  CylindricalGrinding s = example();
  const CutPlan p = plan(s, {});
  REQUIRE(*p.value_of("rough_temperature_c") > s.transform_c);
  REQUIRE(*p.value_of("finish_temperature_c") < s.transform_c);
  const double rough_um = *p.value_of("rough_defect_um");
  CHECK(rough_um > 0);
  CHECK(*p.value_of("defect_depth_um") == 0);
  CHECK(*p.value_of("burn_passes") == std::ceil(rough_um / s.finish_infeed_um));

  // Exactly as many finishing passes as the recursion asks for are enough, one fewer is not.
  s.finish_allowance_um = s.finish_infeed_um * *p.value_of("burn_passes");
  CHECK(limit_of(plan(s, {}), "defect_depth_um").met());
  s.finish_allowance_um -= s.finish_infeed_um;
  const CutPlan burnt = plan(s, {});
  CHECK_FALSE(limit_of(burnt, "defect_depth_um").met());
  CHECK(*burnt.value_of("defect_depth_um") == Approx(rough_um - s.finish_allowance_um));

  // Finishing as hard as roughing never gets rid of it.
  s.finish_infeed_um = s.rough_infeed_um;
  CHECK(*plan(s, {}).value_of("burn_passes") == -1);
}

TEST_CASE("cylindrical grinding: spark-out costs time and lowers Ra") {
  CylindricalGrinding s = example();
  double time_min = 0;
  double ra_um = 1e9;
  for (const std::int64_t sparkout : {0, 1, 3, 8}) {
    s.sparkout_passes = sparkout;
    const CutPlan p = plan(s, {});
    CHECK(p.main_time_min > time_min);
    CHECK(*p.value_of("roughness_ra_um") < ra_um);
    CHECK(limit_of(p, "roughness_ra_um").value == *p.value_of("roughness_ra_um"));
    time_min = p.main_time_min;
    ra_um = *p.value_of("roughness_ra_um");
  }
  s.sparkout_passes = 0;
  CHECK_FALSE(limit_of(plan(s, {}), "roughness_ra_um").met());
}

TEST_CASE("cylindrical grinding: plunge agrees with K302 called directly") {
  CylindricalGrinding s = example();
  s.traverse_feed_mm_rev.reset();
  s.length_mm = 30;
  s.finish_infeed_um = 2;
  s.sparkout_passes = 4;
  s.roughness_ra_max_um.reset();
  const CutPlan p = plan(s, {});
  models::k302::MarkGeometry wheel{.profile_exponent = 0.5,
                                   .tip_exponent = 1.5,
                                   .chip_coefficient = 0.9,
                                   .width_coefficient = 0.283,
                                   .grains_per_mm2 = 20,
                                   .wheel_speed_m_s = 35,
                                   .work_speed_m_min = 20,
                                   .up_grinding = true,
                                   .wheel_diameter_mm = 400.0 * 60 / 460,
                                   .wheel_layer_mm = 0.03};
  const auto intensity = models::k302::abrasive_mark_intensity(wheel);
  models::k302::MarkFieldAtDepth field;
  field.g_per_mm_nu = intensity.g_per_mm_nu;
  field.nu = intensity.nu;
  field.shift_um = 2;
  field.contacts = 20;
  field.sparkout_contacts = 4;
  field.median_depth_um = models::k302::median_depth(field).median_depth_um;
  CHECK(*p.value_of("roughness_ra_um") == Approx(models::k302::roughness_ra(field).ra_um).epsilon(1e-12));
  // Roughing, 12 um deep over 30 mm, takes the most power.
  const double removed_mm3_s = 20'000.0 / 60 * 0.012 * 30;
  CHECK(*p.value_of("power_kw") == Approx(45 * removed_mm3_s / 1000));

  s.length_mm = 41;
  CHECK(test::refusal(s) ==
        "wheel_width_mm = 40, must cover length_mm in plunge grinding (no traverse_feed_mm_rev)");
}

TEST_CASE("cylindrical grinding: electrochemical aid lowers Ra at the same removal") {
  CylindricalGrinding s = example();
  const CutPlan plain = plan(s, {});
  s.electrochemical =
      ElectrochemicalAid{.voltage_v = 6, .gap_um = 20, .exposure_s = 0.5, .conductivity_s_m = 15};
  const CutPlan aided = plan(s, {});
  CHECK(*aided.value_of("roughness_ra_um") < *plain.value_of("roughness_ra_um"));
  CHECK(aided.main_time_min == plain.main_time_min);
  s.electrochemical->voltage_v = 0;
  CHECK(*plan(s, {}).value_of("roughness_ra_um") == *plain.value_of("roughness_ra_um"));
}

TEST_CASE("cylindrical grinding: dressing follows the protrusion") {
  CylindricalGrinding s = example();
  const CutPlan p = plan(s, {});
  REQUIRE(p.more_elements.size() == 1);
  CHECK(p.more_elements[0].element == std::string("wheel dressing"));
  CHECK(p.more_elements[0].mean_min ==
        Approx((30 - *p.value_of("sunk_depth_um")) / s.protrusion_loss_um_min));
  s.grain_protrusion_um = *p.value_of("sunk_depth_um") / 2;
  const CutPlan blunt = plan(s, {});
  CHECK(limit_of(blunt, "grain_protrusion_um").margin() == Approx(-1));
  CHECK(blunt.more_elements[0].mean_min == blunt.main_time_min);
  s.dressing_law = models::LifeLawKind::normal;
  CHECK(test::refusal(s) == "dressing_cv = 0.7, must not be above 0.45 with the normal law");
}

TEST_CASE("cylindrical grinding: bad specifications name the place") {
  nlohmann::json json = test::Gallery("cylindrical_grinding").json.at("process");
  json["work_speed_m_min"] = -1;
  CHECK(test::refusal(json).find("work_speed_m_min = -1") != std::string::npos);
  CylindricalGrinding s = example();
  s.finish_allowance_um = 300;
  CHECK(test::refusal(s) == "finish_allowance_um = 300, must not be above allowance_um");
}

TEST_CASE("cylindrical grinding: harder regimes heat, sink and roughen more") {
  test::property("infeed, speed", [] {
    CylindricalGrinding s = example();
    s.work_speed_m_min = *rc::gen::inRange(5, 40);
    s.finish_infeed_um = *rc::gen::inRange(1, 10);
    const CutPlan mild = plan(s, {});
    s.finish_infeed_um += *rc::gen::inRange(1, 10);
    const CutPlan hard = plan(s, {});
    RC_ASSERT(*hard.value_of("finish_temperature_c") > *mild.value_of("finish_temperature_c"));
    RC_ASSERT(hard.main_time_min <= mild.main_time_min);
    RC_ASSERT(*hard.value_of("sunk_depth_um") >= *mild.value_of("sunk_depth_um") - 1e-9);
  });
}

}  // namespace
}  // namespace verstat::operations
