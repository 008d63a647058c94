#pragma once
// The events of the present instant, first in first out.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/kernel/entry.h"

namespace verstat::sim::detail {

/// Events of one time and one priority: their order is that of their ids, which only grow.
class InstantQueue {
 public:
  InstantQueue() : slots_(mask_ + 1) {}

  [[nodiscard]] bool empty() const noexcept { return stored_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return stored_ - dead_; }
  [[nodiscard]] std::size_t stored() const noexcept { return stored_; }
  [[nodiscard]] EventId front_id() const noexcept { return slots_[head_].id; }

  void push(EventId id, std::uintptr_t payload) {
    if (stored_ > mask_) grow();
    at(stored_++) = Slot{id, payload};
  }
  /// Not when empty; `now` becomes the time of the entry.
  Entry pop(double now) noexcept {
    const Slot first = slots_[head_];
    advance();
    if (dead_ != 0) drop_dead();
    return Entry{now, first.id, first.payload};
  }
  /// False when `id` is not here.
  bool cancel(EventId id) noexcept;

 private:
  struct Slot {
    EventId id;
    std::uintptr_t payload;  // zero when cancelled; never in the front slot
  };

  [[nodiscard]] Slot& at(std::size_t i) noexcept { return slots_[(head_ + i) & mask_]; }
  void advance() noexcept {
    head_ = (head_ + 1) & mask_;
    --stored_;
  }
  void drop_dead() noexcept;
  void grow();

  std::size_t mask_ = 63;
  std::vector<Slot> slots_;  // a ring of mask_ + 1 slots, a power of two
  std::size_t head_ = 0;
  std::size_t stored_ = 0;
  std::size_t dead_ = 0;
};

}  // namespace verstat::sim::detail
