// K102 (1): uncut chip section and edge length of a tool with a round nose, in closed form.
#include <algorithm>
#include <cmath>

#include "models/cutting/k102_insert_nose_radius_forces.h"
#include "models/math/trig_degrees.h"

namespace verstat::models::k102 {
namespace {

// 1 - cos x without cancellation, and its inverse.
double versine(double x) {
  const double s = std::sin(x / 2);
  return 2 * s * s;
}
double inverse_versine(double v) {
  return 2 * std::asin(std::sqrt(std::clamp(v / 2, 0.0, 1.0)));
}

// x - sin x; by its series where the difference would cancel.
double minus_sine(double x) {
  if (x > 0.5) return x - std::sin(x);
  double term = x * x * x / 6;
  double sum = term;
  for (int k = 4; k <= 14; k += 2) {
    term *= -x * x / (k * (k + 1));
    sum += term;
  }
  return sum;
}

// One side of the tool outline: an arc of the nose radius from the lowest point, then a straight edge
// inclined by psi to the feed direction. y is the height above the lowest point.
class Side {
 public:
  Side(double angle_deg, double radius_mm)
      : r_(radius_mm),
        psi_(to_radians(angle_deg)),
        sin_(sin_deg(angle_deg)),
        cot_(cos_deg(angle_deg) / sin_),
        arc_height_(r_ * versine(psi_)) {}

  [[nodiscard]] double angle() const { return psi_; }
  [[nodiscard]] double sine() const { return sin_; }
  [[nodiscard]] double cotangent() const { return cot_; }
  [[nodiscard]] double arc_height() const { return arc_height_; }
  // Horizontal distance from the nose axis to the edge.
  [[nodiscard]] double offset(double y) const {
    if (y <= arc_height_) return std::sqrt(y * (2 * r_ - y));
    return r_ * sin_ + (y - arc_height_) * cot_;
  }
  // Area between the nose axis and the edge below y.
  [[nodiscard]] double area(double y) const {
    const double straight = std::max(0.0, y - arc_height_);
    return r_ * r_ / 4 * minus_sine(2 * arc_angle(y)) + r_ * sin_ * straight + straight * straight / 2 * cot_;
  }
  // Length of the edge below y.
  [[nodiscard]] double length(double y) const {
    return r_ * arc_angle(y) + std::max(0.0, y - arc_height_) / sin_;
  }

 private:
  [[nodiscard]] double arc_angle(double y) const {
    if (r_ == 0) return 0;
    return y >= arc_height_ ? psi_ : inverse_versine(y / r_);
  }
  double r_, psi_, sin_, cot_, arc_height_;
};

// Height at which the outline is as wide as the feed. `low` ends its arc first.
double height_of_width(const Side& low, const Side& high, double r, double feed) {
  if (r > 0 && feed <= 2 * r * low.sine()) {
    // Both sides on the arc: y = r - sqrt(r^2 - S^2/4).
    return feed * feed / 4 / (r + std::sqrt((r - feed / 2) * (r + feed / 2)));
  }
  if (r > 0 && feed <= low.offset(high.arc_height()) + high.offset(high.arc_height())) {
    // One straight edge and the arc at angle theta: r sin(theta) + r (1 - cos(theta) cos(psi)) / sin(psi) =
    // S, that is 1 - cos(theta + psi) = S sin(psi) / r.
    const double theta = inverse_versine(feed * low.sine() / r) - low.angle();
    return r * versine(theta);
  }
  const double width = low.offset(high.arc_height()) + high.offset(high.arc_height());
  return high.arc_height() + (feed - width) / (low.cotangent() + high.cotangent());
}

}  // namespace

ChipSection uncut_chip_section(const ChipSectionInputs& in) {
  return guarded<&uncut_chip_section>(in, [&] {
    require(in.nose_radius_mm > 0 || in.lead_angle_deg < 90 || in.end_angle_deg < 90, "nose_radius_mm",
            in.nose_radius_mm, "must be above 0 when both angles are 90: the tool has no width");
    const Side main(in.lead_angle_deg, in.nose_radius_mm);
    const Side minor(in.end_angle_deg, in.nose_radius_mm);
    const double t = in.depth_mm;
    const double feed = in.feed_mm_rev;
    double height = t;
    if (main.offset(t) + minor.offset(t) > feed) {
      const bool main_first = main.arc_height() <= minor.arc_height();
      height = std::min(
          t, height_of_width(main_first ? main : minor, main_first ? minor : main, in.nose_radius_mm, feed));
    }
    const double area = main.area(height) + minor.area(height) + feed * (t - height);
    const double length = main.length(t) + minor.length(height);
    return ChipSection{area, length, area / length, height};
  });
}

}  // namespace verstat::models::k102
