// The one description of every scenario element: name, unit, valid range, default and meaning.
#include <charconv>

#include "operations/fields.h"
#include "scenarios/flow_fields.h"
#include "scenarios/machines_fields.h"
#include "scenarios/scenario.h"
#include "scenarios/tooling_fields.h"

namespace verstat::models {

using namespace scenarios;

template <>
struct EnumNames<PlannedChange> {
  static constexpr std::array names{std::pair{PlannedChange::setup, "setup"},
                                    std::pair{PlannedChange::delay, "delay"},
                                    std::pair{PlannedChange::planned_downtime, "planned_downtime"}};
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

template <>
struct StructFields<Renamed> {
  static std::vector<Field> fields() {
    return {need<Renamed>(&Renamed::name, "name", "-", no_range(), "its name now"),
            need<Renamed>(&Renamed::was, "was", "-", no_range(),
                          "the name it had; its random numbers are still drawn by it")};
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
            may<SimulationSettings>(&SimulationSettings::planned_change, "planned_change", "-", no_range(),
                                    "what planned insert changes count as in the OEE"),
            may<SimulationSettings>(&SimulationSettings::allow_overload, "allow_overload", "-", no_range(),
                                    "simulate a shop that cannot keep up with its demand"),
            may<SimulationSettings>(&SimulationSettings::unattended_min, "unattended_min", "min",
                                    open_low(0, 1e9),
                                    "interval whose chance of passing without a stop is reported"),
            may<SimulationSettings>(&SimulationSettings::max_events, "max_events", "1",
                                    closed(1, 10'000'000'000), "events that one replication may take"),
            entries(may<SimulationSettings>(&SimulationSettings::renamed, "renamed", "-", no_range(),
                                            "what has another name than before and is to keep its random "
                                            "numbers, so that the results stay what they were"),
                    0, 10'000)};
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
            entries(may<Scenario>(&Scenario::calendars, "calendars", "-", no_range(), "shifts and holidays"),
                    0, 1000),
            entries(may<Scenario>(&Scenario::spares, "spares", "-", no_range(), "spare parts"), 0, 10'000),
            entries(may<Scenario>(&Scenario::crews, "crews", "-", no_range(), "crews"), 0, 10'000),
            entries(need<Scenario>(&Scenario::machines, "machines", "-", no_range(),
                                   "groups of identical machines"),
                    1, 10'000),
            entries(need<Scenario>(&Scenario::operations, "operations", "-", no_range(), "operations"), 1,
                    10'000),
            entries(need<Scenario>(&Scenario::stores, "stores", "-", no_range(), "stores of finished parts"),
                    1, 10'000),
            entries(need<Scenario>(&Scenario::parts, "parts", "-", no_range(), "types of part"), 1, 10'000),
            entries(may<Scenario>(&Scenario::transport, "transport", "-", no_range(),
                                  "how batches go from place to place; the first entry that fits"),
                    0, 10'000),
            entries(may<Scenario>(&Scenario::layout, "layout", "-", no_range(), "ways between places"), 0,
                    100'000),
            may<Scenario>(&Scenario::energy_price_per_kwh, "energy_price_per_kwh", "money/kWh",
                          closed(0, 1e6), "price of energy"),
            may<Scenario>(&Scenario::criteria, "criteria", "-", no_range(),
                          "adds the criteria of efficiency of K205 to the results")};
  }
};

}  // namespace verstat::models

namespace verstat::scenarios {

const std::vector<models::Field>& scenario_fields() {
  static const std::vector<models::Field> all = models::StructFields<Scenario>::fields();
  return all;
}

}  // namespace verstat::scenarios
