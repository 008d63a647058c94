#pragma once
// A trace written for other programs, and what can be read off it.

#include <ostream>
#include <string>
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

/// Names of all machines of the scenario, one by one, in the order of the trace.
[[nodiscard]] std::vector<std::string> machine_names(const scenarios::Scenario& scenario);

/// {"machines": [{"name", "group", "bottleneck", "intervals": [[from_min, to_min, "state"], ...]}], "queues",
/// "parts", "edges"}
void write_json(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// One row per state interval: machine,state,from_min,to_min
void write_csv(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// Trace Event Format: opens in Perfetto and chrome://tracing; one minute is shown as one second.
void write_chrome(std::ostream& out, const scenarios::Scenario& scenario, const Trace& trace);
/// The shop as a graph for Graphviz: machine groups, stores, and the ways parts take.
void write_graphviz(std::ostream& out, const scenarios::Scenario& scenario);

}  // namespace verstat::shop
