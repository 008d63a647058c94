#pragma once
// Searching texts as people do: whatever the case, in Latin and Cyrillic letters.

#include <string>
#include <string_view>

namespace verstat::store {

[[nodiscard]] bool is_utf8(std::string_view text);
/// Lower case of ASCII and of the Cyrillic letters U+0400 to U+042F and Ґ; every other byte unchanged.
[[nodiscard]] std::string folded(std::string_view text);

}  // namespace verstat::store
