#include "scenarios/criteria.h"

#include <algorithm>

#include <fmt/format.h>

#include "operations/fields.h"
#include "scenarios/check.h"

namespace verstat::models {

std::vector<Field> StructFields<scenarios::CriteriaSettings>::fields() {
  using C = scenarios::CriteriaSettings;
  return {may<C>(&C::mission_min, "mission_min", "min", open_low(0, 1e9),
                 "window of a machine that passes with or without a failure, a shift for instance"),
          may<C>(&C::operator_load_limit, "operator_load_limit", "1", open_low(0, 10),
                 "load of the busiest crew at which the socio-ergonomic index is zero"),
          may<C>(&C::best, "best", "-", no_range(), "value of a criterion that counts as 1"),
          may<C>(&C::worst, "worst", "-", no_range(), "value of a criterion that counts as 0"),
          may<C>(&C::local_weights, "local_weights", "-", no_range(), "weights within the groups"),
          may<C>(&C::group_weights, "group_weights", "-", no_range(), "weights of the groups"),
          may<C>(&C::local_form, "local_form", "-", no_range(), "how criteria are combined into groups"),
          may<C>(&C::global_form, "global_form", "-", no_range(), "how groups are combined"),
          may<C>(&C::minimum, "minimum", "-", no_range(), "least normalized values: limits")};
}

}  // namespace verstat::models

namespace verstat::scenarios {

namespace k205 = models::k205;

bool CriteriaSettings::has_hierarchy() const {
  const auto bests = best.values();
  return std::any_of(bests.begin(), bests.end(), [](const auto& b) { return b.has_value(); });
}

k205::Hierarchy CriteriaSettings::hierarchy(const k205::Criteria& values) const {
  k205::Hierarchy h;
  h.best = best;
  h.worst = worst;
  h.local_weights = local_weights;
  h.group_weights = group_weights;
  h.local_form = local_form;
  h.global_form = global_form;
  h.minimum = minimum;
  // A criterion that is not judged needs no value.
  const auto judged = best.values();
  auto kept = values.values();
  for (std::size_t k = 0; k < kept.size(); ++k)
    if (!judged[k]) kept[k].reset();
  h.criteria.set(kept);
  return h;
}

void check_criteria(const Scenario& s, const std::string& at) {
  const CriteriaSettings& criteria = *s.criteria;
  const double counted_min = s.simulation.horizon_min - s.simulation.warmup_min;
  if (criteria.mission_min > counted_min)
    fail(at + "/mission_min", fmt::format("{}", criteria.mission_min),
         fmt::format("must not be above the counted time, {} min", counted_min));
  const auto bests = criteria.best.values();
  const auto worsts = criteria.worst.values();
  const auto minima = criteria.minimum.values();
  for (std::size_t k = 0; k < bests.size(); ++k) {
    const std::string name = fmt::format("e{:02}", k + 1);
    if (bests[k].has_value() != worsts[k].has_value())
      fail(fmt::format("{}/{}/{}", at, bests[k] ? "worst" : "best", name), "null",
           "best and worst value of a criterion must be given together");
    if (bests[k] && *bests[k] == *worsts[k])
      fail(fmt::format("{}/best/{}", at, name), fmt::format("{}", *bests[k]),
           "must differ from the worst value");
    if (minima[k] && !bests[k])
      fail(fmt::format("{}/minimum/{}", at, name), fmt::format("{}", *minima[k]),
           "needs the best and the worst value of the criterion");
  }
  if (!criteria.has_hierarchy()) return;
  // Weights that leave nothing to judge by are found with values in the middle.
  k205::Criteria middle;
  k205::Criteria::Values halves;
  halves.fill(0.5);
  middle.set(halves);
  try {
    static_cast<void>(k205::hierarchical_efficiency(criteria.hierarchy(middle)));
  } catch (const models::ModelError& e) {
    throw InputError(at, fmt::format("{}: {}", at, e.what()));
  }
}

}  // namespace verstat::scenarios
