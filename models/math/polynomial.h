#pragma once
// Polynomials with real coefficients, lowest power first.

#include <vector>

namespace verstat::models {

/// c0 + c1 x + c2 x^2 + ... by Horner's rule; 0 without coefficients.
[[nodiscard]] double evaluate_polynomial(const std::vector<double>& coefficients, double x);
[[nodiscard]] std::vector<double> derivative_polynomial(const std::vector<double>& coefficients);

/// Real roots in [low, high], ascending, each once. The roots of the derivative split the range into monotone
/// pieces, so that none is missed; a root where the polynomial only touches zero counts within rounding. The
/// zero polynomial has none.
[[nodiscard]] std::vector<double> polynomial_roots(std::vector<double> coefficients, double low, double high);

}  // namespace verstat::models
