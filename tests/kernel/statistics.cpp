// Tallies, sketches, histograms, output analysis, replications.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

TEST_CASE("a tally is exact where naive sums are not", "[tally]") {
  Tally tally;
  for (const double x : {1e9 + 4.0, 1e9 + 7.0, 1e9 + 13.0, 1e9 + 16.0}) tally.add(x);
  CHECK(tally.mean() == 1e9 + 10.0);
  CHECK(tally.variance() == Approx(30.0).epsilon(1e-12));
  CHECK(tally.min() == 1e9 + 4.0);
  CHECK(tally.max() == 1e9 + 16.0);
  CHECK(Tally().mean() == 0.0);
  CHECK(Tally().variance() == 0.0);
}

TEST_CASE("property: merging tallies is the same as one tally", "[tally]") {
  const bool passed = rc::check("merge", [](std::vector<int> a, std::vector<int> b) {
    Tally one;
    Tally left;
    Tally right;
    for (const int x : a) {
      one.add(x % 1000);
      left.add(x % 1000);
    }
    for (const int x : b) {
      one.add(x % 1000);
      right.add(x % 1000);
    }
    left.merge(right);
    RC_ASSERT(left.count() == one.count());
    RC_ASSERT(std::abs(left.mean() - one.mean()) < 1e-9);
    RC_ASSERT(std::abs(left.variance() - one.variance()) < 1e-6);
    RC_ASSERT(left.min() == one.min());
    RC_ASSERT(left.max() == one.max());
  });
  CHECK(passed);
}

TEST_CASE("time-weighted averages", "[tally]") {
  TimeWeighted level(10.0, 2.0);
  level.set(12.0, 5.0);
  level.change(13.0, -4.0);
  CHECK(level.mean(15.0) == Approx((2.0 * 2.0 + 5.0 + 2.0) / 5.0));
  CHECK(level.max() == 5.0);
  CHECK(level.min() == 1.0);
  level.reset(15.0);
  CHECK(level.mean(15.0) == 1.0);
  level.set(16.0, 3.0);
  CHECK(level.mean(17.0) == 2.0);
}

TEST_CASE("the quantile sketch is exact when small, close when large, bounded always", "[quantile]") {
  QuantileSketch small;
  for (const double x : {5.0, 1.0, 3.0, 2.0, 4.0}) small.add(x);
  CHECK(small.quantile(0.5) == 3.0);
  CHECK(small.quantile(0.0) == 1.0);
  CHECK(small.quantile(1.0) == 5.0);
  CHECK_THROWS_AS(QuantileSketch().quantile(0.5), std::invalid_argument);
  CHECK_THROWS_AS(small.add(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  CHECK_THROWS_AS(small.quantile(1.1), std::invalid_argument);

  // Sorted, reversed and random order of an exponential grid: errors in rank.
  constexpr int n = 200'000;
  std::vector<double> grid(n);
  for (int i = 0; i < n; ++i) grid[static_cast<std::size_t>(i)] = -std::log1p(-(i + 0.5) / n);
  for (int order = 0; order < 3; ++order) {
    std::vector<double> values = grid;
    if (order == 1) std::reverse(values.begin(), values.end());
    if (order == 2) {
      RandomStream random(1, "shuffle", "order");
      for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
    }
    QuantileSketch whole;
    QuantileSketch half;
    QuantileSketch other;
    for (std::size_t i = 0; i < values.size(); ++i) {
      whole.add(values[i]);
      (i % 2 == 0 ? half : other).add(values[i]);
    }
    half.merge(other);
    CHECK(whole.centroids() < 250);
    for (const QuantileSketch* sketch : {&whole, &half}) {
      CHECK(sketch->count() == n);
      for (const double p : {0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999}) {
        const double rank = -std::expm1(-sketch->quantile(p));
        // Size of a centroid at p, in rank, with a margin: 4 sqrt(p (1 - p)) pi / (2 delta).
        CHECK(std::abs(rank - p) < 4.0 * std::sqrt(p * (1.0 - p)) * M_PI / 200.0 / 2.0);
      }
      CHECK(sketch->quantile(1.0) == grid.back());
    }
  }
}

TEST_CASE("histograms count everything once", "[histogram]") {
  Histogram histogram(0.0, 1.0, 4);
  for (const double x : {-0.1, 0.0, 0.24, 0.25, 0.999, 1.0, 7.0}) histogram.add(x);
  CHECK(histogram.count(0) == 2);
  CHECK(histogram.count(1) == 1);
  CHECK(histogram.count(2) == 0);
  CHECK(histogram.count(3) == 1);
  CHECK(histogram.below() == 1);
  CHECK(histogram.above() == 2);
  CHECK(histogram.total() == 7);
  CHECK(histogram.lower_edge(3) == 0.75);
  Histogram other(0.0, 1.0, 4);
  other.add(0.3);
  histogram.merge(other);
  CHECK(histogram.count(1) == 2);
  CHECK_THROWS_AS(histogram.merge(Histogram(0.0, 2.0, 4)), std::invalid_argument);
  CHECK_THROWS_AS(Histogram(1.0, 1.0, 4), std::invalid_argument);
}

TEST_CASE("Student's t: table values", "[intervals]") {
  // Abramowitz and Stegun, table 26.10 (three decimals).
  CHECK(std::abs(student_t(0.95, 1) - 12.706) < 0.0005);
  CHECK(std::abs(student_t(0.95, 10) - 2.228) < 0.0005);
  CHECK(std::abs(student_t(0.99, 4) - 4.604) < 0.0005);
  CHECK(std::abs(student_t(0.90, 30) - 1.697) < 0.0005);
  Tally tally;
  for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0}) tally.add(x);
  const ConfidenceInterval interval = confidence_interval(tally);
  CHECK(interval.half_width == Approx(2.776445 * std::sqrt(2.5 / 5.0)).epsilon(1e-6));
  CHECK(interval.contains(3.0));
  CHECK_FALSE(interval.contains(5.1));
  Tally single;
  single.add(1.0);
  CHECK_THROWS_WITH(confidence_interval(single), "confidence interval: 1 observations, at least 2 needed");
  CHECK_THROWS_AS(confidence_interval(tally, 1.0), std::invalid_argument);
}

TEST_CASE("paired differences need pairs", "[intervals]") {
  const std::vector<double> a = {3.0, 5.0, 4.0};
  const std::vector<double> b = {1.0, 3.5, 1.5};
  const ConfidenceInterval interval = paired_difference(a, b);
  CHECK(interval.mean == Approx(2.0));
  CHECK(interval.half_width == Approx(4.302653 * 0.5 / std::sqrt(3.0)).epsilon(1e-6));
  CHECK_THROWS_AS(paired_difference(a, std::vector<double>{1.0}), std::invalid_argument);
}

TEST_CASE("batch means drop the start and average the rest", "[intervals]") {
  const std::vector<double> series = {100.0, 1.0, 3.0, 5.0, 7.0};
  const Tally means = batch_means(series, 2);
  CHECK(means.count() == 2);
  CHECK(means.mean() == 4.0);
  CHECK(means.variance() == 8.0);
  CHECK_THROWS_AS(batch_means(series, 1), std::invalid_argument);
  CHECK_THROWS_AS(batch_means(series, 6), std::invalid_argument);

  BatchMeans streamed(4);
  Tally all;
  for (int i = 0; i < 64; ++i) {
    streamed.add(i);
    all.add(i);
  }
  CHECK(streamed.batch_size() == 16);
  CHECK(streamed.batches().count() == 4);
  CHECK(streamed.batches().mean() == Approx(all.mean()));
}

TEST_CASE("MSER-5 finds the end of a transient", "[intervals]") {
  RandomStream random(1, "series", "noise");
  const Distribution noise = Distribution::normal(0.0, 1.0);
  std::vector<double> series;
  for (int i = 0; i < 4000; ++i)
    series.push_back(10.0 + noise.sample(random) - (i < 300 ? 8.0 * (300 - i) / 300.0 : 0.0));
  const Truncation truncation = mser5(series);
  CHECK(truncation.reliable);
  CHECK(truncation.drop % 5 == 0);
  CHECK(truncation.drop > 200);
  CHECK(truncation.drop < 500);
  // The brute force: all cuts that leave five groups.
  std::vector<double> groups;
  for (std::size_t i = 0; i + 5 <= series.size(); i += 5) {
    groups.push_back((series[i] + series[i + 1] + series[i + 2] + series[i + 3] + series[i + 4]) / 5.0);
  }
  double best = 1e300;
  std::size_t cut = 0;
  for (std::size_t d = 0; d + 5 <= groups.size(); ++d) {
    double mean = 0.0;
    for (std::size_t i = d; i < groups.size(); ++i) mean += groups[i];
    const double m = static_cast<double>(groups.size() - d);
    mean /= m;
    double squares = 0.0;
    for (std::size_t i = d; i < groups.size(); ++i) squares += (groups[i] - mean) * (groups[i] - mean);
    if (squares / (m * m) < best) {
      best = squares / (m * m);
      cut = 5 * d;
    }
  }
  CHECK(truncation.drop == cut);
  // Only a trend: never settled.
  std::vector<double> trend;
  for (int i = 0; i < 1000; ++i) trend.push_back(i);
  CHECK_FALSE(mser5(trend).reliable);
  CHECK_THROWS_AS(mser5(std::vector<double>(9, 1.0)), std::invalid_argument);
}

namespace {

/// Many things whose order could go wrong, boiled down to one number.
double shop_number(std::size_t replication) {
  Simulation sim;
  Resource resource(sim, "r", 2);
  Store<double> store(sim, 3);
  Tally tally;
  for (int i = 0; i < 6; ++i) {
    sim.spawn(
        "p" + std::to_string(i),
        [](Simulation& s, Resource& r, Store<double>& st, RandomStream u, int me, Tally& out) -> Task<> {
          for (int k = 0; k < 50; ++k) {
            co_await s.delay(u.exponential(1.0));
            Hold hold = co_await r.acquire(me % 3);
            auto came = co_await first_of(s.delay(u.exponential(0.7)), s.delay(u.exponential(0.9)));
            hold.release();
            if (me % 2 == 0) {
              co_await st.put(s.now());
            } else {
              const double made = co_await st.get();
              out.add(s.now() - made + static_cast<double>(came.index()));
            }
          }
        }(sim, resource, store, RandomStream(5, std::to_string(i), "p", replication), i, tally));
  }
  sim.run();
  return tally.mean() + sim.now();
}

}  // namespace

TEST_CASE("replications: the same bits on 1, 2 and 8 threads", "[replications]") {
  const std::vector<double> one = run_replications(64, 1, shop_number);
  CHECK(run_replications(64, 2, shop_number) == one);
  CHECK(run_replications(64, 8, shop_number) == one);
  CHECK(run_replications(64, 0, shop_number) == one);
  CHECK(run_replications(0, 4, shop_number).empty());
  for (std::size_t i = 0; i < 64; ++i) CHECK(one[i] == shop_number(i));
}

TEST_CASE("replications: the exception of the lowest index comes out", "[replications]") {
  for (const unsigned threads : {1U, 2U, 8U}) {
    const auto fails = [](std::size_t i) {
      if (i % 7 == 5) throw std::runtime_error("replication " + std::to_string(i));
      return i;
    };
    for (int repeat = 0; repeat < 20; ++repeat) {
      CHECK_THROWS_WITH(run_replications(100, threads, fails), "replication 5");
    }
  }
}

TEST_CASE("a simulation may be destroyed in another thread than it was made in", "[replications]") {
  for (int repeat = 0; repeat < 20; ++repeat) {
    auto sim = std::make_unique<Simulation>();
    std::thread first([&] {
      for (int i = 0; i < 50; ++i) {
        sim->spawn("p", [](Simulation& s) -> Task<> {
          while (true) co_await s.delay(1.0);
        }(*sim));
      }
      sim->run_until(3.0);
    });
    first.join();
    std::thread second([&] {
      sim->run_until(6.0);
      sim.reset();
    });
    second.join();
    CHECK(sim == nullptr);
  }
}

TEST_CASE("replicate_until stops where one by one would stop, on any number of threads", "[replications]") {
  const Distribution law = Distribution::lognormal(5.0, 0.6);
  const auto replication = [&law](std::size_t i) {
    RandomStream random(3, "replication", "value", i);
    return law.sample(random);
  };
  const Precision precision(0.05, 10, 2000);
  const ReplicationOutcome one = replicate_until(precision, 1, replication);
  CHECK(one.precise);
  CHECK(one.interval.relative_half_width() <= 0.05);
  Tally tally;
  std::size_t n = 0;
  while (tally.count() < 10 || confidence_interval(tally).relative_half_width() > 0.05)
    tally.add(replication(n++));
  CHECK(one.results.size() == n);
  CHECK(one.interval.mean == tally.mean());
  CHECK(replicate_until(precision, 8, replication).results == one.results);

  const ReplicationOutcome capped = replicate_until(Precision(1e-6, 10, 30), 2, replication);
  CHECK_FALSE(capped.precise);
  CHECK(capped.results.size() == 30);
  CHECK_THROWS_AS(replicate_until(Precision(0.05, 1, 30), 1, replication), std::invalid_argument);
}

TEST_CASE("Wilson's interval holds the probability as often as it says", "[output]") {
  // Newcombe (Stat. Med. 17 (1998) 857), method 3: 81 of 263 and 0 of 20.
  const ProbabilityInterval common = wilson_interval(81, 263);
  CHECK(common.low == Approx(0.2553).margin(5e-5));
  CHECK(common.high == Approx(0.3662).margin(5e-5));
  const ProbabilityInterval never = wilson_interval(0, 20);
  CHECK(never.low == 0);
  CHECK(never.high == Approx(0.1611).margin(5e-5));
  // Coverage over all outcomes of the binomial law, by summing it.
  for (const double p : {0.05, 0.3, 0.9}) {
    constexpr std::int64_t n = 200;
    double covered = 0;
    for (std::int64_t k = 0; k <= n; ++k) {
      const double x = static_cast<double>(k);
      const double chance = std::exp(std::lgamma(n + 1.0) - std::lgamma(x + 1) - std::lgamma(n - x + 1) +
                                     x * std::log(p) + (n - x) * std::log(1 - p));
      const ProbabilityInterval interval = wilson_interval(k, n);
      if (interval.low <= p && p <= interval.high) covered += chance;
    }
    CHECK(covered > 0.93);
    CHECK(covered < 0.975);
  }
  CHECK_THROWS_AS(wilson_interval(3, 2), std::invalid_argument);
  CHECK_THROWS_AS(wilson_interval(0, 0), std::invalid_argument);
}
