#include "operations/machine_load.h"

#include <cmath>

namespace verstat::operations {

namespace {

void at_most(CutPlan& plan, const char* name, double value, const std::optional<double>& allowed,
             const char* unit, const char* origin) {
  if (allowed) plan.limits.push_back({name, value, *allowed, true, unit, origin});
}
void at_least(CutPlan& plan, const char* name, double value, const std::optional<double>& allowed,
              const char* unit, const char* origin) {
  if (allowed) plan.limits.push_back({name, value, *allowed, false, unit, origin});
}

}  // namespace

void limit_power(CutPlan& plan, const PlanContext& context, double power_kw, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "power_kw", power_kw, context.machine->power_kw, "kW", origin);
}

void limit_torque(CutPlan& plan, const PlanContext& context, double torque_nm, const char* origin) {
  plan.spindle.torque_nm = torque_nm;
  if (context.machine != nullptr)
    at_most(plan, "torque_nm", torque_nm, context.machine->torque_max_nm, "N m", origin);
}

void limit_spindle_speed(CutPlan& plan, const PlanContext& context, double lowest_rpm, double highest_rpm,
                         const char* origin) {
  plan.spindle.speed_low_rpm = lowest_rpm;
  plan.spindle.speed_high_rpm = highest_rpm;
  if (context.machine == nullptr) return;
  at_most(plan, "spindle_speed_max_rpm", highest_rpm, context.machine->spindle_speed_max_rpm, "rpm", origin);
  at_least(plan, "spindle_speed_min_rpm", lowest_rpm, context.machine->spindle_speed_min_rpm, "rpm", origin);
}

void limit_feed_force(CutPlan& plan, const PlanContext& context, double force_n, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "feed_force_n", force_n, context.machine->feed_force_max_n, "N", origin);
}

void limit_feed_rate(CutPlan& plan, const PlanContext& context, double rate_mm_min, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "feed_rate_mm_min", rate_mm_min, context.machine->feed_rate_max_mm_min, "mm/min", origin);
}

void add_machine_limits(CutPlan& plan, const PlanContext& context, const MachineLoad& load) {
  constexpr const char* origin = "machine";
  if (load.power_kw) limit_power(plan, context, *load.power_kw, origin);
  if (load.spindle_speed_rpm) limit_spindle_speed(plan, context, *load.spindle_speed_rpm, origin);
  if (load.torque_nm) limit_torque(plan, context, *load.torque_nm, origin);
  if (load.feed_force_n) limit_feed_force(plan, context, *load.feed_force_n, origin);
  if (load.feed_rate_mm_min) limit_feed_rate(plan, context, *load.feed_rate_mm_min, origin);
}

void add_machine_limits(CutPlan& plan, const PlanContext& context, const WheelLoad& wheel) {
  plan.spindle.speed_low_rpm = plan.spindle.speed_high_rpm = wheel.wheel_rpm;
  plan.spindle.wheel_diameter_mm = wheel.diameter_mm;
  plan.spindle.work_speed_m_min = wheel.work_speed_m_min;
  plan.spindle.infeed_mm = wheel.infeed_mm;
  plan.spindle.normal_force_n = wheel.normal_force_n;
  if (context.machine == nullptr) return;
  constexpr const char* origin = "machine";
  const MachineLimits& m = *context.machine;
  if (wheel.power_kw) limit_power(plan, context, *wheel.power_kw, origin);
  at_most(plan, "wheel_speed_rpm", wheel.wheel_rpm, m.spindle_speed_max_rpm, "rpm", origin);
  at_least(plan, "wheel_speed_rpm", wheel.wheel_rpm, m.spindle_speed_min_rpm, "rpm", origin);
  limit_feed_rate(plan, context, wheel.feed_rate_mm_min, origin);
}

double kienzle_n_mm2(double kc11_mpa, double mc, double chip_thickness_mm) {
  return kc11_mpa * std::pow(chip_thickness_mm, -mc);
}

}  // namespace verstat::operations
