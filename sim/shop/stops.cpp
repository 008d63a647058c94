// Failures and maintenance: when they come, who mends, what they renew.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

using scenarios::AtShiftEnd;
using scenarios::StopEffect;
using scenarios::UsageClock;

namespace {

double reading_of(UsageClock clock, double now_min, double operating_min, double cutting_min, double parts) {
  switch (clock) {
    case UsageClock::calendar:
      return now_min;
    case UsageClock::operating:
      return operating_min;
    case UsageClock::cutting:
      return cutting_min;
    case UsageClock::parts:
      return parts;
  }
  return now_min;
}

// Minutes of this clock that pass per minute in this state.
double speed_of(UsageClock clock, MachineState state) {
  switch (clock) {
    case UsageClock::calendar:
      return 1;
    case UsageClock::operating:
      return state == MachineState::cutting || state == MachineState::working ? 1 : 0;
    case UsageClock::cutting:
      return state == MachineState::cutting ? 1 : 0;
    case UsageClock::parts:
      return 0;
  }
  return 0;
}

bool in_effect(StopEffect effect, StopEffect context) {
  return static_cast<int>(effect) <= static_cast<int>(context);
}

}  // namespace

Shop::Stop* Shop::due_stop(MachineUnit& machine, StopEffect context) const {
  for (const auto& stop : machine.stops) {
    const double reading =
        reading_of(stop->clock, sim_.now(), machine.operating_min, machine.cutting_min, machine.parts);
    if (in_effect(stop->effect, context) && reading >= stop->due - 1e-9 * std::max(1.0, std::abs(stop->due)))
      return stop.get();
  }
  return nullptr;
}

double Shop::time_to_stop(const MachineUnit& machine, MachineState state, StopEffect context) const {
  double first_min = std::numeric_limits<double>::infinity();
  for (const auto& stop : machine.stops) {
    const double speed = speed_of(stop->clock, state);
    if (speed == 0 || !in_effect(stop->effect, context)) continue;
    const double reading =
        reading_of(stop->clock, sim_.now(), machine.operating_min, machine.cutting_min, machine.parts);
    first_min = std::min(first_min, std::max(0.0, (stop->due - reading) / speed));
  }
  return first_min;
}

sim::Task<void> Shop::deal_with_stops(MachineUnit& machine, StopEffect context, MountedTool* tool) {
  machine.standing_still = true;
  bool any = false;
  while (Stop* stop = due_stop(machine, context)) {
    co_await stand_still(machine, *stop, tool);
    any = true;
  }
  if (any) {
    for (const auto& stop : machine.stops) {
      if (stop->maintenance == nullptr || stop->maintenance->joins_from >= 1) continue;
      const double reading =
          reading_of(stop->clock, sim_.now(), machine.operating_min, machine.cutting_min, machine.parts);
      if (reading - stop->renewed >= stop->maintenance->joins_from * stop->maintenance->interval)
        co_await stand_still(machine, *stop, tool);
    }
    if (machine.has_joiners) {
      if (tool != nullptr) tool->clock.enter(MachineState::idle, sim_.now());
      co_await join_stop(machine, tool, nullptr);
    }
  }
  machine.standing_still = false;
}

sim::Task<void> Shop::stand_still(MachineUnit& machine, Stop& stop, MountedTool* tool) {
  const bool failed = stop.failure != nullptr;
  ++stop.count;
  if (failed) {
    ++machine.failures;
    machine.missions.add(sim_.now());
    costs_.book(Cost::damage, stop.failure->damage);
    if (stop.failure->scrap_probability > 0 && stop.scrap_stream.uniform() < stop.failure->scrap_probability)
      machine.part_spoiled = true;
  } else {
    ++machine.maintenance_jobs;
  }
  const std::int64_t priority = failed ? stop.failure->priority : stop.maintenance->priority;
  const Cost heading = failed ? Cost::repair : Cost::maintenance;
  const MachineState state = failed ? MachineState::repair : MachineState::maintenance;
  double left_min = stop.duration->sample(stop.duration_stream);

  if (stop.spare != scenarios::route_end) {
    enter(machine, MachineState::waiting_repair, tool);
    co_await take_spare(stop.spare);
  }
  const auto& working_time = machine.group->working_time;
  const bool pauses = working_time && machine.group->spec->repair_at_shift_end == AtShiftEnd::pause;
  for (;;) {
    if (pauses && !working_time->open(sim_.now())) co_await open_shift(machine);
    CrewHold mender =
        co_await call_crew(machine, stop.crews, heading, priority, MachineState::waiting_repair, tool);
    enter(machine, state, tool);
    double slice_min = left_min;
    if (pauses) slice_min = std::min(slice_min, working_time->next_change_min(sim_.now()) - sim_.now());
    co_await sim_.delay(slice_min);
    left_min -= slice_min;
    if (!(left_min > 1e-9)) break;
    mender.release();
  }
  if (failed) {
    renew(machine, stop);
    co_return;
  }
  for (const std::size_t mode : stop.renews) {
    Stop& renewed = *machine.stops[mode];
    const double reading =
        reading_of(renewed.clock, sim_.now(), machine.operating_min, machine.cutting_min, machine.parts);
    const double used = (reading - renewed.renewed) / (renewed.due - renewed.renewed);
    const double threshold = stop.maintenance->condition_threshold;
    // Drawn whether used or not: variants of the shop stay in step.
    const bool noticed = stop.detection_stream.uniform() < stop.maintenance->detection_probability;
    if (threshold == 0 || (used >= threshold && noticed)) renew(machine, renewed);
  }
  renew(machine, stop);
}

void Shop::renew(MachineUnit& machine, Stop& stop) {
  stop.renewed =
      reading_of(stop.clock, sim_.now(), machine.operating_min, machine.cutting_min, machine.parts);
  stop.due = stop.renewed +
             (stop.failure != nullptr ? stop.life->sample(stop.life_stream) : stop.maintenance->interval);
}

sim::Task<void> Shop::take_spare(std::size_t index) {
  Spares& spares = *spares_[index];
  const auto order = [&] {
    spares.ordered += spares.spec->order_quantity;
    sim_.spawn("delivery of " + spares.spec->name, deliver_spares(index));
  };
  if (spares.stock == 0) {
    ++spares.stock_outs;
    if (spares.ordered == 0) order();  // whatever the reorder point says: somebody waits for it
    co_await spares.arrived.wait_until([&] { return spares.stock > 0; });
  }
  --spares.stock;
  ++spares.used;
  ++spares.used_ever;
  costs_.book(Cost::spares, spares.spec->price);
  if (spares.stock + spares.ordered <= spares.spec->reorder_point) order();
}

sim::Task<void> Shop::deliver_spares(std::size_t index) {
  Spares& spares = *spares_[index];
  const double lead_min = spares.lead_time.sample(spares.lead_time_stream);
  co_await sim_.delay(lead_min);
  spares.stock += spares.spec->order_quantity;
  spares.ordered -= spares.spec->order_quantity;
  spares.delivered_ever += static_cast<std::uint64_t>(spares.spec->order_quantity);
  spares.arrived.notify();
}

}  // namespace verstat::shop
