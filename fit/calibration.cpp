#include "fit/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include <Eigen/Dense>
#include <boost/math/distributions/fisher_f.hpp>
#include <fmt/format.h>

#include "fit/fit_error.h"
#include "models/math/normal.h"
#include "models/math/policy.h"
#include "sim/kernel/random_stream.h"

namespace verstat::fit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
constexpr double infinity = std::numeric_limits<double>::infinity();

// Inputs on [-1, 1], linear or logarithmic: the coordinates of surfaces and chains.
class Scale {
 public:
  explicit Scale(const UncertainInput& in) : input_(&in) {
    low_ = in.logarithmic ? std::log(in.low) : in.low;
    high_ = in.logarithmic ? std::log(in.high) : in.high;
  }
  [[nodiscard]] double value(double x) const {
    const double y = low_ + (high_ - low_) * (x + 1) / 2;
    const double v = input_->logarithmic ? std::exp(y) : y;
    return std::clamp(v, input_->low, input_->high);
  }
  [[nodiscard]] double log_prior(double x) const {
    if (!(x >= -1 && x <= 1)) return -infinity;
    if (!input_->mean) return 0;
    const double z = (value(x) - *input_->mean) / *input_->sd;
    // The normal knowledge is of the value itself: on a logarithmic scale its density needs the value.
    return -z * z / 2 + (input_->logarithmic ? std::log(value(x)) : 0);
  }
  // Standard deviation of the prior in x, by summing over a grid.
  [[nodiscard]] double prior_sd() const {
    double w = 0;
    double m = 0;
    double s = 0;
    for (int k = 0; k < 2000; ++k) {
      const double x = -1 + (k + 0.5) / 1000;
      const double p = std::exp(log_prior(x));
      w += p;
      m += p * x;
      s += p * x * x;
    }
    return std::sqrt(s / w - m / w * (m / w));
  }
  [[nodiscard]] double prior_sd_of_value() const {
    double w = 0;
    double m = 0;
    double s = 0;
    for (int k = 0; k < 2000; ++k) {
      const double x = -1 + (k + 0.5) / 1000;
      const double p = std::exp(log_prior(x));
      const double v = value(x);
      w += p;
      m += p * v;
      s += p * v * v;
    }
    return std::sqrt(std::max(0.0, s / w - m / w * (m / w)));
  }

 private:
  const UncertainInput* input_;
  double low_, high_;
};

// 1, x, x^2, and the products when there are months enough to tell them.
VectorXd terms(const VectorXd& x, bool products) {
  const Index d = x.size();
  VectorXd t(1 + 2 * d + (products ? d * (d - 1) / 2 : 0));
  Index k = 0;
  t[k++] = 1;
  for (Index i = 0; i < d; ++i) t[k++] = x[i];
  for (Index i = 0; i < d; ++i) t[k++] = x[i] * x[i];
  if (products)
    for (Index i = 0; i < d; ++i)
      for (Index j = i + 1; j < d; ++j) t[k++] = x[i] * x[j];
  return t;
}

class Surface {
 public:
  Surface(const std::vector<VectorXd>& at, const std::vector<VectorXd>& months,
          const std::vector<ObservedTotal>& totals) {
    const auto n = static_cast<Index>(at.size());
    const auto m = static_cast<Index>(totals.size());
    const Index d = at[0].size();
    const Index all = 1 + 2 * d + d * (d - 1) / 2;
    products_ = n >= 2 * all + m;
    observed_.resize(m);
    for (Index j = 0; j < m; ++j) observed_[j] = totals[static_cast<std::size_t>(j)].value;
    // The box the months lie in: terms of a box far from 0 would be nearly the same.
    middle_ = VectorXd::Zero(d);
    VectorXd low = at[0];
    VectorXd high = at[0];
    for (const VectorXd& x : at) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    middle_ = (low + high) / 2;
    half_ = ((high - low) / 2).cwiseMax(1e-9);
    MatrixXd t(n, terms(at[0], products_).size());
    MatrixXd y(n, m);
    for (Index i = 0; i < n; ++i) {
      t.row(i) = terms(local(at[static_cast<std::size_t>(i)]), products_).transpose();
      y.row(i) = months[static_cast<std::size_t>(i)].transpose();
    }
    const auto qr = t.colPivHouseholderQr();
    coefficients_ = qr.solve(y);
    information_ = (t.transpose() * t).ldlt().solve(MatrixXd::Identity(t.cols(), t.cols()));
    const MatrixXd residuals = y - t * coefficients_;
    const auto degrees = static_cast<double>(n - t.cols());
    student_degrees_ = std::max(1.0, degrees - static_cast<double>(m) + 1);
    MatrixXd covariance = residuals.transpose() * residuals / degrees;
    for (Index j = 0; j < m; ++j) {
      const double range = y.col(j).maxCoeff() - y.col(j).minCoeff();
      if (!(range > 1e-12 * std::max(1.0, y.col(j).cwiseAbs().maxCoeff())))
        throw FitError(fmt::format(
            "\"{}\" is {:g} in every simulated month: it tells nothing about these inputs; leave it out",
            totals[static_cast<std::size_t>(j)].name, y(0, j)));
      covariance(j, j) *= 1 + 1e-8;
      covariance(j, j) += 1e-12 * range * range;
    }
    // Student predictive density: the estimated covariance, wider by its own uncertainty.
    covariance *= degrees / student_degrees_;
    for (Index j = 0; j < m; ++j)
      covariance(j, j) += std::pow(totals[static_cast<std::size_t>(j)].measurement_sd, 2);
    factor_.compute(covariance);
    log_root_ = factor_.matrixLLT().diagonal().array().log().sum();
  }

  // Squared distance of the observed month from the surface, in months' scatter.
  [[nodiscard]] double distance2(const VectorXd& x, double& inflation) const {
    const VectorXd t = terms(local(x), products_);
    inflation = 1 + t.dot(information_ * t);
    const VectorXd gap = observed_ - coefficients_.transpose() * t;
    return factor_.matrixL().solve(gap).squaredNorm() / inflation;
  }
  [[nodiscard]] double log_likelihood(const VectorXd& x) const {
    double inflation = 1;
    const double q = distance2(x, inflation);
    const auto m = static_cast<double>(observed_.size());
    return -(student_degrees_ + m) / 2 * std::log1p(q / student_degrees_) - log_root_ -
           m / 2 * std::log(inflation);
  }
  /// P(a month farther away): Hotelling's F.
  [[nodiscard]] double p_value(const VectorXd& x) const {
    double inflation = 1;
    const double q = distance2(x, inflation);
    const auto m = static_cast<double>(observed_.size());
    using F = boost::math::fisher_f_distribution<double, models::MathPolicy>;
    return boost::math::cdf(boost::math::complement(F(m, student_degrees_), q / m));
  }

 private:
  [[nodiscard]] VectorXd local(const VectorXd& x) const { return (x - middle_).cwiseQuotient(half_); }
  bool products_ = true;
  VectorXd observed_, middle_, half_;
  MatrixXd coefficients_, information_;
  Eigen::LLT<MatrixXd> factor_;
  double student_degrees_ = 1, log_root_ = 0;
};

struct Box {
  VectorXd low, high;
  [[nodiscard]] bool holds(const VectorXd& x) const {
    return (x.array() >= low.array()).all() && (x.array() <= high.array()).all();
  }
};

// Latin hypercube: each input takes each of n slices once.
std::vector<VectorXd> latin_hypercube(const Box& box, int n, sim::RandomStream& stream) {
  std::vector<VectorXd> points(static_cast<std::size_t>(n), VectorXd(box.low.size()));
  std::vector<int> order(static_cast<std::size_t>(n));
  for (Index i = 0; i < box.low.size(); ++i) {
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[stream.below(k)]);
    for (std::size_t k = 0; k < order.size(); ++k)
      points[k][i] = box.low[i] + (box.high[i] - box.low[i]) * (order[k] + stream.uniform()) / n;
  }
  return points;
}

struct Sampled {
  std::vector<VectorXd> draws;
  double r_hat = 1;
};

// Four chains of adaptive Metropolis (Haario, Saksman, Tamminen, Bernoulli 7 (2001) 223); the first half of
// each adapts and is forgotten.
template <class LogDensity>
Sampled sample(const LogDensity& density, const Box& box, int steps, std::uint64_t seed, int round) {
  constexpr int chains = 4;
  const Index d = box.low.size();
  std::vector<std::vector<VectorXd>> kept(chains);
  for (int c = 0; c < chains; ++c) {
    sim::RandomStream stream(seed, "calibration", "chain",
                             static_cast<std::uint64_t>(c) + 16 * static_cast<std::uint64_t>(round));
    // The best of some places: chains start apart, but not in the desert.
    VectorXd x;
    double at_x = -infinity;
    for (int k = 0; k < 200; ++k) {
      VectorXd candidate(d);
      for (Index i = 0; i < d; ++i) candidate[i] = stream.uniform(box.low[i], box.high[i]);
      const double at = density(candidate);
      if (x.size() == 0 || at > at_x) {
        x = candidate;
        at_x = at;
      }
    }
    VectorXd mean = x;
    MatrixXd covariance = ((box.high - box.low) / 10).array().square().matrix().asDiagonal();
    MatrixXd root = covariance.llt().matrixL();
    double step_size = 2.4 / std::sqrt(static_cast<double>(d));
    for (int s = 0; s < steps; ++s) {
      VectorXd z(d);
      for (Index i = 0; i < d; ++i) z[i] = models::normal_quantile(stream.uniform());
      const VectorXd candidate = x + step_size * (root * z);
      const double u = stream.uniform();
      const double at = box.holds(candidate) ? density(candidate) : -infinity;
      const double acceptance = std::exp(std::min(0.0, at - at_x));
      if (u < acceptance) {
        x = candidate;
        at_x = at;
      }
      if (2 * s < steps) {
        const double rate = std::pow(s + 2.0, -0.6);
        step_size *= std::exp(rate * (acceptance - 0.3));
        const VectorXd gap = x - mean;
        mean += rate * gap;
        covariance += rate * (gap * gap.transpose() - covariance);
        if (s % 50 == 49) {
          const MatrixXd safe = covariance + 1e-10 * MatrixXd::Identity(d, d);
          root = safe.llt().matrixL();
        }
      } else {
        kept[static_cast<std::size_t>(c)].push_back(x);
      }
    }
  }
  // Potential scale reduction (Gelman, Rubin 1992).
  Sampled result;
  const auto n = static_cast<double>(kept[0].size());
  for (Index i = 0; i < d; ++i) {
    std::array<double, chains> means{};
    double within = 0;
    for (std::size_t c = 0; c < chains; ++c) {
      for (const VectorXd& x : kept[c]) means[c] += x[i] / n;
      for (const VectorXd& x : kept[c]) within += (x[i] - means[c]) * (x[i] - means[c]) / (n - 1) / chains;
    }
    const double all = std::accumulate(means.begin(), means.end(), 0.0) / chains;
    double between = 0;
    for (const double m : means) between += (m - all) * (m - all) / (chains - 1);
    result.r_hat = std::max(result.r_hat, std::sqrt((n - 1) / n + between / std::max(within, 1e-300)));
  }
  for (const auto& chain : kept) result.draws.insert(result.draws.end(), chain.begin(), chain.end());
  return result;
}

double quantile_of(std::vector<double> values, double p) {
  std::sort(values.begin(), values.end());
  const double place = p * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Calibration calibrate(const std::vector<UncertainInput>& inputs, const std::vector<ObservedTotal>& totals,
                      const std::vector<double>& start, const SimulateMonths& simulate,
                      const CalibrationOptions& options) {
  Calibration result;
  const auto d = static_cast<Index>(inputs.size());
  const std::size_t m = totals.size();
  const Index all_terms = 1 + 2 * d;
  if (options.points_per_round < all_terms + static_cast<Index>(m) + 5)
    throw FitError(fmt::format("{} points per round are too few for {} inputs and {} totals: at least {}",
                               options.points_per_round, d, m, all_terms + static_cast<Index>(m) + 5));
  std::vector<Scale> scales;
  for (const UncertainInput& in : inputs) scales.emplace_back(in);
  const auto value_at = [&](const VectorXd& x) {
    std::vector<double> values;
    for (Index i = 0; i < d; ++i) values.push_back(scales[static_cast<std::size_t>(i)].value(x[i]));
    return values;
  };
  std::uint64_t next_month = 0;
  const auto months_at = [&](const std::vector<std::vector<double>>& points) {
    std::vector<std::vector<double>> months = simulate(points, next_month);
    next_month += points.size();
    return months;
  };

  Box box{VectorXd::Constant(d, -1), VectorXd::Constant(d, 1)};
  std::vector<VectorXd> at;
  std::vector<VectorXd> months;
  std::optional<Surface> surface;
  Sampled posterior;
  sim::RandomStream design(options.seed, "calibration", "design");
  for (int round = 0; round < options.rounds; ++round) {
    const std::vector<VectorXd> points = latin_hypercube(box, options.points_per_round, design);
    std::vector<std::vector<double>> values;
    for (const VectorXd& x : points) values.push_back(value_at(x));
    const std::vector<std::vector<double>> simulated = months_at(values);
    for (std::size_t k = 0; k < points.size(); ++k) {
      at.push_back(points[k]);
      months.emplace_back(Eigen::Map<const VectorXd>(simulated[k].data(), static_cast<Index>(m)));
    }
    // Months of earlier rounds count where they lie in the box of this one.
    std::vector<VectorXd> near;
    std::vector<VectorXd> near_months;
    for (std::size_t k = 0; k < at.size(); ++k)
      if (box.holds(at[k])) {
        near.push_back(at[k]);
        near_months.push_back(months[k]);
      }
    surface.emplace(near, near_months, totals);
    const auto density = [&](const VectorXd& x) {
      double l = surface->log_likelihood(x);
      for (Index i = 0; i < d; ++i) l += scales[static_cast<std::size_t>(i)].log_prior(x[i]);
      return l;
    };
    posterior = sample(density, box, options.chain_steps, options.seed, round);
    if (round + 1 == options.rounds) break;
    // The next box: four standard deviations around the mean, within the limits.
    VectorXd mean = VectorXd::Zero(d);
    for (const VectorXd& x : posterior.draws) mean += x / static_cast<double>(posterior.draws.size());
    VectorXd variance = VectorXd::Zero(d);
    for (const VectorXd& x : posterior.draws)
      variance += (x - mean).array().square().matrix() / static_cast<double>(posterior.draws.size());
    const VectorXd reach = 4 * variance.cwiseSqrt();
    box.low = (mean - reach).cwiseMax(-1);
    box.high = (mean + reach).cwiseMin(1);
  }
  result.largest_r_hat = posterior.r_hat;

  // The posterior in words: each input, pairs, combinations.
  const auto n = static_cast<double>(posterior.draws.size());
  VectorXd mean = VectorXd::Zero(d);
  for (const VectorXd& x : posterior.draws) mean += x / n;
  MatrixXd covariance = MatrixXd::Zero(d, d);
  for (const VectorXd& x : posterior.draws) covariance += (x - mean) * (x - mean).transpose() / (n - 1);
  VectorXd prior_sd(d);
  const double tail = (1 - options.confidence) / 2;
  for (Index i = 0; i < d; ++i) {
    const auto k = static_cast<std::size_t>(i);
    prior_sd[i] = scales[k].prior_sd();
    std::vector<double> values;
    for (const VectorXd& x : posterior.draws) values.push_back(scales[k].value(x[i]));
    CalibratedInput in;
    in.mean = mean_of(values);
    double squares = 0;
    for (const double v : values) squares += (v - in.mean) * (v - in.mean) / (n - 1);
    in.sd = std::sqrt(squares);
    in.median = quantile_of(values, 0.5);
    in.bounds = {quantile_of(values, tail), quantile_of(values, 1 - tail)};
    in.prior_sd = scales[k].prior_sd_of_value();
    in.sd_ratio = std::sqrt(covariance(i, i)) / prior_sd[i];
    result.inputs.push_back(in);
  }
  for (Index i = 0; i < d; ++i) {
    result.correlation.emplace_back();
    for (Index j = 0; j < d; ++j)
      result.correlation.back().push_back(covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)));
  }
  const MatrixXd scaled =
      prior_sd.cwiseInverse().asDiagonal() * covariance * prior_sd.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled);
  for (Index k = 0; k < d; ++k) {
    Direction direction{.weights = {}, .sd_ratio = std::sqrt(std::max(0.0, eigen.eigenvalues()[k]))};
    VectorXd w = eigen.eigenvectors().col(k);
    // The sign of an eigenvector is free: the largest weight is positive.
    Index largest = 0;
    w.cwiseAbs().maxCoeff(&largest);
    if (w[largest] < 0) w = -w;
    for (Index i = 0; i < d; ++i) direction.weights.push_back(w[i]);
    result.directions.push_back(std::move(direction));
  }

  // The model against the month: months at the start, and months from the posterior.
  const auto count = static_cast<std::size_t>(options.check_points);
  const std::vector<std::vector<double>> before = months_at(std::vector<std::vector<double>>(count, start));
  std::vector<std::vector<double>> chosen;
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(value_at(posterior.draws[k * posterior.draws.size() / count]));
  const std::vector<std::vector<double>> after = months_at(chosen);
  result.draws = chosen;
  for (std::size_t j = 0; j < m; ++j) {
    CheckedTotal total{.observed = totals[j].value};
    std::vector<double> column;
    for (const auto& month : before) column.push_back(month[j]);
    total.start_mean = mean_of(column);
    total.start_interval = {quantile_of(column, tail), quantile_of(column, 1 - tail)};
    column.clear();
    for (const auto& month : after) column.push_back(month[j]);
    total.mean = mean_of(column);
    double squares = 0;
    for (const double y : column) squares += (y - total.mean) * (y - total.mean);
    const double sd =
        std::sqrt(squares / static_cast<double>(count - 1) + std::pow(totals[j].measurement_sd, 2));
    // The next month from so many simulated ones: Student's prediction interval.
    const double half = student_quantile(options.confidence, static_cast<double>(count - 1)) * sd *
                        std::sqrt(1 + 1 / static_cast<double>(count));
    total.interval = {total.mean - half, total.mean + half};
    // Counts and shares are never below 0; where no simulated month was, the next one will not be.
    const bool never_negative = std::all_of(column.begin(), column.end(), [](double y) { return y >= 0; });
    if (never_negative) total.interval.low = std::max(0.0, total.interval.low);
    total.inside = total.observed >= total.interval.low && total.observed <= total.interval.high;
    result.totals.push_back(total);
  }
  result.misfit_p_value = surface->p_value(mean);
  result.months = static_cast<int>(next_month);
  return result;
}

}  // namespace verstat::fit
