// The ten criteria of K205 as KPIs: each against the card's function on what the run itself reports.
#include "models/criteria/k205_hierarchical_efficiency.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;
namespace k205 = models::k205;

namespace {

constexpr double price = 60;

json judged_shop() {
  json shop = small_shop(always(), constant(1));
  shop["simulation"]["horizon_min"] = 210'000;
  shop["operations"][0]["quality"] = {{"defect_probability", 0.1}};
  shop["crews"] = {{{"name", "fitter"}, {"rate_per_min", 0.5}}};
  shop["machines"][0]["rate_per_min"] = 4;
  shop["machines"][0]["failures"] = {{{"name", "spindle"},
                                      {"clock", "calendar"},
                                      {"time_to_failure", exponential(900)},
                                      {"repair", constant(30)},
                                      {"crew", "fitter"},
                                      {"damage", 20}}};
  shop["machines"].push_back({{"name", "desk"}, {"rate_per_min", 2}});
  shop["operations"].push_back({{"name", "look"},
                                {"machine", "desk"},
                                {"process", duration_process(constant(0.5))},
                                {"inspection", {{"sensitivity", 0.8}, {"specificity", 0.95}}},
                                {"cost", 0.4}});
  shop["parts"][0]["route"] = {"o", "look"};
  shop["parts"][0]["value"] = 10;
  shop["parts"][0]["price"] = price;
  shop["parts"][0]["escape_cost"] = 40;
  shop["criteria"] = {{"mission_min", 500}, {"operator_load_limit", 0.5}};
  return shop;
}

/// KPI of one replication.
double value(const shop::RunResult& r, std::size_t replication, const std::string& kpi) {
  INFO(kpi);
  const auto k = r.index_of(kpi);
  REQUIRE(k);
  REQUIRE(r.values[replication][*k]);
  return *r.values[replication][*k];
}

}  // namespace

TEST_CASE("criteria of information, yield and inspection follow from detection", "[shop][K205][long]") {
  const auto r = run(judged_shop());
  // Of 1000 parts 100 are defective: 80 found; of the good ones 45 rejected.
  const k205::Diagnosis d{
      .defect_rejected = 80, .defect_accepted = 20, .good_rejected = 45, .good_accepted = 855};
  check_truth(r, "criteria/e01", k205::criterion_information_ratio(d).efficiency, 0.05);
  check_truth(r, "criteria/e02", 0.95, 0.01);
  // No waiting at the desk: time taken is time planned.
  check_truth(r, "criteria/e08", k205::criterion_information_ratio(d).efficiency, 0.05);
  const double inspection_cost = 0.5 * 2 + 0.4;
  check_truth(r, "criteria/e10", 0.935 / inspection_cost, 0.02);
  check_truth(r, "criteria/e05", k205::criterion_information_ratio(d).obtained_bit / inspection_cost, 0.05);
}

TEST_CASE("criteria of cost, reliability and economy are those of the run's own quantities",
          "[shop][K205][long]") {
  const json shop = judged_shop();
  const auto r = run(shop);
  for (std::size_t n = 0; n < 3; ++n) {
    const double good = value(r, n, "parts_good");
    const double scrapped = value(r, n, "parts_scrapped");
    const double escaped = good * value(r, n, "part/p/escape_ratio");
    const double total = value(r, n, "cost_per_part") * (good + scrapped);
    double losses = 0;
    for (const char* heading : {"scrap", "escapes", "damage", "repair", "waiting_repair"})
      losses += value(r, n, std::string("cost/") + heading) * (good + scrapped);
    const double output = price * (good - escaped);
    const double e09 = k205::criterion_economic({output, total - losses, losses}).efficiency;
    CHECK(value(r, n, "criteria/e09") == Approx(e09));
    // Nearly every part that was started has been finished.
    const double part_cost = (total - losses) / (good + scrapped);
    CHECK(value(r, n, "criteria/e03") ==
          Approx(k205::criterion_cost_per_conforming({part_cost, (good - escaped) / good}).cost_cu)
              .epsilon(1e-3));
    CHECK(value(r, n, "criteria/e04") == Approx(part_cost / (1 - escaped / (good + scrapped))).epsilon(1e-3));
    double production = 0;
    double planned = 0;
    double made = 0;
    double kept = 0;
    for (const char* machine : {"m", "desk"}) {
      const std::string at = std::string("machine/") + machine + "/";
      const double working = value(r, n, at + "state/working");
      production += working;
      planned += working * value(r, n, at + "effectiveness");
      const double parts = std::string(machine) == "m" ? 1.0 : value(r, n, at + "quality_ratio");
      made += 1;
      kept += parts;
    }
    const double technical = production / 2 * (planned / production) * (kept / made);
    const double load = value(r, n, "crew/fitter/utilization");
    const double e06 = k205::criterion_socio_ergonomic({technical, 1 - load / 0.5, e09}).efficiency;
    CHECK(value(r, n, "criteria/e06") == Approx(e06).epsilon(1e-3));
    // Cost of a machine's 500 minutes over the chance that they pass without a failure.
    const double missions = 2 * 400;
    const double failures = value(r, n, "machine/m/failures/spindle");
    const double e07 = value(r, n, "criteria/e07");
    const double passing = total / missions / e07;
    CHECK(passing < 1);
    CHECK(passing >= 1 - failures / missions);  // some windows have more than one
  }
  // Half of the windows are the desk's, which never fails; the others pass with exp(-500/900), up to repairs
  // and the life that starts anew after them.
  double passing = 0;
  for (std::size_t n = 0; n < 10; ++n)
    passing += value(r, n, "cost_per_part") * (value(r, n, "parts_good") + value(r, n, "parts_scrapped")) /
               800 / value(r, n, "criteria/e07") / 10;
  CHECK(passing == Approx(0.5 + 0.5 * std::exp(-500.0 / 930)).epsilon(0.03));
}

TEST_CASE("without an inspection nothing is found out, without parts nothing is judged",
          "[shop][K205][long]") {
  json shop = judged_shop();
  shop["parts"][0]["route"] = {"o"};
  shop["operations"].erase(1);
  shop["machines"].erase(1);
  const auto r = run(shop);
  CHECK(mean(r, "criteria/e01") == Approx(0).margin(1e-12));
  CHECK(mean(r, "criteria/e02") == 1);
  CHECK_FALSE(kpi(r, "criteria/e05").mean);
  CHECK_FALSE(kpi(r, "criteria/e08").mean);
  CHECK_FALSE(kpi(r, "criteria/e10").mean);
  shop["parts"][0]["supply"] = arrivals(constant(1e8));
  const auto nothing = run(shop);
  CHECK_FALSE(kpi(nothing, "criteria/e01").mean);
  CHECK_FALSE(kpi(nothing, "criteria/e09").mean);
}

TEST_CASE("the hierarchy of the criteria is a KPI, with its limits", "[shop][K205][long]") {
  json shop = judged_shop();
  shop["criteria"]["best"] = {{"e01", 1}, {"e02", 1}, {"e09", 0.9}};
  shop["criteria"]["worst"] = {{"e01", 0}, {"e02", 0.5}, {"e09", 0}};
  shop["criteria"]["group_weights"] = {{"economy", 3}};
  shop["criteria"]["minimum"] = {{"e09", 0.05}};
  const auto r = run(shop);
  for (std::size_t n = 0; n < 3; ++n) {
    // Information: mean of two normalized values; globally a product with weights 1 and 3 of 4.
    const double information = (value(r, n, "criteria/e01") + (value(r, n, "criteria/e02") - 0.5) / 0.5) / 2;
    const double economy = value(r, n, "criteria/e09") / 0.9;
    CHECK(value(r, n, "criteria/efficiency") ==
          Approx(std::pow(information, 0.25) * std::pow(economy, 0.75)));
    CHECK(value(r, n, "criteria/feasible") == 1);
  }
  shop["criteria"]["minimum"]["e09"] = 0.99;
  CHECK(mean(run(shop), "criteria/feasible") == 0);

  const auto refused = [&](const json& criteria, const char* pointer) {
    json bad = shop;
    bad["criteria"] = criteria;
    CHECK_THROWS_WITH(scenarios::load(bad), Catch::Contains(pointer));
  };
  refused({{"best", {{"e01", 1}}}}, "/criteria/worst/e01");
  refused({{"best", {{"e01", 1}}}, {"worst", {{"e01", 1}}}}, "/criteria/best/e01");
  refused({{"minimum", {{"e02", 0.5}}}}, "/criteria/minimum/e02");
  refused({{"mission_min", 0}}, "/criteria/mission_min");
  refused({{"mission_min", 1e7}}, "/criteria/mission_min");
  refused({{"best", {{"e09", 1}}}, {"worst", {{"e09", 0}}}, {"group_weights", {{"economy", 0}}}},
          "/criteria");
}
