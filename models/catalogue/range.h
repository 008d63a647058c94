#pragma once
// The valid range of one number, and how it is said to a user.

#include <limits>
#include <string>
#include <string_view>

namespace verstat::models {

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;

  /// NaN and infinities are outside every range.
  [[nodiscard]] bool contains(double x) const {
    return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high) &&
           x - x == 0.0;  // false for NaN and infinities
  }
  /// The range as a condition on `name`: "0 < r_tooth < 1", "z >= 1", "x finite".
  [[nodiscard]] std::string text(std::string_view name) const;
};

[[nodiscard]] constexpr Range closed(double low, double high) {
  return {low, high, false, false};
}
[[nodiscard]] constexpr Range open(double low, double high) {
  return {low, high, true, true};
}
/// low < x <= high
[[nodiscard]] constexpr Range open_low(double low, double high) {
  return {low, high, true, false};
}
/// low <= x < high
[[nodiscard]] constexpr Range open_high(double low, double high) {
  return {low, high, false, true};
}
[[nodiscard]] constexpr Range above(double low) {
  return {low, std::numeric_limits<double>::infinity(), true, false};
}
[[nodiscard]] constexpr Range at_least(double low) {
  return {low, std::numeric_limits<double>::infinity(), false, false};
}
[[nodiscard]] constexpr Range below(double high) {
  return {-std::numeric_limits<double>::infinity(), high, false, true};
}
[[nodiscard]] constexpr Range at_most(double high) {
  return {-std::numeric_limits<double>::infinity(), high, false, false};
}
[[nodiscard]] constexpr Range any() {
  return {};
}
/// For texts, flags and structures, which have no range of their own.
[[nodiscard]] constexpr Range no_range() {
  return {};
}
[[nodiscard]] constexpr Range positive() {
  return above(0);
}
[[nodiscard]] constexpr Range non_negative() {
  return at_least(0);
}
[[nodiscard]] constexpr Range probability() {
  return closed(0, 1);
}

}  // namespace verstat::models
