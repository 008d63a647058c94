#include "scenarios/schema.h"

#include <cmath>

#include "scenarios/model_json.h"
#include "scenarios/scenario.h"

namespace verstat::scenarios {

using models::Field;
using models::TypeInfo;
using nlohmann::ordered_json;

namespace {

ordered_json schema_of(const TypeInfo& type, const Field& field);

ordered_json structure(const std::vector<Field>& fields, const std::string& kind) {
  ordered_json schema = {{"type", "object"}, {"additionalProperties", false}};
  ordered_json properties = ordered_json::object();
  ordered_json required = ordered_json::array();
  if (!kind.empty()) {
    properties["kind"] = {{"enum", {kind}}};
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

void put_range(ordered_json& schema, const models::Range& range) {
  if (std::isfinite(range.low)) schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
}

ordered_json schema_of(const TypeInfo& type, const Field& field) {
  if (type.nullable) {
    TypeInfo present = type;
    present.nullable = false;
    return {{"anyOf", {schema_of(present, field), {{"type", "null"}}}}};
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
    case TypeInfo::Kind::list:
      schema["type"] = "array";
      schema["items"] = schema_of(type.element.front(), field);
      schema["minItems"] = field.min_length;
      schema["maxItems"] = field.max_length;
      break;
    case TypeInfo::Kind::structure:
      schema = structure(*type.fields, "");
      break;
    case TypeInfo::Kind::alternatives:
      schema["oneOf"] = ordered_json::array();
      for (const auto& [kind, fields] : type.alternatives)
        schema["oneOf"].push_back(structure(*fields, kind));
      break;
  }
  return schema;
}

}  // namespace

ordered_json scenario_schema() {
  ordered_json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                         {"title", "Verstat scenario"}};
  schema.update(structure(scenario_fields(), ""));
  // A file may name its schema, so that editors find it.
  schema["properties"]["$schema"] = {{"type", "string"}};
  return schema;
}

}  // namespace verstat::scenarios
