#pragma once
// The study file: what may change, what is wanted, what must hold, and how much work may go into it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/catalogue/value.h"
#include "scenarios/load.h"

namespace verstat::optimize {

enum class VariableType { continuous, integer, categorical };

/// Something of the scenario that the study may choose. A point of a study is one double per variable; that
/// of a categorical variable is the index of its option.
struct Variable {
  std::string name;
  std::string pointer;  ///< JSON pointer into the scenario
  std::string unit = "1";
  VariableType type = VariableType::continuous;
  double low = 0;
  double high = 1;
  std::vector<models::Value> options;  ///< of a categorical variable: any JSON, also whole objects
};

enum class Direction { minimize, maximize };

/// A KPI, or an output of a catalogue function (then only computed, never simulated).
struct ObjectiveSpec {
  std::string kpi;
  std::string function;  ///< key, "K117.part_cost_at_gamma"
  std::string output;    ///< of the function
  models::Value inputs;  ///< of the function: values, or {"pointer": ...} into the scenario
  Direction direction = Direction::minimize;

  /// What it is called: the KPI, or "part_cost of K117.part_cost_at_gamma".
  [[nodiscard]] std::string label() const { return kpi.empty() ? output + " of " + function : kpi; }
};

/// What must hold: of a KPI, of the plan of an operation, or of a function of the catalogue. Which one is
/// said by the member that is given: `kpi`, `operation` or `function`.
struct ConstraintSpec {
  std::string name;       ///< what a person calls it; made up when empty
  std::string kpi;        ///< with confidence when simulated
  std::string operation;  ///< its name, or "*" for all of them
  std::string quantity;   ///< of the operation's plan, "cutting_force_n"
  std::string limits;     ///< of the operation's plan: "all", or the name of one
  std::string bands;      ///< forbidden bands of the operation's plan: "all", or the name of one
  std::string function;   ///< key, "K117.part_cost"
  models::Value inputs;   ///< of the function: values, or {"pointer": ...} into the scenario
  std::string output;     ///< of the function
  std::optional<double> at_most;
  std::optional<double> at_least;
  double confidence = 0.95;
};

struct FixedChange {
  std::string pointer;
  models::Value value;
};

struct SearchSpec {
  std::string algorithm;        ///< see SearchOptions
  std::string local_algorithm;  ///< after a global one
  std::int64_t max_evaluations = 4000;
  double relative_precision = 1e-8;
  std::int64_t starts = 2;  ///< local searches from scattered points, besides those from the best
};

/// Stage two: sample averages of growing size around the best points of stage one.
struct SimulationSpec {
  std::int64_t trials = 0;              ///< points simulated at most; 0: no stage two
  std::int64_t first_replications = 5;  ///< of the first sample; doubled at every level
  std::int64_t levels = 3;
  double neighbourhood = 0.1;  ///< half-width of the first search box, of the bounds
};

/// Stage three: the choice among the finalists.
struct ChoiceSpec {
  std::int64_t finalists = 3;
  double confidence = 0.95;
  double indifference = 0.002;  ///< a difference that does not matter, of the objective
  std::int64_t first_replications = 10;
  std::int64_t max_replications = 200;
};

struct ConfirmationSpec {
  std::int64_t replications = 40;
  double confidence = 0.95;
};

struct BudgetSpec {
  double time_s = 0;        ///< 0: no limit. Ends the study as Ctrl-C does; it can be resumed
  std::int64_t trials = 0;  ///< 0: no limit besides those of the stages
};

struct FrontSpec {
  std::int64_t points = 15;       ///< per objective after the first
  std::int64_t replications = 0;  ///< simulated at every point of the front; 0: none
};

/// An input nobody knows exactly.
struct UncertainSpec {
  std::string name;
  std::string pointer;
  double relative = 0.1;  ///< +- of its value
};

enum class RobustMeasure { mean, worst };
struct RobustSpec {
  std::int64_t samples = 0;  ///< 0: the nominal inputs alone
  RobustMeasure measure = RobustMeasure::mean;
};

struct StudySpec {
  std::string name;
  std::string description;
  std::string scenario;  ///< file, relative to the study file
  std::vector<FixedChange> changes;
  std::vector<Variable> variables;
  ObjectiveSpec objective;
  std::vector<ObjectiveSpec> objectives;  ///< instead of `objective`: two or more make a front
  std::vector<ConstraintSpec> constraints;
  SearchSpec search;
  SimulationSpec simulation;
  ChoiceSpec choice;
  ConfirmationSpec confirmation;
  BudgetSpec budget;
  FrontSpec front;
  std::vector<UncertainSpec> uncertain;
  RobustSpec robust;

  /// Discrete settings of a variable: its whole numbers or options; 0 when it is continuous.
  [[nodiscard]] static std::int64_t settings_of(const Variable& variable);
};

/// Checks shapes, types and ranges of a study file. Afterwards `objectives` has at least one entry and
/// `objective` is the first of them. Throws scenarios::InputError naming the pointer.
[[nodiscard]] StudySpec load_study(const nlohmann::json& study);

/// The value of a variable at coordinate `x`, as it stands in the scenario: a double, a whole number or an
/// option.
[[nodiscard]] nlohmann::json value_at(const Variable& variable, double x);
/// As a person reads it.
[[nodiscard]] std::string text_at(const Variable& variable, double x);
/// The changes that put the variables at `x`, one coordinate each.
[[nodiscard]] std::vector<scenarios::Change> changes_at(const std::vector<Variable>& variables,
                                                        const std::vector<double>& x);
/// The fixed changes of the study.
[[nodiscard]] std::vector<scenarios::Change> fixed_changes(const StudySpec& study);
/// Splits "/a/b~1c" into {"a", "b/c"}; throws nlohmann's parse_error when it is no JSON pointer.
[[nodiscard]] std::vector<std::string> pointer_tokens(const std::string& pointer);

}  // namespace verstat::optimize
