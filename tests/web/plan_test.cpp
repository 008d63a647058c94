// Plans, kinds, schema, checks and maps over HTTP: the same numbers as the calls behind the command line.

#include <catch2/catch.hpp>

#include "models/catalogue/catalogue.h"
#include "operations/kind.h"
#include "scenarios/json_text.h"
#include "scenarios/load.h"
#include "scenarios/plan_json.h"
#include "scenarios/schema.h"
#include "tests/web/serving.h"

using namespace verstat;
using namespace verstat::web_test;
using nlohmann::json;

namespace {

const std::string gallery = VERSTAT_SOURCE_DIR "/scenarios/gallery/";

json gallery_json(const std::string& name) {
  return scenarios::read_json_file(gallery + name);
}

}  // namespace

TEST_CASE("every gallery operation is planned as on the command line") {
  const Serving serving;
  int planned = 0;
  for (const auto& entry : std::filesystem::directory_iterator(gallery + "operations")) {
    CAPTURE(entry.path().string());
    const json document = scenarios::read_json_file(entry.path().string());
    const Answer answer = serving.post("/api/v1/plan", json{{"operation", document}}.dump());
    CHECK(answer.status == 200);
    CHECK(answer.body == scenarios::to_json(scenarios::load_operation(document).plan(), true).dump(2) + "\n");
    ++planned;
  }
  CHECK(planned >= 19);
  const json turning = gallery_json("operations/turning.json");
  CHECK(serving.post("/api/v1/plan?explain=0", json{{"operation", turning}}.dump()).body ==
        scenarios::to_json(scenarios::load_operation(turning).plan(), false).dump(2) + "\n");
}

TEST_CASE("an operation of a scenario is planned with its tool and machine, and with changes") {
  const Serving serving;
  const json scenario = gallery_json("heavy-lathe.json");
  const json body = {
      {"scenario", scenario.dump()},
      {"operation", "rough turning"},
      {"changes", {{{"pointer", "/operations/0/process/cutting_speed_m_min"}, {"value", 47}}}}};
  const auto changed =
      scenarios::load(scenarios::apply(scenario, {{"/operations/0/process/cutting_speed_m_min", 47}}));
  const Answer answer = serving.post("/api/v1/plan", body.dump());
  CHECK(answer.body ==
        scenarios::to_json(scenarios::plan(changed, changed.operations[0]), true).dump(2) + "\n");

  json other = body;
  other["operation"] = "milling";
  const Answer unknown = serving.post("/api/v1/plan", other.dump());
  CHECK(unknown.status == 422);
  CHECK_THAT(unknown.message(), Catch::Contains("rough turning"));
}

TEST_CASE("a bad operation is refused with its place") {
  const Serving serving;
  json turning = gallery_json("operations/turning.json");
  turning["process"]["feed_mm_rev"] = -1;
  const Answer range = serving.post("/api/v1/plan", json{{"operation", turning}}.dump());
  CHECK(range.status == 422);
  CHECK(range.parsed()["error"]["pointer"] == "/process/feed_mm_rev");
  CHECK(serving.post("/api/v1/plan", "{}").status == 400);
  CHECK(serving.post("/api/v1/plan", R"({"operation": "x"})").status == 400);
  CHECK(serving.post("/api/v1/plan", R"({"operation": {}, "chnages": []})").status == 400);
  CHECK(serving.post("/api/v1/plan", R"({"operation": {}, "changes": [{"pointer": "x", "value": 1}]})")
            .status == 400);
}

TEST_CASE("a plan can be followed along one number, refusals included") {
  const Serving serving;
  const json turning = gallery_json("operations/turning.json");
  const json body = {{"operation", turning},
                     {"sweep", {{"pointer", "/process/feed_mm_rev"}, {"values", {0.2, 0.33, 0.5, -1}}}}};
  const Answer answer = serving.post("/api/v1/plan", body.dump());
  REQUIRE(answer.status == 200);
  const json points = answer.parsed()["points"];
  REQUIRE(points.size() == 4);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto plan = scenarios::load_operation(
                          scenarios::apply(turning, {{"/process/feed_mm_rev", body["sweep"]["values"][k]}}))
                          .plan();
    CHECK(points[k]["quantities"]["main_time_min"] == plan.main_time_min);
    CHECK(points[k]["feasible"] == plan.feasible());
  }
  CHECK(points[1]["feasible"] == true);   // the gallery's feed keeps the roughness
  CHECK(points[2]["feasible"] == false);  // this one does not
  CHECK(points[3].contains("error"));
}

TEST_CASE("every kind comes with its schema") {
  const Serving serving;
  const json kinds = serving.get("/api/v1/kinds").parsed();
  CHECK(kinds["total"] == operations::kinds().all().size());
  for (const json& kind : kinds["kinds"]) {
    CAPTURE(kind["name"]);
    REQUIRE(kind["schema"].is_object());
    const auto* known = operations::kinds().find(kind["name"].get<std::string>());
    REQUIRE(known != nullptr);
    for (const auto& field : known->fields()) CHECK(kind["schema"]["properties"].contains(field.name));
  }
  CHECK(serving.get("/api/v1/schema").body == scenarios::scenario_schema().dump(2) + "\n");
}

TEST_CASE("a scenario is checked as before a run, and errors name the field") {
  const Serving serving;
  const json scenario = gallery_json("heavy-lathe.json");
  const Answer good = serving.post("/api/v1/check", json{{"scenario", scenario}}.dump());
  CHECK(good.status == 200);
  CHECK(good.parsed()["operations"][0]["operation"] == "rough turning");

  const auto refused = [&](const std::string& pointer, const json& value) {
    const json body = {{"scenario", scenario}, {"changes", {{{"pointer", pointer}, {"value", value}}}}};
    const Answer answer = serving.post("/api/v1/check", body.dump());
    CHECK(answer.status == 422);
    return answer.parsed()["error"].value("pointer", "");
  };
  CHECK(refused("/machines/0/count", 0) == "/machines/0/count");
  CHECK(refused("/tools/0/strategy/gamma", 2) == "/tools/0/strategy/gamma");
  CHECK(refused("/operations/0/process/feed_mm_rev", "fast") == "/operations/0/process/feed_mm_rev");
  const Answer text = serving.post("/api/v1/check", R"({"scenario": "{\"name\": "})");
  CHECK(text.status == 422);
  CHECK_THAT(text.message(), Catch::Contains("line 1"));
  CHECK(serving.post("/api/v1/check", R"({"scenario": 7})").status == 400);
}

TEST_CASE("a function is mapped over a line and a grid with gaps where it refuses") {
  const Serving serving;
  const models::Function& f = models::catalogue().at("K117.weibull_from_moments");
  const json body = {{"inputs", {{"mean_min", 60}, {"cv", 0.7}}},
                     {"output", "shape"},
                     {"x", {{"name", "cv"}, {"values", {-1, 0.5, 0.7}}}},
                     {"y", {{"name", "mean_min"}, {"values", {30, 60}}}}};
  const Answer answer = serving.post("/api/v1/models/K117.weibull_from_moments/map", body.dump());
  REQUIRE(answer.status == 200);
  const json map = answer.parsed();
  REQUIRE(map["values"].size() == 2);
  CHECK(map["values"][0][0].is_null());
  CHECK(map["refusals"].contains("cv"));
  const json eval =
      serving
          .post("/api/v1/models/K117.weibull_from_moments/eval", R"({"inputs": {"mean_min": 60, "cv": 0.5}})")
          .parsed();
  CHECK(map["values"][1][1] == eval["outputs"]["shape"]);
  CHECK(f.outputs.size() >= 2);
  json unknown = body;
  unknown["output"] = "shpae";
  CHECK(serving.post("/api/v1/models/K117.weibull_from_moments/map", unknown.dump()).status == 422);
  json large = body;
  large["x"]["values"] = std::vector<double>(200, 0.5);
  large["y"]["values"] = std::vector<double>(200, 60);
  CHECK(serving.post("/api/v1/models/K117.weibull_from_moments/map", large.dump()).status == 400);
}
