#pragma once
// Forces of ball-end mills from the chip flow that takes the least cutting power: oblique cutting with shear
// and friction power per element of the helical edge, summed over the engaged edge of a ball (K406).
//
// Dobrotvorskiy, Basova 2011; fits (14)-(16) for steel 38KhM2YuA and HSS. Angles in degrees.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k406 {

struct FlowScale {
  double vf_scale = 1e-3;   // unit of speed * feed in the fits
  double stress_scale = 1;  // calibration of the shear stress
};
struct StateInputs : FlowScale {
  double cutting_speed_m_min = 0;
  double feed_mm = 0;
  double effective_rake_deg = 0;
};
struct CuttingState {
  double x;
  double shear_angle_deg;
  double shear_stress_mpa;
  double friction_angle_deg;
};
/// Shear angle, shear stress and friction angle from x = vf_scale v f, eq. (14)-(16).
[[nodiscard]] CuttingState cutting_state(const StateInputs& in);

struct ChipFlow {
  double normal_rake_deg = 0;
  double inclination_deg = 0;
  double flow_deg = 0;
};
struct EffectiveRake {
  double effective_rake_deg;
};
/// Rake in the plane of cutting and chip velocity, eq. (17), corrected.
[[nodiscard]] EffectiveRake effective_rake(const ChipFlow& in);

struct ShearFlow : ChipFlow {
  double shear_angle_deg = 0;
};
struct AreaFactor {
  double factor;
};
/// Shear area per uncut thickness and edge length, (C1). COMPLETION.
[[nodiscard]] AreaFactor shear_area_factor(const ShearFlow& in);

struct EnergyInputs : FlowScale {
  double cutting_speed_m_min = 0;
  double feed_mm = 0;
  double normal_rake_deg = 0;
  double inclination_deg = 0;
  double flow_deg = 0;
};
struct SpecificEnergy {
  double total_n_mm2, shear_n_mm2, friction_n_mm2;
  double effective_rake_deg, shear_angle_deg, friction_angle_deg;
  double shear_stress_mpa;
  double area_factor, friction_area_factor;
};
/// Cutting power per speed, uncut thickness and edge length at a given chip-flow angle, eq. (18), (19).
[[nodiscard]] SpecificEnergy specific_energy(const EnergyInputs& in);

struct ObliqueInputs : FlowScale {
  double cutting_speed_m_min = 0;
  double feed_mm = 0;
  double normal_rake_deg = 0;
  double inclination_deg = 0;
};
struct ObliqueForces {
  double flow_deg, effective_rake_deg, shear_angle_deg, friction_angle_deg;
  double k_m;  // N/mm2 of chip section: along the cutting velocity
  double k_t;  // third axis
  double k_v;  // normal to the cut surface
  double k_f;  // friction on the rake
  double k_n;  // normal to the rake
  bool valid;
};
/// Specific forces at the chip-flow angle of least power, eq. (20)-(24).
[[nodiscard]] ObliqueForces oblique_specific_forces(const ObliqueInputs& in);

struct BallPoint {
  double diameter_mm = 10;
  double helix_deg = 30;
  double height_mm = 0;
};
struct BallGeometry {
  double radius_mm, kappa_deg, inclination_deg, lag_deg;
};
/// Radius, polar angle, edge inclination and lag of the helix at a height above the tip, (C2). COMPLETION.
[[nodiscard]] BallGeometry ball_geometry(const BallPoint& in);

struct BallSpeed {
  double diameter_mm = 10;
  double spindle_rpm = 2000;
  double depth_mm = 0.5;
};
struct MeanSpeed {
  double speed_m_min;
};
/// Mean speed of the engaged edge, (C3).
[[nodiscard]] MeanSpeed mean_edge_speed(const BallSpeed& in);

enum class CutMode { down, up, slot };
struct BallEndMill : FlowScale {
  double diameter_mm = 10;
  double helix_deg = 30;
  std::int64_t teeth = 2;
  double normal_rake_deg = 5;
  double spindle_rpm = 2000;
  double feed_mm_tooth = 0.1;
  double depth_mm = 0.5;
  double step_over_mm = 1.0;
  CutMode mode = CutMode::down;
  double edge_force_m_n_mm = 0;
  double edge_force_v_n_mm = 0;
  std::int64_t slices = 40;
};
struct BallEndMillAt : BallEndMill {
  double angle_deg = 0;
};
struct BallEndForces {
  double x_n, y_n, z_n;  // on the tool: feed, cross-feed, along the axis away from the work
  double torque_nm;
};
/// Forces and torque at a tool angle, (C2)-(C5). COMPLETION of eq. (25).
[[nodiscard]] BallEndForces ball_end_forces_at(const BallEndMillAt& in);

struct BallEndMillTurn : BallEndMill {
  std::int64_t steps = 360;
};
struct ForceSummary {
  double x_peak_n, y_peak_n, z_peak_n, resultant_peak_n, torque_peak_nm;
  double x_mean_n, y_mean_n, z_mean_n, torque_mean_nm;
  double power_mean_kw;
  double speed_m_min;
};
/// Peaks and means over a tooth pitch.
[[nodiscard]] ForceSummary ball_end_force_summary(const BallEndMillTurn& in);

struct InclinedBall {
  double diameter_mm = 10;
  double spindle_rpm = 0;
  double depth_mm = 0;
  double surface_deg = 0;
};
struct InclinedSpeed {
  double diameter_mm, speed_m_min;
};
/// Effective diameter and speed on a surface inclined to the normal of the axis, (C6). COMPLETION.
[[nodiscard]] InclinedSpeed inclined_ball_speed(const InclinedBall& in);

struct ToolForces {
  double x_n = 0, y_n = 0, z_n = 0;
  double lead_deg = 0, tilt_deg = 0;
};
struct MachineForces {
  double x_n, y_n, z_n;
};
/// Tool frame to machine frame: tilt about x, then lead about y, (C7). COMPLETION.
[[nodiscard]] MachineForces rotate_forces(const ToolForces& in);

}  // namespace verstat::models::k406

template <>
struct verstat::models::EnumNames<verstat::models::k406::CutMode> {
  static constexpr std::array names{std::pair{k406::CutMode::down, "down"},
                                    std::pair{k406::CutMode::up, "up"},
                                    std::pair{k406::CutMode::slot, "slot"}};
};
