#include "models/math/bivariate_normal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "models/math/normal.h"
#include "models/math/policy.h"

namespace verstat::models {

double bivariate_normal_cdf(double h, double k, double rho) {
  const double apart = normal_cdf(h) * normal_cdf(k);
  if (rho == 0 || std::isinf(h) || std::isinf(k)) return apart;
  const auto density = [&](double t) {
    const double sine = std::sin(t);
    const double cosine2 = (1 - sine) * (1 + sine);
    // h^2 + k^2 - 2 h k sin t as squares, which keeps its digits near |sin t| = 1.
    return std::exp(-((h - k) * (h - k) / (2 * cosine2) + h * k / (1 + sine)));
  };
  // The integrand changes ever faster towards |sin t| = 1: panels that halve their distance to it.
  double sum = 0;
  const double end = std::asin(std::abs(rho));
  const double sign = rho < 0 ? -1 : 1;
  double from = 0;
  while (from < end) {
    const double to = std::min(end, from + 0.5 * (std::numbers::pi / 2 - from));
    sum += boost::math::quadrature::gauss<double, 30, MathPolicy>::integrate(
        [&](double t) { return density(sign * t); }, from, to);
    from = to;
  }
  return std::clamp(apart + sign * sum / (2 * std::numbers::pi), 0.0, 1.0);
}

}  // namespace verstat::models
