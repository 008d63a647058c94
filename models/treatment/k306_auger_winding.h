#pragma once
// Winding of corrugated auger flights for mixers (K306): a strip is bent on edge, wound turn against turn on
// a mandrel and stretched to the pitch of the screw. Mandrel, neutral radius, blank, clamp forces, coil.
//
// Hevko, Diachun, Babaryka, Liashuk, Liubachivskyi 2011. Lengths in mm, forces in N.

#include <array>
#include <cstdint>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k306 {

struct ScrewFlight {
  double strip_width_mm = 0;
  double pitch_mm = 0;
  double outer_diameter_mm = 0;
  double inner_diameter_mm = 0;
};
struct Mandrel {
  double diameter_mm;
};
/// Mandrel that gives the screw its inner diameter after stretching: keeps the ratio of the edge lengths of
/// one turn, times the paper's 1 - 0.021 T/d. D > d > 0, 0.021 T/d < 1. K306 eq. (1), repaired: the -1
/// stands outside the root.
[[nodiscard]] Mandrel mandrel_diameter(const ScrewFlight& in);

struct ScrewDiameter {
  double outer_diameter_mm = 0;
};
struct MandrelStep {
  double min_mm, max_mm;
};
/// Diameter of the step of the mandrel, 0.8..1.2 D. K306 eq. (2).
[[nodiscard]] MandrelStep mandrel_step_range(const ScrewDiameter& in);

struct Blank {
  double thickness_mm = 0;
};
struct Groove {
  double width_min_mm, width_max_mm;
  double length_min_mm, length_max_mm;
};
/// Slot of the mandrel that holds the end of the strip: width H + 0.1..0.2 mm, length 10..12 H. K306 item 3.
[[nodiscard]] Groove groove_dimensions(const Blank& in);

struct Coil {
  double outer_radius_mm = 0;
  double inner_radius_mm = 0;
  double force_radius_mm = 0;  // at which the longitudinal force acts
};
struct NeutralRadius {
  double radius_mm;
};
/// Neutral radius of the edge bending. R >= r > 0, rho_np > R. K306 eq. (3), repaired under the root.
/// Rejected where it falls below r (R/r above about 20 with the force close to the outer edge).
[[nodiscard]] NeutralRadius neutral_radius(const Coil& in);

struct SpringClamp {
  double k1 = 0.6;  // usually 0.5..0.7
  double k_device_r = 1;
  double k_device_f = 1;
  double friction = 0;
  double turns = 0;
  double deformation_radius_mm = 0;
  double mandrel_radius_mm = 0;
  double force_n = 0;
};
struct Force {
  double force_n;
};
/// Force of the spring clamp, k1 k_r mu0 (2 pi n + k_f rho_cp/r) N. K306 eq. (4).
[[nodiscard]] Force spring_clamp_force(const SpringClamp& in);

struct Recess {
  double coils = 0;  // of the spring
  double wire_radius_mm = 0;
  double device_constant_mm = 0;
};
struct Spacing {
  double spacing_mm;
};
/// Spacing of the recesses, n pi r0 + c. K306 eq. (5).
[[nodiscard]] Spacing recess_spacing(const Recess& in);

enum class Edge { inner, outer };
struct RequiredEdge {
  Edge edge = Edge::inner;
  double edge_thickness_mm = 0;
  double outer_radius_mm = 0;
  double inner_radius_mm = 0;
  double neutral_radius_mm = 0;
};
struct BlankThickness {
  double thickness_mm;
};
/// Thickness of the strip that leaves an edge its thickness, H0 = H sqrt(r/rho0) or h sqrt(R/rho0).
/// r <= rho0 <= R. K306 eq. (6), repaired: printed with r for both edges.
[[nodiscard]] BlankThickness blank_thickness(const RequiredEdge& in);

struct ScrewStrip {
  double screw_length_mm = 0;
  double neutral_radius_mm = 0;
  double mandrel_diameter_mm = 0;
  double inner_diameter_mm = 0;
  double pitch_mm = 0;
  double strip_width_mm = 0;
  double trim = 4;                     // strip widths, usually 3..5
  double developed_length_factor = 1;  // arc over chord of the corrugation
};
struct StripLength {
  double net_mm;
  double trimmed_mm;  // with the ends that are cut off
};
/// Strip of one screw: L/T turns of a helix of the neutral diameter after stretching, 2 rho0 - d0 + d > 0.
/// K306 eq. (7), repaired, and (8).
[[nodiscard]] StripLength strip_length(const ScrewStrip& in);

struct CoilStack {
  double thickness_mm = 0;
  double strip_width_mm = 0;
  double radius_ratio = 0;  // R/r > 1
  double strip_length_mm = 0;
};
struct StackLength {
  double length_mm;
};
/// Axial length of the tight coil, L H (psi - 1)/(2 pi B psi^(1/4)). K306 eq. (9), repaired: printed
/// B^4 sqrt(psi).
[[nodiscard]] StackLength coil_stack_length(const CoilStack& in);

struct Release {
  double redistribution = 0;  // nu
  double friction = 0;
  double k_force = 0;
  double force_n = 0;
  double radial_force_n = 0;
};
/// Force that releases the coil, nu mu0 (8 pi k_N N + P_r). K306 eq. (10).
[[nodiscard]] Force release_force(const Release& in);

struct EdgeBending {
  double flow_stress_mpa = 0;
  double thickness_mm = 0;
  double outer_radius_mm = 0;
  double inner_radius_mm = 0;
  double neutral_radius_mm = 0;
};
/// Longitudinal force of a rigid-plastic strip, 2 sigma_s H0 rho0 ln(sqrt(R r)/rho0): tension positive.
/// r <= rho0 <= R. COMPLETION.
[[nodiscard]] Force longitudinal_force(const EdgeBending& in);

struct Winding {
  double strip_length_mm = 0;
  double neutral_radius_mm = 0;
  double spindle_rpm = 0;
  std::int64_t turns_per_winding = 15;  // usually 10..15
  double setup_min = 0;
};
struct WindingTime {
  double turns;
  std::int64_t windings;
  double time_min;
};
/// Turns, loads of the mandrel and time of winding a strip. COMPLETION.
[[nodiscard]] WindingTime winding_time(const Winding& in);

struct AugerScrew {
  double outer_diameter_mm = 0;
  double inner_diameter_mm = 0;
  double pitch_mm = 0;
  double length_mm = 0;
  double inner_thickness_mm = 0;   // required at the inner edge
  double force_radius_factor = 0;  // rho_np/R > 1
  double trim = 4;
};
struct AugerBlank {
  double strip_width_mm;
  double mandrel_diameter_mm;
  double neutral_radius_mm;
  double thickness_mm;
  double net_mm;
  double trimmed_mm;
  double stack_mm;
};
/// Blank and mandrel of a screw: the chain of eqs. (1), (3), (6)-(9) on the radii of the tight coil.
[[nodiscard]] AugerBlank auger_blank_plan(const AugerScrew& in);

}  // namespace verstat::models::k306

template <>
struct verstat::models::EnumNames<verstat::models::k306::Edge> {
  static constexpr std::array names{std::pair{k306::Edge::inner, "inner"},
                                    std::pair{k306::Edge::outer, "outer"}};
};
