#pragma once
// Choosing the best of a few noisy systems with a stated probability of being right.

#include <cstdint>
#include <functional>
#include <vector>

namespace verstat::optimize {

/// Values of a system in `count` replications from number `first` on. Replications of the same number may be
/// correlated between systems (common random numbers).
using SystemSampler =
    std::function<std::vector<double>(std::size_t system, std::int64_t first, std::int64_t count)>;

struct RankingOptions {
  double confidence = 0.95;              ///< probability of the correct selection, in (1/k, 1)
  double indifference = 0;               ///< > 0: differences below it do not matter, in units of the value
  std::int64_t first_replications = 10;  ///< >= 3
  std::int64_t max_replications = 1000;  ///< of any system
  std::int64_t batch = 1;                ///< replications taken at a time after the first
};

struct RankedSystem {
  double mean = 0;
  double half_width = 0;  ///< of the mean, Student, at the confidence asked for
  std::int64_t replications = 0;
  bool survived = true;  ///< false: eliminated as inferior
};

struct Ranking {
  std::size_t best = 0;  ///< the system chosen: the smallest mean of the survivors
  bool decided = false;  ///< false: the budget ended first, and the probability is not guaranteed
  std::vector<RankedSystem> systems;
};

/// The smallest mean of `systems` >= 1 systems. Fully sequential: after a first sample of every system one
/// more replication is taken of each survivor until one is left, eliminating on the way what falls behind.
/// When the values are normal, and the best is better than the others by at least `indifference`, the best is
/// chosen with at least the stated probability, also under common random numbers.
/// Procedure KN with c = 1: Kim, Nelson, ACM Trans. Model. Comput. Simul. 11 (2001) 251. With batches it
/// eliminates at the ends of batches only, which keeps the guarantee.
/// Throws std::invalid_argument for options outside their ranges.
[[nodiscard]] Ranking select_smallest(std::size_t systems, const SystemSampler& sample,
                                      const RankingOptions& options);

}  // namespace verstat::optimize
