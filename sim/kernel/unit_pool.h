#pragma once
// UnitPool: distinguishable units, of which a process wants one that suits (a setter with a skill).

#include <concepts>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/kernel/priority_queue.h"
#include "sim/kernel/queue_statistics.h"
#include "sim/kernel/simulation.h"

namespace verstat::sim {

template <class T>
class UnitPool;

/// One unit held. Movable; gives the unit back when it is destroyed or release() is called.
template <class T>
class [[nodiscard]] UnitHold {
 public:
  UnitHold() = default;
  UnitHold(UnitHold&& other) noexcept { *this = std::move(other); }
  UnitHold& operator=(UnitHold&& other) noexcept {
    if (this == &other) return *this;
    release();
    pool_ = std::exchange(other.pool_, nullptr);
    index_ = other.index_;
    if (pool_ != nullptr) pool_->slots_[index_].hold = this;
    return *this;
  }
  ~UnitHold() { release(); }

  void release() noexcept {
    if (pool_ != nullptr) std::exchange(pool_, nullptr)->give_back(index_);
  }
  /// False when nothing is held (default-constructed, released, or the pool is gone).
  [[nodiscard]] explicit operator bool() const noexcept { return pool_ != nullptr; }
  /// Number of the unit in the pool, from 0.
  [[nodiscard]] std::size_t index() const noexcept { return index_; }
  [[nodiscard]] T& operator*() const noexcept { return pool_->slots_[index_].unit; }
  [[nodiscard]] T* operator->() const noexcept { return &pool_->slots_[index_].unit; }

 private:
  friend class UnitPool<T>;
  UnitPool<T>* pool_ = nullptr;
  std::size_t index_ = 0;
};

namespace detail {

template <class T>
class UnitWaiter : public LinkedWaiter {
 public:
  [[nodiscard]] virtual bool accepts(const T& unit) = 0;

 protected:
  UnitWaiter(Engine& engine, int priority) noexcept
      : LinkedWaiter(engine), priority_(priority), since_(engine.now()) {}

  friend class UnitPool<T>;
  int priority_;
  double since_;
  UnitHold<T> hold_;
};

template <class T, class Filter>
class AcquireUnit final : public Awaitable<AcquireUnit<T, Filter>, UnitWaiter<T>> {
 public:
  using value_type = UnitHold<T>;
  AcquireUnit(Engine& engine, UnitPool<T>& pool, int priority, Filter filter)
      : Awaitable<AcquireUnit, UnitWaiter<T>>(engine, priority), pool_(&pool), filter_(std::move(filter)) {}

  bool accepts(const T& unit) override { return filter_(unit); }
  bool try_now() { return pool_->take_free(this->hold_, *this); }
  void begin() { pool_->enqueue(*this, this->priority_); }
  void served() override { this->notify(); }
  void withdraw() noexcept override {
    this->cancel_event();
    if (this->linked()) {
      this->unlink();
      pool_->note_queue();
    } else {
      this->hold_.release();
    }
  }
  UnitHold<T> take() {
    if (!this->hold_)
      throw SimulationError(this->engine_->where() + "a pool was destroyed between grant and waking");
    pool_->note_wait(this->engine_->now() - this->since_);
    return std::move(this->hold_);
  }

 private:
  UnitPool<T>* pool_;
  Filter filter_;
};

struct AcceptAll {
  template <class T>
  bool operator()(const T&) const noexcept {
    return true;
  }
};

}  // namespace detail

/// Units of type T, each held by one process at a time. Requests are served in order of priority (smaller
/// first), then arrival; a request whose filter no free unit passes does not hold up those behind it. Of
/// several free units that suit, the one with the lowest number is taken.
template <class T>
class UnitPool {
 public:
  UnitPool(Simulation& sim, std::string_view name) : sim_(&sim), name_(name) {}
  UnitPool(const UnitPool&) = delete;
  UnitPool& operator=(const UnitPool&) = delete;
  ~UnitPool() {
    for (Slot& slot : slots_) {
      if (slot.hold != nullptr) slot.hold->pool_ = nullptr;
    }
  }

  /// Adds a unit and returns its number. Units stay; references to them are valid until the next add.
  std::size_t add(T unit) {
    slots_.emplace_back(std::move(unit));
    offer(slots_.size() - 1);
    return slots_.size() - 1;
  }

  /// `auto who = co_await crew.acquire([](const Worker& w) { return w.can_set; });` waits for a unit that
  /// passes the filter, which must depend on the unit and on things that outlive the wait only.
  template <class Filter = detail::AcceptAll>
  requires std::predicate<Filter&, const T&>
  [[nodiscard]] detail::AcquireUnit<T, Filter> acquire(Filter filter = Filter(), int priority = 0) {
    static_assert(std::is_trivially_destructible_v<Filter>, "capture by reference (see Signal::wait_until)");
    return detail::AcquireUnit<T, Filter>(*sim_, *this, priority, std::move(filter));
  }

  /// A unit that is off (end of shift, breakdown) is not handed out; whoever holds it keeps it.
  void set_available(std::size_t index, bool available) {
    slots_.at(index).available = available;
    if (available && slots_[index].hold == nullptr) offer(index);
  }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] std::size_t size() const noexcept { return slots_.size(); }
  [[nodiscard]] T& unit(std::size_t index) { return slots_.at(index).unit; }
  [[nodiscard]] bool is_held(std::size_t index) const { return slots_.at(index).hold != nullptr; }
  [[nodiscard]] bool is_available(std::size_t index) const { return slots_.at(index).available; }
  [[nodiscard]] std::size_t in_use() const noexcept { return in_use_; }
  [[nodiscard]] std::size_t queue_length() const noexcept { return queue_.size(); }

  void enable_statistics() {
    statistics_ = std::make_unique<QueueStatistics>(sim_->now());
    note_queue();
    note_level();
    statistics_->reset(sim_->now());
  }
  /// `level` is the number of units held. Null when not enabled.
  [[nodiscard]] QueueStatistics* statistics() noexcept { return statistics_.get(); }

 private:
  template <class, class>
  friend class detail::AcquireUnit;
  friend class UnitHold<T>;

  struct Slot {
    explicit Slot(T u) : unit(std::move(u)) {}
    T unit;
    UnitHold<T>* hold = nullptr;  // who has it
    bool available = true;
  };

  void hand_over(std::size_t index, UnitHold<T>& hold) {
    hold.pool_ = this;
    hold.index_ = index;
    slots_[index].hold = &hold;
    ++in_use_;
    note_level();
  }
  bool take_free(UnitHold<T>& hold, detail::UnitWaiter<T>& request) {
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      if (slots_[i].hold == nullptr && slots_[i].available && request.accepts(slots_[i].unit)) {
        hand_over(i, hold);
        return true;
      }
    }
    return false;
  }
  void offer(std::size_t index) {
    if (sim_->closing() || !slots_[index].available) return;
    queue_.template visit_in_order<detail::UnitWaiter<T>>([&](detail::UnitWaiter<T>& request) {
      if (!request.accepts(slots_[index].unit)) return false;
      queue_.remove(request);
      note_queue();
      hand_over(index, request.hold_);
      request.served();
      return true;
    });
  }
  void give_back(std::size_t index) {
    slots_[index].hold = nullptr;
    --in_use_;
    note_level();
    offer(index);
  }
  void enqueue(detail::UnitWaiter<T>& request, int priority) {
    queue_.push_back(request, priority);
    note_queue();
  }
  void note_wait(double wait) {
    if (statistics_) statistics_->wait.add(wait);
  }
  void note_queue() {
    if (statistics_) statistics_->length.set(sim_->now(), static_cast<double>(queue_.size()));
  }
  void note_level() {
    if (statistics_) statistics_->level.set(sim_->now(), static_cast<double>(in_use_));
  }

  Simulation* sim_;
  std::string name_;
  std::vector<Slot> slots_;
  std::size_t in_use_ = 0;
  detail::PriorityWaitList queue_;
  std::unique_ptr<QueueStatistics> statistics_;
};

}  // namespace verstat::sim
