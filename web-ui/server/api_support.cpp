#include "web-ui/server/api_support.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "models/catalogue/shortened.h"
#include "scenarios/json_text.h"

namespace verstat::web {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {
constexpr std::size_t most_names = 16;
constexpr std::size_t longest_text = 200;
constexpr std::size_t most_changes = 1000;
}  // namespace

Response json_response(const ordered_json& body, int status) {
  return {.status = status, .body = body.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n"};
}

Response dense_response(const ordered_json& body) {
  return {.body = body.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + "\n"};
}

Response csv_response(std::string body, const std::string& file) {
  return {.content_type = "text/csv; charset=utf-8",
          .body = std::move(body),
          .headers = {{"Content-Disposition", fmt::format("attachment; filename=\"{}\"", file)}}};
}

std::string clipped(const std::string& text) {
  return std::string(models::shortened(text, 100));
}

void check_query(const Target& target, std::initializer_list<std::string_view> known) {
  for (const auto& [name, value] : target.query)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Refused{400, fmt::format("?{}: no such parameter; allowed: {}", clipped(name),
                                     known.size() == 0 ? "none" : fmt::format("{}", fmt::join(known, ", ")))};
}

std::int64_t whole(const Target& target, const std::string& name, std::int64_t low, std::int64_t high,
                   std::int64_t otherwise) {
  const auto found = target.query.find(name);
  if (found == target.query.end()) return otherwise;
  const std::string& text = found->second;
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size() || value < low || value > high)
    throw Refused{
        400, fmt::format("?{}={}: must be a whole number from {} to {}", name, clipped(text), low, high)};
  return value;
}

std::string word(const Target& target, const std::string& name,
                 std::initializer_list<std::string_view> words) {
  const auto found = target.query.find(name);
  if (found == target.query.end()) return std::string(*words.begin());
  if (std::find(words.begin(), words.end(), found->second) == words.end())
    throw Refused{
        400, fmt::format("?{}={}: must be one of {}", name, clipped(found->second), fmt::join(words, ", "))};
  return found->second;
}

std::string text_in(const Target& target, const std::string& name) {
  const auto found = target.query.find(name);
  if (found == target.query.end()) return {};
  if (found->second.size() > longest_text)
    throw Refused{400,
                  fmt::format("?{}: {} bytes, allowed at most {}", name, found->second.size(), longest_text)};
  return found->second;
}

std::vector<std::string> names_in(const Target& target, const std::string& name) {
  std::vector<std::string> names;
  const auto found = target.query.find(name);
  if (found == target.query.end()) return names;
  std::string_view rest = found->second;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    if (!one.empty()) names.emplace_back(one);
  }
  if (names.size() > most_names)
    throw Refused{400, fmt::format("?{}: {} names, allowed at most {}", name, names.size(), most_names)};
  return names;
}

std::int64_t id_of(const char* what, const std::string& text) {
  std::int64_t id = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (error != std::errc() || stop != text.data() + text.size() || id < 1)
    throw Refused{400, fmt::format("{} \"{}\": an id is a whole number from 1", what, clipped(text))};
  return id;
}

CsvFormat csv_format(const Target& target) {
  const bool semicolon = word(target, "separator", {"comma", "semicolon"}) == "semicolon";
  const bool comma = word(target, "decimal", {"point", "comma"}) == "comma";
  if (comma && !semicolon) throw Refused{400, "?decimal=comma: needs separator=semicolon"};
  return {.separator = semicolon ? ';' : ',', .decimal = comma ? ',' : '.', .byte_order_mark = semicolon};
}

json body_of(const Request& request, std::initializer_list<std::string_view> known) {
  const std::string_view type = request.header("content-type");
  if (type.substr(0, type.find(';')) != "application/json")
    throw Refused{415, "the body must be JSON, sent with \"Content-Type: application/json\""};
  json body;
  try {
    body = scenarios::parse_json(request.body);
  } catch (const scenarios::InputError& e) {
    throw Refused{400, fmt::format("body: {}", e.what())};
  }
  if (!body.is_object())
    throw Refused{400, fmt::format("body: must be an object with {}", fmt::join(known, ", "))};
  for (const auto& [name, value] : body.items())
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Refused{400, fmt::format("body: \"{}\": no such member; allowed: {}", clipped(name),
                                     fmt::join(known, ", "))};
  return body;
}

std::string text_member(const json& body, const char* name, const std::string& otherwise,
                        std::size_t longest) {
  if (!body.contains(name)) return otherwise;
  if (!body[name].is_string()) throw Refused{400, fmt::format("body: {}: must be a text", name)};
  auto text = body[name].get<std::string>();
  if (text.size() > longest)
    throw Refused{400, fmt::format("body: {}: {} bytes, allowed at most {}", name, text.size(), longest)};
  return text;
}

std::vector<scenarios::Change> changes_of(const json& body) {
  std::vector<scenarios::Change> changes;
  if (!body.contains("changes")) return changes;
  const json& list = body["changes"];
  if (!list.is_array() || list.size() > most_changes)
    throw Refused{400, fmt::format("body: changes: must be a list of at most {} changes", most_changes)};
  for (const json& one : list) {
    if (!one.is_object() || one.size() != 2 || !one.contains("pointer") || !one["pointer"].is_string() ||
        !one.contains("value"))
      throw Refused{400, R"(body: changes: each must be {"pointer": "/machines/0/count", "value": 3})"};
    auto pointer = one["pointer"].get<std::string>();
    if (!pointer.starts_with("/") || pointer.find('=') != std::string::npos ||
        pointer.find('\0') != std::string::npos)
      throw Refused{400,
                    fmt::format("body: changes: \"{}\" is no JSON pointer that a change may have; one looks "
                                "like /machines/0/count",
                                clipped(pointer))};
    changes.push_back({std::move(pointer), one["value"]});
  }
  return changes;
}

GivenScenario scenario_of(const json& body) {
  if (!body.contains("scenario") || !(body["scenario"].is_string() || body["scenario"].is_object()))
    throw Refused{400, "body: scenario: must be the scenario, as an object or as its text"};
  GivenScenario given;
  given.changes = changes_of(body);
  json parsed;
  if (body["scenario"].is_string()) {
    given.text = body["scenario"].get<std::string>();
    try {
      parsed = scenarios::parse_json(given.text);
    } catch (const scenarios::InputError& e) {
      throw scenarios::InputError(e.pointer(), fmt::format("the scenario {}", e.what()));
    }
  } else {
    parsed = body["scenario"];
    given.text = parsed.dump(2) + "\n";
  }
  // As on the command line: settings may be changed in a scenario that has none.
  if (parsed.is_object() && !parsed.contains("simulation")) parsed["simulation"] = json::object();
  given.changed = scenarios::apply(std::move(parsed), given.changes);
  return given;
}

}  // namespace verstat::web
