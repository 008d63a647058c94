// Grinding of K412: dressing radius of the wheel, contact, scallops and time.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/toolpath/straightening_roll_contour.h"

namespace verstat::models::k412 {
namespace {

constexpr double unlimited_mm = 1e9;

double curvature_per_mm(double radius_mm) {
  return radius_mm == 0 ? 0 : 1 / radius_mm;  // 0 stands for a straight profile
}

// sqrt(square / (1/R - 1/rho)), unlimited where the wheel is flatter than the profile.
double contact_reach_mm(double square_mm, double wheel_radius_mm, double profile_radius_mm) {
  const double excess = 1 / wheel_radius_mm - curvature_per_mm(profile_radius_mm);
  if (!(excess > 0)) return unlimited_mm;
  return std::min(unlimited_mm, std::sqrt(square_mm / excess));
}

// Radius of a circle that is tangent at `foot` (unit normal n) and passes through `point`.
double tangent_radius_mm(const ContourPoint& point, const ContourPoint& foot, const ContourPoint& n) {
  const double axial = point.axial_mm - foot.axial_mm;
  const double radial = point.radius_mm - foot.radius_mm;
  const double along = axial * n.axial_mm + radial * n.radius_mm;
  if (!(along > 0)) return unlimited_mm;
  return std::min(unlimited_mm, (axial * axial + radial * radial) / (2 * along));
}

}  // namespace

DressingRadius dressing_radius(const DressingSearch& in) {
  return guarded<&dressing_radius>(in, [&] {
    const TurnedContour points = checked(in);
    const std::size_t n = points.size();
    const double step = (points.back().axial_mm - points.front().axial_mm) / static_cast<double>(n - 1);
    require(step > 0, "y_mm", points.back().axial_mm, "must be above the first point");
    for (std::size_t k = 1; k < n; ++k)
      require(std::abs(points[k].axial_mm - points[k - 1].axial_mm - step) <= 1e-4 * step, "y_mm",
              points[k].axial_mm, "must lie on a uniform grid");
    const auto x = [&](std::size_t k) { return points[k].radius_mm; };
    std::vector<ContourPoint> normals(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double slope = k == 0       ? (-3 * x(0) + 4 * x(1) - x(2)) / (2 * step)
                           : k == n - 1 ? (3 * x(n - 1) - 4 * x(n - 2) + x(n - 3)) / (2 * step)
                                        : (x(k + 1) - x(k - 1)) / (2 * step);
      const double length = std::hypot(1, slope);
      normals[k] = {-slope / length, 1 / length};
    }
    const double stock = in.allowance_mm * in.reserve;
    // The wheel stands on the finished profile at `foot` and on the stock contour at `top`.
    const auto radius = [&](std::size_t foot, std::size_t top) {
      const ContourPoint stock_point{points[top].axial_mm + stock * normals[top].axial_mm,
                                     points[top].radius_mm + stock * normals[top].radius_mm};
      return tangent_radius_mm(stock_point, points[foot],
                               normals[in.variant == DressingVariant::tangent ? foot : top]);
    };
    DressingRadius out{unlimited_mm, 1, 0};
    double at_index = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k + 1 < n; ++k) {
      double here = radius(k - 1, k + 1);
      if (in.both_directions) here = std::min(here, radius(k + 1, k - 1));
      // Symmetric and straight profiles tie up to rounding: the first point stays.
      if (here < at_index * (1 - 1e-9)) {
        at_index = here;
        out.index = static_cast<std::int64_t>(k);
      }
      out.radius_mm = std::min(out.radius_mm, here);
      out.largest_radius_mm = std::max(out.largest_radius_mm, here);
    }
    return out;
  });
}

WheelRadius dressing_radius_for_wheel(const WheelOnProfile& in) {
  return guarded<&dressing_radius_for_wheel>(in, [&] {
    const double curvature = curvature_per_mm(in.profile_radius_mm) +
                             8 * in.allowance_mm * in.reserve / (in.wheel_width_mm * in.wheel_width_mm);
    if (!(curvature > 0)) return WheelRadius{unlimited_mm};
    return WheelRadius{std::min(unlimited_mm, 1 / curvature)};
  });
}

HalfWidth wheel_contact_half_width(const WheelContact& in) {
  return guarded<&wheel_contact_half_width>(in, [&] {
    return HalfWidth{contact_reach_mm(2 * in.depth_mm, in.wheel_radius_mm, in.profile_radius_mm)};
  });
}

Feed grinding_feed_for_scallop(const Scallop& in) {
  return guarded<&grinding_feed_for_scallop>(in, [&] {
    return Feed{contact_reach_mm(8 * in.scallop_um / 1000, in.wheel_radius_mm, in.profile_radius_mm)};
  });
}

ProfileGrindingTime profile_grinding_time(const ProfileGrinding& in) {
  return guarded<&profile_grinding_time>(in, [&] {
    const double rpm = 1000 * in.work_speed_m_min / (std::numbers::pi * in.mean_diameter_mm);
    const double passes = std::max(0.0, std::ceil(in.allowance_mm / in.infeed_mm - 1e-9)) +
                          static_cast<double>(in.sparkout_passes);
    require(passes < 1e15, "infeed_mm", in.infeed_mm, "asks for more than 1e15 passes");
    return ProfileGrindingTime{rpm, static_cast<std::int64_t>(passes),
                               passes * in.contour_length_mm / (rpm * in.feed_mm_rev)};
  });
}

}  // namespace verstat::models::k412
