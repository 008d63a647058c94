#pragma once
// Simulation: the clock, the pending events and the processes of one run.

#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "sim/kernel/delay.h"
#include "sim/kernel/engine.h"
#include "sim/kernel/process.h"
#include "sim/kernel/task.h"

namespace verstat::sim {

/// One run of a model. Holds everything that changes: as many simulations as you like can exist side by
/// side, each used by one thread at a time. Time starts at 0 in the unit of your choice.
///
/// What happens within one instant: events are executed in order of (time, priority, sequence of
/// scheduling), the smaller number first. A delay ends with its own priority, a process starts with that
/// given to spawn; everything else (a granted request, a signal, an interruption) wakes its process at
/// priority 0, after what was scheduled for this instant before. What is granted is granted at once, though:
/// nobody can overtake between the grant and the waking.
///
/// Destroying a simulation ends all its processes, at whatever they wait for: nothing leaks.
class Simulation : public detail::Engine {
 public:
  Simulation() = default;
  ~Simulation() { detail::ProcessState::end_all(*this); }

  /// Simulated time.
  using detail::Engine::now;

  /// Executes events until none is left. An exception that escapes from a process leaves run() as
  /// ProcessError; the other processes stay as they are and run() may be called again.
  void run();

  /// Executes all events up to and including `time`, then sets the clock to `time` (>= now, finite).
  void run_until(double time);

  /// Executes one event; false when none is left.
  bool step();

  /// Time of the next event; infinity when none is pending.
  [[nodiscard]] double peek() const noexcept { return list_.next_time(now_); }

  /// Starts `task` as a process of its own at the present time (its first step is an event of that
  /// `priority`). Pass everything a coroutine needs as parameters: captures of a lambda die before it runs.
  Process spawn(std::string_view name, Task<void> task) { return spawn(name, 0, std::move(task)); }
  Process spawn(std::string_view name, int priority, Task<void> task);

  /// The same for a process that returns a value.
  template <class T>
  ProcessOf<T> spawn(std::string_view name, Task<T> task) {
    return spawn(name, 0, std::move(task));
  }
  template <class T>
  ProcessOf<T> spawn(std::string_view name, int priority, Task<T> task) {
    auto slot = detail::ResultRef<T>::make();
    Process process = spawn(name, priority, keep_result(std::move(task), slot));
    return ProcessOf<T>(std::move(process), std::move(slot));
  }

  /// `co_await sim.delay(dt)` goes on `dt` >= 0 time units later (infinity: never), among the events of that
  /// instant in order of `priority` (-32768 to 32767, smaller first). Negative or NaN: SimulationError.
  [[nodiscard]] detail::Delay delay(double dt, int priority = 0) {
    return detail::Delay(*this, dt, priority);
  }

  /// From now on run() and run_until() end with BudgetError before an event above `events`, and when
  /// `at_one_instant` events or more have passed without the clock moving on (found out within twice that
  /// number). Both >= 1. Where the error comes does not depend on the speed of the machine.
  void set_budget(std::uint64_t events, std::uint64_t at_one_instant);

  /// Number of events executed so far.
  [[nodiscard]] std::uint64_t events_executed() const noexcept { return executed_; }
  /// A hash of the times of all events executed so far, bit for bit and in their order. Two runs that took
  /// different courses differ in it, with a chance of 2^-64 that they do not.
  [[nodiscard]] std::uint64_t course() const noexcept { return times_; }
  /// True when no event is pending.
  [[nodiscard]] bool empty() const noexcept { return list_.empty(); }
  /// Number of events pending.
  [[nodiscard]] std::size_t events_pending() const noexcept { return list_.size(); }
  /// Name of the process that is executing; empty outside processes.
  [[nodiscard]] std::string_view current_process() const noexcept;

  /// Calls `hook` before every event; an empty function switches tracing off. The order of events is the
  /// same with and without.
  void set_trace(std::function<void(const TraceRecord&)> hook);

 private:
  void check_budget();

  std::uint64_t budget_ = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t at_one_instant_ = std::numeric_limits<std::uint64_t>::max();
  double checkpoint_time_ = -1.0;

  template <class T>
  static Task<void> keep_result(Task<T> task, detail::ResultRef<T> slot) {
    T value = co_await std::move(task);
    slot.value().emplace(std::move(value));
  }
};

}  // namespace verstat::sim
