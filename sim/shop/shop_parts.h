#pragma once
// The inner parts of a Shop; nobody else includes this.

#include <map>

#include "sim/shop/durations.h"
#include "sim/shop/level_clock.h"
#include "sim/shop/shop.h"
#include "sim/shop/unattended.h"

namespace verstat::shop {

struct Shop::CrewUnit {
  CrewUnit(sim::Simulation& sim, const scenarios::Crew& crew)
      : spec(&crew), members(sim, crew.name, static_cast<int>(crew.members)) {}
  const scenarios::Crew* spec;
  sim::Resource members;
  LevelClock off_line;  // members at work in the tool room
};

// Identical machines share one queue of jobs.
struct Shop::Group {
  Group(sim::Simulation& sim, const scenarios::Machine& machine) : spec(&machine), queue(sim) {}
  const scenarios::Machine* spec;
  sim::Store<Job> queue;
  std::vector<std::size_t> unlimited_parts;  // part types that are always available and start here
  std::size_t next_unlimited = 0;
};

// Copies of a tool that take each other's place; what is not in a machine or in the tool room is ready.
struct Shop::ToolPool {
  explicit ToolPool(sim::Simulation& sim) : ready(sim) {}
  std::vector<std::unique_ptr<ToolBody>> copies;
  std::size_t tool = 0;  // in the scenario's tools
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
struct Shop::MountedTool {
  MountedTool(const scenarios::Scenario& scenario, const scenarios::Tool& spec, std::size_t index,
              const scenarios::Insert& insert, const std::string& entity, std::uint64_t replication);
  [[nodiscard]] ToolView view(double main_time_min) const;
  const scenarios::Tool* spec;
  const scenarios::Insert* insert_spec;
  std::size_t index;  // in the scenario's tools
  CrewUnit* crew = nullptr;
  CrewUnit* failure_crew = nullptr;
  CrewUnit* presetting_crew = nullptr;
  InsertCrib* crib = nullptr;      // null: there are always inserts
  std::unique_ptr<ToolBody> own;   // when edges are changed on the machine
  ToolPool* pool = nullptr;        // when copies are
  ToolBody* body = nullptr;        // in the machine
  const ToolBody* last = nullptr;  // that was in the machine before
  std::unique_ptr<Strategy> strategy;
  double sign_share = 1;     // of its life from which an edge shows its wear
  double mean_life_min = 0;  // of an edge in the operation before
  std::vector<ElementUnit> elements;
  StateClock clock;
  IntervalCount stops;    // of the machine that somebody has to come for, or that wait for a tool
  IntervalCount changes;  // of the tool
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

struct Shop::MachineUnit {
  MachineUnit(const scenarios::Scenario& scenario, std::string unit_name, Group& machine_group,
              std::uint64_t replication)
      : name(std::move(unit_name)),
        group(&machine_group),
        duration_stream(scenario.simulation.seed.value, name, "plain duration", replication),
        breakage_stream(scenario.simulation.seed.value, name, "tool breakage", replication),
        quality_stream(scenario.simulation.seed.value, name, "process scrap", replication) {}
  std::string name;
  Group* group;
  StateClock clock;
  std::map<std::string, std::unique_ptr<MountedTool>> tools;  // by name
  bool has_joiners = false;                                   // a tool whose strategy uses other stops
  sim::RandomStream duration_stream;
  sim::RandomStream breakage_stream;
  sim::RandomStream quality_stream;
};

}  // namespace verstat::shop
