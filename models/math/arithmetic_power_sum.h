#pragma once
// Sums of equally spaced powers, as they arise when many passes or contacts overlap.

#include <cstdint>

namespace verstat::models {

/// sum over i = 0 .. terms-1 of (u - i * step)^p, where terms with u - i * step <= 0 count as nothing.
/// step >= 0, terms >= 0, any p. The last sixteen powers are added one by one, the larger ones by the
/// Euler-Maclaurin formula: the cost does not grow with `terms`, the relative error stays near 1e-15 for
/// |p| < 20.
[[nodiscard]] double arithmetic_power_sum(double u, double step, std::int64_t terms, double p);

}  // namespace verstat::models
