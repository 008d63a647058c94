#pragma once
// Everything one group of lives tells: laws, bounds, fit, causes, batches.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fit/goodness.h"
#include "fit/life_fit.h"

namespace verstat::fit {

struct LifeAnalysisOptions {
  double gamma = 0.9;  ///< share of the edges that survive the gamma-percent life
  double confidence = 0.95;
  int goodness_samples = 199;  ///< of at most two million lives in all; 39 at least
  std::uint64_t seed = 1;
};

struct Bounded {
  double estimate = 0;
  Interval bounds;
};

struct LawReport {
  FittedLaw law;
  GoodnessTest goodness;
};

/// One cause, every other cause taken as censoring (independent latent lives).
struct CauseReport {
  int cause = 0;
  std::size_t failures = 0;
  std::optional<FittedLaw> law;  ///< best by AICc
  std::string why_not;           ///< when there is none
  /// Share of all edges that this cause has ended by the last failure (Aalen, Johansen 1978).
  double incidence = 0;
};

struct BatchReport {
  LifeFamily family = LifeFamily::weibull;  ///< the better one of Weibull and lognormal
  struct Ratio {
    std::size_t batch = 0;
    std::size_t edges = 0, failures = 0;
    Bounded life_ratio;  ///< to the first compared batch
  };
  std::vector<Ratio> ratios;  ///< of the batches with failures
  std::vector<std::size_t> without_failures;
  double scale_p_value = 1;  ///< likelihood ratio: all batches have one scale
  double shape_p_value = 1;  ///< likelihood ratio: all batches have one shape; 1 when it cannot be told
};

struct LifeAnalysis {
  std::size_t edges = 0, failures = 0, intervals = 0;
  std::vector<LawReport> laws;  ///< best first
  std::vector<Unfitted> unfitted;
  Bounded first, second, mean;
  double gamma = 0.9;
  Bounded gamma_percent_life;
  double longest = 0;  ///< the largest life or censoring time: beyond it the law is extrapolated
  std::vector<PlotPoint> weibull_plot;
  std::optional<RankRegression> plot_line;
  std::vector<SurvivalStep> product_limit;
  std::vector<CauseReport> causes;  ///< when failures have more than one
  /// Gamma-percent life of the causes together, from the product of their reliabilities.
  std::optional<double> gamma_percent_life_of_causes;
  std::optional<BatchReport> batches;
  std::string batches_not_compared;  ///< why, when there are several batches and no report
};
inline constexpr std::size_t most_batches = 30;

/// Throws FitError when not even the exponential law can be fitted.
[[nodiscard]] LifeAnalysis analyse_lives(const std::vector<Observation>& lives,
                                         const LifeAnalysisOptions& options);

/// The lives as one cause sees them: failures by another cause are survivals.
[[nodiscard]] std::vector<Observation> lives_of_cause(const std::vector<Observation>& lives, int cause);

/// Likelihood-ratio comparison of batches; nothing when fewer than two batches have failures.
[[nodiscard]] std::optional<BatchReport> compare_batches(const std::vector<Observation>& lives,
                                                         double confidence);

}  // namespace verstat::fit
