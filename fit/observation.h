#pragma once
// What is known of one life: it ended at `low` = `high`, it ended between them, or it had not ended at `low`.

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace verstat::fit {

struct Observation {
  double low = 0;
  double high = 0;       ///< infinite: still alive at `low` (right-censored)
  std::size_t line = 0;  ///< where it stands in its file
  std::size_t batch = 0;
  int cause = -1;  ///< index of the cause of failure; -1: did not fail

  [[nodiscard]] bool exact() const { return low == high; }
  [[nodiscard]] bool failed() const { return std::isfinite(high); }
  /// One number for plots and ranks: the end, the middle of the interval, or the censoring time.
  [[nodiscard]] double at() const { return failed() ? low + (high - low) / 2 : low; }
};

[[nodiscard]] inline Observation exact_life(double t) {
  return {.low = t, .high = t, .cause = 0};
}
[[nodiscard]] inline Observation survived(double t) {
  return {.low = t, .high = std::numeric_limits<double>::infinity()};
}
[[nodiscard]] inline Observation between(double low, double high) {
  return {.low = low, .high = high, .cause = 0};
}

}  // namespace verstat::fit
