#pragma once
// Process: the handle of a running process. To wait for its end, co_await it.

#include <concepts>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "sim/kernel/process_state.h"

namespace verstat::sim {

namespace detail {

/// Counts one reference to the record of a process.
class ProcessRef {
 public:
  ProcessRef() = default;
  explicit ProcessRef(ProcessState* state) noexcept : state_(state) {
    if (state_ != nullptr) state_->add_reference();
  }
  ProcessRef(const ProcessRef& other) noexcept : ProcessRef(other.state_) {}
  ProcessRef(ProcessRef&& other) noexcept : state_(std::exchange(other.state_, nullptr)) {}
  ProcessRef& operator=(ProcessRef other) noexcept {
    std::swap(state_, other.state_);
    return *this;
  }
  ~ProcessRef() {
    if (state_ != nullptr) state_->drop_reference();
  }
  [[nodiscard]] ProcessState* get() const noexcept { return state_; }
  ProcessState* operator->() const noexcept { return state_; }

 private:
  ProcessState* state_ = nullptr;
};

/// Waits until a process has ended, whichever way; returns how.
class Join final : public Awaitable<Join, LinkedWaiter> {
 public:
  using value_type = ProcessStatus;
  Join(Engine& engine, ProcessRef process) noexcept : Awaitable(engine), process_(std::move(process)) {}

  [[nodiscard]] bool try_now() const noexcept { return process_->ended(); }
  void begin() noexcept { process_->joiners().push_back(*this); }
  void served() override { notify(); }
  void withdraw() noexcept override {
    cancel_event();
    unlink();
  }
  [[nodiscard]] ProcessStatus take() const noexcept { return process_->status(); }

 private:
  ProcessRef process_;
};

}  // namespace detail

/// Handle of a process: copyable, valid as long as you keep it, also after the process or the whole
/// simulation has ended. Stays in the thread of its simulation.
class Process {
 public:
  Process() = default;
  explicit Process(detail::ProcessState* state) noexcept : state_(state) {}

  [[nodiscard]] const std::string& name() const noexcept { return state_->name(); }
  [[nodiscard]] ProcessStatus status() const noexcept { return state_->status(); }
  [[nodiscard]] bool ended() const noexcept { return state_->ended(); }
  /// Number of the process in order of spawning, from 1.
  [[nodiscard]] std::uint64_t id() const noexcept { return state_->id(); }
  /// False for a default-constructed handle.
  [[nodiscard]] bool valid() const noexcept { return state_.get() != nullptr; }

  /// Makes the present wait of the process throw Interrupted (or report it, see interruptible()). Its request
  /// is withdrawn at once, the process wakes up within the same instant. A process that has not started yet
  /// is interrupted at its first wait. False when nothing happened: the process has ended, or was already
  /// interrupted and has not woken up yet. A process that interrupts itself is a SimulationError.
  bool interrupt(Reason reason = Reason()) { return state_->interrupt(std::move(reason)); }

  /// Ends the process: its requests are withdrawn, its frames destroyed, so that everything it holds is given
  /// back by destructors. False when it had ended before. A process that cancels itself is a SimulationError.
  bool cancel() { return state_->cancel(); }

  /// `co_await process` waits for its end and returns its status.
  [[nodiscard]] detail::Join join() const { return detail::Join(state_->engine(), state_); }
  [[nodiscard]] detail::Join operator co_await() const { return join(); }

  friend bool operator==(const Process& a, const Process& b) noexcept {
    return a.state_.get() == b.state_.get();
  }

 protected:
  detail::ProcessRef state_;
};

namespace detail {

/// Where the result of a process waits for its readers.
template <class T>
struct ResultSlot {
  explicit ResultSlot(std::size_t users) noexcept : references(users) {}
  std::size_t references;
  std::optional<T> value;
};

template <class T>
class ResultRef {
 public:
  ResultRef() = default;
  explicit ResultRef(ResultSlot<T>* slot) noexcept : slot_(slot) {}
  ResultRef(const ResultRef& other) noexcept : slot_(other.slot_) {
    if (slot_ != nullptr) ++slot_->references;
  }
  ResultRef(ResultRef&& other) noexcept : slot_(std::exchange(other.slot_, nullptr)) {}
  ResultRef& operator=(ResultRef other) noexcept {
    std::swap(slot_, other.slot_);
    return *this;
  }
  ~ResultRef() {
    if (slot_ != nullptr && --slot_->references == 0) delete slot_;
  }
  [[nodiscard]] std::optional<T>& value() const noexcept { return slot_->value; }

  static ResultRef make() { return ResultRef(new ResultSlot<T>(1)); }

 private:
  ResultSlot<T>* slot_ = nullptr;
};

/// Waits for the end of a process that returns a value.
template <class T>
class JoinResult final : public Awaitable<JoinResult<T>, LinkedWaiter> {
 public:
  using value_type = T;
  JoinResult(Engine& engine, ProcessRef process, ResultRef<T> result) noexcept
      : Awaitable<JoinResult<T>, LinkedWaiter>(engine),
        process_(std::move(process)),
        result_(std::move(result)) {}

  [[nodiscard]] bool try_now() const noexcept { return process_->ended(); }
  void begin() noexcept { process_->joiners().push_back(*this); }
  void served() override { this->notify(); }
  void withdraw() noexcept override {
    this->cancel_event();
    this->unlink();
  }
  T take() const {
    if (!result_.value()) {
      throw SimulationError("process " + process_->name() +
                            " ended without its result: it was cancelled or it failed");
    }
    return *result_.value();
  }

 private:
  ProcessRef process_;
  ResultRef<T> result_;
};

}  // namespace detail

/// Handle of a process that returns a T; `co_await process` gives a copy of it.
template <class T>
class ProcessOf : public Process {
 public:
  ProcessOf() = default;
  ProcessOf(Process process, detail::ResultRef<T> result) noexcept
      : Process(std::move(process)), result_(std::move(result)) {}

  [[nodiscard]] detail::JoinResult<T> join() const {
    return detail::JoinResult<T>(state_->engine(), state_, result_);
  }
  [[nodiscard]] detail::JoinResult<T> operator co_await() const { return join(); }
  /// The result when the process has returned, else empty.
  [[nodiscard]] const std::optional<T>& result() const noexcept { return result_.value(); }

 private:
  detail::ResultRef<T> result_;
};

}  // namespace verstat::sim
