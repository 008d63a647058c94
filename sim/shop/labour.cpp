#include "sim/shop/labour.h"

#include <algorithm>
#include <utility>

namespace verstat::shop {

CrewHold& CrewHold::operator=(CrewHold&& other) noexcept {
  if (this == &other) return *this;
  release();
  labour_ = std::exchange(other.labour_, nullptr);
  job_ = other.job_;
  return *this;
}

void CrewHold::release() noexcept {
  if (labour_ != nullptr) std::exchange(labour_, nullptr)->finish(job_);
}

std::size_t CrewHold::crew() const {
  return labour_->jobs_[job_].crew;
}

double CrewHold::walking_min() const {
  return labour_ == nullptr ? 0 : labour_->crews_[labour_->jobs_[job_].crew].spec->walking_min;
}

Labour::Labour(const scenarios::Scenario& scenario, sim::Simulation& sim, Costs& costs)
    : sim_(&sim), costs_(&costs) {
  for (const scenarios::Crew& spec : scenario.crews) {
    Crew crew{.spec = &spec, .hands = spec.members * spec.machines_per_member};
    if (const auto* calendar = scenarios::find_named(scenario.calendars, spec.calendar))
      crew.working_time.emplace(*calendar);
    crews_.push_back(std::move(crew));
  }
}

std::vector<std::size_t> Labour::crews_for(const std::string& crew_or_skill) const {
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < crews_.size(); ++k) {
    const scenarios::Crew& spec = *crews_[k].spec;
    if (spec.name == crew_or_skill ||
        std::find(spec.skills.begin(), spec.skills.end(), crew_or_skill) != spec.skills.end())
      found.push_back(k);
  }
  return found;
}

void Labour::start() {
  for (std::size_t k = 0; k < crews_.size(); ++k)
    if (crews_[k].working_time) sim_->spawn("shifts of " + crews_[k].spec->name, shifts(k));
}

sim::Task<void> Labour::shifts(std::size_t k) {
  Crew& crew = crews_[k];
  const std::int64_t all = crew.spec->members * crew.spec->machines_per_member;
  for (;;) {
    crew.hands = crew.working_time->open(sim_->now()) ? all : 0;
    serve();
    const double change_min = crew.working_time->next_change_min(sim_->now());
    co_await sim_->delay(change_min - sim_->now());
  }
}

std::int64_t Labour::hands_needed(std::size_t crew, Hands hands) const {
  return hands == Hands::one ? 1 : crews_[crew].spec->machines_per_member;
}

std::optional<std::size_t> Labour::free_crew(const Call& call) const {
  for (const std::size_t k : *call.crews)
    if (crews_[k].hands_in_use + hands_needed(k, call.hands) <= crews_[k].hands) return k;
  return std::nullopt;
}

std::size_t Labour::begin(std::size_t crew, const Call& call) {
  std::size_t index = jobs_.size();
  if (free_jobs_.empty()) {
    jobs_.emplace_back();
  } else {
    index = free_jobs_.back();
    free_jobs_.pop_back();
  }
  jobs_[index] = {.crew = crew,
                  .hands = hands_needed(crew, call.hands),
                  .heading = call.heading,
                  .since_min = sim_->now(),
                  .active = true};
  crews_[crew].hands_in_use += jobs_[index].hands;
  return index;
}

sim::Task<CrewHold> Labour::call(const std::vector<std::size_t>& crews, std::int64_t priority, Cost heading,
                                 Hands hands) {
  Call call(*sim_, crews, priority, heading, hands);
  // Whoever waits for the same people and is at least as urgent has been served already: serve() leaves
  // nobody waiting who could be served.
  CrewHold hold;
  std::size_t job = 0;
  if (const auto crew = free_crew(call)) {
    job = begin(*crew, call);
  } else {
    const auto behind = std::find_if(waiting_.begin(), waiting_.end(),
                                     [&](const Call* other) { return other->priority > priority; });
    waiting_.insert(behind, &call);
    job = co_await call.granted.wait();
  }
  hold.labour_ = this;
  hold.job_ = job;
  co_return hold;
}

void Labour::serve() {
  for (auto it = waiting_.begin(); it != waiting_.end();) {
    if (const auto crew = free_crew(**it)) {
      Call& call = **it;
      it = waiting_.erase(it);
      call.granted.succeed(begin(*crew, call));
    } else {
      ++it;
    }
  }
}

void Labour::book(Job& job, double now_min) {
  Crew& crew = crews_[job.crew];
  const double member_min = (now_min - job.since_min) * static_cast<double>(job.hands) /
                            static_cast<double>(crew.spec->machines_per_member);
  crew.busy_min += member_min;
  if (crew.spec->pay == scenarios::CrewPay::busy)
    costs_->book(job.heading, member_min * crew.spec->rate_per_min);
  job.since_min = now_min;
}

void Labour::finish(std::size_t index) noexcept {
  if (closed_) return;
  Job& job = jobs_[index];
  book(job, sim_->now());
  job.active = false;
  crews_[job.crew].hands_in_use -= job.hands;
  free_jobs_.push_back(index);
  serve();
}

void Labour::settle(double now_min) {
  for (Job& job : jobs_)
    if (job.active) book(job, now_min);
}

void Labour::reset_counts(double now_min) {
  settle(now_min);
  for (Crew& crew : crews_) crew.busy_min = 0;
}

double Labour::present_min(std::size_t k, double from_min, double to_min) const {
  const Crew& crew = crews_[k];
  const double open_min =
      crew.working_time ? crew.working_time->working_min(from_min, to_min) : to_min - from_min;
  return open_min * static_cast<double>(crew.spec->members);
}

}  // namespace verstat::shop
