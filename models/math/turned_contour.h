#pragma once
// A turned contour as a polyline of (axial place, radius), material below, axial place not falling.

#include <span>
#include <vector>

namespace verstat::models {

struct ContourPoint {
  double axial_mm;
  double radius_mm;
};
using TurnedContour = std::vector<ContourPoint>;

[[nodiscard]] double contour_length_mm(std::span<const ContourPoint> contour);

/// Equidistant with mitred vertices; a positive offset leads away from the material (+radius for growing
/// axial place). Neighbouring points must differ. Throws DomainError where the contour folds back onto
/// itself.
[[nodiscard]] TurnedContour offset_contour_mitred(std::span<const ContourPoint> contour, double offset_mm);

/// Volume of the solid of revolution, as a sum of frustums.
[[nodiscard]] double revolved_volume_mm3(std::span<const ContourPoint> contour);

/// The pieces of the contour below a radius, cut where it crosses that radius; pieces that only touch it from
/// above are left out.
[[nodiscard]] std::vector<TurnedContour> pieces_below(std::span<const ContourPoint> contour,
                                                      double radius_mm);

}  // namespace verstat::models
