// Description of K119; its formulas stand in k119_certification.cpp.
#include "models/inspection/k119_cutter_certification.h"

namespace verstat::models::k119 {
namespace {

const Range valid_rho = closed(0, 0.995);
const Range valid_fraction = closed(0.001, 0.999);
const Range valid_shape = closed(0.3, 30);

template <class In>
auto chip_resistance() {
  return [](auto& f) {
    f.input(&In::chip_resistance_s, "chip_resistance_s", "T_c", "s", positive(),
            "time until chips cover half of the edge in the shot test (fitted for 55..190)", 90.0);
  };
}
template <class In>
auto rho(double example = 0.7) {
  return [example](auto& f) {
    f.input(&In::rho, "rho", "rho", "1", valid_rho,
            "correlation of the test with the property, magnitude, low score = bad", example);
  };
}
template <class In>
auto reject() {
  return [](auto& f) {
    f.input(&In::reject_fraction, "reject_fraction", "p", "1", valid_fraction,
            "share rejected, the lowest test scores", 0.3);
  };
}
template <class In>
auto bad() {
  return [](auto& f) {
    f.input(&In::bad_fraction, "bad_fraction", "d", "1", valid_fraction, "share of bad ones", 0.31);
  };
}
template <class In>
auto weibull_in() {
  return [](auto& f) {
    f.input(&In::shape, "weibull_shape", "k", "1", valid_shape, "Weibull shape of life", 2.101349)
        .input(&In::scale_min, "weibull_scale_min", "s", "min", positive(), "Weibull scale of life",
               56.264992);
  };
}
template <class Out>
auto weibull_out() {
  return [](auto& f) {
    f.output(&Out::shape, "weibull_shape", "k", "1", positive(), "Weibull shape of life")
        .output(&Out::scale_min, "weibull_scale_min", "s", "min", positive(), "Weibull scale of life");
  };
}
const auto plan = [](auto& f) {
  f.input(&InspectionPlan::insert_cost, "insert_cost", "C_ins", "money", non_negative(), "price of an insert",
          9.0)
      .input(&InspectionPlan::edges_per_insert, "edges_per_insert", "n_e", "1", at_least(1),
             "edges of an insert", 6)
      .input(&InspectionPlan::edges_used_by_test, "edges_used_by_test", "n_test", "1", at_least(0),
             "edges spent on the test, below edges_per_insert", 0)
      .input(&InspectionPlan::test_cost, "test_cost", "C_test", "money", non_negative(),
             "cost of testing an insert", 0.5)
      .input(&InspectionPlan::salvage_value, "salvage_value", "C_salv", "money", non_negative(),
             "value of a rejected insert, not above insert_cost", 2.0)
      .input(&InspectionPlan::change_cost, "change_cost", "C_ch", "money", non_negative(),
             "cost of an edge change", 3.0)
      .input(&InspectionPlan::breakage_cost, "breakage_cost", "C_br", "money", non_negative(),
             "extra cost of a breakage", 40.0)
      .with(weibull_in<InspectionPlan>())
      .input(&InspectionPlan::breakage_fraction, "breakage_fraction", "q", "1", probability(),
             "share of the edges that break", 0.31)
      .input(&InspectionPlan::rho_life, "rho_life", "rho", "1", valid_rho,
             "correlation of the test with life, magnitude", 0.7)
      .input(&InspectionPlan::rho_break, "rho_break", "rho", "1", valid_rho,
             "correlation of the test with breakage, magnitude", 0.69);
};
const auto copula_note =
    "Test score and property as a bivariate normal pair (Gaussian copula). The paper's correlations are per "
    "insert or small group; for whole lots take rho from lot_mean_correlation.";
const auto fit_note =
    "Fitted to T5K10 in roughing; low for every batch, by 43 % for the coated and rounded edge: use "
    "treatment_variant there. Outside, use ratios.";

void describe_published(Source& source) {
  source
      .function<&chipping_test_predict>("chipping_test_predict",
                                        "Breaking feed, mean life and breakages from the shot test.",
                                        "eqs. (1)-(3)", Provenance::paper)
      .with(chip_resistance<ChippingTest>())
      .output(&ChippingPrediction::breaking_feed_mm_rev, "breaking_feed_mm_rev", "S_p", "mm/rev", positive(),
              "feed that breaks the edge")
      .output(&ChippingPrediction::mean_life_s, "mean_life_s", "T_3", "s", positive(), "mean life")
      .output(&ChippingPrediction::mean_life_min, "mean_life_min", "T_3", "min", positive(), "mean life")
      .output(&ChippingPrediction::breakage_fraction_raw, "breakage_fraction_raw", "q", "1", positive(),
              "share of breakages by eq. (3), above 1 for T_c < 61.1 s")
      .output(&ChippingPrediction::breakage_fraction, "breakage_fraction", "q", "1", probability(),
              "the same clamped to 0..1 (COMPLETION)")
      .note(fit_note);
  source
      .function<&breaking_feed_predict>("breaking_feed_predict",
                                        "Life and breakages from a stepped-feed test.",
                                        "eq. (1) inverted, (2), (3)", Provenance::completion)
      .input(&BreakingFeed::breaking_feed_mm_rev, "breaking_feed_mm_rev", "S_p", "mm/rev", positive(),
             "feed that broke the edge", 1.9)
      .output(&BreakingFeedPrediction::chip_resistance_s, "chip_resistance_s", "T_c", "s", positive(),
              "chipping resistance")
      .output(&BreakingFeedPrediction::mean_life_min, "mean_life_min", "T_3", "min", positive(), "mean life")
      .output(&BreakingFeedPrediction::breakage_fraction, "breakage_fraction", "q", "1", probability(),
              "share of breakages")
      .note("A regression read backwards.");
  source
      .function<&required_chip_resistance>("required_chip_resistance",
                                           "Chipping resistance at which a lot meets its targets.",
                                           "eqs. (2), (3) inverted", Provenance::completion)
      .input(&LotTargets::min_mean_life_min, "min_mean_life_min", "T_3", "min", positive(),
             "least mean life wanted", 30.0)
      .input(&LotTargets::max_breakage_fraction, "max_breakage_fraction", "q", "1", open_low(0, 1),
             "largest share of breakages", 0.5)
      .output(&RequiredChipResistance::by_life_s, "by_life_s", "T_c", "s", positive(), "asked for by life")
      .output(&RequiredChipResistance::by_breakage_s, "by_breakage_s", "T_c", "s", positive(),
              "asked for by breakages")
      .output(&RequiredChipResistance::chip_resistance_s, "chip_resistance_s", "T_c", "s", positive(),
              "the larger");
  source
      .function<&ultrasonic_failure_cycles>("ultrasonic_failure_cycles",
                                            "Cycles to destruction on the ultrasonic stand.", "eqs. (4), (5)",
                                            Provenance::paper)
      .input(&UltrasonicTest::indicator, "indicator", "-", "-", no_range(),
             "what was seen: shift of the parts (eq. 4) or contact damage (eq. 5)", "shift")
      .input(&UltrasonicTest::cycles_millions, "cycles", "N_c, N_k", "1e6", positive(),
             "cycles to the indicator, at most 0.5546 (shift) or 8.7206 (contact)", 0.2)
      .output(&FailureCycles::cycles_millions, "failure_cycles", "N_p", "1e6", positive(),
              "cycles to destruction")
      .note("The unit is not printed; millions of cycles is the completion. Do not compare across units.");
  source
      .function<&insert_strength_by_thickness>("insert_strength_by_thickness",
                                               "Load that breaks an insert of a thickness.", "Table 2",
                                               Provenance::paper)
      .input(&InsertThickness::thickness_mm, "thickness_mm", "h", "mm", closed(3.18, 7.94),
             "thickness of the insert", 5.5)
      .output(&InsertStrength::breaking_feed_mm_rev, "breaking_feed_mm_rev", "S_p", "mm/rev", positive(),
              "feed that breaks it")
      .output(&InsertStrength::breaking_force_n, "breaking_force_n", "P_z", "N", positive(), "force borne")
      .output(&InsertStrength::power_kw, "power_kw", "N", "kW", positive(), "power of the lathe")
      .note("Linear between the rows of the table (COMPLETION).");
  source
      .function<&stepped_feed_applicable>("stepped_feed_applicable",
                                          "Whether a lathe can run the stepped-feed test.", "text, Table 2",
                                          Provenance::paper)
      .input(&SteppedFeedSetup::holder_height_mm, "holder_height_mm", "H", "mm", positive(),
             "height of the holder", 25.0)
      .input(&SteppedFeedSetup::thickness_mm, "thickness_mm", "h", "mm", closed(3.18, 7.94),
             "thickness of the insert", 4.76)
      .input(&SteppedFeedSetup::machine_power_kw, "machine_power_kw", "N", "kW", positive(),
             "power of the machine", 11.0)
      .input(&SteppedFeedSetup::machine_max_feed_mm_rev, "machine_max_feed_mm_rev", "S_max", "mm/rev",
             positive(), "largest feed of the machine", 3.2)
      .output(&SteppedFeedApplicability::size_ok, "size_ok", "-", "-", no_range(),
              "holder at most 32 mm, insert at most 6.35 mm")
      .output(&SteppedFeedApplicability::feed_ok, "feed_ok", "-", "-", no_range(),
              "the machine has the breaking feed (COMPLETION)")
      .output(&SteppedFeedApplicability::power_ok, "power_ok", "-", "-", no_range(),
              "the machine has the power (COMPLETION)")
      .output(&SteppedFeedApplicability::applicable, "applicable", "-", "-", no_range(), "all three");
  source
      .function<&strength_test_score>("strength_test_score", "Total score of a strength-test method.",
                                      "Table 1", Provenance::paper)
      .input(&TestScores::universality, "universality", "-", "1", non_negative(),
             "score for universality, weight included", 1.13)
      .input(&TestScores::tool_cost, "tool_cost", "-", "1", non_negative(),
             "score for the cutters spent, weight included", 0.8)
      .input(&TestScores::result_quality, "result_quality", "-", "1", non_negative(),
             "score for the quality of results, weight included", 0.47)
      .output(&TestScore::score, "score", "-", "1", non_negative(), "total");
  source
      .function<&treatment_variant>("treatment_variant", "Test and service results by edge treatment.",
                                    "Tables 3 and 4", Provenance::paper)
      .input(&TreatmentIn::variant, "variant", "-", "-", no_range(),
             "standard, TiN coated, vibro-abrasive edge rounding (bo), or both", "bo")
      .output(&TreatmentVariant::chip_resistance_s, "chip_resistance_s", "T_c", "s", positive(),
              "chipping resistance")
      .output(&TreatmentVariant::breaking_feed_mm_rev, "breaking_feed_mm_rev", "S_p", "mm/rev", positive(),
              "breaking feed")
      .output(&TreatmentVariant::mean_life_min, "mean_life_min", "T_3", "min", positive(), "mean life")
      .output(&TreatmentVariant::breakage_fraction, "breakage_fraction", "q", "1", probability(),
              "share of breakages")
      .output(&TreatmentVariant::r_feed_chip, "r_feed_chip", "R_1", "1", closed(-1, 1),
              "correlation of breaking feed and chipping resistance")
      .output(&TreatmentVariant::r_life_chip, "r_life_chip", "r_2", "1", closed(-1, 1),
              "correlation of life and chipping resistance")
      .output(&TreatmentVariant::r_breakage_chip, "r_breakage_chip", "r_3", "1", closed(-1, 1),
              "correlation of breakages and chipping resistance")
      .output(&TreatmentVariant::life_ratio, "life_ratio", "-", "1", positive(), "life relative to standard")
      .output(&TreatmentVariant::breakage_ratio, "breakage_ratio", "-", "1", positive(),
              "breakages relative to standard");
}

void describe_tests(Source& source) {
  source
      .function<&stepped_feed_test>("stepped_feed_test", "Steps, time and cut of a stepped-feed test.",
                                    "Data, section stepped-feed test", Provenance::completion)
      .optional(&SteppedFeed::start_feed_mm_rev, "start_feed_mm_rev", "S_0", "mm/rev", positive(),
                "first feed (0.76 in the paper)")
      .optional(&SteppedFeed::feed_step_mm_rev, "feed_step_mm_rev", "dS", "mm/rev", positive(),
                "feed step (COMPLETION)")
      .input(&SteppedFeed::breaking_feed_mm_rev, "breaking_feed_mm_rev", "S_p", "mm/rev", positive(),
             "feed that breaks the edge", 1.91)
      .optional(&SteppedFeed::step_time_s, "step_time_s", "tau", "s", positive(), "time of a step")
      .optional(&SteppedFeed::cutting_speed_m_min, "cutting_speed_m_min", "V", "m/min", positive(),
                "cutting speed")
      .output(&SteppedFeedTest::steps, "steps", "-", "1", at_least(1), "steps until the edge breaks")
      .output(&SteppedFeedTest::duration_s, "duration_s", "-", "s", positive(),
              "duration, last step in full (upper bound)")
      .output(&SteppedFeedTest::cut_length_m, "cut_length_m", "-", "m", positive(), "length of cut");
  source
      .function<&weibull_from_mean_cv>("weibull_from_mean_cv", "Weibull law of life from mean and scatter.",
                                       "method of moments", Provenance::completion)
      .input(&LifeMoments::mean_life_min, "mean_life_min", "T_3", "min", positive(), "mean life", 18.7)
      .input(&LifeMoments::life_cv, "life_cv", "cv", "1", closed(0.05, 3), "coefficient of variation of life",
             0.5)
      .with(weibull_out<WeibullLife>());
  source
      .function<&life_model_from_chipping_test>("life_model_from_chipping_test",
                                                "Life of a lot for the simulation, from the shot test.",
                                                "eqs. (2), (3), method of moments", Provenance::completion)
      .with(chip_resistance<ChippingTest>())
      .optional(&ChippingLife::life_cv, "life_cv", "cv", "1", closed(0.05, 3),
                "coefficient of variation of life")
      .output(&LifeModel::mean_life_min, "mean_life_min", "T_3", "min", positive(), "mean life")
      .output(&LifeModel::breakage_fraction, "breakage_fraction", "q", "1", probability(),
              "probability that a life ends by breakage, else by wear")
      .with(weibull_out<LifeModel>())
      .note(fit_note);
}

void describe_screening(Source& source) {
  source
      .function<&screen_by_correlated_test>(
          "screen_by_correlated_test", "What sorting by a correlated test does to the share of bad ones.",
          "screening, Phi_2", Provenance::completion)
      .with(rho<Screen>(0.69))
      .with(bad<Screen>())
      .with(reject<Screen>())
      .output(&Screening::sensitivity, "sensitivity", "-", "1", probability(), "P(rejected | bad)")
      .output(&Screening::specificity, "specificity", "-", "1", probability(), "P(accepted | good)")
      .output(&Screening::bad_fraction_accepted, "bad_fraction_accepted", "d_acc", "1", probability(),
              "share of bad ones among the accepted")
      .output(&Screening::bad_fraction_rejected, "bad_fraction_rejected", "d_rej", "1", probability(),
              "share of bad ones among the rejected")
      .output(&Screening::false_reject_fraction, "false_reject_fraction", "-", "1", probability(),
              "good and rejected, share of all")
      .note(copula_note);
  source
      .function<&reject_fraction_for_target>("reject_fraction_for_target",
                                             "Share to reject for a wanted share of bad ones.",
                                             "screening, inverse", Provenance::completion)
      .with(rho<ScreenTarget>(0.69))
      .with(bad<ScreenTarget>())
      .input(&ScreenTarget::target_bad_fraction, "target_bad_fraction", "d_acc", "1", open(0, 1),
             "share of bad ones wanted among the accepted", 0.15)
      .output(&RejectFraction::reject_fraction, "reject_fraction", "p", "1", probability(),
              "share to reject, 1 when 0.999 is not enough")
      .output(&RejectFraction::feasible, "feasible", "-", "-", no_range(), "the target is met")
      .note(copula_note);
  source
      .function<&screened_survival>("screened_survival", "Survival of all and of the accepted inserts.",
                                    "screening, R_acc(t)", Provenance::completion)
      .input(&ScreenedAtTime::time_min, "time_min", "t", "min", non_negative(), "cutting time", 40.0)
      .with(weibull_in<ScreenedLifeIn>())
      .with(rho<ScreenedLifeIn>())
      .with(reject<ScreenedLifeIn>())
      .output(&ScreenedSurvival::all, "survival_all", "R", "1", probability(), "survival of all")
      .output(&ScreenedSurvival::accepted, "survival_accepted", "R_acc", "1", probability(),
              "survival of the accepted")
      .note(copula_note);
  source
      .function<&screened_life>("screened_life", "Life of the accepted inserts.", "screening, E[T^n | acc]",
                                Provenance::completion)
      .with(weibull_in<ScreenedLifeIn>())
      .with(rho<ScreenedLifeIn>())
      .with(reject<ScreenedLifeIn>())
      .output(&ScreenedLife::mean_all_min, "mean_all_min", "T", "min", positive(), "mean life of all")
      .output(&ScreenedLife::mean_accepted_min, "mean_accepted_min", "T_acc", "min", positive(),
              "mean life of the accepted")
      .output(&ScreenedLife::cv_accepted, "cv_accepted", "cv", "1", positive(),
              "coefficient of variation of the accepted")
      .output(&ScreenedLife::mean_rejected_min, "mean_rejected_min", "T_rej", "min", positive(),
              "mean life of the rejected")
      .output(&ScreenedLife::equivalent_shape, "equivalent_shape", "k", "1", positive(),
              "shape of the Weibull law with the accepted mean and cv")
      .output(&ScreenedLife::equivalent_scale_min, "equivalent_scale_min", "s", "min", positive(),
              "its scale")
      .output(&ScreenedLife::b10_accepted_min, "b10_accepted_min", "t_10", "min", positive(),
              "life that 90 % of the accepted survive")
      .note(copula_note);
  source
      .function<&lot_acceptance>("lot_acceptance",
                                 "Probability of accepting a lot by a sample of shot tests.", "lot sampling",
                                 Provenance::completion)
      .input(&LotPlan::tc_lot_s, "tc_lot_s", "T_c", "s", positive(), "median chipping resistance of the lot",
             90.0)
      .input(&LotPlan::ln_sd_within, "ln_sd_within", "sigma_w", "1", positive(),
             "standard deviation of ln T_c within a lot", 0.35)
      .input(&LotPlan::sample_size, "sample_size", "n", "1", at_least(1), "edges tested", 5)
      .input(&LotPlan::tc_critical_s, "tc_critical_s", "T_crit", "s", positive(),
             "least geometric mean of the sample", 110.0)
      .output(&LotAcceptance::p_accept, "p_accept", "P", "1", probability(), "probability of acceptance");
  source
      .function<&lot_mean_correlation>("lot_mean_correlation",
                                       "Correlation of the sample mean with the lot mean.", "lot sampling",
                                       Provenance::completion)
      .input(&LotScatter::ln_sd_between, "ln_sd_between", "sigma_b", "1", non_negative(),
             "standard deviation of the lot means of ln T_c", 0.3)
      .input(&LotScatter::ln_sd_within, "ln_sd_within", "sigma_w", "1", positive(),
             "standard deviation of ln T_c within a lot", 0.35)
      .input(&LotScatter::sample_size, "sample_size", "n", "1", at_least(1), "edges tested per lot", 5)
      .output(&LotCorrelation::rho_lot, "rho_lot", "rho", "1", probability(), "correlation");
  source
      .function<&inspection_decision>("inspection_decision",
                                      "Cost per minute of cutting with and without sorting.",
                                      "inspection decision", Provenance::completion)
      .with(plan)
      .with(reject<InspectionIn>())
      .output(&InspectionDecision::cost_rate_without, "cost_rate_without", "c_0", "money/min", positive(),
              "cost without inspection")
      .output(&InspectionDecision::cost_rate_with, "cost_rate_with", "c_1", "money/min", non_negative(),
              "cost with inspection")
      .output(&InspectionDecision::saving_fraction, "saving_fraction", "-", "1", at_most(1),
              "share of the cost saved")
      .output(&InspectionDecision::inspect, "inspect", "-", "-", no_range(), "inspection is cheaper")
      .output(&InspectionDecision::mean_life_accepted_min, "mean_life_accepted_min", "T_acc", "min",
              positive(), "mean life of the accepted")
      .output(&InspectionDecision::breakage_fraction_accepted, "breakage_fraction_accepted", "q_acc", "1",
              probability(), "breakages of the accepted")
      .output(&InspectionDecision::breakages_per_hour_without, "breakages_per_hour_without", "-", "1/h",
              non_negative(), "breakages per hour of cutting without inspection")
      .output(&InspectionDecision::breakages_per_hour_with, "breakages_per_hour_with", "-", "1/h",
              non_negative(), "breakages per hour of cutting with inspection")
      .note(copula_note);
  source
      .function<&optimal_reject_fraction>("optimal_reject_fraction", "Reject fraction of least cost.",
                                          "inspection decision", Provenance::completion)
      .with(plan)
      .output(&OptimalReject::reject_fraction, "reject_fraction", "p", "1", probability(),
              "on 0.01, 0.02 .. 0.90; 0 = do without inspection")
      .output(&OptimalReject::cost_rate, "cost_rate", "c", "money/min", non_negative(),
              "cost per minute of cutting")
      .note(copula_note);
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K119",
       .title = "Development of the bases of comprehensive certification of assembled carbide cutters at the "
                "stages "
                "of their design and manufacture",
       .authors = "Kazakova T. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "In rough turning a carbide cutter fails by chipping and breakage, which depend on how the insert "
           "was made, ground, treated and assembled. Accelerated tests whose results correlate with life and "
           "breakages in service; what sorting lots and inserts by them is worth.",
       .role = "inspection",
       .errata = {"The correlation r_3 of breakages with chipping resistance is printed positive; the "
                  "breakages fall "
                  "as the resistance rises, so it is given negative.",
                  "Eq. (3) exceeds 1 for T_c below 61.1 s: clamped."}});
  describe_published(source);
  describe_tests(source);
  describe_screening(source);
}

}  // namespace verstat::models::k119
