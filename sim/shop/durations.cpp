#include "sim/shop/durations.h"

namespace verstat::shop {

sim::Distribution law_of(const scenarios::Duration& duration) {
  struct Law {
    sim::Distribution operator()(const operations::ConstantDuration& d) const {
      return sim::Distribution::constant(d.value_min);
    }
    sim::Distribution operator()(const operations::ExponentialDuration& d) const {
      return sim::Distribution::exponential(1 / d.rate_per_min);
    }
    sim::Distribution operator()(const operations::UniformDuration& d) const {
      return sim::Distribution::uniform(d.low_min, d.high_min);
    }
    sim::Distribution operator()(const operations::TriangularDuration& d) const {
      if (d.low_min == d.high_min) return sim::Distribution::constant(d.low_min);
      return sim::Distribution::triangular(d.low_min, d.mode_min, d.high_min);
    }
    sim::Distribution operator()(const operations::LognormalDuration& d) const {
      return sim::Distribution::lognormal(d.mean_min, d.cv);
    }
    sim::Distribution operator()(const operations::GammaDuration& d) const {
      return sim::Distribution::gamma(1 / (d.cv * d.cv), d.mean_min * d.cv * d.cv);
    }
    sim::Distribution operator()(const operations::WeibullDuration& d) const {
      return sim::Distribution::weibull_mean_cv(d.mean_min, d.cv);
    }
    sim::Distribution operator()(const operations::EmpiricalDuration& d) const {
      const std::vector<double> weights =
          d.weights.empty() ? std::vector<double>(d.values_min.size(), 1.0) : d.weights;
      return d.between == operations::BetweenValues::step
                 ? sim::Distribution::discrete(d.values_min, weights)
                 : sim::Distribution::empirical(d.values_min, weights);
    }
  };
  return std::visit(Law{}, duration);
}

}  // namespace verstat::shop
