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
#include "scenarios/tooling.h"

namespace verstat::scenarios {

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
  std::optional<std::int64_t> magazine;  ///< tool places; none: no bound
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
  double unattended_min = 480;  ///< interval whose chance of passing without a stop is reported
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
