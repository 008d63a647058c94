// Promises that seeded faults (tools/mutate.mjs) broke without any quick test noticing.
#include "scenarios/plan_json.h"
#include "sim/kernel/output_analysis.h"
#include "sim/shop/trace.h"
#include "tests/shop/small_shop.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;

TEST_CASE("what is sure about unattended intervals is Wilson's interval over all of them",
          "[shop][promise]") {
  const auto quiet = run_cell({"/simulation/unattended_min=90", "/tools/0/copies=12",
                               "/simulation/horizon_min=20000", "/simulation/replications=3"});
  const auto n = static_cast<std::int64_t>(std::round(3 * mean_of(quiet, "tool/tool/unattended/intervals")));
  CHECK(n > 100);
  CHECK(mean_of(quiet, "tool/tool/no_stop_share") == 1);
  CHECK(mean_of(quiet, "tool/tool/unattended/no_stop_high") == 1);
  CHECK(mean_of(quiet, "tool/tool/unattended/no_stop_low") == Approx(sim::wilson_interval(n, n).low));
}

TEST_CASE("every element of a tool has its changes among the KPIs", "[shop][promise]") {
  auto cell = tool_cell();
  const auto gallery =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/deep_hole_drilling.json");
  cell["operations"][0]["process"] = gallery["process"];
  cell["inserts"][0]["edge_life"] = gallery["edge_life"];
  cell["simulation"] = {{"horizon_min", 60'000}, {"replications", 1}, {"seed", "3"}};
  cell["tools"][0]["elements"] = {
      {{"element", "guide pads"}, {"change", {{"kind", "constant"}, {"value_min", 4}}}, {"price", 25}}};
  const auto run = run_with(cell, {});
  const double changes = mean_of(run, "tool/tool/element/guide pads/changes");
  const double parts = mean_of(run, "parts_good");
  CHECK(changes > 10);
  CHECK(mean_of(run, "tool/tool/element/guide pads/per_100_parts") == Approx(100 * changes / parts));
  CHECK(mean_of(run, "cost/elements") * parts == Approx(25 * changes));
  // Between two changes lies the cutting time of the pads, between all of them not more than there is.
  const double use_min = mean_of(run, "tool/tool/element/guide pads/use_min");
  CHECK(use_min * changes <= 60'000 * mean_of(run, "machine/lathe/state/cutting") * (1 + 1e-9));
  CHECK(use_min * (changes + 1) >=
        60'000 * mean_of(run, "machine/lathe/state/cutting") * (1 - 1e-9) - use_min);
}

TEST_CASE("the trace knows at which machine a crew worked", "[shop][promise]") {
  json shop = small_shop(always(), constant(10));
  shop["simulation"] = {{"horizon_min", 1000}, {"replications", 1}};
  shop["crews"] = {{{"name", "fitters"}, {"members", 1}}};
  shop["machines"][0]["failures"] = {
      {{"name", "f"}, {"time_to_failure", constant(100)}, {"repair", constant(10)}, {"crew", "fitters"}}};
  const scenarios::Scenario s = scenarios::load(shop);
  shop::Trace trace;
  shop::Shop one(s, 0, &trace);
  static_cast<void>(one.run());
  REQUIRE(trace.crew_work().size() == 9);
  for (const auto& work : trace.crew_work()) {
    REQUIRE(work.machine.has_value());
    CHECK(*work.machine == 0);
    CHECK(work.to_min - work.from_min == Approx(10));
  }
}
