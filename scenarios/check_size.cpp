// Each member of a scenario has its range; these are limits on what they make together.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "scenarios/check.h"

namespace verstat::scenarios {

namespace {

// A machine takes about 2 kB and 30 KPIs per replication.
constexpr std::int64_t most_machines = 20'000;
// Failure modes and maintenance jobs, each on every machine of its group.
constexpr std::int64_t most_stops = 200'000;
// A system of equations of this size is solved for every route.
constexpr std::size_t most_steps = 20'000;
// The layout holds the way from every place to every other.
constexpr std::size_t most_places = 1000;
constexpr std::int64_t most_vehicles = 10'000;
// An operation is planned once for every group that can do it.
constexpr std::int64_t most_plans = 50'000;

std::int64_t plans_of(const Scenario& s, const Operation& operation) {
  auto plans = static_cast<std::int64_t>(operation.machines.size()) + (operation.machine.empty() ? 0 : 1);
  if (!operation.capability.empty())
    for (const Machine& machine : s.machines)
      plans += std::count(machine.capabilities.begin(), machine.capabilities.end(), operation.capability);
  return plans;
}

}  // namespace

void check_size(const Scenario& s) {
  std::int64_t machines = 0;
  std::int64_t stops = 0;
  for (std::size_t k = 0; k < s.machines.size(); ++k) {
    const Machine& group = s.machines[k];
    machines += group.count;
    stops += group.count * static_cast<std::int64_t>(group.failures.size() + group.maintenance.size());
    if (machines > most_machines)
      fail(fmt::format("/machines/{}/count", k), fmt::format("{}", group.count),
           fmt::format("makes {} machines in all, the most is {}", machines, most_machines));
    if (stops > most_stops)
      fail(fmt::format("/machines/{}/failures", k), fmt::format("{}", group.failures.size()),
           fmt::format("makes {} failure modes and maintenance jobs on all machines, the most is {}", stops,
                       most_stops));
  }
  std::int64_t plans = 0;
  for (std::size_t k = 0; k < s.operations.size(); ++k) {
    plans += plans_of(s, s.operations[k]);
    if (plans > most_plans)
      fail(fmt::format("/operations/{}", k), quoted(s.operations[k].name),
           fmt::format("makes {} pairs of operation and machine group, the most is {}", plans, most_plans));
  }
  std::size_t steps = 0;
  for (std::size_t k = 0; k < s.parts.size(); ++k) {
    steps += s.parts[k].route.size() + s.parts[k].steps.size();
    if (steps > most_steps)
      fail(fmt::format("/parts/{}", k), quoted(s.parts[k].name),
           fmt::format("makes {} steps in all routes, the most is {}", steps, most_steps));
  }
  std::set<std::string> places;
  for (std::size_t k = 0; k < s.layout.size(); ++k) {
    places.insert(s.layout[k].from);
    places.insert(s.layout[k].to);
    if (places.size() > most_places)
      fail(fmt::format("/layout/{}", k), quoted(s.layout[k].to),
           fmt::format("is one place too many, the most is {}", most_places));
  }
  std::int64_t vehicles = 0;
  for (std::size_t k = 0; k < s.transport.size(); ++k) {
    const auto* fleet = std::get_if<Vehicles>(&s.transport[k].carrier);
    if (fleet == nullptr) continue;
    // Each fleet holds its own table of ways.
    vehicles += std::max(fleet->count, static_cast<std::int64_t>(100));
    if (vehicles > most_vehicles)
      fail(fmt::format("/transport/{}/carrier/count", k), fmt::format("{}", fleet->count),
           fmt::format("makes too many vehicles; the most is {}, a fleet counting as 100 at least",
                       most_vehicles));
  }
}

}  // namespace verstat::scenarios
