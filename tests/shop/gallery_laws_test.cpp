// What must hold of every shop, asked of every shop of the gallery for a week: nothing is lost or made
// from nothing, threads change nothing, the trace covers every minute of every machine and member of a crew
// once.
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>

#include "sim/shop/kpis.h"
#include "sim/shop/trace_export.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

constexpr double week_min = 10'080;

std::vector<std::filesystem::path> shops() {
  std::vector<std::filesystem::path> all;
  for (const auto& entry : std::filesystem::directory_iterator(VERSTAT_SOURCE_DIR "/scenarios/gallery"))
    if (entry.path().extension() == ".json" && entry.path().stem().extension().empty())
      all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

scenarios::Scenario shortened(const std::filesystem::path& file) {
  json text = scenarios::read_json_file(file.string());
  text["simulation"]["horizon_min"] = std::min(week_min, text["simulation"].value("horizon_min", week_min));
  text["simulation"]["warmup_min"] = text["simulation"]["horizon_min"].get<double>() / 10;
  text["simulation"]["replications"] = 2;
  return scenarios::load(text);
}

template <class Intervals>
void check_covers(const Intervals& intervals, double horizon_min) {
  REQUIRE_FALSE(intervals.empty());
  CHECK(intervals.front().from_min == 0);
  CHECK(intervals.back().to_min == horizon_min);
  bool contiguous = true;
  for (std::size_t k = 1; k < intervals.size(); ++k)
    contiguous = contiguous && intervals[k].from_min == intervals[k - 1].to_min;
  CHECK(contiguous);
}

}  // namespace

TEST_CASE("every shop of the gallery keeps the laws, on one thread as on two", "[shop][gallery][threads]") {
  REQUIRE(shops().size() > 8);
  for (const auto& file : shops()) {
    INFO(file);
    const scenarios::Scenario s = shortened(file);
    std::int64_t reported = 0;
    const auto result = shop::run_scenario(
        s, 1, [&](std::int64_t done, std::int64_t of) { reported += done <= of ? 1 : 0; }, shop::Checks::on);
    CHECK(reported == 2);
    CHECK(result.broken_laws.empty());
    CHECK(result.standstills.empty());
    REQUIRE(result.event_order);
    for (const auto& row : result.values)
      for (std::size_t k = 0; k < row.size(); ++k) {
        INFO(result.kpis[k].name);
        if (row[k]) CHECK(std::isfinite(*row[k]));
      }
    std::set<std::string> names;
    for (const auto& kpi : result.kpis) names.insert(kpi.name);
    CHECK(names.size() == result.kpis.size());
    const auto again = shop::run_scenario(s, 2, {}, shop::Checks::on);
    CHECK(again.values == result.values);
    CHECK(again.courses == result.courses);
    CHECK(again.event_order == result.event_order);
    CHECK(fingerprint_of(again) == fingerprint_of(result));
  }
}

TEST_CASE("the trace of every shop of the gallery covers every minute once, in every format",
          "[shop][gallery]") {
  for (const auto& file : shops()) {
    INFO(file);
    const scenarios::Scenario s = shortened(file);
    shop::Trace trace;
    shop::Shop shop(s, 0, &trace);
    static_cast<void>(shop.run());
    const double horizon_min = s.simulation.horizon_min;
    const auto names = shop::machine_names(s);
    const auto intervals = shop::state_intervals(trace, names.size(), horizon_min);
    for (const auto& own : intervals) check_covers(own, horizon_min);
    double sole = 0;  // one machine alone at a time; in a shift there are two or more
    for (const auto& share : shop::shifting_bottleneck(intervals, 0, horizon_min)) {
      sole += share.sole;
      CHECK(share.sole + share.shifting <= 1 + 1e-9);
    }
    CHECK(sole <= 1 + 1e-9);
    const auto crews = shop::crew_rows(s, trace);
    for (const auto& row : crews) check_covers(row.intervals, horizon_min);

    std::ostringstream whole;
    shop::write_json(whole, s, trace);
    const json document = json::parse(whole.str());
    REQUIRE(document["machines"].size() == names.size());
    std::size_t rows = 1;
    for (std::size_t m = 0; m < names.size(); ++m) {
      CHECK(document["machines"][m]["intervals"].size() == intervals[m].size());
      rows += intervals[m].size();
    }
    for (const auto& row : crews) rows += row.intervals.size();
    std::ostringstream table;
    shop::write_csv(table, s, trace);
    const std::string lines = table.str();
    CHECK(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')) == rows);
    std::ostringstream dense;
    shop::write_compact(dense, s, trace);
    const json drawn = json::parse(dense.str());
    for (std::size_t m = 0; m < names.size(); ++m)
      CHECK(drawn["machines"][m]["until"].size() == drawn["machines"][m]["state"].size());
    CHECK(drawn["crews"].size() == crews.size());
    std::ostringstream events;
    shop::write_chrome(events, s, trace);
    CHECK(json::parse(events.str())["traceEvents"].size() >= rows - 1);
    std::ostringstream graph;
    shop::write_graphviz(graph, s);
    for (const auto& machine : s.machines) CHECK(graph.str().find(machine.name) != std::string::npos);
  }
}
