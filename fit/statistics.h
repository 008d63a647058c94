#pragma once
// Quantiles and tail probabilities of the laws that tests and intervals are read from.

#include <cstddef>

namespace verstat::fit {

/// Quantile of chi-square with `degrees` > 0, 0 < p < 1.
[[nodiscard]] double chi_square_quantile(double p, double degrees);
/// P(X > x) of chi-square, x >= 0.
[[nodiscard]] double chi_square_tail(double x, double degrees);
/// Two-sided quantile of Student's t, P(|T| <= t) = confidence, for real degrees > 0.
[[nodiscard]] double student_quantile(double confidence, double degrees);
/// Two-sided p-value of a standard normal statistic.
[[nodiscard]] double normal_two_sided(double z);
/// Quantile of the beta law with shapes a, b > 0.
[[nodiscard]] double beta_quantile(double p, double a, double b);

struct Interval {
  double low = 0;
  double high = 0;
};
/// Garwood's exact interval of a Poisson mean after `count` events (Biometrika 28 (1936) 437).
[[nodiscard]] Interval poisson_interval(std::size_t count, double confidence);

}  // namespace verstat::fit
