#include "fit/duration_fit.h"

#include <algorithm>
#include <cmath>

#include "fit/fit_error.h"

namespace verstat::fit {

DurationFit fit_durations(const std::vector<Observation>& times, int goodness_samples, std::uint64_t seed) {
  DurationFit fit;
  std::vector<double> complete;
  for (const Observation& o : times) {
    if (o.failed())
      complete.push_back(o.at());
    else
      ++fit.censored;
  }
  fit.values = complete.size();
  if (fit.values < 2) throw FitError("fewer than two complete times");
  std::sort(complete.begin(), complete.end());
  fit.least = complete.front();
  fit.most = complete.back();
  for (const double t : complete) fit.mean += t / static_cast<double>(fit.values);
  double squares = 0;
  for (const double t : complete) squares += (t - fit.mean) * (t - fit.mean);
  fit.sd = std::sqrt(squares / static_cast<double>(fit.values - 1));
  for (int percent = 0; percent <= 100; ++percent) {
    const double place = percent / 100.0 * static_cast<double>(fit.values - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, fit.values - 1);
    fit.quantiles.push_back(complete[below] +
                            (place - static_cast<double>(below)) * (complete[above] - complete[below]));
  }
  double survival = 1;
  for (const SurvivalStep& step : product_limit(times)) {
    fit.distinct.push_back(step.time);
    fit.weights.push_back(fit.censored == 0 ? static_cast<double>(step.failures) : survival - step.survival);
    survival = step.survival;
  }
  if (fit.censored > 0) {
    fit.weights.back() += survival;
    if (survival > 1e-9) fit.weight_beyond = survival;  // less than this is rounding
  }
  fit.constant = fit.least == fit.most;
  if (fit.constant) return fit;
  LifeRanking ranking = rank_laws(times);
  fit.unfitted = std::move(ranking.unfitted);
  for (const FittedLaw& law : ranking.laws) {
    if (law.family == LifeFamily::normal) continue;  // a time is never negative, and no scenario holds one
    const int affordable = static_cast<int>(std::max<std::size_t>(39, 2'000'000 / times.size()));
    fit.laws.push_back({law, goodness_of_fit(law, times, std::min(goodness_samples, affordable), seed)});
  }
  if (fit.laws.empty()) throw FitError(fit.unfitted.front().reason);
  fit.empirical =
      std::all_of(fit.laws.begin(), fit.laws.end(), [](const auto& l) { return l.goodness.p_value < 0.05; });
  double before = 0;
  for (const SurvivalStep& step : product_limit(times)) {
    const double f = fit.laws.front().law.cdf(step.time);
    fit.largest_gap = std::max({fit.largest_gap, std::abs(f - before), std::abs(f - (1 - step.survival))});
    before = 1 - step.survival;
  }
  return fit;
}

}  // namespace verstat::fit
