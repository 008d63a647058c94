#include "scenarios/route.h"

#include <Eigen/Dense>

namespace verstat::scenarios {

namespace {

std::vector<RouteComponent> components(const Scenario& scenario, const std::vector<Component>& named) {
  std::vector<RouteComponent> result;
  for (const Component& c : named) result.push_back({index_of(scenario.parts, c.part), c.count});
  return result;
}

}  // namespace

Route route_of(const Scenario& scenario, const PartType& part) {
  Route route;
  for (const std::string& name : part.route) {
    RouteStep step{.operation = index_of(scenario.operations, name)};
    step.next.push_back({route.size() + 1 == part.route.size() ? route_end : route.size() + 1, 1.0});
    route.push_back(std::move(step));
  }
  for (const Step& named : part.steps) {
    RouteStep step{.operation = index_of(scenario.operations, named.operation),
                   .choice = named.choice,
                   .assembles = components(scenario, named.assembles),
                   .yields = components(scenario, named.yields),
                   .rework = named.rework.empty() ? route_end : index_of(part.steps, named.rework),
                   .rework_limit = named.rework_limit};
    for (const Branch& branch : named.next)
      step.next.push_back(
          {branch.to.empty() ? route_end : index_of(part.steps, branch.to), branch.probability});
    if (step.next.empty())
      step.next.push_back({route.size() + 1 == part.steps.size() ? route_end : route.size() + 1, 1.0});
    route.push_back(std::move(step));
  }
  return route;
}

std::vector<double> expected_visits(const Route& route, const std::vector<double>& lost) {
  const auto n = static_cast<Eigen::Index>(route.size());
  Eigen::MatrixXd flow = Eigen::MatrixXd::Identity(n, n);  // v = e_0 + P' v
  for (Eigen::Index from = 0; from < n; ++from) {
    const RouteStep& step = route[static_cast<std::size_t>(from)];
    for (const RouteBranch& branch : step.next) {
      if (branch.to == route_end) continue;
      const double share = step.choice == BranchChoice::by_probability
                               ? branch.probability
                               : 1.0 / static_cast<double>(step.next.size());
      flow(static_cast<Eigen::Index>(branch.to), from) -= share * (1 - lost[static_cast<std::size_t>(from)]);
    }
  }
  Eigen::VectorXd entering = Eigen::VectorXd::Zero(n);
  entering(0) = 1;
  const Eigen::VectorXd visits = flow.partialPivLu().solve(entering);
  return {visits.data(), visits.data() + visits.size()};
}

}  // namespace verstat::scenarios
