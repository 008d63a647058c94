#pragma once
// Container: an amount of something that can be divided (coolant, chips, money).

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "sim/kernel/queue_statistics.h"
#include "sim/kernel/simulation.h"

namespace verstat::sim {

class Container;

namespace detail {

/// Waits to add (amount > 0) or to take (amount < 0).
class Transfer final : public Awaitable<Transfer, LinkedWaiter> {
 public:
  using value_type = void;
  Transfer(Engine& engine, Container& container, double amount) noexcept
      : Awaitable(engine), container_(&container), amount_(amount), since_(engine.now()) {}

  bool try_now();
  void begin();
  void served() override;
  void withdraw() noexcept override;
  void take() noexcept;

 private:
  friend class verstat::sim::Container;
  Container* container_;
  double amount_;
  double since_;
  bool done_ = false;
};

}  // namespace detail

/// A level between 0 and a capacity. Puts wait for room, gets for content, each in order of arrival; who is
/// first is served first, also when somebody behind wants less. A transfer that is called off between grant
/// and waking is undone as far as the content allows.
class Container {
 public:
  /// 0 <= `level` <= `capacity`, in the unit of your choice.
  explicit Container(Simulation& sim, double capacity = std::numeric_limits<double>::infinity(),
                     double level = 0.0, std::string_view name = "container");
  Container(const Container&) = delete;
  Container& operator=(const Container&) = delete;

  /// `co_await container.put(amount)`: 0 <= amount <= capacity.
  [[nodiscard]] detail::Transfer put(double amount);
  /// `co_await container.get(amount)`: 0 <= amount <= capacity.
  [[nodiscard]] detail::Transfer get(double amount);

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] double level() const noexcept { return level_; }
  [[nodiscard]] double capacity() const noexcept { return capacity_; }
  [[nodiscard]] std::size_t waiting_to_get() const noexcept { return getters_.size(); }
  [[nodiscard]] std::size_t waiting_to_put() const noexcept { return putters_.size(); }

  void enable_statistics();
  /// `level` is the content, `length` the number of processes waiting. Null when not enabled.
  [[nodiscard]] QueueStatistics* statistics() noexcept { return statistics_.get(); }

 private:
  friend class detail::Transfer;

  void check(double amount, const char* what) const;
  [[nodiscard]] bool possible(double amount) const noexcept {
    return amount >= 0.0 ? level_ + amount <= capacity_ : level_ + amount >= 0.0;
  }
  void change(double amount);
  void serve();
  void note();

  Simulation* sim_;
  std::string name_;
  double capacity_;
  double level_;
  detail::WaitList getters_;
  detail::WaitList putters_;
  detail::WaitList granted_;  // whose transfer is done, but who have not woken up yet
  std::unique_ptr<QueueStatistics> statistics_;
};

}  // namespace verstat::sim
