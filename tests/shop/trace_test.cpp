// The trace agrees with the KPIs; the shifting bottleneck is the machine that it must be.
#include <sstream>

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
