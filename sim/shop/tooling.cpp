// Tools at work: cutting until an edge fails or is due, changing it, what that costs.
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/shop/shop_parts.h"
#include "sim/shop/trace.h"

namespace verstat::shop {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

// What ends the cut before the part does, or tells somebody to look.
struct NextStop {
  enum class Kind { failure, planned, inspection, element };
  Kind kind = Kind::element;
  double in_min = never;
  std::size_t index = 0;  // of the tooth or the element
};

}  // namespace

// Cuts one part. Within one instant a failure comes before a planned change (X <= tau fails), and both before
// the end of the cut; what falls due with the end of a part is done before the next one.
sim::Task<void> Shop::cut(MachineUnit& machine, MountedTool& tool, const PlannedOperation& operation,
                          double main_time_min) {
  const bool wears = operation.wears;
  const double mean_life_min = operation.mean_life_min;
  tool.mean_life_min = mean_life_min;
  if (tool.body == nullptr) co_await fetch_tool(machine, tool);
  if (const auto* watch = tool.watch;
      watch != nullptr && watch->every_parts && tool.body->parts_since_inspection >= *watch->every_parts)
    co_await inspect_edge(machine, tool, mean_life_min);

  const auto next_stop = [&] {
    NextStop next;
    if (wears) {
      const ToolView view = tool.view(main_time_min);
      const ToolBody::Failure failure = tool.body->next_failure();
      next = {NextStop::Kind::failure, failure.wear_left * mean_life_min, failure.tooth};
      const double planned_min = tool.strategy->cutting_to_change_min(view);
      if (planned_min < next.in_min) next = {NextStop::Kind::planned, planned_min, 0};
      const double inspection_min = tool.strategy->cutting_to_inspection_min(view);
      if (inspection_min < next.in_min) next = {NextStop::Kind::inspection, inspection_min, 0};
    }
    for (std::size_t k = 0; k < tool.elements.size(); ++k) {
      const ElementUnit& element = tool.elements[k];
      if (operation.element_mean_min[k] == never) continue;
      const double end_min =
          (std::min(element.life, element.limit) - element.wear) * operation.element_mean_min[k];
      if (end_min < next.in_min) next = {NextStop::Kind::element, end_min, k};
    }
    return next;
  };

  // Rounding leaves crumbs of cutting where two times are equal by design.
  const double crumb_min = 1e-9 * main_time_min;
  double full_feed_left_min = main_time_min;
  while (full_feed_left_min > crumb_min) {
    const double feed = tool.body->feed_factor();
    const double left_min = full_feed_left_min / feed;
    const NextStop stop = next_stop();
    const double to_stop_min = std::max(0.0, stop.in_min);
    if (to_stop_min > left_min || to_stop_min > crumb_min) {
      const double cut_min = std::min(left_min, to_stop_min);
      co_await spend(machine, MachineState::cutting, cut_min, &tool);
      if (wears) {
        tool.body->spend(cut_min / mean_life_min);
        tool.body->cut_since_inspection_min += cut_min;
      }
      for (std::size_t k = 0; k < tool.elements.size(); ++k) {
        tool.elements[k].wear += cut_min / operation.element_mean_min[k];
        if (operation.element_mean_min[k] != never) tool.elements[k].use_min += cut_min;
      }
      full_feed_left_min -= cut_min * feed;
      if (cut_min < to_stop_min) continue;  // the part is finished first
    }
    if (stop.kind == NextStop::Kind::failure) {
      tool.body->fail(stop.index);
      ++tools_[tool.index].teeth_failed;
      if (tool.body->failed_teeth() < scenarios::failed_teeth_to_change(*tool.spec)) continue;
      const double draw = tool.scrap_stream.uniform();
      if (draw < tool.spec->failure_scrap_probability) machine.part_spoiled = true;
      co_await change_edge(machine, tool, true, mean_life_min);
      continue;
    }
    if (full_feed_left_min <= crumb_min) continue;  // due with the end of the part
    if (stop.kind == NextStop::Kind::planned) {
      co_await change_edge(machine, tool, false, mean_life_min);
    } else if (stop.kind == NextStop::Kind::inspection) {
      co_await inspect_edge(machine, tool, mean_life_min);
    } else {
      co_await change_element(machine, tool, tool.elements[stop.index]);
    }
  }
  ++tool.body->parts_since_inspection;
  tool.clock.enter(MachineState::idle, sim_.now());
}

// No coroutine of its own: it hands on the one that does the work.
sim::Task<void> Shop::change_edge(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                  double mean_life_min) {
  if (after_failure && tool.body->failed_teeth() == 0) tool.body->break_off();
  tool.changes.add(sim_.now());
  if (tool.pool != nullptr) return swap_tool(machine, tool, after_failure, mean_life_min);
  tool.stops.add(sim_.now());
  return change_on_machine(machine, tool, after_failure, mean_life_min, Stopped());
}

sim::Task<void> Shop::change_on_machine(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                        double mean_life_min, Stopped stopped) {
  ToolBody& body = *tool.body;
  const std::int64_t used_up = body.decide_change(after_failure);
  if (used_up > 0 && tool.crib != nullptr) co_await wait_for_inserts(machine, tool, used_up);
  const auto& crews = after_failure ? tool.failure_crews : tool.crews;
  CrewHold hold;
  if (stopped.present == nullptr || *stopped.present != crews) {
    const Cost heading = after_failure ? Cost::failure_change : Cost::planned_change;
    hold = co_await call_crew(machine, crews, heading, 0, MachineState::waiting_crew, &tool);
  }
  count_change(tool, after_failure);
  const scenarios::ToolChange& change = tool.spec->change;
  const double before_min = change.positioning_min + (after_failure ? change.failure_extra_min : 0) +
                            (stopped.before ? 0 : change.stop_min);
  const double time_min = renew_teeth(tool, body, after_failure, false, mean_life_min, before_min);
  const MachineState state = after_failure ? MachineState::failure_change : MachineState::planned_change;
  co_await spend(machine, state, time_min, &tool);
  if (!stopped.before && machine.has_joiners) {
    tool.clock.enter(MachineState::idle, sim_.now());
    co_await join_stop(machine, &tool, &crews);
  }
}

sim::Task<void> Shop::join_stop(MachineUnit& machine, const MountedTool* in_hand,
                                const std::vector<std::size_t>* present) {
  for (const auto& other : machine.tools) {
    if (other.get() == in_hand || other->body == nullptr || other->pool != nullptr) continue;
    if (!other->strategy->joins_stop(other->view(0))) continue;
    ++tools_[other->index].joined_changes;
    other->changes.add(sim_.now());
    const Stopped stopped{true, present};
    co_await change_on_machine(machine, *other, false, other->mean_life_min, stopped);
    other->clock.enter(MachineState::idle, sim_.now());
  }
}

void Shop::count_change(const MountedTool& tool, bool after_failure) {
  ToolCounts& counts = tools_[tool.index];
  const bool reground_each_time = !tool.spec->regrind.has_value();
  if (after_failure) {
    ++counts.failures;
    machines_[tool.machine]->missions.add(sim_.now());
    costs_.book(Cost::damage, tool.spec->failure_damage);
    if (reground_each_time) costs_.book(Cost::regrinding, tool.spec->regrind_failure);
  } else {
    ++counts.planned_changes;
    if (reground_each_time) costs_.book(Cost::regrinding, tool.spec->regrind_planned);
  }
}

double Shop::renew_teeth(MountedTool& tool, ToolBody& body, bool after_failure, bool reground,
                         double mean_life_min, double time_min) {
  ToolCounts& counts = tools_[tool.index];
  for (ToolBody::Tooth& tooth : body.teeth()) {
    if (!tooth.changed) continue;
    // Both times are drawn at every change, used or not: variants of the shop stay in step.
    const double index_min = tool.index_time.sample(tool.index_stream);
    const double replace_min = tool.replace_time.sample(tool.replace_stream);
    FittedInsert& insert = tooth.insert;
    if (trace_ != nullptr)
      trace_->edge_removed(tool.index, tool.machine, sim_.now(), insert.wear() * mean_life_min, tooth.failed);
    ++counts.edges_used;
    counts.edge_minutes_used += insert.wear() * mean_life_min;
    if (!tooth.failed) {
      ++counts.edges_unspent;
      if (insert.life() > 0) counts.life_left += std::max(0.0, 1 - insert.wear() / insert.life());
    }
    const std::int64_t unused = insert.edges_held() - 1;
    if (tool.spec->insert_booking == scenarios::InsertBooking::life_periods)
      costs_.book(Cost::inserts, tool.insert_spec->price / (tooth.failed ? tool.spec->periods_failure
                                                                         : tool.spec->periods_planned));
    if (tooth.outlook.next == FittedInsert::Next::edge) {
      time_min += index_min;
      insert.turn_to_next_edge();
    } else if (reground) {
      time_min += replace_min;
      insert.regrind(std::pow(tool.spec->regrind->life_factor, static_cast<double>(body.regrinds)));
      counts.edges_reground += insert.edges_held();
    } else {
      time_min += replace_min;
      counts.edges_discarded += unused;  // a failure broke them
      counts.edges_fitted += insert.fit_new();
      ++counts.inserts_fitted;
      weeks_of_insert_[insert_of_tool_[tool.index]].add(sim_.now());
      if (grade_of_tool_[tool.index] != nullptr) grade_of_tool_[tool.index]->weeks.add(sim_.now());
      if (tool.spec->insert_booking == scenarios::InsertBooking::at_fitting)
        costs_.book(Cost::inserts, tool.insert_spec->price);
    }
  }
  body.change_made(after_failure);
  return time_min;
}

sim::Task<void> Shop::wait_for_inserts(MachineUnit& machine, MountedTool& tool, std::int64_t inserts) {
  if (tool.crib->would_wait(inserts)) {
    ++tools_[tool.index].waits;
    enter(machine, MachineState::waiting_tool, &tool);
  }
  co_await tool.crib->issue(inserts);
}

sim::Task<void> Shop::inspect_edge(MachineUnit& machine, MountedTool& tool, double mean_life_min) {
  const auto& watch = std::get<scenarios::ConditionBased>(tool.spec->strategy);
  ToolCounts& counts = tools_[tool.index];
  ToolBody& body = *tool.body;
  body.cut_since_inspection_min = 0;
  body.parts_since_inspection = 0;
  if (watch.inspection_min > 0) {
    tool.stops.add(sim_.now());
    const CrewHold hold =
        co_await call_crew(machine, tool.crews, Cost::planned_change, 0, MachineState::waiting_crew, &tool);
    co_await spend(machine, MachineState::planned_change, watch.inspection_min, &tool);
  }
  ++counts.inspections;
  const bool worn = body.worst_share_of_life() >= tool.sign_share;
  const double noticed = worn ? watch.detection_probability : watch.false_alarm_probability;
  if (tool.inspection_stream.uniform() >= noticed) co_return;
  ++(worn ? counts.worn_found : counts.false_alarms);
  co_await change_edge(machine, tool, false, mean_life_min);
}

sim::Task<void> Shop::change_element(MachineUnit& machine, MountedTool& tool, ElementUnit& element) {
  tool.stops.add(sim_.now());
  const CrewHold hold =
      co_await call_crew(machine, tool.crews, Cost::planned_change, 0, MachineState::waiting_crew, &tool);
  ++element.changes;
  element.use_min_sum += element.use_min;
  costs_.book(Cost::elements, element.spec->price);
  const double time_min = element.change_time.sample(element.change_stream);
  element.renew();
  co_await spend(machine, MachineState::planned_change, time_min, &tool);
}

}  // namespace verstat::shop
