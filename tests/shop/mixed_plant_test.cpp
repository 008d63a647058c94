// A plant of many operation kinds: the simulator uses the plans that the process models make.
#include <set>

#include <catch2/catch.hpp>

#include "scenarios/load.h"
#include "sim/shop/run.h"

using namespace verstat;

TEST_CASE(
    "the mixed plant runs at least ten kinds together, each machine busy as its plan and the demand say") {
  const auto text = scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/mixed-plant.json");
  const scenarios::Scenario plant = scenarios::load(text);
  std::set<std::string> kinds;
  for (const auto& operation : plant.operations) kinds.insert(operation.process.kind()->name);
  CHECK(kinds.size() >= 10);

  const shop::RunResult run = shop::run_scenario(plant, 2);
  for (const auto& part : plant.parts) {
    // In the long run a station cuts for (arrivals per minute) x (main time), less what was scrapped before
    // it.
    const double interarrival_min = operations::mean_min(std::get<scenarios::Interarrival>(part.supply).time);
    double arriving = 1 / interarrival_min;
    for (const std::string& name : part.route) {
      const auto& operation = *scenarios::find_named(plant.operations, name);
      const auto plan = scenarios::plan(plant, operation);
      const auto& estimate = run.estimates[*run.index_of("machine/" + operation.machine + "/availability")];
      INFO(name << " simulated " << *estimate.mean << " +- " << *estimate.half_width);
      const double upper = arriving * plan.main_time_min;
      // Failures scrap a few parts on the way: at most 5 % of the failures, far below 2 % of the parts.
      CHECK(*estimate.mean < upper + 2 * *estimate.half_width);
      CHECK(*estimate.mean > 0.98 * upper - 2 * *estimate.half_width);
      arriving *= 1 - plan.scrap_probability;
    }
  }
}
