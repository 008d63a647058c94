#pragma once
// How often nothing happens for a while: stops counted by intervals of equal length.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace verstat::shop {

/// Events of one machine's tool in consecutive intervals of `interval_min` from the start of the counted
/// time. Whole intervals only: what comes after the last whole one is not counted. Memory grows with the
/// largest number of events in one interval, not with time.
class IntervalCount {
 public:
  /// Counts from `start_min` to `end_min`.
  void restart(double start_min, double end_min, double interval_min) {
    start_min_ = start_min;
    interval_min_ = interval_min;
    // Rounding must not cost the last interval; more of them than this are as good as infinitely many.
    intervals_ =
        static_cast<std::int64_t>(std::min(9e15, (end_min - start_min) / interval_min * (1 + 1e-12)));
    current_ = -1;
    events_ = 0;
    with_events_.clear();
  }
  void add(double now_min) {
    const double at = (now_min - start_min_) / interval_min_;
    if (!(at < static_cast<double>(intervals_))) return;
    const auto interval = static_cast<std::int64_t>(at);
    if (interval != current_) close();
    current_ = interval;
    ++events_;
  }
  /// The interval under way is over.
  void close() {
    if (events_ > 0) {
      if (with_events_.size() <= events_) with_events_.resize(events_ + 1);
      ++with_events_[events_];
    }
    events_ = 0;
    current_ = -1;
  }
  [[nodiscard]] std::int64_t intervals() const { return intervals_; }
  /// Intervals with at most `events` events, once closed.
  [[nodiscard]] std::int64_t at_most(std::size_t events) const {
    std::int64_t more = 0;
    for (std::size_t k = events + 1; k < with_events_.size(); ++k) more += with_events_[k];
    return intervals_ - more;
  }
  [[nodiscard]] std::size_t most_events() const { return with_events_.empty() ? 0 : with_events_.size() - 1; }

 private:
  double start_min_ = 0;
  double interval_min_ = 1;
  std::int64_t intervals_ = 0;
  std::int64_t current_ = -1;
  std::size_t events_ = 0;
  std::vector<std::int64_t> with_events_;  // [n]: intervals with n > 0 events
};

}  // namespace verstat::shop
