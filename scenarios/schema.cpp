#include "scenarios/schema.h"

#include <cmath>
#include <map>
#include <set>

#include "scenarios/model_json.h"
#include "scenarios/scenario.h"

namespace verstat::scenarios {

using models::Field;
using models::TypeInfo;
using nlohmann::ordered_json;

namespace {

// Every structure, and every choice between structures, is written once under "definitions": a duration
// occurs at thirty places.
class SchemaWriter {
 public:
  [[nodiscard]] ordered_json whole(const std::vector<Field>& fields) {
    ordered_json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                           {"title", "Verstat scenario"}};
    schema.update(structure(fields, ""));
    // A file may name its schema, so that editors find it.
    schema["properties"]["$schema"] = {{"type", "string"}};
    schema["definitions"] = ordered_json::object();
    for (auto& [name, definition] : definitions_) schema["definitions"][name] = definition;
    return schema;
  }

 private:
  [[nodiscard]] ordered_json structure(const std::vector<Field>& fields, const std::string& kind) {
    ordered_json schema = {{"type", "object"}, {"additionalProperties", false}};
    ordered_json properties = ordered_json::object();
    ordered_json required = ordered_json::array();
    if (!kind.empty()) {
      // A list of one in braces is a list for one compiler and its only entry for another.
      properties["kind"]["enum"] = ordered_json::array({kind});
      required.push_back("kind");
    }
    for (const Field& field : fields) {
      ordered_json property = schema_of(field.access->type_info(), field);
      property["description"] = field.meaning;
      if (field.unit != "-" && field.unit != "1")
        property["description"] = field.meaning + " [" + field.unit + "]";
      if (field.required) {
        required.push_back(field.name);
      } else {
        property["default"] = to_json(field.default_value);
      }
      properties[field.name] = std::move(property);
    }
    schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = std::move(required);
    return schema;
  }

  // A reference to the definition that `make` writes when `key` is met for the first time.
  template <class Make>
  [[nodiscard]] ordered_json reference(const void* key, const std::string& wish, Make&& make) {
    auto known = names_.find(key);
    if (known == names_.end()) {
      std::string name = wish;
      for (int k = 2; !taken_.insert(name).second; ++k) name = wish + "_" + std::to_string(k);
      known = names_.emplace(key, name).first;
      definitions_[name] = make();
    }
    return {{"$ref", "#/definitions/" + known->second}};
  }

  [[nodiscard]] ordered_json schema_of(const TypeInfo& type, const Field& field) {
    if (type.nullable) {
      TypeInfo present = type;
      present.nullable = false;
      ordered_json inner = schema_of(present, field);
      if (inner.contains("anyOf")) inner = inner["anyOf"][0];
      return {{"anyOf", {std::move(inner), {{"type", "null"}}}}};
    }
    ordered_json schema;
    switch (type.kind) {
      case TypeInfo::Kind::number:
        schema["type"] = "number";
        put_range(schema, field.range);
        break;
      case TypeInfo::Kind::integer:
        schema["type"] = "integer";
        put_range(schema, field.range);
        break;
      case TypeInfo::Kind::flag:
        schema["type"] = "boolean";
        break;
      case TypeInfo::Kind::text:
        schema["type"] = "string";
        break;
      case TypeInfo::Kind::choice:
        schema["enum"] = type.choices;
        break;
      case TypeInfo::Kind::list: {
        schema["type"] = "array";
        ordered_json items = schema_of(type.element.front(), field);
        schema["items"] = items.contains("anyOf") && items.size() == 1 && items["anyOf"].size() == 1
                              ? items["anyOf"][0]
                              : items;
        schema["minItems"] = field.min_length;
        schema["maxItems"] = field.max_length;
        break;
      }
      // In anyOf, because draft 7 ignores what stands beside a reference.
      case TypeInfo::Kind::structure:
        schema["anyOf"] = ordered_json::array(
            {reference(type.fields, field.name, [&] { return structure(*type.fields, ""); })});
        break;
      case TypeInfo::Kind::alternatives: {
        const auto& first = type.alternatives.front();
        // The choice is told from its first alternative by the address of that one's name list.
        schema["anyOf"] =
            ordered_json::array({reference(&choice_keys_[first.second], "any_" + first.first, [&] {
              ordered_json choice = {{"oneOf", ordered_json::array()}};
              for (const auto& [kind, fields] : type.alternatives)
                choice["oneOf"].push_back(
                    reference(fields, kind, [&, &k = kind, &f = fields] { return structure(*f, k); }));
              return choice;
            })});
        break;
      }
    }
    return schema;
  }

  static void put_range(ordered_json& schema, const models::Range& range) {
    if (std::isfinite(range.low)) schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
    if (std::isfinite(range.high)) schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
  }

  std::map<const void*, std::string> names_;
  std::map<const void*, char> choice_keys_;
  std::set<std::string> taken_;
  std::map<std::string, ordered_json> definitions_;
};

}  // namespace

ordered_json scenario_schema() {
  return SchemaWriter().whole(scenario_fields());
}

}  // namespace verstat::scenarios
