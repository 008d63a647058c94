#include "fit/goodness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/fit_error.h"
#include "sim/kernel/random_stream.h"

namespace verstat::fit {
namespace {

// Failures before censored lives at the same time.
std::vector<Observation> in_order(std::vector<Observation> lives) {
  std::stable_sort(lives.begin(), lives.end(), [](const Observation& a, const Observation& b) {
    return a.at() != b.at() ? a.at() < b.at() : a.failed() && !b.failed();
  });
  return lives;
}

double cube(double x) {
  return x * x * x;
}

}  // namespace

std::vector<SurvivalStep> product_limit(const std::vector<Observation>& lives) {
  const std::vector<Observation> sorted = in_order(lives);
  std::vector<SurvivalStep> steps;
  double survival = 1;
  for (std::size_t i = 0; i < sorted.size();) {
    const double t = sorted[i].at();
    const std::size_t at_risk = sorted.size() - i;
    std::size_t failures = 0;
    for (; i < sorted.size() && sorted[i].at() == t; ++i) failures += sorted[i].failed() ? 1 : 0;
    if (failures == 0) continue;
    survival *= 1 - static_cast<double>(failures) / static_cast<double>(at_risk);
    steps.push_back({t, survival, at_risk, failures});
  }
  return steps;
}

std::vector<PlotPoint> median_ranks(const std::vector<Observation>& lives) {
  const std::vector<Observation> sorted = in_order(lives);
  const auto n = static_cast<double>(sorted.size());
  std::vector<PlotPoint> points;
  double rank = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (!sorted[i].failed()) continue;
    // The increment shares the ranks that the censored lives might still take among those left.
    rank += (n + 1 - rank) / (1 + static_cast<double>(sorted.size() - i));
    points.push_back({sorted[i].at(), rank, beta_quantile(0.5, rank, n - rank + 1),
                      beta_quantile(0.05, rank, n - rank + 1), beta_quantile(0.95, rank, n - rank + 1)});
  }
  return points;
}

RankRegression rank_regression(const std::vector<PlotPoint>& points) {
  const auto n = static_cast<double>(points.size());
  double sx = 0;
  double sy = 0;
  for (const PlotPoint& p : points) {
    sx += std::log(-std::log1p(-p.median));
    sy += std::log(p.time);
  }
  double sxx = 0;
  double syy = 0;
  double sxy = 0;
  for (const PlotPoint& p : points) {
    const double x = std::log(-std::log1p(-p.median)) - sx / n;
    const double y = std::log(p.time) - sy / n;
    sxx += x * x;
    syy += y * y;
    sxy += x * y;
  }
  if (points.size() < 2 || !(sxy > 0))
    throw FitError("fewer than two different failures: no line on the Weibull plot");
  const double slope = sxy / sxx;  // of ln t on the reduced variate: 1 / shape
  return {1 / slope, std::exp(sy / n - slope * sx / n), sxy / std::sqrt(sxx * syy)};
}

double distance(const FittedLaw& law, const std::vector<Observation>& lives) {
  double u = 0;
  double failed = 0;  // product-limit estimate of F before the next step
  double sum = 0;
  for (const SurvivalStep& step : product_limit(lives)) {
    const double next = law.cdf(step.time);
    sum += (cube(next - failed) - cube(u - failed)) / 3;
    u = next;
    failed = 1 - step.survival;
  }
  return sum * static_cast<double>(lives.size());
}

GoodnessTest goodness_of_fit(const FittedLaw& law, const std::vector<Observation>& lives, int samples,
                             std::uint64_t seed) {
  GoodnessTest test{.statistic = distance(law, lives)};
  // Censoring seen from the other side: a failure censors the censoring.
  std::vector<Observation> reversed;
  std::vector<double> widths;
  for (const Observation& o : lives) {
    reversed.push_back(o.failed() ? survived(o.at()) : exact_life(o.at()));
    if (o.failed()) widths.push_back(o.high - o.low);
  }
  // A failure at the same time as a censoring came first: it is not at risk of being censored there.
  for (Observation& o : reversed)
    if (!o.failed()) o.low = std::nextafter(o.low, 0.0);
  const std::vector<SurvivalStep> censoring = product_limit(reversed);
  sim::RandomStream stream(seed, "goodness of fit", name_of(law.family));
  int farther = 0;
  std::vector<Observation> sample(lives.size());
  for (int k = 0; k < samples; ++k) {
    for (Observation& o : sample) {
      const double life = std::max(law.quantile(stream.uniform()), 1e-9 * std::abs(law.mean()));
      const double v = stream.uniform();
      const double w = stream.uniform();
      const double place = stream.uniform();
      const auto step = std::partition_point(censoring.begin(), censoring.end(),
                                             [&](const auto& c) { return c.survival > v; });
      const double censored = step == censoring.end() ? std::numeric_limits<double>::infinity() : step->time;
      if (life > censored) {
        o = survived(censored);
        continue;
      }
      const double width =
          widths.empty() ? 0 : widths[static_cast<std::size_t>(w * static_cast<double>(widths.size()))];
      const double low = std::max(0.0, life - place * width);
      o = width > 0 ? between(low, low + width) : exact_life(life);
    }
    try {
      const FittedLaw refit = fit_law(law.family, sample);
      ++test.samples;
      if (distance(refit, sample) >= test.statistic) ++farther;
    } catch (const FitError&) {
      // Too few failures in this sample to fit the law: it says nothing about the distance.
    }
  }
  test.p_value = (farther + 1.0) / (test.samples + 1.0);
  return test;
}

}  // namespace verstat::fit
