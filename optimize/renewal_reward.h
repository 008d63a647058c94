#pragma once
// The long run of a shop without simulation: what the event simulation tends to when nobody waits for a crew
// and queues never run empty where work is short.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "optimize/dual.h"
#include "scenarios/scenario.h"

namespace verstat::optimize {

template <class N>
struct Reading;

/// What one part costs in the long run at one operation, per part that comes to it. N is double, or Dual with
/// the derivatives.
template <class N>
struct OperationOf {
  N cost_per_part = 0;          ///< machine minutes, changing, inserts, damage, scrap
  N time_per_part_min = 0;      ///< machine time: cutting, changing, handling, repairs
  N changing_per_part_min = 0;  ///< of it, changing
  N crew_per_part_min = 0;      ///< crews at work
  N failures_per_part = 0;
  N changes_per_part = 0;
  N inserts_per_part = 0;  ///< new inserts fitted
  N process_survival = 1;  ///< probability that neither the process nor a failing machine spoils the part
  N survival = 1;          ///< probability that the part is still good afterwards
};
using OperationCost = OperationOf<double>;

/// A group of identical machines in the long run.
template <class N>
struct GroupLoadOf {
  N load = 0;      ///< work that comes / work it can do; above 1 it limits the shop
  N changing = 0;  ///< share of its work that is changing edges
};
using GroupLoad = GroupLoadOf<double>;

/// The shop in the long run.
template <class N>
struct LongRunOf {
  N cost_per_part = 0;       ///< infinite where there is none
  N cost_per_good_part = 0;  ///< likewise
  N throughput_per_h = 0;    ///< good parts
  N quality_ratio = 0;
  std::vector<OperationOf<N>> operations;  ///< as in the scenario
  std::vector<operations::CutPlan> plans;  ///< as in the scenario; empty with derivatives
  std::vector<N> operation_rate_per_min;   ///< parts that come to each operation
  std::vector<GroupLoadOf<N>> machines;    ///< as in the scenario
  std::size_t bottleneck = 0;              ///< the group with the largest load
};
using LongRun = LongRunOf<double>;

/// How the plan of an operation moves with one number.
struct PlanSlope {
  double main_time_min = 0;
  double mean_life_min = 0;
  double breakage_probability = 0;
  double scrap_probability = 0;
  double trips_per_part = 0;
  double breaks_per_part = 0;
};

/// Renewal-reward model of the whole shop: every operation's edges are renewed as its tool's strategy says
/// (K117 section E, with inserts of n edges, doubtful reserve edges and different times of indexing and
/// replacing); machines fail, are maintained and set up at their long-run rates and work within their
/// calendars; parts flow through their routes, leave them when scrapped, and no group does more than it can.
/// Every machine minute on shift costs, idle ones too. Not in it: waiting for crews, starving. What else it
/// does not cover is refused by name (optimize/long_run_coverage.cpp): the simulation is left to tell.
///
/// Exact for stops on the clocks of working minutes and parts that take effect at once (renewal reward: one
/// failure per mean life). Approximations:
///   breakage besides wear is a second, exponential cause of failure: it strikes within the part
///   stops that let a part be finished first come half a part later
///   failures by the clock on the wall take their share of the group's time, and rarely coincide
///   set-ups: the family of a batch is independent of that of the batch before (first come, first served, and
///   Poisson arrivals make it so)
///   shifts that let a part be finished gain half a part at each end, or what is left until an edge must be
///   changed by a crew that has gone home
/// Blanks that are always available load the group of their first operation fully, in equal numbers of each
/// part type.
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
  /// The same with derivatives with respect to the number of the scenario at `moved`, by automatic
  /// differentiation. `at` is what evaluate() gives there; `plans` says how the plans of operations move with
  /// the number (operation, slope). None when the number is used where no derivative is known: neither read
  /// by the formulas nor behind a plan.
  [[nodiscard]] std::optional<LongRunOf<Dual>> differentiate(
      const LongRun& at, const double* moved,
      const std::vector<std::pair<std::size_t, PlanSlope>>& plans) const;
  [[nodiscard]] double cost_per_part() const { return evaluate().cost_per_part; }
  [[nodiscard]] OperationCost operation_cost(const scenarios::Operation& operation) const;

  /// KPIs that the model knows by the names of the simulation, and "load/<machine group>".
  [[nodiscard]] std::vector<std::string> kpis() const;
  /// Position of a KPI in `kpis()`; none when the model does not know it.
  [[nodiscard]] std::optional<std::size_t> kpi(const std::string& name) const;
  /// Value of the KPI at that position.
  [[nodiscard]] double value(const LongRun& run, std::size_t kpi) const { return value_in(run, kpi); }
  [[nodiscard]] Dual value(const LongRunOf<Dual>& run, std::size_t kpi) const { return value_in(run, kpi); }

 private:
  struct Cache;
  template <class N>
  struct PlanNumbers;
  template <class N>
  class Flow;
  template <class N>
  [[nodiscard]] OperationOf<N> cost_of(std::size_t operation, const operations::CutPlan& plan,
                                       const PlanNumbers<N>& numbers, const Reading<N>& read) const;
  template <class N>
  [[nodiscard]] N value_in(const LongRunOf<N>& run, std::size_t kpi) const;

  const scenarios::Scenario& scenario_;
  std::unique_ptr<Cache> cache_;  // of positions and life laws
};

/// Expected number of edges used per insert: the first always, edge k + 1 when every change before left it
/// usable (probability `s` each); with probability `p_single` the insert has one edge only. K117 eq. (9).
[[nodiscard]] double edges_used_per_insert(std::int64_t edges, double s, double p_single);

}  // namespace verstat::optimize
