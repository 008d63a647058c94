#pragma once
// How fit and calibrate answer.

#include <cstdint>
#include <string>

#include "fit/report.h"

namespace verstat::app {

/// The number of a flag. Throws UsageError naming the flag, the text and the range.
[[nodiscard]] double real_flag(const std::string& flag, const std::string& text, double low, double high);
[[nodiscard]] std::int64_t whole_flag(const std::string& flag, const std::string& text, std::int64_t low,
                                      std::int64_t high);
/// File, date and version; the fit fills in the rest.
[[nodiscard]] fit::Origin origin_now(const std::string& file);
/// Prints the report as text or JSON, and writes its changes to `out` and its library entries to the folder
/// `library` when these are not empty.
void answer(const fit::Report& report, bool json, const std::string& out, const std::string& library = "");

}  // namespace verstat::app
