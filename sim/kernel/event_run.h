#pragma once
// A sorted row of events that is used up from the front.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/kernel/entry.h"
#include "sim/kernel/event_heap.h"

namespace verstat::sim::detail {

class EventRun {
 public:
  EventRun() : entries_(1, no_event), front_(entries_.data()) {}
  EventRun(const EventRun&) = delete;
  EventRun& operator=(const EventRun&) = delete;

  [[nodiscard]] bool empty() const noexcept { return front_->payload == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return entries_.size() - 1 - used(); }
  /// The first event; no_event when empty.
  [[nodiscard]] const Entry& front() const noexcept { return *front_; }
  void drop_front() noexcept { ++front_; }
  Entry pop() noexcept { return *front_++; }

  /// Where to put the events of the next run, in any order; then sort().
  [[nodiscard]] std::vector<Entry>& refill() noexcept {
    entries_.clear();
    return entries_;
  }
  void sort() {
    if (!sort_few()) {
      std::sort(entries_.begin(), entries_.end(),
                [](const Entry& a, const Entry& b) { return key_of(a) < key_of(b); });
    }
    entries_.push_back(no_event);
    front_ = entries_.data();
  }

  template <class Gone>
  void remove_if(Gone gone) {
    std::size_t kept = 0;
    for (std::size_t i = used(); i + 1 < entries_.size(); ++i) {
      if (!gone(entries_[i].id)) entries_[kept++] = entries_[i];
    }
    entries_.resize(kept);
    entries_.push_back(no_event);
    front_ = entries_.data();
  }

 private:
  [[nodiscard]] std::size_t used() const noexcept {
    return static_cast<std::size_t>(front_ - entries_.data());
  }

  // Puts every entry where the number of earlier ones says: many comparisons, but none of them is a branch
  // that could be mispredicted. False, with nothing done, when there are too many entries or equal times.
  bool sort_few() noexcept {
    const std::size_t n = entries_.size();
    if (n > few) return false;
    std::array<Pair, few / 2> times;
    times.fill(Pair{no_event.time, no_event.time});
    for (std::size_t i = 0; i < n; ++i) times[i / 2][i % 2] = entries_[i].time;
    std::array<std::size_t, few> ranks;
    std::size_t sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double time = entries_[i].time;
      CountPair earlier{};
      for (const Pair& pair : times) earlier -= pair < Pair{time, time};  // true is -1
      ranks[i] = static_cast<std::size_t>(earlier[0] + earlier[1]);
      sum += ranks[i];
    }
    if (2 * sum != n * (n - 1)) return false;
    std::array<Entry, few> unsorted;
    std::copy_n(entries_.begin(), n, unsorted.begin());
    for (std::size_t i = 0; i < n; ++i) entries_[ranks[i]] = unsorted[i];
    return true;
  }

  static constexpr std::size_t few = 16;
  using Pair = double __attribute__((vector_size(16)));
  using CountPair = std::int64_t __attribute__((vector_size(16)));

  std::vector<Entry> entries_;  // ends with no_event
  Entry* front_;
};

}  // namespace verstat::sim::detail
