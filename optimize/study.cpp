#include "optimize/study.h"

#include <cmath>

#include <fmt/format.h>

#include "optimize/renewal_reward.h"
#include "scenarios/model_json.h"

namespace verstat::models {

using optimize::ConfirmationSpec;
using optimize::Direction;
using optimize::ObjectiveSpec;
using optimize::SearchSpec;
using optimize::StudySpec;
using optimize::Variable;

template <>
struct EnumNames<Direction> {
  static constexpr std::array names{std::pair{Direction::minimize, "minimize"}};
};

template <>
struct StructFields<Variable> {
  static std::vector<Field> fields() {
    return {member<Variable>(&Variable::name, "name", "", "-", no_range(), "what a person calls it"),
            member<Variable>(&Variable::pointer, "pointer", "", "-", no_range(),
                             "JSON pointer into the scenario"),
            member<Variable>(&Variable::unit, "unit", "", "-", no_range(), "its unit", false),
            member<Variable>(&Variable::low, "low", "", "1", any(), "lower bound"),
            member<Variable>(&Variable::high, "high", "", "1", any(), "upper bound")};
  }
};
template <>
struct StructFields<ObjectiveSpec> {
  static std::vector<Field> fields() {
    return {member<ObjectiveSpec>(&ObjectiveSpec::kpi, "kpi", "", "-", no_range(), "KPI to improve"),
            member<ObjectiveSpec>(&ObjectiveSpec::direction, "direction", "", "-", no_range(),
                                  "which way is better", false)};
  }
};
template <>
struct StructFields<SearchSpec> {
  static std::vector<Field> fields() {
    return {member<SearchSpec>(&SearchSpec::algorithm, "algorithm", "", "-", no_range(),
                               "NLopt algorithm without derivatives; empty: DIRECT-L, then BOBYQA", false),
            member<SearchSpec>(&SearchSpec::max_evaluations, "max_evaluations", "", "1", closed(1, 1e7),
                               "evaluations of the long-run model", false),
            member<SearchSpec>(&SearchSpec::relative_precision, "relative_precision", "", "1",
                               closed(1e-15, 0.1), "of the variables, relative to their bounds", false)};
  }
};
template <>
struct StructFields<ConfirmationSpec> {
  static std::vector<Field> fields() {
    return {member<ConfirmationSpec>(&ConfirmationSpec::replications, "replications", "", "1",
                                     closed(2, 100'000), "replications of baseline and best", false),
            member<ConfirmationSpec>(&ConfirmationSpec::confidence, "confidence", "", "1",
                                     closed(0.5, 0.9999), "confidence of the interval of the saving", false)};
  }
};
template <>
struct StructFields<StudySpec> {
  static std::vector<Field> fields() {
    Field variables = member<StudySpec>(&StudySpec::variables, "variables", "", "-", no_range(),
                                        "what the study may choose");
    variables.min_length = 1;
    variables.max_length = 100;
    return {member<StudySpec>(&StudySpec::name, "name", "", "-", no_range(), "name of the study"),
            member<StudySpec>(&StudySpec::scenario, "scenario", "", "-", no_range(),
                              "scenario file, relative to this file"),
            std::move(variables),
            member<StudySpec>(&StudySpec::objective, "objective", "", "-", no_range(), "what is improved"),
            member<StudySpec>(&StudySpec::search, "search", "", "-", no_range(),
                              "stage one: the long-run model", false),
            member<StudySpec>(&StudySpec::confirmation, "confirmation", "", "-", no_range(),
                              "stage two: simulation under common random numbers", false)};
  }
};

}  // namespace verstat::models

namespace verstat::optimize {

using nlohmann::json;
using scenarios::Change;
using scenarios::InputError;
using scenarios::Scenario;

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
  if (spec.objective.kpi != "cost_per_part")
    throw InputError("/objective/kpi",
                     fmt::format("/objective/kpi = \"{}\", the long-run model knows \"cost_per_part\"",
                                 spec.objective.kpi.substr(0, 100)));
  if (!spec.search.algorithm.empty() && !known_algorithm(spec.search.algorithm))
    throw InputError(
        "/search/algorithm",
        fmt::format("/search/algorithm = \"{}\", must be an NLopt algorithm without derivatives such as "
                    "LN_BOBYQA, LN_COBYLA, GN_DIRECT_L or GN_CRS2_LM, or be left out",
                    spec.search.algorithm.substr(0, 100)));
  for (std::size_t k = 0; k < spec.variables.size(); ++k)
    if (!(spec.variables[k].low < spec.variables[k].high))
      throw InputError(fmt::format("/variables/{}/low", k),
                       fmt::format("/variables/{}/low = {}, must be below high = {}", k,
                                   spec.variables[k].low, spec.variables[k].high));
  return spec;
}

namespace {

std::vector<std::string> tokens_of(const std::string& pointer) {
  std::vector<std::string> tokens;
  for (json::json_pointer p(pointer); !p.empty(); p.pop_back()) tokens.insert(tokens.begin(), p.back());
  return tokens;
}

// Where the variables stand in the scenario: moving one costs an assignment, not a parse.
std::vector<double*> addresses(const StudySpec& study, Scenario& scenario) {
  std::vector<double*> all;
  for (std::size_t k = 0; k < study.variables.size(); ++k) {
    const Variable& v = study.variables[k];
    double* address = nullptr;
    try {
      address = models::locate_in_fields(&scenario, scenarios::scenario_fields(), tokens_of(v.pointer));
    } catch (const json::exception&) {
      // No JSON pointer at all: said below.
    }
    if (address == nullptr)
      throw InputError(
          fmt::format("/variables/{}/pointer", k),
          fmt::format("/variables/{}/pointer = \"{}\", leads to no continuous number of the scenario", k,
                      v.pointer.substr(0, 200)));
    all.push_back(address);
  }
  return all;
}

}  // namespace

std::vector<Change> changes_at(const StudySpec& study, const std::vector<double>& values) {
  std::vector<Change> changes;
  for (std::size_t k = 0; k < values.size(); ++k) changes.push_back({study.variables[k].pointer, values[k]});
  return changes;
}

AnalyticOutcome optimize_analytic(const StudySpec& study, const json& scenario_text) {
  Scenario scenario = scenarios::load(scenario_text);
  // Valid at both ends of every variable: inside, the ranges of numbers hold as well.
  for (std::size_t k = 0; k < study.variables.size(); ++k)
    for (const auto& [end, value] :
         {std::pair{"low", study.variables[k].low}, std::pair{"high", study.variables[k].high}}) {
      (void)addresses(study, scenario);
      try {
        (void)scenarios::load(scenarios::apply(scenario_text, {{study.variables[k].pointer, value}}));
      } catch (const InputError& e) {
        throw InputError(
            fmt::format("/variables/{}/{}", k, end),
            fmt::format("/variables/{}/{} = {}, is not valid in the scenario: {}", k, end, value, e.what()));
      }
    }
  const std::vector<double*> at = addresses(study, scenario);
  AnalyticOutcome outcome;
  for (const double* value : at) outcome.baseline.push_back(*value);
  const LongRunModel model(scenario);
  outcome.baseline_value = model.cost_per_part();

  std::vector<Bounds> bounds;
  std::vector<double> start = outcome.baseline;
  for (std::size_t k = 0; k < at.size(); ++k) {
    bounds.push_back({study.variables[k].low, study.variables[k].high});
    start[k] = std::clamp(start[k], bounds[k].low, bounds[k].high);
  }
  const auto objective = [&](const std::vector<double>& x) {
    for (std::size_t k = 0; k < x.size(); ++k) *at[k] = x[k];
    return model.cost_per_part();
  };
  outcome.search = minimize(objective, bounds, start,
                            {.algorithm = study.search.algorithm,
                             .max_evaluations = static_cast<int>(study.search.max_evaluations),
                             .relative_precision = study.search.relative_precision,
                             .seed = scenario.simulation.seed.value});
  return outcome;
}

Confirmation confirm(const StudySpec& study, const json& scenario_text, const std::vector<double>& best,
                     int threads, const shop::Progress& progress) {
  Scenario baseline = scenarios::load(scenario_text);
  Scenario changed = scenarios::load(scenarios::apply(scenario_text, changes_at(study, best)));
  baseline.simulation.replications = study.confirmation.replications;
  changed.simulation.replications = study.confirmation.replications;
  const std::int64_t all = 2 * study.confirmation.replications;
  const auto part = [&](std::int64_t before) -> shop::Progress {
    if (!progress) return {};
    return [&progress, before, all](std::int64_t done, std::int64_t) { progress(before + done, all); };
  };
  Confirmation result;
  result.baseline = shop::run_scenario(baseline, threads, part(0));
  result.best = shop::run_scenario(changed, threads, part(study.confirmation.replications));
  result.saving = shop::paired_difference(result.best, result.baseline, study.objective.kpi,
                                          study.confirmation.confidence);
  if (!result.saving.mean || !result.saving.half_width ||
      std::abs(*result.saving.mean) <= *result.saving.half_width)
    result.verdict = "not distinguishable";
  else
    result.verdict = *result.saving.mean > 0 ? "better" : "worse";
  return result;
}

}  // namespace verstat::optimize
