#pragma once
// The long run of a shop without simulation: what the event simulation tends to when nobody waits for a crew
// and queues never run empty where work is short.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::optimize {

/// What one part costs in the long run at one operation, per part that comes to it.
struct OperationCost {
  double cost_per_part = 0;          ///< machine minutes, changing, inserts, damage, scrap
  double time_per_part_min = 0;      ///< machine time: cutting and changing
  double changing_per_part_min = 0;  ///< of it, changing
  double crew_per_part_min = 0;      ///< crew at work
  double failures_per_part = 0;
  double changes_per_part = 0;
  double inserts_per_part = 0;  ///< new inserts fitted
  double survival = 1;          ///< probability that the part is still good afterwards
};

/// A group of identical machines in the long run.
struct GroupLoad {
  double load = 0;      ///< work that comes / work it can do; above 1 it limits the shop
  double changing = 0;  ///< share of its work that is changing edges
};

/// The shop in the long run.
struct LongRun {
  double cost_per_part = 0;       ///< infinite where there is none
  double cost_per_good_part = 0;  ///< likewise
  double throughput_per_h = 0;    ///< good parts
  double quality_ratio = 0;
  std::vector<OperationCost> operations;       ///< as in the scenario
  std::vector<operations::CutPlan> plans;      ///< as in the scenario
  std::vector<double> operation_rate_per_min;  ///< parts that come to each operation
  std::vector<GroupLoad> machines;             ///< as in the scenario
  std::size_t bottleneck = 0;                  ///< the group with the largest load
};

/// Renewal-reward model of the whole shop: every operation's edges are renewed as its tool's strategy says
/// (K117 section E, with inserts of n edges, doubtful reserve edges and different times of indexing and
/// replacing); parts flow through their routes, leave them when scrapped, and no group does more than it can.
/// Every machine minute costs, idle ones too. Not in it: waiting for crews, starving. Shops with machine
/// failures, maintenance, set-ups, calendars, operators, transport, rework, inspection, batches, blocking or
/// late costs are refused by name: their long run is left to the simulation.
///
/// Breakage besides wear is a second, exponential cause of failure (approximation: it strikes within the part
/// rather than at its end). Blanks that are always available load the group of their first operation fully,
/// in equal numbers of each part type.
///
/// Built once for a scenario; the numbers that a study moves may change between calls, names and kinds may
/// not.
class LongRunModel {
 public:
  /// `scenario` is referred to, not copied. Throws scenarios::InputError naming what the model does not
  /// cover.
  explicit LongRunModel(const scenarios::Scenario& scenario);
  LongRunModel(const LongRunModel&) = delete;
  LongRunModel& operator=(const LongRunModel&) = delete;
  ~LongRunModel();

  /// Throws models::ModelError where the process models refuse a regime.
  [[nodiscard]] LongRun evaluate() const;
  [[nodiscard]] double cost_per_part() const { return evaluate().cost_per_part; }
  [[nodiscard]] OperationCost operation_cost(const scenarios::Operation& operation) const;

  /// KPIs that the model knows by the names of the simulation, and "load/<machine group>".
  [[nodiscard]] std::vector<std::string> kpis() const;
  /// Position of a KPI in `kpis()`; none when the model does not know it.
  [[nodiscard]] std::optional<std::size_t> kpi(const std::string& name) const;
  /// Value of the KPI at that position.
  [[nodiscard]] double value(const LongRun& run, std::size_t kpi) const;

 private:
  struct Cache;
  [[nodiscard]] OperationCost cost_of(std::size_t operation, const operations::CutPlan& plan) const;
  void flow(LongRun& run) const;

  const scenarios::Scenario& scenario_;
  std::unique_ptr<Cache> cache_;  // of positions and life laws
};

/// Expected number of edges used per insert: the first always, edge k + 1 when every change before left it
/// usable (probability `s` each); with probability `p_single` the insert has one edge only. K117 eq. (9).
[[nodiscard]] double edges_used_per_insert(std::int64_t edges, double s, double p_single);

}  // namespace verstat::optimize
