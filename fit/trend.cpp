#include "fit/trend.h"

#include <algorithm>
#include <cmath>

#include "fit/fit_error.h"

namespace verstat::fit {

TrendTest laplace_test(const std::vector<EventSeries>& systems) {
  TrendTest test;
  double sum = 0;
  double expected = 0;
  double variance = 0;
  for (const EventSeries& s : systems) {
    if (s.times.empty() || !(s.end > 0)) continue;
    // Given their number, events of a steady rate are uniform on (0, end).
    std::size_t n = s.times.size();
    if (s.times.back() >= s.end) --n;
    for (std::size_t i = 0; i < n; ++i) sum += s.times[i];
    expected += static_cast<double>(n) * s.end / 2;
    variance += static_cast<double>(n) * s.end * s.end / 12;
    test.events += n;
  }
  if (test.events == 0) return test;
  // Late events: the rate grows.
  test.statistic = (sum - expected) / std::sqrt(variance);
  test.p_value = normal_two_sided(test.statistic);
  return test;
}

PowerLaw fit_power_law(const std::vector<EventSeries>& systems, double confidence) {
  double logs = 0;
  std::size_t n = 0;
  double longest = 0;
  for (const EventSeries& s : systems) {
    longest = std::max(longest, s.end);
    for (const double t : s.times) {
      if (!(t > 0) || t >= s.end) continue;
      logs += std::log(s.end / t);
      ++n;
    }
  }
  if (n < 2 || !(logs > 0)) throw FitError("fewer than two events before the end: no power law");
  PowerLaw law;
  const auto events = static_cast<double>(n);
  law.growth = events / logs;
  // 2 b sum ln(end/t) is chi-square with 2 n degrees of freedom.
  law.growth_bounds = {chi_square_quantile((1 - confidence) / 2, 2 * events) / (2 * logs),
                       chi_square_quantile((1 + confidence) / 2, 2 * events) / (2 * logs)};
  double exposure = 0;
  for (const EventSeries& s : systems) exposure += std::pow(s.end, law.growth);
  law.lambda = events / exposure;
  law.rate_at_end = law.lambda * law.growth * std::pow(longest, law.growth - 1);
  return law;
}

}  // namespace verstat::fit
