// Copies of tools: sisters in the magazine, tools shared between machines, and the tool room where worn ones
// get new edges, are reground and set.
#include "sim/shop/shop_parts.h"

namespace verstat::shop {

sim::Task<void> Shop::fetch_tool(MachineUnit& machine, MountedTool& tool) {
  ToolBody* copy = nullptr;
  if (auto ready = tool.pool->ready.try_get()) {
    copy = *ready;
  } else {
    ++tools_[tool.index].waits;
    tool.stops.add(sim_.now());
    enter(machine, MachineState::waiting_tool, &tool);
    copy = co_await tool.pool->ready.get();
  }
  tool.body = copy;
  // A shared copy that another machine had, or that comes back from the tool room, is carried here.
  if (tool.spec->shared && tool.last != copy) {
    const double swap_min = tool.swap_time.sample(tool.swap_stream);
    co_await spend(machine, MachineState::tool_swap, swap_min, &tool);
  }
  tool.last = copy;
}

void Shop::put_back(MountedTool& tool) {
  if (!tool.spec->shared || tool.body == nullptr) return;
  tool.pool->ready.try_put(tool.body);
  tool.body = nullptr;
}

sim::Task<void> Shop::swap_tool(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                double mean_life_min) {
  ToolBody& worn = *tool.body;
  tool.body = nullptr;
  tool.last = nullptr;
  count_change(tool, after_failure);
  ++tool.pool->in_tool_room;
  sim_.spawn("tool room", tool_room(tool, worn, after_failure, mean_life_min));
  const scenarios::ToolChange& change = tool.spec->change;
  double time_min = change.stop_min + (after_failure ? change.failure_extra_min : 0);
  co_await fetch_tool(machine, tool);
  if (!tool.spec->shared) time_min += tool.swap_time.sample(tool.swap_stream);
  co_await spend(machine, MachineState::tool_swap, time_min, &tool);
}

sim::Task<void> Shop::tool_room(MountedTool& tool, ToolBody& body, bool after_failure, double mean_life_min) {
  const std::int64_t used_up = body.decide_change(after_failure);
  const auto& regrind = tool.spec->regrind;
  // A drill is a tool of one tooth: what is left of it is reground, unless the failure broke it.
  const bool reground =
      regrind && used_up > 0 && !body.teeth().front().outlook.broken && body.regrinds < regrind->max_regrinds;
  if (reground) {
    ++body.regrinds;
    ++tools_[tool.index].regrinds;
    costs_.book(Cost::regrinding, after_failure ? tool.spec->regrind_failure : tool.spec->regrind_planned);
    const double away_min = tool.regrind_time->sample(tool.regrind_stream);
    co_await sim_.delay(away_min);
  } else if (used_up > 0) {
    body.regrinds = 0;
    if (tool.crib != nullptr) co_await tool.crib->issue(used_up);
  }
  const CrewHold hold = co_await labour_->call(tool.presetting_crews, 0, Cost::tool_room);
  const double setting_min = tool.presetting_time ? tool.presetting_time->sample(tool.presetting_stream)
                                                  : tool.spec->change.positioning_min;
  const double time_min = renew_teeth(tool, body, after_failure, reground, mean_life_min, setting_min);
  co_await sim_.delay(time_min);
  --tool.pool->in_tool_room;
  tool.pool->ready.try_put(&body);
}

}  // namespace verstat::shop
