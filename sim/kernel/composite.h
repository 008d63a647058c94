#pragma once
// Waiting for several things: first_of, all_of, interruptible.

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

#include "sim/kernel/process.h"
#include "sim/kernel/simulation.h"
#include "sim/kernel/waiter.h"

namespace verstat::sim {

namespace detail {

template <class T>
using NonVoid = std::conditional_t<std::is_void_v<T>, std::monostate, T>;

template <class W>
NonVoid<typename W::value_type> take_from(W& waiter) {
  if constexpr (std::is_void_v<typename W::value_type>) {
    waiter.take();
    return std::monostate{};
  } else {
    return waiter.take();
  }
}

/// A called task as a branch: it runs as a process of its own, which is cancelled when the branch loses.
template <class T>
class TaskBranch final : public Awaitable<TaskBranch<T>, LinkedWaiter> {
 public:
  using value_type = T;
  explicit TaskBranch(Task<T> task)
      : Awaitable<TaskBranch<T>, LinkedWaiter>(no_engine_yet), task_(std::move(task)) {}
  TaskBranch(TaskBranch&&) noexcept = default;
  TaskBranch& operator=(TaskBranch&&) noexcept = default;

  [[nodiscard]] bool try_now() const noexcept { return false; }
  void begin() {
    result_ = ResultRef<NonVoid<T>>::make();
    ProcessState& caller = *this->engine_->current()->process;
    PromiseBase* root = run(std::move(task_), result_).release();
    state_ = ProcessRef(ProcessState::spawn(*this->engine_, caller.name(), 0, root));
    state_->become_part_of(caller);
    state_->joiners().push_back(*this);
  }
  void served() override { this->notify(); }
  void withdraw() noexcept override {
    this->cancel_event();
    this->unlink();
    if (state_.get() != nullptr) state_->abandon();
  }
  T take() {
    if (state_->error()) std::rethrow_exception(state_->error());
    if constexpr (!std::is_void_v<T>) return std::move(*result_.value());
  }

 private:
  static Task<void> run(Task<T> task, ResultRef<NonVoid<T>> result) {
    if constexpr (std::is_void_v<T>) {
      co_await std::move(task);
    } else {
      T value = co_await std::move(task);
      result.value().emplace(std::move(value));
    }
  }

  Task<T> task_;
  ProcessRef state_;
  ResultRef<NonVoid<T>> result_;
};

// What may stand in first_of(...): a wait, a process (its end), a task, or anything with wait().
template <class W>
requires std::is_base_of_v<Waiter, W> W as_waiter(W&& waiter) {
  return std::move(waiter);  // NOLINT: W is no reference, or Waiter would be no base of it
}
inline Join as_waiter(const Process& process) {
  return process.join();
}
template <class T>
JoinResult<T> as_waiter(const ProcessOf<T>& process) {
  return process.join();
}
template <class T>
TaskBranch<T> as_waiter(Task<T>&& task) {
  return TaskBranch<T>(std::move(task));
}
template <class S>
requires requires(S& source) {
  source.wait();
}
auto as_waiter(S& source) {
  return source.wait();
}

}  // namespace detail

/// What first_of() answers: which branch came, and its value.
template <class... Ts>
class FirstResult {
 public:
  template <std::size_t I, class V>
  FirstResult(std::in_place_index_t<I> index, V&& value) : value_(index, std::forward<V>(value)) {}

  /// Number of the branch that came, from 0.
  [[nodiscard]] std::size_t index() const noexcept { return value_.index(); }
  /// Value of branch I, which must be the one that came (else std::bad_variant_access).
  template <std::size_t I>
  [[nodiscard]] auto& get() {
    return std::get<I>(value_);
  }

 private:
  std::variant<detail::NonVoid<Ts>...> value_;
};

/// What interruptible() answers.
template <class T>
class Attempt {
 public:
  explicit Attempt(detail::NonVoid<T> value) : value_(std::move(value)) {}
  explicit Attempt(Reason reason) : reason_(std::move(reason)) {}

  [[nodiscard]] bool interrupted() const noexcept { return !value_.has_value(); }
  [[nodiscard]] const Reason& reason() const noexcept { return reason_; }
  /// The value waited for; only when not interrupted (else std::bad_optional_access).
  [[nodiscard]] detail::NonVoid<T>& value() { return value_.value(); }

 private:
  std::optional<detail::NonVoid<T>> value_;
  Reason reason_;
};

namespace detail {

template <class... Ws>
class FirstOf final : public Awaitable<FirstOf<Ws...>, Composite> {
 public:
  using value_type = FirstResult<typename Ws::value_type...>;
  explicit FirstOf(Ws... branches)
      : Awaitable<FirstOf<Ws...>, Composite>(no_engine_yet), branches_(std::move(branches)...) {}

  bool try_now() {
    return for_each([this](auto& branch, std::size_t index) {
      if (branch.try_now()) came_ = index;
      return came_ != none;
    });
  }
  void begin() {
    began_ = true;
    for_each([this](auto& branch, std::size_t index) {
      branch.attach(*this, index);
      branch.begin();
      return false;
    });
  }
  void branch_came(std::size_t index, bool at_once) override {
    came_ = index;
    began_ = false;
    for_each([index](auto& branch, std::size_t i) {
      if (i != index) branch.withdraw();
      return false;
    });
    at_once ? this->notify_at_once() : this->notify();
  }
  void withdraw() noexcept override {
    this->cancel_event();
    for_each([this](auto& branch, std::size_t index) {
      if (began_ || index == came_) branch.withdraw();
      return false;
    });
    began_ = false;
    came_ = none;
  }
  value_type take() { return take_from_branch<0>(); }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  // Calls `visit(branch, index)` in order until one call returns true.
  template <class Visit>
  bool for_each(Visit visit) {
    return std::apply(
        [&visit](Ws&... branch) {
          std::size_t index = 0;
          return (visit(branch, index++) || ...);
        },
        branches_);
  }
  template <std::size_t I>
  value_type take_from_branch() {
    if constexpr (I + 1 < sizeof...(Ws)) {
      if (came_ != I) return take_from_branch<I + 1>();
    }
    return value_type(std::in_place_index<I>, take_from(std::get<I>(branches_)));
  }

  std::tuple<Ws...> branches_;
  std::size_t came_ = none;
  bool began_ = false;
};

template <class... Ws>
class AllOf final : public Awaitable<AllOf<Ws...>, Composite> {
 public:
  using value_type = std::tuple<NonVoid<typename Ws::value_type>...>;
  explicit AllOf(Ws... branches)
      : Awaitable<AllOf<Ws...>, Composite>(no_engine_yet), branches_(std::move(branches)...) {}

  bool try_now() {
    missing_ = 0;
    for_each([this](auto& branch, std::size_t index) {
      came_[index] = branch.try_now();
      if (!came_[index]) ++missing_;
    });
    return missing_ == 0;
  }
  void begin() {
    for_each([this](auto& branch, std::size_t index) {
      if (came_[index]) return;
      branch.attach(*this, index);
      branch.begin();
    });
  }
  void branch_came(std::size_t index, bool at_once) override {
    came_[index] = true;
    if (--missing_ == 0) at_once ? this->notify_at_once() : this->notify();
  }
  void withdraw() noexcept override {
    this->cancel_event();
    for_each([](auto& branch, std::size_t) { branch.withdraw(); });
  }
  value_type take() {
    return std::apply([](Ws&... branch) { return value_type{take_from(branch)...}; }, branches_);
  }

 private:
  template <class Visit>
  void for_each(Visit visit) {
    std::apply(
        [&visit](Ws&... branch) {
          std::size_t index = 0;
          (visit(branch, index++), ...);
        },
        branches_);
  }

  std::tuple<Ws...> branches_;
  std::array<bool, sizeof...(Ws)> came_{};
  std::size_t missing_ = 0;
};

template <class W>
class Interruptible final : public Awaitable<Interruptible<W>, Composite> {
 public:
  using value_type = Attempt<typename W::value_type>;
  explicit Interruptible(W wait)
      : Awaitable<Interruptible<W>, Composite>(no_engine_yet), wait_(std::move(wait)) {}

  [[nodiscard]] bool await_ready() { return wait_.await_ready(); }
  bool try_now() { return wait_.try_now(); }
  void begin() {
    wait_.attach(*this, 0);
    wait_.begin();
  }
  void branch_came(std::size_t, bool at_once) override { at_once ? this->notify_at_once() : this->notify(); }
  void withdraw() noexcept override {
    this->cancel_event();
    wait_.withdraw();
  }
  value_type await_resume() {
    if (this->promise_ != nullptr) {
      this->promise_->waiter = nullptr;
      if (this->interrupted_) return value_type(this->promise_->process->take_reason());
    }
    return take();
  }
  value_type take() { return value_type(take_from(wait_)); }

 private:
  W wait_;
};

}  // namespace detail

/// `auto came = co_await first_of(a, b, ...)` goes on when the first of them comes; came.index() says which,
/// came.get<I>() has its value. All others are withdrawn at that moment: requests leave their queues, delays
/// their events, tasks are cancelled, processes just no longer waited for. What is ready at once wins in the
/// order written. Branches: delays, requests, events, signals, processes, tasks, other first_of / all_of.
/// A branch that is a task runs as a process of its own under the name of its caller; its exceptions come
/// out of this wait.
template <class... Bs>
[[nodiscard]] auto first_of(Bs&&... branches) {
  static_assert(sizeof...(Bs) > 0);
  return detail::FirstOf<decltype(detail::as_waiter(std::forward<Bs>(branches)))...>(
      detail::as_waiter(std::forward<Bs>(branches))...);
}

/// `auto [x, y] = co_await all_of(a, b)` goes on when all have come (std::monostate where there is no value).
template <class... Bs>
[[nodiscard]] auto all_of(Bs&&... branches) {
  static_assert(sizeof...(Bs) > 0);
  return detail::AllOf<decltype(detail::as_waiter(std::forward<Bs>(branches)))...>(
      detail::as_waiter(std::forward<Bs>(branches))...);
}

/// `auto attempt = co_await interruptible(wait)`: an interruption is an answer here and no exception, at a
/// hundredth of the cost.
template <class B>
[[nodiscard]] auto interruptible(B&& wait) {
  return detail::Interruptible<decltype(detail::as_waiter(std::forward<B>(wait)))>(
      detail::as_waiter(std::forward<B>(wait)));
}

}  // namespace verstat::sim
