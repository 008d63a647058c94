#pragma once
// Mathieu's equation y'' + (a + 2 b cos 2 tau) y = 0: Floquet growth and the borders of its instability
// zones.

#include <utility>

namespace verstat::models {

struct MathieuStability {
  double half_trace;  ///< of the monodromy matrix over pi
  bool unstable;      ///< |half_trace| > 1 + 1e-9
  double growth;      ///< exponent per tau, 0 when stable
};
/// Runge-Kutta 4, 400 steps while |a| + 2 |b| <= 25, else 2000: half trace to 1e-7 max(1, |half trace|) for
/// -5 <= a <= 100, |b| <= 20.
[[nodiscard]] MathieuStability mathieu_stability(double a, double b);

/// Characteristic values b_k(|b|) <= a_k(|b|), the borders of zone k >= 1: eigenvalues of the tridiagonal
/// recurrences of the periodic solutions' Fourier coefficients.
[[nodiscard]] std::pair<double, double> mathieu_zone_borders(int zone, double b);

}  // namespace verstat::models
