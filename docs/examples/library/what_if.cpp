// what_if SCENARIO GAMMA REPLICATIONS: the cost of a part when edges are changed at the level GAMMA.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include <nlohmann/json.hpp>

#include "scenarios/load.h"
#include "sim/shop/run.h"

using namespace verstat;

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: what_if SCENARIO GAMMA REPLICATIONS\n");
    return 2;
  }
  try {
    const std::vector<scenarios::Change> changes = {
        {"/tools/0/strategy/gamma", std::atof(argv[2])},
        {"/simulation/replications", std::atoi(argv[3])},
    };
    const scenarios::Scenario scenario =
        scenarios::load(scenarios::apply(scenarios::read_json_file(argv[1]), changes));
    const shop::RunResult result = shop::run_scenario(scenario, 2);
    const shop::Estimate& cost = result.estimates[*result.index_of("cost_per_part")];
    std::printf("cost_per_part %.2f +- %.2f\n", *cost.mean, *cost.half_width);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "what_if: %s\n", e.what());
    return 2;
  }
  return 0;
}
