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
};

/// Complete times are exact observations > 0, unfinished ones right-censored.
/// Throws FitError with fewer than two complete ones.
[[nodiscard]] DurationFit fit_durations(const std::vector<Observation>& times, int goodness_samples,
                                        std::uint64_t seed);

}  // namespace verstat::fit
