// The queue of jobs, with a shell script in the program's place: it can fail, crash, stall and talk at will.

#include "web-ui/server/jobs.h"

#include <chrono>
#include <thread>

#include <catch2/catch.hpp>

#include "scenarios/json_text.h"
#include "tests/web/serving.h"

using namespace verstat;
using namespace verstat::web_test;
using namespace std::chrono_literals;

namespace {

const std::string gallery = VERSTAT_SOURCE_DIR "/scenarios/gallery/";

json wait_for(const Serving& serving, int id) {
  const auto start = std::chrono::steady_clock::now();
  for (;;) {
    json job = serving.get(fmt::format("/api/v1/jobs/{}", id)).parsed();
    const std::string state = job["state"];
    if ((state != "queued" && state != "running") || std::chrono::steady_clock::now() - start > 20s)
      return job;
    std::this_thread::sleep_for(20ms);
  }
}

std::string run_body(const std::string& label = "mine") {
  return json{{"kind", "run"},
              {"scenario", scenarios::read_text_file(gallery + "heavy-lathe.json")},
              {"changes", {{{"pointer", "/machines/0/count"}, {"value", 3}}}},
              {"label", label}}
      .dump();
}

}  // namespace

TEST_CASE("progress is read from JSON lines and from plain ones") {
  web::JobStatus status;
  CHECK(web::read_progress(R"({"stage": "analytic", "trials": 12, "of": 400, "best": 1.5, "left_s": 3})",
                           status));
  CHECK(status.stage == "analytic");
  CHECK(status.done == 12);
  CHECK(status.of == 400);
  CHECK(status.best == 1.5);
  CHECK(status.left_s == 3.0);
  CHECK(web::read_progress("replications: 3 of 20, 5 s left", status));
  CHECK(status.stage == "replications");
  CHECK(status.done == 3);
  CHECK(status.of == 20);
  CHECK(status.left_s == 5.0);
  CHECK_FALSE(status.best);
  CHECK(web::read_progress("analytic: 12 of 400,  best 125.4 3 s left", status));
  CHECK(status.best == 125.4);
  CHECK(status.left_s == 3.0);
  for (const char* line : {"", "error: no", "{", "{}", R"({"done": "x"})", "x: 3 of", "warning: 3 of 4"})
    CHECK_FALSE(web::read_progress(line, status));
}

TEST_CASE("a run is started with the scenario, its changes and the database, and its result is kept") {
  // The script says what it was given.
  const Serving serving({}, "", R"(
for word in "$@"; do echo "$word" >> words; done
test -f scenario.json || exit 3
echo '{"done": 1, "of": 2, "stage": "replications"}' >&2
cp words "$(dirname "$0")/words"
echo '{"id": 7}'
)");
  const Answer started = serving.post("/api/v1/jobs", run_body());
  REQUIRE(started.status == 202);
  CHECK(started.headers.at("Location") == "/api/v1/jobs/1");
  const json job = wait_for(serving, 1);
  CHECK(job["state"] == "finished");
  CHECK(job["result"]["run"] == 7);
  CHECK(job["done"] == 1);
  CHECK(job["title"] == "Heavy-lathe cell");
  std::ifstream in(serving.file().parent_path() / "words");
  std::vector<std::string> words;
  for (std::string line; std::getline(in, line);) words.push_back(line);
  CHECK(words == std::vector<std::string>{"run", "scenario.json", "--json", "--db",
                                          std::filesystem::absolute(serving.file()).string(), "--label=mine",
                                          "--set", "/machines/0/count=3"});
  CHECK(serving.get("/api/v1/jobs").parsed()["total"] == 1);
}

TEST_CASE("the events of a job are streamed to its end") {
  const Serving serving({.stream_pause = 10ms}, "", R"(
for k in 1 2 3; do echo "{\"done\": $k, \"of\": 3}" >&2; sleep 0.1; done
echo '{"id": 7}'
)");
  REQUIRE(serving.post("/api/v1/jobs", run_body()).status == 202);
  const Answer stream = serving.get("/api/v1/jobs/1/events");
  CHECK(stream.status == 200);
  CHECK(stream.headers.at("Content-Type") == "text/event-stream");
  CHECK(stream.headers.count("ETag") == 0);
  CHECK_THAT(stream.headers.at("Content-Security-Policy"), Catch::Contains("default-src 'none'"));
  CHECK_THAT(stream.body, Catch::Contains("event: job\ndata: {"));
  CHECK_THAT(stream.body, Catch::Contains("\"done\":2"));
  CHECK_THAT(stream.body, Catch::Contains("\"state\":\"finished\""));
  CHECK(stream.body.ends_with("0\r\n\r\n"));  // the last chunk: the stream has ended, not broken off
  CHECK(serving.get("/api/v1/jobs/9/events").status == 404);
}

TEST_CASE("streams are limited, and leave the server free to answer") {
  const Serving serving({.most_streams = 2, .stream_pause = 10ms}, "", "sleep 30");
  REQUIRE(serving.post("/api/v1/jobs", run_body()).status == 202);
  const std::string ask =
      fmt::format("GET /api/v1/jobs/1/events HTTP/1.1\r\nHost: {}\r\n\r\n", serving.host());
  const Socket a(serving.port());
  const Socket b(serving.port());
  for (const Socket* socket : {&a, &b}) {
    socket->send(ask);
    CHECK_THAT(socket->read_piece(), Catch::Contains("200 OK"));
  }
  CHECK(serving.get("/api/v1/jobs/1/events").status == 503);
  CHECK(serving.get("/api/v1/runs").status == 200);
  CHECK(serving.post("/api/v1/jobs/1", "", "X-Verstat: 1\r\n", "DELETE").status == 202);
  CHECK(wait_for(serving, 1)["state"] == "cancelled");
}

TEST_CASE("a job can be cancelled while it runs and while it waits") {
  const Serving serving({}, "", "exec sleep 60");
  for (int k = 0; k < 2; ++k) REQUIRE(serving.post("/api/v1/jobs", run_body()).status == 202);
  while (serving.get("/api/v1/jobs/1").parsed()["state"] != "running") std::this_thread::sleep_for(10ms);
  CHECK(serving.get("/api/v1/jobs/2").parsed()["state"] == "queued");
  const auto cancel = [&](int id) {
    return serving.post(fmt::format("/api/v1/jobs/{}", id), "", "X-Verstat: 1\r\n", "DELETE").status;
  };
  CHECK(cancel(2) == 202);
  CHECK(wait_for(serving, 2)["state"] == "cancelled");
  const auto start = std::chrono::steady_clock::now();
  CHECK(cancel(1) == 202);
  CHECK(wait_for(serving, 1)["state"] == "cancelled");
  CHECK(std::chrono::steady_clock::now() - start < 4s);
  CHECK(cancel(1) == 409);
  CHECK(cancel(9) == 404);
}

TEST_CASE("a study does not keep a simulation waiting") {
  const Serving serving({}, "", "test \"$1\" = optimize && sleep 30\necho '{\"id\": 7}'");
  json study = json::parse(run_body());
  study["kind"] = "study";
  study.erase("label");
  study["study"] = {{"name", "long"}};
  REQUIRE(serving.post("/api/v1/jobs", study.dump()).status == 202);
  REQUIRE(serving.post("/api/v1/jobs", run_body()).status == 202);
  CHECK(wait_for(serving, 2)["state"] == "finished");
  CHECK(serving.get("/api/v1/jobs/1").parsed()["state"] == "running");
}

TEST_CASE("a child has nothing of the server's open but its pipes") {
  const Serving serving({}, "", "ls -l /proc/self/fd | grep -c socket >&2; exit 4");
  REQUIRE(serving.post("/api/v1/jobs", run_body()).status == 202);
  CHECK(wait_for(serving, 1)["message"] == "0");
}

TEST_CASE("a child that fails, crashes or talks nonsense fails its job alone") {
  const Serving serving({}, "", R"(
case "$6" in
  --label=fails) echo "error: scenario: /machines/0/count = 0" >&2; exit 2;;
  --label=crashes) kill -SEGV $$;;
  --label=nonsense) echo "no json";;
  --label=silent) echo '{}';;
esac
)");
  auto outcome = [&, id = 0](const std::string& label) mutable {
    REQUIRE(serving.post("/api/v1/jobs", run_body(label)).status == 202);
    const json job = wait_for(serving, ++id);
    CHECK(job["state"] == "failed");
    return job["message"].get<std::string>();
  };
  CHECK(outcome("fails") == "scenario: /machines/0/count = 0");
  CHECK_THAT(outcome("crashes"), Catch::Contains("139"));
  CHECK_FALSE(outcome("nonsense").empty());
  CHECK_THAT(outcome("silent"), Catch::Contains("\"id\""));
  CHECK(serving.get("/api/v1/health").status == 200);
}

TEST_CASE("bad jobs are refused before anything is started") {
  const Serving serving({}, "", "echo '{\"id\": 7}'");
  const auto refused = [&](json changes, int status, const std::string& part) {
    json body = json::parse(run_body());
    body.update(changes);
    const Answer answer = serving.post("/api/v1/jobs", body.dump());
    CAPTURE(answer.body);
    CHECK(answer.status == status);
    CHECK_THAT(answer.message(), Catch::Contains(part));
  };
  refused({{"kind", "format"}}, 400, "run, study, again, trace, losses, resume or fit");
  refused({{"scenario", 1}}, 400, "scenario");
  refused({{"scenario", "{"}}, 422, "not JSON");
  refused({{"changes", {{{"pointer", "/machines/0/count"}, {"value", 0}}}}}, 422, "count");
  refused({{"changes", {{{"pointer", "--db"}, {"value", 0}}}}}, 400, "pointer");
  refused({{"label", std::string(201, 'x')}}, 400, "label");
  refused({{"more", 1}}, 400, "no such member");
  refused({{"kind", "study"}}, 400, "study");
  refused({{"kind", "again"}, {"run", 99}}, 404, "no run 99");
  CHECK(serving.post("/api/v1/jobs", run_body(), "Content-Type: application/json\r\n").status == 403);
  CHECK(serving.get("/api/v1/jobs").parsed()["total"] == 0);
}

TEST_CASE("the queue has an end") {
  const Serving serving({}, "", "sleep 30");
  int accepted = 0;
  while (accepted < 40 && serving.post("/api/v1/jobs", run_body()).status == 202) ++accepted;
  CHECK(accepted >= static_cast<int>(web::Jobs::most_waiting));
  CHECK(accepted <= static_cast<int>(web::Jobs::most_waiting) + 1);
}

TEST_CASE("the trace of one replication is kept and handed out, of the newest jobs only") {
  const Serving serving({}, "", "echo \"{\\\"machines\\\": \\\"$*\\\"}\"");
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "trace", "run": 1, "replication": 2})").status == 422);
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "trace", "run": 99})").status == 404);
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "trace"})").status == 400);
  const int count = static_cast<int>(web::Jobs::most_outputs) + 1;
  for (int k = 0; k < count; ++k)
    REQUIRE(serving.post("/api/v1/jobs", R"({"kind": "trace", "run": 1, "replication": 1})").status == 202);
  const json last = wait_for(serving, count);
  CHECK(last["state"] == "finished");
  CHECK(last["result"]["of_run"] == 1);
  const Answer output = serving.get(fmt::format("/api/v1/jobs/{}/output", count));
  CHECK(output.parsed()["machines"] ==
        "trace scenario.json --format compact --replication 1 --set /seed=0.1");
  CHECK(serving.get("/api/v1/jobs/2/output").status == 200);
  CHECK(serving.get("/api/v1/jobs/1/output").status == 404);
}

TEST_CASE("a read-only server computes but starts and stores nothing") {
  const Serving serving;
  CHECK(serving.get("/api/v1/version").parsed()["read_only"] == true);
  CHECK(serving.post("/api/v1/jobs", run_body()).status == 403);
  CHECK(serving
            .post("/api/v1/runs/1/notes", R"({"note": "x"})",
                  "X-Verstat: 1\r\nContent-Type: application/json\r\n", "PUT")
            .status == 403);
  CHECK_FALSE(std::filesystem::exists(serving.file().string() + ".notes"));
  CHECK(
      serving
          .post("/api/v1/models/K117.weibull_from_moments/eval", R"({"inputs": {"mean_min": 60, "cv": 0.7}})")
          .status == 200);
}

TEST_CASE("a run says which limits its shop breaks, when asked") {
  const Serving serving;
  store::Run run = example_run(1);
  run.scenario_text = scenarios::read_text_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/bearing-rings.json");
  const auto stored = [&](const char* changes) {
    run.header.changes = changes;
    return store::Writer(serving.file()).add_run(run);
  };
  const auto breaking = stored("[]");
  const auto keeping = stored(R"([{"pointer": "/operations/0/process/feed_mm_rev", "value": 0.15}])");
  const auto warned = [&](std::int64_t id) {
    return serving.get(fmt::format("/api/v1/runs/{}?warnings=1", id)).parsed()["warnings"];
  };
  REQUIRE(warned(breaking).size() == 1);
  CHECK(warned(breaking)[0]["limit"] == "feed_mm_rev");
  CHECK(warned(breaking)[0]["text"].get<std::string>().find("forbidden band") != std::string::npos);
  CHECK(warned(keeping).empty());
  CHECK(warned(1).empty());  // a scenario that this version does not read
  CHECK_FALSE(serving.get(fmt::format("/api/v1/runs/{}", breaking)).parsed().contains("warnings"));
  const json scenario = json::parse(run.scenario_text);
  const json checked = serving.post("/api/v1/check", json{{"scenario", scenario}}.dump()).parsed();
  CHECK(checked["warnings"] == warned(breaking));
}

TEST_CASE("notes and tags are kept, found and listed") {
  const Serving serving({}, "", "true");
  const auto put = [&](const std::string& target, const std::string& body) {
    return serving.post(target, body, "X-Verstat: 1\r\nContent-Type: application/json\r\n", "PUT");
  };
  const Answer kept = put("/api/v1/runs/3/notes",
                          R"({"note": " Токарний верстат ", "tags": ["night", " ", "night", "баз"]})");
  REQUIRE(kept.status == 200);
  CHECK(kept.parsed() == json{{"note", "Токарний верстат"}, {"tags", {"night", "баз"}}});
  CHECK(put("/api/v1/runs/99/notes", "{}").status == 404);
  CHECK(put("/api/v1/runs/3/notes", R"({"tags": "night"})").status == 400);
  CHECK(put("/api/v1/runs/3/notes", json{{"note", std::string(20'000, 'x')}}.dump()).status == 400);
  const auto ids = [&](const std::string& query) {
    std::vector<int> found;
    const json page = serving.get("/api/v1/runs?" + query).parsed();
    for (const json& run : page["runs"]) found.push_back(run["id"]);
    return found;
  };
  CHECK(ids("tag=night") == std::vector<int>{3});
  CHECK(ids("search=%D0%92%D0%95%D0%A0%D0%A1%D0%A2%D0%90%D0%A2") == std::vector<int>{3});  // ВЕРСТАТ
  CHECK(ids("search=run+quoted&limit=2") == std::vector<int>{7, 6});
  CHECK(ids("search=nothing").empty());
  CHECK(ids("sort=cost_per_part&order=asc&limit=2") == std::vector<int>{1, 2});
  CHECK(ids("sort=label&order=asc&limit=1") == std::vector<int>{1});
  CHECK(serving.get("/api/v1/runs?sort=id;drop").status == 400);
  CHECK(serving.get("/api/v1/tags").parsed()["tags"] ==
        json{{{"name", "night"}, {"count", 1}}, {{"name", "баз"}, {"count", 1}}});
  const json run = serving.get("/api/v1/runs/3?notes=1").parsed();
  CHECK(run["note"] == "Токарний верстат");
  put("/api/v1/studies/1/notes", R"({"tags": ["night"]})");
  CHECK(serving.get("/api/v1/studies?tag=night").parsed()["total"] == 1);
  put("/api/v1/runs/3/notes", "{}");
  CHECK(ids("tag=night").empty());
}

TEST_CASE("a table is fitted with the flags of the command line, and its answer can be had") {
  const Serving serving({}, "", R"sh(
for word in "$@"; do echo "$word" >> words; done
cp words "$(dirname "$0")/words"
printf '{"patch": {}, "table": "%s"}' "$(cat removals_1.csv)"
)sh");
  const json body = {{"kind", "fit"},
                     {"fit",
                      {{"what", "life"},
                       {"table", "life;cause"},
                       {"file", "../data/removals 1.csv"},
                       {"columns", {{"life", "Cutting time, min"}}},
                       {"options", {{"to", "/inserts/0"}, {"gamma", 0.9}}}}}};
  REQUIRE(serving.post("/api/v1/jobs", body.dump()).status == 202);
  const json job = wait_for(serving, 1);
  REQUIRE(job["state"] == "finished");
  CHECK(job["result"]["fit"] == "life");
  CHECK(job["result"]["patch"] == true);
  CHECK(serving.get("/api/v1/jobs/1/output").parsed()["table"] == "life;cause");
  std::ifstream in(serving.file().parent_path() / "words");
  std::vector<std::string> words;
  for (std::string line; std::getline(in, line);) words.push_back(line);
  CHECK(words == std::vector<std::string>{"fit", "life", "removals_1.csv", "--json",
                                          "--column=life=Cutting time, min", "--gamma=0.9",
                                          "--to=/inserts/0"});
}

TEST_CASE("fits that would reach beyond their table are refused") {
  const Serving serving({}, "", "echo '{}'");
  const auto refused = [&](json changes, const std::string& part) {
    json fit = {{"what", "life"}, {"table", "life;cause"}};
    fit.update(changes);
    const Answer answer = serving.post("/api/v1/jobs", json{{"kind", "fit"}, {"fit", fit}}.dump());
    CAPTURE(answer.body);
    CHECK(answer.status == 400);
    CHECK_THAT(answer.message(), Catch::Contains(part));
  };
  refused({{"what", "value"}}, "life, taylor, downtime, arrivals or cycle");
  refused({{"table", ""}}, "CSV");
  refused({{"options", {{"out", "/etc/passwd"}}}}, "\"out\" is no flag");
  refused({{"options", {{"criterion", 0.3}}}}, "\"criterion\" is no flag of verstat fit life");
  refused({{"options", {{"tool", "a\nb"}}}}, "one line");
  refused({{"options", {{"library", "/tmp"}}}}, "\"library\" is no flag");
  refused({{"what", "cycle"}, {"options", {{"empirical", "yes"}}}}, "must be true or false");
  refused({{"options", {{"tool", json::array()}}}}, "a text or a number");
  refused({{"columns", {{"--out", "x"}}}}, "no role");
  refused({{"more", 1}}, "\"more\" is not known");
}

TEST_CASE("losses are priced for a stored run; only an interrupted study goes on") {
  const Serving serving({}, "", R"(
for word in "$@"; do echo "$word" >> words; done
cp words "$(dirname "$0")/words"
echo '{"study": 4}'
)");
  const auto words = [&] {
    std::ifstream in(serving.file().parent_path() / "words");
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
  };
  REQUIRE(serving.post("/api/v1/jobs", R"({"kind": "losses", "run": 1})").status == 202);
  CHECK(wait_for(serving, 1)["result"]["study"] == 4);
  REQUIRE(words().size() >= 5);
  CHECK(words()[0] == "losses");
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "losses", "run": 99})").status == 404);
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "resume", "study": 1})").status == 409);
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "resume", "study": 99})").status == 404);
  CHECK(serving.post("/api/v1/jobs", R"({"kind": "resume", "study": "x"})").status == 400);
  std::int64_t id = 0;
  {
    store::Writer writer(serving.file());
    store::Study study = store::Reader(serving.file()).study(1).value();
    study.header.kind = "sweep";
    id = writer.begin_study(study);
    writer.finish_study(id, std::nullopt, std::nullopt, "{}", "interrupted");
  }
  REQUIRE(serving.post("/api/v1/jobs", fmt::format(R"({{"kind": "resume", "study": {}}})", id)).status ==
          202);
  CHECK(wait_for(serving, 2)["state"] == "finished");
  REQUIRE(words().size() >= 3);
  CHECK(words()[0] == "sweep");
  CHECK(words()[1] == "--resume");
  CHECK(words()[2] == std::to_string(id));

  // A program that was killed leaves its study "running": nobody holds it, so it may go on.
  {
    store::Writer writer(serving.file());
    store::Study study = store::Reader(serving.file()).study(1).value();
    study.header.kind = "optimize";
    id = writer.begin_study(study);
    const std::string body = fmt::format(R"({{"kind": "resume", "study": {}}})", id);
    CHECK(serving.get(fmt::format("/api/v1/studies/{}", id)).parsed()["status"] == "running");
    CHECK(serving.post("/api/v1/jobs", body).status == 409);
  }
  CHECK(serving.get(fmt::format("/api/v1/studies/{}", id)).parsed()["status"] == "interrupted");
  CHECK(serving.get("/api/v1/studies").parsed()["studies"][0]["status"] == "interrupted");
  CHECK(serving.post("/api/v1/jobs", fmt::format(R"({{"kind": "resume", "study": {}}})", id)).status == 202);
  CHECK(wait_for(serving, 3)["state"] == "finished");
}
