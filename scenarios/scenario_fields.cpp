// The one description of every scenario element: name, unit, valid range, default and meaning.
#include <charconv>

#include "operations/fields.h"
#include "scenarios/scenario.h"
#include "scenarios/tooling_fields.h"

namespace verstat::models {

using namespace scenarios;

template <>
struct EnumNames<CrewPay> {
  static constexpr std::array names{std::pair{CrewPay::busy, "busy"}, std::pair{CrewPay::shift, "shift"}};
};

template <>
struct detail::Binding<Seed> {
  static void read(Seed& to, const Value& v, const Field& f) {
    constexpr const char* expected = "a whole number from 0 to 18446744073709551615, as a text";
    if (const std::int64_t* i = v.integer(); i != nullptr && *i >= 0) {
      to.value = static_cast<std::uint64_t>(*i);
      return;
    }
    if (v.text() == nullptr) wrong_type(f, v, expected);
    const char* end = v.text()->data() + v.text()->size();
    const auto [stop, error] = std::from_chars(v.text()->data(), end, to.value);
    if (error != std::errc() || stop != end) wrong_type(f, v, expected);
  }
  static Value write(const Seed& x) { return std::to_string(x.value); }
  static void check(const Seed&, const Field&) {}
  static bool finite(const Seed&) { return true; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::text}; }
};

namespace {
constexpr Range money = closed(0, 1e12);
}  // namespace

template <>
struct StructFields<Crew> {
  static std::vector<Field> fields() {
    return {
        need<Crew>(&Crew::name, "name", "-", no_range(), "name that tools refer to"),
        may<Crew>(&Crew::members, "members", "1", closed(1, 10'000), "people who can work at the same time"),
        may<Crew>(&Crew::rate_per_min, "rate_per_min", "money/min", money, "wage of one member"),
        may<Crew>(&Crew::pay, "pay", "-", no_range(), "paid for the minutes worked or for the whole shift")};
  }
};

template <>
struct StructFields<Machine> {
  static std::vector<Field> fields() {
    return {
        need<Machine>(&Machine::name, "name", "-", no_range(), "name that operations refer to"),
        may<Machine>(&Machine::model, "model", "-", no_range(), "maker's model"),
        may<Machine>(&Machine::count, "count", "1", closed(1, 10'000), "number of identical machines"),
        may<Machine>(&Machine::rate_per_min, "rate_per_min", "money/min", money, "cost of a machine minute"),
        may<Machine>(&Machine::limits, "limits", "-", no_range(), "what the machine can do"),
        may<Machine>(&Machine::magazine, "magazine", "1", closed(1, 10'000),
                     "tool places; none: as many as are wanted")};
  }
};

template <>
struct StructFields<Operation> {
  static std::vector<Field> fields() {
    return {need<Operation>(&Operation::name, "name", "-", no_range(), "name that routes refer to"),
            need<Operation>(&Operation::machine, "machine", "-", no_range(),
                            "name of the machine group that does it"),
            may<Operation>(&Operation::tool, "tool", "-", no_range(),
                           "name of the tool; empty: nothing that wears"),
            need<Operation>(&Operation::process, "process", "-", no_range(),
                            "what is done: a process model or a plain duration")};
  }
};

template <>
struct StructFields<AlwaysAvailable> {
  static std::vector<Field> fields() { return {}; }
};
template <>
struct StructFields<Interarrival> {
  static std::vector<Field> fields() {
    return {need<Interarrival>(&Interarrival::time, "time", "min", no_range(), "time between arrivals")};
  }
};

template <>
struct StructFields<PartType> {
  static std::vector<Field> fields() {
    return {need<PartType>(&PartType::name, "name", "-", no_range(), "name of the part"),
            may<PartType>(&PartType::supply, "supply", "-", no_range(), "how blanks come"),
            entries(need<PartType>(&PartType::route, "route", "-", no_range(),
                                   "names of the operations in order"),
                    1, 1000),
            may<PartType>(&PartType::value, "value", "money", money, "what a scrapped part loses"),
            need<PartType>(&PartType::store, "store", "-", no_range(), "name of the store for good parts")};
  }
};

template <>
struct StructFields<Store> {
  static std::vector<Field> fields() {
    return {need<Store>(&Store::name, "name", "-", no_range(), "name that parts refer to")};
  }
};

template <>
struct StructFields<SimulationSettings> {
  static std::vector<Field> fields() {
    return {may<SimulationSettings>(&SimulationSettings::horizon_min, "horizon_min", "min", open_low(0, 1e9),
                                    "simulated time, warm-up included"),
            may<SimulationSettings>(&SimulationSettings::warmup_min, "warmup_min", "min", closed(0, 1e9),
                                    "time at the start that is simulated but not counted"),
            may<SimulationSettings>(&SimulationSettings::replications, "replications", "1",
                                    closed(1, 100'000), "independent repetitions with other random numbers"),
            may<SimulationSettings>(&SimulationSettings::seed, "seed", "-", no_range(),
                                    "seed of all random streams, 64 bits, as a text"),
            may<SimulationSettings>(&SimulationSettings::unattended_min, "unattended_min", "min",
                                    open_low(0, 1e9),
                                    "interval whose chance of passing without a stop is reported")};
  }
};

template <>
struct StructFields<Scenario> {
  static std::vector<Field> fields() {
    return {need<Scenario>(&Scenario::name, "name", "-", no_range(), "name of the shop"),
            may<Scenario>(&Scenario::description, "description", "-", no_range(), "what it shows"),
            may<Scenario>(&Scenario::currency, "currency", "-", no_range(), "unit of all money"),
            may<Scenario>(&Scenario::simulation, "simulation", "-", no_range(), "how it is simulated"),
            entries(may<Scenario>(&Scenario::inserts, "inserts", "-", no_range(), "inserts"), 0, 10'000),
            entries(may<Scenario>(&Scenario::tools, "tools", "-", no_range(), "tools"), 0, 10'000),
            entries(may<Scenario>(&Scenario::crews, "crews", "-", no_range(), "crews"), 0, 10'000),
            entries(need<Scenario>(&Scenario::machines, "machines", "-", no_range(),
                                   "groups of identical machines"),
                    1, 10'000),
            entries(need<Scenario>(&Scenario::operations, "operations", "-", no_range(), "operations"), 1,
                    10'000),
            entries(need<Scenario>(&Scenario::stores, "stores", "-", no_range(), "stores of finished parts"),
                    1, 10'000),
            entries(need<Scenario>(&Scenario::parts, "parts", "-", no_range(), "types of part"), 1, 10'000)};
  }
};

}  // namespace verstat::models

namespace verstat::scenarios {

const std::vector<models::Field>& scenario_fields() {
  static const std::vector<models::Field> all = models::StructFields<Scenario>::fields();
  return all;
}

}  // namespace verstat::scenarios
