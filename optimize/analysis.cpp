#include "optimize/analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "models/catalogue/error.h"

namespace verstat::optimize {

namespace {

constexpr double relaxation = 0.01;

SearchOptions local_search(const SearchOptions& options) {
  SearchOptions local = options;
  local.algorithm.clear();
  local.global = false;
  local.max_evaluations = std::min(options.max_evaluations, 1500);
  return local;
}

// The discrete variables stay where they are.
std::vector<Dimension> with_fixed_discrete(const std::vector<Dimension>& dimensions,
                                           const std::vector<double>& x) {
  std::vector<Dimension> fixed = dimensions;
  for (std::size_t k = 0; k < fixed.size(); ++k)
    if (fixed[k].discrete) fixed[k].bounds = {x[k], x[k]};
  return fixed;
}

}  // namespace

std::vector<Binding> binding_constraints(Problem& problem, const std::vector<double>& best,
                                         const SearchOptions& options) {
  std::vector<Binding> all;
  const bool continuous = std::any_of(problem.dimensions().begin(), problem.dimensions().end(),
                                      [](const Dimension& d) { return !d.discrete; });
  if (!continuous) return all;
  const Look look = problem.look(best);
  const std::vector<Dimension> fixed = with_fixed_discrete(problem.dimensions(), best);
  SearchOptions local = local_search(options);
  local.slopes = [&](const std::vector<double>& x) { return measured(problem.slopes(x)); };
  // Both sides are searched alike, so that what the search misses cancels.
  const auto optimum = [&](const std::vector<Dimension>& dimensions, std::ptrdiff_t relaxed) {
    return minimize_mixed(
               [&](const std::vector<double>& x) {
                 Measured m = measured(problem.evaluate(x));
                 if (relaxed >= 0) m.margins[static_cast<std::size_t>(relaxed)] += relaxation;
                 return m;
               },
               dimensions, best, local)
        .measured.value;
  };
  const double here = optimum(fixed, -1);
  for (std::size_t k = 0; k < look.conditions.size(); ++k) {
    const Condition& c = problem.conditions()[k];
    const Checked& checked = look.conditions[k];
    if (c.kind == Condition::Kind::kpi && !c.long_run_kpi) continue;
    if (std::abs(checked.margin) > 1e-3) continue;
    const double gain = here - optimum(fixed, static_cast<std::ptrdiff_t>(k));
    all.push_back({.name = c.name,
                   .unit = c.unit,
                   .value = checked.value,
                   .allowed = checked.allowed,
                   .shadow_price = std::max(0.0, gain / (relaxation * checked.scale))});
  }
  for (std::size_t k = 0; k < best.size(); ++k) {
    const Dimension& d = problem.dimensions()[k];
    if (d.discrete) continue;
    const double width = d.bounds.high - d.bounds.low;
    const Variable& v = problem.study().variables[k];
    for (const bool upper : {false, true}) {
      const double bound = upper ? d.bounds.high : d.bounds.low;
      if (std::abs(best[k] - bound) > 1e-6 * width) continue;
      std::vector<Dimension> wider = fixed;
      (upper ? wider[k].bounds.high : wider[k].bounds.low) += (upper ? 1 : -1) * relaxation * width;
      const double gain = here - optimum(wider, -1);
      all.push_back({.name = fmt::format("{} bound of {}", upper ? "upper" : "lower", v.name),
                     .unit = v.unit,
                     .value = best[k],
                     .allowed = bound,
                     .shadow_price = std::isfinite(gain) ? std::max(0.0, gain / (relaxation * width)) : 0});
    }
  }
  return all;
}

std::vector<UncertainSpec> usual_uncertain_inputs(const scenarios::Scenario& scenario) {
  std::vector<UncertainSpec> inputs;
  for (std::size_t k = 0; k < scenario.inserts.size(); ++k) {
    const std::string& name = scenario.inserts[k].name;
    inputs.push_back({"price of " + name, fmt::format("/inserts/{}/price", k), 0.1});
    inputs.push_back(
        {"scatter (CV) of the life of " + name, fmt::format("/inserts/{}/edge_life/cv", k), 0.1});
    inputs.push_back({"mean life of " + name, fmt::format("/inserts/{}/edge_life/mean_ref_min", k), 0.1});
    inputs.push_back(
        {"Taylor speed exponent of " + name, fmt::format("/inserts/{}/edge_life/speed_exponent", k), 0.1});
  }
  for (std::size_t k = 0; k < scenario.machines.size(); ++k)
    inputs.push_back(
        {"rate of " + scenario.machines[k].name, fmt::format("/machines/{}/rate_per_min", k), 0.1});
  return inputs;
}

std::vector<Sensitivity> sensitivities(const Problem& problem, const std::vector<double>& best,
                                       const SearchOptions& options) {
  const StudySpec& study = problem.study();
  const std::vector<UncertainSpec> inputs =
      study.uncertain.empty() ? usual_uncertain_inputs(scenarios::load(problem.scenario_at(best)))
                              : study.uncertain;
  const SearchOptions local = local_search(options);
  const std::vector<Dimension> fixed = with_fixed_discrete(problem.dimensions(), best);
  const auto in_world = [&](const std::vector<Shift>& shifts, double& objective, double& regret,
                            std::vector<double>& x) {
    Problem world(study, problem.scenario(), shifts);
    const auto measure = [&](const std::vector<double>& at) { return measured(world.evaluate(at)); };
    SearchOptions search = local;
    search.slopes = [&](const std::vector<double>& at) { return measured(world.slopes(at)); };
    const SearchResult there = minimize_mixed(measure, fixed, best, search);
    objective = shown_value(study.objective, there.measured.value);
    x = there.x;
    const Measured kept = measure(best);
    regret = violation(kept) > 1e-6 ? std::numeric_limits<double>::infinity()
                                    : std::max(0.0, kept.value - there.measured.value);
  };
  double nominal = 0;
  double none = 0;
  std::vector<double> x;
  in_world({}, nominal, none, x);
  std::vector<Sensitivity> all;
  for (const UncertainSpec& input : inputs) {
    Sensitivity s{.name = input.name, .pointer = input.pointer, .relative = input.relative};
    try {
      in_world({{input.pointer, 1 - input.relative}}, s.objective_low, s.regret_low, s.x_low);
      in_world({{input.pointer, 1 + input.relative}}, s.objective_high, s.regret_high, s.x_high);
    } catch (const models::DomainError&) {
      continue;  // the input cannot be moved so far
    } catch (const models::ModelError&) {
      continue;
    }
    if (!std::isfinite(s.objective_low) || !std::isfinite(s.objective_high)) continue;
    const double moved = std::max(std::abs(s.objective_low - nominal), std::abs(s.objective_high - nominal));
    if (moved > 1e-9 * std::abs(nominal)) all.push_back(std::move(s));
  }
  std::stable_sort(all.begin(), all.end(), [](const Sensitivity& a, const Sensitivity& b) {
    return std::abs(a.objective_high - a.objective_low) > std::abs(b.objective_high - b.objective_low);
  });
  return all;
}

}  // namespace verstat::optimize
