#pragma once
// Operation kind "elastic_grinding": a flat pressed to the wheel with a set force, in passes.
//
// Depth of cut, temperature and power follow from the clamp force (K118); the temperature of phase
// transformation limits the force. The state is that of the wheel at the end of its dressing interval, when
// the wear flats are longest and the depth least.

#include <cstdint>

#include "models/grinding/k118_elastic_grinding_clamp_force.h"
#include "operations/dressing.h"
#include "operations/kind.h"

namespace verstat::operations {

/// Wheel, grains, steel and heat as in K118 (its defaults: diamond 100/80, steel R6M5); the wear flat is that
/// of `time_after_dress_min`, the dressing interval.
struct ElasticGrinding : models::k118::ElasticWithoutDepth, DressingLaw {
  static constexpr const char* kind = "elastic_grinding";
  double clamp_force_n = 0;  // on the whole width
  double critical_c = 880;   // phase transformation: 880 R6M5, 820 60S2
  double allowance_um = 0;
  double stroke_length_mm = 0;
  std::int64_t sparkout_passes = 0;
  std::optional<double> grinding_ratio;
};

/// Throws models::ModelError for values outside the models' ranges, and for a clamp force that gives no depth
/// within 1..60 um.
[[nodiscard]] CutPlan plan(const ElasticGrinding& spec, const PlanContext& context);

}  // namespace verstat::operations
