#include "models/math/polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/math/bracketed.h"

namespace verstat::models {

double evaluate_polynomial(const std::vector<double>& coefficients, double x) {
  double value = 0;
  for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) value = value * x + *c;
  return value;
}

std::vector<double> derivative_polynomial(const std::vector<double>& coefficients) {
  std::vector<double> out;
  for (std::size_t k = 1; k < coefficients.size(); ++k)
    out.push_back(static_cast<double>(k) * coefficients[k]);
  return out;
}

std::vector<double> polynomial_roots(std::vector<double> coefficients, double low, double high) {
  while (!coefficients.empty() && coefficients.back() == 0) coefficients.pop_back();
  std::vector<double> roots;
  if (coefficients.size() < 2 || !(low <= high)) return roots;
  if (coefficients.size() == 2) {
    const double root = -coefficients[0] / coefficients[1];
    if (root >= low && root <= high) roots.push_back(root);
    return roots;
  }
  std::vector<double> ends{low};
  for (const double x : polynomial_roots(derivative_polynomial(coefficients), low, high))
    if (x > ends.back()) ends.push_back(x);
  if (high > ends.back()) ends.push_back(high);

  // What rounding can make of a zero at x.
  const auto noise = [&](double x) {
    double sum = 0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c)
      sum = sum * std::abs(x) + std::abs(*c);
    return 8 * std::numeric_limits<double>::epsilon() * sum;
  };
  const auto add = [&](double x) {
    if (roots.empty() || x > roots.back()) roots.push_back(x);
  };
  const auto value = [&](double x) { return evaluate_polynomial(coefficients, x); };
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const double here = value(ends[k]);
    if (std::abs(here) <= noise(ends[k])) {
      add(ends[k]);
      continue;
    }
    if (k + 1 == ends.size()) break;
    const double next = value(ends[k + 1]);
    if (std::abs(next) > noise(ends[k + 1]) && (here < 0) != (next < 0))
      add(bracketed_root(value, ends[k], ends[k + 1], here, next,
                         1e-16 * std::max(std::abs(ends[k]), std::abs(ends[k + 1]))));
  }
  return roots;
}

}  // namespace verstat::models
