#pragma once
// Letting simulated time pass.

#include <limits>

#include "sim/kernel/waiter.h"

namespace verstat::sim::detail {

class Delay final : public Awaitable<Delay> {
 public:
  using value_type = void;

  Delay(Engine& engine, double dt, int priority) : Awaitable(engine), time_(engine.now() + dt) {
    if (!(dt >= 0.0)) [[unlikely]] {
      throw_bad_delay(engine, dt);
    }
    if (priority < lowest_priority || priority > highest_priority) [[unlikely]] {
      throw_bad_priority(engine, priority);
    }
    priority_ = priority;
  }

  // Directly behind co_await the clock may jump. Inside a composite the other branches decide, too: there
  // time never passes without the event list.
  [[nodiscard]] bool await_ready() noexcept {
    if (!engine_->may_jump(time_)) return false;
    engine_->jump(time_);
    return true;
  }
  template <class Promise>
  void await_suspend(std::coroutine_handle<Promise> handle) {
    attach(handle.promise());
    // An infinite delay waits for ever (or until it loses against another branch).
    if (time_ < never) event_ = engine_->push(time_, priority_, promise_);
  }
  [[nodiscard]] bool try_now() const noexcept { return false; }
  void begin() {
    if (time_ < never) event_ = engine_->push(time_, priority_, static_cast<EventNode*>(this));
  }
  void withdraw() noexcept override { cancel_event(); }
  void take() const noexcept {}

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();
  double time_;
  int priority_ = 0;
};

}  // namespace verstat::sim::detail
