#include "sim/kernel/instant_queue.h"

namespace verstat::sim::detail {

bool InstantQueue::cancel(EventId id) noexcept {
  std::size_t low = 0;
  std::size_t high = stored_;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (at(middle).id < id) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == stored_ || at(low).id != id) return false;
  at(low).payload = 0;
  ++dead_;
  drop_dead();
  return true;
}

void InstantQueue::drop_dead() noexcept {
  while (stored_ != 0 && slots_[head_].payload == 0) {
    advance();
    --dead_;
  }
}

void InstantQueue::grow() {
  std::vector<Slot> wider(2 * slots_.size());
  for (std::size_t i = 0; i < stored_; ++i) wider[i] = at(i);
  slots_.swap(wider);
  mask_ = slots_.size() - 1;
  head_ = 0;
}

}  // namespace verstat::sim::detail
