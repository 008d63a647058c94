// Runs and studies started from the pages: what is asked is checked here as the command line would, then
// given to the queue.

#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "store/database.h"
#include "web-ui/server/api_handlers.h"
#include "web-ui/server/api_support.h"
#include "web-ui/server/fit_job.h"

namespace verstat::web {

using nlohmann::json;
using nlohmann::ordered_json;

namespace {

constexpr std::size_t longest_label = 200;

ordered_json job_json(const JobStatus& s) {
  const auto or_null = [](const auto& value) { return value ? ordered_json(*value) : ordered_json(nullptr); };
  ordered_json j = {{"id", s.id}, {"kind", s.kind}, {"title", s.title}, {"state", to_string(s.state)}};
  j["stage"] = s.stage;
  j["done"] = or_null(s.done);
  j["of"] = or_null(s.of);
  j["left_s"] = or_null(s.left_s);
  j["best"] = or_null(s.best);
  j["elapsed_s"] = s.elapsed_s;
  j["message"] = s.message;
  ordered_json result = ordered_json::parse(s.result, nullptr, false);
  j["result"] = result.is_discarded() ? ordered_json(nullptr) : std::move(result);
  return j;
}

std::vector<std::string> with_changes(std::vector<std::string> arguments,
                                      const std::vector<scenarios::Change>& changes) {
  for (const scenarios::Change& change : changes) {
    arguments.emplace_back("--set");
    arguments.push_back(change.pointer + "=" + change.value.dump());
  }
  return arguments;
}

std::int64_t id_in(const json& answer, const char* name) {
  if (!answer.is_object() || !answer.contains(name) || !answer[name].is_number_integer())
    throw std::runtime_error(fmt::format("the program's answer has no \"{}\"", name));
  return answer[name].get<std::int64_t>();
}

std::string run_result(const std::string& output) {
  return ordered_json{{"run", id_in(json::parse(output), "id")}}.dump();
}

std::string study_result(const std::string& output) {
  const json answer = json::parse(output);
  ordered_json result = {{"study", id_in(answer, "study")}};
  for (const char* name : {"baseline_run", "best_run"})
    if (answer.contains(name) && answer[name].is_number_integer()) result[name] = answer[name];
  return result.dump();
}

bool same_bits(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return !a && !b;
  return std::bit_cast<std::uint64_t>(*a) == std::bit_cast<std::uint64_t>(*b);
}

/// Every value of every replication of two runs, compared bit for bit.
std::string repeated_result(const std::filesystem::path& database, std::int64_t first,
                            const std::string& output) {
  const std::int64_t again = id_in(json::parse(output), "id");
  const store::Reader reader(database);
  const auto a = reader.run(first);
  const auto b = reader.run(again);
  if (!a || !b) throw std::runtime_error("one of the two runs has vanished from the database");
  std::int64_t values = 0;
  std::int64_t different = 0;
  std::string where;
  const bool same_shape = a->values.size() == b->values.size() && a->kpis.size() == b->kpis.size();
  for (std::size_t r = 0; same_shape && r < a->values.size(); ++r)
    for (std::size_t k = 0; k < a->values[r].size(); ++k) {
      ++values;
      if (a->kpis[k].kpi.name == b->kpis[k].kpi.name && same_bits(a->values[r][k], b->values[r][k])) continue;
      if (different++ == 0) where = fmt::format("{} of replication {}", a->kpis[k].kpi.name, r + 1);
    }
  ordered_json result = {{"run", again}, {"of_run", first}, {"values", values}, {"different", different}};
  result["identical"] = same_shape && different == 0;
  result["first_difference"] = where;
  result["versions"] = {a->header.provenance.version, b->header.provenance.version};
  result["platforms"] = {a->header.provenance.platform, b->header.provenance.platform};
  return result.dump();
}

JobSpec run_job(const json& body, const std::string& database) {
  const GivenScenario given = scenario_of(body);
  const scenarios::Scenario scenario = scenarios::load(given.changed);  // refused now, not in the child
  const std::string label = text_member(body, "label", "run", longest_label);
  return {.kind = "run",
          .title = scenario.name,
          .arguments = with_changes({"run", "scenario.json", "--json", "--db", database, "--label=" + label},
                                    given.changes),
          .files = {{"scenario.json", given.text}},
          .finish = run_result};
}

JobSpec study_job(const Call& call, const json& body, const std::string& database) {
  const GivenScenario given = scenario_of(body);
  const scenarios::Scenario scenario = scenarios::load(given.changed);
  if (!body.contains("study") || !body["study"].is_object())
    throw Refused{400, "body: study: must be the study, an object as in a study file without \"scenario\""};
  json study = body["study"];
  study["scenario"] = "scenario.json";
  std::vector<std::string> arguments = {"optimize", "study.json", "--json", "--db", database};
  arguments.insert(arguments.end(), call.study_flags.begin(), call.study_flags.end());
  return {.kind = "study",
          .title = study.contains("name") && study["name"].is_string() ? study["name"].get<std::string>()
                                                                       : scenario.name,
          .lengthy = true,
          .arguments = with_changes(std::move(arguments), given.changes),
          .files = {{"scenario.json", given.text}, {"study.json", study.dump(2) + "\n"}},
          .finish = study_result};
}

/// A stored run that a body names: {"run": 3}, as the shop it was.
struct StoredRun {
  store::Run run;
  std::vector<scenarios::Change> changes;
};
StoredRun stored_run(const Call& call, const json& body) {
  if (!body.contains("run") || !body["run"].is_number_integer())
    throw Refused{400, "body: run: must be the number of a run"};
  const auto id = body["run"].get<std::int64_t>();
  auto run = store::Reader(call.database).run(id, false);
  if (!run) throw Refused{404, fmt::format("there is no run {}", id)};
  json stored = {{"changes", json::parse(run->header.changes, nullptr, false)}};
  if (!stored["changes"].is_array())
    throw Refused{422, fmt::format("run {}: its changes are kept in a form that cannot be repeated", id)};
  return {std::move(*run), changes_of(stored)};
}

JobSpec again_job(const Call& call, const json& body, const std::string& database) {
  const StoredRun stored = stored_run(call, body);
  const std::int64_t id = stored.run.header.id;
  return {.kind = "again",
          .title = fmt::format("{} ({})", stored.run.header.scenario_name, id),
          .arguments = with_changes(
              {"run", "scenario.json", "--json", "--db", database, fmt::format("--label=run {} again", id)},
              stored.changes),
          .files = {{"scenario.json", stored.run.scenario_text}},
          .finish = [file = call.database, id](const std::string& output) {
            return repeated_result(file, id, output);
          }};
}

JobSpec trace_job(const Call& call, const json& body) {
  const StoredRun stored = stored_run(call, body);
  const std::int64_t id = stored.run.header.id;
  std::int64_t replication = 0;
  if (body.contains("replication")) {
    if (!body["replication"].is_number_integer())
      throw Refused{400, "body: replication: must be a whole number"};
    replication = body["replication"].get<std::int64_t>();
  }
  if (replication < 0 || replication >= stored.run.header.replications)
    throw Refused{422, fmt::format("replication {}: run {} has replications 0 to {}", replication, id,
                                   stored.run.header.replications - 1)};
  return {
      .kind = "trace",
      .title = fmt::format("{} ({})", stored.run.header.scenario_name, id),
      .arguments = with_changes(
          {"trace", "scenario.json", "--format", "compact", "--replication", std::to_string(replication)},
          stored.changes),
      .files = {{"scenario.json", stored.run.scenario_text}},
      .keep_output = true,
      .finish = [id, replication](const std::string& output) {
        return ordered_json{{"of_run", id}, {"replication", replication}, {"bytes", output.size()}}.dump();
      }};
}

/// What removing each loss of a run's shop would bring: `verstat losses`, stored as a study.
JobSpec losses_job(const Call& call, const json& body, const std::string& database) {
  const StoredRun stored = stored_run(call, body);
  if (stored.run.header.replications < 2)
    throw Refused{422, fmt::format("run {} has one replication; pricing its losses needs at least 2",
                                   stored.run.header.id)};
  std::vector<std::string> arguments = {"losses", "scenario.json", "--json", "--db", database};
  arguments.insert(arguments.end(), call.study_flags.begin(), call.study_flags.end());
  return {.kind = "losses",
          .title = fmt::format("{} ({})", stored.run.header.scenario_name, stored.run.header.id),
          .arguments = with_changes(std::move(arguments), stored.changes),
          .files = {{"scenario.json", stored.run.scenario_text}},
          .finish = study_result};
}

/// An interrupted study goes on where it stopped.
JobSpec resume_job(const Call& call, const json& body, const std::string& database) {
  if (!body.contains("study") || !body["study"].is_number_integer())
    throw Refused{400, "body: study: must be the number of a study"};
  const auto id = body["study"].get<std::int64_t>();
  const auto study = store::Reader(call.database).study(id, false);
  if (!study) throw Refused{404, fmt::format("there is no study {}", id)};
  const store::StudyHeader& header = study->header;
  if (header.kind != "optimize" && header.kind != "sweep")
    throw Refused{
        422, fmt::format("study {} is of the kind {}; only optimize and sweep can go on", id, header.kind)};
  if (header.status != "interrupted")
    throw Refused{409,
                  fmt::format("study {} is {}; only an interrupted one can go on here", id, header.status)};
  if (call.jobs != nullptr)
    for (const JobStatus& job : call.jobs->list())
      if (job.kind == "resume" && !job.over() && job.title.ends_with(fmt::format("({})", id)))
        throw Refused{409, fmt::format("study {} goes on already, as job {}", id, job.id)};
  std::vector<std::string> arguments = {header.kind, "--resume", std::to_string(id),
                                        "--json",    "--db",     database};
  arguments.insert(arguments.end(), call.study_flags.begin(), call.study_flags.end());
  return {.kind = "resume",
          .title = fmt::format("{} ({})", header.name, id),
          .lengthy = true,
          .arguments = std::move(arguments),
          .finish = study_result};
}

Jobs& jobs_of(const Call& call) {
  if (call.jobs == nullptr) throw Refused{404, "a read-only server has no jobs"};
  return *call.jobs;
}

}  // namespace

Response list_jobs(const Call& call) {
  check_query(call.target, {});
  ordered_json list = ordered_json::array();
  if (call.jobs != nullptr)
    for (const JobStatus& status : call.jobs->list()) list.push_back(job_json(status));
  ordered_json body = {{"total", list.size()}};
  body["jobs"] = std::move(list);
  return json_response(body);
}

Response show_job(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("job", call.parameters[0]);
  const auto status = jobs_of(call).find(id);
  if (!status)
    throw Refused{404, fmt::format("there is no job {}; jobs are forgotten when the server ends", id)};
  return json_response(job_json(*status));
}

Response start_job(const Call& call) {
  check_query(call.target, {});
  const json body =
      body_of(call.request, {"kind", "scenario", "changes", "label", "study", "run", "replication", "fit"});
  const std::string kind = text_member(body, "kind", "run", 20);
  const std::string database = std::filesystem::absolute(call.database).string();
  JobSpec spec;
  if (kind == "run") {
    spec = run_job(body, database);
  } else if (kind == "study") {
    spec = study_job(call, body, database);
  } else if (kind == "again") {
    spec = again_job(call, body, database);
  } else if (kind == "trace") {
    spec = trace_job(call, body);
  } else if (kind == "losses") {
    spec = losses_job(call, body, database);
  } else if (kind == "resume") {
    spec = resume_job(call, body, database);
  } else if (kind == "fit") {
    spec = fit_job(body);
  } else {
    throw Refused{
        400,
        fmt::format("body: kind: \"{}\": must be run, study, again, trace, losses, resume or fit", kind)};
  }
  const auto id = jobs_of(call).submit(std::move(spec));
  if (!id)
    throw Refused{503, fmt::format("{} jobs are waiting already; cancel some or wait", Jobs::most_waiting)};
  Response response = json_response(job_json(jobs_of(call).find(*id).value()), 202);
  response.headers["Location"] = fmt::format("/api/v1/jobs/{}", *id);
  return response;
}

Response cancel_job(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("job", call.parameters[0]);
  Jobs& jobs = jobs_of(call);
  if (!jobs.find(id)) throw Refused{404, fmt::format("there is no job {}", id)};
  if (!jobs.cancel(id)) throw Refused{409, fmt::format("job {} is over already", id)};
  return json_response(job_json(jobs.find(id).value()), 202);
}

Response follow_job(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("job", call.parameters[0]);
  auto events = jobs_of(call).events(id, [](const JobStatus& s) { return job_json(s).dump(); });
  if (!events) throw Refused{404, fmt::format("there is no job {}", id)};
  Response response{.content_type = "text/event-stream"};
  response.headers["Cache-Control"] = "no-store";
  response.stream = std::move(events);
  return response;
}

Response show_output(const Call& call) {
  check_query(call.target, {});
  const std::int64_t id = id_of("job", call.parameters[0]);
  const auto status = jobs_of(call).find(id);
  if (!status) throw Refused{404, fmt::format("there is no job {}", id)};
  if (!status->output)
    throw Refused{404, fmt::format("job {} keeps no output: only finished traces and fits do, the {} newest",
                                   id, Jobs::most_outputs)};
  return {.body = *status->output};
}

}  // namespace verstat::web
