#pragma once
// Store: a buffer of things, bounded or not, that processes put into and get from.

#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "sim/kernel/queue_statistics.h"
#include "sim/kernel/ring_buffer.h"
#include "sim/kernel/simulation.h"

namespace verstat::sim {

template <class T>
class Store;

namespace detail {

/// Who waits to get. The item is handed over here, at the moment of the put.
template <class T>
class Getter : public LinkedWaiter {
 public:
  [[nodiscard]] virtual bool accepts(const T& item) = 0;

 protected:
  explicit Getter(Engine& engine) noexcept : LinkedWaiter(engine), since_(engine.now()) {}

  friend class Store<T>;
  std::optional<T> item_;
  double since_;
};

template <class T, class Filter>
class Get final : public Awaitable<Get<T, Filter>, Getter<T>> {
 public:
  using value_type = T;
  Get(Engine& engine, Store<T>& store, Filter filter)
      : Awaitable<Get, Getter<T>>(engine), store_(&store), filter_(std::move(filter)) {}

  // Directly behind co_await the item needs no stop on the way.
  [[nodiscard]] bool await_ready() {
    if (!store_->take_stored(*this, filter_)) return false;
    store_->left(this->since_);
    return true;
  }
  bool accepts(const T& item) override { return filter_(item); }
  bool try_now() {
    if (!store_->take_stored(*this, filter_)) return false;
    store_->handed_over_.push_back(*this);
    return true;
  }
  void begin() { store_->getters_.push_back(*this); }
  void served() override { this->notify(); }
  void withdraw() noexcept override {
    this->cancel_event();
    if (!this->linked()) return;  // never began, or the store is gone
    this->unlink();
    if (this->item_) {
      store_->put_back(std::move(*this->item_));
      this->item_.reset();
    }
  }
  T take() {
    if (this->linked()) {
      this->unlink();
      store_->left(this->since_);
    }
    T item = std::move(*this->item_);
    this->item_.reset();
    return item;
  }

 private:
  Store<T>* store_;
  Filter filter_;
};

template <class T>
class Put final : public Awaitable<Put<T>, LinkedWaiter> {
 public:
  using value_type = void;
  Put(Engine& engine, Store<T>& store, T item)
      : Awaitable<Put, LinkedWaiter>(engine), store_(&store), item_(std::move(item)) {}

  bool try_now() {
    if (!store_->has_room()) return false;
    store_->accept(std::move(item_));
    return true;
  }
  void begin() { store_->putters_.push_back(*this); }
  void served() override {
    store_->accept(std::move(item_));
    this->notify();
  }
  void withdraw() noexcept override {
    this->cancel_event();
    this->unlink();
  }
  void take() const noexcept {}

 private:
  Store<T>* store_;
  T item_;
};

struct TakeAny {
  template <class T>
  bool operator()(const T&) const noexcept {
    return true;
  }
};

}  // namespace detail

/// In which order items leave.
enum class Discipline {
  fifo,     ///< first in, first out
  lifo,     ///< last in, first out
  priority  ///< smallest key first, then first in
};

/// Items of type T (movable). Puts wait while it is full, gets while nothing suits; both are served in
/// order of arrival, except that a filtered get which nothing passes lets those behind it go first.
/// An item handed to a waiting getter leaves its place when the getter wakes up: there are never more than
/// `capacity` items in the store and on the way. If the getter is called off in between, the item goes back
/// to the head.
template <class T>
class Store {
 public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

  /// `capacity` >= 1.
  explicit Store(Simulation& sim, std::size_t capacity = unlimited, Discipline discipline = Discipline::fifo,
                 std::string_view name = "store")
      : sim_(&sim), name_(name), capacity_(capacity), discipline_(discipline) {
    if (capacity == 0) throw SimulationError("store " + name_ + ": capacity is 0, must be >= 1");
    if (discipline == Discipline::priority) {
      throw SimulationError("store " + name_ + ": the priority discipline needs a key function");
    }
  }
  /// A store with Discipline::priority: `key(item)` smallest first.
  Store(Simulation& sim, std::size_t capacity, std::function<double(const T&)> key,
        std::string_view name = "store")
      : sim_(&sim),
        name_(name),
        capacity_(capacity),
        discipline_(Discipline::priority),
        key_(std::move(key)) {
    if (capacity == 0) throw SimulationError("store " + name_ + ": capacity is 0, must be >= 1");
    if (!key_) throw SimulationError("store " + name_ + ": the priority discipline needs a key function");
  }
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// `co_await store.put(item)` waits while the store is full.
  [[nodiscard]] detail::Put<T> put(T item) { return detail::Put<T>(*sim_, *this, std::move(item)); }
  /// `T item = co_await store.get();` waits for the next item.
  [[nodiscard]] detail::Get<T, detail::TakeAny> get() { return get(detail::TakeAny()); }
  /// `co_await store.get([](const Part& p) { return p.kind == 3; })`: the first item that passes the filter,
  /// which must depend on the item and on things that outlive the wait only.
  template <class Filter>
  requires std::predicate<Filter&, const T&>
  [[nodiscard]] detail::Get<T, Filter> get(Filter filter) {
    static_assert(std::is_trivially_destructible_v<Filter>, "capture by reference (see Signal::wait_until)");
    return detail::Get<T, Filter>(*sim_, *this, std::move(filter));
  }
  /// Puts without waiting; false (and `item` untouched) when full.
  bool try_put(T& item) {
    if (!has_room()) return false;
    accept(std::move(item));
    return true;
  }
  bool try_put(T&& item) { return try_put(item); }
  bool try_put(const T& item) requires std::copy_constructible<T> {
    if (!has_room()) return false;
    accept(T(item));
    return true;
  }
  /// Takes the next item if there is one.
  std::optional<T> try_get() {
    std::optional<T> item;
    if (!items_.empty()) {
      item.emplace(take_next());
      note_level();
      admit_putters();
    }
    return item;
  }

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Items stored, without those already handed to getters.
  [[nodiscard]] std::size_t size() const noexcept { return items_.size(); }
  [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  [[nodiscard]] bool full() const noexcept { return items_.size() + handed_over_.size() >= capacity_; }
  [[nodiscard]] std::size_t waiting_to_get() const noexcept { return getters_.size(); }
  [[nodiscard]] std::size_t waiting_to_put() const noexcept { return putters_.size(); }
  /// Item `i` in the order of leaving under FIFO and priority (0 <= i < size()).
  [[nodiscard]] const T& item(std::size_t i) const noexcept { return items_[i]; }

  void enable_statistics() {
    statistics_ = std::make_unique<QueueStatistics>(sim_->now());
    note_level();
    statistics_->reset(sim_->now());
  }
  /// `level` is the number of items stored, `length` the number of processes waiting to get or put (as seen
  /// at changes of the level), `wait` the time getters waited. Null when not enabled.
  [[nodiscard]] QueueStatistics* statistics() noexcept { return statistics_.get(); }

 private:
  template <class, class>
  friend class detail::Get;
  friend class detail::Put<T>;

  // Room for one more, with nobody ahead who waits for room.
  [[nodiscard]] bool has_room() const noexcept { return !full() && putters_.empty(); }

  /// An item comes in: to the first getter it suits, else into the store.
  void accept(T item) {
    if (!getters_.empty() && offer(item)) return;
    insert(std::move(item));
    note_level();
  }
  bool offer(T& item) {
    for (detail::LinkedWaiter* waiter = getters_.front(); waiter != nullptr;
         waiter = detail::WaitList::after(*waiter)) {
      auto& getter = static_cast<detail::Getter<T>&>(*waiter);
      if (!getter.accepts(item)) continue;
      getters_.remove(getter);
      getter.item_.emplace(std::move(item));
      handed_over_.push_back(getter);
      getter.served();
      return true;
    }
    return false;
  }
  void insert(T item) {
    if (discipline_ != Discipline::priority) {
      items_.push_back(std::move(item));
      return;
    }
    const double key = key_(item);
    std::size_t low = 0;
    std::size_t high = items_.size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (key_(items_[middle]) <= key) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    items_.insert(low, std::move(item));
  }
  T take_next() { return discipline_ == Discipline::lifo ? items_.pop_back() : items_.pop_front(); }

  template <class Filter>
  bool take_stored(detail::Getter<T>& getter, Filter& filter) {
    if (items_.empty()) return false;
    if constexpr (std::is_same_v<Filter, detail::TakeAny>) {
      getter.item_.emplace(take_next());
    } else {
      const std::size_t n = items_.size();
      std::size_t found = n;
      for (std::size_t i = 0; i < n && found == n; ++i) {
        const std::size_t at = discipline_ == Discipline::lifo ? n - 1 - i : i;
        if (filter(std::as_const(items_)[at])) found = at;
      }
      if (found == n) return false;
      getter.item_.emplace(items_.erase(found));
    }
    note_level();
    return true;
  }
  /// A getter goes on with its item: the place is free.
  void left(double since) {
    if (statistics_) statistics_->wait.add(sim_->now() - since);
    if (!putters_.empty()) admit_putters();
  }
  void admit_putters() {
    while (!putters_.empty() && !full()) putters_.pop_front().served();
  }
  /// A getter was called off after its item had been handed over.
  void put_back(T item) noexcept {
    if (!sim_->closing() && offer(item)) return;
    if (discipline_ == Discipline::lifo) {
      items_.push_back(std::move(item));
    } else {
      items_.push_front(std::move(item));
    }
    note_level();
  }
  void note_level() {
    if (!statistics_) return;
    statistics_->level.set(sim_->now(), static_cast<double>(items_.size()));
    statistics_->length.set(sim_->now(), static_cast<double>(getters_.size() + putters_.size()));
  }

  Simulation* sim_;
  std::string name_;
  std::size_t capacity_;
  Discipline discipline_;
  std::function<double(const T&)> key_;
  RingBuffer<T> items_;
  detail::WaitList getters_;
  detail::WaitList handed_over_;  // getters that have their item and are about to wake up
  detail::WaitList putters_;
  std::unique_ptr<QueueStatistics> statistics_;
};

}  // namespace verstat::sim
