#pragma once
// Magnetic-abrasive finishing of drill flanks in a ring bath (K208): geometry of the conical flanks, cutting
// and chisel edge of a twist drill, and the angle at which the abrasive powder attacks them while the drill
// is carried round the bath.
//
// Heichuk 2011. Lengths in mm, angles in degrees, speeds in m/s. Drill frame: z = 0 at the corner, tip
// towards -z.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k208 {

/// Conically ground twist drill. Defaults other than diameter and point angle are a textbook drill.
struct Drill {
  double drill_diameter_mm = 20;
  double core_radius_mm = 1.5;  // half the web
  double half_point_angle_deg = 60;
  double cone_half_angle_deg = 15;
  double chisel_angle_deg = 55;
  double clearance_deg = 12;  // at the corner
};
/// How the drill is held and moved in the bath. The offsets are those of ordinary processing; azimuth
/// processing uses -10 and 6.3 mm.
struct Bath {
  double tilt_deg = 60;  // from the vertical
  double azimuth_deg = 0;
  double offset_x_mm = -45;
  double offset_z_mm = 0;
  double bath_radius_mm = 95.5;
  double rotor_rpm = 200;
  double spin_rpm = 0;
  double azimuth_rpm = 0;
};

struct OffsetXInputs {
  double zone_width_mm = 0;
  double working_gap_mm = 0;
  double drill_diameter_mm = 20;
  double half_point_angle_deg = 60;
  double tilt_deg = 60;
};
struct OffsetX {
  double tx_max_mm;
};
/// Largest modulus of T_X that keeps the working gap, eq. (1); negative: the drill does not fit.
[[nodiscard]] OffsetX azimuth_offset_x_max(const OffsetXInputs& in);

struct OffsetZInputs {
  double pole_height_mm = 0;
  double drill_diameter_mm = 20;
  double tilt_deg = 60;
};
struct OffsetZ {
  double tz_mm;
};
/// Vertical offset (H - D sin xi) / 2.
[[nodiscard]] OffsetZ azimuth_offset_z(const OffsetZInputs& in);

struct ConeSetup {
  double mu_deg;
  double theta_n_deg;
  double c1;
  double l0_mm;
  double k0_mm;
  double b_mm;
  double delta_z_deg;
};
/// Position of the grinding cone for the wanted clearance and chisel angle, eq. (2), repaired. Error when the
/// drill admits none (l_0 <= 0) or the web is as thick as the drill.
[[nodiscard]] ConeSetup cone_grind_setup(const Drill& in);

struct FlankParameters : Drill {
  std::int64_t surface = 1;
  double u_mm = 0;
  double v_deg = 0;
};
struct Point {
  double x_mm, y_mm, z_mm;
};
/// Point of flank 1 or 2, eqs. (5), (6).
[[nodiscard]] Point flank_point(const FlankParameters& in);

struct FlankLocation : Drill {
  std::int64_t surface = 1;
  double x_mm = 0;
  double y_mm = 0;
  double z_mm = 0;
};
struct Normal {
  double nx, ny, nz;
};
/// Outward unit normal at a point of the flank, nz < 0: gradient of the cone. The point is taken to lie on
/// the flank.
[[nodiscard]] Normal flank_normal(const FlankLocation& in);

struct EdgeRadius : Drill {
  double radius_mm = 0;
};
/// Point of the cutting edge of flank 1 at a radius above the core radius, in the plane y = -r. COMPLETION.
[[nodiscard]] Point cutting_edge_point(const EdgeRadius& in);

struct ChiselPosition : Drill {
  double x_mm = 0;
};
struct ChiselPoint {
  double y_mm, z_mm;
};
/// Point of the chisel edge, intersection of both cones; x = 0 is the drill axis.
[[nodiscard]] ChiselPoint chisel_edge_point(const ChiselPosition& in);

struct ChiselEdge {
  double x_end_mm;
  double chisel_angle_true_deg;
};
/// Corner of the chisel edge at x > 0 (y = -core radius) and its exact angle to the x axis at the drill axis.
[[nodiscard]] ChiselEdge chisel_edge(const Drill& in);

enum class Edge { cutting, chisel };
struct EdgeInputs : Drill, Bath {
  Edge edge = Edge::cutting;
  double position_mm = 0;  // radius on the cutting edge, x on the chisel edge
};
struct AttackInputs : EdgeInputs {
  double spin_angle_deg = 0;
};
struct Attack {
  double chi_deg;
  double speed_m_s, vx_m_s, vy_m_s, vz_m_s;
};
/// Velocity of an edge point in the bath and attack angle of the powder, eq. (6b); positive: the flank runs
/// into the powder. Both edges use the normal of flank 1. Frame chain: COMPLETION. Error without motion.
[[nodiscard]] Attack edge_attack_angle(const AttackInputs& in);

struct CycleInputs : EdgeInputs {
  double step_deg = 1;
};
struct AttackCycle {
  double chi_max_deg, chi_min_deg, chi_mean_deg, active_fraction;
};
/// Attack angle over one drill revolution, samples 0, step, ..., 360 - step; active means chi > 0.
[[nodiscard]] AttackCycle attack_angle_cycle(const CycleInputs& in);

struct Azimuth {
  double azimuth_deg = 0;
};
struct Efficiency {
  double k_kef;
};
/// Kinematic efficiency index by interpolation of three published points, 0..90 deg, feed ratio -3.
[[nodiscard]] Efficiency kinematic_efficiency(const Azimuth& in);

}  // namespace verstat::models::k208

template <>
struct verstat::models::EnumNames<verstat::models::k208::Edge> {
  static constexpr std::array names{std::pair{k208::Edge::cutting, "cutting"},
                                    std::pair{k208::Edge::chisel, "chisel"}};
};
