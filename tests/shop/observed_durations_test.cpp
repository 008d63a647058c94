// Durations given as the observed values themselves, and tool lives of every law, in a shop.
#include <cmath>

#include "operations/duration.h"
#include "scenarios/input_error.h"
#include "sim/shop/durations.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

json observed(const json& values, const json& weights = json::array(), const char* between = "linear") {
  json time = {{"kind", "empirical"}, {"values_min", values}, {"between", between}};
  if (!weights.empty()) time["weights"] = weights;
  return time;
}

std::string why(const json& scenario) {
  try {
    static_cast<void>(scenarios::load(scenario));
  } catch (const scenarios::InputError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an observed duration has the mean that plans are made with", "[shop][long]") {
  using operations::BetweenValues;
  using operations::EmpiricalDuration;
  for (const EmpiricalDuration& d : {EmpiricalDuration{{3, 1, 2, 9}, {}, BetweenValues::linear},
                                     EmpiricalDuration{{3, 1, 2, 9}, {}, BetweenValues::step},
                                     EmpiricalDuration{{3, 1, 2, 9}, {1, 5, 0, 0.5}, BetweenValues::linear},
                                     EmpiricalDuration{{3, 1, 2, 9}, {1, 5, 0, 0.5}, BetweenValues::step},
                                     EmpiricalDuration{{4, 4, 4}, {}, BetweenValues::linear}}) {
    const sim::Distribution law = shop::law_of(d);
    CHECK(law.mean() == Approx(operations::mean_min(d)).epsilon(1e-14));
  }
  CHECK(operations::mean_min(EmpiricalDuration{{1, 2, 6}, {}, BetweenValues::step}) == Approx(3));
  CHECK(operations::mean_min(EmpiricalDuration{{1, 2, 6}, {}, BetweenValues::linear}) == Approx(2.75));
}

TEST_CASE("a machine with observed cycle times makes one part per mean of them", "[shop][long]") {
  for (const char* between : {"linear", "step"}) {
    const json time = observed({2, 2.2, 5, 7}, {50, 30, 15, 5}, between);
    const shop::RunResult result = run(small_shop(always(), time));
    const sim::Distribution law = shop::law_of(
        operations::EmpiricalDuration{{2, 2.2, 5, 7},
                                      {50, 30, 15, 5},
                                      std::string(between) == "step" ? operations::BetweenValues::step
                                                                     : operations::BetweenValues::linear});
    const shop::Estimate made = kpi(result, "throughput_per_h");
    REQUIRE(made.mean);
    REQUIRE(made.half_width);
    INFO(between << " " << *made.mean << " +- " << *made.half_width << " of " << 60 / law.mean());
    CHECK(std::abs(*made.mean - 60 / law.mean()) < 3 * *made.half_width);
  }
}

TEST_CASE("an observed duration that says nothing is refused at its place", "[shop][long]") {
  const auto error = [](const json& time) { return why(small_shop(always(), time)); };
  CHECK_THAT(error(observed({2})), Catch::Contains("/operations/0/process/time/values_min"));
  CHECK_THAT(error(observed({2, -1})), Catch::Contains("/operations/0/process/time/values_min/1"));
  CHECK_THAT(error(observed({2, 3}, {1})),
             Catch::Contains("/operations/0/process/time/weights") && Catch::Contains("2 values"));
  CHECK_THAT(error(observed({2, 3}, {1, 0})), Catch::Contains("/operations/0/process/time/weights"));
  CHECK_THAT(error(observed({2, 3}, {}, "spline")), Catch::Contains("\"linear\", \"step\""));
  CHECK_THAT(why(small_shop(arrivals(observed({0, 0}, {}, "step")), constant(1))),
             Catch::Contains("/parts/0/supply/time"));
  CHECK(error(observed({2, 3, 3})).empty());
}

TEST_CASE("tool lives of every law: failures and changes as renewal reward says", "[shop][long]") {
  for (const char* law : {"lognormal", "gamma"}) {
    json scenario = scenarios_of("heavy-lathe");
    json& life = scenario["inserts"][0]["edge_life"];
    life["law"] = law;
    life["cv"] = 0.6;
    scenario["tools"][0]["strategy"] = {{"kind", "age"}, {"gamma", 0.6}};
    scenario["simulation"] = {
        {"horizon_min", 400'000}, {"warmup_min", 20'000}, {"replications", 6}, {"seed", "5"}};
    const shop::RunResult result = run(scenario);
    const std::string tool = "tool/" + scenario["tools"][0]["name"].get<std::string>();
    const double failures = mean(result, tool + "/failures");
    const double planned = mean(result, tool + "/planned_changes");
    // Changed at the age that 60 % survive, so 40 % of the edges fail before.
    INFO(law << " " << failures << " " << planned);
    CHECK(failures / (failures + planned) == Approx(0.4).margin(0.01));
  }
}
