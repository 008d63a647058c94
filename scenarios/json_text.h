#pragma once
// Reading JSON as strictly as money deserves: no duplicate keys, no trailing text, bounded size and depth.

#include <stdexcept>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace verstat::scenarios {

/// Bad input in a file or a change: where it is and what would be right, in one line.
class InputError : public std::runtime_error {
 public:
  /// `pointer` is a JSON pointer ("/machines/0/count"), empty when the whole file is meant.
  InputError(std::string pointer, const std::string& text)
      : std::runtime_error(text), pointer_(std::move(pointer)) {}
  [[nodiscard]] const std::string& pointer() const { return pointer_; }

 private:
  std::string pointer_;
};

inline constexpr std::size_t largest_file_bytes = 64U << 20U;
inline constexpr int deepest_json = 64;

/// Parses `text`. Throws InputError that names line and column, the duplicate key, or the limit exceeded.
[[nodiscard]] nlohmann::json parse_json(std::string_view text);
/// Reads and parses a file. Throws InputError that names the file.
[[nodiscard]] nlohmann::json read_json_file(const std::string& path);
/// The text of a file. Throws InputError when it cannot be read or is larger than `largest_file_bytes`.
[[nodiscard]] std::string read_text_file(const std::string& path);

}  // namespace verstat::scenarios
