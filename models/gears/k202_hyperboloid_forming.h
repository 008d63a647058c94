#pragma once
// Forming of hyperboloid gears with a cylindrical gear-like tool on a hobbing machine (K202): coordinate
// transformation tool to gear, geometry of the producing surface, meshing, blank shape, cutting speed and
// time. Crossed axes; kinematically gear skiving.
//
// Vitrenko, Voronov, Kashura, Kuznetsova 2011. Lengths in mm, angles in degrees, curvature in 1/mm.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k202 {

struct ToolPoint {
  double x1_mm = 0, y1_mm = 0, z1_mm = 0;
  double phi1_deg = 0;
  double ratio_u21 = 0;
  double center_distance_mm = 0;
  double shaft_angle_deg = 0;
};
struct GearPoint {
  double x2_mm, y2_mm, z2_mm;
};
/// Point of the tool in the gear's frame, eq. (2), repaired so that the map is a rigid motion. phi2 = phi1
/// u21.
[[nodiscard]] GearPoint tool_to_gear_transform(const ToolPoint& in);

struct ProfileDerivatives {
  double df1 = 0, df2 = 0, d2f1 = 0, d2f2 = 0;
};
struct SurfaceGeometry {
  double nx, ny, nz;
  double e1, f1, g1;
  double l1, m1, n1;
  double k_mu, k_lambda;
};
/// Unit normal, first and second quadratic form and principal curvatures of the tool tooth surface, eqs.
/// (5)-(11). Repaired: sign of n_y and of K_mu. Error where df1 = df2 = 0.
[[nodiscard]] SurfaceGeometry producing_surface_geometry(const ProfileDerivatives& in);

struct Direction {
  double l1 = 0, e1 = 0, g1 = 0;
  double dlambda = 0, dmu = 0;
};
struct Curvature {
  double k;
};
/// Normal curvature in a direction, eq. (10). Error for a zero direction.
[[nodiscard]] Curvature normal_curvature(const Direction& in);

struct BlankSection {
  double z2_mm = 0;
  double center_distance_mm = 0;
  double tool_radius_mm = 0;
  double shaft_angle_deg = 0;
};
struct BlankRadius {
  double radius_mm;
};
/// Radius of the hyperboloid of the tool's generator nearest to the gear axis,
/// sqrt((a_w - r)^2 + z2^2 tan^2 gamma). 0 < r < a_w, 0..89 deg.
[[nodiscard]] BlankRadius hyperboloid_blank_radius(const BlankSection& in);

struct GearPair {
  double module_mm = 0;
  std::int64_t tool_teeth = 12;
  std::int64_t gear_teeth = 12;
  double shaft_angle_deg = 1;
};
struct Setup {
  double tool_pitch_radius_mm;
  double gear_throat_radius_mm;
  double center_distance_mm;
  double ratio_u21;
};
/// r1 = m z1 / 2, r2 = m z2 / (2 cos gamma), a_w = r1 + r2, u21 = -z1/z2 (external). COMPLETION; spur tool.
[[nodiscard]] Setup generating_setup(const GearPair& in);

struct SlidingInputs {
  double tool_pitch_radius_mm = 0;
  double tool_speed_rpm = 0;
  double shaft_angle_deg = 0;
};
struct CuttingSpeed {
  double vc_m_min;
};
/// Sliding speed at the pitch point, 2 pi r1 n1 tan(gamma). Derived from eq. (2).
[[nodiscard]] CuttingSpeed sliding_cutting_speed(const SlidingInputs& in);

struct InvoluteInputs {
  double module_mm = 0;
  std::int64_t tool_teeth = 12;
  double pressure_angle_deg = 20;
  double t = 0;
};
struct InvoluteProfile {
  double f1_mm, f2_mm;
  double df1, df2, d2f1, d2f2;
};
/// Involute profile of the tool with the roll parameter 0 < t < 1.2 (tan alpha at the pitch circle), and its
/// derivatives. COMPLETION: the paper leaves the profile open.
[[nodiscard]] InvoluteProfile involute_tool_profile(const InvoluteInputs& in);

struct ContactInputs {
  double x1_mm = 0, y1_mm = 0;
  double nx = 0, ny = 0;
  double phi1_deg = 0;
  double ratio_u21 = 0;
  double center_distance_mm = 0;
  double shaft_angle_deg = 0;
};
struct ContactMu {
  double mu_mm;
};
/// Axial position at which a profile point is in contact, from n.v12 = 0. COMPLETION (Litvin). The normal
/// need not be of unit length. Error where its rotated x component vanishes.
[[nodiscard]] ContactMu contact_mu(const ContactInputs& in);

struct ToothInputs : GearPair {
  double pressure_angle_deg = 20;
  double t = 0;
  double phi1_deg = 0;
};
struct ToothPoint {
  double x2_mm, y2_mm, z2_mm, mu_mm;
};
/// Point of the generated tooth surface: involute tool, meshing, eq. (2).
[[nodiscard]] ToothPoint gear_tooth_point(const ToothInputs& in);

struct GenerationInputs {
  double face_width_mm = 0;
  double overrun_mm = 0;
  double shaft_angle_deg = 0;
  double feed_mm_rev = 0;
  double tool_speed_rpm = 0;
  std::int64_t tool_teeth = 12;
  std::int64_t gear_teeth = 12;
  std::int64_t passes = 1;
};
struct GenerationTime {
  double gear_speed_rpm, travel_mm, time_min;
};
/// Main time along the generator, feed per gear revolution. COMPLETION.
[[nodiscard]] GenerationTime gear_generation_time(const GenerationInputs& in);

}  // namespace verstat::models::k202
