#pragma once
// What an operation asks of the machine, held against what the machine can do. A limit is added when the
// machine states its ability; what the spindle has to bear is noted in the plan either way.

#include <optional>

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

/// All of them at once, for kinds that work them out together. Members that a kind cannot tell stay empty.
struct MachineLoad {
  std::optional<double> power_kw;
  std::optional<double> spindle_speed_rpm;
  std::optional<double> torque_nm;
  std::optional<double> feed_force_n;
  std::optional<double> feed_rate_mm_min;
};
void add_machine_limits(CutPlan& plan, const PlanContext& context, const MachineLoad& load);

/// A grinding wheel on the machine's spindle.
struct WheelLoad {
  double wheel_rpm = 0;
  double diameter_mm = 0;  ///< on a flat face; equivalent diameter for round parts
  double work_speed_m_min = 0;
  double infeed_mm = 0;
  double feed_rate_mm_min = 0;
  std::optional<double> power_kw;
  double normal_force_n = 0;  ///< 0: not known
};
void add_machine_limits(CutPlan& plan, const PlanContext& context, const WheelLoad& wheel);

/// Specific cutting force of Kienzle, k_c = k_c1.1 h^-m_c, in N/mm2 for a chip thickness in mm, both > 0.
/// COMPLETION (textbook).
[[nodiscard]] double kienzle_n_mm2(double kc11_mpa, double mc, double chip_thickness_mm);

}  // namespace verstat::operations
