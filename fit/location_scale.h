#pragma once
// Censored maximum likelihood of the location-scale regression  y = x'b + sigma e  with e standard normal or
// standard smallest extreme value: Weibull and lognormal lives (y = ln t), normal lives (y = t), batches and
// the extended Taylor equation (x = regime) are all this one model.
//
// In the coordinates a = b / sigma, tau = 1 / sigma the log-likelihood is concave for both laws, with exact,
// right-, left- and interval-censored observations (Burridge, JRSS B 43 (1981) 41), and every question asked
// of the model (a coefficient, a quantile, sigma) is a linear condition on (a, tau). So one Newton method
// with at most one linear condition does the estimates and all profile likelihoods.

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace verstat::fit {

enum class ErrorLaw {
  smallest_extreme_value,  ///< F(z) = 1 - exp(-exp(z)): ln of a Weibull life
  normal
};

/// Quantile of the standard law, 0 < p < 1.
[[nodiscard]] double standard_quantile(ErrorLaw law, double p);
/// P(e <= z).
[[nodiscard]] double standard_cdf(ErrorLaw law, double z);

/// The data: row i of x with what is known of y_i. low = high: exact; low = -inf: left-censored;
/// high = inf: right-censored.
struct CensoredData {
  Eigen::MatrixXd x;
  std::vector<double> low;
  std::vector<double> high;
};

struct RegressionFit {
  Eigen::VectorXd coefficients;
  double sigma = 1;
  double log_likelihood = 0;  ///< of y, not of t
  /// Covariance of (coefficients, ln sigma) from the observed information; of the coefficients alone when
  /// sigma was given.
  Eigen::MatrixXd covariance;
};

/// The maximum-likelihood fit; `sigma` fixes the scale (1 for exponential lives).
/// Throws FitError when there is no finite maximum: all y the same, only censored ones, too few for x.
[[nodiscard]] RegressionFit fit_regression(ErrorLaw law, const CensoredData& data,
                                           std::optional<double> sigma = std::nullopt);

/// Log-likelihood at given values.
[[nodiscard]] double log_likelihood(ErrorLaw law, const CensoredData& data,
                                    const Eigen::VectorXd& coefficients, double sigma);

/// A number the model determines: x'b + sigma z, or sigma itself when x is empty.
struct Question {
  Eigen::VectorXd x;
  double z = 0;
};
/// How far the log-likelihood falls at a bound: half the chi-square quantile with one degree of freedom.
[[nodiscard]] double likelihood_drop(double confidence);
/// The same for a regression with `observations` exact y and normal errors, of which `degrees` are left after
/// the coefficients: n/2 ln(1 + t^2 / degrees), which makes profile bounds of coefficients Student's exact
/// intervals. For censored y an approximation that is right in the limit.
[[nodiscard]] double likelihood_drop(double confidence, double observations, double degrees);

/// Bounds of the answer by profile likelihood: where the log-likelihood has fallen by `drop`. A bound is
/// infinite (0 for sigma) when the likelihood never drops that far.
struct ProfileBounds {
  double estimate = 0;
  double low = 0;
  double high = 0;
};
[[nodiscard]] ProfileBounds profile_bounds(ErrorLaw law, const CensoredData& data, const RegressionFit& fit,
                                           const Question& question, double drop,
                                           std::optional<double> sigma = std::nullopt);

}  // namespace verstat::fit
