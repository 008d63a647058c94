#pragma once
// A 4-ary heap of events.

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "sim/kernel/entry.h"

namespace verstat::sim::detail {

/// Stands behind every real event.
inline constexpr Entry no_event{std::numeric_limits<double>::infinity(), ~EventId{0}, 0};

/// Four children share about two cache lines and are compared without branches; a wider node costs more
/// comparisons, a narrower one more levels.
class EventHeap {
 public:
  EventHeap() : slots_(room_ + arity, no_event) {}

  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::span<const Entry> entries() const noexcept { return {slots_.data(), size_}; }
  /// The first event; no_event when empty.
  [[nodiscard]] const Entry& front() const noexcept { return slots_[0]; }

  void push(const Entry& entry) {
    if (size_ == room_) [[unlikely]] {
      grow();
    }
    const Key key = key_of(entry);
    Entry* const slots = slots_.data();
    std::size_t hole = size_++;
    while (hole > 0) {
      const std::size_t parent = (hole - 1) / arity;
      if (key_of(slots[parent]) < key) break;
      slots[hole] = slots[parent];
      hole = parent;
    }
    slots[hole] = entry;
  }

  void drop_front() {
    const Entry last = slots_[--size_];
    slots_[size_] = no_event;
    if (size_ != 0) sift_down(0, last);
  }
  Entry pop() {
    const Entry first = slots_[0];
    drop_front();
    return first;
  }

  template <class Gone>
  void remove_if(Gone gone) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      if (!gone(slots_[i].id)) slots_[kept++] = slots_[i];
    }
    for (std::size_t i = kept; i < size_; ++i) slots_[i] = no_event;
    size_ = kept;
    if (size_ < 2) return;
    for (std::size_t i = (size_ - 2) / arity + 1; i-- > 0;) sift_down(i, Entry{slots_[i]});
  }

  void clear() noexcept {
    for (std::size_t i = 0; i < size_; ++i) slots_[i] = no_event;
    size_ = 0;
  }

 private:
  static constexpr std::size_t arity = 4;

  // Puts `entry` at or below `hole`. Slots past the end hold no_event: four children are always there.
  void sift_down(std::size_t hole, const Entry& entry) {
    const Key key = key_of(entry);
    Entry* const slots = slots_.data();
    for (std::size_t child = arity * hole + 1; child < size_; child = arity * hole + 1) {
      const std::size_t left =
          child + static_cast<std::size_t>(key_of(slots[child + 1]) < key_of(slots[child]));
      const std::size_t right =
          child + 2 + static_cast<std::size_t>(key_of(slots[child + 3]) < key_of(slots[child + 2]));
      const std::size_t best = key_of(slots[right]) < key_of(slots[left]) ? right : left;
      if (key < key_of(slots[best])) break;
      slots[hole] = slots[best];
      hole = best;
    }
    slots[hole] = entry;
  }

  void grow() {
    room_ *= 2;
    slots_.resize(room_ + arity, no_event);
  }

  std::size_t room_ = 60;
  std::vector<Entry> slots_;  // every slot from size_ on holds no_event
  std::size_t size_ = 0;
};

}  // namespace verstat::sim::detail
