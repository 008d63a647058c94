// A study joined to its scenario: what does not fit is refused by place; what fits is what the plan, the long
// run and the catalogue say.
#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/reliability/k117_rational_reliability.h"
#include "models/surface/k311_lapping_cycle.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

json study(const char* constraints = "[]") {
  json s = gallery("heavy-lathe.study.json");
  s["constraints"] = json::parse(constraints);
  return s;
}
std::string refused(const json& text, const json& scenario = gallery("heavy-lathe.json")) {
  try {
    const StudySpec spec = load_study(text);
    const Problem problem(spec, scenario);
    check_study(problem);
  } catch (const scenarios::InputError& e) {
    if (!e.pointer().empty()) CHECK(std::string(e.what()).starts_with(e.pointer()));
    return e.what();
  }
  return "accepted";
}
std::string with_variable(const char* variable) {
  json text = study();
  text["variables"].push_back(json::parse(variable));
  return refused(text);
}
std::string with_objective(const char* objective) {
  json text = study();
  text["objective"] = json::parse(objective);
  return refused(text);
}
std::string with(const char* member, const char* value) {
  json text = study();
  text[member] = json::parse(value);
  return refused(text);
}

// A joined study, kept with what it refers to.
struct Joined {
  StudySpec spec;
  Problem problem;
  Joined(const json& text, const json& scenario) : spec(load_study(text)), problem(spec, scenario) {}
};

}  // namespace

TEST_CASE("problem: variables that lead nowhere, or to something else") {
  CHECK(with_variable(
            R"({"name": "n", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 4})") ==
        "accepted");
  CHECK(with_variable(
            R"({"name": "n", "pointer": "/inserts/7/edges", "type": "integer", "low": 1, "high": 4})") ==
        "/variables/2/pointer = \"/inserts/7/edges\", leads to nothing in the scenario");
  CHECK(with_variable(R"({"name": "n", "pointer": "inserts", "type": "integer", "low": 1, "high": 4})") ==
        "/variables/2/pointer = \"inserts\", leads to nothing in the scenario");
  CHECK(
      with_variable(
          R"({"name": "n", "pointer": "/tools/0/strategy/gamma", "type": "integer", "low": 0, "high": 1})") ==
      "/variables/2/pointer = \"/tools/0/strategy/gamma\", leads to 0.64, no whole number");
  CHECK(with_variable(R"({"name": "n", "pointer": "/inserts/0/edges"})") ==
        "/variables/2/pointer = \"/inserts/0/edges\", leads to no continuous number of the scenario");
  CHECK(
      with_variable(
          R"({"name": "n", "pointer": "/tools/0/insert_booking", "type": "categorical", "options": ["a", "b"]})") ==
      "/variables/2/options: what the scenario has, \"life_periods\", must be one of them");
  // Every option is tried in the scenario.
  CHECK(
      with_variable(
          R"({"name": "n", "pointer": "/tools/0/insert_booking", "type": "categorical", "options": ["life_periods", "never"]})")
          .starts_with(
              "/variables/2/options/1 = never, is not valid in the scenario: /tools/0/insert_booking"));
  CHECK(
      with_variable(R"({"name": "n", "pointer": "/inserts/0/edges", "type": "integer", "low": 0, "high": 4})")
          .starts_with("/variables/2/low = 0, is not valid in the scenario: /inserts/0/edges = 0"));
  CHECK(with_variable(
            R"({"name": "n", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 400000})")
            .starts_with("/variables/2/high = 400000, is not valid in the scenario: /inserts/0/edges"));
  // The scenario as it stands must be one.
  json broken = gallery("heavy-lathe.json");
  broken["machines"][0]["count"] = 0;
  CHECK(refused(study(), broken).starts_with("/machines/0/count = 0"));
}

TEST_CASE("problem: every study that comes with the program fits its scenario") {
  int studies = 0;
  for (const char* folder : {"gallery/", "tutorial/"})
    for (const auto& file :
         std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/" + std::string(folder))) {
      if (!file.path().string().ends_with(".study.json")) continue;
      INFO(file.path().string());
      const StudySpec spec = load_study(scenarios::read_json_file(file.path().string()));
      const json scenario = scenarios::read_json_file((file.path().parent_path() / spec.scenario).string());
      const Problem problem(spec, scenarios::apply(scenario, fixed_changes(spec)));
      CHECK_NOTHROW(check_study(problem));
      ++studies;
    }
  CHECK(studies >= 4);
}

TEST_CASE("problem: objectives that nobody knows") {
  CHECK(with_objective(R"({"function": "K117.part_coast", "output": "part_cost"})")
            .starts_with("/objective/function: K117.part_coast"));
  CHECK(with_objective(R"({"function": "K117.part_cost", "output": "part_costs"})") ==
        "/objective/output = \"part_costs\", K117.part_cost has no such output; closest: \"part_cost\"");
  CHECK(
      with_objective(
          R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"V": {"pointer": "/nowhere"}}})") ==
      "/objective/inputs/V/pointer = \"/nowhere\", leads to nothing in the scenario");
  CHECK(
      with_objective(
          R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"V": {"pointer": "/tools/0/strategy"}}})") ==
      "/objective/inputs/V/pointer = \"/tools/0/strategy\", leads to nothing in the scenario");
  CHECK(
      with_objective(
          R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"V": {"pointer": "no pointer"}}})") ==
      "/objective/inputs/V/pointer = \"no pointer\", leads to nothing in the scenario");
  json two = study();
  two.erase("objective");
  two["objectives"] =
      json::parse(R"([{"kpi": "cost_per_part"}, {"function": "K117.part_cost", "output": "cost"}])");
  CHECK(refused(two).starts_with("/objectives/1/output = \"cost\", K117.part_cost has no such output"));
  two["objectives"] = json::parse(R"([{"kpi": "cost_per_part"}, {"kpi": "beauty"}])");
  CHECK(refused(two) ==
        "/simulation/trials = 0, but the long-run model does not know the KPI \"beauty\": only "
        "simulation can tell, so it needs trials");
  two["simulation"] = {{"trials", 10}};
  CHECK(refused(two).starts_with(
      "/objectives/1/kpi = \"beauty\", there is no such KPI in a run of the scenario; closest: "));
  json one = study();
  one["objective"] = {{"kpi", "beauty"}};
  one["simulation"] = {{"trials", 10}};
  CHECK(
      refused(one).starts_with("/objective/kpi = \"beauty\", there is no such KPI in a run of the scenario"));
  // A function is computed, never simulated.
  const char* card =
      R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"strategy": "age", "gamma": 0.6, "V": 60}})";
  CHECK(with_objective(card) == "accepted");
  one["objective"] = json::parse(card);
  CHECK(refused(one) ==
        "/simulation/trials: the objective is an output of K117.part_cost, which no simulation knows; "
        "leave it out");
  one["simulation"] = {{"trials", 0}};
  one["front"] = {{"replications", 4}};
  CHECK(refused(one) ==
        "/front/replications: the objective is an output of K117.part_cost, which no simulation knows; "
        "leave it out");
  // The second objective may be one that the long run alone knows, as long as nothing is simulated.
  json load = study();
  load.erase("objective");
  load["objectives"] = json::parse(R"([{"kpi": "cost_per_part"}, {"kpi": "load/lathe"}])");
  CHECK(refused(load) == "accepted");
  load["front"] = {{"replications", 4}};
  CHECK(refused(load).starts_with("/objectives/1/kpi = \"load/lathe\", there is no such KPI"));
}

TEST_CASE("problem: constraints that do not fit, by their number") {
  CHECK(
      refused(study(
          R"([{"kpi": "throughput_per_h", "at_least": 1}, {"operation": "rough turning", "quantity": "torque_nm", "at_most": 1}])")) ==
      "/constraints/1: the plan of operation \"rough turning\" has no quantity \"torque_nm\"");
  CHECK(refused(study(R"([{"operation": "rough turning", "limits": "power_kw"}])")) ==
        "/constraints/0: the plan of operation \"rough turning\" has no limit \"power_kw\"");
  CHECK(refused(study(R"([{"operation": "*", "bands": "feed_mm_rev"}])")) ==
        "/constraints/0: the plan of operation \"*\" has no band \"feed_mm_rev\"");
  // All of none is none.
  CHECK(refused(study(R"([{"operation": "*", "limits": "all"}, {"operation": "*", "bands": "all"}])")) ==
        "accepted");
  CHECK(refused(study(R"([{"function": "K117.part_cost", "output": "x", "at_most": 1}])"))
            .starts_with("/constraints/0/output = \"x\", K117.part_cost has no such output"));
  // Between others that the long run knows or does not need.
  const char* hidden =
      R"([{"kpi": "cost_per_part", "at_most": 900}, {"operation": "rough turning", "quantity": "main_time_min", "at_most": 90},
    {"kpi": "beauty", "at_most": 1}, {"kpi": "quality_ratio", "at_least": 0.5}])";
  CHECK(refused(study(hidden)).starts_with("/constraints/2/kpi = \"beauty\", there is no such KPI"));
  json simulated =
      study(R"([{"kpi": "quality_ratio", "at_least": 0.5}, {"kpi": "load/lathe", "at_most": 1}])");
  CHECK(refused(simulated) == "accepted");
  simulated["simulation"] = {{"trials", 5}};
  CHECK(refused(simulated).starts_with("/constraints/1/kpi = \"load/lathe\", there is no such KPI"));
  CHECK(refused(study(
            R"([{"kpi": "quality_ratio", "at_least": 0.5}, {"kpi": "lead_time_min", "at_most": 1}])")) ==
        "/simulation/trials = 0, but only simulation knows \"lead_time_min\" of a constraint");
}

TEST_CASE("problem: what a variable may become must be covered by the long run, or simulated") {
  const auto only = [](const std::string& variable, const std::string& reason) {
    json text = study();
    text["variables"].push_back(json::parse(variable));
    const std::string said = refused(text);
    INFO(said);
    CHECK(said.starts_with("/simulation/trials = 0, but with /variables/2 at "));
    CHECK(said.find(reason) != std::string::npos);
    text["simulation"] = {{"trials", 5}};
    CHECK(refused(text) == "accepted");
  };
  // An option, the middle one of three; numbers that are zero or one today.
  only(
      R"({"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical", "options": [{"kind": "age", "gamma": 0.64},
    {"kind": "opportunistic", "gamma": 0.64}, {"kind": "run_to_failure"}]})",
      "at {\"gamma\":0.64,\"kind\":\"opportunistic\"} only simulation can tell: the long-run model does not "
      "cover the strategy");
  only(R"({"name": "stop", "pointer": "/tools/0/change/stop_min", "low": 0, "high": 5})",
       "at 5 only simulation can tell: /tools/0/change/stop_min: edges share the stop");
  only(R"({"name": "late", "pointer": "/parts/0/tardiness_cost_per_min", "low": 0, "high": 5})",
       "late parts cost");
  // Functions alone ask nothing of the long run.
  json card = study();
  card["variables"].push_back(
      json::parse(R"({"name": "late", "pointer": "/parts/0/tardiness_cost_per_min", "low": 0, "high": 5})"));
  card["objective"] = json::parse(
      R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"strategy": "age", "gamma": 0.6, "V": 60}})");
  CHECK(refused(card) == "accepted");
}

TEST_CASE("problem: a setting that only the simulation knows keeps the conditions of its plan") {
  json text = study(R"([{"operation": "rough turning", "quantity": "main_time_min", "at_most": 40},
    {"kpi": "throughput_per_h", "at_least": 1}])");
  text["variables"] =
      json::parse(R"([{"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical",
    "options": [{"kind": "age", "gamma": 0.64}, {"kind": "opportunistic", "gamma": 0.64}]}])");
  Joined j(text, gallery("heavy-lathe.json"));
  const auto known = j.problem.evaluate({0});
  const auto simulated = j.problem.evaluate({1});
  CHECK(std::isfinite(known.objectives[0]));
  CHECK(std::isinf(simulated.objectives[0]));
  CHECK(simulated.margins[0] == known.margins[0]);
  CHECK(simulated.margins[1] == 0);  // counts as met
}

TEST_CASE("problem: uncertain inputs") {
  CHECK(with("uncertain", R"([{"name": "a", "pointer": "/inserts/0/edge_life/cv"}])") == "accepted");
  CHECK(with("uncertain", R"([{"name": "a", "pointer": "/inserts/0/edges"}])") ==
        "/uncertain: \"/inserts/0/edges\" leads to no continuous number of the scenario");
  CHECK(with("uncertain", R"([{"name": "a", "pointer": "nowhere"}])") ==
        "/uncertain: \"nowhere\" leads to no continuous number of the scenario");
  CHECK(with("robust", R"({"samples": 3})") ==
        "/robust: say in /uncertain which inputs are uncertain, and by how much");
}

TEST_CASE("problem: conditions are those that the plan has, by name, with their units") {
  json shop = gallery("heavy-lathe.json");
  shop["operations"][0]["process"]["material"] = {{"kc11_n_mm2", 2000}, {"mc", 0.25}};
  shop["machines"][0]["limits"] = {{"power_kw", 40}, {"torque_max_nm", 9000}};
  shop["operations"].push_back(shop["operations"][0]);
  shop["operations"][1]["name"] = "finish";
  shop["operations"][1]["process"]["depth_of_cut_mm"] = 2;
  shop["parts"][0]["route"] = {"rough turning", "finish"};
  Joined j(
      study(
          R"([{"operation": "*", "limits": "all", "name": "machine"}, {"operation": "finish", "limits": "power_kw", "name": "power"},
    {"operation": "*", "quantity": "cutting_force_n", "at_most": 30000, "confidence": 0.8},
    {"operation": "finish", "quantity": "main_time_min", "at_least": 10},
    {"kpi": "throughput_per_h", "at_least": 2, "name": "delivery"}, {"kpi": "cost_per_part", "at_most": 200}])"),
      shop);
  std::vector<std::string> names;
  for (const Condition& c : j.problem.conditions()) names.push_back(c.name);
  const std::vector<std::string> wanted{"machine: power_kw of rough turning",
                                        "machine: torque_nm of rough turning",
                                        "machine: power_kw of finish",
                                        "machine: torque_nm of finish",
                                        "power",
                                        "cutting_force_n of rough turning",
                                        "cutting_force_n of finish",
                                        "main_time_min of finish",
                                        "delivery",
                                        "cost_per_part"};
  REQUIRE(names == wanted);
  CHECK(j.problem.conditions()[0].unit == "kW");
  CHECK(j.problem.conditions()[5].unit == "N");
  const auto look = j.problem.look_at_baseline();
  const double depth_2 = 2000 * 2 * std::pow(1.0, -0.25);  // Kienzle: k A h^-m
  CHECK(look.conditions[6].value == Approx(depth_2));
  CHECK(look.conditions[6].margin == Approx((30000 - depth_2) / 30000));
  CHECK(look.conditions[4].value == Approx(depth_2 * 60 / 60'000).epsilon(0.03));  // N m/min in kW
  CHECK(look.conditions[4].allowed == 40);
  CHECK(look.conditions[3].value == Approx(depth_2 * 0.25));
  const double main_min = look.long_run->plans[1].main_time_min;
  CHECK(look.conditions[7].margin == Approx((main_min - 10) / 10));
  CHECK(look.conditions[8].margin == Approx((look.long_run->throughput_per_h - 2) / 2));
  CHECK(look.conditions[9].margin == Approx((200 - look.long_run->cost_per_part) / 200));
  // At the point of the scenario, the outcome is what the look says.
  const auto outcome = j.problem.evaluate(j.problem.baseline());
  for (std::size_t k = 0; k < wanted.size(); ++k) CHECK(outcome.margins[k] == look.conditions[k].margin);
}

TEST_CASE(
    "problem: a quantity, limit or band that another option of a category does not have counts as met") {
  json shop = gallery("heavy-lathe.json");
  json process = shop["operations"][0]["process"];
  process["material"] = {{"kc11_n_mm2", 2000}, {"mc", 0.25}};
  process["force_max_n"] = 15000;
  shop["operations"][0]["process"] = process;
  const json plain = gallery("heavy-lathe.json")["operations"][0]["process"];
  json text = study(
      R"([{"operation": "*", "limits": "all"}, {"operation": "*", "quantity": "cutting_force_n", "at_most": 15000}])");
  text["variables"] = {{{"name", "process"},
                        {"pointer", "/operations/0/process"},
                        {"type", "categorical"},
                        {"options", {process, plain}}}};
  Joined j(text, shop);
  const auto known = j.problem.evaluate({0});
  const auto unknown = j.problem.evaluate({1});
  CHECK(known.margins[0] == Approx((15000 - 20000) / 15000.0));  // k A = 2000 N/mm2 10 mm2
  CHECK(known.margins[1] == known.margins[0]);
  CHECK(unknown.margins == std::vector<double>{1, 1});
  CHECK(unknown.objectives == known.objectives);  // the force costs nothing
}

TEST_CASE("problem: distances to forbidden bands") {
  // A band of the feed that the deep-cutting spindle shakes at: outside it the margin is the distance in
  // widths, inside it is negative, largest in the middle.
  const json file = gallery("operations/hard_turning_machine.json");
  json shop = gallery("heavy-lathe.json");
  shop["operations"][0]["process"] = file["process"];
  shop["inserts"][0]["edge_life"] = file["edge_life"];
  shop["machines"][0]["limits"] = file["machine_limits"];
  shop["machines"][0]["spindle"] = file["spindle"];
  json text = study(R"([{"operation": "*", "bands": "all"}])");
  text["variables"] = json::parse(
      R"([{"name": "feed", "pointer": "/operations/0/process/feed_mm_rev", "low": 0.1, "high": 0.38}])");
  Joined j(text, shop);
  REQUIRE(!j.problem.conditions().empty());
  // By name: the same one.
  text["constraints"] = {{{"operation", "rough turning"}, {"bands", j.problem.conditions()[0].item}}};
  Joined named(text, shop);
  REQUIRE(!named.problem.conditions().empty());
  CHECK(named.problem.conditions()[0].item == j.problem.conditions()[0].item);
  CHECK(named.problem.look({0.2}).conditions[0].margin == j.problem.look({0.2}).conditions[0].margin);
  int inside = 0;
  for (double feed = 0.1; feed < 0.38; feed += 0.01) {
    const auto look = j.problem.look({feed});
    const auto& plan = look.long_run->plans[0];
    for (std::size_t k = 0; k < look.conditions.size(); ++k) {
      // The tightest band of that name.
      double least = 1;
      for (const auto& b : plan.bands)
        if (b.name == j.problem.conditions()[k].item)
          least = std::min(least, std::max(b.low - b.value, b.value - b.high) / (b.high - b.low));
      CHECK(look.conditions[k].margin == Approx(least));
      if (least < 0) ++inside;
      CHECK(look.conditions[k].margin >= -0.5);
    }
  }
  CHECK(inside > 0);
}

TEST_CASE(
    "problem: functions take numbers, whole numbers and words from the scenario, and give any of them") {
  // K311: parts between lap resets, a whole number; the times and the bound on the parts from the scenario.
  json shop = gallery("lapping-cell.json");
  shop["operations"][0]["process"]["reset_interval_parts"] = 30;
  shop["operations"][0]["process"]["reset_min"] = 15;
  json text = study();
  text.erase("objective");
  text["variables"] = json::parse(
      R"([{"name": "parts", "pointer": "/operations/0/process/reset_interval_parts", "type": "integer", "low": 1, "high": 40},
    {"name": "reset", "pointer": "/operations/0/process/reset_min", "low": 1, "high": 60}])");
  text["objectives"] = json::parse(
      R"([{"function": "K311.best_lap_reset", "output": "t", "inputs": {"t_first": 10, "growth": 0.02, "T_p": 2,
      "T_change": {"pointer": "/operations/0/process/reset_min"}, "n_max": {"pointer": "/operations/0/process/reset_interval_parts"}}},
    {"function": "K311.best_lap_reset", "output": "n", "direction": "maximize", "inputs": {"t_first": 10, "growth": 0.02, "T_p": 2,
      "T_change": {"pointer": "/operations/0/process/reset_min"}, "n_max": {"pointer": "/operations/0/process/reset_interval_parts"}}}])");
  Joined j(text, shop);
  CHECK(j.problem.not_covered() == "");
  for (const double most : {3.0, 12.0, 40.0})
    for (const double change : {2.0, 15.0, 50.0}) {
      const auto card = models::k311::best_lap_reset({.first_min = 10,
                                                      .growth = 0.02,
                                                      .preparation_min = 2,
                                                      .change_min = change,
                                                      .parts_max = static_cast<std::int64_t>(most)});
      const auto outcome = j.problem.evaluate({most, change});
      CHECK(outcome.objectives[0] == card.time_min);
      CHECK(outcome.objectives[1] == -static_cast<double>(card.parts));
    }
  // A word of the scenario: the law of the edges.
  json lathe = study();
  lathe["objective"] =
      json::parse(R"({"function": "K117.part_cost", "output": "part_cost", "inputs": {"strategy": "age",
    "gamma": {"pointer": "/tools/0/strategy/gamma"}, "V": {"pointer": "/operations/0/process/cutting_speed_m_min"},
    "law": {"pointer": "/inserts/0/edge_life/law"}, "cv": {"pointer": "/inserts/0/edge_life/cv"}}})");
  for (const char* law : {"weibull", "normal"}) {
    json s = gallery("heavy-lathe.json");
    s["inserts"][0]["edge_life"]["law"] = law;
    s["inserts"][0]["edge_life"]["cv"] = 0.4;
    Joined card(lathe, s);
    models::k117::PartCostIn in;
    in.strategy = models::k117::Strategy::age;
    in.law = law == std::string("normal") ? models::LifeLawKind::normal : models::LifeLawKind::weibull;
    in.cv = 0.4;
    in.gamma = 0.7;
    in.speed_m_min = 55;
    CHECK(card.problem.evaluate({0.7, 55}).objectives[0] == Approx(models::k117::part_cost(in).part_cost));
    CHECK(card.problem.look_at_baseline().objectives.size() == 1);
  }
  // A yes or no counts one or zero: ceramic chatters from 60 to 100 m/min.
  Joined chatter(study(R"([{"function": "K106.ceramic_chatter_risk", "output": "risk", "at_most": 0.5,
    "inputs": {"v": {"pointer": "/operations/0/process/cutting_speed_m_min"}, "t": 0.1}}])"),
                 gallery("heavy-lathe.json"));
  for (const double v : {40.0, 59.0, 61.0, 99.0, 101.0}) {
    INFO(v);
    CHECK(chatter.problem.evaluate({0.5, v}).margins[0] == (v >= 60 && v <= 100 ? -1.0 : 1.0));
  }
}

TEST_CASE("problem: an undefined point is infinitely bad and breaks every constraint") {
  // A hot spot may not be allowed less than the temperature around: refused by the model of the cut, though
  // each of the two numbers has its range.
  json text = study(R"([{"operation": "rough turning", "quantity": "main_time_min", "at_most": 90},
    {"function": "K117.mean_life_for_regime", "output": "mean_min", "at_least": 1, "inputs": {"V": {"pointer": "/operations/0/process/diameter_mm"}}}])");
  json shop = gallery("heavy-lathe.json");
  json& process = shop["operations"][0]["process"];
  process["material"] = {{"kc11_n_mm2", 2000}, {"mc", 0.25}};
  process["contact"] = {
      {"heat_capacity_n_mm2_k", 2.5}, {"diffusivity_mm2_s", 6}, {"ambient_c", 20}, {"hot_spot_max_c", 600}};
  text["variables"] = json::parse(
      R"([{"name": "allowed", "pointer": "/operations/0/process/contact/hot_spot_max_c", "low": 50, "high": 900},
    {"name": "around", "pointer": "/operations/0/process/contact/ambient_c", "low": -20, "high": 100}])");
  Joined j(text, shop);
  int undefined = 0;
  for (double allowed = 50; allowed <= 200; allowed += 15)
    for (const double around : {-20.0, 65.0, 100.0}) {
      const auto outcome = j.problem.evaluate({allowed, around});
      const bool refuses = allowed <= around;
      undefined += refuses ? 1 : 0;
      CHECK(std::isinf(outcome.objectives[0]) == refuses);
      if (!refuses) continue;
      CHECK_THROWS(j.problem.look({allowed, around}));
      CHECK(outcome.margins == std::vector<double>{-1, -1});
      CHECK(std::isinf(violation(measured(outcome))));
      CHECK_FALSE(j.problem.slopes({allowed, around}));
    }
  CHECK(undefined > 0);
}

TEST_CASE("problem: a point is the scenario with its values") {
  Joined j(study(), gallery("heavy-lathe.json"));
  CHECK(j.problem.baseline() == std::vector<double>{0.64, 60});
  const json there = j.problem.scenario_at({0.5, 80});
  CHECK(there["tools"][0]["strategy"]["gamma"] == 0.5);
  CHECK(there["operations"][0]["process"]["cutting_speed_m_min"] == 80.0);
  const auto s = scenarios::load(there);
  CHECK(j.problem.evaluate({0.5, 80}).objectives[0] ==
        Approx(LongRunModel(s).cost_per_part()).epsilon(1e-14));
  CHECK(scenarios::plan(j.problem.typed_scenario_at({0.5, 80}), s.operations[0]).main_time_min ==
        scenarios::plan(s, s.operations[0]).main_time_min);
  CHECK(shown_value({.kpi = "a", .direction = Direction::maximize}, -3) == 3);
  CHECK(shown_value({.kpi = "a"}, -3) == -3);
  // An uncertain input at another value.
  StudySpec spec = load_study(study());
  Problem dearer(spec, gallery("heavy-lathe.json"), {{"/machines/0/rate_per_min", 2.0}});
  const auto twice = scenarios::load(scenarios::apply(there, {{"/machines/0/rate_per_min", 6.0}}));
  CHECK(dearer.evaluate({0.5, 80}).objectives[0] ==
        Approx(LongRunModel(twice).cost_per_part()).epsilon(1e-14));
}
