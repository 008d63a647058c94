// Description of K117; its formulas stand in k117_life, k117_availability, k117_cost and k117_strategy.cpp.
#include "models/reliability/k117_rational_reliability.h"

namespace verstat::models::k117 {
namespace {

const Range valid_gamma = closed(0.01, 0.99);
const Range valid_shape = closed(0.25, 60);
const Range valid_cv = closed(0.05, 2);

// Groups of fields that several functions share. Each takes the struct that holds the members.
template <class In>
auto moments() {
  return [](auto& f) {
    f.optional(&In::mean_min, "mean_min", "T", "min", positive(), "mean life of an edge")
        .optional(&In::cv, "cv", "CV", "1", valid_cv,
                  "coefficient of variation of life (normal: 0.05..0.45; not used by exponential)");
  };
}
template <class In>
auto law() {
  return [](auto& f) {
    f.optional(&In::law, "law", "F", "-", no_range(),
               "life law: weibull, normal, exponential, lognormal or gamma");
  };
}
template <class In>
auto gamma(double example) {
  return [example](auto& f) {
    f.input(&In::gamma, "gamma", "gamma", "1", valid_gamma,
            "reliability level: share of edges that survive their scheduled period", example);
  };
}
template <class In>
auto period() {
  return
      [](auto& f) { f.optional(&In::period_min, "T_e_min", "T_e", "min", positive(), "scheduled period"); };
}

const auto feed_depth = [](auto& f) {
  f.optional(&FeedAndDepth::feed_mm_rev, "S", "S", "mm/rev", positive(), "feed")
      .optional(&FeedAndDepth::depth_mm, "t", "t", "mm", positive(), "depth of cut");
};
const auto taylor = [](auto& f) {
  f.optional(&TaylorLife::mean_ref_min, "mean_ref_min", "T_ref", "min", positive(),
             "mean life at the reference regime")
      .optional(&TaylorLife::speed_ref_m_min, "V_ref", "V_ref", "m/min", positive(), "reference speed")
      .optional(&TaylorLife::feed_ref_mm_rev, "S_ref", "S_ref", "mm/rev", positive(), "reference feed")
      .optional(&TaylorLife::depth_ref_mm, "t_ref", "t_ref", "mm", positive(), "reference depth of cut")
      .optional(&TaylorLife::mu, "mu", "mu", "1", above(1), "Taylor exponent of speed, 1/m")
      .optional(&TaylorLife::depth_exponent, "x_t", "x", "1", any(), "exponent of depth in V(T, t, S)")
      .optional(&TaylorLife::feed_exponent, "y_S", "y", "1", any(), "exponent of feed in V(T, t, S)");
};
const auto economics = [](auto& f) {
  f.optional(&Economics::machine_rate_per_min, "machine_rate", "E", "UAH/min", positive(),
             "cost of a machine minute")
      .optional(&Economics::setter_rate_per_min, "setter_rate", "a_set", "UAH/min", positive(),
                "wage of the setter per minute")
      .optional(&Economics::t_change_planned_min, "t_change_planned_min", "t_c1", "min", non_negative(),
                "time of a planned change")
      .optional(&Economics::t_change_failure_min, "t_change_failure_min", "t_c2", "min", non_negative(),
                "time of a change after a failure")
      .optional(&Economics::insert_price, "insert_price", "A_u", "UAH", positive(), "price of an insert")
      .optional(&Economics::periods_planned, "periods_planned", "K_1", "1", positive(),
                "life periods obtained from an insert with planned changes")
      .optional(&Economics::periods_failure, "periods_failure", "K_2", "1", positive(),
                "life periods obtained from an insert that fails")
      .optional(&Economics::regrind_planned, "regrind_planned", "A_z1", "UAH", non_negative(),
                "regrinding after a planned change")
      .optional(&Economics::regrind_failure, "regrind_failure", "A_z2", "UAH", non_negative(),
                "regrinding after a failure")
      .optional(&Economics::damage_cost, "damage_cost", "C_d", "UAH", non_negative(),
                "damage of a failure: holder, shim, rework, scrapped part");
};
const auto geometry = [](auto& f) {
  f.optional(&TurnedPart::diameter_mm, "D_mm", "D", "mm", positive(), "diameter turned")
      .optional(&TurnedPart::length_mm, "L_mm", "L", "mm", positive(), "length turned")
      .optional(&TurnedPart::passes, "passes", "i", "1", positive(), "passes");
};
const auto outcome_costs = [](auto& f) {
  f.optional(&OutcomeCosts::planned_cost, "Q_planned", "Q_1", "UAH", non_negative(),
             "cost of a planned change")
      .optional(&OutcomeCosts::failure_cost, "Q_failure", "Q_2", "UAH", non_negative(), "cost of a failure");
};
const auto two_edges = [](auto& f) {
  f.input(&TwoEdgeInsert::scale1_min, "scale1_min", "a_1", "min", positive(), "Weibull scale of edge 1",
          66.18)
      .input(&TwoEdgeInsert::shape1, "shape1", "b_1", "1", valid_shape, "Weibull shape of edge 1", 1.4513)
      .input(&TwoEdgeInsert::scale2_min, "scale2_min", "a_2", "min", positive(), "Weibull scale of edge 2",
             50.0)
      .input(&TwoEdgeInsert::shape2, "shape2", "b_2", "1", valid_shape, "Weibull shape of edge 2", 1.8)
      .optional(&TwoEdgeInsert::change_age1_min, "tau1_min", "tau_1", "min", positive(),
                "scheduled change age of edge 1, 1e9 = none")
      .optional(&TwoEdgeInsert::change_age2_min, "tau2_min", "tau_2", "min", positive(),
                "scheduled change age of edge 2, 1e9 = none")
      .optional(&TwoEdgeInsert::p_reserve_ok, "p_reserve_ok", "p_r", "1", probability(),
                "probability that a failure of edge 1 leaves edge 2 usable")
      .optional(&TwoEdgeInsert::p_single_edge, "p_single_edge", "p_s", "1", probability(),
                "probability that the fitted insert has one usable edge only");
};
template <class In>
auto restoration_rates() {
  return [](auto& f) {
    f.optional(&In::rate_index_per_min, "rate_index_per_min", "lambda_4", "1/min", positive(),
               "rate of indexing (1/mean time)")
        .optional(&In::rate_replace_per_min, "rate_replace_per_min", "lambda_5", "1/min", positive(),
                  "rate of changing the insert (1/mean time)");
  };
}
template <class In>
auto failure_extra() {
  return [](auto& f) {
    f.optional(&In::failure_extra_min, "failure_extra_min", "t_f", "min", non_negative(),
               "additional down time of a failure");
  };
}
const auto accounting_note =
    "scheduled: the period is charged in full even when the edge fails earlier, the paper's approximation "
    "(6 % too cheap at gamma 0.64, 1 % at 0.9 with the default set); renewal: the exact long-run cost.";
const auto levels_note =
    "The paper's levels 0.64, 0.78 and 0.80-0.82 belong to inputs it does not print; the default set was "
    "completed so that they are met. Reference levels, not constants of nature.";

void describe_life(Source& source) {
  source
      .function<&weibull_from_moments>("weibull_from_moments",
                                       "Weibull shape and scale with a given mean and scatter.", "section B",
                                       Provenance::completion)
      .with(moments<LifeMoments>())
      .output(&WeibullParameters::shape, "shape", "b", "1", positive(), "Weibull shape")
      .output(&WeibullParameters::scale_min, "scale_min", "eta", "min", positive(), "Weibull scale");
  source
      .function<&life_reliability>("life_reliability",
                                   "Reliability, density and hazard of an edge at an age.", "section B",
                                   Provenance::completion)
      .with(law<LifeAtAge>())
      .input(&LifeAtAge::age_min, "t_min", "t", "min", non_negative(), "age in cutting time", 20.0)
      .with(moments<LifeAtAge>())
      .output(&LifeReliability::reliability, "reliability", "R", "1", probability(),
              "probability of surviving the age")
      .output(&LifeReliability::density_per_min, "density_per_min", "f", "1/min", non_negative(),
              "density of life, without the atom of the normal law at zero")
      .output(&LifeReliability::hazard_per_min, "hazard_per_min", "h", "1/min", non_negative(),
              "hazard, density/reliability");
  source
      .function<&gamma_percent_life>("gamma_percent_life", "Age survived with probability gamma.",
                                     "section B", Provenance::completion)
      .with(law<GammaPercent>())
      .input(&GammaPercent::gamma, "gamma", "gamma", "1", open(0, 1), "probability of surviving the age", 0.8)
      .with(moments<GammaPercent>())
      .output(&GammaPercentLife::life_min, "T_gamma_min", "T_gamma", "min", non_negative(),
              "gamma-percent life")
      .note("0 for the normal law from gamma = Phi(1/cv) on: that share of the edges fails at once.");
  source
      .function<&required_mean_life>("required_mean_life",
                                     "Mean life at which a period is survived with probability gamma.",
                                     "section B, inverse of T_gamma", Provenance::completion)
      .with(law<PeriodAtGamma>())
      .with(period<PeriodAtGamma>())
      .input(&PeriodAtGamma::gamma, "gamma", "gamma", "1", open(0, 1), "probability of surviving the period",
             0.8)
      .optional(&PeriodAtGamma::cv, "cv", "CV", "1", valid_cv,
                "coefficient of variation of life (normal: 0.05..0.45; not used by exponential)")
      .output(&MeanLife::mean_min, "mean_min", "T", "min", positive(), "mean life");
  source
      .function<&restricted_mean_life>("restricted_mean_life",
                                       "Mean working time of an edge that is changed at an age.",
                                       "eq. (1), numerator", Provenance::completion)
      .with(law<ScheduledAge>())
      .optional(&ScheduledAge::change_age_min, "tau_min", "tau", "min", non_negative(),
                "change age, 1e9 = none")
      .example(60.0)
      .with(moments<ScheduledAge>())
      .output(&RestrictedMean::restricted_mean_min, "M_min", "M", "min", non_negative(),
              "integral of the reliability from 0 to the change age");
  source
      .function<&weibull_restricted_mean_series>("weibull_restricted_mean_series",
                                                 "The paper's series for the mean working time of an edge.",
                                                 "eq. (1), numerator", Provenance::repaired)
      .input(&RestrictedMeanSeries::change_age_min, "tau_min", "tau", "min", positive(), "change age", 20.0)
      .input(&RestrictedMeanSeries::scale_min, "scale_min", "a", "min", positive(), "Weibull scale", 66.18)
      .input(&RestrictedMeanSeries::shape, "shape", "b", "1", valid_shape, "Weibull shape", 1.4513)
      .input(&RestrictedMeanSeries::terms, "n_terms", "n", "1", at_least(1), "terms of the series", 40)
      .output(&RestrictedMean::restricted_mean_min, "M_min", "M", "min", any(),
              "sum of the first n_terms terms")
      .note("Alternating: relative error 1e-14 at (tau/scale)^shape = 6, 1e-10 at 15, where it ends.");
}

void describe_availability(Source& source) {
  source
      .function<&insert_cycle_availability>("insert_cycle_availability",
                                            "Stationary availability of a two-edge insert.", "eq. (1)",
                                            Provenance::repaired)
      .with(two_edges)
      .with(restoration_rates<InsertCycle>())
      .with(failure_extra<InsertCycle>())
      .output(&InsertAvailability::availability, "K_r", "K_r", "1", probability(), "availability")
      .output(&InsertAvailability::mean_up_min, "mean_up_min", "U", "min", positive(),
              "cutting time per insert")
      .output(&InsertAvailability::mean_down_min, "mean_down_min", "W", "min", positive(),
              "restoration time per insert")
      .output(&InsertAvailability::cycle_min, "cycle_min", "U+W", "min", positive(), "time per insert")
      .output(&InsertAvailability::pi1, "pi1", "pi_1", "1", probability(), "edge 1 with reserve")
      .output(&InsertAvailability::pi2, "pi2", "pi_2", "1", probability(), "edge 1 alone")
      .output(&InsertAvailability::pi3, "pi3", "pi_3", "1", probability(), "edge 2")
      .output(&InsertAvailability::pi4, "pi4", "pi_4", "1", probability(), "indexing")
      .output(&InsertAvailability::pi5, "pi5", "pi_5", "1", probability(), "insert change")
      .output(&InsertAvailability::failures_per_insert, "failures_per_insert", "n_fail", "1", non_negative(),
              "failures per insert")
      .output(&InsertAvailability::changes_per_cutting_hour, "changes_per_cutting_hour", "-", "1/h",
              positive(), "indexings and insert changes per hour of cutting")
      .note(
          "Run to failure: the availability depends on the laws through their means only. pi_i is the "
          "embedded "
          "chain, not a time fraction.")
      .note("p_reserve_ok, p_single_edge and failure_extra_min are COMPLETION; 1, 0, 0 is the paper's case.");
  source
      .function<&insert_cycle_availability_edges>("insert_cycle_availability_edges",
                                                  "Stationary availability of an insert with n edges.",
                                                  "section A, n edges", Provenance::completion)
      .input(&InsertCycleEdges::edges, "n_edges", "n", "1", closed(1, 8), "edges of the insert", 4)
      .input(&InsertCycleEdges::scale_min, "scale_min", "a", "min", positive(),
             "Weibull scale of the first edge", 66.18)
      .input(&InsertCycleEdges::shape, "shape", "b", "1", valid_shape, "Weibull shape", 1.4513)
      .optional(&InsertCycleEdges::edge_factor, "edge_factor", "-", "1", positive(),
                "scale of each further edge relative to the one before")
      .optional(&InsertCycleEdges::change_age_min, "tau_min", "tau", "min", positive(),
                "scheduled change age of every edge, 1e9 = none")
      .with(restoration_rates<InsertCycleEdges>())
      .optional(&InsertCycleEdges::p_reserve_ok, "p_reserve_ok", "p_r", "1", probability(),
                "probability that a failure leaves the next edge usable")
      .with(failure_extra<InsertCycleEdges>())
      .output(&InsertAvailabilityEdges::availability, "K_r", "K_r", "1", probability(), "availability")
      .output(&InsertAvailabilityEdges::mean_up_min, "mean_up_min", "U", "min", positive(),
              "cutting time per insert")
      .output(&InsertAvailabilityEdges::mean_down_min, "mean_down_min", "W", "min", positive(),
              "restoration time per insert")
      .output(&InsertAvailabilityEdges::edges_used_per_insert, "edges_used_per_insert", "-", "1", at_least(1),
              "edges used per insert")
      .output(&InsertAvailabilityEdges::failures_per_insert, "failures_per_insert", "n_fail", "1",
              non_negative(), "failures per insert")
      .output(&InsertAvailabilityEdges::inserts_per_cutting_hour, "inserts_per_cutting_hour", "-", "1/h",
              positive(), "inserts per hour of cutting");
  source
      .function<&semi_markov_steady_state>("semi_markov_steady_state",
                                           "Stationary distribution of a semi-Markov process.", "section A",
                                           Provenance::completion)
      .input(&SemiMarkov::transitions, "P", "P", "1", probability(),
             "transition probabilities of the embedded chain, one row per state",
             Value::List{Value::List{0.0, 1.0, 0.0}, Value::List{0.3, 0.0, 0.7}, Value::List{1.0, 0.0, 0.0}})
      .length(1, 300)
      .input(&SemiMarkov::mean_sojourn_min, "m_min", "m", "min", non_negative(), "mean sojourn in each state",
             Value::List{10.0, 4.0, 2.0})
      .length(1, 300)
      .output(&SemiMarkovSteadyState::embedded, "pi", "pi", "1", probability(),
              "stationary distribution of the embedded chain")
      .output(&SemiMarkovSteadyState::time_fraction, "time_fraction", "-", "1", probability(),
              "share of time in each state");
  source
      .function<&required_restoration_rate>("required_restoration_rate",
                                            "Restoration rate that gives an availability.",
                                            "eq. (1), inverse", Provenance::repaired)
      .input(&AvailabilityTarget::availability, "K_target", "K", "1", open(0, 1), "availability wanted", 0.95)
      .with(two_edges)
      .output(&RestorationRate::rate_per_min, "restore_rate_per_min", "lambda", "1/min", positive(),
              "common rate of indexing and insert change");
  source
      .function<&series_reliability>("series_reliability", "Reliability of a tool as a series of parts.",
                                     "text", Provenance::repaired)
      .input(&SeriesParts::parts, "parts", "R_i", "1", probability(), "reliability of each part",
             Value::List{0.82, 0.95, 0.99})
      .length(1, 100'000)
      .output(&SeriesReliability::reliability, "reliability", "R", "1", probability(),
              "product of the parts");
}

void describe_regime(Source& source) {
  source
      .function<&machining_time_turning>("machining_time_turning", "Machining time of longitudinal turning.",
                                         "section B", Provenance::completion)
      .with(geometry)
      .input(&TurningPass::speed_m_min, "V", "V", "m/min", positive(), "cutting speed", 60.0)
      .optional(&TurningPass::feed_mm_rev, "S", "S", "mm/rev", positive(), "feed")
      .output(&MachiningTime::time_min, "t0_min", "t_0", "min", positive(), "machining time");
  source
      .function<&mean_life_for_regime>("mean_life_for_regime", "Mean life of an edge at a regime.",
                                       "section B, extended Taylor law", Provenance::completion)
      .input(&Regime::speed_m_min, "V", "V", "m/min", positive(), "cutting speed", 75.0)
      .with(feed_depth)
      .with(taylor)
      .output(&MeanLife::mean_min, "mean_min", "T", "min", positive(), "mean life");
  source
      .function<&speed_for_mean_life>("speed_for_mean_life", "Cutting speed that gives a mean life.",
                                      "section B, extended Taylor law", Provenance::completion)
      .input(&LifeWanted::mean_min, "T_min", "T", "min", positive(), "mean life wanted", 120.0)
      .with(feed_depth)
      .with(taylor)
      .output(&Speed::speed_m_min, "V_m_min", "V", "m/min", positive(), "cutting speed");
  source
      .function<&change_costs>("change_costs", "Cost of a planned change and of a failure.", "section C",
                               Provenance::reconstructed)
      .with(economics)
      .output(&ChangeCosts::planned, "Q_planned", "Q_1", "UAH", positive(), "cost of a planned change")
      .output(&ChangeCosts::failure, "Q_failure", "Q_2", "UAH", positive(), "cost of a failure");
  source
      .function<&part_cost_base>("part_cost_base", "Variable part cost at a fixed tool life.", "eq. (3)",
                                 Provenance::repaired)
      .input(&PartCostBase::machining_time_min, "t0_min", "t_0", "min", non_negative(), "machining time",
             28.0)
      .optional(&PartCostBase::machine_rate_per_min, "machine_rate", "E", "UAH/min", positive(),
                "cost of a machine minute")
      .input(&PartCostBase::change_time_min, "t_change_min", "t_c", "min", non_negative(),
             "time to change and set the tool", 5.0)
      .input(&PartCostBase::change_rate_per_min, "change_rate", "E_T", "UAH/min", positive(),
             "cost of a minute of that stop", 3.5)
      .input(&PartCostBase::parts_per_period, "z_T", "z_T", "1", positive(), "parts per life period", 2.1)
      .optional(&PartCostBase::insert_price, "insert_price", "A_u", "UAH", positive(), "price of the tool")
      .input(&PartCostBase::periods, "periods", "K", "1", positive(), "life periods of a tool", 4.0)
      .input(&PartCostBase::regrind, "regrind", "A_z", "UAH", non_negative(), "cost of regrinding", 0.0)
      .output(&PartCostBaseOut::part_cost, "part_cost", "A", "UAH", positive(), "variable part cost");
}

template <class In>
auto period_economy() {
  return [](auto& f) {
    f.with(period<In>())
        .with(feed_depth)
        .optional(&In::accounting, "accounting", "-", "-", no_range(),
                  "how a period is charged: scheduled (paper) or renewal (exact)")
        .optional(&In::life_offset_min, "life_offset_min", "a", "min", non_negative(),
                  "offset a of the Weibull scale in a + C_T V^-mu")
        .with(economics)
        .optional(&In::cv, "cv", "CV", "1", valid_cv, "coefficient of variation of life (Weibull)")
        .with(taylor)
        .with(geometry);
  };
}

void describe_fixed_period(Source& source) {
  source
      .function<&part_cost_at_gamma>(
          "part_cost_at_gamma",
          "Part cost when the speed is chosen so that an edge survives its period with probability gamma.",
          "eqs. (4)-(7)", Provenance::reconstructed)
      .with(gamma<PeriodEconomyAtGamma>(0.64))
      .with(period_economy<PeriodEconomy>())
      .output(&PartCostAtGamma::part_cost, "part_cost", "A", "UAH", positive(), "variable part cost")
      .output(&PartCostAtGamma::speed_m_min, "V_m_min", "V", "m/min", positive(), "cutting speed")
      .output(&PartCostAtGamma::machining_time_min, "t0_min", "t_0", "min", positive(), "machining time")
      .output(&PartCostAtGamma::mean_life_min, "mean_life_min", "T", "min", positive(),
              "mean life at that speed")
      .output(&PartCostAtGamma::slope, "dA_dgamma", "dA/dgamma", "UAH", any(),
              "first derivative (scheduled accounting only)")
      .output(&PartCostAtGamma::curvature, "d2A_dgamma2", "d2A/dgamma2", "UAH", any(),
              "second derivative (scheduled accounting only)")
      .note(accounting_note)
      .note(
          "gamma 0.40..0.99 in scheduled accounting, whose cost falls to zero with gamma. Renewal "
          "accounting is COMPLETION.");
  source
      .function<&rational_gamma_cost>("rational_gamma_cost", "Reliability level of least part cost.",
                                      "minimum of eq. (4) or (7)", Provenance::reconstructed)
      .with(period_economy<PeriodEconomy>())
      .optional(&GammaSearch::knee_tolerance, "knee_tolerance", "-", "1", non_negative(),
                "excess over the least cost that marks the knee")
      .optional(&GammaSearch::gamma_min, "gamma_min", "-", "1", valid_gamma,
                "least gamma searched (scheduled: not below 0.40)")
      .optional(&GammaSearch::gamma_max, "gamma_max", "-", "1", valid_gamma, "largest gamma searched")
      .output(&RationalGamma::gamma, "gamma_opt", "gamma*", "1", probability(), "gamma of least cost")
      .output(&RationalGamma::gamma_knee, "gamma_knee", "-", "1", probability(),
              "largest gamma within the tolerance of the least cost")
      .output(&RationalGamma::part_cost, "part_cost_min", "A_min", "UAH", positive(), "least part cost")
      .note(accounting_note)
      .note(levels_note)
      .note("The knee tolerance and renewal accounting are COMPLETION.");
  source
      .function<&failure_penalty_for_gamma>("failure_penalty_for_gamma",
                                            "Failure cost that makes a gamma the level of least cost.",
                                            "stationarity of eq. (4)", Provenance::reconstructed)
      .with(gamma<PenaltyCalibration>(0.64))
      .input(&PenaltyCalibration::shape, "shape", "b", "1", valid_shape, "Weibull shape of life", 1.45126)
      .optional(&PenaltyCalibration::mu, "mu", "mu", "1", above(1), "Taylor exponent of speed")
      .with(period<PenaltyCalibration>())
      .optional(&PenaltyCalibration::machine_rate_per_min, "machine_rate", "E", "UAH/min", positive(),
                "cost of a machine minute")
      .optional(&PenaltyCalibration::planned_cost, "Q_planned", "Q_1", "UAH", non_negative(),
                "cost of a planned change")
      .output(&FailurePenalty::failure_cost, "Q_failure", "Q_2", "UAH", positive(), "cost of a failure")
      .note("A local minimum: for the whole interval compare with its ends (rational_gamma_cost).");

  const auto expenditure = [](auto& f) {
    f.optional(&Expenditure::period_price, "period_price", "A_v0", "UAH", positive(),
               "price of a life period at the base reliability, A_u/K_1")
        .optional(&Expenditure::price_exponent, "price_exponent", "k", "1", non_negative(),
                  "exponent of price over scale life")
        .optional(&Expenditure::cv, "cv", "CV", "1", valid_cv, "coefficient of variation of life (Weibull)")
        .optional(&Expenditure::failure_cost, "failure_cost", "C_f", "UAH", non_negative(),
                  "cost of a failure")
        .with(period<Expenditure>())
        .optional(&Expenditure::mean_ref_min, "mean_ref_min", "T_ref", "min", positive(),
                  "mean life at the base price");
  };
  source
      .function<&reliability_expenditure>("reliability_expenditure",
                                          "Manufacturing and operating expenditure at a reliability level.",
                                          "eq. (8), Fig. 2", Provenance::completion)
      .with(gamma<ExpenditureAtGamma>(0.78))
      .with(expenditure)
      .output(&ExpenditureParts::manufacture, "A_manufacture", "A_v", "UAH", positive(), "manufacturing")
      .output(&ExpenditureParts::operation, "A_operation", "A_e", "UAH", non_negative(), "operation")
      .output(&ExpenditureParts::total, "A_total", "A_v + A_e", "UAH", positive(), "total expenditure");
  source
      .function<&rational_gamma_expenditure>("rational_gamma_expenditure",
                                             "Reliability level of least expenditure, 0.20..0.99.", "eq. (8)",
                                             Provenance::completion)
      .with(expenditure)
      .output(&ExpenditureOptimum::gamma, "gamma_opt", "gamma*", "1", probability(),
              "gamma of least expenditure")
      .output(&ExpenditureOptimum::total, "A_total_min", "-", "UAH", positive(), "least expenditure")
      .note(levels_note);
}

void describe_consumption(Source& source) {
  const auto consumption = [](auto& f) {
    f.with(moments<LifeMoments>())
        .input(&Consumption::edges, "n_edges", "n", "1", at_least(1), "edges of the insert", 4)
        .optional(&Consumption::p_reserve_ok, "p_reserve_ok", "p_r", "1", probability(),
                  "probability that a failure leaves the next edge usable");
  };
  source
      .function<&insert_consumption>("insert_consumption", "Inserts per cutting hour at a reliability level.",
                                     "eq. (9)", Provenance::completion)
      .with(law<LifeLawIn>())
      .with(gamma<ConsumptionAtGamma>(0.78))
      .with(consumption)
      .output(&InsertConsumption::edges_used_per_insert, "edges_used_per_insert", "K_eff", "1", at_least(1),
              "edges used per insert")
      .output(&InsertConsumption::inserts_per_cutting_hour, "inserts_per_cutting_hour", "N", "1/h",
              positive(), "inserts per hour of cutting");
  source
      .function<&rational_gamma_consumption>("rational_gamma_consumption",
                                             "Reliability level of least insert consumption.", "eq. (9)",
                                             Provenance::completion)
      .with(law<LifeLawIn>())
      .with(consumption)
      .optional(&ConsumptionSearch::gamma_min, "gamma_min", "-", "1", valid_gamma, "least gamma searched")
      .optional(&ConsumptionSearch::gamma_max, "gamma_max", "-", "1", valid_gamma, "largest gamma searched")
      .output(&ConsumptionOptimum::gamma, "gamma_opt", "gamma*", "1", probability(),
              "gamma of least consumption")
      .output(&ConsumptionOptimum::inserts_per_cutting_hour, "inserts_per_cutting_hour", "N", "1/h",
              positive(), "inserts per hour of cutting")
      .note(levels_note)
      .note(
          "Levels that the normal law cannot reach (gamma from Phi(1/cv) on) count as endless consumption.");
}

void describe_strategies(Source& source) {
  source
      .function<&part_cost>("part_cost", "Part cost and time at a regime under a replacement strategy.",
                            "section E", Provenance::completion)
      .input(&PartCostIn::strategy, "strategy", "-", "-", no_range(), "replacement strategy", "age")
      .optional(&PartCostIn::gamma, "gamma", "gamma", "1", valid_gamma,
                "reliability level that sets the change age (not used by run_to_failure)")
      .example(0.64)
      .input(&PartCostIn::speed_m_min, "V", "V", "m/min", positive(), "cutting speed", 55.0)
      .with(feed_depth)
      .optional(&PartCostIn::accounting, "accounting", "-", "-", no_range(),
                "how a period is charged (age and part_count only)")
      .with(economics)
      .with(law<PartCostIn>())
      .optional(&PartCostIn::cv, "cv", "CV", "1", valid_cv,
                "coefficient of variation of life (normal: 0.05..0.45)")
      .with(taylor)
      .with(geometry)
      .output(&PartCost::part_cost, "part_cost", "A", "UAH", positive(), "variable part cost")
      .output(&PartCost::machining_time_min, "t0_min", "t_0", "min", positive(), "machining time")
      .output(&PartCost::mean_life_min, "mean_life_min", "T", "min", positive(), "mean life of an edge")
      .output(&PartCost::change_age_min, "change_age_min", "tau", "min", non_negative(),
              "change age, 0 = none")
      .output(&PartCost::life_used_min, "life_used_min", "L", "min", positive(),
              "cutting time that one change pays for")
      .output(&PartCost::parts_per_period, "parts_per_period", "L/t_0", "1", positive(), "parts per change")
      .output(&PartCost::failure_probability, "failure_probability", "1-R", "1", probability(),
              "share of the edges that fail")
      .output(&PartCost::machining_cost, "machining_cost", "t_0 E", "UAH", positive(), "cost of machining")
      .output(&PartCost::edge_cost, "edge_cost", "t_0 q", "UAH", non_negative(), "cost of edges and changes")
      .output(&PartCost::time_per_part_min, "time_per_part_min", "-", "min", positive(),
              "machining time with its share of changes")
      .note(accounting_note)
      .note("A change age from 1e9 min on counts as never.");
  source
      .function<&age_replacement_cost_rate>("age_replacement_cost_rate",
                                            "Cost per cutting minute of replacement at an age or failure.",
                                            "section E (Barlow, Proschan)", Provenance::completion)
      .with(law<AgeReplacement>())
      .optional(&AgeReplacement::change_age_min, "tau_min", "tau", "min", positive(),
                "change age, 1e9 = run to failure")
      .example(45.0)
      .with(moments<AgeReplacement>())
      .with(outcome_costs)
      .output(&AgeReplacementCost::cost_rate_per_min, "cost_rate_per_min", "q", "UAH/min", non_negative(),
              "cost per cutting minute")
      .output(&AgeReplacementCost::reliability, "reliability", "R", "1", probability(),
              "share of the edges that reach the age")
      .output(&AgeReplacementCost::restricted_mean_min, "restricted_mean_min", "M", "min", positive(),
              "mean working time of an edge");
  source
      .function<&optimal_age_replacement>("optimal_age_replacement",
                                          "Change age of least cost per cutting minute.", "section E",
                                          Provenance::completion)
      .with(law<OptimalAgeIn>())
      .with(moments<OptimalAgeIn>())
      .with(outcome_costs)
      .output(&OptimalAge::change_age_min, "tau_opt_min", "tau*", "min", positive(),
              "change age, 1e9 = run to failure")
      .output(&OptimalAge::gamma, "gamma_opt", "gamma*", "1", probability(),
              "share of the edges that reach it, 0 for run to failure")
      .output(&OptimalAge::cost_rate_per_min, "cost_rate_per_min", "q*", "UAH/min", non_negative(),
              "least cost per cutting minute")
      .output(&OptimalAge::run_to_failure_cost_rate_per_min, "run_to_failure_cost_rate_per_min", "Q_2/M(inf)",
              "UAH/min", non_negative(), "cost per cutting minute of run to failure")
      .note("Searched in 0.01..6 mean lives and run to failure, which wins ties.");
  source
      .function<&block_replacement_cost_rate>("block_replacement_cost_rate",
                                              "Cost per cutting minute of block replacement.", "section E",
                                              Provenance::completion)
      .with(law<BlockReplacement>())
      .input(&BlockReplacement::interval_min, "interval_min", "T", "min", positive(),
             "block interval, at most 50 mean lives", 45.0)
      .with(moments<BlockReplacement>())
      .with(outcome_costs)
      .output(&BlockReplacementCost::cost_rate_per_min, "cost_rate_per_min", "q", "UAH/min", non_negative(),
              "cost per cutting minute")
      .output(&BlockReplacementCost::expected_failures, "expected_failures", "H", "1", non_negative(),
              "failures per interval (renewal function)")
      .note("Renewal function by Xie's midpoint scheme, 4000 steps: error below 1e-5 up to 10 mean lives.");
  source
      .function<&joint_speed_gamma_optimum>("joint_speed_gamma_optimum",
                                            "Cutting speed and reliability level of least part cost.",
                                            "eq. (10)", Provenance::completion)
      .with(feed_depth)
      .with(economics)
      .with(law<JointOptimumIn>())
      .optional(&JointOptimumIn::cv, "cv", "CV", "1", valid_cv,
                "coefficient of variation of life (normal: 0.05..0.45)")
      .with(taylor)
      .with(geometry)
      .output(&JointOptimum::gamma, "gamma_opt", "gamma*", "1", probability(),
              "reliability level, 0 for run to failure")
      .output(&JointOptimum::speed_m_min, "V_opt_m_min", "V*", "m/min", positive(), "cutting speed")
      .output(&JointOptimum::mean_life_min, "mean_life_opt_min", "T*", "min", positive(),
              "mean life at that speed")
      .output(&JointOptimum::change_age_min, "change_age_opt_min", "tau*", "min", positive(),
              "change age, 1e9 = run to failure")
      .output(&JointOptimum::part_cost, "part_cost_min", "A*", "UAH", positive(), "least part cost")
      .note("The life law must scale with its mean (cv independent of the regime).");
  source
      .function<&pulse_treatment_effect>("pulse_treatment_effect",
                                         "Gamma-percent life before and after magnetic-pulse treatment.",
                                         "section F", Provenance::reconstructed)
      .with(gamma<PulseTreatment>(0.8))
      .optional(&PulseTreatment::mean_min, "mean_min", "T", "min", positive(), "mean life before treatment")
      .optional(&PulseTreatment::cv_before, "cv_before", "CV", "1", valid_cv,
                "coefficient of variation before (Weibull)")
      .optional(&PulseTreatment::cv_after, "cv_after", "CV", "1", closed(0.05, 0.45),
                "coefficient of variation after (normal)")
      .optional(&PulseTreatment::mean_factor, "mean_factor", "-", "1", at_least(1),
                "mean life after/before; the paper gives no number")
      .output(&PulseTreatmentEffect::shape_before, "shape_before", "b", "1", positive(),
              "Weibull shape before")
      .output(&PulseTreatmentEffect::gamma_life_before_min, "T_gamma_before_min", "T_gamma", "min",
              positive(), "gamma-percent life before")
      .output(&PulseTreatmentEffect::gamma_life_after_min, "T_gamma_after_min", "T_gamma", "min",
              non_negative(), "gamma-percent life after")
      .output(&PulseTreatmentEffect::gamma_life_ratio, "T_gamma_ratio", "-", "1", non_negative(),
              "after/before");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K117",
       .title = "The definition of rational reliability level of assembled (precast) carbide cutters",
       .authors = "Andronov O. Yu.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "An assembled turning tool on a heavy lathe as a repairable system: life of an insert edge, "
                 "availability of the insert with indexing and insert change, and the reliability level "
                 "gamma (share "
                 "of the edges that survive their scheduled period) at which a part costs least; replacement "
                 "strategies, and the effect of magnetic-pulse treatment of the inserts.",
       .role = "reliability",
       .errata = {
           "Eq. (1): t_1, t_2 stand in the place of 1/period; the denominator is the garbled mean "
           "restoration "
           "time 1/lambda_4 + 1/lambda_5; the fraction is inverted (as printed it gives the unavailability).",
           "Eq. (3): the number of life periods K is in the legend but not in the formula; A_u/K is meant.",
           "The expression printed as the second derivative of the part cost is the first one: ln lambda "
           "reads "
           "ln gamma, T_m and T_e are one period, x_4 stands for A_u/K_2 + A_z2, a sign and the constant Q_2 "
           "are lost. The reading in use is the only one found for which it is a derivative."}});
  describe_life(source);
  describe_availability(source);
  describe_regime(source);
  describe_fixed_period(source);
  describe_consumption(source);
  describe_strategies(source);
}

}  // namespace verstat::models::k117
