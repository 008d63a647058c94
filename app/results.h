#pragma once
// From a simulated run to what the store keeps and the terminal shows.

#include <string>
#include <vector>

#include "app/cli.h"
#include "sim/shop/run.h"
#include "store/records.h"

namespace verstat::app {

/// The record of a run. `scenario_text` is the file as it stands, `changes` what was changed in it.
[[nodiscard]] store::Run record_of(const shop::RunResult& result, const LoadedScenario& loaded,
                                   const std::vector<scenarios::Change>& changes, const std::string& label,
                                   double elapsed_s);
/// "125.87 +- 0.21"; "-" where there is no value.
[[nodiscard]] std::string shown(const std::optional<double>& mean, const std::optional<double>& half_width);
/// The run as tables: headline KPIs, machine times, tools, cost by component.
void print_run(const store::Run& run);

}  // namespace verstat::app
