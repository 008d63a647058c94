// K117 section B: life of an edge.
#include <cmath>

#include "models/reliability/detail/k117_parts.h"

namespace verstat::models::k117 {

namespace detail {

double positive_gamma_percent_life(const LifeLaw& law, double gamma) {
  const double life_min = law.gamma_percent_life(gamma);
  require(life_min > 0, "gamma", gamma,
          "must be below Phi(1/cv): from there on the gamma-percent life of the normal law is 0");
  return life_min;
}

}  // namespace detail

WeibullParameters weibull_from_moments(const LifeMoments& in) {
  return guarded<&weibull_from_moments>(in, [&] {
    const LifeLaw law(LifeLawKind::weibull, in.mean_min, in.cv);
    return WeibullParameters{law.shape(), law.scale()};
  });
}

LifeReliability life_reliability(const LifeAtAge& in) {
  return guarded<&life_reliability>(in, [&] {
    const bool starts_high = in.law == LifeLawKind::weibull || in.law == LifeLawKind::gamma;
    require(in.age_min > 0 || !starts_high || in.cv <= 1, "t_min", in.age_min,
            "must be above 0: the Weibull and gamma hazards with cv > 1 are infinite at 0");
    const LifeLaw law(in.law, in.mean_min, in.cv);
    return LifeReliability{law.reliability(in.age_min), law.density(in.age_min), law.hazard(in.age_min)};
  });
}

GammaPercentLife gamma_percent_life(const GammaPercent& in) {
  return guarded<&gamma_percent_life>(
      in, [&] { return GammaPercentLife{LifeLaw(in.law, in.mean_min, in.cv).gamma_percent_life(in.gamma)}; });
}

MeanLife required_mean_life(const PeriodAtGamma& in) {
  return guarded<&required_mean_life>(in, [&] {
    const LifeLaw unit(in.law, 1, in.cv);
    return MeanLife{in.period_min / detail::positive_gamma_percent_life(unit, in.gamma)};
  });
}

RestrictedMean restricted_mean_life(const ScheduledAge& in) {
  return guarded<&restricted_mean_life>(in, [&] {
    return RestrictedMean{detail::worked(LifeLaw(in.law, in.mean_min, in.cv), in.change_age_min)};
  });
}

RestrictedMean weibull_restricted_mean_series(const RestrictedMeanSeries& in) {
  return guarded<&weibull_restricted_mean_series>(in, [&] {
    const double x = std::pow(in.change_age_min / in.scale_min, in.shape);
    require(in.change_age_min < no_schedule_min && x <= 15, "tau_min", in.change_age_min,
            "must keep (tau/scale)^shape <= 15: beyond, rounding swamps the alternating series");
    double sum = 0;
    double term = 1;  // (-x)^n / n!
    for (std::int64_t n = 0; n < in.terms && term != 0; ++n) {
      sum += term / (static_cast<double>(n) * in.shape + 1);
      term *= -x / static_cast<double>(n + 1);
    }
    return RestrictedMean{in.change_age_min * sum};
  });
}

PulseTreatmentEffect pulse_treatment_effect(const PulseTreatment& in) {
  return guarded<&pulse_treatment_effect>(in, [&] {
    const LifeLaw before(LifeLawKind::weibull, in.mean_min, in.cv_before);
    const LifeLaw after(LifeLawKind::normal, in.mean_min * in.mean_factor, in.cv_after);
    const double before_min = before.gamma_percent_life(in.gamma);
    const double after_min = after.gamma_percent_life(in.gamma);
    return PulseTreatmentEffect{before.shape(), before_min, after_min, after_min / before_min};
  });
}

}  // namespace verstat::models::k117
