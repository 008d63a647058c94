#include "store/database.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <SQLiteCpp/SQLiteCpp.h>
#include <catch2/catch.hpp>

#include "tests/store/temporary_file.h"

using namespace verstat::store;
using verstat::test::TemporaryFile;
namespace fs = std::filesystem;

namespace {

Run sample_run() {
  Run run;
  run.header.label = "test";
  run.header.scenario_name = "cell";
  run.header.changes = "[]";
  run.header.seed = 18446744073709551615ULL;
  run.header.replications = 2;
  run.header.horizon_min = 100;
  run.header.provenance = {"0.1", "x86-64", "2026-01-01T00:00:00Z"};
  run.scenario_text = "{}";
  run.currency = "UAH";
  run.kpis = {{{"cost_per_part", "UAH", "cost"}, 125.5, 0.25, 2},
              {{"nothing", "1", "no value"}, std::nullopt, std::nullopt, 0}};
  run.values = {{125.25, std::nullopt}, {0.1 + 0.2, std::nullopt}};
  return run;
}

}  // namespace

TEST_CASE("a run comes back bit for bit") {
  const TemporaryFile file;
  std::int64_t id = 0;
  {
    Writer writer(file.path);
    id = writer.add_run(sample_run());
  }
  const Reader reader(file.path);
  const auto run = reader.run(id);
  REQUIRE(run);
  CHECK(run->header.seed == 18446744073709551615ULL);
  CHECK(run->values == sample_run().values);
  CHECK(run->kpis.at(0).kpi.name == "cost_per_part");
  CHECK(run->kpis.at(0).half_width == 0.25);
  CHECK_FALSE(run->kpis.at(1).mean);
  CHECK(reader.runs().size() == 1);
  CHECK_FALSE(reader.run(id + 1));
}

TEST_CASE("a study keeps its trials by the bits of their variables") {
  const TemporaryFile file;
  Writer writer(file.path);
  Study study;
  study.header = {.id = 0,
                  .name = "s",
                  .scenario_name = "cell",
                  .status = "",
                  .objective = "cost_per_part",
                  .trials = 0,
                  .seed = 7,
                  .provenance = {}};
  study.scenario_text = "{}";
  study.changes = "[]";
  study.variables = {{"gamma", "/tools/0/strategy/gamma", "1", 0.05, 0.99}};
  const std::int64_t id = writer.begin_study(study);
  const double tricky = std::nextafter(0.47, 1);
  writer.add_trials(id,
                    {{1, "analytic", {tricky}, 125.0, true}, {2, "analytic", {0.5}, std::nullopt, false}});
  CHECK_THROWS_AS(writer.add_trials(id, {{2, "analytic", {0.5}, 1.0, true}}),
                  StoreError);  // numbers are unique
  const std::int64_t run = writer.add_run(sample_run());
  writer.finish_study(id, run, run, "{\"saving\":1}", "finished");
  const auto back = Reader(file.path).study(id);
  REQUIRE(back);
  CHECK(back->header.status == "finished");
  CHECK(back->trials.size() == 2);
  CHECK(back->trials.at(0).values == std::vector{tricky});
  CHECK_FALSE(back->trials.at(1).objective);
  CHECK(back->best_run == run);
  // The study came first with the same scenario text: the run keeps its own currency.
  CHECK(Reader(file.path).run(run)->currency == "UAH");
}

TEST_CASE("a value that is not finite is refused and leaves nothing behind") {
  const TemporaryFile file;
  Writer writer(file.path);
  Run bad = sample_run();
  bad.values[1][0] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(writer.add_run(bad), StoreError);
  bad.values[1][0] = std::nan("");
  CHECK_THROWS_AS(writer.add_run(bad), StoreError);
  CHECK(Reader(file.path).run_count() == 0);
}

TEST_CASE("no database, a foreign file and a newer schema are refused in words") {
  const TemporaryFile file;
  CHECK_THROWS_WITH(Reader(file.path), Catch::Contains("does not exist"));
  {
    std::ofstream out(file.path);
    out << std::string(5000, 'x');
  }
  CHECK_THROWS_AS(Reader(file.path), StoreError);
  CHECK_THROWS_AS(Writer(file.path), StoreError);
  fs::remove(file.path);
  { const Writer writer(file.path); }
  {
    SQLite::Database db(file.path.string(), SQLite::OPEN_READWRITE);
    db.exec("PRAGMA user_version = 99");
  }
  CHECK_THROWS_WITH(Writer(file.path), Catch::Contains("newer Verstat"));
  CHECK_THROWS_WITH(Reader(file.path), Catch::Contains("update the program"));
}
