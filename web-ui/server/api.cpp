#include "web-ui/server/api.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "models/catalogue/error.h"
#include "store/database.h"
#include "web-ui/server/api_handlers.h"
#include "web-ui/server/api_support.h"
#include "web-ui/server/openapi.h"

namespace verstat::web {

using nlohmann::ordered_json;

namespace {

Response show_version(const Call& call) {
  check_query(call.target, {});
  static_cast<void>(store::Reader(call.database));
  return json_response({{"program", "verstat"},
                        {"version", call.version},
                        {"api", 1},
                        {"read_only", call.jobs == nullptr},
                        {"database", call.database.filename().string()},
                        {"database_schema", store::schema_version}});
}

Response show_health(const Call& call) {
  check_query(call.target, {});
  const store::Reader reader(call.database);  // health means: the database can be read
  return json_response({{"status", "ok"}, {"runs", reader.run_count()}});
}

Response show_openapi(const Call& call) {
  check_query(call.target, {});
  return {.body = std::string(openapi_text())};
}

struct Route {
  std::string_view method;
  std::string_view pattern;
  Response (*handler)(const Call&);
  bool stores = false;  ///< refused when read-only
};

constexpr std::array all_routes = {
    Route{"GET", "/runs", list_runs},
    Route{"GET", "/runs/{id}", show_run},
    Route{"GET", "/runs/{id}/scenario", show_run_scenario},
    Route{"PUT", "/runs/{id}/notes", annotate_run, true},
    Route{"GET", "/studies", list_studies},
    Route{"GET", "/studies/{id}", show_study},
    Route{"GET", "/studies/{id}/trials", list_trials},
    Route{"PUT", "/studies/{id}/notes", annotate_study, true},
    Route{"GET", "/tags", list_tags},
    Route{"GET", "/models", list_models},
    Route{"GET", "/models/{key}", show_model},
    Route{"POST", "/models/{key}/eval", evaluate_model},
    Route{"POST", "/models/{key}/map", map_model},
    Route{"GET", "/kinds", list_kinds},
    Route{"POST", "/plan", make_plan},
    Route{"GET", "/schema", show_schema},
    Route{"POST", "/check", check_scenario},
    Route{"GET", "/jobs", list_jobs},
    Route{"POST", "/jobs", start_job, true},
    Route{"GET", "/jobs/{id}", show_job},
    Route{"DELETE", "/jobs/{id}", cancel_job, true},
    Route{"GET", "/jobs/{id}/events", follow_job},
    Route{"GET", "/jobs/{id}/output", show_output},
    Route{"GET", "/version", show_version},
    Route{"GET", "/health", show_health},
    Route{"GET", "/openapi.json", show_openapi},
};

/// The steps of `path` (after "api", "v1") that stand for {names}, or none when the pattern does not fit.
std::optional<std::vector<std::string>> match(std::string_view pattern,
                                              const std::vector<std::string>& path) {
  std::vector<std::string> parameters;
  std::size_t step = 2;
  while (!pattern.empty()) {
    pattern.remove_prefix(1);  // the slash
    const std::string_view wanted = pattern.substr(0, pattern.find('/'));
    pattern.remove_prefix(wanted.size());
    if (step >= path.size()) return std::nullopt;
    if (wanted.starts_with("{")) {
      parameters.push_back(path[step]);
    } else if (path[step] != wanted) {
      return std::nullopt;
    }
    ++step;
  }
  if (step != path.size()) return std::nullopt;
  return parameters;
}

}  // namespace

Api::Api(std::filesystem::path database, std::string version, std::shared_ptr<Jobs> jobs,
         std::vector<std::string> study_flags)
    : database_(std::move(database)),
      version_(std::move(version)),
      jobs_(std::move(jobs)),
      study_flags_(std::move(study_flags)) {}

std::vector<std::pair<std::string_view, std::string_view>> Api::routes() {
  std::vector<std::pair<std::string_view, std::string_view>> all;
  for (const Route& r : all_routes) all.emplace_back(r.method, r.pattern);
  return all;
}

Response Api::route(const Request& request, const Target& target) const {
  std::vector<std::string_view> allowed;
  if (target.path.size() > 2 && target.path[1] == "v1")
    for (const Route& r : all_routes) {
      auto parameters = match(r.pattern, target.path);
      if (!parameters) continue;
      if (request.method != r.method && !(r.method == "GET" && request.method == "HEAD")) {
        allowed.push_back(r.method);
        if (r.method == "GET") allowed.emplace_back("HEAD");
        continue;
      }
      if (r.stores && !jobs_)
        throw Refused{403, "the server was started with --read-only: nothing is started or stored"};
      return r.handler({.database = database_,
                        .version = version_,
                        .jobs = jobs_.get(),
                        .study_flags = study_flags_,
                        .request = request,
                        .target = target,
                        .parameters = std::move(*parameters)});
    }
  if (allowed.empty())
    throw Refused{404, fmt::format("there is no {}; /api/v1/openapi.json lists what there is",
                                   clipped(request.target))};
  Response response = error_response(
      405, fmt::format("{} is not allowed here, only {}", clipped(request.method), fmt::join(allowed, ", ")));
  response.headers["Allow"] = fmt::format("{}", fmt::join(allowed, ", "));
  return response;
}

Response Api::answer(const Request& request, const Target& target) const {
  try {
    return route(request, target);
  } catch (const Refused& e) {
    return error_response(e.status, e.message, "", e.pointer);
  } catch (const scenarios::InputError& e) {
    return error_response(422, e.what(), "", e.pointer());
  } catch (const models::ModelError& e) {
    return error_response(422, e.what(), e.input());
  } catch (const models::DomainError& e) {
    return error_response(422, e.what(), e.input());
  } catch (const store::StoreError& e) {
    return error_response(503, e.what());
  } catch (const std::exception& e) {
    return error_response(500, e.what());
  }
}

}  // namespace verstat::web
