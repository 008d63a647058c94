#pragma once
// A batch of parts on its way through the shop.

#include <array>
#include <cstdint>
#include <deque>
#include <limits>
#include <vector>

namespace verstat::shop {

/// Where the lead time of a batch goes.
enum class Phase : std::uint8_t {
  release,     ///< arrived, not yet let into the shop
  components,  ///< waiting for parts to assemble
  queue,       ///< waiting for a machine
  machine,     ///< on a machine: set-up, loading, work, stops
  blocked,     ///< finished there, the next place is full
  transport
};
inline constexpr std::size_t phases = 6;

struct Job {
  std::size_t part = 0;
  std::size_t step = 0;
  std::int64_t quantity = 1;
  std::int64_t defects = 0;      ///< parts among them with a hidden defect
  bool defects_assumed = false;  ///< an inspection took them from its own plan
  std::int64_t reworks = 0;
  double arrived_min = 0;
  double due_min = std::numeric_limits<double>::infinity();
  std::uint64_t number = 0;       ///< in order of arrival in the queue: first come, first served
  std::size_t on_its_way_to = 0;  ///< machine group of the present step
  std::size_t from = 0;           ///< group it came from, or supply or components: see limits.cpp
  std::array<double, phases> phase_min{};
  bool in_use = true;
  Phase phase = Phase::release;
  double since_min = 0;

  void enter(Phase next, double now_min) {
    phase_min[static_cast<std::size_t>(phase)] += now_min - since_min;
    phase = next;
    since_min = now_min;
  }
};

/// Batches come and go by the million: their memory is used again.
class JobPool {
 public:
  [[nodiscard]] Job* make() {
    if (free_.empty()) {
      all_.emplace_back();
      return &all_.back();
    }
    Job* job = free_.back();
    free_.pop_back();
    *job = Job();
    return job;
  }
  void give_back(Job* job) {
    job->in_use = false;
    free_.push_back(job);
  }
  template <class Visit>
  void for_each_in_use(Visit&& visit) const {
    for (const Job& job : all_)
      if (job.in_use) visit(job);
  }

 private:
  std::deque<Job> all_;
  std::vector<Job*> free_;
};

}  // namespace verstat::shop
