#include "sim/kernel/container.h"

#include <utility>

namespace verstat::sim {

namespace detail {

bool Transfer::try_now() {
  WaitList& ahead = amount_ >= 0.0 ? container_->putters_ : container_->getters_;
  if (!ahead.empty() || !container_->possible(amount_)) return false;
  done_ = true;
  container_->granted_.push_back(*this);
  container_->change(amount_);
  return true;
}

void Transfer::begin() {
  (amount_ >= 0.0 ? container_->putters_ : container_->getters_).push_back(*this);
  container_->note();
}

void Transfer::served() {
  done_ = true;
  container_->granted_.push_back(*this);
  notify();
}

void Transfer::withdraw() noexcept {
  cancel_event();
  if (!linked()) return;  // never began, or the container is gone
  unlink();
  if (std::exchange(done_, false)) {
    const double back = container_->level_ - amount_;
    const double possible = back < 0.0 ? 0.0 : back > container_->capacity_ ? container_->capacity_ : back;
    container_->change(possible - container_->level_);
  } else {
    container_->note();
    container_->serve();  // somebody who wants less may now be first
  }
}

void Transfer::take() noexcept {
  if (!linked()) return;
  unlink();
  if (container_->statistics_) container_->statistics_->wait.add(engine_->now() - since_);
}

}  // namespace detail

Container::Container(Simulation& sim, double capacity, double level, std::string_view name)
    : sim_(&sim), name_(name), capacity_(capacity), level_(level) {
  if (!(capacity >= 0.0)) {
    throw SimulationError("container " + name_ + ": capacity is " + detail::text_of(capacity) +
                          ", must be >= 0");
  }
  if (!(level >= 0.0 && level <= capacity)) {
    throw SimulationError("container " + name_ + ": level is " + detail::text_of(level) +
                          ", must be from 0 to the capacity " + detail::text_of(capacity));
  }
}

detail::Transfer Container::put(double amount) {
  check(amount, "put");
  return detail::Transfer(*sim_, *this, amount);
}

detail::Transfer Container::get(double amount) {
  check(amount, "get");
  return detail::Transfer(*sim_, *this, -amount);
}

void Container::check(double amount, const char* what) const {
  if (amount >= 0.0 && amount <= capacity_ && std::isfinite(amount)) return;
  throw SimulationError(sim_->where() + "container " + name_ + ": " + what + " of " +
                        detail::text_of(amount) + ", must be finite and from 0 to the capacity " +
                        detail::text_of(capacity_));
}

void Container::change(double amount) {
  level_ += amount;
  note();
  serve();
}

void Container::serve() {
  if (sim_->closing()) return;
  for (bool moved = true; moved;) {
    moved = false;
    for (detail::WaitList* queue : {&putters_, &getters_}) {
      while (!queue->empty() && possible(static_cast<detail::Transfer*>(queue->front())->amount_)) {
        auto& first = static_cast<detail::Transfer&>(queue->pop_front());
        level_ += first.amount_;
        note();
        first.served();
        moved = true;
      }
    }
  }
}

void Container::enable_statistics() {
  statistics_ = std::make_unique<QueueStatistics>(sim_->now());
  note();
  statistics_->reset(sim_->now());
}

void Container::note() {
  if (!statistics_) return;
  statistics_->level.set(sim_->now(), level_);
  statistics_->length.set(sim_->now(), static_cast<double>(getters_.size() + putters_.size()));
}

}  // namespace verstat::sim
