#include "optimize/problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "models/catalogue/catalogue.h"
#include "models/catalogue/closest.h"
#include "models/catalogue/shortened.h"
#include "optimize/problem_world.h"
#include "scenarios/model_json.h"

namespace verstat::optimize {

using nlohmann::json;
using scenarios::InputError;
using scenarios::Scenario;

namespace {

double* locate(Scenario& scenario, const std::string& pointer) {
  try {
    return models::locate_in_fields(&scenario, scenarios::scenario_fields(), pointer_tokens(pointer));
  } catch (const json::exception&) {
    return nullptr;  // no JSON pointer at all
  }
}

const json* find(const json& scenario, const std::string& pointer) {
  try {
    const json::json_pointer at(pointer);
    return scenario.contains(at) ? &scenario.at(at) : nullptr;
  } catch (const json::exception&) {
    return nullptr;
  }
}

// Inputs that say {"pointer": ...} stand for a number of the scenario.
const std::string* pointer_in(const models::Value& input) {
  const models::Value* pointer = input.find("pointer");
  return pointer == nullptr ? nullptr : pointer->text();
}

// What an input of a function finds at a place of the scenario: a continuous number as it stands, anything
// else as the text has it.
std::optional<models::Value> input_at(Problem::World& world, const std::string& pointer) {
  if (const double* address = locate(world.scenario, pointer)) return models::Value(*address);
  const json* there = find(world.text, pointer);
  if (there == nullptr || there->is_structured()) return std::nullopt;
  return scenarios::to_value(*there);
}

Checked against(double value, double allowed, bool at_most) {
  const double scale = allowed != 0 ? std::abs(allowed) : 1.0;
  return {value, allowed, (at_most ? allowed - value : value - allowed) / scale, scale};
}

Checked band_distance(const operations::ForbiddenBand& band) {
  const double width = band.high - band.low;
  Checked c{.value = band.value, .scale = width > 0 ? width : 1};
  const bool lower = band.value - band.low < band.high - band.value;
  c.allowed = lower ? band.low : band.high;
  c.margin = std::max(band.low - band.value, band.value - band.high) / c.scale;
  return c;
}

}  // namespace

Problem::~Problem() = default;

Problem::Problem(const StudySpec& study, json scenario, std::vector<Shift> shifts)
    : study_(study), scenario_(std::move(scenario)), shifts_(std::move(shifts)) {
  for (const Variable& v : study.variables)
    dimensions_.push_back({.bounds = {v.low, v.high},
                           .discrete = v.type != VariableType::continuous,
                           .ordered = v.type != VariableType::categorical});
  needs_model_ = std::any_of(study.objectives.begin(), study.objectives.end(),
                             [](const ObjectiveSpec& o) { return !o.kpi.empty(); }) ||
                 std::any_of(study.constraints.begin(), study.constraints.end(),
                             [](const ConstraintSpec& c) { return !c.kpi.empty(); });
  baseline_world_ = make_world(scenario_, needs_model_);
  if (!baseline_world_->refused.empty()) throw InputError("", baseline_world_->refused);
  for (std::size_t k = 0; k < study.variables.size(); ++k) {
    const Variable& v = study.variables[k];
    const std::string at = fmt::format("/variables/{}", k);
    if (v.type == VariableType::continuous) {
      const double* address = baseline_world_->variables[k];
      if (address == nullptr)
        throw InputError(at + "/pointer",
                         fmt::format("{}/pointer = \"{}\", leads to no continuous number of the scenario", at,
                                     models::shortened(v.pointer, 200)));
      baseline_.push_back(*address);
      continue;
    }
    const json* present = find(scenario_, v.pointer);
    if (present == nullptr)
      throw InputError(at + "/pointer", fmt::format("{}/pointer = \"{}\", leads to nothing in the scenario",
                                                    at, models::shortened(v.pointer, 200)));
    if (v.type == VariableType::integer) {
      if (!present->is_number_integer())
        throw InputError(at + "/pointer", fmt::format("{}/pointer = \"{}\", leads to {}, no whole number", at,
                                                      v.pointer, models::shortened(present->dump(), 100)));
      baseline_.push_back(present->get<double>());
      continue;
    }
    std::size_t option = 0;
    while (option < v.options.size() && json(scenarios::to_json(v.options[option])) != *present) ++option;
    if (option == v.options.size())
      throw InputError(at + "/options",
                       fmt::format("{}/options: what the scenario has, {}, must be one of them", at,
                                   models::shortened(present->dump(), 200)));
    baseline_.push_back(static_cast<double>(option));
  }
  check_bounds();
  for (std::size_t k = 0; k < study.objectives.size(); ++k) {
    const ObjectiveSpec& objective = study.objectives[k];
    objective_kpis_.emplace_back();
    objective_functions_.emplace_back();
    if (!objective.function.empty())
      objective_functions_.back() =
          function_at(study.objectives.size() > 1 ? fmt::format("/objectives/{}", k) : "/objective",
                      objective.function, objective.output, objective.inputs, *baseline_world_);
    if (baseline_world_->model == nullptr || objective.kpi.empty()) continue;
    objective_kpis_.back() = baseline_world_->model->kpi(objective.kpi);
    if (!objective_kpis_.back() && not_covered_.empty())
      not_covered_ = fmt::format("the long-run model does not know the KPI \"{}\"", objective.kpi);
  }
  expand_conditions(*baseline_world_);
}

void Problem::check_bounds() const {
  const std::vector<Variable>& variables = study_.variables;
  for (std::size_t k = 0; k < variables.size(); ++k) {
    const Variable& v = variables[k];
    std::vector<std::pair<std::string, double>> ends;
    if (v.type == VariableType::categorical) {
      for (std::size_t o = 0; o < v.options.size(); ++o)
        ends.emplace_back(fmt::format("options/{}", o), static_cast<double>(o));
    } else {
      ends = {{"low", v.low}, {"high", v.high}};
    }
    for (const auto& [end, value] : ends) try {
        (void)scenarios::load(scenarios::apply(scenario_, {{v.pointer, value_at(v, value)}}));
      } catch (const InputError& e) {
        throw InputError(fmt::format("/variables/{}/{}", k, end),
                         fmt::format("/variables/{}/{} = {}, is not valid in the scenario: {}", k, end,
                                     text_at(v, value), e.what()));
      }
  }
}

std::unique_ptr<Problem::World> Problem::make_world(const json& text, bool with_model) {
  auto world = std::make_unique<World>();
  try {
    world->scenario = scenarios::load(text);
    world->text = text;
  } catch (const InputError& e) {
    world->refused = e.what();
    return world;
  }
  for (const Shift& shift : shifts_) {
    double* address = locate(world->scenario, shift.pointer);
    if (address == nullptr)
      throw InputError("/uncertain",
                       fmt::format("/uncertain: \"{}\" leads to no continuous number of the scenario",
                                   models::shortened(shift.pointer, 200)));
    *address *= shift.factor;
  }
  for (const Variable& v : study_.variables)
    world->variables.push_back(v.type == VariableType::continuous ? locate(world->scenario, v.pointer)
                                                                  : nullptr);
  if (with_model && not_covered_.empty()) try {
      world->model = std::make_unique<LongRunModel>(world->scenario);
    } catch (const InputError& e) {
      // A setting that only the simulation knows: its plans are known all the same.
      if (baseline_world_ == nullptr) not_covered_ = e.what();
    }
  return world;
}

Condition Problem::function_at(const std::string& at, const std::string& function, const std::string& output,
                               const models::Value& inputs, World& world) const {
  Condition c{.kind = Condition::Kind::function};
  try {
    c.function = &models::catalogue().at(function);
  } catch (const models::ModelError& e) {
    throw InputError(at + "/function", fmt::format("{}/function: {}", at, e.what()));
  }
  const auto found = std::find_if(c.function->outputs.begin(), c.function->outputs.end(),
                                  [&](const models::Field& f) { return f.name == output; });
  if (found == c.function->outputs.end()) {
    std::vector<std::string> names;
    for (const auto& f : c.function->outputs) names.push_back(f.name);
    throw InputError(at + "/output", fmt::format("{}/output = \"{}\", {} has no such output; closest: \"{}\"",
                                                 at, output, function, models::closest(output, names)));
  }
  c.unit = found->unit;
  c.item = output;
  c.inputs = inputs;
  if (c.inputs.map() == nullptr) c.inputs = models::Value(models::Value::Map{});
  for (const auto& [name, input] : *c.inputs.map())
    if (const std::string* pointer = pointer_in(input); pointer != nullptr && !input_at(world, *pointer))
      throw InputError(
          at + "/inputs/" + name,
          fmt::format("{}/inputs/{}/pointer = \"{}\", leads to nothing in the scenario", at, name, *pointer));
  return c;
}

void Problem::expand_conditions(World& world) {
  std::vector<operations::CutPlan> plans;
  for (const auto& operation : world.scenario.operations)
    plans.push_back(scenarios::plan(world.scenario, operation));
  for (std::size_t k = 0; k < study_.constraints.size(); ++k) {
    const ConstraintSpec& spec = study_.constraints[k];
    const std::string at = fmt::format("/constraints/{}", k);
    Condition base{.at_most = spec.at_most.has_value(),
                   .allowed = spec.at_most ? *spec.at_most : spec.at_least.value_or(0),
                   .confidence = spec.confidence};
    const auto add = [&](Condition c, const std::string& name) {
      c.name = spec.name.empty()
                   ? name
                   : (study_.constraints[k].operation == "*" ? spec.name + ": " + name : spec.name);
      conditions_.push_back(std::move(c));
    };
    if (!spec.kpi.empty()) {
      Condition c = base;
      c.kind = Condition::Kind::kpi;
      c.item = spec.kpi;
      if (world.model) c.long_run_kpi = world.model->kpi(spec.kpi);
      add(c, spec.kpi);
    } else if (!spec.function.empty()) {
      Condition c = function_at(at, spec.function, spec.output, spec.inputs, world);
      c.at_most = base.at_most;
      c.allowed = base.allowed;
      c.confidence = base.confidence;
      add(c, fmt::format("{} of {}", spec.output, spec.function));
    } else {
      bool found = false;
      bool operation_found = false;
      for (std::size_t o = 0; o < plans.size(); ++o) {
        const std::string& operation = world.scenario.operations[o].name;
        if (spec.operation != "*" && spec.operation != operation) continue;
        operation_found = true;
        const auto one = [&](Condition::Kind kind, const std::string& item, const char* unit, bool at_most) {
          Condition c = base;
          c.kind = kind;
          c.item = item;
          c.unit = unit;
          c.operation = o;
          if (kind != Condition::Kind::quantity) c.at_most = at_most;
          add(c, fmt::format("{} of {}", item, operation));
          found = true;
        };
        if (!spec.quantity.empty()) {
          for (const auto& q : plans[o].quantities)
            if (spec.quantity == q.name) one(Condition::Kind::quantity, q.name, q.unit, true);
        } else if (!spec.limits.empty()) {
          for (const auto& l : plans[o].limits)
            if (spec.limits == "all" || spec.limits == l.name)
              one(Condition::Kind::limit, l.name, l.unit, l.at_most);
        } else {
          for (const auto& b : plans[o].bands)
            if (spec.bands == "all" || spec.bands == b.name) one(Condition::Kind::band, b.name, b.unit, true);
        }
      }
      if (!operation_found) {
        std::vector<std::string> names;
        for (const auto& operation : world.scenario.operations) names.push_back(operation.name);
        throw InputError(at + "/operation",
                         fmt::format("{}/operation = \"{}\", there is no such operation; closest: \"{}\"", at,
                                     spec.operation, models::closest(spec.operation, names)));
      }
      const bool all = spec.limits == "all" || spec.bands == "all";
      if (!found && !all)
        throw InputError(
            at, fmt::format("{}: the plan of operation \"{}\" has no {} \"{}\"", at, spec.operation,
                            !spec.quantity.empty() ? "quantity" : (!spec.limits.empty() ? "limit" : "band"),
                            spec.quantity + spec.limits + spec.bands));
    }
  }
}

Checked Problem::check_plan(const Condition& c, const operations::CutPlan& plan) const {
  Checked checked{.margin = 1};  // of what the plan does not have here
  if (c.kind == Condition::Kind::quantity) {
    if (const auto value = plan.value_of(c.item)) checked = against(*value, c.allowed, c.at_most);
  } else if (c.kind == Condition::Kind::limit) {
    for (const auto& l : plan.limits)
      if (c.item == l.name) checked = against(l.value, l.allowed, l.at_most);
  } else {
    for (const auto& b : plan.bands)
      if (c.item == b.name) {
        const Checked one = band_distance(b);
        if (one.margin < checked.margin) checked = one;  // bands of one knob may share a name
      }
  }
  return checked;
}

Checked Problem::check_function(const Condition& c, World& world) const {
  models::Value::Map inputs = *c.inputs.map();
  for (auto& [name, input] : inputs)
    if (const std::string* pointer = pointer_in(input)) {
      auto there = input_at(world, *pointer);
      if (!there) throw InputError("", fmt::format("\"{}\" leads to nothing here", *pointer));
      input = std::move(*there);
    }
  const models::Value outputs = c.function->evaluate(models::Value(std::move(inputs)));
  const models::Value* output = outputs.find(c.item);
  double value = std::numeric_limits<double>::quiet_NaN();
  if (output != nullptr && output->real() != nullptr) value = *output->real();
  if (output != nullptr && output->integer() != nullptr) value = static_cast<double>(*output->integer());
  if (output != nullptr && output->boolean() != nullptr) value = *output->boolean() ? 1 : 0;
  return against(value, c.allowed, c.at_most);
}

Look Problem::look_in(World& world) const {
  Look look;
  std::vector<operations::CutPlan> own_plans;
  if (world.model != nullptr) {
    look.long_run = world.model->evaluate();
  } else {
    for (const auto& operation : world.scenario.operations)
      own_plans.push_back(scenarios::plan(world.scenario, operation));
  }
  for (std::size_t k = 0; k < study_.objectives.size(); ++k) {
    if (objective_functions_[k])
      look.objectives.push_back(check_function(*objective_functions_[k], world).value);
    else if (objective_kpis_[k] && look.long_run)
      look.objectives.push_back(world.model->value(*look.long_run, *objective_kpis_[k]));
  }
  const auto& plans = look.long_run ? look.long_run->plans : own_plans;
  for (const Condition& c : conditions_) {
    Checked checked{.margin = 0};
    switch (c.kind) {
      case Condition::Kind::kpi:
        if (c.long_run_kpi && world.model != nullptr)
          checked = against(world.model->value(*look.long_run, *c.long_run_kpi), c.allowed, c.at_most);
        break;
      case Condition::Kind::quantity:
      case Condition::Kind::limit:
      case Condition::Kind::band:
        checked = check_plan(c, plans[c.operation]);
        break;
      case Condition::Kind::function:
        checked = check_function(c, world);
        break;
    }
    look.conditions.push_back(checked);
  }
  return look;
}

Problem::World& Problem::world_at(const std::vector<double>& x) {
  std::vector<double> key;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (dimensions_[k].discrete) key.push_back(x[k]);
  auto& world = worlds_[key];
  if (world == nullptr) {
    std::vector<scenarios::Change> changes;
    for (std::size_t k = 0; k < x.size(); ++k)
      if (dimensions_[k].discrete)
        changes.push_back({study_.variables[k].pointer, value_at(study_.variables[k], x[k])});
    world = make_world(scenarios::apply(scenario_, changes), needs_model_);
  }
  if (world->refused.empty())
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!dimensions_[k].discrete) {
        // A category may bring a structure that lacks the number.
        if (world->variables[k] != nullptr) *world->variables[k] = x[k];
      }
  return *world;
}

Look Problem::look(const std::vector<double>& x) {
  World& world = world_at(x);
  if (!world.refused.empty()) throw InputError("", world.refused);
  return look_in(world);
}

Look Problem::look_at_baseline() {
  return look_in(*baseline_world_);
}

const Scenario& Problem::typed_scenario_at(const std::vector<double>& x) {
  return world_at(x).scenario;
}

Problem::Outcome Problem::evaluate(const std::vector<double>& x) {
  constexpr double undefined = std::numeric_limits<double>::infinity();
  Outcome outcome{.objectives = std::vector<double>(study_.objectives.size(), undefined),
                  .margins = std::vector<double>(conditions_.size(), -1.0)};
  World& world = world_at(x);
  if (!world.refused.empty()) return outcome;
  try {
    const Look look = look_in(world);
    for (std::size_t k = 0; k < look.objectives.size() && look.objectives.size() == study_.objectives.size();
         ++k) {
      const double sign = study_.objectives[k].direction == Direction::maximize ? -1 : 1;
      if (std::isfinite(look.objectives[k])) outcome.objectives[k] = sign * look.objectives[k];
    }
    for (std::size_t k = 0; k < look.conditions.size(); ++k)
      outcome.margins[k] = std::isfinite(look.conditions[k].margin) ? look.conditions[k].margin : -1.0;
  } catch (const models::ModelError&) {
    // The process models refuse this regime: an undefined point.
  } catch (const models::DomainError&) {
  } catch (const InputError&) {
  }
  return outcome;
}

json Problem::scenario_at(const std::vector<double>& x) const {
  return scenarios::apply(scenario_, changes_at(study_.variables, x));
}

std::optional<MeasuredSlopes> measured(std::optional<Problem::OutcomeSlopes> slopes, std::size_t objective) {
  if (!slopes) return std::nullopt;
  return MeasuredSlopes{std::move(slopes->objectives[objective]), std::move(slopes->margins)};
}

Measured measured(const Problem::Outcome& outcome, std::size_t objective) {
  return {outcome.objectives[objective], outcome.margins};
}

double shown_value(const ObjectiveSpec& objective, double searched) {
  return objective.direction == Direction::maximize ? -searched : searched;
}

}  // namespace verstat::optimize
