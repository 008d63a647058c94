// The textbook's optimum of one cut beside what the shop wants, and why they differ.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "optimize/analysis.h"
#include "sim/shop/kpis.h"

namespace verstat::optimize {

double taylor_life_min_cost(double mu, double change_min, double change_cost, double machine_rate) {
  return (mu - 1) * (change_min + change_cost / machine_rate);
}

namespace {

// What the shop does to one operation, by the long run, and by the simulated plan where there is one.
struct Circumstances {
  double load = 0;             // of its machines
  std::size_t bottleneck = 0;  // the group with the largest load
  double failing = 0;          // share of the changes that come after a failure
  double waits_for_crew = 0;   // share of the tool's time
  double waits_for_stock = 0;  // of the tool's time waiting for tools, of the machine's time blocked
  bool blocked = false;        // it is the machine that waits, for room behind it
};

// Mean of a KPI of machines over a group.
std::optional<double> of_group(const shop::RunResult& run, const scenarios::Machine& group, const char* kpi) {
  double sum = 0;
  int count = 0;
  for (std::int64_t k = 0; k < group.count; ++k) {
    const auto at = run.index_of(fmt::format("machine/{}/{}", shop::machine_name(group, k), kpi));
    if (!at || !run.estimates[*at].mean) continue;
    sum += *run.estimates[*at].mean;
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

double of_tool(const shop::RunResult& run, const std::string& tool, const char* kpi) {
  const auto k = run.index_of(fmt::format("tool/{}/{}", tool, kpi));
  return k ? run.estimates[*k].mean.value_or(0) : 0;
}

std::string reason(const scenarios::Scenario& shop, const scenarios::Machine& machine,
                   const scenarios::Tool& tool, const OneCut& cut, const Circumstances& c) {
  constexpr double noticeable = 0.02;
  const double v = cut.speed_shop_m_min;
  const bool several = shop.machines.size() > 1;
  const auto group = static_cast<std::size_t>(&machine - shop.machines.data());
  if (several && group == c.bottleneck && v > cut.speed_min_cost_m_min)
    return fmt::format("bottleneck: {} limits the shop, its minutes are worth more than its rate",
                       machine.name);
  const bool slower = v < cut.speed_min_cost_m_min;
  if (slower && c.waits_for_crew > noticeable && c.waits_for_crew > c.waits_for_stock)
    return fmt::format("crew: {:.0f} % of its time it waits for {}, so that every change saved saves a wait",
                       100 * c.waits_for_crew, tool.crew);
  if (slower && c.waits_for_stock > noticeable)
    return c.blocked ? fmt::format(
                           "stock: {:.0f} % of its time {} stands because there is no room behind it: "
                           "slower cutting saves edges and costs nothing",
                           100 * c.waits_for_stock, machine.name)
                     : fmt::format(
                           "stock: {:.0f} % of its time it waits for tools or inserts, so that every "
                           "edge saved saves a wait",
                           100 * c.waits_for_stock);
  if (slower && c.load < 0.98)
    return several && group != c.bottleneck
               ? fmt::format(
                     "bottleneck: {} limits the shop and {} has {:.0f} % of its time to spare: slower "
                     "cutting saves edges and costs nothing",
                     shop.machines[c.bottleneck].name, machine.name, 100 * (1 - c.load))
               : fmt::format(
                     "demand: {} has {:.0f} % of its time to spare: slower cutting saves edges and costs "
                     "nothing",
                     machine.name, 100 * (1 - c.load));
  if (slower && c.failing > noticeable)
    return fmt::format("failures: {:.0f} % of the changes come after one, which the textbook does not price",
                       100 * c.failing);
  if (v > cut.speed_max_rate_m_min)
    return "faster than the textbook's largest rate: the plan is held there by its bounds or another aim";
  return slower ? "slower than the textbook's least cost: bounds, limits or another aim hold the plan there"
                : "between smallest cost and largest rate";
}

}  // namespace

std::vector<OneCut> one_cut_optima(const scenarios::Scenario& plan, const shop::RunResult* simulated) {
  std::vector<OneCut> all;
  scenarios::Scenario shop = plan;  // its speeds are moved to and fro
  std::optional<LongRun> run;
  try {
    run = LongRunModel(shop).evaluate();
  } catch (const std::exception&) {
    // The simulation alone knows its loads.
  }
  if (!run && simulated == nullptr) return all;
  std::vector<double> loads;
  for (std::size_t g = 0; g < shop.machines.size(); ++g) {
    std::optional<double> load;
    if (simulated != nullptr) load = of_group(*simulated, shop.machines[g], "utilization");
    loads.push_back(run ? run->machines[g].load : load.value_or(0));
  }
  const auto bottleneck =
      static_cast<std::size_t>(std::max_element(loads.begin(), loads.end()) - loads.begin());

  for (std::size_t o = 0; o < shop.operations.size(); ++o) {
    const auto& operation = shop.operations[o];
    if (operation.tool.empty()) continue;
    const std::vector<std::string> path{"operations", std::to_string(o), "process", "cutting_speed_m_min"};
    double* speed = models::locate_in_fields(&shop, scenarios::scenario_fields(), path);
    if (speed == nullptr || !(*speed > 0)) continue;
    const double v = *speed;
    constexpr double h = 1e-4;
    operations::CutPlan here;
    operations::CutPlan slow;
    operations::CutPlan fast;
    try {
      here = scenarios::plan(shop, operation);
      *speed = v * std::exp(-h);
      slow = scenarios::plan(shop, operation);
      *speed = v * std::exp(h);
      fast = scenarios::plan(shop, operation);
    } catch (const std::exception&) {
      *speed = v;
      continue;  // at the edge of the models' range
    }
    *speed = v;
    if (!here.edge) continue;
    const double mu = (std::log(slow.edge->mean_min) - std::log(fast.edge->mean_min)) / (2 * h);
    const double time_exponent = (std::log(slow.main_time_min) - std::log(fast.main_time_min)) / (2 * h);
    if (!(mu > 1) || std::abs(time_exponent - 1) > 0.02) continue;

    const auto& tool = *scenarios::find_named(shop.tools, operation.tool);
    if (tool.insert.empty()) continue;
    const auto insert = scenarios::prepared(*scenarios::find_named(shop.inserts, tool.insert));
    const auto* crew = scenarios::find_named(shop.crews, tool.crew);  // several may have the skill
    const auto& machine = shop.machines[scenarios::groups_of(shop, operation).front()];
    if (!(machine.rate_per_min > 0)) continue;
    // A planned change: of the n edges of an insert one is fitted, the others are indexed to.
    const double replaces = 1 / edges_used_per_insert(insert.edges, 1.0, insert.single_edge_probability);
    const auto teeth = static_cast<double>(tool.teeth);
    const double change_min = tool.change.positioning_min + tool.change.stop_min +
                              teeth * (replaces * scenarios::mean_min(tool.change.replace) +
                                       (1 - replaces) * scenarios::mean_min(tool.change.index));
    const double edge = teeth * (tool.insert_booking == scenarios::InsertBooking::life_periods
                                     ? insert.price / tool.periods_planned
                                     : insert.price * replaces);
    const double wage =
        crew != nullptr && crew->pay == scenarios::CrewPay::busy ? crew->rate_per_min * change_min : 0;
    OneCut cut{.operation = operation.name,
               .life_min_cost_min = taylor_life_min_cost(mu, change_min, edge + wage + tool.regrind_planned,
                                                         machine.rate_per_min),
               .life_max_rate_min = taylor_life_min_cost(mu, change_min, 0, machine.rate_per_min),
               .speed_shop_m_min = v,
               .life_shop_min = here.edge->mean_min};
    cut.speed_min_cost_m_min = v * std::pow(here.edge->mean_min / cut.life_min_cost_min, 1 / mu);
    cut.speed_max_rate_m_min = v * std::pow(here.edge->mean_min / cut.life_max_rate_min, 1 / mu);
    const auto group = static_cast<std::size_t>(&machine - shop.machines.data());
    Circumstances c{.load = loads[group], .bottleneck = bottleneck};
    if (run) {
      const OperationCost& cost = run->operations[o];
      c.failing = cost.changes_per_part > 0 ? cost.failures_per_part / cost.changes_per_part : 0;
    }
    if (simulated != nullptr) {
      if (!run) c.failing = of_tool(*simulated, tool.name, "failure_share");
      c.waits_for_crew = of_tool(*simulated, tool.name, "waiting_crew_share");
      c.waits_for_stock = of_tool(*simulated, tool.name, "waiting_tool_share");
      const double blocked = of_group(*simulated, machine, "state/blocked").value_or(0);
      c.blocked = blocked > c.waits_for_stock;
      c.waits_for_stock = std::max(blocked, c.waits_for_stock);
    }
    cut.load = c.load;
    cut.waits_for_crew = c.waits_for_crew;
    cut.waits_for_stock = c.waits_for_stock;
    cut.why = reason(shop, machine, tool, cut, c);
    all.push_back(std::move(cut));
  }
  return all;
}

}  // namespace verstat::optimize
