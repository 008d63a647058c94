#pragma once
// The inner parts of a Shop; nobody else includes this.

#include <map>

#include "sim/shop/durations.h"
#include "sim/shop/shop.h"

namespace verstat::shop {

struct Shop::CrewUnit {
  CrewUnit(sim::Simulation& sim, const scenarios::Crew& crew)
      : spec(&crew), members(sim, crew.name, static_cast<int>(crew.members)) {}
  const scenarios::Crew* spec;
  sim::Resource members;
};

// Identical machines share one queue of jobs.
struct Shop::Group {
  Group(sim::Simulation& sim, const scenarios::Machine& machine) : spec(&machine), queue(sim) {}
  const scenarios::Machine* spec;
  sim::Store<Job> queue;
  std::vector<std::size_t> unlimited_parts;  // part types that are always available and start here
  std::size_t next_unlimited = 0;
};

// A tool on a machine: its own insert, its own clock.
struct Shop::MountedTool {
  MountedTool(const scenarios::Scenario& scenario, const scenarios::Tool& spec, std::size_t index,
              CrewUnit& crew, const std::string& entity, std::uint64_t replication);
  const scenarios::Tool* spec;
  const scenarios::Insert* insert_spec;
  std::size_t index;  // in the scenario's tools
  CrewUnit* crew;
  FittedInsert insert;
  std::unique_ptr<Strategy> strategy;
  double wear_since_plan = 0;
  StateClock clock;
  sim::Distribution index_time;
  sim::Distribution replace_time;
  sim::RandomStream index_stream;
  sim::RandomStream replace_stream;
  sim::RandomStream scrap_stream;
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
  sim::RandomStream duration_stream;
  sim::RandomStream breakage_stream;
  sim::RandomStream quality_stream;
};

}  // namespace verstat::shop
