#pragma once
// From simulated numbers to statements: confidence intervals, warm-up, batches, comparisons.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "sim/kernel/tally.h"

namespace verstat::sim {

/// `mean` +- `half_width` with the stated confidence.
struct ConfidenceInterval {
  double mean = 0.0;
  double half_width = 0.0;
  double confidence = 0.95;

  [[nodiscard]] double low() const noexcept { return mean - half_width; }
  [[nodiscard]] double high() const noexcept { return mean + half_width; }
  [[nodiscard]] bool contains(double x) const noexcept { return low() <= x && x <= high(); }
  /// Half width over |mean|; infinity when the mean is 0.
  [[nodiscard]] double relative_half_width() const noexcept;
};

/// Two-sided quantile of Student's t: P(|T| <= t) = confidence, for `degrees` >= 1 of freedom.
[[nodiscard]] double student_t(double confidence, std::uint64_t degrees);

/// Student interval of the mean of independent observations (at least 2), 0 < confidence < 1; else
/// std::invalid_argument.
[[nodiscard]] ConfidenceInterval confidence_interval(const Tally& tally, double confidence = 0.95);

/// Interval of the mean difference a - b of two variants run under common random numbers: a[i] and b[i] come
/// from the same replication. At least 2 pairs, as many of each; else std::invalid_argument.
[[nodiscard]] ConfidenceInterval paired_difference(std::span<const double> a, std::span<const double> b,
                                                   double confidence = 0.95);

/// Interval of a probability.
struct ProbabilityInterval {
  double low = 0.0;
  double high = 1.0;
};
/// Wilson's score interval (J. Am. Stat. Assoc. 22 (1927) 209) of the probability of an event that came
/// `successes` times in `trials` independent trials: within 0 and 1 and close to its confidence even when
/// nothing or everything succeeds. 0 <= successes <= trials, trials >= 1, 0 < confidence < 1; else
/// std::invalid_argument.
[[nodiscard]] ProbabilityInterval wilson_interval(std::int64_t successes, std::int64_t trials,
                                                  double confidence = 0.95);

/// Splits a stationary series into `batches` >= 2 runs of equal length (what is left over at the start is
/// dropped) and returns the tally of their means, from which confidence_interval follows.
[[nodiscard]] Tally batch_means(std::span<const double> series, std::size_t batches);

/// How many observations to drop as warm-up.
struct Truncation {
  std::size_t drop = 0;   ///< observations to drop from the start
  bool reliable = false;  ///< false when the minimum lies in the second half: the run is too short
};

/// MSER-5 (White, Cobb, Spratt, WSC 2000, 755): averages groups of five, then drops as many as minimise the
/// marginal standard error of what is left. Needs at least 10 observations; else std::invalid_argument.
[[nodiscard]] Truncation mser5(std::span<const double> series);

/// Batch means of a series of unknown length in bounded memory: batches are joined in pairs whenever there
/// are `2 * target`, so that between `target` and 2 `target` complete batches remain.
class BatchMeans {
 public:
  /// `target` >= 2 batches at least in the end.
  explicit BatchMeans(std::size_t target = 20);
  void add(double x);
  /// Tally of the means of the complete batches.
  [[nodiscard]] Tally batches() const;
  [[nodiscard]] std::uint64_t batch_size() const noexcept { return batch_size_; }

 private:
  std::size_t target_;
  std::uint64_t batch_size_ = 1;
  std::uint64_t in_open_ = 0;
  double open_sum_ = 0.0;
  std::vector<double> means_;
};

/// When replicate_until may stop.
struct Precision {
  Precision() = default;
  Precision(double width, std::size_t least, std::size_t most, double level = 0.95)
      : relative_half_width(width), min_replications(least), max_replications(most), confidence(level) {}
  double relative_half_width = 0.05;
  std::size_t min_replications = 10;  ///< at least 2; small numbers stop too early by chance
  std::size_t max_replications = 1000;
  double confidence = 0.95;
};

/// Runs `replication(i)`, i = 0, 1, ..., until the interval of the mean of its results is narrow enough or
/// the maximum is reached; the results are those of replications 0 to n - 1 whatever `threads` is. Look at
/// the interval to see whether the precision was reached.
struct ReplicationOutcome {
  ConfidenceInterval interval;
  std::vector<double> results;
  bool precise = false;
};
[[nodiscard]] ReplicationOutcome replicate_until(const Precision& precision, unsigned threads,
                                                 const std::function<double(std::size_t)>& replication);

}  // namespace verstat::sim
