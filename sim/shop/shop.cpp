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

Shop::Shop(const scenarios::Scenario& scenario, std::uint64_t replication)
    : scenario_(scenario),
      replication_(replication),
      tools_(scenario.tools.size()),
      parts_(scenario.parts.size()) {
  for (const Operation& operation : scenario.operations) {
    PlannedOperation planned{&operation,
                             index_of(scenario.machines, operation.machine),
                             scenarios::plan(scenario, operation),
                             {},
                             {}};
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
  build_tools();
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
  reset_tool_counts();
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
  settle_tools();
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
    const bool wears = operation.plan.edge.has_value() && !operation.spec->tool.empty();
    if (wears || !operation.element_mean_min.empty()) {
      MountedTool& tool = *machine.tools.at(operation.spec->tool);
      co_await cut(machine, tool, operation, main_time_min, job);
      if (wears && breaks(machine, operation)) {
        if (tool.scrap_stream.uniform() < tool.spec->failure_scrap_probability) job.spoiled = true;
        co_await change_edge(machine, tool, true, operation.plan.edge->mean_min);
      }
      put_back(tool);
    } else {
      co_await spend(machine, MachineState::working, main_time_min);
    }
    if (spoils(machine, operation)) job.spoiled = true;
    pass_on(job);
  }
}

sim::Task<void> Shop::spend(MachineUnit& machine, MachineState state, double time_min, MountedTool* tool) {
  machine.clock.enter(state, sim_.now());
  if (tool != nullptr) tool->clock.enter(state, sim_.now());
  co_await sim_.delay(time_min);
}

sim::Task<sim::Hold> Shop::call_crew(MachineUnit& machine, CrewUnit& crew, MountedTool* tool) {
  machine.clock.enter(MachineState::waiting_crew, sim_.now());
  if (tool != nullptr) tool->clock.enter(MachineState::waiting_crew, sim_.now());
  sim::Hold hold = co_await crew.members.acquire();
  co_return hold;
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

}  // namespace verstat::shop
