#pragma once
// Contact of a hyperboloid tool and the gear it finishes (K405): sliding and sum velocities, the angle
// between sliding and contact line, reduced curvature, roll-over, deviations of measured points, pressure and
// time.
//
// Vorontsov 2011. The paper names the indicators and prints no formulas: all are COMPLETION (kinematics of
// crossed axes, Hertz). Lengths in mm, angles in degrees, n in rpm, speeds in m/min.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k405 {

struct ContactPoint {
  double x_mm = 0, y_mm = 0, z_mm = 0;
  double centre_distance_mm = 0;
  double shaft_angle_deg = 0;
  double gear_rpm = 0;
  double tool_rpm = 0;
};
struct ContactVelocities {
  double gear_m_min, tool_m_min;
  double rel_x_m_min, rel_y_m_min, rel_z_m_min, rel_m_min;
};
/// Speeds of both bodies at a point and the velocity of the tool relative to the gear, (C1). Gear axis = z;
/// tool axis through (A, 0, 0) with direction (0, sin S, cos S). Speeds signed.
[[nodiscard]] ContactVelocities contact_velocities(const ContactPoint& in);

struct SlidingDirection {
  double vx = 0, vy = 0, vz = 0;
  double tx = 0, ty = 0, tz = 0;
};
struct Angle {
  double angle_deg;
};
/// Angle 0..90 between the relative velocity and the tangent of the contact line, (C2). Error for a zero
/// vector.
[[nodiscard]] Angle sliding_contact_angle(const SlidingDirection& in);

struct CrossedGears {
  double module_mm = 0;
  std::int64_t gear_teeth = 1;
  double gear_helix_deg = 0;
  std::int64_t tool_teeth = 1;
  double tool_helix_deg = 0;
};
struct CrossedPairInputs : CrossedGears {
  double tool_rpm = 0;
};
struct CrossedPair {
  double shaft_angle_deg;
  double gear_diameter_mm, tool_diameter_mm, centre_distance_mm;
  double gear_rpm;
  double pitch_gear_m_min, sliding_m_min;
};
/// Pitch diameters, centre distance and speeds of a crossed helical pair, (C3). Helix angles signed (right
/// hand positive); the shaft angle is their signed sum.
[[nodiscard]] CrossedPair crossed_pair(const CrossedPairInputs& in);

struct SlidingTarget : CrossedGears {
  double sliding_m_min = 0;
};
struct ToolSpeed {
  double tool_rpm;
};
/// Tool speed for a sliding speed: inverse of crossed_pair. Error for a shaft angle of 0.
[[nodiscard]] ToolSpeed tool_speed_for_sliding(const SlidingTarget& in);

struct ContactPaths {
  double gear_path_mm = 0;
  double tool_path_mm = 0;
  double tool_turn_deg = 0;
  double tool_rpm = 0;
};
struct ContactPointSpeeds {
  double gear_m_min, tool_m_min, sum_m_min, slide_m_min, time_s;
};
/// Speeds of the contact point on both surfaces from its paths between two contact lines, eq. (1) in words.
[[nodiscard]] ContactPointSpeeds contact_point_speeds(const ContactPaths& in);

struct ContactRadii {
  double gear_mm = 0;
  double tool_mm = 0;
  bool gear_concave = false;
};
struct ReducedCurvature {
  double curvature_per_mm;
  double radius_mm;  // 1e300 for curvature 0, negative = interference
};
/// Reduced curvature of a convex tool and a convex or concave gear, (C4).
[[nodiscard]] ReducedCurvature reduced_curvature(const ContactRadii& in);

struct RollingInputs {
  double phi_from_deg = 0;
  double phi_to_deg = 0;
  double tool_rpm = 0;
  std::int64_t tool_teeth = 1;
};
struct RollingWindow {
  double window_deg, time_s, pairs_in_contact;
};
/// Tool rotation over which contact rolls across the gear, (C5); below one pair the mesh is interrupted.
[[nodiscard]] RollingWindow rolling_window(const RollingInputs& in);

struct Deviations {
  std::vector<double> values;
};
struct DeviationStatistics {
  double max, min, range, mean, rms;
};
/// Statistics of normal deviations from the model surface, rms about zero, (C6).
[[nodiscard]] DeviationStatistics surface_deviation(const Deviations& in);

struct GeneratingInputs {
  double face_width_mm = 0;
  double overrun_mm = 0;
  double axial_feed_mm_rev = 0;
  double gear_rpm = 0;
  std::int64_t passes = 1;
};
struct GeneratingTime {
  double time_min;
};
/// Main time, passes (B + overrun) / (s_a n_g), (C7).
[[nodiscard]] GeneratingTime generating_time(const GeneratingInputs& in);

struct LineContact {
  double load_n_mm = 0;
  double reduced_radius_mm = 0;
  double e1_mpa = 0, nu1 = 0;
  double e2_mpa = 0, nu2 = 0;
};
struct LineContactPressure {
  double half_width_mm, p_max_mpa;
};
/// Hertz line contact, (C8).
[[nodiscard]] LineContactPressure line_contact_pressure(const LineContact& in);

}  // namespace verstat::models::k405
