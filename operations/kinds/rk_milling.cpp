#include "operations/kinds/rk_milling.h"

#include <algorithm>
#include <cmath>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::RkMilling> {
  static std::vector<Field> fields() {
    using S = operations::RkMilling;
    return {
        need<S>(&S::mean_radius_mm, "mean_radius_mm", "mm", open_low(0, 1e4), "mean radius of the hole R"),
        need<S>(&S::eccentricity_mm, "eccentricity_mm", "mm", closed(0, 1e4),
                "half the difference of the radii at lobe and flat e"),
        may<S>(&S::lobes, "lobes", "1", closed(2, 100), "number of lobes N"),
        need<S>(&S::depth_mm, "depth_mm", "mm", open_low(0, 1000),
                "depth of the hole that the cutter covers"),
        need<S>(&S::form_tolerance_mm, "form_tolerance_mm", "mm", open_low(0, 100),
                "allowed deviation of the form, cusps and run-out together"),
        may<S>(&S::cutter_radius_mm, "cutter_radius_mm", "mm", open_low(0, 1e4),
               "mean radius of the cutter; not given: the largest without undercut, less the reserve"),
        may<S>(&S::undercut_reserve_mm, "undercut_reserve_mm", "mm", closed(0, 100),
               "what a chosen cutter radius stays below the undercut limit"),
        may<S>(&S::teeth, "teeth", "1", closed(1, 500),
               "number of teeth; not given: the fewest that keep the tolerance"),
        may<S>(&S::spacing, "spacing", "-", no_range(), "equal pitches, or pitches that equalise the cusps"),
        may<S>(&S::first_tooth_angle_deg, "first_tooth_angle_deg", "deg", closed(-360, 360),
               "polar angle of the first tooth: 0 cuts the lobe tip, 180 the flat"),
        may<S>(&S::run_out_mm, "run_out_mm", "mm", closed(0, 10), "run-out of the teeth, adds to the cusps"),
        may<S>(&S::it_grade_max, "it_grade_max", "1", closed(6, 16),
               "worst accuracy grade of the hole that is allowed, mean diameter 10 to 180 mm"),
        need<S>(&S::infeed_mm, "infeed_mm", "mm", open_low(0, 1000), "radial infeed to the final depth"),
        need<S>(&S::cross_feed_mm_min, "cross_feed_mm_min", "mm/min", open_low(0, 1e5), "radial feed"),
        need<S>(&S::work_speed_rpm, "work_speed_rpm", "rpm", open_low(0, 1e5), "speed of the part"),
        may<S>(&S::finish_revolutions, "finish_revolutions", "1", closed(0, 1e4),
               "turns of the part without infeed")};
  }
};

namespace verstat::operations {

namespace s3 = models::s3;

namespace {

// A hole with material left standing: so far off that no tolerance forgives it, and still a number that an
// optimizer can compare.
constexpr double never_mm = 1e3;

double deviation_mm(const RkMilling& spec, const s3::RkCutter& cutter, std::int64_t teeth) {
  s3::RkUniformCutter with_teeth;
  static_cast<s3::RkCutter&>(with_teeth) = cutter;
  with_teeth.teeth = teeth;
  with_teeth.first_tooth_angle_deg = spec.first_tooth_angle_deg;
  return spec.spacing == s3::Spacing::uniform
             ? s3::rk_form_error_uniform(with_teeth).max_deviation_mm.value_or(never_mm)
             : s3::rk_equalised_cutter(with_teeth).equal_deviation_mm;
}

std::int64_t fewest_teeth(const RkMilling& spec, const s3::RkCutter& cutter) {
  s3::RkTeethForTolerance wanted;
  static_cast<s3::RkCutter&>(wanted) = cutter;
  wanted.tolerance_mm = spec.form_tolerance_mm - spec.run_out_mm;
  wanted.first_tooth_angle_deg = spec.first_tooth_angle_deg;
  wanted.spacing = spec.spacing;
  return s3::rk_min_teeth(wanted).teeth;
}

}  // namespace

CutPlan plan(const RkMilling& spec, const PlanContext& context) {
  models::require(spec.run_out_mm < spec.form_tolerance_mm, "run_out_mm", spec.run_out_mm,
                  "must be below the form tolerance, which it uses up");
  s3::RkCutter cutter;
  cutter.mean_radius_mm = spec.mean_radius_mm;
  cutter.eccentricity_mm = spec.eccentricity_mm;
  cutter.lobes = spec.lobes;
  const s3::RkRadiusLimits limits = s3::rk_cutter_radius_limits(cutter);
  if (spec.cutter_radius_mm) {
    cutter.cutter_radius_mm = *spec.cutter_radius_mm;
  } else {
    cutter.cutter_radius_mm = limits.max_cutter_radius_mm - spec.undercut_reserve_mm;
    models::require(
        cutter.cutter_radius_mm >= limits.min_cutter_radius_mm, "eccentricity_mm", spec.eccentricity_mm,
        "no cutter both clears the undercut at the lobe tip and reaches the flat: the hole is too "
        "strongly lobed, or the reserve too large");
  }
  const std::int64_t teeth = spec.teeth ? *spec.teeth : fewest_teeth(spec, cutter);
  const double cusp_mm = deviation_mm(spec, cutter, teeth);
  const double form_mm = cusp_mm + spec.run_out_mm;

  s3::RkPass pass;
  pass.infeed_mm = spec.infeed_mm;
  pass.cross_feed_mm_min = spec.cross_feed_mm_min;
  pass.work_speed_rpm = spec.work_speed_rpm;
  pass.finish_revolutions = spec.finish_revolutions;

  s3::RkCutting at;
  static_cast<s3::RkCutter&>(at) = cutter;
  at.work_speed_rpm = spec.work_speed_rpm;
  const s3::RkKinematics lobe = s3::rk_cutting_kinematics(at);
  at.normal_angle_deg = 180 / static_cast<double>(spec.lobes);
  const s3::RkKinematics flat = s3::rk_cutting_kinematics(at);
  const double fastest_m_min = std::max(lobe.cutting_speed_m_min, flat.cutting_speed_m_min);
  // Every tooth meets each lobe once in a turn of the part.
  const double feed_per_tooth_mm = spec.cross_feed_mm_min / spec.work_speed_rpm;

  CutPlan p;
  p.quantities.reserve(14);
  p.set_main_time(s3::rk_hole_machining_time(pass).time_min, "S3.rk_hole_machining_time");
  p.quantities.push_back({"cutter_radius_mm", cutter.cutter_radius_mm, "mm",
                          spec.cutter_radius_mm ? "given" : "S3.rk_cutter_radius_limits",
                          "mean radius of the cutter"});
  p.quantities.push_back({"teeth", static_cast<double>(teeth), "1", spec.teeth ? "given" : "S3.rk_min_teeth",
                          "number of teeth"});
  p.quantities.push_back(
      {"cusp_mm", cusp_mm, "mm",
       spec.spacing == s3::Spacing::uniform ? "S3.rk_form_error_uniform" : "S3.rk_equalised_cutter",
       "largest cusp between teeth; 1000 where material stays"});
  p.quantities.push_back(
      {"form_deviation_mm", form_mm, "mm", "COMPLETION: cusp plus run-out", "deviation of the form"});
  p.quantities.push_back({"cutter_radius_max_mm", limits.max_cutter_radius_mm, "mm",
                          "S3.rk_cutter_radius_limits", "undercut limit of the cutter radius"});
  p.quantities.push_back({"cutter_radius_min_mm", limits.min_cutter_radius_mm, "mm",
                          "S3.rk_cutter_radius_limits", "below it the track at the flat loops"});
  p.quantities.push_back(
      {"cutter_speed_rpm", lobe.cutter_speed_rpm, "rpm", "S3.rk_cutting_kinematics", "speed of the cutter"});
  p.quantities.push_back({"cutting_speed_lobe_m_min", lobe.cutting_speed_m_min, "m/min",
                          "S3.rk_cutting_kinematics", "cutting speed at the lobe tip"});
  p.quantities.push_back({"cutting_speed_flat_m_min", flat.cutting_speed_m_min, "m/min",
                          "S3.rk_cutting_kinematics", "cutting speed at the flat"});
  p.quantities.push_back({"feed_per_tooth_mm", feed_per_tooth_mm, "mm", "definition",
                          "radial infeed between two cuts of a tooth in a lobe"});

  p.limits.push_back(
      {"form_deviation_mm", form_mm, spec.form_tolerance_mm, true, "mm", "COMPLETION: cusp plus run-out"});
  p.limits.push_back({"cutter_radius_mm", cutter.cutter_radius_mm, limits.max_cutter_radius_mm, true, "mm",
                      "S3.rk_cutter_radius_limits"});
  p.limits.push_back({"cutter_radius_mm", cutter.cutter_radius_mm, limits.min_cutter_radius_mm, false, "mm",
                      "S3.rk_cutter_radius_limits"});
  const double nominal_mm = 2 * spec.mean_radius_mm;
  if (nominal_mm > 10 && nominal_mm <= 180) {
    const double grade = static_cast<double>(s3::it_grade_for_deviation({form_mm, nominal_mm, 0.6}).it_grade);
    p.quantities.push_back({"it_grade", grade, "1", "S3.it_grade_for_deviation",
                            "accuracy grade of the hole; 17 is worse than 16"});
    if (spec.it_grade_max)
      p.limits.push_back({"it_grade", grade, *spec.it_grade_max, true, "1", "S3.it_grade_for_deviation"});
  } else {
    models::require(!spec.it_grade_max, "it_grade_max", nominal_mm,
                    "is known for mean diameters above 10 and up to 180 mm only");
  }
  MachineLoad load;
  load.spindle_speed_rpm = lobe.cutter_speed_rpm;
  load.feed_rate_mm_min = spec.cross_feed_mm_min;
  add_machine_limits(p, context, load);
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, fastest_m_min, feed_per_tooth_mm, spec.depth_mm);
  return p;
}

namespace rk_milling {
void add_to(Kinds& kinds) {
  kinds.add<RkMilling>("An RK (polygon) hole generated by a disc cutter; the tolerance decides the cutter.",
                       {"S3"});
}
}  // namespace rk_milling

}  // namespace verstat::operations
