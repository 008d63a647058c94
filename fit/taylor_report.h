#pragma once
// Taylor fits of all groups of a wear table in words, JSON and changes to an insert.

#include <array>
#include <string>
#include <vector>

#include "fit/report.h"
#include "fit/taylor_fit.h"

namespace verstat::fit {

struct TaylorTarget {
  std::string pointer;                         ///< of an insert, "/inserts/0"; empty: no changes
  std::vector<std::array<double, 3>> regimes;  ///< to predict: v m/min, f mm/rev, a_p mm
};

[[nodiscard]] Report report_taylor(const WearData& data, const TaylorOptions& options,
                                   const TaylorTarget& target, Origin origin);

}  // namespace verstat::fit
