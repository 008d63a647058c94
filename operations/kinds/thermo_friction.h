#pragma once
// Operation kind "thermo_friction": a flat steel surface machined with a smooth rotating disc that heats and
// carries off the layer (K305). Fast for a rough cut; what it hands to the next operation, a rough, hardened
// and stressed layer, decides how much that one must take.

#include "models/treatment/k305_thermo_friction_surface.h"
#include "operations/kind.h"

namespace verstat::operations {

/// What becomes of the hardened layer in the next operation.
enum class HardenedLayer { removed, kept };

struct ThermoFriction {
  static constexpr const char* kind = "thermo_friction";
  double length_mm = 0;
  double part_width_mm = 0;
  double stock_mm = 0;
  models::k305::Steel steel = models::k305::Steel::steel_45;
  double disc_width_mm = 0;  ///< of a pass
  double overlap_mm = 0;
  double run_in_out_mm = 0;
  double depth_of_cut_mm = 0;
  double feed_mm_min = 0;
  double spindle_speed_rpm = 0;
  double disc_diameter_mm = 500;
  std::optional<double> specific_energy_j_mm3;  ///< adds the power
  double drive_power_kw = 14;
  double efficiency = 0.8;
  double roughness_rz_um = 80;     ///< left behind (published 40 to 80)
  double hardening_factor = 1.4;   ///< at the surface (published 1.3 to 1.5)
  double hardened_depth_um = 500;  ///< published
  double stress_level = 0.5;       ///< within the published ranges, 0 mild to 1 severe
  HardenedLayer hardened_layer = HardenedLayer::removed;
  double positioning_error_um = 0;          ///< of the next operation
  std::optional<double> next_allowance_mm;  ///< that the next operation takes
  std::optional<double> surface_stress_max_mpa;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const ThermoFriction& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::HardenedLayer> {
  static constexpr std::array names{std::pair{operations::HardenedLayer::removed, "removed"},
                                    std::pair{operations::HardenedLayer::kept, "kept"}};
};
