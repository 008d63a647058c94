// KPIs of tools and inserts.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "sim/kernel/output_analysis.h"
#include "sim/shop/shop_parts.h"

namespace verstat::shop {

namespace {

// Fewest events for which `enough(intervals that stay within, all intervals)`; none without a whole interval.
template <class Enough>
std::optional<double> events_for(const std::vector<const IntervalCount*>& counts, Enough&& enough) {
  std::int64_t intervals = 0;
  std::size_t most = 0;
  for (const IntervalCount* count : counts) {
    intervals += count->intervals();
    most = std::max(most, count->most_events());
  }
  if (intervals == 0) return std::nullopt;
  for (std::size_t events = 0; events < most; ++events) {
    std::int64_t within = 0;
    for (const IntervalCount* count : counts) within += count->at_most(events);
    if (enough(within, intervals)) return static_cast<double>(events);
  }
  return enough(intervals, intervals) ? std::optional(static_cast<double>(most)) : std::nullopt;
}
auto share_of(double target) {
  return [target](std::int64_t within, std::int64_t all) {
    return static_cast<double>(within) >= target * static_cast<double>(all);
  };
}

}  // namespace

void Shop::tool_kpis(double finished, const KpiSink& sink) const {
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const ToolCounts& counts = tools_[t];
    const scenarios::Tool& spec = scenario_.tools[t];
    std::array<double, machine_states> state_min{};
    const auto places = static_cast<double>(mounted_[t].size());
    std::int64_t intervals = 0;
    std::int64_t quiet = 0;
    std::vector<const IntervalCount*> changes;
    for (const MountedTool* tool : mounted_[t]) {
      for (std::size_t s = 0; s < machine_states; ++s)
        state_min[s] += tool->clock.time_min(static_cast<MachineState>(s));
      intervals += tool->stops.intervals();
      quiet += tool->stops.at_most(0);
      changes.push_back(&tool->changes);
    }
    const auto in = [&](MachineState s) { return state_min[static_cast<std::size_t>(s)]; };
    const double cutting_min = in(MachineState::cutting);
    const double waiting_min = in(MachineState::waiting_crew);
    const double changing_min = in(MachineState::planned_change) + in(MachineState::failure_change);
    const double engaged_min = cutting_min + changing_min + waiting_min + in(MachineState::waiting_tool) +
                               in(MachineState::tool_swap);
    const auto planned = static_cast<double>(counts.planned_changes);
    const auto failures = static_cast<double>(counts.failures);
    const auto put = [&](const std::string& name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("tool/{}/{}", spec.name, name), unit, meaning}, value);
    };
    const auto count = [&](const char* name, const char* meaning, auto value) {
      put(name, "1", meaning, static_cast<double>(value));
    };
    put("insert_cycle_availability", "1",
        "cutting / (cutting + changing + waiting for crew and tools + swapping); K_r of K117",
        ratio(cutting_min, engaged_min));
    put("waiting_crew_share", "1", "waiting for the crew / the same sum", ratio(waiting_min, engaged_min));
    if (mounted_[t].size() > 1)
      for (const MountedTool* tool : mounted_[t])
        put("on/" + machines_[tool->machine]->name + "/insert_cycle_availability", "1",
            "K_r of this insert position alone", cycle_availability(*tool));
    count("planned_changes", "changes as planned", planned);
    count("failures", "changes after a failure in the cut", failures);
    put("failure_share", "1", "failures / all changes", ratio(failures, planned + failures));
    put("edge_use_min", "min", "mean cutting time of the edges taken out",
        ratio(counts.edge_minutes_used, static_cast<double>(counts.edges_used)));
    count("inserts_fitted", "new inserts fitted", counts.inserts_fitted);
    put("inserts_per_100_parts", "1/100 parts", "new inserts fitted per 100 parts finished",
        ratio(100 * static_cast<double>(counts.inserts_fitted), finished));
    put("waiting_tool_share", "1", "waiting for a sister tool or for inserts / the same sum",
        ratio(in(MachineState::waiting_tool), engaged_min));
    count("teeth_failed", "teeth that failed in the cut", counts.teeth_failed);
    count("edges_unspent", "edges taken out before they failed", counts.edges_unspent);
    put("life_left_share", "1", "mean share of life left in the edges taken out before they failed",
        ratio(counts.life_left, static_cast<double>(counts.edges_unspent)));
    count("waits", "times a machine waited for a sister tool or for inserts", counts.waits);
    put("no_stop_share", "1", "share of unattended intervals in which the tool did not stop its machine",
        ratio(static_cast<double>(quiet), static_cast<double>(intervals)));
    put("sisters_needed", "1",
        "changes of the tool that the wanted share of unattended intervals stays within: so many sister "
        "tools when none comes back in the interval",
        events_for(changes, share_of(spec.unattended_target)));
    put("sisters_needed_surely", "1",
        "the same with 95 % confidence: Wilson's lower bound of the share reaches what is wanted; none: too "
        "few intervals were counted",
        events_for(changes, [&](std::int64_t within, std::int64_t all) {
          return sim::wilson_interval(within, all, 0.9).low >= spec.unattended_target;  // 0.9 two-sided
        }));
    count("unattended/intervals", "unattended intervals counted", intervals);
    count("unattended/quiet", "of those, without a stop of the tool", quiet);
    const auto sure = intervals > 0 ? std::optional(sim::wilson_interval(quiet, intervals)) : std::nullopt;
    put("unattended/no_stop_low", "1",
        "lower end of Wilson's 95 % interval of no_stop_share, all intervals of all replications together",
        sure ? std::optional(sure->low) : std::nullopt);
    put("unattended/no_stop_high", "1", "its upper end", sure ? std::optional(sure->high) : std::nullopt);
    count("edges/at_start", "usable edges in the tools at the start of the counted time",
          counts.edges_at_start);
    count("edges/fitted", "usable edges that came with new inserts", counts.edges_fitted);
    count("edges/reground", "edges that regrinding brought back", counts.edges_reground);
    count("edges/used", "edges taken out after use", counts.edges_used);
    count("edges/discarded", "usable edges that a failure broke before their use", counts.edges_discarded);
    count("edges/at_end", "usable edges in the tools at the end", edges_in_tools(t));
    double other_min = places * window_min();
    for (const MachineState state :
         {MachineState::cutting, MachineState::planned_change, MachineState::failure_change,
          MachineState::waiting_crew, MachineState::waiting_tool, MachineState::tool_swap,
          MachineState::idle}) {
      other_min -= in(state);
      put(fmt::format("state/{}", name_of(state)), "1",
          "share of the time, mean over the machines that hold the tool",
          ratio(in(state), places * window_min()));
    }
    put("state/other", "1", "share of the time in other stops of the machine and outside its calendar",
        ratio(other_min > 1e-9 * window_min() ? other_min : 0, places * window_min()));  // no rounding crumbs
    if (std::holds_alternative<scenarios::ConditionBased>(spec.strategy)) {
      count("inspections", "inspections of edges", counts.inspections);
      count("worn_found", "inspections that found a worn edge", counts.worn_found);
      count("false_alarms", "inspections that took a good edge for a worn one", counts.false_alarms);
    }
    if (std::holds_alternative<scenarios::Opportunistic>(spec.strategy))
      count("joined_changes", "planned changes made at another stop of the machine", counts.joined_changes);
    if (spec.regrind) count("regrinds", "times the tool was reground", counts.regrinds);
    for (std::size_t k = 0; k < spec.elements.size(); ++k) {
      double element_changes = 0;
      double use_min = 0;
      for (const MountedTool* tool : mounted_[t]) {
        element_changes += static_cast<double>(tool->elements[k].changes);
        use_min += tool->elements[k].use_min_sum;
      }
      const std::string& name = spec.elements[k].element;
      put(fmt::format("element/{}/changes", name), "1", "changes of this element", element_changes);
      put(fmt::format("element/{}/use_min", name), "min", "mean cutting time between its changes",
          ratio(use_min, element_changes));
      put(fmt::format("element/{}/per_100_parts", name), "1/100 parts", "changes per 100 parts finished",
          ratio(100 * element_changes, finished));
    }
  }
}

// K_r of one position: cutting over all the time that the edge takes.
std::optional<double> Shop::cycle_availability(const MountedTool& tool) {
  double engaged_min = 0;
  for (const MachineState state :
       {MachineState::cutting, MachineState::planned_change, MachineState::failure_change,
        MachineState::waiting_crew, MachineState::waiting_tool, MachineState::tool_swap})
    engaged_min += tool.clock.time_min(state);
  return ratio(tool.clock.time_min(MachineState::cutting), engaged_min);
}

void Shop::insert_kpis(double finished, const KpiSink& sink) const {
  const auto forecast = [&](const std::string& whose, double fitted, const IntervalCount& weeks) {
    sink(KpiInfo{whose + "consumption_per_week", "1/week", "new inserts fitted per calendar week"},
         fitted * week_min / window_min());
    sink(KpiInfo{whose + "consumption_week_p90", "1/week",
                 "inserts that last through 90 % of the weeks; none: the counted time has no whole week"},
         events_for({&weeks}, share_of(0.9)));
  };
  for (std::size_t i = 0; i < scenario_.inserts.size(); ++i) {
    const std::string& name = scenario_.inserts[i].name;
    const auto put = [&](const char* kpi, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("insert/{}/{}", name, kpi), unit, meaning}, value);
    };
    double fitted = 0;
    for (std::size_t t = 0; t < tools_.size(); ++t)
      if (scenario_.tools[t].insert == name) fitted += static_cast<double>(tools_[t].inserts_fitted);
    put("consumption", "1", "new inserts fitted in all tools in the counted time", fitted);
    put("consumption_per_100_parts", "1/100 parts", "the same per 100 parts finished",
        ratio(100 * fitted, finished));
    forecast(fmt::format("insert/{}/", name), fitted, weeks_of_insert_[i]);
    if (const InsertCrib* crib = cribs_[i].get()) {
      const InsertCrib::Counts& counts = crib->counts();
      put("crib/stock_at_start", "1", "inserts on the shelf at the start of the counted time",
          static_cast<double>(counts.stock_at_start));
      put("crib/delivered", "1", "inserts that orders brought", static_cast<double>(counts.delivered));
      put("crib/issued", "1", "inserts handed out", static_cast<double>(counts.issued));
      put("crib/stock_at_end", "1", "inserts on the shelf at the end", static_cast<double>(crib->stock()));
      put("crib/mean_stock", "1", "mean number of inserts on the shelf", crib->mean_stock());
      put("crib/stock_outs", "1", "requests that had to wait", static_cast<double>(counts.stock_outs));
      put("crib/stock_out_share", "1", "requests that had to wait / all requests",
          ratio(static_cast<double>(counts.stock_outs), static_cast<double>(counts.requests)));
    }
    if (const LotSource* lots = lots_[i].get()) {
      put("lots/tested", "1", "lots whose sample was tested", static_cast<double>(lots->counts().tested));
      put("lots/rejected", "1", "lots that were sent back or treated",
          static_cast<double>(lots->counts().rejected));
    }
  }
  for (const Grade& grade : grades_) {
    double fitted = 0;
    for (std::size_t t = 0; t < tools_.size(); ++t)
      if (grade_of_tool_[t] == &grade) fitted += static_cast<double>(tools_[t].inserts_fitted);
    sink(KpiInfo{fmt::format("grade/{}/consumption", grade.name), "1",
                 "new inserts of this grade fitted in the counted time"},
         fitted);
    forecast(fmt::format("grade/{}/", grade.name), fitted, grade.weeks);
  }
}

}  // namespace verstat::shop
