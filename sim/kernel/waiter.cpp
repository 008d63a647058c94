#include "sim/kernel/waiter.h"

#include "sim/kernel/process_state.h"

namespace verstat::sim::detail {

void Waiter::fire() {
  event_ = 0;
  notify_at_once();
}

Engine* current_engine(const PromiseBase& promise) noexcept {
  return &promise.process->engine();
}

void Waiter::notify() {
  if (parent_ != nullptr) {
    parent_->branch_came(index_, false);
  } else {
    event_ = engine_->push_now(promise_);
  }
}

void Waiter::notify_at_once() {
  if (parent_ != nullptr) {
    parent_->branch_came(index_, true);
  } else {
    engine_->follow(promise_);
  }
}

void Waiter::throw_interrupted() const {
  throw Interrupted(promise_->process->take_reason());
}

WaitList& WaitList::operator=(WaitList&& other) noexcept {
  if (this != &other) {
    clear();
    first_ = std::exchange(other.first_, nullptr);
    last_ = std::exchange(other.last_, nullptr);
    size_ = std::exchange(other.size_, 0);
    for (LinkedWaiter* waiter = first_; waiter != nullptr; waiter = waiter->next_) waiter->list_ = this;
  }
  return *this;
}

void WaitList::push_back(LinkedWaiter& waiter) noexcept {
  waiter.list_ = this;
  waiter.prev_ = last_;
  waiter.next_ = nullptr;
  (last_ == nullptr ? first_ : last_->next_) = &waiter;
  last_ = &waiter;
  ++size_;
}

void WaitList::push_front(LinkedWaiter& waiter) noexcept {
  waiter.list_ = this;
  waiter.prev_ = nullptr;
  waiter.next_ = first_;
  (first_ == nullptr ? last_ : first_->prev_) = &waiter;
  first_ = &waiter;
  ++size_;
}

void WaitList::remove(LinkedWaiter& waiter) noexcept {
  (waiter.prev_ == nullptr ? first_ : waiter.prev_->next_) = waiter.next_;
  (waiter.next_ == nullptr ? last_ : waiter.next_->prev_) = waiter.prev_;
  waiter.list_ = nullptr;
  waiter.prev_ = waiter.next_ = nullptr;
  --size_;
}

}  // namespace verstat::sim::detail
