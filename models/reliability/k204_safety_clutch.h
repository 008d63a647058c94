#pragma once
// Safety clutches of drives (K204): how far the torque overshoots when the clutch trips, how exactly and how
// long it keeps its setting, the window for the setting, and the stop event that an overload causes.
//
// Hevko 2011: a test-stand study. The ranges of the coefficients, the dynamic factors at some speeds and the
// 170 rpm limit are measured; the rest completes them into a stop-event model. Torque in N*m, speed in rpm,
// time in min, cost in currency units (cu); flags are 0 or 1.

#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k204 {

enum class Clutch { cone, ball_round, ball_triangle, ball_pentagon };

struct ClutchType {
  Clutch clutch = Clutch::cone;
};
struct ClutchCoefficients {
  double accuracy_min, accuracy_max;
  double sensitivity_min, sensitivity_max;
  double stability_min, stability_max;
  double frequency_min, frequency_max;
  double auto_reengage_limit_rpm;  // 0 = none
};
/// Published ranges of the coefficients. The tripping frequency of the cone clutch is not published: 1.
[[nodiscard]] ClutchCoefficients clutch_coefficients(const ClutchType& in);

struct ClutchSpeed : ClutchType {
  double speed_rpm = 0;
};
struct DynamicFactor {
  double k_d;
};
/// Dynamic factor, piecewise linear through (0, 1) and the published points, last segment extrapolated;
/// 0..600 rpm. COMPLETION (interpolation).
[[nodiscard]] DynamicFactor clutch_dynamic_factor(const ClutchSpeed& in);

struct InertialDrive {
  double speed_rpm = 0;
  double trip_torque_nm = 0;
  double inertia_kg_m2 = 0;
  double torsional_stiffness_nm_rad = 0;
};
/// Dynamic factor from stored kinetic energy, K_d = 1 + omega sqrt(J c) / T. COMPLETION.
[[nodiscard]] DynamicFactor clutch_dynamic_factor_inertial(const InertialDrive& in);

struct Setting {
  double set_torque_nm = 0;
  double accuracy = 1;
};
struct TripBand {
  double t_min_nm, t_max_nm, t_mean_nm, sigma_nm;
};
/// Band of the trip torque: T_min = 2 T / (1 + K_T), T_max = K_T T_min, sigma a sixth of its width.
/// COMPLETION.
[[nodiscard]] TripBand clutch_trip_band(const Setting& in);

struct DriftInputs {
  double set_torque_nm = 0;
  double stability = 1;
  double trips = 0;
  double reference_trips = 100;
};
struct SetTorque {
  double set_torque_nm;
};
/// Setting after N trips, T K_s^(N / N_ref). COMPLETION.
[[nodiscard]] SetTorque clutch_set_torque_drift(const DriftInputs& in);

struct SensitivityInputs {
  double set_torque_nm = 0;
  double sensitivity = 1;
};
struct ReengageTorque {
  double reengage_torque_nm;
};
/// Torque below which the clutch re-engages, K_ch T. COMPLETION.
[[nodiscard]] ReengageTorque clutch_reengage_torque(const SensitivityInputs& in);

struct WindowInputs {
  double work_peak_torque_nm = 0;
  double allowable_torque_nm = 0;
  double accuracy = 1;
  double dynamic_factor = 1;
  double drift_factor = 1;
};
struct SettingWindow {
  double set_min_nm, set_max_nm;
  int feasible;
  double required_overload_ratio;
};
/// Settings without false trips and with the drive protected, equation (e).
[[nodiscard]] SettingWindow clutch_setting_window(const WindowInputs& in);

struct MaxSpeedInputs : ClutchType {
  double work_peak_torque_nm = 0;
  double allowable_torque_nm = 0;
  double accuracy = 1;
  double drift_factor = 1;
};
struct MaxSpeed {
  double speed_rpm;
};
/// Highest speed with a non-empty window, at most 600; 0 if none. Says nothing about re-engagement.
[[nodiscard]] MaxSpeed clutch_max_speed(const MaxSpeedInputs& in);

struct SpikeInputs {
  double cutting_torque_nm = 0;
  double spike_mean_ratio = 0;
  double set_torque_nm = 0;
  double accuracy = 1;
  double dynamic_factor = 1;
  double break_torque_nm = 0;
};
struct SpikeOutcome {
  double p_trip, p_trip_safe, p_break, p_break_no_clutch;
};
/// Probabilities per spike, equation (f): the demand T_c (1 + X), X exponential, meets a normal threshold.
/// COMPLETION. 1 < K_T <= 1.5.
[[nodiscard]] SpikeOutcome overload_spike_outcome(const SpikeInputs& in);

struct CostRateInputs {
  double spike_rate_per_min = 0;
  double p_trip_safe = 0;
  double p_break = 0;
  double trip_cost = 0;
  double break_cost = 0;
  double trip_downtime_min = 0;
  double break_downtime_min = 0;
};
struct CostRate {
  double trips_per_min, breaks_per_min, cost_per_cut_min, availability;
};
/// Rates per minute of cutting and availability 1 / (1 + sum rate * downtime), renewal-reward.
[[nodiscard]] CostRate clutch_cost_rate(const CostRateInputs& in);

struct OptimumInputs {
  double cutting_torque_nm = 0;
  double spike_mean_ratio = 0;
  double accuracy = 1;
  double dynamic_factor = 1;
  double break_torque_nm = 0;
  double trip_cost = 0;
  double break_cost = 0;
};
struct OptimalSetting {
  double set_torque_nm;
  double cost_per_spike;
};
/// Setting in [T_c (1 + K_T) / 2, T_b] with the least expected cost per spike; error unless T_b lies above
/// the lower end. The optimum may be T_b: then the clutch does not pay.
[[nodiscard]] OptimalSetting optimal_clutch_setting(const OptimumInputs& in);

struct GrowthInputs {
  double initial_torque_nm = 0;
  double torque_growth_per_min = 0;
  double set_torque_nm = 0;
  double accuracy = 1;
};
struct GrowthTripTime {
  double t_first_min, t_mean_min, t_last_min;
};
/// Cutting time until torque growing with tool wear trips the clutch; 0 if it is already above.
[[nodiscard]] GrowthTripTime torque_growth_trip_time(const GrowthInputs& in);

struct StopInputs : ClutchSpeed {
  double overload_clear_min = 0;
  double detect_min = 0;
  double manual_reset_min = 0;
  double restart_min = 0;
  double frequency = 1;
};
struct StopEvent {
  int auto_reengage;
  double downtime_min;
  std::int64_t impacts;
};
/// Downtime and impacts of one overload stop, equation (j). Polygon-slot clutches stay open above 170 rpm.
[[nodiscard]] StopEvent clutch_stop_event(const StopInputs& in);

struct TestSeries {
  std::vector<double> static_trip_nm;
  std::vector<double> dynamic_peak_nm;
  std::vector<double> reengage_nm;
  std::vector<double> static_trip_after_nm;
  std::vector<double> idle_revolutions;
};
struct TestMetrics {
  double k_d, k_accuracy, k_sensitivity, k_stability, k_frequency;
};
/// Coefficients of an own test series; lists may differ in length. Equation (l).
[[nodiscard]] TestMetrics clutch_test_metrics(const TestSeries& in);

struct Motor {
  double power_kw = 0;
  double speed_rpm = 0;
};
struct Torque {
  double torque_nm;
};
/// T = P / omega.
[[nodiscard]] Torque motor_torque(const Motor& in);

struct Pocket {
  double spring_force_n = 0;
  double element_radius_mm = 0;
  double pocket_angle_deg = 0;
  double friction_coefficient = 0;
};
struct StaticTrip {
  std::optional<double> torque_nm;
  int self_locking;
};
/// Static trip torque of a pin or ball in a pocket, F R tan(alpha + arctan mu); none when self-locking.
/// COMPLETION. Friction of the sliding flange is left out.
[[nodiscard]] StaticTrip clutch_static_trip_torque(const Pocket& in);

}  // namespace verstat::models::k204

template <>
struct verstat::models::EnumNames<verstat::models::k204::Clutch> {
  static constexpr std::array names{std::pair{k204::Clutch::cone, "cone"},
                                    std::pair{k204::Clutch::ball_round, "ball_round"},
                                    std::pair{k204::Clutch::ball_triangle, "ball_triangle"},
                                    std::pair{k204::Clutch::ball_pentagon, "ball_pentagon"}};
};
