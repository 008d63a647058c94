#include "models/math/normal.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>

#include "models/math/policy.h"

namespace verstat::models {

double normal_density(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

double normal_cdf(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

double normal_quantile(double p) {
  if (p <= 0) return -std::numeric_limits<double>::infinity();
  if (p >= 1) return std::numeric_limits<double>::infinity();
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2 * p, MathPolicy());
}

double normal_hazard(double z) {
  if (z < 20) return normal_density(z) / normal_cdf(-z);
  // Laplace's continued fraction of the inverse Mills ratio, z + 1/(z + 2/(z + 3/(z + ...))).
  double tail = z;
  for (int k = 20; k >= 1; --k) tail = z + k / tail;
  return tail;
}

}  // namespace verstat::models
