// Searches at their limits: no room, no budget, undefined starts, gradients that fail, penalties, spaces of
// whole numbers; against enumeration and closed forms.
#include <cmath>
#include <numbers>
#include <set>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "optimize/search.h"
#include "sim/kernel/random_stream.h"
#include "tests/property.h"

using namespace verstat::optimize;
using verstat::sim::RandomStream;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

SearchResult result(bool feasible, double value, std::vector<double> margins) {
  return {.x = {0}, .measured = {value, std::move(margins)}, .feasible = feasible};
}

}  // namespace

TEST_CASE("what is missing to the constraints, and which of two points is better") {
  CHECK(violation({1, {}}) == 0);
  CHECK(violation({1, {0.5, 0, -0.5 * margin_tolerance}}) == 0);
  CHECK(violation({1, {0.5, -0.2, -0.3}}) == Approx(0.5));
  CHECK(std::isinf(violation({inf, {1}})));
  CHECK(std::isinf(violation({std::nan(""), {}})));
  CHECK(std::isinf(violation({1, {std::nan("")}})));
  CHECK(better(result(true, 9, {1}), result(false, 1, {-1})));
  CHECK_FALSE(better(result(false, 1, {-1}), result(true, 9, {1})));
  CHECK(better(result(true, 1, {1}), result(true, 2, {1})));
  CHECK_FALSE(better(result(true, 2, {1}), result(true, 2, {1})));
  CHECK(better(result(false, 9, {-0.1}), result(false, 1, {-0.2})));
  CHECK_FALSE(better(result(false, 1, {-0.2}), result(false, 9, {-0.1})));
  CHECK(better(result(false, 1, {-0.2}), result(false, 2, {-0.1, -0.1})));
  CHECK_FALSE(better(result(false, 2, {-0.2}), result(false, 1, {-0.2})));
  // The order is one: of two different points at most one is better, and nothing is better than itself.
  verstat::test::property("better is a strict order", [] {
    const auto any = [] {
      const auto margin = *rc::gen::inRange(-3, 3);
      return result(margin >= 0, *rc::gen::inRange(0, 4), {0.1 * margin});
    };
    const SearchResult a = any();
    const SearchResult b = any();
    const SearchResult c = any();
    RC_ASSERT(!better(a, a));
    RC_ASSERT(!(better(a, b) && better(b, a)));
    if (better(a, b) && better(b, c)) RC_ASSERT(better(a, c));
  });
}

TEST_CASE("searches without variables, or with starts of another size, are refused") {
  const auto zero = [](const std::vector<double>&) { return Measured{}; };
  CHECK_THROWS_WITH(minimize(zero, {}, {}, {}), Catch::Contains("at least one variable"));
  CHECK_THROWS_WITH(minimize(zero, {{0, 1}}, {0.5, 0.5}, {}), Catch::Contains("a start for each"));
  CHECK_THROWS_WITH(minimize_mixed(zero, {}, {}, {}), Catch::Contains("at least one variable"));
  CHECK_THROWS_WITH(minimize_mixed(zero, {{{0, 1}, true, true}}, {}, {}),
                    Catch::Contains("a start for each"));
  CHECK_THROWS_WITH(
      minimize(zero, {{0, 1}}, {0.5}, {.algorithm = "GN_DIRECT_L", .local_algorithm = "LN_NEWTON"}),
      Catch::Contains("\"LN_NEWTON\" is unknown"));
  for (const std::string& name : algorithms()) CHECK(known_algorithm(name));
  CHECK_FALSE(known_algorithm("LN_NEWTON"));
  CHECK_FALSE(known_algorithm(""));
}

TEST_CASE("budgets of every size are kept, and the best of what was seen is the answer") {
  for (const int budget : {1, 2, 3, 5, 17, 60, 400})
    for (const bool constrained : {false, true})
      for (const bool exact : {false, true})
        for (const bool global : {false, true}) {
          std::vector<std::vector<double>> seen;
          const auto value = [](const std::vector<double>& x) {
            return (x[0] - 0.3) * (x[0] - 0.3) + 2 * (x[1] - 0.6) * (x[1] - 0.6);
          };
          const auto margins = [&](const std::vector<double>& x) {
            return constrained ? std::vector<double>{0.7 - x[0] - x[1]} : std::vector<double>{};
          };
          SearchOptions options{.max_evaluations = budget, .global = global};
          if (exact)
            options.slopes = [&](const std::vector<double>& x) -> std::optional<MeasuredSlopes> {
              MeasuredSlopes s{.value = {2 * (x[0] - 0.3), 4 * (x[1] - 0.6)}, .margins = {}};
              if (constrained) s.margins = {{-1, -1}};
              return s;
            };
          const SearchResult r = minimize(
              [&](const std::vector<double>& x) {
                seen.push_back(x);
                return Measured{value(x), margins(x)};
              },
              {{0, 1}, {0, 1}}, {0.9, 0.1}, options);
          INFO(budget << " evaluations, constrained " << constrained << ", exact " << exact << ", global "
                      << global);
          CHECK(static_cast<int>(seen.size()) <= budget);
          CHECK(r.evaluations == static_cast<int>(seen.size()));
          CHECK(seen.front() == std::vector<double>{0.9, 0.1});
          double best = inf;
          for (const auto& x : seen)
            if (!constrained || 0.7 - x[0] - x[1] >= -margin_tolerance) best = std::min(best, value(x));
          if (r.feasible) {
            CHECK(r.measured.value == best);
          } else {
            CHECK(best == inf);
          }
          if (budget < 400) continue;
          // On the line x + y = 0.7 Lagrange says (0.3 - 2 t, 0.6 - t) with 3 t = 0.2.
          CHECK(r.x[0] == Approx(constrained ? 0.3 - 0.4 / 3 : 0.3).margin(2e-4));
          CHECK(r.x[1] == Approx(constrained ? 0.6 - 0.2 / 3 : 0.6).margin(2e-4));
        }
}

TEST_CASE("one variable, a variable without room, starts outside the box") {
  const auto cosine = [](const std::vector<double>& x) { return Measured{std::cos(x[0]), {}}; };
  CHECK(minimize(cosine, {{0, 5}}, {-3}, {}).x[0] == Approx(std::numbers::pi).epsilon(1e-6));
  CHECK(minimize(cosine, {{0, 5}}, {9}, {.algorithm = "LN_NEWUOA_BOUND"}).x[0] ==
        Approx(std::numbers::pi).epsilon(1e-6));
  const auto r = minimize(
      [](const std::vector<double>& x) {
        return Measured{(x[0] - 0.4) * (x[0] - 0.4) + x[1], {}};
      },
      {{0, 1}, {3, 3}}, {0.9, 7}, {.max_evaluations = 2000});
  CHECK(r.x[1] == 3);
  CHECK(r.x[0] == Approx(0.4).margin(1e-4));
}

TEST_CASE("a start that is undefined, and a whole box that is") {
  // Right of 0.7 nothing is defined; the start lies there.
  for (const char* algorithm : {"", "GN_DIRECT_L", "GN_CRS2_LM"}) {
    INFO(algorithm);
    const auto r = minimize(
        [](const std::vector<double>& x) {
          return Measured{x[0] > 0.7 ? inf : (x[0] - 0.5) * (x[0] - 0.5) + (x[1] - 0.2) * (x[1] - 0.2),
                          {1.0}};
        },
        {{0, 1}, {0, 1}}, {0.71, 0.5}, {.algorithm = algorithm, .max_evaluations = 3000});
    REQUIRE(r.feasible);
    CHECK(r.x[0] <= 0.7);
    if (std::string(algorithm).empty()) {
      CHECK(r.x[0] == Approx(0.5).margin(2e-3));
      CHECK(r.x[1] == Approx(0.2).margin(2e-3));
    }
  }
  const auto nowhere = minimize(
      [](const auto&) {
        return Measured{std::nan(""), {1.0}};
      },
      {{0, 1}, {0, 1}}, {0.5, 0.5}, {.max_evaluations = 200});
  CHECK_FALSE(nowhere.feasible);
  CHECK(std::isinf(nowhere.measured.value));
  CHECK(nowhere.evaluations <= 200);
  const auto bad_margin = minimize(
      [](const auto&) {
        return Measured{1.0, {std::nan("")}};
      },
      {{0, 1}}, {0.5}, {.max_evaluations = 50});
  CHECK_FALSE(bad_margin.feasible);
}

TEST_CASE(
    "what the measure or its slopes throw comes out unchanged, from the first point and from a later one") {
  struct Ours : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  for (const int at : {1, 2, 9})
    for (const char* algorithm : {"", "LN_COBYLA", "LD_SLSQP", "LD_MMA", "GN_CRS2_LM"}) {
      int calls = 0;
      const auto throwing = [&](const std::vector<double>& x) -> Measured {
        if (++calls == at) throw Ours("number " + std::to_string(at));
        return {std::sin(40 * x[0]) + x[1], {0.5 - x[0]}};
      };
      INFO(algorithm << " " << at);
      CHECK_THROWS_WITH(minimize(throwing, {{0, 1}, {0, 1}}, {0.9, 0.9}, {.algorithm = algorithm}),
                        "number " + std::to_string(at));
      CHECK(calls == at);  // nothing is computed after the error
    }
  int asked = 0;
  const SearchOptions options{.algorithm = "LD_SLSQP",
                              .slopes = [&](const std::vector<double>&) -> std::optional<MeasuredSlopes> {
                                if (++asked == 3) throw Ours("slopes");
                                return std::nullopt;
                              }};
  CHECK_THROWS_WITH(minimize(
                        [](const std::vector<double>& x) {
                          return Measured{x[0] * x[0] + std::sin(5 * x[1]), {}};
                        },
                        {{-1, 1}, {0, 1}}, {0.7, 0.9}, options),
                    "slopes");
}

TEST_CASE("gradients with holes: where slopes are not known, differences stand in") {
  // Rosenbrock in a box, with slopes in half of it only; the penalty goes with the slopes where an algorithm
  // knows no constraints.
  const auto rosenbrock = [](const std::vector<double>& x) {
    const double a = x[1] - x[0] * x[0];
    return 100 * a * a + (1 - x[0]) * (1 - x[0]);
  };
  const auto slopes = [](const std::vector<double>& x) {
    const double a = x[1] - x[0] * x[0];
    return MeasuredSlopes{.value = {-400 * a * x[0] - 2 * (1 - x[0]), 200 * a}, .margins = {{-1, -1}}};
  };
  // Constrained by x + y <= 1: by Lagrange on the line, found by a fine scan.
  double best = inf;
  double best_x = 0;
  for (double x = -1; x < 1.5; x += 1e-6)
    if (const double there = rosenbrock({x, 1 - x}); there < best) {
      best = there;
      best_x = x;
    }
  int known = 0;
  int unknown = 0;
  for (const char* algorithm : {"LD_SLSQP", "LD_LBFGS", "LD_TNEWTON", "LD_VAR2", "LD_MMA"}) {
    const SearchResult r = minimize(
        [&](const std::vector<double>& x) {
          return Measured{rosenbrock(x), {1 - x[0] - x[1]}};
        },
        {{-1.5, 1.5}, {-1, 2}}, {-1, 0.5},
        {.algorithm = algorithm,
         .local_algorithm = "LN_COBYLA",
         .max_evaluations = 8000,
         .slopes = [&](const std::vector<double>& x) -> std::optional<MeasuredSlopes> {
           ++(x[0] < 0 ? known : unknown);
           if (x[0] < 0) return slopes(x);
           return std::nullopt;
         }});
    INFO(algorithm);
    CHECK(r.feasible);
    CHECK(r.measured.value == Approx(best).epsilon(2e-3));
    CHECK(r.x[0] == Approx(best_x).margin(5e-3));
  }
  CHECK(known > 10);
  CHECK(unknown > 10);
}

TEST_CASE("exact slopes carry the penalty where an algorithm knows no constraints") {
  // The point of the half-plane x + y <= 1 nearest to (1, 1), from a start beyond it. Where the start lies
  // the penalty is steeper than the objective: the first step leads back.
  for (const char* algorithm : {"LD_LBFGS", "LD_VAR1", "LD_TNEWTON_PRECOND"}) {
    std::vector<std::vector<double>> seen;
    const SearchResult r = minimize(
        [&](const std::vector<double>& x) {
          seen.push_back(x);
          return Measured{(x[0] - 1) * (x[0] - 1) + (x[1] - 1) * (x[1] - 1), {1 - x[0] - x[1]}};
        },
        {{-1, 2}, {-1, 2}}, {1.6, 1.4},
        {.algorithm = algorithm,
         .local_algorithm = "LN_COBYLA",
         .max_evaluations = 3000,
         .slopes = [](const std::vector<double>& x) -> std::optional<MeasuredSlopes> {
           return MeasuredSlopes{.value = {2 * (x[0] - 1), 2 * (x[1] - 1)}, .margins = {{-1, -1}}};
         }});
    INFO(algorithm);
    REQUIRE(seen.size() > 2);
    CHECK(seen[1][0] + seen[1][1] < 3);
    CHECK(r.feasible);
    CHECK(r.measured.value == Approx(0.5).margin(1e-4));
  }
}

TEST_CASE("inner searches of MLSL and AUGLAG are those asked for, and find the global optimum") {
  // Six-hump camel: -1.0316 at (0.0898, -0.7126) and its mirror image.
  const auto camel = [](const std::vector<double>& p) {
    const double x = p[0] * p[0];
    const double y = p[1] * p[1];
    return Measured{(4 - 2.1 * x + x * x / 3) * x + p[0] * p[1] + (4 * y - 4) * y, {}};
  };
  for (const char* algorithm : {"G_MLSL_LDS", "GN_MLSL", "GD_MLSL", "GD_MLSL_LDS"})
    for (const char* inner : {"", "LN_BOBYQA"}) {
      INFO(algorithm << " " << inner);
      const auto r = minimize(camel, {{-2, 2}, {-1.5, 1.5}}, {1.5, 1.2},
                              {.algorithm = algorithm, .local_algorithm = inner, .max_evaluations = 4000});
      CHECK(r.measured.value == Approx(-1.031628453).margin(1e-5));
    }
  for (const char* algorithm : {"LN_AUGLAG", "LD_AUGLAG"}) {
    const auto r = minimize(
        [](const std::vector<double>& x) {
          return Measured{(x[0] - 1) * (x[0] - 1) + (x[1] - 1) * (x[1] - 1), {1 - x[0] - x[1]}};
        },
        {{-1, 2}, {-1, 2}}, {-0.5, 1.5}, {.algorithm = algorithm, .max_evaluations = 4000});
    INFO(algorithm);
    CHECK(r.feasible);
    CHECK(r.measured.value == Approx(0.5).margin(0.01));
  }
}

TEST_CASE("whole numbers alone are all looked at when they are few, once each") {
  std::multiset<std::vector<double>> seen;
  const auto r = minimize_mixed(
      [&](const std::vector<double>& x) {
        seen.insert(x);
        return Measured{std::abs(x[0] - 7) + std::abs(x[1] + 2), {}};
      },
      {{{0, 19}, true, true}, {{-3, 3}, true, true}}, {40.2, -0.6}, {.max_evaluations = 4000});
  CHECK(r.x == std::vector<double>{7, -2});
  CHECK(seen.size() == 20 * 7);
  for (const auto& x : seen) CHECK(seen.count(x) == 1);
  CHECK(r.evaluations == 140);
  // Out of budget in the middle: the best so far.
  seen.clear();
  const auto half = minimize_mixed(
      [&](const std::vector<double>& x) {
        seen.insert(x);
        return Measured{-x[0], {}};
      },
      {{{0, 19}, true, true}}, {0}, {.max_evaluations = 6});
  CHECK(seen.size() <= 6);
  CHECK(half.x[0] == 5);
}

TEST_CASE(
    "many whole numbers and categories without a continuous one: the neighbourhood search against all of "
    "them") {
  verstat::test::property("a linear order with a constraint", [] {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    RandomStream stream(seed, "test", "whole");
    std::vector<double> centre;
    for (int k = 0; k < 4; ++k) centre.push_back(std::floor(stream.uniform(1, 19)));
    const std::vector<double> shift{stream.uniform(), stream.uniform(), stream.uniform()};
    const double room = stream.uniform(20, 60);
    const auto measured = [&](const std::vector<double>& x) {
      double sum = 3 * shift[static_cast<std::size_t>(x[4])];
      double total = 0;
      for (std::size_t k = 0; k < 4; ++k) {
        sum += (x[k] - centre[k]) * (x[k] - centre[k]);
        total += x[k];
      }
      return Measured{sum, {(room - total) / 10}};
    };
    int calls = 0;
    const SearchResult found = minimize_mixed(
        [&](const std::vector<double>& x) {
          ++calls;
          return measured(x);
        },
        {{{0, 19}, true, true},
         {{0, 19}, true, true},
         {{0, 19}, true, true},
         {{0, 19}, true, true},
         {{0, 2}, true, false}},
        {0, 0, 19, 0, 1}, {.max_evaluations = 6000});
    RC_ASSERT(calls <= 6000);
    RC_ASSERT(found.feasible);
    // Every set of whole numbers: the category is the smallest shift, the rest a projection on the
    // half-space.
    double least = inf;
    std::vector<double> x(5, 0.0);
    x[4] = static_cast<double>(std::min_element(shift.begin(), shift.end()) - shift.begin());
    for (x[0] = 0; x[0] <= 19; ++x[0])
      for (x[1] = 0; x[1] <= 19; ++x[1])
        for (x[2] = 0; x[2] <= 19; ++x[2]) {
          const double rest = std::floor(room - x[0] - x[1] - x[2]);
          if (rest < 0) continue;
          x[3] = std::min(centre[3], rest);
          least = std::min(least, measured(x).value);
        }
    RC_ASSERT(found.measured.value <= least + 1e-9);
  });
}

TEST_CASE("budgets smaller than one neighbourhood") {
  for (const int budget : {0, 1, 2, 3, 10, 40}) {
    int calls = 0;
    double best = inf;
    const auto r = minimize_mixed(
        [&](const std::vector<double>& x) {
          ++calls;
          double sum = 0;
          for (const double k : x) sum += (k - 17) * (k - 17);
          best = std::min(best, sum);
          return Measured{sum, {}};
        },
        {{{0, 40}, true, true}, {{0, 40}, true, true}, {{0, 40}, true, true}, {{0, 40}, true, true}},
        {0, 40, 20, 3}, {.max_evaluations = budget});
    INFO(budget);
    CHECK(calls <= budget);
    CHECK(r.evaluations == calls);
    if (budget > 0) CHECK(r.measured.value == best);
  }
}

TEST_CASE("mixed searches hand the slopes of their continuous coordinates on") {
  // Many settings; the slopes stop where the whole number is odd.
  int asked = 0;
  const auto f = [](const std::vector<double>& x) {
    return (x[0] - 61) * (x[0] - 61) / 50 + (x[1] - 0.2 - x[0] / 200) * (x[1] - 0.2 - x[0] / 200) +
           (x[2] - 0.7) * (x[2] - 0.7);
  };
  SearchOptions options{
      .max_evaluations = 5000, .slopes = [&](const std::vector<double>& x) -> std::optional<MeasuredSlopes> {
        ++asked;
        if (std::fmod(x[0], 2) == 1) return std::nullopt;
        return MeasuredSlopes{.value = {99, 2 * (x[1] - 0.2 - x[0] / 200), 2 * (x[2] - 0.7)},
                              .margins = {{99, -1, 0}}};
      }};
  const auto r = minimize_mixed(
      [&](const std::vector<double>& x) {
        return Measured{f(x), {0.45 - x[1]}};
      },
      {{{0, 100}, true, true}, {{0, 1}, false, true}, {{0, 1}, false, true}}, {3, 0.9, 0.1}, options);
  CHECK(asked > 0);
  CHECK(r.x[0] == Approx(57).margin(4.1));
  REQUIRE(r.feasible);
  // Enumerated: at a whole number n the best is min(0.2 + n / 200, 0.45) and 0.7.
  double least = inf;
  for (double n = 0; n <= 100; ++n) least = std::min(least, f({n, std::min(0.2 + n / 200, 0.45), 0.7}));
  CHECK(r.measured.value == Approx(least).margin(1e-7));
  // Budgets of every size are kept here, too.
  for (const int budget : {1, 5, 30, 200}) {
    int calls = 0;
    options.max_evaluations = budget;
    const auto small = minimize_mixed(
        [&](const std::vector<double>& x) {
          ++calls;
          return Measured{f(x), {0.45 - x[1]}};
        },
        {{{0, 100}, true, true}, {{0, 1}, false, true}, {{0, 1}, false, true}}, {3, 0.9, 0.1}, options);
    CHECK(calls <= budget);
    CHECK(small.evaluations == calls);
    CHECK(small.x.size() == 3);
  }
}
