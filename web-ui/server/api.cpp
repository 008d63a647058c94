#include "web-ui/server/api.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "models/catalogue/catalogue.h"
#include "scenarios/function_json.h"
#include "scenarios/json_text.h"
#include "scenarios/model_json.h"
#include "store/database.h"
#include "store/result_json.h"
#include "web-ui/server/csv.h"
#include "web-ui/server/openapi.h"

namespace verstat::web {

using nlohmann::ordered_json;

namespace {

/// An answer that is an error: thrown where it is found, caught in `answer`.
struct Refused {
  int status;
  std::string message;
};

constexpr std::int64_t default_page = 50;
constexpr std::int64_t largest_page = 200;
constexpr std::size_t most_list_kpis = 16;

Response json_response(const ordered_json& body) {
  return {.body = body.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n"};
}

std::string clipped(const std::string& text) {
  return text.substr(0, 100);
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

/// One of the words, the first when the parameter is not given.
std::string word(const Target& target, const std::string& name,
                 std::initializer_list<std::string_view> words) {
  const auto found = target.query.find(name);
  if (found == target.query.end()) return std::string(*words.begin());
  if (std::find(words.begin(), words.end(), found->second) == words.end())
    throw Refused{
        400, fmt::format("?{}={}: must be one of {}", name, clipped(found->second), fmt::join(words, ", "))};
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
  if (names.size() > most_list_kpis)
    throw Refused{400, fmt::format("?{}: {} names, allowed at most {}", name, names.size(), most_list_kpis)};
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

Response csv_response(std::string body, const std::string& file) {
  return {.content_type = "text/csv; charset=utf-8",
          .body = std::move(body),
          .headers = {{"Content-Disposition", fmt::format("attachment; filename=\"{}\"", file)}}};
}

void only(const Request& request, std::string_view method) {
  if (request.method != method && !(method == "GET" && request.method == "HEAD"))
    throw Refused{405, fmt::format("{} is not allowed here, only {}", clipped(request.method), method)};
}

Response model_list(const Target& target) {
  check_query(target, {"search"});
  const auto search = target.query.find("search");
  const std::vector<std::string> words =
      search == target.query.end() ? std::vector<std::string>{} : scenarios::words_of(search->second);
  ordered_json functions = ordered_json::array();
  for (const models::Source& source : models::catalogue().sources())
    for (const models::Function& f : source.functions())
      if (scenarios::function_matches(source, f, words))
        functions.push_back(scenarios::function_json(source, f, false));
  ordered_json body = {{"total", functions.size()}};
  body["functions"] = std::move(functions);
  return json_response(body);
}

const models::Function& function_at(const std::string& key) {
  try {
    return models::catalogue().at(key);
  } catch (const models::ModelError& e) {
    throw Refused{404, e.what()};
  }
}

Response model_show(const std::string& key, const Target& target) {
  check_query(target, {});
  const models::Function& f = function_at(key);
  return json_response(scenarios::function_json(scenarios::source_of(f), f, true));
}

Response model_eval(const std::string& key, const Request& request, const Target& target) {
  check_query(target, {});
  const models::Function& f = function_at(key);
  const std::string_view type = request.header("content-type");
  if (type.substr(0, type.find(';')) != "application/json")
    throw Refused{415, "the body must be JSON, sent with \"Content-Type: application/json\""};
  nlohmann::json body;
  try {
    body = scenarios::parse_json(request.body);
  } catch (const scenarios::InputError& e) {
    throw Refused{400, fmt::format("body: {}", e.what())};
  }
  if (!body.is_object() || body.size() != 1 || !body.contains("inputs") || !body["inputs"].is_object())
    throw Refused{400, R"(body: must be {"inputs": {NAME: VALUE, ...}})"};
  return json_response({{"outputs", scenarios::to_json(f.evaluate(scenarios::to_value(body["inputs"])))}});
}

}  // namespace

Api::Api(std::filesystem::path database, std::string version)
    : database_(std::move(database)), version_(std::move(version)) {}

Response Api::runs(const Target& target) const {
  check_query(target, {"limit", "offset", "kpis"});
  const std::int64_t limit = whole(target, "limit", 1, largest_page, default_page);
  const std::int64_t offset = whole(target, "offset", 0, INT64_MAX, 0);
  const std::vector<std::string> kpis = names_in(target, "kpis");
  const store::Reader reader(database_);
  ordered_json list = ordered_json::array();
  for (const store::RunHeader& header : reader.runs(limit, offset)) {
    ordered_json row = store::to_json(header);
    if (!kpis.empty()) {
      row["kpis"] = ordered_json::array();
      if (const auto run = reader.run(header.id, false)) {
        ordered_json all = store::to_json(*run);
        row["currency"] = run->currency;
        for (const ordered_json& kpi : all["kpis"])
          if (std::find(kpis.begin(), kpis.end(), kpi["name"].get_ref<const std::string&>()) != kpis.end())
            row["kpis"].push_back(kpi);
      }
    }
    list.push_back(std::move(row));
  }
  ordered_json body = {{"total", reader.run_count()}, {"limit", limit}, {"offset", offset}};
  body["runs"] = std::move(list);
  return json_response(body);
}

Response Api::run(const std::string& id_text, const Target& target) const {
  check_query(target, {"replications", "format", "separator", "decimal"});
  const std::int64_t id = id_of("run", id_text);
  const bool csv = word(target, "format", {"json", "csv"}) == "csv";
  const bool replications = word(target, "replications", {"0", "1"}) == "1";
  const CsvFormat format = csv_format(target);
  const auto found = store::Reader(database_).run(id, replications);
  if (!found) throw Refused{404, fmt::format("there is no run {}", id)};
  if (csv) return csv_response(kpi_table(*found, format), fmt::format("run-{}.csv", id));
  return json_response(store::to_json(*found, replications));
}

Response Api::studies(const Target& target) const {
  check_query(target, {"limit", "offset"});
  const std::int64_t limit = whole(target, "limit", 1, largest_page, default_page);
  const std::int64_t offset = whole(target, "offset", 0, INT64_MAX, 0);
  const store::Reader reader(database_);
  ordered_json list = ordered_json::array();
  for (const store::StudyHeader& header : reader.studies(limit, offset))
    list.push_back(store::to_json(header));
  ordered_json body = {{"total", reader.study_count()}, {"limit", limit}, {"offset", offset}};
  body["studies"] = std::move(list);
  return json_response(body);
}

Response Api::study(const std::string& id_text, const Target& target) const {
  check_query(target, {"trials", "format", "separator", "decimal"});
  const std::int64_t id = id_of("study", id_text);
  const bool csv = word(target, "format", {"json", "csv"}) == "csv";
  const bool trials = word(target, "trials", {"1", "0"}) == "1";
  const CsvFormat format = csv_format(target);
  const auto found = store::Reader(database_).study(id);
  if (!found) throw Refused{404, fmt::format("there is no study {}", id)};
  if (csv) return csv_response(trial_table(*found, format), fmt::format("study-{}.csv", id));
  ordered_json body = store::to_json(*found);
  if (!trials) body.erase("trial_list");
  return json_response(body);
}

Response Api::route(const Request& request, const Target& target) const {
  const auto& path = target.path;
  const auto at = [&](std::size_t size, std::string_view first) {
    return path.size() == 2 + size && path[1] == "v1" && path[2] == first;
  };
  if (at(3, "models") && path[4] == "eval") {
    only(request, "POST");
    return model_eval(path[3], request, target);
  }
  const bool known = at(1, "runs") || at(2, "runs") || at(1, "studies") || at(2, "studies") ||
                     at(1, "models") || at(2, "models") || at(1, "version") || at(1, "health") ||
                     at(1, "openapi.json");
  if (!known)
    throw Refused{404, fmt::format("there is no {}; /api/v1/openapi.json lists what there is",
                                   clipped(request.target))};
  only(request, "GET");
  if (at(1, "runs")) return runs(target);
  if (at(2, "runs")) return run(path[3], target);
  if (at(1, "studies")) return studies(target);
  if (at(2, "studies")) return study(path[3], target);
  if (at(1, "models")) return model_list(target);
  if (at(2, "models")) return model_show(path[3], target);
  check_query(target, {});
  if (at(1, "openapi.json")) return {.body = std::string(openapi_text())};
  const store::Reader reader(database_);  // health means: the database can be read
  if (at(1, "health")) return json_response({{"status", "ok"}, {"runs", reader.run_count()}});
  return json_response({{"program", "verstat"},
                        {"version", version_},
                        {"api", 1},
                        {"read_only", true},
                        {"database", database_.filename().string()},
                        {"database_schema", store::schema_version}});
}

Response Api::answer(const Request& request, const Target& target) const {
  try {
    return route(request, target);
  } catch (const Refused& e) {
    Response response = error_response(e.status, e.message);
    if (e.status == 405) response.headers["Allow"] = target.path.back() == "eval" ? "POST" : "GET, HEAD";
    return response;
  } catch (const models::ModelError& e) {
    return error_response(422, e.what(), e.input());
  } catch (const store::StoreError& e) {
    return error_response(503, e.what());
  } catch (const std::exception& e) {
    return error_response(500, e.what());
  }
}

}  // namespace verstat::web
