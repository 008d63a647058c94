#pragma once
// The smallest shop with a tool: one machine that turns one part type for ever, and what the theory tests of
// tools share. Mean life of an edge 60 min, one part takes 10 min of cutting, changes take no time.

#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/math/life_law.h"
#include "scenarios/load.h"
#include "sim/shop/run.h"

namespace verstat::test {

inline constexpr double cell_life_min = 60;
inline constexpr double cell_part_min = 10;

inline nlohmann::json tool_cell() {
  return nlohmann::json::parse(R"({
    "name": "cell",
    "simulation": {"horizon_min": 400000, "warmup_min": 2000, "replications": 20, "seed": "7"},
    "inserts": [{"name": "insert", "edges": 1, "price": 10,
                 "edge_life": {"law": "exponential", "mean_ref_min": 60, "cutting_speed_ref_m_min": 60,
                               "feed_ref_mm_rev": 1, "depth_of_cut_ref_mm": 10}}],
    "tools": [{"name": "tool", "insert": "insert", "crew": "crew", "strategy": {"kind": "run_to_failure"},
               "change": {"index": {"kind": "constant", "value_min": 0},
                          "replace": {"kind": "constant", "value_min": 0},
                          "swap": {"kind": "constant", "value_min": 0}},
               "insert_booking": "at_fitting"}],
    "crews": [{"name": "crew", "members": 1}],
    "machines": [{"name": "lathe", "rate_per_min": 1}],
    "operations": [{"name": "turn", "machine": "lathe", "tool": "tool",
                    "process": {"kind": "turning", "diameter_mm": 190.98593171027441, "length_mm": 1000,
                                "cutting_speed_m_min": 60, "feed_mm_rev": 1, "depth_of_cut_mm": 10}}],
    "stores": [{"name": "store"}],
    "parts": [{"name": "part", "supply": {"kind": "always_available"}, "route": ["turn"], "store": "store"}]
  })");
}

inline scenarios::Scenario load_with(const nlohmann::json& text, const std::vector<std::string>& changes) {
  std::vector<scenarios::Change> all;
  for (const std::string& change : changes) all.push_back(scenarios::parse_change(change));
  return scenarios::load(scenarios::apply(text, all));
}
inline shop::RunResult run_with(const nlohmann::json& text, const std::vector<std::string>& changes) {
  return shop::run_scenario(load_with(text, changes), 2);
}
inline shop::RunResult run_cell(const std::vector<std::string>& changes) {
  return run_with(tool_cell(), changes);
}

inline const shop::Estimate& estimate_of(const shop::RunResult& run, const std::string& kpi) {
  const auto k = run.index_of(kpi);
  INFO(kpi);
  REQUIRE(k);
  REQUIRE(run.estimates[*k].mean);
  return run.estimates[*k];
}
inline double mean_of(const shop::RunResult& run, const std::string& kpi) {
  return *estimate_of(run, kpi).mean;
}
/// Within four standard errors of the theory, which would notice a fault of 1 % (`fault`) of it.
inline void check_meets(const shop::RunResult& run, const std::string& kpi, double theory,
                        double fault = 0.01) {
  const shop::Estimate& e = estimate_of(run, kpi);
  const double standard_error = *e.half_width / 2.093;  // Student quantile for 19 degrees of freedom
  INFO(kpi << " simulated " << *e.mean << " +- " << *e.half_width << ", theory " << theory);
  CHECK(std::abs(*e.mean - theory) < 4 * standard_error + 1e-12 * std::abs(theory));
  CHECK(standard_error < fault * theory);
}
/// Minutes in the counted time of the cell.
inline double counted_min(const nlohmann::json& cell) {
  return cell["simulation"]["horizon_min"].get<double>() - cell["simulation"]["warmup_min"].get<double>();
}

}  // namespace verstat::test
