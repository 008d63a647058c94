#pragma once
// The standard normal law.

namespace verstat::sim::detail {

/// P(Z <= z).
[[nodiscard]] double normal_cdf(double z);

/// z with P(Z <= z) = p, 0 < p < 1; -infinity and infinity at the ends.
[[nodiscard]] double normal_quantile(double p);

/// Mean of Normal(mean, sd > 0) given low <= x <= high; `mass` is the probability of that.
[[nodiscard]] double truncated_normal_mean(double mean, double sd, double low, double high, double mass);
/// Variance of the same.
[[nodiscard]] double truncated_normal_variance(double mean, double sd, double low, double high, double mass);

}  // namespace verstat::sim::detail
