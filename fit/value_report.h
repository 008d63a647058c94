#pragma once
// How many more edges to measure before choosing between plans, in words and JSON.

#include <optional>
#include <string>
#include <vector>

#include "fit/removal_log.h"
#include "fit/report.h"

namespace verstat::fit {

struct ChangePlan {
  std::string name;
  std::string tool;                ///< of the log; empty: the only one
  double planned_change_cost = 0;  ///< money per change of an edge that still cuts, the edge included
  double failure_cost = 0;         ///< money per failure, the edge, the stop and the scrap included
  std::optional<double> age_min;   ///< none: change at failure only
};
/// {"plans": [{"name", "tool", "planned_change_cost", "failure_cost", "age_min"}], "cutting_min": 200000,
/// "cost_per_edge": 30, "edges": [5, 10, 20], "watched_min": 90, "risk": 0.05}
struct ValueSpec {
  std::string file;
  std::vector<ChangePlan> plans;
  double cutting_min = 0;             ///< minutes of cutting for which the choice will hold
  double cost_per_edge = 0;           ///< of measuring one edge
  std::vector<int> edges;             ///< numbers of new edges per tool to try
  std::optional<double> watched_min;  ///< new edges are watched so long at most
  double risk = 0.05;                 ///< chance of the wrong plan that is safe enough
};
[[nodiscard]] ValueSpec read_value_spec(const std::string& file);

[[nodiscard]] Report report_value(const RemovalLog& log, const ValueSpec& spec, int truths,
                                  std::uint64_t seed, Origin origin);

}  // namespace verstat::fit
