#pragma once
// A fingerprint of numbers and texts in their order: two that differ in one bit differ.

#include <bit>
#include <cstdint>
#include <string_view>

namespace verstat::shop {

/// FNV-1a, 64 bits: http://www.isthe.com/chongo/tech/comp/fnv. Not for secrets.
class Fingerprint {
 public:
  /// Eight bytes, the lowest first, on every machine.
  void add(std::uint64_t bits) noexcept {
    for (unsigned shift = 0; shift < 64; shift += 8) byte(static_cast<unsigned char>(bits >> shift));
  }
  /// The bits of the number: 0 and -0 differ.
  void add(double number) noexcept { add(std::bit_cast<std::uint64_t>(number)); }
  /// The bytes of the text and its length.
  void add(std::string_view text) noexcept {
    for (const char c : text) byte(static_cast<unsigned char>(c));
    add(static_cast<std::uint64_t>(text.size()));
  }
  [[nodiscard]] std::uint64_t value() const noexcept { return hash_; }

 private:
  void byte(unsigned char b) noexcept { hash_ = (hash_ ^ b) * 0x100000001b3U; }
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace verstat::shop
