#pragma once
// Clamping force limited by the phase-transformation temperature in elastic-scheme grinding (K118).
//
// In the elastic scheme the part is pressed to the wheel with a set force; depth of cut, removal rate,
// temperature and quality follow from it. The forces of all grains in the contact zone (shear plane plus wear
// flat, flow stress falling linearly with temperature) are summed, and the temperature of the zone is that of
// a moving band source.
//
// Burdin, Matyukha 2011: plunge surface grinding of flat knives with a metal-bonded diamond wheel. Defaults
// are the regime of Table 1 with steel R6M5.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k118 {

/// Wheel face and speeds.
struct WheelContact {
  double wheel_radius_mm = 125;
  double wheel_speed_m_s = 35;
  double work_speed_m_min = 6;
  double width_mm = 1;
  double concentration_pct = 100;
  double grains_per_carat = 100000;
  double weibull_m = 1.69;
  double weibull_x0_um_m = 262;
  double kd_intercept = 14.32;
  double kd_slope = 0.112;
  double k_l = 2.46;
  double k_contact = 0.44;
};
struct DepthOfCut {
  double depth_um = 15;
};
/// Cutting by one grain.
struct GrainCutting {
  double roughness_rz_um = 4;
  double shrinkage = 1.35;
  double time_after_dress_min = 1;
  double k_flank = 1;
  double friction = 0.2;
  double tip_radius_um = 10;
  double cone_angle_deg = 100;
};
/// Flow stress C - alpha T (T in kelvin) and the calibration of the forces.
struct Steel {
  double flow_c_mpa = 723;
  double flow_alpha_mpa_k = 0.255;
  double k_cal = 1.33;
};
struct HeatPath {
  double conductivity_w_mk = 24;
  double diffusivity_m2_s = 6.4e-6;
  double heat_fraction = 0.6;
};

struct ContactInputs : WheelContact, DepthOfCut {};
struct ContactGeometry {
  double grain_diameter_um;
  double grain_spacing_body_mm;
  double grain_spacing_surface_mm;
  double active_share;
  double k_height;
  double k_kinematic;
  double grain_pitch_mm;
  double chip_thickness_max_um;
  double contact_length_mm;
  double contact_area_mm2;
  double active_grains;
};
/// Kinematics of the wheel surface and the arc of contact; K118, unnumbered equations before eq. (1). The
/// work advance between two grains is limited to the contact length (completion).
[[nodiscard]] ContactGeometry grinding_contact_geometry(const ContactInputs& in);

struct GrainCutInputs : WheelContact, DepthOfCut, GrainCutting {};
struct GrainCut {
  double chip_thickness_um;
  double rake_deg;
  double shear_angle_deg;
  double stress_ratio;
  double action_angle_deg;
  double wear_flat_um;
  double tip_width_mm;
  double cut_width_mm;
  double normal_factor_mm2;
  double tangential_factor_mm2;
};
/// Cut of one grain and the force factors of all grains (force = factor x flow stress); K118, brackets of eq.
/// (1), the tangential one a completion. Error when the chip is thicker than the grain.
[[nodiscard]] GrainCut grinding_grain_cut(const GrainCutInputs& in);

struct ForceInputs : WheelContact, DepthOfCut, GrainCutting, Steel {
  double temperature_c = 0;
};
struct ForcesAtTemperature {
  double flow_stress_mpa;
  double clamp_force_n;
  double tangential_force_n;
};
/// Forces at the given depth if the zone were at the given temperature, K118 eq. (6) with T in kelvin.
/// -273 < T < C/alpha - 273.
[[nodiscard]] ForcesAtTemperature clamp_force_at_temperature(const ForceInputs& in);

struct HeatInputs : HeatPath {
  double wheel_speed_m_s = 35;
  double work_speed_m_min = 6;
  double contact_length_mm = 0;
  double width_mm = 1;
};
struct RiseInputs : HeatInputs {
  double tangential_force_n = 0;
};
struct TemperatureRise {
  double temperature_rise_k;
  double peclet_h;
};
/// Temperature rise of the surface, K118 eq. (4), with H = V_d L/(4a) (completion). Good for H > 2 or so.
[[nodiscard]] TemperatureRise grinding_temperature_rise(const RiseInputs& in);

struct ForceLimitInputs : HeatInputs {
  double allowed_rise_k = 0;
};
struct ForceLimit {
  double tangential_force_n;
  double peclet_h;
};
/// Tangential force that brings the allowed rise, K118 eq. (5): eq. (4) solved for the force, heat fraction
/// outside the root.
[[nodiscard]] ForceLimit tangential_force_limit(const ForceLimitInputs& in);

struct ElasticWithoutDepth : WheelContact, GrainCutting, Steel, HeatPath {
  double ambient_c = 20;
};
struct ElasticInputs : ElasticWithoutDepth, DepthOfCut {};
struct ElasticState {
  double temperature_c;
  double flow_stress_mpa;
  double clamp_force_n;
  double tangential_force_n;
  double power_kw;
  double removal_rate_mm3_min;
};
/// Force and temperature solved together for a given depth. COMPLETION.
[[nodiscard]] ElasticState elastic_grinding_state(const ElasticInputs& in);

struct ClampInputs : ElasticWithoutDepth {
  double clamp_force_n = 0;
};
struct DepthFromClamp {
  double depth_um;
  double temperature_c;
  double tangential_force_n;
};
/// Depth, 1..60 um, that a set clamp force produces. COMPLETION. Error when the force is outside P_n(1 um) ..
/// P_n(60 um).
[[nodiscard]] DepthFromClamp elastic_depth_from_clamp(const ClampInputs& in);

struct ThermalLimitInputs : ElasticWithoutDepth {
  double critical_c = 0;
};
struct ThermalLimit {
  double depth_um;
  double clamp_force_n;
  bool limited;
};
/// Largest depth in 1..60 um, and its clamp force, without reaching the critical temperature. COMPLETION. Not
/// limited: 60 um; exceeded already at 1 um: 1 um.
[[nodiscard]] ThermalLimit thermal_limit_state(const ThermalLimitInputs& in);

struct PassInputs {
  double allowance_um = 0;
  double depth_um = 15;
  double stroke_length_mm = 0;
  double work_speed_m_min = 6;
};
struct GrindingTime {
  std::int64_t passes;
  double time_min;
};
/// Passes and main time for an allowance, without spark-out and reversal. COMPLETION.
[[nodiscard]] GrindingTime elastic_grinding_time(const PassInputs& in);

}  // namespace verstat::models::k118
