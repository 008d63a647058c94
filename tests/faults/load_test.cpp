// Many readers while a study runs on the same database: every answer is looked at, the server grows neither
// in memory nor in descriptors, the trials are those of a study that was left alone, and the study hardly
// slows down.
//   VERSTAT_LOAD_S=600 VERSTAT_LOAD_RATE=50 test_faults "[load]"
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <numeric>
#include <set>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/faults/served.h"

using nlohmann::json;
using namespace verstat::test;
using verstat::web_test::parse_answer;
using verstat::web_test::Socket;
using HttpAnswer = verstat::web_test::Answer;
using Clock = std::chrono::steady_clock;
namespace fs = std::filesystem;

namespace {

double setting(const char* name, double otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::stod(text);
}

const std::string lathe = "scenarios/gallery/heavy-lathe.json";
// More points than any load lasts; each of some hundredths of a second.
const std::string endless_sweep =
    "sweep " + lathe +
    " --factor /tools/0/strategy/gamma=0.4..0.8 --factor /inserts/0/price=50..100"
    " --design sobol --points 65536 --set /simulation/horizon_min=100000"
    " --replications 4 --threads 1 --db ";

struct Question {
  std::string method;
  std::string target;
  std::string body;
  int status = 200;
};

/// What cannot change while finished results stay what they are, with the answers it got before the load.
struct Fixed {
  Question question;
  std::string body;
};

/// Everything that went wrong, in words, from any thread.
class Complaints {
 public:
  void add(const std::string& text) {
    const std::scoped_lock lock(mutex_);
    if (texts_.size() < 20) texts_.push_back(text);
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const std::string& one : texts_) all += one + "\n";
    return all;
  }

 private:
  std::mutex mutex_;
  std::vector<std::string> texts_;
  std::size_t count_ = 0;
};

/// Targets of the description with an example in place of every parameter, and the files of the pages.
std::vector<Question> every_reading_question(const Served& server) {
  std::vector<Question> all;
  const json description = server.get("/api/v1/openapi.json").parsed();
  for (const auto& [path, methods] : description["paths"].items()) {
    if (!methods.contains("get") || path.starts_with("/jobs")) continue;
    std::string target = "/api/v1" + path;
    for (const auto& [name, value] : {std::pair{"{id}", "1"}, std::pair{"{key}", "K117.part_cost"}})
      if (const auto at = target.find(name); at != std::string::npos)
        target.replace(at, std::string(name).size(), value);
    all.push_back({"GET", target, "", 200});
  }
  for (const char* target :
       {"/api/v1/runs/1?replications=1", "/api/v1/runs/1?warnings=1&notes=1", "/api/v1/runs/2",
        "/api/v1/runs/1?format=csv&separator=semicolon&decimal=comma", "/api/v1/studies/1?format=csv",
        "/api/v1/studies/1?trials=0", "/api/v1/studies/1/trials?sort=objective&limit=20",
        "/api/v1/studies/1/trials?sample=20&best=low", "/api/v1/models?search=weibull", "/"})
    all.push_back({"GET", target, "", 200});
  const std::string page = server.get("/").body;
  for (const char* mark : {"src=\"", "href=\""})
    for (auto at = page.find(mark); at != std::string::npos; at = page.find(mark, at + 1)) {
      const auto begin = at + std::string(mark).size();
      std::string target = page.substr(begin, page.find('"', begin) - begin);
      if (target.starts_with("./")) target = target.substr(1);
      if (target.starts_with("/") && !target.starts_with("//")) all.push_back({"GET", target, "", 200});
    }
  const json scenario = json::parse(read_file(lathe));
  all.push_back({"POST", "/api/v1/models/K117.weibull_from_moments/eval",
                 R"({"inputs": {"mean_min": 60, "cv": 0.7}})", 200});
  all.push_back(
      {"POST", "/api/v1/models/K117.weibull_from_moments/map",
       R"({"inputs": {"mean_min": 60}, "output": "shape", "x": {"name": "cv", "values": [0.5, 0.6, 0.7]}})",
       200});
  all.push_back({"POST", "/api/v1/check", json{{"scenario", scenario}}.dump(), 200});
  all.push_back({"POST", "/api/v1/plan",
                 json{{"scenario", scenario.dump()}, {"operation", "rough turning"}}.dump(), 200});
  // What is refused is refused in the same words.
  all.push_back({"GET", "/api/v1/runs/999999", "", 404});
  all.push_back({"GET", "/api/v1/runs?limit=0", "", 400});
  all.push_back({"GET", "/../etc/passwd", "", 400});
  all.push_back({"POST", "/api/v1/check", "{", 400});
  return all;
}

bool may_change(const Question& q) {
  for (const char* target : {"/api/v1/runs", "/api/v1/studies", "/api/v1/tags", "/api/v1/health"})
    if (q.target == target) return true;
  return false;
}

/// A keep-alive connection that is opened again when the server has closed it.
class Connection {
 public:
  explicit Connection(const Served& server) : server_(server) {}
  HttpAnswer ask(const Question& q) {
    if (++asked_ % 50 == 0) socket_.reset();  // a new one now and then
    for (int tries = 0; tries < 2; ++tries) {
      if (!socket_) socket_.emplace(server_.port());
      HttpAnswer answer;
      if (socket_->send(server_.request(q.method, q.target, q.body)))
        answer = parse_answer(socket_->read_answer());
      if (answer.status != 0) return answer;
      socket_.reset();
    }
    return {};
  }

  [[nodiscard]] const Served& server() const { return server_; }

 private:
  const Served& server_;
  std::optional<Socket> socket_;
  std::size_t asked_ = 0;
};

/// Asks the questions whose answers move, and holds them against what was seen before.
class Moving {
 public:
  Moving(Complaints& complaints, const Served& server) : complaints_(complaints), connection_(server) {}

  /// The next of them; how many requests it took.
  int look() {
    switch (turn_++ % 6) {
      case 0:
        return runs();
      case 1:
        return studies();
      case 2:
        return trials();
      case 3:
        return job();
      case 4:
        return notes();
      default:
        return health();
    }
  }
  [[nodiscard]] const json& trial_rows() const { return trials_; }
  [[nodiscard]] int repeated() const { return repeated_; }

 private:
  json asked(const Question& q) {
    const HttpAnswer answer = connection_.ask(q);
    if (answer.status != q.status) {
      complaints_.add(q.method + " " + q.target + ": " + std::to_string(answer.status) + " " +
                      answer.body.substr(0, 300));
      return json::object();
    }
    json parsed = json::parse(answer.body, nullptr, false);
    if (parsed.is_discarded()) complaints_.add(q.target + ": no JSON");
    return parsed.is_discarded() ? json::object() : parsed;
  }
  void grows(const char* what, std::int64_t& before, const json& now) {
    if (!now.is_number_integer() || now.get<std::int64_t>() < before)
      complaints_.add(std::string(what) + " was " + std::to_string(before) + ", is " + now.dump());
    else
      before = now.get<std::int64_t>();
  }

  int runs() {
    const json page = asked({"GET", "/api/v1/runs?limit=200&kpis=cost_per_part", "", 200});
    grows("the number of runs", runs_, page.value("total", json()));
    std::int64_t before = INT64_MAX;
    for (const json& run : page.value("runs", json::array())) {
      const auto id = run["id"].get<std::int64_t>();
      if (id >= before) complaints_.add("runs are not newest first");
      before = id;
      // A run is whole from the moment it is seen, and stays what it is.
      json kept = run;
      kept.erase("note");
      kept.erase("tags");
      if (kept["kpis"].empty() || kept["fingerprint"].is_null())
        complaints_.add("run " + run["id"].dump() + " is not whole");
      const auto [at, fresh] = seen_.emplace(id, kept);
      if (!fresh && at->second != kept) complaints_.add("run " + run["id"].dump() + " has changed");
    }
    return 1;
  }
  int studies() {
    const json page = asked({"GET", "/api/v1/studies", "", 200});
    for (const json& study : page.value("studies", json::array())) {
      if (study["id"] == 1 && study["status"] != "finished")
        complaints_.add("study 1 is " + study["status"].dump());
      if (study["id"] == 2 && study["status"] != "running")
        complaints_.add("study 2 is " + study["status"].dump());
      if (study["id"] == 2) grows("the number of trials", listed_, study["trials"]);
    }
    return 1;
  }
  /// The trials of the study under way, from the last seen on, as its page asks for them.
  int trials() {
    const auto after = std::max<std::int64_t>(0, static_cast<std::int64_t>(trials_.size()) - 5);
    const json page =
        asked({"GET", "/api/v1/studies/2/trials?limit=2000&after=" + std::to_string(after), "", 200});
    for (const json& trial : page.value("trials", json::array())) {
      const auto at = trial["number"].get<std::size_t>() - 1;
      if (at < trials_.size()) {
        if (trials_[at] != trial) complaints_.add("trial " + trial["number"].dump() + " has changed");
      } else if (at == trials_.size()) {
        trials_.push_back(trial);
      } else {
        complaints_.add("trial " + trial["number"].dump() + " came before its turn");
      }
    }
    return 1;
  }
  /// Now and then a run is made again by the server itself: a second writer beside the study.
  int job() {
    const auto now = Clock::now();
    if (job_ == 0 && now - last_job_ > std::chrono::seconds(5)) {
      last_job_ = now;
      const bool trace = ++jobs_ % 2 == 0;
      const json started =
          asked({"POST", "/api/v1/jobs", json{{"kind", trace ? "trace" : "again"}, {"run", 2}}.dump(), 202});
      job_ = started.value("id", std::int64_t{0});
      return 1;
    }
    if (job_ == 0) {
      if (!asked({"GET", "/api/v1/jobs", "", 200}).contains("jobs")) complaints_.add("no list of jobs");
      return 1;
    }
    const json status = asked({"GET", "/api/v1/jobs/" + std::to_string(job_), "", 200});
    const std::string state = status.value("state", "");
    if (state != "finished" && state != "running" && state != "queued")
      complaints_.add("job " + std::to_string(job_) + ": " + status.dump());
    if (state == "running" || state == "queued") return 1;
    const json result = status.value("result", json::object());
    if (state == "finished" && status["kind"] == "again") {
      ++repeated_;
      if (result.value("identical", false) != true)
        complaints_.add("run 2 came out otherwise: " + result.dump());
    }
    int more = 0;
    if (state == "finished" && status["kind"] == "trace") {
      ++more;
      const HttpAnswer output =
          connection_.ask({"GET", "/api/v1/jobs/" + std::to_string(job_) + "/output", "", 200});
      if (output.body.size() != result.value("bytes", std::size_t{0})) complaints_.add("a trace is cut off");
    }
    // Its events end with the last status.
    const HttpAnswer stream = connection_.server().get("/api/v1/jobs/" + std::to_string(job_) + "/events");
    if (stream.status != 200 || stream.body.find("event: job") == std::string::npos)
      complaints_.add("no events of a job: " + std::to_string(stream.status));
    job_ = 0;
    return 2 + more;
  }
  int notes() {
    const std::string text = "note " + std::to_string(turn_);
    const json put =
        asked({"PUT", "/api/v1/studies/1/notes", json{{"note", text}, {"tags", {"load"}}}.dump(), 200});
    if (put.value("note", "") != text) complaints_.add("a note came back as " + put.dump());
    const json tags = asked({"GET", "/api/v1/tags", "", 200});
    if (tags.dump().find("load") == std::string::npos) complaints_.add("a tag is lost");
    return 2;
  }
  int health() {
    const json now = asked({"GET", "/api/v1/health", "", 200});
    if (now.value("status", "") != "ok") complaints_.add("health: " + now.dump());
    grows("the number of runs", runs_, now.value("runs", json()));
    return 1;
  }

  Complaints& complaints_;
  Connection connection_;
  int turn_ = 0;
  std::int64_t runs_ = 0;
  std::int64_t listed_ = 0;
  std::map<std::int64_t, json> seen_;
  json trials_ = json::array();
  std::int64_t job_ = 0;
  int jobs_ = 0;
  int repeated_ = 0;
  Clock::time_point last_job_{};
};

/// How far the study is: trials stored, its processor time, how long others had the processor that it wanted,
/// the clock.
struct Mark {
  std::int64_t trials = 0;
  double processor = 0;
  double queued = 0;
  Clock::time_point clock;
};

struct Speed {
  std::int64_t trials = 0;
  double processor = 0;
  double queued = 0;
  double clock = 0;
  void add(const Mark& from, const Mark& to) {
    trials += to.trials - from.trials;
    processor += to.processor - from.processor;
    queued += to.queued - from.queued;
    clock += std::chrono::duration<double>(to.clock - from.clock).count();
  }
  [[nodiscard]] double per_processor_s() const { return static_cast<double>(trials) / processor; }
  /// Computing and waiting for locks and the disk, as if a processor had been free whenever it was wanted.
  [[nodiscard]] double per_own_s() const { return static_cast<double>(trials) / (clock - queued); }
  [[nodiscard]] double per_clock_s() const { return static_cast<double>(trials) / clock; }
};

json trials_of(const std::string& db, std::int64_t study) {
  json list =
      json::parse(call("runs --json --study " + std::to_string(study) + " --db " + db).out)["trial_list"];
  for (json& trial : list) trial.erase("first_replication");
  return list;
}

}  // namespace

TEST_CASE("a study under the load of many readers: every answer right, no leak, hardly slower", "[load]") {
  const double load_s = setting("VERSTAT_LOAD_S", 8);
  const double rate_per_s = setting("VERSTAT_LOAD_RATE", 50);
  constexpr int readers = 4;
  const Workspace w;
  const std::string db = w.file("loaded.db");
  REQUIRE(ended(start("run " + lathe + " --replications 10 --db " + db)) == 0);
  REQUIRE(ended(start("run " + lathe + " --set /simulation/horizon_min=12000 --replications 4 --db " + db)) ==
          0);
  REQUIRE(ended(start("sweep " + lathe +
                      " --factor /tools/0/strategy/gamma=0.4..0.8 --design lhs --points 40"
                      " --set /simulation/horizon_min=12000 --replications 2 --db " +
                      db)) == 0);
  Served server(db, "", w.file("said"));
  REQUIRE(server.port() != 0);

  std::vector<Fixed> fixed;
  std::set<std::string> kinds;
  for (const Question& q : every_reading_question(server)) {
    const HttpAnswer answer = server.ask(q.method, q.target, q.body);
    INFO(q.method << " " << q.target << ": " << answer.body.substr(0, 300));
    REQUIRE(answer.status == q.status);
    if (answer.headers.at("Content-Type") == "application/json") REQUIRE(json::accept(answer.body));
    kinds.insert(q.method + " " + q.target);
    if (!may_change(q)) fixed.push_back({q, answer.body});
  }
  REQUIRE(fixed.size() > 25);

  const pid_t study = start(endless_sweep + db);
  for (int k = 0; k < 2000 && server.get("/api/v1/studies/2").status != 200; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  REQUIRE(server.get("/api/v1/studies/2").status == 200);

  Complaints complaints;
  std::atomic<bool> loading{false};
  std::atomic<bool> over{false};
  std::atomic<std::int64_t> requests{0};
  std::atomic<std::int64_t> late{0};
  Moving moving(complaints, server);
  std::vector<std::thread> threads;
  for (int reader = 0; reader < readers; ++reader)
    threads.emplace_back([&, reader] {
      Connection connection(server);
      Moments moments(static_cast<std::uint64_t>(reader) + 1);
      const auto step =
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(readers / rate_per_s));
      auto next = Clock::now();
      while (!over) {
        if (!loading) {
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
          next = Clock::now();
          continue;
        }
        if (reader == 0) {
          const int asked = moving.look();
          requests += asked;
          next += step * asked;
        } else {
          const Fixed& one =
              fixed[static_cast<std::size_t>(moments.next() * static_cast<double>(fixed.size()))];
          const HttpAnswer answer = connection.ask(one.question);
          if (answer.status != one.question.status || answer.body != one.body)
            complaints.add(one.question.method + " " + one.question.target + ": " +
                           std::to_string(answer.status) + ", " + std::to_string(answer.body.size()) +
                           " bytes for " + std::to_string(one.body.size()) + ": " +
                           answer.body.substr(0, 200));
          ++requests;
          next += step;
        }
        const auto now = Clock::now();
        if (next < now) {  // it took longer than its share: no burst to catch up
          ++late;
          next = now;
        }
        std::this_thread::sleep_until(next);
      }
    });

  SQLite::Database direct(db, SQLite::OPEN_READONLY, 10'000);
  const auto mark = [&] {
    Mark m;
    m.clock = Clock::now();
    m.processor = processor_s(study);
    m.queued = queued_s(study);
    m.trials = direct.execAndGet("SELECT count(*) FROM trial WHERE study_id = 2").getInt64();
    return m;
  };
  // Slices under load and alone in turn, 101 101 ...: whatever else the machine does hits both.
  const int rounds = std::max(1, static_cast<int>(load_s / 40));
  const auto slice = std::chrono::duration<double>(load_s / (2.0 * rounds));
  Speed loaded;
  Speed alone;
  std::vector<long> memory_kb;
  const double server_before = processor_s(server.process());
  Mark last = mark();
  for (int s = 0; s < 3 * rounds; ++s) {
    const bool on = s % 3 != 1;
    loading = on;
    std::this_thread::sleep_for(slice);
    const Mark now = mark();
    (on ? loaded : alone).add(last, now);
    last = now;
    if (on) memory_kb.push_back(status_of(server.process(), "VmRSS"));
  }
  const double server_s = processor_s(server.process()) - server_before;
  over = true;
  for (std::thread& thread : threads) thread.join();

  INFO(complaints.text());
  CHECK(complaints.count() == 0);
  CHECK(requests > 100);
  CHECK(moving.repeated() > 0);

  // Everybody has gone: the connections are closed, and what the server keeps has not grown with the
  // requests.
  std::size_t descriptors = 0;
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  descriptors = descriptors_of(server.process());
  CHECK(descriptors < 25 + readers);
  const long early = memory_kb[memory_kb.size() / 4];
  CHECK(memory_kb.back() < early + 30'000);

  const double by_processor = loaded.per_processor_s() / alone.per_processor_s();
  const double by_clock = loaded.per_clock_s() / alone.per_clock_s();
  const double by_own = loaded.per_own_s() / alone.per_own_s();
  WARN("load: " << kinds.size() << " kinds of requests, " << requests << " requests in " << loaded.clock
                << " s (" << static_cast<double>(requests) / loaded.clock << " per s, " << late << " late), "
                << complaints.count() << " complaints; run 2 repeated " << moving.repeated()
                << " times; server " << server_s / loaded.clock << " processors, memory " << early
                << " kB early, " << memory_kb[memory_kb.size() / 2] << " kB in the middle, "
                << memory_kb.back() << " kB at the end, " << descriptors << " descriptors; trials under load "
                << loaded.trials << " in " << loaded.clock << " s (" << loaded.processor
                << " s of processor), alone " << alone.trials << " in " << alone.clock << " s ("
                << alone.processor << "); speed " << by_processor << " per processor second, " << by_own
                << " per second of computing, locks and disk, " << by_clock << " by the clock");
  CHECK(loaded.trials > 20);
  // What the readers take by locks and by the disk shows in waiting; what they take of the caches in
  // processor time.
  // In seconds the processor's own pace scatters by more than the promise is about.
  CHECK(by_processor > (load_s >= 300 ? 0.9 : 0.75));

  ::kill(study, SIGINT);
  CHECK(ended(study) == 130);
  CHECK(server.end(SIGINT) == 0);
  CHECK(state_of(db) == "ok");
  CHECK(call("runs --verify 1 --db " + db).exit_code == 0);
  CHECK(call("runs --verify 2 --db " + db).exit_code == 0);

  // The same study without any reader.
  const std::size_t compared = std::min<std::size_t>(moving.trial_rows().size(), 100);
  REQUIRE(compared > 10);
  const std::string quiet = w.file("quiet.db");
  const pid_t other = start(endless_sweep + quiet);
  for (int k = 0; k < 6000; ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!fs::exists(quiet)) continue;
    SQLite::Database file(quiet, SQLite::OPEN_READWRITE, 10'000);
    if (file.execAndGet("SELECT count(*) FROM sqlite_master WHERE name = 'trial_once'").getInt() == 1 &&
        file.execAndGet("SELECT count(*) FROM trial").getInt64() > static_cast<std::int64_t>(compared))
      break;
  }
  ::kill(other, SIGINT);
  CHECK(ended(other) == 130);
  const json expected = trials_of(quiet, 1);
  REQUIRE(expected.size() >= compared);
  for (std::size_t k = 0; k < compared; ++k) CHECK(moving.trial_rows()[k] == expected[k]);
}
