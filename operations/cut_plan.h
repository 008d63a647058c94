#pragma once
// What an operation asks of the shop: computed once from its specification by the process models, and used by
// the simulator, the optimizer, the command line and the pages alike.

#include <optional>

namespace verstat::operations {

struct CutPlan {
  double main_time_min = 0;             ///< cutting time of one part
  std::optional<double> mean_life_min;  ///< mean life of the edge at this regime; none when no edge wears
};

}  // namespace verstat::operations
