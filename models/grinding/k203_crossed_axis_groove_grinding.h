#pragma once
// Grinding ball-screw and ball-nut grooves with crossed wheel and part axes (K203).
//
// Finish grinding of the circular-arc helical groove with a wheel whose axis is tilted against the part axis:
// the wheel profile a groove needs, the groove a wheel makes, removal rate and volume, wear and dressing, and
// the settings of a narrow wheel that is tilted more at every pass.
//
// Kalchenko, Yeroshenko 2011. Signs: groove profile radius > 0 for a nut, < 0 for a screw; wheel radii are
// positive. The wheel centre lies on the +y side of the part at the centre distance; tilt psi is the rotation
// of the wheel axis about y. Right-hand threads; a left-hand one is the mirror image. Angles in degrees.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k203 {

struct Groove {
  double center_radius_mm = 0;   // R of the profile centre
  double profile_radius_mm = 0;  // rho, > 0 nut, < 0 screw
  double lead_mm = 0;
};

struct GroovePosition : Groove {
  double theta_deg = 0;
  double phi_deg = 0;
};
struct GroovePoint {
  double x_mm;
  double y_mm;
  double z_mm;
  double nx;
  double ny;
  double nz;
};
/// Point of the groove surface and its unit normal, away from the part axis at theta = 0; K203 eqs. (1)-(3).
/// |phi| < 90, R + rho cos(phi) > 0.
[[nodiscard]] GroovePoint helical_groove_point(const GroovePosition& in);

struct GrooveToWheel : Groove {
  double center_distance_mm = 0;
  double tilt_deg = 0;
  double phi_deg = 0;
};
struct WheelPoint {
  double theta_deg;
  double wheel_radius_mm;
  double wheel_axial_mm;
};
/// Contact point and wheel profile point for the groove angle phi, K203 eqs. (4)-(11): the normal meets the
/// wheel axis. |phi| <= 60, |tilt| <= 15. Error without a contact within 40 deg, or where the wheel would
/// undercut the groove.
[[nodiscard]] WheelPoint wheel_profile_point(const GrooveToWheel& in);

struct WheelSetting {
  double wheel_center_radius_mm = 0;  // R_u of the profile centre
  double wheel_profile_radius_mm = 0;
  double lead_mm = 0;
  double center_distance_mm = 0;
  double tilt_deg = 0;
  std::int64_t internal = 0;  // 1 nut, 0 screw
};
struct WheelToGroove : WheelSetting {
  double phi_deg = 0;
};
struct GrooveSectionPoint {
  double wheel_angle_deg;
  double groove_radius_mm;
  double groove_axial_mm;
};
/// Axial-section point of the groove made by a toroidal wheel, K203 eqs. (12)-(15). |phi| <= 60. Error
/// without a contact within 25 deg of the line of centres.
[[nodiscard]] GrooveSectionPoint ground_groove_point(const WheelToGroove& in);

struct SectionSampling : WheelSetting {
  double phi_max_deg = 0;
  std::int64_t points = 41;
};
struct GrooveFit {
  double fit_radius_mm;
  double fit_center_radius_mm;
  double form_error_mm;
  double rms_error_mm;
  double half_width_mm;
};
/// Least-squares arc (algebraic) of the section made by a toroidal wheel, sampled from -phi_max to phi_max.
[[nodiscard]] GrooveFit groove_profile_fit(const SectionSampling& in);

struct IntermediatePass : Groove {
  double final_center_distance_mm = 0;
  double final_tilt_deg = 0;
  double pass_center_distance_mm = 0;
  double pass_tilt_deg = 0;
  double phi_max_deg = 0;
  std::int64_t points = 41;
};
struct PassFormError {
  double fit_radius_mm;
  double fit_center_radius_mm;
  double form_error_mm;
  double rms_error_mm;
};
/// Groove left by an intermediate pass with the wheel dressed for the final groove at the final settings;
/// K203 eqs. (4)-(15), the paper's Delta_kj.
[[nodiscard]] PassFormError pass_form_error(const IntermediatePass& in);

struct CrossedWheel {
  double wheel_profile_radius_mm = 0;
  double wheel_outer_radius_mm = 0;
  double groove_bottom_radius_mm = 0;
  double lead_mm = 0;
  std::int64_t internal = 0;
};
struct TiltedWheel : CrossedWheel {
  double tilt_deg = 0;
};
struct GrooveRadius {
  double groove_radius_mm;
};
/// Radius of the groove arc at its bottom, second-order envelope. COMPLETION. For a nut the wheel must be
/// smaller than the groove bottom.
[[nodiscard]] GrooveRadius effective_groove_radius(const TiltedWheel& in);

struct WantedRadius : CrossedWheel {
  double groove_radius_mm = 0;
};
struct Tilt {
  double tilt_deg;
};
/// Tilt that makes the wanted radius, from the aligned position up to 40 deg further. COMPLETION. Error
/// unless the radius lies between those of both ends.
[[nodiscard]] Tilt tilt_for_radius(const WantedRadius& in);

struct PassPlan {
  double groove_center_radius_mm = 0;
  double final_profile_radius_mm = 0;
  double stock_mm = 0;
  double infeed_mm = 0;
  double lead_mm = 0;
  double wheel_outer_radius_mm = 0;
  double wheel_profile_radius_mm = 0;
  std::int64_t internal = 0;
};
struct PassSchedule {
  std::vector<double> profile_radius_mm;
  std::vector<double> center_distance_mm;
  std::vector<double> tilt_deg;
};
/// Settings of every working pass of the narrow tilted wheel: groove radius, centre distance and tilt.
/// COMPLETION of the process the paper proposes.
[[nodiscard]] PassSchedule pass_schedule(const PassPlan& in);

enum class Stock { shifted, concentric };

struct RemovalRegime {
  double wheel_center_radius_mm = 0;
  double wheel_profile_radius_mm = 0;
  double wear_mm = 0;
  double phi_max_deg = 0;
  double traverse_speed_m_min = 0;
  double infeed_mm = 0;
  double retreat_speed_mm_s = 0;
  double grain_ratio = 0;
  Stock scheme = Stock::shifted;
};
struct RemovalRate {
  double q_mm3_min;
  double q_center_mm2_min;
  double contact_arc_deg;
};
/// Removal rate with wear, elastic retreat and grain coverage; K203 eq. (16) repaired, with the straight
/// traverse of the wheel along the groove (completion).
[[nodiscard]] RemovalRate grinding_removal_rate(const RemovalRegime& in);

struct StockOnGroove : Groove {
  double thread_length_mm = 0;
  double stock_mm = 0;
  double phi_max_deg = 0;
  Stock scheme = Stock::concentric;
};
struct RemovedVolume {
  double section_mm2;
  double groove_length_mm;
  double volume_mm3;
};
/// Metal removed from one part, exact for a section swept along the helix. COMPLETION.
[[nodiscard]] RemovedVolume removed_volume(const StockOnGroove& in);

struct Plunge {
  double stock_mm = 0;
  double theta_max_deg = 0;
};
struct PlungeLength {
  double length_mm;
};
/// Infeed path of the copying method, stock / cos(largest rise angle of the profile).
[[nodiscard]] PlungeLength plunge_length(const Plunge& in);

struct WornProfile {
  double wheel_profile_radius_mm = 0;
  double wear_mm = 0;
  double alpha_deg = 0;
};
struct DressingDepth {
  double depth_mm;
};
/// Depth of dressing that restores the arc, K203 eq. (17); alpha from the wheel axis direction (90 = crown).
[[nodiscard]] DressingDepth dressing_depth(const WornProfile& in);

struct Dressing {
  double wheel_center_radius_mm = 0;
  double wheel_profile_radius_mm = 0;
  double wheel_width_mm = 0;
  double depth_mm = 0;
};
struct DressingVolume {
  double section_mm2;
  double volume_mm3;
};
/// Abrasive lost in one dressing; counts the worn layer too. Width <= 2 rho, depth < R_u.
[[nodiscard]] DressingVolume dressing_volume(const Dressing& in);

enum class Method { narrow, copying };

struct WearInputs {
  double stock_mm = 0;
  double groove_length_mm = 0;
  double wheel_outer_radius_mm = 0;
  double grinding_ratio = 0;
  double wear_limit_mm = 0;
  double phi_max_deg = 0;
  Method method = Method::narrow;
};
struct WheelWear {
  double wear_per_part_mm;
  double dressings_per_part;
};
/// Radial wear and dressings per part from the grinding ratio. COMPLETION.
[[nodiscard]] WheelWear wheel_wear_per_part(const WearInputs& in);

struct GrindingPlan {
  double thread_length_mm = 0;
  double lead_mm = 0;
  double overrun_mm = 0;
  double stock_mm = 0;
  double infeed_mm = 0;
  std::int64_t sparkout_passes = 0;
  double part_speed_rpm = 0;
  double return_speed_ratio = 0;
  double setting_time_min = 0;
  double dressing_time_min = 0;
  double dressings_per_part = 0;
};
struct GrindingTime {
  std::int64_t passes;
  double pass_time_min;
  double time_min;
};
/// Passes, working stroke and time per part. COMPLETION.
[[nodiscard]] GrindingTime groove_grinding_time(const GrindingPlan& in);

}  // namespace verstat::models::k203

template <>
struct verstat::models::EnumNames<verstat::models::k203::Stock> {
  static constexpr std::array names{std::pair{k203::Stock::shifted, "shifted"},
                                    std::pair{k203::Stock::concentric, "concentric"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k203::Method> {
  static constexpr std::array names{std::pair{k203::Method::narrow, "narrow"},
                                    std::pair{k203::Method::copying, "copying"}};
};
