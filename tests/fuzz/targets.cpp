#include "tests/fuzz/targets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "fit/csv_table.h"
#include "models/catalogue/catalogue.h"
#include "models/catalogue/error.h"
#include "optimize/study_spec.h"
#include "scenarios/load.h"
#include "scenarios/model_json.h"
#include "sim/kernel/errors.h"
#include "sim/shop/run.h"
#include "web-ui/server/url.h"

namespace verstat::fuzz {

namespace {

using nlohmann::json;
using scenarios::InputError;

[[noreturn]] void finding(const std::string& what) {
  std::fprintf(stderr, "finding: %s\n", what.c_str());
  std::abort();
}

// An error is for a person: not empty, not a novel. (Names it repeats are made harmless where it is printed.)
void check_words(const std::string& text) {
  if (text.empty() || text.size() > 5000) finding(fmt::format("an error of {} characters", text.size()));
}

std::vector<std::string> files_in(const std::string& folder, const std::string& ending, bool studies) {
  std::vector<std::string> texts;
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(ending) && name.ends_with(".study.json") == studies) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) texts.push_back(scenarios::read_text_file(path.string()));
  return texts;
}

// ------------------------------------------------------------------------------------------------ scenario
// Loaded, and when it can be loaded and is small, simulated a little with every law checked.
void eat_scenario(std::string_view bytes) {
  try {
    scenarios::Scenario s = scenarios::load(scenarios::parse_json(bytes));
    s.simulation.horizon_min = std::min(s.simulation.horizon_min, 3000.0);
    s.simulation.warmup_min = std::min(s.simulation.warmup_min, s.simulation.horizon_min / 4);
    s.simulation.replications = 1;
    s.simulation.max_events = 20'000;
    std::int64_t machines = 0;
    for (const auto& machine : s.machines) machines += machine.count;
    if (machines > 100) return;
    const shop::RunResult result = shop::run_scenario(s, 1, {}, shop::Checks::on);
    for (const std::string& law : result.broken_laws) finding("broken law: " + law);
    for (std::size_t k = 0; k < result.kpis.size(); ++k)
      if (result.values[0][k] && !std::isfinite(*result.values[0][k]))
        finding(fmt::format("KPI {} = {}", result.kpis[k].name, *result.values[0][k]));
  } catch (const InputError& e) {
    check_words(e.what());
  } catch (const sim::BudgetError& e) {
    check_words(e.what());
  }
}
std::vector<std::string> scenario_seeds() {
  return files_in("scenarios/gallery", ".json", false);
}

// --------------------------------------------------------------------------------------------------- study
void eat_study(std::string_view bytes) {
  try {
    const optimize::StudySpec study = optimize::load_study(scenarios::parse_json(bytes));
    (void)optimize::fixed_changes(study);
  } catch (const InputError& e) {
    check_words(e.what());
  }
}
std::vector<std::string> study_seeds() {
  return files_in("scenarios/gallery", ".json", true);
}

// --------------------------------------------------------------------------------------------------- table
void eat_table(std::string_view bytes) {
  for (const char* const separator : {"", "semicolon"}) {
    try {
      fit::TableOptions options;
      options.separator = separator;
      const fit::Table table = fit::parse_table("table.csv", bytes, options);
      for (const fit::Row& row : table.rows)
        if (row.cells.size() != table.columns.size()) finding("a row with too many or too few cells");
    } catch (const InputError& e) {
      check_words(e.what());
    }
  }
}
std::vector<std::string> table_seeds() {
  return {scenarios::read_text_file("tests/data/turning_wear.csv"),
          "tool,time min,failed\n1,30.5,yes\n2,41,no\n",
          "\xef\xbb\xbfінструмент;хв;відмова\n1;30,5;так\n2;41;ні\n\"a;\"\"b\";;-\n", "a\tb\tc\n1\t2\t3\n"};
}

// --------------------------------------------------------------------------------------------------- model
void check_finite(const models::Value& value, std::string_view key) {
  if (const double* number = value.real(); number != nullptr && !std::isfinite(*number))
    finding(fmt::format("{} gives {}", key, *number));
  if (value.list() != nullptr)
    for (const models::Value& one : *value.list()) check_finite(one, key);
  if (value.map() != nullptr)
    for (const auto& [name, one] : *value.map()) check_finite(one, key);
}
// {"function": key, "inputs": {...}}, what a line of verstat models eval --batch holds.
void eat_model(std::string_view bytes) {
  try {
    const json point = scenarios::parse_json(bytes);
    if (!point.is_object() || !point.contains("function") || !point["function"].is_string() ||
        !point.contains("inputs"))
      return;
    const auto key = point["function"].get<std::string>();
    const models::Function& f = models::catalogue().at(key);
    check_finite(f.evaluate(scenarios::to_value(point["inputs"])), key);
  } catch (const InputError& e) {
    check_words(e.what());
  } catch (const models::ModelError& e) {
    check_words(e.what());
  }
}
std::vector<std::string> model_seeds() {
  std::vector<std::string> all;
  for (const models::Source& source : models::catalogue().sources())
    for (const models::Function& f : source.functions()) {
      nlohmann::ordered_json point{{"function", f.key}};
      point["inputs"] = scenarios::to_json(f.example_inputs());
      all.push_back(point.dump());
    }
  return all;
}

// ------------------------------------------------------------------------------------------------- changes
// One --set per line, made in the heavy-lathe cell.
void eat_changes(std::string_view bytes) {
  static const json cell = scenarios::read_json_file("scenarios/gallery/heavy-lathe.json");
  try {
    std::vector<scenarios::Change> changes;
    while (!bytes.empty() && changes.size() < 8) {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      changes.push_back(scenarios::parse_change(bytes.substr(0, end)));
      bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    (void)scenarios::load(scenarios::apply(cell, changes));
  } catch (const InputError& e) {
    if (std::string(e.what()).empty()) finding("an error without words");
  }
}
std::vector<std::string> change_seeds() {
  return {"/machines/0/count=3\n/tools/0/strategy/gamma=0.47",
          "/simulation/seed=\"18446744073709551615\"",
          "/operations/0/process/cutting_speed_m_min=75.5\n/crews/0/members=2",
          "/inserts/0/edge_life={\"law\":\"exponential\"}",
          "/parts/0/supply={\"kind\":\"interarrival\",\"time\":"
          "{\"kind\":\"gamma\",\"mean_min\":50,\"cv\":0.5}}",
          "/a~1b/~0=x"};
}

// --------------------------------------------------------------------------------------------------- route
void eat_route(std::string_view bytes) {
  const auto target = web::parse_target(bytes);
  if (!target) return;
  for (const std::string& step : target->path)
    if (step.empty() || step == "." || step == ".." || step.find('/') != std::string::npos ||
        step.find('\\') != std::string::npos || step.find('\0') != std::string::npos)
      finding("a path that leads elsewhere: " + step);
}
std::vector<std::string> route_seeds() {
  return {"/",
          "/api/v1/runs/3?replications=1",
          "/api/v1/models/K117.part_cost",
          "/assets/index-3f2a.js",
          "/a%20b/c%2Fd?x=%41&y=+1",
          "/api/v1/../../etc/passwd",
          "/%2e%2e/%2e%2e/etc/passwd"};
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"scenario", true, eat_scenario, scenario_seeds}, {"study", true, eat_study, study_seeds},
      {"table", false, eat_table, table_seeds},         {"model", true, eat_model, model_seeds},
      {"changes", false, eat_changes, change_seeds},    {"route", false, eat_route, route_seeds}};
  return all;
}

const Target& target(std::string_view name) {
  for (const Target& one : targets())
    if (one.name == name) return one;
  throw std::invalid_argument(fmt::format("there is no fuzz target \"{}\"", name));
}

}  // namespace verstat::fuzz
