#include "scenarios/function_json.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "scenarios/model_json.h"

namespace verstat::scenarios {

using models::Field;
using models::Function;
using models::Source;
using nlohmann::ordered_json;

namespace {

ordered_json field_json(const Field& f, bool input) {
  ordered_json j = {{"name", f.name},
                    {"symbol", f.symbol},
                    {"unit", f.unit},
                    {"type", f.access->type()},
                    {"meaning", f.meaning}};
  using Kind = models::TypeInfo::Kind;
  static constexpr std::array kinds{
      std::pair{Kind::number, "number"},       std::pair{Kind::integer, "integer"},
      std::pair{Kind::flag, "flag"},           std::pair{Kind::text, "text"},
      std::pair{Kind::choice, "choice"},       std::pair{Kind::list, "list"},
      std::pair{Kind::structure, "structure"}, std::pair{Kind::alternatives, "alternatives"}};
  const models::TypeInfo type = f.access->type_info();
  for (const auto& [kind, name] : kinds)
    if (kind == type.kind) j["kind"] = name;
  if (type.nullable) j["nullable"] = true;
  if (!type.choices.empty()) j["choices"] = type.choices;
  if (input) {
    j["required"] = f.required;
    if (!f.required) j["default"] = to_json(f.default_value);
    j["example"] = to_json(f.example);
  }
  if (std::isfinite(f.range.low)) j[f.range.low_open ? "above" : "at_least"] = f.range.low;
  if (std::isfinite(f.range.high)) j[f.range.high_open ? "below" : "at_most"] = f.range.high;
  return j;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

ordered_json function_json(const Source& source, const Function& f, bool whole) {
  ordered_json j = {{"key", f.key},
                    {"summary", f.summary},
                    {"role", source.info().role},
                    {"equation", f.equation},
                    {"provenance", models::to_string(f.provenance)}};
  if (!whole) return j;
  j["source"] = {{"id", source.info().id},
                 {"title", source.info().title},
                 {"authors", source.info().authors},
                 {"published", source.info().published}};
  j["inputs"] = ordered_json::array();
  for (const Field& field : f.inputs) j["inputs"].push_back(field_json(field, true));
  j["outputs"] = ordered_json::array();
  for (const Field& field : f.outputs) j["outputs"].push_back(field_json(field, false));
  j["notes"] = f.notes;
  j["example"] = {{"inputs", to_json(f.example_inputs())},
                  {"outputs", to_json(f.evaluate(f.example_inputs()))}};
  return j;
}

bool function_matches(const Source& source, const Function& f, const std::vector<std::string>& words) {
  std::string all = f.key + " " + f.summary + " " + source.info().title + " " + source.info().role;
  for (const Field& field : f.inputs) all += " " + field.name + " " + field.meaning;
  for (const Field& field : f.outputs) all += " " + field.name + " " + field.meaning;
  all = lower(all);
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& w) { return all.find(lower(w)) != std::string::npos; });
}

const Source& source_of(const Function& function) {
  for (const Source& source : models::catalogue().sources())
    for (const Function& f : source.functions())
      if (&f == &function) return source;
  throw std::logic_error("a function without a source");
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

}  // namespace verstat::scenarios
