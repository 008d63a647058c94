#include "optimize/renewal_reward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "models/math/life_law.h"
#include "scenarios/capacity.h"
#include "scenarios/input_error.h"
#include "scenarios/route.h"

namespace verstat::optimize {

using models::LifeLaw;
using scenarios::Crew;
using scenarios::InputError;
using scenarios::Insert;
using scenarios::Operation;
using scenarios::Tool;

namespace {

// What happens to edges in the long run, per minute of cutting.
struct EdgeRates {
  double planned_per_min = 0;
  double failures_per_min = 0;
};

// Integral of R(t) exp(-rate t) over 0..tau: the mean time in use of an edge that also breaks by chance.
double thinned_restricted_mean(const LifeLaw& life, double rate, double tau_min) {
  // Gauss-Legendre of five points on panels no longer than a fifth of either time scale.
  constexpr std::array nodes{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                             -0.9061798459386640};
  constexpr std::array weights{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                               0.2369268850561891};
  const double end_min = std::min({tau_min, 40 / rate, life.quantile(1 - 1e-15)});
  const double panel_min = 0.2 * std::min(life.mean(), 1 / rate);
  const int panels = std::clamp(static_cast<int>(std::ceil(end_min / panel_min)), 8, 2000);
  const double h = 0.5 * end_min / panels;
  double sum = 0;
  for (int p = 0; p < panels; ++p)
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double t = (2 * p + 1 + nodes[k]) * h;
      sum += weights[k] * h * life.reliability(t) * std::exp(-rate * t);
    }
  return sum;
}

struct RatesOf {
  const LifeLaw& life;  // at the regime
  double main_time_min;
  double breaks_per_min = 0;  // by chance, besides wear

  [[nodiscard]] EdgeRates aged(double tau_min) const {
    if (breaks_per_min > 0) {
      const double used_min = thinned_restricted_mean(life, breaks_per_min, tau_min);
      const double planned =
          std::isfinite(tau_min) ? life.reliability(tau_min) * std::exp(-breaks_per_min * tau_min) : 0;
      return {planned / used_min, (1 - planned) / used_min};
    }
    const double used_min = life.restricted_mean(tau_min);
    return {life.reliability(tau_min) / used_min, life.failure_probability(tau_min) / used_min};
  }
  EdgeRates operator()(const scenarios::RunToFailure&) const {
    if (breaks_per_min > 0) return aged(std::numeric_limits<double>::infinity());
    return {0, 1 / life.mean_life()};
  }
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
    if (breaks_per_min > 0)
      throw InputError("",
                       "block replacement of a tool that also breaks by chance is left to the simulation");
    return {1 / period_min, life.renewal_function(period_min) / period_min};
  }
  // Strategies without long-run rates.
  template <class Other>
  EdgeRates operator()(const Other&) const {
    throw InputError(
        "", fmt::format("the long-run model does not cover the strategy \"{}\": it is left to the simulation",
                        Other::kind));
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

namespace {

// Life laws are solved from mean and scatter: kept while the scatter stands.
struct KnownLaw {
  models::LifeLawKind kind = models::LifeLawKind::weibull;
  double cv = 0;
  std::optional<LifeLaw> unit;
};

template <class T>
std::size_t position(const std::vector<T>& all, const std::string& name) {
  return static_cast<std::size_t>(scenarios::find_named(all, name) - all.data());
}

}  // namespace

struct LongRunModel::Cache {
  struct OperationAt {
    std::size_t machine = 0;
    std::optional<std::size_t> tool;
  };
  struct ToolAt {
    std::size_t insert = 0;
    std::size_t crew = 0;
    KnownLaw law;
  };
  std::vector<OperationAt> operations;
  std::vector<ToolAt> tools;
  std::vector<scenarios::Route> routes;
  // Part types with blanks always at hand, by the group of their first operation.
  std::vector<std::vector<std::size_t>> unlimited;
};

LongRunModel::~LongRunModel() = default;

namespace {

[[noreturn]] void leave_to_simulation(const std::string& pointer, const std::string& why) {
  throw InputError(pointer,
                   fmt::format("{}: {}, which the long-run model leaves to the simulation", pointer, why));
}

// What stops, blocks or hurries a shop in ways that only a simulation tells.
void check_covered(const scenarios::Scenario& s) {
  for (std::size_t k = 0; k < s.machines.size(); ++k) {
    const scenarios::Machine& m = s.machines[k];
    const std::string at = fmt::format("/machines/{}", k);
    if (!m.failures.empty()) leave_to_simulation(at + "/failures", "the machine fails");
    if (!m.maintenance.empty()) leave_to_simulation(at + "/maintenance", "the machine is maintained");
    if (m.setup) leave_to_simulation(at + "/setup", "the machine is set up between families");
    if (m.attendance) leave_to_simulation(at + "/attendance", "the machine needs an operator");
    if (!m.calendar.empty()) leave_to_simulation(at + "/calendar", "the machine works by a calendar");
    if (m.queue_capacity) leave_to_simulation(at + "/queue_capacity", "a full queue blocks");
    if (m.switch_off) leave_to_simulation(at + "/switch_off", "the machine is switched off");
    const scenarios::Power& power = m.power;
    if (s.energy_price_per_kwh > 0 &&
        power.cutting_kw + power.working_kw + power.standby_kw + power.off_kw > 0)
      leave_to_simulation(at + "/power", "energy is paid for");
  }
  for (std::size_t k = 0; k < s.operations.size(); ++k) {
    const Operation& o = s.operations[k];
    const std::string at = fmt::format("/operations/{}", k);
    if (scenarios::groups_of(s, o).size() > 1)
      leave_to_simulation(at, "several machine groups share the operation");
    if (o.inspection) leave_to_simulation(at + "/inspection", "parts are inspected");
    if (o.quality && (o.quality->defect_probability > 0 || o.quality->defect_when_worn > 0))
      leave_to_simulation(at + "/quality", "defects stay hidden");
  }
  for (std::size_t k = 0; k < s.tools.size(); ++k) {
    const Crew* crew = scenarios::find_named(s.crews, s.tools[k].crew);
    const std::string at = fmt::format("/tools/{}/crew", k);
    if (crew == nullptr) leave_to_simulation(at, "several crews may change edges");
    if (!crew->calendar.empty()) leave_to_simulation(at, "the crew works by a calendar");
    const scenarios::Tool& tool = s.tools[k];
    const Insert* insert = scenarios::find_named(s.inserts, tool.insert);
    if (insert != nullptr && insert->lots)
      leave_to_simulation(fmt::format("/tools/{}/insert", k), "its inserts come in lots that differ");
    if (tool.teeth > 1 || scenarios::changed_off_line(tool) || !tool.elements.empty())
      leave_to_simulation(fmt::format("/tools/{}", k), "the tool has teeth, copies or elements of its own");
    if (crew->walking_min > 0) leave_to_simulation(at, "the crew walks to the machines");
  }
  for (std::size_t k = 0; k < s.crews.size(); ++k)
    if (s.crews[k].pay == scenarios::CrewPay::shift && !s.crews[k].calendar.empty())
      leave_to_simulation(fmt::format("/crews/{}/calendar", k), "the crew works by a calendar");
  for (std::size_t k = 0; k < s.stores.size(); ++k)
    if (s.stores[k].capacity || s.stores[k].demand)
      leave_to_simulation(fmt::format("/stores/{}", k), "the store fills or runs empty");
  if (!s.transport.empty()) leave_to_simulation("/transport", "parts are carried");
  for (std::size_t k = 0; k < s.parts.size(); ++k) {
    const scenarios::PartType& part = s.parts[k];
    const std::string at = fmt::format("/parts/{}", k);
    if (!std::holds_alternative<scenarios::Push>(part.release))
      leave_to_simulation(at + "/release", "the release is held back");
    if (part.tardiness_cost_per_min > 0)
      leave_to_simulation(at + "/tardiness_cost_per_min", "late parts cost");
    if (part.batch_size > 1) leave_to_simulation(at + "/batch_size", "parts move in batches");
    for (const scenarios::RouteStep& step : scenarios::route_of(s, part)) {
      if (!step.assembles.empty() || !step.yields.empty())
        leave_to_simulation(at + "/steps", "parts are put together or divided");
      if (step.rework != scenarios::route_end) leave_to_simulation(at + "/steps", "parts are reworked");
      if (step.next.size() > 1 && step.choice == scenarios::BranchChoice::shortest_queue)
        leave_to_simulation(at + "/steps", "parts choose the shortest queue");
    }
  }
}

}  // namespace

LongRunModel::LongRunModel(const scenarios::Scenario& scenario)
    : scenario_(scenario), cache_(std::make_unique<Cache>()) {
  check_covered(scenario);
  for (const Operation& operation : scenario.operations) {
    Cache::OperationAt at{scenarios::groups_of(scenario, operation).front(), {}};
    if (!operation.tool.empty()) at.tool = position(scenario.tools, operation.tool);
    cache_->operations.push_back(at);
  }
  for (const Tool& tool : scenario.tools)
    cache_->tools.push_back(
        {position(scenario.inserts, tool.insert), position(scenario.crews, tool.crew), {}});
  cache_->unlimited.resize(scenario.machines.size());
  for (std::size_t p = 0; p < scenario.parts.size(); ++p) {
    cache_->routes.push_back(scenarios::route_of(scenario, scenario.parts[p]));
    if (!scenarios::arrival_rate_per_min(scenario, scenario.parts[p]))
      cache_->unlimited[cache_->operations[cache_->routes[p].front().operation].machine].push_back(p);
  }
  (void)evaluate();  // says now what it does not cover
}

OperationCost LongRunModel::cost_of(std::size_t index, const operations::CutPlan& plan) const {
  const Cache::OperationAt& at = cache_->operations[index];
  const double machine_rate = scenario_.machines[at.machine].rate_per_min;
  const Operation& operation = scenario_.operations[index];
  const scenarios::Machine& machine = scenario_.machines[at.machine];
  double handling_min = 0;
  if (machine.loading) handling_min += scenarios::mean_min(*machine.loading);
  if (machine.unloading) handling_min += scenarios::mean_min(*machine.unloading);
  OperationCost cost{.cost_per_part = machine_rate * (plan.main_time_min + handling_min) + operation.cost,
                     .time_per_part_min = plan.main_time_min + handling_min,
                     .survival = 1 - plan.scrap_probability};
  if (operation.quality) cost.survival *= 1 - operation.quality->scrap_probability;
  if (!plan.edge || !at.tool) return cost;
  const Tool& tool = scenario_.tools[*at.tool];
  Cache::ToolAt& tool_at = cache_->tools[*at.tool];
  const Insert& delivered = scenario_.inserts[tool_at.insert];
  std::optional<Insert> treated;
  if (delivered.preparation) treated = scenarios::prepared(delivered);
  const Insert& insert = treated ? *treated : delivered;
  const Crew& crew = scenario_.crews[tool_at.crew];
  KnownLaw& known = tool_at.law;
  if (!known.unit || known.kind != insert.edge_life.law || known.cv != insert.edge_life.cv)
    known = {insert.edge_life.law, insert.edge_life.cv,
             LifeLaw(insert.edge_life.law, 1.0, insert.edge_life.cv)};
  const LifeLaw life = known.unit->with_mean(plan.edge->mean_min);
  const double breaks_per_min =
      plan.breakage_probability > 0
          ? -std::log1p(-std::min(plan.breakage_probability, 1 - 1e-12)) / plan.main_time_min
          : 0;
  const EdgeRates rates = std::visit(RatesOf{life, plan.main_time_min, breaks_per_min}, tool.strategy);
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
  const double wage = crew.pay == scenarios::CrewPay::busy ? crew.rate_per_min : 0;
  const double cost_per_min =
      (machine_rate + wage) * changing + rates.planned_per_min * (insert_planned + tool.regrind_planned) +
      rates.failures_per_min * (insert_failure + tool.regrind_failure + tool.failure_damage);
  cost.cost_per_part += plan.main_time_min * cost_per_min;
  cost.changing_per_part_min = plan.main_time_min * changing;
  cost.time_per_part_min += cost.changing_per_part_min;
  cost.crew_per_part_min = cost.changing_per_part_min;
  cost.failures_per_part = plan.main_time_min * rates.failures_per_min;
  cost.changes_per_part = plan.main_time_min * changes_per_min;
  cost.inserts_per_part = cost.changes_per_part * replaces;
  // Failures within one part are nearly Poisson; each spoils it with the stated probability.
  cost.survival *= std::exp(-cost.failures_per_part * tool.failure_scrap_probability);
  return cost;
}

OperationCost LongRunModel::operation_cost(const Operation& operation) const {
  return cost_of(static_cast<std::size_t>(&operation - scenario_.operations.data()),
                 scenarios::plan(scenario_, operation));
}

// Rates of parts through the shop, then what they cost. Good parts leave a group as fast as it works: in an
// overloaded one queues grow and its customers share what it does.
void LongRunModel::flow(LongRun& run) const {
  const Cache& c = *cache_;
  const std::size_t groups = scenario_.machines.size();
  std::vector<std::vector<double>> in;  // parts per minute that come to step k of part type p
  for (std::size_t p = 0; p < c.routes.size(); ++p) {
    in.emplace_back(c.routes[p].size(), 0.0);
    in[p][0] = scenarios::arrival_rate_per_min(scenario_, scenario_.parts[p]).value_or(0);
  }
  const auto work = [&](std::size_t group) {
    double sum = 0;
    for (std::size_t p = 0; p < c.routes.size(); ++p)
      for (std::size_t k = 0; k < c.routes[p].size(); ++k)
        if (c.operations[c.routes[p][k].operation].machine == group)
          sum += in[p][k] * run.operations[c.routes[p][k].operation].time_per_part_min;
    return sum;
  };
  std::vector<double> pace(groups, 1.0);  // share of the work that comes and is done
  constexpr int most_rounds = 300;
  for (int round = 0; round < most_rounds; ++round) {
    // Rates that chase each other round a loop of the routes settle when they move half way.
    const double step = round < 60 ? 1.0 : 0.5;
    double moved = 0;
    const auto set = [&](double& rate, double to) {
      const double value = rate + step * (to - rate);
      moved = std::max(moved, std::abs(value - rate) / std::max(std::abs(value), 1e-300));
      rate = value;
    };
    for (std::size_t g = 0; g < groups; ++g) {
      const auto count = static_cast<double>(scenario_.machines[g].count);
      if (!c.unlimited[g].empty()) {
        double own = 0;    // work of one blank of every type
        double first = 0;  // work of the blanks at their present rate
        for (const std::size_t p : c.unlimited[g]) {
          const double time_min = run.operations[c.routes[p][0].operation].time_per_part_min;
          own += time_min;
          first += in[p][0] * time_min;
        }
        const double rate = std::max(0.0, count - (work(g) - first)) / own;
        for (const std::size_t p : c.unlimited[g]) set(in[p][0], rate);
      }
      const double load = work(g) / count;
      pace[g] = load > 1 + 1e-12 ? 1 / load : 1.0;
    }
    for (std::size_t p = 0; p < c.routes.size(); ++p) {
      const scenarios::Route& route = c.routes[p];
      // What leaves every step good, by branches; blanks come to the first step besides.
      std::vector<double> comes(route.size(), 0.0);
      for (std::size_t k = 0; k < route.size(); ++k) {
        const std::size_t o = route[k].operation;
        const double out = in[p][k] * pace[c.operations[o].machine] * run.operations[o].survival;
        for (const scenarios::RouteBranch& branch : route[k].next)
          if (branch.to != scenarios::route_end) comes[branch.to] += out * branch.probability;
      }
      for (std::size_t k = 1; k < route.size(); ++k) set(in[p][k], comes[k]);
    }
    if (moved < 1e-13) break;
  }

  run.operation_rate_per_min.assign(scenario_.operations.size(), 0.0);
  double good = 0;
  double finished = 0;
  double scrap_cost = 0;  // per minute
  for (std::size_t p = 0; p < c.routes.size(); ++p)
    for (std::size_t k = 0; k < c.routes[p].size(); ++k) {
      const std::size_t o = c.routes[p][k].operation;
      const double done = in[p][k] * pace[c.operations[o].machine];
      run.operation_rate_per_min[o] += done;
      const double survival = run.operations[o].survival;
      double ends = 0;
      for (const scenarios::RouteBranch& branch : c.routes[p][k].next)
        if (branch.to == scenarios::route_end) ends += branch.probability;
      finished += ends == 1 ? done : done * (1 - survival + survival * ends);
      good += done * survival * ends;
      // Per failure, as K117 books it, and per part that the process itself spoils.
      const double tool_scrap = c.operations[o].tool
                                    ? run.operations[o].failures_per_part *
                                          scenario_.tools[*c.operations[o].tool].failure_scrap_probability
                                    : 0;
      const auto& quality = scenario_.operations[o].quality;
      const double process_scrap =
          1 - (1 - run.plans[o].scrap_probability) * (quality ? 1 - quality->scrap_probability : 1.0);
      scrap_cost += done * scenario_.parts[p].value * (tool_scrap + process_scrap);
    }
  run.machines.assign(groups, {});
  double idle_cost = 0;  // per minute
  for (std::size_t g = 0; g < groups; ++g) {
    const auto count = static_cast<double>(scenario_.machines[g].count);
    run.machines[g].load = work(g) / count;
    double changing = 0;
    double busy = 0;
    for (std::size_t o = 0; o < c.operations.size(); ++o)
      if (c.operations[o].machine == g) {
        busy += run.operation_rate_per_min[o] * run.operations[o].time_per_part_min;
        changing += run.operation_rate_per_min[o] * run.operations[o].changing_per_part_min;
      }
    run.machines[g].changing = busy > 0 ? changing / busy : 0;
    const double idle = count - busy;
    if (idle > 1e-12 * count) idle_cost += idle * scenario_.machines[g].rate_per_min;
    if (run.machines[g].load > run.machines[run.bottleneck].load) run.bottleneck = g;
  }
  double shift_cost = 0;  // per minute
  for (const Crew& crew : scenario_.crews)
    if (crew.pay == scenarios::CrewPay::shift)
      shift_cost += crew.rate_per_min * static_cast<double>(crew.members);

  constexpr double none = std::numeric_limits<double>::infinity();
  double per_part = (scrap_cost + idle_cost + shift_cost) / finished;
  for (std::size_t o = 0; o < c.operations.size(); ++o)
    per_part += run.operation_rate_per_min[o] / finished * run.operations[o].cost_per_part;
  run.cost_per_part = finished > 0 && std::isfinite(per_part) ? per_part : none;
  run.cost_per_good_part = good > 0 ? run.cost_per_part * finished / good : none;
  run.throughput_per_h = 60 * good;
  run.quality_ratio = finished > 0 ? good / finished : 0;
}

LongRun LongRunModel::evaluate() const {
  LongRun run;
  for (std::size_t o = 0; o < scenario_.operations.size(); ++o) {
    run.plans.push_back(scenarios::plan(scenario_, scenario_.operations[o]));
    if (run.plans.back().overload || run.plans.back().detection)
      leave_to_simulation(fmt::format("/operations/{}", o), "the drive trips, or parts are inspected");
    run.operations.push_back(cost_of(o, run.plans.back()));
  }
  flow(run);
  return run;
}

std::vector<std::string> LongRunModel::kpis() const {
  std::vector<std::string> names{"cost_per_part", "cost_per_good_part", "throughput_per_h", "quality_ratio"};
  for (const auto& machine : scenario_.machines) names.push_back("load/" + machine.name);
  for (const Tool& tool : scenario_.tools) {
    names.push_back(fmt::format("tool/{}/failure_share", tool.name));
    names.push_back(fmt::format("tool/{}/inserts_per_100_parts", tool.name));
  }
  return names;
}

std::optional<std::size_t> LongRunModel::kpi(const std::string& name) const {
  const auto names = kpis();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

double LongRunModel::value(const LongRun& run, std::size_t kpi) const {
  const std::array whole{run.cost_per_part, run.cost_per_good_part, run.throughput_per_h, run.quality_ratio};
  if (kpi < whole.size()) return whole[kpi];
  kpi -= whole.size();
  if (kpi < run.machines.size()) return run.machines[kpi].load;
  kpi -= run.machines.size();
  double failures = 0;
  double changes = 0;
  double inserts = 0;
  for (std::size_t o = 0; o < run.operations.size(); ++o) {
    if (cache_->operations[o].tool != kpi / 2) continue;
    const double rate = run.operation_rate_per_min[o];
    failures += rate * run.operations[o].failures_per_part;
    changes += rate * run.operations[o].changes_per_part;
    inserts += rate * run.operations[o].inserts_per_part;
  }
  if (kpi % 2 == 0) return changes > 0 ? failures / changes : 0;
  const double finished_per_min = run.throughput_per_h / 60 / run.quality_ratio;
  return 100 * inserts / finished_per_min;
}

}  // namespace verstat::optimize
