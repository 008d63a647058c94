#pragma once
// Rational reliability level of an assembled carbide turning tool (K117): the life of an insert edge, the
// stationary availability of the two-edge insert, and the reliability level gamma (share of the edges that
// survive their scheduled period) at which a part costs least. The heart of the product.
//
// Andronov 2011. Where to start: LifeLaw (models/math/life_law.h) for the life, part_cost for the cost of a
// part under a replacement strategy, joint_speed_gamma_optimum for speed and gamma together,
// insert_cycle_availability for the availability. Money is in one currency throughout, called UAH.

#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"
#include "models/math/life_law.h"

namespace verstat::models::k117 {

/// "No scheduled change": ages from here on are infinite (nothing survives, M is the mean life), as input
/// and as output.
inline constexpr double no_schedule_min = 1e9;

// ------------------------------------------------------------------------------------------------- life

/// Mean life and scatter of an edge at a fixed regime. cv 0.05..2 (Weibull) or 0.05..0.45 (normal).
struct LifeMoments {
  double mean_min = 60;
  double cv = 0.7;
};
struct LifeLawIn : LifeMoments {
  LifeLawKind law = LifeLawKind::weibull;
};

struct WeibullParameters {
  double shape;
  double scale_min;
};
/// Weibull law with a given mean and coefficient of variation:
///   cv^2 = Gamma(1+2/b)/Gamma(1+1/b)^2 - 1,  eta = mean/Gamma(1+1/b).   K117 section B. COMPLETION.
[[nodiscard]] WeibullParameters weibull_from_moments(const LifeMoments& in);

struct LifeAtAge : LifeLawIn {
  double age_min = 0;
};
struct LifeReliability {
  double reliability;
  double density_per_min;
  double hazard_per_min;
};
/// Reliability, density (without the atom at zero of the normal law) and hazard at an age >= 0 min (> 0 for
/// Weibull cv > 1, whose hazard is infinite at 0). K117 section B. COMPLETION.
[[nodiscard]] LifeReliability life_reliability(const LifeAtAge& in);

struct GammaPercent : LifeLawIn {
  double gamma = 0;
};
struct GammaPercentLife {
  double life_min;
};
/// Age survived with probability gamma in (0, 1); 0 for the normal law from gamma = Phi(1/cv) on.
/// K117 section B. COMPLETION.
[[nodiscard]] GammaPercentLife gamma_percent_life(const GammaPercent& in);

struct PeriodAtGamma {
  LifeLawKind law = LifeLawKind::weibull;
  double period_min = 60;
  double gamma = 0;
  double cv = 0.7;
};
struct MeanLife {
  double mean_min;
};
/// Mean life at which the period T_e is survived with probability gamma: inverse of gamma_percent_life.
[[nodiscard]] MeanLife required_mean_life(const PeriodAtGamma& in);

struct ScheduledAge : LifeLawIn {
  double change_age_min = no_schedule_min;
};
struct RestrictedMean {
  double restricted_mean_min;
};
/// M(tau) = integral of R over 0..tau = E[min(life, tau)], tau >= 0 min. K117 eq. (1), repair 1.
[[nodiscard]] RestrictedMean restricted_mean_life(const ScheduledAge& in);

struct RestrictedMeanSeries {
  double change_age_min = 0;
  double scale_min = 0;
  double shape = 0;
  std::int64_t terms = 1;
};
/// The series of eq. (1) for M(tau) of a Weibull law, terms n = 0..terms-1. The alternating series loses all
/// digits for long ages: an error for (tau/scale)^shape > 15. restricted_mean_life has no such limit.
[[nodiscard]] RestrictedMean weibull_restricted_mean_series(const RestrictedMeanSeries& in);

struct PulseTreatment {
  double gamma = 0;
  double mean_min = 60;
  double cv_before = 0.7;
  double cv_after = 0.4;
  double mean_factor = 1;
};
struct PulseTreatmentEffect {
  double shape_before;
  double gamma_life_before_min;
  double gamma_life_after_min;
  double gamma_life_ratio;
};
/// Gamma-percent life before (Weibull) and after (normal, mean times factor >= 1) magnetic-pulse treatment.
/// K117 section F; laws and coefficients of variation from the paper.
[[nodiscard]] PulseTreatmentEffect pulse_treatment_effect(const PulseTreatment& in);

// ----------------------------------------------------------------------------------------- availability

/// Weibull lives of the two edges, their scheduled ages, and what a failure and a new insert leave usable.
struct TwoEdgeInsert {
  double scale1_min = 0;
  double shape1 = 0;
  double scale2_min = 0;
  double shape2 = 0;
  double change_age1_min = no_schedule_min;
  double change_age2_min = no_schedule_min;
  double p_reserve_ok = 1;   // a failure of edge 1 leaves edge 2 usable
  double p_single_edge = 0;  // the fitted insert has one usable edge only
};
struct InsertCycle : TwoEdgeInsert {
  double rate_index_per_min = 0.3;
  double rate_replace_per_min = 0.3;
  double failure_extra_min = 0;
};
struct InsertAvailability {
  double availability;
  double mean_up_min;    // per insert
  double mean_down_min;  // per insert
  double cycle_min;
  double pi1, pi2, pi3, pi4, pi5;
  double failures_per_insert;
  double changes_per_cutting_hour;
};
/// Stationary availability of a two-edge insert as a semi-Markov process (states 1 edge 1 with reserve, 2
/// edge 1 alone, 3 edge 2, 4 indexing, 5 insert change):  K_r = U/(U + W).   K117 eq. (1c): eq. (1) repaired
/// (1/t is a scheduled age, the denominator is the mean restoration time, the fraction was inverted).
[[nodiscard]] InsertAvailability insert_cycle_availability(const InsertCycle& in);

struct InsertCycleEdges {
  std::int64_t edges = 0;
  double scale_min = 0;
  double shape = 0;
  double edge_factor = 1;  // the scale of edge k = 0, 1, ... is scale * factor^k
  double change_age_min = no_schedule_min;
  double rate_index_per_min = 0.3;
  double rate_replace_per_min = 0.3;
  double p_reserve_ok = 1;
  double failure_extra_min = 0;
};
struct InsertAvailabilityEdges {
  double availability;
  double mean_up_min;
  double mean_down_min;
  double edges_used_per_insert;
  double failures_per_insert;
  double inserts_per_cutting_hour;
};
/// The same for an insert of 1..8 edges. K117 section A, "n edges". COMPLETION.
[[nodiscard]] InsertAvailabilityEdges insert_cycle_availability_edges(const InsertCycleEdges& in);

struct SemiMarkov {
  std::vector<std::vector<double>> transitions;  // rows sum to 1
  std::vector<double> mean_sojourn_min;
};
struct SemiMarkovSteadyState {
  std::vector<double> embedded;  // pi = pi P
  std::vector<double> time_fraction;
};
/// Stationary distribution of a semi-Markov process with one recurrent class (transient states and periods
/// are allowed): embedded chain by the Grassmann-Taksar-Heyman elimination, time fractions pi_i m_i / sum.
[[nodiscard]] SemiMarkovSteadyState semi_markov_steady_state(const SemiMarkov& in);

struct AvailabilityTarget : TwoEdgeInsert {
  double availability = 0;
};
struct RestorationRate {
  double rate_per_min;
};
/// Common restoration rate of indexing and insert change at which the availability reaches the target in
/// (0, 1): lambda = (n4 + n5)/[U (1/K - 1)].   Inverse of K117 eq. (1c).
[[nodiscard]] RestorationRate required_restoration_rate(const AvailabilityTarget& in);

struct SeriesParts {
  std::vector<double> parts;
};
struct SeriesReliability {
  double reliability;
};
/// Reliability of a tool whose parts (insert, clamp, holder) must all survive: the product.
[[nodiscard]] SeriesReliability series_reliability(const SeriesParts& in);

// ------------------------------------------------------------------------------------ regime and economy

struct FeedAndDepth {
  double feed_mm_rev = 1;
  double depth_mm = 10;
};
/// Extended Taylor law of the mean life: mean = T_ref (V_ref/V)^mu (S_ref/S)^(mu y) (t_ref/t)^(mu x).
struct TaylorLife {
  double mean_ref_min = 60;
  double speed_ref_m_min = 60;
  double feed_ref_mm_rev = 1;
  double depth_ref_mm = 10;
  double mu = 5;  // > 1
  double depth_exponent = 0.15;
  double feed_exponent = 0.45;
};
struct TurnedPart {
  double diameter_mm = 500;
  double length_mm = 1000;
  double passes = 1;
};
/// What a planned change and a failure cost.
struct Economics {
  double machine_rate_per_min = 3;
  double setter_rate_per_min = 0.5;
  double t_change_planned_min = 5;
  double t_change_failure_min = 15;
  double insert_price = 80;
  double periods_planned = 4;  // life periods obtained from one insert
  double periods_failure = 2;
  double regrind_planned = 0;
  double regrind_failure = 0;
  double damage_cost = 72;  // holder, shim, rework, scrapped part
};

struct TurningPass : TurnedPart {
  double speed_m_min = 0;
  double feed_mm_rev = 1;
};
struct MachiningTime {
  double time_min;
};
/// Machining time t0 = pi D L i/(1000 V S) of longitudinal turning.
[[nodiscard]] MachiningTime machining_time_turning(const TurningPass& in);

struct Regime : FeedAndDepth, TaylorLife {
  double speed_m_min = 0;
};
/// Mean life at a regime (extended Taylor law; COMPLETION: the paper shows the exponent 1/mu only).
[[nodiscard]] MeanLife mean_life_for_regime(const Regime& in);

struct LifeWanted : FeedAndDepth, TaylorLife {
  double mean_min = 0;
};
struct Speed {
  double speed_m_min;
};
/// Speed that gives a mean life: inverse of mean_life_for_regime.
[[nodiscard]] Speed speed_for_mean_life(const LifeWanted& in);

struct ChangeCosts {
  double planned;
  double failure;
};
/// Cost of a planned change Q1 = (E + a_set) t_c1 + A_u/K_1 + A_z1 and of a failure
/// Q2 = (E + a_set) t_c2 + C_d + A_u/K_2 + A_z2.   K117 section C, reconstructed from the printed derivative.
[[nodiscard]] ChangeCosts change_costs(const Economics& in);

struct PartCostBase {
  double machining_time_min = 0;
  double machine_rate_per_min = 3;
  double change_time_min = 0;
  double change_rate_per_min = 0;  // E_T, cost of a minute of the stop
  double parts_per_period = 0;     // z_T = T/t0
  double insert_price = 80;
  double periods = 0;  // K, life periods of a tool
  double regrind = 0;
};
struct PartCostBaseOut {
  double part_cost;
};
/// Variable part cost A = t0 E + t_c E_T/z_T + (A_u/K + A_z)/z_T.   K117 eq. (3), repaired: K is in the
/// legend but not in the printed formula.
[[nodiscard]] PartCostBaseOut part_cost_base(const PartCostBase& in);

// ------------------------------------------------------------------------------- cost at a fixed period

enum class Accounting {
  scheduled,  ///< the paper: the period is charged in full even when the edge fails earlier
  renewal     ///< exact long-run average: the period is charged as M, the time the edge really works
};

struct PeriodEconomy : Economics, TaylorLife, TurnedPart, FeedAndDepth {
  double period_min = 60;
  Accounting accounting = Accounting::scheduled;
  double life_offset_min = 0;  // a in eta(V) = a + C_T V^-mu
  double cv = 0.7;
};
struct PeriodEconomyAtGamma : PeriodEconomy {
  double gamma = 0;
};
struct PartCostAtGamma {
  double part_cost;
  double speed_m_min;
  double machining_time_min;
  double mean_life_min;
  std::optional<double> slope;      // dA/dgamma, scheduled accounting only
  std::optional<double> curvature;  // d2A/dgamma2
};
/// Part cost when the speed is chosen so that a Weibull edge survives the period T_e with probability gamma
/// (0.40..0.99 scheduled, 0.01..0.99 renewal).   K117 eq. (4)-(7): (4), (5) reconstructed from the printed
/// derivative, (6) its derivative, (7) COMPLETION.
[[nodiscard]] PartCostAtGamma part_cost_at_gamma(const PeriodEconomyAtGamma& in);

struct GammaSearch : PeriodEconomy {
  double knee_tolerance = 0.02;
  double gamma_min = 0.40;  // scheduled accounting: not below 0.40, where the cost falls to zero with gamma
  double gamma_max = 0.99;
};
struct RationalGamma {
  double gamma;
  double gamma_knee;
  double part_cost;
};
/// The gamma of least part cost in [gamma_min, gamma_max], and the largest gamma that costs at most
/// (1 + knee_tolerance) times as much.   Minimum of K117 eq. (4) or (7).
[[nodiscard]] RationalGamma rational_gamma_cost(const GammaSearch& in);

struct PenaltyCalibration {
  double gamma = 0;
  double shape = 0;
  double mu = 5;
  double period_min = 60;
  double machine_rate_per_min = 3;
  double planned_cost = 37.5;
};
struct FailurePenalty {
  double failure_cost;
};
/// Failure cost Q2 at which gamma > exp(1/(b mu) - 1) is the local minimum of eq. (4) with a = 0.
[[nodiscard]] FailurePenalty failure_penalty_for_gamma(const PenaltyCalibration& in);

// ---------------------------------------------------------------------------- expenditure, consumption

struct Expenditure {
  double period_price = 20;  // A_u/K_1 at the base reliability
  double price_exponent = 1;
  double cv = 0.7;
  double failure_cost = 164.5;
  double period_min = 60;
  double mean_ref_min = 60;
};
struct ExpenditureAtGamma : Expenditure {
  double gamma = 0;
};
struct ExpenditureParts {
  double manufacture;
  double operation;
  double total;
};
/// Manufacturing and operating expenditure of a tool of reliability gamma per period.
///   A_v = A_v0 (ln gamma_0/ln gamma)^(k/b), A_e = C_f (1 - gamma).   K117 eq. (8), COMPLETION of Fig. 2.
[[nodiscard]] ExpenditureParts reliability_expenditure(const ExpenditureAtGamma& in);

struct ExpenditureOptimum {
  double gamma;
  double total;
};
/// The gamma of least total expenditure in 0.20..0.99.
[[nodiscard]] ExpenditureOptimum rational_gamma_expenditure(const Expenditure& in);

struct Consumption : LifeLawIn {
  std::int64_t edges = 0;
  double p_reserve_ok = 1;
};
struct ConsumptionAtGamma : Consumption {
  double gamma = 0;
};
struct InsertConsumption {
  double edges_used_per_insert;
  double inserts_per_cutting_hour;
};
/// Inserts per cutting hour when edges are changed at T_gamma: N = 60/(K_eff M(T_gamma)).   K117 eq. (9).
[[nodiscard]] InsertConsumption insert_consumption(const ConsumptionAtGamma& in);

struct ConsumptionSearch : Consumption {
  double gamma_min = 0.05;
  double gamma_max = 0.99;
};
struct ConsumptionOptimum {
  double gamma;
  double inserts_per_cutting_hour;
};
/// The gamma of least insert consumption.
[[nodiscard]] ConsumptionOptimum rational_gamma_consumption(const ConsumptionSearch& in);

// --------------------------------------------------------------------------------- strategies and optima

enum class Strategy {
  age,             ///< change at T_gamma of cutting, or at failure
  run_to_failure,  ///< no planned change
  part_count,      ///< change after the whole parts that fit into T_gamma, or at failure
  block            ///< all edges every T_gamma of cutting, failures replaced in between
};

struct PartCostIn : Economics, TaylorLife, TurnedPart, FeedAndDepth {
  Strategy strategy = Strategy::age;
  std::optional<double> gamma;  // not used by run_to_failure
  double speed_m_min = 0;
  Accounting accounting = Accounting::renewal;  // acts on age and part_count only
  LifeLawKind law = LifeLawKind::weibull;
  double cv = 0.7;
};
struct PartCost {
  double part_cost;
  double machining_time_min;
  double mean_life_min;
  double change_age_min;  // 0 = none
  double life_used_min;   // cutting time that one change pays for
  double parts_per_period;
  double failure_probability;
  double machining_cost;
  double edge_cost;
  double time_per_part_min;
};
/// Cost of a part at a regime under a replacement strategy: A = t0 (E + q), q the cost rate of the edges.
/// K117 section E. COMPLETION (renewal reward, Barlow-Proschan). `block` costs a renewal function (ms).
[[nodiscard]] PartCost part_cost(const PartCostIn& in);

struct OutcomeCosts {
  double planned_cost = 37.5;
  double failure_cost = 164.5;
};
struct AgeReplacement : LifeLawIn, OutcomeCosts {
  double change_age_min = no_schedule_min;
};
struct AgeReplacementCost {
  double cost_rate_per_min;
  double reliability;
  double restricted_mean_min;
};
/// Long-run cost per cutting minute of age replacement: [R Q1 + (1-R) Q2]/M at tau > 0. COMPLETION.
[[nodiscard]] AgeReplacementCost age_replacement_cost_rate(const AgeReplacement& in);

struct OptimalAgeIn : LifeLawIn, OutcomeCosts {};
struct OptimalAge {
  double change_age_min;  // no_schedule_min = run to failure
  double gamma;           // R(change age); 0 = run to failure
  double cost_rate_per_min;
  double run_to_failure_cost_rate_per_min;
};
/// Change age of least cost rate among 0.01..6 mean lives and run to failure, which wins ties. Root of
/// h(tau) M(tau) + R(tau) = Q2/(Q2 - Q1), the only stationary point for a rising hazard. COMPLETION.
[[nodiscard]] OptimalAge optimal_age_replacement(const OptimalAgeIn& in);

struct BlockReplacement : LifeLawIn, OutcomeCosts {
  double interval_min = 0;
};
struct BlockReplacementCost {
  double cost_rate_per_min;
  double expected_failures;
};
/// Long-run cost per cutting minute of block replacement: [Q1 + Q2 H(T)]/T, 0 < T <= 50 means. COMPLETION.
[[nodiscard]] BlockReplacementCost block_replacement_cost_rate(const BlockReplacement& in);

struct JointOptimumIn : Economics, TaylorLife, TurnedPart, FeedAndDepth {
  LifeLawKind law = LifeLawKind::weibull;
  double cv = 0.7;
};
struct JointOptimum {
  double gamma;
  double speed_m_min;
  double mean_life_min;
  double change_age_min;  // no_schedule_min = run to failure
  double part_cost;
};
/// Speed and gamma of least part cost under age replacement:  T* = (mu-1) q*/E, A* = t0* E mu/(mu-1), with
/// gamma*, q* from optimal_age_replacement at unit mean.   K117 eq. (10). COMPLETION.
[[nodiscard]] JointOptimum joint_speed_gamma_optimum(const JointOptimumIn& in);

}  // namespace verstat::models::k117

template <>
struct verstat::models::EnumNames<verstat::models::k117::Accounting> {
  static constexpr std::array names{std::pair{k117::Accounting::scheduled, "scheduled"},
                                    std::pair{k117::Accounting::renewal, "renewal"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k117::Strategy> {
  static constexpr std::array names{
      std::pair{k117::Strategy::age, "age"}, std::pair{k117::Strategy::run_to_failure, "run_to_failure"},
      std::pair{k117::Strategy::part_count, "part_count"}, std::pair{k117::Strategy::block, "block"}};
};
