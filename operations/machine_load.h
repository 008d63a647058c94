#pragma once
// What an operation asks of the machine, held against what the machine can do.

#include <optional>

#include "operations/kind.h"

namespace verstat::operations {

/// Members that a kind cannot tell stay empty: their limits are not set.
struct MachineLoad {
  std::optional<double> power_kw;
  std::optional<double> spindle_speed_rpm;
  std::optional<double> torque_nm;
  std::optional<double> feed_force_n;
  std::optional<double> feed_rate_mm_min;
};

/// Adds a limit for every member that both the load and the machine (may be null) have.
void add_machine_limits(CutPlan& plan, const MachineLimits* machine, const MachineLoad& load);

/// Specific cutting force of Kienzle, k_c = k_c1.1 h^-m_c, in N/mm2 for a chip thickness in mm, both > 0.
/// Textbook relation.
[[nodiscard]] double kienzle_n_mm2(double kc11_mpa, double mc, double chip_thickness_mm);

}  // namespace verstat::operations
