#include "sim/kernel/event_list.h"

namespace verstat::sim::detail {

void EventList::cancel(EventId id) noexcept {
  if (instant_.cancel(id)) return;
  // The event is only marked: finding it would need a back pointer per event, written at every move. Marks
  // never outnumber the living (and 64), so a sweep costs O(1) per cancellation.
  dead_.insert(id);
  if (heap_.front().id == id || run_.front().id == id) {
    settle();
  } else if (dead_.size() > 64 && 2 * dead_.size() > timed()) {
    sweep();
  }
}

void EventList::settle() {
  for (;;) {
    while (!heap_.empty() && dead_.erase(heap_.front().id)) heap_.drop_front();
    while (!run_.empty() && dead_.erase(run_.front().id)) run_.drop_front();
    if (!heap_.empty() || !run_.empty() || far_.size() == 0) return;
    far_.next_bucket(run_.refill());
    run_.sort();
  }
}

void EventList::spread() {
  far_.spread(heap_.entries());
  heap_.clear();
  settle();
}

void EventList::sweep() {
  const auto gone = [this](EventId id) { return dead_.contains(id); };
  heap_.remove_if(gone);
  run_.remove_if(gone);
  far_.remove_if(gone);
  dead_.clear();
  settle();
}

}  // namespace verstat::sim::detail
