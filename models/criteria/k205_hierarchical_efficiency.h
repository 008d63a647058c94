#pragma once
// Efficiency criteria of a machine-tool complex and of its inspection (K205): the ten criteria of the
// published table, their normalization and combination in a hierarchy with limits, the choice of inspection
// operations, and the relaxation of a target from exact match over a tolerance band to best approximation.
//
// Veselovska 2011. The table prints letters without definitions; the meanings are those of the card
// (Shannon information, OEE, profit margin, mission reliability). Counts may be expected values, so they need
// not be whole. Money in cu; all indices are zero-based; flags are 0 or 1.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k205 {

enum class Form { additive, multiplicative, minimum };

struct Diagnosis {
  double defect_rejected = 0;
  double defect_accepted = 0;
  double good_rejected = 0;
  double good_accepted = 0;
};
struct InformationRatio {
  double needed_bit;
  double obtained_bit;
  double efficiency;
};
/// Criterion 1: information that the diagnosis gives about the state of the object over the entropy of that
/// state; 1 when the state is certain. Counts >= 0, at least one object. Blind to the sign: a diagnosis that
/// is always wrong also gives 1.
[[nodiscard]] InformationRatio criterion_information_ratio(const Diagnosis& in);

struct QualityIndex {
  double actual = 0;
  double required = 0;
};
struct Efficiency {
  double efficiency;
};
/// Criterion 2: actual over required value of a probability-like quality index.
[[nodiscard]] Efficiency criterion_generalized_ratio(const QualityIndex& in);

struct GoodParts {
  double good_rejected = 0;
  double good_accepted = 0;
};
/// Criterion 2, yield form: share of the good output that survives the diagnosis, tn / (tn + fp).
[[nodiscard]] Efficiency criterion_yield_ratio(const GoodParts& in);

struct ConformingCost {
  double cost_cu = 0;
  double p_conforming = 0;
};
struct Cost {
  double cost_cu;
};
/// Criterion 3: cost over the probability that a released part conforms, C / p'.
[[nodiscard]] Cost criterion_cost_per_conforming(const ConformingCost& in);

struct InspectionSet {
  double cost_cu = 0;
  double defective_share = 0;
  std::vector<double> detection_probability;  // per defect type
  std::vector<double> defect_share;
};
struct InspectionCost {
  double escape_probability;
  double efficiency_cu;
};
/// Criterion 4: C / (1 - q_0 sum (1 - P_i) q_i). Repaired: printed with two different indices.
[[nodiscard]] InspectionCost criterion_inspection_set(const InspectionSet& in);

struct InspectionChoice {
  double base_cost_cu = 0;
  double defective_share = 0;
  std::vector<double> defect_share;
  std::vector<double> operation_cost_cu;
  std::vector<std::vector<double>> detection;  // [operation][defect type]
};
struct InspectionOptimum {
  std::vector<std::int64_t> operations;
  double efficiency_cu;
  double escape_probability;
  double cost_cu;
};
/// Set of inspection operations with the least criterion 4, P_i = 1 - prod (1 - d_ki). Up to 20 operations
/// every subset is tried; ties within 1e-12 go to fewer operations, then to lexicographic order. Above 20 the
/// best single addition or removal is taken from the empty set until none improves. COMPLETION (product rule,
/// search).
[[nodiscard]] InspectionOptimum optimal_inspection_set(const InspectionChoice& in);

struct InformationCost {
  double information_bit = 0;
  double cost_cu = 0;
  double cost_ref_cu = 1;
  double mass_kg = 0;
  double mass_ref_kg = 1;
  double complexity = 0;
  double complexity_ref = 1;
  double weight_cost = 1;
  double weight_mass = 0;
  double weight_complexity = 0;
};
struct InformationPerCost {
  double generalized_cost;
  double efficiency_bit;
};
/// Criterion 5: information per unit of generalized cost w_c C / C_ref + w_m m / m_ref + w_k k / k_ref.
[[nodiscard]] InformationPerCost criterion_information_per_cost(const InformationCost& in);

struct SocioErgonomic {
  double technical = 0;
  double social = 0;
  double economic = 0;
  std::vector<double> weights{1, 1, 1};
  Form form = Form::multiplicative;
};
/// Criterion 6: f(E_T, E_S, E_W), f one of the forms of aggregate_criteria.
[[nodiscard]] Efficiency criterion_socio_ergonomic(const SocioErgonomic& in);

struct MissionCost {
  double cost_cu = 0;
  double missions = 0;
  double failure_free = 0;
};
struct CostPerReliability {
  double p_failure_free;
  double efficiency_cu;
};
/// Criterion 7: cost over the failure-free probability of a mission.
[[nodiscard]] CostPerReliability criterion_cost_per_reliability(const MissionCost& in);

struct InformationRates {
  double obtained_bit = 0;
  double needed_bit = 0;
  double time_min = 0;
  double time_ideal_min = 0;
};
struct DynamicInformation {
  double actual_bit_min;
  double ideal_bit_min;
  double efficiency;
};
/// Criterion 8: actual over ideal rate of information, (I_p / I_n) (T_0 / T), with I_p / I_n = 1 for I_n = 0.
[[nodiscard]] DynamicInformation criterion_dynamic_information(const InformationRates& in);

struct Turnover {
  double output_value_cu = 0;
  double running_cost_cu = 0;
  double losses_cu = 0;
};
/// Criterion 9: (QJ - (PR + PZ)) / QJ; negative when costs exceed the output.
[[nodiscard]] Efficiency criterion_economic(const Turnover& in);

struct EffectCost {
  double effect = 0;
  double cost_cu = 0;
};
/// Criterion 10: effect per cost, D / C.
[[nodiscard]] Efficiency criterion_effect_per_cost(const EffectCost& in);

/// Values of the ten criteria, or of something per criterion; empty where it is not defined.
struct PerCriterion {
  static constexpr std::size_t count = 10;
  using Values = std::array<std::optional<double>, count>;
  Values values() const { return {e01, e02, e03, e04, e05, e06, e07, e08, e09, e10}; }
  void set(const Values& values) {
    const std::array members = {&e01, &e02, &e03, &e04, &e05, &e06, &e07, &e08, &e09, &e10};
    for (std::size_t k = 0; k < count; ++k) *members[k] = values[k];
  }
  std::optional<double> e01, e02, e03, e04, e05, e06, e07, e08, e09, e10;
};
// Types of their own, so that each is described in its own words.
struct Criteria : PerCriterion {};
struct Bests : PerCriterion {};
struct Worsts : PerCriterion {};
struct LocalWeights : PerCriterion {};
struct Minima : PerCriterion {};

struct SimulationResult : Diagnosis {
  double parts_started = 0;
  std::vector<double> defects_by_type;
  std::vector<double> detected_by_type;
  double diagnosis_time_min = 0;
  double diagnosis_time_ideal_min = 0;
  double production_cost_cu = 0;
  double diagnosis_cost_cu = 0;
  double losses_cu = 0;
  double output_value_cu = 0;
  double missions = 0;
  double missions_failure_free = 0;
  double availability = 0;
  double performance = 0;
  double quality = 0;
  double operator_load = 0;
  double operator_load_limit = 1;
};
/// All ten criteria of a simulation result; a criterion whose denominator is zero in this run is empty.
/// Meanings of the letters: COMPLETION.
[[nodiscard]] Criteria evaluate_all_criteria(const SimulationResult& in);

struct CriterionBounds {
  double value = 0;
  double best = 1;
  double worst = 0;
};
struct Normalized {
  double share;
};
/// (value - worst) / (best - worst) clipped to 0..1; best may be below worst (cost criteria). COMPLETION.
[[nodiscard]] Normalized normalize_criterion(const CriterionBounds& in);

struct Aggregate {
  std::vector<double> values;
  std::optional<std::vector<double>> weights;  // 1 each when left out
  Form form = Form::additive;
};
/// Additive sum w E, multiplicative prod E^w or minimum, weights rescaled to sum 1; a value of weight 0 is
/// left out in every form. Values >= 0.
[[nodiscard]] Efficiency aggregate_criteria(const Aggregate& in);

struct GroupWeights {
  double information = 1;
  double inspection_cost = 1;
  double reliability = 1;
  double economy = 1;
  double socio_ergonomic = 1;
};
struct Hierarchy {
  Criteria criteria;
  Bests best;
  Worsts worst;
  LocalWeights local_weights;  // 1 where left out
  GroupWeights group_weights;
  Form local_form = Form::additive;
  Form global_form = Form::multiplicative;
  Minima minimum;
};
/// Values of the groups; a group without a weighted criterion is left out.
struct Groups {
  std::optional<double> information, inspection_cost, reliability, economy, socio_ergonomic;
};
struct HierarchicalEfficiency {
  double efficiency;
  Groups groups;
  int feasible;
  std::vector<std::string> violated;
};
/// Normalized criteria combined into groups and groups into one value. A normalized criterion below its
/// minimum, or a minimum for a criterion that is left out, makes the result infeasible; the value stays.
[[nodiscard]] HierarchicalEfficiency hierarchical_efficiency(const Hierarchy& in);

struct TargetBand {
  std::vector<double> required;
  std::vector<double> lower;
  std::vector<double> upper;
  std::vector<double> scale;
};
struct TargetInputs : TargetBand {
  std::vector<double> achieved;
};
struct TargetMatch {
  int level;
  std::int64_t exact_count;
  std::int64_t within_count;
  double overlap;
  double discrepancy;
};
/// Hardness of the criterion that is met: 1 exact, 2 lower < required - achieved < upper for all targets,
/// 3 best approximation. Discrepancy: mean of |required - achieved| / scale.
[[nodiscard]] TargetMatch target_match(const TargetInputs& in);

struct Alternatives : TargetBand {
  std::vector<std::vector<double>> alternatives;
  std::vector<double> efficiency;
};
struct Selection {
  int level;
  std::int64_t index;
  double discrepancy;
};
/// Alternative that meets the hardest criterion: the highest efficiency within levels 1 and 2 (first on
/// ties); at level 3 the least discrepancy (rounded to 12 decimals), then most targets within the thresholds,
/// then the first. COMPLETION (tie rules).
[[nodiscard]] Selection select_by_relaxed_criterion(const Alternatives& in);

struct StateSets {
  std::vector<std::vector<std::int64_t>> sets;
};
struct CommonStates {
  std::vector<std::int64_t> states;
  int feasible;
};
/// States common to all required functions, ascending; infeasible when there is none.
[[nodiscard]] CommonStates goal_composition_feasible(const StateSets& in);

struct Increments {
  double efficiency_base = 0;
  std::vector<double> parameter_base;
  std::vector<double> efficiency_changed;
  std::vector<double> parameter_changed;
};
struct Sensitivities {
  std::vector<double> derivative;
  std::vector<double> elasticity;
};
/// Derivative (E - E_0) / (x - x_0) and elasticity (times x_0 / E_0) of one changed parameter per entry.
[[nodiscard]] Sensitivities efficiency_increments(const Increments& in);

struct CriteriaMatrix {
  std::vector<std::vector<double>> matrix;  // [alternative][criterion], larger is better
};
struct Conflict {
  std::vector<std::vector<double>> tau;
  std::vector<std::int64_t> winners;
  std::vector<std::int64_t> pareto;
};
/// Kendall tau-b between the criteria (0 against a constant criterion, 1 on the diagonal), the first best
/// alternative of each, and the Pareto set (equal alternatives are all kept). COMPLETION.
[[nodiscard]] Conflict criteria_conflict(const CriteriaMatrix& in);

}  // namespace verstat::models::k205

template <>
struct verstat::models::EnumNames<verstat::models::k205::Form> {
  static constexpr std::array names{std::pair{k205::Form::additive, "additive"},
                                    std::pair{k205::Form::multiplicative, "multiplicative"},
                                    std::pair{k205::Form::minimum, "minimum"}};
};

namespace verstat::models::k205 {

/// Description of e01..e10 as members of S, all optional.
template <class S>
std::vector<Field> per_criterion_fields(Range range, const std::string& meaning) {
  using P = std::optional<double> PerCriterion::*;
  const std::array<std::pair<const char*, P>, PerCriterion::count> members{{{"e01", &PerCriterion::e01},
                                                                            {"e02", &PerCriterion::e02},
                                                                            {"e03", &PerCriterion::e03},
                                                                            {"e04", &PerCriterion::e04},
                                                                            {"e05", &PerCriterion::e05},
                                                                            {"e06", &PerCriterion::e06},
                                                                            {"e07", &PerCriterion::e07},
                                                                            {"e08", &PerCriterion::e08},
                                                                            {"e09", &PerCriterion::e09},
                                                                            {"e10", &PerCriterion::e10}}};
  std::vector<Field> fields;
  for (const auto& [name, pointer] : members)
    fields.push_back(member<S>(pointer, name, "-", "1", range, meaning + " " + name, false));
  return fields;
}

}  // namespace verstat::models::k205

template <>
struct verstat::models::StructFields<verstat::models::k205::Criteria> {
  static std::vector<Field> fields() { return k205::per_criterion_fields<k205::Criteria>(any(), "value of"); }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::Bests> {
  static std::vector<Field> fields() {
    return k205::per_criterion_fields<k205::Bests>(any(), "best value of");
  }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::Worsts> {
  static std::vector<Field> fields() {
    return k205::per_criterion_fields<k205::Worsts>(any(), "worst value of");
  }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::LocalWeights> {
  static std::vector<Field> fields() {
    return k205::per_criterion_fields<k205::LocalWeights>(non_negative(), "local weight of");
  }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::Minima> {
  static std::vector<Field> fields() {
    return k205::per_criterion_fields<k205::Minima>(any(), "least normalized value of");
  }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::GroupWeights> {
  static std::vector<Field> fields() {
    using G = k205::GroupWeights;
    const auto weight = [](double G::*pointer, const char* name) {
      return member<G>(pointer, name, "w", "1", non_negative(), std::string("weight of the group ") + name,
                       false);
    };
    return {weight(&G::information, "information"), weight(&G::inspection_cost, "inspection_cost"),
            weight(&G::reliability, "reliability"), weight(&G::economy, "economy"),
            weight(&G::socio_ergonomic, "socio_ergonomic")};
  }
};
template <>
struct verstat::models::StructFields<verstat::models::k205::Groups> {
  static std::vector<Field> fields() {
    using G = k205::Groups;
    const auto value = [](std::optional<double> G::*pointer, const char* name) {
      return member<G>(pointer, name, "E", "1", non_negative(), std::string("value of the group ") + name,
                       false);
    };
    return {value(&G::information, "information"), value(&G::inspection_cost, "inspection_cost"),
            value(&G::reliability, "reliability"), value(&G::economy, "economy"),
            value(&G::socio_ergonomic, "socio_ergonomic")};
  }
};

namespace verstat::models::detail {

/// Groups that were left out are absent from the output, not null.
template <>
struct Binding<k205::Groups> {
  static const std::vector<Field>& fields() {
    static const std::vector<Field> all = StructFields<k205::Groups>::fields();
    return all;
  }
  static void read(k205::Groups& to, const Value& v, const Field& f) {
    within(f, [&] { read_fields(&to, fields(), v); });
  }
  static Value write(const k205::Groups& x) {
    Value::Map present;
    for (const Field& field : fields())
      if (Value value = field.access->write(&x); !value.is_null())
        present.emplace_back(field.name, std::move(value));
    return present;
  }
  static void check(const k205::Groups& x, const Field& f) {
    within(f, [&] { check_fields(&x, fields()); });
  }
  static bool finite(const k205::Groups& x) {
    for (const Field& field : fields())
      if (!field.access->finite(&x)) return false;
    return true;
  }
  static TypeInfo type() { return {.kind = TypeInfo::Kind::structure, .fields = &fields()}; }
};

}  // namespace verstat::models::detail
