#include "fit/location_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "fit/fit_error.h"
#include "fit/statistics.h"
#include "models/math/normal.h"
#include "models/math/normal_interval.h"
#include "models/math/solve.h"

namespace verstat::fit {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double log_sqrt_2pi = 0.91893853320467274178;

// A log-probability of z (or of the interval a..b) with its first and second derivatives.
struct Term {
  double value = 0;
  double a = 0, b = 0;            // first derivatives
  double aa = 0, ab = 0, bb = 0;  // second derivatives
};

double log_density(ErrorLaw law, double z) {
  return law == ErrorLaw::normal ? -z * z / 2 - log_sqrt_2pi : z - std::exp(z);
}
// d ln f / dz.
double score(ErrorLaw law, double z) {
  return law == ErrorLaw::normal ? -z : 1 - std::exp(z);
}

Term exact_term(ErrorLaw law, double z) {
  return {
      .value = log_density(law, z), .a = score(law, z), .aa = law == ErrorLaw::normal ? -1.0 : -std::exp(z)};
}

// ln S(z).
Term survival_term(ErrorLaw law, double z) {
  if (law == ErrorLaw::smallest_extreme_value) {
    const double e = std::exp(z);
    return {.value = -e, .a = -e, .aa = -e};
  }
  const double h = models::normal_hazard(z);
  double value = 0;
  if (z < 0)
    value = std::log1p(-models::normal_cdf(z));
  else if (z < 10)
    value = std::log(models::normal_cdf(-z));
  else
    value = log_density(law, z) - std::log(h);
  return {.value = value, .a = -h, .aa = -h * (h - z)};
}

// ln F(z).
Term failure_term(ErrorLaw law, double z) {
  if (law == ErrorLaw::normal) {
    Term mirrored = survival_term(law, -z);
    mirrored.a = -mirrored.a;
    return mirrored;
  }
  const double value = z < -30 ? z : std::log(-std::expm1(-std::exp(z)));
  const double r = std::exp(log_density(law, z) - value);  // f / F
  return {.value = value, .a = r, .aa = r * (score(law, z) - r)};
}

// ln (F(b) - F(a)), a < b, both finite.
Term interval_term(ErrorLaw law, double a, double b) {
  Term t;
  if (law == ErrorLaw::normal) {
    t.value = std::log(std::max(models::normal_between(a, b), 1e-300));
  } else {
    const double gap = std::exp(b) - std::exp(a);
    t.value = -std::exp(a) + std::log(std::max(-std::expm1(-gap), 1e-300));
  }
  const double fa = std::exp(log_density(law, a) - t.value);
  const double fb = std::exp(log_density(law, b) - t.value);
  t.a = -fa;
  t.b = fb;
  t.aa = -fa * score(law, a) - fa * fa;
  t.bb = fb * score(law, b) - fb * fb;
  t.ab = fa * fb;
  return t;
}

// theta = (a, tau); value, gradient and Hessian of the log-likelihood.
struct Local {
  double value = 0;
  VectorXd gradient;
  MatrixXd hessian;
};

double value_at(ErrorLaw law, const CensoredData& data, const VectorXd& theta) {
  const auto p = data.x.cols();
  const double tau = theta[p];
  if (!(tau > 0)) return -infinity;
  double sum = 0;
  for (std::size_t i = 0; i < data.low.size(); ++i) {
    const double shift = data.x.row(static_cast<Eigen::Index>(i)).dot(theta.head(p));
    if (data.low[i] == data.high[i])
      sum += log_density(law, tau * data.low[i] - shift) + std::log(tau);
    else if (data.high[i] == infinity)
      sum += survival_term(law, tau * data.low[i] - shift).value;
    else if (data.low[i] == -infinity)
      sum += failure_term(law, tau * data.high[i] - shift).value;
    else
      sum += interval_term(law, tau * data.low[i] - shift, tau * data.high[i] - shift).value;
  }
  return std::isnan(sum) ? -infinity : sum;
}

Local local_at(ErrorLaw law, const CensoredData& data, const VectorXd& theta) {
  const auto p = data.x.cols();
  const double tau = theta[p];
  Local l{0, VectorXd::Zero(p + 1), MatrixXd::Zero(p + 1, p + 1)};
  VectorXd da(p + 1);
  VectorXd db(p + 1);
  for (std::size_t i = 0; i < data.low.size(); ++i) {
    const auto row = data.x.row(static_cast<Eigen::Index>(i));
    const double shift = row.dot(theta.head(p));
    const double low = data.low[i];
    const double high = data.high[i];
    Term t;
    double y = low;
    if (low == high) {
      t = exact_term(law, tau * low - shift);
      l.value += std::log(tau);
      l.gradient[p] += 1 / tau;
      l.hessian(p, p) -= 1 / (tau * tau);
    } else if (high == infinity) {
      t = survival_term(law, tau * low - shift);
    } else if (low == -infinity) {
      t = failure_term(law, tau * high - shift);
      y = high;
    } else {
      t = interval_term(law, tau * low - shift, tau * high - shift);
      db.head(p) = -row.transpose();
      db[p] = high;
    }
    da.head(p) = -row.transpose();
    da[p] = y;
    l.value += t.value;
    l.gradient += t.a * da;
    l.hessian += t.aa * da * da.transpose();
    if (t.b != 0 || t.bb != 0) {
      l.gradient += t.b * db;
      l.hessian += t.bb * db * db.transpose() + t.ab * (da * db.transpose() + db * da.transpose());
    }
  }
  return l;
}

// c'theta = r, kept by every step; theta is feasible at the start.
using Condition = std::optional<VectorXd>;

// Newton's method with step halving. The log-likelihood is concave, so it converges whenever a maximum
// exists.
VectorXd maximize(ErrorLaw law, const CensoredData& data, VectorXd theta, const Condition& condition) {
  const auto n = theta.size();
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Local l = local_at(law, data, theta);
    VectorXd step;
    if (condition) {
      MatrixXd kkt = MatrixXd::Zero(n + 1, n + 1);
      kkt.topLeftCorner(n, n) = l.hessian;
      kkt.topRightCorner(n, 1) = *condition;
      kkt.bottomLeftCorner(1, n) = condition->transpose();
      VectorXd right = VectorXd::Zero(n + 1);
      right.head(n) = -l.gradient;
      step = kkt.fullPivLu().solve(right).head(n);
    } else {
      step = (-l.hessian).ldlt().solve(l.gradient);
    }
    double gain = l.gradient.dot(step);  // twice what a full step of a quadratic would bring
    const bool newton = step.allFinite() && gain >= 0;
    if (!newton) {
      // A flat or badly scaled place: along the gradient instead.
      step = l.gradient;
      if (condition) step -= *condition * (condition->dot(step) / condition->squaredNorm());
      step *= 1 / std::max(1.0, step.norm());
      gain = l.gradient.dot(step);
    }
    if (gain <= 1e-13 * std::max(1.0, std::abs(l.value))) {
      // Quadratic convergence: the last step, too small to show in the likelihood, still doubles the digits.
      if (newton) theta += step;
      return theta;
    }
    double fraction = 1;
    VectorXd next = theta + step;
    double value = value_at(law, data, next);
    while (value < l.value + 1e-4 * fraction * gain && fraction > 1e-12) {
      fraction /= 2;
      next = theta + fraction * step;
      value = value_at(law, data, next);
    }
    if (fraction <= 1e-12) return theta;  // as far as doubles go
    theta = next;
    if (!(theta.norm() < 1e9)) break;
  }
  throw FitError("the likelihood has no finite maximum: too few different failures for what is asked");
}

// Least squares on the middles of what is known: near enough for Newton.
VectorXd start_of(const CensoredData& data) {
  const auto n = static_cast<Eigen::Index>(data.low.size());
  VectorXd y(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    y[i] = data.high[k] == infinity   ? data.low[k]
           : data.low[k] == -infinity ? data.high[k]
                                      : (data.low[k] + data.high[k]) / 2;
  }
  const VectorXd b = data.x.colPivHouseholderQr().solve(y);
  const double spread = std::sqrt((y - data.x * b).squaredNorm() / static_cast<double>(n));
  const double size = y.cwiseAbs().maxCoeff();
  const double sigma = std::max(spread, 1e-3 * std::max(size, 1e-6));
  VectorXd theta(b.size() + 1);
  theta.head(b.size()) = b / sigma;
  theta[b.size()] = 1 / sigma;
  return theta;
}

RegressionFit fit_of(ErrorLaw law, const CensoredData& data, const VectorXd& theta, bool sigma_given) {
  const auto p = data.x.cols();
  RegressionFit fit;
  fit.sigma = 1 / theta[p];
  fit.coefficients = theta.head(p) * fit.sigma;
  const Local l = local_at(law, data, theta);
  fit.log_likelihood = l.value;
  if (sigma_given) {
    fit.covariance = (-l.hessian.topLeftCorner(p, p)).inverse() * (fit.sigma * fit.sigma);
  } else {
    // b = a / tau, ln sigma = -ln tau.
    MatrixXd jacobian = MatrixXd::Zero(p + 1, p + 1);
    jacobian.topLeftCorner(p, p) = MatrixXd::Identity(p, p) * fit.sigma;
    jacobian.topRightCorner(p, 1) = -fit.coefficients * fit.sigma;
    jacobian(p, p) = -fit.sigma;
    fit.covariance = jacobian * (-l.hessian).inverse() * jacobian.transpose();
  }
  for (Eigen::Index k = 0; k < fit.covariance.rows(); ++k)
    if (!(fit.covariance(k, k) > 0) || !(fit.covariance(k, k) < 1e12))
      throw FitError(
          "the data do not determine the parameters: too few different failures for what is asked");
  return fit;
}

VectorXd theta_of(const RegressionFit& fit) {
  const auto p = fit.coefficients.size();
  VectorXd theta(p + 1);
  theta.head(p) = fit.coefficients / fit.sigma;
  theta[p] = 1 / fit.sigma;
  return theta;
}

void check(const CensoredData& data, bool sigma_given) {
  std::size_t failures = 0;
  double least = infinity;
  double most = -infinity;
  bool distinct = false;
  for (std::size_t i = 0; i < data.low.size(); ++i) {
    if (data.high[i] == infinity) continue;
    ++failures;
    // Two failures that cannot have been at the same moment.
    if (data.low[i] > least || data.high[i] < most) distinct = true;
    least = std::min(least, data.high[i]);
    most = std::max(most, data.low[i]);
  }
  if (failures == 0) throw FitError("no failure: every observation is censored");
  if (sigma_given) return;
  // A failure at one value and survivors beyond it are enough for a finite scale only with a second failure.
  if (failures < 2 || (!distinct && data.x.cols() == 1))
    throw FitError("fewer than two different failures: the scatter cannot be told");
}

}  // namespace

double standard_quantile(ErrorLaw law, double p) {
  return law == ErrorLaw::normal ? models::normal_quantile(p) : std::log(-std::log1p(-p));
}

double standard_cdf(ErrorLaw law, double z) {
  return law == ErrorLaw::normal ? models::normal_cdf(z) : -std::expm1(-std::exp(z));
}

double log_likelihood(ErrorLaw law, const CensoredData& data, const VectorXd& coefficients, double sigma) {
  VectorXd theta(coefficients.size() + 1);
  theta.head(coefficients.size()) = coefficients / sigma;
  theta[coefficients.size()] = 1 / sigma;
  return value_at(law, data, theta);
}

RegressionFit fit_regression(ErrorLaw law, const CensoredData& data, std::optional<double> sigma) {
  check(data, sigma.has_value());
  VectorXd theta = start_of(data);
  Condition condition;
  if (sigma) {
    const auto p = data.x.cols();
    theta.head(p) *= 1 / (*sigma * theta[p]);
    theta[p] = 1 / *sigma;
    condition = VectorXd::Unit(p + 1, p);
  }
  return fit_of(law, data, maximize(law, data, theta, condition), sigma.has_value());
}

double likelihood_drop(double confidence) {
  return chi_square_quantile(confidence, 1) / 2;
}

double likelihood_drop(double confidence, double observations, double degrees) {
  const double t = student_quantile(confidence, degrees);
  return observations / 2 * std::log1p(t * t / degrees);
}

ProfileBounds profile_bounds(ErrorLaw law, const CensoredData& data, const RegressionFit& fit,
                             const Question& question, double drop, std::optional<double> sigma) {
  const auto p = data.x.cols();
  const bool of_sigma = question.x.size() == 0;
  const VectorXd theta = theta_of(fit);
  ProfileBounds bounds;
  // sigma is profiled on the log scale: its bounds stay positive.
  bounds.estimate =
      of_sigma ? std::log(fit.sigma) : question.x.dot(fit.coefficients) + fit.sigma * question.z;
  double error = 0;
  if (of_sigma) {
    error = std::sqrt(fit.covariance(p, p));
  } else {
    VectorXd slope = VectorXd::Zero(fit.covariance.rows());
    slope.head(p) = question.x;
    if (!sigma) slope[p] = fit.sigma * question.z;
    error = std::sqrt(slope.dot(fit.covariance * slope));
  }

  // Log-likelihood lost when the answer is held at q. With x'b + sigma z = q, in (a, tau): x'a - q tau = -z.
  VectorXd warm = theta;
  const auto lost = [&](double q) {
    VectorXd at = warm;
    VectorXd condition = VectorXd::Zero(p + 1);
    if (of_sigma) {
      at.head(p) *= std::exp(-q) / at[p];
      at[p] = std::exp(-q);
      condition[p] = 1;
    } else {
      if (sigma) at[p] = 1 / *sigma;
      at.head(p) +=
          question.x * ((q * at[p] - question.z - question.x.dot(at.head(p))) / question.x.squaredNorm());
      condition.head(p) = question.x;
      condition[p] = -q;
    }
    if (sigma) {
      // Two conditions: sigma is given and so is the answer. One coefficient is then determined by the other
      // ones; with a single coefficient nothing is left to maximise.
      if (p > 1) throw FitError("profiles with a given scale are for one coefficient");
      return fit.log_likelihood - value_at(law, data, at);
    }
    warm = maximize(law, data, at, condition);
    return fit.log_likelihood - value_at(law, data, warm);
  };
  const auto bound = [&](double side) {
    warm = theta;
    double inside = 0;
    double reach = 1.5 * error;
    for (int k = 0; k < 40; ++k) {
      double at_reach = 0;
      try {
        at_reach = lost(bounds.estimate + side * reach);
      } catch (const FitError&) {
        return side * infinity;
      }
      if (at_reach > drop) {
        const double offset =
            models::find_root([&](double s) { return lost(bounds.estimate + side * s) - drop; },
                              std::max(inside, 1e-9 * error), reach, 1e-7);
        return bounds.estimate + side * offset;
      }
      inside = reach;
      reach *= 1.6;
      if (reach > 1e4 * error) break;
    }
    return side * infinity;
  };
  bounds.low = bound(-1);
  bounds.high = bound(1);
  if (of_sigma) {
    bounds.estimate = fit.sigma;
    bounds.low = std::exp(bounds.low);
    bounds.high = std::exp(bounds.high);
  }
  return bounds;
}

}  // namespace verstat::fit
