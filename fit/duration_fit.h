#pragma once
// Times (between failures, of repairs, of cycles, between arrivals) into the laws a scenario knows, with the
// observations themselves to fall back on.

#include <cstdint>
#include <optional>
#include <vector>

#include "fit/life_analysis.h"

namespace verstat::fit {

struct DurationFit {
  std::size_t values = 0;                        ///< complete ones
  std::size_t censored = 0;                      ///< still running when the watching ended
  double mean = 0, sd = 0, least = 0, most = 0;  ///< of the complete ones
  std::vector<LawReport> laws;                   ///< Weibull, lognormal, gamma, exponential; best first
  std::vector<Unfitted> unfitted;
  bool constant = false;  ///< all the same
  /// Every law is refused at 5 %: the observations say more than any of them.
  bool empirical = false;
  std::vector<double> quantiles;  ///< 0, 1, ..., 100 % of the complete ones, linear between order statistics
  double largest_gap = 0;         ///< between the empirical distribution and the best law
  /// The empirical distribution: complete times that differ, ascending, and how often each was seen; with
  /// unfinished ones the steps of the product-limit estimate. What unfinished times leave beyond the longest
  /// complete one is added to that one (Efron, Proc. 5th Berkeley Symp. 4 (1967) 831) and stands in
  /// `weight_beyond`.
  std::vector<double> distinct, weights;
  double weight_beyond = 0;
};

/// Complete times are exact observations > 0, unfinished ones right-censored.
/// Throws FitError with fewer than two complete ones.
[[nodiscard]] DurationFit fit_durations(const std::vector<Observation>& times, int goodness_samples,
                                        std::uint64_t seed);

}  // namespace verstat::fit
