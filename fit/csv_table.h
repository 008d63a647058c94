#pragma once
// A table as it leaves a shop's spreadsheet: comma, semicolon or tab, byte-order mark, Windows-1251, quotes,
// units in the header. Every decision taken while reading is a note, every row left out has a line number and
// a reason.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace verstat::fit {

/// A row of the file that takes no part in a fit.
struct DroppedRow {
  std::size_t line = 0;  ///< in the file, the first is 1
  std::string reason;
};

struct Column {
  std::string header;  ///< as in the file
  std::string name;    ///< lower case, without the unit
  std::string unit;    ///< as written, lower case: "min", "хв", "mm/rev"; empty when the header has none
};

struct Row {
  std::size_t line = 0;
  std::vector<std::string> cells;  ///< trimmed, as many as there are columns
};

struct Table {
  std::string file;
  std::vector<Column> columns;
  std::vector<Row> rows;
  std::size_t rows_in_file = 0;  ///< without the header and blank lines
  std::vector<DroppedRow> dropped;
  std::vector<std::string> notes;  ///< what was decided, in words
  char decimal = '.';
};

enum class Duplicates {
  by_identity,  ///< left out when a column identifies rows, else kept with a note
  drop,
  keep
};

struct TableOptions {
  std::string encoding;   ///< "utf-8" or "cp1251"; empty: UTF-8, else Windows-1251 with a note
  std::string separator;  ///< "comma", "semicolon" or "tab"; empty: found in the header line
  std::string decimal;    ///< "point" or "comma"; empty: found in the cells, refused when they leave a doubt
  Duplicates duplicates = Duplicates::by_identity;
  std::string sheet;  ///< of an xlsx workbook; empty: the first one
};

/// The table in `text`; `file` is only for messages. The first line that is not blank is the header.
/// Throws scenarios::InputError naming file, line and what would be right.
[[nodiscard]] Table parse_table(std::string file, std::string_view text, const TableOptions& options);
/// Reads a file. An xlsx workbook goes through the converter (fit/workbook.h); other workbooks (ods, xls) are
/// refused with what to do.
[[nodiscard]] Table read_table(const std::string& path, const TableOptions& options);

/// True for the ways in which shops write "nothing here": empty, "-", "n/a", "No data", "немає даних".
[[nodiscard]] bool is_missing(std::string_view cell);
/// Lower case of ASCII and Cyrillic letters; other bytes stay.
[[nodiscard]] std::string lower_case(std::string_view utf8);

}  // namespace verstat::fit
