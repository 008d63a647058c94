// Hidden defects, inspections, rework.
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {
json inspected(const json& inspection) {
  json shop = small_shop(always(), constant(1));
  shop["operations"][0]["quality"] = {{"defect_probability", 0.1}};
  shop["machines"].push_back({{"name", "desk"}});
  shop["operations"].push_back({{"name", "look"},
                                {"machine", "desk"},
                                {"process", duration_process(constant(0.5))},
                                {"inspection", inspection},
                                {"cost", 3}});
  shop["parts"][0]["route"] = {"o", "look"};
  shop["parts"][0]["value"] = 50;
  shop["parts"][0]["escape_cost"] = 400;
  return shop;
}
}  // namespace

TEST_CASE("an inspection lets defects through and rejects good parts as stated", "[shop][quality]") {
  const json shop = inspected({{"sensitivity", 0.8}, {"specificity", 0.95}});
  const auto result = run(shop);
  const double rejected = 0.1 * 0.8 + 0.9 * 0.05;
  check_truth(result, "quality_ratio", 1 - rejected, 0.01);
  check_truth(result, "part/p/escape_ratio", 0.02 / (1 - rejected), 0.1);
  check_truth(result, "cost/escapes", 0.02 * 400, 0.1);
  check_truth(result, "cost/scrap", rejected * 50, 0.1);
  CHECK(mean(result, "cost/operations") == Approx(3).epsilon(1e-3));
  check_audit(shop);
}

TEST_CASE("sampling looks at a share of the parts", "[shop][quality]") {
  const auto result = run(inspected({{"share", 0.25}}));
  check_truth(result, "quality_ratio", 1 - 0.025, 0.01);
  check_truth(result, "part/p/escape_ratio", 0.075 / 0.975, 0.1);
}

TEST_CASE("a lot with more rejects than allowed is rejected as a whole", "[shop][quality]") {
  json shop = inspected({{"acceptance_number", 1}});
  shop["parts"][0]["batch_size"] = 10;
  // P(at most one of ten defective) = 0.9^10 + 10 x 0.1 x 0.9^9
  check_truth(run(shop), "quality_ratio", std::pow(0.9, 10) + std::pow(0.9, 9), 0.02);
  check_audit(shop);
}

TEST_CASE("rework sends rejected parts back, so often and no more", "[shop][quality][long]") {
  json shop = inspected(json::object());
  shop["parts"][0].erase("route");
  shop["parts"][0]["steps"] = {
      {{"name", "make"}, {"operation", "o"}},
      {{"name", "check"}, {"operation", "look"}, {"rework", "make"}, {"rework_limit", 2}}};
  shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 3}};
  // Scrapped after three defects in a row.
  const auto result = run(shop);
  check_truth(result, "quality_ratio", 1 - 1e-3, 0.001);
  check_truth(result, "part/p/rework_ratio", 0.1 + 0.01, 0.05);
  check_audit(shop);
}

TEST_CASE("defects grow with the wear of the edge", "[shop][quality]") {
  json shop = scenarios_of("heavy-lathe");
  shop["operations"][0]["quality"] = {{"defect_when_worn", 0.2}};
  shop["parts"][0]["escape_cost"] = 100;
  shop["simulation"]["replications"] = 4;
  const auto worn = run(shop);
  CHECK(mean(worn, "part/shaft/escape_ratio") > 0.01);
  // Changed earlier, fewer escape.
  shop["tools"][0]["strategy"]["gamma"] = 0.95;
  CHECK(mean(run(shop), "part/shaft/escape_ratio") < 0.7 * mean(worn, "part/shaft/escape_ratio"));
}

TEST_CASE("a part has a defect or has none, however many operations leave some", "[shop][quality]") {
  json shop = inspected({{"sensitivity", 0.0}});
  shop["operations"][0]["quality"] = {{"defect_probability", 0.6}};
  shop["operations"][1]["quality"] = {{"defect_probability", 0.5}, {"scrap_probability", 0.2}};
  for (const int batch : {1, 7}) {
    shop["parts"][0]["batch_size"] = batch;
    const auto r = run(shop);
    check_truth(r, "part/p/escape_ratio", 1 - 0.4 * 0.5, 0.02);
    check_truth(r, "quality_ratio", 0.8, 0.02);
    check_audit(shop);
  }
}

TEST_CASE("an inspection by its model judges the defects that come, or those that its plan assumes",
          "[shop][quality][K205]") {
  json shop = inspected(json::object());
  shop["operations"][1].erase("inspection");
  shop["operations"][1]["process"] =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/inspection.json")
          .at("process");
  const auto s = scenarios::load(shop);
  const auto plan = scenarios::plan(s, s.operations[1]);
  const auto d = *plan.detection;
  const auto judged = [&](double share) {
    const auto r = run(shop);
    check_truth(r, "quality_ratio", 1 - (share * d.sensitivity + (1 - share) * (1 - d.specificity)), 0.01);
    check_truth(r, "part/p/escape_ratio",
                share * (1 - d.sensitivity) / (share * (1 - d.sensitivity) + (1 - share) * d.specificity),
                0.05);
  };
  judged(0.1);
  shop["operations"][0].erase("quality");  // nobody says what comes
  judged(d.defective_share);
  CHECK(1 - mean(run(shop), "quality_ratio") == Approx(plan.scrap_probability).epsilon(0.02));
  // A second inspection finds a part of what the first one let through, and assumes nothing more.
  json second = shop["operations"][1];
  second["name"] = "look again";
  shop["machines"].push_back({{"name", "desk 2"}});
  second["machine"] = "desk 2";
  shop["operations"].push_back(second);
  shop["parts"][0]["route"] = {"o", "look", "look again"};
  const double missed = d.defective_share * std::pow(1 - d.sensitivity, 2);
  const double good = (1 - d.defective_share) * std::pow(d.specificity, 2);
  const auto twice = run(shop);
  check_truth(twice, "quality_ratio", missed + good, 0.01);
  check_truth(twice, "part/p/escape_ratio", missed / (missed + good), 0.1);
}
