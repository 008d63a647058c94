// What a machine of a scenario says of its spindle and its clutch reaches the plans of its operations.
#include <catch2/catch.hpp>

#include "scenarios/load.h"

using namespace verstat;

TEST_CASE("the same operation on two machines of a scenario: only one declares spindle and clutch") {
  const auto plain = scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/mixed-plant.json");
  const auto shown =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/face_milling_machine.json");
  const scenarios::Scenario without = scenarios::load(plain);
  const auto* operation = scenarios::find_named(without.operations, "face milling");
  if (operation == nullptr)
    for (const auto& o : without.operations)
      if (o.process.kind()->name == "face_milling") operation = &o;
  REQUIRE(operation != nullptr);
  std::size_t machine = 0;
  while (without.machines[machine].name != operation->machine) ++machine;
  const std::string at = "/machines/" + std::to_string(machine);
  const scenarios::Scenario with = scenarios::load(scenarios::apply(
      plain, {{at + "/spindle", shown.at("spindle")},
              {at + "/limits/safety_clutch", shown.at("machine_limits").at("safety_clutch")}}));

  const auto before = scenarios::plan(without, *operation);
  const auto after = scenarios::plan(with, *scenarios::find_named(with.operations, operation->name));
  CHECK_FALSE(before.overload);
  CHECK(after.overload);
  CHECK(before.bands.empty());
  CHECK_FALSE(after.bands.empty());
  CHECK(after.value_of("stable_width_mm"));
  CHECK(after.main_time_min == before.main_time_min);

  // A wrong spindle is refused by its place, before anything runs.
  CHECK_THROWS_WITH(
      scenarios::load(scenarios::apply(
          plain, {{at + "/spindle", {{"speed_min_rpm", 10}, {"speed_max_rpm", 400}, {"holder", "loose"}}}})),
      Catch::Contains(at + "/spindle/holder"));
}
