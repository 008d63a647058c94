#include "optimize/losses.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace verstat::optimize {

using nlohmann::json;

namespace {

json nothing() {
  return {{"kind", "constant"}, {"value_min", 0.0}};
}

// A scenario need not say how edges are changed, and a pointer into what it does not say leads nowhere: where
// nothing but the usual is said, the whole is given.
bool says_nothing(const scenarios::ToolChange& c) {
  const scenarios::ToolChange usual;
  return c.positioning_min == 0 && c.failure_extra_min == 0 && c.stop_min == 0 && mean_min(c.swap) == 0 &&
         mean_min(c.index) == mean_min(usual.index) && mean_min(c.replace) == mean_min(usual.replace);
}

std::vector<scenarios::Change> changes_in_no_time(const scenarios::Tool& tool, const std::string& at) {
  if (says_nothing(tool.change)) return {{at + "/change", {{"index", nothing()}, {"replace", nothing()}}}};
  std::vector<scenarios::Change> all{{at + "/change/index", nothing()},
                                     {at + "/change/replace", nothing()},
                                     {at + "/change/positioning_min", 0.0}};
  if (tool.change.stop_min > 0) all.push_back({at + "/change/stop_min", 0.0});
  if (mean_min(tool.change.swap) > 0) all.push_back({at + "/change/swap", nothing()});
  return all;
}

}  // namespace

std::vector<Loss> losses_of(const scenarios::Scenario& s) {
  std::vector<Loss> all;
  for (std::size_t t = 0; t < s.tools.size(); ++t) {
    const scenarios::Tool& tool = s.tools[t];
    const std::string at = fmt::format("/tools/{}", t);
    const bool used = std::any_of(s.operations.begin(), s.operations.end(),
                                  [&](const scenarios::Operation& o) { return o.tool == tool.name; });
    if (!used) continue;
    if (tool.change.failure_extra_min > 0 || tool.failure_damage > 0 || tool.failure_scrap_probability > 0) {
      Loss loss{"failures of " + tool.name,
                "failure",
                {{at + "/failure_damage", 0.0},
                 {at + "/failure_scrap_probability", 0.0},
                 {at + "/regrind_failure", tool.regrind_planned},
                 {at + "/periods_failure", tool.periods_planned}}};
      if (tool.change.failure_extra_min > 0)
        loss.removed_by.push_back({at + "/change/failure_extra_min", 0.0});
      all.push_back(std::move(loss));
    }
    const scenarios::ToolChange& change = tool.change;
    if (change.positioning_min + change.stop_min + mean_min(change.index) + mean_min(change.replace) +
            mean_min(change.swap) >
        0)
      all.push_back({"changes of " + tool.name, "change", changes_in_no_time(tool, at)});
    for (std::size_t e = 0; e < tool.elements.size(); ++e)
      if (mean_min(tool.elements[e].change) > 0)
        all.push_back({fmt::format("changes of {} of {}", tool.elements[e].element, tool.name),
                       "change",
                       {{fmt::format("{}/elements/{}/change", at, e), nothing()}}});
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
      if (mean_min(machine.maintenance[k].duration) > 0)
        all.push_back({fmt::format("time of {} of {}", machine.maintenance[k].name, machine.name),
                       "change",
                       {{fmt::format("{}/maintenance/{}/duration", at, k), nothing()}}});
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
  for (std::size_t k = 0; k < s.spares.size(); ++k)
    if (mean_min(s.spares[k].lead_time) > 0)
      all.push_back(
          {"waiting for " + s.spares[k].name, "wait", {{fmt::format("/spares/{}/lead_time", k), nothing()}}});
  for (std::size_t k = 0; k < s.inserts.size(); ++k)
    if (s.inserts[k].crib)
      all.push_back({"waiting for inserts " + s.inserts[k].name,
                     "wait",
                     {{fmt::format("/inserts/{}/crib", k), nullptr}}});
  const std::int64_t machines =
      std::accumulate(s.machines.begin(), s.machines.end(), std::int64_t{0},
                      [](std::int64_t sum, const scenarios::Machine& m) { return sum + m.count; });
  for (std::size_t c = 0; c < s.crews.size(); ++c) {
    const scenarios::Crew& crew = s.crews[c];
    if (crew.walking_min > 0)
      all.push_back({"walking of " + crew.name, "wait", {{fmt::format("/crews/{}/walking_min", c), 0.0}}});
    if (crew.members >= machines) continue;
    Loss loss{"waiting for " + crew.name, "wait", {{fmt::format("/crews/{}/members", c), machines}}};
    // Paid by the shift, the larger crew costs no more than today's: the price is that of waiting alone.
    if (crew.pay == scenarios::CrewPay::shift) {
      const double share = static_cast<double>(crew.members) / static_cast<double>(machines);
      if (crew.wages)
        loss.removed_by.push_back(
            {fmt::format("/crews/{}/wages/monthly_wage", c), crew.wages->monthly_wage * share});
      else
        loss.removed_by.push_back({fmt::format("/crews/{}/rate_per_min", c), crew.rate_per_min * share});
    }
    all.push_back(std::move(loss));
  }
  return all;
}

}  // namespace verstat::optimize
