#pragma once
// What the files of K117 share: formulas without the input checks of the public functions.

#include "models/reliability/k117_rational_reliability.h"

namespace verstat::models::k117::detail {

/// R(age), 0 from no_schedule_min on.
[[nodiscard]] inline double survival(const LifeLaw& law, double age_min) {
  return age_min >= no_schedule_min ? 0 : law.reliability(age_min);
}
/// M(age), the mean life from no_schedule_min on.
[[nodiscard]] inline double worked(const LifeLaw& law, double age_min) {
  return age_min >= no_schedule_min ? law.mean_life() : law.restricted_mean(age_min);
}
/// T_gamma for functions that divide by it. Throws DomainError where it is 0.
[[nodiscard]] double positive_gamma_percent_life(const LifeLaw& law, double gamma);

/// t0 = pi D L i/(1000 V S)
[[nodiscard]] double machining_time(const TurnedPart& part, double speed_m_min, double feed_mm_rev);
/// Speed at which the mean life is `ratio` times smaller than T_ref:
///   V = V_ref ratio^(1/mu) (S_ref/S)^y (t_ref/t)^x
[[nodiscard]] double speed_for_life_ratio(const TaylorLife& life, const FeedAndDepth& cut, double ratio);
[[nodiscard]] double mean_life(const TaylorLife& life, const FeedAndDepth& cut, double speed_m_min);
[[nodiscard]] ChangeCosts outcome_costs(const Economics& in);

}  // namespace verstat::models::k117::detail
