#pragma once
// When to pull a face mill whose teeth fail one by one (K109): the paper's redundancy formula and replacement
// number, and the exact reliabilities it approximates, with the load of failed teeth taken over by the
// survivors.
//
// Klimenko, Denisova 2011. All reliabilities refer to one and the same mission (part, batch, shift).
// Where to start: required_failed_allowed and control_limit for the planner, failure_times for the event
// simulation, policy_cost for the optimizer. mill_reliability_paper is there to compare with shop practice.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k109 {

// ------------------------------------------------------------------------------------ the paper's formulas

struct MillPaper {
  double r_tooth = 0;
  std::int64_t teeth = 1;
  std::int64_t m = 0;
};
struct MillReliability {
  double r_mill;
};
/// Whole-system redundancy of multiplicity m,  R = 1 - (1 - R_z^z)^(m+1).   K109 eq. (0), as printed.
/// A lower bound of the load-sharing reliability with m tolerated failures for alpha <= 2.
[[nodiscard]] MillReliability mill_reliability_paper(const MillPaper& in);

struct MillTarget {
  double r_mill = 0;
  double r_tooth = 0;
  std::int64_t teeth = 1;
};
struct RequiredM {
  double m_real;
  std::int64_t m;
  std::int64_t replace_at_failed;
  bool feasible;
};
/// Teeth that must still work when the mill is pulled, m = ln(1-R)/ln(1-R_z^z) - 1 rounded up.  K109 eq. (1).
/// Rounding up, the clamp of replace_at_failed to 1..z and `feasible` are COMPLETION. m stops at 1e9.
[[nodiscard]] RequiredM required_m_paper(const MillTarget& in);

struct MillTargetPaper {
  double r_mill = 0;
  std::int64_t teeth = 1;
  std::int64_t m = 0;
};
struct ToothReliability {
  double r_tooth;
};
/// Tooth reliability that gives the mill reliability: inverse of eq. (0).
[[nodiscard]] ToothReliability required_tooth_reliability_paper(const MillTargetPaper& in);

struct Property {
  double value = 0;
  double reference = 0;
  bool higher_is_better = true;
};
struct Score {
  double score;
};
/// Ratio of a design's property to the reference design, inverted when smaller is better (COMPLETION).
[[nodiscard]] Score property_score(const Property& in);

struct Scores {
  std::vector<double> scores;
  std::vector<double> weights;
};
struct Quality {
  double quality;
};
/// Weighted arithmetic mean of the scores of one level of the quality tree.   K109 (C10), COMPLETION.
[[nodiscard]] Quality quality_level(const Scores& in);

// ------------------------------------------------------------------------- exact reliability of a mission

struct MillBinomial {
  double r_tooth = 0;
  std::int64_t teeth = 1;
  std::int64_t failed_allowed = 0;
};
/// Independent teeth: at most `failed_allowed` of them fail.   K109 (C1).
[[nodiscard]] MillReliability mill_reliability_binomial(const MillBinomial& in);

struct Load {
  std::int64_t teeth = 1;
  std::int64_t failed = 0;
  double alpha = 2;  // load-sharing exponent: y/m of the Taylor law with kept table feed, 0 with reduced feed
};
struct LoadFactor {
  double factor;
};
/// Hazard (or wear rate) multiplier of each survivor, (z/(z-j))^alpha.   K109 (C2).
[[nodiscard]] LoadFactor load_factor(const Load& in);

struct MillMission {
  double r_tooth = 0;
  std::int64_t teeth = 1;
  double alpha = 2;
};
struct FailedTeethPmf {
  std::vector<double> pmf;
};
/// Probabilities of 0..z failed teeth at the end of a mission begun with a fresh mill.   K109 (C3).
[[nodiscard]] FailedTeethPmf failed_teeth_pmf(const MillMission& in);

struct MillSharing : MillMission {
  std::int64_t failed_allowed = 0;
};
/// Load shared equally by the survivors; at most `failed_allowed` failures.   K109 (C3).
[[nodiscard]] MillReliability mill_reliability_load_sharing(const MillSharing& in);
/// Only the tooth behind a gap takes the extra chip: factor g^alpha for a gap of g pitches. z <= 16. (C4).
[[nodiscard]] MillReliability mill_reliability_local_sharing(const MillSharing& in);

struct MissionFromState : MillSharing {
  std::int64_t failed_now = 0;
};
/// Probability that a mission begun with failed_now failed teeth ends with at most failed_allowed.   (C3).
[[nodiscard]] MillReliability mission_reliability_from_state(const MissionFromState& in);

struct MissionTarget : MillMission {
  double r_mill_target = 0;
};
struct RequiredFailedAllowed {
  std::int64_t failed_allowed;
  std::int64_t replace_at_failed;
  double r_mill_achieved;
  bool feasible;
};
/// Smallest number of failures that must be tolerated for a fresh mill to meet the target.
[[nodiscard]] RequiredFailedAllowed required_failed_allowed(const MissionTarget& in);

struct ControlTarget : MissionTarget {
  std::int64_t failed_allowed = 0;
};
struct ControlLimit {
  std::int64_t replace_at_failed;
  std::int64_t working_at_replacement;
  double r_last_admissible;
  bool feasible;
};
/// Smallest number of failed teeth with which the next mission may not be started any more (at least 1).
[[nodiscard]] ControlLimit control_limit(const ControlTarget& in);

struct SharingTarget {
  double r_mill = 0;
  std::int64_t teeth = 1;
  std::int64_t failed_allowed = 0;
  double alpha = 2;
};
/// Tooth reliability that gives the mill reliability under equal sharing: inverse of (C3).
[[nodiscard]] ToothReliability required_tooth_reliability(const SharingTarget& in);

// ------------------------------------------------------------------------------------------- time domain

/// Weibull life of a tooth at nominal load.
struct ToothLife {
  double t_mean_min = 0;
  double beta = 2;
};
struct ToothAtTime : ToothLife {
  double t_min = 0;
};
/// R_z(t) = exp(-(t/eta)^beta), eta = t_mean/Gamma(1 + 1/beta).   K109 (C5).
[[nodiscard]] ToothReliability tooth_reliability(const ToothAtTime& in);

struct ToothMission : ToothLife {
  double r_tooth = 0;
};
struct Time {
  double t_min;
};
/// Mission that a tooth survives with probability r_tooth. Inverse of (C5).
[[nodiscard]] Time mission_time(const ToothMission& in);

enum class SharingRule {
  equal,  ///< all survivors take the load of the failed teeth in equal parts
  local   ///< the tooth behind a gap takes it
};
struct ToothLives {
  std::vector<double> lives_min;  // at nominal load, in the order of the teeth round the mill
  double alpha = 2;
  SharingRule rule = SharingRule::local;
};
struct FailureTimes {
  std::vector<double> times_min;
  std::vector<std::int64_t> order;
};
/// Times and order of the tooth failures when every tooth wears at the rate of its load and fails at its own
/// exposure; ties go to the lowest index.   K109 (C6).
[[nodiscard]] FailureTimes failure_times(const ToothLives& in);

struct NthFailure : ToothLife {
  std::int64_t n = 1;
  std::int64_t teeth = 1;
  double alpha = 2;
};
struct MeanTime {
  double t_mean_min;
};
/// Mean time to the n-th failure, equal sharing, exposure model.   K109 (C7) as the integral
///   E[T_n] = integral of sum_{j<n} C(z,j) F^j S^(z-j) / phi_j,  accurate also where (C7) alternates.
[[nodiscard]] MeanTime mean_time_to_nth_failure(const NthFailure& in);

struct Exposure : ToothLife {
  double t_min = 0;
  std::int64_t teeth = 1;
  std::int64_t failed_allowed = 0;
  double alpha = 2;
};
/// Reliability at time t under the exposure model with equal sharing.   K109 (C8): quadrature for at most two
/// tolerated failures, otherwise 2^20 draws of a fixed seed (standard error below 5e-4, takes about 0.2 s).
[[nodiscard]] MillReliability mill_reliability_exposure(const Exposure& in);

struct Policy : ToothLife {
  std::int64_t teeth = 1;
  std::int64_t failed_allowed = 0;
  double t_planned_min = 0;
  double alpha = 2;
  double edge_cost = 0;       // per edge
  double planned_cost = 0;    // per change
  double unplanned_cost = 0;  // per change
  double machine_rate_per_min = 0;
  double change_planned_min = 0;
  double change_unplanned_min = 0;
};
struct PolicyCost {
  double mean_cycle_cutting_min;
  double p_unplanned;
  double cost_per_cutting_min;
  double availability;
};
/// Long-run cost of replacing all edges at failure failed_allowed + 1 or at age t_planned.   K109 (C9).
[[nodiscard]] PolicyCost policy_cost(const Policy& in);

// -------------------------------------------------------------------------------------------- kinematics

struct SpindleIn {
  double cutting_speed_m_min = 0;
  double diameter_mm = 0;
};
struct SpindleSpeed {
  double speed_rpm;
};
/// n = 1000 v_c/(pi d)
[[nodiscard]] SpindleSpeed spindle_speed(const SpindleIn& in);

struct TableFeedIn {
  double feed_per_tooth_mm = 0;
  std::int64_t teeth = 1;
  double speed_rpm = 0;
};
struct TableFeed {
  double feed_mm_min;
};
/// v_f = f_z z n
[[nodiscard]] TableFeed table_feed(const TableFeedIn& in);

struct Removal {
  double width_mm = 0;
  double depth_mm = 0;
  double feed_mm_min = 0;
};
struct RemovalRate {
  double rate_cm3_min;
};
/// q = width depth v_f/1000
[[nodiscard]] RemovalRate material_removal_rate(const Removal& in);

}  // namespace verstat::models::k109

template <>
struct verstat::models::EnumNames<verstat::models::k109::SharingRule> {
  static constexpr std::array names{std::pair{k109::SharingRule::equal, "equal"},
                                    std::pair{k109::SharingRule::local, "local"}};
};
