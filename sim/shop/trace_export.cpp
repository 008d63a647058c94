#include "sim/shop/trace_export.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/route.h"
#include "sim/shop/kpis.h"

namespace verstat::shop {

using nlohmann::ordered_json;

std::vector<std::vector<StateInterval>> state_intervals(const Trace& trace, std::size_t machines,
                                                        double horizon_min) {
  std::vector<std::vector<StateInterval>> intervals(machines, {{0, horizon_min, MachineState::idle}});
  for (const Trace::StateChange& change : trace.states()) {
    auto& own = intervals[change.machine];
    own.back().to_min = change.at_min;
    if (own.back().to_min == own.back().from_min) own.pop_back();  // a state that took no time
    own.push_back({change.at_min, horizon_min, change.state});
  }
  return intervals;
}

std::vector<BottleneckShare> shifting_bottleneck(const std::vector<std::vector<StateInterval>>& intervals,
                                                 double from_min, double to_min) {
  struct Active {
    double from_min;
    double to_min;
    std::size_t machine;
  };
  // Uninterrupted active periods, over the whole time: one that reaches into the window counts with all its
  // length.
  std::vector<Active> periods;
  for (std::size_t m = 0; m < intervals.size(); ++m) {
    bool open = false;
    for (const StateInterval& interval : intervals[m]) {
      if (is_passive(interval.state)) {
        open = false;
      } else if (open) {
        periods.back().to_min = interval.to_min;
      } else {
        periods.push_back({interval.from_min, interval.to_min, m});
        open = true;
      }
    }
  }
  std::erase_if(periods, [&](const Active& p) { return p.to_min <= from_min || p.from_min >= to_min; });
  std::stable_sort(periods.begin(), periods.end(),
                   [](const Active& a, const Active& b) { return a.from_min < b.from_min; });

  // The chain of bottlenecks: from the longest period at the start, each time to the longest of those that
  // are active when the present one ends, if it is longer than nothing; where none is active, time without
  // one.
  std::vector<BottleneckShare> shares(intervals.size());
  const auto longest_at = [&](double time_min) -> const Active* {
    const Active* best = nullptr;
    for (const Active& p : periods) {
      if (p.from_min > time_min) break;
      if (p.to_min > time_min && (best == nullptr || p.to_min - p.from_min > best->to_min - best->from_min))
        best = &p;
    }
    return best;
  };
  std::vector<const Active*> chain;
  for (double at = from_min; at < to_min;) {
    if (const Active* now = longest_at(at)) {
      if (chain.empty() || chain.back() != now) chain.push_back(now);
      at = now->to_min;
      continue;
    }
    const auto next =
        std::find_if(periods.begin(), periods.end(), [&](const Active& p) { return p.from_min > at; });
    if (next == periods.end()) break;
    at = next->from_min;
  }
  for (std::size_t k = 0; k < chain.size(); ++k) {
    double begin = std::max(from_min, chain[k]->from_min);
    double end = std::min(to_min, chain[k]->to_min);
    double shifting = 0;
    if (k > 0 && chain[k - 1]->to_min > begin) {
      const double until = std::min(end, chain[k - 1]->to_min);
      shifting += until - begin;
      begin = until;
    }
    if (k + 1 < chain.size() && chain[k + 1]->from_min < end) {
      const double since = std::max(begin, chain[k + 1]->from_min);
      shifting += end - since;
      end = since;
    }
    shares[chain[k]->machine].sole += (end - begin) / (to_min - from_min);
    shares[chain[k]->machine].shifting += shifting / (to_min - from_min);
  }
  return shares;
}

std::vector<std::string> machine_names(const scenarios::Scenario& scenario) {
  std::vector<std::string> names;
  for (const scenarios::Machine& machine : scenario.machines)
    for (std::int64_t k = 0; k < machine.count; ++k) names.push_back(machine_name(machine, k));
  return names;
}

void write_json(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace) {
  const double horizon_min = scenario.simulation.horizon_min;
  const std::vector<std::string> names = machine_names(scenario);
  const auto intervals = state_intervals(trace, names.size(), horizon_min);
  const auto shares = shifting_bottleneck(intervals, scenario.simulation.warmup_min, horizon_min);
  ordered_json document = {{"scenario", scenario.name},
                           {"warmup_min", scenario.simulation.warmup_min},
                           {"horizon_min", horizon_min}};
  std::vector<std::string> groups;
  for (const scenarios::Machine& machine : scenario.machines)
    groups.insert(groups.end(), static_cast<std::size_t>(machine.count), machine.name);
  document["machines"] = ordered_json::array();
  for (std::size_t m = 0; m < names.size(); ++m) {
    ordered_json rows = ordered_json::array();
    for (const StateInterval& i : intervals[m]) rows.push_back({i.from_min, i.to_min, name_of(i.state)});
    document["machines"].push_back(
        {{"name", names[m]},
         {"group", groups[m]},
         {"bottleneck", {{"sole", shares[m].sole}, {"shifting", shares[m].shifting}}},
         {"intervals", std::move(rows)}});
  }
  document["steps"] = ordered_json::array();
  for (const Trace::PartStep& s : trace.part_steps())
    document["steps"].push_back({scenario.parts[s.part].name, s.step, names[s.machine], s.at_min});
  document["queues"] = ordered_json::array();
  for (const Trace::QueueLength& q : trace.queues())
    document["queues"].push_back({scenario.machines[q.group].name, q.at_min, q.waiting});
  document["parts"] = ordered_json::array();
  for (const Trace::Finished& p : trace.finished())
    document["parts"].push_back({scenario.parts[p.part].name, p.arrived_min, p.finished_min});
  document["edges"] = ordered_json::array();
  for (const Trace::EdgeRemoved& e : trace.edges())
    document["edges"].push_back({scenario.tools[e.tool].name, names[e.machine], e.at_min, e.life_min,
                                 e.failed ? "failed" : "planned"});
  out << document.dump() << '\n';
}

namespace {
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}
}  // namespace

void write_csv(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace) {
  const std::vector<std::string> names = machine_names(scenario);
  out << "machine,state,from_min,to_min\n";
  const auto intervals = state_intervals(trace, names.size(), scenario.simulation.horizon_min);
  for (std::size_t m = 0; m < names.size(); ++m)
    for (const StateInterval& i : intervals[m])
      out << fmt::format("{},{},{},{}\n", csv_text(names[m]), name_of(i.state), i.from_min, i.to_min);
}

void write_chrome(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace) {
  const std::vector<std::string> names = machine_names(scenario);
  const auto intervals = state_intervals(trace, names.size(), scenario.simulation.horizon_min);
  constexpr double shown_us_per_min = 1e6;
  out << "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[";
  bool first = true;
  const auto put = [&](const ordered_json& event) {
    out << (first ? "\n" : ",\n") << event.dump();
    first = false;
  };
  for (std::size_t m = 0; m < names.size(); ++m) {
    put({{"ph", "M"}, {"pid", 1}, {"tid", m}, {"name", "thread_name"}, {"args", {{"name", names[m]}}}});
    for (const StateInterval& i : intervals[m])
      put({{"ph", "X"},
           {"pid", 1},
           {"tid", m},
           {"name", name_of(i.state)},
           {"ts", i.from_min * shown_us_per_min},
           {"dur", (i.to_min - i.from_min) * shown_us_per_min}});
  }
  for (const Trace::QueueLength& q : trace.queues())
    put({{"ph", "C"},
         {"pid", 1},
         {"name", "queue of " + scenario.machines[q.group].name},
         {"ts", q.at_min * shown_us_per_min},
         {"args", {{"batches", q.waiting}}}});
  out << "\n]}\n";
}

void write_graphviz(std::ostream& out, const scenarios::Scenario& scenario) {
  const auto quoted = [](const std::string& text) { return ordered_json(text).dump(); };
  out << "digraph shop {\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\"];\n";
  for (const scenarios::Machine& machine : scenario.machines)
    out << fmt::format(
        "  {} [label={}];\n", quoted("machine " + machine.name),
        quoted(machine.count == 1 ? machine.name : fmt::format("{} x {}", machine.count, machine.name)));
  for (const scenarios::Store& store : scenario.stores)
    out << fmt::format("  {} [label={}, shape=cylinder];\n", quoted("store " + store.name),
                       quoted(store.name));
  std::map<std::pair<std::string, std::string>, std::set<std::string>> ways;
  for (const scenarios::PartType& part : scenario.parts) {
    const scenarios::Route route = scenarios::route_of(scenario, part);
    const auto places = [&](std::size_t step) {
      std::vector<std::string> names;
      if (step == scenarios::route_end) return std::vector<std::string>{"store " + part.store};
      for (const std::size_t g : scenarios::groups_of(scenario, scenario.operations[route[step].operation]))
        names.push_back("machine " + scenario.machines[g].name);
      return names;
    };
    const auto connect = [&](std::size_t from, std::size_t to, const std::string& label) {
      for (const std::string& a : places(from))
        for (const std::string& b : places(to)) ways[{a, b}].insert(label);
    };
    for (std::size_t k = 0; k < route.size(); ++k) {
      for (const scenarios::RouteBranch& branch : route[k].next) connect(k, branch.to, part.name);
      if (route[k].rework != scenarios::route_end) connect(k, route[k].rework, part.name + " (rework)");
      for (const scenarios::RouteComponent& c : route[k].assembles)
        for (const std::string& b : places(k))
          ways[{"store " + scenario.parts[c.part].store, b}].insert(scenario.parts[c.part].name);
    }
  }
  for (const auto& [way, labels] : ways) {
    std::string label;
    for (const std::string& one : labels) label += (label.empty() ? "" : "\n") + one;
    out << fmt::format("  {} -> {} [label={}];\n", quoted(way.first), quoted(way.second), quoted(label));
  }
  out << "}\n";
}

}  // namespace verstat::shop
