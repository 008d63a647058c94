#pragma once
// Arrivals whose rate changes with the time of day or week.

#include <utility>
#include <vector>

#include "sim/kernel/random_stream.h"

namespace verstat::sim {

/// A rate that is constant by pieces and repeats with a period (a day, a week).
class RateProfile {
 public:
  /// `rates[i]` >= 0 (arrivals per time unit) holds for `lengths[i]` > 0 time units; the pieces follow each
  /// other and then repeat. At least one rate is positive. Else std::invalid_argument.
  RateProfile(const std::vector<double>& lengths, const std::vector<double>& rates);

  [[nodiscard]] double period() const noexcept { return ends_.back(); }
  /// Rate at `time` >= 0; at a border that of the piece which begins.
  [[nodiscard]] double rate(double time) const;
  /// Expected number of arrivals from 0 to `time` >= 0.
  [[nodiscard]] double expected(double time) const;
  /// The time until which `count` >= 0 arrivals are expected: inverse of expected().
  [[nodiscard]] double time_of(double count) const;

 private:
  std::vector<double> ends_;    // end of each piece within the period
  std::vector<double> counts_;  // expected arrivals by then
  std::vector<double> rates_;
};

/// Non-stationary Poisson process by inversion of the expected count (Cinlar, Introduction to Stochastic
/// Processes, 1975, section 4.7): one uniform per arrival, nothing is thrown away.
class PoissonArrivals {
 public:
  explicit PoissonArrivals(RateProfile profile) : profile_(std::move(profile)) {}

  /// Time of the next arrival (absolute; the first call gives the first one after 0).
  double next(RandomStream& stream) {
    count_ += stream.exponential(1.0);
    return profile_.time_of(count_);
  }
  [[nodiscard]] const RateProfile& profile() const noexcept { return profile_; }

 private:
  RateProfile profile_;
  double count_ = 0.0;
};

}  // namespace verstat::sim
