#include "fit/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fit/library.h"

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

LibraryEntry insert_entry(const std::string& name, const ordered_json& edge_life, const Origin& origin) {
  return {.kind = "insert",
          .name = name,
          .entry = {{"name", name}, {"edge_life", edge_life}, {"provenance", origin_text(origin)}},
          .origin = origin};
}

std::vector<scenarios::Change> insert_changes(const std::string& pointer, const ordered_json& edge_life,
                                              const Origin& origin) {
  std::vector<scenarios::Change> changes;
  for (const auto& [member, value] : edge_life.items())
    changes.push_back({pointer + "/edge_life/" + member, value});
  changes.push_back({pointer + "/provenance", origin_text(origin)});
  return changes;
}

void finish(Report& report, const Origin& origin) {
  report.json["warnings"] = report.warnings;
  report.json["provenance"] = origin_json(origin);
  if (!report.library.empty()) {
    report.json["library"] = ordered_json::array();
    for (const LibraryEntry& entry : report.library) report.json["library"].push_back(library_json(entry));
  }
  if (!report.changes.empty()) report.json["patch"] = patch_json(report.changes, origin);
}

ordered_json patch_json(const std::vector<scenarios::Change>& changes, const Origin& origin) {
  ordered_json list = ordered_json::array();
  for (const scenarios::Change& change : changes)
    list.push_back({{"pointer", change.pointer}, {"value", change.value}});
  return {{"changes", list}, {"provenance", origin_json(origin)}};
}

}  // namespace verstat::fit
