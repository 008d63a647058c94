// K109: life of the teeth in time, exposure model, cost of a replacement policy.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>

#include "models/math/life_law.h"
#include "models/math/solve.h"
#include "models/reliability/detail/k109_chain.h"
#include "models/reliability/k109_face_mill_replacement.h"

namespace verstat::models::k109 {
namespace {

// Weibull scale eta of a tooth with mean life t_mean.
double scale_min(const ToothLife& life) {
  return life.t_mean_min / LifeLaw::weibull(1, life.beta).mean();
}

// Integrals over the life x of a tooth run in s with x = eta s^m and cumulative hazard y = s^(m beta): both
// are smooth at 0 for every shape, where x over y or y over x alone have an infinite slope.
struct SmoothLife {
  explicit SmoothLife(const ToothLife& life)
      : eta_min(scale_min(life)), beta(life.beta), m(std::max(1.0, std::ceil(4 / life.beta))) {}
  double eta_min;
  double beta;
  double m;
  [[nodiscard]] double s_of_time(double x_min) const { return std::pow(x_min / eta_min, 1 / m); }
  [[nodiscard]] double s_of_hazard(double y) const { return std::pow(y, 1 / (m * beta)); }
  [[nodiscard]] double time(double s) const { return eta_min * std::pow(s, m); }
  // m is a whole number: repeated multiplication is quicker than pow, and m is at most 8 for shapes above
  // 1/2.
  [[nodiscard]] double time_slope(double s) const {
    if (m > 8) return eta_min * m * std::pow(s, m - 1);
    double power = 1;
    for (double k = 1; k < m; ++k) power *= s;
    return eta_min * m * power;
  }
  [[nodiscard]] double hazard(double s) const { return std::pow(s, m * beta); }
  // f(x) dx/ds of the life x(s)
  [[nodiscard]] double density_slope(double s) const {
    return m * beta * std::pow(s, m * beta - 1) * std::exp(-hazard(s));
  }
  // -ln S(x)
  [[nodiscard]] double hazard_at(double x_min) const { return std::pow(x_min / eta_min, beta); }
};

// (C8) with one tolerated failure: no failure, or one at exposure x and then none of the others.
double reliability_one(const SmoothLife& life, double t_min, double z, double r1) {
  const double none = std::exp(-z * life.hazard_at(t_min));
  return none + integrate(
                    [&](double s) {
                      const double x_min = life.time(s);
                      return z * life.density_slope(s) *
                             std::exp(-(z - 1) * life.hazard_at(x_min + r1 * (t_min - x_min)));
                    },
                    0, life.s_of_time(t_min), 1e-11);
}

// The part of (C8) with exactly two failures, at exposures x < y.
double probability_two(const SmoothLife& life, double t_min, double z, double r1, double r2) {
  return integrate(
      [&](double s) {
        const double x_min = life.time(s);
        const double density = z * life.density_slope(s);
        const double left_min = t_min - x_min;
        // Bound of the inner integral: its last exponent is smallest where the second failure comes last.
        const double bound =
            (z - 1) * std::exp(-life.hazard(s) - (z - 2) * life.hazard_at(x_min + r1 * left_min));
        if (density * bound < 1e-20) return 0.0;  // would only ask the quadrature for digits of rounding
        const double inner = integrate(
            [&](double v) {
              const double y_min = life.time(v);
              const double end_min = y_min + r2 * std::max(0.0, left_min - (y_min - x_min) / r1);
              return (z - 1) * life.density_slope(v) * std::exp(-(z - 2) * life.hazard_at(end_min));
            },
            s, std::max(s, life.s_of_time(x_min + r1 * left_min)), 1e-10);
        return density * inner;
      },
      0, life.s_of_time(t_min), 1e-9);
}

// (C8) with c >= 3: the first c failures from order statistics, the next one in closed form.
double reliability_by_draws(const SmoothLife& life, double t_min, std::int64_t teeth, std::int64_t c,
                            double alpha) {
  constexpr int draws = 1 << 20;
  std::vector<double> factor;
  for (std::int64_t j = 0; j <= c; ++j) factor.push_back(detail::load_factor(teeth, j, alpha));
  std::mt19937_64 bits(109);  // fixed: equal inputs give equal answers
  double sum = 0;
  for (int draw = 0; draw < draws; ++draw) {
    double y = 0;
    double x_min = 0;
    double clock_min = 0;
    for (std::int64_t j = 0; j < c && clock_min <= t_min; ++j) {
      const double u = (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53;
      y += -std::log(u) / static_cast<double>(teeth - j);
      const double next_min = life.eta_min * std::pow(y, 1 / life.beta);
      clock_min += (next_min - x_min) / factor[static_cast<std::size_t>(j)];
      x_min = next_min;
    }
    if (clock_min > t_min) {
      sum += 1;
    } else {
      const double end_min = x_min + factor[static_cast<std::size_t>(c)] * (t_min - clock_min);
      sum += std::exp(-static_cast<double>(teeth - c) * (life.hazard_at(end_min) - y));
    }
  }
  return sum / draws;
}

}  // namespace

ToothReliability tooth_reliability(const ToothAtTime& in) {
  return guarded<&tooth_reliability>(
      in, [&] { return ToothReliability{std::exp(-std::pow(in.t_min / scale_min(in), in.beta))}; });
}

Time mission_time(const ToothMission& in) {
  return guarded<&mission_time>(
      in, [&] { return Time{scale_min(in) * std::pow(-std::log(in.r_tooth), 1 / in.beta)}; });
}

FailureTimes failure_times(const ToothLives& in) {
  return guarded<&failure_times>(in, [&] {
    const std::size_t z = in.lives_min.size();
    std::vector<double> remaining = in.lives_min;
    std::vector<bool> works(z, true);
    const auto gap_before = [&](std::size_t tooth) {
      std::size_t gap = 1;
      while (gap < z && !works[(tooth + z - gap) % z]) ++gap;
      return static_cast<double>(gap);
    };
    FailureTimes out;
    double clock_min = 0;
    for (std::size_t failed = 0; failed < z; ++failed) {
      const double equal =
          detail::load_factor(static_cast<std::int64_t>(z), static_cast<std::int64_t>(failed), in.alpha);
      std::vector<double> rate(z, equal);
      std::size_t next = z;
      double soonest_min = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < z; ++i) {
        if (!works[i]) continue;
        if (in.rule == SharingRule::local) rate[i] = std::pow(gap_before(i), in.alpha);
        if (remaining[i] / rate[i] < soonest_min) {
          soonest_min = remaining[i] / rate[i];
          next = i;
        }
      }
      clock_min += soonest_min;
      for (std::size_t i = 0; i < z; ++i)
        if (works[i]) remaining[i] = std::max(0.0, remaining[i] - soonest_min * rate[i]);
      works[next] = false;
      out.times_min.push_back(clock_min);
      out.order.push_back(static_cast<std::int64_t>(next));
    }
    return out;
  });
}

MeanTime mean_time_to_nth_failure(const NthFailure& in) {
  return guarded<&mean_time_to_nth_failure>(in, [&] {
    require(in.n <= in.teeth, "n", in.n, "must not be above z");
    const SmoothLife life(in);
    const auto z = static_cast<double>(in.teeth);
    // Beyond this hazard the survivors' share is below exp(-80) times C(40, 20).
    const double last = life.s_of_hazard(80 / (z - static_cast<double>(in.n) + 1));
    // Binomial weights over load factors, once for all points.
    std::vector<double> weights;
    double choose = 1;
    for (std::int64_t j = 0; j < in.n; ++j) {
      weights.push_back(choose / detail::load_factor(in.teeth, j, in.alpha));
      choose *= (z - static_cast<double>(j)) / (static_cast<double>(j) + 1);
    }
    std::vector<double> fails_powers(weights.size());
    const double mean_min = integrate(
        [&](double s) {
          const double y = life.hazard(s);
          const double fails = -std::expm1(-y);
          const double survives = std::exp(-y);
          // Sum of w_j fails^j survives^(z-j), from the most failures down.
          fails_powers[0] = 1;
          for (std::size_t j = 1; j < weights.size(); ++j) fails_powers[j] = fails_powers[j - 1] * fails;
          double sum = 0;
          double survivors = std::exp(-y * (z - static_cast<double>(in.n) + 1));
          for (std::size_t j = weights.size(); j-- > 0;) {
            sum += weights[j] * fails_powers[j] * survivors;
            survivors *= survives;
          }
          return sum * life.time_slope(s);
        },
        0, last, 1e-12);
    return MeanTime{mean_min};
  });
}

MillReliability mill_reliability_exposure(const Exposure& in) {
  return guarded<&mill_reliability_exposure>(in, [&] {
    require(in.failed_allowed < in.teeth, "failed_allowed", in.failed_allowed, "must be below z");
    const SmoothLife life(in);
    const auto z = static_cast<double>(in.teeth);
    const auto factor = [&](std::int64_t failed) { return detail::load_factor(in.teeth, failed, in.alpha); };
    // Longer than this not one tooth survives even alone.
    if (in.t_min == 0) return MillReliability{1};
    if (life.hazard_at(in.t_min) > 745) return MillReliability{0};
    double reliability = 0;
    if (in.failed_allowed == 0)
      reliability = std::exp(-z * life.hazard_at(in.t_min));
    else if (in.failed_allowed <= 2)
      reliability = reliability_one(life, in.t_min, z, factor(1)) +
                    (in.failed_allowed == 2 ? probability_two(life, in.t_min, z, factor(1), factor(2)) : 0);
    else
      reliability = reliability_by_draws(life, in.t_min, in.teeth, in.failed_allowed, in.alpha);
    return MillReliability{std::min(1.0, reliability)};
  });
}

PolicyCost policy_cost(const Policy& in) {
  return guarded<&policy_cost>(in, [&] {
    require(in.failed_allowed < in.teeth, "failed_allowed", in.failed_allowed, "must be below z");
    const SmoothLife life(in);
    const std::vector<double> rates = detail::stage_rates(in.teeth, 0, in.failed_allowed, in.alpha);
    const double slowest = *std::min_element(rates.begin(), rates.end());
    // Beyond L = 150/min a the survival is below 1e-20 for every number of stages.
    const double last_min = std::min(in.t_planned_min, life.eta_min * std::pow(150 / slowest, 1 / in.beta));
    const double cutting_min = integrate(
        [&](double s) { return detail::run_chain(rates, life.hazard(s)).alive() * life.time_slope(s); }, 0,
        life.s_of_time(last_min), 1e-10);
    PolicyCost out{};
    out.mean_cycle_cutting_min = cutting_min;
    out.p_unplanned = detail::run_chain(rates, life.hazard_at(in.t_planned_min)).absorbed;
    const double planned = 1 - out.p_unplanned;
    const double change_min = planned * in.change_planned_min + out.p_unplanned * in.change_unplanned_min;
    out.cost_per_cutting_min =
        (static_cast<double>(in.teeth) * in.edge_cost + planned * in.planned_cost +
         out.p_unplanned * in.unplanned_cost + in.machine_rate_per_min * (cutting_min + change_min)) /
        cutting_min;
    out.availability = cutting_min / (cutting_min + change_min);
    return out;
  });
}

}  // namespace verstat::models::k109
