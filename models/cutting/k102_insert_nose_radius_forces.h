#pragma once
// Rough turning with inserts of different nose radius and rake-face shape (K102): the uncut chip section and
// active edge, the three force components of the handbook power law, what a finite-element run said, and the
// depth rule of chip splitters.
//
// Pasichnyk, Chystiakova, Batiuk 2011. The paper prints no formula but (3); (1) is recovered from its Table 4
// and (2) is the handbook law that reproduces its Table 3.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k102 {

struct ChipSectionInputs {
  double depth_mm = 0;
  double feed_mm_rev = 0;
  double lead_angle_deg = 0;  // approach angle of the main edge to the feed direction
  double end_angle_deg = 0;   // of the minor edge
  double nose_radius_mm = 0;
};
struct ChipSection {
  double chip_area_mm2;
  double edge_length_mm;
  double mean_chip_thickness_mm;
  double residual_height_mm;  // theoretical roughness
};
/// Uncut chip section of a tool with two straight edges and a round nose, K102 (1). The residual height y* is
/// where the width of the tool outline equals the feed, or the depth when the outline stays narrower.
/// Depth, feed > 0; lead angle 10..90, end angle 1..90 deg; nose radius >= 0. A sharp nose with both angles
/// 90 has no width: an error.
[[nodiscard]] ChipSection uncut_chip_section(const ChipSectionInputs& in);

struct TurningInputs {
  double depth_mm = 0;
  double feed_mm_rev = 0;
  double speed_m_min = 0;
  double nose_radius_mm = 0;
  double lead_angle_deg = 60;
  double rake_angle_deg = 0;
  double inclination_deg = 0;     // handbook sign: positive when the nose is the lowest point
  double material_factor = 1.47;  // 1100 MPa / 750 MPa
};
struct TurningForce {
  double pz_n;  // main
  double py_n;  // radial
  double px_n;  // feed
  double p_n;   // resultant
};
/// Handbook force, P_c = 10 C t^x S^y V^n K_m K_phi K_gamma K_lambda K_r, K102 (2). Corrections linear
/// between the entries of their tables and clamped at the ends. COMPLETION: Kosilova-Meshcheryakov, carbide
/// on structural steel.
[[nodiscard]] TurningForce handbook_turning_force(const TurningInputs& in);

struct NoseRadius {
  double nose_radius_mm = 0;
};
struct NoseRadiusFactors {
  double k_pz;
  double k_py;
  double k_px;
};
/// Correction factors of the nose radius (>= 0): handbook at 0.5, 1, 2, 3 mm; the authors' own at
/// 0, 1.5, 2.5.
[[nodiscard]] NoseRadiusFactors nose_radius_force_factor(const NoseRadius& in);

struct ForceComponents {
  double pz_n = 0;
  double py_n = 0;
  double px_n = 0;
};
struct Resultant {
  double p_n;
};
/// Resultant of three components.
[[nodiscard]] Resultant resultant_force(const ForceComponents& in);

/// What the finite-element run said (Table 3: V = 100 m/min, S = 0.5 mm/rev, t = 3 mm), linear between the
/// rows, clamped outside, resultant recomputed. Single runs without experiment: not a prediction.
[[nodiscard]] TurningForce fem_turning_force(const NoseRadius& in);

enum class RakeShape { flat, peripheral_groove, bevelled_land };
struct RakeShapeInputs {
  RakeShape rake_shape = RakeShape::flat;
};
struct RakeShapeForce : TurningForce {
  double factor_pz;  // over the flat rake
  double factor_py;
  double factor_px;
  double factor_p;
};
/// Finite-element forces of three rake faces (Table 5) and their ratios to the flat one; usable as relative
/// factors only.
[[nodiscard]] RakeShapeForce rake_shape_force(const RakeShapeInputs& in);

struct DiscrepancyInputs {
  double fem_n = 0;
  double handbook_n = 0;
};
struct Discrepancy {
  double difference_n;
  double relative_to_fem;  // a fraction
};
/// FEM minus handbook, and that over FEM (> 0). K102 (4).
[[nodiscard]] Discrepancy force_model_discrepancy(const DiscrepancyInputs& in);

struct SplitterInputs {
  double splitter_height_mm = 0;
};
struct SplitterLimit {
  double max_depth_mm;
};
/// Largest depth of cut at which a chip splitter of height l works, t <= l / 1.2. K102 (3).
[[nodiscard]] SplitterLimit chip_splitter_depth_limit(const SplitterInputs& in);

struct SplitterForceInputs {
  double depth_mm = 0;
  double splitter_height_mm = 0;
  double reduction = 0.20;  // of P_z
};
struct SplitterForce {
  bool effective;  // t <= l / 1.2, equality included (to a rounding)
  double force_factor;
};
/// Factor of a chip splitter on P_z: 1 - reduction where it works, else 1. The step is a COMPLETION.
[[nodiscard]] SplitterForce chip_splitter_force_factor(const SplitterForceInputs& in);

struct TurningPowerInputs {
  double pz_n = 0;
  double speed_m_min = 0;
};
struct TurningPower {
  double power_kw;
};
/// Cutting power N = P_z V / 60000. COMPLETION.
[[nodiscard]] TurningPower turning_power(const TurningPowerInputs& in);

}  // namespace verstat::models::k102

template <>
struct verstat::models::EnumNames<verstat::models::k102::RakeShape> {
  static constexpr std::array names{std::pair{k102::RakeShape::flat, "flat"},
                                    std::pair{k102::RakeShape::peripheral_groove, "peripheral_groove"},
                                    std::pair{k102::RakeShape::bevelled_land, "bevelled_land"}};
};
