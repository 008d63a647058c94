#include "operations/cut_plan.h"

#include <algorithm>

namespace verstat::operations {

bool CutPlan::feasible() const {
  return std::all_of(limits.begin(), limits.end(), [](const Limit& l) { return l.met(); }) &&
         std::none_of(bands.begin(), bands.end(), [](const ForbiddenBand& b) { return b.inside(); });
}

std::optional<double> CutPlan::value_of(const std::string& name) const {
  for (const Quantity& q : quantities)
    if (name == q.name) return q.value;
  return std::nullopt;
}

EdgeLife PreparedLot::edge_life(const EdgeLife& delivered) const {
  EdgeLife prepared = delivered;
  prepared.law = law;
  prepared.cv = cv;
  prepared.mean_ref_min *= life_factor;
  return prepared;
}

void CutPlan::set_main_time(double value_min, const char* origin) {
  main_time_min = value_min;
  quantities.insert(quantities.begin(), {"main_time_min", value_min, "min", origin, "main time of one part"});
}

}  // namespace verstat::operations
