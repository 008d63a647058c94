#pragma once
// Probability of an interval under the standard normal law.

namespace verstat::models {

/// P(low < X <= high) for low <= high, without the cancellation of a difference of two values near 1.
[[nodiscard]] double normal_between(double low, double high);

}  // namespace verstat::models
