// Derivatives of the long run against central differences of it, and what the searches make of them.
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "models/reliability/k117_rational_reliability.h"
#include "tests/optimize/studies.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

namespace {

struct Moved {
  const char* name;
  const char* pointer;
  double low, high;
};
// Every way in which a number enters the long run: strategy, regime, life, money, time, probability.
const std::vector<Moved> moved{
    {"gamma", "/tools/0/strategy/gamma", 0.2, 0.95},
    {"speed", "/operations/0/process/cutting_speed_m_min", 40, 90},
    {"feed", "/operations/0/process/feed_mm_rev", 0.5, 1.4},
    {"depth", "/operations/0/process/depth_of_cut_mm", 4, 14},
    {"length", "/operations/0/process/length_mm", 500, 1500},
    {"mean life", "/inserts/0/edge_life/mean_ref_min", 30, 90},
    {"exponent", "/inserts/0/edge_life/speed_exponent", 3, 6},
    {"scatter", "/inserts/0/edge_life/cv", 0.3, 0.9},
    {"price", "/inserts/0/price", 20, 200},
    {"reserve", "/inserts/0/reserve_ok_probability", 0.3, 0.95},
    {"single", "/inserts/0/single_edge_probability", 0.05, 0.5},
    {"rate", "/machines/0/rate_per_min", 1, 6},
    {"wage", "/crews/0/rate_per_min", 0.2, 1},
    {"positioning", "/tools/0/change/positioning_min", 0.5, 4},
    {"extra", "/tools/0/change/failure_extra_min", 1, 20},
    {"indexing", "/tools/0/change/index/rate_per_min", 0.1, 0.9},
    {"damage", "/tools/0/failure_damage", 10, 100},
    {"scrap", "/tools/0/failure_scrap_probability", 0.01, 0.2},
    {"value", "/parts/0/value", 200, 2000},
    {"spindle life", "/machines/0/failures/0/time_to_failure/rate_per_min", 1e-4, 1e-3},
    {"repair", "/machines/0/failures/0/repair/value_min", 30, 300}};

json lathe_shop(const std::string& law, const std::string& strategy, bool second_machine) {
  json s = gallery("heavy-lathe.json");
  s["inserts"][0]["edge_life"]["law"] = law;
  if (law == "normal") s["inserts"][0]["edge_life"]["cv"] = 0.4;
  s["inserts"][0]["edges"] = 4;
  s["inserts"][0]["reserve_ok_probability"] = 0.7;
  s["inserts"][0]["single_edge_probability"] = 0.1;
  s["tools"][0]["insert_booking"] = "at_fitting";
  s["tools"][0]["strategy"] = {{"kind", strategy}, {"gamma", 0.5}};
  s["machines"][0]["failures"] = json::parse(R"([{"name": "spindle", "scrap_probability": 0.2, "damage": 40,
    "time_to_failure": {"kind": "exponential", "rate_per_min": 0.0005}, "repair": {"kind": "constant", "value_min": 120}}])");
  if (second_machine) {
    s["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}});
    s["operations"].push_back(json::parse(
        R"({"name": "milling", "machine": "mill", "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 25}}})"));
    s["parts"][0]["route"] = {"rough turning", "milling"};
  }
  return s;
}

json study_of(const std::vector<Moved>& variables) {
  json study = gallery("heavy-lathe.study.json");
  study["variables"] = json::array();
  for (const Moved& m : variables)
    study["variables"].push_back(
        {{"name", m.name}, {"pointer", m.pointer}, {"low", m.low}, {"high", m.high}});
  study["constraints"] = json::parse(R"([{"kpi": "throughput_per_h", "at_least": 2},
    {"kpi": "tool/roughing tool/inserts_per_100_parts", "at_most": 30}, {"kpi": "load/lathe", "at_most": 2},
    {"operation": "rough turning", "quantity": "main_time_min", "at_most": 30},
    {"function": "K117.mean_life_for_regime", "output": "mean_min", "at_least": 20,
     "inputs": {"V": {"pointer": "/operations/0/process/cutting_speed_m_min"}}}])");
  return study;
}

}  // namespace

TEST_CASE("derivatives of the long run are those of central differences") {
  struct Case {
    std::string law, strategy;
    bool second_machine;
  };
  for (const Case& c :
       {Case{"weibull", "age", false}, Case{"normal", "age", true}, Case{"exponential", "age", false},
        Case{"weibull", "run_to_failure", true}, Case{"weibull", "block", false}}) {
    INFO(c.law << " " << c.strategy);
    std::vector<Moved> variables = moved;
    json scenario = lathe_shop(c.law, c.strategy, c.second_machine);
    if (c.strategy == "run_to_failure") {
      scenario["tools"][0]["strategy"].erase("gamma");
      variables.erase(variables.begin());
    }
    std::erase_if(variables, [&](const Moved& m) {
      return m.name == std::string("scatter") && c.law != "weibull";  // the others have none, or bounds
    });
    const StudySpec study = load_study(study_of(variables));
    Problem problem(study, scenario);
    const bool slow = c.strategy == "block";  // renewal functions take milliseconds
    int properties = 0;
    verstat::test::property("slopes", [&] {
      if (slow && ++properties > 5) return;
      std::vector<double> x;
      for (const Moved& m : variables)
        x.push_back(m.low + (m.high - m.low) * *rc::gen::inRange(50, 950) / 1000.0);
      const auto slopes = problem.slopes(x);
      RC_ASSERT(slopes.has_value());
      const auto at = problem.evaluate(x);
      for (std::size_t k = 0; k < x.size(); ++k) {
        const double h = (slow ? 1e-3 : 1e-5) * (variables[k].high - variables[k].low);
        std::vector<double> up = x;
        std::vector<double> down = x;
        up[k] += h;
        down[k] -= h;
        const auto high = problem.evaluate(up);
        const auto low = problem.evaluate(down);
        const double width = variables[k].high - variables[k].low;
        // Slopes over the whole width of the variable, as shares of what stands there.
        const auto same = [&](double exact, double above, double below, double here) {
          const double scale = std::max(std::abs(here), 0.1);
          return std::abs(exact - (above - below) / (2 * h)) * width < (slow ? 1e-3 : 2e-6) * scale;
        };
        if (!same(slopes->objectives[0][k], high.objectives[0], low.objectives[0], at.objectives[0]))
          RC_FAIL(fmt::format("{}: {} instead of {}", variables[k].name, slopes->objectives[0][k],
                              (high.objectives[0] - low.objectives[0]) / (2 * h)));
        for (std::size_t m = 0; m < at.margins.size(); ++m)
          if (!same(slopes->margins[m][k], high.margins[m], low.margins[m], at.margins[m]))
            RC_FAIL(fmt::format("{} of {}: {} instead of {}", variables[k].name, problem.conditions()[m].name,
                                slopes->margins[m][k], (high.margins[m] - low.margins[m]) / (2 * h)));
      }
    });
  }
}

TEST_CASE("what is read by the formulas needs no differences at all") {
  // The answer is exact to rounding, which no difference of doubles is.
  const StudySpec study = load_study(gallery("heavy-lathe.study.json"));
  Problem problem(study, gallery("heavy-lathe.json"));
  const std::vector<double> x{0.47, 46.97};
  const Look look = problem.look(x);
  // In the speed: A = t0 (E + q / T), t0 ~ 1/V, 1/T ~ V^5. So dA/dV = (-A + 5 t0 q/T) / V.
  const double machining = 3 * look.long_run->plans[0].main_time_min;
  const double edges = look.objectives[0] - machining;
  const double exact = (-look.objectives[0] + 5 * edges) / x[1];
  CHECK(problem.slopes(x)->objectives[0][1] == Approx(exact).epsilon(1e-11).margin(1e-11));
}

TEST_CASE("gradient algorithms need fewer evaluations with exact slopes, and find the same optimum") {
  const StudySpec study = load_study(gallery("heavy-lathe.study.json"));
  Problem problem(study, gallery("heavy-lathe.json"));
  for (const char* algorithm : {"LD_SLSQP", "LD_MMA", "LD_CCSAQ"}) {
    INFO(algorithm);
    const auto measure = [&](const std::vector<double>& x) { return measured(problem.evaluate(x)); };
    SearchOptions options{.algorithm = algorithm, .max_evaluations = 4000};
    const SearchResult differences = minimize(measure, {{0.05, 0.98}, {20, 120}}, {0.64, 60}, options);
    options.slopes = [&](const std::vector<double>& x) { return measured(problem.slopes(x)); };
    const SearchResult exact = minimize(measure, {{0.05, 0.98}, {20, 120}}, {0.64, 60}, options);
    CHECK(exact.measured.value ==
          Approx(models::k117::joint_speed_gamma_optimum({}).part_cost).epsilon(1e-8));
    CHECK(exact.measured.value == Approx(differences.measured.value).epsilon(1e-8));
    CHECK(exact.evaluations < differences.evaluations / 2);
  }
}
