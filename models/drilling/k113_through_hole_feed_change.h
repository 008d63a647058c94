#pragma once
// Drilling of through holes (K113): thrust and torque as random quantities over a group of steels, the feed
// that torsion and buckling of the drill allow, the feed jump at breakthrough, and a spring-loaded drill
// holder that finishes the hole with the quill at rest, compared with three other exit strategies.
//
// Kryvyi, Kobelnyk 2011. The paper numbers equations (1)-(6); (a), (b), (7)-(9) are its unnumbered formulas,
// (C1)-(C10) are completions.

#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k113 {

// ------------------------------------------------------------------------------------ loads of a drill

struct DrillThrustInputs {
  double coefficient = 0;  // C_1
  double diameter_mm = 0;
  double feed_mm_rev = 0;
  double hardness_hb = 0;
  double exp_diameter = 0;
  double exp_feed = 0;
  double exp_hardness = 0;
};
struct DrillThrust {
  double thrust_n;
};
/// Thrust of a drill, P = C_1 D^z S^y HB^n. All but the exponents > 0. K113 eq. (1); the paper prints no
/// coefficients.
[[nodiscard]] DrillThrust drill_thrust(const DrillThrustInputs& in);

struct FeedRuleInputs {
  double feed_coefficient = 0;  // C_s
  double diameter_mm = 0;
};
struct FeedRule {
  double feed_mm_rev;
};
/// Feed from the diameter, S = C_s D^0.6. K113 eq. (2).
[[nodiscard]] FeedRule drill_feed_rule(const FeedRuleInputs& in);

struct ThrustLawInputs {
  double coefficient = 0;  // C_1
  double hardness_hb = 0;
  double feed_coefficient = 0;  // C_s
  double exp_diameter = 0;
  double exp_feed = 0;
  double exp_hardness = 0;
};
struct ThrustLaw {
  double coefficient;  // N mm^-x
  double exponent;
};
/// Thrust against diameter when the feed follows (2): P = C_o D^x_o, C_o = C_1 HB^n C_s^y, x_o = z + 0.6 y.
/// K113 eq. (3).
[[nodiscard]] ThrustLaw thrust_diameter_law(const ThrustLawInputs& in);

struct LoadFitInputs {
  std::vector<double> diameters_mm;  // at least two distinct
  std::vector<double> loads;         // as many, > 0: mean thrust or torque
};
struct LoadFit {
  double coefficient;
  double exponent;
  double r_squared;  // in log space; 1 when all loads are equal
};
/// Least squares of lg P = x_o lg D + lg C_o. K113 eq. (4); the paper reads slope and intercept off a graph.
[[nodiscard]] LoadFit fit_load_diameter_law(const LoadFitInputs& in);

struct GroupLoadInputs {
  std::vector<double> coefficients;  // C_i of the materials, > 0, at least two
  std::vector<double> exponents;     // x_i, as many
  double diameter_mm = 0;
  double sigma_multiplier = 3;
};
struct GroupLoad {
  double coefficient_mean;
  double coefficient_sd;  // denominator m - 1
  double exponent_mean;
  double exponent_sd;
  double load_likely;        // of the paper
  double load_max;           // of the paper: coefficient and exponent at +k sigma together
  double load_median_joint;  // (C8): keeps the correlation of coefficient and exponent
  double load_max_joint;
};
/// Most likely and largest load over a group of materials: P = mean(C) D^mean(x),
/// P_max = (mean(C) + k s_C) D^(mean(x) + k s_x). K113 eqs. (5), (6). The joint values are a COMPLETION (C8):
/// mean and standard deviation of ln P_i at the given diameter. The unit is that of the coefficients (N, N
/// m).
[[nodiscard]] GroupLoad group_load_bounds(const GroupLoadInputs& in);

struct FeedLimitInputs {
  double diameter_mm = 0;
  double torsion_allow_mpa = 0;
  double section_modulus_mm3 = 0;  // polar
  double torque_coefficient_nm = 0;
  double torque_exp_diameter = 0;
  double torque_exp_feed = 0;
  double elastic_modulus_mpa = 0;
  double inertia_mm4 = 0;  // least of the section
  double overhang_mm = 0;
  double length_factor = 0;  // M, 0.5 to 2 in textbooks
  double thrust_coefficient_n = 0;
  double thrust_exp_diameter = 0;
  double thrust_exp_feed = 0;
};
struct FeedLimits {
  double feed_torsion_mm_rev;
  double critical_thrust_n;
  double feed_buckling_mm_rev;
  double feed_limit_mm_rev;
  std::int64_t buckling_governs;  // 1 only when the buckling feed is strictly the smaller
};
/// Largest feeds that the drill stands in torsion and as a compressed bar:
///   S_tor = ([tau] W / (1000 C_m D^x_m))^(1/y_m),  S_st = (pi^2 E I / (C_po D^x_po M^2 l^2))^(1/y_po).
/// K113 (a), (b), reconstructed from a scattered print; 1000 turns N m into N mm.
[[nodiscard]] FeedLimits drill_strength_feed_limits(const FeedLimitInputs& in);

// ------------------------------------------------------------------------------- the spring feed holder

struct SpringHolderInputs {
  double thrust_n = 0;  // steady
  double spring_rate_n_mm = 0;
  double diameter_mm = 0;
  double half_point_angle_deg = 0;
  double zone_fraction = 0;  // exit zone over diameter
  double part_thickness_mm = 0;
};
struct SpringHolder {
  double spring_compression_mm;
  double point_height_mm;
  double zone_mm;
  double switch_distance_mm;  // quill travel from full engagement to the limit switch
  double spring_rate_limit_n_mm;
  std::int64_t spring_completes;
};
/// Spring and limit switch of the holder: x_0 = P / C (7), zone = fraction D, l_p = D/2 cot(phi) (C10),
/// h = L - (l_p + zone) (8), softest need C <= P / (zone + l_p) (C4, relative slack 1e-9).
/// Error when the part is thinner than point and zone: the switch would trip before full engagement.
[[nodiscard]] SpringHolder spring_holder_setup(const SpringHolderInputs& in);

struct FeedClutchInputs {
  double safety_factor = 0;
  double rack_module_mm = 0;
  std::int64_t rack_pinion_teeth = 0;
  double feed_force_limit_n = 0;
  double efficiency = 0;
};
struct FeedClutch {
  double clutch_torque_nm;
};
/// Torque of the clutch on the rack-pinion shaft, M_B = K m z F / (2000 eta). K113 (9), repaired: the
/// efficiency belongs to the denominator. For a clutch elsewhere divide by the transmission ratio.
[[nodiscard]] FeedClutch feed_clutch_torque(const FeedClutchInputs& in);

// --------------------------------------------------------------------------------------- breakthrough

struct LoadFactorInputs {
  double feed_jump = 1;
  double exp_feed = 0;
};
struct LoadFactor {
  double load_factor;
};
/// Load over the steady one when the feed jumps j times, k = j^y. Derived from the power law.
[[nodiscard]] LoadFactor feed_jump_load_factor(const LoadFactorInputs& in);

struct FeedJumpInputs {
  double thrust_n = 0;
  double axial_stiffness_n_mm = 0;
  double relieved_share = 0;    // of the thrust, lost at breakthrough
  double relief_travel_mm = 0;  // drill travel over which it is lost
};
struct FeedJump {
  double springback_mm;
  std::int64_t stable;              // 0: the drill is pulled through
  std::optional<double> feed_jump;  // only when stable
};
/// Feed jump from the compliance of the machine: d = kappa P / c, j = 1 / (1 - d/a). COMPLETION (C1).
[[nodiscard]] FeedJump breakthrough_feed_jump(const FeedJumpInputs& in);

struct SpringExitInputs {
  double feed_mm_rev = 0;  // nominal
  double rpm = 0;
  double spring_compression_mm = 0;
  double zone_mm = 0;
  double point_height_mm = 0;
  double exp_feed = 0;
  double chisel_share = 0;
  double feed_cap_ratio = 1;  // mechanical limit of the feed over the nominal
};
struct SpringExit {
  std::int64_t completed;
  std::optional<double> stall_advance_mm;         // when not completed
  std::optional<double> zone_time_min;            // when the compression exceeds the zone
  std::optional<double> feed_ratio_before;        // just before the chisel edge leaves
  std::optional<double> feed_ratio_after;         // just after
  std::optional<double> exit_time_min;            // when completed
  std::optional<double> total_time_min;           // when completed
  std::optional<double> residual_compression_mm;  // when completed
};
/// Motion of the drill after the quill has stopped, quasi-static: the spring force equals the thrust at the
/// current feed times the engaged share of the edges. COMPLETION (C2)-(C4). The zone in closed form, the exit
/// of the point by the midpoint rule on 20000 panels.
[[nodiscard]] SpringExit spring_exit_phase(const SpringExitInputs& in);

struct CriticalSpringInputs {
  double thrust_n = 0;
  double point_height_mm = 0;
  double chisel_share = 0;
  double exp_feed = 0;
  double zone_mm = 0;
};
struct CriticalSpring {
  double spring_rate_n_mm;
  double feed_ratio_before;
  double feed_ratio_after;
  double zone_for_unit_feed_mm;  // zone after which the exit runs at the nominal feed
};
/// Spring that is relaxed exactly at the end of the exit, x_0 = zone + l_p. COMPLETION (C5).
[[nodiscard]] CriticalSpring spring_critical_design(const CriticalSpringInputs& in);

// --------------------------------------------------------------------------- main times of the strategies

enum class ExitStrategy { constant, reduced_full_depth, reduced_exit, spring_exit };

struct HoleTimeInputs {
  ExitStrategy strategy = ExitStrategy::constant;
  double part_thickness_mm = 0;
  double point_height_mm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double feed_mm_rev = 0;
  double rpm = 0;
  // The strategies that do not use these ignore them.
  std::optional<double> zone_mm = {};
  std::optional<double> feed_divisor = {};
  std::optional<double> spring_compression_mm = {};
  std::optional<double> spring_time_min = {};  // total_time_min of spring_exit_phase
};
struct HoleTime {
  double main_time_min;
};
/// Main time of a through hole under one of four exit strategies. COMPLETION (C6).
[[nodiscard]] HoleTime through_hole_time(const HoleTimeInputs& in);

struct BreakEvenInputs {
  double point_height_mm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double zone_mm = 0;
  double feed_mm_rev = 0;
  double rpm = 0;
  double feed_divisor = 0;
  double spring_compression_mm = 0;
  double spring_time_min = 0;
};
struct BreakEven {
  double break_even_thickness_mm;
};
/// Thickness above which the spring exit is faster than the feed reduced over the full depth; 0 when it
/// always is. A value below zone + point height means faster for every part the scheme can drill.
/// COMPLETION (C7).
[[nodiscard]] BreakEven spring_break_even_thickness(const BreakEvenInputs& in);

struct BreakInputs {
  double torque_mean_nm = 0;
  double torque_sd_nm = 0;
  double load_factor = 1;
  double strength_mean_nm = 0;
  double strength_sd_nm = 0;
};
struct BreakRisk {
  double safety_index;
  double break_probability;
};
/// Probability that the torque peak breaks the drill: normal stress against normal strength,
/// beta = (M_str - k M) / sqrt(s_str^2 + k^2 s_M^2), p = Phi(-beta). COMPLETION (C9).
[[nodiscard]] BreakRisk drill_break_probability(const BreakInputs& in);

// ----------------------------------------------------------------------------------------- printed data

enum class SteelGrade { s15kh, s38kha, s30khm, s20kh2n4a, s40khf, s40khs };
struct SteelInputs {
  SteelGrade grade = SteelGrade::s15kh;
};
struct SteelHardness {
  double hardness_hb;
};
/// Brinell hardness of the alloy steels of the paper's sample.
[[nodiscard]] SteelHardness steel_hardness(const SteelInputs& in);

enum class PublishedQuantity {
  breakthrough_feed_jump,
  feed_reduction_percent,
  feed_divisor_special,
  zone_fraction,
  clutch_safety_factor,
  small_diameter_limit_mm,
  drilling_labour_share_single_percent,
  drilling_labour_share_medium_percent
};
struct PublishedRangeInputs {
  PublishedQuantity quantity = PublishedQuantity::breakthrough_feed_jump;
};
struct PublishedRange {
  double low;
  double high;
};
/// Ranges that the paper prints.
[[nodiscard]] PublishedRange published_ranges(const PublishedRangeInputs& in);

}  // namespace verstat::models::k113

template <>
struct verstat::models::EnumNames<verstat::models::k113::ExitStrategy> {
  using E = k113::ExitStrategy;
  static constexpr std::array names{
      std::pair{E::constant, "constant"}, std::pair{E::reduced_full_depth, "reduced_full_depth"},
      std::pair{E::reduced_exit, "reduced_exit"}, std::pair{E::spring_exit, "spring_exit"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k113::SteelGrade> {
  using E = k113::SteelGrade;
  static constexpr std::array names{std::pair{E::s15kh, "15Kh"},   std::pair{E::s38kha, "38KhA"},
                                    std::pair{E::s30khm, "30KhM"}, std::pair{E::s20kh2n4a, "20Kh2N4A"},
                                    std::pair{E::s40khf, "40KhF"}, std::pair{E::s40khs, "40KhS"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k113::PublishedQuantity> {
  using E = k113::PublishedQuantity;
  static constexpr std::array names{
      std::pair{E::breakthrough_feed_jump, "breakthrough_feed_jump"},
      std::pair{E::feed_reduction_percent, "feed_reduction_percent"},
      std::pair{E::feed_divisor_special, "feed_divisor_special"},
      std::pair{E::zone_fraction, "zone_fraction"},
      std::pair{E::clutch_safety_factor, "clutch_safety_factor"},
      std::pair{E::small_diameter_limit_mm, "small_diameter_limit_mm"},
      std::pair{E::drilling_labour_share_single_percent, "drilling_labour_share_single_percent"},
      std::pair{E::drilling_labour_share_medium_percent, "drilling_labour_share_medium_percent"}};
};
