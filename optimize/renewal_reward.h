#pragma once
// The long-run cost of an operation without simulation: what the event simulation tends to when nobody waits.

#include "scenarios/scenario.h"

namespace verstat::optimize {

/// What one part costs in the long run at one operation.
struct OperationCost {
  double cost_per_part = 0;
  double time_per_part_min = 0;  ///< machine time: cutting and changing
  double failures_per_part = 0;
};

/// Renewal-reward cost per part of the whole route, per part cut, good or scrapped: machine minutes, crew
/// wages, inserts, regrinding, damage and scrap of every operation, without waiting. Generalises K117 section
/// E to inserts of n edges, doubtful reserve edges and different times of indexing and replacing.
///
/// Built once for a scenario; the numbers that a study moves may change between calls, names and kinds may
/// not.
class LongRunModel {
 public:
  /// `scenario` is referred to, not copied. Throws scenarios::InputError naming what the model does not
  /// cover.
  explicit LongRunModel(const scenarios::Scenario& scenario);
  /// Infinity where the scenario has no finite long-run cost.
  [[nodiscard]] double cost_per_part() const;
  [[nodiscard]] OperationCost operation_cost(const scenarios::Operation& operation) const;

 private:
  const scenarios::Scenario& scenario_;
};

/// Expected number of edges used per insert: the first always, edge k + 1 when every change before left it
/// usable (probability `s` each); with probability `p_single` the insert has one edge only. K117 eq. (9).
[[nodiscard]] double edges_used_per_insert(std::int64_t edges, double s, double p_single);

}  // namespace verstat::optimize
