// Slopes of a study against central differences of it, where the gradient tests of the plain lathe do not
// reach: drills that break, clutches, parts that arrive as another operation left them, numbers whose place
// in the model has no derivative.
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

struct Moved {
  const char* pointer;
  double low, high;
};

json study_of(const std::vector<Moved>& variables, const char* constraints = "[]",
              const char* objectives =
                  R"([{"kpi": "cost_per_part"}, {"kpi": "throughput_per_h", "direction": "maximize"}])") {
  json study = {{"name", "slopes"}, {"scenario", "s.json"}, {"variables", json::array()}};
  for (const Moved& m : variables)
    study["variables"].push_back(
        {{"name", m.pointer}, {"pointer", m.pointer}, {"low", m.low}, {"high", m.high}});
  study["constraints"] = json::parse(constraints);
  study["objectives"] = json::parse(objectives);
  return study;
}

// At several places of the box, one variable at a time.
void agree(const json& study_text, const json& scenario, double tolerance = 2e-5) {
  const StudySpec study = load_study(study_text);
  Problem problem(study, scenario);
  REQUIRE(problem.not_covered() == "");
  for (const double share : {0.3, 0.55, 0.8}) {
    std::vector<double> x;
    for (const Variable& v : study.variables) x.push_back(v.low + share * (v.high - v.low));
    const auto slopes = problem.slopes(x);
    REQUIRE(slopes.has_value());
    const auto here = problem.evaluate(x);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double width = study.variables[k].high - study.variables[k].low;
      std::vector<double> up = x;
      std::vector<double> down = x;
      up[k] += 1e-4 * width;
      down[k] -= 1e-4 * width;
      const auto high = problem.evaluate(up);
      const auto low = problem.evaluate(down);
      const auto same = [&](double exact, double above, double below, double at, const std::string& what) {
        INFO(study.variables[k].pointer << " at " << x[k] << ", " << what);
        CHECK(exact * width ==
              Approx((above - below) / 2e-4).margin(tolerance * std::max(std::abs(at), 0.1)));
      };
      for (std::size_t o = 0; o < here.objectives.size(); ++o)
        same(slopes->objectives[o][k], high.objectives[o], low.objectives[o], here.objectives[o],
             study.objectives[o].label());
      for (std::size_t m = 0; m < here.margins.size(); ++m)
        same(slopes->margins[m][k], high.margins[m], low.margins[m], here.margins[m],
             problem.conditions()[m].name);
    }
  }
}

// The radial drills of the gallery alone, blanks at hand.
json drills() {
  json shop = gallery("drilling-line.json");
  shop["parts"][0]["route"] = {"drill 8 x 20"};
  shop["parts"][0].erase("release");
  for (const char* list : {"machines", "operations", "tools", "inserts"}) shop[list].erase(1);
  return shop;
}

// The lathe of K117 whose plan tells forces and roughness.
json full_lathe() {
  json shop = gallery("heavy-lathe.json");
  json& process = shop["operations"][0]["process"];
  process["material"] = {{"kc11_n_mm2", 2000}, {"mc", 0.25}};
  process["insert"] = {{"nose_radius_mm", 2}, {"kr_deg", 60}, {"kr1_deg", 30}};
  return shop;
}

}  // namespace

TEST_CASE("slopes: drills that break, wear and are scrapped, and the limits of their machine") {
  // Three holes in a quarter of an hour, breakages in the order of a percent.
  agree(
      study_of(
          {{"/operations/0/process/cutting_speed_m_min", 18, 30},
           {"/operations/0/process/feed_mm_rev", 0.2, 0.4},
           {"/operations/0/process/break_torque_nm", 80, 160},
           {"/inserts/0/edge_life/mean_ref_min", 30, 90},
           {"/inserts/0/edge_life/cv", 0.3, 0.8},
           {"/tools/0/strategy/gamma", 0.5, 0.9},
           {"/machines/0/limits/feed_force_max_n", 9000, 20000},
           {"/machines/0/loading/value_min", 0.2, 2}},
          R"([{"operation": "*", "limits": "all"}, {"operation": "drill 8 x 20", "quantity": "thrust_n", "at_most": 9000},
                     {"kpi": "tool/20 mm drill/failure_share", "at_most": 0.3}, {"kpi": "quality_ratio", "at_least": 0.5},
                     {"kpi": "load/radial drill", "at_most": 2}])"),
      drills(), 1e-4);
}

TEST_CASE("slopes: drills that are used until they break or wear out") {
  json shop = drills();
  shop["tools"][0]["strategy"] = {{"kind", "run_to_failure"}};
  agree(study_of({{"/operations/0/process/cutting_speed_m_min", 18, 30},
                  {"/operations/0/process/feed_mm_rev", 0.2, 0.4},
                  {"/operations/0/process/break_torque_nm", 80, 160},
                  {"/inserts/0/edge_life/mean_ref_min", 30, 90}}),
        shop, 1e-4);
}

TEST_CASE("slopes: a clutch that trips, spindle and limits of the machine behind the plan") {
  json shop = full_lathe();
  shop["machines"][0]["limits"] =
      json::parse(R"({"power_kw": 40, "safety_clutch": {"clutch": "cone", "set_torque_nm": 12500,
    "accuracy": 1.4, "break_torque_nm": 14000, "spike_rate_per_min": 0.2, "spike_mean_ratio": 0.4,
    "overload_clear_min": 0.05, "detect_min": 0.5, "manual_reset_min": 4, "restart_min": 0.3}})");
  shop["machines"][0]["overload"] =
      json::parse(R"({"crew": "setter", "repair": {"kind": "constant", "value_min": 90},
    "damage": 300, "scrap_probability": 0.5})");
  shop["crews"][0]["walking_min"] = 1.5;
  const std::vector<Moved> variables{{"/operations/0/process/cutting_speed_m_min", 40, 90},
                                     {"/operations/0/process/feed_mm_rev", 0.5, 1.2},
                                     {"/machines/0/limits/safety_clutch/set_torque_nm", 11000, 13500},
                                     {"/machines/0/limits/power_kw", 20, 60},
                                     {"/machines/0/overload/damage", 10, 500},
                                     {"/machines/0/overload/repair/value_min", 30, 200},
                                     {"/machines/0/overload/scrap_probability", 0.1, 0.9},
                                     {"/crews/0/walking_min", 0.5, 6}};
  const StudySpec study = load_study(study_of(variables));
  Problem problem(study, shop);
  const auto look = problem.look_at_baseline();
  REQUIRE(look.long_run->plans[0].overload.has_value());
  REQUIRE(look.long_run->plans[0].overload->trips_per_part > 1e-3);
  REQUIRE(look.long_run->plans[0].overload->breaks_per_part > 1e-6);
  agree(study_of(variables, R"([{"operation": "rough turning", "limits": "all"}])"), shop, 1e-4);
}

TEST_CASE("slopes: hot spots shorten the life of a turning edge besides Taylor") {
  json shop = full_lathe();
  shop["operations"][0]["process"]["contact"] = {
      {"heat_capacity_n_mm2_k", 2.5}, {"diffusivity_mm2_s", 6},   {"temperature_coefficient", 0.24},
      {"hot_spot_factor", 1.8},       {"hot_area_fraction", 0.2}, {"activation_energy_kj_mol", 150}};
  agree(study_of({{"/operations/0/process/cutting_speed_m_min", 40, 70},
                  {"/operations/0/process/feed_mm_rev", 0.6, 1.2},
                  {"/operations/0/process/depth_of_cut_mm", 5, 12},
                  {"/operations/0/process/diameter_mm", 300, 600}}),
        shop, 1e-4);
}

TEST_CASE("slopes: rough parts that are scrapped, plans that the operation's quantity limits") {
  json shop = full_lathe();
  shop["operations"][0]["process"]["insert"]["kr1_deg"] = 10;
  shop["operations"][0]["process"]["roughness_max_um"] = 70;
  shop["operations"][0]["process"]["scrap_above_roughness"] = true;
  shop["operations"][0]["process"]["feed_mm_rev"] = 0.9;
  agree(study_of({{"/operations/0/process/feed_mm_rev", 0.7, 1.1},
                  {"/operations/0/process/insert/nose_radius_mm", 1.6, 3}},
                 R"([{"operation": "rough turning", "limits": "roughness_ra_um"},
                     {"operation": "rough turning", "quantity": "cutting_force_n", "at_most": 30000}])"),
        shop, 2e-4);
}

TEST_CASE("slopes: an operation that takes parts as another has left them moves with that one") {
  json shop = full_lathe();
  shop["machines"].push_back({{"name", "grinder"}, {"rate_per_min", 4.0}});
  shop["operations"].push_back(json::parse(R"({"name": "second cut", "machine": "grinder",
    "process": {"kind": "turning", "diameter_mm": 490, "length_mm": 1000, "cutting_speed_m_min": 150, "feed_mm_rev": 1, "depth_of_cut_mm": 0.5},
    "incoming": [{"from": "rough turning", "quantity": "roughness_ra_um", "input": "length_mm", "factor": 20}]})"));
  shop["operations"].push_back(json::parse(R"({"name": "third cut", "machine": "grinder",
    "process": {"kind": "turning", "diameter_mm": 490, "length_mm": 100, "cutting_speed_m_min": 150, "feed_mm_rev": 1, "depth_of_cut_mm": 0.5}})"));
  shop["parts"][0]["route"] = {"rough turning", "second cut", "third cut"};
  agree(study_of({{"/operations/0/process/feed_mm_rev", 0.7, 1.1},
                  {"/operations/0/process/insert/nose_radius_mm", 1.6, 3},
                  {"/operations/1/process/cutting_speed_m_min", 120, 180},
                  {"/operations/2/process/cutting_speed_m_min", 120, 180}},
                 R"([{"operation": "second cut", "quantity": "main_time_min", "at_most": 12}])"),
        shop, 1e-4);
}

TEST_CASE("slopes: inserts that are prepared, and numbers without a derivative of their own") {
  json shop = gallery("tools-certified-inserts.json");
  shop["inserts"][0].erase("lots");
  agree(study_of({{"/inserts/0/edge_life/mean_ref_min", 40, 80},
                  {"/inserts/0/edge_life/speed_exponent", 3, 6},
                  {"/inserts/0/price", 20, 200},
                  {"/inserts/0/preparation/reject_fraction", 0.05, 0.5},
                  {"/operations/0/process/cutting_speed_m_min", 40, 80},
                  {"/operations/0/process/feed_mm_rev", 0.6, 1.2},
                  {"/operations/0/process/depth_of_cut_mm", 6, 12}}),
        shop, 1e-3);
}

TEST_CASE("slopes: laws of stops, repairs and arrivals, whatever parameter is moved") {
  json shop = gallery("heavy-lathe.json");
  shop["machines"][0]["failures"] = json::parse(R"([
    {"name": "a", "time_to_failure": {"kind": "weibull", "mean_min": 900, "cv": 0.6}, "repair": {"kind": "lognormal", "mean_min": 40, "cv": 0.6}},
    {"name": "b", "time_to_failure": {"kind": "gamma", "mean_min": 900, "cv": 0.6}, "repair": {"kind": "uniform", "low_min": 10, "high_min": 50}},
    {"name": "c", "time_to_failure": {"kind": "triangular", "low_min": 100, "mode_min": 500, "high_min": 1500},
     "repair": {"kind": "exponential", "rate_per_min": 0.05}, "clock": "calendar", "scrap_probability": 0.3, "damage": 20},
    {"name": "d", "time_to_failure": {"kind": "constant", "value_min": 700}, "repair": {"kind": "constant", "value_min": 30}, "effect": "after_part"}])");
  shop["machines"][0]["maintenance"] = json::parse(R"([
    {"name": "e", "clock": "operating", "interval": 600, "duration": {"kind": "constant", "value_min": 40}},
    {"name": "f", "clock": "calendar", "interval": 2000, "duration": {"kind": "constant", "value_min": 40}}])");
  const std::string f = "/machines/0/failures/";
  const std::string m = "/machines/0/maintenance/";
  std::vector<std::string> pointers{f + "0/time_to_failure/mean_min",
                                    f + "0/repair/mean_min",
                                    f + "1/time_to_failure/mean_min",
                                    f + "1/repair/low_min",
                                    f + "1/repair/high_min",
                                    f + "2/time_to_failure/mode_min",
                                    f + "2/repair/rate_per_min",
                                    f + "2/scrap_probability",
                                    f + "2/damage",
                                    f + "3/time_to_failure/value_min",
                                    f + "3/repair/value_min",
                                    m + "0/interval",
                                    m + "0/duration/value_min",
                                    m + "1/interval",
                                    m + "1/duration/value_min"};
  std::vector<Moved> variables;
  for (const std::string& pointer : pointers) {
    const double now = shop.at(json::json_pointer(pointer)).get<double>();
    variables.push_back({pointer.c_str(), 0.7 * now, 1.2 * now});
  }
  agree(study_of(variables,
                 R"([{"kpi": "quality_ratio", "at_least": 0.5}, {"kpi": "load/lathe", "at_most": 2}])"),
        shop, 1e-4);
  // With arrivals of its own: their rate is nowhere in the formulas of the model.
  shop["parts"][0]["supply"] =
      json::parse(R"({"kind": "interarrival", "time": {"kind": "exponential", "rate_per_min": 0.03}})");
  agree(study_of({{"/parts/0/supply/time/rate_per_min", 0.02, 0.035},
                  {"/operations/0/process/cutting_speed_m_min", 50, 70}},
                 R"([{"kpi": "throughput_per_h", "at_least": 1}, {"kpi": "load/lathe", "at_most": 2}])"),
        shop, 1e-4);
}

TEST_CASE("slopes: elements that wear with the operation are moved as a whole") {
  json shop = gallery("camshaft-line.json");
  shop["parts"][0].erase("release");
  agree(study_of({{"/operations/2/process/work_speed_m_min", 15, 25},
                  {"/tools/1/elements/0/price", 2, 20},
                  {"/tools/1/elements/0/change/value_min", 2, 8},
                  {"/operations/0/process/cutting_speed_m_min", 100, 140}},
                 R"([{"kpi": "load/grinder", "at_most": 2}])"),
        shop, 1e-4);
}

TEST_CASE("slopes: wages and working hours reach the long run") {
  json shop = gallery("heavy-lathe.json");
  shop["crews"][0] =
      json::parse(R"({"name": "setter", "members": 2, "calendar": "day", "wages": {"monthly_wage": 15120}})");
  shop["calendars"] = json::parse(
      R"([{"name": "day", "shifts": [{"days": ["monday", "tuesday"], "from_h": 6, "to_h": 14}]}])");
  shop["machines"][0]["calendar"] = "day";
  const auto evaluated = [&](const char* pointer, double low, double high, double x) {
    const StudySpec study = load_study(study_of({{pointer, low, high}}));
    Problem problem(study, shop);
    const double there = problem.evaluate({x}).objectives[0];
    // As a scenario that says so.
    const auto s = scenarios::load(scenarios::apply(shop, {{pointer, x}}));
    CHECK(there == Approx(LongRunModel(s).cost_per_part()));
    agree(study_of({{pointer, low, high}}), shop, 1e-4);
  };
  evaluated("/crews/0/wages/monthly_wage", 5000, 30000, 22000);
  evaluated("/calendars/0/shifts/0/to_h", 10, 22, 20);
}

TEST_CASE("slopes: of functions of the catalogue, of the sum and of what hangs on nothing") {
  // The life of K117 at a speed V is T0 (V0/V)^mu: d ln T / d ln V = -mu.
  const json scenario = gallery("heavy-lathe.json");
  const char* life =
      R"([{"kpi": "cost_per_part"}, {"function": "K117.mean_life_for_regime", "output": "mean_min", "direction": "maximize",
    "inputs": {"V": {"pointer": "/operations/0/process/cutting_speed_m_min"}, "mu": 5}}])";
  const std::vector<Moved> variables{{"/operations/0/process/cutting_speed_m_min", 40, 90},
                                     {"/tools/0/strategy/gamma", 0.3, 0.9}};
  const char* constraint = R"([{"function": "K117.mean_life_for_regime", "output": "mean_min", "at_least": 20,
     "inputs": {"V": {"pointer": "/operations/0/process/cutting_speed_m_min"}, "mu": 5}}])";
  agree(study_of(variables, constraint, life), scenario, 1e-4);
  const StudySpec study = load_study(study_of(variables, constraint, life));
  Problem problem(study, scenario);
  const std::vector<double> x{60, 0.6};
  const auto slopes = problem.slopes(x);
  REQUIRE(slopes);
  const double mean = -problem.evaluate(x).objectives[1];
  CHECK(slopes->objectives[1][0] == Approx(5 * mean / 60).epsilon(1e-6));
  CHECK(slopes->objectives[1][1] == 0);
  CHECK(slopes->margins[0][1] == 0);
  CHECK(slopes->margins[0][0] == Approx(-5 * mean / 60 / 20).epsilon(1e-6));
}

TEST_CASE("slopes: none where nothing is defined, none without a model, none of whole numbers") {
  json study = study_of({{"/operations/0/process/cutting_speed_m_min", 40, 90}});
  study["variables"].push_back(json::parse(
      R"({"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 8})"));
  study["variables"].push_back(
      json::parse(R"({"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical",
    "options": [{"kind": "age", "gamma": 0.64}, {"kind": "opportunistic", "gamma": 0.64}, {"kind": "run_to_failure"}]})"));
  study["variables"].push_back(
      json::parse(R"({"name": "gamma", "pointer": "/tools/0/strategy/gamma", "low": 0.1, "high": 0.9})"));
  // A gamma cannot be set where the strategy has none: the bounds are tried at the scenario's own strategy.
  const StudySpec spec = load_study(study);
  Problem problem(spec, gallery("heavy-lathe.json"));
  const auto at_age = problem.slopes({60, 2, 0, 0.5});
  REQUIRE(at_age);
  CHECK(at_age->objectives[0][1] == 0);
  CHECK(at_age->objectives[0][2] == 0);
  CHECK(at_age->objectives[0][3] != 0);
  // The simulation alone knows the second strategy: an undefined point of the long run.
  CHECK_FALSE(problem.slopes({60, 2, 1, 0.5}));
  CHECK(std::isinf(problem.evaluate({60, 2, 1, 0.5}).objectives[0]));
  CHECK(problem.look({60, 2, 1, 0.5}).objectives.empty());
  // The third has no gamma: nothing hangs on it.
  const auto to_failure = problem.slopes({60, 2, 2, 0.5});
  REQUIRE(to_failure);
  CHECK(to_failure->objectives[0][3] == 0);
  CHECK(problem.evaluate({60, 2, 2, 0.5}).objectives[0] == problem.evaluate({60, 2, 2, 0.1}).objectives[0]);
  // Functions alone need no model, and have no slopes.
  json card = study_of({{"/operations/0/process/cutting_speed_m_min", 40, 90}}, "[]",
                       R"([{"function": "K117.mean_life_for_regime", "output": "mean_min",
                            "inputs": {"V": {"pointer": "/operations/0/process/cutting_speed_m_min"}}}])");
  const StudySpec alone = load_study(card);
  Problem without(alone, gallery("heavy-lathe.json"));
  CHECK_FALSE(without.slopes({60}));
  CHECK_FALSE(measured(std::optional<Problem::OutcomeSlopes>{}));
  CHECK(std::isfinite(without.evaluate({60}).objectives[0]));
}
