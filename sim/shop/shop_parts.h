#pragma once
// The inner parts of a Shop; nobody else includes this.

#include <deque>
#include <limits>

#include "scenarios/layout.h"
#include "sim/kernel/arrivals.h"
#include "sim/kernel/pooled.h"
#include "sim/kernel/ring_buffer.h"
#include "sim/shop/durations.h"
#include "sim/shop/shop.h"
#include "sim/shop/unattended.h"

namespace verstat::shop {

// Identical machines share one queue of batches.
struct Shop::Group : sim::Pooled {
  struct Limit {
    std::size_t by;  // group, or what comes behind the groups
    double minutes = 0;
  };
  Group(sim::Simulation& sim, const scenarios::Machine& machine, std::size_t group_index)
      : spec(&machine),
        index(group_index),
        queue_capacity(machine.queue_capacity.value_or(std::numeric_limits<std::int64_t>::max() / 2)),
        dispatch(machine.dispatch),
        has_setup(machine.setup.has_value()),
        switches_off(machine.switch_off.has_value()),
        room(sim) {
    if (machine.attendance) attended = machine.attendance->during;
  }
  void no_longer_idle(const MachineUnit& machine) {
    for (std::size_t k = 0; k < idle.size(); ++k)
      if (idle[k] == &machine) return static_cast<void>(idle.erase(k));
  }
  // What every batch asks comes first.
  const scenarios::Machine* spec;
  std::size_t index;
  std::int64_t on_their_way = 0;  // batches sent here that have not arrived: their room is taken
  std::int64_t in_work = 0;
  std::int64_t queue_capacity;         // the largest number: none
  sim::RingBuffer<Job*> queue;         // in order of arrival
  sim::RingBuffer<MachineUnit*> idle;  // machines that wait for work, who waits longest first
  scenarios::Dispatch dispatch;
  std::optional<scenarios::Attendance> attended;
  bool has_setup;
  bool switches_off;
  bool pauses = false;                       // parts in work at the end of a shift
  std::vector<std::size_t> unlimited_parts;  // part types that are always available and start here
  std::vector<std::size_t> releases;         // part types whose release waits for this queue to shorten
  std::vector<Limit> starved_of;             // see limits.cpp
  std::vector<Limit> blocked_by;
  sim::TimeWeighted queue_length;
  sim::Signal room;  // the queue has become shorter
  std::vector<MachineUnit*> machines;
  bool assembles_unlimited = false;  // one of the unlimited parts starts with an assembly
  bool has_tool = false;
  bool has_gauge = false;  // that is replaced at its wear limit
  std::size_t next_unlimited = 0;
  std::optional<scenarios::WorkingTime> working_time;
  std::optional<sim::Distribution> loading_time;
  std::optional<sim::Distribution> unloading_time;
  std::optional<sim::Distribution> break_repair;
  std::vector<std::size_t> overload_crews;
  std::optional<sim::Distribution> warm_up_time;
  struct SetupLaw {
    std::optional<std::size_t> from;  // none: any
    std::optional<std::size_t> to;
    sim::Distribution time;
  };
  std::vector<SetupLaw> setup_times;
  std::vector<std::size_t> setup_crews;
  std::vector<std::size_t> attendance_crews;
};

// Copies of a tool that take each other's place; what is not in a machine or in the tool room is ready.
struct Shop::ToolPool {
  explicit ToolPool(sim::Simulation& sim) : ready(sim) {}
  std::vector<std::unique_ptr<ToolBody>> copies;
  std::size_t tool = 0;  // in the scenario's tools
  std::size_t in_tool_room = 0;
  sim::Store<ToolBody*> ready;
};

// A second element that operations with this tool wear.
struct Shop::ElementUnit {
  ElementUnit(const scenarios::ElementService& service, const operations::ElementLife& element,
              std::uint64_t seed, const std::string& entity, std::uint64_t replication);
  void renew();
  const scenarios::ElementService* spec;
  models::LifeLaw unit_life;
  double limit;  // planned change, mean lives; infinite: none
  double life = 0;
  double wear = 0;
  double use_min = 0;  // cutting since it was changed
  sim::Distribution change_time;
  sim::RandomStream life_stream;
  sim::RandomStream change_stream;
  std::uint64_t changes = 0;  // since the warm-up, and their use
  double use_min_sum = 0;
};

// A tool on a machine: its own clock, and the copy that works.
struct Shop::MountedTool : sim::Pooled {
  MountedTool(const scenarios::Scenario& scenario, std::size_t index, const scenarios::Insert& insert,
              const MachineUnit& machine, const std::string& entity, std::uint64_t replication);
  [[nodiscard]] ToolView view(double main_time_min) const;
  // What every cut asks comes first.
  const scenarios::Tool* spec;
  const scenarios::Insert* insert_spec;
  std::size_t index;         // in the scenario's tools
  std::size_t machine;       // among all machines
  ToolBody* body = nullptr;  // in the machine
  double mean_life_min = 0;  // of an edge in the operation before
  std::unique_ptr<Strategy> strategy;
  const scenarios::ConditionBased* watch = nullptr;  // the strategy, when it is that one
  ToolPool* pool = nullptr;                          // when copies are changed
  std::vector<ElementUnit> elements;
  StateClock clock;
  double sign_share = 1;  // of its life from which an edge shows its wear
  std::vector<std::size_t> crews;
  std::vector<std::size_t> failure_crews;
  std::vector<std::size_t> presetting_crews;
  InsertCrib* crib = nullptr;      // null: there are always inserts
  std::unique_ptr<ToolBody> own;   // when edges are changed on the machine
  const ToolBody* last = nullptr;  // that was in the machine before
  IntervalCount stops;             // of the machine that somebody has to come for, or that wait for a tool
  IntervalCount changes;           // of the tool
  sim::Distribution index_time;
  sim::Distribution replace_time;
  sim::Distribution swap_time;
  std::optional<sim::Distribution> presetting_time;
  std::optional<sim::Distribution> regrind_time;
  sim::RandomStream index_stream;
  sim::RandomStream replace_stream;
  sim::RandomStream scrap_stream;
  sim::RandomStream swap_stream;
  sim::RandomStream inspection_stream;
  sim::RandomStream presetting_stream;
  sim::RandomStream regrind_stream;
};

// The gauges of one operation at one machine.
struct Shop::GaugeUnit {
  const PlannedOperation* operation;
  [[nodiscard]] const operations::GaugeWear& spec() const { return *operation->plan.gauge; }
  [[nodiscard]] double worn() const {
    return start + static_cast<double>(checks_of_this_one) * spec().wear_per_check;
  }
  double start = 0;  // share worn off when these gauges came
  std::uint64_t checks_of_this_one = 0;
  // Since the end of the warm-up.
  std::uint64_t checks = 0;
  std::uint64_t changes = 0;
  double worn_sum = 0;  // over the checks
  std::uint64_t good = 0;
  std::uint64_t good_rejected = 0;
  std::uint64_t defective = 0;
  std::uint64_t defective_accepted = 0;
};

// A failure mode or a maintenance job of one machine.
struct Shop::Stop : sim::Pooled {
  Stop(std::uint64_t seed, const std::string& entity, std::uint64_t replication)
      : life_stream(seed, entity, "time to failure", replication),
        duration_stream(seed, entity, "stop duration", replication),
        scrap_stream(seed, entity, "scrap", replication),
        detection_stream(seed, entity, "detection", replication) {}
  const scenarios::FailureMode* failure = nullptr;  // one of the two
  const scenarios::Maintenance* maintenance = nullptr;
  scenarios::UsageClock clock = scenarios::UsageClock::calendar;
  scenarios::StopEffect effect = scenarios::StopEffect::at_once;
  double renewed = 0;  // reading of the clock when it was as new
  double due = 0;      // reading at which it comes
  std::optional<sim::Distribution> life;
  std::optional<sim::Distribution> duration;
  std::vector<std::size_t> crews;
  std::size_t spare = scenarios::route_end;
  std::vector<std::size_t> renews;  // indices of failure modes among the machine's stops
  sim::RandomStream life_stream;
  sim::RandomStream duration_stream;
  sim::RandomStream scrap_stream;
  sim::RandomStream detection_stream;
  std::uint64_t count = 0;
};

struct Shop::MachineUnit : sim::Pooled {
  MachineUnit(const scenarios::Scenario& scenario, std::string unit_name, std::string entity,
              Group& machine_group, std::size_t unit_index, sim::Simulation& sim, std::uint64_t replication)
      : group(&machine_group),
        index(unit_index),
        clock(machine_group.working_time ? &*machine_group.working_time : nullptr),
        inbox(sim),
        name(std::move(unit_name)),
        drawn_as(std::move(entity)),
        duration_stream(scenario.simulation.seed.value, drawn_as, "plain duration", replication),
        breakage_stream(scenario.simulation.seed.value, drawn_as, "tool breakage", replication),
        quality_stream(scenario.simulation.seed.value, drawn_as, "process scrap", replication),
        defect_stream(scenario.simulation.seed.value, drawn_as, "hidden defect", replication),
        inspection_stream(scenario.simulation.seed.value, drawn_as, "inspection", replication),
        loading_stream(scenario.simulation.seed.value, drawn_as, "loading", replication),
        unloading_stream(scenario.simulation.seed.value, drawn_as, "unloading", replication),
        setup_stream(scenario.simulation.seed.value, drawn_as, "setup", replication),
        routing_stream(scenario.simulation.seed.value, drawn_as, "routing", replication),
        overload_stream(scenario.simulation.seed.value, drawn_as, "overload", replication) {}
  // What every part asks comes first.
  Group* group;
  std::size_t index;            // among all machines
  Job* job = nullptr;           // in work
  bool has_joiners = false;     // a tool whose strategy uses other stops
  bool part_spoiled = false;    // the part in work
  bool standing_still = false;  // a stop is being dealt with
  double part_wear = 0;         // of the edge after the part in work, in mean lives
  std::vector<std::unique_ptr<Stop>> stops;
  std::vector<std::unique_ptr<MountedTool>> tools;  // by name, the same on every machine of the group
  // Readings of the usage clocks.
  double operating_min = 0;
  double cutting_min = 0;
  double parts = 0;
  // Counted since the end of the warm-up.
  std::uint64_t parts_done = 0;
  double planned_min = 0;  // main time of the parts done, as planned
  std::uint64_t active_periods = 0;
  StateClock clock;
  sim::Store<Job*> inbox;  // a batch handed over to an idle machine
  std::optional<std::size_t> family;
  double idle_told_min = 0;  // of the idle and blocked minutes, those of which it is told who caused them
  double blocked_told_min = 0;
  Place waits_for;         // when it is blocked; nowhere: on a conveyor that is full
  IntervalCount missions;  // windows with failures, for the criteria of efficiency
  std::vector<GaugeUnit> gauges;
  std::string name;
  std::string drawn_as;  // its random numbers
  std::uint64_t parts_rejected = 0;
  std::uint64_t setups = 0;
  std::uint64_t failures = 0;
  std::uint64_t maintenance_jobs = 0;
  std::uint64_t overload_trips = 0;
  std::uint64_t overload_breaks = 0;
  sim::RandomStream duration_stream;
  sim::RandomStream breakage_stream;
  sim::RandomStream quality_stream;
  sim::RandomStream defect_stream;
  sim::RandomStream inspection_stream;
  sim::RandomStream loading_stream;
  sim::RandomStream unloading_stream;
  sim::RandomStream setup_stream;
  sim::RandomStream routing_stream;
  sim::RandomStream overload_stream;
};

struct Shop::Spares {
  Spares(const scenarios::Spare& spare, sim::Simulation& sim, const scenarios::SimulationSettings& settings,
         std::uint64_t replication)
      : spec(&spare),
        stock(spare.stock),
        arrived(sim),
        lead_time(law_of(spare.lead_time)),
        lead_time_stream(settings.seed.value, drawn_as(settings, spare.name), "lead time", replication) {}
  const scenarios::Spare* spec;
  std::int64_t stock;
  std::int64_t ordered = 0;
  std::uint64_t used = 0;
  std::uint64_t used_ever = 0;
  std::uint64_t delivered_ever = 0;
  std::uint64_t stock_outs = 0;
  sim::Signal arrived;
  sim::Distribution lead_time;
  sim::RandomStream lead_time_stream;
};

struct Shop::StoreUnit : sim::Pooled {
  StoreUnit(const scenarios::Store& store, std::size_t store_index, sim::Simulation& sim)
      : spec(&store), index(store_index), room(sim) {}
  const scenarios::Store* spec;
  std::size_t index;
  std::vector<std::int64_t> parts;  // by part type
  std::vector<std::size_t> kinds;   // part types that are kept here
  std::int64_t level = 0;
  std::int64_t on_their_way = 0;  // parts that have left their machine for here
  sim::Signal room;
  sim::TimeWeighted mean_level;
  std::uint64_t customers = 0;
  std::uint64_t lost = 0;
  std::uint64_t taken = 0;      // by customers, ever
  std::uint64_t assembled = 0;  // into other parts, ever
  std::uint64_t stored = 0;     // ever
};

// How blanks of one part type come and are let into the shop.
struct Shop::Source : sim::Pooled {
  Source(const scenarios::PartType& type, std::size_t part_index,
         const scenarios::SimulationSettings& settings, std::uint64_t replication)
      : spec(&type),
        part(part_index),
        arrival_stream(settings.seed.value, drawn_as(settings, type.name), "interarrival", replication),
        due_stream(settings.seed.value, drawn_as(settings, type.name), "due date", replication) {}
  struct Waiting {
    std::int64_t quantity;
    double arrived_min;
    double due_min;
  };
  const scenarios::PartType* spec;
  std::size_t part;
  std::deque<Waiting> backlog;  // arrived, not yet released
  std::int64_t batches_in_shop = 0;
  std::uint64_t released_ever = 0;  // parts
  std::uint64_t ended_ever = 0;     // parts stored or scrapped
  std::int64_t parts_in_shop = 0;
  std::optional<std::size_t> watched_group;  // of a station threshold
  std::optional<sim::Distribution> due_after;
  sim::RandomStream arrival_stream;
  sim::RandomStream due_stream;
};

// Vehicles of one transport entry.
struct Shop::Fleet {
  struct Vehicle {
    std::size_t at;  // place of the layout
    bool free = true;
  };
  std::vector<Vehicle> vehicles = {};
  scenarios::Layout layout;
  std::vector<std::size_t> crews = {};
  // Places of the layout where machine groups and stores stand; no place: route_end.
  std::vector<std::size_t> of_group = {};
  std::vector<std::size_t> of_store = {};
};

struct Shop::Carrier {
  Carrier(const scenarios::Transport& transport, sim::Simulation& sim,
          const scenarios::SimulationSettings& settings, std::uint64_t replication)
      : spec(&transport),
        room(sim),
        stream(settings.seed.value, drawn_as(settings, transport.name), "transport time", replication) {}
  const scenarios::Transport* spec;
  // Whether it serves moves from a group, to a group and to a store.
  std::vector<bool> from_group = {};
  std::vector<bool> to_group = {};
  std::vector<bool> to_store = {};
  std::optional<sim::Distribution> time;
  std::int64_t on_board = 0;
  sim::Signal room;  // of a conveyor; a vehicle that has become free
  std::optional<Fleet> fleet;
  double busy_min = 0;
  std::uint64_t moves = 0;
  sim::RandomStream stream;
};

}  // namespace verstat::shop
