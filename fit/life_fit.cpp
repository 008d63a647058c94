#include "fit/life_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <boost/math/special_functions/gamma.hpp>

#include "fit/fit_error.h"
#include "fit/location_scale.h"
#include "models/math/life_law.h"
#include "models/math/normal.h"
#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::fit {
namespace {

using models::MathPolicy;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool of_logarithm(LifeFamily family) {
  return family != LifeFamily::normal;
}
ErrorLaw error_law(LifeFamily family) {
  return family == LifeFamily::weibull || family == LifeFamily::exponential ? ErrorLaw::smallest_extreme_value
                                                                            : ErrorLaw::normal;
}

// The lives as data of a regression on a constant.
struct Prepared {
  CensoredData data;
  double jacobian = 0;  // ln dt/dy of the exact lives: likelihood per unit of time, comparable between laws
};
Prepared prepare(LifeFamily family, const std::vector<Observation>& lives) {
  Prepared p;
  p.data.x = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(lives.size()), 1);
  const bool logarithm = of_logarithm(family);
  for (const Observation& o : lives) {
    // A life that ended somewhere before `high`: no lower bound on either scale.
    const double low = o.low <= 0 ? -infinity : logarithm ? std::log(o.low) : o.low;
    const double high = logarithm ? std::log(o.high) : o.high;
    p.data.low.push_back(low);
    p.data.high.push_back(high);
    if (logarithm && o.exact()) p.jacobian -= low;
  }
  return p;
}

double gamma_log_likelihood(double shape, double scale, const std::vector<Observation>& lives) {
  const double norm = boost::math::lgamma(shape, MathPolicy()) + shape * std::log(scale);
  const auto upper = [&](double t) {
    return t <= 0 ? 1 : boost::math::gamma_q(shape, t / scale, MathPolicy());
  };
  const auto lower = [&](double t) {
    return t <= 0 ? 0 : boost::math::gamma_p(shape, t / scale, MathPolicy());
  };
  double sum = 0;
  for (const Observation& o : lives) {
    if (o.exact()) {
      sum += (shape - 1) * std::log(o.low) - o.low / scale - norm;
    } else {
      const double p = !o.failed()             ? upper(o.low)
                       : o.low > shape * scale ? upper(o.low) - upper(o.high)
                                               : lower(o.high) - lower(o.low);
      sum += std::log(std::max(p, 1e-300));
    }
  }
  return sum;
}

// Maximum of a smooth function of two variables: Newton on central differences, halved steps.
struct Point2 {
  double x = 0;
  double y = 0;
};
Point2 maximize2(const std::function<double(double, double)>& f, Point2 at) {
  constexpr double h = 2e-4;
  double here = f(at.x, at.y);
  for (int iteration = 0; iteration < 200; ++iteration) {
    const double xp = f(at.x + h, at.y);
    const double xm = f(at.x - h, at.y);
    const double yp = f(at.x, at.y + h);
    const double ym = f(at.x, at.y - h);
    const double cross =
        f(at.x + h, at.y + h) - f(at.x + h, at.y - h) - f(at.x - h, at.y + h) + f(at.x - h, at.y - h);
    const double gx = (xp - xm) / (2 * h);
    const double gy = (yp - ym) / (2 * h);
    const double hxx = (xp - 2 * here + xm) / (h * h);
    const double hyy = (yp - 2 * here + ym) / (h * h);
    const double hxy = cross / (4 * h * h);
    const double determinant = hxx * hyy - hxy * hxy;
    double dx = gx;
    double dy = gy;
    if (hxx < 0 && determinant > 0) {
      dx = -(hyy * gx - hxy * gy) / determinant;
      dy = -(hxx * gy - hxy * gx) / determinant;
    }
    const double longest = std::max(std::abs(dx), std::abs(dy));
    if (longest > 1) {
      dx /= longest;
      dy /= longest;
    }
    const double gain = gx * dx + gy * dy;
    if (gain < 1e-12 * std::max(1.0, std::abs(here))) return at;
    double fraction = 1;
    double there = f(at.x + dx, at.y + dy);
    while (!(there > here) && fraction > 1e-7) {
      fraction /= 2;
      there = f(at.x + fraction * dx, at.y + fraction * dy);
    }
    if (!(there > here)) return at;
    at = {at.x + fraction * dx, at.y + fraction * dy};
    here = there;
    if (std::abs(at.x) > 12) break;  // shape beyond e^12: a constant, or e^-12: nothing
  }
  throw FitError("the likelihood of the gamma law has no finite maximum: too few different failures");
}

FittedLaw fit_gamma(const std::vector<Observation>& lives) {
  std::size_t failures = 0;
  double sum = 0;
  double squares = 0;
  double least = infinity;
  double most = -infinity;
  for (const Observation& o : lives) {
    sum += o.at();
    squares += o.at() * o.at();
    if (!o.failed()) continue;
    ++failures;
    least = std::min(least, o.high);
    most = std::max(most, o.low);
  }
  if (failures < 2 || most <= least)
    throw FitError("fewer than two different failures: the scatter cannot be told");
  const auto n = static_cast<double>(lives.size());
  const double mean = sum / n;
  const double variance = std::max(squares / n - mean * mean, 1e-6 * mean * mean);
  const auto f = [&](double log_shape, double log_mean) {
    if (std::abs(log_shape) > 13) return -infinity;
    const double shape = std::exp(log_shape);
    return gamma_log_likelihood(shape, std::exp(log_mean) / shape, lives);
  };
  const double censored_share = 1 - static_cast<double>(failures) / n;
  const Point2 start{std::clamp(std::log(mean * mean / variance), -2.0, 6.0),
                     std::log(mean) + std::min(censored_share, 0.9)};
  const Point2 best = maximize2(f, start);
  FittedLaw law{.family = LifeFamily::gamma, .second = std::exp(best.x)};
  law.first = std::exp(best.y) / law.second;
  law.log_likelihood = f(best.x, best.y);
  return law;
}

// The law of a family whose mean or p-quantile is q and whose second parameter is s.
FittedLaw law_with(LifeFamily family, LifeQuantity quantity, double q, double s, double p) {
  FittedLaw law{.family = family, .first = 1, .second = s};
  const bool quantile = quantity == LifeQuantity::quantile;
  switch (family) {
    case LifeFamily::weibull:
    case LifeFamily::gamma:
      law.first = quantity == LifeQuantity::first ? q : q / (quantile ? law.quantile(p) : law.mean());
      break;
    case LifeFamily::lognormal:
      law.first = 0;
      law.first = std::log(q / (quantile ? law.quantile(p) : law.mean()));
      break;
    case LifeFamily::normal:
      law.first = quantile ? q - s * models::normal_quantile(p) : q;
      break;
    case LifeFamily::exponential:
      law.first = quantile ? q / law.quantile(p) : q;
      break;
  }
  return law;
}

// Profile over the second parameter, on logarithmic scales, for quantities above zero.
Interval numeric_bounds(const FittedLaw& law, double estimate, double drop,
                        const std::function<double(double q)>& profile) {
  const auto side = [&](double sign) {
    double inside = 0;
    double reach = 0.05;
    for (int k = 0; k < 30; ++k) {
      if (law.log_likelihood - profile(estimate * std::exp(sign * reach)) > drop) {
        const double offset = models::find_root(
            [&](double s) { return law.log_likelihood - profile(estimate * std::exp(sign * s)) - drop; },
            inside, reach, 1e-6);
        return estimate * std::exp(sign * offset);
      }
      inside = reach;
      reach *= 1.6;
      if (reach > 200) break;
    }
    return sign > 0 ? infinity : 0.0;
  };
  return {side(-1), side(1)};
}

}  // namespace

const char* name_of(LifeFamily family) {
  switch (family) {
    case LifeFamily::weibull:
      return "weibull";
    case LifeFamily::lognormal:
      return "lognormal";
    case LifeFamily::normal:
      return "normal";
    case LifeFamily::gamma:
      return "gamma";
    case LifeFamily::exponential:
      return "exponential";
  }
  return "";
}

std::size_t failures_in(const std::vector<Observation>& lives) {
  return static_cast<std::size_t>(
      std::count_if(lives.begin(), lives.end(), [](const auto& o) { return o.failed(); }));
}

double FittedLaw::mean() const {
  switch (family) {
    case LifeFamily::weibull:
      return first * boost::math::tgamma(1 + 1 / second, MathPolicy());
    case LifeFamily::lognormal:
      return std::exp(first + second * second / 2);
    case LifeFamily::gamma:
      return first * second;
    case LifeFamily::normal:
    case LifeFamily::exponential:
      return first;
  }
  return 0;
}

double FittedLaw::cv() const {
  switch (family) {
    case LifeFamily::weibull:
      return models::weibull_cv(second);
    case LifeFamily::lognormal:
      return std::sqrt(std::expm1(second * second));
    case LifeFamily::gamma:
      return 1 / std::sqrt(second);
    case LifeFamily::normal:
      return second / first;
    case LifeFamily::exponential:
      return 1;
  }
  return 0;
}

double FittedLaw::cdf(double t) const {
  if (family == LifeFamily::normal) return models::normal_cdf((t - first) / second);
  if (t <= 0) return 0;
  switch (family) {
    case LifeFamily::weibull:
      return -std::expm1(-std::pow(t / first, second));
    case LifeFamily::lognormal:
      return models::normal_cdf((std::log(t) - first) / second);
    case LifeFamily::gamma:
      return boost::math::gamma_p(second, t / first, MathPolicy());
    default:
      return -std::expm1(-t / first);
  }
}

double FittedLaw::quantile(double p) const {
  switch (family) {
    case LifeFamily::weibull:
      return first * std::pow(-std::log1p(-p), 1 / second);
    case LifeFamily::lognormal:
      return std::exp(first + second * models::normal_quantile(p));
    case LifeFamily::normal:
      return first + second * models::normal_quantile(p);
    case LifeFamily::gamma:
      return first * boost::math::gamma_p_inv(second, p, MathPolicy());
    case LifeFamily::exponential:
      return -first * std::log1p(-p);
  }
  return 0;
}

FittedLaw fit_law(LifeFamily family, const std::vector<Observation>& lives) {
  FittedLaw law{.family = family};
  if (family == LifeFamily::gamma) {
    law = fit_gamma(lives);
  } else {
    const Prepared prepared = prepare(family, lives);
    const bool exponential = family == LifeFamily::exponential;
    const RegressionFit fit = fit_regression(error_law(family), prepared.data,
                                             exponential ? std::optional<double>(1.0) : std::nullopt);
    const double location = fit.coefficients[0];
    law.log_likelihood = fit.log_likelihood + prepared.jacobian;
    switch (family) {
      case LifeFamily::weibull:
        law.first = std::exp(location);
        law.second = 1 / fit.sigma;
        break;
      case LifeFamily::exponential:
        law.first = std::exp(location);
        break;
      default:
        law.first = location;
        law.second = fit.sigma;
    }
  }
  const auto failures = static_cast<double>(failures_in(lives));
  const double k = law.parameters();
  law.aicc =
      failures > k + 1 ? -2 * law.log_likelihood + 2 * k + 2 * k * (k + 1) / (failures - k - 1) : infinity;
  return law;
}

double log_likelihood(const FittedLaw& law, const std::vector<Observation>& lives) {
  if (law.family == LifeFamily::gamma) return gamma_log_likelihood(law.second, law.first, lives);
  const Prepared prepared = prepare(law.family, lives);
  const bool log_scale = law.family == LifeFamily::weibull || law.family == LifeFamily::exponential;
  const double sigma = law.family == LifeFamily::weibull       ? 1 / law.second
                       : law.family == LifeFamily::exponential ? 1
                                                               : law.second;
  return log_likelihood(error_law(law.family), prepared.data,
                        Eigen::VectorXd::Constant(1, log_scale ? std::log(law.first) : law.first), sigma) +
         prepared.jacobian;
}

LifeRanking rank_laws(const std::vector<Observation>& lives) {
  LifeRanking ranking;
  for (const LifeFamily family : life_families) {
    try {
      ranking.laws.push_back(fit_law(family, lives));
    } catch (const FitError& e) {
      ranking.unfitted.push_back({family, e.what()});
    }
  }
  const auto aic = [](const FittedLaw& law) { return -2 * law.log_likelihood + 2 * law.parameters(); };
  std::stable_sort(ranking.laws.begin(), ranking.laws.end(), [&](const FittedLaw& a, const FittedLaw& b) {
    return a.aicc != b.aicc ? a.aicc < b.aicc : aic(a) < aic(b);
  });
  return ranking;
}

Interval life_bounds(const FittedLaw& law, const std::vector<Observation>& lives, LifeQuantity quantity,
                     double confidence, double p) {
  const double drop = likelihood_drop(confidence);
  const LifeFamily family = law.family;
  const bool exponential = family == LifeFamily::exponential;
  if (quantity == LifeQuantity::second && exponential) return {1, 1};
  const bool linear = family != LifeFamily::gamma &&
                      (quantity != LifeQuantity::mean || family == LifeFamily::normal || exponential);
  if (linear) {
    const Prepared prepared = prepare(family, lives);
    const auto sigma = exponential ? std::optional<double>(1.0) : std::nullopt;
    const RegressionFit fit = fit_regression(error_law(family), prepared.data, sigma);
    Question question{Eigen::VectorXd::Ones(1), 0};
    if (quantity == LifeQuantity::quantile) question.z = standard_quantile(error_law(family), p);
    if (quantity == LifeQuantity::second) question = {};
    const ProfileBounds b = profile_bounds(error_law(family), prepared.data, fit, question, drop, sigma);
    if (quantity == LifeQuantity::second)
      return family == LifeFamily::weibull ? Interval{1 / b.high, 1 / b.low} : Interval{b.low, b.high};
    const bool raw =
        family == LifeFamily::normal || (family == LifeFamily::lognormal && quantity == LifeQuantity::first);
    return raw ? Interval{b.low, b.high} : Interval{std::exp(b.low), std::exp(b.high)};
  }
  if (quantity == LifeQuantity::second) {
    return numeric_bounds(law, law.second, drop, [&](double s) {
      return -models::minimize_unimodal(
                  [&](double log_mean) {
                    FittedLaw at = law;
                    at.second = s;
                    at.first = std::exp(log_mean) / s;
                    return -log_likelihood(at, lives);
                  },
                  std::log(law.mean()) - 3, std::log(law.mean()) + 3, 1e-7)
                  .value;
    });
  }
  const double estimate = quantity == LifeQuantity::mean       ? law.mean()
                          : quantity == LifeQuantity::quantile ? law.quantile(p)
                                                               : law.first;
  return numeric_bounds(law, estimate, drop, [&](double q) {
    const double middle = std::log(law.second);
    return -models::minimize_unimodal(
                [&](double log_second) {
                  const double l =
                      log_likelihood(law_with(family, quantity, q, std::exp(log_second), p), lives);
                  return std::isfinite(l) ? -l : 1e300;
                },
                middle - 2.5, middle + 2.5, 1e-7)
                .value;
  });
}

}  // namespace verstat::fit
