#pragma once
// The standard normal law.

namespace verstat::models {

[[nodiscard]] double normal_density(double z);
/// Phi(z), accurate to rounding in the lower tail; for the upper tail ask normal_cdf(-z).
[[nodiscard]] double normal_cdf(double z);
/// z with Phi(z) = p, 0 < p < 1 (-infinity at 0, infinity at 1).
[[nodiscard]] double normal_quantile(double p);
/// Hazard phi(z) / Phi(-z), the inverse of the Mills ratio; about z for large z, where both underflow.
[[nodiscard]] double normal_hazard(double z);

}  // namespace verstat::models
