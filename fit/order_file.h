#pragma once
// Orders that stand in a table beside the scenario: {"kind": "orders", "file": "orders.csv"}.

#include <filesystem>
#include <string>

namespace verstat::fit {

/// The text of a scenario with every order file read in: what is stored with a run must say all by itself.
/// `folder` is that of the scenario. The table has a column of arrivals (date and time, or minutes) and may
/// have quantities, due dates and, when several part types share it, names of parts. Dates count from the
/// Monday, 00:00, before the first arrival. Returns `text` as it is when no supply names a file. Throws
/// scenarios::InputError naming file, line and what would be right; a row that cannot be read is an error: an
/// order is not left out.
[[nodiscard]] std::string with_order_files(const std::string& text, const std::filesystem::path& folder);

}  // namespace verstat::fit
