#include "models/math/turned_contour.h"

#include <cmath>
#include <numbers>

#include "models/catalogue/error.h"

namespace verstat::models {
namespace {

ContourPoint segment_normal(const ContourPoint& from, const ContourPoint& to) {
  const double axial = to.axial_mm - from.axial_mm;
  const double radial = to.radius_mm - from.radius_mm;
  const double length = std::hypot(axial, radial);
  return {-radial / length, axial / length};
}

ContourPoint between(const ContourPoint& a, const ContourPoint& b, double radius_mm) {
  const double share = (radius_mm - a.radius_mm) / (b.radius_mm - a.radius_mm);
  return {a.axial_mm + share * (b.axial_mm - a.axial_mm), radius_mm};
}

}  // namespace

double contour_length_mm(std::span<const ContourPoint> contour) {
  double length = 0;
  for (std::size_t k = 1; k < contour.size(); ++k)
    length += std::hypot(contour[k].axial_mm - contour[k - 1].axial_mm,
                         contour[k].radius_mm - contour[k - 1].radius_mm);
  return length;
}

TurnedContour offset_contour_mitred(std::span<const ContourPoint> contour, double offset_mm) {
  TurnedContour moved;
  moved.reserve(contour.size());
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const ContourPoint before =
        k > 0 ? segment_normal(contour[k - 1], contour[k]) : segment_normal(contour[0], contour[1]);
    const ContourPoint after = k + 1 < contour.size() ? segment_normal(contour[k], contour[k + 1]) : before;
    // (n1 + n2) / (1 + n1 n2) is the mitre: along the bisector, one offset from both segments.
    const double mitre = 1 + before.axial_mm * after.axial_mm + before.radius_mm * after.radius_mm;
    if (!(mitre > 1e-12)) reject("the contour folds back onto itself: it has no equidistant");
    moved.push_back({contour[k].axial_mm + offset_mm * (before.axial_mm + after.axial_mm) / mitre,
                     contour[k].radius_mm + offset_mm * (before.radius_mm + after.radius_mm) / mitre});
  }
  return moved;
}

double revolved_volume_mm3(std::span<const ContourPoint> contour) {
  double volume = 0;
  for (std::size_t k = 1; k < contour.size(); ++k) {
    const double a = contour[k - 1].radius_mm;
    const double b = contour[k].radius_mm;
    volume += (contour[k].axial_mm - contour[k - 1].axial_mm) * (a * a + a * b + b * b);
  }
  return volume * std::numbers::pi / 3;
}

std::vector<TurnedContour> pieces_below(std::span<const ContourPoint> contour, double radius_mm) {
  std::vector<TurnedContour> pieces;
  bool inside = false;
  for (std::size_t k = 1; k < contour.size(); ++k) {
    ContourPoint from = contour[k - 1];
    ContourPoint to = contour[k];
    if (from.radius_mm >= radius_mm && to.radius_mm >= radius_mm) {
      inside = false;
      continue;
    }
    const bool leaves = to.radius_mm >= radius_mm;
    if (from.radius_mm > radius_mm) from = between(from, to, radius_mm);
    if (to.radius_mm > radius_mm) to = between(from, to, radius_mm);
    if (!inside) pieces.push_back({from});
    pieces.back().push_back(to);
    inside = !leaves;
  }
  return pieces;
}

}  // namespace verstat::models
