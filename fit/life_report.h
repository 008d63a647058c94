#pragma once
// The life of edges in words, JSON and changes to an insert of a scenario.

#include <optional>

#include "fit/life_analysis.h"
#include "fit/removal_log.h"
#include "fit/report.h"

namespace verstat::fit {

/// Where the changes go and what the shop must be told besides the life itself.
struct LifeTarget {
  std::string pointer;  ///< of an insert, "/inserts/0"; empty: no changes
  std::optional<double> cutting_speed_m_min, feed_mm_rev, depth_of_cut_mm;  ///< regime of the log
  std::optional<double> min_per_part;  ///< turns lives in parts into minutes
};

/// Analyses every group of the log. `origin.method` and the row counts are filled in here.
/// Throws InputError when changes are asked for and the log holds several groups, or lives in parts without
/// min_per_part.
[[nodiscard]] Report report_lives(const RemovalLog& log, const LifeAnalysisOptions& options,
                                  const LifeTarget& target, Origin origin);

}  // namespace verstat::fit
