// Every function of the catalogue: {"function": key, "inputs": {...}}, what a line of verstat models eval
// --batch holds.
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "models/catalogue/catalogue.h"
#include "models/catalogue/error.h"
#include "scenarios/json_text.h"
#include "scenarios/model_json.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

using nlohmann::json;

void check_finite(const models::Value& value, std::string_view key) {
  if (const double* number = value.real(); number != nullptr && !std::isfinite(*number))
    finding(fmt::format("{} gives {}", key, *number));
  if (value.list() != nullptr)
    for (const models::Value& one : *value.list()) check_finite(one, key);
  if (value.map() != nullptr)
    for (const auto& [name, one] : *value.map()) check_finite(one, key);
}

// A name that is none stands for some function, but for the few that are asked for as they are: looking for
// the closest of all names takes longer than most functions.
const models::Function& function_of(const std::string& key) {
  static const std::vector<const models::Function*> all = [] {
    std::vector<const models::Function*> list;
    for (const models::Source& source : models::catalogue().sources())
      for (const models::Function& f : source.functions()) list.push_back(&f);
    return list;
  }();
  std::size_t sum = 0;
  for (const char c : key) sum = sum * 131 + static_cast<unsigned char>(c);
  if (const models::Function* known = models::catalogue().find(key); known != nullptr) return *known;
  return sum % 61 == 0 ? models::catalogue().at(key) : *all[sum % all.size()];
}

// These sweep a whole gear or polygon and take up to ten thousand times as long as the others: one input in
// 64 looks at them, so that all functions get their share of a run.
bool has_its_turn(const models::Function& f, std::string_view bytes) {
  static const std::set<std::string_view> slow = {"K101.hobbing_load_summary", "S3.rk_tooth_positions",
                                                  "K207.closed_loop_spectral_radius", "K309.track_max_gap",
                                                  "K301.polygon_milling_time"};
  if (!slow.contains(f.key)) return true;
  std::size_t sum = 0;
  for (const char c : bytes) sum = sum * 131 + static_cast<unsigned char>(c);
  return sum % 64 == 0;
}

void eat(std::string_view bytes) {
  try {
    const json point = scenarios::parse_json(bytes);
    if (!point.is_object()) return;
    const auto function = point.find("function");
    const auto inputs = point.find("inputs");
    if (function == point.end() || !function->is_string() || inputs == point.end()) return;
    const models::Function& f = function_of(function->get_ref<const std::string&>());
    if (has_its_turn(f, bytes)) check_finite(f.evaluate(scenarios::to_value(*inputs)), f.key);
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  } catch (const models::ModelError& e) {
    check_words(e.what());
  }
}

// Each function twice: with what it must have, and with everything it may have.
std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const models::Source& source : models::catalogue().sources())
    for (const models::Function& f : source.functions()) {
      nlohmann::ordered_json point{{"function", f.key}};
      point["inputs"] = scenarios::to_json(f.example_inputs());
      all.push_back(point.dump());
      for (const models::Field& field : f.inputs)
        if (!field.required && !field.default_value.is_null())
          point["inputs"][field.name] = scenarios::to_json(field.default_value);
      if (std::string full = point.dump(); full != all.back()) all.push_back(std::move(full));
    }
  return all;
}

}  // namespace

Target model_target() {
  return {"model", Form::json, eat, seeds};
}

}  // namespace verstat::fuzz
