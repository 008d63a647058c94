#include "store/listing.h"

#include <algorithm>
#include <cstring>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include "store/database.h"
#include "store/naming.h"
#include "store/notes.h"
#include "store/text_search.h"

namespace verstat::store {

namespace {

std::string_view text_of(sqlite3_value* value) {
  const auto* text = reinterpret_cast<const char*>(sqlite3_value_text(value));
  return text == nullptr ? std::string_view{}
                         : std::string_view(text, static_cast<std::size_t>(sqlite3_value_bytes(value)));
}

// has_word(word, text...): true when the folded word stands in one of the texts.
void has_word(sqlite3_context* context, int count, sqlite3_value** values) {
  const std::string_view word = text_of(values[0]);
  int found = 0;
  for (int k = 1; k < count && found == 0; ++k)
    found = folded(text_of(values[k])).find(word) == std::string::npos ? 0 : 1;
  sqlite3_result_int(context, found);
}

// Conditions on rows of `table` ("run" or "study") with their values, in order.
struct Where {
  std::string sql = "1";
  std::vector<std::string> values;
};

Where where_of(const std::string& notes, const std::string& table, const std::string& texts,
               const ListQuery& query) {
  Where where;
  for (const std::string& word : query.words) {
    where.sql += fmt::format(
        " AND has_word(?, {0}, coalesce((SELECT text FROM {2}.note WHERE subject = '{1}' AND note.id = "
        "{1}.id), ''), "
        "coalesce((SELECT group_concat(name, ' ') FROM {2}.tag WHERE subject = '{1}' AND tag.id = {1}.id), "
        "''))",
        texts, table, notes);
    where.values.push_back(folded(word));
  }
  if (!query.tag.empty()) {
    where.sql += fmt::format(" AND {0}.id IN (SELECT tag.id FROM {1}.tag WHERE subject = '{0}' AND name = ?)",
                             table, notes);
    where.values.push_back(query.tag);
  }
  return where;
}

int bind_all(SQLite::Statement& q, const std::vector<std::string>& values) {
  int index = 0;
  for (const std::string& value : values) q.bind(++index, value);
  return index;
}

std::optional<double> real_or_none(const SQLite::Column& c) {
  return c.isNull() ? std::nullopt : std::optional(c.getDouble());
}

TrialRow trial_of(SQLite::Statement& q) {
  const SQLite::Column blob = q.getColumn(2);
  std::vector<double> values(static_cast<std::size_t>(blob.getBytes()) / sizeof(double));
  if (!values.empty()) std::memcpy(values.data(), blob.getBlob(), values.size() * sizeof(double));
  return {.number = q.getColumn(0).getInt64(),
          .stage = q.getColumn(1).getString(),
          .values = std::move(values),
          .objective = real_or_none(q.getColumn(3)),
          .feasible = q.getColumn(4).getInt() != 0,
          .half_width = real_or_none(q.getColumn(5)),
          .replications = q.getColumn(6).getInt64()};
}

constexpr const char* trial_columns =
    "number, stage, variables, objective, feasible, half_width, replications";

std::string placeholders(std::size_t count) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += k == 0 ? "?" : ", ?";
  return all;
}

// Names that a query may sort by, and the columns they mean: nothing of a request ever becomes SQL.
using Columns = std::vector<std::pair<std::string, std::string>>;
const Columns run_columns_of_sorts = {{"id", "run.id"},
                                      {"scenario", "scenario.name COLLATE NOCASE"},
                                      {"label", "run.label COLLATE NOCASE"},
                                      {"created", "run.created"},
                                      {"replications", "run.replications"},
                                      {"elapsed_s", "run.elapsed_s"}};
const Columns study_columns_of_sorts = {{"id", "study.id"},
                                        {"name", "study.name COLLATE NOCASE"},
                                        {"scenario", "scenario.name COLLATE NOCASE"},
                                        {"status", "study.status"},
                                        {"created", "study.created"}};

std::vector<std::string> names_of(const Columns& columns) {
  std::vector<std::string> names;
  for (const auto& [name, column] : columns) names.push_back(name);
  return names;
}

const std::string* column_of(const Columns& columns, const std::string& name) {
  for (const auto& [known, column] : columns)
    if (known == name) return &column;
  return nullptr;
}

}  // namespace

const std::vector<std::string>& Listing::run_sorts() {
  static const std::vector<std::string> names = names_of(run_columns_of_sorts);
  return names;
}
const std::vector<std::string>& Listing::study_sorts() {
  static const std::vector<std::string> names = names_of(study_columns_of_sorts);
  return names;
}

Listing::Listing(const std::filesystem::path& database) : file_(database), db_(open_to_read(database)) {
  naming("database", file_, [&] {
    db_->exec("PRAGMA temp_store = MEMORY");
    const std::filesystem::path notes = notes_file(database);
    std::error_code error;
    bool attached = false;
    if (std::filesystem::exists(notes, error)) {
      SQLite::Statement attach(*db_, "ATTACH ? AS notes");
      attach.bind(1, notes.string());
      attach.exec();
      SQLite::Statement q(*db_, "SELECT count(*) FROM notes.sqlite_master WHERE name IN ('note', 'tag')");
      attached = q.executeStep() && q.getColumn(0).getInt() == 2;
      q.reset();
      if (!attached) db_->exec("DETACH notes");
    }
    if (!attached) {
      // No notes yet: empty tables in their place spare every query a second form.
      notes_ = "temp";
      db_->exec("CREATE TEMP TABLE note(subject TEXT, id INTEGER, text TEXT)");
      db_->exec("CREATE TEMP TABLE tag(subject TEXT, id INTEGER, name TEXT)");
    }
    db_->createFunction("has_word", -1, true, nullptr, has_word, nullptr, nullptr, nullptr);
  });
}
Listing::~Listing() = default;

ListPage<RunHeader> Listing::runs(const ListQuery& query) const {
  return naming("database", file_, [&] {
    const Where where = where_of(notes_, "run", "scenario.name, run.label, run.changes", query);
    ListPage<RunHeader> page;
    {
      SQLite::Statement q(
          *db_,
          query.words.empty() && query.tag.empty()
              ? std::string("SELECT count(*) FROM run")
              : "SELECT count(*) FROM run JOIN scenario ON scenario.id = run.scenario_id WHERE " + where.sql);
      if (!query.words.empty() || !query.tag.empty()) bind_all(q, where.values);
      if (q.executeStep()) page.total = q.getColumn(0).getInt64();
    }
    const std::string* column = column_of(run_columns_of_sorts, query.sort);
    const std::string order = column != nullptr
                                  ? *column
                                  : "(SELECT mean FROM run_kpi JOIN kpi ON kpi.id = run_kpi.kpi_id "
                                    "WHERE run_kpi.run_id = run.id AND kpi.name = ? LIMIT 1)";
    SQLite::Statement q(
        *db_,
        fmt::format(
            "SELECT run.id, run.label, scenario.name, run.changes, run.seed, run.replications, "
            "run.horizon_min, run.warmup_min, run.elapsed_s, run.version, run.platform, "
            "run.created, run.fingerprint FROM run JOIN scenario ON scenario.id = run.scenario_id WHERE {} "
            "ORDER BY {} {} NULLS LAST, run.id DESC LIMIT ? OFFSET ?",
            where.sql, order, query.descending ? "DESC" : "ASC"));
    int index = bind_all(q, where.values);
    if (column == nullptr) q.bind(++index, query.sort);
    q.bind(++index, query.limit);
    q.bind(++index, query.offset);
    while (q.executeStep())
      page.rows.push_back({.id = q.getColumn(0).getInt64(),
                           .label = q.getColumn(1).getString(),
                           .scenario_name = q.getColumn(2).getString(),
                           .changes = q.getColumn(3).getString(),
                           .seed = std::stoull(q.getColumn(4).getString()),
                           .replications = q.getColumn(5).getInt64(),
                           .horizon_min = q.getColumn(6).getDouble(),
                           .warmup_min = q.getColumn(7).getDouble(),
                           .elapsed_s = q.getColumn(8).getDouble(),
                           .provenance = {q.getColumn(9).getString(), q.getColumn(10).getString(),
                                          q.getColumn(11).getString()},
                           .fingerprint = q.getColumn(12).getString()});
    return page;
  });
}

ListPage<StudyHeader> Listing::studies(const ListQuery& query) const {
  return naming("database", file_, [&] {
    const Where where =
        where_of(notes_, "study", "study.name, scenario.name, study.objective, study.changes", query);
    ListPage<StudyHeader> page;
    {
      SQLite::Statement q(
          *db_,
          "SELECT count(*) FROM study JOIN scenario ON scenario.id = study.scenario_id WHERE " + where.sql);
      bind_all(q, where.values);
      if (q.executeStep()) page.total = q.getColumn(0).getInt64();
    }
    const std::string* column = column_of(study_columns_of_sorts, query.sort);
    // Trials are counted for the rows of the page only: the inner query cuts first.
    SQLite::Statement q(
        *db_,
        fmt::format("SELECT id, name, scenario_name, status, objective, "
                    "(SELECT count(*) FROM trial WHERE trial.study_id = page.id), seed, version, platform, "
                    "created, kind FROM (SELECT study.id AS id, study.kind AS kind, study.name AS name, "
                    "scenario.name AS scenario_name, "
                    "study.status AS status, study.objective AS objective, study.seed AS seed, "
                    "study.version AS version, study.platform AS platform, study.created AS created, "
                    "row_number() OVER (ORDER BY {0} {1}, study.id DESC) AS place "
                    "FROM study JOIN scenario ON scenario.id = study.scenario_id WHERE {2} "
                    "ORDER BY place LIMIT ? OFFSET ?) AS page ORDER BY place",
                    column != nullptr ? *column : "study.id", query.descending ? "DESC" : "ASC", where.sql));
    int index = bind_all(q, where.values);
    q.bind(++index, query.limit);
    q.bind(++index, query.offset);
    while (q.executeStep())
      page.rows.push_back(
          {.id = q.getColumn(0).getInt64(),
           .name = q.getColumn(1).getString(),
           .scenario_name = q.getColumn(2).getString(),
           .status = q.getColumn(3).getString(),
           .objective = q.getColumn(4).getString(),
           .trials = q.getColumn(5).getInt64(),
           .seed = std::stoull(q.getColumn(6).getString()),
           .provenance = {q.getColumn(7).getString(), q.getColumn(8).getString(), q.getColumn(9).getString()},
           .kind = q.getColumn(10).getString()});
    for (StudyHeader& header : page.rows)
      header.status = present_status(*db_, file_, header.id, header.status);
    return page;
  });
}

std::map<std::int64_t, std::vector<KpiSummary>> Listing::kpis(const std::vector<std::int64_t>& runs,
                                                              const std::vector<std::string>& names) const {
  return naming("database", file_, [&] {
    std::map<std::int64_t, std::vector<KpiSummary>> all;
    if (runs.empty() || names.empty()) return all;
    SQLite::Statement q(
        *db_, fmt::format("SELECT run_id, name, unit, meaning, mean, half_width, samples FROM run_kpi "
                          "JOIN kpi ON kpi.id = run_kpi.kpi_id WHERE run_id IN ({}) AND name IN ({}) "
                          "ORDER BY run_id, position",
                          placeholders(runs.size()), placeholders(names.size())));
    int index = 0;
    for (const std::int64_t id : runs) q.bind(++index, id);
    for (const std::string& name : names) q.bind(++index, name);
    while (q.executeStep())
      all[q.getColumn(0).getInt64()].push_back(
          {.kpi = {q.getColumn(1).getString(), q.getColumn(2).getString(), q.getColumn(3).getString()},
           .mean = real_or_none(q.getColumn(4)),
           .half_width = real_or_none(q.getColumn(5)),
           .samples = q.getColumn(6).getInt64()});
    return all;
  });
}

std::map<std::int64_t, std::string> Listing::currencies(const std::vector<std::int64_t>& runs) const {
  return naming("database", file_, [&] {
    std::map<std::int64_t, std::string> all;
    SQLite::Statement q(*db_, "SELECT currency FROM run WHERE id = ?");
    for (const std::int64_t id : runs) {
      q.bind(1, id);
      if (q.executeStep()) all[id] = q.getColumn(0).getString();
      q.reset();
    }
    return all;
  });
}

bool Listing::has_kpi(const std::string& name) const {
  return naming("database", file_, [&] {
    SQLite::Statement q(*db_, "SELECT 1 FROM kpi WHERE name = ? LIMIT 1");
    q.bind(1, name);
    return q.executeStep();
  });
}

bool Listing::has_study(std::int64_t id) const {
  return naming("database", file_, [&] {
    SQLite::Statement q(*db_, "SELECT 1 FROM study WHERE id = ?");
    q.bind(1, id);
    return q.executeStep();
  });
}

std::int64_t Listing::trial_count(std::int64_t study) const {
  SQLite::Statement q(*db_, "SELECT count(*) FROM trial WHERE study_id = ?");
  q.bind(1, study);
  return q.executeStep() ? q.getColumn(0).getInt64() : 0;
}

ListPage<TrialRow> Listing::trials(std::int64_t study, const TrialQuery& query) const {
  return naming("database", file_, [&] {
    ListPage<TrialRow> page;
    page.total = trial_count(study);
    SQLite::Statement q(
        *db_,
        fmt::format(
            "SELECT {} FROM trial WHERE study_id = ? AND number > ? {} LIMIT ? OFFSET ?", trial_columns,
            query.by_objective
                ? (query.highest ? "AND objective IS NOT NULL ORDER BY feasible DESC, objective DESC, number"
                                 : "AND objective IS NOT NULL ORDER BY feasible DESC, objective, number")
                : "ORDER BY number"));
    q.bind(1, study);
    q.bind(2, query.after);
    q.bind(3, query.limit);
    q.bind(4, query.offset);
    while (q.executeStep()) page.rows.push_back(trial_of(q));
    return page;
  });
}

ListPage<TrialRow> Listing::sample(std::int64_t study, std::int64_t most, bool highest) const {
  const std::int64_t total = naming("database", file_, [&] { return trial_count(study); });
  if (total <= most) return trials(study, {.limit = most});
  return naming("database", file_, [&] {
    ListPage<TrialRow> page;
    page.total = total;
    const std::int64_t cheap = most / 2;
    const std::int64_t rest = most - cheap;
    const std::int64_t step = (total + rest - 1) / rest;
    SQLite::Statement q(
        // The numbers first, then their rows by key: a test of every row against the best ones takes longer.
        *db_,
        fmt::format("SELECT {} FROM trial WHERE study_id = ?1 AND number IN ("
                    "SELECT number FROM trial WHERE study_id = ?1 AND number % ?2 = 0 UNION ALL "
                    "SELECT number FROM (SELECT number FROM trial WHERE study_id = ?1 AND objective IS "
                    "NOT NULL AND feasible = 1 ORDER BY objective {}, number LIMIT ?3)) ORDER BY number",
                    trial_columns, highest ? "DESC" : "ASC"));
    q.bind(1, study);
    q.bind(2, step);
    q.bind(3, cheap);
    while (q.executeStep()) page.rows.push_back(trial_of(q));
    return page;
  });
}

}  // namespace verstat::store
