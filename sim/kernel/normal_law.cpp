#include "sim/kernel/normal_law.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>

#include "sim/kernel/math_policy.h"

namespace verstat::sim::detail {
namespace {

double density(double z) {
  return std::isinf(z) ? 0.0
                       : std::exp(-0.5 * z * z) * (0.5 * std::numbers::inv_sqrtpi * std::numbers::sqrt2);
}
double density_times_z(double z) {
  return std::isinf(z) ? 0.0 : z * density(z);
}

}  // namespace

double normal_cdf(double z) {
  if (std::isinf(z)) return z > 0.0 ? 1.0 : 0.0;
  return 0.5 * boost::math::erfc(-z / std::numbers::sqrt2, MathPolicy());
}

double normal_quantile(double p) {
  if (p <= 0.0) return -std::numeric_limits<double>::infinity();
  if (p >= 1.0) return std::numeric_limits<double>::infinity();
  return -std::numbers::sqrt2 * boost::math::erfc_inv(2.0 * p, MathPolicy());
}

// With a = (low - mean) / sd, b = (high - mean) / sd, phi the density and Z the probability between
// (Johnson, Kotz, Balakrishnan, Continuous Univariate Distributions 1, 2nd ed., section 13.10.1):
//   mean + sd (phi(a) - phi(b)) / Z
//   sd^2 [1 + (a phi(a) - b phi(b)) / Z - ((phi(a) - phi(b)) / Z)^2]
double truncated_normal_mean(double mean, double sd, double low, double high, double mass) {
  const double a = (low - mean) / sd;
  const double b = (high - mean) / sd;
  return mean + sd * (density(a) - density(b)) / mass;
}

double truncated_normal_variance(double mean, double sd, double low, double high, double mass) {
  const double a = (low - mean) / sd;
  const double b = (high - mean) / sd;
  const double shift = (density(a) - density(b)) / mass;
  return sd * sd * (1.0 + (density_times_z(a) - density_times_z(b)) / mass - shift * shift);
}

}  // namespace verstat::sim::detail
