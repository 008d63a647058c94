#pragma once
// Task<T>: a coroutine that is a step of a process, or a whole one.

#include <coroutine>
#include <cstddef>
#include <exception>
#include <optional>
#include <type_traits>
#include <utility>

#include "sim/kernel/frame_pool.h"
#include "sim/kernel/process_state.h"

namespace verstat::sim {

template <class T = void>
class Task;

namespace detail {

/// What promises of all result types share. The event loop resumes everything: g++ 12 makes no tail call of
/// symmetric transfer, so a chain of immediate returns would otherwise grow the stack.
struct TaskPromise : PromiseBase {
  struct Final {
    [[nodiscard]] bool await_ready() const noexcept { return false; }
    template <class Promise>
    void await_suspend(std::coroutine_handle<Promise> handle) const noexcept {
      PromiseBase& promise = handle.promise();
      Engine& engine = promise.process->engine();
      if (promise.parent == nullptr) {
        engine.finished(promise.process);
      } else {
        promise.process->set_leaf(promise.parent);
        engine.follow(promise.parent);
      }
    }
    void await_resume() const noexcept {}
  };

  [[nodiscard]] std::suspend_always initial_suspend() const noexcept { return {}; }
  [[nodiscard]] Final final_suspend() const noexcept { return {}; }
  void unhandled_exception() noexcept { error = std::current_exception(); }

  static void* operator new(std::size_t bytes) { return FramePool::allocate(bytes); }
  static void operator delete(void* frame, std::size_t bytes) noexcept { FramePool::release(frame, bytes); }
};

template <class T>
struct Promise final : TaskPromise {
  std::optional<T> value;
  Task<T> get_return_object();
  template <class U>
  void return_value(U&& result) {
    value.emplace(std::forward<U>(result));
  }
  T take() {
    if (error) std::rethrow_exception(error);
    return std::move(*value);
  }
};

template <>
struct Promise<void> final : TaskPromise {
  Task<void> get_return_object();
  void return_void() const noexcept {}
  void take() const {
    if (error) std::rethrow_exception(error);
  }
};

}  // namespace detail

/// A coroutine that may wait. Nothing happens until it is awaited by another task, which then goes on with
/// its result, or handed to Simulation::spawn. Movable, awaited once; a task never started is just dropped.
template <class T>
class [[nodiscard]] Task {
 public:
  using promise_type = detail::Promise<T>;
  using value_type = T;

  Task(Task&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Task& operator=(Task&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Task() {
    if (handle_) handle_.destroy();
  }

  [[nodiscard]] bool await_ready() const noexcept { return false; }
  template <class Promise>
  void await_suspend(std::coroutine_handle<Promise> caller) noexcept {
    static_assert(std::is_base_of_v<detail::PromiseBase, Promise>, "only a Task can await a Task");
    detail::PromiseBase& parent = caller.promise();
    detail::PromiseBase& child = handle_.promise();
    child.process = parent.process;
    child.parent = &parent;
    child.process->set_leaf(&child);
    child.process->engine().follow(&child);
  }
  T await_resume() { return handle_.promise().take(); }

  /// The root promise, for the kernel: gives up ownership.
  [[nodiscard]] detail::PromiseBase* release() noexcept { return &std::exchange(handle_, nullptr).promise(); }
  [[nodiscard]] bool valid() const noexcept { return handle_ != nullptr; }

 private:
  friend promise_type;
  explicit Task(std::coroutine_handle<promise_type> handle) noexcept : handle_(handle) {}

  std::coroutine_handle<promise_type> handle_;
};

namespace detail {

template <class T>
Task<T> Promise<T>::get_return_object() {
  const auto handle = std::coroutine_handle<Promise>::from_promise(*this);
  self = handle;
  return Task<T>(handle);
}

inline Task<void> Promise<void>::get_return_object() {
  const auto handle = std::coroutine_handle<Promise>::from_promise(*this);
  self = handle;
  return Task<void>(handle);
}

}  // namespace detail
}  // namespace verstat::sim
