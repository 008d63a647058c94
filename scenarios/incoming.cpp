#include "scenarios/incoming.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/format.h>

#include "models/catalogue/closest.h"
#include "models/math/normal.h"
#include "scenarios/check.h"
#include "scenarios/route.h"

namespace verstat::scenarios {

using models::DomainError;
using models::Value;
using operations::CutPlan;
using operations::Process;
using ProcessBinding = models::detail::Binding<Process>;

namespace {

// Bounds of what a file may ask for; each is far beyond a route on paper.
constexpr std::size_t most_handed_on = 1000;
constexpr std::size_t longest_chain = 50;

std::vector<std::string> path_of(const std::string& input) {
  std::vector<std::string> path;
  std::size_t from = 0;
  for (std::size_t at = input.find('/'); at != std::string::npos; at = input.find('/', from)) {
    path.push_back(input.substr(from, at - from));
    from = at + 1;
  }
  path.push_back(input.substr(from));
  return path;
}

// The same value with another number at the end of the path. Throws DomainError when there is no such member,
// or none that could be a number.
Value with_number(const Value& value, const std::string& input, std::span<const std::string> path,
                  double number) {
  if (path.empty()) {
    if (!value.is_null() && value.real() == nullptr && value.integer() == nullptr)
      throw DomainError(input, fmt::format("{} = {}, is not a number", input, value.to_string()));
    return number;
  }
  std::vector<std::string> names;
  Value::Map members;
  if (value.map() != nullptr) members = *value.map();
  for (auto& [name, member] : members) {
    if (name == path.front()) {
      member = with_number(member, input, path.subspan(1), number);
      return members;
    }
    names.push_back(name);
  }
  throw DomainError(input, names.empty()
                               ? fmt::format("{}: there is no such member of the process", input)
                               : fmt::format("{}: there is no such member of the process; closest: \"{}\"",
                                             input, models::closest(path.front(), names)));
}

models::Field process_field() {
  models::Field field;
  field.name = "process";
  return field;
}

// Sets a number of the process, one that was left out included.
void set_input(Process& process, const std::string& input, double value) {
  const auto path = path_of(input);
  if (double* number = ProcessBinding::locate(process, path)) {
    *number = value;
  } else {
    const Value whole = with_number(ProcessBinding::write(process), input, path, value);
    ProcessBinding::read(process, whole, process_field());
  }
}

// The field that describes an input; null when the path leads through a list or a choice.
const models::Field* described(const Process& process, const std::string& input) {
  const std::vector<models::Field>* fields = &process.kind()->fields();
  const models::Field* field = nullptr;
  for (const std::string& name : path_of(input)) {
    if (fields == nullptr) return nullptr;
    const auto found =
        std::find_if(fields->begin(), fields->end(), [&](const models::Field& f) { return f.name == name; });
    if (found == fields->end()) return nullptr;
    field = &*found;
    fields = field->access->type_info().fields;
  }
  return field;
}

const Operation& source_of(const Scenario& s, const Incoming& incoming) {
  return *find_named(s.operations, incoming.from);
}

// Steps reached from `start` along `next` and, when asked, rework; steps that `stops` names are reached but
// not left. The last entry is the store.
std::vector<bool> reach(const Route& route, const std::vector<std::size_t>& start, bool with_rework,
                        const std::function<bool(std::size_t)>& stops) {
  std::vector<bool> reached(route.size() + 1, false);
  std::vector<std::size_t> open = start;
  while (!open.empty()) {
    const std::size_t k = std::min(open.back(), route.size());
    open.pop_back();
    if (reached[k]) continue;
    reached[k] = true;
    if (k == route.size() || stops(k)) continue;
    for (const RouteBranch& branch : route[k].next)
      if (branch.probability > 0) open.push_back(branch.to);
    if (with_rework && route[k].rework != route_end) open.push_back(route[k].rework);
  }
  return reached;
}

std::vector<std::size_t> after(const RouteStep& step) {
  std::vector<std::size_t> next;
  for (const RouteBranch& branch : step.next)
    if (branch.probability > 0) next.push_back(branch.to);
  return next;
}

std::vector<bool> steps_that_leave(const Scenario& s, const Route& route, const std::string& quantity) {
  std::vector<bool> leaves;
  for (const RouteStep& step : route)
    leaves.push_back(plan(s, s.operations[step.operation]).left(quantity) != nullptr);
  return leaves;
}

std::vector<std::string> states_left(const CutPlan& plan) {
  std::vector<std::string> names;
  for (const operations::PartState& state : plan.leaves) names.emplace_back(state.quantity);
  return names;
}

}  // namespace

Process received(const Scenario& scenario, const Operation& operation) {
  PlansBefore before;
  return received(scenario, operation, before);
}

Process received(const Scenario& scenario, const Operation& operation, PlansBefore& before) {
  Process process = operation.process;
  for (const Incoming& incoming : operation.incoming) {
    auto found = before.find(incoming.from);
    if (found == before.end()) {
      const Operation& source = source_of(scenario, incoming);
      const Machine& machine = scenario.machines.at(groups_of(scenario, source).at(0));
      found = before.emplace(incoming.from, plan(scenario, source, machine, before)).first;
    }
    const auto value = found->second.value_of(incoming.quantity);
    models::require(
        value.has_value(), incoming.input, Value(),
        fmt::format("should come from \"{}\", which leaves no {}", incoming.from, incoming.quantity));
    set_input(process, incoming.input, *value * incoming.factor);
  }
  ProcessBinding::check(process, process_field());
  return process;
}

std::vector<std::size_t> last_steps_that_leave(const Scenario& scenario, std::size_t part,
                                               const std::string& quantity) {
  const Route route = route_of(scenario, scenario.parts[part]);
  const std::vector<bool> leaves = steps_that_leave(scenario, route, quantity);
  std::vector<std::size_t> last;
  for (std::size_t k = 0; k < route.size(); ++k) {
    if (!leaves[k]) continue;
    const auto later = reach(route, after(route[k]), false, [](std::size_t) { return false; });
    bool again = false;
    for (std::size_t j = 0; j < route.size(); ++j) again = again || (j != k && later[j] && leaves[j]);
    if (!again) last.push_back(k);
  }
  return last;
}

double share_that_fails(const Requirement& requirement, const CutPlan& plan) {
  const double value = plan.value_of(requirement.quantity).value_or(0);
  const operations::PartState* state = plan.left(requirement.quantity);
  const double sd = std::hypot(state == nullptr ? 0.0 : state->sd, requirement.sd);
  const auto beyond = [&](double distance) {  // of the bound from the value, towards what is allowed
    return sd > 0 ? models::normal_cdf(-distance / sd) : (distance < 0 ? 1.0 : 0.0);
  };
  double fails = 0;
  if (requirement.at_least) fails += beyond(value - *requirement.at_least);
  if (requirement.at_most) fails += beyond(*requirement.at_most - value);
  return std::min(1.0, fails);
}

void check_sources(const Scenario& s) {
  for (std::size_t o = 0; o < s.operations.size(); ++o)
    for (std::size_t i = 0; i < s.operations[o].incoming.size(); ++i)
      check_reference(s.operations, s.operations[o].incoming[i].from,
                      fmt::format("/operations/{}/incoming/{}/from", o, i), "operation");
  std::size_t handed_on = 0;
  for (const Operation& operation : s.operations) handed_on += operation.incoming.size();
  if (handed_on > most_handed_on)
    fail("/operations", fmt::format("{} members that are taken from operations before", handed_on),
         fmt::format("allowed at most {}", most_handed_on));
  // Operations behind each other. Who receives from itself stands behind itself, for ever.
  std::vector<std::size_t> depth(s.operations.size(), 0);
  for (std::size_t round = 0; round <= longest_chain; ++round) {
    bool changed = false;
    for (std::size_t o = 0; o < s.operations.size(); ++o)
      for (const Incoming& incoming : s.operations[o].incoming) {
        const auto source = static_cast<std::size_t>(&source_of(s, incoming) - s.operations.data());
        if (depth[o] > depth[source]) continue;
        depth[o] = depth[source] + 1;
        changed = true;
        if (depth[o] > longest_chain)
          fail(fmt::format("/operations/{}/incoming", o), quoted(s.operations[o].name),
               fmt::format("receives from itself over other operations, or over more than {} of them",
                           longest_chain));
      }
    if (!changed) break;
  }
}

void check_incoming(const Scenario& s, const Operation& operation, const std::string& at) {
  for (std::size_t i = 0; i < operation.incoming.size(); ++i) {
    const Incoming& incoming = operation.incoming[i];
    const std::string here = fmt::format("{}/incoming/{}", at, i);
    const Operation& source = source_of(s, incoming);
    const CutPlan before = plan(s, source);
    if (before.left(incoming.quantity) == nullptr) {
      const auto names = states_left(before);
      fail(here + "/quantity", quoted(incoming.quantity),
           names.empty() ? fmt::format("operation \"{}\" leaves nothing that could be handed on", source.name)
                         : fmt::format("is not left by operation \"{}\"; closest: \"{}\"", source.name,
                                       models::closest(incoming.quantity, names)));
    }
    for (const std::size_t g : groups_of(s, source))
      if (plan(s, source, s.machines[g]).value_of(incoming.quantity) != before.value_of(incoming.quantity))
        fail(here + "/from", quoted(source.name),
             fmt::format("leaves another {} on machine \"{}\" than on \"{}\": give each an operation of its "
                         "own",
                         incoming.quantity, s.machines[g].name,
                         s.machines[groups_of(s, source).front()].name));
    for (std::size_t j = 0; j < i; ++j)
      if (operation.incoming[j].input == incoming.input)
        fail(here + "/input", quoted(incoming.input),
             fmt::format("is already that of {}/incoming/{}", at, j));
    try {
      Process copy = operation.process;
      set_input(copy, incoming.input, before.value_of(incoming.quantity).value_or(0) * incoming.factor);
    } catch (const DomainError& e) {
      throw InputError(here + "/input", fmt::format("{}/input: {}", here, e.what()));
    }
    const models::Field* input = described(operation.process, incoming.input);
    const std::string unit = before.unit_of(incoming.quantity);
    if (input != nullptr && input->unit != unit && incoming.factor == 1)
      fail(here + "/input", quoted(incoming.input),
           fmt::format("is in {}, but {} is in {}: give the factor between them", input->unit,
                       incoming.quantity, unit));
  }
}

void check_received_on_route(const Scenario& s, const PartType& part, const std::string& at) {
  const Route route = route_of(s, part);
  for (std::size_t k = 0; k < route.size(); ++k) {
    const Operation& operation = s.operations[route[k].operation];
    for (const Incoming& incoming : operation.incoming) {
      const auto source = static_cast<std::size_t>(&source_of(s, incoming) - s.operations.data());
      const auto without =
          reach(route, {0}, true, [&](std::size_t j) { return route[j].operation == source; });
      if (without[k] && route[k].operation != source)
        fail(fmt::format("{}/{}/{}", at, part.steps.empty() ? "route" : "steps", k), quoted(operation.name),
             fmt::format("receives {} from \"{}\", but parts \"{}\" can come here without having been there",
                         incoming.quantity, incoming.from, part.name));
    }
  }
}

void check_requirements(const Scenario& s, const PartType& part, const std::string& at) {
  const Route route = route_of(s, part);
  for (std::size_t r = 0; r < part.requirements.size(); ++r) {
    const Requirement& requirement = part.requirements[r];
    const std::string here = fmt::format("{}/requirements/{}", at, r);
    if (!requirement.at_least && !requirement.at_most)
      fail(here, quoted(requirement.quantity), "must have at_least, at_most or both");
    if (requirement.at_least && requirement.at_most && !(*requirement.at_least <= *requirement.at_most))
      fail(here + "/at_least", fmt::format("{}", *requirement.at_least),
           fmt::format("must not be above at_most = {}", *requirement.at_most));
    for (std::size_t j = 0; j < r; ++j)
      if (part.requirements[j].quantity == requirement.quantity)
        fail(here + "/quantity", quoted(requirement.quantity),
             fmt::format("is already that of {}/requirements/{}", at, j));
    const auto leaves = steps_that_leave(s, route, requirement.quantity);
    if (std::find(leaves.begin(), leaves.end(), true) == leaves.end()) {
      std::vector<std::string> names;
      for (const RouteStep& step : route)
        for (const std::string& name : states_left(plan(s, s.operations[step.operation])))
          names.push_back(name);
      fail(here + "/quantity", quoted(requirement.quantity),
           names.empty() ? "no operation of the route leaves anything with the part"
                         : fmt::format("no operation of the route leaves it; closest: \"{}\"",
                                       models::closest(requirement.quantity, names)));
    }
    const auto leaving = [&](std::size_t k) { return static_cast<bool>(leaves[k]); };
    if (reach(route, {0}, false, leaving)[route.size()])
      fail(here + "/quantity", quoted(requirement.quantity),
           "parts can get to their store without an operation that leaves it");
    for (std::size_t k = 0; k < route.size(); ++k) {
      if (!leaves[k]) continue;
      const auto later = reach(route, after(route[k]), false, leaving);
      bool again = false;
      for (std::size_t j = 0; j < route.size(); ++j) again = again || (later[j] && leaves[j]);
      if (again && later[route.size()])
        fail(
            here + "/quantity", quoted(requirement.quantity),
            fmt::format("after operation \"{}\" some parts go through another one that leaves it and some do "
                        "not: whether the drawing is met is not decided at one of them",
                        s.operations[route[k].operation].name));
    }
  }
}

}  // namespace verstat::scenarios
