#pragma once
// Downtime, arrivals and cycle times in words, JSON and durations of a scenario.

#include <optional>
#include <string>

#include "fit/arrival_log.h"
#include "fit/cycle_log.h"
#include "fit/downtime_log.h"
#include "fit/duration_fit.h"
#include "fit/report.h"

namespace verstat::fit {

/// What is written of times.
enum class Written {
  best,         ///< the best law that fits, else the observations
  observations  ///< the observations, whatever fits
};
/// The times as a duration of a scenario: the first law by AICc that the test of fit does not refuse and
/// whose CV a scenario accepts ({"kind": "weibull", "mean_min": ..., "cv": ...}); without one the
/// observations
/// ({"kind": "empirical", "values_min": [...], "weights": [...]}; more than 1000 different ones by the 1001
/// quantiles 0, 0.1, ..., 100 %).
struct ScenarioDuration {
  nlohmann::json value;
  std::string law;
};
[[nodiscard]] ScenarioDuration duration_of(const DurationFit& fit, Written written = Written::best);

struct EventReportOptions {
  double confidence = 0.95;
  int goodness_samples = 199;
  std::uint64_t seed = 1;
  Written written = Written::best;
};

struct DowntimeTarget {
  std::string mode;  ///< needed when the log has several
  Clock clock = Clock::operating;
  std::string to_failure;     ///< pointer of a duration for the time to failure; empty: none
  std::string to_repair;      ///< pointer of a duration for the repair; empty: none
  bool accept_trend = false;  ///< write a renewal law although the rate changes
};
[[nodiscard]] Report report_downtime(const DowntimeLog& log, const EventReportOptions& options,
                                     const DowntimeTarget& target, Origin origin);

/// How arrivals stand in a scenario.
enum class SupplyForm {
  law,      ///< {"kind": "interarrival"}: times between arrivals
  profile,  ///< {"kind": "weekly_profile"}: arrivals an hour over the week
  orders    ///< {"kind": "orders"}: the very orders of the log
};
/// `pointer`: of the supply of a part, "/parts/0/supply"; empty: no changes. `name` is that of the library
/// entry.
[[nodiscard]] Report report_arrivals(const ArrivalLog& log, const EventReportOptions& options,
                                     SupplyForm form, const std::string& pointer, const std::string& name,
                                     Origin origin);

/// `pointer`: of a duration, "/operations/0/process/time"; empty: no changes.
[[nodiscard]] Report report_cycles(const CycleLog& log, const EventReportOptions& options,
                                   const std::string& pointer, Origin origin);

}  // namespace verstat::fit
