#pragma once
// Ways between the places of a shop.

#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::scenarios {

struct Layout {
  std::vector<std::string> places;            ///< in order of their first mention
  std::vector<std::vector<double>> length_m;  ///< [from][to]: shortest way; infinity when there is none

  /// Index of a place; none when the layout does not mention it.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& place) const;
};
/// Shortest ways by Dijkstra's algorithm from every place.
[[nodiscard]] Layout layout_of(const std::vector<LayoutEdge>& edges);

}  // namespace verstat::scenarios
