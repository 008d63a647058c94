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

const char* CutPlan::unit_of(const std::string& name) const {
  for (const Quantity& q : quantities)
    if (name == q.name) return q.unit;
  return "1";
}

const PartState* CutPlan::left(const std::string& quantity) const {
  for (const PartState& state : leaves)
    if (quantity == state.quantity) return &state;
  return nullptr;
}

Detection GaugeWear::at(double worn_share) const {
  const auto above = std::upper_bound(worn.begin(), worn.end(), worn_share);
  const auto high =
      std::clamp<std::size_t>(static_cast<std::size_t>(above - worn.begin()), 1, worn.size() - 1);
  const std::size_t low = high - 1;
  const double t = std::clamp((worn_share - worn[low]) / (worn[high] - worn[low]), 0.0, 1.0);
  Detection d;
  d.sensitivity = sensitivity[low] + t * (sensitivity[high] - sensitivity[low]);
  d.specificity = specificity[low] + t * (specificity[high] - specificity[low]);
  d.origin = origin;
  return d;
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
