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

struct EventReportOptions {
  double confidence = 0.95;
  int goodness_samples = 199;
  std::uint64_t seed = 1;
};

/// The best law as a duration of a scenario ({"kind": "weibull", "mean_min": ..., "cv": ...}); nothing when
/// none has a CV that a scenario accepts.
struct ScenarioDuration {
  nlohmann::json value;
  std::string law;
  double aicc_more = 0;  ///< than the best law's
};
[[nodiscard]] std::optional<ScenarioDuration> duration_of(const DurationFit& fit);

struct DowntimeTarget {
  std::string mode;  ///< needed when the log has several
  Clock clock = Clock::operating;
  std::string to_failure;     ///< pointer of a duration for the time to failure; empty: none
  std::string to_repair;      ///< pointer of a duration for the repair; empty: none
  bool accept_trend = false;  ///< write a renewal law although the rate changes
};
[[nodiscard]] Report report_downtime(const DowntimeLog& log, const EventReportOptions& options,
                                     const DowntimeTarget& target, Origin origin);

/// `pointer`: of the supply of a part, "/parts/0/supply"; empty: no changes.
[[nodiscard]] Report report_arrivals(const ArrivalLog& log, const EventReportOptions& options,
                                     const std::string& pointer, Origin origin);

/// `pointer`: of a duration, "/operations/0/process/time"; empty: no changes.
[[nodiscard]] Report report_cycles(const CycleLog& log, const EventReportOptions& options,
                                   const std::string& pointer, Origin origin);

}  // namespace verstat::fit
