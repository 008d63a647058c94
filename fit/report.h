#pragma once
// What a fit answers: JSON, lines to read, and changes to a scenario with where they come from.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "fit/csv_table.h"
#include "fit/statistics.h"
#include "scenarios/load.h"

namespace verstat::fit {

/// Where numbers come from: stands beside every change.
struct Origin {
  std::string file;
  std::size_t rows_used = 0;
  std::size_t rows_in_file = 0;
  std::string method;
  std::string date;     ///< when the fit was made, UTC
  std::string version;  ///< of the program
};

struct Report {
  nlohmann::ordered_json json;
  std::vector<std::string> lines;
  std::vector<std::string> warnings;
  std::vector<scenarios::Change> changes;
};

/// A finite number, or null.
[[nodiscard]] nlohmann::ordered_json number(double value);
[[nodiscard]] nlohmann::ordered_json interval_json(const Interval& interval);
/// "12.3 (10.1 to 15.0)"; an infinite bound is "no upper bound".
[[nodiscard]] std::string with_bounds(double estimate, const Interval& interval);

/// What was read: rows in the file, used, dropped with line and reason, notes.
[[nodiscard]] nlohmann::ordered_json table_json(const Table& table, std::size_t rows_used);
void add_table_lines(std::vector<std::string>& lines, const Table& table, std::size_t rows_used);

[[nodiscard]] nlohmann::ordered_json origin_json(const Origin& origin);
/// "removals.csv, 93 of 96 rows; censored maximum likelihood, weibull law; 2026-03-01T10:00:00Z, verstat
/// 0.1.0"
[[nodiscard]] std::string origin_text(const Origin& origin);
/// {"changes": [{pointer, value}], "provenance": {...}}: the file that --changes reads.
[[nodiscard]] nlohmann::ordered_json patch_json(const std::vector<scenarios::Change>& changes,
                                                const Origin& origin);

/// Two decimals more than the largest number needs, at most six significant digits.
[[nodiscard]] std::string plain(double value);

}  // namespace verstat::fit
