#pragma once
// Small results to fill a database with: a run with names that need quoting, a study of one trial.

#include <string>

#include <fmt/format.h>

#include "store/database.h"

namespace verstat::test {

inline store::Run example_run(int number) {
  store::Run run;
  run.header = {.label = fmt::format("run <{}> \"quoted\"", number),
                .scenario_name = "Cell",
                .changes = R"([{"pointer": "/seed", "value": 0.1}])",
                .seed = 18446744073709551615U,
                .replications = 2,
                .horizon_min = 1000,
                .warmup_min = 100,
                .elapsed_s = 0.1,
                .provenance = {"0.1", "test", "2026-01-02T03:04:05Z"}};
  run.scenario_text = "{}";
  run.currency = "UAH";
  run.kpis.push_back({.kpi = {"cost_per_part", "UAH", "cost"},
                      .mean = 0.1 + 0.2 * number,
                      .half_width = 1.0 / 3,
                      .samples = 2});
  run.kpis.push_back({.kpi = {"throughput_per_h", "parts/h", "rate"},
                      .mean = std::nullopt,
                      .half_width = std::nullopt,
                      .samples = 0});
  run.values = {{1.5, std::nullopt}, {2.5, std::nullopt}};
  return run;
}

inline void add_example_study(store::Writer& writer, const std::string& status) {
  store::Study study;
  study.header = {.name = "Study",
                  .scenario_name = "Cell",
                  .status = "running",
                  .objective = "cost_per_part",
                  .seed = 7,
                  .provenance = {"0.1", "test", "2026-01-02T03:04:05Z"}};
  study.changes = "[]";
  study.study_text = "{}";
  study.scenario_text = "{}";
  study.variables = {{"speed", "/v", "m/min", 20, 120}};
  const auto id = writer.begin_study(study);
  writer.add_trials(id, {{.number = 1, .stage = "analytic", .values = {1.0 / 3}, .objective = 125.4}});
  writer.finish_study(id, 1, 2, R"({"words": "saves"})", status);
}

}  // namespace verstat::test
