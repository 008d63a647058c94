#include "fit/sample_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "fit/fit_error.h"
#include "fit/location_scale.h"
#include "models/math/life_law.h"
#include "models/math/normal.h"

namespace verstat::fit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// What LifeLaw::weibull takes; draws beyond are as good as these.
constexpr double least_shape = 0.25;
constexpr double most_shape = 60;

CensoredData log_lives(const std::vector<Observation>& lives) {
  CensoredData data;
  data.x = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(lives.size()), 1);
  for (const Observation& o : lives) {
    data.low.push_back(o.low <= 0 ? -infinity : std::log(o.low));
    data.high.push_back(std::log(o.high));
  }
  return data;
}

std::size_t cheapest(const std::vector<double>& costs) {
  return static_cast<std::size_t>(std::min_element(costs.begin(), costs.end()) - costs.begin());
}

std::vector<double> expected_costs(const std::vector<PlanCosts>& plans) {
  std::vector<double> expected;
  for (const PlanCosts& plan : plans) {
    double sum = 0;
    for (const double c : plan.costs) sum += c;
    expected.push_back(sum / static_cast<double>(plan.costs.size()));
  }
  return expected;
}

}  // namespace

ChoiceNow choose_now(const std::vector<UnknownGroup>& groups, const std::vector<PlanCosts>& plans,
                     std::uint64_t seed, int truths) {
  ChoiceNow now;
  now.expected = expected_costs(plans);
  now.best = cheapest(now.expected);
  now.best_chance.assign(plans.size(), 0);
  sim::RandomStream stream(seed, "sample value", "truths now");
  std::vector<std::size_t> truth(groups.size());
  std::vector<double> costs(plans.size());
  for (int k = 0; k < truths; ++k) {
    for (std::size_t g = 0; g < groups.size(); ++g) truth[g] = stream.below(groups[g].draws);
    for (std::size_t j = 0; j < plans.size(); ++j) costs[j] = plans[j].costs[truth[plans[j].group]];
    const std::size_t best = cheapest(costs);
    now.best_chance[best] += 1.0 / truths;
    now.perfect_information += (costs[now.best] - costs[best]) / truths;
  }
  return now;
}

SampleValue value_of_sample(const std::vector<UnknownGroup>& groups, const std::vector<PlanCosts>& plans,
                            int n, int truths, std::uint64_t seed) {
  SampleValue result{.measured = n};
  const std::size_t now = cheapest(expected_costs(plans));
  std::vector<std::size_t> truth(groups.size());
  std::vector<std::vector<double>> weights(groups.size());
  std::vector<double> expected(plans.size());
  std::vector<double> costs(plans.size());
  double sum = 0;
  double squares = 0;
  for (int k = 0; k < truths; ++k) {
    sim::RandomStream stream(seed, "sample value", "measurements", static_cast<std::uint64_t>(k));
    for (std::size_t g = 0; g < groups.size(); ++g) {
      truth[g] = stream.below(groups[g].draws);
      std::vector<double>& w = weights[g];
      w.assign(groups[g].draws, 0);
      if (n > 0) {
        sim::RandomStream own(seed, groups[g].name, "new edges", static_cast<std::uint64_t>(k));
        groups[g].measure(truth[g], n, own, w);
        // The truth itself is not among what the engineer can think of: with it the posterior would be too
        // sure of it.
        w[truth[g]] = -infinity;
      }
      const double most = *std::max_element(w.begin(), w.end());
      double total = 0;
      for (double& one : w) {
        one = std::exp(one - most);
        total += one;
      }
      for (double& one : w) one /= total;
    }
    for (std::size_t j = 0; j < plans.size(); ++j) {
      const std::vector<double>& w = weights[plans[j].group];
      expected[j] = 0;
      for (std::size_t d = 0; d < w.size(); ++d) expected[j] += w[d] * plans[j].costs[d];
      costs[j] = plans[j].costs[truth[plans[j].group]];
    }
    const std::size_t chosen = n > 0 ? cheapest(expected) : now;
    const double saved = costs[now] - costs[chosen];
    sum += saved;
    squares += saved * saved;
    if (costs[chosen] > costs[cheapest(costs)]) result.wrong_chance += 1.0 / truths;
  }
  result.value = sum / truths;
  result.standard_error = std::sqrt(std::max(0.0, squares / truths - result.value * result.value) / truths);
  return result;
}

std::vector<WeibullDraw> weibull_posterior(const std::vector<Observation>& lives, std::size_t draws,
                                           std::uint64_t seed, const std::string& name) {
  const CensoredData data = log_lives(lives);
  const RegressionFit fit = fit_regression(ErrorLaw::smallest_extreme_value, data);
  const Eigen::Matrix2d root = Eigen::Matrix2d(fit.covariance.topLeftCorner(2, 2)).llt().matrixL();
  constexpr double degrees = 5;  // tails heavier than the posterior's
  const std::size_t proposals = 10 * draws;
  sim::RandomStream stream(seed, name, "posterior of life");
  std::vector<WeibullDraw> proposed;
  std::vector<double> weights;
  double most = -infinity;
  for (std::size_t k = 0; k < proposals; ++k) {
    Eigen::Vector2d z;
    z[0] = models::normal_quantile(stream.uniform());
    z[1] = models::normal_quantile(stream.uniform());
    double chi = 0;
    for (int i = 0; i < 5; ++i) {
      const double x = models::normal_quantile(stream.uniform());
      chi += x * x;
    }
    z *= std::sqrt(degrees / chi);
    const Eigen::Vector2d at = Eigen::Vector2d(fit.coefficients[0], std::log(fit.sigma)) + root * z;
    const double sigma = std::exp(at[1]);
    const double log_proposal = -(degrees + 2) / 2 * std::log1p(z.squaredNorm() / degrees);
    const double l =
        log_likelihood(ErrorLaw::smallest_extreme_value, data, Eigen::VectorXd::Constant(1, at[0]), sigma) -
        log_proposal;
    proposed.push_back({std::exp(at[0]), std::clamp(1 / sigma, least_shape, most_shape)});
    weights.push_back(l);
    most = std::max(most, l);
  }
  double total = 0;
  for (double& w : weights) {
    w = std::exp(w - most);
    total += w;
  }
  // Systematic resampling: every draw stands for the same share of the weight.
  std::vector<WeibullDraw> result;
  const double start = stream.uniform();
  double cumulative = 0;
  std::size_t k = 0;
  for (std::size_t d = 0; d < draws; ++d) {
    const double target = (static_cast<double>(d) + start) / static_cast<double>(draws) * total;
    while (k + 1 < proposals && cumulative + weights[k] < target) cumulative += weights[k++];
    result.push_back(proposed[k]);
  }
  return result;
}

UnknownGroup weibull_group(std::string name, std::vector<WeibullDraw> draws, double watched_min) {
  UnknownGroup group{.name = std::move(name), .draws = draws.size(), .measure = {}};
  group.measure = [draws = std::move(draws), watched_min](std::size_t truth, int n, sim::RandomStream& stream,
                                                          std::vector<double>& log_weights) {
    const WeibullDraw& law = draws[truth];
    std::vector<double> logs;
    int failures = 0;
    double sum_failed = 0;
    for (int i = 0; i < n; ++i) {
      const double life = law.scale * std::pow(-std::log1p(-stream.uniform()), 1 / law.shape);
      logs.push_back(std::log(std::min(life, watched_min)));
      if (life <= watched_min) {
        ++failures;
        sum_failed += logs.back();
      }
    }
    for (std::size_t d = 0; d < draws.size(); ++d) {
      const double shape = draws[d].shape;
      const double log_scale = std::log(draws[d].scale);
      double hazard = 0;
      for (const double log_life : logs) hazard += std::exp(shape * (log_life - log_scale));
      log_weights[d] += failures * (std::log(shape) - shape * log_scale) + (shape - 1) * sum_failed - hazard;
    }
  };
  return group;
}

double age_replacement_cost(const WeibullDraw& law, double age_min, double planned_cost,
                            double failure_cost) {
  const models::LifeLaw life = models::LifeLaw::weibull(law.scale, law.shape);
  if (std::isinf(age_min)) return failure_cost / life.mean_life();
  const double failed = life.failure_probability(age_min);
  return (planned_cost * (1 - failed) + failure_cost * failed) / life.restricted_mean(age_min);
}

}  // namespace verstat::fit
