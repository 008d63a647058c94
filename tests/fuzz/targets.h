#pragma once
// What eats the bytes of strangers, one function per door. Each returns when the bytes were taken or refused
// in words; anything else (another exception, a crash, a broken law, a NaN) is a finding and aborts.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace verstat::fuzz {

struct Target {
  std::string name;
  bool json = false;  ///< inputs are JSON texts: mutations may work on the tree
  void (*eat)(std::string_view bytes) = nullptr;
  /// Honest inputs to start from.
  std::vector<std::string> (*seeds)() = nullptr;
};

/// All targets, in a fixed order.
[[nodiscard]] const std::vector<Target>& targets();
/// Throws std::invalid_argument when there is none of this name.
[[nodiscard]] const Target& target(std::string_view name);

/// A variation of `text`, always the same for the same `seed`. For JSON: members are exchanged, removed,
/// doubled, replaced by what breaks programs; now and then, and for other texts always, bytes are.
[[nodiscard]] std::string mutated(const std::string& text, bool json, std::uint64_t seed);

}  // namespace verstat::fuzz
