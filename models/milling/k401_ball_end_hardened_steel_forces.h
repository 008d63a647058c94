#pragma once
// Maximum forces of two-flute ball-end mills finishing hardened die steel (HRC 40..55), as regressions found
// by the group method of data handling, with their gradients, the largest feed and the best regime under
// force limits (K401).
//
// Ravskaya, Lipskiy, Skrynnik 2011. Valid inside the box n 8936..31100 rpm, f_z 0.04..0.12 mm, a_p 0.06..0.36
// mm, a_e 0.3..0.6 mm, relief 6..18 deg, HRC 40..55; outside it forces are evaluated and flagged.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k401 {

struct CutWidth {
  double spindle_rpm = 0;
  double depth_mm = 0;
  double step_over_mm = 0;
  double relief_deg = 0;
  double hardness_hrc = 0;
};
struct BallEndCut : CutWidth {
  double feed_mm_tooth = 0;
};
struct BallEndForces {
  double feed_n;       // P_x
  double push_off_n;   // P_y, along the tool axis
  double normal_n;     // P_z, normal to the feed force in the plane of rotation
  double in_plane_n;   // hypot(P_x, P_z): upper bound
  double resultant_n;  // of all three: upper bound
  bool in_range;
};
/// Maxima over a revolution, eq. (1)-(3).
[[nodiscard]] BallEndForces ball_end_forces(const BallEndCut& in);

struct ForceGradient {  // of ln P_x, ln P_y, ln P_z; per rpm, mm/tooth, mm, mm, degree, HRC
  double x_n, x_fz, x_ap, x_ae, x_alpha, x_hrc;
  double y_n, y_fz, y_ap, y_ae, y_alpha, y_hrc;
  double z_n, z_fz, z_ap, z_ae, z_alpha, z_hrc;
};
/// Derivatives of the logarithms of the three forces, eq. (4)-(6).
[[nodiscard]] ForceGradient ball_end_force_gradient(const BallEndCut& in);

enum class BindingForce { px, py, pz, range };
struct LimitedCut : CutWidth {
  double px_max_n = 0, py_max_n = 0, pz_max_n = 0;
};
struct LargestFeed {
  bool feasible;
  double feed_mm_tooth;  // 0 when infeasible
  BindingForce binding;
};
/// Largest feed in 0.04..0.12 mm/tooth that keeps three force limits.
[[nodiscard]] LargestFeed max_feed_for_force_limits(const LimitedCut& in);

struct RegimeProblem {
  double hardness_hrc = 0;
  double relief_deg = 0;
  std::int64_t teeth = 2;
  double px_max_n = 0, py_max_n = 0, pz_max_n = 0;
};
struct BestRegime {
  bool feasible;
  double spindle_rpm, feed_mm_tooth, depth_mm, step_over_mm;
  double removal_cm3_min;
};
/// Global maximum of the removal rate in the box under the force limits.
[[nodiscard]] BestRegime best_regime(const RegimeProblem& in);

struct BallFinishing {
  double spindle_rpm = 0;
  double feed_mm_tooth = 0;
  std::int64_t teeth = 2;
  double depth_mm = 0;
  double step_over_mm = 0;
  double diameter_mm = 0;
};
struct FinishingRates {
  double feed_mm_min;
  double removal_cm3_min;
  double area_cm2_min;
  double effective_diameter_mm;
  double effective_speed_m_min;
  double scallop_um;
};
/// Rates, effective diameter and speed, scallop of raster finishing, (C1)-(C4). COMPLETION.
[[nodiscard]] FinishingRates ball_finishing_rates(const BallFinishing& in);

struct PowerLoad {
  double in_plane_n = 0;
  double speed_m_min = 0;
};
struct Power {
  double power_kw;
};
/// Upper bound of the cutting power, (C5). COMPLETION.
[[nodiscard]] Power power_bound(const PowerLoad& in);

struct Overhang {
  double force_n = 0;
  double diameter_mm = 0;
  double overhang_mm = 0;
  double modulus_mpa = 0;
};
struct Deflection {
  double deflection_um;
};
/// Tip deflection of a cantilever of 0.8 d, (C6). COMPLETION.
[[nodiscard]] Deflection tool_deflection(const Overhang& in);

}  // namespace verstat::models::k401

template <>
struct verstat::models::EnumNames<verstat::models::k401::BindingForce> {
  static constexpr std::array names{
      std::pair{k401::BindingForce::px, "px"}, std::pair{k401::BindingForce::py, "py"},
      std::pair{k401::BindingForce::pz, "pz"}, std::pair{k401::BindingForce::range, "range"}};
};
