// The long-run model against the event simulation, to four standard errors, and what it refuses by name.
#include <cmath>

#include <catch2/catch.hpp>

#include "optimize/renewal_reward.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

// Simulated KPIs against those of the long run. `most_error`: standard error as a share of the KPI, so that
// the test would notice a fault of that size; `allowance`: of an approximation that the model states.
void check(const json& scenario, double most_error = 0.003, double allowance = 1e-4,
           const std::vector<std::string>& kpis = {"throughput_per_h", "cost_per_part", "quality_ratio"}) {
  const scenarios::Scenario s = scenarios::load(scenario);
  const LongRunModel model(s);
  const LongRun run = model.evaluate();
  const auto simulated = shop::run_scenario(s, 2);
  for (const std::string& kpi : kpis) {
    const std::size_t k = *simulated.index_of(kpi);
    double sum = 0;
    double squares = 0;
    for (const auto& row : simulated.values) sum += row[k].value();
    const auto n = static_cast<double>(simulated.values.size());
    const double mean = sum / n;
    for (const auto& row : simulated.values) squares += (row[k].value() - mean) * (row[k].value() - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    const double theory = model.value(run, *model.kpi(kpi));
    INFO(kpi << ": simulated " << mean << " +- " << error << " (standard error), long run " << theory);
    CHECK(std::abs(mean - theory) < 4 * error + allowance * std::abs(theory));
    CHECK(error < most_error * std::abs(theory));
  }
}

json cell() {
  json s = gallery("heavy-lathe.json");
  // A setter for each lathe and one to spare: nobody waits.
  s["crews"][0]["members"] = 3;
  s["simulation"] = {{"horizon_min", 250'000}, {"warmup_min", 10'000}, {"replications", 8}, {"seed", "7"}};
  return s;
}

std::string refusal(const json& scenario) {
  try {
    const scenarios::Scenario s = scenarios::load(scenario);
    const LongRunModel model(s);
  } catch (const scenarios::InputError& e) {
    return e.what();
  }
  return "covered";
}

}  // namespace

TEST_CASE("long run: machines that fail while they work, with crew, damage, spare and spoilt part") {
  json s = cell();
  s["crews"].push_back({{"name", "fitter"}, {"members", 4}, {"rate_per_min", 0.9}, {"walking_min", 6}});
  s["spares"] =
      json::parse(R"([{"name": "belt", "price": 55, "stock": 5, "reorder_point": 2, "order_quantity": 5,
                                 "lead_time": {"kind": "constant", "value_min": 0}}])");
  s["machines"][0]["failures"] = json::parse(R"([
    {"name": "spindle", "clock": "operating", "time_to_failure": {"kind": "weibull", "mean_min": 900, "cv": 0.6},
     "repair": {"kind": "lognormal", "mean_min": 90, "cv": 0.8}, "crew": "fitter", "spare": "belt",
     "scrap_probability": 0.5, "damage": 120},
    {"name": "turret", "clock": "cutting", "time_to_failure": {"kind": "exponential", "rate_per_min": 0.002},
     "repair": {"kind": "constant", "value_min": 20}},
    {"name": "chuck", "clock": "parts", "time_to_failure": {"kind": "constant", "value_min": 60},
     "repair": {"kind": "constant", "value_min": 30}, "effect": "after_part"}])");
  check(s);
}

TEST_CASE("long run: failures by the clock on the wall, and maintenance") {
  json s = cell();
  s["machines"][0]["count"] = 1;
  s["machines"][0]["failures"] = json::parse(R"([
    {"name": "control", "clock": "calendar", "time_to_failure": {"kind": "gamma", "mean_min": 2000, "cv": 0.7},
     "repair": {"kind": "exponential", "rate_per_min": 0.01}, "damage": 30, "scrap_probability": 0.3}])");
  check(s, 0.004);
  s["machines"][0]["failures"] = json::array();
  s["machines"][0]["maintenance"] = json::parse(R"([
    {"name": "lubrication", "clock": "operating", "interval": 600, "duration": {"kind": "constant", "value_min": 40}},
    {"name": "inspection", "clock": "parts", "interval": 100, "duration": {"kind": "constant", "value_min": 60}}])");
  check(s);
}

TEST_CASE("long run: shifts, with crews paid by the shift") {
  json s = cell();
  s["calendars"] = json::parse(R"([{"name": "two shifts", "shifts": [
    {"days": ["monday", "tuesday", "wednesday", "thursday", "friday"], "from_h": 6, "to_h": 22}],
    "breaks": [{"days": ["monday", "tuesday", "wednesday", "thursday", "friday"], "from_h": 13.5, "to_h": 14.5}]}])");
  s["machines"][0]["calendar"] = "two shifts";
  s["crews"][0]["pay"] = "shift";
  s["crews"][0]["calendar"] = "two shifts";
  s["crews"][0]["members"] = 2;
  // Whole weeks, so that the share of working time is that of a week.
  s["simulation"]["horizon_min"] = 10'080 * 30;
  s["simulation"]["warmup_min"] = 10'080 * 2;
  s["machines"][0]["part_at_shift_end"] = "pause";
  // Changes are not interrupted by the end of a shift: a few minutes a week.
  check(s, 0.003, 1.5e-3);
  s["machines"][0]["part_at_shift_end"] = "finish";
  check(s, 0.003, 3e-3);
}

TEST_CASE("long run: set-ups between families, batches, handling by operators, walking, moving") {
  json s = cell();
  s["crews"][0]["walking_min"] = 2;
  s["crews"].push_back(
      {{"name", "operator"}, {"members", 2}, {"rate_per_min", 0.4}, {"machines_per_member", 2}});
  s["machines"] = json::parse(R"([{"name": "lathe", "count": 1, "rate_per_min": 3,
    "loading": {"kind": "constant", "value_min": 1.5}, "unloading": {"kind": "exponential", "rate_per_min": 1},
    "attendance": {"crew": "operator", "during": "loading"},
    "setup": {"time": {"kind": "constant", "value_min": 40}, "cost": 25,
              "times": [{"from": "short", "to": "long", "time": {"kind": "exponential", "rate_per_min": 0.01}}]}}])");
  json shaft = s["operations"][0];
  shaft["family"] = "long";
  shaft["process"]["length_mm"] = 600;
  json stub = shaft;
  stub["name"] = "stub turning";
  stub["family"] = "short";
  stub["process"]["length_mm"] = 300;
  s["operations"] = {shaft, stub};
  s["parts"] = json::parse(R"([
    {"name": "shaft", "route": ["rough turning"], "value": 1000, "batch_size": 5, "store": "finished shafts",
     "supply": {"kind": "interarrival", "time": {"kind": "exponential", "rate_per_min": 0.004}}},
    {"name": "stub", "route": ["stub turning"], "value": 400, "batch_size": 8, "store": "finished shafts",
     "supply": {"kind": "interarrival", "time": {"kind": "exponential", "rate_per_min": 0.003}}}])");
  s["transport"] = json::parse(
      R"([{"name": "barrow", "carrier": {"kind": "delay", "time": {"kind": "constant", "value_min": 15}}}])");
  s["simulation"]["horizon_min"] = 600'000;
  check(s, 0.01, 1e-3, {"throughput_per_h", "cost_per_part"});
  const LongRunModel model(scenarios::load(s));
}

TEST_CASE("long run: every gallery shop is covered or refused by the name of a member that it has") {
  int covered = 0;
  for (const auto& file : std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery")) {
    const std::string name = file.path().filename().string();
    if (!name.ends_with(".json") || name.ends_with(".study.json")) continue;
    INFO(name);
    const json text = gallery(name);
    const std::string said = refusal(text);
    if (said == "covered") {
      ++covered;
      continue;
    }
    CHECK(said.find("leaves to the simulation") + said.find("left to the simulation") !=
          2 * std::string::npos);
    if (said[0] != '/') continue;
    const std::string pointer = said.substr(0, said.find(": "));
    // The last token may be a member left out, whose default is what is not covered.
    CHECK(text.contains(json::json_pointer(pointer).parent_pointer()));
  }
  CHECK(covered >= 2);
}

TEST_CASE("long run: what only a simulation tells is refused, and named") {
  const auto with = [&](const char* pointer, const char* value) {
    return refusal(scenarios::apply(cell(), {{pointer, json::parse(value)}}));
  };
  CHECK(refusal(cell()) == "covered");
  CHECK(
      with("/machines/0/queue_capacity", "3").starts_with("/machines/0/queue_capacity: a full queue blocks"));
  CHECK(with("/parts/0/release", R"({"kind": "conwip", "cap": 4})").starts_with("/parts/0/release: "));
  CHECK(with("/machines/0/failures",
             R"([{"name": "a", "time_to_failure": {"kind": "weibull", "mean_min": 900, "cv": 0.6},
                                          "repair": {"kind": "constant", "value_min": 9}, "effect": "when_idle"}])")
            .starts_with("/machines/0/failures/0/effect: "));
  CHECK(with("/stores/0/demand", R"({"kind": "exponential", "rate_per_min": 0.05})")
            .starts_with("/stores/0: "));
}
