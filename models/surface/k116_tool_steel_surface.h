#pragma once
// Surface layer and fatigue strength of hardened tool steel KhVSG (HRC 54-56) after abrasive grinding,
// grinding with a BN wheel (Geksanit-A) and hard turning with a BN cutter (Geksanit-R) (K116).
//
// Volkogon, Antoniuk, Fedoran, Kotliar, Kravchuk 2011. Measured tables and a fatigue curve.

#include <array>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k116 {

/// Finishes with a fatigue curve; the number is the cutting speed in m/min.
enum class FatigueFinish {
  grinding_abrasive,
  turning_geksanit_r_50,
  turning_geksanit_r_100,
  turning_geksanit_r_200
};
enum class Wheel { abrasive, geksanit_a };
enum class LayerFinish { abrasive_wheel, geksanit_a_wheel, geksanit_r_turning };

struct FatigueLoad {
  FatigueFinish finish = FatigueFinish::grinding_abrasive;
  double stress_mpa = 0;
};
struct FatigueLife {
  double cycles;
};
/// Mean life in rotating bending at a stress amplitude of 500..1000 MPa, lg N = A - M lg(sigma / 10 MPa).
/// K116 eq. (3), repaired: decimal logarithms, falling, stress in kgf/mm2. Outside 1e5..1e7 cycles the value
/// is an extrapolation; it is never clamped.
[[nodiscard]] FatigueLife fatigue_life_cycles(const FatigueLoad& in);

struct FatigueBase {
  FatigueFinish finish = FatigueFinish::grinding_abrasive;
  double cycles = 1e7;
};
struct FatigueLimit {
  double limit_mpa;
};
/// Fatigue limit for a base of 1e5..1e7 cycles. Inverse of fatigue_life_cycles.
[[nodiscard]] FatigueLimit fatigue_limit(const FatigueBase& in);

struct TurningSpeed {
  double cutting_speed_m_min = 0;
};
/// Fatigue limit at 1e7 cycles after hard turning, linear between the printed limits at 50, 100 and 200 m/min
/// and their end values outside. COMPLETION.
[[nodiscard]] FatigueLimit turned_fatigue_limit_vs_speed(const TurningSpeed& in);

struct GroundLayer {
  Wheel wheel = Wheel::abrasive;
  double depth_um = 0;
};
struct Austenite {
  double percent;
};
/// Retained austenite at a depth >= 0 after grinding, linear between the depths of K116 Table 1 (10..160 um),
/// end values outside.
[[nodiscard]] Austenite austenite_after_grinding(const GroundLayer& in);

/// Retained austenite after hard turning, linear between the speeds of K116 Table 2 (20..250 m/min), end
/// values outside.
[[nodiscard]] Austenite austenite_after_turning(const TurningSpeed& in);

struct LayerChoice {
  LayerFinish finish = LayerFinish::abrasive_wheel;
};
struct DepthRange {
  double from_um;
  double to_um;
};
/// Depth range of the high-temperature-tempered zone. K116, text.
[[nodiscard]] DepthRange tempered_zone_depth(const LayerChoice& in);

struct LineIntensities {
  double alpha = 0;
  double gamma = 0;
};
/// Retained austenite from the integral intensities >= 0 (not both 0) of the (110) alpha and (111) gamma
/// X-ray lines, 100 S_gamma / (0.66 S_alpha + S_gamma). K116 eq. (1).
[[nodiscard]] Austenite retained_austenite_percent(const LineIntensities& in);

struct LineShift {
  double e_modulus_mpa = 0;
  double poisson = 0;
  double bragg_angle_deg = 0;
  double shift_deg = 0;
};
struct StressSum {
  double sum_mpa;
};
/// Sum of the principal residual stresses, E/mu cot(Theta) dTheta, from the shift of the Bragg angle
/// (machined minus initial) at normal incidence; tension positive. E > 0, 0 < mu <= 0.5, 0 < Theta < 90 deg.
/// K116 eq. (2).
[[nodiscard]] StressSum xray_principal_stress_sum(const LineShift& in);

}  // namespace verstat::models::k116

template <>
struct verstat::models::EnumNames<verstat::models::k116::FatigueFinish> {
  using enum k116::FatigueFinish;
  static constexpr std::array names{std::pair{grinding_abrasive, "grinding_abrasive"},
                                    std::pair{turning_geksanit_r_50, "turning_geksanit_r_50"},
                                    std::pair{turning_geksanit_r_100, "turning_geksanit_r_100"},
                                    std::pair{turning_geksanit_r_200, "turning_geksanit_r_200"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k116::Wheel> {
  static constexpr std::array names{std::pair{k116::Wheel::abrasive, "abrasive_wheel"},
                                    std::pair{k116::Wheel::geksanit_a, "geksanit_a_wheel"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k116::LayerFinish> {
  using enum k116::LayerFinish;
  static constexpr std::array names{std::pair{abrasive_wheel, "abrasive_wheel"},
                                    std::pair{geksanit_a_wheel, "geksanit_a_wheel"},
                                    std::pair{geksanit_r_turning, "geksanit_r_turning"}};
};
