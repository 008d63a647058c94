#include "store/notes.h"

#include <algorithm>
#include <stdexcept>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "store/naming.h"
#include "store/text_search.h"

namespace verstat::store {

namespace {

constexpr int notes_version = 1;
constexpr int busy_ms = 5'000;

const char* word_of(Subject subject) {
  return subject == Subject::run ? "run" : "study";
}

void check_version(const std::filesystem::path& file, SQLite::Database& db) {
  const int version = db.execAndGet("PRAGMA user_version").getInt();
  if (version > notes_version)
    throw StoreError(fmt::format("notes {}: written by a newer Verstat (schema {}, this program knows {})",
                                 file.string(), version, notes_version));
}

std::string trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  const auto first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
}

Annotation checked(const Annotation& given) {
  Annotation a{.note = trimmed(given.note)};
  for (const std::string& tag : given.tags)
    if (std::string text = trimmed(tag); !text.empty()) a.tags.push_back(std::move(text));
  std::sort(a.tags.begin(), a.tags.end());
  a.tags.erase(std::unique(a.tags.begin(), a.tags.end()), a.tags.end());
  if (a.note.size() > Notes::longest_note)
    throw std::invalid_argument(
        fmt::format("note: {} bytes, allowed at most {}", a.note.size(), Notes::longest_note));
  if (a.tags.size() > Notes::most_tags)
    throw std::invalid_argument(fmt::format("tags: {}, allowed at most {}", a.tags.size(), Notes::most_tags));
  if (!is_utf8(a.note)) throw std::invalid_argument("note: must be UTF-8 text");
  for (const std::string& tag : a.tags) {
    if (!is_utf8(tag)) throw std::invalid_argument("tags: must be UTF-8 texts");
    if (tag.size() > Notes::longest_tag)
      throw std::invalid_argument(
          fmt::format("tags: one has {} bytes, allowed at most {}", tag.size(), Notes::longest_tag));
    if (tag.find(',') != std::string::npos)
      throw std::invalid_argument(fmt::format("tag \"{}\": must not hold a comma", tag));
  }
  return a;
}

}  // namespace

std::filesystem::path notes_file(const std::filesystem::path& database) {
  return database.string() + ".notes";
}

Notes::Notes(const std::filesystem::path& database) : file_(notes_file(database)) {}

void Notes::set(Subject subject, std::int64_t id, const Annotation& annotation) const {
  const Annotation a = checked(annotation);
  naming("notes", file_, [&] {
    // A rollback journal, not a write-ahead log: nothing of this file may be lost, and it is written rarely.
    SQLite::Database db(file_.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, busy_ms);
    SQLite::Transaction transaction(db, SQLite::TransactionBehavior::IMMEDIATE);
    check_version(file_, db);
    db.exec(fmt::format(R"sql(
CREATE TABLE IF NOT EXISTS note(
  subject TEXT NOT NULL CHECK(subject IN ('run', 'study')),
  id INTEGER NOT NULL,
  text TEXT NOT NULL,
  PRIMARY KEY(subject, id)
) STRICT, WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS tag(
  subject TEXT NOT NULL CHECK(subject IN ('run', 'study')),
  id INTEGER NOT NULL,
  name TEXT NOT NULL,
  PRIMARY KEY(subject, id, name)
) STRICT, WITHOUT ROWID;
CREATE INDEX IF NOT EXISTS tag_by_name ON tag(name, subject, id);
PRAGMA user_version = {};
)sql",
                        notes_version));
    for (const char* statement :
         {"DELETE FROM note WHERE subject = ? AND id = ?", "DELETE FROM tag WHERE subject = ? AND id = ?"}) {
      SQLite::Statement remove(db, statement);
      remove.bind(1, word_of(subject));
      remove.bind(2, id);
      remove.exec();
    }
    if (!a.note.empty()) {
      SQLite::Statement add(db, "INSERT INTO note VALUES(?, ?, ?)");
      add.bind(1, word_of(subject));
      add.bind(2, id);
      add.bind(3, a.note);
      add.exec();
    }
    SQLite::Statement add(db, "INSERT INTO tag VALUES(?, ?, ?)");
    for (const std::string& tag : a.tags) {
      add.bind(1, word_of(subject));
      add.bind(2, id);
      add.bind(3, tag);
      add.exec();
      add.reset();
    }
    transaction.commit();
  });
}

std::unique_ptr<SQLite::Database> Notes::open_to_read() const {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return nullptr;
  auto db = std::make_unique<SQLite::Database>(file_.string(), SQLite::OPEN_READONLY, busy_ms);
  check_version(file_, *db);
  if (!db->tableExists("note") || !db->tableExists("tag")) return nullptr;
  return db;
}

std::map<std::int64_t, Annotation> Notes::of(Subject subject, const std::vector<std::int64_t>& ids) const {
  return naming("notes", file_, [&] {
    std::map<std::int64_t, Annotation> all;
    const auto db = open_to_read();
    if (!db) return all;
    SQLite::Statement note(*db, "SELECT text FROM note WHERE subject = ? AND id = ?");
    SQLite::Statement tag(*db, "SELECT name FROM tag WHERE subject = ? AND id = ? ORDER BY name");
    for (const std::int64_t id : ids) {
      Annotation a;
      note.bind(1, word_of(subject));
      note.bind(2, id);
      if (note.executeStep()) a.note = note.getColumn(0).getString();
      note.reset();
      tag.bind(1, word_of(subject));
      tag.bind(2, id);
      while (tag.executeStep()) a.tags.push_back(tag.getColumn(0).getString());
      tag.reset();
      if (!a.note.empty() || !a.tags.empty()) all[id] = std::move(a);
    }
    return all;
  });
}

Annotation Notes::get(Subject subject, std::int64_t id) const {
  auto all = of(subject, {id});
  return all.empty() ? Annotation{} : std::move(all.begin()->second);
}

std::map<std::string, std::int64_t> Notes::tags() const {
  return naming("notes", file_, [&] {
    std::map<std::string, std::int64_t> all;
    const auto db = open_to_read();
    if (!db) return all;
    SQLite::Statement q(*db, "SELECT name, count(*) FROM tag GROUP BY name");
    while (q.executeStep()) all[q.getColumn(0).getString()] = q.getColumn(1).getInt64();
    return all;
  });
}

}  // namespace verstat::store
