#include "app/elsewhere.h"

namespace verstat::app {

Elsewhere& elsewhere() {
  static Elsewhere other;
  return other;
}

shop::RunResult simulate_anywhere(const scenarios::Scenario& scenario, std::uint64_t first,
                                  std::int64_t count, int threads, const shop::Progress& check) {
  if (elsewhere()) return elsewhere()(scenario, first, count, check);
  return shop::run_replications(scenario, first, count, threads, check);
}

}  // namespace verstat::app
