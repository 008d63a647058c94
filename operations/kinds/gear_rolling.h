#pragma once
// Operation kind "gear_rolling": the teeth of a cylindrical gear finished and strengthened with a multi-start
// roller on crossed axes (K115). A hyperboloid roller leaves a quarter of the profile error of a conventional
// one.

#include <cstdint>

#include "models/gears/k115_hyperboloid_roller.h"
#include "operations/kind.h"

namespace verstat::operations {

struct GearRolling {
  static constexpr const char* kind = "gear_rolling";
  std::int64_t gear_teeth = 0;
  double module_mm = 0;
  std::int64_t roller_starts = 17;
  double shaft_angle_deg = 30;
  models::k115::Roller roller = models::k115::Roller::hyperboloid;
  double roller_speed_rpm = 0;
  double gear_revolutions = 20;              ///< 10 to 30
  double conventional_profile_error_um = 0;  ///< that a conventional roller leaves on this gear
  std::optional<double> profile_error_max_um;
  std::optional<std::int64_t> accuracy_grade_max;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for an accuracy grade
/// wanted of a roller whose grade is not known.
[[nodiscard]] CutPlan plan(const GearRolling& spec, const PlanContext& context);

}  // namespace verstat::operations
