#pragma once
// Operation kind "internal_grinding": a bore ground by plunging, a depth of cut per revolution of the part.
//
// The height of irregularities inside the contact arc (K303) tells how deep the wheel face sinks into the
// work: it must stay below the protrusion of the grains, which wears and is restored by dressing.

#include <cstdint>

#include "operations/dressing.h"
#include "operations/kind.h"

namespace verstat::operations {

struct InternalGrinding : GrainProtrusion {
  static constexpr const char* kind = "internal_grinding";
  double bore_diameter_mm = 0;
  double length_mm = 0;
  double allowance_um = 0;  // on the radius
  double work_speed_m_min = 0;
  double depth_um = 0;  // per revolution
  std::int64_t sparkout_revolutions = 0;
  double wheel_diameter_mm = 0;
  double wheel_width_mm = 0;
  double wheel_speed_m_s = 0;
  double grain_spacing_mm = 0.32;
  double tip_radius_um = 6.69;
  double tip_angle_deg = 91;
  double weibull_x0_um_m = 81.2;
  double weibull_m = 1.45;
  double interval_um = 0.12;
  double coverage = 0.9;
  std::optional<double> specific_energy_j_mm3;
  std::optional<double> grinding_ratio;
  std::optional<double> residual_height_max_um;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a wheel narrower
/// than the bore is long.
[[nodiscard]] CutPlan plan(const InternalGrinding& spec, const PlanContext& context);

}  // namespace verstat::operations
