#pragma once
// The circle through many points of a measured or computed arc.

#include <span>

namespace verstat::models {

struct PlanePoint {
  double x;
  double y;
};

struct CircleFit {
  double center_x;
  double center_y;
  double radius;
  double form_error;  ///< largest minus smallest deviation
  double rms_error;   ///< root mean square deviation from the radius
};

/// Algebraic (Kasa) least-squares circle, centre free: minimises the sum of (x^2 + y^2 + D x + E y + F)^2.
/// At least three points; throws DomainError when they lie on a line.
[[nodiscard]] CircleFit fit_circle(std::span<const PlanePoint> points);

}  // namespace verstat::models
