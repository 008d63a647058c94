#pragma once
// Roughness in finish turning with a rounded nose: the height of the theoretical profile for any nose radius
// and edge angles, the fitted correction of Ra in feed, its scatter, and the largest feed that keeps a limit
// (K411). Fitted for steel 45, T15K6 inserts, v about 120 m/min, depth 1 mm, fresh edge.
//
// Grinyov, Tsarenko 2011. kr is the main, kr1 the minor edge angle, both against the feed direction.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k411 {

enum class ProfileRegime { nose_nose, nose_edge, edge_edge };
enum class FactorPolicy { hold_factor, printed };
enum class FeedStatus { infeasible, roughness_active, at_feed_max };
enum class RoughnessClass { ra_0_63, ra_1_25, ra_2_5, rz_20, rz_40, rz_80 };

struct InsertShape {
  std::int64_t faces = 4;
  double kr_deg = 0;
};
struct InsertAngles {
  double corner_deg;
  double kr1_deg;
};
/// Corner angle 180 - 360/n and minor edge angle of a regular polygon insert of n = 3..8 faces set at kr.
/// Error when no minor angle is left. COMPLETION.
[[nodiscard]] InsertAngles insert_angles(const InsertShape& in);

struct NoseGeometry {
  double nose_radius_mm = 2.0;
  double kr_deg = 45;
  double kr1_deg = 45;
};
struct TurnedSurface : NoseGeometry {
  double feed_mm_rev = 0;
};
struct TheoreticalProfile {
  double height_um;
  ProfileRegime regime;
  double feed_limit_nose_mm;  // up to here both sides of the profile are arcs of the nose
  double feed_limit_edge_mm;  // from here both sides reach the straight edges
  double ra_02h_um;           // the paper's Ra = 0.2 h
  double ra_profile_um;       // exact mean deviation of the theoretical profile
};
/// Height h of the profile left by a nose arc between two straight edges tangent to it, from
/// x_kr(h) + x_kr1(h) = s, and its mean deviation in closed form. COMPLETION (the paper takes h from
/// another).
[[nodiscard]] TheoreticalProfile theoretical_roughness(const TurnedSurface& in);

struct FittedSurface : TurnedSurface {
  FactorPolicy policy = FactorPolicy::hold_factor;
  double a = 13.686;     // eq. (1)
  double alpha = 9.369;  // eq. (1), 1/(mm/rev)^2
  double beta = -8.608;  // eq. (1), 1/(mm/rev)
};
struct FittedRoughness {
  double ra_um;
  double factor;
  double height_um;
  double equivalent_feed_mm;
  bool in_range;
};
/// Ra = a exp(alpha s^2 + beta s) 0.2 h, eq. (1), with s the feed that leaves the same h with a 2 mm nose;
/// "hold_factor" holds s inside the fitted 0.15..0.55 mm/rev, "printed" does not.
[[nodiscard]] FittedRoughness turning_ra(const FittedSurface& in);

struct FeedBounds : NoseGeometry {
  double feed_min_mm_rev = 0.05;
  double feed_max_mm_rev = 0.55;
};
struct RaLimit : FeedBounds {
  double ra_max_um = 0;
};
struct LargestFeed {
  double feed_mm_rev;  // 0 when infeasible
  FeedStatus status;
};
/// Largest feed between the bounds with Ra <= limit. Inverse of turning_ra ("hold_factor").
[[nodiscard]] LargestFeed max_feed_for_ra(const RaLimit& in);

struct ScatteredSurface : TurnedSurface {
  double variance_within_um2 = 0.007128;  // weighted variance of the readings, text
  bool include_between = true;
};
struct RaScatter {
  double sigma_um;
  double ra_um;
};
/// Standard deviation of Ra of a part: repetition plus (optional) difference between tools. COMPLETION.
[[nodiscard]] RaScatter ra_scatter(const ScatteredSurface& in);

struct LimitedSurface : TurnedSurface {
  double ra_limit_um = 0;
  bool include_between = true;
};
struct ExceedProbability {
  double probability;
};
/// Probability that Ra of a part is above the limit, normal scatter. COMPLETION.
[[nodiscard]] ExceedProbability ra_exceed_probability(const LimitedSurface& in);

struct RaReliability : FeedBounds {
  double ra_limit_um = 0;
  double gamma = 0.95;
  bool include_between = true;
};
/// Largest feed with P(Ra <= limit) >= gamma. COMPLETION.
[[nodiscard]] LargestFeed max_feed_for_ra_reliability(const RaReliability& in);

struct MeanReading {
  double variance_um2 = 0;
  std::int64_t readings = 1;
  double degrees_of_freedom = 1;
  double confidence = 0.95;
};
struct HalfWidth {
  double half_width_um;
};
/// Two-sided confidence half-width of a mean, t((1+confidence)/2; dof) sqrt(variance/n).
[[nodiscard]] HalfWidth ra_confidence_half_width(const MeanReading& in);

struct FinishPass : NoseGeometry {
  double ra_limit_um = 0;
  double gamma = 0.95;
  double cutting_speed_m_min = 0;
  double diameter_mm = 0;
  double length_mm = 0;
  double feed_max_mm_rev = 0.55;
};
struct FinishTime {
  double feed_mm_rev;
  double spindle_rpm;
  double main_time_min;  // 1e9 when infeasible
  FeedStatus status;
};
/// Main time of a finish pass at the feed of max_feed_for_ra_reliability. COMPLETION.
[[nodiscard]] FinishTime finish_pass_time(const FinishPass& in);

struct HandbookSurface {
  RoughnessClass roughness_class = RoughnessClass::ra_2_5;
  double nose_radius_mm = 2.0;
};
struct HandbookFeed {
  double feed_mm_rev;
};
/// Handbook finishing feed for a roughness class, linear in the nose radius, held outside 0.4..2.4 mm.
/// COMPLETION.
[[nodiscard]] HandbookFeed handbook_finish_feed(const HandbookSurface& in);

}  // namespace verstat::models::k411

template <>
struct verstat::models::EnumNames<verstat::models::k411::ProfileRegime> {
  static constexpr std::array names{std::pair{k411::ProfileRegime::nose_nose, "nose-nose"},
                                    std::pair{k411::ProfileRegime::nose_edge, "nose-edge"},
                                    std::pair{k411::ProfileRegime::edge_edge, "edge-edge"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k411::FactorPolicy> {
  static constexpr std::array names{std::pair{k411::FactorPolicy::hold_factor, "hold_factor"},
                                    std::pair{k411::FactorPolicy::printed, "printed"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k411::FeedStatus> {
  static constexpr std::array names{std::pair{k411::FeedStatus::infeasible, "infeasible"},
                                    std::pair{k411::FeedStatus::roughness_active, "roughness_active"},
                                    std::pair{k411::FeedStatus::at_feed_max, "at_feed_max"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k411::RoughnessClass> {
  static constexpr std::array names{
      std::pair{k411::RoughnessClass::ra_0_63, "Ra0.63"}, std::pair{k411::RoughnessClass::ra_1_25, "Ra1.25"},
      std::pair{k411::RoughnessClass::ra_2_5, "Ra2.5"},   std::pair{k411::RoughnessClass::rz_20, "Rz20"},
      std::pair{k411::RoughnessClass::rz_40, "Rz40"},     std::pair{k411::RoughnessClass::rz_80, "Rz80"}};
};
