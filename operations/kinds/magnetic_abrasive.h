#pragma once
// Operation kind "magnetic_abrasive": the bore of a sleeve bearing finished with ferro-abrasive grains
// (K309). The tracks of the grains must cover the surface; inside the published window of settings the
// roughness is known.

#include <cstdint>

#include "models/treatment/k309_grain_trajectory.h"
#include "operations/kind.h"

namespace verstat::operations {

struct MagneticAbrasive {
  static constexpr const char* kind = "magnetic_abrasive";
  models::k309::BearingMaterial material = models::k309::BearingMaterial::nickel_composite;
  double diameter_mm = 0;
  double width_mm = 0;
  double surface_speed_m_min = 0;
  double feed_mm_min = 0;  ///< axial
  double grain_size_um = 150;
  double gap_mm = 1;          ///< between pole and part
  double amplitude_mm = 1.5;  ///< of the axial oscillation
  std::int64_t grains = 10;   ///< in a row along the axis
  double grain_spacing_mm = 0.2;
  double groove_width_mm = 0.08;  ///< of a scratch
  std::int64_t passes = 4;
  double time_constant_min = 1;        ///< of the fall of roughness; to be measured
  std::optional<double> ra_before_um;  ///< not given: as the paper ground the material
  double part_life_factor = 1;         ///< of the bearing in service; to be measured
  std::optional<double> ra_max_um;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const MagneticAbrasive& spec, const PlanContext& context);

}  // namespace verstat::operations
