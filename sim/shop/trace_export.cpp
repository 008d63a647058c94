#include "sim/shop/trace_export.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "scenarios/calendar.h"
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

namespace {

// Times in which nobody works: on shift they are free.
void fill(CrewRow& row, double from_min, double to_min, const scenarios::WorkingTime* working_time) {
  for (double at = from_min; at < to_min;) {
    const bool open = working_time == nullptr || working_time->open(at);
    const double next =
        working_time == nullptr ? to_min : std::min(to_min, working_time->next_change_min(at));
    row.intervals.push_back({at, next, open ? "free" : "off_shift", std::nullopt});
    at = next;
  }
}

}  // namespace

std::vector<CrewRow> crew_rows(const scenarios::Scenario& scenario, const Trace& trace) {
  const double horizon_min = scenario.simulation.horizon_min;
  std::vector<std::vector<Trace::CrewWork>> work(scenario.crews.size());
  for (const Trace::CrewWork& w : trace.crew_work()) work[w.crew].push_back(w);
  std::vector<CrewRow> all;
  for (std::size_t k = 0; k < scenario.crews.size(); ++k) {
    const scenarios::Crew& crew = scenario.crews[k];
    std::optional<scenarios::WorkingTime> working_time;
    if (const auto* calendar = scenarios::find_named(scenario.calendars, crew.calendar))
      working_time.emplace(*calendar);
    const auto* open = working_time ? &*working_time : nullptr;
    std::vector<CrewRow> rows;
    for (std::int64_t m = 1; m <= crew.members; ++m)
      for (std::int64_t hand = 1; hand <= crew.machines_per_member; ++hand) {
        std::string name = crew.name;
        if (crew.members > 1 || crew.machines_per_member > 1) name += fmt::format(" {}", m);
        if (crew.machines_per_member > 1) name += fmt::format(".{}", hand);
        rows.push_back({std::move(name), k, {}});
      }
    std::vector<double> busy_until(rows.size(), 0);
    std::stable_sort(work[k].begin(), work[k].end(),
                     [](const auto& a, const auto& b) { return a.from_min < b.from_min; });
    for (const Trace::CrewWork& w : work[k]) {
      std::int64_t needed = w.hands;
      for (std::size_t r = 0; r < rows.size() && needed > 0; ++r) {
        if (busy_until[r] > w.from_min) continue;
        fill(rows[r], busy_until[r], w.from_min, open);
        rows[r].intervals.push_back(
            {w.from_min, w.to_min, w.heading == Cost::labour ? "tending" : name_of(w.heading), w.machine});
        busy_until[r] = w.to_min;
        --needed;
      }
      if (needed > 0) throw std::logic_error(fmt::format("crew {} has more work than hands", crew.name));
    }
    for (std::size_t r = 0; r < rows.size(); ++r) fill(rows[r], busy_until[r], horizon_min, open);
    std::move(rows.begin(), rows.end(), std::back_inserter(all));
  }
  return all;
}

std::vector<std::string> machine_names(const scenarios::Scenario& scenario) {
  std::vector<std::string> names;
  for (const scenarios::Machine& machine : scenario.machines)
    for (std::int64_t k = 0; k < machine.count; ++k) names.push_back(machine_name(machine, k));
  return names;
}

namespace {

ordered_json calendar_of(const std::string& name) {
  return name.empty() ? ordered_json(nullptr) : ordered_json(name);
}

// The shifts of every calendar, days counted from Monday.
ordered_json shifts_json(const scenarios::Scenario& scenario) {
  ordered_json all = ordered_json::object();
  for (const scenarios::Calendar& calendar : scenario.calendars) {
    ordered_json shifts = ordered_json::array();
    for (const scenarios::Shift& shift : calendar.shifts) {
      ordered_json days = ordered_json::array();
      for (const scenarios::Weekday day : shift.days) days.push_back(static_cast<int>(day));
      shifts.push_back({{"days", std::move(days)}, {"from_h", shift.from_h}, {"to_h", shift.to_h}});
    }
    all[calendar.name] = std::move(shifts);
  }
  return all;
}

std::string quoted(const std::string& text) {
  return ordered_json(text).dump();
}

// [a,b,c] of what `value` makes of each entry.
template <class Range, class Value>
void write_list(std::ostream& out, const Range& range, Value&& value) {
  out << '[';
  bool first = true;
  for (const auto& entry : range) {
    if (!first) out << ',';
    out << fmt::format("{}", value(entry));
    first = false;
  }
  out << ']';
}

double rounded(double time_min) {
  return std::round(time_min * 1e4) / 1e4;
}

}  // namespace

void write_compact(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace) {
  const std::vector<std::string> names = machine_names(scenario);
  const auto intervals = state_intervals(trace, names.size(), scenario.simulation.horizon_min);
  const std::vector<CrewRow> crews = crew_rows(scenario, trace);
  std::vector<std::string_view> states;
  const auto place_of = [&](std::string_view state) {
    const auto found = std::find(states.begin(), states.end(), state);
    const auto place = static_cast<std::size_t>(found - states.begin());
    if (found == states.end()) states.push_back(state);
    return place;
  };
  const auto until = [](const auto& interval) { return rounded(interval.to_min); };
  out << fmt::format("{{\"scenario\":{},\"warmup_min\":{},\"horizon_min\":{},\n\"machines\":[",
                     quoted(scenario.name), scenario.simulation.warmup_min, scenario.simulation.horizon_min);
  std::size_t m = 0;
  for (const scenarios::Machine& machine : scenario.machines)
    for (std::int64_t k = 0; k < machine.count; ++k, ++m) {
      out << fmt::format("{}\n{{\"name\":{},\"group\":{},\"calendar\":{},\"until\":", m == 0 ? "" : ",",
                         quoted(names[m]), quoted(machine.name), calendar_of(machine.calendar).dump());
      write_list(out, intervals[m], until);
      out << ",\"state\":";
      write_list(out, intervals[m], [&](const StateInterval& i) { return place_of(name_of(i.state)); });
      out << '}';
    }
  out << "],\n\"crews\":[";
  for (std::size_t r = 0; r < crews.size(); ++r) {
    const scenarios::Crew& crew = scenario.crews[crews[r].crew];
    out << fmt::format("{}\n{{\"name\":{},\"crew\":{},\"calendar\":{},\"until\":", r == 0 ? "" : ",",
                       quoted(crews[r].name), quoted(crew.name), calendar_of(crew.calendar).dump());
    write_list(out, crews[r].intervals, until);
    out << ",\"state\":";
    write_list(out, crews[r].intervals, [&](const CrewInterval& i) { return place_of(i.doing); });
    out << ",\"machine\":";
    write_list(out, crews[r].intervals,
               [](const CrewInterval& i) { return i.machine ? static_cast<std::int64_t>(*i.machine) : -1; });
    out << '}';
  }
  out << "],\n\"states\":" << ordered_json(states).dump() << ",\n\"shifts\":" << shifts_json(scenario).dump();
  out << ",\n\"queues\":[";
  std::vector<std::vector<Trace::QueueLength>> queues(scenario.machines.size());
  for (const Trace::QueueLength& q : trace.queues()) queues[q.group].push_back(q);
  bool first = true;
  for (std::size_t g = 0; g < queues.size(); ++g) {
    if (queues[g].empty()) continue;
    out << fmt::format("{}\n{{\"name\":{},\"at\":", first ? "" : ",", quoted(scenario.machines[g].name));
    first = false;
    write_list(out, queues[g], [](const Trace::QueueLength& q) { return rounded(q.at_min); });
    out << ",\"waiting\":";
    write_list(out, queues[g], [](const Trace::QueueLength& q) { return q.waiting; });
    out << '}';
  }
  out << "],\n\"parts\":{\"arrived\":";
  write_list(out, trace.finished(), [](const Trace::Finished& p) { return rounded(p.arrived_min); });
  out << ",\"finished\":";
  write_list(out, trace.finished(), [](const Trace::Finished& p) { return rounded(p.finished_min); });
  out << "},\n\"edges\":";
  write_list(out, trace.edges(), [&](const Trace::EdgeRemoved& e) {
    return fmt::format("[{},{},{},{},\"{}\"]", quoted(scenario.tools[e.tool].name), quoted(names[e.machine]),
                       rounded(e.at_min), rounded(e.life_min), e.failed ? "failed" : "planned");
  });
  out << "}\n";
}

void write_json(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace) {
  const double horizon_min = scenario.simulation.horizon_min;
  const std::vector<std::string> names = machine_names(scenario);
  const auto intervals = state_intervals(trace, names.size(), horizon_min);
  const auto shares = shifting_bottleneck(intervals, scenario.simulation.warmup_min, horizon_min);
  ordered_json document = {{"scenario", scenario.name},
                           {"warmup_min", scenario.simulation.warmup_min},
                           {"horizon_min", horizon_min}};
  std::vector<const scenarios::Machine*> groups;
  for (const scenarios::Machine& machine : scenario.machines)
    groups.insert(groups.end(), static_cast<std::size_t>(machine.count), &machine);
  document["machines"] = ordered_json::array();
  for (std::size_t m = 0; m < names.size(); ++m) {
    ordered_json rows = ordered_json::array();
    for (const StateInterval& i : intervals[m]) rows.push_back({i.from_min, i.to_min, name_of(i.state)});
    document["machines"].push_back(
        {{"name", names[m]},
         {"group", groups[m]->name},
         {"calendar", calendar_of(groups[m]->calendar)},
         {"bottleneck", {{"sole", shares[m].sole}, {"shifting", shares[m].shifting}}},
         {"intervals", std::move(rows)}});
  }
  document["crews"] = ordered_json::array();
  for (const CrewRow& row : crew_rows(scenario, trace)) {
    ordered_json rows = ordered_json::array();
    for (const CrewInterval& i : row.intervals) {
      rows.push_back({i.from_min, i.to_min, i.doing});
      if (i.machine) rows.back().push_back(names[*i.machine]);
    }
    const scenarios::Crew& crew = scenario.crews[row.crew];
    document["crews"].push_back({{"name", row.name},
                                 {"crew", crew.name},
                                 {"calendar", calendar_of(crew.calendar)},
                                 {"intervals", std::move(rows)}});
  }
  document["shifts"] = shifts_json(scenario);
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
  out << "kind,name,state,from_min,to_min,machine\n";
  const auto intervals = state_intervals(trace, names.size(), scenario.simulation.horizon_min);
  for (std::size_t m = 0; m < names.size(); ++m)
    for (const StateInterval& i : intervals[m])
      out << fmt::format("machine,{0},{1},{2},{3},{0}\n", csv_text(names[m]), name_of(i.state), i.from_min,
                         i.to_min);
  for (const CrewRow& row : crew_rows(scenario, trace))
    for (const CrewInterval& i : row.intervals)
      out << fmt::format("crew,{},{},{},{},{}\n", csv_text(row.name), i.doing, i.from_min, i.to_min,
                         i.machine ? csv_text(names[*i.machine]) : "");
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
  for (const auto& [pid, name] : {std::pair{1, "machines"}, std::pair{2, "crews"}})
    put({{"ph", "M"}, {"pid", pid}, {"name", "process_name"}, {"args", {{"name", name}}}});
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
  const std::vector<CrewRow> crews = crew_rows(scenario, trace);
  for (std::size_t r = 0; r < crews.size(); ++r) {
    put({{"ph", "M"}, {"pid", 2}, {"tid", r}, {"name", "thread_name"}, {"args", {{"name", crews[r].name}}}});
    for (const CrewInterval& i : crews[r].intervals)
      put({{"ph", "X"},
           {"pid", 2},
           {"tid", r},
           {"name", i.doing},
           {"ts", i.from_min * shown_us_per_min},
           {"dur", (i.to_min - i.from_min) * shown_us_per_min},
           {"args", {{"machine", i.machine ? names[*i.machine] : ""}}}});
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
