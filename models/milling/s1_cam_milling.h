#pragma once
// Milling of cams with one cylindrical cutter whose axis is turned against the cam's (S1): the tool surface
// in the frame of the turning part, the contact, the setting and rotation law that keep contour feed and
// depth constant, and what the usual scheme with uniform rotation loses against it.
//
// Sliednikova, Vynnyk, Skliar, Aksonova 2019. Part axis z; Y horizontal and X vertical distance of the axes;
// the cam is given by its support function h of the direction of its outward normal.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::s1 {

/// Three-arc cam, COMPLETION C1: base circle at the origin, nose circle on the x axis, convex flanks.
struct Cam {
  double r_base_mm = 0;
  double r_nose_mm = 0;
  double centre_distance_mm = 0;  // base centre to nose centre
  double r_flank_mm = 0;          // larger than base and nose radius
};

struct ToolPlacement {
  double tool_z_mm = 0;  // along the tool axis from the pivot section
  double tool_radius_mm = 0;
  double orientation_deg = 0;  // alpha, crossing of the axes
  double x_mm = 0;             // settings X, Y, Z of eq. (5)
  double y_mm = 0;
  double z_mm = 0;
  double part_angle_deg = 0;
};
struct ToolPoint : ToolPlacement {
  double tool_angle_deg = 0;
};
struct PartPoint {
  double x_part_mm;
  double y_part_mm;
  double z_part_mm;
};
/// Point of the cutter surface in the part frame. S1 eq. (7), repaired: the print carries the part angle
/// where the tool angle belongs and a stray matrix.
[[nodiscard]] PartPoint tool_point_in_part(const ToolPoint& in);

struct MovingTool : ToolPlacement {
  double dx_mm_rad = 0;  // derivatives of the settings by the part angle
  double dy_mm_rad = 0;
  double dz_mm_rad = 0;
};
struct ContactPoint : PartPoint {
  double tool_angle_deg;  // 90 to 270
};
/// Where one height of the cutter touches the surface it generates: the triple product of eq. (8) is zero,
///   theta_f = pi - atan[(X cos a + Z_k sin a + Y') / (Y cos a - X' + Z' sin a)].
/// Error when the denominator is zero. S1 eq. (8), solved in closed form.
[[nodiscard]] ContactPoint contact_point(const MovingTool& in);

struct CamOnly {
  Cam cam;
};
struct CamGeometry {
  double nose_joint_deg;  // direction of the normal at the joint of nose and flank
  double base_joint_deg;
  double lift_mm;
  double perimeter_mm;
};
/// Joints of the arcs, lift and contour length; error when the arcs do not join. COMPLETION C1.
[[nodiscard]] CamGeometry cam_geometry(const CamOnly& in);

struct CamAtNormal : CamOnly {
  double normal_angle_deg = 0;  // from the direction of the nose
};
struct CamSupport {
  double support_mm;                 // h
  double support_derivative_mm_rad;  // h'
  double curvature_radius_mm;        // rho = h + h''
  double x_mm;
  double y_mm;
};
/// Support function and point of the cam with the given outward normal, any angle; a joint belongs to the
/// arc nearer the nose. COMPLETION C1.
[[nodiscard]] CamSupport cam_support(const CamAtNormal& in);

struct CamSetting : CamAtNormal {
  double tool_radius_mm = 0;
  double orientation_deg = 0;
};
struct ToolSetting {
  double y_mm;
  double x_vertical_mm;  // for the machine's vertical axis
  double x_model_mm;     // X of eq. (5), a shift in the tilted frame
};
/// Cutter position with the contact in the horizontal plane: Y = h + R, X = -h' (in the tilted frame
/// -h'/cos alpha). |alpha| < 90 deg. Derived from the paper's rule and eq. (8).
[[nodiscard]] ToolSetting cam_tool_setting(const CamSetting& in);

struct CamFeed : CamAtNormal {
  double contour_feed_mm_min = 0;
};
struct RotationLaw {
  double part_speed_rpm;
  double feed_y_mm_min;
  double feed_x_mm_min;
};
/// Rotation and axis feeds that keep the contour feed v: omega = v/rho, v_Y = h' omega, v_X = (h - rho)
/// omega. They jump at the joints. Derived.
[[nodiscard]] RotationLaw cam_rotation_law(const CamFeed& in);

struct CamPass : CamOnly {
  double width_mm = 0;
  double overrun_mm = 0;
  double axial_feed_mm_rev = 0;
  double contour_feed_mm_min = 0;
};
struct CamTime {
  double revolutions;
  double time_min;
};
/// Main time of one cam at constant contour feed: (width + overrun)/s revolutions of L/v each. Derived.
[[nodiscard]] CamTime cam_milling_time(const CamPass& in);

struct UniformRotation : CamAtNormal {
  double tool_radius_mm = 0;
  double part_speed_rpm = 0;
};
struct ConventionalState {
  double part_angle_deg;
  double centre_distance_mm;
  double contact_offset_mm;  // of the contact from the plane of the axes
  double contour_feed_mm_min;
};
/// The usual scheme: tool centre in the plane of the axes, uniform rotation, alpha = 0. Derived.
[[nodiscard]] ConventionalState conventional_state(const UniformRotation& in);

struct CamAndTool : CamOnly {
  double tool_radius_mm = 0;
};
struct FeedNonuniformity {
  double max_to_min_feed;
  double time_factor;  // time of the usual scheme over the stabilised one at equal peak feed
};
/// Swing of the contour feed in the usual scheme. Exact: on each arc the feed is monotone in the cosine of
/// the angle from the line to the arc's centre, so the extremes lie at the ends of the arcs. Derived.
[[nodiscard]] FeedNonuniformity conventional_feed_nonuniformity(const CamAndTool& in);

enum class WearScheme : std::uint8_t { normal_contact, centre_plane };
struct WornTool : CamAndTool {
  double radius_loss_mm = 0;
  WearScheme scheme = WearScheme::normal_contact;
};
struct FormError {
  double form_error_mm;
};
/// Form error left when the loss of tool radius is corrected by a constant offset: loss * max(1 - cos psi),
/// tan psi = h'/(h + R), in the usual scheme; none with normal contact. First order in the loss. Derived.
[[nodiscard]] FormError tool_wear_form_error(const WornTool& in);

struct CrossedContact {
  double tool_radius_mm = 0;
  double part_radius_mm = 0;  // local radius of the cam, rho
};
struct AxialCut : CrossedContact {
  double orientation_deg = 0;
  double axial_feed_mm_rev = 0;
};
struct AxialRoughness {
  std::optional<double> effective_radius_mm;  // none at alpha = 0
  double rz_um;
  double ra_um;
};
/// Geometric roughness along the cam's axis: R_eff = (R + rho cos^2 a)/sin^2 a, Rz = s^2/(8 R_eff),
/// Ra = 4 Rz/(9 sqrt 3). |alpha| <= 90 deg. Derived.
[[nodiscard]] AxialRoughness axial_roughness(const AxialCut& in);

struct RoughnessLimit : CrossedContact {
  double axial_feed_mm_rev = 0;
  double ra_limit_um = 0;
};
struct Orientation {
  double orientation_deg;
};
/// Largest orientation that keeps Ra; 90 deg when any does. Inverse of axial_roughness.
[[nodiscard]] Orientation max_orientation_for_roughness(const RoughnessLimit& in);

struct ToothFacets {
  double contour_feed_mm_min = 0;
  double tool_speed_rpm = 0;
  std::int64_t teeth = 1;
  double tool_diameter_mm = 0;
  double part_radius_mm = 0;
  double orientation_deg = 0;
};
struct Roundness {
  double feed_per_tooth_mm;
  double roundness_deviation_um;
};
/// Height of the facets the teeth leave: f_z^2/8 (1/rho + cos^2 a / R). COMPLETION C2 (chord formula).
[[nodiscard]] Roundness roundness_deviation(const ToothFacets& in);

struct RoughingCut : CrossedContact {
  double allowance_mm = 0;
  double edge_length_mm = 0;  // periphery from the pivot to the end face
  double orientation_deg = 0;
};
struct AllowanceSplit {
  double periphery_mm;
  double end_face_mm;
};
/// What of the allowance the periphery and the end face remove: the end-face circle comes down to
/// H = l^2 sin^2 a / (2 (rho + R cos^2 a)) above the finished surface. Second order in l. COMPLETION C3.
[[nodiscard]] AllowanceSplit allowance_split(const RoughingCut& in);

struct MeanCut {
  double allowance_mm = 0;
  double axial_feed_mm_rev = 0;
  double contour_feed_mm_min = 0;
};
struct RemovalRate {
  double removal_rate_mm3_min;
};
/// Mean removal rate Q = t s v. Derived.
[[nodiscard]] RemovalRate material_removal_rate(const MeanCut& in);

}  // namespace verstat::models::s1

template <>
struct verstat::models::EnumNames<verstat::models::s1::WearScheme> {
  static constexpr std::array names{std::pair{s1::WearScheme::normal_contact, "normal_contact"},
                                    std::pair{s1::WearScheme::centre_plane, "centre_plane"}};
};

template <>
struct verstat::models::StructFields<verstat::models::s1::Cam> {
  static std::vector<Field> fields();
};
