#include "sim/kernel/output_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <boost/math/distributions/students_t.hpp>

#include "sim/kernel/engine.h"
#include "sim/kernel/math_policy.h"
#include "sim/kernel/normal_law.h"
#include "sim/kernel/replications.h"

namespace verstat::sim {

using detail::text_of;

double ConfidenceInterval::relative_half_width() const noexcept {
  return mean == 0.0 ? std::numeric_limits<double>::infinity() : half_width / std::abs(mean);
}

double student_t(double confidence, std::uint64_t degrees) {
  if (!(confidence > 0.0 && confidence < 1.0)) {
    throw std::invalid_argument("student_t: confidence = " + text_of(confidence) +
                                ", allowed 0 < confidence < 1");
  }
  if (degrees == 0) throw std::invalid_argument("student_t: 0 degrees of freedom, at least 1 needed");
  using Law = boost::math::students_t_distribution<double, detail::MathPolicy>;
  const Law law(static_cast<double>(degrees));
  return boost::math::quantile(boost::math::complement(law, 0.5 * (1.0 - confidence)));
}

ConfidenceInterval confidence_interval(const Tally& tally, double confidence) {
  if (tally.count() < 2) {
    throw std::invalid_argument("confidence interval: " + std::to_string(tally.count()) +
                                " observations, at least 2 needed");
  }
  return {tally.mean(), student_t(confidence, tally.count() - 1) * tally.standard_error(), confidence};
}

ConfidenceInterval paired_difference(std::span<const double> a, std::span<const double> b,
                                     double confidence) {
  if (a.size() != b.size()) {
    throw std::invalid_argument("paired difference: " + std::to_string(a.size()) + " and " +
                                std::to_string(b.size()) + " results, must be as many");
  }
  Tally differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.add(a[i] - b[i]);
  return confidence_interval(differences, confidence);
}

ProbabilityInterval wilson_interval(std::int64_t successes, std::int64_t trials, double confidence) {
  if (trials < 1 || successes < 0 || successes > trials || !(confidence > 0 && confidence < 1))
    throw std::invalid_argument("wilson_interval: 0 <= successes <= trials, trials >= 1, 0 < confidence < 1");
  const double n = static_cast<double>(trials);
  const double p = static_cast<double>(successes) / n;
  const double z = detail::normal_quantile(0.5 * (1 + confidence));
  const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
  const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  return {successes == 0 ? 0 : middle - half, successes == trials ? 1 : middle + half};
}

Tally batch_means(std::span<const double> series, std::size_t batches) {
  if (batches < 2 || series.size() < batches) {
    throw std::invalid_argument("batch means: " + std::to_string(batches) + " batches of " +
                                std::to_string(series.size()) +
                                " observations, at least 2 batches and one observation in each needed");
  }
  const std::size_t length = series.size() / batches;
  Tally means;
  for (std::size_t first = series.size() - batches * length; first < series.size(); first += length) {
    Tally batch;
    for (const double x : series.subspan(first, length)) batch.add(x);
    means.add(batch.mean());
  }
  return means;
}

Truncation mser5(std::span<const double> series) {
  constexpr std::size_t group = 5;
  const std::size_t n = series.size() / group;
  if (n < 2) {
    throw std::invalid_argument("MSER-5: " + std::to_string(series.size()) +
                                " observations, at least 10 needed");
  }
  std::vector<double> means(n);
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (const double x : series.subspan(group * i, group)) sum += x;
    means[i] = sum / static_cast<double>(group);
  }
  // From the end backwards, so that each cut costs O(1). The last few groups always look quiet by chance:
  // at least five stay (or all, in short series).
  const std::size_t keep = std::min<std::size_t>(5, n);
  Tally rest;
  double best = std::numeric_limits<double>::infinity();
  std::size_t cut = 0;
  for (std::size_t i = n; i-- > 0;) {
    rest.add(means[i]);
    if (rest.count() < keep) continue;
    const double m = static_cast<double>(rest.count());
    const double marginal_error = rest.variance() * (m - 1.0) / (m * m);
    if (marginal_error <= best) {
      best = marginal_error;
      cut = i;
    }
  }
  return {group * cut, 2 * cut <= n};
}

BatchMeans::BatchMeans(std::size_t target) : target_(target) {
  if (target < 2) {
    throw std::invalid_argument("batch means: " + std::to_string(target) + " batches, at least 2 needed");
  }
  means_.reserve(2 * target);
}

void BatchMeans::add(double x) {
  open_sum_ += x;
  if (++in_open_ < batch_size_) return;
  means_.push_back(open_sum_ / static_cast<double>(batch_size_));
  open_sum_ = 0.0;
  in_open_ = 0;
  if (means_.size() < 2 * target_) return;
  for (std::size_t i = 0; i < target_; ++i) means_[i] = 0.5 * (means_[2 * i] + means_[2 * i + 1]);
  means_.resize(target_);
  batch_size_ *= 2;
}

Tally BatchMeans::batches() const {
  Tally tally;
  for (const double mean : means_) tally.add(mean);
  return tally;
}

ReplicationOutcome replicate_until(const Precision& precision, unsigned threads,
                                   const std::function<double(std::size_t)>& replication) {
  if (precision.min_replications < 2 || precision.max_replications < precision.min_replications ||
      !(precision.relative_half_width > 0.0)) {
    throw std::invalid_argument(
        "replicate_until: relative half width " + text_of(precision.relative_half_width) + ", from " +
        std::to_string(precision.min_replications) + " to " + std::to_string(precision.max_replications) +
        " replications; allowed width > 0 and 2 <= min <= max");
  }
  ReplicationOutcome outcome;
  Tally tally;
  while (tally.count() < precision.max_replications) {
    // Rounds of a size that does not depend on the number of threads; a round may run past the stopping
    // point, and what lies beyond it is dropped, so that the answer is that of one by one.
    const std::size_t done = outcome.results.size();
    const std::size_t round =
        done == 0 ? precision.min_replications
                  : std::min(std::max<std::size_t>(8, done / 4), precision.max_replications - done);
    const std::vector<double> results =
        run_replications(round, threads, [&](std::size_t i) { return replication(done + i); });
    for (const double result : results) {
      outcome.results.push_back(result);
      tally.add(result);
      if (tally.count() < precision.min_replications) continue;
      outcome.interval = confidence_interval(tally, precision.confidence);
      outcome.precise = outcome.interval.relative_half_width() <= precision.relative_half_width;
      if (outcome.precise) return outcome;
    }
  }
  return outcome;
}

}  // namespace verstat::sim
