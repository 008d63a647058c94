#include "models/criteria/k205_hierarchical_efficiency.h"

namespace verstat::models::k205 {
namespace {

constexpr std::size_t most_alternatives = 2000;  // pairs of alternatives are compared

Value numbers(std::initializer_list<double> values) {
  Value::List list;
  for (const double v : values) list.emplace_back(v);
  return list;
}

Value rows(std::initializer_list<std::initializer_list<double>> values) {
  Value::List list;
  for (const auto& row : values) list.push_back(numbers(row));
  return list;
}

Value whole(std::initializer_list<int> values) {
  Value::List list;
  for (const int v : values) list.emplace_back(v);
  return list;
}

Value per_criterion(std::initializer_list<double> values) {
  Value::Map map;
  int k = 0;
  for (const double v : values) {
    const int number = ++k;
    map.emplace_back((number < 10 ? "e0" : "e") + std::to_string(number), v);
  }
  return map;
}

void describe_rows(Source& source) {
  const auto diagnosis = [](auto& f) {
    f.input(&Diagnosis::defect_rejected, "tp", "tp", "1", non_negative(), "defective objects rejected", 46)
        .input(&Diagnosis::defect_accepted, "fn", "fn", "1", non_negative(), "defective objects accepted", 4)
        .input(&Diagnosis::good_rejected, "fp", "fp", "1", non_negative(), "good objects rejected", 19)
        .input(&Diagnosis::good_accepted, "tn", "tn", "1", non_negative(), "good objects accepted", 931);
  };
  source
      .function<&criterion_information_ratio>("criterion_information_ratio",
                                              "Information obtained by the diagnosis over that needed.",
                                              "Table 1, row 1", Provenance::completion)
      .with(diagnosis)
      .output(&InformationRatio::needed_bit, "i_needed_bit", "I_n", "bit", non_negative(),
              "entropy of the true state")
      .output(&InformationRatio::obtained_bit, "i_obtained_bit", "I_p", "bit", non_negative(),
              "mutual information of state and diagnosis")
      .output(&InformationRatio::efficiency, "e", "E_1", "1", probability(), "criterion 1, to be large")
      .note("Blind to the sign: a diagnosis that is always wrong also gives 1.")
      .note("The paper prints E = I_p / I_n; the meanings of I_p and I_n are a completion.");
  source
      .function<&criterion_generalized_ratio>("criterion_generalized_ratio",
                                              "Actual over required value of a quality index.",
                                              "Table 1, row 2", Provenance::completion)
      .input(&QualityIndex::actual, "k_actual", "K_p", "1", probability(), "actual value", 0.92)
      .input(&QualityIndex::required, "k_required", "K_n", "1", open_low(0, 1), "required value", 0.98)
      .output(&Efficiency::efficiency, "e", "E_2", "1", non_negative(), "criterion 2, to be large");
  source
      .function<&criterion_yield_ratio>("criterion_yield_ratio",
                                        "Share of the good output that survives the diagnosis.",
                                        "Table 1, row 2", Provenance::completion)
      .input(&GoodParts::good_rejected, "fp", "fp", "1", non_negative(), "good objects rejected", 19)
      .input(&GoodParts::good_accepted, "tn", "tn", "1", non_negative(), "good objects accepted", 931)
      .output(&Efficiency::efficiency, "e", "E_2", "1", probability(), "criterion 2, to be large");
  source
      .function<&criterion_cost_per_conforming>("criterion_cost_per_conforming",
                                                "Cost over the probability that a released part conforms.",
                                                "Table 1, row 3", Provenance::completion)
      .input(&ConformingCost::cost_cu, "cost_cu", "C", "cu", non_negative(), "cost", 12.9)
      .input(&ConformingCost::p_conforming, "p_conforming", "p'", "1", open_low(0, 1),
             "probability that a released part conforms", 0.9957)
      .output(&Cost::cost_cu, "e_cu", "E_3", "cu", non_negative(), "criterion 3, to be small");
  source
      .function<&criterion_inspection_set>("criterion_inspection_set",
                                           "Cost over the share of parts that do not escape with a defect.",
                                           "Table 1, row 4", Provenance::repaired)
      .input(&InspectionSet::cost_cu, "cost_cu", "C", "cu", non_negative(), "cost", 12.9)
      .input(&InspectionSet::defective_share, "q0", "q_0", "1", open_high(0, 1),
             "probability that a part is defective", 0.05)
      .input(&InspectionSet::detection_probability, "detection_probability", "P_i", "1", probability(),
             "probability to detect a defect of the type", numbers({0.96, 0.87, 0.8}))
      .length(1, 100'000)
      .input(&InspectionSet::defect_share, "defect_share", "q_i", "1", probability(),
             "share of the type among the defects, sum at most 1", numbers({0.6, 0.3, 0.1}))
      .length(1, 100'000)
      .output(&InspectionCost::escape_probability, "escape_probability", "-", "1", probability(),
              "probability that a part leaves with an undetected defect")
      .output(&InspectionCost::efficiency_cu, "e_cu", "E_4", "cu", non_negative(), "criterion 4, to be small")
      .note("Rejected parts count as good, so the criterion favours cheap detection; add the scrap cost.");
  source
      .function<&optimal_inspection_set>("optimal_inspection_set",
                                         "Set of inspection operations with the least criterion 4.",
                                         "Table 1, row 4", Provenance::completion)
      .input(&InspectionChoice::base_cost_cu, "base_cost_cu", "C_0", "cu", non_negative(),
             "cost without inspection", 20.0)
      .input(&InspectionChoice::defective_share, "q0", "q_0", "1", open_high(0, 1),
             "probability that a part is defective", 0.08)
      .input(&InspectionChoice::defect_share, "defect_share", "q_i", "1", probability(),
             "share of the type among the defects, sum at most 1", numbers({0.5, 0.3, 0.2}))
      .length(1, 1000)
      .input(&InspectionChoice::operation_cost_cu, "operation_cost_cu", "c_k", "cu", non_negative(),
             "cost of each operation", numbers({0.2, 0.5, 0.15, 1.2}))
      .length(1, 1000)
      .input(&InspectionChoice::detection, "detection", "d_ki", "1", probability(),
             "one list per operation: probability to detect each defect type",
             rows({{0.9, 0, 0}, {0.3, 0.9, 0}, {0, 0.4, 0.5}, {0.95, 0.95, 0.95}}))
      .length(1, 1000)
      .output(&InspectionOptimum::operations, "operations", "x", "-", at_least(0),
              "chosen operations, ascending")
      .output(&InspectionOptimum::efficiency_cu, "e_cu", "E_4", "cu", non_negative(), "criterion 4")
      .output(&InspectionOptimum::escape_probability, "escape_probability", "-", "1", probability(),
              "probability that a part leaves with an undetected defect")
      .output(&InspectionOptimum::cost_cu, "cost_cu", "C", "cu", non_negative(), "cost with inspection")
      .note("Operations detect independently: P_i = 1 - prod (1 - d_ki).")
      .note("Every subset up to 20 operations; above, single additions and removals from the empty set.");
  source
      .function<&criterion_information_per_cost>("criterion_information_per_cost",
                                                 "Information per unit of generalized cost.",
                                                 "Table 1, row 5", Provenance::completion)
      .input(&InformationCost::information_bit, "information_bit", "I", "bit", non_negative(), "information",
             200.0)
      .input(&InformationCost::cost_cu, "cost_cu", "C", "cu", non_negative(), "cost of the equipment", 900.0)
      .optional(&InformationCost::cost_ref_cu, "cost_ref_cu", "C_ref", "cu", positive(), "reference cost")
      .optional(&InformationCost::mass_kg, "mass_kg", "m", "kg", non_negative(), "mass of the equipment")
      .optional(&InformationCost::mass_ref_kg, "mass_ref_kg", "m_ref", "kg", positive(), "reference mass")
      .optional(&InformationCost::complexity, "complexity", "k", "1", non_negative(), "complexity")
      .optional(&InformationCost::complexity_ref, "complexity_ref", "k_ref", "1", positive(),
                "reference complexity")
      .optional(&InformationCost::weight_cost, "w_cost", "w_c", "1", non_negative(), "weight of the cost")
      .optional(&InformationCost::weight_mass, "w_mass", "w_m", "1", non_negative(), "weight of the mass")
      .optional(&InformationCost::weight_complexity, "w_complexity", "w_k", "1", non_negative(),
                "weight of the complexity")
      .output(&InformationPerCost::generalized_cost, "generalized_cost", "-", "1", positive(),
              "generalized cost")
      .output(&InformationPerCost::efficiency_bit, "e", "E_5", "bit", non_negative(),
              "criterion 5, to be large");
  source
      .function<&criterion_socio_ergonomic>("criterion_socio_ergonomic",
                                            "Technical, social and economic value combined.",
                                            "Table 1, row 6", Provenance::completion)
      .input(&SocioErgonomic::technical, "e_technical", "E_T", "1", non_negative(), "technical value", 0.8)
      .input(&SocioErgonomic::social, "e_social", "E_S", "1", non_negative(), "social value", 0.45)
      .input(&SocioErgonomic::economic, "e_economic", "E_W", "1", non_negative(), "economic value", 0.23)
      .optional(&SocioErgonomic::weights, "weights", "w", "1", non_negative(),
                "weights of the three values, sum above 0")
      .length(3, 3)
      .optional(&SocioErgonomic::form, "form", "f", "-", no_range(), "how the values are combined")
      .output(&Efficiency::efficiency, "e", "E_6", "1", non_negative(), "criterion 6, to be large");
  source
      .function<&criterion_cost_per_reliability>("criterion_cost_per_reliability",
                                                 "Cost over the failure-free probability.", "Table 1, row 7",
                                                 Provenance::completion)
      .input(&MissionCost::cost_cu, "cost_cu", "C", "cu", non_negative(), "cost of a mission", 119.2)
      .input(&MissionCost::missions, "missions", "-", "1", positive(), "missions", 120)
      .input(&MissionCost::failure_free, "missions_failure_free", "-", "1", positive(),
             "missions without a failure, at most all", 111)
      .output(&CostPerReliability::p_failure_free, "p_failure_free", "p'", "1", probability(),
              "failure-free probability")
      .output(&CostPerReliability::efficiency_cu, "e_cu", "E_7", "cu", non_negative(),
              "criterion 7, to be small");
  source
      .function<&criterion_dynamic_information>("criterion_dynamic_information",
                                                "Actual over ideal rate of information.", "Table 1, row 8",
                                                Provenance::completion)
      .input(&InformationRates::obtained_bit, "i_obtained_bit", "I_p", "bit", non_negative(),
             "information obtained", 0.2)
      .input(&InformationRates::needed_bit, "i_needed_bit", "I_n", "bit", non_negative(),
             "information needed", 0.286)
      .input(&InformationRates::time_min, "time_min", "T", "min", positive(), "actual diagnosis time", 0.8)
      .input(&InformationRates::time_ideal_min, "time_ideal_min", "T_0", "min", positive(),
             "ideal diagnosis time", 0.5)
      .output(&DynamicInformation::actual_bit_min, "k_actual_bit_min", "K_I", "bit/min", non_negative(),
              "actual rate")
      .output(&DynamicInformation::ideal_bit_min, "k_ideal_bit_min", "K_IO", "bit/min", non_negative(),
              "ideal rate")
      .output(&DynamicInformation::efficiency, "e", "E_8", "1", non_negative(), "criterion 8, to be large");
  source
      .function<&criterion_economic>("criterion_economic", "Margin of the output over costs and losses.",
                                     "Table 1, row 9", Provenance::paper)
      .input(&Turnover::output_value_cu, "output_value_cu", "QJ", "cu", positive(), "value of the output",
             18620.0)
      .input(&Turnover::running_cost_cu, "running_cost_cu", "PR", "cu", non_negative(),
             "production and diagnosis cost", 12900.0)
      .input(&Turnover::losses_cu, "losses_cu", "PZ", "cu", non_negative(), "scrap, stoppages and rework",
             1400.0)
      .output(&Efficiency::efficiency, "e", "E_9", "1", at_most(1), "criterion 9, to be large");
  source
      .function<&criterion_effect_per_cost>("criterion_effect_per_cost", "Effect per cost.",
                                            "Table 1, row 10", Provenance::paper)
      .input(&EffectCost::effect, "effect", "D", "1", non_negative(), "effect", 0.977)
      .input(&EffectCost::cost_cu, "cost_cu", "C", "cu", positive(), "cost", 0.9)
      .output(&Efficiency::efficiency, "e", "E_10", "1/cu", non_negative(), "criterion 10, to be large");

  source
      .function<&evaluate_all_criteria>("evaluate_all_criteria",
                                        "All ten criteria of a simulation result; null where undefined.",
                                        "Table 1", Provenance::completion)
      .input(&SimulationResult::parts_started, "parts_started", "-", "1", positive(), "parts started", 1000)
      .with(diagnosis)
      .input(&SimulationResult::defects_by_type, "defects_by_type", "-", "1", non_negative(),
             "defects of each type", numbers({30, 15, 5}))
      .length(1, 100'000)
      .input(&SimulationResult::detected_by_type, "detected_by_type", "-", "1", non_negative(),
             "detected defects of each type, at most all", numbers({29, 13, 4}))
      .length(1, 100'000)
      .input(&SimulationResult::diagnosis_time_min, "diagnosis_time_min", "T", "min", non_negative(),
             "diagnosis time per object", 0.8)
      .input(&SimulationResult::diagnosis_time_ideal_min, "diagnosis_time_ideal_min", "T_0", "min",
             positive(), "ideal diagnosis time per object", 0.5)
      .input(&SimulationResult::production_cost_cu, "production_cost_cu", "-", "cu", non_negative(),
             "production cost", 12000.0)
      .input(&SimulationResult::diagnosis_cost_cu, "diagnosis_cost_cu", "-", "cu", non_negative(),
             "diagnosis cost", 900.0)
      .input(&SimulationResult::losses_cu, "losses_cu", "PZ", "cu", non_negative(),
             "scrap, stoppages and rework", 1400.0)
      .input(&SimulationResult::output_value_cu, "output_value_cu", "QJ", "cu", non_negative(),
             "price of the good accepted parts", 18620.0)
      .input(&SimulationResult::missions, "missions", "-", "1", positive(), "missions (shifts)", 120)
      .input(&SimulationResult::missions_failure_free, "missions_failure_free", "-", "1", non_negative(),
             "missions without a failure, at most all", 111)
      .input(&SimulationResult::availability, "availability", "-", "1", probability(), "availability", 0.91)
      .input(&SimulationResult::performance, "performance", "-", "1", probability(), "performance", 0.95)
      .input(&SimulationResult::quality, "quality", "-", "1", probability(), "quality", 0.931)
      .input(&SimulationResult::operator_load, "operator_load", "-", "1", non_negative(), "operator load",
             0.55)
      .input(&SimulationResult::operator_load_limit, "operator_load_limit", "-", "1", positive(),
             "largest operator load", 1.0)
      .output(&Criteria::e01, "e01", "E_1", "1", any(), "information ratio")
      .output(&Criteria::e02, "e02", "E_2", "1", any(), "yield ratio")
      .output(&Criteria::e03, "e03", "E_3", "cu", any(), "cost per conforming part")
      .output(&Criteria::e04, "e04", "E_4", "cu", any(), "cost per part without an escaped defect")
      .output(&Criteria::e05, "e05", "E_5", "bit/cu", any(), "information per cost")
      .output(&Criteria::e06, "e06", "E_6", "1", any(), "socio-ergonomic criterion")
      .output(&Criteria::e07, "e07", "E_7", "cu", any(), "cost per failure-free mission")
      .output(&Criteria::e08, "e08", "E_8", "1", any(), "dynamic information ratio")
      .output(&Criteria::e09, "e09", "E_9", "1", any(), "economic margin")
      .output(&Criteria::e10, "e10", "E_10", "1/cu", any(), "trustworthiness per diagnosis cost");
}

void describe_hierarchy(Source& source) {
  source
      .function<&normalize_criterion>("normalize_criterion", "Criterion scaled from worst 0 to best 1.",
                                      "hierarchy, level 1", Provenance::completion)
      .input(&CriterionBounds::value, "value", "E_k", "1", any(), "value of the criterion", 14.0)
      .input(&CriterionBounds::best, "best", "-", "1", any(), "best value; may be below the worst", 10.0)
      .input(&CriterionBounds::worst, "worst", "-", "1", any(), "worst value", 20.0)
      .output(&Normalized::share, "g", "g_k", "1", probability(), "normalized value");
  source
      .function<&aggregate_criteria>("aggregate_criteria", "Weighted partial criteria combined.", "hierarchy",
                                     Provenance::paper)
      .input(&Aggregate::values, "values", "E_k", "1", non_negative(), "partial criteria",
             numbers({0.4, 0.9, 0.6}))
      .length(1, 100'000)
      .optional(&Aggregate::weights, "weights", "w_k", "1", non_negative(),
                "weights, sum above 0; 1 each when left out")
      .length(1, 100'000)
      .input(&Aggregate::form, "form", "-", "-", no_range(), "how the values are combined", "additive")
      .output(&Efficiency::efficiency, "e", "E", "1", non_negative(), "combined criterion")
      .note("The form \"minimum\" (weakest link) is a completion.");
  source
      .function<&hierarchical_efficiency>("hierarchical_efficiency",
                                          "Criteria combined in groups and groups in one value, with limits.",
                                          "hierarchy", Provenance::completion)
      .input(&Hierarchy::criteria, "criteria", "E_k", "1", no_range(),
             "criteria e01..e10; null or absent ones are left out",
             per_criterion({0.67, 0.98, 12.96, 12.95, 0.21, 0.44, 128.8, 0.42, 0.23, 1.09}))
      .input(&Hierarchy::best, "best", "-", "1", no_range(), "best value of every given criterion",
             per_criterion({1, 1, 10, 10, 1, 1, 60, 1, 0.5, 3}))
      .input(&Hierarchy::worst, "worst", "-", "1", no_range(), "worst value of every given criterion",
             per_criterion({0, 0.8, 20, 20, 0, 0, 300, 0, 0, 0}))
      .optional(&Hierarchy::local_weights, "local_weights", "w_k", "1", no_range(),
                "weight of a criterion in its group, 1 where left out")
      .optional(&Hierarchy::group_weights, "group_weights", "w_g", "1", no_range(),
                "weight of a group, 1 where left out")
      .optional(&Hierarchy::local_form, "local_form", "-", "-", no_range(), "how a group is combined")
      .optional(&Hierarchy::global_form, "global_form", "-", "-", no_range(), "how the groups are combined")
      .optional(&Hierarchy::minimum, "minimum", "-", "1", no_range(),
                "least normalized value of a criterion; none where left out")
      .output(&HierarchicalEfficiency::efficiency, "e", "E", "1", probability(), "global value")
      .output(&HierarchicalEfficiency::groups, "groups", "-", "1", no_range(),
              "values of the groups; groups without a weighted criterion are absent")
      .output(&HierarchicalEfficiency::feasible, "feasible", "-", "-", closed(0, 1), "all minima are met")
      .output(&HierarchicalEfficiency::violated, "violated", "-", "-", no_range(),
              "criteria that miss their minimum")
      .note("The grouping of the criteria is a proposal; the paper prints none.");
}

void describe_relaxation(Source& source) {
  const auto band = [](auto& f) {
    f.input(&TargetBand::required, "required", "x_0j", "1", any(), "required outputs", numbers({10, 5}))
        .length(1, 100'000);
  };
  const auto limits = [](auto& f) {
    f.input(&TargetBand::lower, "lower", "b_j", "1", any(), "lower bound of required - achieved, below upper",
            numbers({-1, -1}))
        .length(1, 100'000)
        .input(&TargetBand::upper, "upper", "c_j", "1", any(), "upper bound of required - achieved",
               numbers({1, 1}))
        .length(1, 100'000)
        .input(&TargetBand::scale, "scale", "-", "1", positive(), "scale of each target", numbers({10, 5}))
        .length(1, 100'000);
  };
  source
      .function<&target_match>("target_match", "How hard a criterion the achieved outputs meet.",
                               "hardness (I)-(III)", Provenance::completion)
      .with(band)
      .input(&TargetInputs::achieved, "achieved", "y_j", "1", any(), "achieved outputs", numbers({9.5, 5.2}))
      .length(1, 100'000)
      .with(limits)
      .output(&TargetMatch::level, "level", "-", "1", closed(1, 3),
              "1 exact, 2 inside the thresholds, 3 best approximation")
      .output(&TargetMatch::exact_count, "exact_count", "-", "1", at_least(0), "targets met exactly")
      .output(&TargetMatch::within_count, "within_count", "-", "1", at_least(0),
              "targets inside the thresholds")
      .output(&TargetMatch::overlap, "overlap", "-", "1", probability(),
              "share of targets inside the thresholds")
      .output(&TargetMatch::discrepancy, "discrepancy", "-", "1", non_negative(),
              "mean scaled distance from the targets");
  source
      .function<&select_by_relaxed_criterion>("select_by_relaxed_criterion",
                                              "Alternative that meets the hardest criterion.",
                                              "hardness (I)-(III)", Provenance::completion)
      .input(&Alternatives::alternatives, "alternatives", "Y", "1", any(),
             "achieved outputs of each alternative", rows({{9.5, 5.2}, {10.6, 4.6}, {8, 5}}))
      .length(1, 100'000)
      .with(band)
      .with(limits)
      .input(&Alternatives::efficiency, "efficiency", "E", "1", any(), "efficiency of each alternative",
             numbers({0.6, 0.7, 0.9}))
      .length(1, 100'000)
      .output(&Selection::level, "level", "-", "1", closed(1, 3), "hardest criterion that is met")
      .output(&Selection::index, "index", "-", "-", at_least(0), "chosen alternative")
      .output(&Selection::discrepancy, "discrepancy", "-", "1", non_negative(),
              "mean scaled distance from the targets");
  source
      .function<&goal_composition_feasible>("goal_composition_feasible",
                                            "States common to all required functions.", "non-empty set S_r",
                                            Provenance::completion)
      .input(&StateSets::sets, "state_sets", "-", "-", any(),
             "one set of state numbers per required function",
             Value::List{whole({1, 2, 3, 5}), whole({2, 3, 7}), whole({3, 2})})
      .length(1, 100'000)
      .output(&CommonStates::states, "states", "S_r", "-", any(), "common states, ascending")
      .output(&CommonStates::feasible, "feasible", "-", "-", closed(0, 1), "there is a common state");
  source
      .function<&efficiency_increments>("efficiency_increments",
                                        "Increments of the efficiency for one changed parameter each.",
                                        "research steps", Provenance::paper)
      .input(&Increments::efficiency_base, "efficiency_base", "E_0", "1", any(), "efficiency, not 0", 0.6)
      .input(&Increments::parameter_base, "parameter_base", "x_0", "1", any(), "parameters",
             numbers({200, 0.3}))
      .length(1, 100'000)
      .input(&Increments::efficiency_changed, "efficiency_changed", "E", "1", any(),
             "efficiency with one parameter changed", numbers({0.63, 0.58}))
      .length(1, 100'000)
      .input(&Increments::parameter_changed, "parameter_changed", "x", "1", any(),
             "changed parameters, each different from its base", numbers({210, 0.33}))
      .length(1, 100'000)
      .output(&Sensitivities::derivative, "derivative", "dE/dx", "1", any(), "derivatives")
      .output(&Sensitivities::elasticity, "elasticity", "-", "1", any(), "elasticities")
      .note("The elasticity is a completion.");
  source
      .function<&criteria_conflict>("criteria_conflict",
                                    "Rank correlation of the criteria, their winners and the Pareto set.",
                                    "introduction", Provenance::completion)
      .input(&CriteriaMatrix::matrix, "matrix", "-", "1", any(),
             "one list of criteria per alternative, larger is better",
             rows({{0.9, 0.2, 0.5}, {0.7, 0.6, 0.4}, {0.3, 0.9, 0.6}, {0.2, 0.5, 0.3}}))
      .length(1, most_alternatives)
      .output(&Conflict::tau, "tau", "tau_b", "1", closed(-1, 1), "Kendall tau-b between the criteria")
      .output(&Conflict::winners, "winners", "-", "-", at_least(0),
              "first best alternative of each criterion")
      .output(&Conflict::pareto, "pareto", "-", "-", at_least(0), "alternatives that none dominates");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K205",
       .title =
           "General hierarchical system of criteria for evaluating the efficiency of machining processes "
           "on machine-tool complexes",
       .authors = "Veselovska N. R.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Ten efficiency criteria of a machine-tool complex and its diagnosis, a hierarchy of weighted "
           "partial criteria of which some are limits, the choice of inspection operations, and the "
           "stepwise relaxation of a target from exact match over a tolerance band to best "
           "approximation.",
       .role = "criteria",
       .errata = {
           "Table 1, row 4 is printed with two different indices and a star; one index per defect type "
           "and a product are meant.",
           "The tolerance band is printed with \"Y subset X_0\", which does not describe it; the "
           "inequality is the definition."}});
  describe_rows(source);
  describe_hierarchy(source);
  describe_relaxation(source);
}

}  // namespace verstat::models::k205
