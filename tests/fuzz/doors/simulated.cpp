// A scenario that can be loaded and is small is simulated a little with every law checked.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "scenarios/load.h"
#include "sim/kernel/errors.h"
#include "sim/shop/run.h"
#include "tests/fuzz/check.h"
#include "tests/fuzz/targets.h"

namespace verstat::fuzz {

namespace {

void eat(std::string_view bytes) {
  try {
    scenarios::Scenario s = scenarios::load(scenarios::parse_json(bytes));
    s.simulation.horizon_min = std::min(s.simulation.horizon_min, 3000.0);
    s.simulation.warmup_min = std::min(s.simulation.warmup_min, s.simulation.horizon_min / 4);
    s.simulation.replications = 1;
    s.simulation.max_events = 20'000;
    std::int64_t machines = 0;
    for (const auto& machine : s.machines) machines += machine.count;
    if (machines > 100) return;
    const shop::RunResult result = shop::run_scenario(s, 1, {}, shop::Checks::on);
    for (const std::string& law : result.broken_laws) finding("broken law: " + law);
    for (std::size_t k = 0; k < result.kpis.size(); ++k)
      if (result.values[0][k] && !std::isfinite(*result.values[0][k]))
        finding(fmt::format("KPI {} = {}", result.kpis[k].name, *result.values[0][k]));
  } catch (const scenarios::InputError& e) {
    check_words(e.what());
  } catch (const sim::BudgetError& e) {
    check_words(e.what());
  }
}

std::vector<std::string> seeds() {
  std::vector<std::string> all = json_in("scenarios/gallery", ".json", 1U << 20U);
  std::erase_if(all, [](const std::string& text) { return text.find("\"variables\"") != std::string::npos; });
  return all;
}

}  // namespace

Target simulated_target() {
  return {"simulated", Form::json, eat, seeds};
}

}  // namespace verstat::fuzz
