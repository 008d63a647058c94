// Designs, effects, fronts, choices and samples at their borders: what is refused, ties, missing values, and
// the answers that are known.
#include <cmath>
#include <set>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "optimize/designs.h"
#include "optimize/pareto.h"
#include "optimize/ranking.h"
#include "optimize/retrospective.h"
#include "tests/property.h"

using namespace verstat::optimize;

namespace {

const double nan_value = std::nan("");

}  // namespace

TEST_CASE("designs out of their ranges are refused") {
  CHECK_THROWS_AS(full_factorial({}), std::invalid_argument);
  CHECK_THROWS_AS(full_factorial({2, 1}), std::invalid_argument);
  CHECK_THROWS_AS(full_factorial({1001, 1000}), std::invalid_argument);
  CHECK_THROWS_AS(fractional_factorial(3, 1), std::invalid_argument);
  CHECK_THROWS_AS(fractional_factorial(3, 11), std::invalid_argument);
  CHECK_THROWS_AS(fractional_factorial(1, 3), std::invalid_argument);
  CHECK_THROWS_AS(fractional_factorial(32, 6), std::invalid_argument);
  CHECK_THROWS_AS(latin_hypercube(0, 5, 1), std::invalid_argument);
  CHECK_THROWS_AS(latin_hypercube(2, 1, 1), std::invalid_argument);
  CHECK_THROWS_AS(sobol(0, 5), std::invalid_argument);
  CHECK_THROWS_AS(sobol(2, 0), std::invalid_argument);
  CHECK_THROWS_AS(one_at_a_time(0), std::invalid_argument);
}

TEST_CASE("fractions: words counted by brute force, whole factorials, and saturated ones") {
  const auto resolution_of = [](const Design& d) {
    // The shortest product of columns that is constant.
    const std::size_t k = d.points.front().size();
    int shortest = 0;
    for (unsigned set = 1; set < (1U << k); ++set) {
      const auto product = [&](const std::vector<double>& p) {
        double sign = 1;
        for (std::size_t f = 0; f < k; ++f)
          if ((set >> f) & 1U) sign *= p[f];
        return sign;
      };
      bool constant = true;
      for (const auto& p : d.points) constant = constant && product(p) == product(d.points.front());
      const int length = __builtin_popcount(set);
      if (constant && (shortest == 0 || length < shortest)) shortest = length;
    }
    return shortest;
  };
  for (int q = 2; q <= 5; ++q)
    for (int factors = 2; factors <= std::min(9, (1 << q) - 1); ++factors) {
      INFO(factors << " factors, 2^" << q);
      const Design d = fractional_factorial(factors, q);
      CHECK(d.resolution == resolution_of(d));
      std::set<std::vector<double>> different;
      for (const auto& p : d.points) different.insert(p);
      // Fewer factors than q: every corner as often as any other.
      CHECK(different.size() == std::min<std::size_t>(1U << q, 1U << factors));
    }
  // Saturated: more extra factors than are weighed one by one; still balanced and orthogonal.
  for (const auto& [factors, q] : {std::pair{31, 5}, std::pair{15, 4}, std::pair{24, 6}, std::pair{31, 10}}) {
    const Design d = fractional_factorial(factors, q);
    for (std::size_t a = 0; a < static_cast<std::size_t>(factors); ++a) {
      double sum = 0;
      for (const auto& p : d.points) sum += p[a];
      CHECK(sum == 0);
      for (std::size_t b = 0; b < a; ++b) {
        double dot = 0;
        for (const auto& p : d.points) dot += p[a] * p[b];
        CHECK(dot == 0);
      }
    }
    CHECK(d.resolution >= 3);
  }
  const Design tornado = one_at_a_time(2);
  CHECK(tornado.points == std::vector<std::vector<double>>{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}});
}

TEST_CASE("effects: shapes, missing values, one replication, a tornado") {
  const Design two = full_factorial({2, 2});
  CHECK_THROWS_WITH(effects({}, {}, 0.95), Catch::Contains("one row of responses per point"));
  CHECK_THROWS_WITH(effects(two, {{1}, {2}, {3}}, 0.95), Catch::Contains("one row of responses per point"));
  CHECK_THROWS_WITH(effects(two, {{1}, {2}, {3}, {4, 5}}, 0.95), Catch::Contains("the same replications"));
  CHECK_THROWS_WITH(effects(two, {{1}, {2}, {3}, {nan_value}}, 0.95), "no replication has all values");
  CHECK_THROWS_WITH(effects(two, {{}, {}, {}, {}}, 0.95), "no replication has all values");
  // One column has no other: nothing can be told.
  Design flat;
  flat.points = {{1.0}, {1.0}};
  CHECK_THROWS_AS(effects(flat, {{1}, {2}}, 0.95), std::invalid_argument);
  // 1 + 2 a - 3 b + 0.5 a b: effects are twice the coefficients; an incomplete replication is left out.
  std::vector<std::vector<double>> y;
  for (const auto& p : two.points) {
    const double f = 1 + 2 * p[0] - 3 * p[1] + 0.5 * p[0] * p[1];
    y.push_back({f, p[0] > 0 && p[1] > 0 ? nan_value : f + 9});
  }
  const auto one = effects(two, y, 0.95);
  REQUIRE(one.size() == 3);
  CHECK(one[0].effect == Approx(4));
  CHECK(one[1].effect == Approx(-6));
  CHECK(one[2].effect == Approx(1));
  CHECK_FALSE(one[0].half_width);
  // The effects of replications 4 +- 1: the Student interval of two values.
  for (std::size_t i = 0; i < 4; ++i)
    y[i] = {y[i][0] + 0.5 * two.points[i][0], y[i][0] - 0.5 * two.points[i][0]};
  const auto both = effects(two, y, 0.9);
  CHECK(both[0].effect == Approx(4));
  CHECK(*both[0].half_width == Approx(6.3138));  // t(0.95, 1) times 1
  // One at a time: main effects, and no interaction that could be told.
  const Design tornado = one_at_a_time(3);
  std::vector<std::vector<double>> z;
  for (const auto& p : tornado.points) z.push_back({4 * p[0] + p[1] * p[1] + p[2]});
  const auto mains = effects(tornado, z, 0.95);
  REQUIRE(mains.size() == 3);
  CHECK(mains[0].effect == Approx(8));
  CHECK(mains[2].effect == Approx(2));
  CHECK(mains[0].aliases.empty());
}

TEST_CASE("dominance, equals, hypervolume of one objective, and knees without a plane") {
  CHECK(dominates({1, 2}, {1, 3}));
  CHECK_FALSE(dominates({1, 2}, {1, 2}));
  CHECK_FALSE(dominates({1, 2}, {0, 3}));
  CHECK(nondominated({{1, 2}, {2, 1}, {1, 2}, {2, 2}, {0, 5}}) == std::vector<std::size_t>{0, 1, 4});
  CHECK(hypervolume({{3}, {1}, {7}}, {5}) == Approx(4));
  CHECK(hypervolume({{6}}, {5}) == 0);
  CHECK(hypervolume({}, {5, 5}) == 0);
  CHECK(hypervolume({{1, 2}, {1, 2}, {3, 2}}, {4, 4}) == Approx(3 * 2));
  CHECK(knee({{4, 4}}) == 0);
  CHECK(knee({{1, 5, 2}, {1, 5, 2}}) == 0);
  // All on one line: nobody stands out, the first is kept.
  CHECK(knee({{0, 1}, {0.5, 0.5}, {1, 0}}) == 0);
  // Three objectives of which one is the same everywhere.
  CHECK(knee({{0, 1, 7}, {0.2, 0.2, 7}, {1, 0, 7}}) == 1);
  // Scales do not matter.
  CHECK(knee({{0, 1000}, {0.1, 200}, {0.5, 100}, {1, 0}}) == 1);
  verstat::test::property("the knee is nowhere below another point of a convex front", [] {
    // Points of f2 = (1 - f1^p)^(1/p), p < 1: the knee is where both are nearest to equal.
    const double p = *rc::gen::inRange(30, 90) / 100.0;
    const int n = 2 * *rc::gen::inRange(2, 20);
    std::vector<std::vector<double>> front;
    for (int k = 0; k <= n; ++k) {
      const double a = std::pow(static_cast<double>(k) / n, 1 / p);
      const double b = std::pow(1 - static_cast<double>(k) / n, 1 / p);
      front.push_back({a, b});
    }
    RC_ASSERT(knee(front) == static_cast<std::size_t>(n / 2));
  });
}

TEST_CASE("fronts: three objectives, an empty one, undefined places, whole numbers") {
  const std::vector<Dimension> square{{{0, 1}, false, true}, {{0, 1}, false, true}};
  // Distances to the three corners (0,0), (1,0), (0,1): the front is the whole triangle.
  const auto corners = [](const std::vector<double>& x) {
    const auto d = [&](double a, double b) { return (x[0] - a) * (x[0] - a) + (x[1] - b) * (x[1] - b); };
    return ManyMeasured{{d(0, 0), d(1, 0), d(0, 1)}, {}};
  };
  const Front three = pareto_front(corners, square, {0.9, 0.9}, 3, 5, {.max_evaluations = 300});
  CHECK(three.points.size() >= 9);
  for (const FrontPoint& p : three.points) CHECK(p.x[0] + p.x[1] <= 1 + 2e-3);
  for (std::size_t a = 0; a < three.points.size(); ++a)
    for (std::size_t b = 0; b < three.points.size(); ++b)
      CHECK_FALSE(dominates(three.points[a].objectives, three.points[b].objectives));
  CHECK(three.hypervolume > 0);
  CHECK(three.reference.size() == 3);
  // Nothing feasible: no front.
  const Front none = pareto_front(
      [&](const std::vector<double>& x) {
        auto m = corners(x);
        m.margins = {-1};
        return m;
      },
      square, {0.5, 0.5}, 3, 3, {.max_evaluations = 60});
  CHECK(none.points.empty());
  CHECK(none.hypervolume == 0);
  // Where the second objective is undefined nothing is kept.
  const Front half = pareto_front(
      [](const std::vector<double>& x) {
        return ManyMeasured{{x[0], x[0] < 0.4 ? std::numeric_limits<double>::infinity() : 1 - x[0]}, {}};
      },
      {{{0, 1}, false, true}}, {0.9}, 2, 6, {.max_evaluations = 200});
  REQUIRE(!half.points.empty());
  for (const FrontPoint& p : half.points) CHECK(std::isfinite(p.objectives[1]));
  // Whole numbers: the front by enumeration.
  const auto whole = [](const std::vector<double>& x) {
    return ManyMeasured{{std::abs(x[0] - 2) + x[1], std::abs(x[0] - 9) + std::abs(x[1] - 3)}, {}};
  };
  std::vector<std::vector<double>> all;
  for (double a = 0; a <= 12; ++a)
    for (double b = 0; b <= 4; ++b) all.push_back(whole({a, b}).objectives);
  std::set<std::vector<double>> best;
  for (const std::size_t k : nondominated(all)) best.insert(all[k]);
  const Front found = pareto_front(whole, {{{0, 12}, true, true}, {{0, 4}, true, true}}, {0, 0}, 2, 11,
                                   {.max_evaluations = 400});
  std::set<std::vector<double>> kept;
  for (const FrontPoint& p : found.points) kept.insert(p.objectives);
  for (const auto& p : kept) CHECK(best.count(p) == 1);
  CHECK(kept.size() == best.size());
}

TEST_CASE("choices: options out of their ranges, one system, ties, systems that are equal to the last bit") {
  const auto constant = [](std::size_t system, std::int64_t, std::int64_t count) {
    return std::vector<double>(static_cast<std::size_t>(count), static_cast<double>(system % 2));
  };
  const RankingOptions good{.indifference = 0.1, .first_replications = 3, .max_replications = 12};
  CHECK_THROWS_WITH(select_smallest(0, constant, good), "a choice needs at least one system");
  const auto refused = [&](auto change) {
    RankingOptions options = good;
    change(options);
    CHECK_THROWS_WITH(select_smallest(2, constant, options),
                      Catch::StartsWith("a choice needs 0 < confidence < 1"));
  };
  refused([](RankingOptions& o) { o.confidence = 0; });
  refused([](RankingOptions& o) { o.confidence = 1; });
  refused([](RankingOptions& o) { o.indifference = 0; });
  refused([](RankingOptions& o) { o.indifference = nan_value; });
  refused([](RankingOptions& o) { o.first_replications = 2; });
  refused([](RankingOptions& o) { o.max_replications = 2; });
  refused([](RankingOptions& o) { o.batch = 0; });
  const Ranking alone = select_smallest(1, constant, good);
  CHECK(alone.decided);
  CHECK(alone.best == 0);
  CHECK(alone.systems[0].replications == 3);
  // Without noise the first sample decides; of equals the first stays.
  const Ranking four = select_smallest(4, constant, good);
  CHECK(four.decided);
  CHECK(four.best == 0);
  CHECK(four.systems[0].survived);
  for (const std::size_t k : {1UL, 2UL, 3UL}) CHECK_FALSE(four.systems[k].survived);
  CHECK(four.systems[3].mean == 1);
  CHECK(four.systems[3].half_width == 0);
  // Batches stop at the budget.
  const auto noisy = [](std::size_t system, std::int64_t first, std::int64_t count) {
    std::vector<double> v;
    for (std::int64_t r = first; r < first + count; ++r)
      v.push_back(static_cast<double>((r * 7 + static_cast<std::int64_t>(system) * 3) % 11) - 5.0);
    return v;
  };
  const Ranking cut = select_smallest(
      2, noisy, {.indifference = 1e-3, .first_replications = 4, .max_replications = 9, .batch = 4});
  CHECK_FALSE(cut.decided);
  CHECK(cut.systems[0].replications == 9);
  CHECK(cut.systems[1].replications == 9);
  CHECK(cut.best == (cut.systems[0].mean <= cut.systems[1].mean ? 0U : 1U));
}

TEST_CASE("samples: means with their sign, one-sided limits, missing values, exact margins") {
  NoisyProblem p{.sample = {}, .objective = 0, .sign = -1};
  p.constraints = {{.column = 1, .at_most = true, .allowed = 10, .confidence = 0.9},
                   {.column = 1, .at_most = false, .allowed = 2, .confidence = 0.9},
                   {.column = 2, .at_most = true, .allowed = 0, .confidence = 0.9}};
  const Rows rows{{4, 5, 1}, {6, 7, nan_value}, {5, 6, 3}, {nan_value, 6, 2}};
  const Measured m = judge(p, rows, {});
  CHECK(m.value == Approx(-5));
  // Column 1: mean 6, standard error sqrt(2/3)/2, t(0.9, 3) = 1.6377; column 2: mean 2, 1/sqrt 3, t(0.9, 2)
  // = 1.8856.
  const double limit = 1.6377 * std::sqrt(2.0 / 3) / 2;
  REQUIRE(m.margins.size() == 3);
  CHECK(m.margins[0] == Approx((10 - 6 - limit) / 10).epsilon(1e-4));
  CHECK(m.margins[1] == Approx((6 - limit - 2) / 2).epsilon(1e-4));
  CHECK(m.margins[2] == Approx(-2 - 1.8856 / std::sqrt(3)).epsilon(1e-4));  // of nothing there is no share
  const auto allowances = confidence_allowances(p, rows);
  CHECK(allowances[0] == Approx(limit / 10).epsilon(1e-4));
  CHECK(allowances[1] == Approx(limit / 2).epsilon(1e-4));
  CHECK(allowances[2] == Approx(1.8856 / std::sqrt(3)).epsilon(1e-4));
  p.exact_margins = [](const std::vector<double>& x) { return std::vector<double>{x[0], -x[0]}; };
  CHECK(judge(p, rows, {0.25}).margins.size() == 5);
  CHECK(judge(p, rows, {0.25}).margins[4] == -0.25);
  // Fewer than two values: undefined, and no allowance.
  const Rows few{{4, 5, 1}, {6, 7, nan_value}};
  CHECK(std::isinf(judge(p, few, {0.25}).value));
  CHECK(judge(p, few, {0.25}).margins[2] == -1);
  CHECK(confidence_allowances(p, few)[2] == 0);
  p.constraints.clear();
  CHECK(std::isinf(judge(p, {{1, 1, 1}}, {0.25}).value));
}

TEST_CASE(
    "refinement: whole numbers and categories near the start, the second start, the end of the budget") {
  // A noiseless parabola over a whole number, a category and a continuous number.
  std::vector<std::vector<double>> asked;
  const auto value = [](const std::vector<double>& x) {
    return std::abs(x[0] - 6) + (x[1] == 2 ? 0 : 1) + (x[2] - 0.5) * (x[2] - 0.5);
  };
  NoisyProblem p{.dimensions = {{{0, 40}, true, true}, {{0, 3}, true, false}, {{0, 1}, false, true}},
                 .sample =
                     [&](const std::vector<double>& x, std::int64_t, std::int64_t count) {
                       asked.push_back(x);
                       return Rows(static_cast<std::size_t>(count), {value(x)});
                     },
                 .objective = 0};
  const Refined r =
      refine(p, {{5, 0, 0.45}}, {.trials = 300, .first_replications = 2, .levels = 2, .neighbourhood = 0.05});
  CHECK(r.best.x[0] == 6);
  CHECK(r.best.x[1] == 2);
  CHECK(r.best.x[2] == Approx(0.5).margin(2e-3));
  CHECK(r.replications == 4);
  for (const auto& x : asked) {
    CHECK(std::abs(x[0] - 5) <= 3);  // two at first, one more from there
    CHECK(std::abs(x[2] - 0.45) <= 0.08);
  }
  // The start itself is a finalist, and each finalist comes once.
  std::set<std::vector<double>> finalists;
  for (const SearchResult& f : r.finalists) CHECK(finalists.insert(f.x).second);
  CHECK(finalists.count({5, 0, 0.45}) == 1);
  CHECK(r.finalists.front().x == r.best.x);
  // A budget that ends at the first level, from two starts of which the second is the better one.
  asked.clear();
  const Refined cut =
      refine(p, {{30, 1, 0.1}, {6, 2, 0.5}}, {.trials = 4, .first_replications = 2, .levels = 5});
  CHECK(cut.best.x == std::vector<double>{6, 2, 0.5});
  CHECK(std::set<std::vector<double>>(asked.begin(), asked.end()).size() <= 4 + 2);
  CHECK(cut.replications < 2 << 4);  // the last levels are not reached
}
