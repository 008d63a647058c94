#pragma once
// What a resource, pool or store records when asked to.

#include "sim/kernel/tally.h"

namespace verstat::sim {

/// Waiting line in front of something. Waits of zero length count.
struct QueueStatistics {
  explicit QueueStatistics(double now) noexcept : length(now), level(now) {}

  TimeWeighted length;  ///< processes waiting
  TimeWeighted level;   ///< units in use (resource, pool), items stored (store), content (container)
  Tally wait;           ///< time from request to grant, of the requests granted

  /// Forgets the warm-up.
  void reset(double now) noexcept {
    length.reset(now);
    level.reset(now);
    wait.reset();
  }
};

}  // namespace verstat::sim
