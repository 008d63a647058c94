#pragma once
// Operation kind "blade_finishing": milled titanium compressor blades polished, and hardened ultrasonically
// with balls or vibropolished (K312). What changes is the roughness and above all the endurance limit and its
// scatter: from them follows how many blades fail in service.

#include <cstdint>

#include "models/treatment/k312_blade_finishing.h"
#include "operations/kind.h"

namespace verstat::operations {

struct BladeFinishing {
  static constexpr const char* kind = "blade_finishing";
  models::k312::Finish variant = models::k312::Finish::medium;
  double polishing_min = 0;       ///< by hand or belt, per blade
  double vibropolishing_min = 0;  ///< per batch
  double handling_min = 0;        ///< per batch
  std::int64_t batch_size = 1;    ///< hardened or vibropolished together
  double ra_max_um = 0.4;
  std::optional<double> working_stress_mpa;  ///< amplitude in service, mean
  double working_stress_sd_mpa = 0;
  double reliability = 0.99;                      ///< of the guaranteed endurance limit
  std::optional<double> failure_probability_max;  ///< in service
  std::optional<double> endurance_limit_min_mpa;  ///< guaranteed
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError where a limit needs
/// the endurance limit of vibropolishing, which was not tested.
[[nodiscard]] CutPlan plan(const BladeFinishing& spec, const PlanContext& context);

}  // namespace verstat::operations
