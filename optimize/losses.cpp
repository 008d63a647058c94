#include "optimize/losses.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace verstat::optimize {

using nlohmann::json;

std::vector<Loss> losses_of(const scenarios::Scenario& s) {
  std::vector<Loss> all;
  for (std::size_t t = 0; t < s.tools.size(); ++t) {
    const scenarios::Tool& tool = s.tools[t];
    const std::string at = fmt::format("/tools/{}", t);
    const bool used = std::any_of(s.operations.begin(), s.operations.end(),
                                  [&](const scenarios::Operation& o) { return o.tool == tool.name; });
    if (!used) continue;
    const json nothing = {{"kind", "constant"}, {"value_min", 0.0}};
    if (tool.change.failure_extra_min > 0 || tool.failure_damage > 0 || tool.failure_scrap_probability > 0)
      all.push_back({"failures of " + tool.name,
                     "failure",
                     {{at + "/change/failure_extra_min", 0.0},
                      {at + "/failure_damage", 0.0},
                      {at + "/failure_scrap_probability", 0.0},
                      {at + "/regrind_failure", tool.regrind_planned},
                      {at + "/periods_failure", tool.periods_planned}}});
    if (tool.change.positioning_min > 0 || mean_min(tool.change.index) > 0 ||
        mean_min(tool.change.replace) > 0)
      all.push_back({"changes of " + tool.name,
                     "change",
                     {{at + "/change/index", nothing},
                      {at + "/change/replace", nothing},
                      {at + "/change/positioning_min", 0.0}}});
    if (tool.failure_scrap_probability > 0)
      all.push_back(
          {"scrap after failures of " + tool.name, "scrap", {{at + "/failure_scrap_probability", 0.0}}});
  }
  for (std::size_t m = 0; m < s.machines.size(); ++m) {
    const scenarios::Machine& machine = s.machines[m];
    const std::string at = fmt::format("/machines/{}", m);
    // As long as any study, in minutes or in parts.
    const json never = {{"kind", "constant"}, {"value_min", 1e9}};
    for (std::size_t f = 0; f < machine.failures.size(); ++f)
      all.push_back({fmt::format("{} of {}", machine.failures[f].name, machine.name),
                     "failure",
                     {{fmt::format("{}/failures/{}/time_to_failure", at, f), never}}});
    for (std::size_t k = 0; k < machine.maintenance.size(); ++k)
      all.push_back(
          {fmt::format("time of {} of {}", machine.maintenance[k].name, machine.name),
           "change",
           {{fmt::format("{}/maintenance/{}/duration", at, k), {{"kind", "constant"}, {"value_min", 0.0}}}}});
    if (machine.setup) all.push_back({"setting up " + machine.name, "change", {{at + "/setup", nullptr}}});
  }
  for (std::size_t o = 0; o < s.operations.size(); ++o) {
    const auto& quality = s.operations[o].quality;
    const std::string at = fmt::format("/operations/{}/quality", o);
    if (quality && quality->scrap_probability > 0)
      all.push_back({"scrap of " + s.operations[o].name, "scrap", {{at + "/scrap_probability", 0.0}}});
    if (quality && (quality->defect_probability > 0 || quality->defect_when_worn > 0))
      all.push_back({"defects of " + s.operations[o].name,
                     "scrap",
                     {{at + "/defect_probability", 0.0}, {at + "/defect_when_worn", 0.0}}});
  }
  const std::int64_t machines =
      std::accumulate(s.machines.begin(), s.machines.end(), std::int64_t{0},
                      [](std::int64_t sum, const scenarios::Machine& m) { return sum + m.count; });
  for (std::size_t c = 0; c < s.crews.size(); ++c) {
    const scenarios::Crew& crew = s.crews[c];
    if (crew.members >= machines) continue;
    Loss loss{"waiting for " + crew.name, "wait", {{fmt::format("/crews/{}/members", c), machines}}};
    // Paid by the shift, the larger crew costs no more than today's: the price is that of waiting alone.
    if (crew.pay == scenarios::CrewPay::shift)
      loss.removed_by.push_back(
          {fmt::format("/crews/{}/rate_per_min", c),
           crew.rate_per_min * static_cast<double>(crew.members) / static_cast<double>(machines)});
    all.push_back(std::move(loss));
  }
  return all;
}

}  // namespace verstat::optimize
