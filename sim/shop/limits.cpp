// What limits what: whose full place blocks a machine, and whose parts it waits for when it idles.
//
// Blocked minutes belong to the place that was full. Idle minutes belong to where the batch that ended them
// came from: the machine group before, the supply of blanks, or components that were missing.
#include <algorithm>

#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

using scenarios::route_end;

namespace {

template <class Limits>
auto find(Limits& limits, std::size_t by) {
  return std::find_if(limits.begin(), limits.end(), [&](const auto& limit) { return limit.by == by; });
}
template <class Limits>
void expect(Limits& limits, std::size_t by) {
  if (find(limits, by) == limits.end()) limits.push_back({by, 0});
}
template <class Limits>
void add(Limits& limits, std::size_t by, double minutes) {
  const auto limit = find(limits, by);
  if (limit != limits.end()) limit->minutes += minutes;
}

template <class Limits>
void sort(Limits& limits) {
  std::sort(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.by < b.by; });
}

}  // namespace

// Every pair that can occur, so that all replications have the same KPIs. Places behind the groups are
// stores.
void Shop::build_limits() {
  const auto groups_for = [&](std::size_t operation) {
    std::vector<std::size_t> groups;
    for (const PlannedOperation& on : operations_[operation].on) groups.push_back(on.group);
    return groups;
  };
  for (std::size_t p = 0; p < routes_.size(); ++p) {
    const scenarios::Route& route = routes_[p];
    for (const std::size_t g : groups_for(route.front().operation))
      expect(groups_[g]->starved_of, from_supply());
    for (const scenarios::RouteStep& step : route) {
      std::vector<std::size_t> next;
      for (const scenarios::RouteBranch& branch : step.next) next.push_back(branch.to);
      if (step.rework != route_end) next.push_back(step.rework);
      for (const std::size_t from : groups_for(step.operation)) {
        if (!step.assembles.empty()) expect(groups_[from]->starved_of, from_components());
        for (const std::size_t to : next) {
          if (to == route_end) {
            if (store_of_[p]->spec->capacity)
              expect(groups_[from]->blocked_by, groups_.size() + store_of_[p]->index);
            continue;
          }
          for (const std::size_t g : groups_for(route[to].operation)) {
            expect(groups_[g]->starved_of, from);
            if (groups_[g]->spec->queue_capacity) expect(groups_[from]->blocked_by, g);
          }
        }
      }
    }
  }
  for (const auto& group : groups_) {
    sort(group->blocked_by);
    sort(group->starved_of);
  }
}

// Called when the machine has got a batch.
void Shop::told_idle(MachineUnit& machine, const Job& job) {
  machine.clock.settle(sim_.now());
  const double idle_min =
      machine.clock.time_min(MachineState::idle) + machine.clock.time_min(MachineState::off);
  if (idle_min == machine.idle_told_min) return;
  add(machine.group->starved_of, job.from, idle_min - machine.idle_told_min);
  machine.idle_told_min = idle_min;
}

// Called when the place has got room, and for who still waits at the end.
void Shop::told_blocked(MachineUnit& machine) {
  machine.clock.settle(sim_.now());
  const double blocked_min = machine.clock.time_min(MachineState::blocked);
  const Place by = machine.waits_for;
  if (by.store != route_end || by.group != route_end)  // a full conveyor is nobody's place
    add(machine.group->blocked_by, by.store != route_end ? groups_.size() + by.store : by.group,
        blocked_min - machine.blocked_told_min);
  machine.blocked_told_min = blocked_min;
}

void Shop::reset_limits() {
  for (const auto& group : groups_) {
    for (Group::Limit& limit : group->blocked_by) limit.minutes = 0;
    for (Group::Limit& limit : group->starved_of) limit.minutes = 0;
  }
  for (const auto& machine : machines_) {
    machine->idle_told_min = 0;
    machine->blocked_told_min = 0;
  }
}

void Shop::limit_kpis(const KpiSink& sink) const {
  for (const auto& group : groups_) {
    const double all_min = window_min() * static_cast<double>(group->spec->count);
    for (const Group::Limit& limit : group->blocked_by) {
      const std::string& by = limit.by < groups_.size() ? groups_[limit.by]->spec->name
                                                        : stores_[limit.by - groups_.size()]->spec->name;
      sink(KpiInfo{fmt::format("limits/{}/blocked_by/{}", group->spec->name, by), "1",
                   "share of the group's time blocked because this place was full"},
           ratio(limit.minutes, all_min));
    }
    for (const Group::Limit& limit : group->starved_of) {
      const std::string by = limit.by < groups_.size()   ? groups_[limit.by]->spec->name
                             : limit.by == from_supply() ? "(supply)"
                                                         : "(components)";
      sink(KpiInfo{fmt::format("limits/{}/starved_by/{}", group->spec->name, by), "1",
                   "share of the group's time idle until a batch came from there"},
           ratio(limit.minutes, all_min));
    }
  }
}

}  // namespace verstat::shop
