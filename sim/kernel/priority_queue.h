#pragma once
// Waiters by priority, first come first served within one.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "sim/kernel/waiter.h"

namespace verstat::sim::detail {

/// One queue per priority that ever occurred: enqueuing costs a binary search over these, nothing else.
class PriorityWaitList {
 public:
  [[nodiscard]] bool empty() const noexcept { return front() == nullptr; }
  [[nodiscard]] std::size_t size() const noexcept {
    std::size_t sum = 0;
    for (const Level& level : levels_) sum += level.waiters.size();
    return sum;
  }

  void push_back(LinkedWaiter& waiter, int priority) { list_of(priority).push_back(waiter); }
  void push_front(LinkedWaiter& waiter, int priority) { list_of(priority).push_front(waiter); }
  static void remove(LinkedWaiter& waiter) noexcept { waiter.unlink(); }
  /// First waiter in order of (priority, arrival); null when empty.
  [[nodiscard]] LinkedWaiter* front() const noexcept {
    for (const Level& level : levels_) {
      if (!level.waiters.empty()) return level.waiters.front();
    }
    return nullptr;
  }
  /// Calls `visit(waiter)` in order until a call returns true; `visit` may remove the waiter it gets.
  template <class Waiter, class Visit>
  bool visit_in_order(Visit visit) {
    for (Level& level : levels_) {
      for (LinkedWaiter* waiter = level.waiters.front(); waiter != nullptr;) {
        LinkedWaiter* next = WaitList::after(*waiter);
        if (visit(static_cast<Waiter&>(*waiter))) return true;
        waiter = next;
      }
    }
    return false;
  }

 private:
  struct Level {
    explicit Level(int p) noexcept : priority(p) {}
    int priority;
    WaitList waiters;
  };
  WaitList& list_of(int priority) {
    auto at = std::lower_bound(levels_.begin(), levels_.end(), priority,
                               [](const Level& level, int p) { return level.priority < p; });
    if (at == levels_.end() || at->priority != priority) at = levels_.emplace(at, priority);
    return at->waiters;
  }

  std::vector<Level> levels_;  // sorted by priority
};

}  // namespace verstat::sim::detail
