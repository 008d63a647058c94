#pragma once
// Where a machine's time goes: one state at a time, so that the times add up to the calendar.

#include <array>
#include <string_view>

namespace verstat::shop {

/// Exclusive states of a machine.
enum class MachineState {
  cutting,         ///< removing metal (ISO 22400: production time)
  working,         ///< an operation given as a plain duration
  planned_change,  ///< the crew indexes or changes an insert as planned
  failure_change,  ///< the crew does so after an edge has failed
  waiting_crew,    ///< an edge is to be changed, the crew is busy elsewhere
  idle,            ///< no part to work on
  waiting_tool,    ///< no sister tool is ready, or the crib has no insert
  tool_swap        ///< a sister tool comes out of the magazine: nobody is needed
};
inline constexpr std::size_t machine_states = 8;
[[nodiscard]] constexpr std::string_view name_of(MachineState state) {
  constexpr std::array<std::string_view, machine_states> names = {
      "cutting",      "working", "planned_change", "failure_change",
      "waiting_crew", "idle",    "waiting_tool",   "tool_swap"};
  return names[static_cast<std::size_t>(state)];
}

class StateClock {
 public:
  /// The machine is in `state` from `now_min` on.
  void enter(MachineState state, double now_min) {
    settle(now_min);
    state_ = state;
  }
  /// Forgets the past (end of the warm-up); the present state goes on.
  void reset(double now_min) {
    time_min_.fill(0);
    since_min_ = now_min;
  }
  /// Books the time up to `now_min`.
  void settle(double now_min) {
    time_min_[static_cast<std::size_t>(state_)] += now_min - since_min_;
    since_min_ = now_min;
  }
  [[nodiscard]] double time_min(MachineState state) const {
    return time_min_[static_cast<std::size_t>(state)];
  }

 private:
  MachineState state_ = MachineState::idle;
  double since_min_ = 0;
  std::array<double, machine_states> time_min_{};
};

}  // namespace verstat::shop
