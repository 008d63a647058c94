// What cannot be stored or read is refused in words that name the file, and changes nothing.
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include <catch2/catch.hpp>

#include "store/database.h"
#include "store/listing.h"
#include "store/notes.h"
#include "tests/store/example_results.h"
#include "tests/store/temporary_file.h"

using namespace verstat::store;
using Catch::Contains;
using verstat::test::TemporaryFile;
namespace fs = std::filesystem;

namespace {

std::string bytes_of(const fs::path& file) {
  std::ostringstream all;
  all << std::ifstream(file, std::ios::binary).rdbuf();
  return all.str();
}

void execute(const fs::path& file, const std::string& sql) {
  SQLite::Database db(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  db.exec(sql);
}

/// A database with one run and one study that is finished.
void fill(const fs::path& file) {
  Writer writer(file);
  writer.add_run(verstat::test::example_run(1));
  writer.add_run(verstat::test::example_run(2));
  verstat::test::add_example_study(writer, "finished");
}

Study a_study() {
  Study study;
  study.header = {
      .name = "s", .scenario_name = "cell", .objective = "oee", .provenance = {"0.1", "test", "now"}};
  study.changes = "[]";
  study.study_text = "{}";
  study.scenario_text = "{}";
  return study;
}

}  // namespace

TEST_CASE("a database of another program stays as it is", "[refusals]") {
  for (const char* sql : {"CREATE TABLE invoices(id INTEGER)", "PRAGMA user_version = -1"}) {
    const TemporaryFile file;
    execute(file.path, sql);
    const std::string before = bytes_of(file.path);
    INFO(sql);
    CHECK_THROWS_WITH(Writer(file.path), Contains(file.path.string()) && Contains("another program"));
    CHECK(bytes_of(file.path) == before);
    CHECK_THROWS_WITH(Reader(file.path), Contains(file.path.string()) && Contains("has schema"));
  }
}

TEST_CASE("an older schema can be read when a writer has brought it up to date", "[refusals]") {
  const TemporaryFile file;
  fill(file.path);
  execute(file.path, "PRAGMA user_version = 2");
  CHECK_THROWS_WITH(Reader(file.path), Contains("any writing command brings it up to date"));
  CHECK_THROWS_WITH(Listing(file.path), Contains("any writing command brings it up to date"));
}

TEST_CASE("places where nothing can be written are named", "[refusals]") {
  const TemporaryFile file;
  CHECK_THROWS_WITH(Writer(file.path / "below" / "x.db"),
                    Contains("below/x.db") && Contains("cannot write here"));
  fs::create_directory(file.path);
  CHECK_THROWS_WITH(Writer(file.path), Contains("database " + file.path.string()));
  CHECK_THROWS_WITH(Reader(file.path), Contains("database " + file.path.string()));
  CHECK_THROWS_WITH(Reader(file.path.string() + ".none"),
                    Contains("does not exist") && Contains("verstat run"));
}

TEST_CASE("values that no Verstat has stored are an error of the file, not of the program", "[refusals]") {
  for (const char* damage :
       {"UPDATE run SET seed = 'abc' WHERE id = 1", "UPDATE run SET seed = '99999999999999999999999'",
        "INSERT INTO replication_kpi VALUES(1, 99, 0, 1.5)",
        "INSERT INTO replication_kpi VALUES(1, 0, -3, 1.5)"}) {
    const TemporaryFile file;
    fill(file.path);
    execute(file.path, damage);
    INFO(damage);
    CHECK_THROWS_AS(Reader(file.path).run(1), StoreError);
    CHECK_THROWS_WITH(Reader(file.path).run(1),
                      Contains(file.path.string()) && Contains("no Verstat has written"));
    if (std::string_view(damage).find("seed") != std::string_view::npos)
      CHECK_THROWS_WITH(Listing(file.path).runs({}), Contains("no Verstat has written"));
  }
}

TEST_CASE("a study belongs to one program at a time, and one that is gone left it interrupted",
          "[refusals]") {
  const TemporaryFile file;
  CHECK_FALSE(study_under_way(file.path, 1));  // no lock file: nobody
  std::int64_t id = 0;
  {
    Writer first(file.path);
    id = first.begin_study(a_study());
    CHECK(study_under_way(file.path, id));
    CHECK(Reader(file.path).study(id)->header.status == "running");
    CHECK(Listing(file.path).studies({}).rows.at(0).status == "running");
    Writer second(file.path);
    CHECK_THROWS_WITH(second.resume_study(id),
                      Contains(file.path.string()) && Contains("under way in another program"));
    CHECK_THROWS_WITH(second.resume_study(id + 1), Contains(fmt::format("has no study {}", id + 1)));
  }
  CHECK_FALSE(study_under_way(file.path, id));
  CHECK(Reader(file.path).study(id)->header.status == "interrupted");
  CHECK(Reader(file.path).studies().at(0).status == "interrupted");
  Writer later(file.path);
  later.resume_study(id);
  CHECK(study_under_way(file.path, id));
  CHECK(Reader(file.path).study(id)->header.status == "running");
  const auto run = later.add_run(verstat::test::example_run(1));
  later.set_study_run(id, true, run);
  CHECK(Reader(file.path).study(id)->baseline_run == run);
  later.finish_study(id, run, std::nullopt, "{}", "finished");
  CHECK_FALSE(study_under_way(file.path, id));
  const auto ended = Reader(file.path).study(id, false);
  CHECK(ended->header.status == "finished");
  CHECK(ended->baseline_run == run);
  CHECK_FALSE(ended->best_run);
  // Where the lock cannot be looked at, nobody may take the study for abandoned.
  CHECK(study_under_way(file.path / "below", id));
}

TEST_CASE("a database that is replaced under its writer ends the writing", "[refusals]") {
  const TemporaryFile file;
  Writer writer(file.path);
  writer.add_run(verstat::test::example_run(1));
  const std::string moved = file.path.string() + ".moved";
  fs::rename(file.path, moved);
  CHECK_THROWS_WITH(writer.add_run(verstat::test::example_run(2)),
                    Contains("was deleted, moved or replaced"));
  fs::copy_file(moved, file.path);
  CHECK_THROWS_WITH(writer.add_run(verstat::test::example_run(2)),
                    Contains("was deleted, moved or replaced"));
  fs::remove(file.path);
  fs::rename(moved, file.path);
  CHECK(writer.add_run(verstat::test::example_run(2)) == 2);
}

TEST_CASE("notes: what is too long, too many or no text is refused, and what was there stays", "[refusals]") {
  const TemporaryFile file;
  const Notes notes(file.path);
  CHECK(notes.get(Subject::run, 1).note.empty());
  CHECK(notes.tags().empty());
  notes.set(Subject::run, 1, {" good \n", {"b", " a", "b", " ", "\t"}});
  const auto check_kept = [&] {
    CHECK(notes.get(Subject::run, 1).note == "good");
    CHECK(notes.get(Subject::run, 1).tags == std::vector<std::string>{"a", "b"});
  };
  check_kept();
  CHECK(notes.get(Subject::study, 1).note.empty());
  const auto refused = [&](const Annotation& a, const std::string& words) {
    CHECK_THROWS_WITH(notes.set(Subject::run, 1, a), Contains(words));
    check_kept();
  };
  refused({std::string(Notes::longest_note + 1, 'x'), {}}, "note: 10001 bytes, allowed at most 10000");
  refused({"\xff", {}}, "note: must be UTF-8");
  refused({"", {std::string(Notes::longest_tag + 1, 'x')}}, "101 bytes, allowed at most 100");
  refused({"", {"\xd1"}}, "tags: must be UTF-8");
  refused({"", {"a,b"}}, "must not hold a comma");
  Annotation many;
  for (std::size_t k = 0; k <= Notes::most_tags; ++k) many.tags.push_back(std::to_string(k));
  refused(many, "tags: 31, allowed at most 30");
  notes.set(Subject::run, 1, {std::string(Notes::longest_note, 'x'), {std::string(Notes::longest_tag, 'y')}});
  CHECK(notes.get(Subject::run, 1).note.size() == Notes::longest_note);
  // Taken back: neither note nor tag is left.
  notes.set(Subject::run, 1, {});
  CHECK(notes.of(Subject::run, {1}).empty());
  CHECK(notes.tags().empty());
}

TEST_CASE("notes of a newer program and files that hold none", "[refusals]") {
  const TemporaryFile file;
  fill(file.path);
  const Notes notes(file.path);
  execute(notes_file(file.path), "CREATE TABLE note(x)");  // half of what is needed
  CHECK(notes.get(Subject::run, 1).note.empty());
  CHECK(Listing(file.path).runs({.words = {"cell"}}).total == 2);
  execute(notes_file(file.path), "PRAGMA user_version = 7");
  CHECK_THROWS_WITH(notes.get(Subject::run, 1),
                    Contains(".notes") && Contains("newer Verstat") && Contains("schema 7"));
  CHECK_THROWS_WITH(notes.set(Subject::run, 1, {"x", {}}), Contains("newer Verstat"));
  fs::remove(notes_file(file.path));
  std::ofstream(notes_file(file.path)) << std::string(5000, 'x');
  CHECK_THROWS_WITH(notes.get(Subject::run, 1), Contains("notes " + file.path.string()));
}
