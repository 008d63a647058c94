#include "scenarios/load.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "models/catalogue/closest.h"
#include "operations/fields.h"
#include "operations/kinds/duration.h"
#include "scenarios/model_json.h"

namespace verstat::scenarios {

using nlohmann::json;

operations::CutPlan plan(const Scenario& scenario, const Operation& operation) {
  const Machine& machine = *find_named(scenario.machines, operation.machine);
  operations::PlanContext context{.machine = &machine.limits,
                                  .spindle = machine.spindle ? &*machine.spindle : nullptr};
  if (!operation.tool.empty())
    context.edge =
        &find_named(scenario.inserts, find_named(scenario.tools, operation.tool)->insert)->edge_life;
  return operation.process.plan(context);
}

std::optional<double> gamma_of(const Strategy& strategy) {
  return std::visit(
      [](const auto& s) -> std::optional<double> {
        if constexpr (requires { s.gamma; })
          return s.gamma;
        else
          return std::nullopt;
      },
      strategy);
}

Change parse_change(std::string_view text) {
  const auto equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0 || text[0] != '/')
    throw InputError("", fmt::format("--set {}: must be POINTER=VALUE, such as /machines/0/count=3", text));
  Change change{std::string(text.substr(0, equals)), {}};
  const std::string_view value = text.substr(equals + 1);
  change.value = json::accept(value) ? parse_json(value) : json(std::string(value));
  return change;
}

namespace {

std::string shown(const json& value) {
  return to_value(value).to_string();
}

std::vector<std::string> members_of(const json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

// Splits "/a/b~1c" into {"a", "b/c"}.
std::vector<std::string> tokens_of(const std::string& pointer) {
  try {
    json::json_pointer p(pointer);
    std::vector<std::string> tokens;
    for (; !p.empty(); p.pop_back()) tokens.insert(tokens.begin(), p.back());
    return tokens;
  } catch (const json::exception&) {
    throw InputError(pointer,
                     fmt::format("\"{}\" is no JSON pointer; one looks like /machines/0/count", pointer));
  }
}

json* step_into(json* at, const std::string& token, const std::string& so_far, bool last) {
  if (at->is_object()) {
    if (at->contains(token)) return &(*at)[token];
    if (last) return &((*at)[token] = nullptr);  // an optional member: the loader says whether it exists
    throw InputError(so_far, fmt::format("{}/{}: there is no such member; closest: \"{}\"", so_far, token,
                                         models::closest(token, members_of(*at))));
  }
  if (at->is_array()) {
    const bool digits = !token.empty() && token.size() < 10 &&
                        std::all_of(token.begin(), token.end(), [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t index = digits ? std::stoul(token) : at->size();
    if (index < at->size()) return &(*at)[index];
    throw InputError(
        so_far, fmt::format("{}/{}: the list has {} entries, counted from 0", so_far, token, at->size()));
  }
  throw InputError(so_far,
                   fmt::format("{}/{}: {} is {}, which has no members", so_far, token, so_far, shown(*at)));
}

}  // namespace

json apply(json scenario, const std::vector<Change>& changes) {
  for (const Change& change : changes) {
    json* at = &scenario;
    std::string so_far;
    const auto tokens = tokens_of(change.pointer);
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      at = step_into(at, tokens[k], so_far, k + 1 == tokens.size());
      so_far += "/" + tokens[k];
    }
    *at = change.value;
  }
  return scenario;
}

namespace {

[[noreturn]] void fail(const std::string& pointer, const std::string& value, const std::string& allowed) {
  throw InputError(pointer, fmt::format("{} = {}, {}", pointer, value, allowed));
}
std::string quoted(const std::string& text) {
  return fmt::format("\"{}\"", text.substr(0, 100));
}

template <class T>
void check_names(const std::vector<T>& all, const std::string& list) {
  std::map<std::string, std::size_t> seen;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string pointer = fmt::format("{}/{}/name", list, k);
    if (all[k].name.empty() || all[k].name.size() > 100)
      fail(pointer, quoted(all[k].name), "must have 1 to 100 characters");
    const auto [first, fresh] = seen.emplace(all[k].name, k);
    if (!fresh)
      fail(pointer, quoted(all[k].name), fmt::format("is already the name of {}/{}", list, first->second));
  }
}

template <class T>
void check_reference(const std::vector<T>& all, const std::string& name, const std::string& pointer,
                     const std::string& what) {
  if (find_named(all, name) != nullptr) return;
  std::vector<std::string> names;
  for (const T& one : all) names.push_back(one.name);
  fail(pointer, quoted(name),
       names.empty()
           ? fmt::format("there is no {} at all", what)
           : fmt::format("there is no such {}; closest: \"{}\"", what, models::closest(name, names)));
}

void check_law(const Duration& duration, const std::string& pointer) {
  try {
    operations::check_duration(duration, pointer);
  } catch (const models::DomainError& e) {
    throw InputError(e.input(), e.what());
  }
}

// A process that takes no time would repeat for ever at one instant.
void check_takes_time(const Duration& duration, const std::string& pointer) {
  check_law(duration, pointer);
  if (mean_min(duration) < 1e-6)
    fail(pointer, fmt::format("mean {} min", mean_min(duration)), "must have a mean of at least 1e-6 min");
}

void check_insert(const Insert& insert, const std::string& at) {
  const EdgeLife& life = insert.edge_life;
  if (life.law == models::LifeLawKind::normal && life.cv > 0.45)
    fail(at + "/edge_life/cv", fmt::format("{}", life.cv), "allowed 0.05 <= cv <= 0.45 for the normal law");
}

void check_tool(const Scenario& s, const Tool& tool, const std::string& at) {
  check_reference(s.inserts, tool.insert, at + "/insert", "insert");
  check_reference(s.crews, tool.crew, at + "/crew", "crew");
  check_law(tool.change.index, at + "/change/index");
  check_law(tool.change.replace, at + "/change/replace");
  const EdgeLife& life = find_named(s.inserts, tool.insert)->edge_life;
  const auto gamma = gamma_of(tool.strategy);
  if (!gamma) return;
  const models::LifeLaw unit(life.law, 1.0, life.cv);
  if (!(unit.gamma_percent_life(*gamma) > 1e-6))
    fail(at + "/strategy/gamma", fmt::format("{}", *gamma),
         fmt::format("leaves a scheduled period of zero for the life of insert \"{}\"; lower it",
                     tool.insert));
}

void check_operation(const Scenario& s, const Operation& operation, const std::string& at) {
  check_reference(s.machines, operation.machine, at + "/machine", "machine");
  if (!operation.tool.empty()) check_reference(s.tools, operation.tool, at + "/tool", "tool");
  if (const auto* plain = operation.process.as<operations::PlainOperation>())
    check_law(plain->time, at + "/process/time");
  operations::CutPlan plan;
  try {
    plan = scenarios::plan(s, operation);
  } catch (const models::ModelError& e) {
    throw InputError(at + "/process", fmt::format("{}/process cannot be planned: {}", at, e.what()));
  }
  if (plan.main_time_min < 1e-6)
    fail(at + "/process", fmt::format("{} min", plan.main_time_min), "must take at least 1e-6 min");
}

void check_part(const Scenario& s, const PartType& part, const std::string& at) {
  for (std::size_t k = 0; k < part.route.size(); ++k)
    check_reference(s.operations, part.route[k], fmt::format("{}/route/{}", at, k), "operation");
  check_reference(s.stores, part.store, at + "/store", "store");
  if (const auto* arrivals = std::get_if<Interarrival>(&part.supply))
    check_takes_time(arrivals->time, at + "/supply/time");
}

template <class T, class Check>
void check_each(const std::vector<T>& all, const std::string& list, Check&& check) {
  for (std::size_t k = 0; k < all.size(); ++k) check(all[k], fmt::format("{}/{}", list, k));
}

void check_whole(const Scenario& s) {
  check_names(s.inserts, "/inserts");
  check_names(s.tools, "/tools");
  check_names(s.crews, "/crews");
  check_names(s.machines, "/machines");
  check_names(s.operations, "/operations");
  check_names(s.stores, "/stores");
  check_names(s.parts, "/parts");
  check_each(s.inserts, "/inserts", check_insert);
  check_each(s.tools, "/tools", [&](const Tool& t, const std::string& at) { check_tool(s, t, at); });
  check_each(s.operations, "/operations",
             [&](const Operation& o, const std::string& at) { check_operation(s, o, at); });
  check_each(s.parts, "/parts", [&](const PartType& p, const std::string& at) { check_part(s, p, at); });
  const SimulationSettings& run = s.simulation;
  if (run.warmup_min >= run.horizon_min)
    fail("/simulation/warmup_min", fmt::format("{}", run.warmup_min),
         fmt::format("must be below horizon_min = {}: nothing would be counted", run.horizon_min));
  for (std::size_t k = 0; k < s.machines.size(); ++k)
    if (std::none_of(s.operations.begin(), s.operations.end(),
                     [&](const Operation& o) { return o.machine == s.machines[k].name; }))
      fail(fmt::format("/machines/{}/name", k), quoted(s.machines[k].name),
           "has no operation to do: no operation names it");
}

}  // namespace

Scenario load(const json& scenario) {
  Scenario result;
  try {
    json named = scenario;
    if (named.is_object()) named.erase("$schema");  // for editors
    models::read_fields(&result, scenario_fields(), to_value(named));
    models::check_fields(&result, scenario_fields());
  } catch (const models::DomainError& e) {
    throw InputError("/" + e.input(), (e.input().empty() ? "the scenario" : "/") + std::string(e.what()));
  }
  check_whole(result);
  return result;
}

}  // namespace verstat::scenarios
