#pragma once
// The answer of `verstat optimize`: as JSON for the database, the pages and --json, and as tables.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimize/analysis.h"
#include "optimize/study.h"

namespace verstat::app {

struct StudyFindings {
  const optimize::StudySpec& study;
  optimize::StudyAnswer answer;
  std::string currency;
  std::int64_t id = 0;
  std::int64_t trials = 0;
  std::optional<optimize::Confirmation> confirmation;
  std::optional<double> best_long_run;  ///< of the best plan, when the long-run model covers it
  std::vector<optimize::Binding> binding;
  std::vector<optimize::Sensitivity> sensitivity;
  std::vector<optimize::OneCut> one_cut;
  std::string nearest_miss;  ///< when nothing is feasible: what is in the way
};

[[nodiscard]] nlohmann::ordered_json to_json(const StudyFindings& findings);
/// The JSON as tables on standard output.
void print_findings(const nlohmann::ordered_json& result);

}  // namespace verstat::app
