#include "scenarios/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <fmt/format.h>

#include "scenarios/check.h"
#include "scenarios/route.h"

namespace verstat::scenarios {

std::optional<std::size_t> Layout::find(const std::string& place) const {
  const auto found = std::find(places.begin(), places.end(), place);
  if (found == places.end()) return std::nullopt;
  return static_cast<std::size_t>(found - places.begin());
}

Layout layout_of(const std::vector<LayoutEdge>& edges) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Layout layout;
  const auto place = [&](const std::string& name) {
    if (const auto known = layout.find(name)) return *known;
    layout.places.push_back(name);
    return layout.places.size() - 1;
  };
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, double>>;
  Graph graph;
  for (const LayoutEdge& edge : edges) {
    const std::size_t from = place(edge.from);
    const std::size_t to = place(edge.to);
    boost::add_edge(from, to, edge.length_m, graph);
    if (!edge.one_way) boost::add_edge(to, from, edge.length_m, graph);
  }
  for (std::size_t from = 0; from < layout.places.size(); ++from) {
    std::vector<double> length(layout.places.size(), infinity);
    boost::dijkstra_shortest_paths(graph, from, boost::distance_map(length.data()).distance_inf(infinity));
    layout.length_m.push_back(std::move(length));
  }
  return layout;
}

namespace {

bool fits(const std::string& pattern, const std::string& name) {
  return pattern == "*" || pattern == name;
}

// Every way from a machine group to the next place that parts take.
std::set<std::pair<std::string, std::string>> moves_of(const Scenario& s) {
  std::set<std::pair<std::string, std::string>> moves;
  for (const PartType& part : s.parts) {
    const Route route = route_of(s, part);
    for (const RouteStep& step : route)
      for (const std::size_t from : groups_of(s, s.operations[step.operation]))
        for (const RouteBranch& branch : step.next) {
          if (branch.to == route_end) {
            moves.emplace(s.machines[from].name, part.store);
            continue;
          }
          for (const std::size_t to : groups_of(s, s.operations[route[branch.to].operation]))
            moves.emplace(s.machines[from].name, s.machines[to].name);
        }
  }
  return moves;
}

}  // namespace

void check_layout(const Scenario& s) {
  const Layout layout = layout_of(s.layout);
  for (const auto& [from, to] : moves_of(s)) {
    const auto carrier = std::find_if(
        s.transport.begin(), s.transport.end(),
        [&, &a = from, &b = to](const Transport& t) { return fits(t.from, a) && fits(t.to, b); });
    if (carrier == s.transport.end() || !std::holds_alternative<Vehicles>(carrier->carrier)) continue;
    const std::string pointer = fmt::format("/transport/{}", carrier - s.transport.begin());
    for (const std::string& name : {from, to})
      if (!layout.find(name))
        fail(pointer, quoted(carrier->name),
             fmt::format("drives to \"{}\", which the layout does not mention", name));
    // Vehicles start at the first place and come from wherever they were before.
    for (const auto& [a, b] :
         {std::pair{layout.places.front(), from}, std::pair{from, to}, std::pair{to, from}})
      if (std::isinf(layout.length_m[*layout.find(a)][*layout.find(b)]))
        fail(pointer, quoted(carrier->name),
             fmt::format("has no way from \"{}\" to \"{}\" in the layout", a, b));
  }
}

}  // namespace verstat::scenarios
