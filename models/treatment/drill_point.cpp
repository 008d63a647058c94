#include "models/treatment/drill_point.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "models/math/solve.h"

namespace verstat::models::k208 {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;

// Newton's iteration for f(z) = 0; `f` returns value and derivative. Throws when it does not settle.
template <class F>
double newton(F&& f, double z, std::string_view input, double value, double scale) {
  for (int k = 0; k < 100; ++k) {
    const auto [residual, slope] = f(z);
    const double step = residual / slope;
    if (!std::isfinite(step)) break;
    z -= step;
    if (std::abs(step) <= 1e-14 * scale) return z;
  }
  require(false, input, value, "the flanks have no edge there that the iteration finds");
  return z;
}

}  // namespace

DrillPoint::DrillPoint(const Drill& drill) : drill_(drill), setup_{} {
  const double radius = drill.drill_diameter_mm / 2;
  const double core = drill.core_radius_mm;
  require(core < radius, "core_radius_mm", core, "must be below half of the drill diameter");
  const double phi = drill.half_point_angle_deg * rad_per_deg;
  const double rho = drill.cone_half_angle_deg * rad_per_deg;
  tan_rho_ = std::tan(rho);
  tan2_rho_ = tan_rho_ * tan_rho_;
  const double mu = std::asin(core / radius);
  const double tan_theta = std::tan(drill.clearance_deg * rad_per_deg) * std::sin(phi) / std::cos(mu) -
                           std::tan(mu) * std::cos(phi);
  const double c1 = tan_theta * tan_rho_ / std::sin(phi);
  const double rise = tan_rho_ / (std::tan(phi) * std::tan(drill.chisel_angle_deg * rad_per_deg));
  const double l0 = (c1 * radius + core) / (rise - c1);
  if (!(l0 > 0) || !std::isfinite(l0))
    reject(
        fmt::format("no cone position gives this clearance and chisel angle: l0 = {:.6g} mm, must be "
                    "positive",
                    l0));
  setup_ = {mu / rad_per_deg,
            std::atan(tan_theta) / rad_per_deg,
            c1,
            l0,
            l0 * rise,
            (radius + l0) / std::tan(phi),
            drill.half_point_angle_deg - drill.cone_half_angle_deg};
  sin_ = std::sin(setup_.delta_z_deg * rad_per_deg);
  cos_ = std::cos(setup_.delta_z_deg * rad_per_deg);
}

Eigen::Vector3d DrillPoint::flank(double u, double v) const {
  const double axial = u / tan_rho_;
  return {u * std::cos(v) * cos_ + axial * sin_ - setup_.l0_mm, u * std::sin(v) - setup_.k0_mm,
          axial * cos_ - u * sin_ * std::cos(v) - setup_.b_mm};
}

Eigen::Vector3d DrillPoint::in_cone(const Eigen::Vector3d& p) const {
  const double x = p.x() + setup_.l0_mm;
  const double z = p.z() + setup_.b_mm;
  return {x * cos_ - z * sin_, p.y() + setup_.k0_mm, x * sin_ + z * cos_};
}

Eigen::Vector3d DrillPoint::outward_normal(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d c = in_cone(point);
  const double axial = tan2_rho_ * c.z();
  Eigen::Vector3d gradient(c.x() * cos_ - axial * sin_, c.y(), -c.x() * sin_ - axial * cos_);
  const double length = gradient.norm();
  if (!(length > 0)) reject("the point is the apex of the cone, which has no normal");
  gradient /= gradient.z() > 0 ? -length : length;
  return gradient;
}

Eigen::Vector3d DrillPoint::cutting_edge(double radius) const {
  const double core = drill_.core_radius_mm;
  require(radius > core, "radius_mm", radius, "must be above the core radius");
  const double x = std::sqrt((radius - core) * (radius + core));
  const double half = drill_.drill_diameter_mm / 2;
  const double start = -(half - x) / std::tan(drill_.half_point_angle_deg * rad_per_deg);
  const double z = newton(
      [&](double at) {
        const Eigen::Vector3d c = in_cone({x, -core, at});
        return std::pair(c.x() * c.x() + c.y() * c.y() - tan2_rho_ * c.z() * c.z(),
                         -2 * c.x() * sin_ - 2 * tan2_rho_ * c.z() * cos_);
      },
      start, "radius_mm", radius, half + setup_.b_mm);
  return {x, -core, z};
}

double DrillPoint::chisel_slope(double z) const {
  const Eigen::Vector3d c = in_cone({0, 0, z});
  return (c.x() * cos_ - tan2_rho_ * c.z() * sin_) / setup_.k0_mm;
}

Eigen::Vector3d DrillPoint::chisel_edge(double x) const {
  // Difference of both cones gives y, their sum an equation in z.
  const double k0 = setup_.k0_mm;
  const double scale = drill_.drill_diameter_mm + setup_.b_mm;
  const auto sum = [&](double at_x) {
    return [this, k0, at_x](double z) {
      const Eigen::Vector3d c = in_cone({0, 0, z});
      const double y = -at_x * chisel_slope(z);
      const double dy = at_x * sin_ * cos_ * (1 + tan2_rho_) / k0;
      const double value = c.x() * c.x() + k0 * k0 + at_x * at_x * (cos_ * cos_ - tan2_rho_ * sin_ * sin_) +
                           y * y - tan2_rho_ * c.z() * c.z();
      return std::pair(value, -2 * c.x() * sin_ + 2 * y * dy - 2 * tan2_rho_ * c.z() * cos_);
    };
  };
  const double start = -drill_.drill_diameter_mm / (2 * std::tan(drill_.half_point_angle_deg * rad_per_deg));
  const double at_axis = newton(sum(0), start, "x_mm", 0, scale);
  const double z = x == 0 ? at_axis : newton(sum(x), at_axis, "x_mm", x, scale);
  return {x, -x * chisel_slope(z), z};
}

ChiselEdge DrillPoint::chisel() const {
  const double slope = chisel_slope(chisel_edge(0).z());
  const double core = drill_.core_radius_mm;
  // y falls from 0 at the axis; the straight continuation of the tangent brackets the corner.
  const auto above_core = [&](double x) { return chisel_edge(x).y() + core; };
  if (!(slope > 0)) reject("the chisel edge does not run from the drill axis to y = -core_radius_mm");
  double far = core / slope;
  for (int k = 0; k < 60 && above_core(far) > 0; ++k) far *= 1.25;
  return {find_root(above_core, 0, far), std::atan(slope) / rad_per_deg};
}

}  // namespace verstat::models::k208
