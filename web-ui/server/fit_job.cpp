#include "web-ui/server/fit_job.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "web-ui/server/api_support.h"

namespace verstat::web {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr std::size_t longest_table = 2U << 20U;
constexpr std::size_t longest_value = 300;

// What may be asked of each command. Flags that name files or databases are not among them.
const std::set<std::string> of_every_table = {"separator", "decimal", "duplicates", "confidence", "seed"};
const std::map<std::string, std::set<std::string>> options_of = {
    {"life",
     {"tool", "regime", "gamma", "bootstrap", "to", "speed", "feed", "depth", "min-per-part", "planned-cause",
      "failure-cause"}},
    {"taylor", {"criterion", "material", "tool", "at", "to"}},
    {"downtime",
     {"bootstrap", "hours", "weekdays", "from", "to-time", "clock", "mode", "to-failure", "to-repair"}},
    {"arrivals", {"bootstrap", "hours", "weekdays", "part", "as", "to"}},
    {"cycle", {"bootstrap", "operation", "to"}},
};
const std::map<std::string, std::set<std::string>> switches_of = {
    {"life", {}},
    {"taylor", {"pool-laboratories"}},
    {"downtime", {"new-at-start", "accept-trend", "empirical"}},
    {"arrivals", {"empirical"}},
    {"cycle", {"empirical"}},
};

const json& object_in(const json& body, const char* name, const char* what) {
  static const json empty = json::object();
  if (!body.contains(name)) return empty;
  if (!body[name].is_object()) throw Refused{400, fmt::format("body: fit: {}: must be {}", name, what)};
  return body[name];
}

/// A flag's value: one line, not too long. Numbers are written as JSON writes them.
std::string value_of(const std::string& place, const json& value) {
  if (!value.is_string() && !value.is_number())
    throw Refused{400, fmt::format("body: fit: {}: must be a text or a number", place)};
  std::string text = value.is_string() ? value.get<std::string>() : value.dump();
  const auto control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (text.empty() || text.size() > longest_value || std::any_of(text.begin(), text.end(), control))
    throw Refused{400, fmt::format("body: fit: {}: must be one line of 1 to {} bytes", place, longest_value)};
  return text;
}

/// A file name of letters, digits, dots and dashes: what the child's answer calls the table.
std::string plain_name(const std::string& given) {
  std::string name;
  for (const char c : given.substr(given.find_last_of("/\\") + 1)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    name += plain || c == '.' || c == '-' || c == '_' ? c : '_';
  }
  return name.empty() || name.starts_with(".") || name.starts_with("-") ? "table.csv" : name.substr(0, 100);
}

}  // namespace

JobSpec fit_job(const json& body) {
  if (!body.contains("fit") || !body["fit"].is_object())
    throw Refused{400, "body: fit: must be an object with \"what\" and \"table\""};
  const json& asked = body["fit"];
  for (const auto& [name, value] : asked.items())
    if (name != "what" && name != "table" && name != "file" && name != "columns" && name != "options")
      throw Refused{400,
                    fmt::format("body: fit: \"{}\" is not known; what, table, file, columns, options are",
                                clipped(name))};
  const std::string what = text_member(asked, "what", "", longest_value);
  const auto options = options_of.find(what);
  if (options == options_of.end())
    throw Refused{
        400, fmt::format("body: fit: what: \"{}\": must be life, taylor, downtime, arrivals or cycle", what)};
  const std::string table = text_member(asked, "table", "", longest_table);
  if (table.empty()) throw Refused{400, "body: fit: table: must be the text of a CSV table"};
  const std::string file = plain_name(text_member(asked, "file", "table.csv", longest_value));

  std::vector<std::string> arguments = {"fit", what, file, "--json"};
  for (const auto& [role, header] : object_in(asked, "columns", "an object of roles and headers").items()) {
    if (role.empty() ||
        !std::all_of(role.begin(), role.end(), [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; }))
      throw Refused{400, fmt::format("body: fit: columns: \"{}\" is no role", clipped(role))};
    arguments.push_back("--column=" + role + "=" + value_of("columns: " + role, header));
  }
  for (const auto& [name, value] : object_in(asked, "options", "an object of flags and values").items()) {
    if (switches_of.at(what).contains(name)) {
      if (!value.is_boolean())
        throw Refused{400, fmt::format("body: fit: options: {}: must be true or false", name)};
      if (value.get<bool>()) arguments.push_back("--" + name);
      continue;
    }
    if (!of_every_table.contains(name) && !options->second.contains(name))
      throw Refused{400, fmt::format("body: fit: options: \"{}\" is no flag of verstat fit {} that can be "
                                     "given here",
                                     clipped(name), what)};
    arguments.push_back("--" + name + "=" + value_of("options: " + name, value));
  }
  return {.kind = "fit",
          .title = file,
          .arguments = std::move(arguments),
          .files = {{file, table}},
          .keep_output = true,
          .finish = [what](const std::string& output) {
            const json answer = json::parse(output);
            return ordered_json{{"fit", what}, {"bytes", output.size()}, {"patch", answer.contains("patch")}}
                .dump();
          }};
}

}  // namespace verstat::web
