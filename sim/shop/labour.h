#pragma once
// The people of the shop: crews answer calls by name or by skill, the most urgent call first.

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/calendar.h"
#include "scenarios/scenario.h"
#include "sim/kernel/event.h"
#include "sim/kernel/simulation.h"
#include "sim/shop/costs.h"

namespace verstat::shop {

class Labour;
class Trace;

/// A member of a crew at work. Gives the member back when it goes out of scope.
class [[nodiscard]] CrewHold {
 public:
  CrewHold() = default;
  CrewHold(CrewHold&& other) noexcept { *this = std::move(other); }
  CrewHold& operator=(CrewHold&& other) noexcept;
  ~CrewHold() { release(); }
  void release() noexcept;
  [[nodiscard]] explicit operator bool() const noexcept { return labour_ != nullptr; }
  /// Index of the crew; only while something is held.
  [[nodiscard]] std::size_t crew() const;
  /// Minutes that the member walks to get there.
  [[nodiscard]] double walking_min() const;

 private:
  friend class Labour;
  Labour* labour_ = nullptr;
  std::size_t job_ = 0;
};

/// Calls are served in order of (priority, time of the call): the first whose crew has a free member goes
/// first. A member who tends machines (`machines_per_member` > 1) has that many hands; attending a machine
/// takes one, everything else takes all of them. Who works when the shift ends finishes the job.
class Labour {
 public:
  /// Wages of crews that are paid for the minutes worked are booked in `costs`.
  Labour(const scenarios::Scenario& scenario, sim::Simulation& sim, Costs& costs);
  Labour(const Labour&) = delete;
  Labour& operator=(const Labour&) = delete;

  enum class Hands { all, one };
  /// Crews that answer to the name of a crew or of a skill, in the order of the scenario.
  [[nodiscard]] std::vector<std::size_t> crews_for(const std::string& crew_or_skill) const;

  /// Nobody's machine.
  static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
  /// `auto hold = co_await labour.call(...)`; the wage is booked under `heading`. `crews` must outlive the
  /// call. `machine` is where they are wanted.
  [[nodiscard]] sim::Task<CrewHold> call(const std::vector<std::size_t>& crews, std::int64_t priority,
                                         Cost heading, Hands hands = Hands::all,
                                         std::size_t machine = nowhere);

  /// Whether a member of one of the crews is at the machine.
  [[nodiscard]] bool present(std::size_t machine, const std::vector<std::size_t>& crews) const;

  /// The shift of the machine ends with a part in it: whoever tends it goes home and comes back to it. What
  /// was done up to now is booked; the hands stay promised to the machine.
  void leave(std::size_t machine) { away(machine, true); }
  void come_back(std::size_t machine) { away(machine, false); }

  /// A machine that keeps a member of one crew while it waits for another.
  struct Wait {
    std::size_t machine;
    std::size_t keeps;
    std::size_t wants;
  };
  /// Set by the shop: told once when machines wait for people whom they keep from each other for good.
  std::function<void(const std::vector<Wait>&)> on_standstill;

  /// Nobody is served any more: processes are ended in any order, and holds among them go out of scope.
  void close() noexcept { closed_ = true; }
  /// From now on `trace`, unless null, is told who worked where; it must outlive the crews.
  void record(Trace* trace) noexcept { trace_ = trace; }
  /// Starts the processes that open and close shifts.
  void start();
  void reset_counts(double now_min);
  /// Books the work under way up to now.
  void settle(double now_min);
  /// Member-minutes of work since the last reset.
  [[nodiscard]] double busy_min(std::size_t crew) const { return crews_[crew].busy_min; }
  /// Of those, minutes after the end of the shift.
  [[nodiscard]] double overtime_min(std::size_t crew) const { return crews_[crew].overtime_min; }
  /// Member-minutes of presence from `from_min` to `to_min`.
  [[nodiscard]] double present_min(std::size_t crew, double from_min, double to_min) const;

 private:
  friend class CrewHold;
  struct Crew {
    const scenarios::Crew* spec = nullptr;
    std::optional<scenarios::WorkingTime> working_time;
    std::int64_t hands = 0;  // there are, on shift
    std::int64_t hands_in_use = 0;
    double busy_min = 0;
    double overtime_min = 0;
  };
  struct Call {
    Call(sim::Simulation& sim, const std::vector<std::size_t>& asked, std::int64_t urgency, Cost cost,
         Hands h, std::size_t where)
        : crews(&asked), priority(urgency), heading(cost), hands(h), machine(where), granted(sim) {}
    const std::vector<std::size_t>* crews;
    std::int64_t priority;
    Cost heading;
    Hands hands;
    std::size_t machine;
    sim::Event<std::size_t> granted;  // number of the job
  };
  struct Job {
    std::size_t crew = 0;
    std::int64_t hands = 0;
    Cost heading = Cost::labour;
    std::size_t machine = nowhere;
    double since_min = 0;
    bool active = false;
    bool away = false;
  };
  [[nodiscard]] sim::Task<void> shifts(std::size_t crew);
  [[nodiscard]] std::int64_t hands_needed(std::size_t crew, Hands hands) const;
  [[nodiscard]] std::optional<std::size_t> free_crew(const Call& call) const;
  [[nodiscard]] std::size_t begin(std::size_t crew, const Call& call);
  void book(Job& job, double now_min);
  void finish(std::size_t job) noexcept;
  void serve();
  void away(std::size_t machine, bool now_away);
  void look_for_standstill(const Call& latest) const;

  sim::Simulation* sim_;
  Costs* costs_;
  Trace* trace_ = nullptr;
  bool closed_ = false;
  std::vector<Crew> crews_;
  std::vector<Job> jobs_;
  std::vector<std::size_t> free_jobs_;
  std::vector<std::int64_t> jobs_at_;  // by machine
  std::deque<Call*> waiting_;          // by priority, then by time of the call
};

}  // namespace verstat::shop
