#pragma once
// Operation kind "turning": a cylinder turned in passes (K117).

#include <cstdint>
#include <string>

#include "operations/cut_plan.h"
#include "operations/edge_life.h"

namespace verstat::operations {

struct Turning {
  static constexpr const char* kind = "turning";
  double diameter_mm = 0;
  double length_mm = 0;
  std::int64_t passes = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_of_cut_mm = 0;
  std::string tool;
};

/// Main time by K117.machining_time_turning, mean edge life by K117.mean_life_for_regime.
/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const Turning& turning, const EdgeLife& edge);

}  // namespace verstat::operations
