#include "fit/statistics.h"

#include <cmath>

#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "models/math/normal.h"
#include "models/math/policy.h"

namespace verstat::fit {

using models::MathPolicy;

double chi_square_quantile(double p, double degrees) {
  return 2 * boost::math::gamma_p_inv(degrees / 2, p, MathPolicy());
}

double chi_square_tail(double x, double degrees) {
  return x <= 0 ? 1 : boost::math::gamma_q(degrees / 2, x / 2, MathPolicy());
}

double student_quantile(double confidence, double degrees) {
  return boost::math::quantile(boost::math::students_t_distribution<double, MathPolicy>(degrees),
                               (1 + confidence) / 2);
}

double normal_two_sided(double z) {
  return 2 * models::normal_cdf(-std::abs(z));
}

double beta_quantile(double p, double a, double b) {
  return boost::math::ibeta_inv(a, b, p, MathPolicy());
}

Interval poisson_interval(std::size_t count, double confidence) {
  const auto n = static_cast<double>(count);
  const double tail = (1 - confidence) / 2;
  return {count == 0 ? 0 : chi_square_quantile(tail, 2 * n) / 2,
          chi_square_quantile(1 - tail, 2 * n + 2) / 2};
}

}  // namespace verstat::fit
