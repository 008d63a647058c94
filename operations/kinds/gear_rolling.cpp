#include "operations/kinds/gear_rolling.h"

#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::GearRolling> {
  static std::vector<Field> fields() {
    using S = operations::GearRolling;
    return {
        need<S>(&S::gear_teeth, "gear_teeth", "1", closed(5, 1000), "teeth of the gear"),
        need<S>(&S::module_mm, "module_mm", "mm", closed(0.2, 50), "module"),
        may<S>(&S::roller_starts, "roller_starts", "1", closed(5, 200), "starts of the roller"),
        may<S>(&S::shaft_angle_deg, "shaft_angle_deg", "deg", closed(0, 60), "crossing of the axes"),
        may<S>(&S::roller, "roller", "-", no_range(), "shape of the roller"),
        need<S>(&S::roller_speed_rpm, "roller_speed_rpm", "rpm", open_low(0, 1e4), "speed of the roller"),
        may<S>(&S::gear_revolutions, "gear_revolutions", "1", open_low(0, 1000),
               "revolutions of the gear, 10 to 30"),
        need<S>(&S::conventional_profile_error_um, "conventional_profile_error_um", "um", open_low(0, 1000),
                "profile error that a conventional roller leaves"),
        may<S>(&S::profile_error_max_um, "profile_error_max_um", "um", open_low(0, 1000),
               "largest profile error"),
        may<S>(&S::accuracy_grade_max, "accuracy_grade_max", "1", closed(1, 12), "coarsest accuracy grade")};
  }
};

namespace verstat::operations {

namespace k115 = models::k115;

CutPlan plan(const GearRolling& spec, const PlanContext& context) {
  const auto pitch = k115::roller_pitch_geometry({.roller_starts = spec.roller_starts,
                                                  .module_mm = spec.module_mm,
                                                  .shaft_angle_deg = spec.shaft_angle_deg,
                                                  .tool_teeth = spec.gear_teeth});
  const auto quality = k115::gear_rolling_quality({spec.roller});
  const auto made = k115::roller_design_range({});
  models::require(!spec.accuracy_grade_max || quality.accuracy_grade, "accuracy_grade_max",
                  spec.accuracy_grade_max.value_or(0), "is known for the hyperboloid roller only");
  const double error_um = spec.conventional_profile_error_um * quality.profile_error_factor;

  CutPlan p;
  const double ratio = static_cast<double>(spec.gear_teeth) / static_cast<double>(spec.roller_starts);
  p.set_main_time(spec.gear_revolutions * ratio / spec.roller_speed_rpm,
                  "COMPLETION: revolutions of the gear over its speed");
  auto& q = p.quantities;
  q.push_back({"gear_speed_rpm", spec.roller_speed_rpm / ratio, "rpm", "definition", "speed of the gear"});
  q.push_back({"roller_pitch_diameter_mm", pitch.pitch_diameter_mm, "mm", "K115.roller_pitch_geometry",
               "pitch diameter of the roller"});
  q.push_back({"centre_distance_mm", pitch.centre_distance_mm, "mm", "K115.roller_pitch_geometry",
               "shortest distance of the axes"});
  q.push_back({"profile_error_factor", quality.profile_error_factor, "1", "K115.gear_rolling_quality",
               "profile error over that of a conventional roller"});
  q.push_back({"profile_error_um", error_um, "um", "K115.gear_rolling_quality", "profile error left"});
  if (quality.accuracy_grade)
    q.push_back({"accuracy_grade", static_cast<double>(*quality.accuracy_grade), "1",
                 "K115.gear_rolling_quality", "accuracy grade reached"});
  p.leave("profile_error_um");
  if (quality.accuracy_grade) p.leave("accuracy_grade");
  if (spec.profile_error_max_um)
    p.limits.push_back(
        {"profile_error_um", error_um, *spec.profile_error_max_um, true, "um", "K115.gear_rolling_quality"});
  if (spec.accuracy_grade_max)
    p.limits.push_back({"accuracy_grade", static_cast<double>(*quality.accuracy_grade),
                        static_cast<double>(*spec.accuracy_grade_max), true, "1",
                        "K115.gear_rolling_quality"});
  constexpr const char* range = "K115.roller_design_range: rollers outside have not been made";
  const auto between = [&](const char* name, double value, double low, double high, const char* unit) {
    p.limits.push_back({name, value, low, false, unit, range});
    p.limits.push_back({name, value, high, true, unit, range});
  };
  between("roller_starts", static_cast<double>(spec.roller_starts), static_cast<double>(made.starts_min),
          static_cast<double>(made.starts_max), "1");
  between("roller_pitch_diameter_mm", pitch.pitch_diameter_mm, made.pitch_diameter_min_mm,
          made.pitch_diameter_max_mm, "mm");
  between("shaft_angle_deg", spec.shaft_angle_deg, made.helix_min_deg, made.helix_max_deg, "deg");
  limit_spindle_speed(p, context, spec.roller_speed_rpm, "given");
  return p;
}

namespace gear_rolling {
void add_to(Kinds& kinds) {
  kinds.add<GearRolling>("Gear teeth finished and strengthened with a roller on crossed axes.", {"K115"});
}
}  // namespace gear_rolling

}  // namespace verstat::operations
