#include "models/math/solve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include "models/catalogue/error.h"
#include "models/math/policy.h"

namespace verstat::models {

double find_root(const Function1& f, double low, double high, double rel_tol) {
  const double f_low = f(low);
  const double f_high = f(high);
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  if (!(f_low * f_high < 0) && !(std::signbit(f_low) != std::signbit(f_high)))
    reject(fmt::format("no root between {} and {}: the function does not change sign", low, high));
  std::uintmax_t iterations = 300;
  const auto close = [rel_tol](double a, double b) {
    return std::abs(b - a) <= rel_tol * std::max(std::abs(a), std::abs(b)) || std::nextafter(a, b) == b;
  };
  const auto [a, b] =
      boost::math::tools::toms748_solve(f, low, high, f_low, f_high, close, iterations, MathPolicy());
  if (iterations >= 300 && !close(a, b)) reject(fmt::format("no root found between {} and {}", low, high));
  // Of the two ends the one with the smaller residual.
  return std::abs(f(a)) <= std::abs(f(b)) ? a : b;
}

Minimum minimize_unimodal(const Function1& f, double low, double high, double rel_tol) {
  std::uintmax_t iterations = 500;
  const int bits = std::clamp(static_cast<int>(std::ceil(-std::log2(std::max(rel_tol, 1e-15)))) + 1, 8, 52);
  const auto [x, value] = boost::math::tools::brent_find_minima(f, low, high, bits, iterations);
  Minimum best{x, value};
  if (const double at_low = f(low); at_low <= best.value) best = {low, at_low};
  if (const double at_high = f(high); at_high < best.value) best = {high, at_high};
  return best;
}

Minimum minimize_global(const Function1& f, double low, double high, int cells, double rel_tol) {
  const auto node = [&](int k) { return k == cells ? high : low + (high - low) * k / cells; };
  std::vector<double> values(static_cast<std::size_t>(cells) + 1);
  for (int k = 0; k <= cells; ++k) values[static_cast<std::size_t>(k)] = f(node(k));
  Minimum best{low, values[0]};
  for (int k = 0; k <= cells; ++k) {
    const double here = values[static_cast<std::size_t>(k)];
    if (here < best.value) best = {node(k), here};
  }
  for (int k = 0; k <= cells; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool below_left = k == 0 || values[i] <= values[i - 1];
    const bool below_right = k == cells || values[i] <= values[i + 1];
    if (!below_left || !below_right) continue;
    const Minimum local =
        minimize_unimodal(f, node(std::max(k - 1, 0)), node(std::min(k + 1, cells)), rel_tol);
    if (local.value < best.value) best = local;
  }
  return best;
}

double integrate(const Function1& f, double low, double high, double rel_tol) {
  if (low == high) return 0;
  double error = 0;
  double l1 = 0;
  // Over -1 to 1: Boost compares the error of an interval mapped to this length with a tolerance in the given
  // one, and so refuses short intervals and trusts long ones.
  const double middle = low + (high - low) / 2;
  const double half = (high - low) / 2;
  const double result = boost::math::quadrature::gauss_kronrod<double, 31, MathPolicy>::integrate(
      [&](double t) { return f(middle + half * t); }, -1.0, 1.0, 15, rel_tol, &error, &l1);
  if (!(error <= 1e3 * rel_tol * std::max(l1, std::abs(result)) + 1e-300))
    reject(fmt::format("an integral over {} to {} did not converge (error estimate {})", low, high,
                       error * std::abs(half)));
  return result * half;
}

}  // namespace verstat::models
