#include "fit/taylor_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>

#include "fit/statistics.h"
#include "models/math/life_law.h"
#include "models/math/policy.h"

namespace verstat::fit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array<const char*, 3> factor_names = {"cutting_speed", "feed", "depth_of_cut"};

std::array<double, 3> regime_of(const WearRun& run) {
  return {run.cutting_speed_m_min, run.feed_mm_rev, run.depth_of_cut_mm};
}

// Is `column` a combination of the others, for the rows that count?
bool dependent(const MatrixXd& others, const VectorXd& column) {
  const VectorXd left = column - others * others.colPivHouseholderQr().solve(column);
  return left.norm() <= 1e-8 * std::max(column.norm(), 1e-300);
}

}  // namespace

double TaylorFit::degrees() const {
  return static_cast<double>(exact + left_censored) - static_cast<double>(regression.coefficients.size());
}

double TaylorFit::scatter() const {
  return regression.sigma * std::sqrt(static_cast<double>(exact + left_censored) / degrees());
}

double TaylorFit::cv() const {
  const double s = scatter();
  return law == ErrorLaw::normal ? std::sqrt(std::expm1(s * s)) : models::weibull_cv(1 / s);
}

VectorXd TaylorFit::row(const std::array<double, 3>& regime, const std::string& laboratory) const {
  VectorXd x = VectorXd::Zero(regression.coefficients.size());
  x[0] = 1;
  for (std::size_t l = 1; l < laboratories.size(); ++l)
    if (laboratories[l] == laboratory) x[static_cast<Index>(l)] = 1;
  auto column = static_cast<Index>(std::max<std::size_t>(laboratories.size(), 1));
  for (std::size_t k = 0; k < 3; ++k)
    if (exponents[k].fitted) x[column++] = std::log(regime[k] / center[k]);
  return x;
}

double TaylorFit::median_min(const std::array<double, 3>& regime) const {
  return std::exp(row(regime, "").dot(regression.coefficients) +
                  regression.sigma * standard_quantile(law, 0.5));
}

double TaylorFit::mean_min(const std::array<double, 3>& regime) const {
  const double s = scatter();
  const double location = row(regime, "").dot(regression.coefficients);
  if (law == ErrorLaw::normal) return std::exp(location + s * s / 2);
  return std::exp(location) * boost::math::tgamma(1 + s, models::MathPolicy());
}

TaylorFit fit_taylor(const WearGroup& group, ErrorLaw law, const TaylorOptions& options) {
  TaylorFit fit;
  fit.law = law;
  std::vector<const WearRun*> runs;
  std::vector<std::string> reached;  // laboratories of which at least one edge reached the criterion
  for (const WearRun& run : group.runs) {
    if (!run.life.failed()) continue;
    if (std::find(reached.begin(), reached.end(), run.laboratory) == reached.end())
      reached.push_back(run.laboratory);
  }
  fit.laboratories = options.pool_laboratories ? std::vector<std::string>{""} : reached;
  if (fit.laboratories.size() > 30)
    throw FitError("more than 30 laboratories; --pool-laboratories takes them as one");
  std::array<double, 3> logs{};
  fit.low.fill(infinity);
  fit.high.fill(0);
  for (const WearRun& run : group.runs) {
    fit.longest_min = std::max(fit.longest_min, run.last_time_min);
    // A laboratory whose edges all outlasted the test has a level without an upper bound.
    if (!options.pool_laboratories &&
        std::find(reached.begin(), reached.end(), run.laboratory) == reached.end())
      continue;
    runs.push_back(&run);
    for (std::size_t k = 0; k < 3; ++k) logs[k] += std::log(regime_of(run)[k]);
    if (!run.life.failed()) {
      ++fit.right_censored;
      continue;
    }
    ++(run.life.exact() ? fit.exact : fit.left_censored);
    for (std::size_t k = 0; k < 3; ++k) {
      fit.low[k] = std::min(fit.low[k], regime_of(run)[k]);
      fit.high[k] = std::max(fit.high[k], regime_of(run)[k]);
    }
  }
  fit.runs = runs.size();
  const std::size_t failures = fit.exact + fit.left_censored;
  if (failures == 0)
    throw FitError(fmt::format("none of the {} runs reached the criterion: life is longer than every test",
                               group.runs.size()));
  for (std::size_t k = 0; k < 3; ++k) fit.center[k] = std::exp(logs[k] / static_cast<double>(runs.size()));

  // Columns, those of the laboratories first: an exponent must show within laboratories, else a difference
  // between laboratories would pass for one.
  const auto n = static_cast<Index>(runs.size());
  MatrixXd x = MatrixXd::Zero(n, static_cast<Index>(fit.laboratories.size()) + 3);
  CensoredData data;
  std::vector<Index> failed_rows;
  for (Index i = 0; i < n; ++i) {
    const WearRun& run = *runs[static_cast<std::size_t>(i)];
    x(i, 0) = 1;
    for (std::size_t l = 1; l < fit.laboratories.size(); ++l)
      if (run.laboratory == fit.laboratories[l]) x(i, static_cast<Index>(l)) = 1;
    data.low.push_back(run.life.low <= 0 ? -infinity : std::log(run.life.low));
    data.high.push_back(std::log(run.life.high));
    if (run.life.failed()) failed_rows.push_back(i);
  }
  auto used = static_cast<Index>(fit.laboratories.size());
  const MatrixXd levels_only = x.leftCols(used);
  MatrixXd failed(static_cast<Index>(failed_rows.size()), x.cols());
  for (std::size_t i = 0; i < failed_rows.size(); ++i)
    failed.row(static_cast<Index>(i)) = x.row(failed_rows[i]);
  for (std::size_t k = 0; k < 3; ++k) {
    TaylorExponent& exponent = fit.exponents[k];
    exponent.factor = factor_names[k];
    VectorXd column(n);
    for (Index i = 0; i < n; ++i)
      column[i] = std::log(regime_of(*runs[static_cast<std::size_t>(i)])[k] / fit.center[k]);
    VectorXd column_failed(failed.rows());
    for (std::size_t i = 0; i < failed_rows.size(); ++i)
      column_failed[static_cast<Index>(i)] = column[failed_rows[i]];
    if (column.cwiseAbs().maxCoeff() < 1e-9) {
      exponent.why_not = "the same in all runs";
    } else if (column_failed.maxCoeff() - column_failed.minCoeff() < 1e-9) {
      exponent.why_not = "the same in all runs that reached the criterion";
    } else if (dependent(failed.leftCols(used), column_failed)) {
      exponent.why_not = used > 1 ? "changes only together with the laboratory or another factor"
                                  : "changes only together with another factor";
    } else {
      exponent.fitted = true;
      x.col(used) = column;
      failed.col(used) = column_failed;
      ++used;
    }
  }
  if (!fit.exponents[0].fitted)
    throw FitError(fmt::format("no exponent of the cutting speed: {} ({} of {} runs reached the criterion)",
                               fit.exponents[0].why_not, failures, group.runs.size()));
  const auto needed = static_cast<std::size_t>(used) + 1;
  if (fit.exact < needed)
    throw FitError(
        fmt::format("{} of {} runs crossed the criterion between two readings, {} are needed for {} "
                    "coefficients and a scatter",
                    fit.exact, group.runs.size(), needed, used));
  data.x = x.leftCols(used);
  fit.regression = fit_regression(law, data);
  const MatrixXd rows = failed.leftCols(used);
  fit.inverse_information = (rows.transpose() * rows).inverse();
  for (Index i = 0; i < rows.rows(); ++i)
    fit.largest_leverage =
        std::max(fit.largest_leverage, rows.row(i).dot(fit.inverse_information * rows.row(i).transpose()));
  const double drop = likelihood_drop(options.confidence, static_cast<double>(failures), fit.degrees());
  Index column = static_cast<Index>(fit.laboratories.size());
  for (TaylorExponent& exponent : fit.exponents) {
    if (!exponent.fitted) continue;
    exponent.value = -fit.regression.coefficients[column];
    const ProfileBounds b =
        profile_bounds(law, data, fit.regression, {VectorXd::Unit(used, column), 0}, drop);
    exponent.bounds = {-b.high, -b.low};
    ++column;
  }
  const double k = static_cast<double>(used) + 1;
  const auto r = static_cast<double>(failures);
  double jacobian = 0;
  for (const WearRun* run : runs)
    if (run->life.exact()) jacobian += std::log(run->life.low);
  const double deviance = -2 * (fit.regression.log_likelihood - jacobian);
  fit.aicc = r > k + 1 ? deviance + 2 * k + 2 * k * (k + 1) / (r - k - 1) : infinity;
  return fit;
}

TaylorPrediction predict(const TaylorFit& fit, const std::array<double, 3>& regime, double confidence,
                         const std::string& laboratory) {
  if (fit.law != ErrorLaw::normal) throw FitError("predictions are made from the lognormal fit");
  TaylorPrediction p{.regime = regime};
  const VectorXd x = fit.row(regime, laboratory);
  const double location = x.dot(fit.regression.coefficients);
  p.median_min = std::exp(location);
  const Index k = x.size();
  const auto failures = static_cast<double>(fit.exact + fit.left_censored);
  const double correction = failures / fit.degrees();
  const double t = student_quantile(confidence, fit.degrees());
  const double of_median = x.dot(fit.regression.covariance.topLeftCorner(k, k) * x) * correction;
  const double of_edge = of_median + fit.regression.sigma * fit.regression.sigma * correction;
  p.median_bounds = {std::exp(location - t * std::sqrt(of_median)),
                     std::exp(location + t * std::sqrt(of_median))};
  p.one_edge_bounds = {std::exp(location - t * std::sqrt(of_edge)),
                       std::exp(location + t * std::sqrt(of_edge))};

  constexpr std::array<const char*, 3> names = {"cutting speed", "feed", "depth of cut"};
  constexpr std::array<const char*, 3> units = {"m/min", "mm/rev", "mm"};
  bool outside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 1e-9 * fit.high[i];
    if (regime[i] >= fit.low[i] - slack && regime[i] <= fit.high[i] + slack) continue;
    outside = true;
    p.warnings.push_back(
        fmt::format("{} {:g} {} is outside the {:g} to {:g} of the runs that reached the criterion{}",
                    names[i], regime[i], units[i], fit.low[i], fit.high[i],
                    fit.exponents[i].fitted ? "" : ", and its exponent is not known: it is ignored"));
  }
  if (!outside && x.dot(fit.inverse_information * x) > fit.largest_leverage * (1 + 1e-9))
    p.warnings.emplace_back("this combination lies outside the measured ones (leverage above every run's)");
  if (p.median_min > fit.longest_min)
    p.warnings.push_back(
        fmt::format("the life is longer than any edge was watched ({:g} min)", fit.longest_min));
  return p;
}

}  // namespace verstat::fit
