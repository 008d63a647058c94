// kill -9 at random moments: what was committed is there, whole, and comes out the same when computed again.
// VERSTAT_KILLS=200 VERSTAT_KILL_SEED=7 test_faults "[kill]" does more of it than a test needs.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"
#include "tests/faults/program.h"

using nlohmann::json;
using namespace verstat::test;
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

/// Kills `arguments` after a random part of `whole_s`. True when it was still running.
bool kill_within(const std::string& arguments, double whole_s, Moments& moments) {
  const pid_t child = start(arguments);
  std::this_thread::sleep_for(std::chrono::duration<double>(1.1 * whole_s * moments.next()));
  ::kill(child, SIGKILL);
  return ended(child) == 128 + SIGKILL;
}

double seconds_for(const std::string& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(ended(start(arguments)) == 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
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

TEST_CASE("runs killed at random moments: stored whole or not at all", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 10);
  Moments moments(setting("VERSTAT_KILL_SEED", 1));
  const std::string db = w.file("killed.db");
  const double whole_s = seconds_for(run_of_500 + " --db " + w.file("whole.db"));
  const json expected = all_values(w.file("whole.db"), 1);
  REQUIRE(expected[0]["values"].size() == 500);
  std::int64_t kept = 0;
  std::uint64_t hit = 0;
  for (std::uint64_t k = 0; k < kills; ++k) {
    INFO("kill " << k);
    const bool was_running = kill_within(run_of_500 + " --db " + db, whole_s, moments);
    hit += was_running ? 1 : 0;
    if (!fs::exists(db)) continue;
    REQUIRE(state_of(db) == "ok");
    const std::int64_t runs = runs_in(db);
    // Who ended by himself has committed; who was killed has committed all of it or nothing.
    REQUIRE(runs >= kept + (was_running ? 0 : 1));
    REQUIRE(runs <= kept + 1);
    if (runs > kept) REQUIRE(all_values(db, runs) == expected);
    kept = runs;
  }
  CHECK(hit > 0);
  REQUIRE(ended(start(run_of_500 + " --db " + db)) == 0);
  CHECK(runs_in(db) == kept + 1);
  for (std::int64_t run = 1; run <= kept + 1; run += 1 + kept / 10) CHECK(all_values(db, run) == expected);
  WARN("runs: " << hit << " of " << kills << " killed while running, " << kept + 1 << " stored");
}

TEST_CASE("a migration killed at random moments: the old file or the new one, and a backup", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 10);
  Moments moments(setting("VERSTAT_KILL_SEED", 1) + 1);
  std::ifstream in("tests/store/schema1.sql");
  std::ostringstream old;
  old << in.rdbuf();
  const std::string quick =
      "run scenarios/gallery/heavy-lathe.json --set /simulation/horizon_min=11000 --replications 2 --threads "
      "1 --db ";
  const int first_new_run = 3;  // the sample holds only a few values of its two runs
  double whole_s = 0;
  std::uint64_t hit = 0;
  for (std::uint64_t k = 0; k <= kills; ++k) {
    INFO("kill " << k);
    const std::string db = w.file("old" + std::to_string(k) + ".db");
    { SQLite::Database(db, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(old.str()); }
    if (k == 0) {
      whole_s = seconds_for(quick + db);
    } else {
      hit += kill_within(quick + db, whole_s, moments) ? 1 : 0;
    }
    REQUIRE(state_of(db, first_new_run) == "ok");
    const std::int64_t version = SQLite::Database(db).execAndGet("PRAGMA user_version").getInt64();
    CHECK((version == 1 || version == 2));
    if (version == 2) CHECK(fs::exists(db + ".schema1.bak"));
    REQUIRE(ended(start(quick + db)) == 0);  // whatever there was, it goes on
    REQUIRE(state_of(db, first_new_run) == "ok");
    REQUIRE(fs::exists(db + ".schema1.bak"));
    CHECK(SQLite::Database(db + ".schema1.bak").execAndGet("PRAGMA user_version").getInt() == 1);
    CHECK(SQLite::Database(db + ".schema1.bak").execAndGet("SELECT count(*) FROM trial").getInt() == 4);
    CHECK(SQLite::Database(db).execAndGet("SELECT count(*) FROM trial").getInt() == 4);
    CHECK(call("runs --study 1 --json --db " + db).exit_code == 0);
    fs::remove(db);
  }
  CHECK(hit > 0);
  WARN("migrations: " << hit << " of " << kills << " killed while running");
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
  const double whole_s = seconds_for(sweep + w.file("whole.db"));
  const json expected = json::parse(call("sweep --resume 1 --json --db " + w.file("whole.db")).out);
  std::uint64_t hit = 0;
  std::uint64_t studies = 0;
  while (hit < kills && studies < 4 * kills) {
    const std::string db = w.file("killed" + std::to_string(studies++) + ".db");
    std::int64_t trials = 0;
    for (int k = 0; k < 8 && hit < kills; ++k) {
      const bool begun = fs::exists(db) && call("runs --study 1 --db " + db).exit_code == 0;
      const bool was_running =
          kill_within(begun ? "sweep --resume 1 --db " + db : sweep + db, whole_s / 2, moments);
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

TEST_CASE("a server killed at random moments while results are written and read", "[kill]") {
  const Workspace w;
  const std::uint64_t kills = setting("VERSTAT_KILLS", 5);
  Moments moments(setting("VERSTAT_KILL_SEED", 1) + 3);
  const std::string db = w.file("served.db");
  REQUIRE(ended(start(run_of_500 + " --db " + db)) == 0);
  const json expected = all_values(db, 1);
  std::uint64_t hit = 0;
  for (std::uint64_t k = 0; k < kills; ++k) {
    const pid_t server = start("serve --port 0 --db " + db);
    const pid_t writer = start(run_of_500 + " --db " + db);
    std::this_thread::sleep_for(std::chrono::duration<double>(0.3 * moments.next()));
    ::kill(server, SIGKILL);
    hit += ended(server) == 128 + SIGKILL ? 1 : 0;
    REQUIRE(ended(writer) == 0);  // the death of a reader is nothing to it
    REQUIRE(state_of(db) == "ok");
    REQUIRE(runs_in(db) == static_cast<std::int64_t>(k) + 2);
    CHECK(all_values(db, runs_in(db)) == expected);
  }
  CHECK(hit == kills);
  WARN("servers: " << hit << " of " << kills << " killed while running");
}
