// The stages of a study with shops whose simulation is a formula and known noise: what the study should
// choose can be written down.
#include <cmath>
#include <map>
#include <numbers>

#include <catch2/catch.hpp>

#include "models/catalogue/error.h"
#include "operations/kinds/turning.h"
#include "sim/kernel/random_stream.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

double speed_of(const scenarios::Scenario& s) {
  return s.operations[0].process.as<operations::Turning>()->cutting_speed_m_min;
}
double gamma_of_tool(const scenarios::Scenario& s) {
  return scenarios::gamma_of(s.tools[0].strategy).value_or(0);
}

// KPIs of a scenario without noise, by name.
using Formula = std::function<std::map<std::string, std::optional<double>>(const scenarios::Scenario&)>;
// The same noise at every point, up to `noise`; the seed of the scenario makes it fresh.
Simulate simulated_by(Formula formula, double noise) {
  return [formula = std::move(formula), noise](const scenarios::Scenario& s, std::uint64_t first,
                                               std::int64_t count) {
    const auto mean = formula(s);
    shop::RunResult run;
    for (const auto& [name, value] : mean) run.kpis.push_back({name, "1", ""});
    std::vector<std::vector<std::optional<double>>> columns(mean.size());
    for (std::uint64_t r = first; r < first + static_cast<std::uint64_t>(count); ++r) {
      sim::RandomStream stream(s.simulation.seed.value, "formula", "noise", r);
      const double shift = stream.uniform(-noise, noise);
      auto& row = run.values.emplace_back();
      std::size_t k = 0;
      for (const auto& [name, value] : mean) {
        row.push_back(value ? std::optional(*value + shift) : std::nullopt);
        columns[k++].push_back(row.back());
      }
    }
    for (const auto& column : columns) run.estimates.push_back(shop::estimate(column));
    return run;
  };
}

struct Answered {
  StudySpec spec;
  Problem problem;
  Ledger ledger;
  StudyAnswer answer;
  std::vector<StudyProgress> progress;
  std::map<std::string, int> trials;  // by stage
  Answered(const json& text, const json& scenario, const Simulate& simulate, int stop_after = -1)
      : spec(load_study(text)),
        problem(spec, scenarios::apply(scenario, fixed_changes(spec))),
        ledger([this](const Trial& t) { ++trials[t.stage]; },
               [this, stop_after]() -> std::string {
                 return stop_after >= 0 && ledger.computed() >= stop_after ? "enough" : "";
               }) {
    check_study(problem);
    answer = run_study(problem, ledger, {.simulate = simulate, .progress = [this](const StudyProgress& p) {
                                           progress.push_back(p);
                                         }});
  }
};

json study(const char* objective = R"({"kpi": "cost_per_part"})") {
  json s = gallery("heavy-lathe.study.json");
  s["objective"] = json::parse(objective);
  s["search"]["max_evaluations"] = 600;
  s["simulation"] = {{"trials", 60}, {"first_replications", 4}, {"levels", 2}, {"neighbourhood", 0.3}};
  s["choice"] = {
      {"finalists", 3}, {"first_replications", 6}, {"max_replications", 60}, {"indifference", 0.001}};
  return s;
}
// A shop that the long run does not cover.
json uncovered() {
  json s = gallery("heavy-lathe.json");
  s["machines"][0]["queue_capacity"] = 5;
  return s;
}

}  // namespace

TEST_CASE("stages: without a long run the simulation alone finds the bottom of a bowl, smallest or largest") {
  const auto bowl = [](const scenarios::Scenario& s) {
    const double a = (speed_of(s) - 64) / 100;
    const double b = gamma_of_tool(s) - 0.55;
    return 10 + 20 * (a * a + b * b);
  };
  for (const bool maximize : {false, true}) {
    json text = study(maximize ? R"({"kpi": "throughput_per_h", "direction": "maximize"})"
                               : R"({"kpi": "cost_per_part"})");
    const Answered a(text, uncovered(),
                     simulated_by(
                         [&](const auto& s) -> std::map<std::string, std::optional<double>> {
                           return {{"cost_per_part", bowl(s)}, {"throughput_per_h", 30 - bowl(s)}};
                         },
                         0.05));
    CHECK(a.answer.not_covered.starts_with("/machines/0/queue_capacity"));
    CHECK_FALSE(a.answer.analytic);
    CHECK_FALSE(a.answer.baseline_value);
    REQUIRE(a.answer.best);
    CHECK(a.answer.best->x[0] == Approx(0.55).margin(0.05));
    CHECK(a.answer.best->x[1] == Approx(64).margin(5));
    CHECK(a.answer.best->value == Approx(maximize ? 20 : 10).margin(0.1));
    CHECK(a.answer.best->stage == "choice");
    REQUIRE(a.answer.choice);
    const Choice& choice = *a.answer.choice;
    CHECK(choice.finalists.size() <= 3);
    CHECK(choice.finalists[choice.best].survived);
    CHECK(choice.finalists[choice.best].x == a.answer.best->x);
    // A share of the objective that does not matter, in its own unit.
    CHECK(choice.indifference == Approx(0.001 * (maximize ? 20 : 10)).epsilon(0.05));
    CHECK(a.trials.count("analytic") == 0);
    CHECK(a.trials.at("choice") >= 1);
    REQUIRE(!a.progress.empty());
    CHECK(a.progress.front().stage == "simulation");
    CHECK(a.progress.front().of == 60);
    CHECK(a.progress.back().stage == "choice");
  }
}

TEST_CASE("stages: what simulation adds to one option of a category is learnt, and another is taken") {
  // The long run likes run to failure least, then age at three levels; the simulation knows that the cheapest
  // one costs 40 more. The answer by enumeration.
  json text = study();
  text["variables"] =
      json::parse(R"([{"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical",
    "options": [{"kind": "run_to_failure"}, {"kind": "age", "gamma": 0.64}, {"kind": "age", "gamma": 0.5}, {"kind": "age", "gamma": 0.2}]},
    {"name": "speed", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 30, "high": 90}])");
  const json scenario = gallery("heavy-lathe.json");
  const auto extra = [](const scenarios::Scenario& s) {
    return std::abs(gamma_of_tool(s) - 0.5) < 1e-9 ? 40.0 : 1.0;
  };
  const Answered a(text, scenario,
                   simulated_by(
                       [&](const auto& s) -> std::map<std::string, std::optional<double>> {
                         return {{"cost_per_part", LongRunModel(s).cost_per_part() + extra(s)}};
                       },
                       0.2));
  std::size_t best = 9;
  double least = 1e300;
  double believed = 1e300;
  std::size_t first = 9;
  for (std::size_t k = 0; k < 4; ++k)
    for (double v = 30; v <= 90; v += 0.5) {
      const auto s = scenarios::load(
          scenarios::apply(scenario, {{"/tools/0/strategy", text["variables"][0]["options"][k]},
                                      {"/operations/0/process/cutting_speed_m_min", v}}));
      const double long_run = LongRunModel(s).cost_per_part();
      if (long_run < believed) {
        believed = long_run;
        first = k;
      }
      if (long_run + extra(s) < least) {
        least = long_run + extra(s);
        best = k;
      }
    }
  CHECK(first == 2);
  CHECK(best != first);
  REQUIRE(a.answer.analytic);
  CHECK(a.answer.analytic->x[0] == static_cast<double>(first));
  CHECK(a.answer.analytic->value == Approx(believed).epsilon(1e-3));
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == static_cast<double>(best));
  CHECK(a.answer.best->value == Approx(least).margin(0.3));
}

TEST_CASE("stages: an option that only simulation knows is tried, and taken when it is the best") {
  json text = study();
  text["variables"] =
      json::parse(R"([{"name": "strategy", "pointer": "/tools/0/strategy", "type": "categorical",
    "options": [{"kind": "age", "gamma": 0.64}, {"kind": "opportunistic", "gamma": 0.64}, {"kind": "run_to_failure"}]},
    {"name": "speed", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 40, "high": 80}])");
  text["constraints"] =
      json::parse(R"([{"operation": "rough turning", "quantity": "main_time_min", "at_most": 29}])");
  const double slowest = std::numbers::pi * 500 / 29;
  for (const double bonus : {-30.0, 30.0}) {
    const Answered a(text, gallery("heavy-lathe.json"),
                     simulated_by(
                         [&](const auto& s) -> std::map<std::string, std::optional<double>> {
                           const bool alone = s.tools[0].strategy.index() == 6;
                           return {{"cost_per_part", 100 + speed_of(s) + (alone ? bonus : 0)}};
                         },
                         0.1));
    REQUIRE(a.answer.best);
    CHECK((a.answer.best->x[0] == 1) == (bonus < 0));
    CHECK(a.answer.best->x[1] >= slowest * (1 - 1e-6));
    CHECK(a.answer.best->x[1] == Approx(slowest).margin(3));
  }
}

TEST_CASE("stages: a simulated constraint is kept on the safe side, or said to be out of reach") {
  json text = study();
  text["constraints"] = json::parse(R"([{"kpi": "throughput_per_h", "at_least": 3.25, "confidence": 0.9},
    {"operation": "rough turning", "quantity": "main_time_min", "at_most": 29}])");
  // The simulated shop makes a twentieth less than the long run says.
  const auto shop = [](const auto& s) -> std::map<std::string, std::optional<double>> {
    const LongRun run = LongRunModel(s).evaluate();
    return {{"cost_per_part", run.cost_per_part}, {"throughput_per_h", 0.95 * run.throughput_per_h}};
  };
  const Answered a(text, gallery("heavy-lathe.json"), simulated_by(shop, 0.02));
  REQUIRE(a.answer.best);
  const auto s = scenarios::load(a.problem.scenario_at(a.answer.best->x));
  const LongRun run = LongRunModel(s).evaluate();
  CHECK(0.95 * run.throughput_per_h > 3.25 - 0.01);
  CHECK(run.plans[0].main_time_min <= 29 * (1 + 1e-6));
  // Not far from the cheapest plan that makes as much: by a fine grid.
  double least = 1e300;
  Problem grid(a.spec, gallery("heavy-lathe.json"));
  const double slowest = std::numbers::pi * 500 / 29;  // 29 min for a metre of 500 mm at 1 mm
  for (double gamma = 0.05; gamma < 0.98; gamma += 0.02)
    for (double v = slowest; v <= 120; v += 1) {
      const auto there = shop(grid.typed_scenario_at({gamma, v}));
      if (*there.at("throughput_per_h") >= 3.25) least = std::min(least, *there.at("cost_per_part"));
    }
  CHECK(a.answer.best->value < least * 1.02);
  CHECK(a.answer.best->value > least * 0.998);
  // Ten an hour is out of reach: nothing is recommended, and no replications are wasted on it.
  text["constraints"][0]["at_least"] = 10;
  const Answered none(text, gallery("heavy-lathe.json"), simulated_by(shop, 0.02));
  CHECK_FALSE(none.answer.best);
  REQUIRE(none.answer.choice);
  for (const Finalist& f : none.answer.choice->finalists) {
    CHECK_FALSE(f.feasible);
    CHECK_FALSE(f.survived);
    CHECK(f.replications == 6);
    CHECK(f.mean);
  }
  // A little noise, a constraint at the very mean: replications double until it is clear.
  json close = study();
  close["variables"] = json::parse(
      R"([{"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 2, "high": 3}])");
  close["constraints"] =
      json::parse(R"([{"kpi": "throughput_per_h", "at_least": 3.95, "confidence": 0.99}])");
  close["simulation"]["trials"] = 4;
  const Answered clear(close, uncovered(),
                       simulated_by(
                           [](const auto& s2) -> std::map<std::string, std::optional<double>> {
                             return {{"cost_per_part", 100 - static_cast<double>(s2.inserts[0].edges)},
                                     {"throughput_per_h", 4.0}};
                           },
                           0.15));
  REQUIRE(clear.answer.choice);
  std::int64_t most = 0;
  for (const Finalist& f : clear.answer.choice->finalists) most = std::max(most, f.replications);
  CHECK(most > 6);
}

TEST_CASE("stages: points that cannot be simulated are no plans; other errors end the study") {
  // The simulation refuses speeds above 70, and has no cost below 45.
  json text = study();
  text["variables"].erase(0);
  const auto partly = [](const auto& s) -> std::map<std::string, std::optional<double>> {
    const double v = speed_of(s);
    if (v > 70) {
      if (v > 80) throw models::ModelError("K117.part_cost", "V", "out of range");
      throw scenarios::InputError("/operations/0", "too fast");
    }
    if (v < 45) return {{"cost_per_part", std::nullopt}};
    return {{"cost_per_part", 200 - v}};
  };
  const Answered a(text, uncovered(), simulated_by(partly, 0.1));
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] > 62);
  CHECK(a.answer.best->x[0] <= 70);
  CHECK_THROWS_WITH(Answered(text, uncovered(),
                             simulated_by(
                                 [](const auto&) -> std::map<std::string, std::optional<double>> {
                                   throw std::runtime_error("disk full");
                                 },
                                 0)),
                    "disk full");
  // A run that lacks a KPI has no values of it.
  const Answered lacking(text, uncovered(),
                         simulated_by(
                             [](const auto&) -> std::map<std::string, std::optional<double>> {
                               return {{"throughput_per_h", 3}};
                             },
                             0));
  CHECK_FALSE(lacking.answer.best);
  // Ctrl-C while a simulation runs.
  const Answered stopped(text, uncovered(), [](const auto&, std::uint64_t, std::int64_t) -> shop::RunResult {
    throw Interrupted("Ctrl-C");
  });
  CHECK(stopped.answer.interrupted == "Ctrl-C");
  CHECK_FALSE(stopped.answer.best);
}

TEST_CASE("stages: a plan that sometimes makes nothing loses to a dearer one that always does") {
  // The long run likes three edges; the simulation finds two cheaper, but in every fourth replication nothing
  // is finished then and there is no cost per part.
  json text = study();
  text["variables"] = json::parse(
      R"([{"name": "edges", "pointer": "/inserts/0/edges", "type": "integer", "low": 2, "high": 3}])");
  const json shop =
      scenarios::apply(gallery("heavy-lathe.json"), {{"/tools/0/insert_booking", "at_fitting"}});
  const auto sometimes = [](const scenarios::Scenario& s, std::uint64_t first, std::int64_t count) {
    shop::RunResult run;
    run.kpis = {{"cost_per_part", "UAH", ""}};
    std::vector<std::optional<double>> column;
    for (std::uint64_t r = first; r < first + static_cast<std::uint64_t>(count); ++r) {
      const bool two = s.inserts[0].edges == 2;
      column.push_back(two && r % 4 == 3
                           ? std::nullopt
                           : std::optional(two ? 190.0 : 200.0 + 0.1 * static_cast<double>(r % 2)));
      run.values.push_back({column.back()});
    }
    run.estimates = {shop::estimate(column)};
    return run;
  };
  const Answered a(text, shop, sometimes);
  REQUIRE(a.answer.analytic);
  CHECK(a.answer.analytic->x[0] == 3);
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == 3);
  REQUIRE(a.answer.choice);
  REQUIRE(a.answer.choice->finalists.size() == 2);
  CHECK(*a.answer.choice->finalists[0].mean < 200);  // of those that have a value
  // Of an objective that is zero there is no share: what does not matter is given in its unit.
  const Answered zero(text, uncovered(),
                      simulated_by(
                          [](const auto&) -> std::map<std::string, std::optional<double>> {
                            return {{"cost_per_part", 0.0}};
                          },
                          0));
  REQUIRE(zero.answer.choice);
  CHECK(zero.answer.choice->indifference == 0.001);
  CHECK(zero.answer.best->value == 0);
}

TEST_CASE("stages: interrupted before the first trial, in stage one, and before stage two has judged") {
  const auto shop = simulated_by(
      [](const auto& s) -> std::map<std::string, std::optional<double>> {
        return {{"cost_per_part", LongRunModel(s).cost_per_part() + 3}};
      },
      0.1);
  const json scenario = gallery("heavy-lathe.json");
  const Answered at_once(study(), scenario, shop, 0);
  CHECK(at_once.answer.interrupted == "enough");
  CHECK_FALSE(at_once.answer.best);
  CHECK(at_once.answer.baseline_value);
  const Answered early(study(), scenario, shop, 5);
  CHECK(early.answer.interrupted == "enough");
  REQUIRE(early.answer.best);
  CHECK(early.answer.best->stage == "analytic");
  CHECK_FALSE(early.answer.analytic);
  // As many as stage one takes: its answer stands.
  json first = study();
  first.erase("simulation");
  const Answered one(first, scenario, shop);
  const Answered between(study(), scenario, shop, one.trials.at("analytic"));
  CHECK(between.answer.interrupted == "enough");
  REQUIRE(between.answer.best);
  CHECK(between.answer.best->x == one.answer.best->x);
  CHECK(between.answer.best->stage == "analytic");
  // Nothing feasible in stage one: nothing stands.
  json out_of_reach = study();
  out_of_reach["constraints"] = json::parse(R"([{"kpi": "throughput_per_h", "at_least": 100}])");
  first["constraints"] = out_of_reach["constraints"];
  const Answered unmet(first, scenario, shop);
  CHECK_FALSE(unmet.answer.best);
  REQUIRE(unmet.answer.analytic);
  CHECK_FALSE(unmet.answer.analytic->feasible);
  CHECK_FALSE(unmet.answer.baseline_feasible);
  const Answered cut(out_of_reach, scenario, shop, unmet.trials.at("analytic"));
  CHECK(cut.answer.interrupted == "enough");
  CHECK_FALSE(cut.answer.best);
}

TEST_CASE("stages: robust by the mean and by the worst of the samples, in closed form") {
  // The rate of the lathe is uncertain; the speed alone may move: A = r (t0 + tc) + rest is linear in the
  // rate.
  json text = study();
  text.erase("simulation");
  text["variables"].erase(0);
  text["uncertain"] =
      json::parse(R"([{"name": "rate", "pointer": "/machines/0/rate_per_min", "relative": 0.3},
    {"name": "wage", "pointer": "/crews/0/rate_per_min", "relative": 0.1}])");
  text["constraints"] = json::parse(R"([{"kpi": "cost_per_part", "at_most": 200}])");
  const json scenario = gallery("heavy-lathe.json");
  const auto best_at = [&](double rate) {
    json one = text;
    one.erase("uncertain");
    one.erase("robust");
    one.erase("constraints");
    return Answered(one, scenarios::apply(scenario, {{"/machines/0/rate_per_min", rate}}), {}).answer;
  };
  text["robust"] = {{"samples", 24}, {"measure", "mean"}};
  const Answered mean(text, scenario, {});
  // A Latin hypercube of 24: the mean of the rates is that of the middle to 1/24 of the half range at most.
  const auto nominal = best_at(3);
  REQUIRE(mean.answer.best);
  CHECK(mean.answer.best->value == Approx(nominal.best->value).epsilon(0.3 / 24));
  CHECK(mean.answer.best->x[0] == Approx(nominal.best->x[0]).epsilon(0.01));
  text["robust"]["measure"] = "worst";
  const Answered worst(text, scenario, {});
  const auto dearest = best_at(3 * 1.3);
  REQUIRE(worst.answer.best);
  CHECK(worst.answer.best->value <= dearest.best->value * 1.01);
  CHECK(worst.answer.best->value >= best_at(3 * (1.3 - 0.6 / 24)).best->value * 0.99);
  CHECK(worst.answer.best->x[0] > nominal.best->x[0]);
  // A constraint holds in every sample: what the worst costs is the bound.
  text["constraints"][0]["at_most"] = worst.answer.best->value * 0.999;
  CHECK_FALSE(Answered(text, scenario, {}).answer.best);
  text["constraints"][0]["at_most"] = worst.answer.best->value * 1.001;
  CHECK(Answered(text, scenario, {}).answer.best);
  // With simulation the robust plan is where stage two begins.
  text["simulation"] = {{"trials", 6}, {"first_replications", 3}, {"levels", 1}, {"neighbourhood", 0.02}};
  const Answered refined(
      text, scenario,
      simulated_by(
          [](const auto& s) -> std::map<std::string, std::optional<double>> {
            return {{"cost_per_part", 100 + 0.001 * (speed_of(s) - 50) * (speed_of(s) - 50)}};
          },
          0.01));
  REQUIRE(refined.answer.best);
  CHECK(refined.answer.best->x[0] == Approx(refined.answer.analytic->x[0]).margin(2.1));
}

TEST_CASE("stages: a front by simulation alone, and a computed one simulated point by point") {
  // Cost (v - 40)^2, throughput v: every speed above 40 is on the front.
  json text = study();
  text.erase("objective");
  text["variables"].erase(0);
  text["objectives"] =
      json::parse(R"([{"kpi": "cost_per_part"}, {"kpi": "throughput_per_h", "direction": "maximize"}])");
  text["front"] = {{"points", 5}, {"replications", 4}};
  text["simulation"] = {{"trials", 300}, {"first_replications", 3}};
  const auto formula = [](const auto& s) -> std::map<std::string, std::optional<double>> {
    return {{"cost_per_part", 50 + (speed_of(s) - 40) * (speed_of(s) - 40) / 100},
            {"throughput_per_h", speed_of(s)}};
  };
  const Answered a(text, uncovered(), simulated_by(formula, 0.5));
  REQUIRE(a.answer.front);
  const FrontAnswer& front = *a.answer.front;
  REQUIRE(front.points.size() >= 4);
  for (const FrontEstimate& p : front.points) {
    CHECK(p.x[0] >= 40 - 0.5);
    REQUIRE(p.means.size() == 2);
    CHECK(*p.means[0] == Approx(50 + (p.x[0] - 40) * (p.x[0] - 40) / 100).margin(0.6));
    CHECK(*p.means[1] == Approx(p.x[0]).margin(0.6));
    CHECK(*p.half_widths[0] > 0);
    CHECK(p.objectives[1] == Approx(p.x[0]).margin(0.6));
  }
  CHECK(front.points.back().x[0] == Approx(120).margin(0.5));
  CHECK(front.reference[1] <
        front.points.front().objectives[1]);  // worse than the worst, as the user sees it
  CHECK(front.hypervolume > 0);
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->stage == "simulation");
  CHECK(a.answer.best->x == front.points[front.knee].x);
  CHECK(a.trials.at("front") == static_cast<int>(front.points.size()));
  // Of the parabola with the chord the knee is in the middle, where the slope is that of the chord.
  CHECK(front.points[front.knee].x[0] == Approx(80).margin(21));
  // By the long run; nothing is simulated unless asked for.
  text.erase("simulation");
  text["front"] = {{"points", 4}};
  const Answered computed(text, gallery("heavy-lathe.json"), {});
  REQUIRE(computed.answer.front);
  CHECK(computed.answer.front->points.front().means.empty());
  CHECK(computed.answer.best->stage == "analytic");
  CHECK(computed.progress.front().stage == "front");
  // Nothing feasible: no front.
  text["constraints"] = json::parse(R"([{"kpi": "quality_ratio", "at_least": 2}])");
  const Answered none(text, gallery("heavy-lathe.json"), {});
  CHECK_FALSE(none.answer.front);
  CHECK_FALSE(none.answer.best);
}

TEST_CASE("confirmation: better, worse, and not to be told apart, for less or for more") {
  const auto run = [](const std::vector<std::optional<double>>& values) {
    shop::RunResult r;
    r.kpis = {{"cost_per_part", "UAH", ""}};
    for (const auto& v : values) r.values.push_back({v});
    r.estimates = {shop::estimate(values)};
    return r;
  };
  StudySpec spec = load_study(gallery("heavy-lathe.study.json"));
  spec.confirmation.confidence = 0.9;
  const auto dear = run({10, 12, 11});
  const auto cheap = run({7, 10, 8});
  const auto saving = confirm(spec, dear, cheap);
  CHECK(saving.verdict == "better");
  // Pairs 3, 2, 3: mean 8/3, standard error 1/3, t(0.95, 2) = 2.92.
  CHECK(*saving.saving.mean == Approx(8.0 / 3));
  CHECK(*saving.saving.half_width == Approx(2.91999 / 3).epsilon(1e-4));
  CHECK(confirm(spec, cheap, dear).verdict == "worse");
  CHECK(confirm(spec, dear, dear).verdict == "not distinguishable");
  CHECK(confirm(spec, dear, run({9, 13, 11})).verdict == "not distinguishable");
  CHECK(confirm(spec, run({10, std::nullopt}), run({9, 12})).verdict == "not distinguishable");
  CHECK(confirm(spec, run({std::nullopt, std::nullopt}), run({9, 12})).verdict == "not distinguishable");
  spec.objective.direction = Direction::maximize;
  CHECK(confirm(spec, dear, cheap).verdict == "worse");
  CHECK(confirm(spec, cheap, dear).verdict == "better");
  CHECK_THROWS_AS(confirm(spec, dear, run({1, 2})), std::invalid_argument);
  // Fresh numbers: another seed, the replications asked for.
  const auto changes = confirmation_changes(spec, 5);
  REQUIRE(changes.size() == 2);
  CHECK(changes[0].value == json(std::to_string(stage_seed(5, "confirmation"))));
  CHECK(changes[1].value == json(40));
  CHECK(stage_seed(5, "confirmation") != stage_seed(5, "choice"));
  CHECK(stage_seed(5, "confirmation") != stage_seed(6, "confirmation"));
}
