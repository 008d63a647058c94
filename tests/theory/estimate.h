#pragma once
// How a simulated mean is held against its theoretical value.

#include <cmath>
#include <cstddef>
#include <vector>

#include <catch2/catch.hpp>

#include "sim/kernel/kernel.h"

namespace verstat::sim::theory {

/// The mean of independent replications must lie within four standard errors of `expected`, and the standard
/// error must be small enough for an error of one percent to fail.
inline void check_mean(const char* what, const Tally& replications, double expected) {
  INFO(what << ": simulated " << replications.mean() << ", theory " << expected << ", standard error "
            << replications.standard_error());
  CHECK(std::abs(replications.mean() - expected) < 4.0 * replications.standard_error());
  CHECK(5.0 * replications.standard_error() < 0.01 * std::abs(expected));
}

/// Runs `model(random replication number, sampling)` for `pairs` antithetic pairs, each pair one observation
/// per output, and returns a tally per output.
template <class Model>
std::vector<Tally> antithetic_pairs(std::size_t pairs, Model model) {
  std::vector<Tally> tallies;
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::vector<double> a = model(i, Sampling::plain);
    const std::vector<double> b = model(i, Sampling::antithetic);
    tallies.resize(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) tallies[k].add(0.5 * (a[k] + b[k]));
  }
  return tallies;
}

}  // namespace verstat::sim::theory
