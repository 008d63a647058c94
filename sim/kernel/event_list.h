#pragma once
// The pending events in strict order of (time, priority, sequence).

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/kernel/id_set.h"

namespace verstat::sim::detail {

/// Identity of a scheduled event: priority in the upper 16 bits (biased), sequence number in the lower 48.
/// Comparing two ids compares (priority, sequence). Zero is never issued.
using EventId = std::uint64_t;

constexpr int lowest_priority = -32768;
constexpr int highest_priority = 32767;

/// A pending event. `payload` belongs to the caller; zero never occurs.
struct Entry {
  double time;
  EventId id;
  std::uintptr_t payload;
};

/// Times are never negative, so their bits order like the numbers, and (time, id) is one 128-bit number:
/// compared without a branch.
__extension__ typedef unsigned __int128 Key;
[[nodiscard]] inline Key key_of(const Entry& entry) noexcept {
  return (static_cast<Key>(std::bit_cast<std::uint64_t>(entry.time)) << 64U) | entry.id;
}

class EventList {
 public:
  EventList();

  /// Adds an event; O(log n), no allocation once the list has had its largest size.
  /// `time` >= 0, finite; lowest_priority <= `priority` <= highest_priority, the smaller the earlier.
  EventId push(double time, int priority, std::uintptr_t payload) {
    const EventId id = next_id(priority);
    push_heap(Entry{time, id, payload});
    return id;
  }

  /// Adds an event of priority 0 at the present instant; O(1). `now` must be the time of the last event
  /// popped (or any time no pending event precedes).
  EventId push_now(std::uintptr_t payload) {
    const EventId id = next_id(0);
    if (ring_size_ == ring_.size()) grow_ring();
    ring_[(ring_head_ + ring_size_++) & (ring_.size() - 1)] = Instant{id, payload};
    return id;
  }

  /// Takes a pending event out: O(log n) amortised. The id must be pending.
  void cancel(EventId id) noexcept;

  [[nodiscard]] bool empty() const noexcept { return ring_size_ == 0 && size_ == 0; }
  /// Number of pending events.
  [[nodiscard]] std::size_t size() const noexcept { return ring_size_ - ring_dead_ + size_ - dead_.size(); }

  /// Entries in memory, with those that are cancelled but not yet removed.
  [[nodiscard]] std::size_t stored() const noexcept { return ring_size_ + size_; }

  /// Time of the next event; infinity when there is none. `now` as in pop.
  [[nodiscard]] double next_time(double now) const noexcept {
    return ring_size_ != 0 ? now : heap_.front().time;
  }

  /// True when an event at `time` pushed now would be the next one for certain.
  [[nodiscard]] bool nothing_until(double time) const noexcept {
    return ring_size_ == 0 && time < heap_.front().time;
  }

  /// Removes and returns the first event; the list must not be empty. `now` is the present time, at which
  /// the events of push_now stand.
  Entry pop(double now) {
    if (ring_size_ != 0 && (heap_.front().time > now || ring_[ring_head_].id < heap_.front().id)) {
      return pop_ring(now);
    }
    return pop_heap();
  }

  /// Number of events ever added.
  [[nodiscard]] std::uint64_t issued() const noexcept { return sequence_; }

 private:
  struct Instant {
    EventId id;
    std::uintptr_t payload;  // zero when cancelled
  };

  EventId next_id(int priority) noexcept {
    return (static_cast<EventId>(priority - lowest_priority) << 48U) | ++sequence_;
  }
  void push_heap(const Entry& entry) {
    if (size_ + children >= heap_.size()) grow_heap();
    std::size_t hole = size_++;
    while (hole > 0) {
      const std::size_t parent = (hole - 1) / children;
      if (key_of(heap_[parent]) < key_of(entry)) break;
      heap_[hole] = heap_[parent];
      hole = parent;
    }
    heap_[hole] = entry;
  }
  Entry pop_heap() {
    const Entry top = heap_.front();
    remove_top();
    if (!dead_.empty()) drop_dead_tops();
    return top;
  }
  void remove_top() {
    const Entry last = heap_[--size_];
    heap_[size_] = sentinel;
    if (size_ != 0) sift_down(0, last);
  }
  // Puts `entry` at or below `hole`. Slots past the end hold the sentinel: four children are always there.
  void sift_down(std::size_t hole, const Entry& entry) {
    const Key key = key_of(entry);
    for (std::size_t child = children * hole + 1; child < size_; child = children * hole + 1) {
      std::size_t best = child;
      Key best_key = key_of(heap_[child]);
      for (std::size_t i = 1; i < children; ++i) {
        const Key other = key_of(heap_[child + i]);
        best = other < best_key ? child + i : best;
        best_key = other < best_key ? other : best_key;
      }
      if (key < best_key) break;
      heap_[hole] = heap_[best];
      hole = best;
    }
    heap_[hole] = entry;
  }

  Entry pop_ring(double now);
  void drop_dead_tops();
  void sweep();
  void grow_heap();
  void grow_ring();

  static constexpr std::size_t children = 4;
  static constexpr Entry sentinel{std::numeric_limits<double>::infinity(), ~EventId{0}, 0};

  std::vector<Entry> heap_;  // 4-ary; every slot from size_ on holds the sentinel
  std::size_t size_ = 0;
  IdSet dead_;                 // ids in the heap that were cancelled; never the top
  std::vector<Instant> ring_;  // a power of two of slots
  std::size_t ring_head_ = 0;
  std::size_t ring_size_ = 0;
  std::size_t ring_dead_ = 0;
  std::uint64_t sequence_ = 0;
};

}  // namespace verstat::sim::detail
