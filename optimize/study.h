#pragma once
// A study: variables of a scenario, an objective, and the way to the best plan. Stage one minimises the
// long-run model, stage two simulates baseline and best under common random numbers.

#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimize/search.h"
#include "scenarios/load.h"
#include "sim/shop/run.h"

namespace verstat::optimize {

/// A number of the scenario that the study may choose.
struct Variable {
  std::string name;
  std::string pointer;  ///< JSON pointer into the scenario
  std::string unit = "1";
  double low = 0;
  double high = 1;
};

enum class Direction { minimize };

struct ObjectiveSpec {
  std::string kpi = "cost_per_part";
  Direction direction = Direction::minimize;
};

struct SearchSpec {
  std::string algorithm;  ///< see SearchOptions
  std::int64_t max_evaluations = 4000;
  double relative_precision = 1e-8;
};

struct ConfirmationSpec {
  std::int64_t replications = 40;
  double confidence = 0.95;
};

struct StudySpec {
  std::string name;
  std::string scenario;  ///< file, relative to the study file
  std::vector<Variable> variables;
  ObjectiveSpec objective;
  SearchSpec search;
  ConfirmationSpec confirmation;
};

/// Checks shapes, types and ranges of a study file. Throws scenarios::InputError naming the pointer.
[[nodiscard]] StudySpec load_study(const nlohmann::json& study);

struct AnalyticOutcome {
  std::vector<double> baseline;  ///< values of the variables in the scenario as it stands
  double baseline_value = 0;     ///< objective there
  SearchResult search;
};

/// Stage one. `scenario` is the JSON text with all changes made. Throws scenarios::InputError when a variable
/// does not name a number of the scenario, a bound is not valid for it, or the model does not cover the
/// scenario.
[[nodiscard]] AnalyticOutcome optimize_analytic(const StudySpec& study, const nlohmann::json& scenario);

/// The changes that put the variables at `values`.
[[nodiscard]] std::vector<scenarios::Change> changes_at(const StudySpec& study,
                                                        const std::vector<double>& values);

struct Confirmation {
  shop::RunResult baseline;
  shop::RunResult best;
  shop::Estimate saving;  ///< baseline minus best, per pair of replications, at the study's confidence
  /// "better", "worse" or "not distinguishable" at the study's confidence.
  std::string verdict;
};

/// Stage two: both variants with the same random numbers. `scenario` as above.
[[nodiscard]] Confirmation confirm(const StudySpec& study, const nlohmann::json& scenario,
                                   const std::vector<double>& best, int threads,
                                   const shop::Progress& progress = {});

}  // namespace verstat::optimize
