// Gauges wear with every part they check (K307): risks, changes, time and cost in the shop.
#include "operations/kinds/gauge_inspection.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

/// Parts come from "o", a tenth of them defective; gauges check every one on "bench".
json gauged(const json& change) {
  json gauge =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/gauge_inspection.json")
          .at("process");
  gauge["distance_sigma_mm"] = 0.15;  // a poor process: both risks large enough to count
  gauge.erase("producer_risk_max");
  gauge.update(change);
  json shop = small_shop(always(), constant(1));
  shop["operations"][0]["quality"] = {{"defect_probability", 0.1}};
  shop["machines"].push_back({{"name", "bench"}, {"rate_per_min", 2}});
  shop["operations"].push_back({{"name", "gauge"}, {"machine", "bench"}, {"process", gauge}});
  shop["parts"][0]["route"] = {"o", "gauge"};
  shop["parts"][0]["escape_cost"] = 100;
  return shop;
}

const std::string at = "machine/bench/gauge/gauge/";

/// Risks of the card for gauges worn so far.
operations::Detection card(json shop, double worn) {
  shop["operations"][1]["process"]["worn_now"] = worn;
  const auto s = scenarios::load(shop);
  return *scenarios::plan(s, s.operations[1]).detection;
}

}  // namespace

TEST_CASE("new gauges reject good parts as the card says, gauges beyond the limit pass bad ones",
          "[gauge][K307][long]") {
  // So little wear that the gauges stay as they are.
  const json fresh = gauged({{"wear_per_check_um", 1e-6}});
  const auto r = run(fresh);
  const double producer = 1 - card(fresh, 0).specificity;
  CHECK(producer > 0.003);
  check_truth(r, at + "producer_risk", producer, 0.2);
  CHECK(mean(r, at + "consumer_risk") == 0);
  CHECK(mean(r, at + "changes") == 0);
  CHECK(mean(r, "part/p/escape_ratio") == 0);
  check_truth(r, "quality_ratio", 0.9 * (1 - producer), 0.01);

  const json worn = gauged({{"wear_per_check_um", 1e-6}, {"worn_now", 2.5}, {"replace_at_wear", 3}});
  const auto w = run(worn);
  const double consumer = 1 - card(worn, 2.5).sensitivity;
  CHECK(consumer > 0.01);
  check_truth(w, at + "consumer_risk", consumer, 0.2);
  CHECK(mean(w, at + "producer_risk") == 0);
  check_truth(w, "part/p/escape_ratio", 0.1 * consumer / (0.9 + 0.1 * consumer), 0.2);
  CHECK(mean(w, at + "worn") == Approx(2.5).margin(0.01));
}

TEST_CASE("gauges wear by the parts they check and are replaced at their limit, with time and cost",
          "[gauge][K307][long]") {
  // 14 um to wear at 0.05 um a check: 280 checks.
  const json shop = gauged({{"wear_per_check_um", 0.05}, {"replace_min", 3}, {"gauge_cost", 150}});
  const auto s = scenarios::load(shop);
  const auto plan = scenarios::plan(s, s.operations[1]);
  REQUIRE(*plan.value_of("gauge_life_checks") == 280);
  const auto r = run(shop);
  const double checks = mean(r, at + "checks");
  const double changes = mean(r, at + "changes");
  CHECK(checks == Approx(100'000).epsilon(0.001));  // one part a minute
  CHECK(std::abs(changes - checks / 280) <= 1);
  CHECK(mean(r, "machine/bench/state/planned_change") == Approx(3 * changes / 100'000).epsilon(1e-6));
  CHECK(mean(r, "cost/planned_change") == Approx(2 * 3 * changes / checks).epsilon(0.01));
  CHECK(mean(r, "cost/operations") == Approx(150 * changes / checks).epsilon(0.01));
  CHECK(mean(r, at + "mean_worn") == Approx(0.5).margin(0.005));
  // Over its life the gauge errs as the plan says on average.
  check_truth(r, at + "producer_risk", *plan.value_of("producer_risk"), 0.3);
  CHECK(mean(r, at + "consumer_risk") == 0);
  check_audit(shop);

  // Used to twice the allowance: half of the changes, and defective parts pass in the second half of each
  // life.
  const json longer = gauged({{"wear_per_check_um", 0.05}, {"replace_at_wear", 2}});
  const auto l = run(longer);
  const auto ls = scenarios::load(longer);
  const auto on_average = scenarios::plan(ls, ls.operations[1]);
  CHECK(mean(l, at + "changes") == Approx(changes / 2).epsilon(0.01));
  check_truth(l, at + "consumer_risk", *on_average.value_of("consumer_risk"), 0.3);
  CHECK(mean(l, "part/p/escape_ratio") > 0);
}

TEST_CASE("what is not looked at wears no gauge, and each station has gauges of its own",
          "[gauge][K307][long]") {
  json sampled = gauged({{"wear_per_check_um", 0.05}});
  sampled["operations"][1]["inspection"] = {{"share", 0.25}};
  const auto r = run(sampled);
  check_truth(r, at + "checks", 25'000, 0.05);
  CHECK(mean(r, at + "changes") == Approx(25'000.0 / 280).epsilon(0.05));
  json two = gauged({{"wear_per_check_um", 0.05}, {"check_min", 1.6}});
  two["machines"][1]["count"] = 2;
  const auto both = run(two);
  const double first = mean(both, "machine/bench 1/gauge/gauge/checks");
  const double second = mean(both, "machine/bench 2/gauge/gauge/checks");
  CHECK(first + second == Approx(100'000).epsilon(0.001));
  CHECK(std::abs(mean(both, "machine/bench 1/gauge/gauge/changes") - first / 280) <= 1);
  CHECK(std::abs(mean(both, "machine/bench 2/gauge/gauge/changes") - second / 280) <= 1);
}

TEST_CASE("states of a gauge between the nodes of its plan are those of the card", "[gauge][K307][long]") {
  const json shop = gauged({{"replace_at_wear", 2}});
  const auto s = scenarios::load(shop);
  const auto gauge = *scenarios::plan(s, s.operations[1]).gauge;
  CHECK(gauge.wear_per_check == Approx(0.002 / 14));
  for (double worn = 0; worn <= 2; worn += 0.037) {
    const auto exact = card(shop, worn);
    const auto table = gauge.at(worn);
    INFO(worn);
    CHECK(table.specificity == Approx(exact.specificity).margin(2e-5));
    CHECK(table.sensitivity == Approx(exact.sensitivity).margin(2e-4));
  }
}
