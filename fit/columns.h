#pragma once
// From the columns of a shop's table to numbers with known units. A column is found by the names engineers
// use in English, Ukrainian and Russian; two candidates, an unknown unit or a doubtful decimal comma are
// refused with the flag that settles them.

#include <optional>
#include <string>
#include <vector>

#include "fit/csv_table.h"

namespace verstat::fit {

enum class Quantity {
  text,
  number,       ///< without unit
  time_min,     ///< min, h, s
  length_mm,    ///< mm, um
  speed_m_min,  ///< m/min, m/s
  feed_mm_rev,  ///< mm/rev
  moment_min    ///< date and time, in minutes since 1970-01-01; or a counter of minutes
};

/// What a fit wants from a table.
struct Role {
  std::string key;  ///< for --column KEY=HEADER and in messages
  Quantity quantity = Quantity::text;
  std::vector<std::string> names;  ///< lower case, without unit
  bool identifies = false;         ///< rows equal in everything, this included, are one row written twice
};

/// "KEY=HEADER" of --column.
struct ColumnChoice {
  std::string key;
  std::string header;
};
[[nodiscard]] ColumnChoice parse_column_choice(const std::string& text);

/// The columns of a table by role. Rows that repeat an earlier one are taken out of the table as
/// `options.duplicates` says.
class Columns {
 public:
  Columns(Table& table, const std::vector<Role>& roles, const std::vector<ColumnChoice>& choices,
          const TableOptions& options);

  [[nodiscard]] bool has(const std::string& key) const { return find(key) != nullptr; }
  [[nodiscard]] std::string header(const std::string& key) const;
  /// Unit as written in the header of the column; empty when there is none.
  [[nodiscard]] std::string unit(const std::string& key) const;
  /// Throws InputError naming the role and the headers there are, when the column is missing.
  void require(const std::string& key, const std::string& meaning) const;

  [[nodiscard]] std::string text(const Row& row, const std::string& key) const;
  /// The value in the unit of the role; nothing and a reason when the cell has none.
  [[nodiscard]] std::optional<double> value(const Row& row, const std::string& key,
                                            std::string& reason) const;

 private:
  struct Found {
    Role role;
    std::size_t index = 0;
    double factor = 1;
  };
  [[nodiscard]] const Found* find(const std::string& key) const;
  const Table& table_;
  std::vector<Found> found_;
};

/// A number with the given decimal sign; blanks between thousands are skipped. Nothing for any other text.
[[nodiscard]] std::optional<double> parse_number(std::string_view cell, char decimal);
/// Minutes since 1970-01-01 00:00 of "2026-03-01 14:05[:30]", "2026-03-01T14:05", "01.03.2026 14:05" or a
/// date alone; nothing for any other text.
[[nodiscard]] std::optional<double> parse_moment(std::string_view cell);

}  // namespace verstat::fit
