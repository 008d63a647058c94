#pragma once
// A trace written for other programs, and what can be read off it.

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario.h"
#include "sim/shop/trace.h"

namespace verstat::shop {

/// One time in which a machine stays in one state.
struct StateInterval {
  double from_min;
  double to_min;
  MachineState state;
};
/// State intervals of every machine from 0 to `horizon_min`, without gaps.
[[nodiscard]] std::vector<std::vector<StateInterval>> state_intervals(const Trace& trace,
                                                                      std::size_t machines,
                                                                      double horizon_min);

/// Shifting bottleneck (Roser, Nakano, Tanaka, Winter Simulation Conference 2002): at any time the machine
/// with the longest uninterrupted active period is the bottleneck; where two such periods overlap, the
/// bottleneck shifts from one machine to the other.
struct BottleneckShare {
  double sole = 0;      ///< share of the time as the only bottleneck
  double shifting = 0;  ///< share of the time in a shift to or from another machine
};
[[nodiscard]] std::vector<BottleneckShare> shifting_bottleneck(
    const std::vector<std::vector<StateInterval>>& intervals, double from_min, double to_min);

/// One time in which a member of a crew does one thing.
struct CrewInterval {
  double from_min;
  double to_min;
  std::string_view doing;  ///< heading of the work; "tending", "free", "off_shift"
  std::optional<std::size_t> machine;
};
/// A member of a crew; of a member who tends several machines, one hand.
struct CrewRow {
  std::string name;
  std::size_t crew;
  std::vector<CrewInterval> intervals;  ///< from 0 to the horizon, without gaps
};
/// Who did what, member by member. Members of a crew are alike: work is given to the first who is free.
[[nodiscard]] std::vector<CrewRow> crew_rows(const scenarios::Scenario& scenario, const Trace& trace);

/// Names of all machines of the scenario, one by one, in the order of the trace.
[[nodiscard]] std::vector<std::string> machine_names(const scenarios::Scenario& scenario);

/// {"machines": [{"name", "group", "calendar", "bottleneck", "intervals": [[from_min, to_min, "state"],
/// ...]}], "crews": [{"name", "crew", "calendar", "intervals": [[from_min, to_min, "doing", "machine"],
/// ...]}], "shifts": {calendar: [{"days": [0 (Monday), ...], "from_h", "to_h"}]}, "queues", "parts", "edges"}
void write_json(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// The same for pages that draw it, a quarter as long and written as it is read: times rounded to 0.0001 min,
/// states by their place in "states", intervals by their ends. {"states": [...], "machines": [{"name",
/// "group", "calendar", "until": [...], "state": [...]}], "crews": [{..., "machine": [place in "machines" or
/// -1]}], "queues": [{"name", "at", "waiting"}], "parts": {"arrived", "finished"}, "shifts", "edges"}
void write_compact(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// One row per interval of a machine or of a member of a crew: kind,name,state,from_min,to_min,machine
void write_csv(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// Trace Event Format: opens in Perfetto and chrome://tracing; one minute is shown as one second.
void write_chrome(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// The shop as a graph for Graphviz: machine groups, stores, and the ways parts take.
void write_graphviz(std::ostream& out, const scenarios::Scenario& scenario);

}  // namespace verstat::shop
