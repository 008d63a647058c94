#pragma once
// The results database: one SQLite file. One connection at a time writes and checkpoints (a lock file sees to
// it: SQLite before 3.51.3 can lose commits when a checkpoint races a commit); readers open read-only and
// copy rows out.

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

inline constexpr int schema_version = 1;

class Writer {
 public:
  /// Opens or creates the database and brings it to `schema_version`; waits up to a minute for another
  /// writer.
  explicit Writer(const std::filesystem::path& file);
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer();

  /// Stores a whole run in one transaction; returns its id. The ids in `run` are ignored.
  std::int64_t add_run(const Run& run);
  /// Opens a study in state "running"; returns its id. Trials and results are added later.
  std::int64_t begin_study(const Study& study);
  /// Adds trials in one transaction.
  void add_trials(std::int64_t study, const std::vector<Trial>& trials);
  /// Closes a study.
  void finish_study(std::int64_t study, std::optional<std::int64_t> baseline_run,
                    std::optional<std::int64_t> best_run, const std::string& result,
                    const std::string& status);

 private:
  class Lock;
  std::filesystem::path file_;
  std::unique_ptr<Lock> lock_;
  std::unique_ptr<SQLite::Database> db_;
};

class Reader {
 public:
  /// Opens an existing database read-only. Throws StoreError when there is none or it is newer than this
  /// program.
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
