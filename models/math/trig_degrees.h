#pragma once
// Angles in degrees, as process models state them. Quarter turns are exact: cos_deg(90) is 0, not 6e-17, so
// that a flat edge is flat and a limit of a formula is reached instead of missed by a rounding.

#include <cmath>
#include <numbers>

namespace verstat::models {

[[nodiscard]] constexpr double to_radians(double angle_deg) {
  return angle_deg * (std::numbers::pi / 180);
}
[[nodiscard]] constexpr double to_degrees(double angle_rad) {
  return angle_rad * (180 / std::numbers::pi);
}

/// Sine of an angle in degrees; exact at multiples of 90.
[[nodiscard]] inline double sin_deg(double angle_deg) {
  const double turn = std::fmod(angle_deg, 360);
  if (turn == 0 || turn == 180 || turn == -180) return 0;
  if (turn == 90 || turn == -270) return 1;
  if (turn == -90 || turn == 270) return -1;
  return std::sin(to_radians(turn));
}

/// Cosine of an angle in degrees; exact at multiples of 90.
[[nodiscard]] inline double cos_deg(double angle_deg) {
  const double turn = std::fmod(angle_deg, 360);
  if (turn == 90 || turn == -90 || turn == 270 || turn == -270) return 0;
  if (turn == 0) return 1;
  if (turn == 180 || turn == -180) return -1;
  return std::cos(to_radians(turn));
}

/// Direction of the vector (x, y) in degrees, -180 to 180.
[[nodiscard]] inline double atan2_deg(double y, double x) {
  return to_degrees(std::atan2(y, x));
}

}  // namespace verstat::models
