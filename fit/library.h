#pragma once
// A library: a folder of fitted entries, one JSON file each, from which scenarios are furnished.
//   {"kind": "insert", "name": "T5K10", "entry": {...}, "provenance": {"file": ..., "rows_used": ..., ...}}

#include <string>
#include <vector>

#include "fit/report.h"
#include "scenarios/load.h"

namespace verstat::fit {

/// The entries of a report as they stand in a library and in JSON answers.
[[nodiscard]] nlohmann::ordered_json library_json(const LibraryEntry& entry);

/// Writes every entry to `folder` (made when it is not there) as KIND-NAME.json, each whole or not at all;
/// an entry of the same kind and name is replaced. Returns the files. Throws InputError naming --library.
std::vector<std::string> write_library(const std::string& folder, const std::vector<LibraryEntry>& entries);

/// "POINTER=FILE" as the changes that put the entry of the file at POINTER: its members replace those that
/// stand there, other members and the name stay. A duration or supply replaces what stands there whole.
/// Throws InputError naming --use and what is wrong with pointer or file.
[[nodiscard]] std::vector<scenarios::Change> changes_of_use(const std::string& text);

}  // namespace verstat::fit
