#pragma once
// Clock, event list and dispatch: the part of a simulation that every wait touches.

#include <bit>
#include <coroutine>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "sim/kernel/errors.h"
#include "sim/kernel/event_list.h"

namespace verstat::sim {

/// One executed event, as a trace hook sees it just before it happens.
struct TraceRecord {
  double time;               ///< simulated time
  int priority;              ///< priority within the instant, smaller first
  std::uint64_t sequence;    ///< order in which events were scheduled
  std::string_view process;  ///< name of the process that goes on; empty when the kernel itself acts
};

namespace detail {

class Waiter;
class ProcessState;

/// Something the event loop calls when its time has come.
class EventNode {
 public:
  virtual void fire() = 0;
  /// The process behind it, for the trace.
  [[nodiscard]] virtual std::string_view process_name() const noexcept { return {}; }

 protected:
  ~EventNode() = default;
};

/// The part of a coroutine promise that the kernel works with.
struct PromiseBase {
  std::coroutine_handle<> self;     // this coroutine
  ProcessState* process = nullptr;  // the process it is part of, once it has started
  Waiter* waiter = nullptr;         // what it is suspended on; null while it, or a task it called, runs
  PromiseBase* parent = nullptr;    // the coroutine that awaits it; null for the root of a process
  std::exception_ptr error;
};

/// Clock and event loop. Not for users: Simulation is the public face.
class Engine {
 public:
  Engine() = default;
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  [[nodiscard]] double now() const noexcept { return now_; }

  EventId push(double time, int priority, PromiseBase* promise) {
    return list_.push(time, priority, reinterpret_cast<std::uintptr_t>(promise));
  }
  EventId push(double time, int priority, EventNode* node) {
    return list_.push(time, priority, reinterpret_cast<std::uintptr_t>(node) | node_tag);
  }
  EventId push_now(PromiseBase* promise) { return list_.push_now(reinterpret_cast<std::uintptr_t>(promise)); }
  EventId push_now(EventNode* node) {
    return list_.push_now(reinterpret_cast<std::uintptr_t>(node) | node_tag);
  }
  /// Takes back a pending event. After the engine began to close nothing will fire any more anyway.
  void cancel(EventId id) noexcept {
    if (!closing_) list_.cancel(id);
  }

  /// A process that delays until `time` may go on at once, without passing through the event list, when
  /// every other pending event is later: the clock jumps. Nothing observable differs.
  [[nodiscard]] bool may_jump(double time) const noexcept {
    return time <= jump_limit_ && executed_ < checkpoint_ && list_.nothing_until(time);
  }
  void jump(double time) noexcept {
    now_ = time;
    ++executed_;
    note_time(time);
  }

  /// The coroutine to resume when the present one has suspended (a called task, a caller).
  void follow(PromiseBase* promise) noexcept { follow_ = promise; }
  /// The process whose root has just reached its end.
  void finished(ProcessState* process) noexcept { finished_ = process; }

  /// The coroutine that is running; null outside processes.
  [[nodiscard]] PromiseBase* current() const noexcept { return current_; }
  [[nodiscard]] bool closing() const noexcept { return closing_; }

  /// "t = 9.5, process mill-2: ", for messages.
  [[nodiscard]] std::string where() const;

 protected:
  void dispatch(const Entry& entry) {
    now_ = entry.time;
    ++executed_;
    note_time(entry.time);
    if (trace_) [[unlikely]] {
      record(entry);
    }
    if ((entry.payload & node_tag) == 0) {
      follow_ = reinterpret_cast<PromiseBase*>(entry.payload);
    } else {
      reinterpret_cast<EventNode*>(entry.payload & ~node_tag)->fire();
    }
    while (follow_ != nullptr) {
      current_ = std::exchange(follow_, nullptr);
      current_->self.resume();
    }
    current_ = nullptr;
    if (finished_ != nullptr) [[unlikely]] {
      reap();
    }
  }
  // One to one in the hash for every time: a difference never dies out by itself.
  void note_time(double time) noexcept {
    times_ = std::rotl(times_ ^ std::bit_cast<std::uint64_t>(time), 29) * 0x9e3779b97f4a7c15U;
  }
  void record(const Entry& entry) const;
  void reap();

  static constexpr std::uintptr_t node_tag = 1;

  double now_ = 0.0;
  double jump_limit_ = -1.0;  // latest time a delay may jump to; negative when none may
  PromiseBase* follow_ = nullptr;
  PromiseBase* current_ = nullptr;
  ProcessState* finished_ = nullptr;
  std::uint64_t executed_ = 0;
  std::uint64_t times_ = 0xcbf29ce484222325U;  // hash of the times of all events so far, in their order
  std::uint64_t checkpoint_ = std::numeric_limits<std::uint64_t>::max();  // look at the budget from here on
  EventList list_;
  std::function<void(const TraceRecord&)> trace_;
  bool closing_ = false;
  // Processes that have not ended, newest first; those that have but are still referred to; records to reuse.
  ProcessState* live_ = nullptr;
  ProcessState* ended_ = nullptr;
  ProcessState* spare_ = nullptr;
  std::uint64_t spawned_ = 0;

  friend class ProcessState;
};

/// A time as people read it in messages: the shortest decimal that gives the same double back.
[[nodiscard]] std::string text_of(double value);

[[noreturn]] void throw_bad_delay(const Engine& engine, double dt);
[[noreturn]] void throw_bad_priority(const Engine& engine, int priority);

}  // namespace detail
}  // namespace verstat::sim
