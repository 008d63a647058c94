// Optima that are known in closed form or by enumeration, asked for as a user asks: by study files.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/inspection/k119_cutter_certification.h"
#include "models/math/life_law.h"
#include "models/surface/k311_lapping_cycle.h"
#include "operations/kinds/lapping.h"
#include "optimize/analysis.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;
using verstat::test::Studied;

namespace {

// One variable, the objective given.
json study_of(const char* pointer, double low, double high, const json& objective) {
  return {{"name", "closed form"},
          {"scenario", "heavy-lathe.json"},
          {"variables", {{{"name", "x"}, {"pointer", pointer}, {"low", low}, {"high", high}}}},
          {"objective", objective},
          {"search", {{"max_evaluations", 2000}, {"relative_precision", 1e-9}}}};
}

// A lathe whose edges run to failure, which costs no more than a planned change: the textbook's one cut.
json textbook_lathe(double exponent, double change_min, double price) {
  return scenarios::apply(gallery("heavy-lathe.json"),
                          {{"/inserts/0/edge_life/speed_exponent", exponent},
                           {"/inserts/0/price", price},
                           {"/tools/0/strategy", {{"kind", "run_to_failure"}}},
                           {"/tools/0/change/index", {{"kind", "constant"}, {"value_min", change_min}}},
                           {"/tools/0/change/replace", {{"kind", "constant"}, {"value_min", change_min}}},
                           {"/tools/0/change/positioning_min", 0.0},
                           {"/tools/0/change/failure_extra_min", 0.0},
                           {"/tools/0/periods_failure", 4.0},
                           {"/tools/0/failure_damage", 0.0},
                           {"/tools/0/failure_scrap_probability", 0.0}});
}

}  // namespace

TEST_CASE("Taylor: the speed of least cost and the speed of most parts") {
  const char* speed = "/operations/0/process/cutting_speed_m_min";
  for (const double exponent : {3.0, 4.0, 5.5})
    for (const double change_min : {1.0, 6.0})
      for (const double price : {20.0, 200.0}) {
        const json shop = textbook_lathe(exponent, change_min, price);
        // Taylor (1907), Gilbert (1950): lathe 3 UAH/min, setter 0.5 UAH/min, four periods per insert.
        const double cheap_life = (exponent - 1) * (change_min * (3 + 0.5) + price / 4) / 3;
        const double fast_life = (exponent - 1) * change_min;
        const auto speed_of = [&](double life) { return 60 * std::pow(60 / life, 1 / exponent); };
        const Studied cheap(study_of(speed, 10, 400, {{"kpi", "cost_per_part"}}), shop);
        const Studied fast(study_of(speed, 10, 400, {{"kpi", "throughput_per_h"}, {"direction", "maximize"}}),
                           shop);
        INFO("exponent " << exponent << ", change " << change_min << " min, insert " << price << " UAH");
        CHECK(cheap.answer.best->x[0] == Approx(speed_of(cheap_life)).epsilon(1e-4));
        CHECK(fast.answer.best->x[0] == Approx(speed_of(fast_life)).epsilon(1e-4));
        // The cost there is that of machining times mu / (mu - 1).
        const double machining = 3 * std::numbers::pi * 500 * 1000 / (1000 * speed_of(cheap_life));
        CHECK(cheap.answer.best->value == Approx(machining * exponent / (exponent - 1)).epsilon(1e-8));
      }
}

TEST_CASE("K117: every rational gamma of the checks of its card") {
  const json shop = gallery("heavy-lathe.json");
  const json gamma = {{"pointer", "/tools/0/strategy/gamma"}};
  const auto rational = [&](const char* function, const char* output, json inputs, double low, double high) {
    inputs["gamma"] = gamma;
    const json objective = {{"function", function}, {"output", output}, {"inputs", inputs}};
    return Studied(study_of("/tools/0/strategy/gamma", low, high, objective), shop).answer;
  };
  const auto cost = [&](json inputs, const char* accounting) {
    inputs["accounting"] = accounting;
    return *rational("K117.part_cost_at_gamma", "part_cost", inputs, 0.40, 0.99).best;
  };
  constexpr double printed = 0.0006;  // three digits
  CHECK(cost({}, "scheduled").x[0] == Approx(0.6400).margin(0.00006));
  CHECK(cost({}, "scheduled").value == Approx(125.87).margin(0.006));
  CHECK(cost({}, "renewal").x[0] == Approx(0.775).margin(printed));
  // Check 6: expenditure and consumption.
  CHECK(rational("K117.reliability_expenditure", "A_total", json::object(), 0.2, 0.99).best->x[0] ==
        Approx(0.777).margin(printed));
  const auto consumption = [&](const char* law, double cv, int edges, double reserve) {
    return rational("K117.insert_consumption", "inserts_per_cutting_hour",
                    {{"law", law}, {"cv", cv}, {"n_edges", edges}, {"p_reserve_ok", reserve}}, 0.05, 0.99)
        .best->x[0];
  };
  CHECK(consumption("normal", 0.4, 8, 0.5) == Approx(0.778).margin(printed));
  CHECK(consumption("weibull", 0.7, 8, 0) == Approx(0.766).margin(printed));
  CHECK(consumption("weibull", 0.4, 4, 0) == Approx(0.772).margin(printed));
  // Check 7: scheduled and renewal accounting.
  struct Case {
    json inputs;
    double scheduled, renewal;
  };
  for (const Case& c :
       {Case{{{"cv", 0.4}}, 0.850, 0.874}, Case{{{"cv", 0.5}}, 0.795, 0.840},
        Case{{{"t_change_failure_min", 30}}, 0.774, 0.832}, Case{{{"damage_cost", 300}}, 0.896, 0.909},
        Case{{{"mu", 4}, {"damage_cost", 120}}, 0.664, 0.780}, Case{{{"machine_rate", 6}}, 0.40, 0.675},
        Case{{{"damage_cost", 0}}, 0.40, 0.591}}) {
    INFO(c.inputs.dump());
    CHECK(cost(c.inputs, "scheduled").x[0] == Approx(c.scheduled).margin(printed));
    CHECK(cost(c.inputs, "renewal").x[0] == Approx(c.renewal).margin(printed));
  }
  // Check 8: age replacement at a mean life of 60 min; the cost rate is what a part costs beyond machining.
  const auto age = [&](const char* law, double cv) {
    return rational("K117.part_cost", "edge_cost", {{"strategy", "age"}, {"V", 60}, {"law", law}, {"cv", cv}},
                    0.05, 0.98);
  };
  const double main_time_min = std::numbers::pi * 500 * 1000 / (1000 * 60);
  CHECK(age("weibull", 0.7).best->x[0] == Approx(0.470).margin(printed));
  CHECK(age("weibull", 0.7).best->value / main_time_min == Approx(2.551).margin(printed));
  CHECK(age("normal", 0.4).best->x[0] == Approx(0.821).margin(printed));
  CHECK(age("normal", 0.4).best->value / main_time_min == Approx(1.689).margin(printed));
}

TEST_CASE("K113: the exit strategy is the cheapest of the four, and which one that is hangs on the breaks") {
  json shop = gallery("drilling-line.json");
  // The radial drills alone, with blanks always at hand.
  shop["parts"][0]["route"] = {"drill 8 x 20"};
  shop["parts"][0].erase("release");
  for (const char* list : {"machines", "operations", "tools", "inserts"}) shop[list].erase(1);
  shop["crews"][0]["members"] = 4;
  // Drills that wear slowly: between time and breaks, not between time and wear.
  shop["inserts"][0]["price"] = 20;
  shop["inserts"][0]["edge_life"]["mean_ref_min"] = 400;
  shop["inserts"][0]["edge_life"]["feed_exponent"] = 0.05;
  json study = study_of("/operations/0/process/exit_strategy", 0, 1, {{"kpi", "cost_per_part"}});
  study["variables"] = json::parse(R"([{"name": "exit", "pointer": "/operations/0/process/exit_strategy",
    "type": "categorical", "options": ["constant", "reduced_full_depth", "reduced_exit", "spring_exit"]}])");
  std::vector<std::size_t> chosen;
  for (const double break_torque_nm : {400.0, 110.0}) {
    shop["operations"][0]["process"]["break_torque_nm"] = break_torque_nm;
    const Studied a(study, shop);
    // By hand: machine minutes, and a renewal for every drill that wears out, is changed or breaks.
    std::size_t best = 0;
    std::vector<double> costs;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto s = scenarios::load(scenarios::apply(
          shop,
          {{study["variables"][0]["pointer"].get<std::string>(), study["variables"][0]["options"][k]}}));
      const auto plan = scenarios::plan(s, s.operations[0]);
      const models::LifeLaw life(plan.edge->law, plan.edge->mean_min, plan.edge->cv);
      const double tau = life.gamma_percent_life(0.8);
      const double rate = -std::log1p(-plan.breakage_probability) / plan.main_time_min;
      double used = 0;  // by the midpoint rule
      constexpr int steps = 20'000;
      for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) * tau / steps;
        used += life.reliability(t) * std::exp(-rate * t) * tau / steps;
      }
      const double planned = life.reliability(tau) * std::exp(-rate * tau);
      // Change 3 min, 6 more after a failure, which costs 150 and 30 % of a part; drill 20, grinding 15;
      // lathe 2.2 and setter 0.5 UAH/min.
      const double per_life =
          planned * (3 * 2.7 + 20 + 15) + (1 - planned) * (9 * 2.7 + 20 + 150 + 0.3 * s.parts[0].value);
      costs.push_back(2.2 * (plan.main_time_min + 0.6) + plan.main_time_min / used * per_life);
      if (costs[k] < costs[best]) best = k;
    }
    INFO("drills of " << break_torque_nm << " N m, costs " << costs[0] << " " << costs[1] << " " << costs[2]
                      << " " << costs[3]);
    CHECK(a.answer.best->x[0] == static_cast<double>(best));
    CHECK(a.answer.best->value == Approx(costs[best]).epsilon(1e-6));
    chosen.push_back(best);
  }
  CHECK(chosen.front() != chosen.back());
}

TEST_CASE("K311: parts between lap resets") {
  // (12), (13) of the card: t_1 (1 + g (n - 1) / 2) + T_p + T_c / n is least at the best n. The shop's lap is
  // changed after n parts, which takes T_c; the handling of a part takes the same whatever n.
  for (const double reset_min : {4.0, 15.0, 45.0}) {
    json shop = gallery("lapping-cell.json");
    json& process = shop["operations"][0]["process"];
    process["reset_interval_parts"] = 30;
    process["reset_min"] = reset_min;
    shop["tools"][0]["elements"][0]["change"]["value_min"] = reset_min;
    json study = study_of("/operations/0/process/reset_interval_parts", 1, 40,
                          {{"kpi", "throughput_per_h"}, {"direction", "maximize"}});
    study["variables"][0]["type"] = "integer";
    const Studied a(study, shop);
    const auto s = scenarios::load(shop);
    const auto* spec = s.operations[0].process.as<operations::Lapping>();
    REQUIRE(spec != nullptr);
    const double first_min = *scenarios::plan(s, s.operations[0]).value_of("first_part_min");
    const double growth = (spec->end_of_life_ratio - 1) / static_cast<double>(spec->parts_per_lap_life - 1);
    const auto card = models::k311::best_lap_reset({.first_min = first_min,
                                                    .growth = growth,
                                                    .preparation_min = 1.5,
                                                    .change_min = reset_min,
                                                    .parts_max = 40});
    INFO("a reset takes " << reset_min << " min");
    CHECK(a.answer.best->x[0] == static_cast<double>(card.parts));
    CHECK(a.answer.best->value == Approx(3 * 60 / card.time_min).epsilon(1e-9));
    // Between the ends: the test would see a search that goes to a bound.
    CHECK((card.parts > 1 && card.parts < 40));
  }
}

TEST_CASE("K119: the share of inserts to reject, by the long run of the shop and by the card's cost rate") {
  // Edges run to failure; machine and setter cost nothing, a change costs 12, an insert its prepared price.
  const json shop = scenarios::apply(gallery("tools-certified-inserts.json"),
                                     {{"/inserts/0/lots", nullptr},
                                      {"/inserts/0/preparation/life_correlation", 0.9},
                                      {"/inserts/0/preparation/edges_used_by_test", 0},
                                      {"/tools/0/strategy", {{"kind", "run_to_failure"}}},
                                      {"/tools/0/insert_booking", "at_fitting"},
                                      {"/tools/0/regrind_failure", 12.0},
                                      {"/tools/0/failure_damage", 0.0},
                                      {"/tools/0/failure_scrap_probability", 0.0},
                                      {"/machines/0/rate_per_min", 0.0},
                                      {"/crews/0/rate_per_min", 0.0}});
  const Studied a(study_of("/inserts/0/preparation/reject_fraction", 0.02, 0.9, {{"kpi", "cost_per_part"}}),
                  shop);
  models::k119::InspectionIn in;
  const models::LifeLaw life(models::LifeLawKind::weibull, 60, 0.5);
  in.insert_cost = 80;
  in.edges_per_insert = 4;
  in.edges_used_by_test = 0;
  in.test_cost = 2;
  in.salvage_value = 15;
  in.change_cost = 12;
  in.shape = life.shape();
  in.scale_min = life.scale();
  in.rho_life = 0.9;
  const auto rate_at = [&](double share) {
    in.reject_fraction = share;
    return models::k119::inspection_decision(in).cost_rate_with;
  };
  double best = 0.02;
  for (double share = 0.02; share <= 0.9; share += 1e-4)
    if (rate_at(share) < rate_at(best)) best = share;
  const double main_time_min = std::numbers::pi * 500 * 1000 / (1000 * 60);
  INFO("by scan " << best << " " << rate_at(best));
  CHECK(a.answer.best->value / main_time_min == Approx(rate_at(a.answer.best->x[0])).epsilon(1e-4));
  CHECK(rate_at(a.answer.best->x[0]) == Approx(rate_at(best)).epsilon(1e-5));
  // The card's own search, on its grid of hundredths, asked for by a study of its cost rate.
  json inputs = {{"insert_cost", 80},
                 {"edges_per_insert", 4},
                 {"edges_used_by_test", 0},
                 {"test_cost", 2},
                 {"salvage_value", 15},
                 {"change_cost", 12},
                 {"breakage_cost", 0},
                 {"weibull_shape", life.shape()},
                 {"weibull_scale_min", life.scale()},
                 {"breakage_fraction", 0},
                 {"rho_life", 0.9},
                 {"rho_break", 0},
                 {"reject_fraction", {{"pointer", "/inserts/0/preparation/reject_fraction"}}}};
  const Studied card(
      study_of("/inserts/0/preparation/reject_fraction", 0.02, 0.9,
               {{"function", "K119.inspection_decision"}, {"output", "cost_rate_with"}, {"inputs", inputs}}),
      gallery("tools-certified-inserts.json"));
  CHECK(card.answer.best->x[0] == Approx(best).margin(2e-3));
  CHECK(models::k119::optimal_reject_fraction(in).reject_fraction ==
        Approx(card.answer.best->x[0]).margin(0.0101));
}

TEST_CASE("K109: replace at m failed teeth, by enumeration") {
  // Ten teeth that wear out by chance (exponential lives of 44 min) and do not load each other, because the
  // table slows down in proportion to those that work: until the m-th failure the mill does the work of
  // m/10 of a tooth's life in the time sum of 1/(10 - j). A change takes 20 min.
  json shop = gallery("tools-face-mill.json");
  shop["inserts"][0]["edge_life"]["cv"] = 1.0;
  shop["machines"][0]["count"] = 1;
  shop["tools"][0]["strategy"] = {{"kind", "replace_at_failed_teeth"},
                                  {"failed_teeth", 2},
                                  {"load_sharing", "none"},
                                  {"reduce_feed", true},
                                  {"replace", "all"}};
  const json nothing = {{"kind", "constant"}, {"value_min", 0.0}};
  shop["tools"][0]["change"] = {{"index", nothing}, {"replace", nothing}, {"stop_min", 20.0}};
  shop["tools"][0]["failure_scrap_probability"] = 0.0;
  shop["simulation"] = {{"horizon_min", 30'000}, {"warmup_min", 1000}, {"seed", "9"}};
  json study = study_of("/tools/0/strategy/failed_teeth", 1, 9,
                        {{"kpi", "throughput_per_h"}, {"direction", "maximize"}});
  study["variables"][0]["type"] = "integer";
  study["simulation"] = {{"trials", 9}, {"first_replications", 6}, {"levels", 1}, {"neighbourhood", 1.0}};
  study["choice"] = {
      {"finalists", 3}, {"first_replications", 8}, {"max_replications", 60}, {"indifference", 0.005}};
  const Studied a(study, shop);
  double elapsed = 0;
  double most = 0;
  int best = 0;
  std::vector<double> rates;
  for (int m = 1; m <= 9; ++m) {
    elapsed += 44.0 / (11 - m);
    rates.push_back(m * 4.4 / (elapsed + 20));
    if (rates.back() > most) {
      most = rates.back();
      best = m;
    }
  }
  CHECK(best == 6);
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == best);
  const auto s = scenarios::load(shop);
  const double main_time_min = scenarios::plan(s, s.operations[0]).main_time_min;
  CHECK(a.answer.best->value == Approx(60 * most / main_time_min).epsilon(0.015));
}
