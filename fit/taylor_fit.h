#pragma once
// The extended Taylor equation with scatter, by censored maximum likelihood:
//   ln T = ln T_c(laboratory) - m_v ln(v/v_c) - m_f ln(f/f_c) - m_a ln(a_p/a_c) + sigma e
// around the geometric mean regime (v_c, f_c, a_c) of the runs. Only exponents that the runs determine are
// fitted; the others are named with the reason.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "fit/fit_error.h"
#include "fit/location_scale.h"
#include "fit/statistics.h"
#include "fit/wear_curves.h"

namespace verstat::fit {

struct TaylorOptions {
  bool pool_laboratories = false;  ///< one level for all laboratories instead of one each
  double confidence = 0.95;
};

/// One of ln v, ln f, ln a_p.
struct TaylorExponent {
  std::string factor;  ///< "cutting_speed", "feed", "depth_of_cut"
  bool fitted = false;
  std::string why_not;
  double value = 0;  ///< m: life goes as factor^-m
  Interval bounds;   ///< profile likelihood; Student's when every run crossed the criterion
};

struct TaylorFit {
  ErrorLaw law = ErrorLaw::normal;  ///< of ln T: normal (lognormal lives) or smallest extreme value (Weibull)
  RegressionFit regression;
  std::array<TaylorExponent, 3> exponents;
  std::vector<std::string> laboratories;  ///< of the levels; the first is the constant
  std::array<double, 3> center{};         ///< v_c, f_c, a_c
  std::array<double, 3> low{}, high{};    ///< range of the runs that reached the criterion
  std::size_t runs = 0, exact = 0, left_censored = 0, right_censored = 0;
  double aicc = 0;
  double largest_leverage = 0;  ///< of the runs that reached the criterion
  double longest_min = 0;       ///< longest time any edge was watched

  [[nodiscard]] double degrees() const;  ///< failures less coefficients
  /// sigma corrected for the fitted coefficients, sigma sqrt(failures / degrees): maximum likelihood takes
  /// the scatter of a few runs for too small.
  [[nodiscard]] double scatter() const;
  [[nodiscard]] double cv() const;  ///< of life at one regime, from scatter()
  /// Median or mean life at a regime, level of the first laboratory.
  [[nodiscard]] double median_min(const std::array<double, 3>& regime) const;
  [[nodiscard]] double mean_min(const std::array<double, 3>& regime) const;
  [[nodiscard]] Eigen::VectorXd row(const std::array<double, 3>& regime, const std::string& laboratory) const;
  Eigen::MatrixXd inverse_information;  ///< (X'X)^-1 of the runs that reached the criterion, for leverages
};

/// Throws FitError with what is missing: "2 runs reached the criterion, 3 are needed for ...".
[[nodiscard]] TaylorFit fit_taylor(const WearGroup& group, ErrorLaw law, const TaylorOptions& options);

struct TaylorPrediction {
  std::array<double, 3> regime{};
  double median_min = 0;
  Interval median_bounds;    ///< of the median life
  Interval one_edge_bounds;  ///< prediction interval of the next edge
  std::vector<std::string> warnings;
};
/// Lognormal fits only: Student intervals with the scale corrected for the fitted coefficients, exact for
/// uncensored runs (Draper, Smith, Applied Regression Analysis, 3rd ed., section 3.1) and asymptotic else.
/// `laboratory` empty: the first.
[[nodiscard]] TaylorPrediction predict(const TaylorFit& fit, const std::array<double, 3>& regime,
                                       double confidence, const std::string& laboratory = "");

}  // namespace verstat::fit
