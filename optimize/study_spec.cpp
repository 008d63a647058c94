#include "optimize/study_spec.h"

#include <cmath>

#include <fmt/format.h>

#include "models/catalogue/field.h"
#include "models/catalogue/shortened.h"
#include "optimize/search.h"
#include "scenarios/model_json.h"

namespace verstat::models {

using namespace optimize;

template <>
struct EnumNames<Direction> {
  static constexpr std::array names{std::pair{Direction::minimize, "minimize"},
                                    std::pair{Direction::maximize, "maximize"}};
};
template <>
struct EnumNames<VariableType> {
  static constexpr std::array names{std::pair{VariableType::continuous, "continuous"},
                                    std::pair{VariableType::integer, "integer"},
                                    std::pair{VariableType::categorical, "categorical"}};
};
template <>
struct EnumNames<RobustMeasure> {
  static constexpr std::array names{std::pair{RobustMeasure::mean, "mean"},
                                    std::pair{RobustMeasure::worst, "worst"}};
};

/// Any JSON: an option of a variable, an input of a function.
template <>
struct detail::Binding<Value> {
  static void read(Value& to, const Value& v, const Field&) { to = v; }
  static Value write(const Value& x) { return x; }
  static void check(const Value&, const Field&) {}
  static bool finite(const Value&) { return true; }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::text}; }
};

namespace {

template <class S, class T>
Field need(T S::*pointer, std::string_view name, std::string_view unit, const Range& range,
           std::string_view meaning) {
  return member<S>(pointer, name, "", unit, range, meaning, true);
}
template <class S, class T>
Field may(T S::*pointer, std::string_view name, std::string_view unit, const Range& range,
          std::string_view meaning) {
  return member<S>(pointer, name, "", unit, range, meaning, false);
}
Field entries(Field f, std::size_t least, std::size_t most) {
  f.min_length = least;
  f.max_length = most;
  return f;
}

}  // namespace

template <>
struct StructFields<Variable> {
  static std::vector<Field> fields() {
    return {need(&Variable::name, "name", "-", no_range(), "what a person calls it"),
            need(&Variable::pointer, "pointer", "-", no_range(), "JSON pointer into the scenario"),
            may(&Variable::unit, "unit", "-", no_range(), "its unit"),
            may(&Variable::type, "type", "-", no_range(), "continuous, integer or categorical"),
            may(&Variable::low, "low", "1", any(), "lower bound"),
            may(&Variable::high, "high", "1", any(), "upper bound"),
            entries(may(&Variable::options, "options", "-", no_range(), "values of a categorical variable"),
                    0, 1000)};
  }
};
template <>
struct StructFields<ObjectiveSpec> {
  static std::vector<Field> fields() {
    return {may(&ObjectiveSpec::kpi, "kpi", "-", no_range(), "KPI to improve, or"),
            may(&ObjectiveSpec::function, "function", "-", no_range(), "catalogue function to improve"),
            may(&ObjectiveSpec::output, "output", "-", no_range(), "output of the function"),
            may(&ObjectiveSpec::inputs, "inputs", "-", no_range(), "inputs of the function"),
            may(&ObjectiveSpec::direction, "direction", "-", no_range(), "which way is better")};
  }
};
template <>
struct StructFields<ConstraintSpec> {
  using C = ConstraintSpec;
  static std::vector<Field> fields() {
    return {
        may(&C::name, "name", "-", no_range(), "what a person calls it"),
        may(&C::kpi, "kpi", "-", no_range(), "KPI that is constrained"),
        may(&C::operation, "operation", "-", no_range(), "operation whose plan is constrained, * for all"),
        may(&C::quantity, "quantity", "-", no_range(), "quantity of the plan"),
        may(&C::limits, "limits", "-", no_range(), "limits of the plan: all, or the name of one"),
        may(&C::bands, "bands", "-", no_range(), "forbidden bands of the plan: all, or the name of one"),
        may(&C::function, "function", "-", no_range(), "catalogue function that is constrained"),
        may(&C::inputs, "inputs", "-", no_range(), "inputs of the function"),
        may(&C::output, "output", "-", no_range(), "output of the function"),
        may(&C::at_most, "at_most", "1", any(), "largest allowed value"),
        may(&C::at_least, "at_least", "1", any(), "smallest allowed value"),
        may(&C::confidence, "confidence", "1", closed(0.5, 0.9999),
            "with which a simulated KPI must meet it")};
  }
};
template <>
struct StructFields<FixedChange> {
  static std::vector<Field> fields() {
    return {need(&FixedChange::pointer, "pointer", "-", no_range(), "JSON pointer into the scenario"),
            need(&FixedChange::value, "value", "-", no_range(), "its value")};
  }
};
template <>
struct StructFields<SearchSpec> {
  static std::vector<Field> fields() {
    return {may(&SearchSpec::algorithm, "algorithm", "-", no_range(),
                "NLopt algorithm by name; empty: DIRECT-L, then BOBYQA, with constraints COBYLA and SLSQP"),
            may(&SearchSpec::local_algorithm, "local_algorithm", "-", no_range(),
                "NLopt algorithm that finishes, by name"),
            may(&SearchSpec::max_evaluations, "max_evaluations", "1", closed(1, 1e7),
                "evaluations of the long-run model"),
            may(&SearchSpec::relative_precision, "relative_precision", "1", closed(1e-15, 0.1),
                "of the variables, relative to their bounds"),
            may(&SearchSpec::starts, "starts", "1", closed(0, 1000), "local searches from scattered points")};
  }
};
template <>
struct StructFields<SimulationSpec> {
  using S = SimulationSpec;
  static std::vector<Field> fields() {
    return {
        may(&S::trials, "trials", "1", closed(0, 100'000), "points simulated at most, 0 for no stage two"),
        may(&S::first_replications, "first_replications", "1", closed(2, 10'000), "of the first sample"),
        may(&S::levels, "levels", "1", closed(1, 10), "samples, each twice as large as the one before"),
        may(&S::neighbourhood, "neighbourhood", "1", open_low(0, 1),
            "half-width of the first search box, as a share of the bounds")};
  }
};
template <>
struct StructFields<ChoiceSpec> {
  using S = ChoiceSpec;
  static std::vector<Field> fields() {
    return {may(&S::finalists, "finalists", "1", closed(1, 100), "points that go into the choice"),
            may(&S::confidence, "confidence", "1", open(0.5, 1), "probability of the correct selection"),
            may(&S::indifference, "indifference", "1", open_low(0, 1),
                "difference that does not matter, as a share of the objective"),
            may(&S::first_replications, "first_replications", "1", closed(3, 10'000), "of every finalist"),
            may(&S::max_replications, "max_replications", "1", closed(3, 100'000), "of any finalist")};
  }
};
template <>
struct StructFields<ConfirmationSpec> {
  static std::vector<Field> fields() {
    return {may(&ConfirmationSpec::replications, "replications", "1", closed(2, 100'000),
                "replications of baseline and best"),
            may(&ConfirmationSpec::confidence, "confidence", "1", closed(0.5, 0.9999),
                "confidence of the interval of the saving")};
  }
};
template <>
struct StructFields<BudgetSpec> {
  static std::vector<Field> fields() {
    return {may(&BudgetSpec::time_s, "time_s", "s", closed(0, 1e9),
                "ends the study as Ctrl-C does; 0 for no end"),
            may(&BudgetSpec::trials, "trials", "1", closed(0, 1e9), "likewise")};
  }
};
template <>
struct StructFields<FrontSpec> {
  static std::vector<Field> fields() {
    return {
        may(&FrontSpec::points, "points", "1", closed(2, 200), "of the front, per objective after the first"),
        may(&FrontSpec::replications, "replications", "1", closed(0, 100'000),
            "simulated at every point of the front")};
  }
};
template <>
struct StructFields<UncertainSpec> {
  static std::vector<Field> fields() {
    return {need(&UncertainSpec::name, "name", "-", no_range(), "what a person calls it"),
            need(&UncertainSpec::pointer, "pointer", "-", no_range(), "JSON pointer into the scenario"),
            may(&UncertainSpec::relative, "relative", "1", open(0, 1), "+- of its value")};
  }
};
template <>
struct StructFields<RobustSpec> {
  static std::vector<Field> fields() {
    return {may(&RobustSpec::samples, "samples", "1", closed(0, 1000), "of the uncertain inputs"),
            may(&RobustSpec::measure, "measure", "-", no_range(), "mean or worst of the samples")};
  }
};
template <>
struct StructFields<StudySpec> {
  using S = StudySpec;
  static std::vector<Field> fields() {
    return {need(&S::name, "name", "-", no_range(), "name of the study"),
            may(&S::description, "description", "-", no_range(), "what it asks"),
            need(&S::scenario, "scenario", "-", no_range(), "scenario file, relative to this file"),
            entries(may(&S::changes, "changes", "-", no_range(), "fixed changes of the scenario"), 0, 1000),
            entries(need(&S::variables, "variables", "-", no_range(), "what the study may choose"), 1, 100),
            may(&S::objective, "objective", "-", no_range(), "what is improved"),
            entries(may(&S::objectives, "objectives", "-", no_range(), "several of them"), 0, 4),
            entries(may(&S::constraints, "constraints", "-", no_range(), "what must hold"), 0, 1000),
            may(&S::search, "search", "-", no_range(), "stage one: the long-run model"),
            may(&S::simulation, "simulation", "-", no_range(), "stage two: simulated refinement"),
            may(&S::choice, "choice", "-", no_range(), "stage three: the choice among finalists"),
            may(&S::confirmation, "confirmation", "-", no_range(), "today against the best, paired"),
            may(&S::budget, "budget", "-", no_range(), "where the study ends in any case"),
            may(&S::front, "front", "-", no_range(), "of several objectives"),
            entries(may(&S::uncertain, "uncertain", "-", no_range(), "inputs nobody knows exactly"), 0, 100),
            may(&S::robust, "robust", "-", no_range(), "optimum over samples of the uncertain inputs")};
  }
};

}  // namespace verstat::models

namespace verstat::optimize {

using nlohmann::json;
using scenarios::Change;
using scenarios::InputError;

namespace {

[[noreturn]] void fail(const std::string& pointer, const std::string& text) {
  throw InputError(pointer, pointer + text);
}

void check_variable(const Variable& v, const std::string& at) {
  if (v.type == VariableType::categorical) {
    if (v.options.size() < 2) fail(at + "/options", ": a categorical variable needs at least 2 options");
    return;
  }
  if (!v.options.empty())
    fail(at + "/options", ": only a categorical variable has options; this one has low and high");
  if (!(v.low < v.high)) fail(at + "/low", fmt::format(" = {}, must be below high = {}", v.low, v.high));
  if (v.type == VariableType::integer)
    for (const auto& [end, value] : {std::pair{"low", v.low}, std::pair{"high", v.high}})
      if (value != std::floor(value) || std::abs(value) > 1e15)
        fail(fmt::format("{}/{}", at, end), fmt::format(" = {}, must be a whole number", value));
}

void check_constraint(const ConstraintSpec& c, const std::string& at) {
  const int kinds = static_cast<int>(!c.kpi.empty()) + static_cast<int>(!c.operation.empty()) +
                    static_cast<int>(!c.function.empty());
  if (kinds != 1) fail(at, ": must have exactly one of kpi, operation and function");
  const int items = static_cast<int>(!c.quantity.empty()) + static_cast<int>(!c.limits.empty()) +
                    static_cast<int>(!c.bands.empty());
  if (c.operation.empty() ? items != 0 : items != 1)
    fail(at, ": exactly one of quantity, limits and bands goes with operation, and only with it");
  if (!c.function.empty() && c.output.empty()) fail(at + "/output", ": which output of the function?");
  const bool own_limit = c.limits.empty() && c.bands.empty();
  if (own_limit != (c.at_most.has_value() != c.at_least.has_value()) ||
      (!own_limit && (c.at_most || c.at_least)))
    fail(at, own_limit ? ": must have either at_most or at_least"
                       : ": limits and bands of a plan bring their own allowed values");
}

}  // namespace

std::int64_t StudySpec::settings_of(const Variable& v) {
  switch (v.type) {
    case VariableType::continuous:
      return 0;
    case VariableType::integer:
      return static_cast<std::int64_t>(v.high - v.low) + 1;
    case VariableType::categorical:
      return static_cast<std::int64_t>(v.options.size());
  }
  return 0;
}

StudySpec load_study(const json& study) {
  StudySpec spec;
  const auto fields = models::StructFields<StudySpec>::fields();
  try {
    json named = study;
    if (named.is_object()) named.erase("$schema");
    models::read_fields(&spec, fields, scenarios::to_value(named));
    models::check_fields(&spec, fields);
  } catch (const models::DomainError& e) {
    throw InputError("/" + e.input(), (e.input().empty() ? "the study" : "/") + std::string(e.what()));
  }
  if (study.contains("objective") && study.contains("objectives"))
    fail("/objectives", ": a study has either objective or objectives");
  if (!study.contains("objective")) spec.objective.kpi = "cost_per_part";
  if (spec.objectives.empty()) spec.objectives.push_back(spec.objective);
  for (std::size_t k = 0; k < spec.objectives.size(); ++k) {
    const ObjectiveSpec& o = spec.objectives[k];
    const std::string at = study.contains("objectives") ? fmt::format("/objectives/{}", k) : "/objective";
    if (o.kpi.empty() == o.function.empty()) fail(at, ": must have exactly one of kpi and function");
    if (o.function.empty() != o.output.empty())
      fail(at + "/output", ": goes with function, and only with it");
  }
  spec.objective = spec.objectives.front();
  for (const auto& [member, name] : {std::pair{"algorithm", spec.search.algorithm},
                                     std::pair{"local_algorithm", spec.search.local_algorithm}})
    if (!name.empty() && !known_algorithm(name))
      fail(fmt::format("/search/{}", member),
           fmt::format(" = \"{}\", must be an NLopt algorithm such as LN_BOBYQA, LN_COBYLA, LD_SLSQP, "
                       "GN_DIRECT_L or GN_CRS2_LM, or be left out",
                       models::shortened(name, 100)));
  for (std::size_t k = 0; k < spec.variables.size(); ++k) {
    Variable& v = spec.variables[k];
    check_variable(v, fmt::format("/variables/{}", k));
    if (v.type == VariableType::categorical) {
      v.low = 0;
      v.high = static_cast<double>(v.options.size() - 1);
    }
  }
  for (std::size_t k = 0; k < spec.constraints.size(); ++k)
    check_constraint(spec.constraints[k], fmt::format("/constraints/{}", k));
  return spec;
}

json value_at(const Variable& v, double x) {
  if (v.type == VariableType::continuous) return x;
  const auto setting = static_cast<std::int64_t>(std::llround(x));
  if (v.type == VariableType::integer) return setting;
  return scenarios::to_json(v.options.at(static_cast<std::size_t>(setting)));
}

std::string text_at(const Variable& v, double x) {
  if (v.type == VariableType::continuous) return fmt::format("{:.6g}", x);
  const json value = value_at(v, x);
  if (value.is_object() && value.contains("kind")) return value.dump();
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::vector<Change> changes_at(const std::vector<Variable>& variables, const std::vector<double>& x) {
  std::vector<Change> changes;
  for (std::size_t k = 0; k < x.size(); ++k)
    changes.push_back({variables[k].pointer, value_at(variables[k], x[k])});
  return changes;
}

std::vector<Change> fixed_changes(const StudySpec& study) {
  std::vector<Change> changes;
  for (const FixedChange& change : study.changes)
    changes.push_back({change.pointer, json(scenarios::to_json(change.value))});
  return changes;
}

std::vector<std::string> pointer_tokens(const std::string& pointer) {
  std::vector<std::string> tokens;
  for (json::json_pointer p(pointer); !p.empty(); p.pop_back()) tokens.insert(tokens.begin(), p.back());
  return tokens;
}

}  // namespace verstat::optimize
