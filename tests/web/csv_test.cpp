#include "web-ui/server/csv.h"

#include <catch2/catch.hpp>

using namespace verstat;

namespace {

store::Run example() {
  store::Run run;
  run.kpis.push_back({.kpi = {"cost_per_part", "UAH", "all \"costs\", per part"},
                      .mean = 0.1 + 0.2,
                      .half_width = 0.43,
                      .samples = 20});
  run.kpis.push_back({.kpi = {"=cmd|' /C calc'!A0", "1", ""},
                      .mean = std::nullopt,
                      .half_width = std::nullopt,
                      .samples = 0});
  return run;
}

}  // namespace

TEST_CASE("KPI tables follow RFC 4180, keep every digit and disarm formulas") {
  CHECK(web::kpi_table(example(), {}) ==
        "name,mean,half_width_95,unit,samples,meaning\r\n"
        "cost_per_part,0.30000000000000004,0.43,UAH,20,\"all \"\"costs\"\", per part\"\r\n"
        "'=cmd|' /C calc'!A0,,,1,0,\r\n");
}

TEST_CASE("the variant for Excel has semicolons, decimal commas and a byte order mark") {
  const std::string text =
      web::kpi_table(example(), {.separator = ';', .decimal = ',', .byte_order_mark = true});
  CHECK(text.substr(0, 3) == "\xEF\xBB\xBF");
  CHECK(text.find("cost_per_part;0,30000000000000004;0,43;UAH;20;\"all \"\"costs\"\", per part\"\r\n") !=
        std::string::npos);
}

TEST_CASE("trial tables have a column per variable with its unit") {
  store::Study study;
  study.header.objective = "cost_per_part";
  study.variables = {{"gamma", "/g", "1", 0, 1}, {"speed", "/v", "m/min", 1, 2}};
  study.trials = {
      {.number = 1, .stage = "analytic", .values = {0.5, -70}, .objective = 191.25},
      {.number = 2, .stage = "analytic", .values = {0.25, 60}, .objective = std::nullopt, .feasible = false}};
  CHECK(web::trial_table(study, {}) ==
        "number,stage,gamma,speed [m/min],objective cost_per_part,feasible\r\n"
        "1,analytic,0.5,-70,191.25,1\r\n"
        "2,analytic,0.25,60,,0\r\n");
}
