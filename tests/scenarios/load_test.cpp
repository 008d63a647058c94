#include "scenarios/load.h"

#include <limits>

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <rapidcheck.h>

#include "operations/kinds/turning.h"

using namespace verstat::scenarios;
using nlohmann::json;

namespace {

json heavy_lathe() {
  return read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
}

// Loads the heavy-lathe cell with one change and returns the message of the error.
std::string error_of(const std::string& change) {
  try {
    (void)load(apply(heavy_lathe(), {parse_change(change)}));
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("the gallery's heavy-lathe cell is card K117's default set") {
  const Scenario s = load(heavy_lathe());
  CHECK(s.machines.at(0).count == 2);
  const auto* turning = s.operations.at(0).process.as<verstat::operations::Turning>();
  REQUIRE(turning != nullptr);
  CHECK(turning->cutting_speed_m_min == 60);
  CHECK(s.inserts.at(0).edge_life.cv == 0.7);
  CHECK(s.simulation.seed.value == 20111);
  const Tool& tool = s.tools.at(0);
  CHECK(tool.change.positioning_min + mean_min(tool.change.index) == Approx(5).epsilon(1e-15));
  CHECK(tool.failure_damage + tool.failure_scrap_probability * s.parts.at(0).value == Approx(72));
}

TEST_CASE("every bad input names its place, its value and what would be right") {
  CHECK(error_of("/machines/0/count=0") ==
        "/machines/0/count = 0, allowed 1 <= count <= 10000 (number of identical machines)");
  CHECK(error_of("/machines/0/count=2.5") ==
        "/machines/0/count = 2.5, must be a whole number (number of identical machines)");
  CHECK(error_of("/machines/0/count=true") ==
        "/machines/0/count = true, must be a whole number (number of identical machines)");
  CHECK(error_of("/machines/0/count=\"2\"") ==
        "/machines/0/count = \"2\", must be a whole number (number of identical machines)");
  CHECK(error_of("/machines/0/counts=3") ==
        "/machines/0/counts = 3, there is no such input; closest: \"count\"");
  CHECK(error_of("/machines/7/count=3") == "/machines/7: the list has 1 entries, counted from 0");
  CHECK(error_of("/machine/0/count=3") == "/machine: there is no such member; closest: \"machines\"");
  CHECK(error_of("/machines=[]") ==
        "/machines has 0 entries, allowed 1 to 10000 (groups of identical machines)");
  CHECK(error_of("/tools/0/insert=T5K11") ==
        "/tools/0/insert = \"T5K11\", there is no such insert; closest: \"T5K10\"");
  CHECK(error_of("/tools/0/strategy={\"kind\":\"agee\",\"gamma\":0.5}")
            .starts_with("/tools/0/strategy = {\"gamma\": 0.5, \"kind\": \"agee\"}, must be an object whose "
                         "\"kind\" is one of \"run_to_failure\""));
  CHECK(error_of("/tools/0/strategy/gamma=1.0")
            .starts_with("/tools/0/strategy/gamma = 1, allowed 0.01 <= gamma <= 0.99"));
  CHECK(error_of("/inserts/0/edge_life/law=normal") ==
        "/inserts/0/edge_life/cv = 0.7, allowed 0.05 <= cv <= 0.45 for the normal law");
  CHECK(error_of("/simulation/warmup_min=250000") ==
        "/simulation/warmup_min = 250000, must be below horizon_min = 250000: nothing would be counted");
  CHECK(error_of("/simulation/seed=-1").starts_with("/simulation/seed = -1, must be a whole number from 0"));
  CHECK(error_of("/simulation/seed=18446744073709551616").starts_with("/simulation/seed = "));
  CHECK(error_of("/parts/0/route=[\"grinding\"]") ==
        "/parts/0/route/0 = \"grinding\", there is no such operation; closest: \"rough turning\"");
  CHECK(
      error_of(
          "/operations/0/process={\"kind\":\"duration\",\"time\":{\"kind\":\"constant\",\"value_min\":0}}") ==
      "/operations/0/process = 0 min, must take at least 1e-6 min");
  CHECK(error_of("/tools/0/change/index={\"kind\":\"uniform\",\"low_min\":3,\"high_min\":2}") ==
        "/tools/0/change/index/low_min = 3, must not be above high_min = 2");
  CHECK(error_of("/crews/0/name=") == "/crews/0/name = \"\", must have 1 to 100 characters");
  CHECK(error_of("/operations/0/process/cutting_speed_m_min=1e400") != "accepted");
}

TEST_CASE("bad change texts name --set") {
  CHECK_THROWS_WITH(parse_change("machines/0/count=3"),
                    "--set machines/0/count=3: must be POINTER=VALUE, such as /machines/0/count=3");
  CHECK_THROWS_WITH(parse_change("/a"), "--set /a: must be POINTER=VALUE, such as /machines/0/count=3");
  CHECK(parse_change("/a=x y").value == "x y");
  CHECK(parse_change("/a=1.5").value == 1.5);
}

TEST_CASE("JSON is read strictly") {
  CHECK_THROWS_WITH(parse_json("{\"a\": 1, \"a\": 2}"), "holds the key \"a\" twice in one object");
  CHECK_THROWS_WITH(parse_json(std::string(100, '[') + std::string(100, ']')),
                    "is nested deeper than 64 levels");
  CHECK_THROWS_AS(parse_json("{} trailing"), InputError);
  CHECK_THROWS_WITH(parse_json("{\n  \"a\": oops\n}"), Catch::StartsWith("is not JSON: line 2, column"));
  CHECK_THROWS_WITH(read_json_file("/no/such/file.json"),
                    "/no/such/file.json cannot be read: no such file, or no permission");
}

namespace {

// All pointers of a document, leaves and inner nodes.
void collect(const json& j, const std::string& at, std::vector<std::string>& into) {
  if (!at.empty()) into.push_back(at);
  if (j.is_object())
    for (const auto& [key, value] : j.items()) collect(value, at + "/" + key, into);
  if (j.is_array())
    for (std::size_t k = 0; k < j.size(); ++k) collect(j[k], fmt::format("{}/{}", at, k), into);
}

}  // namespace

TEST_CASE("any member replaced by anything loads or gives a one-line error with a pointer") {
  std::vector<std::string> pointers;
  collect(heavy_lathe(), "", pointers);
  const std::vector<json> absurd = {nullptr,
                                    true,
                                    -1,
                                    0,
                                    1e308,
                                    -1e308,
                                    1e-308,
                                    18446744073709551615ULL,
                                    "",
                                    "x",
                                    std::string(100'000, 'a'),
                                    json::array(),
                                    json::object(),
                                    json::array({1, "a"})};
  std::size_t refused = 0;
  for (const std::string& pointer : pointers)
    for (const json& value : absurd) {
      INFO(pointer << " = " << value.dump().substr(0, 50));
      try {
        (void)load(apply(heavy_lathe(), {{pointer, value}}));
      } catch (const InputError& e) {
        ++refused;
        const std::string text = e.what();
        CHECK(text.find('/') != std::string::npos);
        CHECK(text.find('\n') == std::string::npos);
        CHECK(text.size() < 700);
      }
    }
  CHECK(refused > pointers.size() * absurd.size() / 2);
}

TEST_CASE("removing any member is noticed or has a default") {
  std::vector<std::string> pointers;
  collect(heavy_lathe(), "", pointers);
  for (const std::string& pointer : pointers) {
    json without = heavy_lathe();
    const json::json_pointer p(pointer);
    if (!without[p.parent_pointer()].is_object()) continue;
    without[p.parent_pointer()].erase(p.back());
    try {
      (void)load(without);
    } catch (const InputError& e) {
      CHECK(std::string(e.what()).find("is missing") + std::string(e.what()).find("must be") +
                std::string(e.what()).find("there is no") >
            std::size_t{0});
    }
  }
}
