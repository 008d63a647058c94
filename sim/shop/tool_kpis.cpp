// KPIs of tools and inserts.
#include <fmt/format.h>

#include "sim/shop/shop_parts.h"

namespace verstat::shop {

void Shop::tool_kpis(double finished, const KpiSink& sink) const {
  for (std::size_t t = 0; t < tools_.size(); ++t) {
    const ToolCounts& counts = tools_[t];
    double cutting_min = 0;
    double changing_min = 0;
    double waiting_min = 0;
    for (const auto& machine : machines_)
      for (const auto& [name, tool] : machine->tools) {
        if (tool->index != t) continue;
        cutting_min += tool->clock.time_min(MachineState::cutting);
        waiting_min += tool->clock.time_min(MachineState::waiting_crew);
        changing_min += tool->clock.time_min(MachineState::planned_change) +
                        tool->clock.time_min(MachineState::failure_change);
      }
    const auto planned = static_cast<double>(counts.planned_changes);
    const auto failures = static_cast<double>(counts.failures);
    const auto put = [&](const char* name, const char* unit, const char* meaning,
                         std::optional<double> value) {
      sink(KpiInfo{fmt::format("tool/{}/{}", scenario_.tools[t].name, name), unit, meaning}, value);
    };
    put("insert_cycle_availability", "1",
        "cutting / (cutting + changing + waiting for the crew); K_r of K117",
        ratio(cutting_min, cutting_min + changing_min + waiting_min));
    put("waiting_crew_share", "1", "waiting for the crew / (cutting + changing + waiting)",
        ratio(waiting_min, cutting_min + changing_min + waiting_min));
    put("planned_changes", "1", "edges changed as planned", planned);
    put("failures", "1", "edges that failed in the cut", failures);
    put("failure_share", "1", "failures / all changes", ratio(failures, planned + failures));
    put("edge_use_min", "min", "mean cutting time of the edges taken out",
        ratio(counts.edge_minutes_used, static_cast<double>(counts.edges_used)));
    put("inserts_fitted", "1", "new inserts fitted", static_cast<double>(counts.inserts_fitted));
    put("inserts_per_100_parts", "1/100 parts", "new inserts fitted per 100 parts finished",
        ratio(100 * static_cast<double>(counts.inserts_fitted), finished));
  }
}

}  // namespace verstat::shop
