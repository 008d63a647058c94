#include "models/criteria/k205_hierarchical_efficiency.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace verstat::models::k205 {
namespace {

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

void require_same_length(std::size_t length, std::string_view input, std::size_t expected,
                         std::string_view other) {
  if (length == expected) return;
  throw DomainError(std::string(input), fmt::format("{} has {} entries, must have as many as {}, that is {}",
                                                    input, length, other, expected));
}

double entropy_term(double count, double total) {
  if (count <= 0) return 0;
  const double p = count / total;
  return -p * std::log2(p);
}

InformationRatio information(const Diagnosis& d) {
  const double objects = d.defect_rejected + d.defect_accepted + d.good_rejected + d.good_accepted;
  if (!(objects > 0)) reject("tp + fn + fp + tn = 0, at least one object must be diagnosed");
  const double needed = entropy_term(d.defect_rejected + d.defect_accepted, objects) +
                        entropy_term(d.good_rejected + d.good_accepted, objects);
  const auto given = [&](double defective, double good) {
    const double diagnosed = defective + good;
    return diagnosed / objects * (entropy_term(defective, diagnosed) + entropy_term(good, diagnosed));
  };
  const double left = given(d.defect_rejected, d.good_rejected) + given(d.defect_accepted, d.good_accepted);
  const double obtained = std::max(0.0, needed - left);
  return {needed, obtained, needed > 0 ? obtained / needed : 1};
}

void require_shares(const std::vector<double>& shares) {
  const double total = sum(shares);
  if (total > 1 + 1e-9)
    throw DomainError("defect_share", fmt::format("defect_share sums to {}, must not exceed 1", total));
}

// Escape probability q_0 sum (1 - P_i) q_i.
template <class Missed>
double escape(double defective_share, const std::vector<double>& shares, Missed&& missed) {
  double undetected = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) undetected += missed(i) * shares[i];
  return defective_share * undetected;
}

double per_surviving(double cost_cu, double escape_probability) {
  if (!(escape_probability < 1)) reject("every part escapes with a defect: the criterion is not defined");
  return cost_cu / (1 - escape_probability);
}

double normalized(const CriterionBounds& b) {
  return std::clamp((b.value - b.worst) / (b.best - b.worst), 0.0, 1.0);
}

// Weights need not sum to 1; empty when none is positive.
std::optional<double> combine(const std::vector<double>& values, const std::vector<double>& weights,
                              Form form) {
  const double total = sum(weights);
  if (!(total > 0)) return std::nullopt;
  double additive = 0;
  double product = 1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!(weights[k] > 0)) continue;
    const double w = weights[k] / total;
    additive += w * values[k];
    product *= std::pow(values[k], w);
    least = std::min(least, values[k]);
  }
  switch (form) {
    case Form::additive:
      return additive;
    case Form::multiplicative:
      return product;
    case Form::minimum:
      return least;
  }
  return std::nullopt;
}

constexpr std::array<const char*, PerCriterion::count> criterion_names{"e01", "e02", "e03", "e04", "e05",
                                                                       "e06", "e07", "e08", "e09", "e10"};
constexpr std::size_t group_count = 5;
// Group of each criterion, in the order of GroupWeights: information {1, 2, 8}, inspection cost
// {3, 4, 5, 10}, reliability {7}, economy {9}, socio-ergonomic {6}. The paper does not print a grouping.
constexpr std::array<std::size_t, PerCriterion::count> group_of{0, 0, 1, 1, 1, 4, 2, 0, 3, 1};

TargetMatch match(const TargetBand& band, const std::vector<double>& achieved) {
  TargetMatch out{3, 0, 0, 0, 0};
  const std::size_t targets = band.required.size();
  for (std::size_t k = 0; k < targets; ++k) {
    const double gap = band.required[k] - achieved[k];
    if (gap == 0) ++out.exact_count;
    if (band.lower[k] < gap && gap < band.upper[k]) ++out.within_count;
    out.discrepancy += std::abs(gap) / band.scale[k];
  }
  out.overlap = static_cast<double>(out.within_count) / static_cast<double>(targets);
  out.discrepancy /= static_cast<double>(targets);
  const auto all = static_cast<std::int64_t>(targets);
  if (out.exact_count == all)
    out.level = 1;
  else if (out.within_count == all)
    out.level = 2;
  return out;
}

void require_band(const TargetBand& band) {
  const std::size_t targets = band.required.size();
  require_same_length(band.lower.size(), "lower", targets, "required");
  require_same_length(band.upper.size(), "upper", targets, "required");
  require_same_length(band.scale.size(), "scale", targets, "required");
  for (std::size_t k = 0; k < targets; ++k)
    require(band.lower[k] < band.upper[k], fmt::format("lower/{}", k), band.lower[k], "must be below upper");
}

}  // namespace

InformationRatio criterion_information_ratio(const Diagnosis& in) {
  return guarded<&criterion_information_ratio>(in, [&] { return information(in); });
}

Efficiency criterion_generalized_ratio(const QualityIndex& in) {
  return guarded<&criterion_generalized_ratio>(in, [&] { return Efficiency{in.actual / in.required}; });
}

Efficiency criterion_yield_ratio(const GoodParts& in) {
  return guarded<&criterion_yield_ratio>(in, [&] {
    const double good = in.good_accepted + in.good_rejected;
    if (!(good > 0)) reject("fp + tn = 0, there must be a good part");
    return Efficiency{in.good_accepted / good};
  });
}

Cost criterion_cost_per_conforming(const ConformingCost& in) {
  return guarded<&criterion_cost_per_conforming>(in, [&] { return Cost{in.cost_cu / in.p_conforming}; });
}

InspectionCost criterion_inspection_set(const InspectionSet& in) {
  return guarded<&criterion_inspection_set>(in, [&] {
    require_same_length(in.detection_probability.size(), "detection_probability", in.defect_share.size(),
                        "defect_share");
    require_shares(in.defect_share);
    const double escaped = escape(in.defective_share, in.defect_share,
                                  [&](std::size_t i) { return 1 - in.detection_probability[i]; });
    return InspectionCost{escaped, per_surviving(in.cost_cu, escaped)};
  });
}

InformationPerCost criterion_information_per_cost(const InformationCost& in) {
  return guarded<&criterion_information_per_cost>(in, [&] {
    if (!(in.weight_cost + in.weight_mass + in.weight_complexity > 0))
      reject("w_cost + w_mass + w_complexity = 0, one weight must be positive");
    const double generalized = in.weight_cost * in.cost_cu / in.cost_ref_cu +
                               in.weight_mass * in.mass_kg / in.mass_ref_kg +
                               in.weight_complexity * in.complexity / in.complexity_ref;
    if (!(generalized > 0)) reject("the generalized cost is 0, it must be positive");
    return InformationPerCost{generalized, in.information_bit / generalized};
  });
}

Efficiency criterion_socio_ergonomic(const SocioErgonomic& in) {
  return guarded<&criterion_socio_ergonomic>(in, [&] {
    const auto value = combine({in.technical, in.social, in.economic}, in.weights, in.form);
    if (!value) reject("weights sum to 0, one weight must be positive");
    return Efficiency{*value};
  });
}

CostPerReliability criterion_cost_per_reliability(const MissionCost& in) {
  return guarded<&criterion_cost_per_reliability>(in, [&] {
    require(in.failure_free <= in.missions, "missions_failure_free", in.failure_free,
            "must not exceed missions");
    const double p = in.failure_free / in.missions;
    return CostPerReliability{p, in.cost_cu / p};
  });
}

DynamicInformation criterion_dynamic_information(const InformationRates& in) {
  return guarded<&criterion_dynamic_information>(in, [&] {
    const double ratio = in.needed_bit > 0 ? in.obtained_bit / in.needed_bit : 1;
    return DynamicInformation{in.obtained_bit / in.time_min, in.needed_bit / in.time_ideal_min,
                              ratio * in.time_ideal_min / in.time_min};
  });
}

Efficiency criterion_economic(const Turnover& in) {
  return guarded<&criterion_economic>(in, [&] {
    return Efficiency{(in.output_value_cu - (in.running_cost_cu + in.losses_cu)) / in.output_value_cu};
  });
}

Efficiency criterion_effect_per_cost(const EffectCost& in) {
  return guarded<&criterion_effect_per_cost>(in, [&] { return Efficiency{in.effect / in.cost_cu}; });
}

Criteria evaluate_all_criteria(const SimulationResult& in) {
  return guarded<&evaluate_all_criteria>(in, [&] {
    require_same_length(in.detected_by_type.size(), "detected_by_type", in.defects_by_type.size(),
                        "defects_by_type");
    for (std::size_t i = 0; i < in.defects_by_type.size(); ++i)
      require(in.detected_by_type[i] <= in.defects_by_type[i], fmt::format("detected_by_type/{}", i),
              in.detected_by_type[i], "must not exceed the defects of the type");
    require(in.missions_failure_free <= in.missions, "missions_failure_free", in.missions_failure_free,
            "must not exceed missions");
    const InformationRatio info = information(in);
    const double objects = in.defect_rejected + in.defect_accepted + in.good_rejected + in.good_accepted;
    const double defects = sum(in.defects_by_type);
    if (defects > objects)
      throw DomainError("defects_by_type",
                        fmt::format("defects_by_type sums to {}, must not exceed the {} objects diagnosed",
                                    defects, objects));
    const double good = in.good_accepted + in.good_rejected;
    const double released = in.good_accepted + in.defect_accepted;
    const double running_cu = in.production_cost_cu + in.diagnosis_cost_cu;
    const double part_cu = running_cu / in.parts_started;
    const bool diagnosis_paid = in.diagnosis_cost_cu > 0;

    Criteria out;
    out.e01 = info.efficiency;
    if (good > 0) out.e02 = in.good_accepted / good;
    if (released > 0 && in.good_accepted > 0) out.e03 = part_cu / (in.good_accepted / released);
    double undetected = 0;
    for (std::size_t i = 0; i < in.defects_by_type.size(); ++i)
      undetected += in.defects_by_type[i] - in.detected_by_type[i];
    if (undetected < objects) out.e04 = part_cu / (1 - undetected / objects);
    if (diagnosis_paid) out.e05 = info.obtained_bit * objects / in.diagnosis_cost_cu;
    if (in.output_value_cu > 0)
      out.e09 = (in.output_value_cu - (running_cu + in.losses_cu)) / in.output_value_cu;
    out.e06 = combine(
        {in.availability * in.performance * in.quality,
         std::max(0.0, 1 - in.operator_load / in.operator_load_limit), std::max(0.0, out.e09.value_or(0))},
        {1, 1, 1}, Form::multiplicative);
    if (in.missions_failure_free > 0)
      out.e07 = (running_cu + in.losses_cu) / in.missions / (in.missions_failure_free / in.missions);
    if (in.diagnosis_time_min > 0)
      out.e08 = info.efficiency * in.diagnosis_time_ideal_min / in.diagnosis_time_min;
    if (diagnosis_paid) out.e10 = (in.defect_rejected + in.good_accepted) / in.diagnosis_cost_cu;
    return out;
  });
}

Normalized normalize_criterion(const CriterionBounds& in) {
  return guarded<&normalize_criterion>(in, [&] {
    require(in.best != in.worst, "best", in.best, "must differ from worst");
    return Normalized{normalized(in)};
  });
}

Efficiency aggregate_criteria(const Aggregate& in) {
  return guarded<&aggregate_criteria>(in, [&] {
    const std::vector<double> weights = in.weights.value_or(std::vector<double>(in.values.size(), 1.0));
    require_same_length(weights.size(), "weights", in.values.size(), "values");
    const auto value = combine(in.values, weights, in.form);
    if (!value) reject("weights sum to 0, one weight must be positive");
    return Efficiency{*value};
  });
}

HierarchicalEfficiency hierarchical_efficiency(const Hierarchy& in) {
  return guarded<&hierarchical_efficiency>(in, [&] {
    const auto values = in.criteria.values();
    const auto bests = in.best.values();
    const auto worsts = in.worst.values();
    const auto weights = in.local_weights.values();
    const auto minima = in.minimum.values();
    std::array<std::vector<double>, group_count> shares;
    std::array<std::vector<double>, group_count> share_weights;
    HierarchicalEfficiency out{0, {}, 1, {}};
    for (std::size_t k = 0; k < PerCriterion::count; ++k) {
      const std::string name = criterion_names[k];
      std::optional<double> share;
      if (values[k]) {
        if (!bests[k])
          throw DomainError("best/" + name, "best/" + name + " is missing for a given criterion");
        if (!worsts[k])
          throw DomainError("worst/" + name, "worst/" + name + " is missing for a given criterion");
        require(*bests[k] != *worsts[k], "best/" + name, *bests[k], "must differ from worst/" + name);
        share = normalized({*values[k], *bests[k], *worsts[k]});
        shares[group_of[k]].push_back(*share);
        share_weights[group_of[k]].push_back(weights[k].value_or(1));
      }
      if (minima[k] && !(share && *share >= *minima[k])) out.violated.push_back(name);
    }
    out.feasible = out.violated.empty() ? 1 : 0;

    const std::array<std::optional<double> Groups::*, group_count> members{
        &Groups::information, &Groups::inspection_cost, &Groups::reliability, &Groups::economy,
        &Groups::socio_ergonomic};
    const GroupWeights& g = in.group_weights;
    const std::array<double, group_count> given{g.information, g.inspection_cost, g.reliability, g.economy,
                                                g.socio_ergonomic};
    std::vector<double> group_values;
    std::vector<double> group_weights;
    for (std::size_t k = 0; k < group_count; ++k) {
      const auto value = combine(shares[k], share_weights[k], in.local_form);
      if (!value) continue;
      out.groups.*members[k] = *value;
      group_values.push_back(*value);
      group_weights.push_back(given[k]);
    }
    const auto global = combine(group_values, group_weights, in.global_form);
    if (!global) reject("no weighted criterion with a value is left in a weighted group");
    out.efficiency = *global;
    return out;
  });
}

TargetMatch target_match(const TargetInputs& in) {
  return guarded<&target_match>(in, [&] {
    require_band(in);
    require_same_length(in.achieved.size(), "achieved", in.required.size(), "required");
    return match(in, in.achieved);
  });
}

Selection select_by_relaxed_criterion(const Alternatives& in) {
  return guarded<&select_by_relaxed_criterion>(in, [&] {
    require_band(in);
    require_same_length(in.efficiency.size(), "efficiency", in.alternatives.size(), "alternatives");
    std::vector<TargetMatch> matches;
    matches.reserve(in.alternatives.size());
    int level = 3;
    for (std::size_t k = 0; k < in.alternatives.size(); ++k) {
      require_same_length(in.alternatives[k].size(), fmt::format("alternatives/{}", k), in.required.size(),
                          "required");
      matches.push_back(match(in, in.alternatives[k]));
      level = std::min(level, matches.back().level);
    }
    const auto rounded = [](double discrepancy) { return std::round(discrepancy * 1e12); };
    const auto better = [&](std::size_t a, std::size_t b) {
      if (level < 3) return in.efficiency[a] > in.efficiency[b];
      const double gap_a = rounded(matches[a].discrepancy);
      const double gap_b = rounded(matches[b].discrepancy);
      if (gap_a != gap_b) return gap_a < gap_b;
      return matches[a].within_count > matches[b].within_count;
    };
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < matches.size(); ++k)
      if (matches[k].level == level && (!best || better(k, *best))) best = k;
    return Selection{level, static_cast<std::int64_t>(*best), matches[*best].discrepancy};
  });
}

CommonStates goal_composition_feasible(const StateSets& in) {
  return guarded<&goal_composition_feasible>(in, [&] {
    std::vector<std::int64_t> common = in.sets.front();
    std::sort(common.begin(), common.end());
    common.erase(std::unique(common.begin(), common.end()), common.end());
    for (std::size_t k = 1; k < in.sets.size(); ++k) {
      std::vector<std::int64_t> set = in.sets[k];
      std::sort(set.begin(), set.end());
      std::erase_if(common, [&](std::int64_t s) { return !std::binary_search(set.begin(), set.end(), s); });
    }
    const int feasible = common.empty() ? 0 : 1;
    return CommonStates{std::move(common), feasible};
  });
}

Sensitivities efficiency_increments(const Increments& in) {
  return guarded<&efficiency_increments>(in, [&] {
    const std::size_t parameters = in.parameter_base.size();
    require_same_length(in.efficiency_changed.size(), "efficiency_changed", parameters, "parameter_base");
    require_same_length(in.parameter_changed.size(), "parameter_changed", parameters, "parameter_base");
    require(in.efficiency_base != 0, "efficiency_base", in.efficiency_base, "must not be 0");
    Sensitivities out;
    for (std::size_t k = 0; k < parameters; ++k) {
      require(in.parameter_changed[k] != in.parameter_base[k], fmt::format("parameter_changed/{}", k),
              in.parameter_changed[k], "must differ from parameter_base");
      const double derivative =
          (in.efficiency_changed[k] - in.efficiency_base) / (in.parameter_changed[k] - in.parameter_base[k]);
      out.derivative.push_back(derivative);
      out.elasticity.push_back(derivative * in.parameter_base[k] / in.efficiency_base);
    }
    return out;
  });
}

}  // namespace verstat::models::k205
