// What strangers may do to `verstat serve` over its socket: no crash, no leak, nothing read that is not
// served, and those who behave are answered all the while.
#include <chrono>
#include <deque>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "tests/faults/served.h"

using nlohmann::json;
using namespace verstat::test;
using verstat::web_test::parse_answer;
using verstat::web_test::Socket;
namespace fs = std::filesystem;

namespace {

const std::string small_run =
    "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=12000 --replications 4 --db ";

struct Shown {
  Workspace w;
  std::string db = w.file("shown.db");
  int run = ended(start(small_run + db));
  Served server{db, "", w.file("said"), "TMPDIR=" + w.file("tmp")};
  json expected;
  Shown() {
    REQUIRE(run == 0);
    fs::create_directories(w.file("tmp"));
    REQUIRE(server.port() != 0);
    expected = served();
  }
  [[nodiscard]] json served() const {
    const auto answer = server.get("/api/v1/runs/1?replications=1");
    REQUIRE(answer.status == 200);
    return answer.parsed();
  }
  [[nodiscard]] std::string raw(const std::string& text) const {
    const Socket socket(server.port());
    socket.send(text);
    return socket.read_all();
  }
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

TEST_CASE("2500 idle connections and 170 slow ones: others are served, memory is bounded, nothing leaks",
          "[server]") {
  constexpr std::size_t idle_connections = 2500;
  rlimit files{};
  ::getrlimit(RLIMIT_NOFILE, &files);
  if (files.rlim_max < idle_connections + 200) {
    WARN("not tested here: " << idle_connections << " connections need more open files than "
                             << files.rlim_max);
    return;
  }
  const rlim_t before = files.rlim_cur;
  files.rlim_cur = files.rlim_max;
  const Shown shown;  // the server has the limit of any user
  ::setrlimit(RLIMIT_NOFILE, &files);
  const pid_t server = shown.server.process();
  for (int k = 0; k < 20; ++k) REQUIRE(shown.served() == shown.expected);
  const long memory_kb = status_of(server, "VmRSS");
  const std::size_t descriptors = descriptors_of(server);
  long most_kb = 0;
  double slowest_s = 0;
  int answered = 0;
  const auto ask = [&] {
    const auto begin = std::chrono::steady_clock::now();
    CHECK(shown.served() == shown.expected);
    ++answered;
    slowest_s = std::max(slowest_s, seconds_since(begin));
    most_kb = std::max(most_kb, status_of(server, "VmRSS"));
  };
  {
    std::deque<Socket> idle;
    for (std::size_t k = 0; k < idle_connections; ++k) {
      idle.emplace_back(shown.server.port());
      REQUIRE(idle.back().connected());
      if (k % 100 == 0) ask();
    }
    // A byte a second each, of a request that never ends; two places in three are theirs.
    std::deque<Socket> slow;
    const std::string request =
        "GET /api/v1/runs/1 HTTP/1.1\r\nHost: " + shown.server.host() + "\r\nX-Slow: xxxxxxxxxxxxx";
    for (int k = 0; k < 170; ++k) slow.emplace_back(shown.server.port());
    const auto begin = std::chrono::steady_clock::now();
    std::size_t alive = slow.size();
    for (std::size_t second = 0; second < 13; ++second) {
      alive = 0;
      for (const Socket& socket : slow) alive += socket.send(request.substr(second, 1)) ? 1 : 0;
      ask();
      std::this_thread::sleep_until(begin + std::chrono::seconds(second + 1));
    }
    // The whole request must come within 10 s of its first byte.
    CHECK(alive == 0);
    CHECK(descriptors_of(server) < 256 + 16 + 40);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  for (int k = 0; k < 20; ++k) ask();
  CHECK(descriptors_of(server) <= descriptors + 2);
  CHECK(most_kb < memory_kb + 40'000);
  CHECK(slowest_s < 2);
  files.rlim_cur = before;
  ::setrlimit(RLIMIT_NOFILE, &files);
  WARN("idle and slow clients: memory " << memory_kb << " kB before, " << most_kb << " kB at most, "
                                        << status_of(server, "VmRSS") << " kB after; " << answered
                                        << " honest requests, the slowest " << slowest_s << " s");
}

TEST_CASE("huge, chunked and contradictory bodies are refused, and cost no memory", "[server]") {
  const Shown shown;
  const pid_t server = shown.server.process();
  const long memory_kb = status_of(server, "VmRSS");
  const std::string post = "POST /api/v1/check HTTP/1.1\r\nHost: " + shown.server.host() +
                           "\r\nX-Verstat: 1\r\nContent-Type: application/json\r\n";
  // Announced: refused before a byte of it has come.
  CHECK(parse_answer(shown.raw(post + "Content-Length: 10000000000\r\n\r\n")).status == 413);
  for (const char* length : {"99999999999999999999999", "-1", "1e3", "0x10", "12 13", ""})
    CHECK(parse_answer(shown.raw(post + "Content-Length: " + length + "\r\n\r\n{}")).status == 400);
  // Two ways to say how long it is, and a proxy in front would take the other one.
  CHECK(parse_answer(shown.raw(post + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}\n")).status == 400);
  for (const char* both : {"Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
                           "Transfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n0\r\n\r\n"})
    CHECK(parse_answer(shown.raw(post + both)).status == 400);
  const std::string chunked = post + "Transfer-Encoding: chunked\r\n\r\n";
  for (const char* bad : {"zz\r\n", "-1\r\n", "ffffffffffffffffff\r\n", "2\r\n{}x\r\n"})
    CHECK_THAT(shown.raw(chunked + bad), !Catch::Contains("HTTP/1.1 2"));  // refused, or hung up on
  const auto swallowed = [&](const std::string& head, const std::string& piece) {
    const Socket socket(shown.server.port());
    REQUIRE(socket.send(head));
    std::size_t sent = 0;
    while (sent < 200'000'000 && socket.send(piece)) sent += piece.size();
    return sent;
  };
  const std::string block(65536, ' ');
  // Never ending: bodies, a chunk's own header, trailers, the request's header.
  CHECK(swallowed(chunked, "10000\r\n" + block + "\r\n") < 100'000'000);
  CHECK(swallowed(chunked + "1;x=", block) < 100'000'000);
  CHECK(swallowed(chunked + "0\r\n", "X-Trailer: " + std::string(1000, 'x') + "\r\n") < 100'000'000);
  CHECK(swallowed(post, "X-Header: " + std::string(1000, 'x') + "\r\n") < 100'000'000);
  CHECK(swallowed("GET /", block) < 100'000'000);
  // A whole chunked request is a request like any other.
  const Socket good(shown.server.port());
  good.send(post +
            "Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n3\r\n{\"s\r\n5\r\n\": 1}\r\n0\r\n\r\n");
  const auto answer = parse_answer(good.read_all());
  CHECK(answer.status == 400);
  CHECK_THAT(answer.body, Catch::Contains("no such member"));
  CHECK(shown.served() == shown.expected);
  CHECK(status_of(server, "VmRSS") < memory_kb + 20'000);
}

TEST_CASE("line ends in an address never reach a header", "[server]") {
  const Shown shown;
  const std::string evil = "%0d%0aX-Injected:%201%0d%0a%0d%0a<script>";
  int asked = 0;
  const json description = shown.server.get("/api/v1/openapi.json").parsed();
  std::vector<std::string> targets = {"/", "/assets/x"};
  for (const auto& [path, methods] : description["paths"].items()) {
    std::string target = "/api/v1" + path;
    for (const char* name : {"{id}", "{key}"})
      if (const auto at = target.find(name); at != std::string::npos)
        target.replace(at, std::string(name).size(), "1" + evil);
    targets.push_back(target);
  }
  for (const std::string& target : targets)
    for (const std::string& more : {std::string(), evil, "?format=csv&" + evil + "=1", "?search=" + evil,
                                    std::string("?sort=%0aX-Injected:1")})
      for (const char* method : {"GET", "HEAD", "POST", "PUT", "DELETE"}) {
        const std::string text =
            shown.raw(shown.server.request(method, target + more, "{}", "Connection: close\r\n"));
        const auto answer = parse_answer(text);
        INFO(method << " " << target << more << ": " << text.substr(0, 500));
        REQUIRE(answer.status >= 200);
        REQUIRE(answer.headers.count("X-Injected") == 0);
        REQUIRE(text.substr(0, text.find("\r\n\r\n")).find("Injected") == std::string::npos);
        ++asked;
      }
  // Raw ones are no HTTP; a folded header is not taken for two.
  for (const char* raw :
       {"GET /\nX-Injected: 1 HTTP/1.1\r\nHost: x\r\n\r\n", "GET /\rX HTTP/1.1\r\nHost: x\r\n\r\n",
        "GET / HTTP/1.1\r\nHost: a\rb\r\n\r\n", "GET / HTTP/1.1\r\nHost: a\r\n b\r\n\r\n"})
    CHECK(parse_answer(shown.raw(raw)).status >= 400);
  CHECK(asked > 500);
}

TEST_CASE("no address leads to a file outside the pages", "[server]") {
  const Shown shown;
  for (const char* target : {"/../../../../etc/passwd",
                             "/%2e%2e/%2e%2e/%2e%2e/etc/passwd",
                             "/..%2f..%2f..%2fetc/passwd",
                             "/%252e%252e/etc/passwd",
                             "/..\\..\\etc\\passwd",
                             "/..%5c..%5cetc%5cpasswd",
                             "/assets/....//....//etc/passwd",
                             "/assets/../../etc/passwd",
                             "/etc/passwd",
                             "//etc/passwd",
                             "/./etc/passwd",
                             "/%00/etc/passwd",
                             "/index.html%00.png",
                             "/%c0%ae%c0%ae/etc/passwd",
                             "/proc/self/environ",
                             "/shown.db",
                             "/../shown.db",
                             "/api/v1/../../shown.db",
                             "/api/v1/models/../../../etc/passwd",
                             "/api/v1/models/..%2f..%2fetc%2fpasswd",
                             "/api/v1/runs/..%2f1",
                             "file:///etc/passwd",
                             "http://127.0.0.1/etc/passwd",
                             "*",
                             "etc/passwd"}) {
    INFO(target);
    const auto answer =
        parse_answer(shown.raw(shown.server.request("GET", target, "", "Connection: close\r\n")));
    CHECK((answer.status == 400 || answer.status == 404));
    CHECK(answer.body.find("root:") == std::string::npos);
    CHECK(answer.body.find("SQLite format") == std::string::npos);
    CHECK(answer.headers.at("Content-Type") == "application/json");
  }
}

TEST_CASE("pages of other sites change nothing and read nothing", "[server]") {
  const Shown shown;
  const json description = shown.server.get("/api/v1/openapi.json").parsed();
  int changing = 0;
  for (const auto& [path, methods] : description["paths"].items())
    for (const auto& [name, what] : methods.items()) {
      if (name == "get") continue;
      ++changing;
      std::string target = "/api/v1" + path;
      for (const auto& [hole, value] : {std::pair{"{id}", "1"}, std::pair{"{key}", "K117.part_cost"}})
        if (const auto at = target.find(hole); at != std::string::npos)
          target.replace(at, std::string(hole).size(), value);
      std::string method = name;
      for (char& c : method) c = static_cast<char>(c - 'a' + 'A');
      INFO(method << " " << target);
      const std::string line =
          method + " " + target + " HTTP/1.1\r\nConnection: close\r\nContent-Length: 2\r\n";
      const std::string host = "Host: " + shown.server.host() + "\r\n";
      const auto status = [&](const std::string& headers) {
        return parse_answer(shown.raw(line + headers + "\r\n{}")).status;
      };
      // A form, a page of another site, one of another port, a sandboxed frame, a name that was bound again.
      CHECK(status(host + "Content-Type: text/plain\r\n") == 403);
      CHECK(status(host + "X-Verstat: 1\r\nOrigin: http://evil.example\r\n") == 403);
      CHECK(status(host + "X-Verstat: 1\r\nOrigin: http://127.0.0.1:1\r\n") == 403);
      CHECK(status(host + "X-Verstat: 1\r\nOrigin: null\r\n") == 403);
      CHECK(status(host + "X-Verstat: 1\r\nSec-Fetch-Site: cross-site\r\n") == 403);
      CHECK(status(host + "X-Verstat: 1\r\nSec-Fetch-Site: same-site\r\n") == 403);
      CHECK(status("Host: evil.example\r\nX-Verstat: 1\r\nOrigin: http://evil.example\r\n") == 403);
      CHECK(status("X-Verstat: 1\r\n") == 400);
    }
  CHECK(changing >= 8);
  // A browser asks beforehand whether it may: it may not.
  const auto preflight =
      parse_answer(shown.raw("OPTIONS /api/v1/jobs HTTP/1.1\r\nHost: " + shown.server.host() +
                             "\r\nConnection: close\r\nOrigin: http://evil.example\r\n"
                             "Access-Control-Request-Method: POST\r\n\r\n"));
  CHECK(preflight.status >= 400);
  for (const auto& [name, value] : preflight.headers) CHECK(name.find("Access-Control") == std::string::npos);
  for (const char* target : {"/", "/api/v1/runs", "/api/v1/health"}) {
    CHECK(parse_answer(shown.raw("GET " + std::string(target) +
                                 " HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"))
              .status == 403);
    CHECK(shown.server.get(target).headers.at("Cross-Origin-Resource-Policy") == "same-origin");
  }
  CHECK(shown.server.get("/api/v1/jobs").parsed()["total"] == 0);
  CHECK(shown.served() == shown.expected);
}

TEST_CASE("a token counts for its server alone, and only where it belongs", "[server]") {
  const Workspace w;
  const std::string db = w.file("closed.db");
  REQUIRE(ended(start(small_run + db)) == 0);
  const std::string first = "0123456789abcdef0123456789abcdef";
  const std::string second = "fedcba9876543210fedcba9876543210";
  const auto status = [](const Served& server, const std::string& headers,
                         const std::string& target = "/api/v1/runs") {
    return server.ask("GET", target, "", headers + "Connection: close\r\n").status;
  };
  std::string caught;  // a request that somebody has listened to
  {
    const Served server(db, "--token " + first, w.file("said"));
    REQUIRE(server.port() != 0);
    caught = server.request("GET", "/api/v1/runs", "",
                            "Authorization: Bearer " + first + "\r\nConnection: close\r\n");
    const Socket socket(server.port());
    socket.send(caught);
    CHECK(parse_answer(socket.read_all()).status == 200);
    CHECK(status(server, "") == 401);
    CHECK(status(server, "Authorization: Bearer " + second + "\r\n") == 401);
    CHECK(status(server, "Authorization: Basic " + first + "\r\n") == 401);
    CHECK(status(server, "Authorization: Bearer " + first.substr(0, 31) + "\r\n") == 401);
    CHECK(status(server, "Authorization: Bearer " + first + "0\r\n") == 401);
    // Not where a page of another site, a log or a history could have it from.
    CHECK(status(server, "Cookie: token=" + first + "\r\n") == 401);
    CHECK(status(server, "", "/api/v1/runs?token=" + first) == 401);
    CHECK(status(server, "X-Token: " + first + "\r\n") == 401);
    // Twice is not once.
    CHECK(status(server, "Authorization: Bearer " + first + "\r\nAuthorization: Bearer " + first + "\r\n") ==
          401);
    CHECK(status(server, "Authorization: Bearer x\r\nAuthorization: Bearer " + first + "\r\n") == 401);
  }
  const Served server(db, "--token " + second, w.file("said"));
  REQUIRE(server.port() != 0);
  // Played again to the next server, to whatever port it listens.
  const std::string host = "Host: 127.0.0.1:";
  const auto at = caught.find(host) + host.size();
  caught.replace(at, caught.find('\r', at) - at, std::to_string(server.port()));
  const Socket socket(server.port());
  socket.send(caught);
  CHECK(parse_answer(socket.read_all()).status == 401);
  CHECK(status(server, "Authorization: Bearer " + second + "\r\n") == 200);
}

TEST_CASE("a job without memory and a job that is killed end in words; the server and its data stay",
          "[server]") {
  const Workspace w;
  const std::string db = w.file("jobs.db");
  REQUIRE(ended(start(small_run + db)) == 0);
  fs::create_directories(w.file("tmp"));
  const auto over = [](const Served& server, int id) {
    for (int k = 0; k < 30'000; ++k) {
      const json status = server.get("/api/v1/jobs/" + std::to_string(id)).parsed();
      if (status["state"] != "queued" && status["state"] != "running") return status;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return json::object();
  };
  const json plant = json::parse(read_file("scenarios/gallery/mixed-plant.json"));
  const auto job = [&](int machines, int replications) {
    return json{{"kind", "run"},
                {"scenario", plant},
                {"changes",
                 {{{"pointer", "/machines/0/count"}, {"value", machines}},
                  {{"pointer", "/simulation/replications"}, {"value", replications}}}}}
        .dump();
  };
  {
    const Served server(db, "", w.file("said"), "ulimit -v 400000; export TMPDIR=" + w.file("tmp") + ";");
    REQUIRE(server.port() != 0);
    REQUIRE(server.ask("POST", "/api/v1/jobs", job(10'000, 40)).status == 202);
    const json ended_job = over(server, 1);
    INFO(ended_job.dump());
    CHECK(ended_job["state"] == "failed");
    CHECK_THAT(ended_job["message"].get<std::string>(), Catch::Contains("out of memory"));
    CHECK(server.get("/api/v1/health").parsed()["runs"] == 1);
  }
  const Served server(db, "", w.file("said"), "export TMPDIR=" + w.file("tmp") + ";");
  REQUIRE(server.ask("POST", "/api/v1/jobs", job(2, 5000)).status == 202);
  // As the system does when memory runs out.
  pid_t child = 0;
  for (int k = 0; k < 1000 && child == 0; ++k) {
    for (const auto& task : fs::directory_iterator("/proc/" + std::to_string(server.process()) + "/task")) {
      std::ifstream in(task.path() / "children");
      if (in >> child) break;
      child = 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  REQUIRE(child > 0);
  ::kill(child, SIGKILL);
  const json killed = over(server, 1);
  INFO(killed.dump());
  CHECK(killed["state"] == "failed");
  CHECK_THAT(killed["message"].get<std::string>(), Catch::Contains("killed from outside"));
  CHECK(server.get("/api/v1/health").parsed()["runs"] == 1);
  CHECK(state_of(db) == "ok");
  // The next one comes through.
  REQUIRE(server.ask("POST", "/api/v1/jobs", R"({"kind": "again", "run": 1})").status == 202);
  CHECK(over(server, 2)["result"]["identical"] == true);
  CHECK(std::distance(fs::directory_iterator(w.file("tmp")), fs::directory_iterator()) ==
        0);  // folders of jobs
}
