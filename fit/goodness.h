#pragma once
// Does the law fit? Nonparametric reliability, median ranks, and a test by simulation.

#include <cstdint>
#include <vector>

#include "fit/life_fit.h"

namespace verstat::fit {

/// Product-limit estimate at one failure time (Kaplan, Meier, JASA 53 (1958) 457). Intervals count at their
/// middles.
struct SurvivalStep {
  double time = 0;
  double survival = 1;  ///< just after `time`
  std::size_t at_risk = 0;
  std::size_t failures = 0;
};
[[nodiscard]] std::vector<SurvivalStep> product_limit(const std::vector<Observation>& lives);

/// A failure on the Weibull plot: adjusted rank (Johnson 1964) with the median and the bounds of the beta law
/// of that order statistic.
struct PlotPoint {
  double time = 0;
  double rank = 0;
  double median = 0;  ///< median rank: estimate of P(life <= time)
  double low = 0;     ///< 5 % rank
  double high = 0;    ///< 95 % rank
};
[[nodiscard]] std::vector<PlotPoint> median_ranks(const std::vector<Observation>& lives);

/// Straight line through the Weibull plot, ln t regressed on ln(-ln(1 - median rank)).
struct RankRegression {
  double shape = 0;
  double scale = 0;
  double correlation = 0;
};
/// Needs two different failures, else FitError.
[[nodiscard]] RankRegression rank_regression(const std::vector<PlotPoint>& points);

/// Cramer-von Mises distance between the product-limit estimate and the law, over the failures.
[[nodiscard]] double distance(const FittedLaw& law, const std::vector<Observation>& lives);

struct GoodnessTest {
  double statistic = 0;
  double p_value = 1;  ///< share of simulated samples from the fitted law that lie farther from their own fit
  int samples = 0;     ///< that could be fitted
};
/// Parametric bootstrap (Stute, Gonzales Manteiga, Presedo Quindimil, Metrika 40 (1993) 243): lives from the
/// fitted law, censoring times from the product-limit estimate of the censoring, widths of intervals from the
/// data; every sample is fitted again.
[[nodiscard]] GoodnessTest goodness_of_fit(const FittedLaw& law, const std::vector<Observation>& lives,
                                           int samples, std::uint64_t seed);

}  // namespace verstat::fit
