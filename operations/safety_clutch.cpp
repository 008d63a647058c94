#include "operations/safety_clutch.h"

#include <algorithm>
#include <cmath>

#include "models/reliability/k204_safety_clutch.h"
#include "operations/fields.h"

namespace verstat::models {

std::vector<Field> StructFields<operations::SafetyClutch>::fields() {
  using S = operations::SafetyClutch;
  return {
      may<S>(&S::clutch, "clutch", "-", no_range(), "design of the clutch"),
      need<S>(&S::set_torque_nm, "set_torque_nm", "N m", open_low(0, 1e7), "mean static trip torque"),
      may<S>(&S::accuracy, "accuracy", "1", open_low(1, 1.5), "largest over smallest trip torque"),
      may<S>(&S::stability, "stability", "1", open_low(0, 1), "share of the setting left after 100 trips"),
      may<S>(&S::trips, "trips", "1", closed(0, 1e6), "trips since it was set"),
      need<S>(&S::break_torque_nm, "break_torque_nm", "N m", open_low(0, 1e7),
              "torque that breaks the weakest element"),
      need<S>(&S::spike_rate_per_min, "spike_rate_per_min", "1/min", closed(0, 1e4),
              "torque spikes per minute of cutting"),
      may<S>(&S::spike_mean_ratio, "spike_mean_ratio", "1", closed(0.05, 2),
             "mean height of a spike over the cutting torque"),
      may<S>(&S::shaft_speed_rpm, "shaft_speed_rpm", "rpm", open_low(0, 600),
             "speed of the shaft it sits on, when it is not the spindle"),
      may<S>(&S::overload_clear_min, "overload_clear_min", "min", closed(0, 1e5),
             "time until the overload is gone"),
      may<S>(&S::detect_min, "detect_min", "min", closed(0, 1e5), "time until the stop is seen"),
      may<S>(&S::manual_reset_min, "manual_reset_min", "min", closed(0, 1e5), "time of a reset by hand"),
      may<S>(&S::restart_min, "restart_min", "min", closed(0, 1e5), "run-up and return to the cut")};
}

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k204 = models::k204;

struct AtClutch {
  double torque_nm;
  double speed_rpm;
  double dynamic_factor;
};

AtClutch at_clutch(const SafetyClutch& clutch, const CutPlan& plan) {
  const double spindle_rpm = plan.spindle.speed_high_rpm;
  const double speed_rpm = clutch.shaft_speed_rpm.value_or(spindle_rpm);
  models::require(speed_rpm <= 600, "machine_limits/safety_clutch/shaft_speed_rpm", speed_rpm,
                  "is the spindle's own and above 600: give the speed of the shaft that the clutch sits on");
  return {plan.spindle.torque_nm * spindle_rpm / speed_rpm, speed_rpm,
          k204::clutch_dynamic_factor({{clutch.clutch}, speed_rpm}).k_d};
}

}  // namespace

double optimal_setting_nm(const SafetyClutch& clutch, const CutPlan& plan, double trip_cost,
                          double break_cost) {
  models::require(plan.spindle.torque_nm > 0 && plan.spindle.speed_high_rpm > 0, "torque_nm",
                  plan.spindle.torque_nm, "must be known and above 0 to set a clutch");
  const AtClutch at = at_clutch(clutch, plan);
  return k204::optimal_clutch_setting({.cutting_torque_nm = at.torque_nm,
                                       .spike_mean_ratio = clutch.spike_mean_ratio,
                                       .accuracy = clutch.accuracy,
                                       .dynamic_factor = at.dynamic_factor,
                                       .break_torque_nm = clutch.break_torque_nm,
                                       .trip_cost = trip_cost,
                                       .break_cost = break_cost})
      .set_torque_nm;
}

void add_overload(CutPlan& plan, const SafetyClutch& clutch) {
  if (plan.spindle.torque_nm <= 0 || plan.spindle.speed_high_rpm <= 0) return;
  const AtClutch at = at_clutch(clutch, plan);
  const double set_nm =
      k204::clutch_set_torque_drift(
          {.set_torque_nm = clutch.set_torque_nm, .stability = clutch.stability, .trips = clutch.trips})
          .set_torque_nm;
  const auto spike = k204::overload_spike_outcome({.cutting_torque_nm = at.torque_nm,
                                                   .spike_mean_ratio = clutch.spike_mean_ratio,
                                                   .set_torque_nm = set_nm,
                                                   .accuracy = clutch.accuracy,
                                                   .dynamic_factor = at.dynamic_factor,
                                                   .break_torque_nm = clutch.break_torque_nm});
  k204::StopInputs stop;
  stop.clutch = clutch.clutch;
  stop.speed_rpm = at.speed_rpm;
  stop.overload_clear_min = clutch.overload_clear_min;
  stop.detect_min = clutch.detect_min;
  stop.manual_reset_min = clutch.manual_reset_min;
  stop.restart_min = clutch.restart_min;
  const auto event = k204::clutch_stop_event(stop);

  constexpr const char* origin = "K204.overload_spike_outcome; COMPLETION: spikes at a constant rate";
  const double spikes = clutch.spike_rate_per_min * plan.main_time_min;
  Overload o;
  o.trips_per_part = spikes * spike.p_trip_safe;
  o.breaks_per_part = spikes * spike.p_break;
  o.trip_probability = -std::expm1(-o.trips_per_part);
  o.break_probability = -std::expm1(-o.breaks_per_part);
  o.reset_min = event.downtime_min;
  o.self_reset = event.auto_reengage != 0;
  o.origin = origin;
  plan.overload = o;
  auto& q = plan.quantities;
  q.push_back({"clutch_torque_nm", at.torque_nm, "N m", "definition", "cutting torque at the safety clutch"});
  q.push_back(
      {"clutch_setting_nm", set_nm, "N m", "K204.clutch_set_torque_drift", "trip torque after drift"});
  q.push_back({"overload_probability", o.trip_probability, "1", origin,
               "probability that the clutch stops the machine within a part"});
  q.push_back({"overload_break_probability", o.break_probability, "1", origin,
               "probability that a spike breaks the tool or the drive in spite of it"});
  q.push_back({"overload_break_probability_no_clutch", -std::expm1(-spikes * spike.p_break_no_clutch), "1",
               origin, "the same without a clutch"});
  q.push_back({"overload_reset_min", o.reset_min, "min", "K204.clutch_stop_event", "downtime of one stop"});
  const auto window = k204::clutch_setting_window({.work_peak_torque_nm = at.torque_nm,
                                                   .allowable_torque_nm = clutch.break_torque_nm,
                                                   .accuracy = clutch.accuracy,
                                                   .dynamic_factor = at.dynamic_factor,
                                                   .drift_factor = set_nm / clutch.set_torque_nm});
  plan.limits.push_back({"clutch_setting_nm", clutch.set_torque_nm, window.set_min_nm, false, "N m",
                         "K204.clutch_setting_window: no trips in normal work"});
  plan.limits.push_back({"clutch_setting_nm", clutch.set_torque_nm, window.set_max_nm, true, "N m",
                         "K204.clutch_setting_window: the drive stays whole"});
}

}  // namespace verstat::operations
