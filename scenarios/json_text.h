#pragma once
// Reading JSON as strictly as money deserves: no duplicate keys, no trailing text, bounded size and depth.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scenarios/input_error.h"

namespace verstat::scenarios {

inline constexpr std::size_t largest_file_bytes = 64U << 20U;
inline constexpr int deepest_json = 64;

/// Parses `text`. Throws InputError that names line and column, the duplicate key, or the limit exceeded.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);
/// Reads and parses a file. Throws InputError that names the file.
[[nodiscard]] nlohmann::json read_json_file(const std::string& path);
/// The text of a file. Throws InputError when it cannot be read or is larger than `largest_file_bytes`.
[[nodiscard]] std::string read_text_file(const std::string& path);

}  // namespace verstat::scenarios
