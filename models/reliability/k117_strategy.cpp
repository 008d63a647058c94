// K117 section E: replacement strategies and the joint optimum of speed and gamma.
#include <algorithm>
#include <cmath>

#include "models/math/solve.h"
#include "models/reliability/detail/k117_parts.h"

namespace verstat::models::k117 {
namespace {

// Share of the edges that fail before the age; not 1 - R, which is noise for short ages.
double failing(const LifeLaw& law, double age_min) {
  return age_min >= no_schedule_min ? 1 : law.failure_probability(age_min);
}

double age_cost_rate(double fails, double worked_min, double planned, double failure) {
  return ((1 - fails) * planned + fails * failure) / worked_min;
}

OptimalAge optimal_age(const LifeLaw& law, double planned, double failure) {
  const double to_failure = failure / law.mean_life();
  const OptimalAge run_to_failure{no_schedule_min, 0, to_failure, to_failure};
  if (!(failure > planned)) return run_to_failure;
  // The cost rate falls while h M + R < Q2/(Q2 - Q1). The left side rises and falls with the hazard: for a
  // rising hazard its root is the only minimum, for a constant or falling one it never gets there, and for
  // one that rises and then falls (lognormal) the first of two roots is the minimum.
  const double level = failure / (failure - planned);
  const auto excess = [&](double age) {
    return law.hazard(age) * law.restricted_mean(age) + law.reliability(age) - level;
  };
  const double low = 0.01 * law.mean();
  double high = 6 * law.mean();
  if (law.kind() == LifeLawKind::lognormal && excess(low) < 0) {
    constexpr int steps = 256;
    for (int k = 1; k <= steps; ++k) {
      const double age = low * std::pow(600.0, static_cast<double>(k) / steps);
      if (excess(age) < 0) continue;
      high = age;
      break;
    }
  }
  double age = 0;
  if (excess(low) >= 0)
    age = low;
  else if (excess(high) <= 0)
    age = high;
  else
    age = find_root(excess, low, high, 1e-13);
  const double cost_rate =
      age_cost_rate(law.failure_probability(age), law.restricted_mean(age), planned, failure);
  // 1e-12: a difference made by rounding is a tie, which run to failure wins.
  if (!(cost_rate < to_failure * (1 - 1e-12))) return run_to_failure;
  return {age, law.reliability(age), cost_rate, to_failure};
}

constexpr double longest_interval_in_means = 50;

// Cost rate of the edges and what goes with it; t0 enters part_count only.
struct EdgeUse {
  double change_age_min;  // 0 = none
  double life_used_min;
  double failure_probability;
  double cost_rate_per_min;
  double stop_share;  // minutes of change per cutting minute
};

EdgeUse edge_use(const PartCostIn& in, const LifeLaw& law, double t0_min) {
  const ChangeCosts cost = detail::outcome_costs(in);
  if (in.strategy == Strategy::run_to_failure) {
    const double life_min = law.mean_life();
    return {0, life_min, 1, cost.failure / life_min, in.t_change_failure_min / life_min};
  }
  if (!in.gamma) reject("gamma is missing: every strategy but run_to_failure needs it");
  const double gamma = *in.gamma;
  double age_min = detail::positive_gamma_percent_life(law, gamma);
  if (in.strategy == Strategy::block) {
    const double failures = law.renewal_function(age_min);
    return {age_min, age_min, 1 - gamma, (cost.planned + cost.failure * failures) / age_min,
            (in.t_change_planned_min + failures * in.t_change_failure_min) / age_min};
  }
  double fails = age_min >= no_schedule_min ? 1 : 1 - gamma;
  if (in.strategy == Strategy::part_count) {
    // 1e-12 keeps a part that fits exactly from being lost to rounding.
    const double parts = std::floor(age_min / t0_min + 1e-12);
    if (parts >= 1) age_min = parts * t0_min;
    fails = failing(law, age_min);
  }
  const double used_min = in.accounting == Accounting::scheduled ? age_min : detail::worked(law, age_min);
  return {age_min, used_min, fails, age_cost_rate(fails, used_min, cost.planned, cost.failure),
          ((1 - fails) * in.t_change_planned_min + fails * in.t_change_failure_min) / used_min};
}

}  // namespace

PartCost part_cost(const PartCostIn& in) {
  return guarded<&part_cost>(in, [&] {
    const double t0_min = detail::machining_time(in, in.speed_m_min, in.feed_mm_rev);
    const double mean_min = detail::mean_life(in, in, in.speed_m_min);
    const EdgeUse use = edge_use(in, LifeLaw(in.law, mean_min, in.cv), t0_min);
    PartCost out{};
    out.machining_time_min = t0_min;
    out.mean_life_min = mean_min;
    out.change_age_min = use.change_age_min;
    out.life_used_min = use.life_used_min;
    out.parts_per_period = use.life_used_min / t0_min;
    out.failure_probability = use.failure_probability;
    out.machining_cost = t0_min * in.machine_rate_per_min;
    out.edge_cost = t0_min * use.cost_rate_per_min;
    out.part_cost = out.machining_cost + out.edge_cost;
    out.time_per_part_min = t0_min * (1 + use.stop_share);
    return out;
  });
}

AgeReplacementCost age_replacement_cost_rate(const AgeReplacement& in) {
  return guarded<&age_replacement_cost_rate>(in, [&] {
    const LifeLaw law(in.law, in.mean_min, in.cv);
    const double worked_min = detail::worked(law, in.change_age_min);
    return AgeReplacementCost{
        age_cost_rate(failing(law, in.change_age_min), worked_min, in.planned_cost, in.failure_cost),
        detail::survival(law, in.change_age_min), worked_min};
  });
}

OptimalAge optimal_age_replacement(const OptimalAgeIn& in) {
  return guarded<&optimal_age_replacement>(
      in, [&] { return optimal_age(LifeLaw(in.law, in.mean_min, in.cv), in.planned_cost, in.failure_cost); });
}

BlockReplacementCost block_replacement_cost_rate(const BlockReplacement& in) {
  return guarded<&block_replacement_cost_rate>(in, [&] {
    require(in.interval_min <= longest_interval_in_means * in.mean_min, "interval_min", in.interval_min,
            "must not be above 50 mean lives");
    const double failures = LifeLaw(in.law, in.mean_min, in.cv).renewal_function(in.interval_min);
    return BlockReplacementCost{(in.planned_cost + in.failure_cost * failures) / in.interval_min, failures};
  });
}

JointOptimum joint_speed_gamma_optimum(const JointOptimumIn& in) {
  return guarded<&joint_speed_gamma_optimum>(in, [&] {
    const ChangeCosts cost = detail::outcome_costs(in);
    const OptimalAge unit = optimal_age(LifeLaw(in.law, 1, in.cv), cost.planned, cost.failure);
    JointOptimum out{};
    out.gamma = unit.gamma;
    out.mean_life_min = (in.mu - 1) * unit.cost_rate_per_min / in.machine_rate_per_min;
    out.speed_m_min = detail::speed_for_life_ratio(in, in, in.mean_ref_min / out.mean_life_min);
    out.change_age_min =
        unit.change_age_min >= no_schedule_min ? no_schedule_min : unit.change_age_min * out.mean_life_min;
    out.part_cost = detail::machining_time(in, out.speed_m_min, in.feed_mm_rev) * in.machine_rate_per_min *
                    in.mu / (in.mu - 1);
    return out;
  });
}

}  // namespace verstat::models::k117
