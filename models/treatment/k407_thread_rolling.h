#pragma once
// External thread rolling between two rollers: geometry of the roller ridges sunk into the blank, extruded
// height, the step-by-step displaced areas, the fitted radial force, drive and cycle time, blank diameter
// (K407).
//
// Lipka 2011. Lengths mm, areas mm2, forces kN, pressures MPa.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k407 {

/// Axial profile of one roller ridge: flat tip of the width tip_flat_mm, or (radius > 0) a rounded tip
/// tangent to the flanks.
struct RidgeShape {
  double pitch_mm = 0;
  double half_angle_deg = 30;
  double tip_flat_mm = 0;
  double tip_radius_mm = 0;
};
struct SunkRidge : RidgeShape {
  double depth_mm = 0;
};
struct RidgeProfile {
  double area_mm2;
  double perimeter_mm;
  double width_mm;  // at the surface of the blank
  double gap_mm;    // A of eq. (6): gap between ridges at zero depth
  double closing;   // B of eq. (6): narrowing of the gap per mm
};
/// One ridge sunk by a depth. COMPLETION of the tables the paper refers to.
[[nodiscard]] RidgeProfile ridge_profile(const SunkRidge& in);

struct Extrusion {
  double gap_mm = 0;
  double closing = 0;
  double depth_mm = 0;
  double area_mm2 = 0;
};
struct ExtrudedHeight {
  double height_mm;
};
/// Height to which the displaced area rises in the gap between ridges, eq. (6).
[[nodiscard]] ExtrudedHeight extrusion_height(const Extrusion& in);

struct ThreadProfile : RidgeShape {
  double profile_height_mm = 0;
  double half_tolerance_mm = 0;
  double minor_diameter_mm = 0;
};
struct SizingRidge {
  double full_mm;         // t'
  double penetration_mm;  // H_cal
  double extruded_mm;     // H_ext at H_cal
  double blank_mm;        // plane model
  double blank_exact_mm;  // equal ring volumes
};
/// Penetration of the sizing ridges for a full profile, and the blank that fills it.
[[nodiscard]] SizingRidge calibrating_penetration(const ThreadProfile& in);

struct RollerContact {
  double blank_radius_mm = 0;
  double roller_radius_mm = 0;
  double depth_mm = 0;
};
struct ContactArc {
  double chord_mm;  // X: from the centre of the blank to the common chord
  double gamma_deg;
  double arc_mm;
};
/// Arc of contact of the roller, eq. (5), repaired: sqrt(R^2 - X^2).
[[nodiscard]] ContactArc contact_arc(const RollerContact& in);

struct RidgeSequence : RidgeShape {
  std::vector<double> drops_mm;
  double sizing_depth_mm = 0;
  double blank_radius_mm = 0;
  double roller_radius_mm = 0;
  std::int64_t sizing_turns = 1;
};
struct TurnSequence {
  std::vector<double> depth_mm, own_depth_mm, extruded_mm, displaced_mm2, perimeter_mm, arc_mm;
  double displaced_mean_mm2;
  double perimeter_mean_mm;
  double arc_mean_mm;
  double sizing_perimeter_mm;
  double layer_mm;
  double contact_area_mm2;
};
/// What every lead-in ridge of one roller displaces, in ten steps.
[[nodiscard]] TurnSequence turn_sequence(const RidgeSequence& in);

struct RollingZone {
  double layer_mm = 0;
  double perimeter_mean_mm = 0;
  double arc_mean_mm = 0;
  double sizing_perimeter_mm = 0;
  double coefficient = 9.4;  // eq. (7)
  double layer_exponent = 0.34;
  double area_exponent = 0.58;
  double sizing_exponent = 0.13;
  double tangential_ratio = 0.135;
};
struct RollingForce {
  double radial_kn, tangential_kn;
  double pressure_mpa;
  bool in_range;
};
/// Radial and tangential force, eq. (3), (7).
[[nodiscard]] RollingForce rolling_radial_force(const RollingZone& in);

struct BlankQuality {
  double form = 1, hardness = 1, diameter = 1, location = 1;  // K1..K4
  double base = 1;
};
struct ForceCoefficient {
  double coefficient;
};
/// Coefficient of eq. (1) from the blank-quality factors, eq. (4).
[[nodiscard]] ForceCoefficient force_coefficient(const BlankQuality& in);

enum class StrengthProperty { tension_static, shear_static, bending_fatigue, axial_fatigue };
struct StrengthQuestion {
  StrengthProperty property = StrengthProperty::tension_static;
};
struct StrengthFactor {
  double low, high;
};
/// Strength of a rolled over that of a cut thread.
[[nodiscard]] StrengthFactor rolled_thread_strength(const StrengthQuestion& in);

struct RollingLoad {
  double radial_kn = 0;
  double tangential_ratio = 0.135;
  double roller_diameter_mm = 0;
  double speed_m_min = 0;
  std::int64_t rollers = 2;
};
struct RollingDrive {
  double torque_nm;  // per roller
  double power_kw;
};
/// Drive load of the rollers. COMPLETION.
[[nodiscard]] RollingDrive rolling_drive(const RollingLoad& in);

struct PlungeCycle {
  double sizing_depth_mm = 0;
  double approach_mm = 0;
  double feed_mm_rev = 0;
  double sizing_revolutions = 0;
  double speed_m_min = 0;
  double blank_diameter_mm = 0;
  double roller_diameter_mm = 0;
  double handling_min = 0;
};
struct PlungeTime {
  double blank_rpm, roller_rpm;
  double rolling_min, cycle_min;
};
/// Speeds and times of plunge rolling. COMPLETION.
[[nodiscard]] PlungeTime plunge_cycle_time(const PlungeCycle& in);

}  // namespace verstat::models::k407

template <>
struct verstat::models::EnumNames<verstat::models::k407::StrengthProperty> {
  static constexpr std::array names{std::pair{k407::StrengthProperty::tension_static, "tension_static"},
                                    std::pair{k407::StrengthProperty::shear_static, "shear_static"},
                                    std::pair{k407::StrengthProperty::bending_fatigue, "bending_fatigue"},
                                    std::pair{k407::StrengthProperty::axial_fatigue, "axial_fatigue"}};
};
