#include "sim/kernel/event_list.h"

#include <utility>

namespace verstat::sim::detail {

EventList::EventList() : heap_(64, sentinel), ring_(64) {}

Entry EventList::pop_ring(double now) {
  const Instant first = ring_[ring_head_];
  const std::size_t mask = ring_.size() - 1;
  ring_head_ = (ring_head_ + 1) & mask;
  --ring_size_;
  // The first entry of the ring is always alive.
  while (ring_dead_ != 0 && ring_size_ != 0 && ring_[ring_head_].payload == 0) {
    ring_head_ = (ring_head_ + 1) & mask;
    --ring_size_;
    --ring_dead_;
  }
  return Entry{now, first.id, first.payload};
}

void EventList::cancel(EventId id) noexcept {
  // The ring is sorted by id: look there first.
  const std::size_t mask = ring_.size() - 1;
  std::size_t low = 0;
  std::size_t high = ring_size_;
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    if (ring_[(ring_head_ + middle) & mask].id < id) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low < ring_size_ && ring_[(ring_head_ + low) & mask].id == id) {
    ring_[(ring_head_ + low) & mask].payload = 0;
    ++ring_dead_;
    while (ring_size_ != 0 && ring_[ring_head_].payload == 0) {
      ring_head_ = (ring_head_ + 1) & mask;
      --ring_size_;
      --ring_dead_;
    }
    return;
  }
  if (heap_.front().id == id) {
    remove_top();
    if (!dead_.empty()) drop_dead_tops();
    return;
  }
  // Deeper in the heap the event is only marked: finding it would need a back pointer per event, written
  // at every move. Marks never outnumber the living (and 64), so a sweep costs O(1) per cancellation.
  dead_.insert(id);
  if (dead_.size() > 64 && 2 * dead_.size() > size_) sweep();
}

void EventList::drop_dead_tops() {
  while (size_ != 0 && dead_.erase(heap_.front().id)) remove_top();
}

void EventList::sweep() {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < size_; ++i) {
    if (!dead_.contains(heap_[i].id)) heap_[kept++] = heap_[i];
  }
  for (std::size_t i = kept; i < size_; ++i) heap_[i] = sentinel;
  size_ = kept;
  dead_.clear();
  for (std::size_t i = size_ / children + 1; i-- > 0;) {
    if (i < size_) sift_down(i, Entry{heap_[i]});
  }
}

void EventList::grow_heap() {
  heap_.resize(2 * heap_.size(), sentinel);
}

void EventList::grow_ring() {
  std::vector<Instant> wider(2 * ring_.size());
  for (std::size_t i = 0; i < ring_size_; ++i) wider[i] = ring_[(ring_head_ + i) & (ring_.size() - 1)];
  ring_.swap(wider);
  ring_head_ = 0;
}

}  // namespace verstat::sim::detail
