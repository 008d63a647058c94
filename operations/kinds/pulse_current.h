#pragma once
// Operation kind "pulse_current": a surface coated or welded spot by spot with current pulses through real
// contact spots (K310). Hot enough to bond, not so hot that the spot boils; the set-up must make the pulse.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

struct PulseCurrent {
  static constexpr const char* kind = "pulse_current";
  double area_mm2 = 0;
  double spot_area_mm2 = 0;  ///< treated by one pulse
  double overlap = 0.3;
  std::int64_t pulses_per_spot = 1;
  double frequency_hz = 0;
  double current_a = 0;
  double pulse_us = 0;
  double generator_voltage_v = 0;
  double resistivity_uohm_m = 0;  ///< mean of electrode and part
  double contact_radius_um = 0;   ///< of a real contact spot
  std::int64_t contacts = 1;      ///< real contact spots under the electrode
  double body_temperature_c = 20;
  double bonding_temperature_c = 0;  ///< that the spot must reach
  double boiling_temperature_c = 0;  ///< that it must not
  /// What the coating is worth: K310 has no data, so it is given. For a lot of tools or for the part itself.
  double life_factor = 1;
  models::LifeLawKind life_law = models::LifeLawKind::weibull;
  double life_cv = 0.7;
  double breakage_fraction = 0;
  double cost_per_piece = 0;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const PulseCurrent& spec, const PlanContext& context);

}  // namespace verstat::operations
