#pragma once
// Lives of cutting edges from a removal log: one row per edge taken out (or still in), with how long it cut
// and why it was taken out.

#include <string>
#include <vector>

#include "fit/columns.h"
#include "fit/observation.h"

namespace verstat::fit {

struct RemovalOptions {
  TableOptions table;
  std::vector<ColumnChoice> columns;
  std::vector<std::string> planned_causes;  ///< further words for "taken out although it still cut"
  std::vector<std::string> failure_causes;  ///< further words for a failure; each is a cause of its own
  std::string tool;                         ///< only rows of this tool; empty: all
  std::string regime;                       ///< only rows of this regime; empty: all
};

/// Edges of one tool in one regime.
struct RemovalGroup {
  std::string tool;
  std::string regime;
  std::vector<Observation> lives;  ///< cause and batch are indices into the lists of the log
};

struct RemovalLog {
  Table table;  ///< what was read, dropped and decided
  std::string unit = "min";
  std::vector<std::string> causes;   ///< of failure, in the order met
  std::vector<std::string> batches;  ///< one empty name when there is no such column
  std::vector<RemovalGroup> groups;
  std::size_t rows_used = 0;
};

/// Reads a table with columns for the life (minutes, or whole parts) and the cause, and if there are any for
/// tool, regime, batch, edge and the last inspection at which the edge was still good. Lives counted in parts
/// are intervals: an edge that failed in its 31st part lived between 30 and 31 parts.
/// Throws InputError naming file, column and what would be right.
[[nodiscard]] RemovalLog read_removals(const std::string& path, const RemovalOptions& options);

}  // namespace verstat::fit
