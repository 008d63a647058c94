#pragma once
// Roots, minima and integrals of one variable, each checked: Boost's solvers answer silently when they run
// out of iterations, and a quadrature across a kink misjudges its own error.

#include <functional>

namespace verstat::models {

using Function1 = std::function<double(double)>;

/// Root of `f` in [low, high], where f(low) and f(high) differ in sign (or one is zero). TOMS 748.
/// `rel_tol` relative to the root. Throws DomainError when the signs agree or it does not converge.
[[nodiscard]] double find_root(const Function1& f, double low, double high, double rel_tol = 1e-14);

struct Minimum {
  double x;
  double value;
};
/// Local minimum of a function unimodal in [low, high], ends included. Golden section with parabolic steps
/// (Brent), to |x| * `rel_tol` (below 1e-8 a double cannot tell).
[[nodiscard]] Minimum minimize_unimodal(const Function1& f, double low, double high, double rel_tol = 1e-9);
/// Global minimum over [low, high], ends included: a grid of `cells` cells, then Brent around every cell that
/// could hold a minimum. The first of equal minima wins.
[[nodiscard]] Minimum minimize_global(const Function1& f, double low, double high, int cells = 200,
                                      double rel_tol = 1e-9);

/// Integral of a smooth `f` over [low, high]: adaptive Gauss-Kronrod (31 points), to `rel_tol` of the result.
/// Split at kinks first. Throws DomainError when the error estimate stays above 1e3 * rel_tol.
[[nodiscard]] double integrate(const Function1& f, double low, double high, double rel_tol = 1e-12);

}  // namespace verstat::models
