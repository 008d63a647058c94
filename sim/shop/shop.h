#pragma once
// The shop built from a scenario: parts follow routes over machines that hold tools served by crews. One
// object per replication, no globals.
//
// Accounting, as in the cost model of K117: a machine minute inside the machine's calendar costs its rate in
// whatever state; a crew member costs the wage for the minutes worked (or for the whole time, as the scenario
// says); an insert is booked by life periods at every change or when it is fitted; a failure costs damage
// and, with a probability, the part. A part that a failure spoils is finished by the new edge and found out
// afterwards: it counts as scrapped. What is under way at the horizon has been paid for up to then and counts
// as work in process; a stop that lasts beyond it is counted when it began, with the time it took so far.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/calendar.h"
#include "scenarios/route.h"
#include "scenarios/scenario.h"
#include "sim/kernel/distribution.h"
#include "sim/kernel/event.h"
#include "sim/kernel/quantile_sketch.h"
#include "sim/kernel/simulation.h"
#include "sim/kernel/store.h"
#include "sim/kernel/tally.h"
#include "sim/shop/costs.h"
#include "sim/shop/crib.h"
#include "sim/shop/fingerprint.h"
#include "sim/shop/job.h"
#include "sim/shop/kpis.h"
#include "sim/shop/labour.h"
#include "sim/shop/lots.h"
#include "sim/shop/state_clock.h"
#include "sim/shop/strategy.h"
#include "sim/shop/tool_body.h"
#include "sim/shop/unattended.h"

namespace verstat::shop {

class Trace;

/// Batches in the shop or waiting for release, per replication: about 200 bytes each.
inline constexpr std::int64_t most_batches = 1'000'000;
/// Pieces in one batch.
inline constexpr std::int64_t most_pieces = 1'000'000'000;
/// More events while the clock stands still are no plan: durations of zero feed each other.
inline constexpr std::uint64_t events_at_one_instant = 5'000'000;

inline constexpr double week_min = 7 * 24 * 60;

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
};

/// Everything counted about one part type. Parts, not batches.
struct PartCounts {
  std::uint64_t released = 0;
  std::uint64_t good = 0;
  std::uint64_t scrapped = 0;
  std::uint64_t reworked = 0;
  std::uint64_t escaped = 0;               ///< good ones with a defect nobody saw
  std::uint64_t late = 0;                  ///< good ones after their due date
  double tardiness_min = 0;                ///< sum over good parts
  std::array<double, phases> phase_min{};  ///< sums over parts finished, good or scrapped
  double lead_time_min = 0;                ///< sum over parts finished
};

/// Everything counted about inspections.
struct InspectionCounts {
  std::uint64_t defective_rejected = 0;  ///< parts
  std::uint64_t good_rejected = 0;
  double time_min = 0;          ///< of the stations, from taking a batch to judging it
  double planned_time_min = 0;  ///< main times of the same parts
  double cost = 0;              ///< of the stations' minutes, of the checks and of new gauges
};

class Shop {
 public:
  /// Builds the shop of a checked scenario. `replication` counts from 0 and picks the random streams. The
  /// trace, when there is one, must outlive the shop.
  Shop(const scenarios::Scenario& scenario, std::uint64_t replication, Trace* trace = nullptr);
  Shop(const Shop&) = delete;
  Shop& operator=(const Shop&) = delete;
  ~Shop();

  /// Simulates warm-up and horizon; returns the KPIs in the order of kpi_infos(scenario).
  /// Throws sim::BudgetError when the shop needs more events or memory than it may, and sim::ProcessError;
  /// that would be a bug of ours.
  [[nodiscard]] std::vector<std::optional<double>> run();
  [[nodiscard]] std::uint64_t events_executed() const { return sim_.events_executed(); }
  /// After run(): a hash of the times of all events in their order. Costs nothing that can be measured.
  [[nodiscard]] std::uint64_t course() const { return sim_.course(); }
  /// Before run(): keep a fingerprint of which process went on when. Slower by about a half.
  void watch_event_order();
  [[nodiscard]] std::uint64_t event_order() const { return event_order_.value(); }
  /// After run(): which machines blocked each other for good, and since when. Empty: none did.
  [[nodiscard]] std::string standstill() const;
  /// After run(): laws of conservation that do not hold, in words. Empty when all is well.
  [[nodiscard]] std::vector<std::string> audit() const;

 private:
  friend std::vector<KpiInfo> kpi_infos(const scenarios::Scenario& scenario);
  struct Group;
  struct MountedTool;
  struct GaugeUnit;
  struct ToolPool;
  struct ElementUnit;
  struct MachineUnit;
  struct Stop;
  struct Spares;
  struct StoreUnit;
  struct Source;
  struct Carrier;
  struct Fleet;
  struct Movement;  // limits.cpp: who keeps whom waiting
  [[nodiscard]] std::size_t from_supply() const { return groups_.size(); }
  [[nodiscard]] std::size_t from_components() const { return groups_.size() + 1; }
  void build_limits();
  void told_idle(MachineUnit& machine, const Job& job);
  void told_blocked(MachineUnit& machine);
  void reset_limits();
  void limit_kpis(const KpiSink& sink) const;

  // standstill.cpp
  /// An operation on one group of machines. What every part asks stands first, together: a large plant lives
  /// or dies by the memory it touches.
  struct PlannedOperation {
    PlannedOperation(const scenarios::Operation& operation, std::size_t on_group,
                     operations::CutPlan cut_plan);
    std::size_t group;  // of the machines that do it
    double main_time_min;
    double cost;
    double mean_life_min;             // of an edge; infinite: none is worn
    double spoils;                    // chance that the process spoils a part
    double breaks;                    // chance that the tool breaks in a part
    std::size_t tool_slot = no_tool;  // among the tools of each machine of the group
    bool uses_tool = false;
    bool wears = false;
    bool inspects;
    const scenarios::Quality* quality;  // null: none
    /// Mean lives, min, of the elements that its tool has a service for; infinite: not worn.
    std::vector<double> element_mean_min;
    std::optional<sim::Distribution> time_law;
    const scenarios::Operation* spec;
    operations::CutPlan plan;
  };
  static constexpr std::size_t no_tool = static_cast<std::size_t>(-1);
  /// An operation with its plan on every group that can do it.
  struct OperationUnit {
    const scenarios::Operation* spec;
    std::vector<PlannedOperation, sim::PoolAllocator<PlannedOperation>> on;
    std::size_t family = 0;
    std::size_t next_in_turn = 0;
  };
  /// Where a batch goes next: to a machine group, or to the store of its part type.
  struct Place {
    std::size_t group = scenarios::route_end;
    std::size_t store = scenarios::route_end;
  };

  // build.cpp
  void build_operations();
  void build_machines();
  void build_tools();  // tool_setup.cpp
  void build_flow();
  void start();

  void build_quality();  // quality.cpp

  // machine.cpp: machines at work
  [[nodiscard]] sim::Task<void> machine_process(MachineUnit& machine);
  [[nodiscard]] sim::Task<Job*> wait_for_job(MachineUnit& machine);
  [[nodiscard]] sim::Task<void> process(MachineUnit& machine, Job& job);
  [[nodiscard]] sim::Task<void> set_up(MachineUnit& machine, std::size_t family);
  [[nodiscard]] sim::Task<void> work_on_part(MachineUnit& machine, const PlannedOperation& operation);
  [[nodiscard]] sim::Task<void> load(MachineUnit& machine, bool unloading);
  [[nodiscard]] sim::Task<void> overload(MachineUnit& machine, const operations::Overload& expected);
  [[nodiscard]] sim::Task<void> open_shift(MachineUnit& machine);
  /// The machine spends `time_min` in `state`, and so does the tool that works (null: none). The only place
  /// where time passes for a machine that has work: what stretches it (failures, ends of shifts) is dealt
  /// with there.
  [[nodiscard]] sim::Task<void> spend(MachineUnit& machine, MachineState state, double time_min,
                                      MountedTool* tool = nullptr);
  /// A member of one of the crews comes to the machine, which waits in `waiting` for it.
  [[nodiscard]] sim::Task<CrewHold> call_crew(MachineUnit& machine, const std::vector<std::size_t>& crews,
                                              Cost heading, std::int64_t priority = 0,
                                              MachineState waiting = MachineState::waiting_crew,
                                              MountedTool* tool = nullptr);
  void enter(MachineUnit& machine, MachineState state, MountedTool* tool = nullptr);

  // stops.cpp: failures and maintenance
  [[nodiscard]] Stop* due_stop(MachineUnit& machine, scenarios::StopEffect context) const;
  [[nodiscard]] double time_to_stop(const MachineUnit& machine, MachineState state,
                                    scenarios::StopEffect context) const;
  [[nodiscard]] sim::Task<void> deal_with_stops(MachineUnit& machine, scenarios::StopEffect context,
                                                MountedTool* tool = nullptr);
  [[nodiscard]] sim::Task<void> stand_still(MachineUnit& machine, Stop& stop, MountedTool* tool);
  void renew(MachineUnit& machine, Stop& stop);
  [[nodiscard]] sim::Task<void> take_spare(std::size_t spare);
  [[nodiscard]] sim::Task<void> deliver_spares(std::size_t spare);

  // tooling.cpp: tools at work
  /// Cuts one part: `main_time_min` at full feed.
  [[nodiscard]] sim::Task<void> cut(MachineUnit& machine, MountedTool& tool,
                                    const PlannedOperation& operation, double main_time_min);
  /// The edges of the tool are changed, on the machine or by a sister tool. A failure that no tooth has had
  /// is a break of the whole tool.
  [[nodiscard]] sim::Task<void> change_edge(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                            double mean_life_min);
  /// The machine has stopped for something else before; `present`: crews of which a member is there (null:
  /// nobody).
  struct Stopped {
    bool before = false;
    const std::vector<std::size_t>* present = nullptr;
  };
  [[nodiscard]] sim::Task<void> change_on_machine(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                                  double mean_life_min, Stopped stopped);
  /// Edges whose strategy uses other stops are changed while the machine stands; `in_hand` (null: none) is
  /// not asked.
  [[nodiscard]] sim::Task<void> join_stop(MachineUnit& machine, const MountedTool* in_hand,
                                          const std::vector<std::size_t>* present);
  [[nodiscard]] sim::Task<void> inspect_edge(MachineUnit& machine, MountedTool& tool, double mean_life_min);
  [[nodiscard]] sim::Task<void> change_element(MachineUnit& machine, MountedTool& tool, ElementUnit& element);
  [[nodiscard]] sim::Task<void> wait_for_inserts(MachineUnit& machine, MountedTool& tool,
                                                 std::int64_t inserts);
  /// Books a change; `renew_teeth` makes it and returns `time_min` plus the time at the teeth.
  void count_change(const MountedTool& tool, bool after_failure);
  [[nodiscard]] double renew_teeth(MountedTool& tool, ToolBody& body, bool after_failure, bool reground,
                                   double mean_life_min, double time_min);

  // tool_room.cpp: copies of tools
  [[nodiscard]] sim::Task<void> swap_tool(MachineUnit& machine, MountedTool& tool, bool after_failure,
                                          double mean_life_min);
  /// A copy comes into the machine; waits until one is ready.
  [[nodiscard]] sim::Task<void> fetch_tool(MachineUnit& machine, MountedTool& tool);
  /// A shared copy is free for other machines.
  static void put_back(MountedTool& tool);
  /// New edges, regrinding and setting off the machine; then the copy is ready again.
  [[nodiscard]] sim::Task<void> tool_room(MountedTool& tool, ToolBody& body, bool after_failure,
                                          double mean_life_min);

  // quality.cpp
  /// Whether the tool breaks in this cut, and whether the part is spoiled by the process, as the plan says.
  [[nodiscard]] static bool breaks(MachineUnit& machine, const PlannedOperation& operation);
  [[nodiscard]] static bool spoils(MachineUnit& machine, const PlannedOperation& operation);
  [[nodiscard]] bool leaves_defect(MachineUnit& machine, const PlannedOperation& operation);
  /// Number of parts of the batch that an inspection rejects; their defects leave the batch with them.
  [[nodiscard]] std::int64_t inspect(MachineUnit& machine, const PlannedOperation& operation, Job& job);
  /// The same with gauges that wear and are replaced.
  [[nodiscard]] sim::Task<std::int64_t> inspect_with_gauges(MachineUnit& machine,
                                                            const PlannedOperation& operation, Job& job);
  struct Verdict {
    std::int64_t rejected = 0;
    std::int64_t rejected_defects = 0;  // of them
  };
  /// Where no operation of the route says that it leaves defects, the first inspection by a process model
  /// meets them at the share that its plan assumes.
  void assume_defects(MachineUnit& machine, const PlannedOperation& operation, Job& job);
  /// One part of the batch is looked at, or not; whether it was.
  static bool judge(MachineUnit& machine, const scenarios::Inspection& inspection, bool defective,
                    Verdict& verdict);
  /// The verdict on a batch, with lot acceptance; counted.
  [[nodiscard]] std::int64_t conclude(const MachineUnit& machine, const PlannedOperation& operation, Job& job,
                                      Verdict verdict);
  /// Takes `quantity` rejected parts out of the batch: to rework, or to scrap.
  void reject(MachineUnit& machine, Job& job, std::int64_t quantity);

  // flow.cpp: batches between machines
  [[nodiscard]] sim::Task<void> arrivals(Source& source);
  [[nodiscard]] sim::Task<void> demand(StoreUnit& store);
  [[nodiscard]] sim::Task<void> pass_on(MachineUnit& machine, Job& job);
  [[nodiscard]] sim::Task<void> carry(Job& job, Carrier& carrier, std::size_t from, Place to);
  [[nodiscard]] Job* take_job(MachineUnit& machine);
  [[nodiscard]] std::size_t best_waiting(const MachineUnit& machine) const;
  [[nodiscard]] Job* new_unlimited_job(Group& group);
  void count_batch(std::size_t part);
  [[nodiscard]] Job* new_job(std::size_t part, std::int64_t quantity);
  [[nodiscard]] const PlannedOperation& planned(const Job& job) const;
  [[nodiscard]] std::size_t choose_step(MachineUnit& machine, const Job& job);
  [[nodiscard]] std::size_t choose_group(std::size_t operation);
  [[nodiscard]] bool has_room(Place place, const Job& job) const;
  [[nodiscard]] Carrier* carrier_between(std::size_t from_group, Place to);
  void backlog(std::size_t part, std::int64_t quantity, double due_min);
  void release_what_may(std::size_t part);
  void release_after_queue_change(std::size_t group);
  void start_route(Job& job);
  void send(Job& job, std::size_t group);
  void arrive(Job& job);
  [[nodiscard]] bool take_components(std::size_t part, std::size_t step, std::int64_t quantity);
  void serve_assemblies();
  void store_parts(Job& job);
  void finish(Job& job);
  void count_lead_time(const Job& job, std::int64_t quantity);

  // standstill.cpp
  void look_for_standstill(const MachineUnit& blocked);
  void note_standstill(const std::vector<Labour::Wait>& waits);

  // kpis.cpp, tool_kpis.cpp
  void simulate_until(double time_min);
  void reset_counts();
  void settle();
  void book_totals();
  /// Hands every KPI to the sink, in order: names and values stand together.
  void each_kpi(const KpiSink& sink) const;
  [[nodiscard]] bool can_occur(const Group& group, MachineState state) const;
  [[nodiscard]] bool can_occur(Cost cost) const;
  void shop_kpis(const KpiSink& sink) const;
  void machine_kpis(const KpiSink& sink) const;
  void part_kpis(const KpiSink& sink) const;
  /// `finished` parts in the counted time, good or scrapped.
  void tool_kpis(double finished, const KpiSink& sink) const;
  void insert_kpis(double finished, const KpiSink& sink) const;
  [[nodiscard]] static std::optional<double> cycle_availability(const MountedTool& tool);
  void reset_tool_counts();
  /// Adds laws of edges, inserts and copies that do not hold.
  void audit_tools(std::vector<std::string>& broken) const;
  /// Edges in all copies of a tool.
  [[nodiscard]] std::int64_t edges_in_tools(std::size_t tool) const;
  void crew_kpis(const KpiSink& sink) const;
  // quality.cpp
  void gauge_kpis(const KpiSink& sink) const;
  void requirement_kpis(std::size_t part, const KpiSink& sink) const;
  void reset_quality_counts();
  // criteria_kpis.cpp
  void criteria_kpis(const KpiSink& sink) const;
  /// What the criteria of K205 ask of a run; no part started: none.
  [[nodiscard]] std::optional<models::k205::SimulationResult> criteria_inputs() const;
  void store_and_transport_kpis(const KpiSink& sink) const;
  [[nodiscard]] double window_min() const {
    return scenario_.simulation.horizon_min - scenario_.simulation.warmup_min;
  }

  const scenarios::Scenario& scenario_;
  std::uint64_t replication_;
  Trace* trace_;
  JobPool jobs_;
  Costs costs_;
  // Before the simulation: processes end with it, and what they hold goes back.
  std::unique_ptr<Labour> labour_;
  sim::Simulation sim_;
  std::vector<OperationUnit> operations_;  // one per operation of the scenario
  std::vector<std::string> families_;
  std::vector<std::unique_ptr<Group>> groups_;
  std::vector<scenarios::Insert> inserts_;          // as fitted; behind them one for tools without
  std::vector<std::unique_ptr<LotSource>> lots_;    // one per insert; null: one lot
  std::vector<std::unique_ptr<InsertCrib>> cribs_;  // one per insert; null: always enough
  std::vector<std::unique_ptr<ToolPool>> pools_;    // of copies
  std::vector<std::unique_ptr<MachineUnit>> machines_;
  std::vector<std::vector<MountedTool*>> mounted_;  // by tool of the scenario, in the order of the machines
  std::vector<std::vector<ToolPool*>> pools_of_;    // by tool of the scenario
  std::vector<std::unique_ptr<Spares>> spares_;
  std::vector<std::unique_ptr<StoreUnit>> stores_;
  std::vector<StoreUnit*> store_of_;              // by part type
  std::vector<std::unique_ptr<Source>> sources_;  // one per part type
  std::vector<std::unique_ptr<Carrier>> carriers_;
  /// What a step leaves for good with the parts that the drawing asks for.
  struct StateAtStep {
    std::size_t requirement;    // of the part type
    std::vector<double> value;  // one per machine group that does it
    std::vector<double> fails;  // probability that a part falls short
  };
  struct RequirementCounts {
    std::uint64_t parts = 0;
    double mean_value = 0;  // over them
    double mean_fails = 0;
  };
  std::vector<std::vector<std::vector<StateAtStep>>> states_;       // [part][step]; [part] empty: none
  std::vector<std::vector<RequirementCounts>> requirement_counts_;  // [part][requirement]
  std::vector<bool> defects_known_;  // by part type: operations of its route say which defects they leave
  InspectionCounts inspections_;
  std::vector<ToolCounts> tools_;  // one per tool of the scenario
  /// Inserts of one grade, whatever their shape.
  struct Grade {
    std::string name;
    IntervalCount weeks;  // of inserts fitted
  };
  std::deque<Grade> grades_;           // by name
  std::vector<Grade*> grade_of_tool_;  // null: no grade is given
  std::vector<IntervalCount> weeks_of_insert_;
  std::vector<std::size_t> insert_of_tool_;
  std::vector<PartCounts> parts_;  // one per part type
  std::vector<scenarios::Route> routes_;
  std::vector<std::vector<double>> work_left_min_;  // [part][step]: expected work on the rest of the route
  std::vector<Job*> waiting_for_components_;
  std::vector<Group*> assembling_groups_;  // that start assemblies from blanks that are always available
  bool can_block_ = false;                 // a place in the shop can be full
  bool has_off_line_tools_ = false;
  std::optional<double> stands_since_min_;
  std::string standstill_;                  // who holds what for whom
  sim::TimeWeighted work_in_process_{0.0};  // parts in the shop
  sim::QuantileSketch lead_times_;
  std::uint64_t next_number_ = 0;
  std::int64_t batches_ = 0;  // in the shop or waiting for release
  Fingerprint event_order_;
};

}  // namespace verstat::shop
