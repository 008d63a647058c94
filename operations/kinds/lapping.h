#pragma once
// Operation kind "lapping": a groove lapped in a forced and a gentle stage while the lap wears.
//
// Removal rates by Preston's law, the switch of stages and the growth of the cycle with lap wear from K311;
// the lap is reset after a number of parts, by default the one with the least mean piece time.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

/// Grains under the lap, for the roughness of the finishing stage (K311, Table 1).
struct LapGrains {
  double grain_um = 0;
  double depth_mean_um = 0;
  double depth_sd_um = 0;
  double depth_greatest_um = 0;
  double spacing_um = 0;
  double shape_factor = 2;
  double share_under_lap = 0;  // of the finishing time that a point is under the lap
};

struct Lapping {
  static constexpr const char* kind = "lapping";
  // part
  double allowance_um = 0;  // per lapped side
  double width_mm = 0;
  double length_mm = 0;
  std::int64_t sides = 1;  // of the web
  double web_um = 0;
  double web_min_um = 0;
  double web_max_um = 0;
  double roughness_initial_um = 0;
  double defect_initial_um = 0;
  double roughness_final_um = 0;
  double defect_final_um = 0;
  // regime
  double forced_force_n = 0;
  double finish_force_n = 0;
  double lap_speed_m_min = 0;
  double contact_area_mm2 = 0;
  double preston_um_mpa_m = 0;
  double roughness_forced_um = 0;  // that the forced stage keeps up
  double defect_forced_um = 0;
  std::optional<LapGrains> grains;
  // lap
  std::int64_t parts_per_lap_life = 30;
  double end_of_life_ratio = 1.38;
  std::optional<std::int64_t> reset_interval_parts;  // absent: the best one
  double preparation_min = 0;
  double reset_min = 0;
  std::optional<double> paste_g_mm3;
  // limits
  std::optional<double> force_max_n;
  std::optional<double> lap_speed_max_m_min;
  std::optional<double> roughness_ra_max_um;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a reset interval
/// beyond the lap's life.
[[nodiscard]] CutPlan plan(const Lapping& spec, const PlanContext& context);

}  // namespace verstat::operations
