#include "operations/against_machine.h"

namespace verstat::operations {

namespace {

void at_most(CutPlan& plan, const char* name, double value, const std::optional<double>& allowed,
             const char* unit, const char* origin) {
  if (allowed) plan.limits.push_back({name, value, *allowed, true, unit, origin});
}

}  // namespace

void limit_power(CutPlan& plan, const PlanContext& context, double power_kw, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "power_kw", power_kw, context.machine->power_kw, "kW", origin);
}

void limit_torque(CutPlan& plan, const PlanContext& context, double torque_nm, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "torque_nm", torque_nm, context.machine->torque_max_nm, "N m", origin);
}

void limit_spindle_speed(CutPlan& plan, const PlanContext& context, double lowest_rpm, double highest_rpm,
                         const char* origin) {
  if (context.machine == nullptr) return;
  at_most(plan, "spindle_speed_max_rpm", highest_rpm, context.machine->spindle_speed_max_rpm, "rpm", origin);
  if (context.machine->spindle_speed_min_rpm)
    plan.limits.push_back(
        {"spindle_speed_min_rpm", lowest_rpm, *context.machine->spindle_speed_min_rpm, false, "rpm", origin});
}

void limit_feed_force(CutPlan& plan, const PlanContext& context, double force_n, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "feed_force_n", force_n, context.machine->feed_force_max_n, "N", origin);
}

void limit_feed_rate(CutPlan& plan, const PlanContext& context, double rate_mm_min, const char* origin) {
  if (context.machine != nullptr)
    at_most(plan, "feed_rate_mm_min", rate_mm_min, context.machine->feed_rate_max_mm_min, "mm/min", origin);
}

}  // namespace verstat::operations
