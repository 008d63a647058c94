#pragma once
// Operation kind "drill_finishing": the flanks and edges of twist drills finished in the ring bath of a
// magnetic-abrasive machine (K208). How the drill is held and carried round decides how evenly the powder
// attacks its flanks; the plan hands a treated lot on (K103).

#include <cstdint>

#include "models/treatment/k103_magneto_abrasive_drills.h"
#include "models/treatment/k208_drill_flank_kinematics.h"
#include "operations/kind.h"

namespace verstat::operations {

struct DrillFinishing {
  static constexpr const char* kind = "drill_finishing";
  models::k208::Drill drill;
  models::k208::Bath bath;
  models::k103::Powder powder = models::k103::Powder::polimam_t_plus_10_pr_r6m5;
  double hardness_gpa = 9.1;  ///< before
  double cycle_s = 180;
  double handling_s = 60;  ///< per batch
  std::int64_t batch_size = 12;
  double life_cv = 0.5;          ///< of the drills as delivered; the treatment is not known to change it
  double breakage_fraction = 0;  ///< likewise
  double treatment_cost = 0;     ///< per drill
  std::optional<double> unevenness_max;       ///< of the kinematic efficiency about 1
  std::optional<double> active_fraction_min;  ///< of a turn in which the powder attacks the corner
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const DrillFinishing& spec, const PlanContext& context);

}  // namespace verstat::operations
