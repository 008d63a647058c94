#pragma once
// Routes with every name looked up once, and how often their steps are visited.

#include <cstddef>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::scenarios {

inline constexpr std::size_t route_end = static_cast<std::size_t>(-1);

/// Position of the element with this name; route_end when there is none.
template <class T>
[[nodiscard]] std::size_t index_of(const std::vector<T>& all, const std::string& name) {
  const T* found = find_named(all, name);
  return found == nullptr ? route_end : static_cast<std::size_t>(found - all.data());
}

struct RouteBranch {
  std::size_t to = route_end;  ///< index of a step, or route_end
  double probability = 1;
};
struct RouteComponent {
  std::size_t part = 0;  ///< index of the part type
  std::int64_t count = 1;
};
struct RouteStep {
  std::size_t operation = 0;
  std::vector<RouteBranch> next;  ///< at least one
  BranchChoice choice = BranchChoice::by_probability;
  std::vector<RouteComponent> assembles;
  std::vector<RouteComponent> yields;
  std::size_t rework = route_end;  ///< route_end: rejected parts are scrapped
  std::int64_t rework_limit = 1;
};
using Route = std::vector<RouteStep>;

/// The route of a part type of a checked scenario.
[[nodiscard]] Route route_of(const Scenario& scenario, const PartType& part);

/// Expected visits to every step per part that enters at the first one, when a visit to step k loses the
/// share `lost[k]` of the parts; parts in rework are left out. Branches by shortest queue count evenly.
[[nodiscard]] std::vector<double> expected_visits(const Route& route, const std::vector<double>& lost);

}  // namespace verstat::scenarios
