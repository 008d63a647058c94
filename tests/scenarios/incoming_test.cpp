// The state of parts handed from operation to operation: what is taken, and what is refused by its place.
#include "scenarios/incoming.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"
#include "scenarios/load.h"

using namespace verstat;
using Catch::Contains;
using nlohmann::json;

namespace {

json process(const std::string& operation) {
  return scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/" + operation + ".json")
      .at("process");
}

// A shaft is ground, then finished with grains, then measured.
json shop() {
  json finishing = process("magnetic_abrasive");
  finishing.erase("ra_max_um");
  return {{"name", "bearings"},
          {"machines", {{{"name", "grinder"}}, {{"name", "bath"}}, {{"name", "desk"}}}},
          {"operations",
           {{{"name", "grind"}, {"machine", "grinder"}, {"process", process("cylindrical_grinding")}},
            {{"name", "finish"},
             {"machine", "bath"},
             {"process", finishing},
             {"incoming", {{{"from", "grind"}, {"quantity", "roughness_ra_um"}, {"input", "ra_before_um"}}}}},
            {{"name", "look"},
             {"machine", "desk"},
             {"process", {{"kind", "duration"}, {"time", {{"kind", "constant"}, {"value_min", 1}}}}}}}},
          {"stores", {{{"name", "s"}}}},
          {"parts",
           {{{"name", "p"},
             {"route", {"grind", "finish", "look"}},
             {"requirements", {{{"quantity", "ra_um"}, {"at_most", 0.2}}}},
             {"store", "s"}}}}};
}

void refused(const json& scenario, const std::string& pointer, const std::string& why) {
  INFO(pointer);
  CHECK_THROWS_WITH(scenarios::load(scenario), Contains(pointer) && Contains(why));
}

double value(const scenarios::Scenario& s, std::size_t operation, const char* quantity) {
  return scenarios::plan(s, s.operations[operation]).value_of(quantity).value();
}

}  // namespace

TEST_CASE("a member that was left out, a number and a nested one are taken from the operation before") {
  const auto s = scenarios::load(shop());
  CHECK(value(s, 1, "ra_before_um") == value(s, 0, "roughness_ra_um"));
  json given = shop();
  given["operations"][1]["process"]["ra_before_um"] = 5;  // given and taken: the part decides
  CHECK(value(scenarios::load(given), 1, "ra_before_um") == value(s, 0, "roughness_ra_um"));
  json scaled = shop();
  scaled["operations"][1]["incoming"][0]["factor"] = 2;
  CHECK(value(scenarios::load(scaled), 1, "ra_before_um") == 2 * value(s, 0, "roughness_ra_um"));
  // Over two operations, and into a member of a member.
  json chain = shop();
  chain["operations"][0]["process"] = process("tool_steel_finishing");
  chain["operations"][0]["process"].erase("fatigue_limit_min_mpa");
  json grinding = process("cylindrical_grinding");
  grinding["feed_controller"] = {{"feed_from_m_min", 1}};
  chain["operations"][2]["process"] = grinding;
  chain["operations"][1]["incoming"] = {{{"from", "grind"},
                                         {"quantity", "tempered_depth_um"},
                                         {"input", "time_constant_min"},
                                         {"factor", 0.01}}};
  chain["operations"][2]["incoming"] = {{{"from", "finish"},
                                         {"quantity", "ra_um"},
                                         {"input", "feed_controller/feed_from_m_min"},
                                         {"factor", 3}}};
  const auto c = scenarios::load(chain);
  const auto taken = scenarios::received(c, c.operations[2]);
  CHECK(taken.kind()->name == "cylindrical_grinding");
  CHECK(value(c, 2, "main_time_min") > 0);
  json by_hand = chain;
  by_hand["operations"][2].erase("incoming");
  by_hand["operations"][2]["process"]["feed_controller"]["feed_from_m_min"] = 3 * value(c, 1, "ra_um");
  CHECK(value(c, 2, "main_time_min") == value(scenarios::load(by_hand), 2, "main_time_min"));
}

TEST_CASE("what cannot be handed on is refused by its place") {
  const auto with = [](const json& incoming) {
    json s = shop();
    s["operations"][1]["incoming"][0].update(incoming);
    return s;
  };
  refused(with({{"from", "grint"}}), "/operations/1/incoming/0/from", "closest: \"grind\"");
  refused(with({{"quantity", "roughness_ra"}}), "/operations/1/incoming/0/quantity", "roughness_ra_um");
  refused(with({{"quantity", "power_kw"}}), "/operations/1/incoming/0/quantity", "is not left");
  refused(with({{"from", "look"}}), "/operations/1/incoming/0/quantity", "leaves nothing");
  refused(with({{"input", "ra_befor_um"}}), "/operations/1/incoming/0/input", "ra_before_um");
  refused(with({{"input", "material"}}), "/operations/1/incoming/0/input", "is not a number");
  refused(with({{"input", "gap_mm"}}), "/operations/1/incoming/0/input", "give the factor");
  refused(with({{"factor", 1e6}}), "/operations/1/process", "ra_before_um");  // outside the member's range
  refused(with({{"from", "finish"}}), "/operations/1/incoming", "receives from itself");
  json twice = shop();
  twice["operations"][1]["incoming"].push_back(twice["operations"][1]["incoming"][0]);
  refused(twice, "/operations/1/incoming/1/input", "is already that of");
  json circle = shop();
  circle["operations"][0]["incoming"] = {
      {{"from", "finish"}, {"quantity", "ra_um"}, {"input", "initial_defect_um"}}};
  refused(circle, "/operations/0/incoming", "receives from itself");
  json before = shop();
  before["parts"][0]["route"] = {"finish", "grind", "look"};
  refused(before, "/parts/0/route/0", "without having been there");
  // Two grinders that leave different surfaces.
  json two = shop();
  two["machines"].push_back({{"name", "other"}});
  two["operations"][0].erase("machine");
  two["operations"][0]["machines"] = {"grinder", "other"};
  CHECK_NOTHROW(scenarios::load(two));
}

TEST_CASE("ladders of operations that hand on are planned once each, and have an end") {
  json ladder = shop();
  ladder["operations"].erase(2);
  ladder["machines"].erase(2);
  json rung = ladder["operations"][1];
  json names = {"grind", "finish"};
  for (int k = 0; k < 40; ++k) {  // two ways from each rung to the one below: 2^40 ways in all
    json next = rung;
    next["name"] = "rung " + std::to_string(k);
    next["incoming"] = {{{"from", names.back()}, {"quantity", "ra_um"}, {"input", "ra_before_um"}},
                        {{"from", names[names.size() - 2]},
                         {"quantity", k == 0 ? "roughness_ra_um" : "ra_um"},
                         {"input", "time_constant_min"}}};
    next["incoming"][1]["factor"] = 10;
    ladder["operations"].push_back(next);
    names.push_back(next["name"]);
  }
  ladder["parts"][0]["route"] = names;
  const auto s = scenarios::load(ladder);
  CHECK(value(s, 41, "ra_um") <= value(s, 1, "ra_um"));
  for (int k = 40; k < 60; ++k) {
    json next = rung;
    next["name"] = "rung " + std::to_string(k);
    next["incoming"] = {{{"from", names.back()}, {"quantity", "ra_um"}, {"input", "ra_before_um"}}};
    ladder["operations"].push_back(next);
    names.push_back(next["name"]);
  }
  ladder["parts"][0]["route"] = names;
  refused(ladder, "/incoming", "more than 50");
}

TEST_CASE("a drawing that nobody can judge is refused by its place") {
  const auto with = [](const json& requirement) {
    json s = shop();
    s["parts"][0]["requirements"] = {requirement};
    return s;
  };
  refused(with({{"quantity", "ra_um"}}), "/parts/0/requirements/0", "at_least, at_most or both");
  refused(with({{"quantity", "ra_um"}, {"at_least", 2}, {"at_most", 1}}), "/parts/0/requirements/0/at_least",
          "must not be above");
  refused(with({{"quantity", "ra"}, {"at_most", 1}}), "/parts/0/requirements/0/quantity", "ra_um");
  json twice = shop();
  twice["parts"][0]["requirements"].push_back(twice["parts"][0]["requirements"][0]);
  refused(twice, "/parts/0/requirements/1/quantity", "is already that of");
  // A way round the finishing.
  json branch = shop();
  branch["operations"][1].erase("incoming");
  branch["parts"][0].erase("route");
  branch["parts"][0]["steps"] = {
      {{"name", "a"},
       {"operation", "grind"},
       {"next", {{{"to", "b"}, {"probability", 0.5}}, {{"to", "c"}, {"probability", 0.5}}}}},
      {{"name", "b"}, {"operation", "finish"}},
      {{"name", "c"}, {"operation", "look"}}};
  refused(branch, "/parts/0/requirements/0/quantity", "without an operation that leaves it");
  // Some parts are finished a second time, some are not.
  json again = shop();
  json second = again["operations"][1];
  second["name"] = "finish again";
  again["operations"].push_back(second);
  again["parts"][0].erase("route");
  again["parts"][0]["steps"] = {
      {{"name", "a"}, {"operation", "grind"}},
      {{"name", "b"},
       {"operation", "finish"},
       {"next", {{{"to", "c"}, {"probability", 0.5}}, {{"to", "d"}, {"probability", 0.5}}}}},
      {{"name", "c"}, {"operation", "finish again"}},
      {{"name", "d"}, {"operation", "look"}}};
  refused(again, "/parts/0/requirements/0/quantity", "is not decided");
}

TEST_CASE("share of parts that fall short: normal with both scatters, a step without") {
  operations::CutPlan plan;
  plan.quantities.push_back({"limit_mpa", 500, "MPa", "", ""});
  plan.leave("limit_mpa", 30);
  using scenarios::Requirement;
  using scenarios::share_that_fails;
  CHECK(share_that_fails({"limit_mpa", 500, {}, 0}, plan) == Approx(0.5));
  CHECK(share_that_fails({"limit_mpa", 450, {}, 40}, plan) == Approx(0.15865525393145707));  // one deviation
  CHECK(share_that_fails({"limit_mpa", {}, 550, 40}, plan) == Approx(0.15865525393145707));
  CHECK(share_that_fails({"limit_mpa", 450, 550, 40}, plan) == Approx(2 * 0.15865525393145707));
  plan.leaves.front().sd = 0;
  CHECK(share_that_fails({"limit_mpa", 500, {}, 0}, plan) == 0);
  CHECK(share_that_fails({"limit_mpa", 501, {}, 0}, plan) == 1);
}
