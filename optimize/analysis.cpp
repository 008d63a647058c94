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

double taylor_life_min_cost(double mu, double change_min, double change_cost, double machine_rate) {
  return (mu - 1) * (change_min + change_cost / machine_rate);
}

std::vector<OneCut> one_cut_optima(const scenarios::Scenario& plan) {
  std::vector<OneCut> all;
  scenarios::Scenario shop = plan;  // its speeds are moved to and fro
  LongRun run;
  try {
    run = LongRunModel(shop).evaluate();
  } catch (const std::exception&) {
    return all;  // no long run, no loads
  }
  for (std::size_t o = 0; o < shop.operations.size(); ++o) {
    const auto& operation = shop.operations[o];
    const operations::CutPlan& here = run.plans[o];
    if (operation.tool.empty() || !here.edge) continue;
    const std::vector<std::string> path{"operations", std::to_string(o), "process", "cutting_speed_m_min"};
    double* speed = models::locate_in_fields(&shop, scenarios::scenario_fields(), path);
    if (speed == nullptr || !(*speed > 0)) continue;
    const double v = *speed;
    constexpr double h = 1e-4;
    operations::CutPlan slow;
    operations::CutPlan fast;
    try {
      *speed = v * std::exp(-h);
      slow = scenarios::plan(shop, operation);
      *speed = v * std::exp(h);
      fast = scenarios::plan(shop, operation);
    } catch (const std::exception&) {
      *speed = v;
      continue;  // at the edge of the models' range
    }
    *speed = v;
    const double mu = (std::log(slow.edge->mean_min) - std::log(fast.edge->mean_min)) / (2 * h);
    const double time_exponent = (std::log(slow.main_time_min) - std::log(fast.main_time_min)) / (2 * h);
    if (!(mu > 1) || std::abs(time_exponent - 1) > 0.02) continue;

    const auto& tool = *scenarios::find_named(shop.tools, operation.tool);
    const auto insert = scenarios::prepared(*scenarios::find_named(shop.inserts, tool.insert));
    const auto& crew = *scenarios::find_named(shop.crews, tool.crew);
    const auto& machine = shop.machines[scenarios::groups_of(shop, operation).front()];
    if (!(machine.rate_per_min > 0)) continue;
    // A planned change: of the n edges of an insert one is fitted, the others are indexed to.
    const double replaces = 1 / edges_used_per_insert(insert.edges, 1.0, insert.single_edge_probability);
    const double change_min = tool.change.positioning_min +
                              replaces * scenarios::mean_min(tool.change.replace) +
                              (1 - replaces) * scenarios::mean_min(tool.change.index);
    const double edge = tool.insert_booking == scenarios::InsertBooking::life_periods
                            ? insert.price / tool.periods_planned
                            : insert.price * replaces;
    const double wage = crew.pay == scenarios::CrewPay::busy ? crew.rate_per_min * change_min : 0;
    OneCut cut{.operation = operation.name,
               .life_min_cost_min = taylor_life_min_cost(mu, change_min, edge + wage + tool.regrind_planned,
                                                         machine.rate_per_min),
               .life_max_rate_min = taylor_life_min_cost(mu, change_min, 0, machine.rate_per_min),
               .speed_shop_m_min = v,
               .life_shop_min = here.edge->mean_min};
    cut.speed_min_cost_m_min = v * std::pow(here.edge->mean_min / cut.life_min_cost_min, 1 / mu);
    cut.speed_max_rate_m_min = v * std::pow(here.edge->mean_min / cut.life_max_rate_min, 1 / mu);
    const auto group = static_cast<std::size_t>(&machine - shop.machines.data());
    cut.load = run.machines[group].load;
    const bool several = shop.machines.size() > 1;
    const OperationCost& cost = run.operations[o];
    const double failing = cost.changes_per_part > 0 ? cost.failures_per_part / cost.changes_per_part : 0;
    if (several && group == run.bottleneck && v > cut.speed_min_cost_m_min)
      cut.why = fmt::format("{} limits the shop: its minutes are worth more than its rate", machine.name);
    else if (several && cut.load < 0.98 && v < cut.speed_min_cost_m_min)
      cut.why =
          fmt::format("{} has {:.0f} % of its time to spare: slower cutting saves edges and costs nothing",
                      machine.name, 100 * (1 - cut.load));
    else if (v < cut.speed_min_cost_m_min && failing > 0.02)
      cut.why = fmt::format("{:.0f} % of the changes come after a failure, which the textbook does not price",
                            100 * failing);
    else if (v > cut.speed_max_rate_m_min)
      cut.why =
          "faster than the textbook's largest rate: the plan is held there by its bounds or another aim";
    else
      cut.why = "between smallest cost and largest rate";
    all.push_back(std::move(cut));
  }
  return all;
}

}  // namespace verstat::optimize
