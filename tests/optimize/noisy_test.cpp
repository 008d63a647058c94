// Choices under noise: the stated probability, the known optimum, the honest verdict.
#include <cmath>

#include <catch2/catch.hpp>

#include "optimize/compare.h"
#include "optimize/ranking.h"
#include "optimize/retrospective.h"
#include "sim/kernel/normal_law.h"
#include "sim/kernel/output_analysis.h"
#include "sim/kernel/random_stream.h"

using namespace verstat;
using namespace verstat::optimize;
using sim::RandomStream;

namespace {

// Standard normal by Box and Muller: two uniform numbers each.
double normal(RandomStream& stream) {
  const double r = std::sqrt(-2 * std::log(stream.uniform()));
  return r * std::cos(2 * 3.14159265358979323846 * stream.uniform());
}

}  // namespace

TEST_CASE("the chosen system is the best one in at least the promised share of 500 repetitions") {
  // The least favourable case: all others exactly the indifference worse, with different scatter; once with
  // independent replications, once with common random numbers.
  constexpr int repetitions = 500;
  constexpr double delta = 0.5;
  for (const bool common : {false, true})
    for (const std::size_t systems : {2UL, 8UL}) {
      int right = 0;
      std::int64_t taken = 0;
      for (int repetition = 0; repetition < repetitions; ++repetition) {
        const std::size_t best = static_cast<std::size_t>(repetition) % systems;
        const auto sample = [&](std::size_t system, std::int64_t first, std::int64_t count) {
          std::vector<double> values;
          for (std::int64_t r = first; r < first + count; ++r) {
            RandomStream own(11, "system " + std::to_string(system), std::to_string(repetition),
                             static_cast<std::uint64_t>(r));
            RandomStream shared(11, "all", std::to_string(repetition), static_cast<std::uint64_t>(r));
            const double scatter = 0.7 + 0.1 * static_cast<double>(system);
            double noise = normal(own);
            if (common) noise = 0.9 * normal(shared) + std::sqrt(1 - 0.81) * noise;
            values.push_back((system == best ? 0 : delta) + scatter * noise);
          }
          return values;
        };
        const Ranking ranking = select_smallest(systems, sample,
                                                {.confidence = 0.9,
                                                 .indifference = delta,
                                                 .first_replications = 10,
                                                 .max_replications = 100'000,
                                                 .batch = 5});
        CHECK(ranking.decided);
        right += ranking.best == best ? 1 : 0;
        for (const auto& s : ranking.systems) taken += s.replications;
      }
      INFO(systems << " systems, common " << common << ": right " << right << " times");
      CHECK(right >= 450);
      // It is no census: far less than what a fixed comparison of every system would take.
      CHECK(taken / repetitions < static_cast<std::int64_t>(systems) * 200);
    }
}

TEST_CASE("a budget that ends first says so; bad options are refused") {
  const auto same = [](std::size_t system, std::int64_t first, std::int64_t count) {
    std::vector<double> values;
    for (std::int64_t r = first; r < first + count; ++r) {
      RandomStream s(1, std::to_string(system), "noise", static_cast<std::uint64_t>(r));
      values.push_back(normal(s));
    }
    return values;
  };
  const Ranking r =
      select_smallest(3, same, {.indifference = 0.01, .first_replications = 5, .max_replications = 20});
  CHECK_FALSE(r.decided);
  CHECK(r.systems[0].replications == 20);
  CHECK_THROWS_AS(select_smallest(3, same, {.indifference = 0}), std::invalid_argument);
  CHECK_THROWS_AS(select_smallest(0, same, {.indifference = 1}), std::invalid_argument);
  CHECK(select_smallest(1, same, {.indifference = 1}).decided);
}

TEST_CASE("retrospective approximation finds a noisy optimum, and keeps a noisy constraint with confidence") {
  // f = (x - 0.6)^2 + (y - 0.3)^2 + noise, common to all points and of its own; g = x + y + noise <= 0.7: the
  // optimum on the line is (0.5, 0.2).
  std::int64_t replications = 0;
  const auto sample = [&](const std::vector<double>& x, std::int64_t first, std::int64_t count) {
    Rows rows;
    for (std::int64_t r = first; r < first + count; ++r) {
      RandomStream s(3, "shop", "noise", static_cast<std::uint64_t>(r));
      const double tilt = 0.02 * normal(s);
      const double level = normal(s);
      const double f = (x[0] - 0.6) * (x[0] - 0.6) + (x[1] - 0.3) * (x[1] - 0.3) + tilt * x[0] + level;
      rows.push_back({f, x[0] + x[1] + 0.02 * normal(s)});
      ++replications;
    }
    return rows;
  };
  NoisyProblem problem{.dimensions = {{{0, 1}, false, true}, {{0, 1}, false, true}}, .sample = sample};
  const RefineOptions options{.trials = 240, .first_replications = 8, .levels = 4, .neighbourhood = 0.4};
  const Refined free = refine(problem, {{0.2, 0.8}}, options);
  CHECK(free.best.x[0] == Approx(0.6).margin(0.02));
  CHECK(free.best.x[1] == Approx(0.3).margin(0.02));
  CHECK(free.replications == 64);

  problem.constraints = {{.column = 1, .at_most = true, .allowed = 0.7, .confidence = 0.95}};
  const Refined bound = refine(problem, {{0.2, 0.8}}, options);
  REQUIRE(bound.best.feasible);
  CHECK(bound.best.x[0] + bound.best.x[1] < 0.7);  // the mean itself, on the safe side
  CHECK(bound.best.x[0] + bound.best.x[1] > 0.68);
  CHECK(bound.best.x[0] == Approx(0.5).margin(0.04));
  CHECK(bound.finalists.front().x == bound.best.x);
  // Replications made once are used again.
  CHECK(replications < 2 * (240 * 64));
}

TEST_CASE("verdicts: less, more and unchanged are rarely wrong, whatever the number of looks") {
  // Paired differences of mean `shift` and standard deviation 1 around 100; one of two variants.
  const auto verdicts = [&](double shift, double indifference) {
    std::vector<int> counts(4);
    for (int repetition = 0; repetition < 300; ++repetition) {
      const auto run = [&](std::size_t variant, std::uint64_t first, std::int64_t count) {
        shop::RunResult r;
        r.kpis = {{"cost_per_part", "UAH", ""}};
        std::vector<std::optional<double>> column;
        for (std::uint64_t k = first; k < first + static_cast<std::uint64_t>(count); ++k) {
          RandomStream s(21, "run " + std::to_string(repetition), variant == 0 ? "a" : "b", k);
          RandomStream shared(21, "run " + std::to_string(repetition), "shared", k);
          const double noise = variant == 0 ? 0 : normal(s);
          r.values.push_back({100 + 20 * normal(shared) + noise + (variant == 0 ? 0 : shift)});
          column.push_back(r.values.back()[0]);
        }
        r.estimates = {shop::estimate(column)};
        return r;
      };
      const Comparison c =
          compare(2, run, {.kpis = {"cost_per_part"}, .indifference = indifference, .max_replications = 160});
      ++counts[static_cast<std::size_t>(c.differences[0][0].verdict)];
    }
    return counts;
  };
  const auto at = [](Verdict v) { return static_cast<std::size_t>(v); };
  // No difference: a wrong "less" or "more" in at most 5 % of cases (4 standard errors above: 10 %).
  const auto none = verdicts(0, 0.0005);
  CHECK(none[at(Verdict::less)] + none[at(Verdict::more)] <= 30);
  CHECK(verdicts(-3, 0.0005)[at(Verdict::less)] == 300);
  CHECK(verdicts(3, 0.0005)[at(Verdict::more)] == 300);
  CHECK(verdicts(0.05, 0.01)[at(Verdict::unchanged)] >= 285);
}
