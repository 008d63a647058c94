#include "sim/kernel/process_state.h"

namespace verstat::sim::detail {

ProcessState* ProcessState::spawn(Engine& engine, std::string_view name, int priority, PromiseBase* root) {
  ProcessState* state = engine.spare_;
  if (state != nullptr) {
    engine.spare_ = std::exchange(state->next_, nullptr);
  } else {
    state = new ProcessState;
  }
  state->engine_ = &engine;
  state->name_.assign(name);
  state->root_ = state->leaf_ = root;
  state->status_ = ProcessStatus::waiting_to_start;
  state->abandoned_ = false;
  state->owner_ = nullptr;
  state->interrupt_at_first_wait_ = false;
  state->references_ = 1;  // the kernel's own, until the end
  state->id_ = ++engine.spawned_;
  state->error_ = nullptr;
  root->process = state;
  state->link(engine.live_);
  state->event_ = priority == 0 ? engine.push_now(state) : engine.push(engine.now(), priority, state);
  return state;
}

void ProcessState::fire() {
  event_ = 0;
  if (abandoned_) {
    end(ProcessStatus::cancelled);
  } else if (status_ == ProcessStatus::waiting_to_start) {
    status_ = ProcessStatus::running;
    if (interrupt_at_first_wait_) event_ = engine_->push_now(this);
    engine_->follow(root_);
  } else {
    interrupt(std::exchange(reason_, Reason()));
  }
}

bool ProcessState::interrupt(Reason reason) {
  if (ended()) return false;
  if (status_ == ProcessStatus::waiting_to_start) {
    if (interrupt_at_first_wait_) return false;
    interrupt_at_first_wait_ = true;
    reason_ = std::move(reason);
    return true;
  }
  Waiter* waiter = leaf_->waiter;
  if (executing_process() == this || waiter == nullptr) {
    throw SimulationError(engine_->where() + "a process cannot interrupt itself");
  }
  if (waiter->interrupted()) return false;
  reason_ = std::move(reason);
  waiter->interrupt();
  return true;
}

bool ProcessState::cancel() {
  if (ended()) return false;
  for (ProcessState* part = executing_process(); part != nullptr; part = part->owner_) {
    if (part == this) {
      throw SimulationError(engine_->where() + "a process cannot cancel itself; it can co_return");
    }
  }
  end(ProcessStatus::cancelled);
  return true;
}

void ProcessState::abandon() noexcept {
  if (ended() || abandoned_) return;
  if (executing_process() != this) {
    end(ProcessStatus::cancelled);
    return;
  }
  abandoned_ = true;
  if (event_ != 0) engine_->cancel(event_);
  event_ = engine_->push_now(this);
}

ProcessState* ProcessState::executing_process() const noexcept {
  return engine_->current() == nullptr ? nullptr : engine_->current()->process;
}

void ProcessState::end(ProcessStatus status) noexcept {
  status_ = status;
  if (event_ != 0) engine_->cancel(std::exchange(event_, 0));
  if (leaf_->waiter != nullptr) std::exchange(leaf_->waiter, nullptr)->withdraw();
  leaf_ = nullptr;
  // Destroys the locals of the process, called tasks first. They may give back resources, cancel others.
  std::exchange(root_, nullptr)->self.destroy();
  if (!engine_->closing()) {
    while (!joiners_.empty()) joiners_.pop_front().served();
  }
  unlink(engine_->live_);
  link(engine_->ended_);
  drop_reference();
}

std::exception_ptr ProcessState::finish() {
  error_ = root_->error;
  const bool to_run = error_ && owner_ == nullptr;
  std::exception_ptr escaping = to_run ? error_ : nullptr;
  end(error_ ? ProcessStatus::failed : ProcessStatus::done);
  return escaping;
}

void ProcessState::link(ProcessState*& head) noexcept {
  prev_ = nullptr;
  next_ = head;
  if (head != nullptr) head->prev_ = this;
  head = this;
}

void ProcessState::unlink(ProcessState*& head) noexcept {
  (prev_ == nullptr ? head : prev_->next_) = next_;
  if (next_ != nullptr) next_->prev_ = prev_;
  prev_ = next_ = nullptr;
}

void ProcessState::drop_reference() noexcept {
  if (--references_ != 0) return;
  error_ = nullptr;
  if (engine_ == nullptr) {
    delete this;
    return;
  }
  unlink(engine_->ended_);
  next_ = engine_->spare_;
  engine_->spare_ = this;
}

void ProcessState::end_all(Engine& engine) noexcept {
  engine.closing_ = true;
  // Waits first, frames after: nobody is handed anything by a dying process.
  for (ProcessState* state = engine.live_; state != nullptr; state = state->next_) {
    if (state->leaf_->waiter != nullptr) std::exchange(state->leaf_->waiter, nullptr)->withdraw();
  }
  while (engine.live_ != nullptr) engine.live_->end(ProcessStatus::cancelled);
  // Handles may outlive the simulation.
  while (engine.ended_ != nullptr) {
    ProcessState* state = engine.ended_;
    state->unlink(engine.ended_);
    state->engine_ = nullptr;
  }
  while (engine.spare_ != nullptr) {
    ProcessState* state = engine.spare_;
    engine.spare_ = state->next_;
    delete state;
  }
}

}  // namespace verstat::sim::detail
