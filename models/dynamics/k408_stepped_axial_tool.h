#pragma once
// Natural frequencies, modes and receptance of stepped axial tools (reamers, boring bars) as elastic beams
// under six schemes of holder and hole, and the reaming speed they allow (K408).
//
// Sergeechev 2011. Euler-Bernoulli: good for L/D >= 10 and the first two modes.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k408 {

struct KrylovArgument {
  double x = 0;
};
struct KrylovValues {
  double a, b, c, d;
};
/// Krylov functions: halves of cosh + cos, sinh + sin, cosh - cos, sinh - sin, for x >= 0.
[[nodiscard]] KrylovValues krylov_abcd(const KrylovArgument& in);

/// A tool of segments from the holder end to the tip, under a scheme 1..6:
/// holder rigid (1, 2), rocking (3, 4) or floating (5, 6); tip pinned (odd) or clamped (even).
struct AxialTool {
  std::int64_t scheme = 1;
  std::vector<double> length_mm;
  std::vector<double> outer_mm;
  std::vector<double> inner_mm;  // empty: no bore
  std::vector<double> j_factor;  // empty: 1; inertia of the fluted section over that of the ring
  std::vector<double> a_factor;  // empty: 1; area likewise
  double modulus_gpa = 210;
  double density_kg_m3 = 7850;
};
struct ToolSpectrum : AxialTool {
  std::int64_t count = 3;
};
struct NaturalFrequencies {
  std::vector<double> omega_rad_s, frequency_hz;
};
/// Lowest natural frequencies, ascending: roots of the frequency determinant.
[[nodiscard]] NaturalFrequencies axial_tool_frequencies(const ToolSpectrum& in);

struct ToolMode : AxialTool {
  std::int64_t mode = 1;
};
struct NodeShape {
  std::vector<double> displacement;  // at the segment ends, the largest +1
};
/// Displacements of a mode at the segment ends.
[[nodiscard]] NodeShape axial_tool_mode(const ToolMode& in);

struct ForcedTool : AxialTool {
  std::int64_t node_force = 0;
  std::int64_t node_response = 0;
  double frequency_hz = 0;
  double loss_factor = 0.02;
};
struct Receptance {
  double real_um_n, imaginary_um_n, magnitude_um_n;
};
/// Displacement at a node per unit harmonic force at a node, hysteretic damping. COMPLETION.
[[nodiscard]] Receptance axial_tool_receptance(const ForcedTool& in);

struct ToothFrequency {
  double frequency_hz = 0;
  std::int64_t teeth = 1;
  double diameter_mm = 0;
  double margin = 0.2;
};
struct ReamingSpeed {
  double spindle_rpm, speed_m_min;
};
/// Speed that keeps the tooth frequency below (1 - margin) f1. COMPLETION.
[[nodiscard]] ReamingSpeed reaming_speed_limit(const ToothFrequency& in);

struct ReamedHole {
  double length_mm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double speed_m_min = 0;
  double diameter_mm = 0;
  double feed_mm_rev = 0;
};
struct ReamingTime {
  double spindle_rpm, main_time_min;
};
/// Main time of reaming. COMPLETION.
[[nodiscard]] ReamingTime reaming_main_time(const ReamedHole& in);

}  // namespace verstat::models::k408
