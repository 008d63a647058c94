#pragma once
// Do failures come at a steady rate? Laplace's test before anyone assumes renewal, and the power law when
// they do not.

#include <vector>

#include "fit/statistics.h"

namespace verstat::fit {

/// Events of one system on its clock, from 0 to `end`.
struct EventSeries {
  std::vector<double> times;  ///< ascending, 0 < t <= end
  double end = 0;
};

struct TrendTest {
  double statistic = 0;  ///< standard normal without a trend; positive: events come faster and faster
  double p_value = 1;    ///< two-sided
  std::size_t events = 0;
};
/// Laplace's test, pooled over systems (Cox, Lewis, The Statistical Analysis of Series of Events (1966),
/// section 3.3). A system watched up to its last event counts that event as the end.
[[nodiscard]] TrendTest laplace_test(const std::vector<EventSeries>& systems);

/// Power-law intensity  lambda b t^(b - 1)  of equal systems (Crow 1974; MIL-HDBK-189).
struct PowerLaw {
  double growth = 1;  ///< b: below 1 the rate falls, above 1 it grows
  Interval growth_bounds;
  double lambda = 0;
  double rate_at_end = 0;  ///< events per unit of time and system at the longest end
};
/// Maximum likelihood; needs two events after which time went on, else FitError.
[[nodiscard]] PowerLaw fit_power_law(const std::vector<EventSeries>& systems, double confidence);

}  // namespace verstat::fit
