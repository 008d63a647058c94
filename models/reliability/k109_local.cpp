#include "models/reliability/detail/k109_local.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include <boost/math/special_functions/gamma.hpp>

#include "models/math/policy.h"

namespace verstat::models::k109::detail {
namespace {

using Complex = std::complex<double>;

// The [6/7] Pade approximation of exp as partial fractions, sum of residue/(x - pole): L-stable, so that
// stages that are over within a step just vanish (it is the step of the Radau IIA method with 7 stages).
// Only poles with a non-negative imaginary part; the others are their conjugates.
struct PadeTerm {
  Complex pole, residue;
};
std::vector<PadeTerm> pade_terms() {
  constexpr int upper = 6;
  constexpr int lower = 7;
  // Coefficient of x^j in a Pade polynomial of degree n: (13-j)! n!/(13! j! (n-j)!).
  const auto coefficient = [](int n, int j) {
    double c = 1;
    for (int i = 0; i < j; ++i) c *= static_cast<double>(n - i) / ((upper + lower - i) * (i + 1.0));
    return c;
  };
  const auto numerator = [&](Complex x) {
    Complex sum = 0;
    for (int j = upper; j >= 0; --j) sum = sum * x + coefficient(upper, j);
    return sum;
  };
  const auto denominator = [&](Complex x) {
    Complex sum = 0;
    for (int j = lower; j >= 0; --j) sum = sum * x + (j % 2 == 0 ? 1 : -1) * coefficient(lower, j);
    return sum;
  };
  // All roots at once (Durand, Kerner).
  const double lead = -coefficient(lower, lower);
  std::array<Complex, lower> roots;
  for (std::size_t k = 0; k < lower; ++k)
    roots[k] = 5.0 * std::pow(Complex(0.4, 0.9), static_cast<double>(k));
  const auto spread = [&](std::size_t k) {
    Complex product = lead;
    for (std::size_t i = 0; i < lower; ++i)
      if (i != k) product *= roots[k] - roots[i];
    return product;
  };
  for (int round = 0; round < 200; ++round)
    for (std::size_t k = 0; k < lower; ++k) roots[k] -= denominator(roots[k]) / spread(k);
  std::vector<PadeTerm> terms;
  for (std::size_t k = 0; k < lower; ++k)
    if (roots[k].imag() > -1e-6) terms.push_back({roots[k], numerator(roots[k]) / spread(k)});
  return terms;
}

}  // namespace

LocalSharing::LocalSharing(int teeth, int failed_allowed, double alpha) : teeth_(teeth) {
  std::vector<int> index(std::size_t{1} << teeth, -1);
  std::vector<unsigned> level{full()};
  add(full(), index);
  for (int failed = 0; failed <= failed_allowed; ++failed) {
    std::vector<unsigned> next;
    for (const unsigned pattern : level) {
      const int from = index[pattern];
      for (int tooth = 0; tooth < teeth; ++tooth) {
        if ((pattern >> tooth & 1U) == 0) continue;
        const double rate = std::pow(gap_before(pattern, tooth), alpha);
        total_[static_cast<std::size_t>(from)] += rate;
        if (failed == failed_allowed) continue;  // the next failure absorbs
        const unsigned to = canonical(pattern & ~(1U << tooth));
        if (index[to] < 0) {
          add(to, index);
          next.push_back(to);
        }
        inflow_[static_cast<std::size_t>(index[to])].push_back({from, rate});
      }
    }
    level = std::move(next);
  }
}

unsigned LocalSharing::canonical(unsigned pattern) const {
  unsigned least = pattern;
  for (int k = 1; k < teeth_; ++k) {
    pattern = ((pattern << 1) | (pattern >> (teeth_ - 1))) & full();
    least = std::min(least, pattern);
  }
  return least;
}

int LocalSharing::gap_before(unsigned pattern, int tooth) const {
  int gap = 1;
  while (gap < teeth_ && (pattern >> ((tooth - gap + teeth_) % teeth_) & 1U) == 0) ++gap;
  return gap;
}

void LocalSharing::add(unsigned pattern, std::vector<int>& index) {
  index[pattern] = static_cast<int>(total_.size());
  total_.push_back(0);
  inflow_.emplace_back();
}

double LocalSharing::reliability(double exposure) const {
  if (exposure == 0) return 1;
  const auto [slowest, fastest] = std::minmax_element(total_.begin(), total_.end());
  if (*slowest * exposure > 1000) return 0;
  // Uniformization costs a sweep for every expected jump; a lone tooth of 16 jumps up to 16^4 times as fast.
  const double alive = *fastest * exposure <= 400 ? by_uniformization(*fastest, exposure)
                                                  : by_implicit_steps(*fastest, exposure);
  return std::clamp(alive, 0.0, 1.0);
}

double LocalSharing::by_uniformization(double fastest, double exposure) const {
  const double jumps = fastest * exposure;
  std::vector<double> p(total_.size(), 0.0);
  p[0] = 1;
  double alive = 1;
  double weight = std::exp(-jumps);
  double sum = weight;
  for (int k = 1; !(k > jumps && weight < 1e-18); ++k) {
    alive = 0;
    for (std::size_t s = p.size(); s-- > 0;) {  // from many failures to few: predecessors are still old
      p[s] *= 1 - total_[s] / fastest;
      for (const Inflow& in : inflow_[s]) p[s] += p[static_cast<std::size_t>(in.from)] * (in.rate / fastest);
      alive += p[s];
    }
    weight *= jumps / k;
    sum += weight * alive;
  }
  return sum;
}

double LocalSharing::by_implicit_steps(double fastest, double exposure) const {
  const std::vector<PadeTerm> terms = pade_terms();
  const double slow = static_cast<double>(teeth_);  // rate of the fresh mill
  std::vector<double> p(total_.size(), 0.0);
  p[0] = 1;
  std::vector<Complex> y(total_.size());
  std::vector<double> next(total_.size());
  // Steps grow with the time passed: a stage of rate a has decayed by exp(-a t) when a step reaches 0.35 t.
  for (double passed = 0; passed < exposure;) {
    const double wanted = std::min(std::max(0.5 / fastest, 0.35 * passed), 1 / slow);
    const double left = exposure - passed;
    const double h = wanted >= left ? left : std::min(wanted, left / 2);
    std::fill(next.begin(), next.end(), 0.0);
    for (const PadeTerm& term : terms) {
      const double both = std::abs(term.pole.imag()) < 1e-6 ? 1 : 2;  // with its conjugate
      for (std::size_t s = 0; s < y.size(); ++s) {
        double real = p[s];
        double imag = 0;
        for (const Inflow& in : inflow_[s]) {
          const Complex& from = y[static_cast<std::size_t>(in.from)];
          real -= h * in.rate * from.real();
          imag -= h * in.rate * from.imag();
        }
        y[s] = Complex(real, imag) / (-h * total_[s] - term.pole);
        next[s] += both * (term.residue * y[s]).real();
      }
    }
    p.swap(next);
    passed = h == left ? exposure : passed + h;
  }
  return std::accumulate(p.begin(), p.end(), 0.0);
}

}  // namespace verstat::models::k109::detail
