#pragma once
// Kinematics of turn-milling with rotating tools (S4): resultant cutting speed over the cut, inclination of
// the edge in motion, the feed a control sustains with short blocks, and flats milled on a rotating bar.
//
// Popok, Anisimov 2024. Part axis at the origin, tool centre at (0, a_w), contact point at the angle rho at
// the tool centre from the line of centres.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::s4 {

struct Centres {
  double centre_distance_mm = 0;
  double tool_radius_mm = 0;
};
struct Contact : Centres {
  double contact_angle_deg = 0;  // rho
};
struct ContactRadius {
  double contact_radius_mm;  // distance of the contact from the part axis
  double work_angle_deg;     // sigma
};
/// Radius of the contact on the part, R2' = sqrt(a_w^2 + R1^2 - 2 a_w R1 cos rho), and its angle at the part
/// axis by atan2 (the printed arcsine is wrong beyond 90 deg). S4 eqs. (1)-(3).
[[nodiscard]] ContactRadius contact_radius(const Contact& in);

struct ToolAndWork : Centres {
  double work_radius_mm = 0;
};
struct EngagementLimit {
  bool engaged;
  double tool_angle_deg;
  double work_angle_deg;
};
/// Angles of entry and exit (plus and minus), where R2' = R2; zero when the circles do not meet, 180 and 0
/// when the whole tool circle lies in the part. Derived from eq. (1).
[[nodiscard]] EngagementLimit engagement_limit(const ToolAndWork& in);

enum class MillingMode : std::uint8_t { down, up };
struct CuttingMotion : Contact {
  double tool_speed_rpm = 0;
  double work_speed_rpm = 0;
  double approach_feed_mm_min = 0;  // > 0 towards the part
  MillingMode mode = MillingMode::down;
};
struct ResultantSpeed {
  double tool_speed_m_min;
  double work_speed_m_min;
  double feed_speed_m_min;  // both feed motions together
  double resultant_speed_m_min;
  double deviation_deg;  // of the resultant from the tool speed, unsigned
};
/// Velocity of the edge relative to the part, the vector sum of rotation and both feeds. S4 eqs. (4), (5),
/// repaired: printed as products of speeds, which have the unit m^2/min^2.
[[nodiscard]] ResultantSpeed resultant_speed(const CuttingMotion& in);

struct EdgeInclination {
  double resultant_speed_m_min = 0;
  double inclination_deg = 0;
};
struct EdgeSpeeds {
  double tangential_speed_m_min;
  double normal_speed_m_min;
};
/// Speed along and normal to the edge: v sin lambda, v cos lambda. Textbook formula behind the example.
[[nodiscard]] EdgeSpeeds edge_speed_components(const EdgeInclination& in);

struct SecondMotion {
  double static_inclination_deg = 0;
  double speed_ratio = 0;         // other motion over main; negative for the opposite sense
  double crossing_angle_deg = 0;  // between the two velocities
};
struct KinematicInclination {
  double turn_deg;
  double kinematic_inclination_deg;
};
/// Turn of the main plane by a second motion, eta = atan2(i sin eps, 1 + i cos eps), and the inclination in
/// motion, lambda_C - eta. Error when the motions cancel. COMPLETION.
[[nodiscard]] KinematicInclination kinematic_inclination(const SecondMotion& in);

struct Block {
  double block_length_mm = 0;
  double block_time_ms = 0;
};
struct FeedLimit {
  double max_feed_mm_min;
};
/// Largest feed at which the control keeps up with the blocks. S4 eq. (6).
[[nodiscard]] FeedLimit block_feed_limit(const Block& in);

struct ChordTolerance {
  double path_radius_mm = 0;
  double chord_tolerance_mm = 0;  // <= path radius
};
struct BlockLength {
  double block_length_mm;
};
/// Longest block within a chord tolerance, 2 sqrt(2 R tol - tol^2). COMPLETION.
[[nodiscard]] BlockLength block_length_for_tolerance(const ChordTolerance& in);

struct LeadCut {
  double feed_mm = 0;
  double lead_angle_deg = 0;
};
struct ChipThickness {
  double thickness_mm;
};
/// Uncut chip thickness f sin kappa. Textbook formula behind the example.
[[nodiscard]] ChipThickness uncut_chip_thickness(const LeadCut& in);

struct Layer {
  double blank_radius_mm = 0;
  double depth_mm = 0;  // 0 to blank radius
};
struct FlatLayer {
  double edge_angle_deg;
  double x_travel_mm;
  double width_mm;
};
/// Layer of a flat on a bar: cos alpha = (R - t)/R, X travel t, width 2 sqrt(R^2 - (R - t)^2). The formula
/// behind the printed angles.
[[nodiscard]] FlatLayer flat_layer(const Layer& in);

struct TiltedFlat {
  double flat_length_mm = 0;
  double tilt_deg = 0;
};
struct Projection {
  double projection_mm;
};
/// Projection l sin alpha of a flat, as printed; it is not the X travel.
[[nodiscard]] Projection flat_projection(const TiltedFlat& in);

struct Flat {
  double tool_radius_mm = 0;    // 0: a point tool
  double flat_distance_mm = 0;  // from the axis; d + R1 > 0
};
struct FlatTurn : Flat {
  double rotation_deg = 0;  // theta, |theta| < 90
  double surface_feed_mm_min = 0;
};
struct FlatAxes {
  double x_mm;
  double flat_position_mm;
  double work_speed_rpm;
  double x_feed_mm_min;
};
/// Synchronised axes that generate a flat: x = (d + R1)/cos theta, s = (d + R1) tan theta, and the speeds
/// for a constant feed along the flat. Derived.
[[nodiscard]] FlatAxes flat_axis_law(const FlatTurn& in);

struct FlatSteps : Flat {
  double half_angle_deg = 0;
  std::int64_t steps = 1;
};
struct XIncrements {
  std::vector<double> increments_mm;
};
/// X moves for equal angular steps from -half angle to +half angle (0 to 90 deg, exclusive). Derived.
[[nodiscard]] XIncrements flat_x_increments(const FlatSteps& in);

struct FlatStep : Flat {
  double rotation_deg = 0;
  double step_deg = 0;  // |rotation| + step/2 < 90
};
struct StepErrors {
  double interpolation_error_mm;
  double step_along_flat_mm;
  std::optional<double> imprint_scallop_mm;  // none when the imprints do not meet
};
/// Errors of a flat made in angular steps: blocks linear in x and theta; imprints where the tool stops.
/// COMPLETION.
[[nodiscard]] StepErrors flat_step_error(const FlatStep& in);

struct FlatPass {
  double blank_radius_mm = 0;
  double depth_mm = 0;  // <= blank radius
  double width_of_cut_mm = 0;
  double flat_axial_length_mm = 0;
  double axial_depth_mm = 0;
  double tool_radius_mm = 0;
  double surface_feed_mm_min = 0;
};
struct FlatTime {
  std::int64_t layers;
  std::int64_t axial_passes;
  double path_length_mm;
  double time_min;
};
/// Main time of a flat in layers: each from first to last touch of the full blank. COMPLETION.
[[nodiscard]] FlatTime flat_milling_time(const FlatPass& in);

struct FlatCut : Layer {
  double tool_radius_mm = 0;
  double tool_speed_rpm = 0;
  double surface_feed_mm_min = 0;
  MillingMode mode = MillingMode::down;
};
struct FlatSpeeds {
  double entry_speed_m_min;
  double middle_speed_m_min;
  double exit_speed_m_min;
};
/// Resultant speed at entry, middle and exit of a flat: v = 2 pi n1 R1 -+ (v_f - 2 pi n2 R1), minus in down
/// milling. Derived.
[[nodiscard]] FlatSpeeds flat_milling_speeds(const FlatCut& in);

struct FinishingRegime {
  double cutting_speed_m_min = 0;
  double depth_to_feed_ratio = 0;
  double ratio_limit = 0.2;
};
struct FinishingRule {
  bool applies;
  std::optional<double> ra_min_um;
  std::optional<double> ra_max_um;
};
/// The paper's rule: at v >= 600 m/min and a ratio of depth to feed of at most 0.2, Ra 1.6-3.2 um.
[[nodiscard]] FinishingRule finishing_rule(const FinishingRegime& in);

}  // namespace verstat::models::s4

template <>
struct verstat::models::EnumNames<verstat::models::s4::MillingMode> {
  static constexpr std::array names{std::pair{s4::MillingMode::down, "down"},
                                    std::pair{s4::MillingMode::up, "up"}};
};
