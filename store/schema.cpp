#include "store/schema.h"

#include <array>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "store/database.h"

namespace verstat::store {
namespace {

// Step k brings user_version from k to k + 1. A step that has shipped is never edited.
constexpr std::array steps = {R"sql(
CREATE TABLE scenario(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  text TEXT NOT NULL UNIQUE
) STRICT;
CREATE TABLE run(
  id INTEGER PRIMARY KEY,
  label TEXT NOT NULL,
  -- of the run, not of the scenario text: a change may set it
  currency TEXT NOT NULL,
  scenario_id INTEGER NOT NULL REFERENCES scenario(id),
  changes TEXT NOT NULL,
  seed TEXT NOT NULL,
  replications INTEGER NOT NULL CHECK(replications > 0),
  horizon_min REAL NOT NULL CHECK(abs(horizon_min) < 9e999),
  warmup_min REAL NOT NULL CHECK(abs(warmup_min) < 9e999),
  elapsed_s REAL NOT NULL CHECK(abs(elapsed_s) < 9e999),
  version TEXT NOT NULL,
  platform TEXT NOT NULL,
  created TEXT NOT NULL
) STRICT;
CREATE INDEX run_of_scenario ON run(scenario_id);
CREATE TABLE kpi(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  unit TEXT NOT NULL,
  meaning TEXT NOT NULL,
  UNIQUE(name, unit, meaning)
) STRICT;
CREATE TABLE run_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  position INTEGER NOT NULL,
  kpi_id INTEGER NOT NULL REFERENCES kpi(id),
  mean REAL CHECK(mean IS NULL OR abs(mean) < 9e999),
  half_width REAL CHECK(half_width IS NULL OR abs(half_width) < 9e999),
  samples INTEGER NOT NULL,
  PRIMARY KEY(run_id, position)
) STRICT, WITHOUT ROWID;
-- A KPI without a value in a replication (the cost of no part) has no row.
CREATE TABLE replication_kpi(
  run_id INTEGER NOT NULL REFERENCES run(id),
  replication INTEGER NOT NULL,
  position INTEGER NOT NULL,
  value REAL NOT NULL CHECK(abs(value) < 9e999),
  PRIMARY KEY(run_id, replication, position)
) STRICT, WITHOUT ROWID;
CREATE TABLE study(
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('running', 'finished', 'failed')),
  objective TEXT NOT NULL,
  scenario_id INTEGER NOT NULL REFERENCES scenario(id),
  changes TEXT NOT NULL,
  study_text TEXT NOT NULL,
  seed TEXT NOT NULL,
  version TEXT NOT NULL,
  platform TEXT NOT NULL,
  created TEXT NOT NULL,
  baseline_run INTEGER REFERENCES run(id),
  best_run INTEGER REFERENCES run(id),
  result TEXT NOT NULL
) STRICT;
CREATE TABLE study_variable(
  study_id INTEGER NOT NULL REFERENCES study(id),
  position INTEGER NOT NULL,
  name TEXT NOT NULL,
  pointer TEXT NOT NULL,
  unit TEXT NOT NULL,
  low REAL NOT NULL CHECK(abs(low) < 9e999),
  high REAL NOT NULL CHECK(abs(high) < 9e999),
  PRIMARY KEY(study_id, position)
) STRICT, WITHOUT ROWID;
-- Values of the variables as the bits of doubles: a trial must be found again exactly.
CREATE TABLE trial(
  study_id INTEGER NOT NULL REFERENCES study(id),
  number INTEGER NOT NULL,
  stage TEXT NOT NULL,
  variables BLOB NOT NULL,
  objective REAL CHECK(objective IS NULL OR abs(objective) < 9e999),
  feasible INTEGER NOT NULL CHECK(feasible IN (0, 1)),
  PRIMARY KEY(study_id, number)
) STRICT, WITHOUT ROWID;
)sql",
                              R"sql(
-- Studies of any kind that can be interrupted; trials with everything a resumed study needs of them.
CREATE TABLE new_study(
  id INTEGER PRIMARY KEY,
  kind TEXT NOT NULL CHECK(kind IN ('optimize', 'sweep', 'compare', 'losses')),
  name TEXT NOT NULL,
  status TEXT NOT NULL CHECK(status IN ('running', 'finished', 'interrupted', 'failed')),
  objective TEXT NOT NULL,
  scenario_id INTEGER NOT NULL REFERENCES scenario(id),
  changes TEXT NOT NULL,
  study_text TEXT NOT NULL,
  seed TEXT NOT NULL,
  version TEXT NOT NULL,
  platform TEXT NOT NULL,
  created TEXT NOT NULL,
  baseline_run INTEGER REFERENCES run(id),
  best_run INTEGER REFERENCES run(id),
  result TEXT NOT NULL
) STRICT;
INSERT INTO new_study SELECT id, 'optimize', name, status, objective, scenario_id, changes, study_text, seed,
  version, platform, created, baseline_run, best_run, result FROM study;
DROP TABLE study;
ALTER TABLE new_study RENAME TO study;
ALTER TABLE study_variable ADD COLUMN type TEXT NOT NULL DEFAULT 'continuous'
  CHECK(type IN ('continuous', 'integer', 'categorical'));
ALTER TABLE study_variable ADD COLUMN options TEXT NOT NULL DEFAULT '[]';
ALTER TABLE trial ADD COLUMN half_width REAL CHECK(half_width IS NULL OR abs(half_width) < 9e999);
ALTER TABLE trial ADD COLUMN first_replication INTEGER NOT NULL DEFAULT 0;
ALTER TABLE trial ADD COLUMN replications INTEGER NOT NULL DEFAULT 0;
-- Bits of doubles; empty in trials of schema 1, which asked the same question twice at times.
ALTER TABLE trial ADD COLUMN outcome BLOB NOT NULL DEFAULT x'';
CREATE UNIQUE INDEX trial_once ON trial(study_id, stage, variables, first_replication, replications)
  WHERE length(outcome) > 0;
)sql",
                              R"sql(
-- Of all results of the run and the course of its events; empty where it was not kept.
ALTER TABLE run ADD COLUMN fingerprint TEXT NOT NULL DEFAULT '';
)sql"};
static_assert(steps.size() == schema_version);

bool is_empty(SQLite::Database& db) {
  return db.execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0;
}

}  // namespace

void refuse_foreign(SQLite::Database& db) {
  const int version = db.execAndGet("PRAGMA user_version").getInt();
  if (version < 0 || (version == 0 && !is_empty(db)))
    throw StoreError(fmt::format("is of another program (user_version {}); choose another --db", version));
}

void migrate(SQLite::Database& db, const std::filesystem::path& file) {
  // A new file holds nothing that a copy could save.
  bool kept = is_empty(db);
  for (;;) {
    const int found = db.execAndGet("PRAGMA user_version").getInt();
    if (found > 0 && found < schema_version && !kept) {
      const std::filesystem::path copy = fmt::format("{}.schema{}.bak", file.string(), found);
      std::filesystem::remove(copy);  // of an upgrade that did not come to its end
      SQLite::Statement keep(db, "VACUUM INTO ?");
      keep.bind(1, copy.string());
      keep.exec();
      kept = true;
    }
    SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
    const int version = db.execAndGet("PRAGMA user_version").getInt();
    if (version > schema_version)
      throw StoreError(
          fmt::format("was written by a newer Verstat (schema {}, this program knows {}); update the program",
                      version, schema_version));
    if (version == schema_version) return;
    db.exec(steps[static_cast<std::size_t>(version)]);
    SQLite::Statement broken(db, "PRAGMA foreign_key_check");
    if (broken.executeStep())
      throw StoreError(fmt::format("cannot be brought from schema {}: a row of table \"{}\" leads nowhere",
                                   version, broken.getColumn(0).getString()));
    db.exec(fmt::format("PRAGMA user_version = {}", version + 1));
    transaction.commit();
  }
}

}  // namespace verstat::store
