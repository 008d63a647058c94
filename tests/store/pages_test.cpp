// Pages of runs and studies in every order, against a sort of all of them; results as JSON.
#include <algorithm>
#include <limits>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "store/database.h"
#include "store/listing.h"
#include "store/notes.h"
#include "store/result_json.h"
#include "store/text_search.h"
#include "tests/store/example_results.h"
#include "tests/store/temporary_file.h"

using namespace verstat::store;
using verstat::test::TemporaryFile;

namespace {

constexpr int runs_stored = 9;

/// Every column in another order; the KPI is missing in every third run.
Run numbered_run(int k) {
  Run run = verstat::test::example_run(k);
  run.header.scenario_name = fmt::format("cell {}", k * 2 % 5);
  run.scenario_text = fmt::format("{{\"n\": {}}}", k * 2 % 5);
  run.header.label = fmt::format("{}abel {}", k % 2 == 0 ? "L" : "l", k * 4 % 7);
  run.header.provenance.created = fmt::format("2026-01-{:02}T00:00:00Z", 1 + k * 5 % 11);
  run.header.elapsed_s = k * 7 % 4;
  run.currency = k < 5 ? "UAH" : "EUR";
  if (k % 3 == 0) {
    run.kpis.erase(run.kpis.begin());
    for (auto& row : run.values) row.erase(row.begin());
  }
  return run;
}

std::string without_case(std::string text) {
  for (char& c : text) c = c == 'L' ? 'l' : c;
  return text;
}

}  // namespace

TEST_CASE("runs are sorted by every column and by a KPI, with those that have none at the end", "[pages]") {
  const TemporaryFile file;
  std::vector<Run> all;
  {
    Writer writer(file.path);
    for (int k = 1; k <= runs_stored; ++k) {
      all.push_back(numbered_run(k));
      all.back().header.id = writer.add_run(all.back());
    }
  }
  const Listing listing(file.path);
  const auto kpi_of = [](const Run& run) {
    return run.kpis.size() == 2 ? run.kpis[0].mean : std::optional<double>();
  };
  const auto text_key = [](const Run& run, const std::string& sort) -> std::string {
    if (sort == "scenario") return run.header.scenario_name;
    if (sort == "label") return without_case(run.header.label);
    return run.header.provenance.created;
  };
  std::vector<std::string> sorts = Listing::run_sorts();
  sorts.emplace_back("cost_per_part");
  for (const std::string& sort : sorts)
    for (const bool descending : {false, true}) {
      INFO(sort << (descending ? " down" : " up"));
      std::vector<Run> expected = all;
      std::sort(expected.begin(), expected.end(), [&](const Run& a, const Run& b) {
        const auto decided = [&](const auto& x, const auto& y) -> std::optional<bool> {
          if (x == y) return std::nullopt;
          return descending ? y < x : x < y;
        };
        std::optional<bool> first;
        if (sort == "cost_per_part") {
          if (kpi_of(a).has_value() != kpi_of(b).has_value()) return kpi_of(a).has_value();
          if (kpi_of(a)) first = decided(*kpi_of(a), *kpi_of(b));
        } else if (sort == "id") {
          first = decided(a.header.id, b.header.id);
        } else if (sort == "replications") {
          first = decided(a.header.replications, b.header.replications);
        } else if (sort == "elapsed_s") {
          first = decided(a.header.elapsed_s, b.header.elapsed_s);
        } else {
          first = decided(text_key(a, sort), text_key(b, sort));
        }
        return first.value_or(a.header.id > b.header.id);  // the newest first among equals
      });
      ListQuery query{.sort = sort, .descending = descending, .limit = 4};
      std::vector<std::int64_t> found;
      for (; query.offset < runs_stored; query.offset += query.limit) {
        const auto page = listing.runs(query);
        CHECK(page.total == runs_stored);
        for (const RunHeader& row : page.rows) found.push_back(row.id);
      }
      std::vector<std::int64_t> ids;
      for (const Run& run : expected) ids.push_back(run.header.id);
      CHECK(found == ids);
    }
}

TEST_CASE("runs are found by words and tags; their KPIs and currencies by number", "[pages]") {
  const TemporaryFile file;
  {
    Writer writer(file.path);
    for (int k = 1; k <= runs_stored; ++k) writer.add_run(numbered_run(k));
  }
  const Notes notes(file.path);
  notes.set(Subject::run, 3, {"Токарний", {"good", "new"}});
  notes.set(Subject::run, 5, {"", {"good"}});
  notes.set(Subject::study, 3, {"", {"good"}});
  const Listing listing(file.path);
  const auto found = [&](const ListQuery& query) {
    std::vector<std::int64_t> ids;
    for (const RunHeader& row : listing.runs(query).rows) ids.push_back(row.id);
    CHECK(listing.runs(query).total == static_cast<std::int64_t>(ids.size()));
    return ids;
  };
  CHECK(found({.words = {"CELL", "2"}}) == std::vector<std::int64_t>{6, 4, 1});  // in scenario or label
  CHECK(found({.words = {"токАРНИЙ"}}) == std::vector<std::int64_t>{3});
  CHECK(found({.words = {"new"}}) == std::vector<std::int64_t>{3});
  CHECK(found({.tag = "good"}) == std::vector<std::int64_t>{5, 3});
  CHECK(found({.words = {"cell"}, .tag = "new"}) == std::vector<std::int64_t>{3});
  CHECK(found({.words = {"%"}}).empty());
  CHECK(notes.tags() == std::map<std::string, std::int64_t>{{"good", 3}, {"new", 1}});

  const auto kpis = listing.kpis({1, 3, 99}, {"cost_per_part", "throughput_per_h"});
  CHECK(kpis.size() == 2);
  CHECK(kpis.at(1).size() == 2);
  CHECK(kpis.at(1)[0].mean == numbered_run(1).kpis[0].mean);
  CHECK(kpis.at(3).size() == 1);
  CHECK_FALSE(kpis.at(3)[0].mean);
  CHECK(listing.kpis({}, {"cost_per_part"}).empty());
  CHECK(listing.kpis({1}, {}).empty());
  CHECK(listing.currencies({1, 8, 99}) == std::map<std::int64_t, std::string>{{1, "UAH"}, {8, "EUR"}});
  CHECK(listing.has_kpi("cost_per_part"));
  CHECK_FALSE(listing.has_kpi("cost_per_pa"));
}

TEST_CASE("studies are sorted by every column; the best trials go by the sense of the objective", "[pages]") {
  const TemporaryFile file;
  {
    Writer writer(file.path);
    writer.add_run(verstat::test::example_run(1));
    writer.add_run(verstat::test::example_run(2));
    for (const char* status : {"finished", "failed", "interrupted", "finished"})
      verstat::test::add_example_study(writer, status);
    std::vector<Trial> trials;
    for (int k = 2; k <= 101; ++k)
      trials.push_back(
          {.number = k, .stage = "design", .values = {}, .objective = k * 37 % 101, .feasible = k % 5 != 0});
    writer.add_trials(1, trials);
  }
  const Listing listing(file.path);
  for (const std::string& sort : Listing::study_sorts())
    for (const bool descending : {false, true}) {
      std::vector<std::int64_t> ids;
      for (const StudyHeader& row : listing.studies({.sort = sort, .descending = descending}).rows)
        ids.push_back(row.id);
      INFO(sort << (descending ? " down" : " up"));
      if (sort == "status")
        CHECK(ids ==
              (descending ? std::vector<std::int64_t>{3, 4, 1, 2} : std::vector<std::int64_t>{2, 4, 1, 3}));
      else if (sort == "id" && !descending)
        CHECK(ids == std::vector<std::int64_t>{1, 2, 3, 4});
      else
        CHECK(ids == std::vector<std::int64_t>{4, 3, 2, 1});  // equal in everything else
    }
  CHECK(listing.studies({.sort = "no such"}).rows.at(0).id == 4);
  CHECK(listing.has_study(4));
  CHECK_FALSE(listing.has_study(5));
  for (const bool highest : {false, true}) {
    std::vector<double> best;
    for (const TrialRow& row :
         listing.trials(1, {.by_objective = true, .highest = highest, .limit = 5}).rows) {
      CHECK(row.feasible);
      best.push_back(*row.objective);
    }
    std::vector<double> all = {125.4};
    for (int k = 2; k <= 101; ++k)
      if (k % 5 != 0) all.push_back(k * 37 % 101);
    std::sort(all.begin(), all.end());
    if (highest) std::reverse(all.begin(), all.end());
    CHECK(best == std::vector<double>(all.begin(), all.begin() + 5));
    // The best half of a sample holds them, too.
    const auto sample = listing.sample(1, 20, highest);
    CHECK(sample.total == 101);
    CHECK(sample.rows.size() <= 20);
    for (const double value : best)
      CHECK(std::any_of(sample.rows.begin(), sample.rows.end(),
                        [&](const TrialRow& row) { return row.objective == value; }));
  }
  CHECK(listing.sample(1, 500).rows.size() == 101);
  CHECK(listing.trials(99, {}).total == 0);
}

TEST_CASE("results as JSON: numbers that are none are null, texts that are JSON are embedded", "[pages]") {
  CHECK(number_or_null(1.5) == 1.5);
  CHECK(number_or_null(std::nullopt).is_null());
  CHECK(number_or_null(std::numeric_limits<double>::infinity()).is_null());

  Run run = verstat::test::example_run(1);
  auto j = to_json(run, true);
  CHECK(j["seed"] == "18446744073709551615");
  CHECK(j["changes"][0]["pointer"] == "/seed");
  CHECK(j["fingerprint"].is_null());
  CHECK(j["kpis"][0]["values"] == nlohmann::ordered_json{1.5, 2.5});
  CHECK(j["kpis"][1]["mean"].is_null());
  CHECK(j["kpis"][1]["values"] == nlohmann::ordered_json{nullptr, nullptr});
  run.header.changes = "by hand";
  run.header.fingerprint = "ab";
  j = to_json(run, false);
  CHECK(j["changes"] == "by hand");
  CHECK(j["fingerprint"] == "ab");
  CHECK_FALSE(j["kpis"][0].contains("values"));

  Study study;
  study.variables = {{"speed", "/v", "m/min", 20, 120},
                     {"kind", "/k", "-", 0, 1, "categorical", R"(["a", "b"])"}};
  study.best_run = 7;
  study.result = R"({"words": "saves"})";
  study.trials = {{.number = 1, .stage = "analytic", .values = {1}, .objective = 2},
                  {.number = 2,
                   .stage = "simulation",
                   .values = {1},
                   .objective = std::nullopt,
                   .feasible = false,
                   .half_width = 0.5,
                   .first_replication = 10,
                   .replications = 20}};
  j = to_json(study);
  CHECK_FALSE(j["variables"][0].contains("options"));
  CHECK(j["variables"][1]["options"] == nlohmann::ordered_json{"a", "b"});
  CHECK(j["baseline_run"].is_null());
  CHECK(j["best_run"] == 7);
  CHECK(j["result"]["words"] == "saves");
  CHECK_FALSE(j["trial_list"][0].contains("replications"));
  CHECK(j["trial_list"][1]["objective"].is_null());
  CHECK(j["trial_list"][1]["half_width"] == 0.5);
  CHECK(j["trial_list"][1]["replications"] == 20);
}

TEST_CASE("folding leaves alone what only looks like a letter", "[pages]") {
  CHECK(folded("\xd0") == "\xd0");          // cut off
  CHECK(folded("\xd0\x41") == "\xd0\x61");  // no character, but a letter behind it
  CHECK(folded("\xd2\x91\xd2\x92") == "\xd2\x91\xd2\x92");
  CHECK(folded("\xd0\x90\xd0\xaf\xd0\xb0\xd0\x81\xd0\x8f") == "\xd0\xb0\xd1\x8f\xd0\xb0\xd1\x91\xd1\x9f");
}
