#include "sim/kernel/simulation.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>

namespace verstat::sim {

namespace {

/// Allows delays to jump up to a time, for as long as the run lasts.
class JumpPermit {
 public:
  JumpPermit(double& limit, double time) : limit_(limit), previous_(limit) { limit_ = time; }
  ~JumpPermit() { limit_ = previous_; }
  JumpPermit(const JumpPermit&) = delete;
  JumpPermit& operator=(const JumpPermit&) = delete;

 private:
  double& limit_;
  double previous_;
};

constexpr double no_jump = -1.0;

}  // namespace

void Simulation::run() {
  if (current_ != nullptr) throw SimulationError(where() + "run() called from inside a process");
  const JumpPermit permit(jump_limit_, trace_ ? no_jump : std::numeric_limits<double>::max());
  while (!list_.empty()) {
    if (executed_ >= checkpoint_) [[unlikely]] {
      check_budget();
    }
    dispatch(list_.pop(now_));
  }
}

void Simulation::run_until(double time) {
  if (current_ != nullptr) throw SimulationError(where() + "run_until() called from inside a process");
  if (!(time >= now_) || std::isinf(time)) {
    throw SimulationError(where() + "run_until(" + detail::text_of(time) + "), must be finite and >= now");
  }
  const JumpPermit permit(jump_limit_, trace_ ? no_jump : time);
  while (!list_.empty() && list_.next_time(now_) <= time) {
    if (executed_ >= checkpoint_) [[unlikely]] {
      check_budget();
    }
    dispatch(list_.pop(now_));
  }
  now_ = time;
}

bool Simulation::step() {
  if (current_ != nullptr) throw SimulationError(where() + "step() called from inside a process");
  if (list_.empty()) return false;
  dispatch(list_.pop(now_));
  return true;
}

void Simulation::set_budget(std::uint64_t events, std::uint64_t at_one_instant) {
  if (events == 0 || at_one_instant == 0) throw SimulationError("set_budget: both budgets must be >= 1");
  budget_ = events;
  at_one_instant_ = at_one_instant;
  checkpoint_time_ = -1.0;
  checkpoint_ = executed_;
}

// Jumps stop at a checkpoint, too: a process that never suspends otherwise comes back to the event list.
void Simulation::check_budget() {
  if (executed_ >= budget_) throw BudgetError(where() + "more than " + std::to_string(budget_) + " events");
  if (now_ == checkpoint_time_)
    throw BudgetError(where() + "the clock stands still: " + std::to_string(at_one_instant_) +
                      " events at one instant");
  checkpoint_time_ = now_;
  const std::uint64_t left = budget_ - executed_;
  checkpoint_ = executed_ + std::min(left, at_one_instant_);
}

Process Simulation::spawn(std::string_view name, int priority, Task<void> task) {
  if (!task.valid()) throw SimulationError(where() + "spawn(\"" + std::string(name) + "\") of an empty task");
  if (priority < detail::lowest_priority || priority > detail::highest_priority) {
    detail::throw_bad_priority(*this, priority);
  }
  if (closing_)
    throw SimulationError("spawn(\"" + std::string(name) + "\") while the simulation is destroyed");
  return Process(detail::ProcessState::spawn(*this, name, priority, task.release()));
}

std::string_view Simulation::current_process() const noexcept {
  return current_ == nullptr ? std::string_view() : std::string_view(current_->process->name());
}

void Simulation::set_trace(std::function<void(const TraceRecord&)> hook) {
  trace_ = std::move(hook);
  if (trace_) jump_limit_ = no_jump;
}

namespace detail {

void Engine::record(const Entry& entry) const {
  TraceRecord record{};
  record.time = entry.time;
  record.priority = static_cast<int>(entry.id >> 48U) + lowest_priority;
  record.sequence = entry.id & ((EventId{1} << 48U) - 1);
  if ((entry.payload & node_tag) == 0) {
    record.process = reinterpret_cast<PromiseBase*>(entry.payload)->process->name();
  } else {
    record.process = reinterpret_cast<EventNode*>(entry.payload & ~node_tag)->process_name();
  }
  trace_(record);
}

void Engine::reap() {
  ProcessState* process = std::exchange(finished_, nullptr);
  const std::string name = process->name();
  const std::exception_ptr error = process->finish();
  if (!error) return;
  const std::string at = "t = " + text_of(now_) + ", process " + name + ": ";
  try {
    std::rethrow_exception(error);
  } catch (const std::exception& original) {
    // Errors of the kernel already say where.
    const std::string what = original.what();
    throw ProcessError(what.starts_with(at) ? what : at + what, name, now_);
  } catch (...) {
    throw ProcessError(at + "an exception that is no std::exception", name, now_);
  }
}

std::string Engine::where() const {
  std::string text = "t = " + text_of(now_) + ", ";
  if (current_ != nullptr) text += "process " + current_->process->name() + ": ";
  return text;
}

std::string text_of(double value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return std::string(buffer.data(), result.ptr);
}

void throw_bad_delay(const Engine& engine, double dt) {
  throw SimulationError(engine.where() + "delay is " + text_of(dt) + ", must be >= 0");
}

void throw_bad_priority(const Engine& engine, int priority) {
  throw SimulationError(engine.where() + "priority is " + std::to_string(priority) +
                        ", must be from -32768 to 32767");
}

}  // namespace detail
}  // namespace verstat::sim
