// K109 (C2), (C3): load sharing as a pure-birth chain.
#include "models/reliability/detail/k109_chain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace verstat::models::k109::detail {
namespace {

constexpr double longest_series = 500;  // jumps of the uniformized chain in one step

// Occupancy after `jumps` expected jumps of the chain uniformized at rate q, starting in stage `start`.
// Result: stages, then the absorbing state.
std::vector<double> series(const std::vector<double>& rates, double q, double jumps, std::size_t start) {
  const std::size_t n = rates.size();
  std::vector<double> p(n + 1, 0.0);
  p[start] = 1;
  double weight = std::exp(-jumps);
  std::vector<double> sum(n + 1, 0.0);
  sum[start] = weight;
  for (int k = 1; !(k > jumps && weight < 1e-18); ++k) {
    p[n] += p[n - 1] * (rates[n - 1] / q);
    for (std::size_t j = n - 1; j > start; --j)
      p[j] = p[j] * (1 - rates[j] / q) + p[j - 1] * (rates[j - 1] / q);
    p[start] *= 1 - rates[start] / q;
    weight *= jumps / k;
    for (std::size_t j = start; j <= n; ++j) sum[j] += weight * p[j];
  }
  return sum;
}

using Matrix = std::vector<std::vector<double>>;  // upper triangular

Matrix squared(const Matrix& t) {
  const std::size_t n = t.size();
  Matrix out(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = i; k < n; ++k) {
      const double factor = t[i][k];
      for (std::size_t j = k; j < n; ++j) out[i][j] += factor * t[k][j];
    }
    // Rows are distributions: restoring their sum keeps rounding from doubling with every squaring.
    const double sum = std::accumulate(out[i].begin(), out[i].end(), 0.0);
    for (double& x : out[i]) x /= sum;
  }
  return out;
}

}  // namespace

double load_factor(std::int64_t teeth, std::int64_t failed, double alpha) {
  return std::pow(static_cast<double>(teeth) / static_cast<double>(teeth - failed), alpha);
}

std::vector<double> stage_rates(std::int64_t teeth, std::int64_t first, std::int64_t last, double alpha) {
  std::vector<double> rates;
  for (std::int64_t j = first; j <= last; ++j)
    rates.push_back(static_cast<double>(teeth - j) * load_factor(teeth, j, alpha));
  return rates;
}

double Occupancy::alive() const {
  return std::accumulate(stage.begin(), stage.end(), 0.0);
}

Occupancy run_chain(const std::vector<double>& rates, double exposure) {
  const std::size_t n = rates.size();
  Occupancy out{std::vector<double>(n, 0.0), 0};
  if (exposure == 0) {
    out.stage[0] = 1;
    return out;
  }
  const auto [slowest, fastest] = std::minmax_element(rates.begin(), rates.end());
  if (*slowest * exposure > 1000) {  // every stage is over: survival below exp(-1000) times a polynomial
    out.absorbed = 1;
    return out;
  }
  double jumps = *fastest * exposure;
  int doublings = 0;
  while (jumps > longest_series) {
    jumps /= 2;
    ++doublings;
  }
  std::vector<double> last;
  if (doublings == 0) {
    last = series(rates, *fastest, jumps, 0);
  } else {
    Matrix step;
    for (std::size_t i = 0; i < n; ++i) step.push_back(series(rates, *fastest, jumps, i));
    step.emplace_back(n + 1, 0.0).back() = 1;
    for (int k = 0; k < doublings; ++k) step = squared(step);
    last = step.front();
  }
  out.absorbed = last.back();
  last.pop_back();
  out.stage = std::move(last);
  return out;
}

}  // namespace verstat::models::k109::detail
