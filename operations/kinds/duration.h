#pragma once
// Operation kind "duration": a plain time, so that a shop can be modelled before its physics is known.

#include "operations/kind.h"

namespace verstat::operations {

struct PlainOperation {
  static constexpr const char* kind = "duration";
  Duration time = ConstantDuration{1};
};

[[nodiscard]] CutPlan plan(const PlainOperation& spec, const PlanContext& context);

}  // namespace verstat::operations
