#pragma once
// Distribution: a probability law as a value.

#include <cmath>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "sim/kernel/random_stream.h"

namespace verstat::sim {

namespace detail::law {

// One struct per law, made by the checked factories of Distribution only. Each has quantile(u) with
// 0 < u < 1, cdf(x), mean(), variance() and name().
struct Constant {
  double value;
};
struct Uniform {
  double low, high;
};
struct Triangular {
  double low, mode, high;
};
struct Exponential {
  double mean;
};
struct Gamma {  // Erlang is the case of a whole shape
  double shape, scale;
};
struct Normal {
  double mean, sd;
};
struct TruncatedNormal {  // of the untruncated law: mean, sd; the mass below and between the limits
  double mean, sd, low, high, mass_below, mass;
};
struct Lognormal {  // of the logarithm
  double log_mean, log_sd;
};
struct Weibull {
  double scale, shape;
};
struct Beta {  // on [low, high]
  double a, b, low, high;
};
struct Discrete {  // values ascending, cumulative probabilities ending in 1
  std::shared_ptr<const std::vector<double>> values, cumulative;
};
struct Empirical {  // piecewise linear through the sorted observations
  std::shared_ptr<const std::vector<double>> sorted;
};
struct WeightedEmpirical {  // values ascending, their cumulative probabilities from 0 to 1
  std::shared_ptr<const std::vector<double>> values, cumulative;
};
using Any = std::variant<Constant, Uniform, Triangular, Exponential, Gamma, Normal, TruncatedNormal,
                         Lognormal, Weibull, Beta, Discrete, Empirical, WeightedEmpirical>;

}  // namespace detail::law

/// A probability law: cheap to copy, never changes. Every variate takes exactly one uniform number and is
/// non-decreasing in it (inversion), so that two variants of a model fed from streams of the same names stay
/// paired variate by variate, and antithetic runs are really opposite.
///
/// The factories throw std::invalid_argument, naming the parameter, its value and what is allowed, when a
/// parameter is out of range or not finite.
class Distribution {
 public:
  /// Always `value` (still takes one uniform).
  static Distribution constant(double value);
  /// Uniform on (low, high), low <= high.
  static Distribution uniform(double low, double high);
  /// Triangular, low <= mode <= high, low < high.
  static Distribution triangular(double low, double mode, double high);
  /// Exponential with mean > 0.
  static Distribution exponential(double mean);
  /// Sum of `phases` >= 1 exponentials, with mean > 0 of the sum.
  static Distribution erlang(int phases, double mean);
  /// Gamma with shape > 0 and scale > 0: mean shape * scale.
  static Distribution gamma(double shape, double scale);
  /// Normal with standard deviation sd >= 0.
  static Distribution normal(double mean, double sd);
  /// Normal(mean, sd > 0) conditioned on low <= x <= high (low < high, infinities allowed). The interval must
  /// carry at least 1e-12 of the mass. mean() and variance() are those of the truncated law.
  static Distribution truncated_normal(double mean, double sd, double low, double high);
  /// Lognormal with the given mean > 0 and coefficient of variation cv >= 0 of the variable itself.
  static Distribution lognormal(double mean, double cv);
  /// Weibull with scale > 0 and shape > 0: cdf 1 - exp(-(x / scale)^shape).
  static Distribution weibull(double scale, double shape);
  /// Weibull with mean > 0 and coefficient of variation 0.01 <= cv <= 20.
  static Distribution weibull_mean_cv(double mean, double cv);
  /// Beta with shapes a, b > 0 on [low, high], low < high.
  static Distribution beta(double a, double b, double low = 0.0, double high = 1.0);
  /// PERT: beta on [low, high] with mean (low + 4 mode + high) / 6; low <= mode <= high, low < high.
  static Distribution pert(double low, double mode, double high);
  /// Takes values[i] with a probability proportional to weights[i] >= 0.
  static Distribution discrete(const std::vector<double>& values, const std::vector<double>& weights);
  /// Continuous law through observations (at least 2): linear between the order statistics x_(i), where the
  /// cdf is (i - 1) / (n - 1) (Law, Simulation Modeling and Analysis, 5th ed., eq. 6.2 style).
  static Distribution empirical(const std::vector<double>& observations);
  /// The same with a weight >= 0 for each observation, at least two of them above 0: between two neighbours
  /// lies half the weight of each, evenly spread, and the whole is scaled to 1. Equal weights are the law
  /// above.
  static Distribution empirical(const std::vector<double>& observations, const std::vector<double>& weights);

  /// Draws one variate.
  [[nodiscard]] double sample(RandomStream& stream) const {
    if (const auto* exponential = std::get_if<detail::law::Exponential>(&law_)) {
      return stream.exponential(exponential->mean);
    }
    return quantile_open(stream.uniform());
  }

  [[nodiscard]] double mean() const;
  [[nodiscard]] double variance() const;
  /// P(X <= x).
  [[nodiscard]] double cdf(double x) const;
  /// Smallest x with cdf(x) >= p, 0 <= p <= 1 (limits of the support at the ends, possibly infinite);
  /// std::invalid_argument outside.
  [[nodiscard]] double quantile(double p) const;
  /// "weibull(scale 20, shape 1.8)".
  [[nodiscard]] std::string describe() const;

 private:
  explicit Distribution(detail::law::Any law) noexcept : law_(std::move(law)) {}
  [[nodiscard]] double quantile_open(double u) const;

  detail::law::Any law_;
};

}  // namespace verstat::sim
