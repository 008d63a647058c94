#pragma once
// Refining a plan by simulation: a sequence of deterministic problems, each the average of a larger sample.

#include <cstdint>
#include <functional>
#include <vector>

#include "optimize/search.h"

namespace verstat::optimize {

/// rows[r][c]: column c (a KPI) in replication first + r, NaN where it has no value. The same replication
/// uses the same random numbers at every point.
using Rows = std::vector<std::vector<double>>;
using Sampler = std::function<Rows(const std::vector<double>& x, std::int64_t first, std::int64_t count)>;

/// A constraint on the mean of a column, to be met with confidence.
struct NoisyConstraint {
  std::size_t column = 0;
  bool at_most = true;
  double allowed = 0;
  double confidence = 0.95;  ///< one-sided
};

struct NoisyProblem {
  std::vector<Dimension> dimensions;
  Sampler sample;
  std::size_t objective = 0;  ///< column
  double sign = 1;            ///< -1: the column is maximised
  std::vector<NoisyConstraint> constraints;
  /// Margins known without simulation; may be empty.
  std::function<std::vector<double>(const std::vector<double>& x)> exact_margins;
};

/// The objective (sign included) and the margins of a sample: noisy constraints first, each as the margin of
/// the confidence limit of the mean relative to the allowed value. Fewer than two values: undefined.
[[nodiscard]] Measured judge(const NoisyProblem& problem, const Rows& rows, const std::vector<double>& x);

/// What the confidence of each noisy constraint costs on this sample: the distance of the confidence limit
/// from the mean, relative to the allowed value.
[[nodiscard]] std::vector<double> confidence_allowances(const NoisyProblem& problem, const Rows& rows);

struct RefineOptions {
  std::int64_t trials = 60;  ///< points looked at, over all levels
  std::int64_t first_replications = 5;
  std::int64_t levels = 3;
  double neighbourhood = 0.1;  ///< half-width of the first box, of the bounds; halved at every level
  std::uint64_t seed = 1;
};

struct Refined {
  SearchResult best;
  std::int64_t replications = 0;        ///< behind it
  std::vector<SearchResult> finalists;  ///< the best of every level and start, best first, without doubles
};

/// Retrospective approximation: at level k the average of first_replications 2^k common replications is
/// minimised near the best of level k - 1 (Chen, Schmeiser, IIE Trans. 33 (2001) 259); replications already
/// made at a point are used again, not repeated. `starts` >= 1 points.
[[nodiscard]] Refined refine(const NoisyProblem& problem, const std::vector<std::vector<double>>& starts,
                             const RefineOptions& options);

}  // namespace verstat::optimize
