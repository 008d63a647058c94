#pragma once
// Delamination in drilling a laminate with a two-stage step drill (K404): the critical thrust of each stage,
// the exit feed it allows, the best ratio of the stages and the published geometry.
//
// Globa, Kukhanovskyi 2011 (TWINTEX, glass fibre in polypropylene). Throughout: gd = G_IC D in N^2 (critical
// energy release rate N/mm times bending stiffness of the uncut ply N mm), xi = d_1/d_2 ratio of the stage
// diameters, nu Poisson's ratio 0..0.45.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k404 {

struct Ply {
  double e_modulus_mpa = 0;
  double thickness_mm = 0;
  double poisson = 0;
};
struct BendingStiffness {
  double stiffness_n_mm;
};
/// Bending stiffness of the uncut ply, D = E h^3 / (12 (1 - nu^2)); E, h > 0. K404 under eq. (1).
[[nodiscard]] BendingStiffness bending_stiffness(const Ply& in);

struct StressIntensity {
  double k_i_mpa_m05 = 0;  // MPa m^0.5
  double e_modulus_mpa = 0;
  double poisson = 0;
};
struct EnergyReleaseRate {
  double g_ic_n_mm;
};
/// Critical energy release rate, G_IC = (1 - nu^2) K_I^2 / E, times 1000 from MPa m to N/mm. K404 under (1).
[[nodiscard]] EnergyReleaseRate energy_release_rate(const StressIntensity& in);

struct FirstStagePlate {
  double gd_n2 = 0;
  double poisson = 0;
};
struct CriticalThrust {
  double thrust_n;
};
/// Critical thrust of the first stage, a point load on a simply supported disc:
///   P = 4 pi sqrt(2 G_IC D (1 + nu) / (3 + nu)).   K404 eq. (1)
[[nodiscard]] CriticalThrust critical_thrust_first_stage(const FirstStagePlate& in);

struct NextStagePlate {
  double gd_n2 = 0;
  double poisson = 0;
  double ratio = 0;
};
struct NextStageThrust {
  double thrust_n;
  bool valid;
};
/// Critical thrust of the next stage, a load on a ring round the open hole, 0 < xi <= 1. K404 eq. (2) as
/// printed. Its bracket changes sign at next_stage_pole: beyond it the absolute value is taken, which
/// reproduces the printed table, and `valid` is false: do not use the force then. Error at the pole.
[[nodiscard]] NextStageThrust critical_thrust_next_stage(const NextStagePlate& in);

struct PoissonRatio {
  double poisson = 0;
};
struct Pole {
  double ratio;
};
/// Ratio at which the bracket of eq. (2) changes sign; eq. (2) is usable well below it.
[[nodiscard]] Pole next_stage_pole(const PoissonRatio& in);

/// Critical thrust of a clamped annulus loaded on its hole edge, 0 <= xi < 1 (0: the first stage):
///   F = 4 pi sqrt(2 gd) [(1-nu) + (1+nu) xi^2] / [(1-nu)(1-xi^2) - 2 (1+nu) xi^2 ln xi].   K404 (C1)
/// COMPLETION: one boundary condition for both stages, no pole. Recommended for both.
[[nodiscard]] CriticalThrust critical_thrust_clamped(const NextStagePlate& in);

struct LoadedPlate {
  double thrust_n = 0;
  double stiffness_n_mm = 0;
  double poisson = 0;
  double support_radius_mm = 0;
  double radius_mm = 0;
};
struct Deflection {
  double deflection_mm;
};
/// Deflection at the radius 0 <= r <= a of a simply supported disc under a central load:
///   w = P / (16 pi D) [(3+nu)/(1+nu) (a^2 - r^2) + 2 r^2 ln(r/a)].   K404 eq. (3)
[[nodiscard]] Deflection plate_deflection(const LoadedPlate& in);

struct DeflectionLimit {
  double thrust_n = 0;
  double stiffness_n_mm = 0;
  double poisson = 0;
  double support_radius_mm = 0;
  double deflection_limit_mm = 0;
};
struct StageRadius {
  double radius_mm;
};
/// Smallest radius with a deflection not above the limit >= 0: 0 when even the centre meets it, a when the
/// limit is 0. Inverse of plate_deflection.
[[nodiscard]] StageRadius stage_radius_for_deflection(const DeflectionLimit& in);

struct StepDrillLoad {
  double diameter_mm = 0;
  double ratio = 0;
  double critical_first_n = 0;
  double critical_next_n = 0;
  double c_first_n_mm = 0;
  double c_next_n_mm = 0;
  double exponent = 0;
  double safety = 1;
};
struct FeedLimit {
  double feed_first_mm_rev;
  double feed_next_mm_rev;
  double feed_max_mm_rev;
  std::int64_t binding_stage;
};
/// Largest exit feed per stage with the thrust model F = c w f^y, w the diameter that the stage takes, and
/// the stage that limits (1 on a tie). 0 < xi < 1, y 0.5..1, safety >= 1. K404 (C2), COMPLETION.
[[nodiscard]] FeedLimit step_drill_feed_limit(const StepDrillLoad& in);

struct StepDrillChoice {
  double gd_n2 = 0;
  double poisson = 0;
  double diameter_mm = 0;
  double c_first_n_mm = 0;
  double c_next_n_mm = 0;
  double exponent = 0;
  double safety = 1;
};
struct BestRatio {
  double ratio;
  double feed_max_mm_rev;
};
/// Ratio 0.1..0.9 of the largest exit feed by (C1) and (C2): where the limits of both stages cross, or the
/// end of the range. COMPLETION.
[[nodiscard]] BestRatio best_step_ratio(const StepDrillChoice& in);

struct ThrustScatter {
  double thrust_mean_n = 0;
  double cv_thrust = 0;
  double critical_n = 0;
  double cv_critical = 0;
};
struct Delamination {
  double probability;
};
/// Probability that a normal thrust exceeds a normal critical thrust, K404 (C3), COMPLETION. Without scatter
/// 0, 0.5 or 1 for a mean below, at or above the critical thrust.
[[nodiscard]] Delamination delamination_probability(const ThrustScatter& in);

struct DrillSize {
  double diameter_mm = 0;
  double ratio = 0.4;
};
struct DrillGeometry {
  double first_diameter_mm;
  double next_diameter_mm;
  double helix_deg;
  double first_point_deg;
  double next_point_deg;
  double first_relief_deg;
  double next_relief_deg;
  double chisel_angle_deg;
  double web_radius_mm;
};
/// The published geometry of the step drill with the stage diameters xi d and d. K404, table of the geometry.
[[nodiscard]] DrillGeometry step_drill_geometry(const DrillSize& in);

struct StaticRelief {
  double relief_deg = 0;
  double feed_mm_rev = 0;
  double radius_mm = 0;
  double half_point_deg = 0;  // not used by this approximation
};
struct WorkingRelief {
  double relief_deg;
};
/// Relief left at the radius r by the feed, alpha - arctan(f / (2 pi r)), in the plane parallel to the axis.
/// K404 (C4), COMPLETION.
[[nodiscard]] WorkingRelief working_relief(const StaticRelief& in);

struct StepDrilling {
  double thickness_mm = 0;
  double diameter_mm = 0;
  double ratio = 0;
  double first_point_deg = 0;
  double next_point_deg = 0;
  double step_length_mm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double feed_mm_rev = 0;
  double speed_rpm = 0;
};
struct DrillingTime {
  double travel_mm;
  double time_min;
};
/// Travel until the second stage is through, both cones and the first stage's cylinder included, and its
/// time. Full point angles. K404 (C5), COMPLETION.
[[nodiscard]] DrillingTime step_drilling_time(const StepDrilling& in);

}  // namespace verstat::models::k404
