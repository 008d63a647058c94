// K117 sections C and D: part cost at a fixed scheduled period, expenditure and consumption criteria.
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/special_functions/gamma.hpp>

#include "models/math/policy.h"
#include "models/math/solve.h"
#include "models/reliability/detail/k117_parts.h"

namespace verstat::models::k117 {

namespace detail {

double machining_time(const TurnedPart& part, double speed_m_min, double feed_mm_rev) {
  return std::numbers::pi * part.diameter_mm * part.length_mm * part.passes /
         (1000 * speed_m_min * feed_mm_rev);
}

double speed_for_life_ratio(const TaylorLife& life, const FeedAndDepth& cut, double ratio) {
  return life.speed_ref_m_min * std::pow(ratio, 1 / life.mu) *
         std::pow(life.feed_ref_mm_rev / cut.feed_mm_rev, life.feed_exponent) *
         std::pow(life.depth_ref_mm / cut.depth_mm, life.depth_exponent);
}

double mean_life(const TaylorLife& life, const FeedAndDepth& cut, double speed_m_min) {
  return life.mean_ref_min * std::pow(life.speed_ref_m_min / speed_m_min, life.mu) *
         std::pow(life.feed_ref_mm_rev / cut.feed_mm_rev, life.mu * life.feed_exponent) *
         std::pow(life.depth_ref_mm / cut.depth_mm, life.mu * life.depth_exponent);
}

ChangeCosts outcome_costs(const Economics& in) {
  const double stop_rate_per_min = in.machine_rate_per_min + in.setter_rate_per_min;
  return {
      stop_rate_per_min * in.t_change_planned_min + in.insert_price / in.periods_planned + in.regrind_planned,
      stop_rate_per_min * in.t_change_failure_min + in.damage_cost + in.insert_price / in.periods_failure +
          in.regrind_failure};
}

}  // namespace detail

namespace {

// A(gamma) of eqs. (4)-(7) with everything solved that does not depend on gamma.
class FixedPeriod {
 public:
  explicit FixedPeriod(const PeriodEconomy& in)
      : in_(in),
        reference_(LifeLawKind::weibull, in.mean_ref_min, in.cv),
        unit_scale_mean_(in.mean_ref_min / reference_.scale()),
        costs_(detail::outcome_costs(in)) {
    require(in.life_offset_min < reference_.scale(), "life_offset_min", in.life_offset_min,
            "must be below the scale of the life at the reference regime");
  }

  [[nodiscard]] PartCostAtGamma at(double gamma) const {
    const double b = reference_.shape();
    const double x = -std::log(gamma);
    const double scale_min = in_.period_min * std::pow(x, -1 / b);  // R(T_e) = gamma at this scale
    const double u = scale_min - in_.life_offset_min;
    require(u > 0, "life_offset_min", in_.life_offset_min,
            "must be below the scale of the life that the period and gamma ask for");
    PartCostAtGamma out{};
    out.speed_m_min = detail::speed_for_life_ratio(in_, in_, (reference_.scale() - in_.life_offset_min) / u);
    out.machining_time_min = detail::machining_time(in_, out.speed_m_min, in_.feed_mm_rev);
    out.mean_life_min = scale_min * unit_scale_mean_;
    const double per_period = gamma * costs_.planned + (1 - gamma) * costs_.failure;
    if (in_.accounting == Accounting::renewal) {
      const double worked_min = out.mean_life_min * boost::math::gamma_p(1 / b, x, MathPolicy());
      out.part_cost = out.machining_time_min * (in_.machine_rate_per_min + per_period / worked_min);
      return out;
    }
    const double delta = costs_.failure - costs_.planned;
    const double bracket = in_.machine_rate_per_min * in_.period_min + per_period;  // B of eq. (4)
    const double front = out.machining_time_min / in_.period_min;                   // kappa U^(1/mu)
    const double q = 1 / in_.mu;
    const double du = scale_min / (b * gamma * x) / u;                                 // U'/U
    const double d2u = scale_min / (b * gamma * gamma * x * x) * (1 / b + 1 - x) / u;  // U''/U
    out.part_cost = front * bracket;
    out.slope = front * (bracket * q * du - delta);  // eq. (5)
    out.curvature =
        front * (q * (q - 1) * du * du * bracket + q * d2u * bracket - 2 * q * delta * du);  // eq. (6)
    return out;
  }

 private:
  const PeriodEconomy& in_;
  LifeLaw reference_;
  double unit_scale_mean_;  // Gamma(1 + 1/b)
  ChangeCosts costs_;
};

// Largest x in [from, to] with f(x) <= limit, where f(from) <= limit.
double last_below(const Function1& f, double from, double to, double limit) {
  if (f(to) <= limit) return to;
  constexpr int cells = 400;
  double above = to;
  for (int k = cells - 1; k >= 0; --k) {
    const double x = from + (to - from) * k / cells;
    if (k == 0 || f(x) <= limit) {
      // Bisection keeps the answer on the side that meets the limit.
      double below = x;
      for (int i = 0; i < 200 && above - below > 1e-14; ++i) {
        const double middle = below + (above - below) / 2;
        if (middle == below || middle == above) break;
        (f(middle) <= limit ? below : above) = middle;
      }
      return below;
    }
    above = x;
  }
  return from;
}

struct ExpenditureLaw {
  explicit ExpenditureLaw(const Expenditure& in)
      : in_(in), base_(LifeLawKind::weibull, in.mean_ref_min, in.cv) {}
  [[nodiscard]] ExpenditureParts at(double gamma) const {
    // (ln gamma_0/ln gamma)^(k/b) with gamma_0 = R(T_e) at the base reliability.
    const double growth = in_.period_min / base_.scale() * std::pow(-std::log(gamma), -1 / base_.shape());
    ExpenditureParts out{};
    out.manufacture = in_.period_price * std::pow(growth, in_.price_exponent);
    out.operation = in_.failure_cost * (1 - gamma);
    out.total = out.manufacture + out.operation;
    return out;
  }

 private:
  const Expenditure& in_;
  LifeLaw base_;
};

// Eq. (9); `worked_min` is M(T_gamma).
InsertConsumption consumption(const Consumption& in, double gamma, double worked_min) {
  const double lost = (1 - gamma) * (1 - in.p_reserve_ok);  // 1 - s
  const auto edges = static_cast<double>(in.edges);
  const double used = lost == 0 ? edges : -std::expm1(edges * std::log1p(-lost)) / lost;
  return {used, 60 / (used * worked_min)};
}

}  // namespace

MachiningTime machining_time_turning(const TurningPass& in) {
  return guarded<&machining_time_turning>(
      in, [&] { return MachiningTime{detail::machining_time(in, in.speed_m_min, in.feed_mm_rev)}; });
}

MeanLife mean_life_for_regime(const Regime& in) {
  return guarded<&mean_life_for_regime>(in,
                                        [&] { return MeanLife{detail::mean_life(in, in, in.speed_m_min)}; });
}

Speed speed_for_mean_life(const LifeWanted& in) {
  return guarded<&speed_for_mean_life>(
      in, [&] { return Speed{detail::speed_for_life_ratio(in, in, in.mean_ref_min / in.mean_min)}; });
}

ChangeCosts change_costs(const Economics& in) {
  return guarded<&change_costs>(in, [&] { return detail::outcome_costs(in); });
}

PartCostBaseOut part_cost_base(const PartCostBase& in) {
  return guarded<&part_cost_base>(in, [&] {
    return PartCostBaseOut{in.machining_time_min * in.machine_rate_per_min +
                           in.change_time_min * in.change_rate_per_min / in.parts_per_period +
                           (in.insert_price / in.periods + in.regrind) / in.parts_per_period};
  });
}

PartCostAtGamma part_cost_at_gamma(const PeriodEconomyAtGamma& in) {
  return guarded<&part_cost_at_gamma>(in, [&] {
    require(in.accounting != Accounting::scheduled || in.gamma >= 0.40, "gamma", in.gamma,
            "allowed 0.40 <= gamma <= 0.99 in scheduled accounting");
    return FixedPeriod(in).at(in.gamma);
  });
}

RationalGamma rational_gamma_cost(const GammaSearch& in) {
  return guarded<&rational_gamma_cost>(in, [&] {
    require(in.gamma_min < in.gamma_max, "gamma_min", in.gamma_min, "must be below gamma_max");
    require(in.accounting != Accounting::scheduled || in.gamma_min >= 0.40, "gamma_min", in.gamma_min,
            "must not be below 0.40 in scheduled accounting, where the cost falls to zero with gamma");
    const FixedPeriod period(in);
    const Function1 cost = [&](double gamma) { return period.at(gamma).part_cost; };
    const Minimum best = minimize_global(cost, in.gamma_min, in.gamma_max);
    const double limit = (1 + in.knee_tolerance) * best.value;
    return RationalGamma{best.x, last_below(cost, best.x, in.gamma_max, limit), best.value};
  });
}

FailurePenalty failure_penalty_for_gamma(const PenaltyCalibration& in) {
  return guarded<&failure_penalty_for_gamma>(in, [&] {
    const double b_mu = in.shape * in.mu;
    require(in.gamma > std::exp(1 / b_mu - 1), "gamma", in.gamma,
            "must be above exp(1/(shape mu) - 1): no minimum of the cost lies below");
    const double c = 1 / (b_mu * in.gamma * -std::log(in.gamma));
    const double r = c / (1 + c * in.gamma);
    return FailurePenalty{(in.planned_cost + r * in.machine_rate_per_min * in.period_min) / (1 - r)};
  });
}

ExpenditureParts reliability_expenditure(const ExpenditureAtGamma& in) {
  return guarded<&reliability_expenditure>(in, [&] { return ExpenditureLaw(in).at(in.gamma); });
}

ExpenditureOptimum rational_gamma_expenditure(const Expenditure& in) {
  return guarded<&rational_gamma_expenditure>(in, [&] {
    const ExpenditureLaw law(in);
    const Minimum best = minimize_global([&](double gamma) { return law.at(gamma).total; }, 0.20, 0.99);
    return ExpenditureOptimum{best.x, best.value};
  });
}

InsertConsumption insert_consumption(const ConsumptionAtGamma& in) {
  return guarded<&insert_consumption>(in, [&] {
    const LifeLaw law(in.law, in.mean_min, in.cv);
    const double age_min = detail::positive_gamma_percent_life(law, in.gamma);
    return consumption(in, in.gamma, law.restricted_mean(age_min));
  });
}

ConsumptionOptimum rational_gamma_consumption(const ConsumptionSearch& in) {
  return guarded<&rational_gamma_consumption>(in, [&] {
    require(in.gamma_min < in.gamma_max, "gamma_min", in.gamma_min, "must be below gamma_max");
    const LifeLaw law(in.law, in.mean_min, in.cv);
    // Levels that no age reaches (atom of the normal law) consume without bound.
    const Minimum best = minimize_global(
        [&](double gamma) {
          const double age_min = law.gamma_percent_life(gamma);
          if (!(age_min > 0)) return std::numeric_limits<double>::max();
          return consumption(in, gamma, law.restricted_mean(age_min)).inserts_per_cutting_hour;
        },
        in.gamma_min, in.gamma_max);
    require(best.value < std::numeric_limits<double>::max(), "gamma_min", in.gamma_min,
            "must be below Phi(1/cv): from there on the gamma-percent life of the normal law is 0");
    return ConsumptionOptimum{best.x, best.value};
  });
}

}  // namespace verstat::models::k117
