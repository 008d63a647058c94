#pragma once
// Certification of carbide cutters by accelerated tests (K119): what a shot test of the edge predicts about
// life and breakage, and what sorting inserts by a correlated test is worth.
//
// Kazakova 2011. Where to start: life_model_from_chipping_test hands a lot over to the simulation,
// screened_life and screen_by_correlated_test say what sorting does to it, inspection_decision what it saves.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k119 {

// ------------------------------------------------------------------------------------ published relations

struct ChippingTest {
  double chip_resistance_s = 0;
};
struct ChippingPrediction {
  double breaking_feed_mm_rev;
  double mean_life_s;
  double mean_life_min;
  double breakage_fraction_raw;
  double breakage_fraction;
};
/// Breaking feed, mean life and breakages from the chipping resistance T_c > 0 s (fitted for 55..190):
///   S_p = 0.26 T_c^0.46, T_3 = 2.28 T_c^1.35 s, q = 56.3 T_c^-0.98.   K119 eqs. (1)-(3); q clamped to 0..1.
[[nodiscard]] ChippingPrediction chipping_test_predict(const ChippingTest& in);

struct BreakingFeed {
  double breaking_feed_mm_rev = 0;
};
struct BreakingFeedPrediction {
  double chip_resistance_s;
  double mean_life_min;
  double breakage_fraction;
};
/// Life and breakages from a stepped-feed test: eq. (1) read backwards, then (2), (3). COMPLETION.
[[nodiscard]] BreakingFeedPrediction breaking_feed_predict(const BreakingFeed& in);

struct LotTargets {
  double min_mean_life_min = 0;
  double max_breakage_fraction = 0;
};
struct RequiredChipResistance {
  double by_life_s;
  double by_breakage_s;
  double chip_resistance_s;
};
/// Chipping resistance at which a lot meets both targets: eqs. (2), (3) inverted, the larger. COMPLETION.
[[nodiscard]] RequiredChipResistance required_chip_resistance(const LotTargets& in);

enum class UltrasonicIndicator { shift, contact };
struct UltrasonicTest {
  UltrasonicIndicator indicator = UltrasonicIndicator::shift;
  double cycles_millions = 0;
};
struct FailureCycles {
  double cycles_millions;
};
/// Cycles to destruction on the ultrasonic stand from the cycles to an indicator:
///   N_p = 0.91 N_c^0.84 (shift of the parts), N_p = 2.65 N_k^0.55 (contact damage).   K119 eqs. (4), (5).
/// Beyond N_p = N_c or N_k an error: the indicator would come after the destruction.
[[nodiscard]] FailureCycles ultrasonic_failure_cycles(const UltrasonicTest& in);

struct InsertThickness {
  double thickness_mm = 0;
};
struct InsertStrength {
  double breaking_feed_mm_rev;
  double breaking_force_n;
  double power_kw;
};
/// Load that breaks an insert of a thickness of 3.18..7.94 mm: Table 2, linear between its rows (COMPLETION).
[[nodiscard]] InsertStrength insert_strength_by_thickness(const InsertThickness& in);

struct SteppedFeedSetup {
  double holder_height_mm = 0;
  double thickness_mm = 0;
  double machine_power_kw = 0;
  double machine_max_feed_mm_rev = 0;
};
struct SteppedFeedApplicability {
  bool size_ok;
  bool feed_ok;
  bool power_ok;
  bool applicable;
};
/// Whether a lathe can run the stepped-feed test: holder <= 32 mm, insert <= 6.35 mm, and feed and power of
/// Table 2 within the machine's (COMPLETION).
[[nodiscard]] SteppedFeedApplicability stepped_feed_applicable(const SteppedFeedSetup& in);

struct TestScores {
  double universality = 0;
  double tool_cost = 0;
  double result_quality = 0;
};
struct TestScore {
  double score;
};
/// Total score of a strength-test method: the sum, the weights are inside the scores.   K119 Table 1.
[[nodiscard]] TestScore strength_test_score(const TestScores& in);

enum class Treatment { standard, tin, bo, bo_tin };
struct TreatmentIn {
  Treatment variant = Treatment::standard;
};
struct TreatmentVariant {
  double chip_resistance_s;
  double breaking_feed_mm_rev;
  double mean_life_min;
  double breakage_fraction;
  double r_feed_chip;
  double r_life_chip;
  double r_breakage_chip;
  double life_ratio;
  double breakage_ratio;
};
/// Test and service results of T5K10 inserts by edge treatment.   K119 Tables 3 and 4.
[[nodiscard]] TreatmentVariant treatment_variant(const TreatmentIn& in);

// -------------------------------------------------------------------------------- cost and life of a test

struct SteppedFeed {
  double start_feed_mm_rev = 0.76;
  double feed_step_mm_rev = 0.1;
  double breaking_feed_mm_rev = 0;
  double step_time_s = 5;
  double cutting_speed_m_min = 21.6;
};
struct SteppedFeedTest {
  std::int64_t steps;
  double duration_s;
  double cut_length_m;
};
/// Steps, time and length of cut until the edge breaks in a stepped-feed test. COMPLETION.
[[nodiscard]] SteppedFeedTest stepped_feed_test(const SteppedFeed& in);

struct LifeMoments {
  double mean_life_min = 0;
  double life_cv = 0;
};
struct WeibullLife {
  double shape;
  double scale_min;
};
/// Weibull law with a mean life and a coefficient of variation of 0.05..3. COMPLETION.
[[nodiscard]] WeibullLife weibull_from_mean_cv(const LifeMoments& in);

struct ChippingLife : ChippingTest {
  double life_cv = 0.5;
};
struct LifeModel {
  double mean_life_min;
  double breakage_fraction;
  double shape;
  double scale_min;
};
/// Life of a lot for the simulation: Weibull with the mean of eq. (2); it ends by breakage with probability
/// breakage_fraction, else by wear. COMPLETION.
[[nodiscard]] LifeModel life_model_from_chipping_test(const ChippingLife& in);

// ----------------------------------------------------------------------------------------------- screening

struct Screen {
  double rho = 0;
  double bad_fraction = 0;
  double reject_fraction = 0;
};
struct Screening {
  double sensitivity;
  double specificity;
  double bad_fraction_accepted;
  double bad_fraction_rejected;
  double false_reject_fraction;
};
/// Sorting by a test whose score correlates with the property (0 <= rho <= 0.995, Gaussian copula); the
/// lowest reject_fraction of the scores is rejected. COMPLETION (Taylor-Russell selection).
[[nodiscard]] Screening screen_by_correlated_test(const Screen& in);

struct ScreenTarget {
  double rho = 0;
  double bad_fraction = 0;
  double target_bad_fraction = 0;
};
struct RejectFraction {
  double reject_fraction;
  bool feasible;
};
/// Share to reject so that the accepted hold target_bad_fraction of bad ones: 0 when nothing needs rejecting,
/// 1 and not feasible when rejecting 0.999 is not enough. COMPLETION.
[[nodiscard]] RejectFraction reject_fraction_for_target(const ScreenTarget& in);

struct ScreenedLifeIn {
  double shape = 0;
  double scale_min = 0;
  double rho = 0;
  double reject_fraction = 0;
};
struct ScreenedAtTime : ScreenedLifeIn {
  double time_min = 0;
};
struct ScreenedSurvival {
  double all;
  double accepted;
};
/// Survival of all and of the accepted inserts at a time >= 0 min. COMPLETION.
[[nodiscard]] ScreenedSurvival screened_survival(const ScreenedAtTime& in);

struct ScreenedLife {
  double mean_all_min;
  double mean_accepted_min;
  double cv_accepted;
  double mean_rejected_min;
  double equivalent_shape;
  double equivalent_scale_min;
  double b10_accepted_min;
};
/// Life of the accepted inserts; the equivalent Weibull law has their mean and cv. COMPLETION.
[[nodiscard]] ScreenedLife screened_life(const ScreenedLifeIn& in);

struct LotPlan {
  double tc_lot_s = 0;
  double ln_sd_within = 0;
  std::int64_t sample_size = 1;
  double tc_critical_s = 0;
};
struct LotAcceptance {
  double p_accept;
};
/// Probability of accepting a lot by the geometric mean of T_c of a sample. COMPLETION.
[[nodiscard]] LotAcceptance lot_acceptance(const LotPlan& in);

struct LotScatter {
  double ln_sd_between = 0;
  double ln_sd_within = 0;
  std::int64_t sample_size = 1;
};
struct LotCorrelation {
  double rho_lot;
};
/// Correlation of the sample mean with the lot mean of ln T_c. COMPLETION.
[[nodiscard]] LotCorrelation lot_mean_correlation(const LotScatter& in);

/// Inspection of inserts before use; costs in one currency.
struct InspectionPlan {
  double insert_cost = 0;
  std::int64_t edges_per_insert = 1;
  std::int64_t edges_used_by_test = 0;
  double test_cost = 0;      // per insert
  double salvage_value = 0;  // per rejected insert
  double change_cost = 0;    // per edge change
  double breakage_cost = 0;  // extra cost of a breakage
  double shape = 0;
  double scale_min = 0;
  double breakage_fraction = 0;
  double rho_life = 0;
  double rho_break = 0;
};
struct InspectionIn : InspectionPlan {
  double reject_fraction = 0;
};
struct InspectionDecision {
  double cost_rate_without;
  double cost_rate_with;
  double saving_fraction;
  bool inspect;
  double mean_life_accepted_min;
  double breakage_fraction_accepted;
  double breakages_per_hour_without;
  double breakages_per_hour_with;
};
/// Cost per minute of cutting with and without sorting the inserts. COMPLETION (renewal reward).
[[nodiscard]] InspectionDecision inspection_decision(const InspectionIn& in);

struct OptimalReject {
  double reject_fraction;
  double cost_rate;
};
/// Reject fraction of least cost on 0.01, 0.02 .. 0.90, or 0 when doing without is as cheap. COMPLETION.
[[nodiscard]] OptimalReject optimal_reject_fraction(const InspectionPlan& in);

}  // namespace verstat::models::k119

template <>
struct verstat::models::EnumNames<verstat::models::k119::UltrasonicIndicator> {
  static constexpr std::array names{std::pair{k119::UltrasonicIndicator::shift, "shift"},
                                    std::pair{k119::UltrasonicIndicator::contact, "contact"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k119::Treatment> {
  static constexpr std::array names{
      std::pair{k119::Treatment::standard, "standard"}, std::pair{k119::Treatment::tin, "tin"},
      std::pair{k119::Treatment::bo, "bo"}, std::pair{k119::Treatment::bo_tin, "bo_tin"}};
};
