// A shop put together from its scenario.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

using scenarios::index_of;
using scenarios::Operation;

namespace {

// Index of a text in a list that grows when it is new.
std::size_t intern(std::vector<std::string>& all, const std::string& text) {
  const auto found = std::find(all.begin(), all.end(), text);
  if (found != all.end()) return static_cast<std::size_t>(found - all.begin());
  all.push_back(text);
  return all.size() - 1;
}

// Expected work from each step to the end of the route; parts in rework and scrap are left out.
std::vector<double> work_left(const scenarios::Route& route, const std::vector<double>& time_min) {
  std::vector<double> left(route.size(), 0.0);
  // Re-entrant routes make this a system of equations; value iteration from zero rises to its solution.
  for (int round = 0; round < 1000; ++round) {
    double change = 0;
    for (std::size_t k = route.size(); k-- > 0;) {
      double sum = time_min[k];
      for (const scenarios::RouteBranch& branch : route[k].next) {
        const double share = route[k].choice == scenarios::BranchChoice::by_probability
                                 ? branch.probability
                                 : 1.0 / static_cast<double>(route[k].next.size());
        if (branch.to != scenarios::route_end) sum += share * left[branch.to];
      }
      change = std::max(change, std::abs(sum - left[k]));
      left[k] = sum;
    }
    if (change < 1e-9) break;
  }
  return left;
}

}  // namespace

Shop::PlannedOperation::PlannedOperation(const Operation& operation, std::size_t on_group,
                                         operations::CutPlan cut_plan)
    : group(on_group),
      main_time_min(cut_plan.main_time_min),
      cost(operation.cost),
      mean_life_min(cut_plan.edge ? cut_plan.edge->mean_min : std::numeric_limits<double>::infinity()),
      breaks(cut_plan.breakage_probability),
      wears(cut_plan.edge.has_value() && !operation.tool.empty()),
      inspects(operation.inspection || cut_plan.detection),
      quality(operation.quality ? &*operation.quality : nullptr),
      spec(&operation),
      plan(std::move(cut_plan)) {
  // Of an inspection it is the share rejected when defects come as its plan assumes: here parts are judged.
  double kept = plan.detection ? 1 : 1 - plan.scrap_probability;
  if (quality != nullptr) kept *= 1 - quality->scrap_probability;
  spoils = 1 - kept;
  if (plan.time_law) time_law = law_of(*plan.time_law);
}

Shop::Shop(const scenarios::Scenario& scenario, std::uint64_t replication, Trace* trace)
    : scenario_(scenario),
      replication_(replication),
      trace_(trace),
      labour_(std::make_unique<Labour>(scenario, sim_, costs_)),
      tools_(scenario.tools.size()),
      parts_(scenario.parts.size()) {
  labour_->record(trace);
  build_operations();
  build_machines();
  build_tools();
  build_flow();
  build_quality();
  start();
}

Shop::~Shop() {
  labour_->close();
}

void Shop::build_operations() {
  for (const Operation& operation : scenario_.operations) {
    OperationUnit unit{.spec = &operation, .on = {}};
    unit.family = intern(families_, operation.family.empty() ? operation.name : operation.family);
    for (const std::size_t g : scenarios::groups_of(scenario_, operation)) {
      unit.on.emplace_back(operation, g, scenarios::plan(scenario_, operation, scenario_.machines[g]));
    }
    operations_.push_back(std::move(unit));
  }
}

void Shop::build_machines() {
  const scenarios::SimulationSettings& settings = scenario_.simulation;
  for (const scenarios::Spare& spare : scenario_.spares)
    spares_.push_back(std::make_unique<Spares>(spare, sim_, settings, replication_));
  for (const scenarios::Machine& machine : scenario_.machines) {
    groups_.push_back(std::make_unique<Group>(sim_, machine, groups_.size()));
    Group& group = *groups_.back();
    can_block_ = can_block_ || machine.queue_capacity;
    if (const auto* calendar = scenarios::find_named(scenario_.calendars, machine.calendar)) {
      group.working_time.emplace(*calendar);
      group.pauses = machine.part_at_shift_end == scenarios::AtShiftEnd::pause;
    }
    if (machine.loading) group.loading_time = law_of(*machine.loading);
    if (machine.unloading) group.unloading_time = law_of(*machine.unloading);
    if (machine.overload) {
      group.break_repair = law_of(machine.overload->repair);
      group.overload_crews = labour_->crews_for(machine.overload->crew);
    }
    if (machine.switch_off) group.warm_up_time = law_of(machine.switch_off->warm_up);
    if (machine.attendance) group.attendance_crews = labour_->crews_for(machine.attendance->crew);
    if (machine.setup) {
      const auto family = [&](const std::string& name) -> std::optional<std::size_t> {
        if (name == "*") return std::nullopt;
        return intern(families_, name);
      };
      for (const scenarios::SetupTime& time : machine.setup->times)
        group.setup_times.push_back({family(time.from), family(time.to), law_of(time.time)});
      group.setup_times.push_back({std::nullopt, std::nullopt, law_of(machine.setup->time)});
      if (!machine.setup->crew.empty()) group.setup_crews = labour_->crews_for(machine.setup->crew);
    }
    for (std::int64_t k = 0; k < machine.count; ++k) {
      const std::string entity = numbered(drawn_as(settings, machine.name), machine.count, k);
      machines_.push_back(std::make_unique<MachineUnit>(scenario_, machine_name(machine, k), entity, group,
                                                        machines_.size(), sim_, replication_));
      MachineUnit& unit = *machines_.back();
      group.machines.push_back(&unit);
      for (const scenarios::FailureMode& mode : machine.failures) {
        auto stop = std::make_unique<Stop>(settings.seed.value, entity + "/" + drawn_as(settings, mode.name),
                                           replication_);
        stop->failure = &mode;
        stop->clock = mode.clock;
        stop->effect = mode.effect;
        stop->life = law_of(mode.time_to_failure);
        stop->duration = law_of(mode.repair);
        stop->crews = labour_->crews_for(mode.crew);
        stop->spare = index_of(scenario_.spares, mode.spare);
        stop->due = stop->life->sample(stop->life_stream);
        unit.stops.push_back(std::move(stop));
      }
      for (const scenarios::Maintenance& job : machine.maintenance) {
        auto stop = std::make_unique<Stop>(settings.seed.value, entity + "/" + drawn_as(settings, job.name),
                                           replication_);
        stop->maintenance = &job;
        stop->clock = job.clock;
        stop->effect = job.effect;
        stop->duration = law_of(job.duration);
        stop->crews = labour_->crews_for(job.crew);
        stop->spare = index_of(scenario_.spares, job.spare);
        stop->due = job.interval;
        for (const std::string& mode : job.renews) stop->renews.push_back(index_of(machine.failures, mode));
        unit.stops.push_back(std::move(stop));
      }
    }
  }
}

void Shop::build_flow() {
  const scenarios::SimulationSettings& settings = scenario_.simulation;
  for (const scenarios::Store& store : scenario_.stores) {
    stores_.push_back(std::make_unique<StoreUnit>(store, stores_.size(), sim_));
    stores_.back()->parts.assign(scenario_.parts.size(), 0);
    can_block_ = can_block_ || store.capacity;
  }
  for (std::size_t p = 0; p < scenario_.parts.size(); ++p) {
    const scenarios::PartType& part = scenario_.parts[p];
    routes_.push_back(scenarios::route_of(scenario_, part));
    std::vector<double> time_min;
    for (const scenarios::RouteStep& step : routes_.back())
      time_min.push_back(operations_[step.operation].on.front().main_time_min *
                         static_cast<double>(part.batch_size));
    work_left_min_.push_back(work_left(routes_.back(), time_min));
    store_of_.push_back(stores_[index_of(scenario_.stores, part.store)].get());
    store_of_.back()->kinds.push_back(p);
    sources_.push_back(std::make_unique<Source>(part, p, settings, replication_));
    Source& source = *sources_.back();
    if (part.due_after) source.due_after = law_of(*part.due_after);
    if (const auto* threshold = std::get_if<scenarios::StationThreshold>(&part.release))
      source.watched_group = index_of(scenario_.machines, threshold->machine);
    if (source.watched_group) groups_[*source.watched_group]->releases.push_back(p);
    for (const PlannedOperation& first : operations_[routes_.back().front().operation].on)
      if (groups_[first.group]->spec->queue_capacity && source.watched_group != first.group)
        groups_[first.group]->releases.push_back(p);
  }
  for (const scenarios::Transport& transport : scenario_.transport) {
    carriers_.push_back(std::make_unique<Carrier>(transport, sim_, settings, replication_));
    Carrier& carrier = *carriers_.back();
    can_block_ = can_block_ || std::holds_alternative<scenarios::Conveyor>(transport.carrier);
    const auto serves = [](const std::string& wanted, const std::string& name) {
      return wanted == "*" || wanted == name;
    };
    for (const auto& group : groups_) {
      carrier.from_group.push_back(serves(transport.from, group->spec->name));
      carrier.to_group.push_back(serves(transport.to, group->spec->name));
    }
    for (const auto& store : stores_) carrier.to_store.push_back(serves(transport.to, store->spec->name));
    if (const auto* delay = std::get_if<scenarios::TransportDelay>(&transport.carrier))
      carrier.time = law_of(delay->time);
    if (const auto* vehicles = std::get_if<scenarios::Vehicles>(&transport.carrier)) {
      Fleet fleet{.layout = scenarios::layout_of(scenario_.layout)};
      fleet.vehicles.assign(static_cast<std::size_t>(vehicles->count), Fleet::Vehicle{.at = 0});
      if (!vehicles->crew.empty()) fleet.crews = labour_->crews_for(vehicles->crew);
      const auto place = [&](const std::string& name) {
        return fleet.layout.find(name).value_or(scenarios::route_end);
      };
      for (const auto& group : groups_) fleet.of_group.push_back(place(group->spec->name));
      for (const auto& store : stores_) fleet.of_store.push_back(place(store->spec->name));
      carrier.fleet = std::move(fleet);
    }
  }
}

void Shop::start() {
  labour_->on_standstill = [this](const std::vector<Labour::Wait>& waits) { note_standstill(waits); };
  labour_->start();
  for (const auto& source : sources_) {
    if (!std::holds_alternative<scenarios::AlwaysAvailable>(source->spec->supply)) {
      sim_.spawn("arrivals of " + source->spec->name, arrivals(*source));
    } else if (std::holds_alternative<scenarios::Push>(source->spec->release)) {
      // The shop takes a blank whenever a machine that starts the route has nothing else to do.
      const scenarios::RouteStep& start = routes_[source->part].front();
      for (const PlannedOperation& first : operations_[start.operation].on) {
        groups_[first.group]->unlimited_parts.push_back(source->part);
        if (!start.assembles.empty()) groups_[first.group]->assembles_unlimited = true;
      }
    } else {
      release_what_may(source->part);
    }
  }
  build_limits();
  for (const auto& group : groups_)
    if (group->assembles_unlimited) assembling_groups_.push_back(group.get());
  for (const auto& store : stores_)
    if (store->spec->demand) sim_.spawn("customers of " + store->spec->name, demand(*store));
  for (const auto& machine : machines_) sim_.spawn(machine->name, machine_process(*machine));
}

}  // namespace verstat::shop
