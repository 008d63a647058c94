// What the long run leaves to the simulation, member by member: the place is named, and the same shop without
// that member is covered.
#include <catch2/catch.hpp>

#include "optimize/renewal_reward.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

const char* week = R"([{"name": "day", "shifts": [{"days": ["monday", "tuesday"], "from_h": 6, "to_h": 14}]},
  {"name": "night", "shifts": [{"days": ["monday"], "from_h": 14, "to_h": 22}]}])";

// The lathes of K117 with a second crew, spare parts at once, calendars and a second machine.
json shop() {
  json s = gallery("heavy-lathe.json");
  s["crews"].push_back({{"name", "fitter"}, {"members", 2}, {"rate_per_min", 0.9}});
  s["spares"] = json::parse(R"([
    {"name": "belt", "lead_time": {"kind": "constant", "value_min": 0}},
    {"name": "rare", "lead_time": {"kind": "constant", "value_min": 600}}])");
  s["calendars"] = json::parse(week);
  s["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}});
  s["operations"].push_back(json::parse(R"({"name": "milling", "machine": "mill",
    "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}})"));
  s["parts"][0]["route"] = {"rough turning", "milling"};
  return s;
}

using Changes = std::vector<std::pair<const char*, const char*>>;
std::string refusal(const Changes& changes) {
  std::vector<scenarios::Change> all;
  for (const auto& [pointer, value] : changes) all.push_back({pointer, json::parse(value)});
  const scenarios::Scenario s = scenarios::load(scenarios::apply(shop(), all));
  try {
    const LongRunModel model(s);
  } catch (const scenarios::InputError& e) {
    if (e.pointer().empty()) return e.what();
    CHECK(std::string(e.what()).starts_with(e.pointer()));
    CHECK(std::string(e.what()).find("leaves to the simulation") != std::string::npos);
    return std::string(e.what()).substr(0, std::string(e.what()).find(", which"));
  }
  return "covered";
}

// A failure mode and a maintenance with one member more.
std::string failure(const std::string& member) {
  return R"([{"name": "a", "time_to_failure": {"kind": "weibull", "mean_min": 900, "cv": 0.6},
              "repair": {"kind": "constant", "value_min": 9})" +
         (member.empty() ? "" : ", " + member) + "}]";
}
std::string maintenance(const std::string& member) {
  return R"([{"name": "b", "clock": "operating", "interval": 900, "duration": {"kind": "constant", "value_min": 9})" +
         (member.empty() ? "" : ", " + member) + "}]";
}
std::string with_failure(const std::string& member, Changes more = {}) {
  const std::string text = failure(member);
  more.emplace_back("/machines/1/failures", text.c_str());
  return refusal(more);
}
std::string with_maintenance(const std::string& member, Changes more = {}) {
  const std::string text = maintenance(member);
  more.emplace_back("/machines/1/maintenance", text.c_str());
  return refusal(more);
}

}  // namespace

TEST_CASE("refused by the long run: failures and maintenance") {
  CHECK(refusal({}) == "covered");
  CHECK(with_failure("") == "covered");
  CHECK(with_maintenance("") == "covered");
  CHECK(with_failure(R"("crew": "fitter", "spare": "belt")") == "covered");
  CHECK(with_maintenance(R"("crew": "fitter", "spare": "belt")") == "covered");
  const std::string f = "/machines/1/failures/0";
  const std::string m = "/machines/1/maintenance/0";
  CHECK(with_failure(R"("spare": "rare")") == f + "/spare: the repair may wait for a spare part");
  CHECK(with_maintenance(R"("spare": "rare")") == m + "/spare: the repair may wait for a spare part");
  CHECK(with_failure(R"("effect": "when_idle")") == f + "/effect: the repair waits for an empty queue");
  CHECK(with_maintenance(R"("effect": "when_idle")") ==
        m + "/effect: the maintenance waits for an empty queue");
  // A clock on the wall goes on outside the shifts; without a calendar there is no outside.
  const Changes on_shift{{"/machines/1/calendar", "\"day\""},
                         {"/machines/1/repair_at_shift_end", "\"pause\""}};
  CHECK(with_failure(R"("clock": "calendar")") == "covered");
  CHECK(with_failure(R"("clock": "operating")", on_shift) == "covered");
  CHECK(with_failure(R"("clock": "calendar")", on_shift) ==
        f + "/clock: the machine ages outside its shifts, too");
  CHECK(with_maintenance(R"("clock": "calendar")", on_shift) ==
        m + "/clock: it falls due outside the shifts, too");
  CHECK(with_failure("", {{"/machines/1/calendar", "\"day\""}}) ==
        "/machines/1/repair_at_shift_end: repairs go on after the shift");
  CHECK(with_maintenance("", {{"/machines/1/calendar", "\"day\""}}) ==
        "/machines/1/repair_at_shift_end: repairs go on after the shift");
  CHECK(refusal({{"/machines/1/calendar", "\"day\""}}) == "covered");
  CHECK(with_failure(R"("clock": "parts")") == f + "/clock: the life is a random number of parts");
  // Joining other stops, and renewing what ages; what does not age is as new anyway.
  CHECK(with_maintenance(R"("joins_from": 0.8)") == m + "/joins_from: the maintenance joins other stops");
  const std::string ageing = failure("");
  CHECK(with_maintenance(R"("renews": ["a"])", {{"/machines/1/failures", ageing.c_str()}}) ==
        m + "/renews: the maintenance keeps an ageing part from failing");
  const char* ageless = R"([{"name": "a", "time_to_failure": {"kind": "exponential", "rate_per_min": 0.001},
                             "repair": {"kind": "constant", "value_min": 9}}])";
  CHECK(with_maintenance(R"("renews": ["a"])", {{"/machines/1/failures", ageless}}) == "covered");
}

TEST_CASE("refused by the long run: crews that are several, or elsewhere") {
  const std::string at = "/machines/1/failures/0/crew";
  // A skill of two crews; a crew's name that another has as a skill; a skill of one crew alone.
  CHECK(with_failure(R"("crew": "electrics")", {{"/crews/1/skills", R"(["electrics"])"}}) ==
        at + ": several crews may be called");
  CHECK(with_failure(R"("crew": "fitter")", {{"/crews/0/skills", R"(["fitter"])"}}) ==
        at + ": several crews may be called");
  CHECK(with_failure(R"("crew": "fitter")", {{"/crews/0/skills", R"(["lifting"])"}}) == "covered");
  const Changes both{{"/machines/1/calendar", "\"day\""},
                     {"/machines/1/repair_at_shift_end", "\"pause\""},
                     {"/crews/1/calendar", "\"day\""}};
  CHECK(with_failure(R"("crew": "fitter")", both) == "covered");
  Changes apart = both;
  apart[2].second = "\"night\"";
  CHECK(with_failure(R"("crew": "fitter")", apart) ==
        at + ": the crew works by a calendar that is not the machine's");
  CHECK(with_maintenance(R"("crew": "fitter")", apart) ==
        "/machines/1/maintenance/0/crew: the crew works by a calendar that is not the machine's");
  const Changes elsewhere{{"/crews/1/calendar", "\"night\""}};
  const auto by_fitter = [&](const char* pointer, const char* value) {
    Changes changes = elsewhere;
    changes.emplace_back(pointer, value);
    return refusal(changes);
  };
  const std::string reason = ": the crew works by a calendar that is not the machine's";
  const char* setup = R"({"time": {"kind": "constant", "value_min": 9}, "crew": "fitter"})";
  CHECK(by_fitter("/machines/1/setup", setup) == "/machines/1/setup/crew" + reason);
  CHECK(refusal({{"/machines/1/setup", setup}}) == "covered");
  CHECK(by_fitter("/machines/1/attendance", R"({"crew": "fitter"})") ==
        "/machines/1/attendance/crew" + reason);
  CHECK(by_fitter("/machines/1/overload",
                  R"({"crew": "fitter", "repair": {"kind": "constant", "value_min": 9}})") ==
        "/machines/1/overload/crew" + reason);
  CHECK(by_fitter("/tools/0/crew", "\"fitter\"") == "/tools/0/crew" + reason);
  CHECK(refusal({{"/tools/0/crew", "\"fitter\""}}) == "covered");
}

TEST_CASE("refused by the long run: what a machine does besides") {
  CHECK(refusal({{"/machines/1/queue_capacity", "3"}}) == "/machines/1/queue_capacity: a full queue blocks");
  CHECK(refusal({{"/machines/1/switch_off",
                  R"({"after_idle_min": 10, "warm_up": {"kind": "constant", "value_min": 1}})"}}) ==
        "/machines/1/switch_off: the machine is switched off");
  CHECK(refusal({{"/machines/1/attendance", R"({"crew": "fitter", "during": "always"})"}}) ==
        "/machines/1/attendance: an operator stays with the machine");
  CHECK(refusal({{"/machines/1/attendance", R"({"crew": "fitter"})"}}) == "covered");
  const char* setup = R"({"time": {"kind": "constant", "value_min": 9}})";
  CHECK(refusal({{"/machines/1/setup", setup}, {"/machines/1/dispatch", "\"least_setup\""}}) ==
        "/machines/1/dispatch: set-ups depend on the order of the queue");
  CHECK(refusal({{"/machines/1/dispatch", "\"least_setup\""}}) == "covered");
  // Power that nobody pays for, a price for no power, and both.
  for (const char* member : {"cutting_kw", "working_kw", "standby_kw", "off_kw"}) {
    const std::string power = std::string("{\"") + member + "\": 5}";
    CHECK(refusal({{"/machines/1/power", power.c_str()}}) == "covered");
    CHECK(refusal({{"/machines/1/power", power.c_str()}, {"/energy_price_per_kwh", "3"}}) ==
          "/machines/1/power: energy is paid for");
  }
  CHECK(refusal({{"/energy_price_per_kwh", "3"}}) == "covered");
  CHECK(refusal({{"/calendars/0/holidays", R"([{"first_day": 0}])"}, {"/machines/1/calendar", "\"day\""}}) ==
        "/machines/1/calendar: the calendar has holidays");
}

TEST_CASE("refused by the long run: tools") {
  const std::string given = gallery("tools-certified-inserts.json")["inserts"][0]["lots"].dump();
  const char* lots = given.c_str();
  CHECK(refusal({{"/tools/0/teeth", "2"}}) == "/tools/0: the tool has teeth or copies");
  CHECK(refusal({{"/tools/0/copies", "2"}}) == "/tools/0: the tool has teeth or copies");
  CHECK(refusal({{"/tools/0/failure_crew", "\"fitter\""}}) ==
        "/tools/0/failure_crew: another crew comes after a failure");
  CHECK(refusal({{"/tools/0/failure_crew", "\"setter\""}}) == "covered");
  CHECK(refusal({{"/tools/0/change/stop_min", "2"}}) ==
        "/tools/0/change/stop_min: edges share the stop of the machine");
  CHECK(refusal({{"/inserts/0/lots", lots}}) == "/tools/0/insert: its inserts come in lots that differ");
  CHECK(
      refusal(
          {{"/inserts/0/crib",
            R"({"stock": 10, "reorder_point": 2, "order_quantity": 5, "lead_time": {"kind": "constant", "value_min": 60}})"}}) ==
      "/tools/0/insert: its inserts come from a crib that may be empty");
  // By the strategy, from where the rates are made.
  CHECK(refusal({{"/tools/0/strategy", R"({"kind": "opportunistic", "gamma": 0.6})"}}) ==
        "the long-run model does not cover the strategy \"opportunistic\": it is left to the simulation");
  CHECK(
      refusal(
          {{"/tools/0/strategy",
            R"({"kind": "condition_based", "every_parts": 1, "sign": {"kind": "share_of_life", "share": 0.8}})"}}) ==
      "the long-run model does not cover the strategy \"condition_based\": it is left to the simulation");
}

TEST_CASE("refused by the long run: operations, parts, stores and ways") {
  CHECK(refusal({{"/operations/1/machine", "\"\""}, {"/operations/1/machines", R"(["mill", "lathe"])"}}) ==
        "/operations/1: several machine groups share the operation");
  CHECK(refusal({{"/operations/1/inspection", "{}"}}) == "/operations/1/inspection: parts are inspected");
  const std::string gauging = gallery("operations/inspection.json")["process"].dump();
  CHECK(refusal({{"/operations/1/process", gauging.c_str()}}) == "/operations/1: parts are inspected");
  CHECK(refusal({{"/operations/1/quality", R"({"defect_probability": 0.1})"}}) ==
        "/operations/1/quality: defects stay hidden");
  CHECK(refusal({{"/operations/1/quality", R"({"defect_when_worn": 0.1})"}}) ==
        "/operations/1/quality: defects stay hidden");
  CHECK(refusal({{"/operations/1/quality", R"({"scrap_probability": 0.1})"}}) == "covered");
  CHECK(refusal({{"/stores/0/demand", R"({"kind": "exponential", "rate_per_min": 0.05})"}}) ==
        "/stores/0: the store fills or runs empty");
  CHECK(refusal({{"/stores/0/demand", R"({"kind": "exponential", "rate_per_min": 0.05})"},
                 {"/stores/0/capacity", "50"}}) == "/stores/0: the store fills or runs empty");
  CHECK(refusal({{"/transport", R"([{"name": "belt", "carrier": {"kind": "conveyor", "time_min": 2}}])"}}) ==
        "/transport/0/carrier: parts wait for what carries them");
  CHECK(refusal({{"/transport", R"([{"name": "barrow",
          "carrier": {"kind": "delay", "time": {"kind": "constant", "value_min": 2}}}])"}}) == "covered");
  CHECK(refusal({{"/parts/0/release", R"({"kind": "conwip", "cap": 4})"}}) ==
        "/parts/0/release: the release is held back");
  CHECK(refusal({{"/parts/0/tardiness_cost_per_min", "1"}}) ==
        "/parts/0/tardiness_cost_per_min: late parts cost");
  const auto steps = [](const char* first, const char* second) {
    const std::string text = std::string(R"([{"name": "a", "operation": "rough turning")") + first +
                             R"(}, {"name": "b", "operation": "milling")" + second + "}]";
    return refusal({{"/parts/0/route", "[]"}, {"/parts/0/steps", text.c_str()}});
  };
  CHECK(steps("", "") == "covered");
  CHECK(steps(R"(, "next": [{"to": "b", "probability": 0.5}, {"probability": 0.5}])", "") == "covered");
  CHECK(steps(R"(, "next": [{"to": "b"}, {}], "choice": "shortest_queue")", "") ==
        "/parts/0/steps: parts choose the shortest queue");
  // A single way is no choice.
  CHECK(steps(R"(, "next": [{"to": "b"}], "choice": "shortest_queue")", "") == "covered");
  const char* two_parts = R"([
    {"name": "shaft", "steps": [{"name": "a", "operation": "rough turning", MORE}], "store": "finished shafts"},
    {"name": "stub", "route": ["milling"], "store": "finished shafts",
     "supply": {"kind": "interarrival", "time": {"kind": "constant", "value_min": 500}}}])";
  const auto two = [&](const std::string& more) {
    std::string text = two_parts;
    text.replace(text.find("MORE"), 4, more);
    return refusal({{"/parts", text.c_str()}});
  };
  CHECK(two(R"("next": [])") == "covered");
  CHECK(two(R"("yields": [{"part": "stub"}])") == "/parts/0/steps: parts are put together or divided");
  CHECK(two(R"("assembles": [{"part": "stub"}])") == "/parts/0/steps: parts are put together or divided");
  CHECK(
      refusal(
          {{"/parts/0/route", "[]"},
           {"/operations/1/quality", R"({"scrap_probability": 0.1})"},
           {"/parts/0/steps",
            R"([{"name": "a", "operation": "rough turning"}, {"name": "b", "operation": "milling", "rework": "a"}])"}}) ==
      "/parts/0/steps: parts are reworked");
}

TEST_CASE("refused by the long run: families of blanks that come in turn") {
  // Two families on the mill, both with blanks always at hand: one follows the other, never by chance.
  const char* operations = R"([
    {"name": "rough turning", "machine": "lathe", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}},
    {"name": "milling", "machine": "mill", "family": "FIRST", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}},
    {"name": "slotting", "machine": "mill", "family": "slots", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}}])";
  const auto mixed = [&](const std::string& family, const char* parts, bool setup = true) {
    std::string text = operations;
    text.replace(text.find("FIRST"), 5, family);
    Changes changes{{"/operations", text.c_str()}, {"/parts", parts}};
    if (setup)
      changes.emplace_back("/machines/1/setup", R"({"time": {"kind": "constant", "value_min": 30}})");
    return refusal(changes);
  };
  const char* at_hand = R"([{"name": "a", "route": ["milling"], "store": "finished shafts"},
    {"name": "b", "route": ["slotting"], "store": "finished shafts"}, {"name": "c", "route": ["rough turning"], "store": "finished shafts"}])";
  const char* from_lathe =
      R"([{"name": "a", "route": ["rough turning", "milling", "slotting"], "store": "finished shafts"}])";
  CHECK(mixed("flats", at_hand) == "/machines/1/setup: blanks that are always there come in turn");
  CHECK(mixed("slots", at_hand) == "covered");
  CHECK(mixed("flats", at_hand, false) == "covered");
  CHECK(mixed("", from_lathe) == "covered");
}
