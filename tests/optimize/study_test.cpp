// Stage one against the closed form of K117, stage two against stage one.
#include "optimize/study.h"

#include <cmath>
#include <memory>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/reliability/k117_rational_reliability.h"
#include "optimize/analysis.h"
#include "optimize/renewal_reward.h"
#include "sim/kernel/random_stream.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;

using verstat::test::gallery;

namespace {

double long_run_cost(const json& scenario, const std::vector<std::string>& changes) {
  std::vector<scenarios::Change> all;
  for (const std::string& change : changes) all.push_back(scenarios::parse_change(change));
  const scenarios::Scenario s = scenarios::load(scenarios::apply(scenario, all));
  return LongRunModel(s).cost_per_part();
}

using Analytic = verstat::test::Studied;

}  // namespace

TEST_CASE("the study finds the joint optimum of K117 from any start") {
  struct Case {
    const char* name;
    models::LifeLawKind law;
    double cv;
    double gamma_published, speed_published;  // of the issue and card, check 9
  };
  for (const Case& c : {Case{"heavy-lathe", models::LifeLawKind::weibull, 0.7, 0.4703, 46.97},
                        Case{"heavy-lathe-treated", models::LifeLawKind::normal, 0.4, 0.8205, 51.01}}) {
    models::k117::JointOptimumIn in;
    in.law = c.law;
    in.cv = c.cv;
    const auto exact = models::k117::joint_speed_gamma_optimum(in);
    const json study = gallery(std::string(c.name) + ".study.json");
    const json scenario = gallery(std::string(c.name) + ".json");
    for (double gamma : {0.05, 0.3, 0.64, 0.9, 0.98})
      for (double speed : {20.0, 47.0, 60.0, 119.0}) {
        INFO(c.name << " from gamma " << gamma << " V " << speed);
        const Analytic a(study,
                         scenarios::apply(scenario, {{"/tools/0/strategy/gamma", gamma},
                                                     {"/operations/0/process/cutting_speed_m_min", speed}}));
        REQUIRE(a.answer.best);
        const auto& best = *a.answer.best;
        CHECK(best.x[0] == Approx(exact.gamma).epsilon(1e-4));
        CHECK(best.x[1] == Approx(exact.speed_m_min).epsilon(1e-4));
        CHECK(best.value == Approx(exact.part_cost).epsilon(1e-9));
        CHECK(best.x[0] == Approx(c.gamma_published).margin(0.00005 + 1e-4 * 0.5));
        CHECK(best.x[1] == Approx(c.speed_published).margin(0.005 + 1e-4 * 50));
        CHECK(a.trials <= 4000);
      }
  }
}

TEST_CASE("the long-run model is K117.part_cost for every strategy") {
  const json scenario = gallery("heavy-lathe.json");
  using models::k117::Strategy;
  for (const auto& [name, strategy] :
       {std::pair{"age", Strategy::age}, std::pair{"part_count", Strategy::part_count},
        std::pair{"block", Strategy::block}, std::pair{"run_to_failure", Strategy::run_to_failure}})
    for (double gamma : {0.1, 0.47, 0.9}) {
      models::k117::PartCostIn in;
      in.strategy = strategy;
      in.gamma = gamma;
      in.speed_m_min = 52;
      const std::string text = strategy == Strategy::run_to_failure
                                   ? R"({"kind":"run_to_failure"})"
                                   : fmt::format(R"({{"kind":"{}","gamma":{}}})", name, gamma);
      INFO(text);
      CHECK(long_run_cost(scenario,
                          {"/tools/0/strategy=" + text, "/operations/0/process/cutting_speed_m_min=52"}) ==
            Approx(models::k117::part_cost(in).part_cost).epsilon(1e-12));
    }
}

TEST_CASE(
    "the long-run model is what the simulation tends to, with doubtful edges and unequal change times") {
  const json scenario = gallery("heavy-lathe.json");
  const std::vector<std::string> odd = {"/crews/0/members=2",
                                        "/inserts/0/edges=4",
                                        "/inserts/0/reserve_ok_probability=0.6",
                                        "/inserts/0/single_edge_probability=0.2",
                                        "/tools/0/change/replace/rate_per_min=0.1",
                                        "/tools/0/insert_booking=at_fitting",
                                        "/tools/0/regrind_planned=3",
                                        "/tools/0/strategy/gamma=0.7",
                                        "/simulation/horizon_min=610000"};
  std::vector<scenarios::Change> changes;
  for (const std::string& change : odd) changes.push_back(scenarios::parse_change(change));
  const auto run = shop::run_scenario(scenarios::load(scenarios::apply(scenario, changes)), 2);
  const auto& estimate = run.estimates[*run.index_of("cost_per_part")];
  const double theory = long_run_cost(scenario, odd);
  INFO(*estimate.mean << " +- " << *estimate.half_width << " theory " << theory);
  CHECK(std::abs(*estimate.mean - theory) < 2 * *estimate.half_width);
  CHECK(*estimate.half_width < 0.005 * theory);
}

TEST_CASE("confirmation finds the optimum better than the baseline under common random numbers") {
  const json scenario = gallery("heavy-lathe.json");
  const Analytic a(gallery("heavy-lathe.study.json"), scenario);
  StudySpec study = a.study;
  study.confirmation.replications = 10;
  const auto changes = confirmation_changes(study, 20111);
  const auto run = [&](const json& text) {
    return shop::run_scenario(scenarios::load(scenarios::apply(text, changes)), 2);
  };
  const auto confirmation = confirm(study, run(scenario), run(a.problem->scenario_at(a.answer.best->x)));
  CHECK(confirmation.verdict == "better");
  // Waiting for the shared setter is outside the long-run model, and small.
  CHECK(*confirmation.saving.mean == Approx(*a.answer.baseline_value - a.answer.best->value).epsilon(0.25));
  // The pairing pays: the half-width of the difference is below that of independent runs.
  const auto k = *confirmation.baseline.index_of("cost_per_part");
  CHECK(*confirmation.saving.half_width < std::hypot(*confirmation.baseline.estimates[k].half_width,
                                                     *confirmation.best.estimates[k].half_width));
}

TEST_CASE("replications given in two parts are those given at once") {
  scenarios::Scenario s = scenarios::load(gallery("heavy-lathe.json"));
  s.simulation.horizon_min = 20'000;
  s.simulation.replications = 5;
  const auto whole = shop::run_scenario(s, 2);
  const auto rest = shop::run_replications(s, 2, 3, 1);
  for (std::size_t r = 0; r < 3; ++r) CHECK(rest.values[r] == whole.values[r + 2]);
}

TEST_CASE("age replacement: the optimum of renewal theory") {
  // Cost per minute of cutting with fixed costs of a planned and a failed change, found by a fine scan;
  // Barlow, Proschan (1965). The shop is priced so that only those two costs differ with gamma.
  const json scenario =
      scenarios::apply(gallery("heavy-lathe.json"), {{"/machines/0/rate_per_min", 0.0},
                                                     {"/crews/0/rate_per_min", 0.0},
                                                     {"/tools/0/regrind_planned", 20.0},
                                                     {"/tools/0/regrind_failure", 100.0},
                                                     {"/tools/0/failure_damage", 0.0},
                                                     {"/tools/0/failure_scrap_probability", 0.0},
                                                     {"/inserts/0/price", 0.0}});
  json study = gallery("heavy-lathe.study.json");
  study["variables"].erase(1);
  const Analytic a(study, scenario);
  const models::LifeLaw life(models::LifeLawKind::weibull, 60, 0.7);
  double best_gamma = 0;
  double best = 1e300;
  for (double gamma = 0.05; gamma <= 0.98; gamma += 1e-5) {
    const double tau = life.gamma_percent_life(gamma);
    const double cost = (20 * gamma + 100 * (1 - gamma)) / life.restricted_mean(tau);
    if (cost < best) {
      best = cost;
      best_gamma = gamma;
    }
  }
  CHECK(a.answer.best->x[0] == Approx(best_gamma).margin(2e-4));
  const double main_time_min = a.problem->look_at_baseline().long_run->plans[0].main_time_min;
  CHECK(a.answer.best->value == Approx(best * main_time_min).epsilon(1e-7));
}

TEST_CASE(
    "one cut: the closed form is the optimum of its own cost, and of a shop that is no more than one cut") {
  // Brute force over the speed of the textbook's cost per part.
  const double mu = 5, change = 3, edge = 20, rate = 3;
  const double closed = taylor_life_min_cost(mu, change, edge, rate);
  double best_life = 0;
  double best = 1e300;
  for (double v = 20; v < 120; v += 1e-3) {
    const double life = 60 * std::pow(60 / v, mu);
    const double time = 1000 / v;
    const double cost = rate * time + time / life * (rate * change + edge);
    if (cost < best) {
      best = cost;
      best_life = life;
    }
  }
  CHECK(closed == Approx(best_life).epsilon(5e-4));
  CHECK(closed == Approx((mu - 1) * (change + edge / rate)));
  // Where a failed edge costs no more than one changed as planned, only the mean time in use counts: with the
  // edges changed at the age of gamma it is the share c of the mean life, and the shop's best speed is where
  // c times the life is the closed form's. The edges are booked by periods, four of them whatever happens.
  const json scenario =
      scenarios::apply(gallery("heavy-lathe.json"), {{"/tools/0/change/failure_extra_min", 0.0},
                                                     {"/tools/0/failure_damage", 0.0},
                                                     {"/tools/0/failure_scrap_probability", 0.0},
                                                     {"/tools/0/periods_failure", 4.0}});
  json study = gallery("heavy-lathe.study.json");
  study["variables"].erase(0);
  const Analytic a(study, scenario);
  const auto cuts = one_cut_optima(scenarios::load(a.problem->scenario_at(a.answer.best->x)));
  REQUIRE(cuts.size() == 1);
  const models::LifeLaw unit(models::LifeLawKind::weibull, 1.0, 0.7);
  const double c = unit.restricted_mean(unit.gamma_percent_life(0.64));
  CHECK(cuts[0].speed_shop_m_min == a.answer.best->x[0]);
  CHECK(c * cuts[0].life_shop_min == Approx(cuts[0].life_min_cost_min).epsilon(1e-4));
  CHECK(cuts[0].speed_max_rate_m_min > cuts[0].speed_min_cost_m_min);
  // By hand: exponent 5; change 1.6667 + 1 / 0.3 min at 0.5 UAH/min, edge 80 / 4 UAH, lathe 3 UAH/min.
  const double change_min = 5.0 / 3 + 1 / 0.3;
  CHECK(cuts[0].life_min_cost_min == Approx(4 * (change_min + (20 + 0.5 * change_min) / 3)).epsilon(1e-6));
  CHECK(cuts[0].life_max_rate_min == Approx(4 * change_min).epsilon(1e-6));
}

TEST_CASE(
    "the long run of a route: the bottleneck sets the pace, idle machines cost, and the simulation agrees") {
  // Lathe, then a slower mill and a washer with time to spare; scrap on the way; one crew paid by the shift.
  json scenario = gallery("heavy-lathe.json");
  scenario["crews"][0]["pay"] = "shift";
  scenario["crews"][0]["members"] = 4;
  scenario["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}});
  scenario["machines"].push_back({{"name", "washer"}, {"rate_per_min", 1.0}});
  scenario["operations"].push_back(
      {{"name", "milling"},
       {"machine", "mill"},
       {"process", {{"kind", "duration"}, {"time", {{"kind", "constant"}, {"value_min", 20.0}}}}}});
  scenario["operations"].push_back(
      {{"name", "washing"},
       {"machine", "washer"},
       {"process", {{"kind", "duration"}, {"time", {{"kind", "constant"}, {"value_min", 4.0}}}}}});
  scenario["parts"][0]["route"] = {"rough turning", "milling", "washing"};
  scenario["simulation"] = {
      {"horizon_min", 400'000}, {"warmup_min", 100'000}, {"replications", 6}, {"seed", "5"}};
  const scenarios::Scenario s = scenarios::load(scenario);
  const LongRunModel model(s);
  const LongRun run = model.evaluate();
  CHECK(s.machines[run.bottleneck].name == "mill");
  CHECK(run.machines[run.bottleneck].load > 1.15);  // the lathes could do more
  CHECK(run.throughput_per_h ==
        Approx(3.0));  // one good part every 20 min: nothing is scrapped behind the mill
  CHECK(run.machines[2].load == Approx(0.2));
  const auto simulated = shop::run_scenario(s, 2);
  for (const char* kpi : {"throughput_per_h", "cost_per_part", "quality_ratio"}) {
    INFO(kpi);
    const auto& estimate = simulated.estimates[*simulated.index_of(kpi)];
    const double theory = model.value(run, *model.kpi(kpi));
    CHECK(std::abs(*estimate.mean - theory) < 2 * *estimate.half_width + 1e-4 * theory);
    CHECK(*estimate.half_width < 0.01 * theory);
  }
}

TEST_CASE("constraints of plans hold, bind, and have their price") {
  // The speed may not go below 55: a bound of the box, a quantity's limit and a function's limit say the
  // same.
  const json scenario = gallery("heavy-lathe.json");
  const auto with = [&](const char* constraint) {
    json study = gallery("heavy-lathe.study.json");
    if (constraint != nullptr) study["constraints"] = json::array({json::parse(constraint)});
    return study;
  };
  const Analytic free(with(nullptr), scenario);
  const double main_time_at_55 =
      free.problem->look(std::vector<double>{0.5, 55.0}).long_run->plans[0].main_time_min;
  const Analytic quantity(
      with(fmt::format(R"({{"operation": "rough turning", "quantity": "main_time_min", "at_most": {:.17g}}})",
                       main_time_at_55)
               .c_str()),
      scenario);
  const Analytic function(
      with(R"({"function": "K117.weibull_from_moments", "output": "scale_min", "at_least": 60.6651,
                                   "inputs": {"mean_min": {"pointer": "/operations/0/process/cutting_speed_m_min"}, "cv": 0.7}})"),
      scenario);
  REQUIRE(quantity.answer.best);
  CHECK(quantity.answer.best->x[1] == Approx(55).epsilon(1e-6));
  CHECK(quantity.answer.best->x[1] >= 55 * (1 - 1e-7));
  CHECK(quantity.answer.best->value > free.answer.best->value);
  // The Weibull scale is proportional to its mean, here the speed: 60.6651 = 55 / Gamma(1 + 1/b).
  REQUIRE(function.answer.best);
  CHECK(function.answer.best->x[1] == Approx(55).epsilon(1e-4));
  CHECK(function.answer.best->x[0] == Approx(quantity.answer.best->x[0]).epsilon(1e-3));
  // The price of one minute more of main time is the slope of the optimum.
  const auto binding =
      binding_constraints(*quantity.problem, quantity.answer.best->x, search_options(quantity.study, 1));
  REQUIRE(binding.size() == 1);
  CHECK(binding[0].name == "main_time_min of rough turning");
  const double more = 0.01 * main_time_at_55;
  const Analytic relaxed(
      with(fmt::format(R"({{"operation": "*", "quantity": "main_time_min", "at_most": {:.17g}}})",
                       main_time_at_55 + more)
               .c_str()),
      scenario);
  CHECK(binding[0].shadow_price ==
        Approx((quantity.answer.best->value - relaxed.answer.best->value) / more).epsilon(0.02));
  // Nothing is feasible: no plan rather than a wrong one.
  const Analytic none(with(R"({"kpi": "throughput_per_h", "at_least": 1e6})"), scenario);
  CHECK_FALSE(none.answer.best);
}

TEST_CASE("whole numbers and categories of a scenario against all their combinations") {
  const json scenario =
      scenarios::apply(gallery("heavy-lathe.json"), {{"/inserts/0/reserve_ok_probability", 0.7}});
  json study = gallery("heavy-lathe.study.json");
  study["variables"] = json::parse(R"([
    {"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 1, "high": 8},
    {"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical",
     "options": [{"kind": "run_to_failure"}, {"kind": "age", "gamma": 0.64}, {"kind": "age", "gamma": 0.5}, {"kind": "part_count", "gamma": 0.5}]},
    {"name": "booking", "pointer": "/tools/0/insert_booking", "type": "categorical", "options": ["life_periods", "at_fitting"]}])");
  const Analytic a(study, scenario);
  CHECK(a.answer.baseline == std::vector<double>{2, 1, 0});
  double best = 1e300;
  for (int edges = 1; edges <= 8; ++edges)
    for (const auto& strategy : study["variables"][1]["options"])
      for (const auto& booking : study["variables"][2]["options"]) {
        const auto s = scenarios::load(scenarios::apply(scenario, {{"/inserts/0/edges", edges},
                                                                   {"/tools/0/strategy", strategy},
                                                                   {"/tools/0/insert_booking", booking}}));
        best = std::min(best, LongRunModel(s).cost_per_part());
      }
  CHECK(a.answer.best->value == Approx(best).epsilon(1e-12));
  CHECK(a.trials <= 64);
}

TEST_CASE(
    "a study interrupted at 20 random moments has the same trials and answer, and computes nothing twice") {
  // All three stages, with a noisy constraint; short shop.
  const json scenario = scenarios::apply(
      gallery("heavy-lathe.json"), {{"/simulation/horizon_min", 4000}, {"/simulation/warmup_min", 500}});
  json text = gallery("heavy-lathe.study.json");
  text["search"]["max_evaluations"] = 300;
  text["simulation"] = {{"trials", 20}, {"first_replications", 3}, {"levels", 2}};
  text["choice"] = {{"finalists", 3}, {"first_replications", 5}, {"max_replications", 20}};
  text["constraints"] = json::parse(R"([{"kpi": "throughput_per_h", "at_least": 2.0, "confidence": 0.9}])");
  const StudySpec study = load_study(text);
  std::vector<Trial> kept;
  std::size_t stop_after = 0;
  const StudyTools tools{
      .simulate = [](const scenarios::Scenario& s, std::uint64_t first, std::int64_t count) {
        return shop::run_replications(s, first, count, 1);
      }};
  const auto go = [&](std::size_t stop) {
    stop_after = stop;
    Problem problem(study, scenario);
    Ledger ledger(
        [&](const Trial& t) { kept.push_back(t); },
        [&]() -> std::string { return stop_after > 0 && kept.size() >= stop_after ? "stopped" : ""; });
    for (const Trial& t : kept) ledger.remember(t);
    return run_study(problem, ledger, tools);
  };
  const StudyAnswer whole = go(0);
  const std::vector<Trial> all = kept;
  REQUIRE(whole.best);
  REQUIRE(whole.interrupted.empty());
  CHECK(whole.best->stage == "choice");
  sim::RandomStream moments(1, "test", "moments");
  for (int k = 0; k < 20; ++k) {
    kept.clear();
    const std::size_t moment = 1 + moments.below(all.size() - 1);
    const StudyAnswer half = go(moment);
    CHECK(half.interrupted == "stopped");
    CHECK(kept.size() == moment);
    const StudyAnswer rest = go(0);
    CHECK(rest.best->x == whole.best->x);
    CHECK(rest.best->value == whole.best->value);
    REQUIRE(kept.size() == all.size());  // none twice, none missing
    for (std::size_t t = 0; t < all.size(); ++t) {
      CHECK(kept[t].x == all[t].x);
      CHECK(kept[t].stage == all[t].stage);
    }
  }
}

TEST_CASE(
    "a shop whose machines fail is optimized by simulation alone, near the optimum of one whose do not") {
  // Failures that come with parts, not with minutes, cost every part the same: the best regime moves little.
  json text = gallery("heavy-lathe.study.json");
  text["changes"] = json::parse(R"([
    {"pointer": "/machines/0/failures", "value": [{"name": "spindle", "clock": "parts", "time_to_failure": {"kind": "exponential", "rate_per_min": 0.013},
                                                   "repair": {"kind": "constant", "value_min": 120}}]},
    {"pointer": "/simulation/horizon_min", "value": 30000}, {"pointer": "/simulation/warmup_min", "value": 0}])");
  const json scenario = gallery("heavy-lathe.json");
  const StudySpec blind = load_study(text);
  const json changed = scenarios::apply(scenario, fixed_changes(blind));
  Problem refused(blind, changed);
  CHECK_THROWS_WITH(check_study(refused),
                    Catch::Contains("/simulation/trials = 0, but /machines/0/failures/0/clock"));
  text["simulation"] = {{"trials", 80}, {"first_replications", 4}, {"levels", 2}, {"neighbourhood", 0.4}};
  const StudySpec study = load_study(text);
  Problem problem(study, changed);
  Ledger ledger;
  const StudyAnswer answer =
      run_study(problem, ledger, {.simulate = [](const auto& s, std::uint64_t first, std::int64_t count) {
                  return shop::run_replications(s, first, count, 2);
                }});
  REQUIRE(answer.best);
  CHECK(answer.best->stage == "choice");
  CHECK_FALSE(answer.analytic);
  CHECK(answer.best->x[1] == Approx(46.97).margin(4));
  CHECK(ledger.computed() <= 120);
  // A part carries 0.013 x 120 min of repair, which costs the rate of the lathe: 5 UAH.
  CHECK(answer.best->value > 125.41);
  CHECK(answer.best->value < 125.41 * 1.08);
}

TEST_CASE("robust optimum: the worst of the samples is better than at the nominal optimum") {
  const json scenario = gallery("heavy-lathe.json");
  json text = gallery("heavy-lathe.study.json");
  text["uncertain"] =
      json::parse(R"([{"name": "exponent", "pointer": "/inserts/0/edge_life/speed_exponent", "relative": 0.3},
                                      {"name": "life", "pointer": "/inserts/0/edge_life/mean_ref_min", "relative": 0.4}])");
  const Analytic nominal(text, scenario);
  text["robust"] = {{"samples", 16}, {"measure", "worst"}};
  const Analytic robust(text, scenario);
  // The objective of the robust study at the nominal optimum, asked of a study that has no choice.
  json fixed = text;
  for (std::size_t k = 0; k < 2; ++k) {
    const double x = nominal.answer.best->x[k];
    fixed["variables"][k]["low"] = x;
    fixed["variables"][k]["high"] = x * (1 + 1e-9);
  }
  const Analytic held(fixed, scenario);
  CHECK(robust.answer.best->value < held.answer.best->value - 0.01);
  CHECK(robust.answer.best->value > nominal.answer.best->value);
  const auto s = sensitivities(*nominal.problem, nominal.answer.best->x, search_options(nominal.study, 1));
  REQUIRE(s.size() == 2);
  for (const auto& one : s) {
    CHECK(one.regret_low >= 0);
    CHECK(one.regret_high >= 0);
    CHECK(one.regret_low + one.regret_high > 0);
  }
}

TEST_CASE("cost against throughput: a front with both ends, and a study of 12 + 4 variables") {
  const json scenario = gallery("heavy-lathe.json");
  json text = gallery("heavy-lathe.study.json");
  text.erase("objective");
  text["objectives"] =
      json::parse(R"([{"kpi": "cost_per_part"}, {"kpi": "throughput_per_h", "direction": "maximize"}])");
  text["front"] = {{"points", 9}};
  text["search"]["max_evaluations"] = 6000;
  const Analytic a(text, scenario);
  REQUIRE(a.answer.front);
  const auto& points = a.answer.front->points;
  REQUIRE(points.size() >= 8);
  const Analytic cheap(gallery("heavy-lathe.study.json"), scenario);
  CHECK(points.front().objectives[0] == Approx(cheap.answer.best->value).epsilon(1e-5));
  for (std::size_t k = 1; k < points.size(); ++k) {
    CHECK(points[k].objectives[0] > points[k - 1].objectives[0]);
    CHECK(points[k].objectives[1] > points[k - 1].objectives[1]);
  }
  CHECK(a.answer.front->hypervolume > 0);
}

TEST_CASE("a study that cannot be run says why") {
  const json scenario = gallery("heavy-lathe.json");
  const auto error_of = [&](const std::string& change) -> std::string {
    try {
      const json text =
          scenarios::apply(gallery("heavy-lathe.study.json"), {scenarios::parse_change(change)});
      (void)Analytic(text, scenario);
    } catch (const scenarios::InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  CHECK(error_of("/variables/0/pointer=/tools/0/strategy/gamm") ==
        "/variables/0/pointer = \"/tools/0/strategy/gamm\", leads to no continuous number of the scenario");
  CHECK(error_of("/variables/0/pointer=tools") ==
        "/variables/0/pointer = \"tools\", leads to no continuous number of the scenario");
  CHECK(error_of("/variables/0/high=1.5")
            .starts_with(
                "/variables/0/high = 1.5, is not valid in the scenario: /tools/0/strategy/gamma = 1.5"));
  CHECK(error_of("/variables/0/low=2") == "/variables/0/low = 2, must be below high = 0.98");
  CHECK(error_of("/variables=[]").starts_with("/variables has 0 entries, allowed 1 to 100"));
  CHECK(error_of("/objective/kpi=beauty")
            .starts_with("/simulation/trials = 0, but the long-run model does not know"));
  CHECK(error_of("/search/algorithm=LD_NEWTON")
            .starts_with("/search/algorithm = \"LD_NEWTON\", must be an NLopt algorithm"));
  CHECK(error_of("/variables/0/type=integer").starts_with("/variables/0/low = 0.05, must be a whole number"));
  CHECK(error_of(R"(/constraints=[{"kpi": "cost_per_part"}])") ==
        "/constraints/0: must have either at_most or at_least");
  CHECK(error_of(R"(/constraints=[{"kpi": "a", "operation": "b", "limits": "all"}])") ==
        "/constraints/0: must have exactly one of kpi, operation and function");
  CHECK(
      error_of(R"(/constraints=[{"operation": "rough turnin", "limits": "all"}])") ==
      "/constraints/0/operation = \"rough turnin\", there is no such operation; closest: \"rough turning\"");
  CHECK(error_of(R"(/constraints=[{"function": "K117.part_coast", "output": "part_cost", "at_most": 1}])")
            .starts_with("/constraints/0/function: K117.part_coast"));
  CHECK(error_of(R"(/constraints=[{"kpi": "beauty", "at_most": 1}])")
            .starts_with("/constraints/0/kpi = \"beauty\", there is no such KPI"));
  CHECK(error_of(R"(/constraints=[{"kpi": "lead_time_min", "at_most": 1}])")
            .starts_with("/simulation/trials = 0, but only simulation knows \"lead_time_min\""));
  CHECK(error_of(R"(/robust={"samples": 4})") ==
        "/robust: say in /uncertain which inputs are uncertain, and by how much");
}
