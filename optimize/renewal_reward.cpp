#include "optimize/renewal_reward.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "models/math/life_law.h"
#include "optimize/edge_rates.h"
#include "optimize/long_run_coverage.h"
#include "scenarios/calendar.h"
#include "scenarios/capacity.h"
#include "scenarios/input_error.h"
#include "scenarios/route.h"

namespace verstat::optimize {

using models::LifeLaw;
using scenarios::Crew;
using scenarios::Insert;
using scenarios::Machine;
using scenarios::Operation;
using scenarios::StopEffect;
using scenarios::Tool;
using scenarios::UsageClock;

namespace {

template <class N>
N edges_used(std::int64_t edges, const N& s, const N& p_single) {
  N several = 0;
  N reach = 1;
  for (std::int64_t k = 0; k < edges; ++k) {
    several += reach;
    reach *= s;
  }
  return p_single + (1 - p_single) * several;
}

}  // namespace

double edges_used_per_insert(std::int64_t edges, double s, double p_single) {
  return edges_used(edges, s, p_single);
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

constexpr std::size_t nobody = static_cast<std::size_t>(-1);
template <class T>
std::size_t position_or_none(const std::vector<T>& all, const std::string& name) {
  return name.empty() ? nobody : position(all, name);
}

}  // namespace

struct LongRunModel::Cache {
  struct OperationAt {
    std::size_t machine = 0;
    std::optional<std::size_t> tool;
    std::size_t family = 0;
  };
  struct ToolAt {
    std::size_t insert = 0;
    std::size_t crew = 0;
    KnownLaw law;
  };
  // A way in which the machines of a group stop: a failure mode or a maintenance.
  struct StopAt {
    UsageClock clock = UsageClock::operating;
    StopEffect effect = StopEffect::at_once;
    std::size_t number = 0;  // among failures or maintenance
    bool failure = true;
    std::size_t crew = nobody;
    std::size_t spare = nobody;
  };
  struct GroupAt {
    std::vector<StopAt> stops;
    std::size_t setup_crew = nobody;
    std::size_t loading_crew = nobody;
    std::size_t overload_crew = nobody;
    std::size_t families = 0;
  };
  std::vector<OperationAt> operations;
  std::vector<ToolAt> tools;
  std::vector<GroupAt> groups;
  std::vector<std::string> families;
  std::vector<scenarios::Route> routes;
  // Part types with blanks always at hand, by the group of their first operation.
  std::vector<std::vector<std::size_t>> unlimited;
};

LongRunModel::~LongRunModel() = default;

// What the formulas take from the plan of an operation.
template <class N>
struct LongRunModel::PlanNumbers {
  N main_time_min = 0;
  N mean_life_min = 0;
  N breakage_probability = 0;
  N scrap_probability = 0;
  N trips_per_part = 0;
  N breaks_per_part = 0;

  explicit PlanNumbers(const operations::CutPlan& plan)
      : main_time_min(plan.main_time_min),
        mean_life_min(plan.edge ? plan.edge->mean_min : 0),
        breakage_probability(plan.breakage_probability),
        scrap_probability(plan.scrap_probability),
        trips_per_part(plan.overload ? plan.overload->trips_per_part : 0),
        breaks_per_part(plan.overload ? plan.overload->breaks_per_part : 0) {}
  PlanNumbers(const operations::CutPlan& plan, const PlanSlope& slope) : PlanNumbers(plan) {
    main_time_min.slope = slope.main_time_min;
    mean_life_min.slope = slope.mean_life_min;
    breakage_probability.slope = slope.breakage_probability;
    scrap_probability.slope = slope.scrap_probability;
    trips_per_part.slope = slope.trips_per_part;
    breaks_per_part.slope = slope.breaks_per_part;
  }
};

LongRunModel::LongRunModel(const scenarios::Scenario& scenario)
    : scenario_(scenario), cache_(std::make_unique<Cache>()) {
  check_covered(scenario);
  Cache& c = *cache_;
  for (const Operation& operation : scenario.operations) {
    Cache::OperationAt at{scenarios::groups_of(scenario, operation).front(), {}, 0};
    if (!operation.tool.empty()) at.tool = position(scenario.tools, operation.tool);
    const std::string& family = operation.family.empty() ? operation.name : operation.family;
    at.family = static_cast<std::size_t>(std::find(c.families.begin(), c.families.end(), family) -
                                         c.families.begin());
    if (at.family == c.families.size()) c.families.push_back(family);
    c.operations.push_back(at);
  }
  for (const Tool& tool : scenario.tools) {
    // Tools that no operation uses need no insert or crew.
    const Insert* insert = scenarios::find_named(scenario.inserts, tool.insert);
    const Crew* crew = scenarios::find_named(scenario.crews, tool.crew);
    c.tools.push_back({insert == nullptr ? nobody : position(scenario.inserts, tool.insert),
                       crew == nullptr ? nobody : position(scenario.crews, tool.crew),
                       {}});
  }
  for (std::size_t g = 0; g < scenario.machines.size(); ++g) {
    const Machine& machine = scenario.machines[g];
    Cache::GroupAt at;
    for (std::size_t k = 0; k < machine.failures.size(); ++k) {
      const auto& mode = machine.failures[k];
      at.stops.push_back({mode.clock, mode.effect, k, true, position_or_none(scenario.crews, mode.crew),
                          position_or_none(scenario.spares, mode.spare)});
    }
    for (std::size_t k = 0; k < machine.maintenance.size(); ++k) {
      const auto& job = machine.maintenance[k];
      at.stops.push_back({job.clock, job.effect, k, false, position_or_none(scenario.crews, job.crew),
                          position_or_none(scenario.spares, job.spare)});
    }
    if (machine.setup) at.setup_crew = position_or_none(scenario.crews, machine.setup->crew);
    if (machine.attendance) at.loading_crew = position_or_none(scenario.crews, machine.attendance->crew);
    if (machine.overload) at.overload_crew = position_or_none(scenario.crews, machine.overload->crew);
    std::vector<bool> has(c.families.size(), false);
    for (const auto& operation : c.operations)
      if (operation.machine == g && !has[operation.family]) {
        has[operation.family] = true;
        ++at.families;
      }
    c.groups.push_back(std::move(at));
  }
  c.unlimited.resize(scenario.machines.size());
  for (std::size_t p = 0; p < scenario.parts.size(); ++p) {
    c.routes.push_back(scenarios::route_of(scenario, scenario.parts[p]));
    if (!scenarios::arrival_rate_per_min(scenario, scenario.parts[p]))
      c.unlimited[c.operations[c.routes[p].front().operation].machine].push_back(p);
  }
  (void)evaluate();  // says now what it does not cover
}

namespace {

// Paid by the minute worked; the share of a member who tends several machines.
template <class N>
N wage_of(const scenarios::Scenario& s, std::size_t crew, const Reading<N>& read) {
  if (crew == nobody || s.crews[crew].pay != scenarios::CrewPay::busy) return 0.0;
  return read(s.crews[crew].rate_per_min);
}
template <class N>
N walking_of(const scenarios::Scenario& s, std::size_t crew, const Reading<N>& read) {
  if (crew == nobody) return 0.0;
  return read(s.crews[crew].walking_min);
}

}  // namespace

template <class N>
OperationOf<N> LongRunModel::cost_of(std::size_t index, const operations::CutPlan& plan,
                                     const PlanNumbers<N>& numbers, const Reading<N>& read) const {
  const Cache::OperationAt& at = cache_->operations[index];
  const Cache::GroupAt& group = cache_->groups[at.machine];
  const Operation& operation = scenario_.operations[index];
  const Machine& machine = scenario_.machines[at.machine];
  const N machine_rate = read(machine.rate_per_min);
  const N& main_time_min = numbers.main_time_min;
  N handling_min = 0;
  for (const auto* handling : {&machine.loading, &machine.unloading})
    if (*handling)
      handling_min += mean_of(**handling, read) + walking_of(scenario_, group.loading_crew, read);
  OperationOf<N> cost{.cost_per_part = machine_rate * (main_time_min + handling_min) + read(operation.cost),
                      .time_per_part_min = main_time_min + handling_min,
                      .process_survival = 1 - numbers.scrap_probability};
  if (operation.quality) cost.process_survival *= 1 - read(operation.quality->scrap_probability);
  if (group.loading_crew != nobody && value_of(handling_min) > 0) {
    const N hands_min =
        handling_min / static_cast<double>(scenario_.crews[group.loading_crew].machines_per_member);
    cost.crew_per_part_min += hands_min;
    cost.cost_per_part += hands_min * wage_of(scenario_, group.loading_crew, read);
  }

  N mean_failures = 0;  // of edges, per part
  if (plan.edge && at.tool && cache_->tools[*at.tool].insert != nobody) {
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
    N breaks_per_min = 0;
    if (plan.breakage_probability > 0) {
      const N breakage = plan.breakage_probability < 1 - 1e-12 ? numbers.breakage_probability : N(1 - 1e-12);
      breaks_per_min = -log_one_plus(-breakage) / main_time_min;
    }
    const EdgeRates<N> rates = std::visit(
        RatesOf<N>{{life, numbers.mean_life_min}, main_time_min, breaks_per_min, read}, tool.strategy);
    const N changes_per_min = rates.planned_per_min + rates.failures_per_min;
    const N failing_share = rates.failures_per_min / changes_per_min;

    // Of the changes of one insert one is a replacement, the others index it.
    const N s = 1 - failing_share + failing_share * read(insert.reserve_ok_probability);
    const N replaces = 1 / edges_used(insert.edges, s, read(insert.single_edge_probability));
    const N change_min = read(tool.change.positioning_min) + replaces * mean_of(tool.change.replace, read) +
                         (1 - replaces) * mean_of(tool.change.index, read) + read(crew.walking_min);
    const N changing =
        changes_per_min * change_min + rates.failures_per_min * read(tool.change.failure_extra_min);

    const bool by_periods = tool.insert_booking == scenarios::InsertBooking::life_periods;
    const N price = read(insert.price);
    const N insert_planned = by_periods ? price / read(tool.periods_planned) : price * replaces;
    const N insert_failure = by_periods ? price / read(tool.periods_failure) : price * replaces;
    const N wage = wage_of(scenario_, tool_at.crew, read);
    const N cost_per_min =
        (machine_rate + wage) * changing +
        rates.planned_per_min * (insert_planned + read(tool.regrind_planned)) +
        rates.failures_per_min * (insert_failure + read(tool.regrind_failure) + read(tool.failure_damage));
    cost.cost_per_part += main_time_min * cost_per_min;
    cost.changing_per_part_min = main_time_min * changing;
    cost.time_per_part_min += cost.changing_per_part_min;
    cost.crew_per_part_min += cost.changing_per_part_min;
    cost.failures_per_part = main_time_min * rates.failures_per_min;
    cost.changes_per_part = main_time_min * changes_per_min;
    cost.inserts_per_part = cost.changes_per_part * replaces;
    mean_failures = cost.failures_per_part * read(tool.failure_scrap_probability);
  }

  // Guide pads, wheels, laps: one change per mean time in use of each.
  bool cuts = plan.edge.has_value() && at.tool.has_value();
  if (at.tool)
    for (const scenarios::ElementService& service : scenario_.tools[*at.tool].elements)
      for (const operations::ElementLife& element : plan.more_elements) {
        if (service.element != element.element) continue;
        cuts = true;
        const LifeLaw unit(element.law, 1.0, element.cv);
        const LifeOf<N> life{unit, N(1)};
        const N used_min =
            element.mean_min * (service.gamma
                                    ? life.restricted_mean(life.gamma_percent_life(read(*service.gamma)))
                                    : life.mean_life());
        const N changes = main_time_min / used_min;
        const std::size_t crew = cache_->tools[*at.tool].crew;
        const N minutes = changes * (mean_of(service.change, read) + walking_of(scenario_, crew, read));
        cost.cost_per_part +=
            minutes * (machine_rate + wage_of(scenario_, crew, read)) + changes * read(service.price);
        cost.time_per_part_min += minutes;
        cost.changing_per_part_min += minutes;
        cost.crew_per_part_min += minutes;
      }

  N spoils = 0;  // mean number of stops that spoil the part
  // Stops that come with work on parts: one per mean life of their clock.
  const N undisturbed_min = cost.time_per_part_min;
  for (const Cache::StopAt& stop : group.stops) {
    const auto* failure = stop.failure ? &machine.failures[stop.number] : nullptr;
    const auto* maintenance = stop.failure ? nullptr : &machine.maintenance[stop.number];
    N interval = failure != nullptr ? mean_of(failure->time_to_failure, read) : read(maintenance->interval);
    if (stop.clock == UsageClock::calendar) {
      if (failure != nullptr && stop.effect == StopEffect::at_once)
        spoils += undisturbed_min / interval * read(failure->scrap_probability);
      continue;
    }
    N use = main_time_min;
    if (stop.clock == UsageClock::parts) {
      use = 1.0;
      interval = std::ceil(value_of(interval) - 1e-9);
    } else if (stop.clock == UsageClock::cutting && !cuts) {
      continue;
    } else if (stop.effect == StopEffect::after_part) {
      interval += 0.5 * main_time_min;
    }
    const N stops = use / interval;
    const N minutes = mean_of(failure != nullptr ? failure->repair : maintenance->duration, read) +
                      walking_of(scenario_, stop.crew, read);
    N each = (machine_rate + wage_of(scenario_, stop.crew, read)) * minutes;
    if (failure != nullptr) each += read(failure->damage);
    if (stop.spare != nobody) each += read(scenario_.spares[stop.spare].price);
    cost.cost_per_part += stops * each;
    cost.time_per_part_min += stops * minutes;
    if (stop.crew != nobody) cost.crew_per_part_min += stops * minutes;
    if (failure != nullptr && stop.effect == StopEffect::at_once && stop.clock != UsageClock::parts)
      spoils += stops * read(failure->scrap_probability);
  }
  if (plan.overload) {
    const N walk_min = walking_of(scenario_, group.overload_crew, read);
    const N wage = wage_of(scenario_, group.overload_crew, read);
    const bool called = !plan.overload->self_reset && group.overload_crew != nobody;
    const N reset_min = plan.overload->reset_min + (called ? walk_min : N(0));
    N minutes = numbers.trips_per_part * reset_min;
    cost.cost_per_part += minutes * (machine_rate + (called ? wage : N(0)));
    if (machine.overload) {
      const N repair_min = mean_of(machine.overload->repair, read) + walk_min;
      minutes += numbers.breaks_per_part * repair_min;
      cost.cost_per_part +=
          numbers.breaks_per_part * (repair_min * (machine_rate + wage) + read(machine.overload->damage));
      spoils += numbers.breaks_per_part * read(machine.overload->scrap_probability);
    }
    cost.time_per_part_min += minutes;
  }
  if (value_of(spoils) > 0) cost.process_survival *= exponential(-spoils);
  // Failures within one part are nearly Poisson; each spoils it with the stated probability.
  cost.survival = cost.process_survival * exponential(-mean_failures);
  return cost;
}

OperationCost LongRunModel::operation_cost(const Operation& operation) const {
  const operations::CutPlan plan = scenarios::plan(scenario_, operation);
  return cost_of<double>(static_cast<std::size_t>(&operation - scenario_.operations.data()), plan,
                         PlanNumbers<double>(plan), {});
}

// Rates of parts through the shop, then what they cost. Good parts leave a group as fast as it works: in an
// overloaded one queues grow and its customers share what it does.
template <class N>
class LongRunModel::Flow {
 public:
  Flow(const LongRunModel& model, LongRunOf<N>& run, const Reading<N>& read)
      : scenario_(model.scenario_), c_(*model.cache_), run_(run), read_(read) {
    for (const scenarios::Calendar& calendar : scenario_.calendars) hours_.push_back(hours_within(calendar));
    for (std::size_t g = 0; g < scenario_.machines.size(); ++g)
      calendar_stops_.push_back(stops_by_the_wall(g));
  }

  void settle() {
    const std::size_t groups = scenario_.machines.size();
    for (std::size_t p = 0; p < c_.routes.size(); ++p) {
      in_.emplace_back(c_.routes[p].size(), N(0));
      batches_.emplace_back(c_.routes[p].size(), N(0));
      in_[p][0] = scenarios::arrival_rate_per_min(scenario_, scenario_.parts[p]).value_or(0);
    }
    pace_.assign(groups, N(1));  // share of the work that comes and is done
    constexpr int most_rounds = 300;
    for (int round = 0; round < most_rounds; ++round) {
      // Rates that chase each other round a loop of the routes settle when they move half way.
      const double step = round < 60 ? 1.0 : 0.5;
      double moved = 0;
      const auto set = [&](N& rate, const N& to) {
        const N value = rate + step * (to - rate);
        moved = std::max(
            moved, std::abs(value_of(value) - value_of(rate)) / std::max(std::abs(value_of(value)), 1e-300));
        const double slope = std::abs(slope_of(value) - slope_of(rate));
        if (slope > 1e-11 * std::abs(slope_of(value))) moved = std::max(moved, 1.0);
        rate = value;
      };
      for (std::size_t g = 0; g < groups; ++g) {
        const N can = capacity(g);
        if (!c_.unlimited[g].empty()) {
          N own = 0;    // work of one batch of every type
          N first = 0;  // work of the blanks at their present rate
          for (const std::size_t p : c_.unlimited[g]) {
            const N& time_min = run_.operations[c_.routes[p][0].operation].time_per_part_min;
            own += size_of(p) * time_min;
            first += in_[p][0] * time_min;
          }
          const N left = can - (work(g) - first);
          const N rate = value_of(left) > 0 ? left / own : N(0);
          for (const std::size_t p : c_.unlimited[g]) set(in_[p][0], size_of(p) * rate);
        }
        const N load = work(g) / can;
        pace_[g] = value_of(load) > 1 + 1e-12 ? 1 / load : N(1);
      }
      for (std::size_t p = 0; p < c_.routes.size(); ++p) {
        const scenarios::Route& route = c_.routes[p];
        // What leaves every step good, by branches; blanks come to the first step besides.
        std::vector<N> comes(route.size(), N(0));
        std::vector<N> batches(route.size(), N(0));
        batches[0] = in_[p][0] / size_of(p);
        for (std::size_t k = 0; k < route.size(); ++k) {
          const std::size_t o = route[k].operation;
          const N& pace = pace_[c_.operations[o].machine];
          const N out = in_[p][k] * pace * run_.operations[o].survival;
          for (const scenarios::RouteBranch& branch : route[k].next)
            if (branch.to != scenarios::route_end) {
              comes[branch.to] += out * branch.probability;
              batches[branch.to] += batches_[p][k] * pace * branch.probability;
            }
        }
        for (std::size_t k = 1; k < route.size(); ++k) set(in_[p][k], comes[k]);
        for (std::size_t k = 0; k < route.size(); ++k) set(batches_[p][k], batches[k]);
      }
      if (moved < 1e-13) break;
    }
  }

  void price() {
    const std::size_t groups = scenario_.machines.size();
    run_.operation_rate_per_min.assign(scenario_.operations.size(), N(0));
    N good = 0;
    N finished = 0;
    N scrap_cost = 0;  // per minute
    for (std::size_t p = 0; p < c_.routes.size(); ++p)
      for (std::size_t k = 0; k < c_.routes[p].size(); ++k) {
        const std::size_t o = c_.routes[p][k].operation;
        const OperationOf<N>& operation = run_.operations[o];
        const N done = in_[p][k] * pace_[c_.operations[o].machine];
        run_.operation_rate_per_min[o] += done;
        double ends = 0;
        for (const scenarios::RouteBranch& branch : c_.routes[p][k].next)
          if (branch.to == scenarios::route_end) ends += branch.probability;
        finished += ends == 1 ? done : done * (1 - operation.survival + operation.survival * ends);
        good += done * operation.survival * ends;
        // Per failure, as K117 books it, and per part that the process itself or a stop spoils.
        N spoilt = 1 - operation.process_survival;
        if (c_.operations[o].tool)
          spoilt += operation.failures_per_part *
                    read_(scenario_.tools[*c_.operations[o].tool].failure_scrap_probability);
        scrap_cost += done * read_(scenario_.parts[p].value) * spoilt;
      }
    run_.machines.assign(groups, {});
    N other_cost = 0;  // per minute: idle machines, set-ups, stops by the clock on the wall
    for (std::size_t g = 0; g < groups; ++g) {
      const Machine& machine = scenario_.machines[g];
      const N rate = read_(machine.rate_per_min);
      run_.machines[g].load = work(g) / capacity(g);
      N changing = 0;
      N busy = 0;
      for (std::size_t o = 0; o < c_.operations.size(); ++o)
        if (c_.operations[o].machine == g) {
          busy += run_.operation_rate_per_min[o] * run_.operations[o].time_per_part_min;
          changing += run_.operation_rate_per_min[o] * run_.operations[o].changing_per_part_min;
        }
      run_.machines[g].changing = value_of(busy) > 0 ? changing / busy : N(0);
      // Set-ups and repairs are machine minutes like idle ones; what they cost besides comes on top.
      const N idle = on_shift(g) - busy;
      if (value_of(idle) > 1e-12 * static_cast<double>(machine.count)) other_cost += idle * rate;
      other_cost += setup(g).cost * pace_[g] + calendar_stops_[g].cost_per_min;
      if (value_of(run_.machines[g].load) > value_of(run_.machines[run_.bottleneck].load))
        run_.bottleneck = g;
    }
    N shift_cost = 0;  // per minute
    for (const Crew& crew : scenario_.crews) {
      if (crew.pay != scenarios::CrewPay::shift) continue;
      // By the month's wage where it is given: a study may move it.
      const N rate = crew.wages ? N(scenarios::wage_fund_per_min(crew)) : read_(crew.rate_per_min);
      shift_cost += rate * static_cast<double>(crew.members) * hours_of(crew.calendar).open_share;
    }

    constexpr double none = std::numeric_limits<double>::infinity();
    const bool any = value_of(finished) > 0;
    N per_part = (scrap_cost + other_cost + shift_cost) / finished;
    for (std::size_t o = 0; o < c_.operations.size(); ++o)
      per_part += run_.operation_rate_per_min[o] / finished * run_.operations[o].cost_per_part;
    run_.cost_per_part = any && std::isfinite(value_of(per_part)) ? per_part : N(none);
    run_.cost_per_good_part = value_of(good) > 0 ? run_.cost_per_part * finished / good : N(none);
    run_.throughput_per_h = 60 * good;
    run_.quality_ratio = any ? good / finished : N(0);
  }

 private:
  struct WallStops {
    N share = 0;         // of the group's time
    N cost_per_min = 0;  // besides machine minutes
  };
  // Of a calendar in an ordinary week; the hours are numbers that a study may move.
  struct Hours {
    double open_share = 1;
    double closings_per_min = 0;  // ends of shifts
  };
  struct SetupWork {
    N minutes = 0;  // machine minutes per minute
    N cost = 0;     // money per minute besides machine minutes
  };

  [[nodiscard]] double size_of(std::size_t part) const {
    return static_cast<double>(scenario_.parts[part].batch_size);
  }

  [[nodiscard]] Hours hours_of(const std::string& name) const {
    const auto* calendar = scenarios::find_named(scenario_.calendars, name);
    return calendar == nullptr ? Hours()
                               : hours_[static_cast<std::size_t>(calendar - scenario_.calendars.data())];
  }
  [[nodiscard]] static Hours hours_within(const scenarios::Calendar& calendar) {
    Hours all;
    const scenarios::WorkingTime hours(calendar);
    all.open_share = hours.open_share();
    double time_min = 0;
    for (int changes = 0; changes < 10'000; ++changes) {
      const bool open = hours.open(time_min);
      time_min = hours.next_change_min(time_min);
      if (time_min > scenarios::minutes_per_week) break;
      if (open) all.closings_per_min += 1 / scenarios::minutes_per_week;
    }
    return all;
  }

  [[nodiscard]] WallStops stops_by_the_wall(std::size_t g) const {
    const Machine& machine = scenario_.machines[g];
    WallStops all;
    for (const auto& stop : c_.groups[g].stops) {
      if (stop.clock != UsageClock::calendar) continue;
      const auto* failure = stop.failure ? &machine.failures[stop.number] : nullptr;
      const auto* maintenance = stop.failure ? nullptr : &machine.maintenance[stop.number];
      const N minutes = mean_of(failure != nullptr ? failure->repair : maintenance->duration, read_) +
                        walking_of(scenario_, stop.crew, read_);
      const N interval =
          failure != nullptr ? mean_of(failure->time_to_failure, read_) : read_(maintenance->interval);
      const N per_min = 1 / (interval + minutes);
      all.share += per_min * minutes;
      N each = wage_of(scenario_, stop.crew, read_) * minutes;
      if (failure != nullptr) each += read_(failure->damage);
      if (stop.spare != nobody) each += read_(scenario_.spares[stop.spare].price);
      all.cost_per_min += per_min * each * static_cast<double>(machine.count);
    }
    return all;
  }

  // Machine minutes per minute that are paid: within the calendar, and the ends of parts begun within it.
  [[nodiscard]] N on_shift(std::size_t g) const {
    const Hours hours = hours_of(scenario_.machines[g].calendar);
    const Machine& machine = scenario_.machines[g];
    const auto count = static_cast<double>(machine.count);
    if (hours.closings_per_min == 0 || machine.part_at_shift_end != scenarios::AtShiftEnd::finish)
      return count * hours.open_share;
    // Longer parts are met more often when the shift ends.
    N minutes = 0;
    N overruns = 0;
    for (std::size_t p = 0; p < c_.routes.size(); ++p)
      for (std::size_t k = 0; k < c_.routes[p].size(); ++k)
        if (const std::size_t o = c_.routes[p][k].operation; c_.operations[o].machine == g) {
          const N work_min = in_[p][k] * run_.operations[o].time_per_part_min;
          minutes += work_min;
          overruns += work_min * overrun(o);
        }
    const N overrun_min = value_of(minutes) > 0 ? overruns / minutes : N(0);
    return count * (hours.open_share + hours.closings_per_min * overrun_min);
  }
  // How long a part goes on after the shift: half of it on the average, or until its edge must be changed by
  // somebody who has gone home.
  [[nodiscard]] N overrun(std::size_t o) const {
    const OperationOf<N>& operation = run_.operations[o];
    const N& time_min = operation.time_per_part_min;
    const auto& tool = c_.operations[o].tool;
    const bool alone =
        tool && c_.tools[*tool].crew != nobody && !scenario_.crews[c_.tools[*tool].crew].calendar.empty();
    const N changes = alone ? operation.changes_per_part : N(0);  // per part
    if (value_of(changes) < 1e-3) return 0.5 * time_min;
    return time_min / changes * (1 - (1 - exponential(-changes)) / changes);
  }
  [[nodiscard]] N capacity(std::size_t g) const { return on_shift(g) * (1 - calendar_stops_[g].share); }

  [[nodiscard]] SetupWork setup(std::size_t g) const {
    SetupWork all;
    const auto& setup = scenario_.machines[g].setup;
    if (!setup || c_.groups[g].families < 2) return all;
    std::map<std::size_t, N> rates;  // of batches, by family
    N total = 0;
    for (std::size_t p = 0; p < c_.routes.size(); ++p)
      for (std::size_t k = 0; k < c_.routes[p].size(); ++k)
        if (const auto& at = c_.operations[c_.routes[p][k].operation]; at.machine == g) {
          rates.try_emplace(at.family, N(0)).first->second += batches_[p][k];
          total += batches_[p][k];
        }
    if (!(value_of(total) > 0)) return all;
    const N wage = wage_of(scenario_, c_.groups[g].setup_crew, read_);
    const N walk_min = walking_of(scenario_, c_.groups[g].setup_crew, read_);
    const auto fits = [&](const std::string& family, std::size_t k) {
      return family == "*" || family == c_.families[k];
    };
    for (const auto& [from, rate_from] : rates)
      for (const auto& [to, rate_to] : rates) {
        if (from == to) continue;
        const operations::Duration* time = &setup->time;
        for (const auto& special : setup->times)
          if (fits(special.from, from) && fits(special.to, to)) {
            time = &special.time;
            break;
          }
        const N per_min = rate_from * rate_to / total;
        const N minutes = mean_of(*time, read_) + walk_min;
        all.minutes += per_min * minutes;
        all.cost += per_min * (wage * minutes + read_(setup->cost));
      }
    return all;
  }

  [[nodiscard]] N work(std::size_t g) const {
    N sum = setup(g).minutes;
    for (std::size_t p = 0; p < c_.routes.size(); ++p)
      for (std::size_t k = 0; k < c_.routes[p].size(); ++k)
        if (c_.operations[c_.routes[p][k].operation].machine == g)
          sum += in_[p][k] * run_.operations[c_.routes[p][k].operation].time_per_part_min;
    return sum;
  }

  const scenarios::Scenario& scenario_;
  const Cache& c_;
  LongRunOf<N>& run_;
  const Reading<N>& read_;
  std::vector<std::vector<N>> in_;       // parts per minute that come to step k of part type p
  std::vector<std::vector<N>> batches_;  // batches likewise
  std::vector<N> pace_;
  std::vector<WallStops> calendar_stops_;
  std::vector<Hours> hours_;  // by calendar
};

LongRun LongRunModel::evaluate() const {
  LongRun run;
  const Reading<double> read;
  for (std::size_t o = 0; o < scenario_.operations.size(); ++o) {
    run.plans.push_back(scenarios::plan(scenario_, scenario_.operations[o]));
    const operations::CutPlan& plan = run.plans.back();
    if (plan.detection)
      throw scenarios::InputError(
          fmt::format("/operations/{}", o),
          fmt::format(
              "/operations/{}: parts are inspected, which the long-run model leaves to the simulation", o));
    run.operations.push_back(cost_of<double>(o, plan, PlanNumbers<double>(plan), read));
  }
  Flow<double> flow(*this, run, read);
  flow.settle();
  flow.price();
  return run;
}

std::optional<LongRunOf<Dual>> LongRunModel::differentiate(
    const LongRun& at, const double* moved,
    const std::vector<std::pair<std::size_t, PlanSlope>>& plans) const {
  // Lives of elements move with the regime in ways that PlanSlope does not say.
  for (const auto& [operation, slope] : plans)
    if (const auto& tool = cache_->operations[operation].tool;
        tool && !scenario_.tools[*tool].elements.empty())
      return std::nullopt;
  bool met = false;
  const Reading<Dual> read{moved, &met};
  LongRunOf<Dual> run;
  for (std::size_t o = 0; o < scenario_.operations.size(); ++o) {
    PlanSlope slope;
    for (const auto& [operation, s] : plans)
      if (operation == o) slope = s;
    run.operations.push_back(cost_of<Dual>(o, at.plans[o], PlanNumbers<Dual>(at.plans[o], slope), read));
  }
  Flow<Dual> flow(*this, run, read);
  flow.settle();
  flow.price();
  if (!met && plans.empty()) return std::nullopt;
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

template <class N>
N LongRunModel::value_in(const LongRunOf<N>& run, std::size_t kpi) const {
  const std::array whole{run.cost_per_part, run.cost_per_good_part, run.throughput_per_h, run.quality_ratio};
  if (kpi < whole.size()) return whole[kpi];
  kpi -= whole.size();
  if (kpi < run.machines.size()) return run.machines[kpi].load;
  kpi -= run.machines.size();
  N failures = 0;
  N changes = 0;
  N inserts = 0;
  for (std::size_t o = 0; o < run.operations.size(); ++o) {
    if (cache_->operations[o].tool != kpi / 2) continue;
    const N& rate = run.operation_rate_per_min[o];
    failures += rate * run.operations[o].failures_per_part;
    changes += rate * run.operations[o].changes_per_part;
    inserts += rate * run.operations[o].inserts_per_part;
  }
  if (kpi % 2 == 0) return value_of(changes) > 0 ? failures / changes : N(0);
  const N finished_per_min = run.throughput_per_h / 60 / run.quality_ratio;
  return 100 * inserts / finished_per_min;
}

template double LongRunModel::value_in(const LongRun&, std::size_t) const;
template Dual LongRunModel::value_in(const LongRunOf<Dual>&, std::size_t) const;

}  // namespace verstat::optimize
