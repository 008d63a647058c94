#pragma once
// What a shop is: plain data, as the JSON file says it. Parts follow routes over machines that hold tools
// served by crews; those nouns are the keys of the file.
//
// The description of every member (name, unit, range, default, meaning) stands in scenario.cpp, once: the
// loader, the JSON Schema, the forms and the reference page are made from it.

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "models/catalogue/field.h"
#include "operations/edge_life.h"
#include "operations/kind.h"
#include "operations/spindle.h"

namespace verstat::scenarios {

using operations::Duration;
using operations::ExponentialDuration;
using operations::mean_min;

// --------------------------------------------------------------------------------------- inserts and their
// life
using operations::EdgeLife;

struct Insert {
  std::string name;
  std::string grade;
  std::int64_t edges = 2;
  double price = 0;
  EdgeLife edge_life;
  double reserve_ok_probability = 1;   ///< a failed edge leaves the next one usable
  double single_edge_probability = 0;  ///< a fitted insert has only one usable edge
  std::string provenance;              ///< where the numbers come from
};

// --------------------------------------------------------------------------------------------------
// strategies
struct RunToFailure {
  static constexpr const char* kind = "run_to_failure";
};
/// Change an edge at its gamma-percent life or at failure.
struct AgeReplacement {
  static constexpr const char* kind = "age";
  double gamma = 0.64;
};
/// Change after the whole parts that fit into the gamma-percent life, or at failure.
struct PartCountReplacement {
  static constexpr const char* kind = "part_count";
  double gamma = 0.64;
};
/// Change every gamma-percent life of cutting, whatever the age of the edge; failures in between.
struct BlockReplacement {
  static constexpr const char* kind = "block";
  double gamma = 0.64;
};
using Strategy = std::variant<RunToFailure, AgeReplacement, PartCountReplacement, BlockReplacement>;
/// Reliability level of a strategy; none for run to failure.
[[nodiscard]] std::optional<double> gamma_of(const Strategy& strategy);

/// When the price of an insert is booked.
enum class InsertBooking {
  life_periods,  ///< price / periods at every change (K117): planned and failure changes waste different
                 ///< shares
  at_fitting     ///< the whole price when an insert is fitted
};

struct ToolChange {
  Duration index = ExponentialDuration{0.3};    ///< turn the insert to its next edge
  Duration replace = ExponentialDuration{0.3};  ///< fit a new insert
  double positioning_min = 0;                   ///< on top of both: approach, trial cut, measuring
  double failure_extra_min = 0;                 ///< on top of both after a failure
};

struct Tool {
  std::string name;
  std::string insert;
  Strategy strategy = AgeReplacement{};
  std::string crew;  ///< who changes edges
  ToolChange change;
  InsertBooking insert_booking = InsertBooking::life_periods;
  double periods_planned = 4;
  double periods_failure = 2;
  double regrind_planned = 0;
  double regrind_failure = 0;
  double failure_damage = 0;  ///< holder, shim, rework: money per failure
  double failure_scrap_probability = 0;
};

// ------------------------------------------------------------------------------------- people, machines,
// parts
enum class CrewPay {
  busy,  ///< paid for the minutes worked (K117)
  shift  ///< paid for the whole scheduled time
};
struct Crew {
  std::string name;
  std::int64_t members = 1;
  double rate_per_min = 0;
  CrewPay pay = CrewPay::busy;
};

struct Machine {
  std::string name;
  std::string model;
  std::int64_t count = 1;
  double rate_per_min = 0;
  operations::MachineLimits limits;
  std::optional<operations::Spindle> spindle;
};

struct Operation {
  std::string name;
  std::string machine;
  std::string tool;  ///< empty: no tool that wears
  operations::Process process;
};

struct AlwaysAvailable {
  static constexpr const char* kind = "always_available";
};
struct Interarrival {
  static constexpr const char* kind = "interarrival";
  Duration time;
};
using Supply = std::variant<AlwaysAvailable, Interarrival>;

struct PartType {
  std::string name;
  Supply supply;
  std::vector<std::string> route;  ///< names of operations
  double value = 0;                ///< lost when the part is scrapped
  std::string store;               ///< where good parts go
};

struct Store {
  std::string name;
};

// ---------------------------------------------------------------------------------------------------- the
// whole
/// Seeds go through JSON as texts: JavaScript has no 64-bit integers.
struct Seed {
  std::uint64_t value = 1;
};

struct SimulationSettings {
  double horizon_min = 120'000;
  double warmup_min = 0;
  std::int64_t replications = 20;
  Seed seed;
};

struct Scenario {
  std::string name;
  std::string description;
  std::string currency = "UAH";
  SimulationSettings simulation;
  std::vector<Insert> inserts;
  std::vector<Tool> tools;
  std::vector<Crew> crews;
  std::vector<Machine> machines;
  std::vector<Operation> operations;
  std::vector<Store> stores;
  std::vector<PartType> parts;
};

/// The plan of an operation with the tool and the machine that the scenario gives it.
/// Throws models::ModelError when its process models refuse the specification.
[[nodiscard]] operations::CutPlan plan(const Scenario& scenario, const Operation& operation);

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
