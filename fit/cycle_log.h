#pragma once
// Cycle times as an operator or the control writes them down, by operation.

#include <string>
#include <vector>

#include "fit/columns.h"
#include "fit/observation.h"

namespace verstat::fit {

struct CycleOptions {
  TableOptions table;
  std::vector<ColumnChoice> columns;
  std::string operation;  ///< only rows of this operation; empty: all
};
struct CycleGroup {
  std::string operation;
  std::vector<Observation> times;  ///< min
};
struct CycleLog {
  Table table;
  std::size_t rows_used = 0;
  std::vector<CycleGroup> groups;
};

[[nodiscard]] CycleLog read_cycles(const std::string& path, const CycleOptions& options);

}  // namespace verstat::fit
