// Tools at work: cutting until an edge fails or is due, changing it, what that costs.
#include <algorithm>

#include "sim/shop/shop_parts.h"
#include "sim/shop/trace.h"

namespace verstat::shop {

Shop::MountedTool::MountedTool(const scenarios::Scenario& scenario, const scenarios::Tool& tool,
                               std::size_t tool_index, std::vector<std::size_t> tool_crews,
                               const scenarios::WorkingTime* working_time, const std::string& entity,
                               std::uint64_t replication)
    : spec(&tool),
      insert_spec(scenarios::find_named(scenario.inserts, tool.insert)),
      index(tool_index),
      crews(std::move(tool_crews)),
      insert(*insert_spec, scenario.simulation.seed.value, entity, replication),
      strategy(make_strategy(tool.strategy,
                             models::LifeLaw(insert_spec->edge_life.law, 1.0, insert_spec->edge_life.cv))),
      clock(working_time),
      index_time(law_of(tool.change.index)),
      replace_time(law_of(tool.change.replace)),
      index_stream(scenario.simulation.seed.value, entity, "index time", replication),
      replace_stream(scenario.simulation.seed.value, entity, "replace time", replication),
      scrap_stream(scenario.simulation.seed.value, entity, "scrap", replication) {}

// Cuts one part. Within one instant a failure comes before a planned change (X <= tau fails), and both before
// the end of the cut; a planned change that falls due with the end of a part is made before the next one.
sim::Task<void> Shop::cut(MachineUnit& machine, MountedTool& tool, double main_time_min,
                          double mean_life_min) {
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
      co_await spend(machine, MachineState::cutting, cut_min, &tool);
      tool.insert.spend(cut_min / mean_life_min);
      tool.wear_since_plan += cut_min / mean_life_min;
      left_min -= cut_min;
      if (cut_min < to_stop_min) continue;  // the part is finished first
    }
    if (!fails_first && left_min <= crumb_min) continue;  // due with the end of the part
    if (fails_first) {
      const double draw = tool.scrap_stream.uniform();
      if (draw < tool.spec->failure_scrap_probability) machine.part_spoiled = true;
    }
    co_await change_edge(machine, tool, fails_first, mean_life_min);
  }
  tool.clock.enter(MachineState::idle, sim_.now());
}

sim::Task<void> Shop::change_edge(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                  double mean_life_min) {
  const Cost heading = after_failure ? Cost::failure_change : Cost::planned_change;
  const CrewHold hold =
      co_await call_crew(machine, tool.crews, heading, 0, MachineState::waiting_crew, &tool);
  ToolCounts& counts = tools_[tool.index];
  if (trace_ != nullptr)
    trace_->edge_removed(tool.index, machine.index, sim_.now(), tool.insert.wear() * mean_life_min,
                         after_failure);
  ++counts.edges_used;
  counts.edge_minutes_used += tool.insert.wear() * mean_life_min;
  if (after_failure) {
    ++counts.failures;
    costs_.book(Cost::damage, tool.spec->failure_damage);
    costs_.book(Cost::regrinding, tool.spec->regrind_failure);
  } else {
    ++counts.planned_changes;
    costs_.book(Cost::regrinding, tool.spec->regrind_planned);
    tool.wear_since_plan = 0;
  }
  if (tool.spec->insert_booking == scenarios::InsertBooking::life_periods)
    costs_.book(Cost::inserts, tool.insert_spec->price /
                                   (after_failure ? tool.spec->periods_failure : tool.spec->periods_planned));

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
      costs_.book(Cost::inserts, tool.insert_spec->price);
  }
  const MachineState state = after_failure ? MachineState::failure_change : MachineState::planned_change;
  co_await spend(machine, state, time_min, &tool);
}

}  // namespace verstat::shop
