#pragma once
// Request targets: path and query, decoded once and strictly.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace verstat::web {

/// Decodes %XX. None for a broken escape, and for NUL and other control characters, which have no business in
/// an address.
[[nodiscard]] std::optional<std::string> percent_decode(std::string_view text);

/// "/api/v1/runs/3?replications=1" in pieces.
struct Target {
  std::vector<std::string> path;             ///< decoded steps without the slashes: "api", "v1", "runs", "3"
  std::map<std::string, std::string> query;  ///< decoded; "+" is a space
};

/// None when `target` is not an absolute path, has a broken escape, an empty, "." or ".." step, a step that
/// decodes to something with a slash or backslash in it, or a query parameter twice.
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

}  // namespace verstat::web
