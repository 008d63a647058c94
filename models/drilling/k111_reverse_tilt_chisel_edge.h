#pragma once
// Chisel edge of a twist drill ground with plane flanks (K111): the standard ridge between the two flanks,
// and the new point in which a narrow slot with walls parallel to the axis, cut across the web at a reverse
// inclination, makes a chisel edge of zero rake. Static angles, angles in work, the feed they allow.
//
// Ravska, Besarabets, Plivak 2011, eqs. (1)-(8), two of them corrected; (9), (10) derived from them.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k111 {

/// Plane-ground point: half point angle 45..75, periphery clearance 5..30 deg, core radius below drill
/// radius.
struct DrillPoint {
  double half_point_angle_deg = 0;
  double clearance_periphery_deg = 0;
  double core_radius_mm = 0;
  double drill_radius_mm = 0;
};

struct StandardChisel {
  double mu_deg;
  double theta_p_deg;      // clearance of the flank in the section perpendicular to the axis; may be negative
  double chisel_tilt_deg;  // in plan, between chisel and main edge
  double chisel_half_length_mm;
  double chisel_clearance_deg;
  double chisel_rake_deg;
};
/// Chisel edge of the standard drill. sin(mu) = r/R, tan(Theta) = tan(alpha) tan(phi)/cos(mu) - tan(mu) (4),
/// psi_st = 90 - Theta (1), tan(alpha_ch) = cot(phi)/cos(Theta), gamma_ch = alpha_ch - 90 (3).
[[nodiscard]] StandardChisel standard_chisel_geometry(const DrillPoint& in);

struct MainEdgePoint : DrillPoint {
  double radius_mm = 0;
};
struct MainEdgeClearance {
  double clearance_deg;
};
/// Static clearance of the main edge in the plane tangent to the cylinder of a radius, from the chisel
/// junction to the periphery. K111 eq. (2).
[[nodiscard]] MainEdgeClearance main_edge_clearance(const MainEdgePoint& in);

struct SlottedPoint : DrillPoint {
  double reverse_tilt_deg = 0;  // psi, from the perpendicular to the main edge
};
struct SlottedChisel {
  double theta_p_deg;
  double tilt_from_standard_deg;  // Theta + psi
  double chisel_half_point_deg;
  double clearance_axial_deg;   // section perpendicular to the slot wall, parallel to the axis
  double clearance_normal_deg;  // section normal to the edge
  double rake_deg;
};
/// Static angles of the slotted chisel, 0 < Theta + psi < 90. K111 (5), (6) as printed and (6c) corrected for
/// the section normal to the edge.
[[nodiscard]] SlottedChisel slotted_chisel_geometry(const SlottedPoint& in);

struct WorkingPoint : SlottedPoint {
  double slot_width_mm = 0;
  double feed_mm_rev = 0;
  double radius_mm = 0;
};
struct SlottedKinematics {
  double delta_deg;
  double mu_point_deg;
  double tau_deg;
  double tau_printed_deg;  // the paper's formula, for record only
  double kinematic_clearance_deg;
  double kinematic_rake_deg;
};
/// Angles in work at one point of the slotted chisel, slot/2 < radius <= R. K111 (7c), corrected: the feed
/// term carries the sine of the half point angle; alpha_k = alpha_n - tau, gamma_k = tau (8).
[[nodiscard]] SlottedKinematics slotted_chisel_kinematics(const WorkingPoint& in);

struct FeedLimitInputs : SlottedPoint {
  double slot_width_mm = 0;
  double radius_mm = 0;
  double min_kinematic_clearance_deg = 0;
};
struct FeedLimit {
  double max_feed_mm_rev;
};
/// Largest feed with at least a given kinematic clearance (0 to below 90) at a radius; 0 or less means
/// infeasible. K111 (10), derived.
[[nodiscard]] FeedLimit slotted_chisel_max_feed(const FeedLimitInputs& in);

struct RubbingInputs : SlottedPoint {
  double slot_width_mm = 0;
  double feed_mm_rev = 0;
  double min_kinematic_clearance_deg = 0;
};
struct Rubbing {
  double rubbing_radius_mm;
};
/// Radius inside which the kinematic clearance is below the minimum; half the slot when the whole edge
/// clears, not clipped at its outer end. The minimum must be below the static normal clearance. K111 (10),
/// derived.
[[nodiscard]] Rubbing slotted_chisel_rubbing_radius(const RubbingInputs& in);

struct ThrustShares {
  double chisel_share = 0;
  double chisel_force_ratio = 0;
};
struct ThrustRatio {
  double thrust_ratio;
};
/// Thrust of the modified point over the standard one, 1 - k (1 - kappa). COMPLETION (C1).
[[nodiscard]] ThrustRatio drill_thrust_ratio(const ThrustShares& in);

}  // namespace verstat::models::k111
