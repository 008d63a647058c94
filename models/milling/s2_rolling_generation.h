#pragma once
// Generation of die profiles by a conical tool edge that rolls on them (S2): the part turns about O1 while
// the table translates along Z and Y, so that the straight edge stays tangent to the profile and rolls on it
// without slip (p = 1), with slip, or slides (p = 0).
//
// Ambrosimov, Kharlamov, Cherepenko 2016. Profile sides are functions y = f(z) in mm, O1 is the origin. The
// worked side lies below its graph, the edge rises to the right at 90 deg - alpha/2 to OZ. Translations are
// those of the table with the part, relative to a fixed tool.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::s2 {

enum class ProfileKind : std::uint8_t { poly, arc, points };
/// One side of a profile; only the members of its kind are used.
struct Profile {
  ProfileKind kind = ProfileKind::poly;
  std::vector<double> coeff;     // poly: c0 + c1 z + ...
  std::optional<double> zc, yc;  // arc: centre; the upper half of the circle
  std::optional<double> r;
  std::vector<double> z, y;  // points: natural cubic spline, z ascending
  double z_min = 0;
  double z_max = 0;
};

struct ConcaveArc {
  double part_radius_mm = 0;      // R_A
  double tool_arc_radius_mm = 0;  // r0
  double rotation_deg = 0;
  double angular_speed_deg_s = 0;
};
struct ConcaveMotion {
  double s_z_mm;
  double s_y_mm;
  double v_z_mm_min;
  double v_y_mm_min;
};
/// Coordination of kind 1, concave arc of the tool's own radius: S = (R_A + r0)(cos phi, sin phi) and its
/// rate. S2 eqs. (2), (3), the sign of V_y repaired.
[[nodiscard]] ConcaveMotion concave_arc_motion(const ConcaveArc& in);

struct Worked {
  Profile profile;
  double tool_angle_deg = 0;  // alpha, 0 to 180 exclusive
};
enum class ArcMode : std::uint8_t { chord, exact };
struct Transfer : Worked {
  double z2_mm = 0;
  double slip = 1;
  ArcMode arc_mode = ArcMode::exact;
};
struct TransferMotion {
  double rotation_deg;
  double z1_mm;  // contact A1 before the rotation
  double y1_mm;
  double z2_rot_mm;  // contact A2 after it
  double y2_rot_mm;
  double ds_z1_mm;  // motion without rolling
  double ds_y1_mm;
  double arc_length_mm;  // negative when z2 < z1
  double ds_z_mm;
  double ds_y_mm;
};
/// Coordination of kind 2: rotation and translation that carry the contact from A1, where the edge touches
/// the unrotated profile, to A2. Error when no point of the profile has the edge's slope. S2 eqs. (5)-(11).
[[nodiscard]] TransferMotion rolling_transfer(const Transfer& in);

struct Stroke : Worked {
  double z_start_mm = 0;
  double z_end_mm = 0;
  std::int64_t steps = 2;  // equal in z
  double slip = 1;
};
struct StrokeEnd {
  double rotation_deg;
  double s_z_mm;
  double s_y_mm;
  double vertex_offset_mm;  // distance of the contact from the tool vertex
  double arc_length_mm;
};
struct StrokeMotion : StrokeEnd {
  double mid_rotation_deg;
  double mid_s_z_mm;
  double mid_s_y_mm;
};
/// Motion along a whole side relative to the start, at its end and at half of the (even) steps. S2 eqs.
/// (5)-(11) summed without accumulation of error.
[[nodiscard]] StrokeMotion rolling_path(const Stroke& in);

struct Corner : Worked {
  Profile opposite;
  double z2_mm = 0;
};
struct VertexLimit {
  double rotation_deg;
  bool limited;
  std::optional<double> max_offset_mm;  // none when not limited
  std::optional<double> vertex_z_mm;    // after the rotation (7)
  std::optional<double> vertex_y_mm;
};
/// Coordination of kind 3: the farthest the vertex may lie from the contact before it meets the opposite
/// side. S2 eq. (12), second line rebuilt from the text.
[[nodiscard]] VertexLimit vertex_limit(const Corner& in);

struct CornerStroke : Stroke {
  Profile opposite;
};
struct Gouge {
  double max_gouge_mm;
};
/// Deepest penetration (along y of the part) of the vertex into the opposite side without limiting.
[[nodiscard]] Gouge vertex_gouge(const CornerStroke& in);

struct LimitedStroke : StrokeEnd {
  double mean_slip;
  double min_step_slip;
  double max_gouge_mm;
};
/// Path with the slip reduced where the vertex would enter the opposite side. S2 kind 3, rebuilt.
[[nodiscard]] LimitedStroke rolling_path_limited(const CornerStroke& in);

enum class Section : std::uint8_t { concave_arc, convex, straight, junction };
struct SectionAndTool {
  Section section = Section::convex;
  double side_angle_deg = 0;  // beta
  double tool_angle_deg = 0;
};
struct Coordination {
  std::int64_t kind;
  bool tool_fits;
};
/// The paper's choice of coordination: concave arc 1, convex and straight 2, junction 3 below 90 deg, else
/// 2; the tool fits when alpha <= beta.
[[nodiscard]] Coordination coordination_kind(const SectionAndTool& in);

struct FacetStep {
  double curvature_radius_mm = 0;
  double rotation_step_deg = 0;
};
struct FacetError {
  double facet_error_mm;
};
/// Height left between two successive tangents, r (sec(step/2) - 1). COMPLETION.
[[nodiscard]] FacetError facet_error(const FacetStep& in);

struct FacetTolerance {
  double curvature_radius_mm = 0;
  double tolerance_mm = 0;
};
struct RotationStep {
  double rotation_step_deg;
};
/// Rotation step that leaves a facet error. Inverse of facet_error. COMPLETION.
[[nodiscard]] RotationStep rotation_step_for_tolerance(const FacetTolerance& in);

struct TimedStroke : Stroke {
  double feed_mm_min = 0;  // along the profile
  double max_rotation_rpm = 0;
  double max_axis_feed_mm_min = 0;
};
struct StrokeTime {
  double time_min;
};
/// Time of one generating stroke: every step takes what feed, rotation or the slower axis needs. COMPLETION.
[[nodiscard]] StrokeTime rolling_time(const TimedStroke& in);

struct EdgeTravel {
  double slip = 1;
  double arc_length_mm = 0;
  double contact_width_mm = 0;
};
struct WearSpread {
  double contact_travel_mm;
  double life_factor;
};
/// Travel of the contact along the edge, |p| L, and the gain in life 1 + |p| L/b, wear taken proportional to
/// the time of contact per length of edge. COMPLETION.
[[nodiscard]] WearSpread edge_wear_spread(const EdgeTravel& in);

}  // namespace verstat::models::s2

template <>
struct verstat::models::EnumNames<verstat::models::s2::ProfileKind> {
  static constexpr std::array names{std::pair{s2::ProfileKind::poly, "poly"},
                                    std::pair{s2::ProfileKind::arc, "arc"},
                                    std::pair{s2::ProfileKind::points, "points"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::s2::ArcMode> {
  static constexpr std::array names{std::pair{s2::ArcMode::chord, "chord"},
                                    std::pair{s2::ArcMode::exact, "exact"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::s2::Section> {
  static constexpr std::array names{
      std::pair{s2::Section::concave_arc, "concave_arc"}, std::pair{s2::Section::convex, "convex"},
      std::pair{s2::Section::straight, "straight"}, std::pair{s2::Section::junction, "junction"}};
};
template <>
struct verstat::models::StructFields<verstat::models::s2::Profile> {
  static std::vector<Field> fields();
};
