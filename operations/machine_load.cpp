#include "operations/machine_load.h"

#include <cmath>

namespace verstat::operations {

namespace {

constexpr const char* machine_origin = "machine";

void at_most(CutPlan& plan, const char* name, const char* unit, const std::optional<double>& value,
             const std::optional<double>& allowed) {
  if (value && allowed) plan.limits.push_back({name, *value, *allowed, true, unit, machine_origin});
}

}  // namespace

void add_machine_limits(CutPlan& plan, const MachineLimits* machine, const MachineLoad& load) {
  if (machine == nullptr) return;
  at_most(plan, "power_kw", "kW", load.power_kw, machine->power_kw);
  at_most(plan, "spindle_speed_max_rpm", "rpm", load.spindle_speed_rpm, machine->spindle_speed_max_rpm);
  if (load.spindle_speed_rpm && machine->spindle_speed_min_rpm)
    plan.limits.push_back({"spindle_speed_min_rpm", *load.spindle_speed_rpm, *machine->spindle_speed_min_rpm,
                           false, "rpm", machine_origin});
  at_most(plan, "torque_nm", "N m", load.torque_nm, machine->torque_max_nm);
  at_most(plan, "feed_force_n", "N", load.feed_force_n, machine->feed_force_max_n);
  at_most(plan, "feed_rate_mm_min", "mm/min", load.feed_rate_mm_min, machine->feed_rate_max_mm_min);
}

double kienzle_n_mm2(double kc11_mpa, double mc, double chip_thickness_mm) {
  return kc11_mpa * std::pow(chip_thickness_mm, -mc);
}

}  // namespace verstat::operations
