#pragma once
// One scenario of a study with its long-run model; for the two sources of Problem.

#include <memory>
#include <string>
#include <vector>

#include "optimize/problem.h"

namespace verstat::optimize {

struct Problem::World {
  scenarios::Scenario scenario;
  nlohmann::json text;             ///< of the scenario
  std::string refused;             ///< why there is no such shop; then nothing else is valid
  std::vector<double*> variables;  ///< null: not continuous
  std::unique_ptr<LongRunModel> model;
};

}  // namespace verstat::optimize
