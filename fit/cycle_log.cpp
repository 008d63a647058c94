#include "fit/cycle_log.h"

#include <algorithm>

#include <fmt/format.h>

#include "scenarios/json_text.h"

namespace verstat::fit {
namespace {

const std::vector<Role>& roles() {
  static const std::vector<Role> all = {
      {"cycle",
       Quantity::time_min,
       {"cycle", "cycle time", "duration", "time", "цикл", "час циклу", "тривалість", "час", "время цикла",
        "длительность", "время"}},
      {"operation", Quantity::text, {"operation", "op", "operation name", "операція", "операция"}},
      {"record", Quantity::text, {"record", "id", "no", "part no", "serial", "№", "номер"}, true}};
  return all;
}

}  // namespace

CycleLog read_cycles(const std::string& path, const CycleOptions& options) {
  CycleLog log;
  log.table = read_table(path, options.table);
  const Columns columns(log.table, roles(), options.columns, options.table);
  columns.require("cycle", "how long the operation took");
  for (const Row& row : log.table.rows) {
    const std::string operation = columns.text(row, "operation");
    if (!options.operation.empty() && operation != options.operation) continue;
    std::string reason;
    const auto time = columns.value(row, "cycle", reason);
    if (time && !(*time > 0)) reason = fmt::format("a time of {} min is not above 0", *time);
    if (!time || !(*time > 0)) {
      log.table.dropped.push_back({row.line, reason});
      continue;
    }
    auto group = std::find_if(log.groups.begin(), log.groups.end(),
                              [&](const auto& g) { return g.operation == operation; });
    if (group == log.groups.end()) group = log.groups.insert(log.groups.end(), {operation, {}});
    group->times.push_back(exact_life(*time));
    group->times.back().line = row.line;
    ++log.rows_used;
  }
  if (log.rows_used == 0) {
    std::string why;
    if (!log.table.dropped.empty())
      why = fmt::format("; line {}: {}", log.table.dropped.front().line, log.table.dropped.front().reason);
    throw scenarios::InputError(
        "", fmt::format("table {}: no row of {} can be used{}", path, log.table.rows_in_file, why));
  }
  return log;
}

}  // namespace verstat::fit
