#include "fit/life_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "fit/fit_error.h"
#include "fit/location_scale.h"
#include "models/math/solve.h"

namespace verstat::fit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

ErrorLaw error_law(LifeFamily family) {
  return family == LifeFamily::weibull ? ErrorLaw::smallest_extreme_value : ErrorLaw::normal;
}

CensoredData log_lives(const std::vector<Observation>& lives, const std::vector<std::size_t>& column_of_batch,
                       Eigen::Index columns) {
  CensoredData data;
  data.x = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(lives.size()), columns);
  for (std::size_t i = 0; i < lives.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    data.x(row, 0) = 1;
    if (const std::size_t c = column_of_batch[lives[i].batch]; c > 0)
      data.x(row, static_cast<Eigen::Index>(c)) = 1;
    data.low.push_back(lives[i].low <= 0 ? -infinity : std::log(lives[i].low));
    data.high.push_back(std::log(lives[i].high));
  }
  return data;
}

// Aalen-Johansen: the hazard of each failure weighs with the survival of all causes just before it.
void add_incidences(std::vector<CauseReport>& causes, const std::vector<Observation>& lives) {
  std::vector<Observation> sorted = lives;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Observation& a, const Observation& b) {
    return a.at() != b.at() ? a.at() < b.at() : a.failed() && !b.failed();
  });
  double survival = 1;
  for (std::size_t i = 0; i < sorted.size();) {
    const double t = sorted[i].at();
    const auto at_risk = static_cast<double>(sorted.size() - i);
    double failures = 0;
    for (; i < sorted.size() && sorted[i].at() == t; ++i) {
      if (!sorted[i].failed()) continue;
      ++failures;
      for (CauseReport& c : causes)
        if (c.cause == sorted[i].cause) c.incidence += survival / at_risk;
    }
    survival *= 1 - failures / at_risk;
  }
}

std::vector<CauseReport> compare_causes(const std::vector<Observation>& lives) {
  std::map<int, std::size_t> counts;
  for (const Observation& o : lives)
    if (o.failed()) ++counts[o.cause];
  std::vector<CauseReport> reports;
  if (counts.size() < 2) return reports;
  for (const auto& [cause, count] : counts) {
    CauseReport report{.cause = cause, .failures = count};
    const LifeRanking ranking = rank_laws(lives_of_cause(lives, cause));
    if (ranking.laws.empty())
      report.why_not = ranking.unfitted.front().reason;
    else
      report.law = ranking.laws.front();
    reports.push_back(std::move(report));
  }
  add_incidences(reports, lives);
  return reports;
}

}  // namespace

std::vector<Observation> lives_of_cause(const std::vector<Observation>& lives, int cause) {
  std::vector<Observation> result;
  for (Observation o : lives) {
    if (o.failed() && o.cause != cause) {
      // Up to the other failure it had survived this cause. What failed within its first interval, known
      // only to have lived longer than nothing, tells nothing about this one.
      if (o.low <= 0) continue;
      o.high = infinity;
    }
    result.push_back(o);
  }
  return result;
}

std::optional<BatchReport> compare_batches(const std::vector<Observation>& lives, double confidence) {
  BatchReport report;
  std::map<std::size_t, BatchReport::Ratio> batches;
  for (const Observation& o : lives) {
    BatchReport::Ratio& one = batches[o.batch];
    one.batch = o.batch;
    ++one.edges;
    one.failures += o.failed() ? 1 : 0;
  }
  std::vector<std::size_t> column_of_batch(batches.rbegin()->first + 1, 0);
  for (const auto& [batch, one] : batches) {
    if (one.failures == 0) {
      report.without_failures.push_back(batch);
      continue;
    }
    column_of_batch[batch] = report.ratios.size();
    report.ratios.push_back(one);
  }
  const std::size_t k = report.ratios.size();
  if (k < 2) return std::nullopt;
  std::vector<Observation> compared;
  for (const Observation& o : lives)
    if (batches[o.batch].failures > 0) compared.push_back(o);
  const CensoredData data = log_lives(compared, column_of_batch, static_cast<Eigen::Index>(k));
  CensoredData common = data;
  common.x = data.x.leftCols(1);

  std::optional<RegressionFit> best;
  for (const LifeFamily family : {LifeFamily::weibull, LifeFamily::lognormal}) {
    try {
      RegressionFit fit = fit_regression(error_law(family), data);
      if (best && !(fit.log_likelihood > best->log_likelihood)) continue;
      report.family = family;
      best = std::move(fit);
    } catch (const FitError&) {
      // The other family may do; without either there is no comparison.
    }
  }
  if (!best) return std::nullopt;
  const ErrorLaw law = error_law(report.family);
  const auto degrees = static_cast<double>(k - 1);
  report.scale_p_value =
      chi_square_tail(2 * (best->log_likelihood - fit_regression(law, common).log_likelihood), degrees);
  try {
    double separate = 0;
    for (const auto& ratio : report.ratios) {
      CensoredData own;
      for (std::size_t i = 0; i < compared.size(); ++i)
        if (compared[i].batch == ratio.batch) {
          own.low.push_back(data.low[i]);
          own.high.push_back(data.high[i]);
        }
      own.x = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(own.low.size()), 1);
      separate += fit_regression(law, own).log_likelihood;
    }
    report.shape_p_value = chi_square_tail(2 * (separate - best->log_likelihood), degrees);
  } catch (const FitError&) {
    report.shape_p_value = 1;  // a batch with a single failure has no shape of its own
  }
  for (std::size_t j = 0; j < k; ++j) {
    if (j == 0) {
      report.ratios[0].life_ratio = {1, {1, 1}};
      continue;
    }
    const Question coefficient{
        Eigen::VectorXd::Unit(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)), 0};
    const ProfileBounds b = profile_bounds(law, data, *best, coefficient, likelihood_drop(confidence));
    report.ratios[j].life_ratio = {std::exp(b.estimate), {std::exp(b.low), std::exp(b.high)}};
  }
  return report;
}

LifeAnalysis analyse_lives(const std::vector<Observation>& lives, const LifeAnalysisOptions& options) {
  LifeAnalysis a;
  a.edges = lives.size();
  a.failures = failures_in(lives);
  a.gamma = options.gamma;
  for (const Observation& o : lives) {
    a.intervals += o.failed() && !o.exact() ? 1 : 0;
    a.longest = std::max(a.longest, o.failed() ? o.high : o.low);
  }
  if (a.failures == 0)
    throw FitError("no failure among the edges: only a lower bound of life could be told, no law");
  LifeRanking ranking = rank_laws(lives);
  a.unfitted = std::move(ranking.unfitted);
  if (ranking.laws.empty()) throw FitError(a.unfitted.front().reason);
  const int affordable = static_cast<int>(std::max<std::size_t>(39, 2'000'000 / lives.size()));
  const int samples = std::min(options.goodness_samples, affordable);
  for (const FittedLaw& law : ranking.laws)
    a.laws.push_back({law, goodness_of_fit(law, lives, samples, options.seed)});

  const FittedLaw& best = a.laws.front().law;
  const auto bounded = [&](double estimate, LifeQuantity quantity) {
    return Bounded{estimate, life_bounds(best, lives, quantity, options.confidence, 1 - options.gamma)};
  };
  a.first = bounded(best.first, LifeQuantity::first);
  a.second = bounded(best.second, LifeQuantity::second);
  a.mean = bounded(best.mean(), LifeQuantity::mean);
  a.gamma_percent_life = bounded(best.gamma_percent_life(options.gamma), LifeQuantity::quantile);

  a.weibull_plot = median_ranks(lives);
  try {
    a.plot_line = rank_regression(a.weibull_plot);
  } catch (const FitError&) {
    // A single failure is a point, not a line.
  }
  a.product_limit = product_limit(lives);
  a.causes = compare_causes(lives);
  const bool all_fitted = !a.causes.empty() && std::all_of(a.causes.begin(), a.causes.end(),
                                                           [](const auto& c) { return c.law.has_value(); });
  if (all_fitted) {
    const auto reliability = [&](double t) {
      double r = 1;
      for (const CauseReport& c : a.causes) r *= 1 - c.law->cdf(t);
      return r;
    };
    double high = a.longest;
    for (int k = 0; k < 60 && reliability(high) > options.gamma; ++k) high *= 1.5;
    if (reliability(high) <= options.gamma)
      a.gamma_percent_life_of_causes =
          models::find_root([&](double t) { return reliability(t) - options.gamma; }, 0, high, 1e-10);
  }
  const bool several =
      std::any_of(lives.begin(), lives.end(), [&](const auto& o) { return o.batch != lives[0].batch; });
  if (!several) return a;
  std::set<std::size_t> with_failures;
  for (const Observation& o : lives)
    if (o.failed()) with_failures.insert(o.batch);
  if (with_failures.size() > most_batches) {
    a.batches_not_compared = "more than 30 batches with failures";
    return a;
  }
  a.batches = compare_batches(lives, options.confidence);
  if (!a.batches) a.batches_not_compared = "fewer than two batches with enough different failures";
  return a;
}

}  // namespace verstat::fit
