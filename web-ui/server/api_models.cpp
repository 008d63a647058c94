// The catalogue, the operation kinds and plans, the scenario's schema and checks: computing, nothing stored.

#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "models/catalogue/catalogue.h"
#include "scenarios/function_json.h"
#include "scenarios/load.h"
#include "scenarios/model_json.h"
#include "scenarios/plan_json.h"
#include "scenarios/schema.h"
#include "scenarios/warnings.h"
#include "web-ui/server/api_handlers.h"
#include "web-ui/server/api_support.h"

namespace verstat::web {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr std::size_t most_points = 10'000;
constexpr std::size_t most_values = 2'000;
// A map asks a function thousands of times; iterative ones take milliseconds each.
constexpr std::chrono::seconds map_time{8};

class Patience {
 public:
  void check() const {
    if (std::chrono::steady_clock::now() - start_ > map_time)
      throw Refused{422, fmt::format("this takes longer than the {} s allowed; ask for fewer points",
                                     map_time.count())};
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const models::Function& function_at(const std::string& key) {
  try {
    return models::catalogue().at(key);
  } catch (const models::ModelError& e) {
    throw Refused{404, e.what()};
  }
}

/// Members "name" and "values" of one axis.
struct Axis {
  std::string name;
  std::vector<json> values;
};

Axis axis_of(const json& body, const char* member, const char* name) {
  const json& given = body[member];
  if (!given.is_object() || given.size() != 2 || !given.contains(name) || !given[name].is_string() ||
      !given.contains("values") || !given["values"].is_array() || given["values"].empty() ||
      given["values"].size() > most_values)
    throw Refused{400, fmt::format("body: {}: must be {{\"{}\": ..., \"values\": [...]}} with 1 to {} values",
                                   member, name, most_values)};
  Axis axis{.name = given[name].get<std::string>()};
  for (const json& value : given["values"]) axis.values.push_back(value);
  return axis;
}

/// A local "#/..." reference followed, and "this or null" taken for this, so that readers of the schema need
/// not know how it is cut up.
const ordered_json& resolved(const ordered_json& schema, const ordered_json& at) {
  const ordered_json* here = &at;
  for (int k = 0; k < 16; ++k) {
    if (here->contains("$ref")) {
      here = &schema.at(ordered_json::json_pointer((*here)["$ref"].get_ref<const std::string&>().substr(1)));
      continue;
    }
    if (!here->contains("anyOf")) break;
    const ordered_json* only = nullptr;
    int alternatives = 0;
    for (const ordered_json& one : (*here)["anyOf"])
      if (one.value("type", ordered_json()) != "null") {
        only = &one;
        ++alternatives;
      }
    if (alternatives != 1) break;
    here = only;
  }
  return *here;
}

/// The schema of each kind of operation, out of the scenario's.
std::map<std::string, ordered_json> kind_schemas(const ordered_json& schema) {
  std::map<std::string, ordered_json> all;
  const ordered_json& operations = resolved(schema, schema.at("properties").at("operations"));
  const ordered_json& operation = resolved(schema, operations.at("items"));
  const ordered_json& process = resolved(schema, operation.at("properties").at("process"));
  for (const ordered_json& one : process.at("oneOf")) {
    const ordered_json& kind = resolved(schema, one);
    const ordered_json& name = resolved(schema, kind.at("properties").at("kind"));
    all[(name.contains("enum") ? name["enum"][0] : name.at("const")).get<std::string>()] = kind;
  }
  return all;
}

const ordered_json& the_schema() {
  static const ordered_json schema = scenarios::scenario_schema();
  return schema;
}

/// The plan that a body asks for, with the changes made.
operations::CutPlan plan_of(const json& body, const json& document) {
  if (body.contains("scenario")) {
    const auto name = body["operation"].get<std::string>();
    const scenarios::Scenario scenario = scenarios::load(document);
    const auto* operation = scenarios::find_named(scenario.operations, name);
    if (operation == nullptr) {
      std::vector<std::string> names;
      for (const auto& one : scenario.operations) names.push_back(one.name);
      throw Refused{422,
                    fmt::format("operation \"{}\": the scenario has none of this name; it has {}",
                                clipped(name), fmt::join(names, ", ")),
                    "/operations"};
    }
    return scenarios::plan(scenario, *operation);
  }
  return scenarios::load_operation(document).plan();
}

}  // namespace

Response list_models(const Call& call) {
  check_query(call.target, {"search"});
  const auto search = call.target.query.find("search");
  const std::vector<std::string> words =
      search == call.target.query.end() ? std::vector<std::string>{} : scenarios::words_of(search->second);
  ordered_json functions = ordered_json::array();
  for (const models::Source& source : models::catalogue().sources())
    for (const models::Function& f : source.functions())
      if (scenarios::function_matches(source, f, words))
        functions.push_back(scenarios::function_json(source, f, false));
  ordered_json body = {{"total", functions.size()}};
  body["functions"] = std::move(functions);
  return json_response(body);
}

Response show_model(const Call& call) {
  check_query(call.target, {});
  const models::Function& f = function_at(call.parameters[0]);
  return json_response(scenarios::function_json(scenarios::source_of(f), f, true));
}

Response evaluate_model(const Call& call) {
  check_query(call.target, {});
  const models::Function& f = function_at(call.parameters[0]);
  const json body = body_of(call.request, {"inputs"});
  if (!body.contains("inputs") || !body["inputs"].is_object())
    throw Refused{400, R"(body: must be {"inputs": {NAME: VALUE, ...}})"};
  return json_response({{"outputs", scenarios::to_json(f.evaluate(scenarios::to_value(body["inputs"])))}});
}

Response map_model(const Call& call) {
  check_query(call.target, {});
  const models::Function& f = function_at(call.parameters[0]);
  const json body = body_of(call.request, {"inputs", "output", "x", "y"});
  if (!body.contains("inputs") || !body["inputs"].is_object() || !body.contains("x"))
    throw Refused{400,
                  R"(body: must be {"inputs": {...}, "output": NAME, "x": {"name", "values"}, "y": ...})"};
  const std::string output = text_member(body, "output", "", 200);
  const Axis x = axis_of(body, "x", "name");
  const Axis y =
      body.contains("y") ? axis_of(body, "y", "name") : Axis{.name = "", .values = {json(nullptr)}};
  if (x.values.size() * y.values.size() > most_points)
    throw Refused{400, fmt::format("body: {} points, allowed at most {}", x.values.size() * y.values.size(),
                                   most_points)};
  ordered_json rows = ordered_json::array();
  ordered_json errors = ordered_json::object();
  json inputs = body["inputs"];
  const Patience patience;
  for (const json& b : y.values) {
    if (!y.name.empty()) inputs[y.name] = b;
    ordered_json row = ordered_json::array();
    for (const json& a : x.values) {
      inputs[x.name] = a;
      patience.check();
      try {
        const ordered_json out = scenarios::to_json(f.evaluate(scenarios::to_value(inputs)));
        if (!out.contains(output))
          throw Refused{422, fmt::format("output \"{}\": {} has none of this name", clipped(output), f.key)};
        const ordered_json& value = out[output];
        row.push_back(value.is_number() ? value : ordered_json(nullptr));
      } catch (const models::ModelError& e) {
        // Outside the model's range: a gap, and once why.
        row.push_back(nullptr);
        if (errors.size() < 10) errors[e.input().empty() ? "-" : e.input()] = e.what();
      }
    }
    rows.push_back(std::move(row));
  }
  ordered_json answer = {{"output", output}};
  answer["values"] = std::move(rows);
  answer["refusals"] = std::move(errors);
  return dense_response(answer);
}

Response list_kinds(const Call& call) {
  check_query(call.target, {});
  const auto schemas = kind_schemas(the_schema());
  ordered_json list = ordered_json::array();
  for (const auto& kind : operations::kinds().all()) {
    const auto schema = schemas.find(kind->name);
    list.push_back({{"name", kind->name}, {"summary", kind->summary}, {"sources", kind->sources}});
    list.back()["schema"] = schema == schemas.end() ? ordered_json(nullptr) : schema->second;
  }
  ordered_json body = {{"total", list.size()}};
  body["kinds"] = std::move(list);
  return json_response(body);
}

Response make_plan(const Call& call) {
  check_query(call.target, {"explain"});
  const bool explain = word(call.target, "explain", {"1", "0"}) == "1";
  const json body = body_of(call.request, {"scenario", "operation", "changes", "sweep"});
  const bool whole_shop = body.contains("scenario");
  if (!body.contains("operation") ||
      (whole_shop ? !body["operation"].is_string() : !body["operation"].is_object()))
    throw Refused{400,
                  "body: must be {\"operation\": {an operation document}} or {\"scenario\": ..., "
                  "\"operation\": NAME}, both with \"changes\" if wanted"};
  const json document =
      whole_shop ? scenario_of(body).changed : scenarios::apply(body["operation"], changes_of(body));
  if (!body.contains("sweep")) return json_response(scenarios::to_json(plan_of(body, document), explain));

  // The same plan along the values of one member.
  const Axis axis = axis_of(body, "sweep", "pointer");
  ordered_json points = ordered_json::array();
  const Patience patience;
  for (const json& value : axis.values) {
    patience.check();
    ordered_json point = {{"value", value}};
    try {
      const auto plan = plan_of(body, scenarios::apply(document, {{axis.name, value}}));
      point["feasible"] = plan.feasible();
      ordered_json numbers = ordered_json::object();
      for (const auto& q : plan.quantities) numbers[q.name] = q.value;
      if (plan.edge) numbers["edge_life_mean_min"] = plan.edge->mean_min;
      point["quantities"] = std::move(numbers);
      ordered_json margins = ordered_json::object();
      for (const auto& l : plan.limits) margins[l.name] = l.margin();
      point["margins"] = std::move(margins);
    } catch (const scenarios::InputError& e) {
      point["error"] = e.what();
    } catch (const models::ModelError& e) {
      point["error"] = e.what();
    } catch (const models::DomainError& e) {
      point["error"] = e.what();
    }
    points.push_back(std::move(point));
  }
  ordered_json answer = {{"pointer", axis.name}};
  answer["points"] = std::move(points);
  return dense_response(answer);
}

Response show_schema(const Call& call) {
  check_query(call.target, {});
  return json_response(the_schema());
}

Response check_scenario(const Call& call) {
  check_query(call.target, {});
  const json body = body_of(call.request, {"scenario", "changes"});
  const GivenScenario given = scenario_of(body);
  const scenarios::Scenario scenario = scenarios::load(given.changed);
  ordered_json plans = ordered_json::array();
  for (const auto& operation : scenario.operations) {
    ordered_json one = {{"operation", operation.name}};
    try {
      const auto plan = scenarios::plan(scenario, operation);
      one["main_time_min"] = plan.main_time_min;
      one["feasible"] = plan.feasible();
    } catch (const models::ModelError& e) {
      one["error"] = e.what();
    } catch (const models::DomainError& e) {
      one["error"] = e.what();
    }
    plans.push_back(std::move(one));
  }
  ordered_json answer = {{"valid", true}, {"name", scenario.name}};
  answer["operations"] = std::move(plans);
  answer["warnings"] = scenarios::to_json(scenarios::warnings(scenario));
  return json_response(answer);
}

}  // namespace verstat::web
