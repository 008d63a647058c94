#include "sim/shop/labour.h"

#include <algorithm>
#include <utility>

#include "sim/shop/trace.h"

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
                  .machine = call.machine,
                  .since_min = sim_->now(),
                  .active = true};
  crews_[crew].hands_in_use += jobs_[index].hands;
  if (call.machine != nowhere) {
    if (jobs_at_.size() <= call.machine) jobs_at_.resize(call.machine + 1);
    ++jobs_at_[call.machine];
  }
  return index;
}

bool Labour::present(std::size_t machine, const std::vector<std::size_t>& crews) const {
  if (machine >= jobs_at_.size() || jobs_at_[machine] == 0) return false;
  return std::any_of(jobs_.begin(), jobs_.end(), [&](const Job& job) {
    return job.active && job.machine == machine &&
           std::find(crews.begin(), crews.end(), job.crew) != crews.end();
  });
}

sim::Task<CrewHold> Labour::call(const std::vector<std::size_t>& crews, std::int64_t priority, Cost heading,
                                 Hands hands, std::size_t machine) {
  Call call(*sim_, crews, priority, heading, hands, machine);
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
    if (on_standstill && machine != nowhere) look_for_standstill(call);
    job = co_await call.granted.wait();
  }
  hold.labour_ = this;
  hold.job_ = job;
  co_return hold;
}

// A call is answered one day when some crew has hands enough that are not kept by machines which wait in vain
// themselves. Starting with all that wait, those are taken out until nothing changes; who is left waits for
// good.
void Labour::look_for_standstill(const Call& latest) const {
  const auto kept_at = [&](std::size_t machine) {
    return std::find_if(jobs_.begin(), jobs_.end(),
                        [&](const Job& job) { return job.active && job.machine == machine; });
  };
  if (kept_at(latest.machine) == jobs_.end()) return;  // nobody waits for this machine's people
  std::vector<const Call*> stuck(waiting_.begin(), waiting_.end());
  const auto is_stuck = [&](std::size_t machine) {
    return machine != nowhere && std::any_of(stuck.begin(), stuck.end(),
                                             [&](const Call* call) { return call->machine == machine; });
  };
  const auto answered = [&](const Call* call) {
    return std::any_of(call->crews->begin(), call->crews->end(), [&](std::size_t k) {
      std::int64_t hands = crews_[k].spec->members * crews_[k].spec->machines_per_member;
      for (const Job& job : jobs_)
        if (job.active && job.crew == k && is_stuck(job.machine)) hands -= job.hands;
      return hands >= hands_needed(k, call->hands);
    });
  };
  while (true) {
    const auto helped = std::find_if(stuck.begin(), stuck.end(), answered);
    if (helped == stuck.end()) break;
    stuck.erase(helped);
  }
  if (!is_stuck(latest.machine)) return;
  std::vector<Wait> waits;
  for (const Call* call : stuck)
    if (const auto kept = kept_at(call->machine); call->machine != nowhere && kept != jobs_.end())
      waits.push_back({call->machine, kept->crew, call->crews->front()});
  on_standstill(waits);
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

void Labour::away(std::size_t machine, bool now_away) {
  if (machine >= jobs_at_.size() || jobs_at_[machine] == 0) return;
  for (Job& job : jobs_)
    if (job.active && job.machine == machine) {
      book(job, sim_->now());
      job.away = now_away;
    }
}

void Labour::book(Job& job, double now_min) {
  if (job.away) {
    job.since_min = now_min;
    return;
  }
  Crew& crew = crews_[job.crew];
  const double member_min = (now_min - job.since_min) * static_cast<double>(job.hands) /
                            static_cast<double>(crew.spec->machines_per_member);
  crew.busy_min += member_min;
  if (crew.working_time && now_min > job.since_min)
    crew.overtime_min +=
        member_min * (1 - crew.working_time->working_min(job.since_min, now_min) / (now_min - job.since_min));
  if (crew.spec->pay == scenarios::CrewPay::busy)
    costs_->book(job.heading, member_min * crew.spec->rate_per_min);
  if (trace_ != nullptr && now_min > job.since_min)
    trace_->crew_work({.crew = job.crew,
                       .hands = job.hands,
                       .heading = job.heading,
                       .machine = job.machine == nowhere ? std::nullopt : std::optional(job.machine),
                       .from_min = job.since_min,
                       .to_min = now_min});
  job.since_min = now_min;
}

void Labour::finish(std::size_t index) noexcept {
  if (closed_) return;
  Job& job = jobs_[index];
  book(job, sim_->now());
  job.active = false;
  if (job.machine != nowhere) --jobs_at_[job.machine];
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
  for (Crew& crew : crews_) {
    crew.busy_min = 0;
    crew.overtime_min = 0;
  }
}

double Labour::present_min(std::size_t k, double from_min, double to_min) const {
  const Crew& crew = crews_[k];
  const double open_min =
      crew.working_time ? crew.working_time->working_min(from_min, to_min) : to_min - from_min;
  return open_min * static_cast<double>(crew.spec->members);
}

}  // namespace verstat::shop
