#pragma once
// Resource: a number of equal units that processes hold for a while.

#include <memory>
#include <string>
#include <string_view>

#include "sim/kernel/priority_queue.h"
#include "sim/kernel/queue_statistics.h"
#include "sim/kernel/simulation.h"

namespace verstat::sim {

class Resource;
class Acquire;

/// Units held. Movable; gives them back when it is destroyed or release() is called. It becomes empty when
/// its units are pre-empted, or when the resource is gone.
class [[nodiscard]] Hold {
 public:
  Hold() = default;
  Hold(Hold&& other) noexcept { *this = std::move(other); }
  Hold& operator=(Hold&& other) noexcept;
  ~Hold() { release(); }

  /// Gives the units back now. Does nothing when empty.
  void release() noexcept;
  /// True while units are held.
  [[nodiscard]] explicit operator bool() const noexcept { return resource_ != nullptr; }
  [[nodiscard]] int units() const noexcept { return resource_ == nullptr ? 0 : units_; }
  [[nodiscard]] int priority() const noexcept { return priority_; }

 private:
  friend class Resource;
  friend class Acquire;
  void link(Resource& resource) noexcept;
  void unlink() noexcept;

  Resource* resource_ = nullptr;
  Hold* prev_ = nullptr;
  Hold* next_ = nullptr;
  int units_ = 0;
  int priority_ = 0;
  detail::ProcessRef owner_;
  Acquire* granted_to_ = nullptr;  // the request it is still part of, until its process wakes up
};

/// The wait for units; see Resource::acquire.
class Acquire final : public detail::Awaitable<Acquire, detail::LinkedWaiter> {
 public:
  using value_type = Hold;
  Acquire(Resource& resource, int units, int priority, bool preempting);

  bool try_now();
  void begin();
  void served() override;
  void withdraw() noexcept override;
  Hold take();

 private:
  friend class Resource;
  Resource* resource_;
  int units_;
  int priority_;
  bool preempting_;
  double since_;  // time of the request
  detail::ProcessRef process_;
  Hold hold_;  // what was granted, until the process wakes up and takes it
};

/// Equal units with a priority queue (smaller number first, first come first served within a priority; who
/// is first in the queue is served first, also when somebody behind would need fewer units).
class Resource {
 public:
  enum class OnShrink {
    finish,  ///< who holds units finishes; units go as they are given back
    preempt  ///< the least urgent holders are interrupted at once
  };

  /// `capacity` >= 0 units.
  Resource(Simulation& sim, std::string_view name, int capacity = 1);
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;
  ~Resource();

  /// `Hold hold = co_await resource.acquire();` waits for `units` (1 to the largest capacity there will be).
  [[nodiscard]] Acquire acquire(int priority = 0, int units = 1) {
    return Acquire(*this, units, priority, false);
  }
  /// Like acquire, but takes the units from less urgent holders when they are not free: these are
  /// interrupted with Reason::preempted and their holds are empty. The last to come loses first.
  [[nodiscard]] Acquire preempt(int priority, int units = 1) { return Acquire(*this, units, priority, true); }
  /// Takes units that are free with nobody waiting; else returns an empty hold.
  Hold try_acquire(int units = 1, int priority = 0);

  /// Changes the number of units (shift change, breakdown of one of several).
  void set_capacity(int capacity, OnShrink policy = OnShrink::finish);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] int capacity() const noexcept { return capacity_; }
  [[nodiscard]] int in_use() const noexcept { return in_use_; }
  /// Units that could be taken now (0 while more are in use than there are).
  [[nodiscard]] int free_units() const noexcept { return in_use_ < capacity_ ? capacity_ - in_use_ : 0; }
  [[nodiscard]] std::size_t queue_length() const noexcept { return queue_.size(); }

  /// Starts recording from now; costs nothing until then.
  void enable_statistics();
  /// What was recorded: `level` is the number of units in use. Null when not enabled.
  [[nodiscard]] QueueStatistics* statistics() noexcept { return statistics_.get(); }

 private:
  friend class Hold;
  friend class Acquire;

  [[nodiscard]] bool fits(int units) const noexcept { return in_use_ + units <= capacity_; }
  /// True when nobody waits whom a request of this priority may not overtake.
  [[nodiscard]] bool first_in_line(int priority) const noexcept;
  void grant(Hold& hold, int units, int priority, detail::ProcessRef owner);
  void give_back(Hold& hold) noexcept;
  void serve_queue();
  bool make_room(const Acquire& request);
  [[nodiscard]] Hold* least_urgent_hold(int than) const noexcept;
  void evict(Hold& hold);
  void enqueue(Acquire& request, bool in_front);
  void note_queue() {
    if (statistics_) statistics_->length.set(sim_->now(), static_cast<double>(queue_.size()));
  }
  void note_level() {
    if (statistics_) statistics_->level.set(sim_->now(), in_use_);
  }

  Simulation* sim_;
  std::string name_;
  int capacity_;
  int in_use_ = 0;
  detail::PriorityWaitList queue_;
  Hold* last_hold_ = nullptr;  // holds in order of granting, last first
  bool evicting_ = false;      // units that become free are spoken for
  std::unique_ptr<QueueStatistics> statistics_;
};

}  // namespace verstat::sim
