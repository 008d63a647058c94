#pragma once
// Things to wait for that others announce: a one-shot event, a signal, a gate.

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include "sim/kernel/simulation.h"
#include "sim/kernel/waiter.h"

namespace verstat::sim {

template <class T>
class Event;

namespace detail {

/// Waits in a list until served. `Source` says whether there is nothing to wait for.
template <class Source>
class ListWait final : public Awaitable<ListWait<Source>, LinkedWaiter> {
 public:
  using value_type = typename Source::value_type;
  ListWait(Engine& engine, Source& source) noexcept
      : Awaitable<ListWait<Source>, LinkedWaiter>(engine), source_(&source) {}

  [[nodiscard]] bool try_now() {
    if (!source_->passable()) return false;
    keep_value();
    return true;
  }
  void begin() noexcept { source_->waiters().push_back(*this); }
  void served() override {
    keep_value();
    this->notify();
  }
  void withdraw() noexcept override {
    this->cancel_event();
    this->unlink();
  }
  value_type take() {
    if constexpr (!std::is_void_v<value_type>) return std::move(*value_);
  }

 private:
  // The source may be gone when the process wakes up.
  void keep_value() {
    if constexpr (!std::is_void_v<value_type>) value_.emplace(source_->value());
  }

  struct Nothing {};
  Source* source_;
  std::optional<std::conditional_t<std::is_void_v<value_type>, Nothing, value_type>> value_;
};

/// Waits until a predicate holds; it holds when the process goes on.
template <class Predicate>
class PredicateWait final : public Awaitable<PredicateWait<Predicate>, LinkedWaiter> {
 public:
  using value_type = void;
  PredicateWait(Engine& engine, WaitList& waiters, WaitList& rising, Predicate predicate)
      : Awaitable<PredicateWait<Predicate>, LinkedWaiter>(engine),
        waiters_(&waiters),
        rising_(&rising),
        predicate_(std::move(predicate)) {}

  [[nodiscard]] bool try_now() { return predicate_(); }
  void begin() noexcept { waiters_->push_back(*this); }
  // Looks at the moment of the announcement, and again when its turn has come: an earlier riser may have
  // changed the state in between.
  void served() override {
    if (predicate_()) {
      rising_->push_back(*this);
      this->event_ = this->engine_->push_now(static_cast<EventNode*>(this));
    } else {
      waiters_->push_back(*this);
    }
  }
  void fire() override {
    this->event_ = 0;
    if (!this->linked()) return;  // the signal is gone
    this->unlink();
    if (predicate_()) {
      this->notify_at_once();
    } else {
      waiters_->push_back(*this);
    }
  }
  void withdraw() noexcept override {
    this->cancel_event();
    this->unlink();
  }
  void take() const noexcept {}

 private:
  WaitList* waiters_;
  WaitList* rising_;
  Predicate predicate_;
};

/// Serves everybody who waits now; those who queue up again meanwhile are left for the next time.
inline void serve_all(WaitList& waiters) {
  for (std::size_t left = waiters.size(); left != 0 && !waiters.empty(); --left) waiters.pop_front().served();
}

}  // namespace detail

/// Something that happens at most once, with a value for everyone who waits for it, before or after.
template <class T = void>
class Event {
 public:
  using value_type = T;
  using Wait = detail::ListWait<Event>;

  explicit Event(Simulation& sim) noexcept : sim_(&sim) {}

  /// Announces that it has happened. A second time is a SimulationError.
  template <class U = T>
  requires(!std::is_void_v<U>) void succeed(U value) {
    check_first();
    value_.emplace(std::move(value));
    detail::serve_all(waiters_);
  }
  void succeed() requires(std::is_void_v<T>) {
    check_first();
    value_.emplace();
    detail::serve_all(waiters_);
  }

  [[nodiscard]] bool happened() const noexcept { return value_.has_value(); }
  /// The value; only after it happened (else std::bad_optional_access).
  [[nodiscard]] const auto& value() const { return value_.value(); }
  /// Makes it wait to happen again, for everyone who comes from now on.
  void reset() noexcept { value_.reset(); }

  /// `co_await event` or `co_await event.wait()`: returns (a copy of) the value, at once if it happened.
  [[nodiscard]] Wait wait() noexcept { return Wait(*sim_, *this); }
  [[nodiscard]] Wait operator co_await() noexcept { return wait(); }

  /// For the kernel.
  [[nodiscard]] bool passable() const noexcept { return happened(); }
  [[nodiscard]] detail::WaitList& waiters() noexcept { return waiters_; }

 private:
  struct Nothing {};
  void check_first() const {
    if (happened()) throw SimulationError(sim_->where() + "an event succeeds a second time without reset()");
  }

  Simulation* sim_;
  std::optional<std::conditional_t<std::is_void_v<T>, Nothing, T>> value_;
  detail::WaitList waiters_;
};

/// A condition that may change again and again: notify() wakes whoever waits at that moment.
class Signal {
 public:
  using value_type = void;
  using Wait = detail::ListWait<Signal>;

  explicit Signal(Simulation& sim) noexcept : sim_(&sim) {}

  /// Wakes all plain waiters, and those whose predicate holds.
  void notify() { detail::serve_all(waiters_); }

  /// `co_await signal.wait()` goes on at the next notify().
  [[nodiscard]] Wait wait() noexcept { return Wait(*sim_, *this); }
  [[nodiscard]] Wait operator co_await() noexcept { return wait(); }

  /// `co_await signal.wait_until([&] { return level < 3; })` goes on at once if the predicate holds, else
  /// after the first notify() at which it does. It holds when the process goes on, whatever others did in
  /// between. Capture by reference only (g++ 12 destroys other captures twice).
  template <class Predicate>
  [[nodiscard]] detail::PredicateWait<Predicate> wait_until(Predicate predicate) {
    static_assert(std::is_trivially_destructible_v<Predicate>, "capture by reference");
    return detail::PredicateWait<Predicate>(*sim_, waiters_, rising_, std::move(predicate));
  }
  [[nodiscard]] std::size_t waiting() const noexcept { return waiters_.size(); }

  /// For the kernel.
  [[nodiscard]] bool passable() const noexcept { return false; }
  [[nodiscard]] detail::WaitList& waiters() noexcept { return waiters_; }

 private:
  Simulation* sim_;
  detail::WaitList waiters_;
  detail::WaitList rising_;  // whose predicate held, on their way to look again
};

/// A gate lets pass while it is open.
class Gate {
 public:
  using value_type = void;
  using Wait = detail::ListWait<Gate>;

  explicit Gate(Simulation& sim, bool open = false) noexcept : sim_(&sim), open_(open) {}

  /// Opens: everybody who waits passes, even if it closes again within the instant.
  void open() {
    open_ = true;
    detail::serve_all(waiters_);
  }
  void close() noexcept { open_ = false; }
  [[nodiscard]] bool is_open() const noexcept { return open_; }
  [[nodiscard]] std::size_t waiting() const noexcept { return waiters_.size(); }

  /// `co_await gate.wait()`: goes on at once while the gate is open.
  [[nodiscard]] Wait wait() noexcept { return Wait(*sim_, *this); }
  [[nodiscard]] Wait operator co_await() noexcept { return wait(); }

  /// For the kernel.
  [[nodiscard]] bool passable() const noexcept { return open_; }
  [[nodiscard]] detail::WaitList& waiters() noexcept { return waiters_; }

 private:
  Simulation* sim_;
  bool open_;
  detail::WaitList waiters_;
};

}  // namespace verstat::sim
