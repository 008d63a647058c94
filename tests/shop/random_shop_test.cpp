// Thousands of random shops: whatever the scenario, parts, time and money are conserved, and what does not
// matter changes nothing.
#include <map>
#include <set>

#include <fmt/format.h>

#include "tests/property.h"
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

int pick(int low, int high) {
  return *rc::gen::inRange(low, high + 1);
}
bool chance(int percent) {
  return pick(1, 100) <= percent;
}
// Times never fall on the same instant: no ties, no order of lists that could matter.
json time_law(double mean_min) {
  switch (pick(0, 2)) {
    case 0:
      return exponential(mean_min);
    case 1:
      return {{"kind", "lognormal"}, {"mean_min", mean_min}, {"cv", 0.3}};
    default:
      return {{"kind", "uniform"}, {"low_min", 0.5 * mean_min}, {"high_min", 1.5 * mean_min}};
  }
}

json random_machine(int k) {
  json machine = {{"name", "m" + std::to_string(k)}, {"count", pick(1, 2)}, {"rate_per_min", pick(0, 3)}};
  if (chance(30)) machine["queue_capacity"] = pick(0, 3);
  if (chance(30)) machine["loading"] = time_law(0.5);
  if (chance(20)) machine["unloading"] = time_law(0.5);
  if (chance(30))
    machine["dispatch"] =
        *rc::gen::element<std::string>("spt", "edd", "critical_ratio", "least_setup", "priority");
  if (chance(30)) machine["setup"] = {{"time", time_law(2)}, {"crew", chance(50) ? "c0" : ""}, {"cost", 1}};
  if (chance(30)) machine["attendance"] = {{"crew", "skill"}, {"during", chance(50) ? "always" : "loading"}};
  if (chance(40)) {
    machine["failures"] = {{{"name", "f"},
                            {"clock", *rc::gen::element<std::string>("calendar", "operating", "parts")},
                            {"time_to_failure", time_law(60)},
                            {"repair", time_law(10)},
                            {"effect", *rc::gen::element<std::string>("at_once", "after_part", "when_idle")},
                            {"scrap_probability", 0.3},
                            {"damage", 5}}};
    if (chance(50)) machine["failures"][0]["crew"] = "skill";
    if (chance(30)) machine["failures"][0]["spare"] = "belt";
    if (chance(50))
      machine["maintenance"] = {{{"name", "pm"},
                                 {"clock", "operating"},
                                 {"interval", 47.3},
                                 {"duration", time_law(4)},
                                 {"renews", {"f"}},
                                 {"joins_from", 0.7}}};
  }
  if (chance(20)) {
    machine["calendar"] = "day";
    machine["part_at_shift_end"] = chance(50) ? "pause" : "finish";
    machine["repair_at_shift_end"] = chance(50) ? "pause" : "finish";
  }
  if (chance(20)) machine["switch_off"] = {{"after_idle_min", 5}, {"warm_up", time_law(1)}};
  machine["power"] = {{"working_kw", 5}, {"standby_kw", 1}};
  return machine;
}

json random_shop() {
  json shop = {
      {"name", "random"},
      {"simulation",
       {{"horizon_min", 2'000},
        {"warmup_min", 300},
        {"replications", 1},
        {"allow_overload", true},
        {"seed", std::to_string(pick(1, 1'000'000))}}},
      {"crews",
       {{{"name", "c0"},
         {"rate_per_min", 1},
         {"members", pick(1, 2)},
         {"skills", {"skill"}},
         {"walking_min", 0.3}},
        {{"name", "c1"},
         {"rate_per_min", 2},
         {"pay", "shift"},
         {"skills", {"skill"}},
         {"machines_per_member", 2}}}},
      {"calendars",
       {{{"name", "day"}, {"shifts", {{{"days", {"monday", "tuesday"}}, {"from_h", 3.1}, {"to_h", 19.7}}}}}}},
      {"spares", {{{"name", "belt"}, {"price", 3}, {"lead_time", time_law(30)}}}},
      {"energy_price_per_kwh", 0.2},
      {"stores", {{{"name", "out"}}, {{"name", "middle"}}}}};
  if (chance(30)) shop["crews"][1]["calendar"] = "day";
  const int machines = pick(1, 4);
  for (int k = 0; k < machines; ++k) shop["machines"].push_back(random_machine(k));
  if (chance(40)) shop["criteria"] = {{"mission_min", 97}};
  static const json gauge = [] {
    json process =
        scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/gauge_inspection.json")
            .at("process");
    process["wear_per_check_um"] = 0.35;
    process["replace_min"] = 0.83;
    return process;
  }();
  const int operations = pick(machines, machines + 3);
  for (int k = 0; k < operations; ++k) {
    json operation = {{"name", "o" + std::to_string(k)},
                      {"process", duration_process(time_law(pick(1, 5)))},
                      {"cost", pick(0, 2)}};
    if (k < machines || chance(60))
      operation["machine"] = "m" + std::to_string(k % machines);
    else
      operation["machines"] = {"m0", "m" + std::to_string(machines - 1)};
    if (operation.contains("machines") && machines == 1) {
      operation.erase("machines");
      operation["machine"] = "m0";
    }
    if (chance(40)) operation["quality"] = {{"scrap_probability", 0.05}, {"defect_probability", 0.1}};
    if (chance(25)) operation["inspection"] = {{"share", 0.8}, {"sensitivity", 0.9}, {"specificity", 0.95}};
    if (chance(15)) {  // gauges that last 40 checks
      operation["process"] = gauge;
      operation["process"]["check_min"] = 0.3 + 0.01 * k;
    }
    if (chance(30)) operation["family"] = "x";
    shop["operations"].push_back(operation);
  }
  const int parts = pick(1, 3);
  for (int p = 0; p < parts; ++p) {
    json part = {{"name", "p" + std::to_string(p)},
                 {"store", p == 0 ? "middle" : "out"},
                 {"value", 10},
                 {"batch_size", pick(1, 3)},
                 {"priority", pick(0, 2)},
                 {"escape_cost", 5},
                 {"tardiness_cost_per_min", 0.01}};
    if (chance(70))
      part["supply"] = arrivals(time_law(pick(4, 30)));
    else
      part["supply"] = always();
    if (chance(40)) part["release"] = {{"kind", "conwip"}, {"cap", pick(1, 6)}};
    if (chance(50)) part["due_after"] = time_law(40);
    const int steps = pick(1, 4);
    for (int k = 0; k < steps; ++k) {
      json step = {{"name", "s" + std::to_string(k)},
                   {"operation", "o" + std::to_string(pick(0, operations - 1))}};
      if (chance(25) && k + 1 < steps)
        step["next"] = {{{"to", "s" + std::to_string(k + 1)}, {"probability", 0.7}},
                        {{"to", ""}, {"probability", 0.3}}};
      if (chance(30)) step["rework"] = "s0";
      if (p == 1 && k == steps - 1 && chance(50)) step["assembles"] = {{{"part", "p0"}, {"count", 2}}};
      part["steps"].push_back(step);
    }
    shop["parts"].push_back(part);
  }
  if (chance(30))
    shop["transport"] = {{{"name", "belt"},
                          {"from", "m0"},
                          {"carrier", {{"kind", "conveyor"}, {"capacity", 2}, {"time_min", 1.37}}}},
                         {{"name", "cart"}, {"carrier", {{"kind", "delay"}, {"time", time_law(2)}}}}};
  // Machines nobody uses would be refused.
  for (int k = 0; k < machines; ++k)
    shop["operations"].push_back({{"name", "spare" + std::to_string(k)},
                                  {"machine", "m" + std::to_string(k)},
                                  {"process", duration_process(constant(1))}});
  return shop;
}

bool on_shifts(const json& shop) {
  for (const json& machine : shop["machines"])
    if (machine.contains("calendar")) return true;
  return false;
}

}  // namespace

TEST_CASE("random shops conserve parts, time and money", "[shop][random]") {
  int run_shops = 0;
  int dead_shops = 0;
  // A property is tried a hundred times, each with twenty shops.
  property("conservation", [&] {
    for (int twenty = 0; twenty < 20; ++twenty) {
      const json text = random_shop();
      const scenarios::Scenario scenario = scenarios::load(text);
      shop::Shop one(scenario, 0);
      const auto values = one.run();
      for (const std::string& broken : one.audit()) RC_FAIL(broken);
      const auto infos = shop::kpi_infos(scenario);
      double sum = 0;
      std::optional<double> whole;
      for (std::size_t k = 0; k < infos.size(); ++k) {
        if (infos[k].name == "cost_per_part") whole = values[k];
        if (infos[k].name.starts_with("cost/") && values[k]) sum += *values[k];
      }
      // What is said to stand for good never moves again.
      double longest_blocked = 0;
      double standstill = 0;
      for (std::size_t k = 0; k < infos.size(); ++k) {
        if (infos[k].name.ends_with("/state/blocked"))
          longest_blocked = std::max(longest_blocked, *values[k]);
        if (infos[k].name == "standstill_share") standstill = *values[k];
      }
      // Blocked time belongs to places (conveyors aside), idle time to where batches came from (once they
      // came).
      const auto by_group = [&](const std::string& what) {
        std::map<std::string, double> sums;
        for (std::size_t k = 0; k < infos.size(); ++k)
          if (const auto at = infos[k].name.find(what); at != std::string::npos && values[k])
            sums[infos[k].name.substr(7, at - 7)] += *values[k];
        return sums;
      };
      const auto blocked_by = by_group("/blocked_by/");
      const auto starved_by = by_group("/starved_by/");
      for (const json& machine : text["machines"]) {
        const std::string name = machine["name"];
        double idle = 0;
        double blocked = 0;
        for (std::size_t k = 0; k < infos.size(); ++k) {
          if (!infos[k].name.starts_with("machine/" + name)) continue;
          const double share = values[k].value_or(0) / machine["count"].get<double>();
          if (infos[k].name.ends_with("/state/idle") || infos[k].name.ends_with("/state/off")) idle += share;
          if (infos[k].name.ends_with("/state/blocked")) blocked += share;
        }
        if (starved_by.contains(name)) RC_ASSERT(starved_by.at(name) <= idle + 1e-9);
        if (blocked_by.contains(name)) RC_ASSERT(blocked_by.at(name) <= blocked + 1e-9);
        if (blocked_by.contains(name) && !text.contains("transport"))
          RC_ASSERT(std::abs(blocked_by.at(name) - blocked) <= 1e-9);
      }
      RC_ASSERT(one.standstill().empty() == (standstill == 0));
      if (standstill > 0) ++dead_shops;
      if (!on_shifts(text)) RC_ASSERT(longest_blocked >= standstill - 1e-9);
      if (whole) RC_ASSERT(std::abs(sum - *whole) <= 1e-12 * std::abs(*whole));
      ++run_shops;
    }
  });
  CHECK(run_shops == 2000);
  CHECK(dead_shops > 0);
}

TEST_CASE("the order of lists changes nothing", "[shop][random]") {
  property("reordering", [] {
    json text = random_shop();
    // Everybody with the same shift wants hands at the same instant when it begins: the tie would be broken
    // by the order of the list.
    bool shift_taken = text["crews"][1].contains("calendar");
    for (json& machine : text["machines"]) {
      if (!machine.contains("calendar")) continue;
      if (shift_taken || machine["count"] != 1) machine.erase("calendar");
      shift_taken = true;
    }
    const auto result = run(text);
    // Crews are asked in the order of their list: that order means something.
    for (const char* list : {"machines", "stores", "operations", "calendars", "spares"})
      std::reverse(text[list].begin(), text[list].end());
    const auto again = run(text);
    for (std::size_t k = 0; k < result.kpis.size(); ++k) {
      const auto other = again.index_of(result.kpis[k].name);
      RC_ASSERT(other.has_value());
      const auto a = result.values[0][k];
      const auto b = again.values[0][*other];
      RC_ASSERT(a.has_value() == b.has_value());
      if (a && std::abs(*a - *b) > 1e-9 * std::max(1.0, std::abs(*a)))
        RC_FAIL(fmt::format("{}: {} and {} in {}", result.kpis[k].name, *a, *b, text.dump()));
    }
  });
}

namespace {

// Every name of the shop in another order of the alphabet; the old ones stand at /simulation/renamed.
json with_other_names(json text) {
  const std::set<std::string> lists = {"machines", "failures",  "maintenance", "operations",
                                       "stores",   "parts",     "crews",       "calendars",
                                       "spares",   "transport", "inserts",     "tools"};
  std::map<std::string, std::string> names;
  const auto collect = [&](const auto& self, const json& at) -> void {
    for (const auto& [key, value] : at.items()) {
      if (lists.contains(key) && value.is_array())
        for (const json& one : value)
          if (one.is_object() && one.contains("name")) {
            const auto name = one["name"].get<std::string>();
            names[name] = std::string(1, static_cast<char>('z' - name.back() % 26)) + "ew " + name;
          }
      if (value.is_structured()) self(self, value);
    }
  };
  collect(collect, text);
  const auto rename = [&](const auto& self, json& at) -> void {
    for (auto& [key, value] : at.items()) {
      if (value.is_structured())
        self(self, value);
      else if (value.is_string() && key != "kind" && key != "clock" && names.contains(value))
        value = names.at(value);
    }
  };
  for (auto& [key, value] : text.items())
    if (value.is_structured() && key != "simulation") rename(rename, value);
  const auto draws = [&](const std::string& name) {
    for (const char* list : {"machines", "stores", "parts", "spares", "transport", "inserts", "tools"})
      for (const json& one : text.value(list, json::array())) {
        if (one["name"] == name) return true;
        for (const char* stops : {"failures", "maintenance"})
          for (const json& stop : one.value(stops, json::array()))
            if (stop["name"] == name) return true;
      }
    return false;
  };
  for (const auto& [was, name] : names)
    if (draws(name)) text["simulation"]["renamed"].push_back({{"name", name}, {"was", was}});
  return text;
}

// The first value that differs, in words; empty when all bits are the same.
std::string difference(const shop::RunResult& result, const shop::RunResult& renamed) {
  if (result.kpis.size() != renamed.kpis.size()) return "another number of KPIs";
  for (std::size_t k = 0; k < result.kpis.size(); ++k)
    if (result.values[0][k] != renamed.values[0][k])
      return fmt::format("{} = {}, {} = {}", result.kpis[k].name, result.values[0][k].value_or(-1),
                         renamed.kpis[k].name, renamed.values[0][k].value_or(-1));
  return "";
}

}  // namespace

TEST_CASE("other names change no bit when the shop says what they were", "[shop][random]") {
  property("renaming", [] {
    const json text = random_shop();
    const std::string differs = difference(run(text), run(with_other_names(text)));
    if (!differs.empty()) RC_FAIL(differs + " in " + text.dump());
  });
  // Without the old names the numbers are others.
  json plant = scenarios_of("mixed-plant-60");
  plant["simulation"]["replications"] = 1;
  json renamed = with_other_names(plant);
  CHECK(difference(run(plant), run(renamed)) == "");
  renamed["simulation"].erase("renamed");
  CHECK(difference(run(plant), run(renamed)) != "");
}

// Three lathes in one group, or three groups of one with the same names.
TEST_CASE("splitting a group of machines changes no bit", "[shop]") {
  json text = scenarios_of("heavy-lathe");
  json& lathe = text["machines"][0];
  lathe["count"] = 3;
  lathe["name"] = "lathe";
  lathe["failures"] = {{{"name", "drive"},
                        {"clock", "operating"},
                        {"time_to_failure", exponential(900)},
                        {"repair", exponential(40)},
                        {"effect", "after_part"}}};
  for (json& operation : text["operations"]) operation["machine"] = "lathe";
  text["simulation"]["replications"] = 3;
  json split = text;
  split["machines"].clear();
  json names = json::array();
  for (int k = 1; k <= 3; ++k) {
    json one = lathe;
    one.erase("count");
    one["name"] = "lathe " + std::to_string(k);
    names.push_back(one["name"]);
    split["machines"].push_back(one);
  }
  for (json& operation : split["operations"]) {
    operation.erase("machine");
    operation["machines"] = names;
  }
  const auto whole = run(text);
  const auto parts = run(split);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < whole.kpis.size(); ++k) {
    const std::string& name = whole.kpis[k].name;
    if (name.starts_with("queue/") || name.starts_with("limits/")) continue;  // one queue or three
    INFO(whole.kpis[k].name);
    const auto other = parts.index_of(whole.kpis[k].name);
    REQUIRE(other.has_value());
    for (std::size_t r = 0; r < whole.values.size(); ++r)
      CHECK(whole.values[r][k] == parts.values[r][*other]);
    ++compared;
  }
  CHECK(compared > 100);
}
