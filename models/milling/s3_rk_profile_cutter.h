#pragma once
// Teeth of a disc cutter that mills an RK (polygon) hole in one revolution per lobe (S3): the conjugate
// cutter profile, the cusps between neighbouring teeth, the even spacing of the cusps, and the grade reached.
//
// Kuts, Mitrofanov, Malneva, Kirillov 2022. Part and cutter turn in the same sense, the cutter N times
// faster, at the fixed centre distance a = R - R_f. The hole is given by its support function h = R + e cos
// N t of the normal angle t. Angles of teeth are polar angles on the cutter, zero at the tooth that cuts the
// lobe tip, 180 deg at the flat.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::s3 {

/// The hole; convex: R > (N^2 - 1) e.
struct RkHole {
  double mean_radius_mm = 40;
  double eccentricity_mm = 3.4;
  std::int64_t lobes = 3;
};
/// Hole and cutter: 0 < R_f < R - (N - 1) e, so that the normals reach the pitch circle.
struct RkCutter : RkHole {
  double cutter_radius_mm = 24;  // mean radius R_f
};

struct RkHoleAtNormal : RkHole {
  double normal_angle_deg = 0;
};
struct RkProfilePoint {
  double x_mm;
  double y_mm;
  double r_mm;
  double curvature_radius_mm;
};
/// Point of the hole profile with the normal t: (h cos t - h' sin t, h sin t + h' cos t), radius of
/// curvature h + h''. From the paper's references, confirmed by Tables 1 and 2.
[[nodiscard]] RkProfilePoint rk_profile_point(const RkHoleAtNormal& in);

struct RkCutterAtNormal : RkCutter {
  double normal_angle_deg = 0;
};
struct RkCutterPoint {
  double tooth_radius_mm;
  double tooth_angle_deg;        // unwrapped to the value nearest N t
  double centre_line_angle_deg;  // gamma
  double parameter_angle_deg;    // N t
};
/// Cutter point that generates the profile point t: the normal passes through the pitch point on the line of
/// centres, gamma = t + asin(h'/r_w), r_w = N a/(N - 1). S3 eqs. (1)-(3), closed form for straight teeth.
[[nodiscard]] RkCutterPoint rk_cutter_point(const RkCutterAtNormal& in);

struct RkRadiusLimits {
  double max_cutter_radius_mm;
  double min_cutter_radius_mm;
};
/// Largest cutter without undercut at the lobe tip: the larger root of
/// R_f^2 - (R - (N-1)^2 e) R_f + ((N-1) e)^2 = 0; smallest without a looping track at the flat,
/// e + (R - e)/N. COMPLETION.
[[nodiscard]] RkRadiusLimits rk_cutter_radius_limits(const RkHole& in);

struct RkToothPair : RkCutter {
  double tooth1_angle_deg = 0;
  double tooth2_angle_deg = 0;
};
struct RkCusp {
  std::optional<double> cusp_height_mm;        // none: the tracks never meet, material stays
  std::optional<double> cusp_polar_angle_deg;  // none where there is no crossing
  double contact_pitch_mm;
};
/// Cusp that two neighbouring teeth leave: radial distance from the crossing of their tracks to the profile.
/// tooth1 < tooth2 <= tooth1 + 360. S3 eqs. (5)-(9), closed form for straight teeth.
[[nodiscard]] RkCusp rk_cusp(const RkToothPair& in);

struct RkUniformCutter : RkCutter {
  std::int64_t teeth = 1;
  double first_tooth_angle_deg = 180;
};
struct RkDeviations {
  std::optional<double> max_deviation_mm;  // none: infinite
  std::optional<double> min_deviation_mm;
};
/// Largest and smallest cusp of equally spaced teeth. S3 Tables 1 and 2.
[[nodiscard]] RkDeviations rk_form_error_uniform(const RkUniformCutter& in);

struct RkTolerance : RkCutter {
  double tolerance_mm = 0;
  double first_tooth_angle_deg = 180;
};
struct RkToothPositions {
  std::int64_t positions_listed;
  std::int64_t teeth;
  std::vector<double> tooth_angles_deg;       // from the first tooth, one per tooth
  std::vector<double> parameter_angles_deg;   // N t(theta_k) - N t(theta_1), one per position
  std::vector<double> parameter_pitches_deg;  // their differences
  std::optional<double> closing_cusp_mm;      // between the last tooth and the first
};
/// The paper's algorithm: each tooth at the smallest pitch at which the cusp reaches the tolerance, until the
/// turn is full. S3 eq. (10), Fig. 7 rebuilt from the text. At most 2000 teeth.
[[nodiscard]] RkToothPositions rk_tooth_positions(const RkTolerance& in);

struct RkEqualisedCutter {
  double equal_deviation_mm;
  std::vector<double> tooth_angles_deg;
};
/// The common cusp of `teeth` teeth (1 to 500) spaced so that all cusps are equal all the way round.
/// Error when so few teeth cannot close the turn. COMPLETION.
[[nodiscard]] RkEqualisedCutter rk_equalised_cutter(const RkUniformCutter& in);

enum class Spacing : std::uint8_t { uniform, equalised };
struct RkTeethForTolerance : RkTolerance {
  Spacing spacing = Spacing::uniform;
};
struct RkTeeth {
  std::int64_t teeth;
};
/// Fewest teeth for a tolerance: uniform, the first Z = 2, 3, ... whose largest deviation keeps it;
/// equalised, the teeth of rk_tooth_positions. At most 2000. COMPLETION.
[[nodiscard]] RkTeeth rk_min_teeth(const RkTeethForTolerance& in);

struct FormDeviation {
  double deviation_mm = 0;
  double nominal_mm = 0;
  double share = 0.6;  // level A of GOST 24643
};
struct ItGrade {
  std::int64_t it_grade;  // 6 to 16; 17 = worse
  std::optional<double> allowed_deviation_mm;
};
/// First ISO 286 grade with share * IT(nominal) >= deviation (equality counts, within 1e-12 mm).
/// 10 < nominal <= 180 mm.
[[nodiscard]] ItGrade it_grade_for_deviation(const FormDeviation& in);

struct RkCutting : RkCutterAtNormal {
  double work_speed_rpm = 0;
};
struct RkKinematics {
  double cutter_speed_rpm;
  double cutting_speed_m_min;
};
/// Cutter speed N n, eq. (1), and sliding speed at the contact, (N - 1) 2 pi n times the distance of the
/// contact from the pitch point. COMPLETION.
[[nodiscard]] RkKinematics rk_cutting_kinematics(const RkCutting& in);

struct RkPass {
  double infeed_mm = 0;
  double cross_feed_mm_min = 0;
  double work_speed_rpm = 0;
  double finish_revolutions = 1;
};
struct RkTime {
  double time_min;
};
/// Main time: infeed/S_m + finish revolutions/n. COMPLETION from eq. (4).
[[nodiscard]] RkTime rk_hole_machining_time(const RkPass& in);

}  // namespace verstat::models::s3

template <>
struct verstat::models::EnumNames<verstat::models::s3::Spacing> {
  static constexpr std::array names{std::pair{s3::Spacing::uniform, "uniform"},
                                    std::pair{s3::Spacing::equalised, "equalised"}};
};
