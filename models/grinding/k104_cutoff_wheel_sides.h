#pragma once
// Side surfaces of abrasive cut-off wheels (K104): the probability that side grains remove the kerf wall, the
// largest grain density at which each of them still cuts, and the smallest radial feed that avoids burning.
//
// Novoselov, Levchenko 2011. Through all functions: grain tip radius rho mm, relative depth t/rho of a
// grain's penetration, wheel speed m/s, feeds mm/s, k >= 1 exponent of the grain height distribution, m
// 0.3..1 exponent of the grain profile (0.5 a parabolic tip), K_c chip-formation coefficient. The usual
// ranges are no limits: only values that are not positive are refused.

#include <array>
#include <numbers>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k104 {

struct CutoffPair {
  double workpiece_diameter_mm = 0;
  double wheel_diameter_mm = 0;
};
struct SideLayer {
  double layer_mm;
};
/// Layer that the wheel's sides take in one cut of a pipe of 20..120 mm. K104 Table 1 with the interpolation
/// of the card (COMPLETION): a base column for a 300 mm wheel, 5e-5 mm less per mm of wheel above, the wheel
/// clamped to 300..600 mm and the layer to 0.002..0.003 of the pipe.
[[nodiscard]] SideLayer side_layer_thickness(const CutoffPair& in);

struct SideFeedInputs {
  double layer_mm = 0;
  double radial_feed_mm_s = 0;
  double workpiece_diameter_mm = 0;
};
struct SideFeed {
  double feed_mm_s;
};
/// Side feed that takes the layer during the cut, S_x = dh S_y / d. K104, implied before eq. (4).
[[nodiscard]] SideFeed side_feed(const SideFeedInputs& in);

struct SideContact {
  double grain_density_mm2 = 0;
  double wheel_speed_m_s = 0;
  double side_feed_mm_s = 0;
  double contact_time_s = 0;
  double active_depth_mm = 0;
  double grain_tip_radius_mm = 0;
  double chip_coefficient = 0.8;
  double k = 1.5;
  double m = 0.5;
};
struct Removal {
  double exponent;
  double probability;
};
/// Probability P = 1 - exp(-a) that wall material is removed after a contact time >= 0:
///   a = 1000 k K_c C_b B(m+1, k) n V_k (V_y tau)^(k+m+1) / (H_u^k (k+m+1) V_y),   C_b = 2 sqrt(2) rho^(1-m)
/// K104 eq. (1); C_b is not printed: recovered from eq. (3) for m = 1/2, COMPLETION for other m. The path
/// V_y tau must not leave the active layer H_u (1e-9 relative allowed for rounding).
[[nodiscard]] Removal side_removal_exponent(const SideContact& in);

struct ProfileExponents {
  double k = 1.5;
  double m = 0.5;
  double median_exponent = std::numbers::ln2;
};
struct Coefficient {
  double coefficient;
};
/// Coefficient of eq. (3), c = ln 2 * 2^(k-1.5) (k+m+1) / (k B(m+1, k)); printed 3.53 for k = 1.5, m = 0.5.
/// median_exponent stands for ln 2, the removal exponent at the mean line of the profile.
[[nodiscard]] Coefficient density_coefficient(const ProfileExponents& in);

struct SideGrains {
  double layer_mm = 0;
  double radial_feed_mm_s = 0;
  double workpiece_diameter_mm = 0;
  double grain_tip_radius_mm = 0;
  double relative_depth = 0;
  double wheel_speed_m_s = 0;
  double chip_coefficient = 0.8;
  double k = 1.5;
  double m = 0.5;
};
struct GrainDensity {
  double density_mm2;
};
/// Largest number of side grains per mm2 at which each still penetrates t/rho. K104 eqs. (3), (4), with V_k
/// in m/s: n = c S_x / (K_c rho^2 (t/rho)^(m+1) 1000 V_k).
[[nodiscard]] GrainDensity max_side_grain_density(const SideGrains& in);

struct WheelInCut {
  double grain_density_mm2 = 0;
  double layer_mm = 0;
  double radial_feed_mm_s = 0;
  double workpiece_diameter_mm = 0;
  double grain_tip_radius_mm = 0;
  double wheel_speed_m_s = 0;
  double chip_coefficient = 0.8;
};
struct RelativeDepth {
  double relative_depth;
};
/// Relative depth t/rho that the side grains reach. K104 eq. (4) inverted, k = 1.5, m = 0.5.
[[nodiscard]] RelativeDepth relative_cut_depth(const WheelInCut& in);

struct WheelForDepth {
  double grain_density_mm2 = 0;
  double layer_mm = 0;
  double workpiece_diameter_mm = 0;
  double grain_tip_radius_mm = 0;
  double relative_depth = 0;
  double wheel_speed_m_s = 0;
  double chip_coefficient = 0.8;
};
struct RadialFeed {
  double feed_mm_s;
  double feed_mm_min;
};
/// Smallest radial feed at which the side grains reach t/rho. K104 eq. (4) inverted, k = 1.5, m = 0.5.
[[nodiscard]] RadialFeed min_radial_feed(const WheelForDepth& in);

enum class CutRegime { plastic, transition, cutting, intensive_cutting };
struct GrainDepth {
  double relative_depth = 0;
};
struct GrainRegime {
  CutRegime regime;
};
/// What a grain does at a relative depth >= 0: plastic below 0.04, transition to 0.08, cutting to 0.25,
/// intensive cutting from there. K104 condition (0).
[[nodiscard]] GrainRegime grain_cut_regime(const GrainDepth& in);

struct Cutoff {
  double workpiece_diameter_mm = 0;
  double radial_feed_mm_s = 0;
  double wheel_thickness_mm = 0;
  double layer_mm = 0;
};
struct TimeAndKerf {
  double main_time_min;
  double kerf_width_mm;
};
/// Main time d/(60 S_y) of a cut and kerf width, wheel plus side layer. COMPLETION.
[[nodiscard]] TimeAndKerf cutoff_time_and_kerf(const Cutoff& in);

}  // namespace verstat::models::k104

template <>
struct verstat::models::EnumNames<verstat::models::k104::CutRegime> {
  using enum k104::CutRegime;
  static constexpr std::array names{std::pair{plastic, "plastic"}, std::pair{transition, "transition"},
                                    std::pair{cutting, "cutting"},
                                    std::pair{intensive_cutting, "intensive_cutting"}};
};
