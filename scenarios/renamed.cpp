// Renaming: random numbers are drawn by name.
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "scenarios/check.h"

namespace verstat::scenarios {

const std::string& drawn_as(const SimulationSettings& settings, const std::string& name) {
  const Renamed* renamed = find_named(settings.renamed, name);
  return renamed == nullptr ? name : renamed->was;
}

void check_renamed(const Scenario& s) {
  const std::vector<Renamed>& renamed = s.simulation.renamed;
  if (renamed.empty()) return;
  const std::string list = "/simulation/renamed";
  check_names(names_of(renamed), list);
  std::set<std::string> all;
  const auto add = [&](const auto& things) {
    for (const std::string& name : names_of(things)) all.insert(name);
  };
  add(s.inserts);
  add(s.tools);
  add(s.spares);
  add(s.machines);
  for (const Machine& machine : s.machines) {
    add(machine.failures);
    add(machine.maintenance);
  }
  add(s.stores);
  add(s.parts);
  add(s.transport);
  const std::vector<std::string> names(all.begin(), all.end());
  std::set<std::string> before;
  for (std::size_t k = 0; k < renamed.size(); ++k) {
    const std::string at = fmt::format("{}/{}/", list, k);
    check_reference(names, renamed[k].name, at + "name", "thing that draws random numbers");
    const std::string& was = renamed[k].was;
    if (was.empty() || was.size() > 100) fail(at + "was", quoted(was), "must have 1 to 100 characters");
    // Two things under one name would have the same luck.
    if (all.contains(was) && find_named(renamed, was) == nullptr)
      fail(at + "was", quoted(was), "is still the name of something");
    if (!before.insert(was).second) fail(at + "was", quoted(was), "stands here twice");
  }
}

}  // namespace verstat::scenarios
