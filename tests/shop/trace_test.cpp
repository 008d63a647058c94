// The trace agrees with the KPIs; the shifting bottleneck is the machine that it must be.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "scenarios/calendar.h"
#include "sim/shop/kpis.h"
#include "sim/shop/trace_export.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

TEST_CASE("state intervals of the trace are the state times of the KPIs", "[shop][trace]") {
  json shop = small_shop(arrivals(exponential(3)), exponential(2));
  shop["machines"][0]["failures"] = {
      {{"name", "f"}, {"time_to_failure", exponential(50)}, {"repair", exponential(20)}}};
  shop["simulation"] = {{"horizon_min", 5'000}, {"replications", 1}};
  const scenarios::Scenario s = scenarios::load(shop);
  shop::Trace trace;
  shop::Shop one(s, 0, &trace);
  const auto values = one.run();
  const auto result = run(shop);
  CHECK(values == result.values[0]);  // tracing changes nothing
  const auto intervals = shop::state_intervals(trace, 1, 5'000);
  std::map<std::string, double> sums;
  double at = 0;
  for (const shop::StateInterval& i : intervals[0]) {
    CHECK(i.from_min == at);
    at = i.to_min;
    sums["machine/m/state/" + std::string(shop::name_of(i.state))] += (i.to_min - i.from_min) / 5'000;
  }
  CHECK(at == 5'000);
  for (const auto& [name, share] : sums) CHECK(share == Approx(mean(result, name)).epsilon(1e-9));
  CHECK(trace.finished().size() == static_cast<std::size_t>(mean(result, "parts_good")));

  std::ostringstream text;
  shop::write_json(text, s, trace);
  const json document = json::parse(text.str());
  CHECK(document["machines"][0]["name"] == "m");
  CHECK(document["machines"][0]["intervals"].size() == intervals[0].size());
  std::ostringstream chrome;
  shop::write_chrome(chrome, s, trace);
  CHECK(json::parse(chrome.str())["traceEvents"].size() > intervals[0].size());
}

TEST_CASE("the slow machine of a line is the bottleneck", "[shop][trace]") {
  json shop = small_shop(always(), exponential(1));
  shop["machines"].push_back({{"name", "slow"}, {"queue_capacity", 3}});
  shop["operations"].push_back(
      {{"name", "q"}, {"machine", "slow"}, {"process", duration_process(exponential(1.6))}});
  shop["parts"][0]["route"] = {"o", "q"};
  shop["simulation"] = {{"horizon_min", 20'000}, {"warmup_min", 100}, {"replications", 1}};
  const scenarios::Scenario s = scenarios::load(shop);
  shop::Trace trace;
  shop::Shop one(s, 0, &trace);
  static_cast<void>(one.run());
  const auto shares = shop::shifting_bottleneck(shop::state_intervals(trace, 2, 20'000), 100, 20'000);
  CHECK(shares[1].sole > 0.7);
  CHECK(shares[0].sole < 0.15);
}

TEST_CASE("shifting bottleneck of a hand-made history", "[shop][trace]") {
  using shop::MachineState;
  // a is active 0-10, b 8-20: sole a 0-8, shifting 8-10, sole b 10-20; nothing 20-25.
  const std::vector<std::vector<shop::StateInterval>> intervals = {
      {{0, 10, MachineState::working}, {10, 25, MachineState::idle}},
      {{0, 8, MachineState::idle},
       {8, 14, MachineState::working},
       {14, 20, MachineState::repair},
       {20, 25, MachineState::blocked}}};
  const auto shares = shop::shifting_bottleneck(intervals, 0, 25);
  CHECK(shares[0].sole == Approx(8.0 / 25));
  CHECK(shares[0].shifting == Approx(2.0 / 25));
  CHECK(shares[1].sole == Approx(10.0 / 25));
  CHECK(shares[1].shifting == Approx(2.0 / 25));
}

TEST_CASE("crews in the trace work as long as their utilization says, never twice at a time",
          "[shop][trace]") {
  std::ifstream file("scenarios/gallery/pump-shop.json");
  REQUIRE(file);
  const scenarios::Scenario s = scenarios::load(json::parse(file));
  shop::Trace trace;
  shop::Shop one(s, 3, &trace);
  const auto values = one.run();
  const auto kpis = shop::kpi_infos(s);
  const auto rows = shop::crew_rows(s, trace);
  std::size_t hands = 0;
  for (const auto& crew : s.crews) hands += static_cast<std::size_t>(crew.members * crew.machines_per_member);
  REQUIRE(rows.size() == hands);
  std::vector<double> busy_min(s.crews.size(), 0);
  const double warmup_min = s.simulation.warmup_min;
  for (const shop::CrewRow& row : rows) {
    double at = 0;
    for (const shop::CrewInterval& i : row.intervals) {
      REQUIRE(i.from_min == at);
      REQUIRE(i.to_min > at);
      at = i.to_min;
      const bool works = i.doing != "free" && i.doing != "off_shift";
      CHECK((works || !i.machine));
      if (works)
        busy_min[row.crew] += std::max(0.0, i.to_min - std::max(warmup_min, i.from_min)) /
                              static_cast<double>(s.crews[row.crew].machines_per_member);
    }
    CHECK(at == s.simulation.horizon_min);
  }
  for (std::size_t k = 0; k < s.crews.size(); ++k) {
    const auto* calendar = scenarios::find_named(s.calendars, s.crews[k].calendar);
    const double open_min = calendar == nullptr ? s.simulation.horizon_min - warmup_min
                                                : scenarios::WorkingTime(*calendar).working_min(
                                                      warmup_min, s.simulation.horizon_min);
    const auto kpi = std::find_if(kpis.begin(), kpis.end(), [&](const auto& info) {
      return info.name == "crew/" + s.crews[k].name + "/utilization";
    });
    REQUIRE(kpi != kpis.end());
    const auto utilization = values.at(static_cast<std::size_t>(kpi - kpis.begin()));
    REQUIRE(utilization);
    CHECK(*utilization > 0.01);
    CHECK(busy_min[k] / (open_min * static_cast<double>(s.crews[k].members)) ==
          Approx(*utilization).epsilon(1e-9));
  }

  // Every form tells the same.
  std::ostringstream full_text;
  std::ostringstream compact_text;
  std::ostringstream csv;
  shop::write_json(full_text, s, trace);
  shop::write_compact(compact_text, s, trace);
  shop::write_csv(csv, s, trace);
  const json full = json::parse(full_text.str());
  const json compact = json::parse(compact_text.str());
  CHECK(compact_text.str().size() * 3 < full_text.str().size());
  std::size_t lines = 1;
  for (const char* list : {"machines", "crews"}) {
    REQUIRE(full.at(list).size() == compact.at(list).size());
    for (std::size_t r = 0; r < full.at(list).size(); ++r) {
      const json& intervals = full.at(list).at(r).at("intervals");
      const json& row = compact.at(list).at(r);
      lines += intervals.size();
      REQUIRE(row.at("until").size() == intervals.size());
      for (std::size_t k = 0; k < intervals.size(); ++k) {
        const double until = row.at("until").at(k).get<double>();
        REQUIRE(std::abs(until - intervals.at(k).at(1).get<double>()) <= 0.5001e-4);
        REQUIRE(compact.at("states").at(row.at("state").at(k).get<std::size_t>()) == intervals.at(k).at(2));
        const int machine = row.contains("machine") ? row.at("machine").at(k).get<int>() : -1;
        if (machine < 0) continue;
        REQUIRE(intervals.at(k).size() == 4);
        REQUIRE(compact.at("machines").at(static_cast<std::size_t>(machine)).at("name") ==
                intervals.at(k).at(3));
      }
    }
  }
  const std::string text = csv.str();
  CHECK(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) == lines);
  CHECK(full.at("edges").size() == compact.at("edges").size());
  CHECK(compact.at("shifts").at("day shift").at(0).at("from_h") == 7);
  CHECK(full.at("shifts") == compact.at("shifts"));
}
