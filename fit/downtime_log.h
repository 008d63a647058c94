#pragma once
// Stops of machines: time between failures of each mode on a chosen clock, and the time each stop lasted.

#include <optional>
#include <string>
#include <vector>

#include "fit/columns.h"
#include "fit/observation.h"
#include "fit/trend.h"
#include "fit/work_calendar.h"

namespace verstat::fit {

enum class Clock {
  calendar,   ///< every minute
  operating,  ///< a counter of the log, else working time without the recorded stops
  cutting     ///< a counter of the log
};
[[nodiscard]] const char* name_of(Clock clock);

struct DowntimeOptions {
  TableOptions table;
  std::vector<ColumnChoice> columns;
  std::string from, to;       ///< period of watching, as times; empty: first stop, end of the last one
  WorkCalendar calendar;      ///< working time, for the operating clock without a counter
  bool new_at_start = false;  ///< machines were as new when the watching began: the first time counts, too
};

/// One mode of failure on one clock, all machines together.
struct ModeTimes {
  std::string mode;
  Clock clock = Clock::calendar;
  std::vector<Observation>
      between;                      ///< min between stops of this mode; the last one of a machine is censored
  std::vector<EventSeries> series;  ///< of each machine, from the start of watching
};
struct ModeRepairs {
  std::string mode;
  std::vector<Observation> repairs;  ///< min
};

struct DowntimeLog {
  Table table;
  std::size_t rows_used = 0;
  std::vector<std::string> machines;
  double from_min = 0, to_min = 0;  ///< period watched
  std::vector<ModeTimes> times;     ///< every mode on every clock the log has
  std::vector<ModeRepairs> repairs;
};

[[nodiscard]] DowntimeLog read_downtime(const std::string& path, const DowntimeOptions& options);

}  // namespace verstat::fit
