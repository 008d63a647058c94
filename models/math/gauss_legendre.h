#pragma once
// Gauss-Legendre rules with a fixed number of points: for smooth integrands whose quadrature is part of a
// model's definition (so many points per panel), where an adaptive rule would cost more and give other
// digits.

#include <cstddef>
#include <vector>

namespace verstat::models {

struct GaussPoint {
  double x;       // in (0, 1), ascending
  double weight;  // weights sum to 1
};
/// Points and weights on [0, 1] of the rule with `points` >= 1 points, exact for polynomials of degree
/// 2 * points - 1. Newton on the Legendre recurrence.
[[nodiscard]] std::vector<GaussPoint> gauss_legendre(std::size_t points);
/// The rule with 24 points, computed once.
[[nodiscard]] const std::vector<GaussPoint>& gauss_legendre_24();

/// Integral of f over [low, high] by `rule`.
template <class F>
[[nodiscard]] double integrate_gauss(F&& f, double low, double high, const std::vector<GaussPoint>& rule) {
  double sum = 0;
  for (const GaussPoint& p : rule) sum += p.weight * f(low + (high - low) * p.x);
  return sum * (high - low);
}

}  // namespace verstat::models
