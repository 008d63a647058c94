#include "models/math/life_law.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <boost/math/special_functions/digamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/special_functions/zeta.hpp>

#include "models/catalogue/error.h"
#include "models/math/normal.h"
#include "models/math/policy.h"

namespace verstat::models {
namespace {

double log_gamma(double x) {
  return boost::math::lgamma(x, MathPolicy());
}

// ln(1 + cv^2) of the Weibull law.
double log_one_plus_cv2(double shape) {
  const double x = 1 / shape;
  if (x > 0.03) return log_gamma(1 + 2 * x) - 2 * log_gamma(1 + x);
  // Large shapes: the terms linear in x cancel, so the series of ln Gamma(1 + x) from the second term on,
  // sum of (-1)^k zeta(k) x^k / k, is taken for 2x and x together.
  double sum = 0;
  double power = x;
  double two = 2;
  for (int k = 2; k <= 12; ++k) {
    power *= -x;
    two *= 2;
    sum -= boost::math::zeta(static_cast<double>(k), MathPolicy()) * (two - 2) * power / k;
  }
  return sum;
}

// Mean of a Weibull life with scale 1.
double unit_scale_mean(double shape) {
  return boost::math::tgamma(1 + 1 / shape, MathPolicy());
}

// Hazard of the gamma law with scale 1 at x >= 0.
double gamma_hazard(double shape, double x) {
  const double left = boost::math::gamma_q(shape, x, MathPolicy());
  if (left > 1e-200) {
    if (x == 0) return shape > 1 ? 0 : shape == 1 ? 1 : std::numeric_limits<double>::infinity();
    return boost::math::gamma_p_derivative(shape, x, MathPolicy()) / left;
  }
  // Where both underflow: Legendre's continued fraction of Gamma(shape, x) / (x^shape exp(-x)) by the
  // modified Lentz method (DLMF 8.9.2); it converges for x > shape + 1, and here x is far beyond.
  double b = x + 1 - shape;
  double c = 1e300;
  double d = 1 / b;
  double fraction = d;
  for (int k = 1; k <= 1000; ++k) {
    const double a = -k * (k - shape);
    b += 2;
    d = 1 / (a * d + b);
    c = b + a / c;
    const double step = c * d;
    fraction *= step;
    if (std::abs(step - 1) < 1e-15) break;
  }
  return 1 / (x * fraction);
}

// Integral of Phi from -infinity to z.
double integrated_phi(double z) {
  return z * normal_cdf(z) + normal_density(z);
}

}  // namespace

double weibull_cv(double shape) {
  return std::sqrt(std::expm1(log_one_plus_cv2(shape)));
}

double weibull_shape(double cv) {
  require(cv >= 1e-4 && cv <= 10, "cv", cv, "allowed 1e-4 <= cv <= 10 for the Weibull law");
  if (cv == 1) return 1;
  // Newton in ln b for ln ln(1 + cv^2), which is almost a straight line: four steps reach rounding.
  const double target = std::log1p(cv * cv);
  double shape = std::pow(cv, -1.086);
  for (int k = 0; k < 20; ++k) {
    const double value = log_one_plus_cv2(shape);
    const double slope = -2 / shape *
                         (boost::math::digamma(1 + 2 / shape, MathPolicy()) -
                          boost::math::digamma(1 + 1 / shape, MathPolicy())) /
                         value;
    const double step = std::log(value / target) / slope;
    shape *= std::exp(-step);
    if (std::abs(step) < 1e-9) break;  // quadratic: the step after this one would be rounding
  }
  // Rounding must not carry the shape over the border between falling and rising hazard.
  return cv < 1 ? std::max(shape, 1.0) : std::min(shape, 1.0);
}

LifeLaw::LifeLaw(LifeLawKind kind, double mean, double cv) : kind_(kind), mean_(mean), cv_(cv) {
  if (!(mean > 0 && mean < std::numeric_limits<double>::infinity()))
    require(false, "mean life", mean, "must be a finite number above 0");
  switch (kind) {
    case LifeLawKind::weibull:
      shape_ = weibull_shape(cv);
      scale_ = mean / unit_scale_mean(shape_);
      break;
    case LifeLawKind::normal:
      require(cv >= 0.05 && cv <= 0.45, "cv", cv, "allowed 0.05 <= cv <= 0.45 for the normal law");
      scale_ = cv * mean;
      break;
    case LifeLawKind::exponential:
      cv_ = 1;
      scale_ = mean;
      break;
    case LifeLawKind::lognormal:
      require(cv >= 1e-4 && cv <= 10, "cv", cv, "allowed 1e-4 <= cv <= 10 for the lognormal law");
      shape_ = std::sqrt(std::log1p(cv * cv));
      scale_ = mean / std::sqrt(1 + cv * cv);
      break;
    case LifeLawKind::gamma:
      require(cv >= 0.01 && cv <= 10, "cv", cv, "allowed 0.01 <= cv <= 10 for the gamma law");
      shape_ = 1 / (cv * cv);
      scale_ = mean * cv * cv;
      break;
  }
}

LifeLaw LifeLaw::weibull(double scale, double shape) {
  require(scale > 0 && scale < std::numeric_limits<double>::infinity(), "scale", scale,
          "must be a finite number above 0");
  require(shape >= 0.25 && shape <= 60, "shape", shape, "allowed 0.25 <= shape <= 60");
  LifeLaw law;
  law.kind_ = LifeLawKind::weibull;
  law.shape_ = shape;
  law.scale_ = scale;
  law.mean_ = scale * unit_scale_mean(shape);
  law.cv_ = weibull_cv(shape);
  return law;
}

LifeLaw LifeLaw::with_mean(double mean) const {
  require(mean > 0 && mean < std::numeric_limits<double>::infinity(), "mean life", mean,
          "must be a finite number above 0");
  LifeLaw law = *this;
  law.mean_ = mean;
  law.scale_ = scale_ / mean_ * mean;
  return law;
}

double LifeLaw::reliability(double t) const {
  switch (kind_) {
    case LifeLawKind::weibull:
      return std::exp(-std::pow(t / scale_, shape_));
    case LifeLawKind::normal:
      return normal_cdf((mean_ - t) / scale_);
    case LifeLawKind::exponential:
      return std::exp(-t / scale_);
    case LifeLawKind::lognormal:
      return t > 0 ? normal_cdf(std::log(scale_ / t) / shape_) : 1;
    case LifeLawKind::gamma:
      return std::isinf(t) ? 0 : boost::math::gamma_q(shape_, t / scale_, MathPolicy());
  }
  return 0;
}

double LifeLaw::failure_probability(double t) const {
  switch (kind_) {
    case LifeLawKind::weibull:
      return -std::expm1(-std::pow(t / scale_, shape_));
    case LifeLawKind::normal:
      return normal_cdf((t - mean_) / scale_);
    case LifeLawKind::exponential:
      return -std::expm1(-t / scale_);
    case LifeLawKind::lognormal:
      return t > 0 ? normal_cdf(std::log(t / scale_) / shape_) : 0;
    case LifeLawKind::gamma:
      return std::isinf(t) ? 1 : boost::math::gamma_p(shape_, t / scale_, MathPolicy());
  }
  return 1;
}

double LifeLaw::density(double t) const {
  if (kind_ == LifeLawKind::normal) return normal_density((t - mean_) / scale_) / scale_;
  return hazard(t) * reliability(t);
}

double LifeLaw::hazard(double t) const {
  switch (kind_) {
    case LifeLawKind::weibull:
      return shape_ / scale_ * std::pow(t / scale_, shape_ - 1);
    case LifeLawKind::normal:
      return normal_hazard((t - mean_) / scale_) / scale_;
    case LifeLawKind::exponential:
      return 1 / scale_;
    case LifeLawKind::lognormal:
      return t > 0 ? normal_hazard(std::log(t / scale_) / shape_) / (shape_ * t) : 0;
    case LifeLawKind::gamma:
      return gamma_hazard(shape_, t / scale_) / scale_;
  }
  return 0;
}

double LifeLaw::restricted_mean(double tau) const {
  if (std::isinf(tau)) return mean_life();
  switch (kind_) {
    case LifeLawKind::weibull:
      // The series of K117 eq. (1) in closed form; the minimum keeps rounding below the bounds of M.
      return std::min(tau,
                      mean_ * boost::math::gamma_p(1 / shape_, std::pow(tau / scale_, shape_), MathPolicy()));
    case LifeLawKind::normal: {
      const double z = (mean_ - tau) / scale_;
      // g(z) - z = g(-z): the second form has no cancellation for short tau.
      if (z < 0) return scale_ * (integrated_phi(1 / cv_) - integrated_phi(z));
      return std::min(tau, tau - scale_ * (integrated_phi(-z) - integrated_phi(-1 / cv_)));
    }
    case LifeLawKind::exponential:
      return std::min(tau, -mean_ * std::expm1(-tau / mean_));
    case LifeLawKind::lognormal:
    case LifeLawKind::gamma: {
      if (tau == 0) return 0;
      // E[life; life <= tau] + tau R(tau): the first is mean times the failure probability of the law
      // weighted by life itself, which is lognormal or gamma again.
      const double weighted = kind_ == LifeLawKind::lognormal
                                  ? normal_cdf(std::log(tau / scale_) / shape_ - shape_)
                                  : boost::math::gamma_p(shape_ + 1, tau / scale_, MathPolicy());
      return std::min({tau, mean_, mean_ * weighted + tau * reliability(tau)});
    }
  }
  return 0;
}

double LifeLaw::mean_life() const {
  return kind_ == LifeLawKind::normal ? scale_ * integrated_phi(1 / cv_) : mean_;
}

double LifeLaw::gamma_percent_life(double gamma) const {
  switch (kind_) {
    case LifeLawKind::weibull:
      return scale_ * std::pow(-std::log(gamma), 1 / shape_);
    case LifeLawKind::normal:
      return std::max(0.0, mean_ - scale_ * normal_quantile(gamma));
    case LifeLawKind::exponential:
      return -scale_ * std::log(gamma);
    case LifeLawKind::lognormal:
      return scale_ * std::exp(-shape_ * normal_quantile(gamma));
    case LifeLawKind::gamma:
      return scale_ * boost::math::gamma_q_inv(shape_, gamma, MathPolicy());
  }
  return 0;
}

double LifeLaw::quantile(double u) const {
  switch (kind_) {
    case LifeLawKind::weibull:
      return scale_ * std::pow(-std::log1p(-u), 1 / shape_);
    case LifeLawKind::normal:
      return std::max(0.0, mean_ + scale_ * normal_quantile(u));
    case LifeLawKind::exponential:
      return -scale_ * std::log1p(-u);
    case LifeLawKind::lognormal:
      return scale_ * std::exp(shape_ * normal_quantile(u));
    case LifeLawKind::gamma:
      return scale_ * boost::math::gamma_p_inv(shape_, u, MathPolicy());
  }
  return 0;
}

double LifeLaw::renewal_function(double interval, int steps) const {
  require(steps >= 1 && steps <= 100'000, "steps", steps, "allowed 1 <= steps <= 100000");
  if (interval == 0) return 0;
  const auto n = static_cast<std::size_t>(steps);
  const double h = interval / steps;
  // midpoint[n - k] = F((k + 1/2) h), stored backwards so that the convolution runs forwards in both lists.
  std::vector<double> midpoint(n + 1);
  for (std::size_t k = 0; k < n; ++k)
    midpoint[n - k] = failure_probability((static_cast<double>(k) + 0.5) * h);
  const double first = midpoint[n];
  std::vector<double> increment(n + 1, 0.0);
  double renewals = 0;
  for (std::size_t i = 1; i <= n; ++i) {
    // Four partial sums in a fixed order: faster than one, and the same on every machine of a kind.
    double sum0 = 0;
    double sum1 = 0;
    double sum2 = 0;
    double sum3 = 0;
    const double* f = midpoint.data() + (n - i);  // f[j] = F((i - j + 1/2) h)
    const double* dh = increment.data();
    std::size_t j = 1;
    for (; j + 3 < i; j += 4) {
      sum0 += dh[j] * f[j];
      sum1 += dh[j + 1] * f[j + 1];
      sum2 += dh[j + 2] * f[j + 2];
      sum3 += dh[j + 3] * f[j + 3];
    }
    for (; j < i; ++j) sum0 += dh[j] * f[j];
    const double at = failure_probability(static_cast<double>(i) * h);
    const double next = (at + ((sum0 + sum1) + (sum2 + sum3)) - first * renewals) / (1 - first);
    increment[i] = next - renewals;
    renewals = next;
  }
  return renewals;
}

}  // namespace verstat::models
