#pragma once
// Arrivals and orders: times between them, their rate over the day and the week, quantities.

#include <array>
#include <string>
#include <vector>

#include "fit/columns.h"
#include "fit/observation.h"
#include "fit/trend.h"
#include "fit/work_calendar.h"

namespace verstat::fit {

struct ArrivalOptions {
  TableOptions table;
  std::vector<ColumnChoice> columns;
  std::string part;       ///< only rows of this part; empty: all
  WorkCalendar calendar;  ///< times between arrivals run on it
};

/// A slot of the day or week: how many came in how much time.
struct RateSlot {
  std::string name;  ///< "Monday", "07:00"
  std::size_t arrivals = 0;
  double exposure_h = 0;  ///< working time only
  double rate_per_h = 0;
  Interval bounds;  ///< Garwood
};

struct ArrivalLog {
  Table table;
  std::size_t rows_used = 0;
  std::vector<double> moments_min;   ///< ascending, each once
  std::vector<Observation> between;  ///< min between successive moments, working time only
  std::vector<double> quantities;    ///< arriving at each moment
  bool with_quantities = false;
  bool dates_only = false;  ///< no row has a time of day
  bool calendar = false;    ///< moments are dates, not minutes of a counter
  TrendTest trend;
  double dispersion_of_days = 0;  ///< variance / mean of the arrivals per day; 1 for a Poisson process
  double dispersion_p_value = 1;
  std::vector<RateSlot> weekdays, hours;
  double weekday_p_value = 1, hour_p_value = 1;  ///< the same rate on all
};

[[nodiscard]] ArrivalLog read_arrivals(const std::string& path, const ArrivalOptions& options,
                                       double confidence);

}  // namespace verstat::fit
