#pragma once
// What eats the bytes of strangers, one function per door. Each returns when the bytes were taken or refused
// in words; anything else (another exception, a crash, a broken law, a NaN) is a finding and aborts.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace verstat::fuzz {

/// What inputs look like, so that variations of them end where they are used and not in a parser.
enum class Form {
  bytes,
  json,    ///< a JSON text
  request  ///< a head of lines, an empty line, and a body that may be JSON
};

struct Target {
  std::string name;
  Form form = Form::bytes;
  void (*eat)(std::string_view bytes) = nullptr;
  /// Honest inputs to start from.
  std::vector<std::string> (*seeds)() = nullptr;
  /// Variations eaten in every test; fewer where one takes long.
  std::uint64_t short_run = 1500;
};

// One per file in tests/fuzz/doors.
[[nodiscard]] Target scenario_target();
[[nodiscard]] Target simulated_target();
[[nodiscard]] Target study_target();
[[nodiscard]] Target table_target();
[[nodiscard]] Target records_target();
[[nodiscard]] Target workbook_target();
[[nodiscard]] Target model_target();
[[nodiscard]] Target changes_target();
[[nodiscard]] Target arguments_target();
[[nodiscard]] Target route_target();
[[nodiscard]] Target http_target();

/// All targets, in a fixed order.
[[nodiscard]] const std::vector<Target>& targets();

/// A variation of `text`, always the same for the same `seed`. For JSON: members are exchanged, removed,
/// doubled, replaced by what breaks programs; now and then, and for other texts always, bytes are.
[[nodiscard]] std::string mutated(const std::string& text, Form form, std::uint64_t seed);
/// `text` with a part of `other` in it; empty when the two have no form that can be crossed.
[[nodiscard]] std::string crossed(const std::string& text, const std::string& other, Form form,
                                  std::uint64_t seed);

}  // namespace verstat::fuzz
