#include "sim/shop/costs.h"

namespace verstat::shop {

namespace {
struct Heading {
  std::string_view name;
  std::string_view meaning;
};
constexpr std::array<Heading, cost_headings> headings = {{
    {"machining", "machine minutes of cutting"},
    {"other_operations", "machine minutes of operations given as durations"},
    {"loading", "machine minutes of loading and unloading"},
    {"setup", "machine and crew minutes of changing over, and its cost"},
    {"planned_change", "machine and crew minutes of planned changes of inserts or gauges"},
    {"failure_change", "machine and crew minutes of changes after a failure"},
    {"waiting_crew", "machine minutes of waiting for the crew"},
    {"waiting_tool", "machine minutes of waiting for a tool or an insert"},
    {"repair", "machine and crew minutes of repairs"},
    {"waiting_repair", "machine minutes of waiting for a repair or maintenance to begin"},
    {"maintenance", "machine and crew minutes of planned maintenance"},
    {"overload_reset", "machine minutes of resetting overload clutches"},
    {"warm_up", "machine minutes of warming up"},
    {"blocked", "machine minutes of waiting for room at the next place"},
    {"idle", "machine minutes without a part"},
    {"off", "machine minutes switched off"},
    {"labour", "crews paid by the shift, and attendance of machines"},
    {"transport", "vehicles and their drivers"},
    {"inserts", "inserts"},
    {"regrinding", "regrinding"},
    {"damage", "holders, shims, rework and damage after failures"},
    {"spares", "spare parts used"},
    {"operations", "costs of operations per part besides machine and people"},
    {"scrap", "value of scrapped parts"},
    {"escapes", "defective parts that left the shop"},
    {"tardiness", "parts finished after their due date"},
    {"lost_demand", "customers who found the store empty"},
    {"energy", "electric energy"},
    {"tool_swap", "machine minutes of swapping sister tools"},
    {"tool_room", "crew minutes at tools off the machines"},
    {"elements", "guide pads, dressings and other second elements"},
}};
}  // namespace

std::string_view name_of(Cost cost) {
  return headings[static_cast<std::size_t>(cost)].name;
}
std::string_view meaning_of(Cost cost) {
  return headings[static_cast<std::size_t>(cost)].meaning;
}

Cost heading_of(MachineState state) {
  switch (state) {
    case MachineState::cutting:
      return Cost::machining;
    case MachineState::working:
      return Cost::other_operations;
    case MachineState::loading:
      return Cost::loading;
    case MachineState::setup:
      return Cost::setup;
    case MachineState::planned_change:
      return Cost::planned_change;
    case MachineState::failure_change:
      return Cost::failure_change;
    case MachineState::waiting_crew:
      return Cost::waiting_crew;
    case MachineState::waiting_tool:
      return Cost::waiting_tool;
    case MachineState::repair:
      return Cost::repair;
    case MachineState::waiting_repair:
      return Cost::waiting_repair;
    case MachineState::maintenance:
      return Cost::maintenance;
    case MachineState::overload_reset:
      return Cost::overload_reset;
    case MachineState::warm_up:
      return Cost::warm_up;
    case MachineState::blocked:
      return Cost::blocked;
    case MachineState::idle:
      return Cost::idle;
    case MachineState::tool_swap:
      return Cost::tool_swap;
    case MachineState::off:
    case MachineState::off_shift:
      return Cost::off;
  }
  return Cost::idle;
}

}  // namespace verstat::shop
