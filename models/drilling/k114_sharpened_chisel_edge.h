#pragma once
// Twist drills with a sharpened, roof-shaped chisel edge (K114): clearance and rake of the chisel edge by the
// setting angles of the two planes ground on each half, the settings for wanted angles, and two conventional
// points to compare with.
//
// Kovaleva, Rodin, Plivak 2011, eqs. (1)-(2); (3)-(6) derived or completed. All angles in degrees: psi slope
// of the chisel edge in plan (0..90), phi_c half angle of the roof (0..90, 90 = horizontal), eps1 and eps2
// setting angles of flank and face, from the axis direction.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k114 {

struct Edge {
  double psi_deg = 0;
  double phi_c_deg = 0;
};

struct FlankSetting : Edge {
  double eps1_deg = 0;
};
struct Clearance {
  double alpha_c_deg;
};
/// Clearance in the section normal to the chisel edge,
///   tan(alpha_c) = (sin phi_c cos eps1 + cos phi_c sin eps1 sin psi) / (sin eps1 cos psi).
/// K114 eq. (1) in its compact form (1c).
[[nodiscard]] Clearance chisel_edge_clearance(const FlankSetting& in);

struct FaceSetting : Edge {
  double eps2_deg = 0;
  std::int64_t sign = 1;  // -1: as printed
};
struct Rake {
  double gamma_c_deg;
};
/// Rake in the section normal to the chisel edge,
///   tan(gamma_c) = sin eps2 cos psi / (sin phi_c cos eps2 + sign cos phi_c sin eps2 sin psi).
/// K114 eq. (2), repaired: printed with the minus sign, which contradicts the paper's own numbers.
[[nodiscard]] Rake chisel_edge_rake(const FaceSetting& in);

struct Limits {
  double alpha_min_deg;
  double gamma_max_deg;
};
/// Clearance at eps1 = 90 and rake at eps2 = 90: alpha_min = atan(cos phi_c tan psi), gamma_max = 90 -
/// alpha_min. K114 (3).
[[nodiscard]] Limits chisel_edge_limits(const Edge& in);

struct Targets : Edge {
  double alpha_target_deg = 0;
  double gamma_target_deg = 0;
};
struct Settings {
  double eps1_deg;
  double eps2_deg;
  bool feasible;
};
/// Setting angles for a wanted clearance and rake, K114 (4): the inversion of (1c) and (2c). Feasible when
/// the targets are within the limits (3) and leave a wedge, alpha + gamma < 90; otherwise the angles are for
/// information only.
[[nodiscard]] Settings chisel_edge_setting_angles(const Targets& in);

struct OnePlanePoint {
  double two_phi_deg = 0;
  double psi_deg = 0;
};
/// Chisel rake of the conventional one-plane point, -(90 - atan(cot phi / sin psi)). COMPLETION (5).
[[nodiscard]] Rake flat_flank_chisel_rake(const OnePlanePoint& in);

struct TwoPlanePoint {
  double two_phi_deg = 0;
  double psi_deg = 0;
  double alpha_periphery_deg = 0;
  double core_ratio = 0;  // core over drill diameter
};
struct TwoPlaneChisel {
  double phi_c_deg;     // above 90: recessed centre
  double flank1_slope;  // tangents
  double flank2_slope;
};
/// Half angle of the chisel edge of a point ground with two planes per flank. COMPLETION (6).
[[nodiscard]] TwoPlaneChisel two_plane_chisel_plan_angle(const TwoPlanePoint& in);

}  // namespace verstat::models::k114
