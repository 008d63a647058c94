#include "scenarios/load.h"

#include <algorithm>

#include <fmt/format.h>

#include "models/catalogue/closest.h"
#include "models/maintenance/k409_repair_service.h"
#include "scenarios/check.h"
#include "scenarios/incoming.h"
#include "scenarios/model_json.h"

namespace verstat::scenarios {

using nlohmann::json;

double wage_fund_per_min(const Crew& crew) {
  const CrewWages& wages = *crew.wages;
  return models::k409::maintenance_wage_fund({.crews = crew.members,
                                              .workers_per_crew = wages.workers_per_member,
                                              .shifts = wages.shifts,
                                              .attendance = wages.attendance,
                                              .monthly_wage = wages.monthly_wage,
                                              .bonus_fraction = wages.bonus_fraction,
                                              .social_fraction = wages.social_fraction,
                                              .hours_per_month = wages.hours_per_month})
             .crew_cost_per_h /
         60;
}

namespace {

// The shop follows the teeth of this tool one by one: where a plan gives the life of the whole mill and the
// mean slowdown by its failed teeth, those of one tooth and of the fresh mill take their place.
void follow_each_tooth(operations::CutPlan& plan) {
  const auto tooth_life_min = plan.value_of("tooth_life_min");
  if (!tooth_life_min || !plan.edge) return;
  plan.edge->mean_min = *tooth_life_min;
  plan.edge->origin = "K117.mean_life_for_regime, one tooth";
  plan.main_time_min /= plan.value_of("slowdown").value_or(1);
  for (operations::Quantity& quantity : plan.quantities)
    if (quantity.name == std::string_view("main_time_min")) quantity.value = plan.main_time_min;
}

}  // namespace

operations::CutPlan plan(const Scenario& scenario, const Operation& operation, const Machine& machine) {
  PlansBefore before;
  return plan(scenario, operation, machine, before);
}

operations::CutPlan plan(const Scenario& scenario, const Operation& operation, const Machine& machine,
                         PlansBefore& before) {
  operations::PlanContext context{.machine = &machine.limits,
                                  .spindle = machine.spindle ? &*machine.spindle : nullptr};
  const Tool* tool = operation.tool.empty() ? nullptr : find_named(scenario.tools, operation.tool);
  EdgeLife after_preparation;
  if (tool != nullptr && !tool->insert.empty()) {
    const Insert& insert = *find_named(scenario.inserts, tool->insert);
    if (insert.preparation) {
      after_preparation = prepared(insert).edge_life;
      context.edge = &after_preparation;
    } else {
      context.edge = &insert.edge_life;
    }
  }
  operations::CutPlan plan = operation.incoming.empty() ? operation.process.plan(context)
                                                        : received(scenario, operation, before).plan(context);
  if (tool != nullptr && tool->teeth > 1) follow_each_tooth(plan);
  return plan;
}

operations::CutPlan plan(const Scenario& scenario, const Operation& operation) {
  return plan(scenario, operation, scenario.machines.at(groups_of(scenario, operation).at(0)));
}

std::vector<std::size_t> groups_of(const Scenario& scenario, const Operation& operation) {
  const auto index = [&](const std::string& name) {
    return static_cast<std::size_t>(find_named(scenario.machines, name) - scenario.machines.data());
  };
  std::vector<std::size_t> groups;
  if (!operation.machine.empty()) groups.push_back(index(operation.machine));
  for (const std::string& name : operation.machines) groups.push_back(index(name));
  if (!operation.capability.empty())
    for (std::size_t g = 0; g < scenario.machines.size(); ++g) {
      const auto& has = scenario.machines[g].capabilities;
      if (std::find(has.begin(), has.end(), operation.capability) != has.end()) groups.push_back(g);
    }
  return groups;
}

std::optional<double> gamma_of(const Strategy& strategy) {
  return std::visit(
      [](const auto& s) -> std::optional<double> {
        if constexpr (requires { s.gamma; })
          return s.gamma;  // of replace_at_failed_teeth: may be left out
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

template <class T, class Check>
void check_each(const std::vector<T>& all, const std::string& list, Check&& check) {
  for (std::size_t k = 0; k < all.size(); ++k) check(all[k], fmt::format("{}/{}", list, k));
}

void check_whole(const Scenario& s) {
  check_size(s);
  check_names(names_of(s.inserts), "/inserts");
  check_names(names_of(s.tools), "/tools");
  check_names(names_of(s.calendars), "/calendars");
  check_names(names_of(s.crews), "/crews");
  check_names(names_of(s.spares), "/spares");
  check_names(names_of(s.machines), "/machines");
  check_names(names_of(s.operations), "/operations");
  check_names(names_of(s.stores), "/stores");
  check_names(names_of(s.parts), "/parts");
  check_names(names_of(s.transport), "/transport");
  using Text = const std::string&;
  check_each(s.inserts, "/inserts", [&](const Insert& x, Text at) { check_insert(s, x, at); });
  check_each(s.tools, "/tools", [&](const Tool& x, Text at) { check_tool(s, x, at); });
  check_each(s.calendars, "/calendars", check_calendar);
  check_each(s.crews, "/crews", [&](const Crew& x, Text at) { check_crew(s, x, at); });
  check_each(s.spares, "/spares", check_spare);
  check_each(s.machines, "/machines", [&](const Machine& x, Text at) { check_machine(s, x, at); });
  check_each(s.operations, "/operations",
             [&](const Operation& x, Text at) { check_operation_names(s, x, at); });
  check_sources(s);
  // Those that receive nothing first: the others are planned from their plans.
  for (const bool receives : {false, true})
    check_each(s.operations, "/operations", [&](const Operation& x, Text at) {
      if (receives == !x.incoming.empty()) check_operation(s, x, at);
    });
  check_each(s.tools, "/tools", [&](const Tool& x, Text at) { check_tool_use(s, x, at); });
  check_each(s.machines, "/machines", [&](const Machine& x, Text at) { check_magazine(s, x, at); });
  check_each(s.parts, "/parts", [&](const PartType& x, Text at) { check_part(s, x, at); });
  check_each(s.stores, "/stores", [&](const Store& x, Text at) { check_store(s, x, at); });
  check_each(s.transport, "/transport", [&](const Transport& x, Text at) { check_transport(s, x, at); });
  const SimulationSettings& run = s.simulation;
  if (run.warmup_min >= run.horizon_min)
    fail("/simulation/warmup_min", fmt::format("{}", run.warmup_min),
         fmt::format("must be below horizon_min = {}: nothing would be counted", run.horizon_min));
  if (s.criteria) check_criteria(s, "/criteria");
  check_renamed(s);
  std::vector<bool> busy(s.machines.size(), false);
  for (const Operation& operation : s.operations)
    for (const std::size_t g : groups_of(s, operation)) busy[g] = true;
  for (std::size_t k = 0; k < s.machines.size(); ++k)
    if (!busy[k])
      fail(fmt::format("/machines/{}/name", k), quoted(s.machines[k].name),
           "has no operation to do: no operation names it");
  check_layout(s);
  check_capacity(s);
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
  for (std::size_t k = 0; k < result.crews.size(); ++k) {
    Crew& crew = result.crews[k];
    if (!crew.wages) continue;
    try {
      crew.rate_per_min = wage_fund_per_min(crew);
    } catch (const models::ModelError& e) {
      const std::string pointer = fmt::format("/crews/{}/wages", k);
      throw InputError(pointer, fmt::format("{}: {}", pointer, e.what()));
    }
    crew.pay = CrewPay::shift;
  }
  return result;
}

}  // namespace verstat::scenarios
