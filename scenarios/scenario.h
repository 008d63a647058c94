#pragma once
// What a shop is: plain data, as the JSON file says it. Parts follow routes over machines that hold tools
// served by crews; those nouns are the keys of the file.
//
// The description of every member (name, unit, range, default, meaning) stands in the *_fields.cpp files,
// once: the loader, the JSON Schema, the forms and the reference page are made from it.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/catalogue/field.h"
#include "operations/kind.h"
#include "scenarios/criteria.h"
#include "scenarios/flow.h"
#include "scenarios/machines.h"
#include "scenarios/people.h"
#include "scenarios/tooling.h"

namespace verstat::scenarios {

// ---------------------------------------------------------------------------------------------------- the
// whole
/// Seeds go through JSON as texts: JavaScript has no 64-bit integers.
struct Seed {
  std::uint64_t value = 1;
};

/// What a planned insert change counts as in the OEE.
enum class PlannedChange {
  setup,            ///< an availability loss, with the set-ups
  delay,            ///< an availability loss, with the stops (ISO 22400: delay time)
  planned_downtime  ///< outside the planned busy time
};

/// Something that had another name before. Random numbers are drawn by name, so that adding, removing or
/// reordering things changes nothing for the others; with this, renaming changes nothing either.
struct Renamed {
  std::string name;
  std::string was;  ///< the name its random numbers are drawn by
};

struct SimulationSettings {
  double horizon_min = 120'000;
  double warmup_min = 0;
  std::int64_t replications = 20;
  Seed seed;
  PlannedChange planned_change = PlannedChange::delay;
  bool allow_overload = false;           ///< simulate a shop that cannot keep up with its demand
  double unattended_min = 480;           ///< interval whose chance of passing without a stop is reported
  std::int64_t max_events = 50'000'000;  ///< of one replication; a shop that needs more is refused
  std::vector<Renamed> renamed;
};

/// The name that the random numbers of `name` are drawn by.
[[nodiscard]] const std::string& drawn_as(const SimulationSettings& settings, const std::string& name);

struct Scenario {
  std::string name;
  std::string description;
  std::string currency = "UAH";
  SimulationSettings simulation;
  std::vector<Insert> inserts;
  std::vector<Tool> tools;
  std::vector<Calendar> calendars;
  std::vector<Crew> crews;
  std::vector<Spare> spares;
  std::vector<Machine> machines;
  std::vector<Operation> operations;
  std::vector<Store> stores;
  std::vector<PartType> parts;
  std::vector<Transport> transport;
  std::vector<LayoutEdge> layout;
  double energy_price_per_kwh = 0;
  std::optional<CriteriaSettings> criteria;
};

/// The plan of an operation on a machine, with the tool that the scenario gives it.
/// Throws models::ModelError when its process models refuse the specification.
[[nodiscard]] operations::CutPlan plan(const Scenario& scenario, const Operation& operation,
                                       const Machine& machine);
/// The same on the first of its machine groups.
[[nodiscard]] operations::CutPlan plan(const Scenario& scenario, const Operation& operation);

/// Cost of one member of a crew that states its wages, money per minute on shift
/// (K409.maintenance_wage_fund).
[[nodiscard]] double wage_fund_per_min(const Crew& crew);

/// Indices of the machine groups that can do the operation, in the order in which they are named (a
/// capability: in the order of the scenario).
[[nodiscard]] std::vector<std::size_t> groups_of(const Scenario& scenario, const Operation& operation);

/// The members of a scenario, for the loader, the schema and the reference page.
[[nodiscard]] const std::vector<models::Field>& scenario_fields();

/// Element with this name, or null. T has a member `name`.
template <class T>
[[nodiscard]] const T* find_named(const std::vector<T>& all, const std::string& name) {
  for (const T& one : all)
    if (one.name == name) return &one;
  return nullptr;
}

}  // namespace verstat::scenarios
