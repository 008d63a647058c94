#pragma once
// What a plan asks of the machine, as limits: each is added only when the machine states its ability.

#include "operations/kind.h"

namespace verstat::operations {

/// Spindle power drawn, kW. `origin` says where the number comes from.
void limit_power(CutPlan& plan, const PlanContext& context, double power_kw, const char* origin);
/// Spindle torque, N m.
void limit_torque(CutPlan& plan, const PlanContext& context, double torque_nm, const char* origin);
/// Spindle speeds that the operation runs through, rpm: the lowest and the highest.
void limit_spindle_speed(CutPlan& plan, const PlanContext& context, double lowest_rpm, double highest_rpm,
                         const char* origin);
/// One spindle speed, rpm.
inline void limit_spindle_speed(CutPlan& plan, const PlanContext& context, double speed_rpm,
                                const char* origin) {
  limit_spindle_speed(plan, context, speed_rpm, speed_rpm, origin);
}
/// Force against the feed drive, N.
void limit_feed_force(CutPlan& plan, const PlanContext& context, double force_n, const char* origin);
/// Feed rate, mm/min.
void limit_feed_rate(CutPlan& plan, const PlanContext& context, double rate_mm_min, const char* origin);

}  // namespace verstat::operations
