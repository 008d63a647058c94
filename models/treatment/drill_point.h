#pragma once
// The conical flanks of a twist drill behind K208: cone position, flank normal, cutting and chisel edge.

#include <Eigen/Core>

#include "models/treatment/k208_drill_flank_kinematics.h"

namespace verstat::models::k208 {

class DrillPoint {
 public:
  /// Throws DomainError when the drill admits no cone position.
  explicit DrillPoint(const Drill& drill);

  [[nodiscard]] const ConeSetup& setup() const { return setup_; }
  [[nodiscard]] Eigen::Vector3d flank(double u_mm, double v_rad) const;              ///< of flank 1
  [[nodiscard]] Eigen::Vector3d outward_normal(const Eigen::Vector3d& point) const;  ///< of flank 1
  [[nodiscard]] Eigen::Vector3d cutting_edge(double radius_mm) const;
  [[nodiscard]] Eigen::Vector3d chisel_edge(double x_mm) const;
  [[nodiscard]] ChiselEdge chisel() const;

 private:
  // Point in the frame of the cone of flank 1; F = X^2 + Y^2 - Z^2 tan^2 rho.
  [[nodiscard]] Eigen::Vector3d in_cone(const Eigen::Vector3d& point) const;
  // y of the chisel edge per x, negative: the edge lies at y = -slope x.
  [[nodiscard]] double chisel_slope(double z_mm) const;

  Drill drill_;
  ConeSetup setup_;
  double sin_, cos_;  // of delta_z
  double tan2_rho_;   // tan^2 of the cone's half angle
  double tan_rho_;
};

}  // namespace verstat::models::k208
