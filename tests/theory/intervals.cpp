// Do 95 % intervals cover in 95 % of cases? And does sampling follow the laws?
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/theory/estimate.h"

using namespace verstat::sim;

namespace {

constexpr int runs = 2000;

/// Nominal 95 % must cover in 93 to 97 % of 2000 runs (four standard deviations are 1.95 %).
void check_coverage(const char* what, int covered) {
  INFO(what << ": covered " << covered << " of " << runs);
  CHECK(covered >= 0.93 * runs);
  CHECK(covered <= 0.97 * runs);
}

}  // namespace

TEST_CASE("coverage of the Student interval of replications", "[theory]") {
  int covered = 0;
  for (int run = 0; run < runs; ++run) {
    Tally tally;
    for (std::uint64_t i = 0; i < 20; ++i) {
      Simulation sim;
      Tally minima;
      sim.spawn("race", [](Simulation& s, RandomStream u, Tally& out) -> Task<> {
        for (int k = 0; k < 20; ++k) {
          const double start = s.now();
          auto came = co_await first_of(s.delay(u.exponential(1.0)), s.delay(u.exponential(2.0)));
          out.add(s.now() - start + 0.0 * static_cast<double>(came.index()));
        }
      }(sim, RandomStream(static_cast<std::uint64_t>(run), "race", "coverage", i), minima));
      sim.run();
      tally.add(minima.mean());
    }
    if (confidence_interval(tally).contains(2.0 / 3.0)) ++covered;
  }
  check_coverage("replications", covered);
}

TEST_CASE("coverage of batch means of a correlated series", "[theory]") {
  // AR(1) with correlation 0.7, mean 5; 20 batches of 200.
  const Distribution noise = Distribution::normal(0.0, 1.0);
  int fixed = 0;
  int growing = 0;
  for (int run = 0; run < runs; ++run) {
    RandomStream random(static_cast<std::uint64_t>(run), "series", "coverage");
    std::vector<double> series;
    BatchMeans streamed(10);
    double x = noise.sample(random) / std::sqrt(1.0 - 0.49);
    for (int i = 0; i < 4000; ++i) {
      x = 0.7 * x + noise.sample(random);
      series.push_back(5.0 + x);
      streamed.add(5.0 + x);
    }
    if (confidence_interval(batch_means(series, 20)).contains(5.0)) ++fixed;
    if (confidence_interval(streamed.batches()).contains(5.0)) ++growing;
  }
  check_coverage("batch means", fixed);
  check_coverage("batch means in bounded memory", growing);
}

TEST_CASE("coverage of paired comparisons, which are narrower than independent ones", "[theory]") {
  int covered = 0;
  double paired_width = 0.0;
  double independent_width = 0.0;
  const Distribution slow = Distribution::weibull_mean_cv(1.1, 0.5);
  const Distribution fast = Distribution::weibull_mean_cv(1.0, 0.5);
  const auto total = [](const Distribution& law, std::uint64_t seed, std::uint64_t i) {
    RandomStream random(seed, "machine", "time", i);
    double sum = 0.0;
    for (int k = 0; k < 10; ++k) sum += law.sample(random);
    return sum;
  };
  for (int run = 0; run < runs; ++run) {
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> other;
    const auto seed = static_cast<std::uint64_t>(run);
    for (std::uint64_t i = 0; i < 10; ++i) {
      a.push_back(total(slow, seed, i));
      b.push_back(total(fast, seed, i));
      other.push_back(total(fast, seed + 1'000'000, i));
    }
    const ConfidenceInterval paired = paired_difference(a, b);
    if (paired.contains(1.0)) ++covered;
    paired_width += paired.half_width;
    independent_width += paired_difference(a, other).half_width;
  }
  check_coverage("paired", covered);
  CHECK(paired_width < 0.2 * independent_width);
}

TEST_CASE("every law: samples have its mean, variance and distribution", "[theory]") {
  const std::vector<Distribution> laws = {
      Distribution::constant(3.0),
      Distribution::uniform(-1.0, 4.0),
      Distribution::triangular(1.0, 2.0, 5.0),
      Distribution::triangular(1.0, 1.0, 5.0),
      Distribution::exponential(2.5),
      Distribution::erlang(4, 2.0),
      Distribution::gamma(0.6, 3.0),
      Distribution::gamma(7.3, 0.4),
      Distribution::normal(10.0, 3.0),
      Distribution::truncated_normal(10.0, 3.0, 8.0, 20.0),
      Distribution::truncated_normal(0.0, 1.0, 2.0, 3.0),
      Distribution::truncated_normal(0.0, 1.0, 5.0, 1e300),
      Distribution::lognormal(5.0, 0.8),
      Distribution::weibull(20.0, 1.8),
      Distribution::weibull(3.0, 0.7),
      Distribution::weibull_mean_cv(12.0, 0.3),
      Distribution::beta(2.0, 5.0),
      Distribution::beta(0.5, 0.5, -1.0, 1.0),
      Distribution::pert(1.0, 2.0, 9.0),
      Distribution::discrete({3.0, 1.0, 2.0, 1.0}, {1.0, 2.0, 3.0, 0.5}),
      Distribution::empirical({1.0, 4.0, 2.0, 2.5, 9.0}),
  };
  constexpr int n = 100'000;
  for (const Distribution& law : laws) {
    INFO(law.describe());
    RandomStream random(17, law.describe(), "samples");
    Tally samples;
    Tally squares;
    std::vector<double> values(n);
    for (double& value : values) {
      value = law.sample(random);
      samples.add(value);
      squares.add((value - law.mean()) * (value - law.mean()));
    }
    const double tiny = 1e-12 * (1.0 + std::abs(law.mean()));
    CHECK(std::abs(samples.mean() - law.mean()) < 4.0 * samples.standard_error() + tiny);
    CHECK(std::abs(squares.mean() - law.variance()) < 4.0 * squares.standard_error() + tiny);
    // Kolmogorov-Smirnov on both sides of every sample (laws with atoms included): the 0.01 % point is
    // 2.23 / sqrt(n).
    std::sort(values.begin(), values.end());
    double worst = 0.0;
    for (int i = 0; i < n; i += 7) {
      const double x = values[static_cast<std::size_t>(i)];
      const auto below = std::lower_bound(values.begin(), values.end(), x) - values.begin();
      const auto until = std::upper_bound(values.begin(), values.end(), x) - values.begin();
      const double before = law.cdf(std::nextafter(x, -1e308));
      worst = std::max({worst, std::abs(law.cdf(x) - static_cast<double>(until) / n),
                        std::abs(before - static_cast<double>(below) / n)});
    }
    CHECK(worst < 2.23 / std::sqrt(static_cast<double>(n)));
  }
}
