#include "optimize/renewal_reward.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "models/math/life_law.h"
#include "scenarios/json_text.h"

namespace verstat::optimize {

using models::LifeLaw;
using scenarios::Crew;
using scenarios::Insert;
using scenarios::Operation;
using scenarios::Tool;

namespace {

// What happens to edges in the long run, per minute of cutting.
struct EdgeRates {
  double planned_per_min = 0;
  double failures_per_min = 0;
};

struct RatesOf {
  const LifeLaw& life;  // at the regime
  double main_time_min;

  [[nodiscard]] EdgeRates aged(double tau_min) const {
    const double used_min = life.restricted_mean(tau_min);
    return {life.reliability(tau_min) / used_min, life.failure_probability(tau_min) / used_min};
  }
  EdgeRates operator()(const scenarios::RunToFailure&) const { return {0, 1 / life.mean_life()}; }
  EdgeRates operator()(const scenarios::AgeReplacement& s) const {
    return aged(life.gamma_percent_life(s.gamma));
  }
  EdgeRates operator()(const scenarios::PartCountReplacement& s) const {
    const double limit_min = life.gamma_percent_life(s.gamma);
    const double parts = std::floor(limit_min / main_time_min + 1e-12);
    return aged(parts >= 1 ? parts * main_time_min : limit_min);
  }
  EdgeRates operator()(const scenarios::BlockReplacement& s) const {
    const double period_min = life.gamma_percent_life(s.gamma);
    return {1 / period_min, life.renewal_function(period_min) / period_min};
  }
  template <class Other>
  EdgeRates operator()(const Other&) const {
    throw scenarios::InputError(
        "", fmt::format("the long-run cost of strategy \"{}\" is left to the simulation", Other::kind));
  }
};

}  // namespace

double edges_used_per_insert(std::int64_t edges, double s, double p_single) {
  double several = 0;
  double reach = 1;
  for (std::int64_t k = 0; k < edges; ++k) {
    several += reach;
    reach *= s;
  }
  return p_single + (1 - p_single) * several;
}

LongRunModel::LongRunModel(const scenarios::Scenario& scenario) : scenario_(scenario) {
  if (scenario.parts.size() != 1)
    throw scenarios::InputError("/parts",
                                fmt::format("/parts has {} entries; the long-run cost per part is that of "
                                            "one part type",
                                            scenario.parts.size()));
  for (std::size_t t = 0; t < scenario.tools.size(); ++t) {
    const Tool& tool = scenario.tools[t];
    const Crew* crew = scenarios::find_named(scenario.crews, tool.crew);
    if (crew == nullptr)
      throw scenarios::InputError(
          fmt::format("/tools/{}/crew", t),
          fmt::format(
              "/tools/{}/crew = \"{}\", is a skill of several crews: its cost per part is left to the "
              "simulation",
              t, tool.crew));
    if (crew->pay == scenarios::CrewPay::shift)
      throw scenarios::InputError(
          fmt::format("/tools/{}/crew", t),
          fmt::format("/tools/{}/crew = \"{}\", is paid by the shift: its cost per part depends on "
                      "the whole shop and is left to the simulation",
                      t, tool.crew));
    const Insert* insert = scenarios::find_named(scenario.inserts, tool.insert);
    if (insert != nullptr && insert->lots)
      throw scenarios::InputError(
          fmt::format("/tools/{}/insert", t),
          fmt::format(
              "/tools/{}/insert = \"{}\", comes in lots that differ: its cost per part is left to the "
              "simulation",
              t, tool.insert));
    if (tool.teeth > 1 || scenarios::changed_off_line(tool) || !tool.elements.empty())
      throw scenarios::InputError(
          fmt::format("/tools/{}", t),
          fmt::format("/tools/{} = \"{}\", has teeth, copies or elements of its own: its cost per part is "
                      "left to the simulation",
                      t, tool.name));
  }
}

OperationCost LongRunModel::operation_cost(const Operation& operation) const {
  const double machine_rate =
      scenario_.machines[scenarios::groups_of(scenario_, operation).front()].rate_per_min;
  const operations::CutPlan plan = scenarios::plan(scenario_, operation);
  if (plan.breakage_probability > 0 && plan.edge && !operation.tool.empty())
    throw scenarios::InputError(
        "", fmt::format("operation \"{}\" can break its tool: its cost per part is left to the "
                        "simulation",
                        operation.name));
  const double process_scrap = plan.scrap_probability * scenario_.parts.front().value;
  if (!plan.edge || operation.tool.empty())
    return {machine_rate * plan.main_time_min + process_scrap, plan.main_time_min, 0};
  const Tool& tool = *scenarios::find_named(scenario_.tools, operation.tool);
  const Insert insert = scenarios::prepared(*scenarios::find_named(scenario_.inserts, tool.insert));
  const Crew& crew = *scenarios::find_named(scenario_.crews, tool.crew);
  const LifeLaw life(insert.edge_life.law, plan.edge->mean_min, insert.edge_life.cv);
  const EdgeRates rates = std::visit(RatesOf{life, plan.main_time_min}, tool.strategy);
  const double changes_per_min = rates.planned_per_min + rates.failures_per_min;
  const double failing_share = rates.failures_per_min / changes_per_min;

  // Of the changes of one insert one is a replacement, the others index it.
  const double s = 1 - failing_share + failing_share * insert.reserve_ok_probability;
  const double replaces = 1 / edges_used_per_insert(insert.edges, s, insert.single_edge_probability);
  const double change_min = tool.change.positioning_min +
                            replaces * scenarios::mean_min(tool.change.replace) +
                            (1 - replaces) * scenarios::mean_min(tool.change.index);
  const double changing =
      changes_per_min * change_min + rates.failures_per_min * tool.change.failure_extra_min;

  const bool by_periods = tool.insert_booking == scenarios::InsertBooking::life_periods;
  const double insert_planned = by_periods ? insert.price / tool.periods_planned : insert.price * replaces;
  const double insert_failure = by_periods ? insert.price / tool.periods_failure : insert.price * replaces;
  const double scrap = tool.failure_scrap_probability * scenario_.parts.front().value;
  const double cost_per_min =
      (machine_rate + crew.rate_per_min) * changing +
      rates.planned_per_min * (insert_planned + tool.regrind_planned) +
      rates.failures_per_min * (insert_failure + tool.regrind_failure + tool.failure_damage + scrap);
  return {.cost_per_part = plan.main_time_min * (machine_rate + cost_per_min) + process_scrap,
          .time_per_part_min = plan.main_time_min * (1 + changing),
          .failures_per_part = plan.main_time_min * rates.failures_per_min};
}

double LongRunModel::cost_per_part() const {
  double total = 0;
  for (const std::string& name : scenario_.parts.front().route)
    total += operation_cost(*scenarios::find_named(scenario_.operations, name)).cost_per_part;
  return std::isfinite(total) ? total : std::numeric_limits<double>::infinity();
}

}  // namespace verstat::optimize
