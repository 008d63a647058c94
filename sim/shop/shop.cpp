#include "sim/shop/shop.h"

#include <algorithm>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

using scenarios::Operation;

namespace {

// A scenario that asks for more is a typing error, not a plan: it would simulate for days.
constexpr std::uint64_t event_budget = 2'000'000'000;

template <class T>
std::size_t index_of(const std::vector<T>& all, const std::string& name) {
  return static_cast<std::size_t>(scenarios::find_named(all, name) - all.data());
}

}  // namespace

Shop::MountedTool::MountedTool(const scenarios::Scenario& scenario, const scenarios::Tool& tool,
                               std::size_t tool_index, CrewUnit& tool_crew, const std::string& entity,
                               std::uint64_t replication)
    : spec(&tool),
      insert_spec(scenarios::find_named(scenario.inserts, tool.insert)),
      index(tool_index),
      crew(&tool_crew),
      insert(*insert_spec, scenario.simulation.seed.value, entity, replication),
      strategy(make_strategy(tool.strategy,
                             models::LifeLaw(insert_spec->edge_life.law, 1.0, insert_spec->edge_life.cv))),
      index_time(law_of(tool.change.index)),
      replace_time(law_of(tool.change.replace)),
      index_stream(scenario.simulation.seed.value, entity, "index time", replication),
      replace_stream(scenario.simulation.seed.value, entity, "replace time", replication),
      scrap_stream(scenario.simulation.seed.value, entity, "scrap", replication) {}

Shop::Shop(const scenarios::Scenario& scenario, std::uint64_t replication)
    : scenario_(scenario),
      replication_(replication),
      tools_(scenario.tools.size()),
      parts_(scenario.parts.size()) {
  for (const Operation& operation : scenario.operations) {
    PlannedOperation planned{
        &operation, index_of(scenario.machines, operation.machine), scenarios::plan(scenario, operation), {}};
    if (planned.plan.time_law) planned.time_law = law_of(*planned.plan.time_law);
    operations_.push_back(std::move(planned));
  }
  for (const scenarios::PartType& part : scenario.parts) {
    auto& route = routes_.emplace_back();
    for (const std::string& name : part.route) route.push_back(index_of(scenario.operations, name));
  }
  for (const scenarios::Crew& crew : scenario.crews) crews_.push_back(std::make_unique<CrewUnit>(sim_, crew));
  for (const scenarios::Machine& machine : scenario.machines) {
    groups_.push_back(std::make_unique<Group>(sim_, machine));
    for (std::int64_t k = 0; k < machine.count; ++k)
      machines_.push_back(
          std::make_unique<MachineUnit>(scenario, machine_name(machine, k), *groups_.back(), replication));
  }
  for (const auto& machine : machines_)
    for (const Operation& operation : scenario.operations) {
      if (operation.tool.empty() || operation.machine != machine->group->spec->name) continue;
      if (machine->tools.contains(operation.tool)) continue;
      const std::size_t index = index_of(scenario.tools, operation.tool);
      const scenarios::Tool& tool = scenario.tools[index];
      machine->tools[operation.tool] =
          std::make_unique<MountedTool>(scenario, tool, index, *crews_[index_of(scenario.crews, tool.crew)],
                                        machine->name + "/" + tool.name, replication);
    }
  for (std::size_t p = 0; p < scenario.parts.size(); ++p) {
    const scenarios::PartType& part = scenario.parts[p];
    if (std::holds_alternative<scenarios::AlwaysAvailable>(part.supply)) {
      groups_[operations_[routes_[p].front()].group]->unlimited_parts.push_back(p);
    } else {
      sim_.spawn("arrivals of " + part.name, arrival_process(p));
    }
  }
  for (const auto& machine : machines_) sim_.spawn(machine->name, machine_process(*machine));
}

Shop::~Shop() = default;

std::vector<std::optional<double>> Shop::run() {
  sim_.run_until(scenario_.simulation.warmup_min);
  reset_counts();
  sim_.run_until(scenario_.simulation.horizon_min);
  settle();
  return compute_kpis();
}

void Shop::reset_counts() {
  settle();
  for (ToolCounts& tool : tools_) tool = ToolCounts();
  for (PartCounts& part : parts_) part = PartCounts{.in_process = part.in_process};
  for (const auto& machine : machines_) {
    machine->clock.reset(sim_.now());
    for (const auto& [name, tool] : machine->tools) tool->clock.reset(sim_.now());
  }
}

void Shop::settle() {
  for (const auto& machine : machines_) {
    machine->clock.settle(sim_.now());
    for (const auto& [name, tool] : machine->tools) tool->clock.settle(sim_.now());
  }
}

sim::Task<void> Shop::arrival_process(std::size_t part) {
  const sim::Distribution interarrival =
      law_of(std::get<scenarios::Interarrival>(scenario_.parts[part].supply).time);
  sim::RandomStream stream(scenario_.simulation.seed.value, scenario_.parts[part].name, "interarrival",
                           replication_);
  for (;;) {
    const double wait_min = interarrival.sample(stream);
    co_await sim_.delay(wait_min);
    release(Job{.part = part, .released_min = sim_.now()});
  }
}

// A job enters the queue of the machines that do its next operation.
void Shop::release(Job job) {
  ++parts_[job.part].in_process;
  groups_[operations_[routes_[job.part][job.step]].group]->queue.try_put(job);
}

// Parts under way go first; blanks that are always available fill the rest, part types in turn.
std::optional<Shop::Job> Shop::next_job(Group& group) {
  if (auto job = group.queue.try_get()) return job;
  if (group.unlimited_parts.empty()) return std::nullopt;
  const std::size_t part = group.unlimited_parts[group.next_unlimited];
  group.next_unlimited = (group.next_unlimited + 1) % group.unlimited_parts.size();
  ++parts_[part].in_process;
  return Job{.part = part, .released_min = sim_.now()};
}

sim::Task<void> Shop::machine_process(MachineUnit& machine) {
  for (;;) {
    machine.clock.enter(MachineState::idle, sim_.now());
    Job job;
    if (auto ready = next_job(*machine.group)) {
      job = *ready;
    } else {
      job = co_await machine.group->queue.get();
    }
    if (sim_.events_executed() > event_budget)
      throw std::runtime_error(
          fmt::format("more than {} events in one replication: shorten the horizon or check the "
                      "durations, they are far apart",
                      event_budget));
    const PlannedOperation& operation = operations_[routes_[job.part][job.step]];
    const double main_time_min = operation.time_law ? operation.time_law->sample(machine.duration_stream)
                                                    : operation.plan.main_time_min;
    if (operation.plan.edge && !operation.spec->tool.empty()) {
      MountedTool& tool = *machine.tools.at(operation.spec->tool);
      co_await turn(machine, tool, main_time_min, operation.plan.edge->mean_min, job);
      if (breaks(machine, operation)) {
        if (tool.scrap_stream.uniform() < tool.spec->failure_scrap_probability) job.spoiled = true;
        co_await change_edge(machine, tool, true, operation.plan.edge->mean_min);
      }
    } else {
      machine.clock.enter(MachineState::working, sim_.now());
      co_await sim_.delay(main_time_min);
    }
    if (spoils(machine, operation)) job.spoiled = true;
    pass_on(job);
  }
}

// Numbers are drawn only where the process model gives a chance at all, from streams of their own.
bool Shop::breaks(MachineUnit& machine, const PlannedOperation& operation) {
  const double chance = operation.plan.breakage_probability;
  return chance > 0 && machine.breakage_stream.uniform() < chance;
}
bool Shop::spoils(MachineUnit& machine, const PlannedOperation& operation) {
  const double chance = operation.plan.scrap_probability;
  return chance > 0 && machine.quality_stream.uniform() < chance;
}

void Shop::pass_on(Job job) {
  PartCounts& part = parts_[job.part];
  --part.in_process;
  const scenarios::PartType& type = scenario_.parts[job.part];
  const bool last = job.step + 1 == type.route.size();
  if (!job.spoiled && !last) {
    ++job.step;
    release(job);
    return;
  }
  if (job.spoiled) {
    ++part.scrapped;
    part.scrap_cost += type.value;
  } else {
    ++part.good;
  }
  part.lead_time_min += sim_.now() - job.released_min;
}

// Cuts one part. Within one instant a failure comes before a planned change (X <= tau fails), and both before
// the end of the cut; a planned change that falls due with the end of a part is made before the next one.
sim::Task<void> Shop::turn(MachineUnit& machine, MountedTool& tool, double main_time_min,
                           double mean_life_min, Job& job) {
  // Rounding leaves crumbs of cutting where two times are equal by design.
  const double crumb_min = 1e-9 * main_time_min;
  double left_min = main_time_min;
  while (left_min > crumb_min) {
    const double to_failure_min = (tool.insert.life() - tool.insert.wear()) * mean_life_min;
    const double to_change_min =
        tool.strategy->cutting_to_change_min({.edge_wear = tool.insert.wear(),
                                              .wear_since_plan = tool.wear_since_plan,
                                              .mean_life_min = mean_life_min,
                                              .main_time_min = main_time_min});
    const bool fails_first = to_failure_min <= to_change_min;
    const double to_stop_min = std::max(0.0, fails_first ? to_failure_min : to_change_min);
    if (to_stop_min > left_min || to_stop_min > crumb_min) {
      const double cut_min = std::min(left_min, to_stop_min);
      machine.clock.enter(MachineState::cutting, sim_.now());
      tool.clock.enter(MachineState::cutting, sim_.now());
      co_await sim_.delay(cut_min);
      tool.insert.spend(cut_min / mean_life_min);
      tool.wear_since_plan += cut_min / mean_life_min;
      left_min -= cut_min;
      if (cut_min < to_stop_min) continue;  // the part is finished first
    }
    if (!fails_first && left_min <= crumb_min) continue;  // due with the end of the part
    if (fails_first) {
      const double draw = tool.scrap_stream.uniform();
      if (draw < tool.spec->failure_scrap_probability) job.spoiled = true;
    }
    co_await change_edge(machine, tool, fails_first, mean_life_min);
  }
  tool.clock.enter(MachineState::idle, sim_.now());
}

sim::Task<void> Shop::change_edge(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                  double mean_life_min) {
  machine.clock.enter(MachineState::waiting_crew, sim_.now());
  tool.clock.enter(MachineState::waiting_crew, sim_.now());
  sim::Hold hold = co_await tool.crew->members.acquire();
  const MachineState state = after_failure ? MachineState::failure_change : MachineState::planned_change;
  machine.clock.enter(state, sim_.now());
  tool.clock.enter(state, sim_.now());

  ToolCounts& counts = tools_[tool.index];
  ++counts.edges_used;
  counts.edge_minutes_used += tool.insert.wear() * mean_life_min;
  if (after_failure) {
    ++counts.failures;
    counts.damage_cost += tool.spec->failure_damage;
    counts.regrind_cost += tool.spec->regrind_failure;
  } else {
    ++counts.planned_changes;
    counts.regrind_cost += tool.spec->regrind_planned;
    tool.wear_since_plan = 0;
  }
  if (tool.spec->insert_booking == scenarios::InsertBooking::life_periods)
    counts.insert_cost +=
        tool.insert_spec->price / (after_failure ? tool.spec->periods_failure : tool.spec->periods_planned);

  const scenarios::ToolChange& change = tool.spec->change;
  // Both times are drawn at every change, used or not: variants of the shop stay in step.
  const double index_min = tool.index_time.sample(tool.index_stream);
  const double replace_min = tool.replace_time.sample(tool.replace_stream);
  double time_min = change.positioning_min + (after_failure ? change.failure_extra_min : 0);
  if (tool.insert.turn_to_next_edge(after_failure)) {
    time_min += index_min;
  } else {
    time_min += replace_min;
    tool.insert.fit_new();
    ++counts.inserts_fitted;
    if (tool.spec->insert_booking == scenarios::InsertBooking::at_fitting)
      counts.insert_cost += tool.insert_spec->price;
  }
  co_await sim_.delay(time_min);
}

}  // namespace verstat::shop
