#pragma once
// What happens to the edges of a tool in the long run under its strategy (K117 section E), as plain numbers
// or with a derivative.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "models/math/life_law.h"
#include "optimize/dual.h"
#include "scenarios/input_error.h"
#include "scenarios/tooling.h"

namespace verstat::optimize {

/// Reads numbers of a scenario. As a Dual, one of them, known by its address, is the variable.
template <class N>
struct Reading;
template <>
struct Reading<double> {
  double operator()(const double& x) const { return x; }
};
template <>
struct Reading<Dual> {
  const double* moved = nullptr;
  bool* met = nullptr;  ///< set when the variable was read
  Dual operator()(const double& x) const {
    if (&x != moved) return {x};
    *met = true;
    return {x, 1};
  }
};

/// Mean of a duration. The variable is found in constant and exponential ones, and in those given by a mean.
template <class N>
N mean_of(const operations::Duration& duration, const Reading<N>& read) {
  if constexpr (std::is_same_v<N, Dual>) {
    if (const auto* c = std::get_if<operations::ConstantDuration>(&duration)) return read(c->value_min);
    if (const auto* e = std::get_if<operations::ExponentialDuration>(&duration))
      return 1 / read(e->rate_per_min);
    if (const auto* l = std::get_if<operations::LognormalDuration>(&duration)) return read(l->mean_min);
    if (const auto* g = std::get_if<operations::GammaDuration>(&duration)) return read(g->mean_min);
    if (const auto* w = std::get_if<operations::WeibullDuration>(&duration)) return read(w->mean_min);
  }
  return mean_min(duration);
}

/// Per minute of cutting.
template <class N>
struct EdgeRates {
  N planned_per_min = 0;
  N failures_per_min = 0;
};

/// A life law whose mean is `mean`; ages scale with it.
template <class N>
struct LifeOf {
  const models::LifeLaw& law;  ///< at the value of `mean`
  N mean;

  [[nodiscard]] N gamma_percent_life(const N& gamma) const {
    const double age = law.gamma_percent_life(value_of(gamma));
    if constexpr (std::is_same_v<N, double>) {
      return age;
    } else {
      if (age <= 0) return 0.0;  // in the atom of the normal law
      double slope = age / mean.value * mean.slope;
      if (gamma.slope != 0) slope -= gamma.slope / law.density(age);
      return {age, slope};
    }
  }
  [[nodiscard]] N reliability(const N& age) const {
    const double r = law.reliability(value_of(age));
    if constexpr (std::is_same_v<N, double>)
      return r;
    else
      return {r, -ageing(age)};
  }
  [[nodiscard]] N failure_probability(const N& age) const {
    const double f = law.failure_probability(value_of(age));
    if constexpr (std::is_same_v<N, double>)
      return f;
    else
      return {f, ageing(age)};
  }
  [[nodiscard]] N restricted_mean(const N& age) const {
    const double m = law.restricted_mean(value_of(age));
    if constexpr (std::is_same_v<N, double>) {
      return m;
    } else {
      if (std::isinf(age.value)) return mean_life();
      const double r = law.reliability(age.value);
      return {m, r * age.slope + (m - r * age.value) / mean.value * mean.slope};
    }
  }
  [[nodiscard]] N mean_life() const {
    const double m = law.mean_life();
    if constexpr (std::is_same_v<N, double>)
      return m;
    else
      return {m, m / mean.value * mean.slope};
  }
  // Slope of the failure probability.
  [[nodiscard]] double ageing(const Dual& age) const {
    const double slope = age.slope - age.value / value_of(mean) * slope_of(mean);
    return slope == 0 ? 0 : law.density(age.value) * slope;
  }
};

/// Integral of R(t) exp(-rate t) over 0..tau: the mean time in use of an edge that also breaks by chance.
template <class N>
N thinned_restricted_mean(const LifeOf<N>& life, const N& rate, const N& tau_min) {
  // Gauss-Legendre of five points on panels no longer than a fifth of either time scale.
  constexpr std::array nodes{0.0, 0.5384693101056831, -0.5384693101056831, 0.9061798459386640,
                             -0.9061798459386640};
  constexpr std::array weights{0.5688888888888889, 0.4786286704993665, 0.4786286704993665, 0.2369268850561891,
                               0.2369268850561891};
  const double r = value_of(rate);
  const double mean = value_of(life.mean);
  const double end_min = std::min({value_of(tau_min), 40 / r, life.law.quantile(1 - 1e-15)});
  const double panel_min = 0.2 * std::min(mean, 1 / r);
  const int panels = std::clamp(static_cast<int>(std::ceil(end_min / panel_min)), 8, 2000);
  const double h = 0.5 * end_min / panels;
  double sum = 0;
  double slope = 0;
  for (int p = 0; p < panels; ++p)
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const double t = (2 * p + 1 + nodes[k]) * h;
      const double there = life.law.reliability(t);
      const double chance = std::exp(-r * t);
      sum += weights[k] * h * there * chance;
      if (slope_of(rate) != 0) slope -= weights[k] * h * there * chance * t * slope_of(rate);
      if (slope_of(life.mean) != 0)
        slope += weights[k] * h * life.law.density(t) * t / mean * slope_of(life.mean) * chance;
    }
  if constexpr (std::is_same_v<N, double>) {
    return sum;
  } else {
    if (end_min == tau_min.value)
      slope += life.law.reliability(end_min) * std::exp(-r * end_min) * tau_min.slope;
    return {sum, slope};
  }
}

/// Visits the strategy of a tool. Throws scenarios::InputError for strategies without long-run rates.
template <class N>
struct RatesOf {
  LifeOf<N> life;  ///< at the regime
  N main_time_min;
  N breaks_per_min;  ///< by chance, besides wear; 0: none
  const Reading<N>& read;

  [[nodiscard]] EdgeRates<N> aged(const N& tau_min) const {
    if (value_of(breaks_per_min) > 0) {
      const N used_min = thinned_restricted_mean(life, breaks_per_min, tau_min);
      N planned = 0.0;
      if (std::isfinite(value_of(tau_min)))
        planned = life.reliability(tau_min) * exponential(-(breaks_per_min * tau_min));
      return {planned / used_min, (1 - planned) / used_min};
    }
    const N used_min = life.restricted_mean(tau_min);
    return {life.reliability(tau_min) / used_min, life.failure_probability(tau_min) / used_min};
  }
  EdgeRates<N> operator()(const scenarios::RunToFailure&) const {
    if (value_of(breaks_per_min) > 0) return aged(std::numeric_limits<double>::infinity());
    return {0.0, 1 / life.mean_life()};
  }
  EdgeRates<N> operator()(const scenarios::AgeReplacement& s) const {
    return aged(life.gamma_percent_life(read(s.gamma)));
  }
  EdgeRates<N> operator()(const scenarios::PartCountReplacement& s) const {
    const N limit_min = life.gamma_percent_life(read(s.gamma));
    const double parts = std::floor(value_of(limit_min) / value_of(main_time_min) + 1e-12);
    return aged(parts >= 1 ? parts * main_time_min : limit_min);
  }
  EdgeRates<N> operator()(const scenarios::BlockReplacement& s) const {
    const N period_min = life.gamma_percent_life(read(s.gamma));
    if (value_of(breaks_per_min) > 0)
      throw scenarios::InputError(
          "", "block replacement of a tool that also breaks by chance is left to the simulation");
    return {1 / period_min, renewals(period_min) / period_min};
  }
  template <class Other>
  EdgeRates<N> operator()(const Other&) const {
    throw scenarios::InputError(
        "", fmt::format("the long-run model does not cover the strategy \"{}\": it is left to the simulation",
                        Other::kind));
  }

 private:
  [[nodiscard]] N renewals(const N& period_min) const {
    const double h = life.law.renewal_function(value_of(period_min));
    if constexpr (std::is_same_v<N, double>) {
      return h;
    } else {
      // A function of period over mean alone; its density has no closed form, so this one is a difference.
      const double relative = period_min.slope / period_min.value - life.mean.slope / life.mean.value;
      if (relative == 0) return h;
      constexpr double step = 1e-4;
      const double up = life.law.renewal_function(period_min.value * (1 + step));
      const double down = life.law.renewal_function(period_min.value * (1 - step));
      return {h, (up - down) / (2 * step) * relative};
    }
  }
};

}  // namespace verstat::optimize
