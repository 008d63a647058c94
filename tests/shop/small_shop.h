#pragma once
// Small shops for the tests, written as the JSON that a user writes.

#include <cmath>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "scenarios/json_text.h"
#include "scenarios/load.h"
#include "sim/shop/run.h"
#include "sim/shop/shop.h"

namespace verstat::test {

using nlohmann::json;

inline json constant(double value_min) {
  return {{"kind", "constant"}, {"value_min", value_min}};
}
inline json exponential(double mean_min) {
  return {{"kind", "exponential"}, {"rate_per_min", 1 / mean_min}};
}
inline json duration_process(const json& time) {
  return {{"kind", "duration"}, {"time", time}};
}

/// One machine "m" with one operation "o" for parts "p"; the tests change what they are about.
inline json small_shop(const json& supply, const json& time) {
  return {{"name", "test shop"},
          {"simulation",
           {{"horizon_min", 110'000}, {"warmup_min", 10'000}, {"replications", 10}, {"seed", "11"}}},
          {"machines", {{{"name", "m"}}}},
          {"operations", {{{"name", "o"}, {"machine", "m"}, {"process", duration_process(time)}}}},
          {"stores", {{{"name", "s"}}}},
          {"parts", {{{"name", "p"}, {"supply", supply}, {"route", {"o"}}, {"store", "s"}}}}};
}
inline json always() {
  return {{"kind", "always_available"}};
}
inline json arrivals(const json& time) {
  return {{"kind", "interarrival"}, {"time", time}};
}

/// A shop of the gallery.
inline json scenarios_of(const std::string& name) {
  return scenarios::read_json_file(std::string(VERSTAT_SOURCE_DIR) + "/scenarios/gallery/" + name + ".json");
}

inline shop::RunResult run(const json& scenario) {
  return shop::run_scenario(scenarios::load(scenario), 2);
}
inline shop::Estimate kpi(const shop::RunResult& result, const std::string& name) {
  const auto k = result.index_of(name);
  INFO(name);
  REQUIRE(k.has_value());
  return result.estimates[*k];
}
inline double mean(const shop::RunResult& result, const std::string& name) {
  const shop::Estimate e = kpi(result, name);
  INFO(name);
  REQUIRE(e.mean.has_value());
  return *e.mean;
}
/// Within five standard errors of the truth (with ten replications that fails once in 1,350 fair tries; the
/// seed is fixed), and sharp enough to notice `sharp` relative.
inline void check_truth(const shop::RunResult& result, const std::string& name, double truth, double sharp) {
  const shop::Estimate e = kpi(result, name);
  REQUIRE(e.mean.has_value());
  REQUIRE(e.half_width.has_value());
  const double standard_error = *e.half_width / 2.262;  // Student, 10 replications
  INFO(name << " = " << *e.mean << " +- " << *e.half_width << ", truth " << truth);
  CHECK(std::abs(*e.mean - truth) < 5 * standard_error + 1e-9 * std::abs(truth));
  CHECK(5 * standard_error < sharp * std::abs(truth));
}
inline void check_audit(const json& scenario) {
  const scenarios::Scenario s = scenarios::load(scenario);
  shop::Shop one(s, 0);
  static_cast<void>(one.run());
  for (const std::string& broken : one.audit()) FAIL_CHECK(broken);
}

}  // namespace verstat::test
