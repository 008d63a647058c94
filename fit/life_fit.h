#pragma once
// Five life laws fitted to censored lives by maximum likelihood, ranked by AICc.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "fit/observation.h"
#include "fit/statistics.h"

namespace verstat::fit {

enum class LifeFamily { weibull, lognormal, normal, gamma, exponential };
inline constexpr std::array life_families = {LifeFamily::weibull, LifeFamily::lognormal, LifeFamily::normal,
                                             LifeFamily::gamma, LifeFamily::exponential};
[[nodiscard]] const char* name_of(LifeFamily family);

/// One law with its two parameters as textbooks write them (exponential: one).
struct FittedLaw {
  LifeFamily family = LifeFamily::weibull;
  double first = 1;   ///< weibull, gamma, exponential: scale (mean); lognormal: mean of ln t; normal: mean
  double second = 1;  ///< weibull, gamma: shape; lognormal, normal: standard deviation (of ln t, of t)
  double log_likelihood = 0;
  double aicc = 0;  ///< infinite when there are too few failures to say

  [[nodiscard]] int parameters() const { return family == LifeFamily::exponential ? 1 : 2; }
  [[nodiscard]] double mean() const;
  [[nodiscard]] double cv() const;  ///< coefficient of variation
  /// P(life <= t).
  [[nodiscard]] double cdf(double t) const;
  /// Life not exceeded with probability p, 0 < p < 1. The normal law may answer below zero.
  [[nodiscard]] double quantile(double p) const;
  /// T with P(life > T) = gamma.
  [[nodiscard]] double gamma_percent_life(double gamma) const { return quantile(1 - gamma); }
};

/// A law that could not be fitted, and why.
struct Unfitted {
  LifeFamily family;
  std::string reason;
};

struct LifeRanking {
  std::vector<FittedLaw> laws;  ///< best first
  std::vector<Unfitted> unfitted;
};

/// Maximum likelihood. Lives > 0 (low may be 0 in an interval). Throws FitError when there is no maximum.
[[nodiscard]] FittedLaw fit_law(LifeFamily family, const std::vector<Observation>& lives);
/// Log-likelihood of the law for these lives, the density taken per unit of time.
[[nodiscard]] double log_likelihood(const FittedLaw& law, const std::vector<Observation>& lives);
/// All five, by AICc with the number of failures as sample size (a censored life tells less than a failure).
[[nodiscard]] LifeRanking rank_laws(const std::vector<Observation>& lives);

/// What is asked of a law with its bounds.
enum class LifeQuantity { first, second, mean, quantile };
/// Profile-likelihood bounds of a parameter, the mean, or the quantile at `p`. A bound that the data do not
/// give is infinite or 0.
[[nodiscard]] Interval life_bounds(const FittedLaw& law, const std::vector<Observation>& lives,
                                   LifeQuantity quantity, double confidence, double p = 0.5);

[[nodiscard]] std::size_t failures_in(const std::vector<Observation>& lives);

}  // namespace verstat::fit
