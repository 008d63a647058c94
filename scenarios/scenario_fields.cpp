// The one description of every scenario element: name, unit, valid range, default and meaning.
#include <charconv>

#include "scenarios/scenario.h"

namespace verstat::models {

using namespace scenarios;

template <>
struct EnumNames<InsertBooking> {
  static constexpr std::array names{std::pair{InsertBooking::life_periods, "life_periods"},
                                    std::pair{InsertBooking::at_fitting, "at_fitting"}};
};
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

constexpr double longest_min = 1e9;  // nineteen centuries: beyond any plan, and still exact in a double

template <class S>
Field need(auto S::*pointer, std::string name, std::string unit, Range range, std::string meaning) {
  return member<S>(pointer, std::move(name), "", std::move(unit), range, std::move(meaning), true);
}
template <class S>
Field may(auto S::*pointer, std::string name, std::string unit, Range range, std::string meaning) {
  return member<S>(pointer, std::move(name), "", std::move(unit), range, std::move(meaning), false);
}
Field entries(Field f, std::size_t least, std::size_t most) {
  f.min_length = least;
  f.max_length = most;
  return f;
}

constexpr Range a_duration = closed(0, longest_min);
constexpr Range money = closed(0, 1e12);

}  // namespace

template <>
struct StructFields<ConstantDuration> {
  static std::vector<Field> fields() {
    return {need(&ConstantDuration::value_min, "value_min", "min", a_duration, "the duration")};
  }
};
template <>
struct StructFields<ExponentialDuration> {
  static std::vector<Field> fields() {
    return {need(&ExponentialDuration::rate_per_min, "rate_per_min", "1/min", closed(1e-9, 1e9),
                 "rate; the mean is 1/rate")};
  }
};
template <>
struct StructFields<UniformDuration> {
  static std::vector<Field> fields() {
    return {need(&UniformDuration::low_min, "low_min", "min", a_duration, "shortest"),
            need(&UniformDuration::high_min, "high_min", "min", a_duration, "longest")};
  }
};
template <>
struct StructFields<TriangularDuration> {
  static std::vector<Field> fields() {
    return {need(&TriangularDuration::low_min, "low_min", "min", a_duration, "shortest"),
            need(&TriangularDuration::mode_min, "mode_min", "min", a_duration, "most likely"),
            need(&TriangularDuration::high_min, "high_min", "min", a_duration, "longest")};
  }
};
template <class D>
requires std::same_as<D, LognormalDuration> || std::same_as<D, GammaDuration> ||
    std::same_as<D, WeibullDuration>
struct StructFields<D> {
  static std::vector<Field> fields() {
    return {need(&D::mean_min, "mean_min", "min", open_low(0, longest_min), "mean"),
            need(&D::cv, "cv", "1", closed(0.05, 2), "coefficient of variation")};
  }
};

template <>
struct StructFields<EdgeLife> {
  static std::vector<Field> fields() {
    return {
        may(&EdgeLife::law, "law", "-", no_range(), "life law of an edge"),
        may(&EdgeLife::cv, "cv", "1", closed(0.05, 2),
            "coefficient of variation of life (normal law: 0.05 to 0.45)"),
        need(&EdgeLife::mean_ref_min, "mean_ref_min", "min", open_low(0, 1e6),
             "mean edge life at the reference regime"),
        need(&EdgeLife::cutting_speed_ref_m_min, "cutting_speed_ref_m_min", "m/min", open_low(0, 1e5),
             "cutting speed of the reference regime"),
        need(&EdgeLife::feed_ref_mm_rev, "feed_ref_mm_rev", "mm/rev", open_low(0, 100),
             "feed of the reference regime"),
        need(&EdgeLife::depth_of_cut_ref_mm, "depth_of_cut_ref_mm", "mm", open_low(0, 1000),
             "depth of cut of the reference regime"),
        may(&EdgeLife::speed_exponent, "speed_exponent", "1", open_low(1, 50), "mu: mean life goes as V^-mu"),
        may(&EdgeLife::feed_exponent, "feed_exponent", "1", closed(0, 5),
            "y: speed at equal life goes as S^-y"),
        may(&EdgeLife::depth_exponent, "depth_exponent", "1", closed(0, 5),
            "x: speed at equal life goes as t^-x")};
  }
};

template <>
struct StructFields<Insert> {
  static std::vector<Field> fields() {
    return {need(&Insert::name, "name", "-", no_range(), "name that tools refer to"),
            may(&Insert::grade, "grade", "-", no_range(), "carbide grade or cutting material"),
            may(&Insert::edges, "edges", "1", closed(1, 16), "cutting edges of one insert"),
            need(&Insert::price, "price", "money", money, "price of one insert"),
            need(&Insert::edge_life, "edge_life", "-", no_range(), "life of one edge"),
            may(&Insert::reserve_ok_probability, "reserve_ok_probability", "1", probability(),
                "chance that a failed edge leaves the next one usable"),
            may(&Insert::single_edge_probability, "single_edge_probability", "1", probability(),
                "chance that a fitted insert has only one usable edge"),
            may(&Insert::provenance, "provenance", "-", no_range(), "where the numbers come from")};
  }
};

template <>
struct StructFields<RunToFailure> {
  static std::vector<Field> fields() { return {}; }
};
template <class S>
requires std::same_as<S, AgeReplacement> || std::same_as<S, PartCountReplacement> ||
    std::same_as<S, BlockReplacement>
struct StructFields<S> {
  static std::vector<Field> fields() {
    return {need(&S::gamma, "gamma", "1", closed(0.01, 0.99),
                 "reliability level: probability that an edge survives its scheduled period")};
  }
};

template <>
struct StructFields<ToolChange> {
  static std::vector<Field> fields() {
    return {may(&ToolChange::index, "index", "min", no_range(), "time to turn the insert to its next edge"),
            may(&ToolChange::replace, "replace", "min", no_range(), "time to fit a new insert"),
            may(&ToolChange::positioning_min, "positioning_min", "min", closed(0, 1e6),
                "added to every change: approach, trial cut, measuring"),
            may(&ToolChange::failure_extra_min, "failure_extra_min", "min", closed(0, 1e6),
                "added to a change after a failure")};
  }
};

template <>
struct StructFields<Tool> {
  static std::vector<Field> fields() {
    return {
        need(&Tool::name, "name", "-", no_range(), "name that operations refer to"),
        need(&Tool::insert, "insert", "-", no_range(), "name of the insert it holds"),
        may(&Tool::strategy, "strategy", "-", no_range(), "when an edge is changed"),
        need(&Tool::crew, "crew", "-", no_range(), "name of the crew that changes edges"),
        may(&Tool::change, "change", "-", no_range(), "how long a change takes"),
        may(&Tool::insert_booking, "insert_booking", "-", no_range(),
            "when the price of an insert is booked"),
        may(&Tool::periods_planned, "periods_planned", "1", open_low(0, 1000),
            "life periods one insert yields when changed as planned"),
        may(&Tool::periods_failure, "periods_failure", "1", open_low(0, 1000),
            "life periods one insert yields when run to failure"),
        may(&Tool::regrind_planned, "regrind_planned", "money", money, "regrinding after a planned change"),
        may(&Tool::regrind_failure, "regrind_failure", "money", money, "regrinding after a failure"),
        may(&Tool::failure_damage, "failure_damage", "money", money, "holder, shim and rework per failure"),
        may(&Tool::failure_scrap_probability, "failure_scrap_probability", "1", probability(),
            "chance that a failure scraps the part in the machine")};
  }
};

template <>
struct StructFields<Crew> {
  static std::vector<Field> fields() {
    return {need(&Crew::name, "name", "-", no_range(), "name that tools refer to"),
            may(&Crew::members, "members", "1", closed(1, 10'000), "people who can work at the same time"),
            may(&Crew::rate_per_min, "rate_per_min", "money/min", money, "wage of one member"),
            may(&Crew::pay, "pay", "-", no_range(), "paid for the minutes worked or for the whole shift")};
  }
};

template <>
struct StructFields<Machine> {
  static std::vector<Field> fields() {
    return {need(&Machine::name, "name", "-", no_range(), "name that operations refer to"),
            may(&Machine::model, "model", "-", no_range(), "maker's model"),
            may(&Machine::count, "count", "1", closed(1, 10'000), "number of identical machines"),
            may(&Machine::rate_per_min, "rate_per_min", "money/min", money, "cost of a machine minute")};
  }
};

template <>
struct StructFields<Turning> {
  static std::vector<Field> fields() {
    return {need(&Turning::diameter_mm, "diameter_mm", "mm", open_low(0, 1e5), "diameter of the cut"),
            need(&Turning::length_mm, "length_mm", "mm", open_low(0, 1e6), "length of the cut"),
            may(&Turning::passes, "passes", "1", closed(1, 10'000), "number of passes"),
            need(&Turning::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e5),
                 "cutting speed v_c"),
            need(&Turning::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-4, 100), "feed f"),
            need(&Turning::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(1e-4, 1000), "depth of cut a_p"),
            need(&Turning::tool, "tool", "-", no_range(), "name of the tool")};
  }
};
template <>
struct StructFields<PlainOperation> {
  static std::vector<Field> fields() {
    return {need(&PlainOperation::time, "time", "min", no_range(), "time of the operation")};
  }
};

template <>
struct StructFields<Operation> {
  static std::vector<Field> fields() {
    return {need(&Operation::name, "name", "-", no_range(), "name that routes refer to"),
            need(&Operation::machine, "machine", "-", no_range(), "name of the machine group that does it"),
            need(&Operation::process, "process", "-", no_range(),
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
    return {need(&Interarrival::time, "time", "min", no_range(), "time between arrivals")};
  }
};

template <>
struct StructFields<PartType> {
  static std::vector<Field> fields() {
    return {need(&PartType::name, "name", "-", no_range(), "name of the part"),
            may(&PartType::supply, "supply", "-", no_range(), "how blanks come"),
            entries(need(&PartType::route, "route", "-", no_range(), "names of the operations in order"), 1,
                    1000),
            may(&PartType::value, "value", "money", money, "what a scrapped part loses"),
            need(&PartType::store, "store", "-", no_range(), "name of the store for good parts")};
  }
};

template <>
struct StructFields<Store> {
  static std::vector<Field> fields() {
    return {need(&Store::name, "name", "-", no_range(), "name that parts refer to")};
  }
};

template <>
struct StructFields<SimulationSettings> {
  static std::vector<Field> fields() {
    return {may(&SimulationSettings::horizon_min, "horizon_min", "min", open_low(0, longest_min),
                "simulated time, warm-up included"),
            may(&SimulationSettings::warmup_min, "warmup_min", "min", closed(0, longest_min),
                "time at the start that is simulated but not counted"),
            may(&SimulationSettings::replications, "replications", "1", closed(1, 100'000),
                "independent repetitions with other random numbers"),
            may(&SimulationSettings::seed, "seed", "-", no_range(),
                "seed of all random streams, 64 bits, as a text")};
  }
};

template <>
struct StructFields<Scenario> {
  static std::vector<Field> fields() {
    return {
        need(&Scenario::name, "name", "-", no_range(), "name of the shop"),
        may(&Scenario::description, "description", "-", no_range(), "what it shows"),
        may(&Scenario::currency, "currency", "-", no_range(), "unit of all money"),
        may(&Scenario::simulation, "simulation", "-", no_range(), "how it is simulated"),
        entries(may(&Scenario::inserts, "inserts", "-", no_range(), "inserts"), 0, 10'000),
        entries(may(&Scenario::tools, "tools", "-", no_range(), "tools"), 0, 10'000),
        entries(may(&Scenario::crews, "crews", "-", no_range(), "crews"), 0, 10'000),
        entries(need(&Scenario::machines, "machines", "-", no_range(), "groups of identical machines"), 1,
                10'000),
        entries(need(&Scenario::operations, "operations", "-", no_range(), "operations"), 1, 10'000),
        entries(need(&Scenario::stores, "stores", "-", no_range(), "stores of finished parts"), 1, 10'000),
        entries(need(&Scenario::parts, "parts", "-", no_range(), "types of part"), 1, 10'000)};
  }
};

}  // namespace verstat::models

namespace verstat::scenarios {

const std::vector<models::Field>& scenario_fields() {
  static const std::vector<models::Field> all = models::StructFields<Scenario>::fields();
  return all;
}

}  // namespace verstat::scenarios
