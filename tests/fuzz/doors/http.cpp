// Every address of the server, in process: guard, router, handlers, database. An input is a request as it is
// sent, with a plain line end after each line of the head.
#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"
#include "store/database.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"
#include "tests/store/example_results.h"
#include "web-ui/server/site.h"

namespace verstat::fuzz {

namespace {

using nlohmann::json;

constexpr web::Asset pages[] = {
    {"/index.html", "text/html; charset=utf-8", "aaaa", false, "<p>plain</p>", "gzipped"},
    {"/assets/x-1.js", "text/javascript; charset=utf-8", "bbbb", true, "1;", ""}};
const char* const token = "0123456789abcdef";

// Of a scenario that can be drawn and run again.
store::Run a_run(int number) {
  store::Run run = test::example_run(number);
  run.header.changes = R"([{"pointer": "/machines/0/count", "value": 3}])";
  run.scenario_text = scenarios::read_text_file("scenarios/gallery/heavy-lathe.json");
  return run;
}

// A database of runs and studies, and jobs that wait for ever: a queue that is full is a state, too.
struct Server {
  Server() {
    const std::filesystem::path database = own_folder() + "/results.db";
    {
      store::Writer writer(database);
      for (int k = 1; k <= 3; ++k) writer.add_run(a_run(k));
      test::add_example_study(writer, "finished");
      test::add_example_study(writer, "interrupted");
    }
    const std::filesystem::path program = write_own("program.sh", "#!/bin/sh\nexec sleep 3600\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    writing.emplace(web::Api(database, "9.9", std::make_shared<web::Jobs>(program)), pages);
    reading.emplace(web::Api(database, "9.9"), pages);
  }
  std::optional<web::Site> writing;
  std::optional<web::Site> reading;
  web::Guard open = web::guard_for("127.0.0.1", true, 8080, "");
  web::Guard locked = web::guard_for("192.0.2.1", false, 8080, token);
};

web::Request request_of(std::string_view bytes) {
  web::Request request;
  const auto line = [&] {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view text = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return text;
  };
  const std::string_view first = line();
  const std::size_t space = std::min(first.find(' '), first.size());
  request.method = first.substr(0, space);
  request.target = first.substr(std::min(space + 1, first.size()));
  for (std::string_view text = line(); !text.empty(); text = line()) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    std::string name(text.substr(0, colon));
    std::transform(name.begin(), name.end(), name.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    text.remove_prefix(std::min(colon + 1, text.size()));
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    std::string& value = request.headers[name];
    if (!value.empty()) value += ", ";
    value += text;
  }
  request.body = bytes;
  return request;
}

void check(const web::Response& response) {
  constexpr std::array expected = {200, 202, 304, 400, 401, 403, 404, 405, 409, 415, 422, 503};
  if (std::find(expected.begin(), expected.end(), response.status) == expected.end())
    finding(fmt::format("status {}: {}", response.status, response.body));
  const auto plain = [](const std::string& text) {
    return std::none_of(text.begin(), text.end(), [](char c) {
      return (static_cast<unsigned char>(c) < 0x20 && c != '\t') || c == 0x7f;
    });
  };
  if (!plain(response.content_type)) finding("a content type with control characters");
  for (const auto& [name, value] : response.headers)
    if (!plain(name) || !plain(value)) finding("a header with control characters: " + name);
  constexpr std::size_t worth_reading = 4000;
  if (response.content_type == "application/json" && response.status != 304 && !response.stream &&
      response.body.size() < worth_reading && !json::accept(response.body))
    finding("an answer that is no JSON: " + response.body);
  if (response.stream)
    for (int k = 0; k < 3 && response.stream->next(); ++k) continue;
}

void eat(std::string_view bytes) {
  static const Server server;
  const web::Request request = request_of(bytes);
  const bool locked = request.headers.contains("authorization");
  const bool reading = request.headers.contains("x-reading");
  check((reading ? server.reading : server.writing)->answer(locked ? server.locked : server.open, request));
}

std::string asks(const std::string& method, const std::string& target, const std::string& more = "") {
  return method + " /api/v1" + target + "\nHost: 127.0.0.1:8080\n" + more + "\n";
}
std::string sends(const std::string& method, const std::string& target, const std::string& body) {
  return asks(method, target, "X-Verstat: 1\nContent-Type: application/json\n") + body;
}

std::vector<std::string> seeds() {
  std::vector<std::string> all;
  for (const auto& [method, pattern] : web::Api::routes()) {
    std::string target(pattern);
    if (const auto id = target.find("{id}"); id != std::string::npos) target.replace(id, 4, "1");
    if (const auto key = target.find("{key}"); key != std::string::npos)
      target.replace(key, 5, "K117.weibull_from_moments");
    all.push_back(method == "GET" ? asks("GET", target) : sends(std::string(method), target, "{}"));
  }
  const std::string cell = json_in("scenarios/gallery", "heavy-lathe.json", 4000).at(0);
  const std::string study = json_in("scenarios/gallery", "heavy-lathe.study.json", 4000).at(0);
  const std::string turning = json_in("scenarios/gallery/operations", "turning.json", 4000).at(0);
  const std::string text = json(cell).dump();
  const std::string change = R"([{"pointer":"/machines/0/count","value":3}])";
  const std::vector<std::string> more = {
      asks("GET", "/runs?limit=2&offset=1&search=cell&sort=label&order=down&tag=a"),
      asks("GET", "/runs/2?replications=1&format=csv&separator=semicolon&decimal=comma"),
      asks("GET", "/studies/1?format=csv"),
      asks("GET", "/studies/1/trials?limit=10&offset=0&stage=analytic"),
      asks("GET", "/models?search=wear+life"),
      asks("HEAD", "/runs", "If-None-Match: *\nAccept-Encoding: gzip;q=0.5, br\n"),
      asks("GET", "/runs", fmt::format("Authorization: Bearer {}\n", token)),
      asks("GET", "/jobs/1/events"),
      asks("DELETE", "/jobs/1", "X-Verstat: 1\nOrigin: http://127.0.0.1:8080\nSec-Fetch-Site: same-origin\n"),
      "GET / HTTP/1.1\nHost: localhost:8080\nAccept-Encoding: gzip\n\n",
      "GET /assets/x-1.js\nHost: localhost:8080\n\n",
      sends("PUT", "/runs/1/notes", R"({"note":"good","tags":["a","b"]})"),
      sends("PUT", "/studies/1/notes", R"({"note":"better","tags":["c"]})"),
      sends("POST", "/models/K117.weibull_from_moments/eval", R"({"inputs":{"mean_min":60,"cv":0.7}})"),
      sends("POST", "/models/K117.weibull_from_moments/map",
            R"({"inputs":{"mean_min":60},"output":"shape","x":{"name":"cv","values":[0.1,0.7]},)"
            R"("y":{"name":"mean_min","values":[30,60]}})"),
      sends("POST", "/plan", R"({"operation":)" + turning + "}"),
      sends("POST", "/plan?explain=1",
            R"({"scenario":)" + cell + R"(,"operation":"rough turning","changes":)" + change +
                R"(,"sweep":{"pointer":"/operations/0/process/feed_mm_rev","values":[0.5,1]}})"),
      sends("POST", "/check", R"({"scenario":)" + cell + R"(,"changes":)" + change + "}"),
      sends("POST", "/check", R"({"scenario":)" + text + "}"),
      sends("POST", "/jobs",
            R"({"kind":"run","scenario":)" + cell + R"(,"changes":)" + change + R"(,"label":"x"})"),
      sends("POST", "/jobs", R"({"kind":"study","scenario":)" + cell + R"(,"study":)" + study + "}"),
      sends("POST", "/jobs", R"({"kind":"again","run":1})"),
      sends("POST", "/jobs", R"({"kind":"trace","run":1,"replication":1})"),
      sends("POST", "/jobs", R"({"kind":"losses","run":1})"),
      sends("POST", "/jobs", R"({"kind":"resume","study":2})"),
      sends("POST", "/jobs",
            R"({"kind":"fit","fit":{"what":"life","table":"time,cause\n1,worn\n","file":"a.csv",)"
            R"("columns":{"life":"time"},"options":{"gamma":0.8,"bootstrap":19}}})"),
      sends("POST", "/jobs",
            R"({"kind":"fit","fit":{"what":"cycle","table":"x","options":{"empirical":true}}})")};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace

Target http_target() {
  return {"http", Form::request, eat, seeds};
}

}  // namespace verstat::fuzz
