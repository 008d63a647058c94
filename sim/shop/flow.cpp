// Batches between machines: supply, release, queues, dispatch, transport, assembly, stores.
#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"
#include "sim/shop/trace.h"

namespace verstat::shop {

using scenarios::Dispatch;
using scenarios::route_end;

// ------------------------------------------------------------------------------------------------- supply
sim::Task<void> Shop::arrivals(Source& source) {
  const scenarios::PartType& part = *source.spec;
  if (const auto* regular = std::get_if<scenarios::Interarrival>(&part.supply)) {
    const sim::Distribution interarrival = law_of(regular->time);
    for (;;) {
      const double wait_min = interarrival.sample(source.arrival_stream);
      co_await sim_.delay(wait_min);
      backlog(source.part, part.batch_size, std::numeric_limits<double>::infinity());
    }
  }
  if (const auto* weekly = std::get_if<scenarios::WeeklyProfile>(&part.supply)) {
    std::vector<double> lengths;
    std::vector<double> rates;
    double at_h = 0;
    for (const scenarios::RatePeriod& period : weekly->rates) {
      if (period.from_h > at_h) {
        lengths.push_back(60 * (period.from_h - at_h));
        rates.push_back(0);
      }
      lengths.push_back(60 * (period.to_h - period.from_h));
      rates.push_back(period.per_h / 60);
      at_h = period.to_h;
    }
    if (at_h < 168) {
      lengths.push_back(60 * (168 - at_h));
      rates.push_back(0);
    }
    sim::PoissonArrivals process{sim::RateProfile(lengths, rates)};
    for (;;) {
      const double at_min = process.next(source.arrival_stream);
      co_await sim_.delay(at_min - sim_.now());
      backlog(source.part, part.batch_size, std::numeric_limits<double>::infinity());
    }
  }
  const auto& list = std::get<scenarios::OrderList>(part.supply).orders;
  for (const scenarios::Order& order : list) {
    co_await sim_.delay(order.arrives_min - sim_.now());
    const double due_min = order.due_min.value_or(std::numeric_limits<double>::infinity());
    for (std::int64_t left = order.quantity; left > 0; left -= part.batch_size)
      backlog(source.part, std::min(left, part.batch_size), due_min);
  }
}

void Shop::backlog(std::size_t part, std::int64_t quantity, double due_min) {
  Source& source = *sources_[part];
  if (source.due_after) {
    const double allowance_min = source.due_after->sample(source.due_stream);
    if (due_min == std::numeric_limits<double>::infinity()) due_min = sim_.now() + allowance_min;
  }
  count_batch(part);
  source.backlog.push_back({quantity, sim_.now(), due_min});
  release_what_may(part);
}

void Shop::release_what_may(std::size_t part) {
  Source& source = *sources_[part];
  const scenarios::PartType& type = *source.spec;
  const bool unlimited = std::holds_alternative<scenarios::AlwaysAvailable>(type.supply);
  if (unlimited && std::holds_alternative<scenarios::Push>(type.release)) return;  // machines help themselves
  for (;;) {
    if (!unlimited && source.backlog.empty()) return;
    if (const auto* conwip = std::get_if<scenarios::Conwip>(&type.release))
      if (source.batches_in_shop >= conwip->cap) return;
    if (source.watched_group) {
      const Group& watched = *groups_[*source.watched_group];
      const auto waiting = static_cast<std::int64_t>(watched.queue.size()) + watched.on_their_way;
      if (waiting >= std::get<scenarios::StationThreshold>(type.release).queue) return;
    }
    const std::size_t group = choose_group(routes_[part].front().operation);
    const Job probe{.part = part};
    if (!has_room({.group = group}, probe)) return;
    Job* job = new_job(part, unlimited ? type.batch_size : source.backlog.front().quantity);
    if (unlimited) {
      if (source.due_after) job->due_min = sim_.now() + source.due_after->sample(source.due_stream);
    } else {
      job->arrived_min = source.backlog.front().arrived_min;
      job->due_min = source.backlog.front().due_min;
      job->since_min = job->arrived_min;
      source.backlog.pop_front();
      --batches_;  // waiting no more: counted as released
    }
    send(*job, group);
  }
}

void Shop::release_after_queue_change(std::size_t group) {
  for (const std::size_t part : groups_[group]->releases) release_what_may(part);
}

// A queue that grows without end takes all memory long before it takes all events.
void Shop::count_batch(std::size_t part) {
  if (++batches_ > most_batches)
    throw sim::BudgetError(fmt::format(
        "more than {} batches wait in the shop, part \"{}\" the last: more come than can be worked",
        most_batches, scenario_.parts[part].name));
}

Job* Shop::new_job(std::size_t part, std::int64_t quantity) {
  count_batch(part);
  if (quantity > most_pieces)
    throw sim::BudgetError(
        fmt::format("a batch of {} pieces of part \"{}\", the most is {}: check the counts "
                    "of yields, they multiply",
                    quantity, scenario_.parts[part].name, most_pieces));
  Job* job = jobs_.make();
  job->part = part;
  job->from = from_supply();
  job->quantity = quantity;
  job->arrived_min = sim_.now();
  job->since_min = sim_.now();
  Source& source = *sources_[part];
  ++source.batches_in_shop;
  source.parts_in_shop += quantity;
  source.released_ever += static_cast<std::uint64_t>(quantity);
  parts_[part].released += static_cast<std::uint64_t>(quantity);
  work_in_process_.change(sim_.now(), static_cast<double>(quantity));
  return job;
}

// Blanks that an operation sets free start their own route at once.
void Shop::start_route(Job& job) {
  send(job, choose_group(routes_[job.part].front().operation));
}

Job* Shop::new_unlimited_job(Group& group) {
  for (std::size_t tried = 0; tried < group.unlimited_parts.size(); ++tried) {
    const std::size_t part = group.unlimited_parts[group.next_unlimited];
    group.next_unlimited = (group.next_unlimited + 1) % group.unlimited_parts.size();
    const std::int64_t batch = scenario_.parts[part].batch_size;
    if (!take_components(part, 0, batch)) continue;
    Job* job = new_job(part, batch);
    Source& source = *sources_[part];
    if (source.due_after) job->due_min = sim_.now() + source.due_after->sample(source.due_stream);
    job->on_its_way_to = group.index;
    return job;
  }
  return nullptr;
}

// -------------------------------------------------------------------------------------- queues and dispatch
const Shop::PlannedOperation& Shop::planned(const Job& job) const {
  const auto& on = operations_[routes_[job.part][job.step].operation].on;
  for (const PlannedOperation& operation : on)
    if (operation.group == job.on_its_way_to) return operation;
  return on.front();
}

std::size_t Shop::choose_group(std::size_t index) {
  OperationUnit& operation = operations_[index];
  if (operation.on.size() == 1) return operation.on.front().group;
  if (operation.spec->choice == scenarios::Choice::in_turn) {
    const std::size_t k = operation.next_in_turn;
    operation.next_in_turn = (k + 1) % operation.on.size();
    return operation.on[k].group;
  }
  std::size_t best = operation.on.front().group;
  double shortest = std::numeric_limits<double>::infinity();
  for (const PlannedOperation& on : operation.on) {
    const Group& group = *groups_[on.group];
    const double load = static_cast<double>(static_cast<std::int64_t>(group.queue.size()) +
                                            group.on_their_way + group.in_work) /
                        static_cast<double>(group.spec->count);
    if (load < shortest) {
      shortest = load;
      best = on.group;
    }
  }
  return best;
}

std::size_t Shop::choose_step(MachineUnit& machine, const Job& job) {
  const scenarios::RouteStep& step = routes_[job.part][job.step];
  if (step.next.size() == 1) return step.next.front().to;
  if (step.choice == scenarios::BranchChoice::by_probability) {
    double left = machine.routing_stream.uniform();
    for (const scenarios::RouteBranch& branch : step.next) {
      left -= branch.probability;
      if (left < 0) return branch.to;
    }
    return step.next.back().to;
  }
  std::size_t best = step.next.front().to;
  double shortest = std::numeric_limits<double>::infinity();
  for (const scenarios::RouteBranch& branch : step.next) {
    double load = 0;
    if (branch.to != route_end) {
      const Group& group = *groups_[choose_group(routes_[job.part][branch.to].operation)];
      load = static_cast<double>(static_cast<std::int64_t>(group.queue.size()) + group.on_their_way +
                                 group.in_work) /
             static_cast<double>(group.spec->count);
    }
    if (load < shortest) {
      shortest = load;
      best = branch.to;
    }
  }
  return best;
}

bool Shop::has_room(Place place, const Job& job) const {
  if (place.store != route_end) {
    const StoreUnit& store = *stores_[place.store];
    return !store.spec->capacity ||
           store.level + store.on_their_way + job.quantity <= *store.spec->capacity ||
           (store.level + store.on_their_way == 0);  // a batch larger than the store goes in alone
  }
  const Group& group = *groups_[place.group];
  const auto taken = static_cast<std::int64_t>(group.queue.size()) + group.on_their_way;
  return taken < group.queue_capacity + static_cast<std::int64_t>(group.idle.size());
}

void Shop::send(Job& job, std::size_t group) {
  job.on_its_way_to = group;
  ++groups_[group]->on_their_way;
  arrive(job);
}

void Shop::arrive(Job& job) {
  Group& group = *groups_[job.on_its_way_to];
  --group.on_their_way;
  job.number = next_number_++;
  if (!take_components(job.part, job.step, job.quantity)) {
    job.enter(Phase::components, sim_.now());
    waiting_for_components_.push_back(&job);
    return;
  }
  job.enter(Phase::queue, sim_.now());
  if (!group.idle.empty()) {
    group.idle.pop_front()->inbox.try_put(&job);
    return;
  }
  group.queue.push_back(&job);
  group.queue_length.set(sim_.now(), static_cast<double>(group.queue.size()));
  if (trace_ != nullptr) trace_->queue_length(job.on_its_way_to, sim_.now(), group.queue.size());
}

std::size_t Shop::best_waiting(const MachineUnit& machine) const {
  const sim::RingBuffer<Job*>& queue = machine.group->queue;
  const Dispatch rule = machine.group->dispatch;
  if (rule == Dispatch::fifo) return 0;
  const double now = sim_.now();
  const auto rank = [&](const Job& job) -> double {
    switch (rule) {
      case Dispatch::fifo:
        return 0;
      case Dispatch::spt:
        return planned(job).main_time_min * static_cast<double>(job.quantity);
      case Dispatch::edd:
        return job.due_min;
      case Dispatch::critical_ratio: {
        const double left_min = work_left_min_[job.part][job.step];
        return (job.due_min - now) / std::max(left_min, 1e-9);
      }
      case Dispatch::least_setup:
        return machine.family == operations_[routes_[job.part][job.step].operation].family ? 0 : 1;
      case Dispatch::priority:
        return static_cast<double>(scenario_.parts[job.part].priority);
    }
    return 0;
  };
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const double value = rank(*queue[k]);
    if (value < least) {  // ties: first come, first served
      least = value;
      best = k;
    }
  }
  return best;
}

// Batches under way go first; blanks that are always available fill the rest, part types in turn.
Job* Shop::take_job(MachineUnit& machine) {
  Group& group = *machine.group;
  if (group.queue.empty()) return group.unlimited_parts.empty() ? nullptr : new_unlimited_job(group);
  Job* job = group.queue.erase(best_waiting(machine));
  group.queue_length.set(sim_.now(), static_cast<double>(group.queue.size()));
  if (trace_ != nullptr) trace_->queue_length(job->on_its_way_to, sim_.now(), group.queue.size());
  group.room.notify();
  release_after_queue_change(job->on_its_way_to);
  return job;
}

// ----------------------------------------------------------------------------------------------- moving on
Shop::Carrier* Shop::carrier_between(std::size_t from_group, Place to) {
  for (const auto& carrier : carriers_)
    if (carrier->from_group[from_group] &&
        (to.store != route_end ? carrier->to_store[to.store] : carrier->to_group[to.group]))
      return carrier.get();
  return nullptr;
}

sim::Task<void> Shop::pass_on(MachineUnit& machine, Job& job) {
  const std::size_t from = job.on_its_way_to;
  const std::size_t next = choose_step(machine, job);
  Place to;
  if (next == route_end) {
    to.store = store_of_[job.part]->index;
  } else {
    to.group = choose_group(routes_[job.part][next].operation);
  }
  if (!has_room(to, job)) {
    job.enter(Phase::blocked, sim_.now());
    enter(machine, MachineState::blocked);
    machine.waits_for = to;
    look_for_standstill(machine);
    sim::Signal& room = to.store != route_end ? stores_[to.store]->room : groups_[to.group]->room;
    co_await room.wait_until([&] { return has_room(to, job); });
    told_blocked(machine);
  }
  // The room is taken from now on.
  if (to.store != route_end) {
    stores_[to.store]->on_their_way += job.quantity;
  } else {
    job.from = from;
    job.step = next;
    job.on_its_way_to = to.group;
    ++groups_[to.group]->on_their_way;
  }
  Carrier* carrier = carriers_.empty() ? nullptr : carrier_between(from, to);
  if (carrier == nullptr) {
    if (to.store != route_end)
      store_parts(job);
    else
      arrive(job);
    co_return;
  }
  if (const auto* conveyor = std::get_if<scenarios::Conveyor>(&carrier->spec->carrier)) {
    if (carrier->on_board >= conveyor->capacity) {
      job.enter(Phase::blocked, sim_.now());
      enter(machine, MachineState::blocked);
      machine.waits_for = Place();
      co_await carrier->room.wait_until([&] { return carrier->on_board < conveyor->capacity; });
      told_blocked(machine);
    }
    ++carrier->on_board;
  }
  job.enter(Phase::transport, sim_.now());
  sim_.spawn(carrier->spec->name, carry(job, *carrier, from, to));
}

sim::Task<void> Shop::carry(Job& job, Carrier& carrier, std::size_t from, Place to) {
  ++carrier.moves;
  if (carrier.time) {
    const double time_min = carrier.time->sample(carrier.stream);
    co_await sim_.delay(time_min);
  } else if (const auto* conveyor = std::get_if<scenarios::Conveyor>(&carrier.spec->carrier)) {
    co_await sim_.delay(conveyor->time_min);
    --carrier.on_board;
    carrier.room.notify();
  } else {
    const auto& vehicles = std::get<scenarios::Vehicles>(carrier.spec->carrier);
    Fleet& fleet = *carrier.fleet;
    const std::size_t pick_up = fleet.of_group[from];
    const std::size_t set_down = to.store != route_end ? fleet.of_store[to.store] : fleet.of_group[to.group];
    co_await carrier.room.wait_until([&] {
      return std::any_of(fleet.vehicles.begin(), fleet.vehicles.end(), [](const auto& v) { return v.free; });
    });
    // The nearest free vehicle comes.
    std::size_t chosen = fleet.vehicles.size();
    for (std::size_t v = 0; v < fleet.vehicles.size(); ++v) {
      if (!fleet.vehicles[v].free) continue;
      if (chosen == fleet.vehicles.size() || fleet.layout.length_m[fleet.vehicles[v].at][pick_up] <
                                                 fleet.layout.length_m[fleet.vehicles[chosen].at][pick_up])
        chosen = v;
    }
    fleet.vehicles[chosen].free = false;
    CrewHold driver;
    if (!fleet.crews.empty()) driver = co_await labour_->call(fleet.crews, 0, Cost::transport);
    const double way_m =
        fleet.layout.length_m[fleet.vehicles[chosen].at][pick_up] + fleet.layout.length_m[pick_up][set_down];
    const double time_min = way_m / vehicles.speed_m_min + vehicles.pick_up_min + vehicles.set_down_min;
    co_await sim_.delay(time_min);
    carrier.busy_min += time_min;
    costs_.book(Cost::transport, time_min * vehicles.rate_per_min);
    fleet.vehicles[chosen].at = set_down;
    fleet.vehicles[chosen].free = true;
    carrier.room.notify();
  }
  if (to.store != route_end)
    store_parts(job);
  else
    arrive(job);
}

// ---------------------------------------------------------------------------------------- assembly and
// stores
bool Shop::take_components(std::size_t part, std::size_t step, std::int64_t quantity) {
  const auto& wanted = routes_[part][step].assembles;
  for (const scenarios::RouteComponent& c : wanted)
    if (store_of_[c.part]->parts[c.part] < c.count * quantity) return false;
  for (const scenarios::RouteComponent& c : wanted) {
    StoreUnit& store = *store_of_[c.part];
    store.parts[c.part] -= c.count * quantity;
    store.level -= c.count * quantity;
    store.assembled += static_cast<std::uint64_t>(c.count * quantity);
    store.mean_level.set(sim_.now(), static_cast<double>(store.level));
    store.room.notify();
  }
  return true;
}

// Who waits longest for components is served first; who comes later takes what the first cannot use.
void Shop::serve_assemblies() {
  for (std::size_t k = 0; k < waiting_for_components_.size();) {
    Job* job = waiting_for_components_[k];
    if (!take_components(job->part, job->step, job->quantity)) {
      ++k;
      continue;
    }
    job->from = from_components();
    waiting_for_components_.erase(waiting_for_components_.begin() + static_cast<std::ptrdiff_t>(k));
    job->enter(Phase::queue, sim_.now());
    Group& group = *groups_[job->on_its_way_to];
    if (!group.idle.empty()) {
      group.idle.pop_front()->inbox.try_put(job);
    } else {
      group.queue.push_back(job);
      group.queue_length.set(sim_.now(), static_cast<double>(group.queue.size()));
    }
  }
  for (Group* group : assembling_groups_)
    while (!group->idle.empty()) {
      Job* job = new_unlimited_job(*group);
      if (job == nullptr) break;
      job->from = from_components();
      group->idle.pop_front()->inbox.try_put(job);
    }
}

void Shop::store_parts(Job& job) {
  StoreUnit& store = *store_of_[job.part];
  store.on_their_way -= job.quantity;
  store.parts[job.part] += job.quantity;
  store.level += job.quantity;
  store.stored += static_cast<std::uint64_t>(job.quantity);
  store.mean_level.set(sim_.now(), static_cast<double>(store.level));

  PartCounts& counts = parts_[job.part];
  const scenarios::PartType& type = scenario_.parts[job.part];
  const auto quantity = static_cast<double>(job.quantity);
  counts.good += static_cast<std::uint64_t>(job.quantity);
  counts.escaped += static_cast<std::uint64_t>(job.defects);
  costs_.book(Cost::escapes, static_cast<double>(job.defects) * type.escape_cost);
  if (sim_.now() > job.due_min) {
    counts.late += static_cast<std::uint64_t>(job.quantity);
    counts.tardiness_min += quantity * (sim_.now() - job.due_min);
    costs_.book(Cost::tardiness, quantity * (sim_.now() - job.due_min) * type.tardiness_cost_per_min);
  }
  Source& source = *sources_[job.part];
  source.ended_ever += static_cast<std::uint64_t>(job.quantity);
  source.parts_in_shop -= job.quantity;
  work_in_process_.change(sim_.now(), -quantity);
  if (trace_ != nullptr) trace_->part_finished(job.part, job.arrived_min, sim_.now());
  count_lead_time(job, job.quantity);
  finish(job);
  serve_assemblies();
}

void Shop::count_lead_time(const Job& job, std::int64_t quantity) {
  PartCounts& counts = parts_[job.part];
  Job until_now = job;
  until_now.enter(job.phase, sim_.now());
  for (std::size_t k = 0; k < phases; ++k)
    counts.phase_min[k] += static_cast<double>(quantity) * until_now.phase_min[k];
  const double lead_time_min = sim_.now() - job.arrived_min;
  counts.lead_time_min += static_cast<double>(quantity) * lead_time_min;
  lead_times_.add(lead_time_min);
}

void Shop::finish(Job& job) {
  const std::size_t part = job.part;
  --sources_[part]->batches_in_shop;
  jobs_.give_back(&job);
  --batches_;
  release_what_may(part);
}

sim::Task<void> Shop::demand(StoreUnit& store) {
  const sim::Distribution interarrival = law_of(*store.spec->demand);
  const scenarios::SimulationSettings& settings = scenario_.simulation;
  sim::RandomStream stream(settings.seed.value, drawn_as(settings, store.spec->name), "demand", replication_);
  for (;;) {
    const double wait_min = interarrival.sample(stream);
    co_await sim_.delay(wait_min);
    ++store.customers;
    if (store.level == 0) {
      ++store.lost;
      costs_.book(Cost::lost_demand, store.spec->demand_lost_cost);
      continue;
    }
    // The customer takes what there is most of.
    const auto kind = std::max_element(store.parts.begin(), store.parts.end());
    --*kind;
    --store.level;
    ++store.taken;
    store.mean_level.set(sim_.now(), static_cast<double>(store.level));
    store.room.notify();
  }
}

}  // namespace verstat::shop
