#pragma once
// A wait in progress: what a suspended process hangs on, and how it can be called off.

#include <coroutine>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "sim/kernel/engine.h"

namespace verstat::sim::detail {

class Composite;

struct NoEngineYet {};
inline constexpr NoEngineYet no_engine_yet{};

/// Base of everything that can stand behind `co_await` or inside first_of / all_of.
///
/// Life of a wait: try_now() asks whether it is fulfilled already; if not, begin() registers it; its source
/// calls notify() once; take() hands over the value. At any moment after begin() it may be withdrawn, also
/// when its source has served it but the process has not woken up yet: then what was granted is given back.
class Waiter : public EventNode {
 public:
  /// Stops waiting and gives back what was granted. Ends in the state before begin().
  virtual void withdraw() noexcept = 0;

  /// The event loop calls this for waits that are branches of a composite, or that check again.
  void fire() override;

  /// True when an interruption was delivered to this wait.
  [[nodiscard]] bool interrupted() const noexcept { return interrupted_; }

  /// This wait is branch `index` of `parent`.
  void attach(Composite& parent, std::size_t index) noexcept;
  /// This wait stands directly behind co_await in the coroutine `promise`.
  void attach(PromiseBase& promise) noexcept {
    promise_ = &promise;
    promise.waiter = this;
  }
  [[nodiscard]] bool is_branch() const noexcept { return parent_ != nullptr; }

  /// Withdraws and wakes the process with the news that it was interrupted. Only for direct waits.
  void interrupt() {
    withdraw();
    interrupted_ = true;
    event_ = engine_->push_now(promise_);
  }

 protected:
  explicit Waiter(Engine& engine) noexcept : engine_(&engine) {}
  // A wait made of others learns its engine when it is awaited.
  explicit Waiter(NoEngineYet) noexcept : engine_(nullptr) {}
  // Waits move into composites before they begin; afterwards their address is known to others.
  Waiter(Waiter&&) noexcept = default;
  Waiter& operator=(Waiter&&) noexcept = default;
  ~Waiter() = default;

  /// The source has served this wait: wakes the process, or tells the composite.
  void notify();
  /// The same from within the event loop: the process goes on at once, in the place of this event.
  void notify_at_once();
  void cancel_event() noexcept {
    if (event_ != 0) engine_->cancel(std::exchange(event_, 0));
  }
  /// First thing after waking up.
  void woken() {
    if (promise_ != nullptr) {
      promise_->waiter = nullptr;
      if (interrupted_) [[unlikely]] {
        throw_interrupted();
      }
    }
  }
  [[noreturn]] void throw_interrupted() const;

  Engine* engine_;
  PromiseBase* promise_ = nullptr;
  EventId event_ = 0;  // the event that will wake us, while it is pending
  Composite* parent_ = nullptr;
  std::size_t index_ = 0;
  bool interrupted_ = false;

  friend class Composite;
};

/// A wait made of waits.
class Composite : public Waiter {
 public:
  /// Branch `index` has come. `at_once`: the event loop itself calls, the process may go on directly.
  virtual void branch_came(std::size_t index, bool at_once) = 0;

 protected:
  using Waiter::Waiter;
};

inline void Waiter::attach(Composite& parent, std::size_t index) noexcept {
  parent_ = &parent;
  index_ = index;
  engine_ = static_cast<Waiter&>(parent).engine_;
}

[[nodiscard]] Engine* current_engine(const PromiseBase& promise) noexcept;

/// Gives a waiter its three await functions. `Derived` has try_now(), begin() and take().
template <class Derived, class Base = Waiter>
class Awaitable : public Base {
 public:
  [[nodiscard]] bool await_ready() { return derived().try_now(); }
  template <class Promise>
  void await_suspend(std::coroutine_handle<Promise> handle) {
    static_assert(std::is_base_of_v<PromiseBase, Promise>,
                  "only coroutines that return verstat::sim::Task can wait for kernel objects");
    this->attach(handle.promise());
    if (this->engine_ == nullptr) this->engine_ = current_engine(handle.promise());
    derived().begin();
  }
  decltype(auto) await_resume() {
    this->woken();
    return derived().take();
  }

 protected:
  using Base::Base;

 private:
  Derived& derived() noexcept { return static_cast<Derived&>(*this); }
};

class WaitList;

/// A waiter that stands in a queue.
class LinkedWaiter : public Waiter {
 public:
  [[nodiscard]] bool linked() const noexcept { return list_ != nullptr; }
  /// The source took this waiter out of its queue because what it waited for has happened.
  virtual void served() = 0;

 protected:
  using Waiter::Waiter;
  LinkedWaiter(LinkedWaiter&&) noexcept = default;
  LinkedWaiter& operator=(LinkedWaiter&&) noexcept = default;
  ~LinkedWaiter();

 public:
  /// Leaves the queue, if it stands in one.
  void unlink() noexcept;

 private:
  WaitList* list_ = nullptr;
  LinkedWaiter* prev_ = nullptr;
  LinkedWaiter* next_ = nullptr;

  friend class WaitList;
};

/// A first-in-first-out queue of waiters, which live in the frames of their processes.
class WaitList {
 public:
  WaitList() = default;
  WaitList(WaitList&& other) noexcept { *this = std::move(other); }
  WaitList& operator=(WaitList&& other) noexcept;
  /// Whoever still waits when the source dies will wait for ever, but harmlessly.
  ~WaitList() { clear(); }

  [[nodiscard]] bool empty() const noexcept { return first_ == nullptr; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] LinkedWaiter* front() const noexcept { return first_; }
  [[nodiscard]] static LinkedWaiter* after(const LinkedWaiter& waiter) noexcept { return waiter.next_; }

  void push_back(LinkedWaiter& waiter) noexcept;
  void push_front(LinkedWaiter& waiter) noexcept;
  void remove(LinkedWaiter& waiter) noexcept;
  LinkedWaiter& pop_front() noexcept {
    LinkedWaiter& waiter = *first_;
    remove(waiter);
    return waiter;
  }
  void clear() noexcept {
    while (!empty()) pop_front();
  }

 private:
  LinkedWaiter* first_ = nullptr;
  LinkedWaiter* last_ = nullptr;
  std::size_t size_ = 0;
};

inline LinkedWaiter::~LinkedWaiter() {
  unlink();
}
inline void LinkedWaiter::unlink() noexcept {
  if (list_ != nullptr) list_->remove(*this);
}

}  // namespace verstat::sim::detail
