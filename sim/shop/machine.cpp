// Machines at work: waiting for a batch, setting up, loading, working part by part.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/kernel/composite.h"
#include "sim/shop/shop_parts.h"
#include "sim/shop/trace.h"

namespace verstat::shop {

using scenarios::AtShiftEnd;
using scenarios::Attendance;
using scenarios::StopEffect;

void Shop::enter(MachineUnit& machine, MachineState state, MountedTool* tool) {
  if (trace_ != nullptr && state != machine.clock.state())
    trace_->machine_state(machine.index, sim_.now(), state);
  if (is_passive(machine.clock.state()) && !is_passive(state)) ++machine.active_periods;
  machine.clock.enter(state, sim_.now());
  if (tool != nullptr) tool->clock.enter(state, sim_.now());
}

sim::Task<void> Shop::machine_process(MachineUnit& machine) {
  for (;;) {
    Job* const job = co_await wait_for_job(machine);
    machine.job = job;
    told_idle(machine, *job);
    ++machine.group->in_work;
    co_await process(machine, *job);
    machine.job = nullptr;
    --machine.group->in_work;
  }
}

sim::Task<Job*> Shop::wait_for_job(MachineUnit& machine) {
  Group& group = *machine.group;
  const scenarios::WorkingTime* working_time = group.working_time ? &*group.working_time : nullptr;
  const double never = std::numeric_limits<double>::infinity();
  bool switched_off = false;
  double idle_since_min = sim_.now();
  for (;;) {
    if (working_time != nullptr && !working_time->open(sim_.now())) {
      co_await open_shift(machine);
      idle_since_min = sim_.now();
      switched_off = false;
    }
    if (due_stop(machine, StopEffect::after_part) != nullptr)
      co_await deal_with_stops(machine, StopEffect::after_part);
    Job* job = take_job(machine);
    if (job == nullptr) {
      if (due_stop(machine, StopEffect::when_idle) != nullptr) {
        co_await deal_with_stops(machine, StopEffect::when_idle);
        continue;
      }
      enter(machine, switched_off ? MachineState::off : MachineState::idle);
      const double now = sim_.now();
      double wake_min = time_to_stop(machine, MachineState::idle, StopEffect::when_idle);
      if (working_time != nullptr) wake_min = std::min(wake_min, working_time->next_change_min(now) - now);
      const bool may_switch_off = group.switches_off && !switched_off;
      double switch_off_min = never;
      if (may_switch_off)
        switch_off_min = std::max(0.0, idle_since_min + group.spec->switch_off->after_idle_min - now);
      wake_min = std::min(wake_min, switch_off_min);
      group.idle.push_back(&machine);
      group.room.notify();
      if (wake_min == never) {
        job = co_await machine.inbox.get();
      } else {
        auto came = co_await sim::first_of(machine.inbox.get(), sim_.delay(wake_min));
        if (came.index() == 0) {
          job = came.get<0>();
        } else {
          group.no_longer_idle(machine);
          if (wake_min == switch_off_min) switched_off = true;
          continue;
        }
      }
    }
    if (switched_off) {
      const double warm_up_min = group.warm_up_time->sample(machine.setup_stream);
      co_await spend(machine, MachineState::warm_up, warm_up_min);
    }
    co_return job;
  }
}

// Outside the calendar until the next shift begins, which may start with warming up.
sim::Task<void> Shop::open_shift(MachineUnit& machine) {
  enter(machine, MachineState::off_shift);
  labour_->leave(machine.index);
  const double opens_min = machine.group->working_time->next_change_min(sim_.now());
  co_await sim_.delay(opens_min - sim_.now());
  labour_->come_back(machine.index);
  if (machine.group->warm_up_time) {
    const double warm_up_min = machine.group->warm_up_time->sample(machine.setup_stream);
    co_await spend(machine, MachineState::warm_up, warm_up_min);
  }
}

sim::Task<void> Shop::process(MachineUnit& machine, Job& job) {
  Group& group = *machine.group;
  const PlannedOperation& operation = planned(job);
  job.enter(Phase::machine, sim_.now());
  if (trace_ != nullptr) trace_->part_step(job.part, job.step, machine.index, sim_.now());
  CrewHold attending;
  if (group.attended == Attendance::always) {
    attending = co_await call_crew(machine, group.attendance_crews, Cost::labour);
  }
  const std::size_t family = operations_[routes_[job.part][job.step].operation].family;
  if (group.has_setup && machine.family != family) co_await set_up(machine, family);

  std::int64_t rejected = 0;
  const std::int64_t defective = job.defects;  // from operations before: the first so many parts of the batch
  for (std::int64_t k = 0; k < job.quantity; ++k) {
    if (k > 0) {
      if (group.working_time && !group.working_time->open(sim_.now())) co_await open_shift(machine);
      if (due_stop(machine, StopEffect::after_part) != nullptr)
        co_await deal_with_stops(machine, StopEffect::after_part);
    }
    machine.part_spoiled = false;
    machine.part_wear = 0;
    if (group.loading_time) co_await load(machine, false);
    co_await work_on_part(machine, operation);
    if (group.unloading_time) co_await load(machine, true);
    machine.parts += 1;
    ++machine.parts_done;
    machine.planned_min += operation.main_time_min;
    costs_.book(Cost::operations, operation.cost);
    const bool had_defect = k < defective;
    if (machine.part_spoiled) {
      ++rejected;
      if (had_defect) --job.defects;
    } else if (leaves_defect(machine, operation) && !had_defect) {
      ++job.defects;
    }
  }
  attending.release();

  if (rejected > 0) reject(machine, job, rejected);
  if (operation.inspects && job.quantity > 0) {
    std::int64_t found = 0;
    if (operation.plan.gauge)
      found = co_await inspect_with_gauges(machine, operation, job);
    else
      found = inspect(machine, operation, job);
    if (found > 0) reject(machine, job, found);
  }
  for (const scenarios::RouteComponent& blank : routes_[job.part][job.step].yields)
    if (job.quantity > 0) start_route(*new_job(blank.part, blank.count * job.quantity));
  if (job.quantity > 0) {
    co_await pass_on(machine, job);
  } else {
    finish(job);
  }
}

sim::Task<void> Shop::set_up(MachineUnit& machine, std::size_t family) {
  Group& group = *machine.group;
  const bool first = !machine.family.has_value();
  const auto law =
      std::find_if(group.setup_times.begin(), group.setup_times.end(), [&](const Group::SetupLaw& l) {
        return (!l.from || (!first && *l.from == *machine.family)) && (!l.to || *l.to == family);
      });
  const double setup_min = law->time.sample(machine.setup_stream);
  machine.family = family;
  if (first) co_return;  // the shop is found set up
  const CrewHold setter = co_await call_crew(machine, group.setup_crews, Cost::setup);
  ++machine.setups;
  costs_.book(Cost::setup, group.spec->setup->cost);
  co_await spend(machine, MachineState::setup, setup_min);
}

sim::Task<void> Shop::load(MachineUnit& machine, bool unloading) {
  Group& group = *machine.group;
  const double time_min = unloading ? group.unloading_time->sample(machine.unloading_stream)
                                    : group.loading_time->sample(machine.loading_stream);
  CrewHold hands;
  if (group.attended == Attendance::loading)
    hands = co_await call_crew(machine, group.attendance_crews, Cost::labour);
  co_await spend(machine, MachineState::loading, time_min);
}

sim::Task<void> Shop::work_on_part(MachineUnit& machine, const PlannedOperation& operation) {
  const double main_time_min =
      operation.time_law ? operation.time_law->sample(machine.duration_stream) : operation.main_time_min;
  if (operation.uses_tool) {
    MountedTool& tool = *machine.tools[operation.tool_slot];
    co_await cut(machine, tool, operation, main_time_min);
    if (operation.wears && breaks(machine, operation)) {
      if (tool.scrap_stream.uniform() < tool.spec->failure_scrap_probability) machine.part_spoiled = true;
      co_await change_edge(machine, tool, true, operation.mean_life_min);
      tool.clock.enter(MachineState::idle, sim_.now());
    }
    machine.part_wear = tool.body->largest_wear();
    put_back(tool);
  } else {
    co_await spend(machine, MachineState::working, main_time_min);
  }
  if (operation.plan.overload) co_await overload(machine, *operation.plan.overload);
  if (spoils(machine, operation)) machine.part_spoiled = true;
}

// Trips and breaks of the drive while one part was cut (K204): their number is Poisson, by inversion of one
// uniform number each, and their time is added to the part.
sim::Task<void> Shop::overload(MachineUnit& machine, const operations::Overload& expected) {
  const Group& group = *machine.group;
  const auto poisson = [&](double mean) {
    double left = machine.overload_stream.uniform();
    double term = std::exp(-mean);
    int count = 0;
    while (left > term && count < 1000) {
      left -= term;
      ++count;
      term *= mean / count;
    }
    return count;
  };
  const int trips = poisson(expected.trips_per_part);
  const int breaks = poisson(expected.breaks_per_part);
  for (int k = 0; k < trips; ++k) {
    ++machine.overload_trips;
    CrewHold hands;
    if (!expected.self_reset) hands = co_await call_crew(machine, group.overload_crews, Cost::overload_reset);
    co_await spend(machine, MachineState::overload_reset, expected.reset_min);
  }
  for (int k = 0; k < breaks; ++k) {
    ++machine.overload_breaks;
    machine.missions.add(sim_.now());
    if (!group.spec->overload) continue;
    costs_.book(Cost::damage, group.spec->overload->damage);
    if (machine.overload_stream.uniform() < group.spec->overload->scrap_probability)
      machine.part_spoiled = true;
    const CrewHold mender =
        co_await call_crew(machine, group.overload_crews, Cost::repair, 0, MachineState::waiting_repair);
    const double repair_min = group.break_repair->sample(machine.overload_stream);
    co_await spend(machine, MachineState::repair, repair_min);
  }
}

sim::Task<CrewHold> Shop::call_crew(MachineUnit& machine, const std::vector<std::size_t>& crews, Cost heading,
                                    std::int64_t priority, MachineState waiting, MountedTool* tool) {
  CrewHold hold;
  if (crews.empty()) co_return hold;
  // Whoever is at the machine already does what is to be done, when it is their trade.
  if (labour_->present(machine.index, crews)) co_return hold;
  enter(machine, waiting, tool);
  const bool tends = heading == Cost::labour;
  hold = co_await labour_->call(crews, priority, heading, tends ? Labour::Hands::one : Labour::Hands::all,
                                machine.index);
  const double walk_min = hold.walking_min();
  if (walk_min > 0) co_await sim_.delay(walk_min);
  co_return hold;
}

sim::Task<void> Shop::spend(MachineUnit& machine, MachineState state, double time_min, MountedTool* tool) {
  const bool works = state == MachineState::cutting || state == MachineState::working;
  const auto& working_time = machine.group->working_time;
  const bool pauses = works && machine.group->pauses;
  const double crumb_min = 1e-9 * time_min;
  double left_min = time_min;
  for (;;) {
    enter(machine, state, tool);
    double slice_min = left_min;
    if (!machine.stops.empty() && !machine.standing_still)
      slice_min = std::min(slice_min, time_to_stop(machine, state, StopEffect::at_once));
    if (pauses)
      slice_min = working_time->open(sim_.now())
                      ? std::min(slice_min, working_time->next_change_min(sim_.now()) - sim_.now())
                      : 0;
    co_await sim_.delay(slice_min);
    left_min -= slice_min;
    if (works) machine.operating_min += slice_min;
    if (state == MachineState::cutting) machine.cutting_min += slice_min;
    if (left_min <= crumb_min) co_return;
    if (pauses && !working_time->open(sim_.now())) co_await open_shift(machine);
    if (!machine.standing_still) co_await deal_with_stops(machine, StopEffect::at_once, tool);
  }
}

}  // namespace verstat::shop
