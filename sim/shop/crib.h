#pragma once
// The tool crib: a shelf of inserts that is filled by orders.

#include <cstdint>
#include <string>

#include "scenarios/tooling.h"
#include "sim/kernel/container.h"
#include "sim/kernel/distribution.h"
#include "sim/kernel/random_stream.h"
#include "sim/kernel/simulation.h"
#include "sim/kernel/tally.h"

namespace verstat::shop {

/// Stock of one insert under continuous review: when shelf + orders under way - inserts owed falls to the
/// reorder point, the least multiple of `order_quantity` that lifts it above is ordered. Requests are served
/// in turn.
class InsertCrib {
 public:
  InsertCrib(sim::Simulation& sim, const scenarios::InsertStock& spec, const std::string& insert,
             std::uint64_t seed, std::uint64_t replication);
  InsertCrib(const InsertCrib&) = delete;
  InsertCrib& operator=(const InsertCrib&) = delete;

  /// True when a request for `inserts` would wait.
  [[nodiscard]] bool would_wait(std::int64_t inserts) const;
  /// Hands out `inserts`, waiting until they are there.
  [[nodiscard]] sim::Task<void> issue(std::int64_t inserts);

  /// Since the last reset.
  struct Counts {
    std::int64_t stock_at_start = 0;
    std::int64_t requests = 0;
    std::int64_t stock_outs = 0;  ///< requests that waited
    std::int64_t issued = 0;
    std::int64_t delivered = 0;
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::int64_t stock() const { return static_cast<std::int64_t>(shelf_.level()); }
  /// Mean number of inserts on the shelf since the last reset.
  [[nodiscard]] double mean_stock() const { return mean_stock_.mean(sim_->now()); }
  void reset_counts();

 private:
  [[nodiscard]] sim::Task<void> deliver(std::int64_t inserts, double lead_min);

  sim::Simulation* sim_;
  const scenarios::InsertStock* spec_;
  sim::Container shelf_;
  sim::Distribution lead_time_;
  sim::RandomStream lead_stream_;
  std::int64_t position_;  // shelf + ordered - owed
  sim::TimeWeighted mean_stock_;
  Counts counts_;
};

}  // namespace verstat::shop
