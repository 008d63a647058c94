// Databases written by older programs open, keep everything, and are kept themselves.
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "store/database.h"
#include "store/listing.h"

using namespace verstat::store;
namespace fs = std::filesystem;

namespace {

struct Folder {
  fs::path path = fs::temp_directory_path() / ("verstat-migration-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }
};

// As a program of that schema wrote it. 1: one study of 4 trials, two runs; 2: one run of 47 KPIs in two
// replications, one study of 3 trials.
void make_schema(int schema, const fs::path& file) {
  std::ifstream in(VERSTAT_SOURCE_DIR "/tests/store/schema" + std::to_string(schema) + ".sql");
  std::ostringstream text;
  text << in.rdbuf();
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  db.exec(text.str());
}

}  // namespace

TEST_CASE("a database of schema 1 is brought up to date, and copied before") {
  const Folder folder;
  const fs::path file = folder.path / "old.db";
  make_schema(1, file);
  CHECK_THROWS_WITH(Reader(file), Catch::Contains("has schema 1"));
  { const Writer writer(file); }
  const auto study = Reader(file).study(1);
  REQUIRE(study);
  CHECK(study->header.kind == "optimize");
  CHECK(study->header.status == "finished");
  CHECK(study->header.name == "Reliability level and cutting speed of the heavy-lathe cell");
  CHECK(study->baseline_run == 1);
  CHECK(study->best_run == 2);
  REQUIRE(study->trials.size() == 4);
  CHECK(study->trials[0].outcome.empty());
  CHECK(study->trials[0].replications == 0);
  CHECK(study->variables.at(1).type == "continuous");
  CHECK(Reader(file).run(2));
  SQLite::Database migrated(file.string());
  CHECK(migrated.execAndGet("PRAGMA user_version").getInt() == schema_version);
  CHECK(migrated.execAndGet("PRAGMA integrity_check").getString() == "ok");
  CHECK_FALSE(SQLite::Statement(migrated, "PRAGMA foreign_key_check").executeStep());
  // The old file is beside it, as it was.
  SQLite::Database kept(file.string() + ".schema1.bak");
  CHECK(kept.execAndGet("PRAGMA user_version").getInt() == 1);
  CHECK(kept.execAndGet("SELECT count(*) FROM trial").getInt() == 4);
}

TEST_CASE("a database of schema 2 keeps every value, and its runs have no fingerprint yet") {
  const Folder folder;
  const fs::path file = folder.path / "old.db";
  make_schema(2, file);
  const auto values = [&](const fs::path& of) {
    SQLite::Database db(of.string());
    SQLite::Statement q(db,
                        "SELECT run_id, replication, position, value FROM replication_kpi ORDER BY 1, 2, 3");
    std::vector<double> all;
    while (q.executeStep())
      for (int c = 0; c < 4; ++c) all.push_back(q.getColumn(c).getDouble());
    return all;
  };
  const std::vector<double> before = values(file);
  REQUIRE(before.size() == 4 * 94);
  CHECK_THROWS_WITH(Reader(file), Catch::Contains("has schema 2") && Catch::Contains("up to date"));
  Run run;
  {
    Writer writer(file);
    run = Reader(file).run(1).value();
    CHECK(run.header.fingerprint.empty());
    run.header.fingerprint = "0123456789abcdef";
    CHECK(writer.add_run(run) == 2);
  }
  CHECK(Reader(file).run(2)->header.fingerprint == "0123456789abcdef");
  CHECK(Listing(file).runs({}).rows.at(0).fingerprint == "0123456789abcdef");
  CHECK(Listing(file).runs({}).rows.at(1).fingerprint.empty());
  CHECK(Reader(file).study(1)->trials.size() == 3);
  std::vector<double> after = values(file);
  after.resize(before.size());  // the second run's come behind
  CHECK(after == before);
  SQLite::Database migrated(file.string());
  CHECK(migrated.execAndGet("PRAGMA user_version").getInt() == schema_version);
  CHECK(migrated.execAndGet("PRAGMA integrity_check").getString() == "ok");
  CHECK_FALSE(SQLite::Statement(migrated, "PRAGMA foreign_key_check").executeStep());
  const fs::path backup = file.string() + ".schema2.bak";
  CHECK(SQLite::Database(backup.string()).execAndGet("PRAGMA user_version").getInt() == 2);
  CHECK(values(backup) == before);
  CHECK_FALSE(fs::exists(file.string() + ".schema1.bak"));
}

TEST_CASE("a trial is stored once, by the bits of its variables and its replications") {
  const Folder folder;
  const fs::path file = folder.path / "new.db";
  Writer writer(file);
  Study study;
  study.scenario_text = "{}";
  study.changes = "[]";
  study.header.kind = "sweep";
  study.variables = {{"n", "/n", "1", 0, 3, "integer", "[]"},
                     {"c", "/c", "1", 0, 1, "categorical", "[\"a\",\"b\"]"}};
  const std::int64_t id = writer.begin_study(study);
  const auto trial = [](std::int64_t number, double x, std::int64_t first) {
    Trial t{.number = number, .stage = "simulation", .values = {x, 1}, .objective = 2.5};
    t.half_width = 0.5;
    t.first_replication = first;
    t.replications = 5;
    t.outcome = {1.0, std::nan(""), 0.1 + 0.2};
    return t;
  };
  writer.set_durable(false);
  writer.add_trials(id, {trial(1, 0.3, 0)});
  writer.set_durable(true);
  writer.add_trials(id, {trial(2, 0.3, 5), trial(3, 0.1 + 0.2, 0)});
  CHECK_THROWS_AS(writer.add_trials(id, {trial(4, 0.3, 0)}), StoreError);
  writer.finish_study(id, std::nullopt, std::nullopt, "{}", "interrupted");
  writer.resume_study(id);
  const auto back = Reader(file).study(id);
  CHECK(back->header.status == "running");
  CHECK(back->header.kind == "sweep");
  CHECK(back->variables.at(1).options == "[\"a\",\"b\"]");
  REQUIRE(back->trials.size() == 3);
  CHECK(back->trials[1].first_replication == 5);
  CHECK(back->trials[2].outcome.at(2) == 0.1 + 0.2);
  CHECK(std::isnan(back->trials[2].outcome.at(1)));
  CHECK_THROWS_WITH(writer.resume_study(99), Catch::Contains("has no study 99"));
}

TEST_CASE(
    "a study whose program was killed reads as interrupted, and goes on; one that lives is left alone") {
  const Folder folder;
  const fs::path file = folder.path / "killed.db";
  Study study;
  study.scenario_text = "{}";
  study.changes = "[]";
  int to_parent[2];
  REQUIRE(::pipe(to_parent) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    Writer writer(file);
    const std::int64_t id = writer.begin_study(study);
    static_cast<void>(::write(to_parent[1], &id, sizeof id));
    for (;;) ::pause();
  }
  std::int64_t id = 0;
  REQUIRE(::read(to_parent[0], &id, sizeof id) == sizeof id);
  Writer here(file);
  const auto listed = [&] { return Listing(file).studies({}).rows.at(0).status; };
  CHECK(study_under_way(file, id));
  CHECK(Reader(file).study(id)->header.status == "running");
  CHECK(listed() == "running");
  CHECK_THROWS_WITH(here.resume_study(id), Catch::Contains("under way in another program"));
  ::kill(child, SIGKILL);
  REQUIRE(::waitpid(child, nullptr, 0) == child);
  CHECK_FALSE(study_under_way(file, id));
  CHECK(Reader(file).study(id)->header.status == "interrupted");
  CHECK(Reader(file).studies().at(0).status == "interrupted");
  CHECK(listed() == "interrupted");
  here.resume_study(id);
  CHECK(Reader(file).study(id)->header.status == "running");
  here.finish_study(id, std::nullopt, std::nullopt, "{}", "finished");
  CHECK(listed() == "finished");
  CHECK_FALSE(study_under_way(file, id));
}

TEST_CASE("a long study leaves room for other writers") {
  const Folder folder;
  const fs::path file = folder.path / "shared.db";
  Writer study(file);
  Study record;
  record.scenario_text = "{}";
  record.changes = "[]";
  const std::int64_t id = study.begin_study(record);
  // Another program writes while the study's connection stays open.
  const pid_t child = ::fork();
  if (child == 0) {
    int code = 1;
    try {
      Writer other(file);
      Study own = record;
      for (int k = 0; k < 50; ++k) (void)other.begin_study(own);
      code = 0;
    } catch (...) {
    }
    ::_exit(code);
  }
  for (std::int64_t k = 1; k <= 50; ++k) {
    Trial t{.number = k, .stage = "analytic", .values = {static_cast<double>(k)}, .objective = 1};
    t.outcome = {1};
    study.add_trials(id, {t});
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 0);
  const Reader reader(file);
  CHECK(reader.study_count() == 51);
  CHECK(reader.study(id)->trials.size() == 50);
}
