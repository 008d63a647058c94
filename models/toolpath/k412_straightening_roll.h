#pragma once
// Pipe-straightening roll: profile, allowances, toolpaths, dressing radius of the grinding wheel, machining
// time and NC program (K412).
//
// A skew-roll straightening machine holds a pipe between concave rolls whose axes cross the pipe axis. The
// roll profile is the envelope of the pipe surface turned about the roll axis. From it follow the check of
// the contact, rough turning in two phases, finish turning, grinding and the NC program. The turning
// functions serve any contour of revolution.
//
// Pasichnyk, Shumaiev 2011. Contours: axial place y, not falling (0 at the throat of a roll), and radius x;
// neighbouring points differ. Outward is away from the material.

#include <cstdint>
#include <string>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k412 {

/// A contour of revolution.
struct Contour {
  std::vector<double> y_mm;
  std::vector<double> x_radius_mm;
};

// ------------------------------------------------------------------------------------------- geometry

struct RollAndPipe {
  double throat_diameter_mm = 0;
  double pipe_diameter_mm = 0;
  double crossing_angle_deg = 0;
};
struct ProfileAngle : RollAndPipe {
  double phi_deg = 0;
};
struct ProfilePoint {
  double diameter_mm;
  double y_mm;
};
/// Point of the roll profile for the parameter phi (90 deg: throat); K412 eqs. (1), (2) as corrected.
/// 5 <= alpha <= 90, 0 < phi <= 90.
[[nodiscard]] ProfilePoint roll_profile_point(const ProfileAngle& in);

struct ProfilePlace : RollAndPipe {
  double y_mm = 0;
};
struct Phi {
  double phi_deg;
};
/// Parameter of the profile at |y|, inverse of eq. (2). alpha = 90: |y| below half the pipe diameter.
[[nodiscard]] Phi roll_phi_at_y(const ProfilePlace& in);

struct ProfileSampling : RollAndPipe {
  double half_length_mm = 0;
  std::int64_t n_points = 3;
};
struct RollProfile : Contour {
  double phi_end_deg;
  double end_diameter_mm;
  double throat_curvature_radius_mm;
};
/// Working profile, uniform in y; n_points odd.
[[nodiscard]] RollProfile roll_profile(const ProfileSampling& in);

struct RollSetup : Contour {
  double pipe_diameter_mm = 0;
  double crossing_angle_deg = 0;
  double centre_distance_mm = 0;
};
struct RollGap {
  std::vector<double> gap_mm;
  double gap_min_mm;
  double gap_max_mm;
};
/// Clearance between roll and pipe in every section; negative where they interfere. COMPLETION.
[[nodiscard]] RollGap roll_pipe_gap(const RollSetup& in);

struct FitSearch : Contour {
  double pipe_diameter_mm = 0;
  double alpha_min_deg = 0;
  double alpha_max_deg = 0;
};
struct RollFit {
  double alpha_deg;
  double centre_distance_mm;
  double gap_max_mm;
};
/// Set-up of an existing roll for another pipe: touching, with the smallest largest gap. COMPLETION. A result
/// at an end of the range is a limit, not an optimum.
[[nodiscard]] RollFit roll_pipe_fit(const FitSearch& in);

struct ProfileEnd {
  double y_k_mm = 0;
  double x_k_mm = 0;
  double y_k1_mm = 0;
  double x_k1_mm = 0;
  double fillet_radius_mm = 0;
};
struct EndFillet {
  double beta_deg;
  double y_c_mm;
  double x_c_mm;
  double max_diameter_mm;
  double y_face_mm;
  double arc_length_mm;
};
/// Fillet from the end of the profile to the face, K412 eq. (3) with the fraction turned over. Right end,
/// radii.
[[nodiscard]] EndFillet roll_end_fillet(const ProfileEnd& in);

struct ContourSampling : ProfileSampling {
  double fillet_radius_mm = 0;
  std::int64_t arc_points = 1;
};
struct RollContour : Contour {
  double max_diameter_mm;
  double length_mm;
};
/// Both fillets and the profile, left face to right face.
[[nodiscard]] RollContour roll_contour(const ContourSampling& in);

// ------------------------------------------------------------------------------------ toolpath and time

struct Length {
  double length_mm;
};
/// Length of a contour, the sum of its lines and arcs.
[[nodiscard]] Length path_length(const Contour& in);

struct OffsetInput : Contour {
  double offset_mm = 0;
};
/// Equidistant with mitred vertices; valid while a concave part has a larger radius than the offset.
[[nodiscard]] Contour offset_contour(const OffsetInput& in);

enum class SpindleMode { css, rpm };

struct PassInput : Contour {
  double feed_mm_rev = 0;
  double speed_m_min = 0;
  double max_rpm = 0;
  SpindleMode mode = SpindleMode::css;
  double rpm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
};
struct PassTime {
  double length_mm;
  double main_time_min;
};
/// One pass along the contour: at constant surface speed up to the largest spindle speed, or at a fixed
/// spindle speed.
[[nodiscard]] PassTime contour_pass_time(const PassInput& in);

struct RoughTurning : Contour {
  double blank_diameter_mm = 0;
  double finish_allowance_mm = 0;
  double grind_allowance_mm = 0;
  double max_depth_mm = 0;
  double feed_mm_rev = 0;
  double speed_m_min = 0;
  double max_rpm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double rapid_mm_min = 0;
};
struct RoughPlan {
  double cylinder_diameter_mm;
  std::int64_t cylinder_passes;
  double cylinder_depth_mm;
  std::int64_t contour_passes;
  double contour_depth_mm;
  std::vector<double> contour_lengths_mm;
  double cut_length_mm;
  double cylinder_time_min;
  double main_time_min;
  double rapid_time_min;
  double removed_cm3;
};
/// Roughing in two phases: cylinder passes down to the crest, then equidistants of the contour. COMPLETION of
/// what the paper names.
[[nodiscard]] RoughPlan rough_turning_plan(const RoughTurning& in);

struct Facing {
  double outer_diameter_mm = 0;
  double inner_diameter_mm = 0;
  double allowance_mm = 0;
  double max_depth_mm = 0;
  double feed_mm_rev = 0;
  double speed_m_min = 0;
  double max_rpm = 0;
  double approach_mm = 0;
};
struct FacingTime {
  std::int64_t passes;
  double main_time_min;
};
/// Main time of one face. COMPLETION.
[[nodiscard]] FacingTime facing_time(const Facing& in);

struct Volume {
  double volume_cm3;
};
/// Solid of revolution, as a sum of frustums.
[[nodiscard]] Volume revolve_volume(const Contour& in);

struct OperationTimes {
  double rough_main_min = 0;
  double rough_rapid_min = 0;
  double finish_main_min = 0;
  double facing_main_min = 0;
  double grind_main_min = 0;
  double handling_min = 0;
  std::int64_t setups = 1;
  double setup_min = 0;
  double programming_min = 0;
  std::int64_t batch = 1;
};
struct PartTime {
  double main_min;
  double piece_min;
  double per_part_min;
};
/// Piece time and the part's share of set-up and programming. COMPLETION.
[[nodiscard]] PartTime roll_part_time(const OperationTimes& in);

struct ProgramInput : Contour {
  double feed_mm_rev = 0;
  double speed_m_min = 0;
  double max_rpm = 0;
  std::int64_t tool = 1;
  double clearance_mm = 0;
  std::int64_t program = 1;
};
struct Program {
  std::vector<std::string> lines;
};
/// NC text of one contour pass: X diametral, constant surface speed. COMPLETION (dialect).
[[nodiscard]] Program gcode_contour(const ProgramInput& in);

// -------------------------------------------------------------------------------------------- grinding

enum class DressingVariant { tangent, printed };

struct DressingSearch : Contour {
  double allowance_mm = 0;
  double reserve = 0;
  DressingVariant variant = DressingVariant::tangent;
  bool both_directions = true;
};
struct DressingRadius {
  double radius_mm;
  std::int64_t index;
  double largest_radius_mm;
};
/// Largest radius of the dressed wheel that does not grind with its side; K412 eqs. (4)-(9) on a uniform
/// grid. Depends on the spacing of the points: for parity with the paper, see dressing_radius_for_wheel.
[[nodiscard]] DressingRadius dressing_radius(const DressingSearch& in);

struct WheelOnProfile {
  double wheel_width_mm = 0;
  double allowance_mm = 0;
  double reserve = 0;
  double profile_radius_mm = 0;  // > 0 concave, 0 straight, < 0 convex
};
struct WheelRadius {
  double radius_mm;
};
/// The same criterion with half the wheel width as span, 1/R = 1/rho + 8 a k_z / B^2. COMPLETION. 1e9:
/// unlimited.
[[nodiscard]] WheelRadius dressing_radius_for_wheel(const WheelOnProfile& in);

struct WheelContact {
  double wheel_radius_mm = 0;
  double profile_radius_mm = 0;
  double depth_mm = 0;
};
struct HalfWidth {
  double half_width_mm;
};
/// Half-width of the contact of wheel and profile. COMPLETION. 1e9 when the wheel is flatter than the
/// profile.
[[nodiscard]] HalfWidth wheel_contact_half_width(const WheelContact& in);

struct Scallop {
  double wheel_radius_mm = 0;
  double profile_radius_mm = 0;
  double scallop_um = 0;
};
struct Feed {
  double feed_mm_rev;
};
/// Axial feed that leaves the scallop height h = f^2 / 8 (1/R - 1/rho). COMPLETION. 1e9 when the wheel is
/// flatter than the profile.
[[nodiscard]] Feed grinding_feed_for_scallop(const Scallop& in);

struct ProfileGrinding {
  double contour_length_mm = 0;
  double mean_diameter_mm = 0;
  double allowance_mm = 0;
  double infeed_mm = 0;
  std::int64_t sparkout_passes = 0;
  double feed_mm_rev = 0;
  double work_speed_m_min = 0;
};
struct ProfileGrindingTime {
  double work_rpm;
  std::int64_t passes;
  double main_time_min;
};
/// Traverse profile grinding. COMPLETION.
[[nodiscard]] ProfileGrindingTime profile_grinding_time(const ProfileGrinding& in);

}  // namespace verstat::models::k412

template <>
struct verstat::models::EnumNames<verstat::models::k412::SpindleMode> {
  static constexpr std::array names{std::pair{k412::SpindleMode::css, "css"},
                                    std::pair{k412::SpindleMode::rpm, "rpm"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k412::DressingVariant> {
  static constexpr std::array names{std::pair{k412::DressingVariant::tangent, "tangent"},
                                    std::pair{k412::DressingVariant::printed, "printed"}};
};
