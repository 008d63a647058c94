// The wall clock is set by hours while programs work: forward, back, again and again. Only dates may show it.
// The clock of the system is left alone: a small library that the test builds stands between the program and
// the C library.
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/mman.h>

#include "tests/faults/served.h"

using nlohmann::json;
using namespace verstat::test;
namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

const char* const source = R"(
#include <dlfcn.h>
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>
static const volatile long* shift() {
  static const volatile long* at;
  static const long none[2];
  if (!at) {
    const char* name = getenv("VERSTAT_TEST_CLOCK");
    int file = name ? open(name, O_RDWR) : -1;
    void* memory = file < 0 ? MAP_FAILED : mmap(0, 16, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0) close(file);
    at = memory == MAP_FAILED ? none : (const volatile long*)memory;
  }
  return at;
}
int clock_gettime(clockid_t id, struct timespec* t) {
  int result = syscall(SYS_clock_gettime, id, t);
  if (id == CLOCK_REALTIME || id == CLOCK_REALTIME_COARSE) {
    const volatile long* s = shift();
    t->tv_sec += s[0];
    __sync_fetch_and_add((long*)&s[1], 1);
  }
  return result;
}
time_t time(time_t* out) {
  struct timespec t;
  clock_gettime(CLOCK_REALTIME, &t);
  if (out) *out = t.tv_sec;
  return t.tv_sec;
}
int gettimeofday(struct timeval* out, void* zone) {
  struct timespec t;
  (void)zone;
  clock_gettime(CLOCK_REALTIME, &t);
  out->tv_sec = t.tv_sec;
  out->tv_usec = t.tv_nsec / 1000;
  return 0;
}
)";

/// A wall clock that can be set, for programs started with `before()`.
class WallClock {
 public:
  explicit WallClock(const Workspace& w) : library_(w.file("clock.so")), file_(w.file("shift")) {
    std::ofstream(w.file("clock.c")) << source;
    std::ofstream(file_) << std::string(16, '\0');
    const char* const named = std::getenv("CC");
    const std::string compiler = named != nullptr ? named : "cc";
    built_ = std::system((compiler + " -shared -fPIC -O1 -w -o " + library_ + " " + w.file("clock.c") +
                          " 2>/dev/null")
                             .c_str()) == 0;
    const int file = ::open(file_.c_str(), O_RDWR);
    memory_ = static_cast<volatile long*>(::mmap(nullptr, 16, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0));
    ::close(file);
  }
  WallClock(const WallClock&) = delete;
  WallClock& operator=(const WallClock&) = delete;
  ~WallClock() { ::munmap(const_cast<long*>(memory_), 16); }

  [[nodiscard]] bool built() const { return built_; }
  [[nodiscard]] std::string before() const {
    return "export LD_PRELOAD=" + library_ + " VERSTAT_TEST_CLOCK=" + file_ + "; ";
  }
  void set_by_h(double hours) { memory_[0] = static_cast<long>(hours * 3600); }
  /// How often programs have looked at it.
  [[nodiscard]] long looks() const { return memory_[1]; }

 private:
  std::string library_;
  std::string file_;
  volatile long* memory_;
  bool built_ = false;
};

/// Sets the clock by up to five hours to and fro, twenty times a second, as long as it lives.
class Jumping {
 public:
  explicit Jumping(WallClock& clock)
      : thread_([this, &clock] {
          Moments moments(5);
          while (!over_) {
            clock.set_by_h(10 * moments.next() - 5);
            std::this_thread::sleep_for(50ms);
          }
          clock.set_by_h(0);
        }) {}
  Jumping(const Jumping&) = delete;
  Jumping& operator=(const Jumping&) = delete;
  ~Jumping() {
    over_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> over_{false};
  std::thread thread_;
};

json without_times(json run) {
  for (const char* name : {"id", "elapsed_s", "provenance"}) run.erase(name);
  return run;
}

std::string sweep_of(int points) {
  return "sweep scenarios/gallery/heavy-lathe.json --factor /tools/0/strategy/gamma=0.4..0.8 --design lhs "
         "--set /simulation/horizon_min=60000 --replications 4 --threads 1 --points " +
         std::to_string(points) + " ";
}
const std::string sweep = sweep_of(24) + "--json ";

const std::string optimum_of =
    "optimize scenarios/gallery/heavy-lathe.study.json --set /simulation/horizon_min=60000 --threads 1 "
    "--json --replications ";

}  // namespace

TEST_CASE("a wall clock that jumps by hours changes no result, no time limit and no lock", "[clock]") {
  const Workspace w;
  WallClock clock(w);
  if (!clock.built()) {
    WARN("not tested here: there is no C compiler (cc)");
    return;
  }
  const std::string db = w.file("a.db");
  const std::string quiet = w.file("quiet.db");
  const std::string run =
      "run scenarios/gallery/mixed-plant.json --set /simulation/horizon_min=30000 --replications 4 --json "
      "--db ";
  const json plain_run = json::parse(call(run + quiet).out);
  const json plain_study = json::parse(call(sweep + "--db " + quiet).out);
  const json plain_optimum = json::parse(call(optimum_of + "4 --db " + quiet).out);

  // The library does what it says.
  clock.set_by_h(24 * 400);
  const json dated = json::parse(call(run + w.file("dated.db"), clock.before()).out);
  const int now = std::stoi(plain_run["provenance"]["created"].get<std::string>().substr(0, 4));
  CHECK(std::stoi(dated["provenance"]["created"].get<std::string>().substr(0, 4)) > now);
  CHECK(without_times(dated) == without_times(plain_run));
  CHECK(clock.looks() > 0);

  const Jumping jumping(clock);
  // A run: the same bits, and a time that was measured by another clock.
  const json jumped = json::parse(call(run + db, clock.before()).out);
  CHECK(without_times(jumped) == without_times(plain_run));
  CHECK(jumped["elapsed_s"] >= 0);
  CHECK(jumped["elapsed_s"] < 60);
  // Studies: the same answers, and a limit of an hour does not pass with the clock.
  const Answer study = call(sweep + "--db " + db, clock.before());
  INFO(study.err);
  REQUIRE(study.exit_code == 0);
  CHECK(json::parse(study.out) == plain_study);
  const Answer optimum = call(optimum_of + "4 --time 3600 --db " + db, clock.before());
  INFO(optimum.err);
  REQUIRE(optimum.exit_code == 0);
  CHECK(json::parse(optimum.out) == plain_optimum);
  // A limit of a second ends after about a second, though the clock goes back by hours.
  const auto begin = std::chrono::steady_clock::now();
  const Answer limited = call(optimum_of + "50000 --time 1 --db " + db, clock.before() + "timeout 60");
  INFO(limited.err);
  CHECK(limited.exit_code == 0);
  CHECK_THAT(limited.out, Catch::Contains("the time budget of 1 s is used up"));
  CHECK(std::chrono::steady_clock::now() - begin < 30s);
  CHECK(state_of(db) == "ok");
}

TEST_CASE("a server and the study beside it live through a clock that jumps by hours", "[clock]") {
  const Workspace w;
  WallClock clock(w);
  if (!clock.built()) {
    WARN("not tested here: there is no C compiler (cc)");
    return;
  }
  const std::string db = w.file("a.db");
  REQUIRE(call(sweep + "--db " + db).exit_code == 0);
  fs::create_directories(w.file("tmp"));
  const Served server(db, "", w.file("said"), clock.before() + "export TMPDIR=" + w.file("tmp") + ";");
  REQUIRE(server.port() != 0);
  const Jumping jumping(clock);
  const pid_t study = start(sweep_of(50000) + "--db " + db, clock.before());
  for (int k = 0; k < 2000 && server.get("/api/v1/studies/2").status != 200; ++k)
    std::this_thread::sleep_for(5ms);
  // A connection that stays open, for some seconds of ours and weeks of the wall clock.
  const verstat::web_test::Socket open(server.port());
  const std::string run =
      "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=12000 --replications 4 --db ";
  REQUIRE(call(run + db, clock.before()).exit_code == 0);  // takes its turn beside the study
  const std::int64_t first_run = 1;
  for (int k = 0; k < 40; ++k) {
    open.send(server.request("GET", "/api/v1/studies/2?trials=0"));
    const auto answer = verstat::web_test::parse_answer(open.read_answer());
    REQUIRE(answer.status == 200);
    CHECK(answer.parsed()["status"] == "running");
    std::this_thread::sleep_for(50ms);
  }
  const auto job = server.ask("POST", "/api/v1/jobs", json{{"kind", "again"}, {"run", first_run}}.dump());
  INFO(job.body);
  REQUIRE(job.status == 202);
  json status;
  for (int k = 0; k < 4000; ++k) {
    status = server.get("/api/v1/jobs/1").parsed();
    if (status["state"] != "queued" && status["state"] != "running") break;
    std::this_thread::sleep_for(5ms);
  }
  CHECK(status["result"]["identical"] == true);
  CHECK(status["elapsed_s"] >= 0);
  CHECK(status["elapsed_s"] < 60);
  // Whoever lives holds its study, whatever the clock says; whoever was killed does not.
  CHECK(call("sweep --resume 2 --db " + db, clock.before()).exit_code == 1);
  ::kill(study, SIGKILL);
  CHECK(ended(study) == 128 + SIGKILL);
  CHECK(server.get("/api/v1/studies/2?trials=0").parsed()["status"] == "interrupted");
  CHECK(state_of(db) == "ok");
}
