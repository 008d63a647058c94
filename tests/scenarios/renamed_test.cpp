// Old names that random numbers are still drawn by.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"
#include "scenarios/load.h"

using namespace verstat;
using Catch::Contains;
using nlohmann::json;

namespace {

json with(const json& renamed) {
  json cell = scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
  cell["simulation"]["renamed"] = renamed;
  return cell;
}

}  // namespace

TEST_CASE("who has an old name draws by it, everybody else by the present one") {
  const auto cell = scenarios::load(with({{{"name", "lathe"}, {"was", "north lathe"}}}));
  CHECK(scenarios::drawn_as(cell.simulation, "lathe") == "north lathe");
  CHECK(scenarios::drawn_as(cell.simulation, "shaft") == "shaft");
}

TEST_CASE("old names that cannot be are refused by their place") {
  const auto refused = [](const json& renamed, const std::string& pointer, const std::string& why) {
    CHECK_THROWS_WITH(scenarios::load(with(renamed)), Contains(pointer) && Contains(why));
  };
  refused({{{"name", "lahte"}, {"was", "mill"}}}, "/simulation/renamed/0/name", "closest: \"lathe\"");
  refused({{{"name", "lathe"}, {"was", ""}}}, "/simulation/renamed/0/was", "1 to 100 characters");
  refused({{{"name", "lathe"}, {"was", "shaft"}}}, "/simulation/renamed/0/was",
          "still the name of something");
  refused({{{"name", "lathe"}, {"was", "old"}}, {{"name", "shaft"}, {"was", "old"}}},
          "/simulation/renamed/1/was", "twice");
  refused({{{"name", "lathe"}, {"was", "a"}}, {{"name", "lathe"}, {"was", "b"}}},
          "/simulation/renamed/1/name", "already");
  // Two that change places are no contradiction.
  CHECK_NOTHROW(
      scenarios::load(with({{{"name", "lathe"}, {"was", "shaft"}}, {{"name", "shaft"}, {"was", "lathe"}}})));
}
