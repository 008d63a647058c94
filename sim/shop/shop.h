#pragma once
// The shop built from a scenario: parts follow routes over machines that hold tools served by crews. One
// object per replication, no globals.
//
// Accounting, as in the cost model of K117: a machine minute costs its rate in whatever state; a crew member
// costs the wage for the minutes worked (or for the whole time, as the scenario says); an insert is booked by
// life periods at every change or when it is fitted; a failure costs damage and, with a probability, the
// part. A part that a failure spoils is finished by the new edge and found out afterwards: it counts as
// scrapped.

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "sim/kernel/distribution.h"
#include "sim/kernel/resource.h"
#include "sim/kernel/simulation.h"
#include "sim/kernel/store.h"
#include "sim/shop/crib.h"
#include "sim/shop/kpis.h"
#include "sim/shop/lots.h"
#include "sim/shop/state_clock.h"
#include "sim/shop/strategy.h"
#include "sim/shop/tool_body.h"

namespace verstat::shop {

/// Everything counted since the end of the warm-up about one kind of tool.
struct ToolCounts {
  std::uint64_t planned_changes = 0;  ///< of the tool, whatever the number of teeth
  std::uint64_t failures = 0;         ///< changes after a failure
  std::uint64_t teeth_failed = 0;     ///< in the cut
  std::uint64_t joined_changes = 0;   ///< planned changes made at another stop
  std::uint64_t inspections = 0;
  std::uint64_t worn_found = 0;
  std::uint64_t false_alarms = 0;
  std::uint64_t waits = 0;  ///< for a tool or for inserts
  std::uint64_t regrinds = 0;
  std::uint64_t inserts_fitted = 0;
  std::uint64_t edges_used = 0;      ///< edges taken out
  double edge_minutes_used = 0;      ///< cutting minutes of the edges taken out
  std::uint64_t edges_unspent = 0;   ///< of those, taken out before they failed
  double life_left = 0;              ///< sum over them of the share of life left
  std::int64_t edges_at_start = 0;   ///< in tools at the start of the counted time
  std::int64_t edges_fitted = 0;     ///< usable ones, with new inserts
  std::int64_t edges_reground = 0;   ///< that regrinding brought back
  std::int64_t edges_discarded = 0;  ///< never used: unusable ones, and those a failure broke
  double insert_cost = 0;
  double regrind_cost = 0;
  double damage_cost = 0;
  double element_cost = 0;
};

struct PartCounts {
  std::uint64_t good = 0;
  std::uint64_t scrapped = 0;
  double scrap_cost = 0;
  double lead_time_min = 0;      ///< sum over finished parts
  std::uint64_t in_process = 0;  ///< now, not since the warm-up
};

class Shop {
 public:
  /// Builds the shop of a checked scenario. `replication` counts from 0 and picks the random streams.
  Shop(const scenarios::Scenario& scenario, std::uint64_t replication);
  Shop(const Shop&) = delete;
  Shop& operator=(const Shop&) = delete;
  ~Shop();

  /// Simulates warm-up and horizon; returns the KPIs in the order of kpi_infos(scenario).
  /// Throws sim::ProcessError; that would be a bug of ours or an exhausted event budget.
  [[nodiscard]] std::vector<std::optional<double>> run();
  [[nodiscard]] std::uint64_t events_executed() const { return sim_.events_executed(); }

 private:
  friend std::vector<KpiInfo> kpi_infos(const scenarios::Scenario& scenario);
  struct Job {
    std::size_t part = 0;
    std::size_t step = 0;
    double released_min = 0;
    bool spoiled = false;
  };
  struct PlannedOperation {
    const scenarios::Operation* spec;
    std::size_t group;  // of the machines that do it
    operations::CutPlan plan;
    std::optional<sim::Distribution> time_law;
    /// Mean lives, min, of the elements that its tool has a service for; infinite: not worn.
    std::vector<double> element_mean_min;
  };
  struct Group;
  struct MountedTool;
  struct ToolPool;
  struct ElementUnit;
  struct MachineUnit;
  struct CrewUnit;

  [[nodiscard]] sim::Task<void> machine_process(MachineUnit& machine);
  [[nodiscard]] sim::Task<void> arrival_process(std::size_t part);
  /// Cuts one part: `main_time_min` at full feed.
  [[nodiscard]] sim::Task<void> cut(MachineUnit& machine, MountedTool& tool,
                                    const PlannedOperation& operation, double main_time_min, Job& job);
  /// The machine spends `time_min` in `state`, and so does the tool that works (null: none). The only place
  /// where time passes for a machine that has work: what stretches it (failures, ends of shifts) is dealt
  /// with there.
  [[nodiscard]] sim::Task<void> spend(MachineUnit& machine, MachineState state, double time_min,
                                      MountedTool* tool = nullptr);
  /// A member of the crew comes to the machine, which waits for it.
  [[nodiscard]] sim::Task<sim::Hold> call_crew(MachineUnit& machine, CrewUnit& crew,
                                               MountedTool* tool = nullptr);
  /// A member of the crew comes to the tool room.
  [[nodiscard]] static sim::Task<sim::Hold> call_crew(CrewUnit& crew);
  /// The edges of the tool are changed, on the machine or by a sister tool. A failure that no tooth has had
  /// is a break of the whole tool.
  [[nodiscard]] sim::Task<void> change_edge(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                            double mean_life_min);
  /// The crew `present` (null: nobody yet) changes edges on the machine.
  [[nodiscard]] sim::Task<void> change_on_machine(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                                  double mean_life_min, const CrewUnit* present);
  /// Edges whose strategy uses other stops are changed while the machine stands: `stopped_for` (null: not for
  /// a tool) is not asked, `present` (null: nobody) is at the machine already.
  [[nodiscard]] sim::Task<void> join_stop(MachineUnit& machine, const MountedTool* stopped_for,
                                          const CrewUnit* present);
  [[nodiscard]] sim::Task<void> swap_tool(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                          double mean_life_min);
  /// A copy comes into the machine; waits until one is ready.
  [[nodiscard]] sim::Task<void> fetch_tool(MachineUnit& machine, MountedTool& tool);
  /// A shared copy is free for other machines.
  static void put_back(MountedTool& tool);
  /// New edges, regrinding and setting off the machine; then the copy is ready again.
  [[nodiscard]] sim::Task<void> tool_room(MountedTool& tool, ToolBody& body, bool after_failure,
                                          double mean_life_min);
  [[nodiscard]] sim::Task<void> wait_for_inserts(MachineUnit& machine, MountedTool& tool,
                                                 std::int64_t inserts);
  [[nodiscard]] sim::Task<void> inspect_edge(MachineUnit& machine, MountedTool& tool, double mean_life_min);
  [[nodiscard]] sim::Task<void> change_element(MachineUnit& machine, MountedTool& tool, ElementUnit& element);
  /// Books a change; `renew_teeth` makes it and returns `time_min` plus the time at the teeth.
  void count_change(const MountedTool& tool, bool after_failure);
  [[nodiscard]] double renew_teeth(MountedTool& tool, ToolBody& body, bool after_failure, bool reground,
                                   double mean_life_min, double time_min);
  void build_tools();
  /// Edges in all copies of a tool.
  [[nodiscard]] std::int64_t edges_in_tools(std::size_t tool) const;
  void reset_tool_counts();
  void settle_tools();
  [[nodiscard]] std::optional<Job> next_job(Group& group);
  /// Whether the tool breaks in this cut, and whether the part is spoiled by the process, as the plan says.
  [[nodiscard]] static bool breaks(MachineUnit& machine, const PlannedOperation& operation);
  [[nodiscard]] static bool spoils(MachineUnit& machine, const PlannedOperation& operation);
  void release(Job job);
  void pass_on(Job job);
  void reset_counts();
  void settle();
  [[nodiscard]] std::vector<std::optional<double>> compute_kpis() const;
  /// Hands every KPI to the sink, in order: names and values stand together.
  void each_kpi(const KpiSink& sink) const;
  /// `finished` parts in the counted time, good or scrapped.
  void tool_kpis(double finished, const KpiSink& sink) const;
  void insert_kpis(double finished, const KpiSink& sink) const;

  const scenarios::Scenario& scenario_;
  std::uint64_t replication_;
  sim::Simulation sim_;
  std::vector<PlannedOperation> operations_;  // one per operation of the scenario
  std::vector<std::unique_ptr<CrewUnit>> crews_;
  std::vector<scenarios::Insert> inserts_;          // as fitted; behind them one for tools without
  std::vector<std::unique_ptr<LotSource>> lots_;    // one per insert; null: one lot
  std::vector<std::unique_ptr<InsertCrib>> cribs_;  // one per insert; null: always enough
  std::vector<std::unique_ptr<ToolPool>> pools_;    // of copies
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<std::unique_ptr<MachineUnit>> machines_;
  std::vector<ToolCounts> tools_;  // one per tool of the scenario
  std::vector<PartCounts> parts_;  // one per part type
  // routes_[part][step]: index of the operation, looked up by name once
  std::vector<std::vector<std::size_t>> routes_;
};

}  // namespace verstat::shop
