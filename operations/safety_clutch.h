#pragma once
// The safety clutch of a machine's drive and the torque spikes it meets (K204): a member of MachineLimits.
// What it does to an operation stands in CutPlan::overload; the shop lets it trip and resets it.

#include <optional>

namespace verstat::models::k204 {
enum class Clutch;
}

namespace verstat::operations {

struct CutPlan;

/// Torque N m at the clutch, which turns with the spindle unless shaft_speed_rpm is given: then torque is
/// carried over in inverse proportion to speed.
struct SafetyClutch {
  models::k204::Clutch clutch = {};  ///< cone
  double set_torque_nm = 0;
  double accuracy = 1.1;          ///< K_T: largest over smallest trip torque, 1 < K_T <= 1.5
  double stability = 1;           ///< K_s: setting left after reference_trips
  double trips = 0;               ///< since it was set
  double break_torque_nm = 0;     ///< of the weakest element of the drive or the tool
  double spike_rate_per_min = 0;  ///< of cutting
  double spike_mean_ratio = 0.4;  ///< mean height of a spike over the cutting torque
  std::optional<double> shaft_speed_rpm;
  double overload_clear_min = 0;  ///< until the demand has fallen
  double detect_min = 0;          ///< until somebody sees the open clutch
  double manual_reset_min = 0;
  double restart_min = 0;  ///< run-up and return to the cut
};

/// The setting with the least expected cost per spike for this plan's torque and speed, N m at the clutch, in
/// [T_c (1 + K_T) / 2, T_b]. At T_b the clutch does not pay. K204.optimal_clutch_setting.
/// Costs >= 0 in one currency. Throws models::ModelError, models::DomainError for a plan without torque.
[[nodiscard]] double optimal_setting_nm(const SafetyClutch& clutch, const CutPlan& plan, double trip_cost,
                                        double break_cost);

/// Fills in plan.overload, its quantities and the limit on the setting, for a plan that tells its torque and
/// speed; else nothing.
void add_overload(CutPlan& plan, const SafetyClutch& clutch);

}  // namespace verstat::operations
