#include "fit/value_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fit/fit_error.h"
#include "fit/life_fit.h"
#include "fit/sample_value.h"
#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using scenarios::InputError;

[[noreturn]] void refuse(const std::string& file, const std::string& text) {
  throw InputError("", fmt::format("plans {}: {}", file, text));
}

double number_of(const std::string& file, const json& object, const std::string& where, const char* member,
                 double low, double high) {
  if (!object.contains(member) || !object[member].is_number())
    refuse(file, fmt::format("{}/{} must be a number", where, member));
  const double value = object[member].get<double>();
  if (!(value >= low && value <= high))
    refuse(file, fmt::format("{}/{} = {}, allowed {} to {}", where, member, value, low, high));
  return value;
}

void only(const std::string& file, const json& object, const std::string& where,
          std::initializer_list<const char*> known) {
  if (!object.is_object())
    refuse(file, fmt::format("{} must be an object", where.empty() ? "the file" : where));
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse(file, fmt::format("{}/{}: there is no such member", where, key));
}

}  // namespace

ValueSpec read_value_spec(const std::string& file) {
  ValueSpec spec{.file = file};
  json j;
  try {
    j = scenarios::parse_json(scenarios::read_text_file(file));
  } catch (const InputError& e) {
    refuse(file, e.what());
  }
  only(file, j, "", {"description", "plans", "cutting_min", "cost_per_edge", "edges", "watched_min", "risk"});
  if (!j.contains("plans") || !j["plans"].is_array() || j["plans"].size() < 2 || j["plans"].size() > 20)
    refuse(file, "/plans must be a list of 2 to 20 plans");
  for (std::size_t k = 0; k < j["plans"].size(); ++k) {
    const json& one = j["plans"][k];
    const std::string where = fmt::format("/plans/{}", k);
    only(file, one, where, {"name", "tool", "planned_change_cost", "failure_cost", "age_min"});
    const auto text = [&](const char* member) {
      if (!one.contains(member)) return std::string();
      if (!one[member].is_string()) refuse(file, fmt::format("{}/{} must be a text", where, member));
      return one[member].get<std::string>();
    };
    ChangePlan plan{.name = text("name"), .tool = text("tool")};
    if (plan.name.empty()) refuse(file, where + "/name must be a text");
    plan.failure_cost = number_of(file, one, where, "failure_cost", 0, 1e9);
    if (one.contains("age_min")) {
      plan.age_min = number_of(file, one, where, "age_min", 1e-3, 1e6);
      plan.planned_change_cost = number_of(file, one, where, "planned_change_cost", 0, 1e9);
    }
    spec.plans.push_back(std::move(plan));
  }
  spec.cutting_min = number_of(file, j, "", "cutting_min", 1, 1e12);
  spec.cost_per_edge = number_of(file, j, "", "cost_per_edge", 0, 1e9);
  if (j.contains("watched_min")) spec.watched_min = number_of(file, j, "", "watched_min", 1e-3, 1e6);
  if (j.contains("risk")) spec.risk = number_of(file, j, "", "risk", 1e-4, 0.5);
  if (j.contains("edges")) {
    if (!j["edges"].is_array() || j["edges"].empty() || j["edges"].size() > 30)
      refuse(file, "/edges must be a list of 1 to 30 whole numbers");
    for (const json& n : j["edges"]) {
      if (!n.is_number_integer() || n.get<std::int64_t>() < 1 || n.get<std::int64_t>() > 1000)
        refuse(file, fmt::format("/edges: {} must be a whole number from 1 to 1000", n.dump()));
      spec.edges.push_back(n.get<int>());
    }
    std::sort(spec.edges.begin(), spec.edges.end());
  } else {
    spec.edges = {2, 5, 10, 20, 40, 80};
  }
  return spec;
}

Report report_value(const RemovalLog& log, const ValueSpec& spec, int truths, std::uint64_t seed,
                    Origin origin) {
  constexpr std::size_t draws = 1000;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<UnknownGroup> groups;
  std::vector<std::vector<WeibullDraw>> laws;
  std::vector<PlanCosts> plans;
  std::vector<std::string> tools;
  Report report;
  report.json["table"] = table_json(log.table, log.rows_used);
  report.json["tools"] = ordered_json::array();
  add_table_lines(report.lines, log.table, log.rows_used);
  report.lines.emplace_back("");
  for (std::size_t k = 0; k < spec.plans.size(); ++k) {
    const ChangePlan& plan = spec.plans[k];
    std::vector<Observation> lives;
    std::string tool = plan.tool;
    std::string known;
    std::string regime;
    bool mixed = false;
    for (const RemovalGroup& g : log.groups) {
      known += (known.empty() ? "\"" : ", \"") + g.tool + "\"";
      if (plan.tool.empty() ? log.groups.size() == 1 : g.tool == plan.tool) {
        mixed = mixed || (!lives.empty() && g.regime != regime);
        regime = g.regime;
        lives.insert(lives.end(), g.lives.begin(), g.lives.end());
        tool = g.tool;
      }
    }
    if (lives.empty())
      refuse(spec.file, fmt::format("/plans/{}/tool \"{}\": the log has {}", k, plan.tool, known));
    if (mixed)
      refuse(spec.file,
             fmt::format("/plans/{}/tool \"{}\" was used in several regimes; choose one with --regime", k,
                         tool));
    auto at = std::find(tools.begin(), tools.end(), tool);
    if (at == tools.end()) {
      try {
        laws.push_back(weibull_posterior(lives, draws, seed, tool));
      } catch (const FitError& e) {
        refuse(spec.file, fmt::format("/plans/{}/tool \"{}\": {}", k, tool, e.what()));
      }
      groups.push_back(weibull_group(tool, laws.back(), spec.watched_min.value_or(infinity)));
      tools.push_back(tool);
      at = tools.end() - 1;
      report.json["tools"].push_back(
          {{"tool", tool}, {"edges", lives.size()}, {"failures", failures_in(lives)}});
      report.lines.push_back(fmt::format("{}: {} edges measured, {} failures",
                                         tool.empty() ? "all edges" : tool, lives.size(),
                                         failures_in(lives)));
    }
    PlanCosts costs{.name = plan.name, .group = static_cast<std::size_t>(at - tools.begin()), .costs = {}};
    for (const WeibullDraw& law : laws[costs.group])
      costs.costs.push_back(spec.cutting_min * age_replacement_cost(law, plan.age_min.value_or(infinity),
                                                                    plan.planned_change_cost,
                                                                    plan.failure_cost));
    plans.push_back(std::move(costs));
  }

  const ChoiceNow now = choose_now(groups, plans, seed);
  origin.rows_used = log.rows_used;
  origin.rows_in_file = log.table.rows_in_file;
  origin.method =
      fmt::format("expected value of sample information, {} simulated truths, Weibull lives", truths);
  report.json["plans"] = ordered_json::array();
  for (std::size_t k = 0; k < plans.size(); ++k) {
    report.json["plans"].push_back(
        {{"name", plans[k].name}, {"expected_cost", now.expected[k]}, {"best_chance", now.best_chance[k]}});
    report.lines.push_back(fmt::format("{}: {} for {} min of cutting, cheapest with probability {:.3f}",
                                       plans[k].name, plain(now.expected[k]), plain(spec.cutting_min),
                                       now.best_chance[k]));
  }
  report.json["best_now"] = plans[now.best].name;
  report.json["perfect_information"] = now.perfect_information;
  report.lines.push_back(
      fmt::format("choosing {} now loses {} on average against knowing the truth: more is not worth paying",
                  plans[now.best].name, plain(now.perfect_information)));
  report.lines.push_back(fmt::format("  {:>10}{:>14}{:>14}{:>14}{:>16}", "new edges", "saves", "+-",
                                     "less cost", "wrong choice"));
  report.json["samples"] = ordered_json::array();
  int best_n = 0;
  double best_net = 0;
  std::optional<int> safe_n;
  if (1 - now.best_chance[now.best] <= spec.risk) safe_n = 0;
  for (const int n : spec.edges) {
    const SampleValue v = value_of_sample(groups, plans, n, truths, seed);
    const double net = v.value - n * static_cast<double>(groups.size()) * spec.cost_per_edge;
    // A saving that may be the chance of the simulation does not count.
    if (net > best_net && v.value > 2 * v.standard_error) {
      best_net = net;
      best_n = n;
    }
    if (!safe_n && v.wrong_chance <= spec.risk) safe_n = n;
    report.json["samples"].push_back({{"new_edges_per_tool", n},
                                      {"value", v.value},
                                      {"standard_error", v.standard_error},
                                      {"net", net},
                                      {"wrong_chance", v.wrong_chance}});
    report.lines.push_back(fmt::format("  {:>10}{:>14}{:>14}{:>14}{:>16.3f}", n, plain(v.value),
                                       plain(2 * v.standard_error), plain(net), v.wrong_chance));
  }
  if (best_n == spec.edges.back())
    report.warnings.push_back(
        fmt::format("{} is the largest number tried; still more may be worth it", best_n));
  report.json["worth_measuring_per_tool"] = best_n;
  report.json["net_value"] = best_net;
  report.json["risk"] = spec.risk;
  report.json["safe_after_per_tool"] = safe_n ? ordered_json(*safe_n) : ordered_json(nullptr);
  report.lines.push_back(best_n == 0
                             ? fmt::format("measuring more does not pay: choose {} now", plans[now.best].name)
                             : fmt::format("measure {} more edges of each tool: worth {} more than they cost",
                                           best_n, plain(best_net)));
  report.lines.push_back(
      safe_n ? (*safe_n == 0
                    ? fmt::format("the choice is safe now (wrong with at most {:g} %)", 100 * spec.risk)
                    : fmt::format("the choice is safe (wrong with at most {:g} %) after {} more of each tool",
                                  100 * spec.risk, *safe_n))
             : fmt::format("the choice is not safe (wrong with at most {:g} %) with any of these numbers",
                           100 * spec.risk));
  report.json["warnings"] = report.warnings;
  report.json["provenance"] = origin_json(origin);
  return report;
}

}  // namespace verstat::fit
