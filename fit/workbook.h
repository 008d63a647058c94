#pragma once
// Workbooks are read by the converter xlsx2csv (Debian package of that name), never by a parser of our own.

#include <string>

namespace verstat::fit {

/// True for the names of files that the converter reads: ".xlsx" in either case.
[[nodiscard]] bool is_workbook_name(const std::string& path);

/// One sheet of an xlsx workbook as a table separated by semicolons, with decimal points, whole numbers
/// unrounded by what a cell shows, and dates as 2026-03-01 14:05:00; line n of the table is row n of the
/// sheet. `sheet` empty: the first one. Runs the program xlsx2csv, without a shell. Throws
/// scenarios::InputError naming the file, and the package when the program is not there.
[[nodiscard]] std::string workbook_as_table(const std::string& path, const std::string& sheet);

}  // namespace verstat::fit
