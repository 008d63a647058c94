#pragma once
// Gear hobbing (K101): geometry and kinematics of a single-start hob cutting a spur or helical gear, chip
// thickness at any point of any tooth as the normal distance to what earlier passes left, tooth loads, and
// the main time with its approach length.
//
// Ravska, Okhrimenko 2011, eqs. (1)-(15), several of them corrected; (C1)-(C5) are completions. Frames: S0
// fixed with the hob axis Z0, S1 turning with the hob, S2 turning with the blank, whose axis is X2.

#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k101 {

enum class HobProfile { convolute, archimedean };
enum class FeedMode { conventional, climb };
/// Parts of the tooth edge in the order of cutting: flank, corner, tip land, corner, flank.
enum class Segment { flank_12, corner_23, tip_34, corner_45, flank_56 };

/// The hob; defaults are the worked example of the paper.
struct HobInputs {
  double module_mm = 5;
  double hob_diameter_mm = 100;
  double hob_tip_radius_mm = 1.5;
  double pressure_angle_deg = 20;
  double hob_addendum_factor = 1.25;
  HobProfile hob_profile = HobProfile::convolute;
};
struct HobGeometry {
  double pitch_radius_mm;
  double lead_angle_deg;
  double helix_parameter_mm_rad;
  double lead_mm;
  double a1_mm;                 // half tooth width extrapolated to the axis
  double tip_centre_radial_mm;  // of the corner arc
  double tip_centre_axial_mm;
  double section_angle_deg;  // beta_1: of the section that holds the outline
};
/// Constants of the hob tooth. COMPLETION (C1), standard hob geometry. Error when the tip radius leaves no
/// tip land or the module reaches the pitch diameter.
[[nodiscard]] HobGeometry hob_geometry(const HobInputs& in);

struct SetupInputs {
  double module_mm = 5;
  std::int64_t gear_teeth = 20;
  double gear_helix_deg = 0;  // right-hand positive
  double profile_shift = 0.4;
  double hob_diameter_mm = 100;
  double hob_addendum_factor = 1.25;
};
struct HobbingSetup {
  double centre_distance_mm;
  double gear_outer_radius_mm;
  double setting_angle_deg;
  double cutting_depth_mm;
  double ratio_i12;
};
/// Setting of hob and blank, beta_set = -(beta_w - gamma). K101 eq. (1), (C1).
[[nodiscard]] HobbingSetup hobbing_setup(const SetupInputs& in);

/// Everything that fixes the process.
struct Hobbing : HobInputs {
  std::int64_t gear_teeth = 20;
  double gear_helix_deg = 0;
  double profile_shift = 0.4;
  std::int64_t hob_gashes = 10;
  double axial_feed_mm_rev = 2;  // per blank revolution
  FeedMode feed_mode = FeedMode::climb;
};

struct KinematicsInputs : Hobbing {
  double hob_angle_deg = 0;
};
struct HobbingKinematics {
  double blank_angle_deg;
  double axial_travel_mm;
};
/// Blank rotation and axial hob travel at a hob rotation. K101 eqs. (2), repaired: the feed is missing in
/// print; (3).
[[nodiscard]] HobbingKinematics hobbing_kinematics(const KinematicsInputs& in);

struct EdgePointInputs : Hobbing {
  Segment segment = Segment::flank_12;
  double parameter = 0;  // u or u_1 in mm on the straight parts, mu in degrees on the corners
  std::int64_t tooth_index = 0;
};
struct EdgePoint {
  double x1_mm;
  double y1_mm;
  double z1_mm;
};
/// A point of a tooth edge in the hob frame. K101 eq. (5) with beta_1 = -gamma for convolute hobs, repaired.
[[nodiscard]] EdgePoint hob_edge_point(const EdgePointInputs& in);

struct BlankPointInputs : Hobbing {
  double x1_mm = 0;
  double y1_mm = 0;
  double z1_mm = 0;
  double hob_angle_deg = 0;
};
struct BlankPoint {
  double x2_mm;
  double y2_mm;
  double z2_mm;
};
/// A point of the hob frame in the blank frame. K101 eq. (4), repaired: one row of the matrix is misprinted.
[[nodiscard]] BlankPoint hob_point_in_blank_frame(const BlankPointInputs& in);

struct ApproachInputs {
  double centre_distance_mm = 0;
  double hob_diameter_mm = 100;
  double gear_outer_radius_mm = 0;
  double setting_angle_deg = 0;
};
struct Approach {
  double approach_length_mm;
  double contact_angle_deg;  // on the blank cylinder
};
/// Axial distance of the hob centre at first contact of the tip cylinders; 0 and 90 deg when they do not
/// meet. K101 eq. (7), repaired.
[[nodiscard]] Approach hob_approach_length(const ApproachInputs& in);

struct MainTimeInputs {
  double approach_length_mm = 0;
  double face_width_mm = 0;
  double axial_feed_mm_rev = 2;
  std::int64_t gear_teeth = 20;
  double hob_speed_rpm = 0;
  std::int64_t hob_starts = 1;
};
struct MainTime {
  double hob_rotation_rad;
  double hob_revolutions;
  double main_time_min;
};
/// Hob rotation and main time of one gear, phi = 2 pi (2L + B) Z_k/(S z_0). K101 eq. (8).
[[nodiscard]] MainTime hobbing_main_time(const MainTimeInputs& in);

struct ContactArcInputs {
  double centre_distance_mm = 0;
  double hob_diameter_mm = 100;
  double gear_outer_radius_mm = 0;
};
struct ContactArc {
  double entry_angle_deg;
  double exit_angle_deg;
};
/// Arc of the hob in which a tooth is in the blank, mid-plane and zero swivel. K101 eq. (9).
[[nodiscard]] ContactArc hob_contact_arc(const ContactArcInputs& in);

struct EngagedInputs {
  double tooth_angle_deg = 0;
  double entry_angle_deg = 0;
  double exit_angle_deg = 0;
};
struct Engaged {
  bool engaged;
};
/// Whether a tooth is in the arc, angle modulo 360, ends included. K101 eq. (12).
[[nodiscard]] Engaged hob_tooth_engaged(const EngagedInputs& in);

struct WorkingTeethInputs : ApproachInputs {
  double lead_mm = 0;
  std::int64_t hob_gashes = 10;
};
struct WorkingTeeth {
  double zone_half_length_mm;
  std::int64_t teeth_in_zone;
};
/// Teeth within the intersection of the tip cylinders along the hob axis. COMPLETION (C2).
[[nodiscard]] WorkingTeeth hob_working_teeth(const WorkingTeethInputs& in);

struct ToothPointInputs : EdgePointInputs {
  double tooth_angle_deg = 0;  // theta = t_j + phi01, 270 = nearest to the blank axis
};
struct VelocityInputs : ToothPointInputs {
  std::optional<double> hob_speed_rpm = {};
};
struct RelativeVelocity {
  double vx_mm_rad;
  double vy_mm_rad;
  double vz_mm_rad;
  std::optional<double> speed_m_min;
};
/// Velocity of an edge point relative to the blank per radian of hob rotation, components in S0. K101 eq.
/// (10), repaired.
[[nodiscard]] RelativeVelocity hob_relative_velocity(const VelocityInputs& in);

struct SurfaceNormal {
  double nx;
  double ny;
  double nz;
};
/// Unit normal of the cutting surface in the blank frame, into the tooth body. K101 eq. (11).
[[nodiscard]] SurfaceNormal cutting_surface_normal(const ToothPointInputs& in);

struct ChipInputs : ToothPointInputs {
  std::int64_t previous_blank_revs = 4;
  bool blank_limited = false;
  std::optional<double> face_width_mm = {};
  std::int64_t hob_turns = 0;
};
struct Chip {
  double chip_thickness_mm;
};
/// Chip thickness at an edge point: distance along the surface normal to what earlier teeth and blank
/// revolutions left, or to the boundary of the blank. K101 eqs. (13)-(15), steps 1-9.
[[nodiscard]] Chip hobbing_chip_thickness(const ChipInputs& in);

struct ToothLoadInputs : Hobbing {
  std::int64_t tooth_index = 0;
  double tooth_angle_deg = 0;
  std::int64_t n_flank = 16;
  std::int64_t n_round = 5;
  std::int64_t n_tip = 7;
  std::optional<double> kc11_n_mm2 = {};
  std::optional<double> mc = {};
};
struct ToothLoad {
  double max_chip_thickness_mm;
  double contact_length_mm;  // edge with a chip above 1e-4 mm
  double chip_section_mm2;
  std::optional<double> cutting_force_n;  // Kienzle, when both constants are given
};
/// Load of one tooth at one angle by the trapezoidal rule along its edge. K101, (C4).
[[nodiscard]] ToothLoad hobbing_tooth_load(const ToothLoadInputs& in);

struct LoadSummaryInputs : Hobbing {
  double angle_step_deg = 1.5;
};
struct LoadSummary {
  double max_chip_thickness_mm;
  double chip_volume_per_gap_mm3;  // and blank revolution
  std::int64_t most_loaded_tooth;
  double most_loaded_share;
  std::int64_t first_tooth_index;
  std::vector<double> tooth_shares;
};
/// Sweep of all teeth over the whole arc: largest chip, removed volume and its distribution over the teeth.
/// K101, (C3).
[[nodiscard]] LoadSummary hobbing_load_summary(const LoadSummaryInputs& in);

struct HoffmeisterInputs {
  double module_mm = 5;
  std::int64_t gear_teeth = 20;
  double gear_helix_deg = 0;
  double profile_shift = 0.4;
  double hob_diameter_mm = 100;
  std::int64_t hob_gashes = 10;
  std::int64_t hob_starts = 1;
  double axial_feed_mm_rev = 2;
  double cutting_depth_mm = 0;
};
struct HoffmeisterChip {
  double max_chip_thickness_mm;
};
/// Fast estimate of the largest head chip thickness. COMPLETION (C5), Hoffmeister; helix angle in degrees.
[[nodiscard]] HoffmeisterChip hoffmeister_chip_thickness(const HoffmeisterInputs& in);

}  // namespace verstat::models::k101

template <>
struct verstat::models::EnumNames<verstat::models::k101::HobProfile> {
  static constexpr std::array names{std::pair{k101::HobProfile::convolute, "convolute"},
                                    std::pair{k101::HobProfile::archimedean, "archimedean"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k101::FeedMode> {
  static constexpr std::array names{std::pair{k101::FeedMode::conventional, "conventional"},
                                    std::pair{k101::FeedMode::climb, "climb"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k101::Segment> {
  using E = k101::Segment;
  static constexpr std::array names{std::pair{E::flank_12, "12"}, std::pair{E::corner_23, "23"},
                                    std::pair{E::tip_34, "34"}, std::pair{E::corner_45, "45"},
                                    std::pair{E::flank_56, "56"}};
};
