#include "app/results.h"

#include <cmath>

#include <fmt/format.h>

namespace verstat::app {

store::Run record_of(const shop::RunResult& result, const LoadedScenario& loaded,
                     const std::vector<scenarios::Change>& changes, const std::string& label,
                     double elapsed_s) {
  store::Run run;
  const scenarios::Scenario& s = loaded.scenario;
  run.header = {.label = label,
                .scenario_name = s.name,
                .changes = changes_text(changes),
                .seed = s.simulation.seed.value,
                .replications = static_cast<std::int64_t>(result.values.size()),
                .horizon_min = s.simulation.horizon_min,
                .warmup_min = s.simulation.warmup_min,
                .elapsed_s = elapsed_s,
                .provenance = provenance(),
                .fingerprint = shop::fingerprint_of(result)};
  run.scenario_text = loaded.text;
  run.currency = s.currency;
  for (std::size_t k = 0; k < result.kpis.size(); ++k) {
    const shop::Estimate& e = result.estimates[k];
    run.kpis.push_back({.kpi = {result.kpis[k].name, result.kpis[k].unit, result.kpis[k].meaning},
                        .mean = e.mean,
                        .half_width = e.half_width,
                        .samples = e.samples});
  }
  run.values = result.values;
  return run;
}

std::string shown(const std::optional<double>& mean, const std::optional<double>& half_width) {
  if (!mean) return "-";
  if (!half_width) return fmt::format("{:.6g}", *mean);
  if (*half_width == 0) return fmt::format("{:.6g}", *mean);
  // Two digits of the uncertainty; the mean no finer than that.
  const int digits = std::max(0, 1 - static_cast<int>(std::floor(std::log10(*half_width))));
  return fmt::format("{:.{}f} +- {:.{}f}", *mean, digits, *half_width, digits);
}

void print_run(const store::Run& run) {
  fmt::print(
      "{}\n{} replications of {:g} min after {:g} min warm-up, seed {}; +- is the half-width at 95 %\n\n",
      run.header.scenario_name, run.header.replications, run.header.horizon_min - run.header.warmup_min,
      run.header.warmup_min, run.header.seed);
  std::string group;
  for (const store::KpiSummary& kpi : run.kpis) {
    const auto slash = kpi.kpi.name.rfind('/');
    const std::string head = slash == std::string::npos ? "" : kpi.kpi.name.substr(0, slash);
    if (head != group) fmt::print("{}\n", head);
    group = head;
    const std::string name =
        slash == std::string::npos ? kpi.kpi.name : "  " + kpi.kpi.name.substr(slash + 1);
    fmt::print("{:<28} {:>24}  {}\n", name, shown(kpi.mean, kpi.half_width),
               kpi.kpi.unit == "1" ? "" : kpi.kpi.unit);
  }
}

}  // namespace verstat::app
