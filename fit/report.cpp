#include "fit/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verstat::fit {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json interval_json(const Interval& interval) {
  return {{"low", number(interval.low)}, {"high", number(interval.high)}};
}

std::string plain(double value) {
  if (!std::isfinite(value)) return value > 0 ? "inf" : "-inf";
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-3 || size >= 1e6)) return fmt::format("{:.4g}", value);
  if (size >= 1000) return fmt::format("{:.0f}", value);
  if (size >= 100) return fmt::format("{:.1f}", value);
  if (size >= 10) return fmt::format("{:.2f}", value);
  return fmt::format("{:.3f}", value);
}

std::string with_bounds(double estimate, const Interval& interval) {
  if (std::isinf(interval.low) && std::isinf(interval.high))
    return fmt::format("{} (the data give no bounds)", plain(estimate));
  if (std::isinf(interval.high))
    return fmt::format("{} (at least {}, no upper bound)", plain(estimate), plain(interval.low));
  if (std::isinf(interval.low))
    return fmt::format("{} (at most {}, no lower bound)", plain(estimate), plain(interval.high));
  return fmt::format("{} ({} to {})", plain(estimate), plain(interval.low), plain(interval.high));
}

namespace {
std::vector<DroppedRow> by_line(std::vector<DroppedRow> dropped) {
  std::stable_sort(dropped.begin(), dropped.end(),
                   [](const auto& a, const auto& b) { return a.line < b.line; });
  return dropped;
}
}  // namespace

ordered_json table_json(const Table& table, std::size_t rows_used) {
  ordered_json dropped = ordered_json::array();
  for (const DroppedRow& row : by_line(table.dropped))
    dropped.push_back({{"line", row.line}, {"reason", row.reason}});
  return {{"file", table.file},
          {"rows_in_file", table.rows_in_file},
          {"rows_used", rows_used},
          {"dropped", dropped},
          {"notes", table.notes}};
}

void add_table_lines(std::vector<std::string>& lines, const Table& table, std::size_t rows_used) {
  lines.push_back(fmt::format("{}: {} of {} rows used", table.file, rows_used, table.rows_in_file));
  for (const std::string& note : table.notes) lines.push_back("  " + note);
  for (const DroppedRow& row : by_line(table.dropped))
    lines.push_back(fmt::format("  line {} left out: {}", row.line, row.reason));
}

ordered_json origin_json(const Origin& origin) {
  return {{"file", origin.file},     {"rows_used", origin.rows_used}, {"rows_in_file", origin.rows_in_file},
          {"method", origin.method}, {"date", origin.date},           {"version", origin.version}};
}

std::string origin_text(const Origin& origin) {
  return fmt::format("{}, {} of {} rows; {}; {}, verstat {}", origin.file, origin.rows_used,
                     origin.rows_in_file, origin.method, origin.date, origin.version);
}

ordered_json insert_entry(const std::string& name, const std::string& pointer,
                          const std::vector<scenarios::Change>& changes) {
  ordered_json entry = {{"name", name}};
  for (const scenarios::Change& change : changes)
    if (change.pointer.starts_with(pointer + "/"))
      entry[ordered_json::json_pointer(change.pointer.substr(pointer.size()))] = change.value;
  return entry;
}

ordered_json patch_json(const std::vector<scenarios::Change>& changes, const Origin& origin) {
  ordered_json list = ordered_json::array();
  for (const scenarios::Change& change : changes)
    list.push_back({{"pointer", change.pointer}, {"value", change.value}});
  return {{"changes", list}, {"provenance", origin_json(origin)}};
}

}  // namespace verstat::fit
