// Money of rare events, booked once and in full: found by seeded faults (tools/mutate.mjs).
#include "tests/shop/small_shop.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;

TEST_CASE("every failure of a machine costs its damage", "[shop][money]") {
  json shop = small_shop(always(), constant(10));
  shop["simulation"] = {{"horizon_min", 1000}, {"replications", 1}};
  shop["machines"][0]["failures"] = {
      {{"name", "trip"}, {"time_to_failure", constant(15)}, {"repair", constant(5)}, {"damage", 40}}};
  const auto result = run(shop);
  const double failures = mean(result, "machine/m/failures/trip");
  CHECK(failures == 50);
  CHECK(mean(result, "cost/damage") * mean(result, "parts_good") == Approx(40 * failures).epsilon(1e-12));
}

TEST_CASE("a rejected lot that is treated costs the treatment of each of its inserts", "[shop][money]") {
  const auto run_lots = [](double retreat_cost) {
    return run_cell(
        {fmt::format(
             R"(/inserts/0/lots={{"lot_size":10,"ln_sd_between":0.4,"ln_sd_within":0.35,"sample_size":5,)"
             R"("test_correlation":0.95,"reject_fraction":0.25,"test_cost":3,"rejected":"retreat",)"
             R"("retreat_life_factor":1.5,"retreat_cost":{}}})",
             retreat_cost),
         "/simulation/horizon_min=40000", "/simulation/warmup_min=0", "/simulation/replications=2"});
  };
  const auto free = run_lots(0);
  const auto paid = run_lots(6);
  const auto at = [](const shop::RunResult& run, const std::string& kpi, std::size_t replication) {
    const auto k = run.index_of(kpi);
    INFO(kpi);
    REQUIRE(k);
    return *run.values[replication][*k];
  };
  for (std::size_t r = 0; r < 2; ++r) {
    const double parts = at(paid, "parts_good", r);
    const double rejected = at(paid, "insert/insert/lots/rejected", r);
    CHECK(rejected > 10);
    CHECK(at(free, "insert/insert/lots/rejected", r) == rejected);
    CHECK((at(paid, "cost/inserts", r) - at(free, "cost/inserts", r)) * parts ==
          Approx(6 * 10 * rejected).epsilon(1e-9));
  }
}

TEST_CASE("maintenance by condition renews what is worn beyond the threshold, at once when there is none",
          "[shop][money]") {
  // The failure comes after 100 min of operation, the maintenance looks every 60: with threshold 0 it renews
  // whatever is seen, and nothing ever fails; with a threshold of 0.9 it never finds enough wear at 60 of
  // 100.
  const auto failures = [](double threshold, double seen) {
    json shop = small_shop(always(), constant(1));
    shop["simulation"] = {{"horizon_min", 10'000}, {"replications", 1}};
    shop["machines"][0]["failures"] = {
        {{"name", "belt"}, {"time_to_failure", constant(100)}, {"repair", constant(5)}}};
    shop["machines"][0]["maintenance"] = {{{"name", "look"},
                                           {"clock", "operating"},
                                           {"interval", 60},
                                           {"duration", constant(1)},
                                           {"renews", {"belt"}},
                                           {"condition_threshold", threshold},
                                           {"detection_probability", seen}}};
    return mean(run(shop), "machine/m/failures/belt");
  };
  CHECK(failures(0, 0.01) == 0);
  CHECK(failures(0.5, 1) == 0);
  CHECK(failures(0.9, 1) > 50);
}
