#pragma once
// Operation kind "cutting_off": a bar or pipe parted with an abrasive wheel (K104). Besides the usual upper
// bounds the radial feed has a lower one: below it the grains on the wheel's sides rub instead of cutting and
// burn the kerf walls.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

struct CuttingOff {
  static constexpr const char* kind = "cutting_off";
  double workpiece_diameter_mm = 0;
  double wheel_diameter_mm = 400;
  double wheel_thickness_mm = 4;
  double wheel_speed_m_s = 0;
  double radial_feed_mm_s = 0;
  double side_grains_per_mm2 = 0;
  double grain_tip_radius_mm = 0.05;
  double chip_coefficient = 0.8;
  double relative_depth_min = 0.08;  ///< of the side grains over their tip radius: 0.08 cuts, 0.04 still rubs
  double part_length_mm = 0;         ///< of the piece that is parted
  std::optional<double> specific_energy_j_mm3;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const CuttingOff& spec, const PlanContext& context);

}  // namespace verstat::operations
