#include "store/database.h"

#include <chrono>
#include <cstring>
#include <thread>
#include <type_traits>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "store/naming.h"
#include "store/schema.h"

namespace verstat::store {
namespace {

constexpr int busy_timeout_ms = 10'000;

std::string blob_of(const std::vector<double>& values) {
  std::string bits(values.size() * sizeof(double), '\0');
  if (!values.empty()) std::memcpy(bits.data(), values.data(), bits.size());
  return bits;
}
std::vector<double> doubles_of(const SQLite::Column& blob) {
  std::vector<double> values(static_cast<std::size_t>(blob.getBytes()) / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), blob.getBlob(), values.size() * sizeof(double));
  return values;
}
void bind(SQLite::Statement& s, int index, const std::optional<double>& value) {
  if (value) {
    s.bind(index, *value);
  } else {
    s.bind(index);
  }
}
void bind(SQLite::Statement& s, int index, const std::optional<std::int64_t>& value) {
  if (value) {
    s.bind(index, *value);
  } else {
    s.bind(index);
  }
}
std::optional<double> real_or_none(const SQLite::Column& c) {
  return c.isNull() ? std::nullopt : std::optional(c.getDouble());
}
std::optional<std::int64_t> integer_or_none(const SQLite::Column& c) {
  return c.isNull() ? std::nullopt : std::optional(c.getInt64());
}
// Seeds have 64 bits, SQLite's integers 63 and a sign: they are kept as texts.
std::uint64_t seed_of(const SQLite::Column& c) {
  return std::stoull(c.getString());
}

std::int64_t scenario_id(SQLite::Database& db, const std::string& name, const std::string& text) {
  SQLite::Statement find(db, "SELECT id FROM scenario WHERE text = ?");
  find.bind(1, text);
  if (find.executeStep()) return find.getColumn(0).getInt64();
  SQLite::Statement add(db, "INSERT INTO scenario(name, text) VALUES(?, ?)");
  add.bind(1, name);
  add.bind(2, text);
  add.exec();
  return db.getLastInsertRowid();
}

// Rows of the table of KPIs. A shop has thousands of them: their statements are prepared once.
class KpiRows {
 public:
  explicit KpiRows(SQLite::Database& db)
      : db_(db),
        find_(db, "SELECT id FROM kpi WHERE name = ? AND unit = ? AND meaning = ?"),
        add_(db, "INSERT INTO kpi(name, unit, meaning) VALUES(?, ?, ?)") {}
  std::int64_t id_of(const KpiInfo& kpi) {
    bind(find_, kpi);
    const bool found = find_.executeStep();
    const std::int64_t id = found ? find_.getColumn(0).getInt64() : 0;
    find_.reset();
    if (found) return id;
    bind(add_, kpi);
    add_.exec();
    add_.reset();
    return db_.getLastInsertRowid();
  }

 private:
  static void bind(SQLite::Statement& s, const KpiInfo& kpi) {
    s.bind(1, kpi.name);
    s.bind(2, kpi.unit);
    s.bind(3, kpi.meaning);
  }
  SQLite::Database& db_;
  SQLite::Statement find_;
  SQLite::Statement add_;
};

}  // namespace

namespace {

struct flock byte_of(std::int64_t study, short type) {
  struct flock byte {};
  byte.l_type = type;
  byte.l_whence = SEEK_SET;
  byte.l_start = study;
  byte.l_len = 1;
  return byte;
}

}  // namespace

bool study_under_way(const std::filesystem::path& database, std::int64_t id) {
  const int descriptor = ::open((database.string() + ".lock").c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return errno != ENOENT;  // a copy of a database, without its lock: nobody runs it here
  struct flock byte = byte_of(id, F_WRLCK);
  const bool known = ::fcntl(descriptor, F_OFD_GETLK, &byte) == 0;
  ::close(descriptor);
  return !known || byte.l_type != F_UNLCK;
}

std::string present_status(SQLite::Database& db, const std::filesystem::path& file, std::int64_t id,
                           const std::string& recorded) {
  if (recorded != "running" || study_under_way(file, id)) return recorded;
  // It may have ended between the two looks.
  SQLite::Statement again(db, "SELECT status FROM study WHERE id = ?");
  again.bind(1, id);
  const std::string now = again.executeStep() ? again.getColumn(0).getString() : recorded;
  return now == "running" ? "interrupted" : now;
}

// An advisory lock on a file beside the database, released by the system even when the process is killed.
// Held for one operation at a time, so that a study of many hours leaves room for others.
class Writer::Lock {
 public:
  explicit Lock(const std::filesystem::path& database) : database_(database) {
    const std::string file = database.string() + ".lock";
    descriptor_ = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (descriptor_ < 0)
      throw StoreError(
          fmt::format("database {}: cannot write here ({})", database.string(), std::strerror(errno)));
  }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;
  ~Lock() { ::close(descriptor_); }

  void take() {
    constexpr int tries = 600;
    for (int k = 0; ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0; ++k) {
      if (errno == EINTR) continue;
      if (errno != EWOULDBLOCK || k == tries)
        throw StoreError(
            fmt::format("database {}: another Verstat is writing to it; wait for it or choose another --db",
                        database_.string()));
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
  }
  void give_back() noexcept { ::flock(descriptor_, LOCK_UN); }

  /// Byte `id` of the file stands for study `id`: whoever runs it holds it. False when somebody else does.
  /// These locks are of another kind than flock's; neither sees the other.
  bool claim(std::int64_t id) noexcept {
    struct flock byte = byte_of(id, F_WRLCK);
    return ::fcntl(descriptor_, F_OFD_SETLK, &byte) == 0 || (errno != EAGAIN && errno != EACCES);
  }
  void disclaim(std::int64_t id) noexcept {
    struct flock byte = byte_of(id, F_UNLCK);
    ::fcntl(descriptor_, F_OFD_SETLK, &byte);
  }

  /// The database is open: from now on it must stay the file that its name leads to.
  void remember_database() {
    struct stat found {};
    if (::stat(database_.c_str(), &found) != 0) found = {};
    device_ = found.st_dev;
    inode_ = found.st_ino;
    remembered_ = true;
  }
  /// SQLite goes on writing into a file that was deleted, and all of it is lost in silence.
  void check_database() const {
    if (!remembered_) return;
    struct stat found {};
    if (::stat(database_.c_str(), &found) == 0 && found.st_dev == device_ && found.st_ino == inode_) return;
    throw StoreError(fmt::format(
        "database {}: was deleted, moved or replaced while it was written to; what was stored since "
        "is lost: run the command again",
        database_.string()));
  }

 private:
  std::filesystem::path database_;
  int descriptor_ = -1;
  bool remembered_ = false;
  dev_t device_ = 0;
  ino_t inode_ = 0;
};

// Runs `body` as the only writer, and names the file in whatever goes wrong.
template <class Body>
auto Writer::alone(Body&& body) const {
  struct Held {
    explicit Held(Lock& l) : lock(l) { lock.take(); }
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    ~Held() { lock.give_back(); }
    Lock& lock;
  };
  const Held held(*lock_);
  lock_->check_database();
  // Looked at again afterwards, when nothing else went wrong.
  if constexpr (std::is_void_v<std::invoke_result_t<Body>>) {
    naming("database", file_, std::forward<Body>(body));
    lock_->check_database();
  } else {
    auto result = naming("database", file_, std::forward<Body>(body));
    lock_->check_database();
    return result;
  }
}

Writer::Writer(const std::filesystem::path& file) : file_(file), lock_(std::make_unique<Lock>(file)) {
  alone([&] {
    db_ = std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE,
                                             busy_timeout_ms);
    lock_->remember_database();
    refuse_foreign(*db_);
    db_->exec("PRAGMA journal_mode = WAL");
    db_->exec("PRAGMA journal_size_limit = 67108864");
    set_durable(true);
    migrate(*db_, file);
    db_->exec("PRAGMA foreign_keys = ON");
  });
}
// Closing the last connection checkpoints: alone, too.
Writer::~Writer() {
  try {
    alone([&] { db_.reset(); });
  } catch (const StoreError&) {
    // Another writer does not let go: the next one to open the file checkpoints.
  }
}

void Writer::set_durable(bool durable) {
  naming("database", file_,
         [&] { db_->exec(durable ? "PRAGMA synchronous = FULL" : "PRAGMA synchronous = NORMAL"); });
}

std::int64_t Writer::add_run(const Run& run) {
  return alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement add(
        *db_,
        "INSERT INTO run(label, scenario_id, changes, seed, replications, horizon_min, warmup_min, "
        "elapsed_s, version, platform, created, currency, fingerprint) "
        "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    add.bind(1, run.header.label);
    add.bind(2, scenario_id(*db_, run.header.scenario_name, run.scenario_text));
    add.bind(3, run.header.changes);
    add.bind(4, std::to_string(run.header.seed));
    add.bind(5, run.header.replications);
    add.bind(6, run.header.horizon_min);
    add.bind(7, run.header.warmup_min);
    add.bind(8, run.header.elapsed_s);
    add.bind(9, run.header.provenance.version);
    add.bind(10, run.header.provenance.platform);
    add.bind(11, run.header.provenance.created);
    add.bind(12, run.currency);
    add.bind(13, run.header.fingerprint);
    add.exec();
    const std::int64_t id = db_->getLastInsertRowid();
    SQLite::Statement add_kpi(*db_, "INSERT INTO run_kpi VALUES(?, ?, ?, ?, ?, ?)");
    KpiRows kpi_rows(*db_);
    for (std::size_t k = 0; k < run.kpis.size(); ++k) {
      const KpiSummary& kpi = run.kpis[k];
      add_kpi.bind(1, id);
      add_kpi.bind(2, static_cast<std::int64_t>(k));
      add_kpi.bind(3, kpi_rows.id_of(kpi.kpi));
      bind(add_kpi, 4, kpi.mean);
      bind(add_kpi, 5, kpi.half_width);
      add_kpi.bind(6, kpi.samples);
      add_kpi.exec();
      add_kpi.reset();
    }
    SQLite::Statement add_value(*db_, "INSERT INTO replication_kpi VALUES(?, ?, ?, ?)");
    for (std::size_t r = 0; r < run.values.size(); ++r)
      for (std::size_t k = 0; k < run.values[r].size(); ++k) {
        if (!run.values[r][k]) continue;
        add_value.bind(1, id);
        add_value.bind(2, static_cast<std::int64_t>(r));
        add_value.bind(3, static_cast<std::int64_t>(k));
        add_value.bind(4, *run.values[r][k]);
        add_value.exec();
        add_value.reset();
      }
    transaction.commit();
    return id;
  });
}

std::int64_t Writer::begin_study(const Study& study) {
  return alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement add(
        *db_,
        "INSERT INTO study(name, status, objective, scenario_id, changes, study_text, seed, version, "
        "platform, created, result, kind) VALUES(?, 'running', ?, ?, ?, ?, ?, ?, ?, ?, '{}', ?)");
    add.bind(1, study.header.name);
    add.bind(2, study.header.objective);
    add.bind(3, scenario_id(*db_, study.header.scenario_name, study.scenario_text));
    add.bind(4, study.changes);
    add.bind(5, study.study_text);
    add.bind(6, std::to_string(study.header.seed));
    add.bind(7, study.header.provenance.version);
    add.bind(8, study.header.provenance.platform);
    add.bind(9, study.header.provenance.created);
    add.bind(10, study.header.kind);
    add.exec();
    const std::int64_t id = db_->getLastInsertRowid();
    SQLite::Statement add_variable(*db_, "INSERT INTO study_variable VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (std::size_t k = 0; k < study.variables.size(); ++k) {
      const Variable& v = study.variables[k];
      add_variable.bind(1, id);
      add_variable.bind(2, static_cast<std::int64_t>(k));
      add_variable.bind(3, v.name);
      add_variable.bind(4, v.pointer);
      add_variable.bind(5, v.unit);
      add_variable.bind(6, v.low);
      add_variable.bind(7, v.high);
      add_variable.bind(8, v.type);
      add_variable.bind(9, v.options);
      add_variable.exec();
      add_variable.reset();
    }
    lock_->claim(id);  // before anybody can see it
    transaction.commit();
    return id;
  });
}

void Writer::add_trials(std::int64_t study, const std::vector<Trial>& trials) {
  alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement add(
        *db_,
        "INSERT INTO trial(study_id, number, stage, variables, objective, feasible, half_width, "
        "first_replication, replications, outcome) VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    for (const Trial& trial : trials) {
      add.bind(1, study);
      add.bind(2, trial.number);
      add.bind(3, trial.stage);
      const std::string bits = blob_of(trial.values);
      add.bind(4, bits.data(), static_cast<int>(bits.size()));
      bind(add, 5, trial.objective);
      add.bind(6, trial.feasible ? 1 : 0);
      bind(add, 7, trial.half_width);
      add.bind(8, trial.first_replication);
      add.bind(9, trial.replications);
      const std::string outcome = blob_of(trial.outcome);
      add.bind(10, outcome.data(), static_cast<int>(outcome.size()));
      add.exec();
      add.reset();
    }
    transaction.commit();
  });
}

void Writer::set_study_run(std::int64_t study, bool baseline, std::int64_t run) {
  alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement update(
        *db_, fmt::format("UPDATE study SET {} = ? WHERE id = ?", baseline ? "baseline_run" : "best_run"));
    update.bind(1, run);
    update.bind(2, study);
    update.exec();
    transaction.commit();
  });
}

void Writer::resume_study(std::int64_t study) {
  alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement update(*db_, "UPDATE study SET status = 'running' WHERE id = ?");
    update.bind(1, study);
    if (update.exec() != 1) throw StoreError(fmt::format("has no study {}", study));
    if (!lock_->claim(study))
      throw StoreError(
          fmt::format("has study {} under way in another program; follow it, or end that one first", study));
    transaction.commit();
  });
}

void Writer::finish_study(std::int64_t study, std::optional<std::int64_t> baseline_run,
                          std::optional<std::int64_t> best_run, const std::string& result,
                          const std::string& status) {
  alone([&] {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    SQLite::Statement update(
        *db_, "UPDATE study SET status = ?, baseline_run = ?, best_run = ?, result = ? WHERE id = ?");
    update.bind(1, status);
    bind(update, 2, baseline_run);
    bind(update, 3, best_run);
    update.bind(4, result);
    update.bind(5, study);
    update.exec();
    transaction.commit();
    lock_->disclaim(study);
  });
}

namespace {

// Readers of a database in WAL mode share memory through a file beside it, which a read-only disk refuses.
// Nobody can change a file there either: SQLite may read it as one that never changes. Not when a log was
// left beside it, that holds commits which would not be seen.
bool on_read_only_disk(const std::filesystem::path& file) {
  struct statvfs disk {};
  std::error_code error;
  const std::uintmax_t log_bytes = std::filesystem::file_size(file.string() + "-wal", error);
  return ::statvfs(file.c_str(), &disk) == 0 && (disk.f_flag & ST_RDONLY) != 0 && (error || log_bytes == 0);
}

std::string unchanging(const std::filesystem::path& file) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string())
    uri += c == '?' || c == '#' || c == '%' ? fmt::format("%{:02x}", static_cast<unsigned char>(c))
                                            : std::string(1, c);
  return uri + "?immutable=1";
}

}  // namespace

std::unique_ptr<SQLite::Database> open_to_read(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw StoreError(fmt::format("database {} does not exist; `verstat run SCENARIO --db {}` makes one",
                                 file.string(), file.string()));
  return naming("database", file, [&] {
    auto db =
        on_read_only_disk(file)
            ? std::make_unique<SQLite::Database>(unchanging(file), SQLite::OPEN_READONLY | SQLite::OPEN_URI)
            : std::make_unique<SQLite::Database>(file.string(), SQLite::OPEN_READONLY, busy_timeout_ms);
    db->exec("PRAGMA wal_autocheckpoint = 0");
    const int version = db->execAndGet("PRAGMA user_version").getInt();
    if (version != schema_version)
      throw StoreError(fmt::format(
          "has schema {}, this program reads {}; {}", version, schema_version,
          version > schema_version ? "update the program" : "any writing command brings it up to date"));
    return db;
  });
}

Reader::Reader(const std::filesystem::path& file) : file_(file), db_(open_to_read(file)) {}
Reader::~Reader() = default;

namespace {

constexpr const char* run_columns =
    "run.id, run.label, scenario.name, run.changes, run.seed, run.replications, run.horizon_min, "
    "run.warmup_min, "
    "run.elapsed_s, run.version, run.platform, run.created, run.fingerprint";
RunHeader run_header(SQLite::Statement& row) {
  return {.id = row.getColumn(0).getInt64(),
          .label = row.getColumn(1).getString(),
          .scenario_name = row.getColumn(2).getString(),
          .changes = row.getColumn(3).getString(),
          .seed = seed_of(row.getColumn(4)),
          .replications = row.getColumn(5).getInt64(),
          .horizon_min = row.getColumn(6).getDouble(),
          .warmup_min = row.getColumn(7).getDouble(),
          .elapsed_s = row.getColumn(8).getDouble(),
          .provenance = {row.getColumn(9).getString(), row.getColumn(10).getString(),
                         row.getColumn(11).getString()},
          .fingerprint = row.getColumn(12).getString()};
}

constexpr const char* study_columns =
    "study.id, study.name, scenario.name, study.status, study.objective, "
    "(SELECT count(*) FROM trial WHERE trial.study_id = study.id), study.seed, study.version, "
    "study.platform, study.created, study.kind";
StudyHeader study_header(SQLite::Statement& row) {
  return {.id = row.getColumn(0).getInt64(),
          .name = row.getColumn(1).getString(),
          .scenario_name = row.getColumn(2).getString(),
          .status = row.getColumn(3).getString(),
          .objective = row.getColumn(4).getString(),
          .trials = row.getColumn(5).getInt64(),
          .seed = seed_of(row.getColumn(6)),
          .provenance = {row.getColumn(7).getString(), row.getColumn(8).getString(),
                         row.getColumn(9).getString()},
          .kind = row.getColumn(10).getString()};
}

}  // namespace

std::vector<RunHeader> Reader::runs(std::int64_t limit, std::int64_t offset) const {
  return naming("database", file_, [&] {
    SQLite::Statement q(*db_, fmt::format("SELECT {} FROM run JOIN scenario ON scenario.id = run.scenario_id "
                                          "ORDER BY run.id DESC LIMIT ? OFFSET ?",
                                          run_columns));
    q.bind(1, limit);
    q.bind(2, offset);
    std::vector<RunHeader> all;
    while (q.executeStep()) all.push_back(run_header(q));
    return all;
  });
}

std::int64_t Reader::run_count() const {
  return naming("database", file_, [&] { return db_->execAndGet("SELECT count(*) FROM run").getInt64(); });
}

std::optional<Run> Reader::run(std::int64_t id, bool replications) const {
  return naming("database", file_, [&]() -> std::optional<Run> {
    // One read transaction, so that the parts of the answer belong together.
    SQLite::Transaction snapshot(*db_);
    Run run;
    {
      SQLite::Statement q(*db_, fmt::format("SELECT {}, scenario.text, run.currency FROM run "
                                            "JOIN scenario ON scenario.id = run.scenario_id WHERE run.id = ?",
                                            run_columns));
      q.bind(1, id);
      if (!q.executeStep()) return std::nullopt;
      run.header = run_header(q);
      run.scenario_text = q.getColumn(13).getString();
      run.currency = q.getColumn(14).getString();
    }
    {
      SQLite::Statement q(*db_,
                          "SELECT name, unit, meaning, mean, half_width, samples FROM run_kpi "
                          "JOIN kpi ON kpi.id = run_kpi.kpi_id WHERE run_id = ? ORDER BY position");
      q.bind(1, id);
      while (q.executeStep())
        run.kpis.push_back(
            {.kpi = {q.getColumn(0).getString(), q.getColumn(1).getString(), q.getColumn(2).getString()},
             .mean = real_or_none(q.getColumn(3)),
             .half_width = real_or_none(q.getColumn(4)),
             .samples = q.getColumn(5).getInt64()});
    }
    if (replications) {
      run.values.assign(static_cast<std::size_t>(run.header.replications),
                        std::vector<std::optional<double>>(run.kpis.size()));
      SQLite::Statement q(*db_, "SELECT replication, position, value FROM replication_kpi WHERE run_id = ?");
      q.bind(1, id);
      while (q.executeStep())
        run.values.at(static_cast<std::size_t>(q.getColumn(0).getInt64()))
            .at(static_cast<std::size_t>(q.getColumn(1).getInt64())) = q.getColumn(2).getDouble();
    }
    return run;
  });
}

std::vector<StudyHeader> Reader::studies(std::int64_t limit, std::int64_t offset) const {
  return naming("database", file_, [&] {
    SQLite::Statement q(*db_,
                        fmt::format("SELECT {} FROM study JOIN scenario ON scenario.id = study.scenario_id "
                                    "ORDER BY study.id DESC LIMIT ? OFFSET ?",
                                    study_columns));
    q.bind(1, limit);
    q.bind(2, offset);
    std::vector<StudyHeader> all;
    while (q.executeStep()) all.push_back(study_header(q));
    for (StudyHeader& header : all) header.status = present_status(*db_, file_, header.id, header.status);
    return all;
  });
}

std::int64_t Reader::study_count() const {
  return naming("database", file_, [&] { return db_->execAndGet("SELECT count(*) FROM study").getInt64(); });
}

std::optional<Study> Reader::study(std::int64_t id, bool trials) const {
  auto found = naming("database", file_, [&]() -> std::optional<Study> {
    SQLite::Transaction snapshot(*db_);
    Study study;
    {
      SQLite::Statement q(
          *db_, fmt::format("SELECT {}, study.study_text, scenario.text, study.changes, study.baseline_run, "
                            "study.best_run, study.result FROM study "
                            "JOIN scenario ON scenario.id = study.scenario_id WHERE study.id = ?",
                            study_columns));
      q.bind(1, id);
      if (!q.executeStep()) return std::nullopt;
      study.header = study_header(q);
      study.study_text = q.getColumn(11).getString();
      study.scenario_text = q.getColumn(12).getString();
      study.changes = q.getColumn(13).getString();
      study.baseline_run = integer_or_none(q.getColumn(14));
      study.best_run = integer_or_none(q.getColumn(15));
      study.result = q.getColumn(16).getString();
    }
    {
      SQLite::Statement q(
          *db_,
          "SELECT name, pointer, unit, low, high, type, options FROM study_variable WHERE study_id = ? ORDER "
          "BY position");
      q.bind(1, id);
      while (q.executeStep())
        study.variables.push_back({q.getColumn(0).getString(), q.getColumn(1).getString(),
                                   q.getColumn(2).getString(), q.getColumn(3).getDouble(),
                                   q.getColumn(4).getDouble(), q.getColumn(5).getString(),
                                   q.getColumn(6).getString()});
    }
    if (trials) {
      SQLite::Statement q(
          *db_,
          "SELECT number, stage, variables, objective, feasible, half_width, first_replication, "
          "replications, outcome FROM trial WHERE study_id = ? ORDER BY number");
      q.bind(1, id);
      while (q.executeStep())
        study.trials.push_back({.number = q.getColumn(0).getInt64(),
                                .stage = q.getColumn(1).getString(),
                                .values = doubles_of(q.getColumn(2)),
                                .objective = real_or_none(q.getColumn(3)),
                                .feasible = q.getColumn(4).getInt() != 0,
                                .half_width = real_or_none(q.getColumn(5)),
                                .first_replication = q.getColumn(6).getInt64(),
                                .replications = q.getColumn(7).getInt64(),
                                .outcome = doubles_of(q.getColumn(8))});
    }
    return study;
  });
  if (found)
    found->header.status =
        naming("database", file_, [&] { return present_status(*db_, file_, id, found->header.status); });
  return found;
}

}  // namespace verstat::store
