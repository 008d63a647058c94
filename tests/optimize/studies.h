#pragma once
// Studies as a user writes them, run in memory.

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimize/study.h"

namespace verstat::test {

inline nlohmann::json gallery(const std::string& name) {
  return scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/" + name);
}

/// A study of a scenario and its answer, by stage one alone or with simulation.
struct Studied {
  optimize::StudySpec study;
  std::unique_ptr<optimize::Problem> problem;
  optimize::StudyAnswer answer;
  std::int64_t trials = 0;

  Studied(const nlohmann::json& text, const nlohmann::json& scenario) : study(optimize::load_study(text)) {
    problem = std::make_unique<optimize::Problem>(study,
                                                  scenarios::apply(scenario, optimize::fixed_changes(study)));
    optimize::check_study(*problem);
    optimize::Ledger ledger;
    answer = optimize::run_study(
        *problem, ledger,
        {.simulate = [](const scenarios::Scenario& s, std::uint64_t first, std::int64_t count) {
          return shop::run_replications(s, first, count, 2);
        }});
    trials = ledger.computed();
  }
};

}  // namespace verstat::test
