#pragma once
// Operation kind "auger_winding": a strip bent on edge and wound into the tight coil of a screw flight, then
// stretched to its pitch (K306). Coils of springs are wound likewise; the paper treats flights.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

struct AugerWinding {
  static constexpr const char* kind = "auger_winding";
  double outer_diameter_mm = 0;
  double inner_diameter_mm = 0;
  double pitch_mm = 0;
  double length_mm = 0;           ///< of the screw
  double inner_thickness_mm = 0;  ///< that the inner edge must keep
  double force_radius_factor = 1.5;
  double trim_widths = 4;  ///< strip ends that are cut off, in strip widths
  double spindle_speed_rpm = 0;
  std::int64_t turns_per_winding = 15;
  double setup_min = 0;  ///< of every winding
  double flow_stress_mpa = 0;
  double friction = 0.15;
  double clamp_turns = 3;                     ///< that the spring clamp holds
  double clamp_factor = 0.6;                  ///< k1
  std::optional<double> strip_thickness_mm;   ///< at hand; not given: the one that is needed
  std::optional<double> mandrel_length_mm;    ///< that the coil must fit on
  std::optional<double> winding_force_max_n;  ///< of the machine
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const AugerWinding& spec, const PlanContext& context);

}  // namespace verstat::operations
