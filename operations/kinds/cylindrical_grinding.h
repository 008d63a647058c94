#pragma once
// Operation kind "cylindrical_grinding": a shaft ground outside in roughing and finishing passes and
// spark-out, along the part (traverse) or straight in (plunge: a pass is one revolution).
//
// Roughness and heat-affected layer from K302, temperature from the moving heat source of K118 with the
// specific grinding energy (COMPLETION). How the traverse feed comes to its value: K207.

#include <cstdint>

#include "operations/dressing.h"
#include "operations/kind.h"

namespace verstat::operations {

/// Electrochemical dissolution in the grinding zone, K302 completion C3.
struct ElectrochemicalAid {
  double voltage_v = 0;
  double gap_um = 0;
  double exposure_s = 0;
  double conductivity_s_m = 0;
  double efficiency = 1;
  double volume_equivalent_mm3_a_min = 2.21;
};

/// Digital controller that brings the traverse feed to its set value, K207: one sample is one pass.
struct FeedController {
  double feed_from_m_min = 0;  ///< of the passes before this operation
  double plant_gain = 1;       ///< of the drive; falls as it wears
  double plant_pole = 0.9091867638508087;
  std::int64_t delay = 2;  ///< dead time, samples
};

struct CylindricalGrinding : GrainProtrusion {
  static constexpr const char* kind = "cylindrical_grinding";
  // part
  double diameter_mm = 0;
  double length_mm = 0;
  double allowance_um = 0;       // on the radius
  double initial_defect_um = 0;  // heat-affected layer the part comes with
  double transform_c = 0;        // phase transformation of the steel
  double ambient_c = 20;
  double conductivity_w_mk = 0;
  double diffusivity_m2_s = 0;
  // regime
  double work_speed_m_min = 0;
  double rough_infeed_um = 0;      // per pass
  double finish_infeed_um = 0;     // per pass
  double finish_allowance_um = 0;  // of the allowance
  std::int64_t sparkout_passes = 0;
  std::optional<double> traverse_feed_mm_rev;  // absent: plunge
  double overrun_mm = 0;
  std::optional<FeedController> feed_controller;  // traverse only; absent: the feed is there at once
  bool up_grinding = true;
  double specific_energy_j_mm3 = 0;
  double heat_fraction = 0.6;
  std::optional<ElectrochemicalAid> electrochemical;
  // wheel
  double wheel_diameter_mm = 0;
  double wheel_width_mm = 0;
  double wheel_speed_m_s = 0;
  double profile_exponent = 0.5;
  double tip_exponent = 1.5;
  double chip_coefficient = 0.9;
  double width_coefficient = 0.283;
  double grains_per_mm2 = 20;
  double wheel_layer_mm = 0.03;
  std::optional<double> grinding_ratio;
  // limits
  std::optional<double> roughness_ra_max_um;
  std::optional<double> defect_depth_max_um;
  std::optional<double> temperature_max_c;
  double base_length_mm = 0.8;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for allowances, feeds
/// and widths that contradict each other.
[[nodiscard]] CutPlan plan(const CylindricalGrinding& spec, const PlanContext& context);

}  // namespace verstat::operations
