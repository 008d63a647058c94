#include "sim/kernel/resource.h"

#include <limits>
#include <utility>

namespace verstat::sim {

// ------------------------------------------------------------------------------------------------- Hold

Hold& Hold::operator=(Hold&& other) noexcept {
  if (this == &other) return *this;
  release();
  resource_ = std::exchange(other.resource_, nullptr);
  units_ = other.units_;
  priority_ = other.priority_;
  owner_ = std::move(other.owner_);
  granted_to_ = std::exchange(other.granted_to_, nullptr);
  prev_ = std::exchange(other.prev_, nullptr);
  next_ = std::exchange(other.next_, nullptr);
  if (resource_ != nullptr) {
    (prev_ == nullptr ? resource_->last_hold_ : prev_->next_) = this;
    if (next_ != nullptr) next_->prev_ = this;
  }
  return *this;
}

void Hold::release() noexcept {
  if (resource_ != nullptr) resource_->give_back(*this);
}

void Hold::link(Resource& resource) noexcept {
  resource_ = &resource;
  prev_ = nullptr;
  next_ = resource.last_hold_;
  if (next_ != nullptr) next_->prev_ = this;
  resource.last_hold_ = this;
}

void Hold::unlink() noexcept {
  (prev_ == nullptr ? resource_->last_hold_ : prev_->next_) = next_;
  if (next_ != nullptr) next_->prev_ = prev_;
  prev_ = next_ = nullptr;
  resource_ = nullptr;
  granted_to_ = nullptr;
  owner_ = detail::ProcessRef();
}

// ---------------------------------------------------------------------------------------------- Acquire

Acquire::Acquire(Resource& resource, int units, int priority, bool preempting)
    : Awaitable(*resource.sim_),
      resource_(&resource),
      units_(units),
      priority_(priority),
      preempting_(preempting),
      since_(resource.sim_->now()) {
  if (units < 1) {
    throw SimulationError(resource.sim_->where() + "resource " + resource.name() + ": request for " +
                          std::to_string(units) + " units, must be >= 1");
  }
}

bool Acquire::try_now() {
  process_ = detail::ProcessRef(engine_->current()->process);
  if (!resource_->first_in_line(priority_)) return false;
  if (!resource_->fits(units_) && !(preempting_ && resource_->make_room(*this))) return false;
  resource_->grant(hold_, units_, priority_, std::move(process_));
  return true;
}

void Acquire::begin() {
  resource_->enqueue(*this, false);
}

void Acquire::served() {
  resource_->grant(hold_, units_, priority_, process_);
  hold_.granted_to_ = this;
  notify();
}

void Acquire::withdraw() noexcept {
  cancel_event();
  if (linked()) {
    unlink();
    resource_->note_queue();
    resource_->serve_queue();  // somebody who needs fewer units may now be first
  } else {
    hold_.release();
  }
}

Hold Acquire::take() {
  if (!hold_) {
    throw SimulationError(engine_->where() + "a resource was destroyed between grant and waking");
  }
  if (resource_->statistics_) resource_->statistics_->wait.add(engine_->now() - since_);
  hold_.granted_to_ = nullptr;
  return std::move(hold_);
}

// --------------------------------------------------------------------------------------------- Resource

Resource::Resource(Simulation& sim, std::string_view name, int capacity)
    : sim_(&sim), name_(name), capacity_(capacity) {
  if (capacity < 0) {
    throw SimulationError("resource " + name_ + ": capacity is " + std::to_string(capacity) +
                          ", must be >= 0");
  }
}

Resource::~Resource() {
  while (last_hold_ != nullptr) last_hold_->unlink();
}

Hold Resource::try_acquire(int units, int priority) {
  if (units < 1) {
    throw SimulationError(sim_->where() + "resource " + name_ + ": request for " + std::to_string(units) +
                          " units, must be >= 1");
  }
  Hold hold;
  if (first_in_line(priority) && fits(units)) {
    detail::PromiseBase* current = sim_->current();
    grant(hold, units, priority, detail::ProcessRef(current == nullptr ? nullptr : current->process));
    if (statistics_) statistics_->wait.add(0.0);
  }
  return hold;
}

void Resource::set_capacity(int capacity, OnShrink policy) {
  if (capacity < 0) {
    throw SimulationError(sim_->where() + "resource " + name_ + ": capacity is " + std::to_string(capacity) +
                          ", must be >= 0");
  }
  capacity_ = capacity;
  if (policy == OnShrink::preempt) {
    evicting_ = true;
    while (in_use_ > capacity_) {
      Hold* victim = least_urgent_hold(std::numeric_limits<int>::min());
      if (victim == nullptr) break;
      evict(*victim);
    }
    evicting_ = false;
  }
  serve_queue();
}

void Resource::enable_statistics() {
  statistics_ = std::make_unique<QueueStatistics>(sim_->now());
  note_queue();
  note_level();
  statistics_->reset(sim_->now());
}

bool Resource::first_in_line(int priority) const noexcept {
  const auto* front = static_cast<const Acquire*>(queue_.front());
  return front == nullptr || front->priority_ > priority;
}

void Resource::grant(Hold& hold, int units, int priority, detail::ProcessRef owner) {
  hold.units_ = units;
  hold.priority_ = priority;
  hold.owner_ = std::move(owner);
  hold.link(*this);
  in_use_ += units;
  note_level();
}

void Resource::give_back(Hold& hold) noexcept {
  in_use_ -= hold.units_;
  hold.unlink();
  note_level();
  serve_queue();
}

void Resource::serve_queue() {
  if (evicting_ || sim_->closing()) return;
  while (auto* front = static_cast<Acquire*>(queue_.front())) {
    if (!fits(front->units_) && !(front->preempting_ && make_room(*front))) return;
    front->unlink();
    note_queue();
    front->served();
  }
}

void Resource::enqueue(Acquire& request, bool in_front) {
  if (in_front) {
    queue_.push_front(request, request.priority_);
  } else {
    queue_.push_back(request, request.priority_);
  }
  note_queue();
}

Hold* Resource::least_urgent_hold(int than) const noexcept {
  // The process that is executing cannot lose what it holds: it is in no wait that could tell it.
  const detail::PromiseBase* current = sim_->current();
  Hold* found = nullptr;
  for (Hold* hold = last_hold_; hold != nullptr; hold = hold->next_) {
    const bool own = current != nullptr && hold->owner_.get() == current->process;
    if (!own && hold->priority_ > than && (found == nullptr || hold->priority_ > found->priority_))
      found = hold;
  }
  return found;
}

bool Resource::make_room(const Acquire& request) {
  int obtainable = capacity_ - in_use_;
  const detail::PromiseBase* current = sim_->current();
  for (const Hold* hold = last_hold_; hold != nullptr; hold = hold->next_) {
    const bool own = current != nullptr && hold->owner_.get() == current->process;
    if (!own && hold->priority_ > request.priority_) obtainable += hold->units_;
  }
  if (obtainable < request.units_) return false;
  evicting_ = true;
  while (!fits(request.units_)) {
    Hold* victim = least_urgent_hold(request.priority_);
    if (victim == nullptr) break;
    evict(*victim);
  }
  evicting_ = false;
  return fits(request.units_);
}

void Resource::evict(Hold& hold) {
  in_use_ -= hold.units_;
  Acquire* request = hold.granted_to_;
  const detail::ProcessRef owner = hold.owner_;
  hold.unlink();
  note_level();
  if (request != nullptr && !request->is_branch()) {
    // It has not woken up yet: back to the head of the queue, as if it had never been granted.
    request->cancel_event();
    enqueue(*request, true);
  } else if (owner.get() != nullptr) {
    owner->interrupt(Reason(Reason::preempted, "pre-empted from " + name_));
  }
}

}  // namespace verstat::sim
