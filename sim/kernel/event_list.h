#pragma once
// The pending events in strict order of (time, priority, sequence).

#include <cstddef>
#include <cstdint>

#include "sim/kernel/entry.h"
#include "sim/kernel/event_heap.h"
#include "sim/kernel/event_run.h"
#include "sim/kernel/far_events.h"
#include "sim/kernel/id_set.h"
#include "sim/kernel/instant_queue.h"

namespace verstat::sim::detail {

/// Four places by urgency: a queue for the present instant; a heap; and, when there are many events, rough
/// buckets for most of them, of which the next one has been sorted into a run. The next event is the first of
/// queue, heap and run. docs/decisions tells what else was tried.
class EventList {
 public:
  /// Adds an event; O(log n) and no allocation once the list has had its largest size.
  /// `time` >= 0, finite; lowest_priority <= `priority` <= highest_priority, the smaller the earlier.
  EventId push(double time, int priority, std::uintptr_t payload) {
    const EventId id = next_id(priority);
    if (far_.is_near(time)) {
      heap_.push(Entry{time, id, payload});
      if (heap_.size() > longest_heap && far_.size() == 0) [[unlikely]] {
        spread();
      }
    } else {
      far_.push(Entry{time, id, payload});
    }
    return id;
  }

  /// Adds an event of priority 0 at the present instant; O(1). `now` must be the time of the last event
  /// popped (or any time no pending event precedes).
  EventId push_now(std::uintptr_t payload) {
    const EventId id = next_id(0);
    instant_.push(id, payload);
    return id;
  }

  /// Takes a pending event out: O(1) amortised. The id must be pending.
  void cancel(EventId id) noexcept;

  [[nodiscard]] bool empty() const noexcept { return instant_.empty() && heap_.empty() && run_.empty(); }
  /// Number of pending events.
  [[nodiscard]] std::size_t size() const noexcept { return instant_.size() + timed() - dead_.size(); }
  /// Entries in memory, with those that are cancelled but not yet removed.
  [[nodiscard]] std::size_t stored() const noexcept { return instant_.stored() + timed(); }

  /// Time of the next event; infinity when there is none. `now` as in pop.
  [[nodiscard]] double next_time(double now) const noexcept { return instant_.empty() ? next_timed() : now; }

  /// True when an event at `time` pushed now would be the next one for certain.
  [[nodiscard]] bool nothing_until(double time) const noexcept {
    return time < heap_.front().time && time < run_.front().time && instant_.empty();
  }

  /// Removes and returns the first event; the list must not be empty. `now` is the present time, at which
  /// the events of push_now stand.
  [[gnu::always_inline]] Entry pop(double now) {
    const bool from_run = key_of(run_.front()) < key_of(heap_.front());
    if (!instant_.empty()) {
      const Entry& first = from_run ? run_.front() : heap_.front();
      if (first.time > now || instant_.front_id() < first.id) return instant_.pop(now);
    }
    const Entry entry = from_run ? run_.pop() : heap_.pop();
    if (!dead_.empty() || (far_.size() != 0 && heap_.empty() && run_.empty())) settle();
    return entry;
  }

 private:
  EventId next_id(int priority) noexcept {
    return (static_cast<EventId>(priority - lowest_priority) << 48U) | ++sequence_;
  }
  [[nodiscard]] std::size_t timed() const noexcept { return heap_.size() + run_.size() + far_.size(); }
  [[nodiscard]] double next_timed() const noexcept {
    return heap_.front().time < run_.front().time ? heap_.front().time : run_.front().time;
  }

  // Makes the fronts of heap and run living events, and one of them the next, if any event is left.
  void settle();
  // The heap has become long: most of it goes into buckets.
  void spread();
  // Removes what was cancelled, everywhere.
  void sweep();

  static constexpr std::size_t longest_heap = 256;

  EventHeap heap_;
  EventRun run_;
  InstantQueue instant_;
  FarEvents far_;  // later than everything in heap and run; empty when these are
  IdSet dead_;     // ids in heap, run and buckets that were cancelled; none of them in front
  std::uint64_t sequence_ = 0;
};

}  // namespace verstat::sim::detail
