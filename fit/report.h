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

/// A fitted element of a scenario by itself: an insert, a failure mode, a duration, a supply.
struct LibraryEntry {
  std::string kind;  ///< "insert", "failure", "duration", "supply"
  std::string name;
  nlohmann::ordered_json entry;
  Origin origin;
};

struct Report {
  nlohmann::ordered_json json;
  std::vector<std::string> lines;
  std::vector<std::string> warnings;
  std::vector<scenarios::Change> changes;
  std::vector<LibraryEntry> library;
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
/// The members of an edge life as an entry of a library; price and edges are the shop's to add.
[[nodiscard]] LibraryEntry insert_entry(const std::string& name, const nlohmann::ordered_json& edge_life,
                                        const Origin& origin);
/// The members of an edge life as changes of the insert at `pointer`.
[[nodiscard]] std::vector<scenarios::Change> insert_changes(const std::string& pointer,
                                                            const nlohmann::ordered_json& edge_life,
                                                            const Origin& origin);
/// Puts warnings, provenance, library entries and the patch into the JSON answer.
void finish(Report& report, const Origin& origin);

/// Four or five digits, without an exponent between 0.001 and a million.
[[nodiscard]] std::string plain(double value);

}  // namespace verstat::fit
