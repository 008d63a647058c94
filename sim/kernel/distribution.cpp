#include "sim/kernel/distribution.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/gamma.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

#include "sim/kernel/engine.h"
#include "sim/kernel/math_policy.h"
#include "sim/kernel/normal_law.h"

namespace verstat::sim {

using detail::MathPolicy;
using detail::text_of;
namespace law = detail::law;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

[[noreturn]] void refuse(std::string_view what, std::string_view name, double value,
                         std::string_view allowed) {
  throw std::invalid_argument("distribution " + std::string(what) + ": " + std::string(name) + " = " +
                              text_of(value) + ", allowed " + std::string(allowed));
}

void need_finite(std::string_view what, std::initializer_list<std::pair<std::string_view, double>> values) {
  for (const auto& [name, value] : values) {
    if (!std::isfinite(value)) refuse(what, name, value, "finite numbers");
  }
}

void need_positive(std::string_view what, std::string_view name, double value) {
  if (!(value > 0.0) || std::isinf(value)) refuse(what, name, value, "finite and > 0");
}

double square(double x) {
  return x * x;
}

double gamma_function(double x) {
  return boost::math::tgamma(x, MathPolicy());
}

/// Squared coefficient of variation of the Weibull law.
double weibull_cv_squared(double shape) {
  // Through logarithms: for shapes near 0.05 the gamma functions themselves overflow.
  return std::expm1(boost::math::lgamma(1.0 + 2.0 / shape, MathPolicy()) -
                    2.0 * boost::math::lgamma(1.0 + 1.0 / shape, MathPolicy()));
}

template <class... Fs>
struct Overload : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overload(Fs...) -> Overload<Fs...>;

using GammaLaw = boost::math::gamma_distribution<double, MathPolicy>;
using BetaLaw = boost::math::beta_distribution<double, MathPolicy>;

std::size_t discrete_index(const std::vector<double>& cumulative, double p) {
  const auto at = std::lower_bound(cumulative.begin(), cumulative.end(), p);
  const auto last = std::prev(cumulative.end());
  return static_cast<std::size_t>(std::min(at, last) - cumulative.begin());
}

}  // namespace

Distribution Distribution::constant(double value) {
  need_finite("constant", {{"value", value}});
  return Distribution(law::Constant{value});
}

Distribution Distribution::uniform(double low, double high) {
  need_finite("uniform", {{"low", low}, {"high", high}});
  if (low > high) refuse("uniform", "low", low, "<= high = " + text_of(high));
  return Distribution(law::Uniform{low, high});
}

Distribution Distribution::triangular(double low, double mode, double high) {
  need_finite("triangular", {{"low", low}, {"mode", mode}, {"high", high}});
  if (!(low < high)) refuse("triangular", "low", low, "< high = " + text_of(high));
  if (mode < low || mode > high) {
    refuse("triangular", "mode", mode, "from low = " + text_of(low) + " to high = " + text_of(high));
  }
  return Distribution(law::Triangular{low, mode, high});
}

Distribution Distribution::exponential(double mean) {
  need_positive("exponential", "mean", mean);
  return Distribution(law::Exponential{mean});
}

Distribution Distribution::erlang(int phases, double mean) {
  if (phases < 1) refuse("erlang", "phases", phases, ">= 1");
  need_positive("erlang", "mean", mean);
  return Distribution(law::Gamma{static_cast<double>(phases), mean / phases});
}

Distribution Distribution::gamma(double shape, double scale) {
  need_positive("gamma", "shape", shape);
  need_positive("gamma", "scale", scale);
  return Distribution(law::Gamma{shape, scale});
}

Distribution Distribution::normal(double mean, double sd) {
  need_finite("normal", {{"mean", mean}, {"sd", sd}});
  if (sd < 0.0) refuse("normal", "sd", sd, ">= 0");
  return Distribution(law::Normal{mean, sd});
}

Distribution Distribution::truncated_normal(double mean, double sd, double low, double high) {
  need_finite("truncated_normal", {{"mean", mean}});
  need_positive("truncated_normal", "sd", sd);
  if (!(low < high)) refuse("truncated_normal", "low", low, "< high = " + text_of(high));
  // Deep in the upper tail differences of cdf values cancel: such laws are mirrored.
  if (low > mean) {
    const double mass_below = detail::normal_cdf((mean - high) / sd);
    const double mass = detail::normal_cdf((mean - low) / sd) - mass_below;
    if (!(mass >= 1e-12)) refuse("truncated_normal", "probability of the interval", mass, ">= 1e-12");
    return Distribution(law::TruncatedNormal{mean, -sd, low, high, mass_below, mass});
  }
  const double mass_below = detail::normal_cdf((low - mean) / sd);
  const double mass = detail::normal_cdf((high - mean) / sd) - mass_below;
  if (!(mass >= 1e-12)) refuse("truncated_normal", "probability of the interval", mass, ">= 1e-12");
  return Distribution(law::TruncatedNormal{mean, sd, low, high, mass_below, mass});
}

Distribution Distribution::lognormal(double mean, double cv) {
  need_positive("lognormal", "mean", mean);
  if (!(cv >= 0.0) || std::isinf(cv)) refuse("lognormal", "cv", cv, "finite and >= 0");
  const double log_variance = std::log1p(cv * cv);
  return Distribution(law::Lognormal{std::log(mean) - 0.5 * log_variance, std::sqrt(log_variance)});
}

Distribution Distribution::weibull(double scale, double shape) {
  need_positive("weibull", "scale", scale);
  need_positive("weibull", "shape", shape);
  return Distribution(law::Weibull{scale, shape});
}

Distribution Distribution::weibull_mean_cv(double mean, double cv) {
  need_positive("weibull_mean_cv", "mean", mean);
  if (!(cv >= 0.01 && cv <= 20.0)) refuse("weibull_mean_cv", "cv", cv, "from 0.01 to 20");
  // cv decreases in the shape; bisection in the logarithm of the shape to the last bit, then
  // scale = mean / Gamma(1 + 1/shape).
  double low = std::log(0.1);
  double high = std::log(200.0);
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (weibull_cv_squared(std::exp(middle)) > cv * cv ? low : high) = middle;
  }
  const double shape = std::exp(0.5 * (low + high));
  return Distribution(law::Weibull{mean / gamma_function(1.0 + 1.0 / shape), shape});
}

Distribution Distribution::beta(double a, double b, double low, double high) {
  need_positive("beta", "a", a);
  need_positive("beta", "b", b);
  need_finite("beta", {{"low", low}, {"high", high}});
  if (!(low < high)) refuse("beta", "low", low, "< high = " + text_of(high));
  return Distribution(law::Beta{a, b, low, high});
}

Distribution Distribution::pert(double low, double mode, double high) {
  need_finite("pert", {{"low", low}, {"mode", mode}, {"high", high}});
  if (!(low < high)) refuse("pert", "low", low, "< high = " + text_of(high));
  if (mode < low || mode > high) {
    refuse("pert", "mode", mode, "from low = " + text_of(low) + " to high = " + text_of(high));
  }
  const double at = (mode - low) / (high - low);
  return Distribution(law::Beta{1.0 + 4.0 * at, 1.0 + 4.0 * (1.0 - at), low, high});
}

Distribution Distribution::discrete(const std::vector<double>& values, const std::vector<double>& weights) {
  if (values.empty() || values.size() != weights.size()) {
    throw std::invalid_argument("distribution discrete: " + std::to_string(values.size()) + " values and " +
                                std::to_string(weights.size()) +
                                " weights, must be as many and at least one");
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) refuse("discrete", "value", values[i], "finite numbers");
    if (!(weights[i] >= 0.0) || std::isinf(weights[i]))
      refuse("discrete", "weight", weights[i], "finite and >= 0");
    sum += weights[i];
  }
  if (!(sum > 0.0) || std::isinf(sum)) refuse("discrete", "sum of weights", sum, "finite and > 0");
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (weights[i] > 0.0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return values[i] < values[k]; });
  auto sorted = std::make_shared<std::vector<double>>();
  auto cumulative = std::make_shared<std::vector<double>>();
  double so_far = 0.0;
  for (const std::size_t i : order) {
    so_far += weights[i];
    if (!sorted->empty() && sorted->back() == values[i]) {
      cumulative->back() = so_far / sum;
      continue;
    }
    sorted->push_back(values[i]);
    cumulative->push_back(so_far / sum);
  }
  cumulative->back() = 1.0;
  return Distribution(law::Discrete{std::move(sorted), std::move(cumulative)});
}

Distribution Distribution::empirical(const std::vector<double>& observations) {
  if (observations.size() < 2) {
    throw std::invalid_argument("distribution empirical: " + std::to_string(observations.size()) +
                                " observations, at least 2 needed");
  }
  for (const double x : observations) {
    if (!std::isfinite(x)) refuse("empirical", "observation", x, "finite numbers");
  }
  auto sorted = std::make_shared<std::vector<double>>(observations);
  std::sort(sorted->begin(), sorted->end());
  return Distribution(law::Empirical{std::move(sorted)});
}

Distribution Distribution::empirical(const std::vector<double>& observations,
                                     const std::vector<double>& weights) {
  if (weights.size() != observations.size()) {
    throw std::invalid_argument("distribution empirical: " + std::to_string(observations.size()) +
                                " observations and " + std::to_string(weights.size()) +
                                " weights, must be as many");
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!std::isfinite(observations[i]))
      refuse("empirical", "observation", observations[i], "finite numbers");
    if (!(weights[i] >= 0.0) || std::isinf(weights[i]))
      refuse("empirical", "weight", weights[i], "finite and >= 0");
    if (weights[i] > 0.0) order.push_back(i);
  }
  if (order.size() < 2) {
    throw std::invalid_argument("distribution empirical: " + std::to_string(order.size()) +
                                " observations with a weight above 0, at least 2 needed");
  }
  if (std::all_of(order.begin(), order.end(),
                  [&](std::size_t i) { return weights[i] == weights[order[0]]; })) {
    std::vector<double> alike;
    alike.reserve(order.size());
    for (const std::size_t i : order) alike.push_back(observations[i]);
    return empirical(alike);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return observations[i] < observations[k]; });
  auto values = std::make_shared<std::vector<double>>();
  auto cumulative = std::make_shared<std::vector<double>>();
  double so_far = 0.0;
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (n > 0) so_far += 0.5 * (weights[order[n - 1]] + weights[order[n]]);
    values->push_back(observations[order[n]]);
    cumulative->push_back(so_far);
  }
  if (std::isinf(so_far)) refuse("empirical", "sum of weights", so_far, "finite");
  for (double& p : *cumulative) p /= so_far;
  return Distribution(law::WeightedEmpirical{std::move(values), std::move(cumulative)});
}

double Distribution::quantile_open(double u) const {
  return std::visit(
      Overload{
          [](const law::Constant& d) { return d.value; },
          [u](const law::Uniform& d) { return d.low + (d.high - d.low) * u; },
          [u](const law::Triangular& d) {
            const double width = d.high - d.low;
            const double rising = (d.mode - d.low) / width;
            return u < rising ? d.low + std::sqrt(u * width * (d.mode - d.low))
                              : d.high - std::sqrt((1.0 - u) * width * (d.high - d.mode));
          },
          [u](const law::Exponential& d) { return -d.mean * std::log1p(-u); },
          [u](const law::Gamma& d) { return d.scale * boost::math::gamma_p_inv(d.shape, u, MathPolicy()); },
          [u](const law::Normal& d) { return d.mean + d.sd * detail::normal_quantile(u); },
          [u](const law::TruncatedNormal& d) {
            // A negative sd marks the mirrored law, which decreases in its own u.
            const double v = d.sd > 0.0 ? u : 1.0 - u;
            const double x = d.mean + d.sd * detail::normal_quantile(d.mass_below + v * d.mass);
            return std::clamp(x, d.low, d.high);
          },
          [u](const law::Lognormal& d) {
            return std::exp(d.log_mean + d.log_sd * detail::normal_quantile(u));
          },
          [u](const law::Weibull& d) { return d.scale * std::pow(-std::log1p(-u), 1.0 / d.shape); },
          [u](const law::Beta& d) {
            return d.low + (d.high - d.low) * boost::math::quantile(BetaLaw(d.a, d.b), u);
          },
          [u](const law::Discrete& d) { return (*d.values)[discrete_index(*d.cumulative, u)]; },
          [u](const law::Empirical& d) {
            const double at = u * static_cast<double>(d.sorted->size() - 1);
            const auto i = static_cast<std::size_t>(at);
            const double low = (*d.sorted)[i];
            if (i + 1 == d.sorted->size()) return low;
            return low + (at - static_cast<double>(i)) * ((*d.sorted)[i + 1] - low);
          },
          [u](const law::WeightedEmpirical& d) {
            const std::vector<double>& p = *d.cumulative;
            const std::vector<double>& x = *d.values;
            // 0 = p[0] < u < 1 = p.back(), so there is a piece around u.
            const auto i = static_cast<std::size_t>(std::lower_bound(p.begin(), p.end(), u) - p.begin());
            return x[i - 1] + (u - p[i - 1]) / (p[i] - p[i - 1]) * (x[i] - x[i - 1]);
          },
      },
      law_);
}

double Distribution::quantile(double p) const {
  if (!(p >= 0.0 && p <= 1.0)) {
    throw std::invalid_argument("quantile of " + describe() + ": p = " + text_of(p) +
                                ", allowed 0 <= p <= 1");
  }
  if (p > 0.0 && p < 1.0) return quantile_open(p);
  const bool upper = p == 1.0;
  return std::visit(
      Overload{
          [](const law::Constant& d) { return d.value; },
          [upper](const law::Uniform& d) { return upper ? d.high : d.low; },
          [upper](const law::Triangular& d) { return upper ? d.high : d.low; },
          [upper](const law::Exponential&) { return upper ? infinity : 0.0; },
          [upper](const law::Gamma&) { return upper ? infinity : 0.0; },
          [upper](const law::Normal& d) { return d.sd == 0.0 ? d.mean
                                                 : upper     ? infinity
                                                             : -infinity; },
          [upper](const law::TruncatedNormal& d) { return upper ? d.high : d.low; },
          [upper](const law::Lognormal& d) {
            return d.log_sd == 0.0 ? std::exp(d.log_mean) : upper ? infinity : 0.0;
          },
          [upper](const law::Weibull&) { return upper ? infinity : 0.0; },
          [upper](const law::Beta& d) { return upper ? d.high : d.low; },
          [upper](const law::Discrete& d) { return upper ? d.values->back() : d.values->front(); },
          [upper](const law::Empirical& d) { return upper ? d.sorted->back() : d.sorted->front(); },
          [upper](const law::WeightedEmpirical& d) { return upper ? d.values->back() : d.values->front(); },
      },
      law_);
}

double Distribution::mean() const {
  return std::visit(Overload{
                        [](const law::Constant& d) { return d.value; },
                        [](const law::Uniform& d) { return 0.5 * (d.low + d.high); },
                        [](const law::Triangular& d) { return (d.low + d.mode + d.high) / 3.0; },
                        [](const law::Exponential& d) { return d.mean; },
                        [](const law::Gamma& d) { return d.shape * d.scale; },
                        [](const law::Normal& d) { return d.mean; },
                        [](const law::TruncatedNormal& d) {
                          return detail::truncated_normal_mean(d.mean, std::abs(d.sd), d.low, d.high, d.mass);
                        },
                        [](const law::Lognormal& d) { return std::exp(d.log_mean + 0.5 * square(d.log_sd)); },
                        [](const law::Weibull& d) { return d.scale * gamma_function(1.0 + 1.0 / d.shape); },
                        [](const law::Beta& d) { return d.low + (d.high - d.low) * d.a / (d.a + d.b); },
                        [](const law::Discrete& d) {
                          double sum = 0.0;
                          double before = 0.0;
                          for (std::size_t i = 0; i < d.values->size(); ++i) {
                            sum += (*d.values)[i] * ((*d.cumulative)[i] - before);
                            before = (*d.cumulative)[i];
                          }
                          return sum;
                        },
                        [](const law::Empirical& d) {
                          // Of the linear pieces: the inner observations count once, the outer ones half.
                          const std::vector<double>& x = *d.sorted;
                          const double inner = std::accumulate(x.begin() + 1, x.end() - 1, 0.0);
                          return (inner + 0.5 * (x.front() + x.back())) / static_cast<double>(x.size() - 1);
                        },
                        [](const law::WeightedEmpirical& d) {
                          const std::vector<double>& p = *d.cumulative;
                          const std::vector<double>& x = *d.values;
                          double sum = 0.0;
                          for (std::size_t i = 0; i + 1 < x.size(); ++i)
                            sum += (p[i + 1] - p[i]) * 0.5 * (x[i] + x[i + 1]);
                          return sum;
                        },
                    },
                    law_);
}

double Distribution::variance() const {
  return std::visit(
      Overload{
          [](const law::Constant&) { return 0.0; },
          [](const law::Uniform& d) { return square(d.high - d.low) / 12.0; },
          [](const law::Triangular& d) {
            const double a = d.mode - d.low;
            const double b = d.high - d.mode;
            return (a * a + a * b + b * b) / 18.0;
          },
          [](const law::Exponential& d) { return square(d.mean); },
          [](const law::Gamma& d) { return d.shape * square(d.scale); },
          [](const law::Normal& d) { return square(d.sd); },
          [](const law::TruncatedNormal& d) {
            return detail::truncated_normal_variance(d.mean, std::abs(d.sd), d.low, d.high, d.mass);
          },
          [](const law::Lognormal& d) {
            return std::expm1(square(d.log_sd)) * std::exp(2.0 * d.log_mean + square(d.log_sd));
          },
          [](const law::Weibull& d) {
            return square(d.scale * gamma_function(1.0 + 1.0 / d.shape)) * weibull_cv_squared(d.shape);
          },
          [](const law::Beta& d) {
            const double sum = d.a + d.b;
            return square(d.high - d.low) * d.a * d.b / (sum * sum * (sum + 1.0));
          },
          [this](const law::Discrete& d) {
            const double center = mean();
            double sum = 0.0;
            double before = 0.0;
            for (std::size_t i = 0; i < d.values->size(); ++i) {
              sum += square((*d.values)[i] - center) * ((*d.cumulative)[i] - before);
              before = (*d.cumulative)[i];
            }
            return sum;
          },
          [this](const law::Empirical& d) {
            // E[(X - m)^2] over a linear piece from a to b: (a^2 + a b + b^2) / 3, a and b about the mean.
            const double center = mean();
            double sum = 0.0;
            for (std::size_t i = 0; i + 1 < d.sorted->size(); ++i) {
              const double a = (*d.sorted)[i] - center;
              const double b = (*d.sorted)[i + 1] - center;
              sum += (a * a + a * b + b * b) / 3.0;
            }
            return sum / static_cast<double>(d.sorted->size() - 1);
          },
          [this](const law::WeightedEmpirical& d) {
            const std::vector<double>& p = *d.cumulative;
            const double center = mean();
            double sum = 0.0;
            for (std::size_t i = 0; i + 1 < p.size(); ++i) {
              const double a = (*d.values)[i] - center;
              const double b = (*d.values)[i + 1] - center;
              sum += (p[i + 1] - p[i]) * (a * a + a * b + b * b) / 3.0;
            }
            return sum;
          },
      },
      law_);
}

double Distribution::cdf(double x) const {
  if (std::isnan(x)) throw std::invalid_argument("cdf of " + describe() + ": x is not a number");
  return std::visit(
      Overload{
          [x](const law::Constant& d) { return x < d.value ? 0.0 : 1.0; },
          [x](const law::Uniform& d) {
            return x < d.low ? 0.0 : x >= d.high ? 1.0 : (x - d.low) / (d.high - d.low);
          },
          [x](const law::Triangular& d) {
            if (x <= d.low) return 0.0;
            if (x >= d.high) return 1.0;
            const double width = d.high - d.low;
            return x < d.mode ? square(x - d.low) / (width * (d.mode - d.low))
                              : 1.0 - square(d.high - x) / (width * (d.high - d.mode));
          },
          [x](const law::Exponential& d) { return x <= 0.0 ? 0.0 : -std::expm1(-x / d.mean); },
          [x](const law::Gamma& d) {
            if (x <= 0.0) return 0.0;
            return std::isinf(x) ? 1.0 : boost::math::gamma_p(d.shape, x / d.scale, MathPolicy());
          },
          [x](const law::Normal& d) {
            if (d.sd == 0.0) return x < d.mean ? 0.0 : 1.0;
            return detail::normal_cdf((x - d.mean) / d.sd);
          },
          [x](const law::TruncatedNormal& d) {
            if (x <= d.low) return 0.0;
            if (x >= d.high) return 1.0;
            const double part = (detail::normal_cdf((x - d.mean) / d.sd) - d.mass_below) / d.mass;
            return d.sd > 0.0 ? part : 1.0 - part;
          },
          [x](const law::Lognormal& d) {
            if (x <= 0.0) return 0.0;
            if (d.log_sd == 0.0) return std::log(x) < d.log_mean ? 0.0 : 1.0;
            return detail::normal_cdf((std::log(x) - d.log_mean) / d.log_sd);
          },
          [x](const law::Weibull& d) {
            return x <= 0.0 ? 0.0 : -std::expm1(-std::pow(x / d.scale, d.shape));
          },
          [x](const law::Beta& d) {
            if (x <= d.low) return 0.0;
            if (x >= d.high) return 1.0;
            return boost::math::cdf(BetaLaw(d.a, d.b), (x - d.low) / (d.high - d.low));
          },
          [x](const law::Discrete& d) {
            const auto above = std::upper_bound(d.values->begin(), d.values->end(), x);
            if (above == d.values->begin()) return 0.0;
            return (*d.cumulative)[static_cast<std::size_t>(above - d.values->begin()) - 1];
          },
          [x](const law::Empirical& d) {
            const std::vector<double>& sorted = *d.sorted;
            if (x < sorted.front()) return 0.0;
            if (x >= sorted.back()) return 1.0;
            const auto above = std::upper_bound(sorted.begin(), sorted.end(), x);
            const double low = *std::prev(above);
            const double i = static_cast<double>(above - sorted.begin()) - 1.0;
            return (i + (x - low) / (*above - low)) / static_cast<double>(sorted.size() - 1);
          },
          [x](const law::WeightedEmpirical& d) {
            const std::vector<double>& values = *d.values;
            if (x < values.front()) return 0.0;
            if (x >= values.back()) return 1.0;
            const auto i =
                static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), x) - values.begin());
            const double below = (*d.cumulative)[i - 1];
            return below + (x - values[i - 1]) / (values[i] - values[i - 1]) * ((*d.cumulative)[i] - below);
          },
      },
      law_);
}

std::string Distribution::describe() const {
  const auto text = [](std::string_view name,
                       std::initializer_list<std::pair<std::string_view, double>> values) {
    std::string out(name);
    std::string_view separator = "(";
    for (const auto& [parameter, value] : values) {
      out += std::string(separator) + std::string(parameter) + " " + text_of(value);
      separator = ", ";
    }
    return out + ")";
  };
  return std::visit(
      Overload{
          [&](const law::Constant& d) {
            return text("constant", {{"value", d.value}});
          },
          [&](const law::Uniform& d) {
            return text("uniform", {{"low", d.low}, {"high", d.high}});
          },
          [&](const law::Triangular& d) {
            return text("triangular", {{"low", d.low}, {"mode", d.mode}, {"high", d.high}});
          },
          [&](const law::Exponential& d) {
            return text("exponential", {{"mean", d.mean}});
          },
          [&](const law::Gamma& d) {
            return text("gamma", {{"shape", d.shape}, {"scale", d.scale}});
          },
          [&](const law::Normal& d) {
            return text("normal", {{"mean", d.mean}, {"sd", d.sd}});
          },
          [&](const law::TruncatedNormal& d) {
            return text("truncated_normal",
                        {{"mean", d.mean}, {"sd", std::abs(d.sd)}, {"low", d.low}, {"high", d.high}});
          },
          [&](const law::Lognormal& d) {
            return text("lognormal", {{"log mean", d.log_mean}, {"log sd", d.log_sd}});
          },
          [&](const law::Weibull& d) {
            return text("weibull", {{"scale", d.scale}, {"shape", d.shape}});
          },
          [&](const law::Beta& d) {
            return text("beta", {{"a", d.a}, {"b", d.b}, {"low", d.low}, {"high", d.high}});
          },
          [&](const law::Discrete& d) {
            return text("discrete", {{"values", static_cast<double>(d.values->size())}});
          },
          [&](const law::Empirical& d) {
            return text("empirical", {{"observations", static_cast<double>(d.sorted->size())}});
          },
          [&](const law::WeightedEmpirical& d) {
            return text("empirical", {{"weighted observations", static_cast<double>(d.values->size())}});
          },
      },
      law_);
}

}  // namespace verstat::sim
