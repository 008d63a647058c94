// Checks of operations and parts that one member alone cannot show.
#include <fmt/format.h>

#include "operations/kinds/duration.h"
#include "scenarios/check.h"

namespace verstat::scenarios {

void check_operation(const Scenario& s, const Operation& operation, const std::string& at) {
  check_reference(s.machines, operation.machine, at + "/machine", "machine");
  if (!operation.tool.empty()) check_reference(s.tools, operation.tool, at + "/tool", "tool");
  if (const auto* plain = operation.process.as<operations::PlainOperation>())
    check_law(plain->time, at + "/process/time");
  operations::CutPlan plan;
  try {
    plan = scenarios::plan(s, operation);
  } catch (const models::ModelError& e) {
    throw InputError(at + "/process", fmt::format("{}/process cannot be planned: {}", at, e.what()));
  }
  if (plan.main_time_min < 1e-6)
    fail(at + "/process", fmt::format("{} min", plan.main_time_min), "must take at least 1e-6 min");
}

void check_part(const Scenario& s, const PartType& part, const std::string& at) {
  for (std::size_t k = 0; k < part.route.size(); ++k)
    check_reference(s.operations, part.route[k], fmt::format("{}/route/{}", at, k), "operation");
  check_reference(s.stores, part.store, at + "/store", "store");
  if (const auto* arrivals = std::get_if<Interarrival>(&part.supply))
    check_takes_time(arrivals->time, at + "/supply/time");
}

}  // namespace verstat::scenarios
