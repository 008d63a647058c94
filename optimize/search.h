#pragma once
// NLopt behind one door: bounded minimisation with our own incumbent, seeds and limits.
//
// Debian's NLopt 2.7.1 may return the last or an infeasible point, calls a NaN a success, and seeds itself
// per thread: so every variable is scaled to [0, 1], every evaluation is kept, and the best one is the
// answer.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace verstat::optimize {

struct Bounds {
  double low = 0;
  double high = 1;
};

struct Evaluation {
  std::vector<double> x;
  double value = 0;  ///< infinity where the objective is undefined
};

struct SearchOptions {
  /// Empty: global DIRECT-L over the box, then local searches by BOBYQA (Sbplx for one variable) from the
  /// best point and from the start. Else the name of one NLopt algorithm without derivatives, such as
  /// "LN_COBYLA".
  std::string algorithm;
  int max_evaluations = 4000;
  double relative_precision = 1e-8;  ///< of the variables, relative to their bounds
  std::uint64_t seed = 1;
};

struct SearchResult {
  Evaluation best;
  std::vector<Evaluation> evaluations;  ///< all, in order
};

using Objective = std::function<double(const std::vector<double>&)>;

/// Minimises `objective` over the box from `start` (inside the box). Deterministic: the same arguments give
/// the same evaluations. What `objective` throws comes out unchanged. Throws std::invalid_argument for an
/// unknown algorithm or one that needs derivatives, naming it.
[[nodiscard]] SearchResult minimize(const Objective& objective, const std::vector<Bounds>& bounds,
                                    const std::vector<double>& start, const SearchOptions& options);

/// True when `algorithm` can be given to SearchOptions.
[[nodiscard]] bool known_algorithm(const std::string& algorithm);

}  // namespace verstat::optimize
