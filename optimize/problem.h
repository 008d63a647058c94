#pragma once
// A study and its scenario joined: what a point is worth in the long run, and how far it is from every
// constraint.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "optimize/renewal_reward.h"
#include "optimize/search.h"
#include "optimize/study_spec.h"

namespace verstat::models {
class Function;
}

namespace verstat::optimize {

/// One thing that must hold, after "all limits of all operations" has been written out.
struct Condition {
  enum class Kind { kpi, quantity, limit, band, function };
  Kind kind = Kind::kpi;
  std::string name;  ///< "power_kw of rough turning"
  std::string unit = "1";
  bool at_most = true;
  double allowed = 0;         ///< of a KPI, quantity or function; limits and bands bring their own
  double confidence = 0.95;   ///< of a simulated KPI
  std::string item;           ///< KPI, quantity, limit, band or output by name
  std::size_t operation = 0;  ///< of a quantity, limit or band
  std::optional<std::size_t> long_run_kpi;
  const models::Function* function = nullptr;
  models::Value inputs;
};

/// A condition at one point.
struct Checked {
  double value = 0;
  double allowed = 0;
  double margin = 0;  ///< >= 0 when met; relative to `scale`
  double scale = 1;   ///< what one unit of the margin is worth, in the unit of the condition
};

/// A point looked at closely.
struct Look {
  std::vector<double> objectives;  ///< as the user sees them; empty when the long-run model has no part in it
  std::optional<LongRun> long_run;
  std::vector<Checked> conditions;  ///< those without simulation; margins of the others are 0
};

/// What moves between two problems of the same study: an uncertain input at another value.
struct Shift {
  std::string pointer;
  double factor = 1;
};

class Problem {
 public:
  /// `scenario` is the JSON text with all fixed changes made. Throws scenarios::InputError when a variable or
  /// constraint does not fit the scenario.
  Problem(const StudySpec& study, nlohmann::json scenario, std::vector<Shift> shifts = {});
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;
  ~Problem();

  [[nodiscard]] const StudySpec& study() const { return study_; }
  [[nodiscard]] const nlohmann::json& scenario() const { return scenario_; }
  [[nodiscard]] const std::vector<Condition>& conditions() const { return conditions_; }
  [[nodiscard]] const std::vector<Dimension>& dimensions() const { return dimensions_; }
  /// The variables as the scenario has them; outside the bounds perhaps.
  [[nodiscard]] const std::vector<double>& baseline() const { return baseline_; }

  /// Empty when the long-run model, or a catalogue function, knows every objective; else why not.
  [[nodiscard]] const std::string& not_covered() const { return not_covered_; }

  /// Objectives (to be minimised) and margins of all conditions in the long run; KPIs that only the
  /// simulation knows count as met. Undefined points have infinite objectives.
  struct Outcome {
    std::vector<double> objectives;
    std::vector<double> margins;
  };
  [[nodiscard]] Outcome evaluate(const std::vector<double>& x);
  /// Derivatives of an outcome with respect to every variable (0 for whole numbers and categories).
  struct OutcomeSlopes {
    std::vector<std::vector<double>> objectives;
    std::vector<std::vector<double>> margins;
  };
  /// Of objectives and KPIs by automatic differentiation of the long-run model; what the process models bring
  /// into it in closed form for the regime of turning, otherwise by central differences of the plans of the
  /// operations concerned alone, as are margins of plans and functions. A number whose place in the model has
  /// no derivative (the scatter of lives, arrivals) is moved by central differences of the whole. None at
  /// undefined points and without a long-run model.
  [[nodiscard]] std::optional<OutcomeSlopes> slopes(const std::vector<double>& x);
  /// Throws what the models throw.
  [[nodiscard]] Look look(const std::vector<double>& x);
  /// Of the scenario as it stands.
  [[nodiscard]] Look look_at_baseline();

  /// The scenario with the variables at `x`.
  [[nodiscard]] nlohmann::json scenario_at(const std::vector<double>& x) const;
  /// The scenario with the variables at `x`, to read from until the next call.
  [[nodiscard]] const scenarios::Scenario& typed_scenario_at(const std::vector<double>& x);

  struct World;  ///< one scenario with its long-run model

 private:
  World& world_at(const std::vector<double>& x);
  std::unique_ptr<World> make_world(const nlohmann::json& text, bool with_model);
  [[nodiscard]] Look look_in(World& world) const;
  [[nodiscard]] Checked check_plan(const Condition& condition, const operations::CutPlan& plan) const;
  [[nodiscard]] Checked check_function(const Condition& condition, World& world) const;
  struct Slope;  // with respect to one variable
  [[nodiscard]] Slope slope(World& world, const Look& look, std::size_t variable);
  [[nodiscard]] Condition function_at(const std::string& at, const std::string& function,
                                      const std::string& output, const models::Value& inputs,
                                      World& world) const;
  void expand_conditions(World& world);
  void check_bounds() const;

  const StudySpec& study_;
  nlohmann::json scenario_;
  std::vector<Shift> shifts_;
  std::vector<Dimension> dimensions_;
  std::vector<double> baseline_;
  std::vector<Condition> conditions_;
  std::string not_covered_;
  bool needs_model_ = true;
  std::vector<std::optional<std::size_t>> objective_kpis_;
  std::vector<std::optional<Condition>> objective_functions_;
  std::unique_ptr<World> baseline_world_;
  std::map<std::vector<double>, std::unique_ptr<World>> worlds_;  // by the discrete coordinates
};

/// Slopes of objective `k` and of all margins.
[[nodiscard]] std::optional<MeasuredSlopes> measured(std::optional<Problem::OutcomeSlopes> slopes,
                                                     std::size_t objective = 0);
/// Objective `k` of a point as Measured, with all its margins.
[[nodiscard]] Measured measured(const Problem::Outcome& outcome, std::size_t objective = 0);

/// Objective value as the user sees it (a maximised one is searched with the sign changed).
[[nodiscard]] double shown_value(const ObjectiveSpec& objective, double searched);

}  // namespace verstat::optimize
