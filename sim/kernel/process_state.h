#pragma once
// The record of a process: shared by the kernel and the handles that users hold.

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "sim/kernel/waiter.h"

namespace verstat::sim {

/// Where a process is in its life.
enum class ProcessStatus {
  waiting_to_start,  ///< spawned; its start event is pending
  running,           ///< started and not ended (suspended or executing)
  done,              ///< its coroutine returned
  failed,            ///< an exception escaped from it
  cancelled          ///< ended from outside
};

namespace detail {

/// Lives from spawn until the process has ended and the last handle is gone; then it is kept for reuse, name
/// buffer included, so that spawning allocates nothing in the steady state. Its references are counted
/// without locks: handles stay in the thread that runs the simulation.
class ProcessState final : public EventNode {
 public:
  /// Makes a process of the coroutine `root` and schedules its start at the present time.
  static ProcessState* spawn(Engine& engine, std::string_view name, int priority, PromiseBase* root);

  [[nodiscard]] Engine& engine() const noexcept { return *engine_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] ProcessStatus status() const noexcept { return status_; }
  [[nodiscard]] bool ended() const noexcept {
    return status_ != ProcessStatus::waiting_to_start && status_ != ProcessStatus::running;
  }
  [[nodiscard]] std::uint64_t id() const noexcept { return id_; }
  [[nodiscard]] const std::exception_ptr& error() const noexcept { return error_; }
  [[nodiscard]] WaitList& joiners() noexcept { return joiners_; }

  void set_leaf(PromiseBase* leaf) noexcept { leaf_ = leaf; }
  /// Runs a branch of a wait of `owner`, to whom its exceptions go instead of run().
  void become_part_of(ProcessState& owner) noexcept { owner_ = &owner; }
  /// The owner has lost interest: cancels as soon as the process is not the one executing.
  void abandon() noexcept;

  bool interrupt(Reason reason);
  bool cancel();
  [[nodiscard]] Reason take_reason() noexcept { return std::move(reason_); }

  void fire() override;
  [[nodiscard]] std::string_view process_name() const noexcept override { return name_; }

  void add_reference() noexcept { ++references_; }
  void drop_reference() noexcept;

  /// The process reached its end; destroys the frame and wakes the joiners. Returns the error that must
  /// leave run(), null when there is none.
  std::exception_ptr finish();
  /// Ends all processes of an engine that is being destroyed.
  static void end_all(Engine& engine) noexcept;

 private:
  ProcessState() = default;
  ~ProcessState() = default;
  [[nodiscard]] ProcessState* executing_process() const noexcept;
  void end(ProcessStatus status) noexcept;
  void link(ProcessState*& head) noexcept;
  void unlink(ProcessState*& head) noexcept;

  Engine* engine_ = nullptr;
  PromiseBase* leaf_ = nullptr;  // innermost coroutine of the process
  PromiseBase* root_ = nullptr;  // outermost coroutine; null when the process has ended
  ProcessStatus status_ = ProcessStatus::waiting_to_start;
  bool abandoned_ = false;
  ProcessState* owner_ = nullptr;
  bool interrupt_at_first_wait_ = false;
  std::uint32_t references_ = 0;
  EventId event_ = 0;  // the start, or an interruption that waits for the first wait
  std::uint64_t id_ = 0;
  std::string name_;
  Reason reason_;
  WaitList joiners_;
  std::exception_ptr error_;
  ProcessState* prev_ = nullptr;
  ProcessState* next_ = nullptr;
};

}  // namespace detail
}  // namespace verstat::sim
