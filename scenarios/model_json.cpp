#include "scenarios/model_json.h"

#include <stdexcept>

#include <fmt/format.h>

namespace verstat::scenarios {

using models::Value;
using nlohmann::json;
using nlohmann::ordered_json;

Value to_value(const json& j) {
  switch (j.type()) {
    case json::value_t::boolean:
      return j.get<bool>();
    case json::value_t::number_integer:
      return j.get<std::int64_t>();
    case json::value_t::number_unsigned: {
      const auto u = j.get<std::uint64_t>();
      if (u <= static_cast<std::uint64_t>(INT64_MAX)) return static_cast<std::int64_t>(u);
      return static_cast<double>(u);
    }
    case json::value_t::number_float:
      return j.get<double>();
    case json::value_t::string:
      return j.get<std::string>();
    case json::value_t::array: {
      Value::List list;
      list.reserve(j.size());
      for (const json& element : j) list.push_back(to_value(element));
      return list;
    }
    case json::value_t::object: {
      Value::Map map;
      map.reserve(j.size());
      for (const auto& [key, element] : j.items()) map.emplace_back(key, to_value(element));
      return map;
    }
    default:
      return {};
  }
}

ordered_json to_json(const Value& value) {
  if (const bool* b = value.boolean()) return *b;
  if (const std::int64_t* i = value.integer()) return *i;
  if (const double* d = value.real()) return *d;
  if (const std::string* s = value.text()) return *s;
  if (const Value::List* l = value.list()) {
    ordered_json out = ordered_json::array();
    for (const Value& element : *l) out.push_back(to_json(element));
    return out;
  }
  if (const Value::Map* m = value.map()) {
    ordered_json out = ordered_json::object();
    for (const auto& [key, element] : *m) out[key] = to_json(element);
    return out;
  }
  return nullptr;
}

ordered_json evaluate_batch(const json& points, const std::string& source) {
  if (!points.is_array())
    throw std::invalid_argument("a batch must be a list of {\"id\", \"function\", \"inputs\"}");
  ordered_json results = ordered_json::array();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const json& point = points[k];
    ordered_json result;
    if (point.is_object() && point.contains("id")) {
      result["id"] = point["id"];
    } else {
      result["id"] = k;
    }
    try {
      if (!point.is_object()) throw std::invalid_argument(fmt::format("/{} must be an object", k));
      if (!point.contains("function") || !point["function"].is_string())
        throw std::invalid_argument(fmt::format("/{}/function must be the name of a model function", k));
      std::string key = point["function"].get<std::string>();
      if (key.find('.') == std::string::npos && !source.empty()) key = source + "." + key;
      const json inputs = point.contains("inputs") ? point["inputs"] : json::object();
      result["outputs"] = to_json(models::catalogue().at(key).evaluate(to_value(inputs)));
    } catch (const std::exception& e) {
      result["error"] = e.what();
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace verstat::scenarios
