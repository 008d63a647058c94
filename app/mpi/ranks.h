#pragma once
// Replications on many machines: rank 0 runs the program, the other ranks simulate what it hands them, one
// replication at a time, whoever is free. A rank that does not answer is passed over and its work is done
// again.

#include <cstdint>

#include "sim/shop/run.h"

namespace verstat::app {

/// Of rank 0. Uses MPI from the calling thread only.
class Ranks {
 public:
  /// `size`: ranks of the job, this one included.
  explicit Ranks(int size);
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  /// What shop::run_replications gives, whatever the number of ranks. Throws what the simulation throws (as
  /// std::runtime_error with its text) and what `progress` throws.
  [[nodiscard]] shop::RunResult run(const scenarios::Scenario& scenario, std::uint64_t first,
                                    std::int64_t count, const shop::Progress& progress);
  /// Tells the others to end. False when a rank has not answered: then MPI cannot be finalized.
  [[nodiscard]] bool stop();

 private:
  struct State;
  State* state_;
};

/// What the other ranks do until they are told to end.
void serve_rank_0();

}  // namespace verstat::app
