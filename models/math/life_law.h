#pragma once
// Life of a cutting edge as a random variable: Weibull, normal with an atom at zero, exponential, lognormal
// or gamma, given by its mean and coefficient of variation. The card functions use it for gamma-percent lives
// and cost rates, the simulator draws lives from it by inversion.
//
//   const LifeLaw law(LifeLawKind::weibull, 60, 0.7);      // mean in any unit of time, here min
//   const double age = law.gamma_percent_life(0.64);       // survived with probability 0.64
//   const double life = law.quantile(u);                   // u uniform in (0, 1)
//
// All times of one law are in one unit; rates are per that unit. An infinite time means "never".

#include <array>
#include <utility>

namespace verstat::models {

enum class LifeLawKind {
  weibull,      ///< R(t) = exp(-(t/scale)^shape)
  normal,       ///< life = max(0, N(mean, cv mean)): an atom of 1 - Phi(1/cv) at zero
  exponential,  ///< R(t) = exp(-t/mean); no cv of its own
  lognormal,    ///< R(t) = Phi(ln(scale/t)/shape): scale is the median, shape the sd of ln life
  gamma,        ///< R(t) = Q(shape, t/scale), the regularized upper incomplete gamma function
};

template <class E>
struct EnumNames;  // models/catalogue/field.h
template <>
struct EnumNames<LifeLawKind> {
  static constexpr std::array names{
      std::pair{LifeLawKind::weibull, "weibull"}, std::pair{LifeLawKind::normal, "normal"},
      std::pair{LifeLawKind::exponential, "exponential"}, std::pair{LifeLawKind::lognormal, "lognormal"},
      std::pair{LifeLawKind::gamma, "gamma"}};
};

class LifeLaw {
 public:
  /// Law with mean > 0 and cv: 1e-4..10 for Weibull, 0.05..0.45 for normal (a wider scatter would put more
  /// than 1.3 % of the lives into the atom), 1e-4..10 for lognormal, 0.01..10 for gamma, ignored by
  /// exponential.
  /// `mean` of the normal law is the untruncated mean. Throws DomainError naming "cv" or the mean.
  LifeLaw(LifeLawKind kind, double mean, double cv);
  /// Weibull law given by scale > 0 and shape 0.25..60 (cv 8.3..0.021). Throws DomainError.
  [[nodiscard]] static LifeLaw weibull(double scale, double shape);

  [[nodiscard]] LifeLawKind kind() const { return kind_; }
  [[nodiscard]] double mean() const { return mean_; }
  [[nodiscard]] double cv() const { return cv_; }
  /// Weibull shape b, gamma shape, sd of ln life of the lognormal law (1 for exponential; not used by
  /// normal).
  [[nodiscard]] double shape() const { return shape_; }
  /// Weibull or gamma scale, exponential mean, lognormal median, or standard deviation of the normal law.
  [[nodiscard]] double scale() const { return scale_; }
  /// The same law stretched to another mean (shape and cv kept). Cheap: nothing is solved again.
  [[nodiscard]] LifeLaw with_mean(double mean) const;

  /// R(t), probability of surviving age t >= 0. The normal law survives age 0 with Phi(1/cv) only.
  [[nodiscard]] double reliability(double t) const;
  /// F(t) = 1 - R(t), without cancellation for small t.
  [[nodiscard]] double failure_probability(double t) const;
  /// Density at t >= 0 without the atom; infinite at t = 0 for Weibull and gamma shape < 1.
  [[nodiscard]] double density(double t) const;
  /// density / R, finite also where R underflows.
  [[nodiscard]] double hazard(double t) const;
  /// M(tau) = integral of R over 0..tau = E[min(life, tau)], tau >= 0 or infinite.
  [[nodiscard]] double restricted_mean(double tau) const;
  /// M(infinity): the mean of the lives that are drawn. For the normal law slightly above mean().
  [[nodiscard]] double mean_life() const;
  /// T_gamma with R(T_gamma) = gamma, 0 < gamma < 1; 0 where the atom of the normal law is met.
  [[nodiscard]] double gamma_percent_life(double gamma) const;
  /// Life not exceeded with probability u, 0 < u < 1: T_gamma for gamma = 1 - u. For drawing lives.
  [[nodiscard]] double quantile(double u) const;

  /// Renewal function H(interval): expected failures in 0..interval when every failed edge is replaced at
  /// once by a new one. Xie's midpoint scheme with `steps` steps; with 4000 the relative error is below 1e-5
  /// up to 10 means and 1e-4 up to 50 means. Costs steps^2/2 products (a few ms for 4000).
  [[nodiscard]] double renewal_function(double interval, int steps = 4000) const;

 private:
  LifeLaw() = default;
  LifeLawKind kind_ = LifeLawKind::exponential;
  double mean_ = 1;
  double cv_ = 1;
  double shape_ = 1;
  double scale_ = 1;
};

/// Weibull shape b with the coefficient of variation cv (1e-4..10), to rounding:
///   cv^2 = Gamma(1 + 2/b) / Gamma(1 + 1/b)^2 - 1.  Exactly 1 for cv = 1.
[[nodiscard]] double weibull_shape(double cv);
/// Coefficient of variation of the Weibull law with shape > 0.2.
[[nodiscard]] double weibull_cv(double shape);

}  // namespace verstat::models
