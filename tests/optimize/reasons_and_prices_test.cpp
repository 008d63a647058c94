// What holds an optimum back and what it hangs on, against closed forms; why a shop leaves the textbook's
// speed, one reason after the other.
#include <cmath>

#include <catch2/catch.hpp>

#include "optimize/analysis.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

json study(const char* variables, const char* constraints = "[]") {
  json s = gallery("heavy-lathe.study.json");
  s["variables"] = json::parse(variables);
  s["constraints"] = json::parse(constraints);
  return s;
}
const char* speed_and_gamma = R"([
  {"name": "gamma", "pointer": "/tools/0/strategy/gamma", "low": 0.05, "high": 0.98},
  {"name": "speed", "unit": "m/min", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 20, "high": 120}])";

struct Joined {
  StudySpec spec;
  Problem problem;
  explicit Joined(const json& text, const json& scenario = gallery("heavy-lathe.json"))
      : spec(load_study(text)), problem(spec, scenario) {}
};

// A run of the shop that says these KPIs.
shop::RunResult run_of(const std::vector<std::pair<std::string, double>>& kpis) {
  shop::RunResult r;
  r.values = {{}, {}};
  for (const auto& [name, value] : kpis) {
    r.kpis.push_back({name, "1", ""});
    for (auto& row : r.values) row.emplace_back(value);
    r.estimates.push_back({value, 0.0, 2});
  }
  return r;
}

}  // namespace

TEST_CASE("bounds that hold the optimum back have the price of the slope there") {
  // The cheapest speed is 46.97: the box ends below it, or begins above it.
  for (const auto& [low, high, at] : {std::tuple{20.0, 40.0, 40.0}, std::tuple{60.0, 120.0, 60.0}}) {
    json text = study(speed_and_gamma);
    text["variables"][1]["low"] = low;
    text["variables"][1]["high"] = high;
    Joined j(text);
    // Gamma at its best, by a search of its own.
    const std::vector<double> best{minimize(
                                       [&](const std::vector<double>& x) {
                                         return measured(j.problem.evaluate({x[0], at}));
                                       },
                                       {{0.05, 0.98}}, {0.5}, {})
                                       .x[0],
                                   at};
    const auto binding = binding_constraints(j.problem, best, search_options(j.spec, 1));
    REQUIRE(binding.size() == 1);
    CHECK(binding[0].name == (at == high ? "upper bound of speed" : "lower bound of speed"));
    CHECK(binding[0].unit == "m/min");
    CHECK(binding[0].value == at);
    CHECK(binding[0].allowed == at);
    // Over the step of one percent of the bounds the slope is that in its middle, up to its curvature.
    const double step = 0.01 * (high - low) * (at == high ? 1 : -1);
    const double here = j.problem.evaluate(best).objectives[0];
    const double there = minimize(
                             [&](const std::vector<double>& x) {
                               return measured(j.problem.evaluate({x[0], at + step}));
                             },
                             {{0.05, 0.98}}, {0.5}, {})
                             .measured.value;
    CHECK(binding[0].shadow_price == Approx((here - there) / std::abs(step)).epsilon(1e-3));
    CHECK(binding[0].shadow_price > 0);
  }
}

TEST_CASE(
    "constraints with room cost nothing, those that only simulation knows are left out, whole numbers have "
    "no price") {
  Joined j(study(speed_and_gamma,
                 R"([{"kpi": "throughput_per_h", "at_least": 1}, {"kpi": "lead_time_min", "at_most": 1e9},
    {"operation": "rough turning", "quantity": "main_time_min", "at_most": 500}])"));
  CHECK(binding_constraints(j.problem, {0.4703, 46.97}, search_options(j.spec, 1)).empty());
  // A KPI that binds: more throughput than the cheapest plan gives, priced by the plan with one percent less.
  Joined fast(study(speed_and_gamma, R"([{"kpi": "throughput_per_h", "at_least": 3.5}])"));
  const auto optimum = [&](double least) {
    const auto measure = [&](const std::vector<double>& x) {
      const auto o = fast.problem.evaluate(x);
      const double throughput = (o.margins[0] + 1) * 3.5;
      return Measured{o.objectives[0], {(throughput - least) / 3.5}};
    };
    return minimize(measure, {{0.05, 0.98}, {20, 120}}, {0.5, 55}, {});
  };
  const auto best = optimum(3.5);
  REQUIRE(best.feasible);
  const auto binding = binding_constraints(fast.problem, best.x, search_options(fast.spec, 1));
  REQUIRE(binding.size() == 1);
  CHECK(binding[0].name == "throughput_per_h");
  CHECK(binding[0].allowed == 3.5);
  CHECK(binding[0].value == Approx(3.5).epsilon(1e-3));
  CHECK(binding[0].shadow_price ==
        Approx((best.measured.value - optimum(3.5 * 0.99).measured.value) / 0.035).epsilon(0.01));
  // Whole numbers alone.
  Joined whole(
      study(R"([{"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 8}])"));
  CHECK(binding_constraints(whole.problem, {8}, search_options(whole.spec, 1)).empty());
  // Beside a continuous one they stay where they are.
  Joined mixed(
      study(R"([{"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 8},
    {"name": "speed", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 20, "high": 40}])"));
  const auto at_bound = binding_constraints(mixed.problem, {8, 40}, search_options(mixed.spec, 1));
  REQUIRE(at_bound.size() == 1);
  CHECK(at_bound[0].name == "upper bound of speed");
}

TEST_CASE("sensitivities: the optimum with an input off, and what keeping the plan would lose") {
  json text = study(speed_and_gamma);
  text["uncertain"] =
      json::parse(R"([{"name": "rate", "pointer": "/machines/0/rate_per_min", "relative": 0.2},
    {"name": "value of nothing", "pointer": "/parts/0/due_after/value_min", "relative": 0.2},
    {"name": "length", "pointer": "/operations/0/process/length_mm", "relative": 0.1}])");
  json shop = gallery("heavy-lathe.json");
  shop["parts"][0]["due_after"] = {{"kind", "constant"}, {"value_min", 100}};
  const test::Studied s(text, shop);
  const auto all = sensitivities(*s.problem, s.answer.best->x, search_options(s.study, 1));
  REQUIRE(all.size() == 2);  // the due date moves nothing
  CHECK(all[0].name == "rate");
  CHECK(all[1].name == "length");
  // A part twice as long costs twice as much, but for what a failure spoils: the cost is linear in the
  // length, and the best plan is the same.
  const double half = (all[1].objective_high - all[1].objective_low) / 2;
  CHECK(all[1].objective_low + half == Approx(s.answer.best->value).epsilon(1e-6));
  CHECK(half == Approx(0.1 * s.answer.best->value).epsilon(0.01));
  CHECK(all[1].regret_low == Approx(0).margin(1e-4));
  CHECK(all[1].regret_high == Approx(0).margin(1e-4));
  // With the rate up the plan moves; solved as a study of its own.
  const test::Studied dear(study(speed_and_gamma),
                           scenarios::apply(shop, {{"/machines/0/rate_per_min", 3.6}}));
  CHECK(all[0].objective_high == Approx(dear.answer.best->value).epsilon(1e-6));
  CHECK(all[0].x_high[1] == Approx(dear.answer.best->x[1]).epsilon(1e-2));
  CHECK(
      all[0].regret_high ==
      Approx(dear.problem->evaluate(s.answer.best->x).objectives[0] - dear.answer.best->value).margin(1e-4));
  CHECK(all[0].x_high[1] > all[0].x_low[1]);
}

TEST_CASE("sensitivities: a plan that would break a constraint, and inputs that cannot be moved so far") {
  json text = study(speed_and_gamma);
  json shop = gallery("heavy-lathe.json");
  shop["inserts"][0]["edge_life"]["law"] = "normal";
  shop["inserts"][0]["edge_life"]["cv"] = 0.4;  // 0.52 is no normal law of lives
  // Nearly as much as the shop can make: only plans far from the cheapest one do.
  text["objective"] = {{"kpi", "throughput_per_h"}, {"direction", "maximize"}};
  const double most = test::Studied(text, shop).answer.best->value;
  text["objective"] = {{"kpi", "cost_per_part"}};
  text["constraints"] = {{{"kpi", "throughput_per_h"}, {"at_least", 0.97 * most}}};
  text["uncertain"] =
      json::parse(R"([{"name": "life", "pointer": "/inserts/0/edge_life/mean_ref_min", "relative": 0.05},
    {"name": "scatter", "pointer": "/inserts/0/edge_life/cv", "relative": 0.3}])");
  const test::Studied s(text, shop);
  REQUIRE(s.answer.best);
  const auto all = sensitivities(*s.problem, s.answer.best->x, search_options(s.study, 1));
  REQUIRE(all.size() == 1);
  CHECK(all[0].name == "life");
  CHECK(std::isinf(all[0].regret_low));  // shorter lives: fewer parts than promised
  CHECK(std::isfinite(all[0].regret_high));
  CHECK(all[0].objective_low > all[0].objective_high);
}

TEST_CASE("sensitivities: the usual inputs when the study names none") {
  const json scenario = gallery("heavy-lathe.json");
  const auto usual = usual_uncertain_inputs(scenarios::load(scenario));
  REQUIRE(usual.size() == 5);
  for (const UncertainSpec& u : usual) {
    CHECK(scenario.contains(json::json_pointer(u.pointer)));
    CHECK(u.relative == 0.1);
  }
  CHECK(usual[0].name == "price of T5K10");
  CHECK(usual[4].name == "rate of lathe");
  // Maximised: what is better is larger.
  json text = study(speed_and_gamma);
  text["objective"] = {{"kpi", "throughput_per_h"}, {"direction", "maximize"}};
  const test::Studied s(text, scenario);
  const auto all = sensitivities(*s.problem, s.answer.best->x, search_options(s.study, 1));
  REQUIRE(!all.empty());
  for (const Sensitivity& one : all) {
    INFO(one.name);
    CHECK(one.name != "rate of lathe");  // money moves no parts
    CHECK(one.name != "price of T5K10");
    CHECK(one.objective_low > 0);
    if (one.name == "mean life of T5K10") CHECK(one.objective_high > one.objective_low);
  }
}

TEST_CASE("one cut: each reason by what the simulated plan says") {
  json shop = gallery("heavy-lathe.json");
  shop["machines"][0]["count"] = 1;
  // The long run does not know this strategy: the loads are those of the run.
  shop["tools"][0]["strategy"] = {{"kind", "opportunistic"}, {"gamma", 0.64}};
  const auto why = [&](double speed, const std::vector<std::pair<std::string, double>>& kpis) {
    json s = shop;
    s["operations"][0]["process"]["cutting_speed_m_min"] = speed;
    const auto run = run_of(kpis);
    const auto cuts = one_cut_optima(scenarios::load(s), &run);
    REQUIRE(cuts.size() == 1);
    return cuts[0].why;
  };
  const std::string tool = "tool/roughing tool/";
  const std::string lathe = "machine/lathe/";
  CHECK(one_cut_optima(scenarios::load(shop)).empty());  // nobody knows anything
  CHECK(why(20, {{lathe + "utilization", 0.6}}) ==
        "demand: lathe has 40 % of its time to spare: slower cutting saves edges and costs nothing");
  CHECK(why(20, {{lathe + "utilization", 1.0}, {tool + "waiting_crew_share", 0.25}}) ==
        "crew: 25 % of its time it waits for setter, so that every change saved saves a wait");
  CHECK(why(20, {{lathe + "utilization", 1.0},
                 {tool + "waiting_tool_share", 0.25},
                 {tool + "waiting_crew_share", 0.2}}) ==
        "stock: 25 % of its time it waits for tools or inserts, so that every edge saved saves a wait");
  CHECK(why(20, {{lathe + "utilization", 1.0},
                 {tool + "waiting_tool_share", 0.25},
                 {lathe + "state/blocked", 0.3}}) ==
        "stock: 30 % of its time lathe stands because there is no room behind it: slower cutting saves edges "
        "and costs "
        "nothing");
  CHECK(why(20, {{lathe + "utilization", 1.0}, {tool + "failure_share", 0.36}}) ==
        "failures: 36 % of the changes come after one, which the textbook does not price");
  CHECK(why(20, {{lathe + "utilization", 1.0}}) ==
        "slower than the textbook's least cost: bounds, limits or another aim hold the plan there");
  CHECK(why(110, {{lathe + "utilization", 1.0}, {tool + "failure_share", 0.36}}) ==
        "faster than the textbook's largest rate: the plan is held there by its bounds or another aim");
  // A machine that the run does not know stands still, as far as anybody knows.
  CHECK(why(20, {{"other", 1.0}}).starts_with("demand: lathe has 100 %"));
  // A second group: the one with the larger load limits the shop.
  shop["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}, {"count", 2}});
  shop["operations"].push_back(json::parse(R"({"name": "milling", "machine": "mill",
    "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 20}}})"));
  shop["parts"][0]["route"] = {"rough turning", "milling"};
  const std::vector<std::pair<std::string, double>> mill_limits{
      {lathe + "utilization", 0.5}, {"machine/mill 1/utilization", 0.8}, {"machine/mill 2/utilization", 1.0}};
  CHECK(why(20, mill_limits) ==
        "bottleneck: mill limits the shop and lathe has 50 % of its time to spare: slower cutting saves "
        "edges and costs "
        "nothing");
  CHECK(why(90, {{lathe + "utilization", 0.95},
                 {"machine/mill 1/utilization", 0.8},
                 {"machine/mill 2/utilization", 1.0}}) ==
        "bottleneck: lathe limits the shop, its minutes are worth more than its rate");
}

TEST_CASE("one cut: only where there is one to speak of") {
  const json shop = gallery("heavy-lathe.json");
  const auto cuts = [](const json& text) { return one_cut_optima(scenarios::load(text)).size(); };
  CHECK(cuts(shop) == 1);
  json s = shop;
  s["operations"][0]["process"] =
      json::parse(R"({"kind": "duration", "time": {"kind": "constant", "value_min": 20}})");
  s["operations"][0].erase("tool");
  CHECK(cuts(s) == 0);  // no speed
  s = shop;
  s["operations"][0].erase("tool");
  CHECK(cuts(s) == 0);  // no edge
  s = shop;
  s["machines"][0]["rate_per_min"] = 0;
  CHECK(cuts(s) == 0);  // minutes that cost nothing have no best life
  // A drill's time is not all cutting: indexing does not go with the speed.
  json drill = gallery("drilling-line.json");
  drill["parts"][0].erase("release");
  drill["operations"][0]["process"]["index_min"] = 2;
  for (const OneCut& cut : one_cut_optima(scenarios::load(drill))) CHECK(cut.operation != "drill 8 x 20");
  // A tool without inserts, and a wheel.
  json wheel = gallery("camshaft-line.json");
  wheel["parts"][0].erase("release");
  const auto all = one_cut_optima(scenarios::load(wheel));
  REQUIRE(all.size() == 1);
  CHECK(all[0].operation == "turn journals");
  // By hand at fitting: an insert of four edges, replaced once, indexed three times.
  const double change_min = 1 + (3 + 3 * 2.0) / 4;
  CHECK(all[0].life_min_cost_min ==
        Approx(4 * (change_min + (60.0 / 4 + 0.6 * change_min) / 2.5)).epsilon(1e-6));
  CHECK(all[0].life_max_rate_min == Approx(4 * change_min).epsilon(1e-6));
  CHECK(taylor_life_min_cost(4, 2, 6, 3) == Approx(3 * (2 + 2.0)));
  // A crew paid by the shift costs a change nothing.
  wheel["crews"][0]["pay"] = "shift";
  CHECK(one_cut_optima(scenarios::load(wheel))[0].life_min_cost_min ==
        Approx(4 * (change_min + 15 / 2.5)).epsilon(1e-6));
}
