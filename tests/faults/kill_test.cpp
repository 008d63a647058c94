// kill -9 at random moments, each while the victim is at work: what was committed is there, whole, and comes
// out the same when computed again. VERSTAT_KILLS=50 VERSTAT_KILL_SEED=7 test_faults "[kill]" does more of it
// than a test needs.
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <sys/prctl.h>

#include "tests/faults/served.h"

using nlohmann::json;
using namespace verstat::test;
using verstat::web_test::parse_answer;
using verstat::web_test::Socket;
namespace fs = std::filesystem;

namespace {

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
  const char* const text = std::getenv(name);
  return text == nullptr ? otherwise : std::stoull(text);
}

// Many small replications: a good part of the time goes into the transaction.
const std::string run_of_500 =
    "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=12000 --replications 500 --threads "
    "1";

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Seconds of processor of a child that has not been waited for, to the nanosecond.
double worked_s(pid_t child) {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(child, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool has_ended(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == child;
}

/// Waits until `sign` is given or the child has ended; false in the latter case.
template <class Sign>
bool wait_for(pid_t child, const Sign& sign) {
  while (!sign()) {
    if (has_ended(child)) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  return true;
}

/// Kills a child; true when it was still at work.
bool killed(pid_t child) {
  ::kill(child, SIGKILL);
  return ended(child) == 128 + SIGKILL;
}

/// Kills `arguments` after `work_s` of its own processor time: however busy the machine is, it is at work
/// then. True when it was; the time of an undisturbed run scatters a little, so that the last moments may
/// come too late.
bool kill_at_work(const std::string& arguments, double work_s) {
  const pid_t child = start(arguments);
  wait_for(child, [&] { return worked_s(child) >= work_s; });
  return killed(child);
}

/// Seconds of processor of `arguments` left alone.
double work_of(const std::string& arguments) {
  const pid_t child = start(arguments);
  siginfo_t info{};
  while (::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) != 0) {
  }
  const double work_s = worked_s(child);
  REQUIRE(ended(child) == 0);
  return work_s;
}

/// Whether somebody holds the database to write: whoever does has locked the file beside it.
bool writes(const std::string& db) {
  const int lock = ::open((db + ".lock").c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return false;
  const bool taken = ::flock(lock, LOCK_SH | LOCK_NB) != 0;
  ::close(lock);
  return taken;
}

json all_values(const std::string& db, std::int64_t run) {
  return json::parse(
      call("runs --json --all-replications --run " + std::to_string(run) + " --db " + db).out)["kpis"];
}

std::int64_t runs_in(const std::string& db) {
  SQLite::Database file(db, SQLite::OPEN_READWRITE, 60'000);
  if (file.execAndGet("SELECT count(*) FROM sqlite_master WHERE name = 'run'").getInt() == 0) return 0;
  return file.execAndGet("SELECT count(*) FROM run").getInt64();
}

}  // namespace

TEST_CASE("runs killed while they compute and while they commit: stored whole or not at all", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 10);
  Moments moments(setting("VERSTAT_KILL_SEED", 1));
  const std::string db = w.file("killed.db");
  const double whole_s = work_of(run_of_500 + " --db " + w.file("whole.db"));
  REQUIRE(whole_s > 0.01);
  const json expected = all_values(w.file("whole.db"), 1);
  REQUIRE(expected[0]["values"].size() == 500);
  // How long storing takes by the clock, from the moment on at which it locks out others.
  double commit_s = 0;
  {
    const pid_t child = start(run_of_500 + " --db " + db);
    wait_for(child, [&] { return writes(db); });
    const auto begin = Clock::now();
    REQUIRE(ended(child) == 0);
    commit_s = seconds_since(begin);
  }
  std::int64_t kept = 1;
  std::uint64_t hit = 0;
  std::uint64_t committing = 0;
  std::uint64_t started = 0;
  while (hit < kills && started < 5 * kills) {
    INFO("start " << started);
    bool at_work = false;
    const bool in_commit = started++ % 2 == 1;
    const double moment = moments.next();
    if (in_commit) {
      // Storing is short: every second kill waits for its beginning.
      const pid_t child = start(run_of_500 + " --db " + db);
      if (wait_for(child, [&] { return writes(db); })) {
        const auto begin = Clock::now();
        wait_for(child, [&] { return seconds_since(begin) >= moment * commit_s; });
      }
      at_work = killed(child);
      committing += at_work ? 1 : 0;
    } else {
      at_work = kill_at_work(run_of_500 + " --db " + db, moment * whole_s);
    }
    hit += at_work ? 1 : 0;
    REQUIRE(state_of(db) == "ok");
    const std::int64_t runs = runs_in(db);
    // Who ended by himself has committed; who was killed has committed all of it or nothing.
    REQUIRE(runs >= kept + (at_work ? 0 : 1));
    REQUIRE(runs <= kept + 1);
    if (runs > kept) REQUIRE(all_values(db, runs) == expected);
    kept = runs;
  }
  REQUIRE(hit == kills);
  REQUIRE(ended(start(run_of_500 + " --db " + db)) == 0);
  CHECK(runs_in(db) == kept + 1);
  for (std::int64_t run = 1; run <= kept + 1; run += 1 + kept / 10) CHECK(all_values(db, run) == expected);
  // Rows taken at random come out again, bit for bit, from what is stored with them.
  for (int k = 0; k < 3; ++k) {
    const auto run = 1 + static_cast<std::int64_t>(moments.next() * static_cast<double>(kept + 1));
    CHECK(call("runs --verify " + std::to_string(run) + " --db " + db).exit_code == 0);
  }
  WARN("runs: " << hit << " killed at work, " << committing << " of them while they stored; " << started
                << " started, " << kept + 1 << " stored");
}

TEST_CASE("a migration killed at random moments: the old file or the new one, and a backup", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 10);
  Moments moments(setting("VERSTAT_KILL_SEED", 1) + 1);
  std::ifstream in("tests/store/schema1.sql");
  std::ostringstream old;
  old << in.rdbuf();
  constexpr int trials = 60'004;  // a migration takes some tenths of a second
  const std::string before = w.file("before.db");
  {
    SQLite::Database db(before, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    db.exec(old.str());
    db.exec(
        "WITH RECURSIVE n(k) AS (SELECT 5 UNION ALL SELECT k + 1 FROM n WHERE k < 60004) INSERT INTO trial "
        "SELECT 1, k, 'analytic', randomblob(16), k, 1 FROM n");
  }
  const std::string quick =
      "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=11000 --replications 2 --threads "
      "1 --db ";
  const int first_new_run = 3;  // the sample holds only a few values of its two runs
  const std::string db = w.file("old.db");
  const std::string backup = db + ".schema1.bak";
  double migration_s = 0;
  std::uint64_t hit = 0;
  std::uint64_t started = 0;
  std::map<std::int64_t, int> found;
  while (hit < kills && started < 5 * kills + 5) {
    INFO("start " << started);
    for (const char* more :
         {"", "-wal", "-shm", ".lock", ".schema1.bak", ".schema1.bak-journal", ".schema2.bak"})
      fs::remove(db + more);
    fs::copy_file(before, db);
    const pid_t child = start(quick + db);
    // The first thing to be seen of a migration is the copy.
    wait_for(child, [&] { return fs::exists(backup); });
    const auto begin = Clock::now();
    bool at_work = false;
    if (started++ == 0) {
      REQUIRE(ended(child) == 0);
      migration_s = seconds_since(begin);
    } else {
      const double moment = moments.next();
      wait_for(child, [&] { return seconds_since(begin) >= moment * migration_s; });
      at_work = killed(child);
    }
    REQUIRE(state_of(db, first_new_run) == "ok");
    const std::int64_t version = SQLite::Database(db).execAndGet("PRAGMA user_version").getInt64();
    CHECK((version >= 1 && version <= 3));
    if (version > 1) CHECK(fs::exists(backup));
    // At work at the migration, not at what comes after it.
    const bool migrating = at_work && runs_in(db) == 2;
    hit += migrating ? 1 : 0;
    if (migrating) ++found[version];
    REQUIRE(ended(start(quick + db)) == 0);  // whatever there was, it goes on
    REQUIRE(state_of(db, first_new_run) == "ok");
    REQUIRE(fs::exists(backup));
    CHECK(SQLite::Database(backup).execAndGet("PRAGMA user_version").getInt() == 1);
    CHECK(SQLite::Database(backup).execAndGet("PRAGMA integrity_check").getString() == "ok");
    CHECK(SQLite::Database(backup).execAndGet("SELECT count(*) FROM trial").getInt() == trials);
    CHECK(SQLite::Database(db).execAndGet("PRAGMA user_version").getInt() == 3);
    SQLite::Database both(db);
    both.exec("ATTACH '" + backup + "' AS old");
    CHECK(both.execAndGet(
                  "SELECT count(*) FROM (SELECT number, stage, variables, objective FROM main.trial EXCEPT "
                  "SELECT number, stage, variables, objective FROM old.trial)")
              .getInt() == 0);
    CHECK(both.execAndGet("SELECT count(*) FROM main.trial").getInt() == trials);
    if (started % 10 == 1) CHECK(call("runs --study 1 --json --db " + db).exit_code == 0);
  }
  REQUIRE(hit == kills);
  std::string versions;
  for (const auto& [version, times] : found)
    versions += ", schema " + std::to_string(version) + " found " + std::to_string(times) + " times";
  WARN("migrations: " << hit << " killed at work of " << started - 1 << " started" << versions);
}

TEST_CASE("a study killed at random moments goes on to the trials of one that was not", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 5);
  Moments moments(setting("VERSTAT_KILL_SEED", 1) + 2);
  const std::string sweep =
      "sweep scenarios/gallery/heavy-lathe.json --factor /tools/0/strategy/gamma=0.4..0.8 --factor "
      "/inserts/0/price=50..100 --design sobol --points 32 --set /simulation/horizon_min=60000 "
      "--replications 4 "
      "--json --db ";
  const double whole_s = work_of(sweep + w.file("whole.db"));
  const json expected = json::parse(call("sweep --resume 1 --json --db " + w.file("whole.db")).out);
  std::uint64_t hit = 0;
  std::uint64_t studies = 0;
  while (hit < kills && studies < 4 * kills) {
    const std::string db = w.file("killed" + std::to_string(studies++) + ".db");
    std::int64_t trials = 0;
    for (int k = 0; k < 8 && hit < kills; ++k) {
      const bool begun = fs::exists(db) && call("runs --study 1 --db " + db).exit_code == 0;
      const bool was_running =
          kill_at_work(begun ? "sweep --resume 1 --db " + db : sweep + db, 0.55 * whole_s * moments.next());
      hit += was_running ? 1 : 0;
      if (!fs::exists(db)) continue;
      REQUIRE(state_of(db) == "ok");
      if (call("runs --study 1 --db " + db).exit_code != 0) continue;
      const std::int64_t now =
          SQLite::Database(db).execAndGet("SELECT count(*) FROM trial WHERE study_id = 1").getInt64();
      REQUIRE(now >= trials);
      trials = now;
      if (!was_running) break;
    }
    const bool begun = fs::exists(db) && call("runs --study 1 --db " + db).exit_code == 0;
    if (!begun) continue;
    const Answer rest = call("sweep --resume 1 --json --db " + db);
    REQUIRE(rest.exit_code == 0);
    CHECK(json::parse(rest.out) == expected);
  }
  CHECK(hit >= kills);
  WARN("studies: " << hit << " kills in " << studies << " studies");
}

TEST_CASE("a server killed while it computes a page, writes a note, or has a run made", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 8);
  Moments moments(setting("VERSTAT_KILL_SEED", 1) + 3);
  const std::string db = w.file("served.db");
  REQUIRE(ended(start(run_of_500 + " --db " + db)) == 0);
  const json expected = all_values(db, 1);
  // Jobs whose server has died are waited for here; the folders they leave go with the workspace.
  REQUIRE(::prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
  fs::create_directories(w.file("tmp"));
  const std::string before = "TMPDIR=" + w.file("tmp");
  enum Kind { page, map, note, job };
  const auto body_of = [](Kind kind, const std::string& text) -> std::string {
    if (kind == map) {
      json speeds = json::array();
      for (int k = 0; k < 500; ++k) speeds.push_back(0.3 + 0.001 * k);
      return json{
          {"inputs", {{"mean_min", 60}}}, {"output", "shape"}, {"x", {{"name", "cv"}, {"values", speeds}}}}
          .dump();
    }
    if (kind == note) return json{{"note", text}, {"tags", json::array()}}.dump();
    if (kind == job) return R"({"kind": "again", "run": 1})";
    return "";
  };
  const char* const methods[] = {"GET", "POST", "PUT", "POST"};
  const char* const targets[] = {"/api/v1/runs/1?replications=1",
                                 "/api/v1/models/K117.weibull_from_moments/map", "/api/v1/runs/1/notes",
                                 "/api/v1/jobs"};
  const auto job_over = [](const Served& server) {
    const std::string state = server.get("/api/v1/jobs/1").parsed().value("state", "");
    return state != "queued" && state != "running";
  };
  // How long each takes when nobody disturbs it.
  double whole_s[4] = {};
  {
    const Served server(db, "", w.file("said"), before);
    REQUIRE(server.port() != 0);
    for (const Kind kind : {page, map, note, job}) {
      const auto begin = Clock::now();
      const auto answer = server.ask(methods[kind], targets[kind], body_of(kind, "first"));
      REQUIRE((answer.status == 200 || answer.status == 202));
      while (kind == job && !job_over(server)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      whole_s[kind] = seconds_since(begin);
    }
  }
  std::string noted = "first";
  std::int64_t kept = runs_in(db);
  REQUIRE(kept == 2);
  std::uint64_t hits[4] = {};
  std::uint64_t hit = 0;
  std::uint64_t started = 0;
  while (hit < kills && started < 10 * kills) {
    const auto kind = static_cast<Kind>(hit % 4);
    const std::string text = "note " + std::to_string(started++);
    INFO(targets[kind] << ", start " << started);
    Served server(db, "", w.file("said"), before);
    REQUIRE(server.port() != 0);
    // What the last one had promised, and nothing that is neither the old nor the new.
    REQUIRE(server.get("/api/v1/runs/1?notes=1").parsed()["note"] == noted);
    const double moment = moments.next();
    bool at_work = false;
    if (kind == job) {
      REQUIRE(server.ask("POST", targets[job], body_of(job, "")).status == 202);
      const auto begin = Clock::now();
      while (seconds_since(begin) < moment * whole_s[job])
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      at_work = !job_over(server);
      REQUIRE(server.end(SIGKILL) == 128 + SIGKILL);
    } else {
      const Socket socket(server.port());
      REQUIRE(socket.send(
          server.request(methods[kind], targets[kind], body_of(kind, text), "Connection: close\r\n")));
      const auto begin = Clock::now();
      while (seconds_since(begin) < moment * whole_s[kind]) continue;
      REQUIRE(server.end(SIGKILL) == 128 + SIGKILL);
      const std::string answer = socket.read_all();
      const auto got = parse_answer(answer);
      at_work = got.status == 0 || got.body.size() < std::stoul(got.headers.at("Content-Length"));
      if (kind == note) {
        SQLite::Database notes(db + ".notes", SQLite::OPEN_READWRITE, 60'000);
        REQUIRE(notes.execAndGet("PRAGMA integrity_check").getString() == "ok");
        const std::string now =
            notes.execAndGet("SELECT text FROM note WHERE subject = 'run' AND id = 1").getString();
        REQUIRE((now == text || (at_work && now == noted)));
        noted = now;
      }
    }
    // A job that lives on ends by itself.
    while (::waitpid(-1, nullptr, 0) > 0 || errno == EINTR) continue;
    REQUIRE(state_of(db) == "ok");
    const std::int64_t runs = runs_in(db);
    REQUIRE(runs <= kept + (kind == job ? 1 : 0));
    REQUIRE(runs >= kept);
    if (runs > kept) REQUIRE(all_values(db, runs) == expected);
    kept = runs;
    hit += at_work ? 1 : 0;
    hits[kind] += at_work ? 1 : 0;
  }
  ::prctl(PR_SET_CHILD_SUBREAPER, 0);
  REQUIRE(hit == kills);
  CHECK(all_values(db, 1) == expected);
  CHECK(call("runs --verify 1 --db " + db).exit_code == 0);
  WARN("servers: " << hit << " killed at work of " << started << " started: " << hits[page] << " in a page, "
                   << hits[map] << " in a map, " << hits[note] << " in a note, " << hits[job] << " in a job");
}
