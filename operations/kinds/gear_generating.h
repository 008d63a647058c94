#pragma once
// Operation kind "gear_generating": a gear finished by a spur tool on crossed axes, whose blank is a
// one-sheet hyperboloid (K202, K405). Only the sliding of the crossed flanks cuts: the speed follows from the
// crossing.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

/// Elastic constants of tool and gear, for the contact pressure.
struct FlankContact {
  double load_n_mm = 0;  ///< along the line of contact
  double reduced_radius_mm = 0;
  double tool_modulus_mpa = 600'000;
  double tool_poisson = 0.22;
  double gear_modulus_mpa = 210'000;
  double gear_poisson = 0.3;
  std::optional<double> pressure_max_mpa;
};

struct GearGenerating {
  static constexpr const char* kind = "gear_generating";
  double module_mm = 0;
  std::int64_t gear_teeth = 12;
  std::int64_t tool_teeth = 12;
  double shaft_angle_deg = 25;
  double face_width_mm = 0;
  double overrun_mm = 0;
  double feed_mm_rev = 0;  ///< per revolution of the gear
  double tool_speed_rpm = 0;
  std::int64_t passes = 1;
  double depth_of_cut_mm = 0.05;  ///< of a pass, for the life of the edge
  std::optional<double> cutting_speed_min_m_min;
  std::optional<double> cutting_speed_max_m_min;
  std::optional<FlankContact> contact;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const GearGenerating& spec, const PlanContext& context);

}  // namespace verstat::operations
