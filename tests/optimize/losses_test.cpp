// The price list of losses can be asked of every shop, whatever its file leaves out.
#include "optimize/losses.h"

#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::gallery;

TEST_CASE("every loss of every gallery shop can be removed") {
  std::set<std::string> kinds;
  for (const auto& file : std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery")) {
    const std::string name = file.path().filename().string();
    if (!name.ends_with(".json") || name.ends_with(".study.json")) continue;
    const json text = gallery(name);
    for (const Loss& loss : losses_of(scenarios::load(text))) {
      INFO(name << ": " << loss.name);
      kinds.insert(loss.kind);
      // Removed, it is no loss any more.
      const auto without = scenarios::load(scenarios::apply(text, loss.removed_by));
      for (const Loss& left : losses_of(without)) CHECK((left.name != loss.name || loss.kind == "failure"));
    }
  }
  CHECK(kinds == std::set<std::string>{"change", "failure", "scrap", "wait"});
}

TEST_CASE("a tool that says nothing of its changes has changes all the same") {
  json text = gallery("heavy-lathe.json");
  text["tools"][0].erase("change");
  for (const char* member :
       {"failure_damage", "failure_scrap_probability", "regrind_failure", "regrind_planned"})
    text["tools"][0].erase(member);
  const auto losses = losses_of(scenarios::load(text));
  REQUIRE(!losses.empty());
  CHECK(losses[0].name == "changes of roughing tool");
  const auto s = scenarios::load(scenarios::apply(text, losses[0].removed_by));
  CHECK(mean_min(s.tools[0].change.index) == 0);
  CHECK(mean_min(s.tools[0].change.replace) == 0);
}
