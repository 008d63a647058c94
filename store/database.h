#pragma once
// The results database: one SQLite file. One connection at a time commits and checkpoints (a lock file sees
// to it, held for one transaction at a time: SQLite before 3.51.3 can lose commits when a checkpoint races a
// commit); readers open read-only and copy rows out.

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "store/records.h"

namespace SQLite {
class Database;
}

namespace verstat::store {

/// The database cannot be used as asked; the message names the file and what to do.
class StoreError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline constexpr int schema_version = 3;

class Writer {
 public:
  /// Opens or creates the database and brings it to `schema_version`; a file of an older schema is copied to
  /// `<file>.schema<N>.bak` first. Every operation waits up to a minute for another writer's.
  explicit Writer(const std::filesystem::path& file);
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer();

  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

  /// Stores a whole run in one transaction; returns its id. The ids in `run` are ignored.
  std::int64_t add_run(const Run& run);
  /// Opens a study in state "running"; returns its id. Trials and results are added later.
  std::int64_t begin_study(const Study& study);
  /// Adds trials in one transaction. A trial that is there already (same stage, variables and replications)
  /// is an error: nothing is computed twice.
  void add_trials(std::int64_t study, const std::vector<Trial>& trials);
  /// True, as at first: a commit survives a power cut. False: only the end of the program, however sudden; a
  /// power cut may take the last ones. For trials that take microseconds.
  void set_durable(bool durable);
  /// Notes a run that belongs to a study: its baseline, or else its best.
  void set_study_run(std::int64_t study, bool baseline, std::int64_t run);
  /// An interrupted study goes on, and one whose program was killed. Throws StoreError when there is no such
  /// study, or when it is under way in another program.
  void resume_study(std::int64_t study);
  /// Closes a study, or notes how far it came.
  void finish_study(std::int64_t study, std::optional<std::int64_t> baseline_run,
                    std::optional<std::int64_t> best_run, const std::string& result,
                    const std::string& status);

 private:
  class Lock;
  template <class Body>
  auto alone(Body&& body) const;
  std::filesystem::path file_;
  std::unique_ptr<Lock> lock_;
  std::unique_ptr<SQLite::Database> db_;
};

/// Whether a program that runs study `id` lives: each holds a lock on its study, which the system releases
/// even when the program is killed. True, too, where the file system cannot tell.
[[nodiscard]] bool study_under_way(const std::filesystem::path& database, std::int64_t id);
/// Status of a study that was read as `recorded` from `db`, the database `file`: one that is recorded as
/// running and is not under way is "interrupted". Not within a transaction.
[[nodiscard]] std::string present_status(SQLite::Database& db, const std::filesystem::path& file,
                                         std::int64_t id, const std::string& recorded);

/// Opens an existing database of this program's schema to read, also on a read-only disk. Throws StoreError
/// when there is none or its schema is another.
[[nodiscard]] std::unique_ptr<SQLite::Database> open_to_read(const std::filesystem::path& file);

class Reader {
 public:
  /// As open_to_read.
  explicit Reader(const std::filesystem::path& file);
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader();

  /// Newest first.
  [[nodiscard]] std::vector<RunHeader> runs(std::int64_t limit = 100, std::int64_t offset = 0) const;
  [[nodiscard]] std::int64_t run_count() const;
  /// With `replications` false the values of single replications are left out.
  [[nodiscard]] std::optional<Run> run(std::int64_t id, bool replications = true) const;
  [[nodiscard]] std::vector<StudyHeader> studies(std::int64_t limit = 100, std::int64_t offset = 0) const;
  [[nodiscard]] std::int64_t study_count() const;
  /// With `trials` false the list of trials is left out; the header counts them all the same.
  [[nodiscard]] std::optional<Study> study(std::int64_t id, bool trials = true) const;

 private:
  std::filesystem::path file_;
  std::unique_ptr<SQLite::Database> db_;
};

}  // namespace verstat::store
