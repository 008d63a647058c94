#pragma once
#include <cstddef>
#include <string_view>

namespace verstat::models {

/// The beginning of a text for an error message or a name: at most so many bytes, and no character of UTF-8
/// cut in two, which no JSON could carry.
[[nodiscard]] constexpr std::string_view shortened(std::string_view text, std::size_t bytes) noexcept {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80U) --bytes;
  return text.substr(0, bytes);
}

}  // namespace verstat::models
