// Searches, fronts and designs against problems whose answers are known.
#include "optimize/search.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "optimize/designs.h"
#include "optimize/pareto.h"
#include "sim/kernel/random_stream.h"
#include "tests/property.h"

using namespace verstat::optimize;
using verstat::sim::RandomStream;

namespace {

// Hock, Schittkowski (1981) no. 24, in a box: minimum -1 at (3, sqrt 3), two constraints active.
Measured hock_schittkowski_24(const std::vector<double>& x) {
  const double s3 = std::numbers::sqrt3;
  const double a = x[0] - 3;
  return {(a * a - 9) * x[1] * x[1] * x[1] / (27 * s3),
          {x[0] / s3 - x[1], x[0] + s3 * x[1], 6 - x[0] - s3 * x[1]}};
}

}  // namespace

TEST_CASE("constrained optima are met from inside, whatever the algorithm returns") {
  const std::vector<Bounds> box{{0, 5}, {0, 5}};
  const auto check = [&](const SearchOptions& options, double tolerance) {
    INFO(options.algorithm << " " << options.local_algorithm);
    const SearchResult r = minimize(hock_schittkowski_24, box, {1, 0.5}, options);
    REQUIRE(r.feasible);
    CHECK(violation(r.measured) == 0);
    CHECK(r.measured.value == Approx(-1).margin(tolerance));
    CHECK(r.measured.value == hock_schittkowski_24(r.x).value);
    CHECK(r.evaluations <= options.max_evaluations);
  };
  check({.max_evaluations = 4000}, 1e-6);
  for (const char* algorithm : {"LN_COBYLA", "LD_SLSQP", "LD_MMA", "LD_CCSAQ"})
    check({.algorithm = algorithm, .max_evaluations = 2000}, 1e-5);
  // A global one that knows no constraints goes by the penalty; a local one finishes.
  check({.algorithm = "GN_CRS2_LM", .local_algorithm = "LN_COBYLA", .max_evaluations = 6000}, 1e-5);
}

TEST_CASE("every algorithm of NLopt keeps to its budget and box, and repeats itself bit for bit") {
  const std::vector<Bounds> box{{-2, 2}, {-1, 3}};
  for (const std::string& algorithm : algorithms()) {
    INFO(algorithm);
    std::vector<std::vector<double>> asked[2];
    double best[2] = {0, 0};
    for (int round = 0; round < 2; ++round) {
      const SearchResult r = minimize(
          [&](const std::vector<double>& x) {
            asked[round].push_back(x);
            const double a = x[1] - x[0] * x[0];
            return Measured{100 * a * a + (1 - x[0]) * (1 - x[0]), {}};
          },
          box, {-1.2, 1}, {.algorithm = algorithm, .max_evaluations = 300, .seed = 7});
      best[round] = r.measured.value;
      CHECK(r.evaluations == static_cast<int>(asked[round].size()));
    }
    CHECK(asked[0] == asked[1]);
    CHECK(asked[0].size() <= 300);
    CHECK(best[0] <= 24.2 + 1e-9);  // of the start: never worse than what was seen
    for (const auto& x : asked[0])
      for (std::size_t k = 0; k < 2; ++k) CHECK((x[k] >= box[k].low && x[k] <= box[k].high));
  }
  CHECK_THROWS_WITH(
      minimize([](const auto&) { return Measured{}; }, {{0, 1}}, {0.5}, {.algorithm = "LN_NEWTON"}),
      Catch::Contains("LN_NEWTON"));
}

TEST_CASE("undefined regions and exceptions") {
  // Undefined left of 0.3: the optimum lies on the edge of what is defined.
  const auto r = minimize(
      [](const std::vector<double>& x) {
        return Measured{x[0] < 0.3 ? std::nan("") : x[0] + (x[1] - 0.5) * (x[1] - 0.5), {}};
      },
      {{0, 1}, {0, 1}}, {0.9, 0.9}, {.max_evaluations = 4000});
  CHECK(r.measured.value == Approx(0.3).margin(2e-3));
  const auto throwing = [](const std::vector<double>& x) -> Measured {
    if (x[0] > 0.6) throw std::runtime_error("our own words");
    return {-x[0], {}};
  };
  CHECK_THROWS_WITH(minimize(throwing, {{0, 1}}, {0.1}, {}), "our own words");
}

TEST_CASE("whole numbers and categories: the neighbourhood search finds what enumeration finds") {
  verstat::test::property("mixed search", [] {
    // A convex quadratic over 3 whole numbers in 0..11 (too many settings to search each), 1 category that
    // shifts it, and 1 continuous coordinate.
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    RandomStream stream(seed, "test", "quadratic");
    std::vector<double> centre;
    std::vector<double> weight;
    for (int k = 0; k < 4; ++k) {
      centre.push_back(stream.uniform(0, 11));
      weight.push_back(stream.uniform(0.5, 3));
    }
    const double coupling = stream.uniform(-0.4, 0.4);
    std::vector<double> shift{stream.uniform(), stream.uniform(), stream.uniform()};
    const auto f = [&](const std::vector<double>& x) {
      double sum = shift[static_cast<std::size_t>(x[3])];
      for (std::size_t k = 0; k < 3; ++k) sum += weight[k] * (x[k] - centre[k]) * (x[k] - centre[k]);
      sum += weight[3] * (x[4] - centre[3]) * (x[4] - centre[3]);
      sum += coupling * (x[0] - centre[0]) * (x[1] - centre[1]);
      return sum;
    };
    const std::vector<Dimension> dimensions{{{0, 11}, true, true},
                                            {{0, 11}, true, true},
                                            {{0, 11}, true, true},
                                            {{0, 2}, true, false},
                                            {{0, 11}, false, true}};
    const SearchResult found = minimize_mixed(
        [&](const std::vector<double>& x) {
          return Measured{f(x), {}};
        },
        dimensions, {0, 11, 5, 1, 5}, {.max_evaluations = 6000});
    double best = 1e300;
    for (double a = 0; a <= 11; ++a)
      for (double b = 0; b <= 11; ++b)
        for (double c = 0; c <= 11; ++c)
          for (double d = 0; d <= 2; ++d) best = std::min(best, f({a, b, c, d, centre[3]}));
    RC_ASSERT(found.measured.value <= best + 1e-6);
    for (std::size_t k = 0; k < 4; ++k) RC_ASSERT(found.x[k] == std::round(found.x[k]));
  });
}

TEST_CASE("few settings are all searched") {
  // The best category has the narrowest valley.
  const std::vector<Dimension> dimensions{{{0, 3}, true, false}, {{0, 1}, false, true}};
  const auto r = minimize_mixed(
      [](const std::vector<double>& x) {
        const double at = 0.2 * x[0] + 0.1;
        return Measured{std::abs(x[1] - at) * (1 + 50 * x[0]) - x[0], {}};
      },
      dimensions, {0, 0.5}, {.max_evaluations = 4000});
  CHECK(r.x[0] == 3);
  CHECK(r.x[1] == Approx(0.7).margin(1e-4));
  CHECK(r.evaluations <= 4000);
}

TEST_CASE("hypervolume, dominance and knee") {
  CHECK(hypervolume({{1, 1}}, {3, 4}) == Approx(6));
  CHECK(hypervolume({{1, 3}, {2, 2}, {3, 1}}, {4, 4}) == Approx(3 + 2 + 1));
  CHECK(hypervolume({{1, 1}, {5, 0}}, {3, 3}) == Approx(4));  // outside the reference adds nothing
  // Three objectives: inclusion and exclusion of two boxes.
  CHECK(hypervolume({{0, 0, 2}, {1, 1, 0}}, {2, 3, 3}) == Approx(6 * 1 + 1 * 2 * 3 - 1 * 2 * 1));
  verstat::test::property("hypervolume of random sets against counting cells", [] {
    const auto points = *rc::gen::container<std::vector<std::vector<double>>>(
        *rc::gen::inRange(1, 7),
        rc::gen::map(rc::gen::container<std::vector<int>>(3, rc::gen::inRange(0, 7)),
                     [](const std::vector<int>& v) { return std::vector<double>(v.begin(), v.end()); }));
    int cells = 0;
    for (int a = 0; a < 6; ++a)
      for (int b = 0; b < 6; ++b)
        for (int c = 0; c < 6; ++c)
          cells += std::any_of(points.begin(), points.end(),
                               [&](const auto& p) { return p[0] <= a && p[1] <= b && p[2] <= c; });
    RC_ASSERT(std::abs(hypervolume(points, {6, 6, 6}) - cells) < 1e-9);
    std::vector<std::vector<double>> kept;
    for (const std::size_t k : nondominated(points)) kept.push_back(points[k]);
    RC_ASSERT(std::abs(hypervolume(kept, {6, 6, 6}) - cells) < 1e-9);
  });
  CHECK(knee({{0, 1}, {0.1, 0.2}, {0.5, 0.1}, {1, 0}}) == 1);
}

TEST_CASE("the epsilon-constraint front of two parabolas is the known curve") {
  // Minima of (x - 0)^2 + y^2 and (x - 1)^2 + y^2: the front is f2 = (1 - sqrt f1)^2, y = 0.
  const auto measure = [](const std::vector<double>& x) {
    return ManyMeasured{{x[0] * x[0] + x[1] * x[1], (x[0] - 1) * (x[0] - 1) + x[1] * x[1]}, {}};
  };
  const std::vector<Dimension> dimensions{{{-1, 2}, false, true}, {{-1, 1}, false, true}};
  const Front front = pareto_front(measure, dimensions, {1.5, 0.7}, 2, 11, {.max_evaluations = 800});
  REQUIRE(front.points.size() >= 10);
  for (const FrontPoint& p : front.points) {
    const double s = 1 - std::sqrt(p.objectives[0]);
    CHECK(p.objectives[1] == Approx(s * s).margin(1e-4));
  }
  // The curve is symmetric: its knee lies in the middle, at f1 = f2 = 1/4.
  CHECK(front.points[front.knee].objectives[0] == Approx(0.25).margin(0.06));
  // Volume below the reference (1.1, 1.1): 1.1^2 less the area under the curve, which the steps approach from
  // below.
  const double whole = 1.21 - (0.0 + 1.0 / 6.0) - 0.0;
  CHECK(front.hypervolume < whole);
  CHECK(front.hypervolume > whole - 0.08);
}

TEST_CASE("fractions have the resolution of the tables, and are balanced") {
  struct Case {
    int factors, q, resolution;
  };
  // Box, Hunter, Hunter, Statistics for Experimenters, table of fractional designs.
  for (const Case& c :
       {Case{3, 2, 3}, Case{4, 3, 4}, Case{5, 4, 5}, Case{6, 5, 6}, Case{5, 3, 3}, Case{6, 4, 4},
        Case{7, 3, 3}, Case{7, 4, 4}, Case{8, 4, 4}, Case{7, 6, 7}, Case{8, 6, 5}, Case{9, 5, 4}}) {
    INFO(c.factors << " factors in 2^" << c.q);
    const Design d = fractional_factorial(c.factors, c.q);
    CHECK(d.resolution == c.resolution);
    CHECK(d.points.size() == (1U << c.q));
    for (std::size_t a = 0; a < static_cast<std::size_t>(c.factors); ++a)
      for (std::size_t b = 0; b <= a; ++b) {
        double dot = 0;
        for (const auto& p : d.points) dot += p[a] * p[b];
        CHECK(dot == (a == b ? static_cast<double>(d.points.size()) : 0.0));
      }
  }
  CHECK_THROWS_AS(fractional_factorial(8, 3), std::invalid_argument);
}

TEST_CASE("space-filling designs fill space") {
  const Design lhs = latin_hypercube(3, 20, 5);
  for (std::size_t f = 0; f < 3; ++f) {
    std::vector<int> cell;
    for (const auto& p : lhs.points) cell.push_back(static_cast<int>((p[f] + 1) / 2 * 20));
    std::sort(cell.begin(), cell.end());
    std::vector<int> every(20);
    std::iota(every.begin(), every.end(), 0);
    CHECK(cell == every);
  }
  CHECK(latin_hypercube(3, 20, 5).points == lhs.points);
  CHECK(latin_hypercube(3, 20, 6).points != lhs.points);
  // The mean of x^2 y^2 over the square is 1/9: Sobol is closer than the 4 standard errors of chance.
  double sum = 0;
  for (const auto& p : sobol(2, 1024).points) sum += p[0] * p[0] * p[1] * p[1];
  CHECK(sum / 1024 == Approx(1.0 / 9).margin(0.001));
  CHECK(full_factorial({2, 3}).points ==
        std::vector<std::vector<double>>{{-1, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {1, 1}});
}

TEST_CASE("effects of a polynomial are its coefficients, and aliases are named") {
  const auto response = [](const std::vector<double>& x) {
    return 10 + 3 * x[0] - 2 * x[1] + 0.5 * x[2] + 1.5 * x[0] * x[1];
  };
  const auto fit = [&](const Design& design) {
    std::vector<std::vector<double>> y;
    // Two replications that differ by a constant: paired, the effects have no scatter.
    for (const auto& p : design.points) y.push_back({response(p), response(p) + 7});
    return effects(design, y, 0.95);
  };
  for (const Design& d :
       {full_factorial({2, 2, 2}), full_factorial({3, 3, 3}), latin_hypercube(3, 30, 1), sobol(3, 32)}) {
    const auto found = fit(d);
    REQUIRE(found.size() == 6);
    const std::vector<double> expected{6, -4, 1, 3, 0, 0};
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(found[k].effect == Approx(expected[k]).margin(1e-9));
      CHECK(*found[k].half_width == Approx(0).margin(1e-9));
      CHECK(found[k].aliases.empty());
    }
  }
  // Half fraction of three factors: every main effect is confused with an interaction.
  const auto half = fit(fractional_factorial(3, 2));
  REQUIRE(half.size() == 3);
  CHECK(half[2].aliases == std::vector<std::vector<std::size_t>>{{0, 1}});
  CHECK(std::abs(half[2].effect - 1) ==
        Approx(3));  // 1 of its own, and 3 of the interaction with either sign
}
