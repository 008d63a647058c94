#pragma once
// Where a machine's time goes: one state at a time, so that the times add up to the calendar.

#include <array>
#include <cstdint>
#include <string_view>

#include "scenarios/calendar.h"

namespace verstat::shop {

/// Exclusive states of a machine (and of a tool on it).
enum class MachineState : std::uint8_t {
  cutting,         ///< removing metal (ISO 22400: production time)
  working,         ///< an operation given as a plain duration
  loading,         ///< a part is loaded or unloaded
  setup,           ///< changing over to another family
  planned_change,  ///< the crew indexes or changes an insert as planned
  failure_change,  ///< the crew does so after an edge has failed
  waiting_crew,    ///< hands are needed, the crew is busy elsewhere or off
  waiting_tool,    ///< a tool or an insert is needed, none is there
  repair,          ///< under repair after a failure
  waiting_repair,  ///< failed or due for maintenance: waits for crew or spare part
  maintenance,     ///< planned maintenance
  overload_reset,  ///< the overload clutch has tripped and is reset
  warm_up,         ///< warming up after switching on
  blocked,         ///< the batch cannot leave: the next place is full
  idle,            ///< no part to work on
  off,             ///< switched off for lack of work
  off_shift,       ///< outside its calendar
  tool_swap        ///< a sister tool comes out of the magazine: nobody is needed
};
inline constexpr std::size_t machine_states = 18;
[[nodiscard]] constexpr std::string_view name_of(MachineState state) {
  constexpr std::array<std::string_view, machine_states> names = {
      "cutting",        "working",        "loading",      "setup",
      "planned_change", "failure_change", "waiting_crew", "waiting_tool",
      "repair",         "waiting_repair", "maintenance",  "overload_reset",
      "warm_up",        "blocked",        "idle",         "off",
      "off_shift",      "tool_swap"};
  return names[static_cast<std::size_t>(state)];
}
/// A machine in a passive state waits for others. The rest is activity, planned or not.
[[nodiscard]] constexpr bool is_passive(MachineState state) {
  return state == MachineState::waiting_crew || state == MachineState::waiting_tool ||
         state == MachineState::waiting_repair || state == MachineState::blocked ||
         state == MachineState::idle || state == MachineState::off || state == MachineState::off_shift;
}

class StateClock {
 public:
  /// `working_time` null: round the clock. Waiting outside the calendar is booked as off_shift; work that
  /// goes on after the end of the shift is booked as what it is.
  explicit StateClock(const scenarios::WorkingTime* working_time = nullptr) : working_time_(working_time) {}

  /// The machine is in `state` from `now_min` on.
  void enter(MachineState state, double now_min) {
    settle(now_min);
    state_ = state;
  }
  [[nodiscard]] MachineState state() const { return state_; }
  /// Forgets the past (end of the warm-up); the present state goes on.
  void reset(double now_min) {
    time_min_.fill(0);
    since_min_ = now_min;
  }
  /// Books the time up to `now_min`.
  void settle(double now_min) {
    if (working_time_ != nullptr && is_passive(state_) && now_min > since_min_) {
      const double inside_min = working_time_->working_min(since_min_, now_min);
      book(state_, inside_min);
      book(MachineState::off_shift, now_min - since_min_ - inside_min);
    } else {
      book(state_, now_min - since_min_);
    }
    since_min_ = now_min;
  }
  [[nodiscard]] double time_min(MachineState state) const {
    return time_min_[static_cast<std::size_t>(state)];
  }

 private:
  void book(MachineState state, double minutes) { time_min_[static_cast<std::size_t>(state)] += minutes; }

  const scenarios::WorkingTime* working_time_ = nullptr;
  MachineState state_ = MachineState::idle;
  double since_min_ = 0;
  std::array<double, machine_states> time_min_{};
};

}  // namespace verstat::shop
