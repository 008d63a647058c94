// Forbidden bands that an optimum must keep out of, and the reasons why a shop leaves the textbook's optimum.
#include <cmath>

#include <catch2/catch.hpp>

#include "optimize/analysis.h"
#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;
using verstat::test::Studied;

TEST_CASE(
    "forbidden feeds, depths (K107) and speeds of the spindle (K201) keep the optimum out, on its best "
    "side") {
  const json file = gallery("operations/hard_turning_machine.json");
  json shop = gallery("heavy-lathe.json");
  shop["operations"][0]["process"] = file["process"];
  // Nothing but the constraint keeps the feed out of the band.
  shop["operations"][0]["process"]["clash_scrap_probability"] = 0.0;
  shop["inserts"][0]["edge_life"] = file["edge_life"];
  shop["machines"][0]["limits"] = file["machine_limits"];
  shop["machines"][0]["spindle"] = file["spindle"];
  json study = gallery("heavy-lathe.study.json");
  study["variables"] = json::parse(R"([
    {"name": "feed", "pointer": "/operations/0/process/feed_mm_rev", "low": 0.1, "high": 0.38},
    {"name": "speed", "pointer": "/operations/0/process/cutting_speed_m_min", "low": 100, "high": 180}])");
  const Studied free(study, shop);
  study["constraints"] = json::parse(R"([{"operation": "rough turning", "bands": "all"}])");
  const Studied kept(study, shop);
  REQUIRE(free.answer.best);
  REQUIRE(kept.answer.best);
  // Brute force over both knobs.
  scenarios::Scenario s = scenarios::load(shop);
  double* feed = models::locate_in_fields(&s, scenarios::scenario_fields(),
                                          pointer_tokens("/operations/0/process/feed_mm_rev"));
  double* speed = models::locate_in_fields(&s, scenarios::scenario_fields(),
                                           pointer_tokens("/operations/0/process/cutting_speed_m_min"));
  REQUIRE(feed != nullptr);
  REQUIRE(speed != nullptr);
  const LongRunModel model(s);
  const auto inside = [&] {
    const auto plan = scenarios::plan(s, s.operations[0]);
    return std::any_of(plan.bands.begin(), plan.bands.end(), [](const auto& b) { return b.inside(); });
  };
  double least = 1e300;
  double least_free = 1e300;
  for (*feed = 0.1; *feed <= 0.38; *feed += 0.005)
    for (*speed = 100; *speed <= 180; *speed += 2) {
      const double cost = model.cost_per_part();
      least_free = std::min(least_free, cost);
      if (!inside()) least = std::min(least, cost);
    }
  *feed = free.answer.best->x[0];
  *speed = free.answer.best->x[1];
  CHECK(inside());  // or the constraint would say nothing
  *feed = kept.answer.best->x[0];
  *speed = kept.answer.best->x[1];
  const auto plan = scenarios::plan(s, s.operations[0]);
  for (const auto& band : plan.bands) {
    const double rounding = 1e-6 * (band.high - band.low);
    CHECK((band.value <= band.low + rounding || band.value >= band.high - rounding));
  }
  CHECK(kept.answer.best->value <= least * (1 + 1e-6));
  CHECK(kept.answer.best->value > least * 0.98);  // the grid is not far off
  CHECK(free.answer.best->value <= least_free * (1 + 1e-6));
  CHECK(kept.answer.best->value > free.answer.best->value);
}

TEST_CASE("one cut against the shop: bottleneck, crew, stock, demand and failures are told apart") {
  const auto why = [](json shop, double speed, bool simulate = true) {
    shop["operations"][0]["process"]["cutting_speed_m_min"] = speed;
    shop["simulation"] = {{"horizon_min", 20'000}, {"warmup_min", 1000}, {"replications", 2}, {"seed", "1"}};
    const auto s = scenarios::load(shop);
    std::optional<shop::RunResult> run;
    if (simulate) run = shop::run_scenario(s, 2);
    const auto cuts = one_cut_optima(s, run ? &*run : nullptr);
    REQUIRE(cuts.size() == 1);
    return cuts[0].why;
  };
  json alone = gallery("heavy-lathe.json");
  alone["crews"][0]["members"] = 2;
  CHECK(why(alone, 50).starts_with("failures: "));
  CHECK(why(alone, 67) == "between smallest cost and largest rate");
  json busy_setter = gallery("heavy-lathe.json");
  busy_setter["machines"][0]["count"] = 6;
  CHECK(why(busy_setter, 55).starts_with("crew: "));
  CHECK(why(busy_setter, 55).find("it waits for setter") != std::string::npos);
  // A mill behind the lathes that is slower, then one that is faster.
  const auto with_mill = [&](double minutes) {
    json line = alone;
    line["machines"].push_back({{"name", "mill"}, {"rate_per_min", 2.0}});
    line["operations"].push_back(
        {{"name", "milling"},
         {"machine", "mill"},
         {"process", {{"kind", "duration"}, {"time", {{"kind", "constant"}, {"value_min", minutes}}}}}});
    line["parts"][0]["route"] = {"rough turning", "milling"};
    return line;
  };
  CHECK(why(with_mill(5), 70).starts_with("bottleneck: lathe limits the shop"));
  json blocked = with_mill(40);
  blocked["machines"][1]["queue_capacity"] = 1;
  CHECK(why(blocked, 50).starts_with("stock: "));
  CHECK(why(blocked, 50).find("no room behind it") != std::string::npos);
  json few_orders = alone;
  few_orders["parts"][0]["supply"] = {{"kind", "interarrival"},
                                      {"time", {{"kind", "exponential"}, {"rate_per_min", 0.03}}}};
  CHECK(why(few_orders, 50).starts_with("demand: lathe has"));
  CHECK(why(few_orders, 50, false).starts_with("demand: lathe has"));
}
