#pragma once
// Operation kind "turning": a cylinder turned lengthwise in passes.
//
// Main time and edge life from K117; cutting force and power from the textbook relation of Kienzle
// (COMPLETION).

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

struct Turning {
  static constexpr const char* kind = "turning";
  double diameter_mm = 0;
  double length_mm = 0;
  std::int64_t passes = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_of_cut_mm = 0;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const Turning& spec, const PlanContext& context);

}  // namespace verstat::operations
