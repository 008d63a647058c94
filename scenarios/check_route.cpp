// Checks of routes as directed graphs: every step is reached, and from every step parts reach their store.
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/reverse_graph.hpp>
#include <fmt/format.h>

#include "scenarios/check.h"
#include "scenarios/route.h"

namespace verstat::scenarios {

namespace {

// Vertices are the steps, and one more for the store.
using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>;

template <class G>
std::vector<bool> reached_from(const G& graph, std::size_t start) {
  std::vector<boost::default_color_type> colours(num_vertices(graph), boost::white_color);
  boost::queue<std::size_t> buffer;
  boost::breadth_first_visit(graph, start, buffer, boost::default_bfs_visitor(), colours.data());
  std::vector<bool> reached;
  for (const auto colour : colours) reached.push_back(colour != boost::white_color);
  return reached;
}

std::string name_of_step(const PartType& part, std::size_t k) {
  return part.steps.empty() ? part.route[k] : part.steps[k].name;
}
std::string pointer_of_step(const PartType& part, const std::string& at, std::size_t k) {
  return part.steps.empty() ? fmt::format("{}/route/{}", at, k) : fmt::format("{}/steps/{}", at, k);
}

void check_step(const Scenario& s, const PartType& part, const Step& step, const std::string& at) {
  check_reference(s.operations, step.operation, at + "/operation", "operation");
  if (!step.rework.empty()) check_reference(part.steps, step.rework, at + "/rework", "step");
  double sum = 0;
  for (std::size_t b = 0; b < step.next.size(); ++b) {
    const Branch& branch = step.next[b];
    if (!branch.to.empty())
      check_reference(part.steps, branch.to, fmt::format("{}/next/{}/to", at, b), "step");
    sum += branch.probability;
  }
  if (step.choice == BranchChoice::by_probability && !step.next.empty() && std::abs(sum - 1) > 1e-9)
    fail(at + "/next", fmt::format("probabilities that add up to {}", sum), "must add up to 1");
  const auto check_components = [&](const std::vector<Component>& all, const std::string& member) {
    for (std::size_t c = 0; c < all.size(); ++c) {
      const std::string pointer = fmt::format("{}/{}/{}/part", at, member, c);
      check_reference(s.parts, all[c].part, pointer, "part");
      if (all[c].part == part.name) fail(pointer, quoted(part.name), "must be another part type");
    }
  };
  check_components(step.assembles, "assembles");
  check_components(step.yields, "yields");
}

}  // namespace

void check_route(const Scenario& s, const PartType& part, const std::string& at) {
  if (part.route.empty() == part.steps.empty())
    fail(at + "/route", part.route.empty() ? "nothing" : "a route besides steps",
         "give either route (names of operations) or steps (a graph)");
  for (std::size_t k = 0; k < part.route.size(); ++k)
    check_reference(s.operations, part.route[k], fmt::format("{}/route/{}", at, k), "operation");
  check_names(names_of(part.steps), at + "/steps");
  for (std::size_t k = 0; k < part.steps.size(); ++k)
    check_step(s, part, part.steps[k], pointer_of_step(part, at, k));

  const Route route = route_of(s, part);
  const std::size_t store = route.size();
  Graph graph(route.size() + 1);
  for (std::size_t k = 0; k < route.size(); ++k) {
    for (const RouteBranch& branch : route[k].next)
      if (branch.probability > 0) add_edge(k, branch.to == route_end ? store : branch.to, graph);
    if (route[k].rework != route_end) add_edge(k, route[k].rework, graph);
  }
  const std::vector<bool> reached = reached_from(graph, 0);
  const std::vector<bool> finishes = reached_from(boost::make_reverse_graph(graph), store);
  for (std::size_t k = 0; k < route.size(); ++k) {
    const std::string pointer = pointer_of_step(part, at, k);
    if (!reached[k])
      fail(pointer, quoted(name_of_step(part, k)),
           "is never reached from the first step; give it a way in or drop it");
    if (!finishes[k])
      fail(pointer, quoted(name_of_step(part, k)),
           "parts that come here never get to their store: every way leads back into the loop");
  }
}

}  // namespace verstat::scenarios
