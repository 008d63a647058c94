#include "operations/fields.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace verstat::models {

using namespace operations;

std::vector<Field> StructFields<ConstantDuration>::fields() {
  return {
      need<ConstantDuration>(&ConstantDuration::value_min, "value_min", "min", duration_min, "the duration")};
}
std::vector<Field> StructFields<ExponentialDuration>::fields() {
  return {need<ExponentialDuration>(&ExponentialDuration::rate_per_min, "rate_per_min", "1/min",
                                    closed(1e-9, 1e9), "rate; the mean is 1/rate")};
}
std::vector<Field> StructFields<UniformDuration>::fields() {
  return {need<UniformDuration>(&UniformDuration::low_min, "low_min", "min", duration_min, "shortest"),
          need<UniformDuration>(&UniformDuration::high_min, "high_min", "min", duration_min, "longest")};
}
std::vector<Field> StructFields<TriangularDuration>::fields() {
  return {
      need<TriangularDuration>(&TriangularDuration::low_min, "low_min", "min", duration_min, "shortest"),
      need<TriangularDuration>(&TriangularDuration::mode_min, "mode_min", "min", duration_min, "most likely"),
      need<TriangularDuration>(&TriangularDuration::high_min, "high_min", "min", duration_min, "longest")};
}

namespace {
template <class D>
std::vector<Field> mean_and_cv() {
  return {need<D>(&D::mean_min, "mean_min", "min", open_low(0, 1e9), "mean"),
          need<D>(&D::cv, "cv", "1", closed(0.05, 2), "coefficient of variation")};
}
}  // namespace
std::vector<Field> StructFields<LognormalDuration>::fields() {
  return mean_and_cv<LognormalDuration>();
}
std::vector<Field> StructFields<GammaDuration>::fields() {
  return mean_and_cv<GammaDuration>();
}
std::vector<Field> StructFields<WeibullDuration>::fields() {
  return mean_and_cv<WeibullDuration>();
}

std::vector<Field> StructFields<EmpiricalDuration>::fields() {
  using D = EmpiricalDuration;
  return {entries(need<D>(&D::values_min, "values_min", "min", duration_min, "observed values, in any order"),
                  2, 10'000),
          entries(may<D>(&D::weights, "weights", "1", closed(0, 1e9),
                         "weight of every value, such as how often it was seen; empty: the same for all"),
                  0, 10'000),
          may<D>(&D::between, "between", "-", no_range(),
                 "linear: evenly between neighbouring values; step: only observed values occur")};
}

std::vector<Field> StructFields<EdgeLife>::fields() {
  return {may<EdgeLife>(&EdgeLife::law, "law", "-", no_range(), "life law of an edge"),
          may<EdgeLife>(&EdgeLife::cv, "cv", "1", closed(0.05, 2),
                        "coefficient of variation of life (normal law: 0.05 to 0.45)"),
          need<EdgeLife>(&EdgeLife::mean_ref_min, "mean_ref_min", "min", open_low(0, 1e6),
                         "mean edge life at the reference regime"),
          need<EdgeLife>(&EdgeLife::cutting_speed_ref_m_min, "cutting_speed_ref_m_min", "m/min",
                         open_low(0, 1e5), "cutting speed of the reference regime"),
          need<EdgeLife>(&EdgeLife::feed_ref_mm_rev, "feed_ref_mm_rev", "mm/rev", open_low(0, 100),
                         "feed of the reference regime"),
          need<EdgeLife>(&EdgeLife::depth_of_cut_ref_mm, "depth_of_cut_ref_mm", "mm", open_low(0, 1000),
                         "depth of cut of the reference regime"),
          may<EdgeLife>(&EdgeLife::speed_exponent, "speed_exponent", "1", open_low(1, 50),
                        "mu: mean life goes as V^-mu"),
          may<EdgeLife>(&EdgeLife::feed_exponent, "feed_exponent", "1", closed(0, 5),
                        "y: speed at equal life goes as S^-y"),
          may<EdgeLife>(&EdgeLife::depth_exponent, "depth_exponent", "1", closed(0, 5),
                        "x: speed at equal life goes as t^-x")};
}

std::vector<Field> StructFields<MachineLimits>::fields() {
  using M = MachineLimits;
  return {
      may<M>(&M::power_kw, "power_kw", "kW", open_low(0, 1e5), "spindle power"),
      may<M>(&M::spindle_speed_max_rpm, "spindle_speed_max_rpm", "rpm", open_low(0, 1e6),
             "highest spindle speed"),
      may<M>(&M::spindle_speed_min_rpm, "spindle_speed_min_rpm", "rpm", closed(0, 1e6),
             "lowest spindle speed"),
      may<M>(&M::torque_max_nm, "torque_max_nm", "N m", open_low(0, 1e7), "largest spindle torque"),
      may<M>(&M::feed_force_max_n, "feed_force_max_n", "N", open_low(0, 1e8), "largest feed force"),
      may<M>(&M::feed_rate_max_mm_min, "feed_rate_max_mm_min", "mm/min", open_low(0, 1e7), "fastest feed"),
      may<M>(&M::safety_clutch, "safety_clutch", "-", no_range(), "safety clutch of the drive")};
}

}  // namespace verstat::models

namespace verstat::operations {

namespace {

double weight_of(const EmpiricalDuration& d, std::size_t k) {
  return d.weights.empty() ? 1 : d.weights[k];
}

double mean_of(const EmpiricalDuration& d) {
  std::vector<std::size_t> order(d.values_min.size());
  std::iota(order.begin(), order.end(), 0);
  std::erase_if(order, [&](std::size_t k) { return !(weight_of(d, k) > 0); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return d.values_min[a] < d.values_min[b]; });
  // Step: the weighted mean. Linear: between two neighbours lies half the weight of each, evenly spread.
  double sum = 0;
  double weight = 0;
  const auto add = [&](double w, double value) {
    sum += w * value;
    weight += w;
  };
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (d.between == BetweenValues::step)
      add(weight_of(d, order[k]), d.values_min[order[k]]);
    else if (k > 0)
      add((weight_of(d, order[k - 1]) + weight_of(d, order[k])) / 2,
          (d.values_min[order[k - 1]] + d.values_min[order[k]]) / 2);
  }
  return sum / weight;
}

}  // namespace

double mean_min(const Duration& duration) {
  struct Mean {
    double operator()(const ConstantDuration& d) const { return d.value_min; }
    double operator()(const ExponentialDuration& d) const { return 1 / d.rate_per_min; }
    double operator()(const UniformDuration& d) const { return (d.low_min + d.high_min) / 2; }
    double operator()(const TriangularDuration& d) const { return (d.low_min + d.mode_min + d.high_min) / 3; }
    double operator()(const LognormalDuration& d) const { return d.mean_min; }
    double operator()(const GammaDuration& d) const { return d.mean_min; }
    double operator()(const WeibullDuration& d) const { return d.mean_min; }
    double operator()(const EmpiricalDuration& d) const { return mean_of(d); }
  };
  return std::visit(Mean{}, duration);
}

void check_duration(const Duration& duration, const std::string& name) {
  if (const auto* u = std::get_if<UniformDuration>(&duration))
    models::require(u->low_min <= u->high_min, name + "/low_min", u->low_min,
                    fmt::format("must not be above high_min = {}", u->high_min));
  if (const auto* t = std::get_if<TriangularDuration>(&duration)) {
    models::require(t->low_min <= t->mode_min, name + "/low_min", t->low_min,
                    fmt::format("must not be above mode_min = {}", t->mode_min));
    models::require(t->mode_min <= t->high_min, name + "/mode_min", t->mode_min,
                    fmt::format("must not be above high_min = {}", t->high_min));
  }
  if (const auto* e = std::get_if<EmpiricalDuration>(&duration)) {
    if (!e->weights.empty())
      models::require(e->weights.size() == e->values_min.size(), name + "/weights",
                      static_cast<double>(e->weights.size()),
                      fmt::format("must have one weight for each of the {} values", e->values_min.size()));
    const auto heavy = std::count_if(e->weights.begin(), e->weights.end(), [](double w) { return w > 0; });
    models::require(e->weights.empty() || heavy >= 2, name + "/weights", static_cast<double>(heavy),
                    "must be above 0 for at least two values");
  }
}

}  // namespace verstat::operations
