// Expected value of sample information against its closed form, and the pieces it is made of.
#include "fit/sample_value.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "fit/fit_error.h"
#include "fit/life_fit.h"
#include "models/math/life_law.h"
#include "models/math/normal.h"
#include "models/math/solve.h"

using namespace verstat::fit;
using verstat::models::normal_cdf;
using verstat::models::normal_density;
using verstat::models::normal_quantile;
using verstat::sim::RandomStream;

namespace {

// E max(0, -x) of a normal x with mean and standard deviation.
double expected_loss(double mean, double sd) {
  const double z = mean / sd;
  return sd * normal_density(z) - mean * normal_cdf(-z);
}

}  // namespace

TEST_CASE("normal mean, two acts: Raiffa and Schlaifer's closed form", "[fit]") {
  // Plan A costs 0; plan B costs m, known to 0.4 +- 1. Each measurement of m scatters by 2. Choosing now: A.
  // After n: the posterior mean has the standard deviation s_n = 1 / sqrt(1 + 4 / n).
  constexpr std::size_t draws = 4000;
  std::vector<double> m;
  for (std::size_t d = 0; d < draws; ++d)
    m.push_back(0.4 + normal_quantile((static_cast<double>(d) + 0.5) / draws));
  UnknownGroup b{.name = "b", .draws = draws, .measure = {}};
  b.measure = [&](std::size_t truth, int n, RandomStream& stream, std::vector<double>& log_weights) {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += m[truth] + 2 * normal_quantile(stream.uniform());
    for (std::size_t d = 0; d < draws; ++d) log_weights[d] -= (n * m[d] * m[d] - 2 * sum * m[d]) / (2 * 4);
  };
  const std::vector<PlanCosts> plans = {{"a", 0, std::vector<double>(draws, 0.0)}, {"b", 0, m}};
  const ChoiceNow now = choose_now({b}, plans, 1);
  CHECK(now.best == 0);
  CHECK(now.perfect_information == Approx(expected_loss(0.4, 1)).epsilon(0.03));
  CHECK(now.best_chance[0] == Approx(normal_cdf(0.4)).margin(0.01));
  double before = 0;
  for (const int n : {1, 4, 16}) {
    const SampleValue v = value_of_sample({b}, plans, n, 4000, 1);
    const double theory = expected_loss(0.4, 1 / std::sqrt(1 + 4.0 / n));
    INFO(n << ": " << v.value << " +- " << v.standard_error << ", theory " << theory);
    CHECK(std::abs(v.value - theory) < 4 * v.standard_error);
    CHECK(v.standard_error < 0.1 * theory + 0.01);
    CHECK(v.value > before);
    before = v.value;
  }
  CHECK(value_of_sample({b}, plans, 0, 500, 1).value == 0);
}

TEST_CASE("the cost rate of age replacement is the one of renewal reward", "[fit]") {
  const WeibullDraw law{60, 2};
  const verstat::models::LifeLaw life = verstat::models::LifeLaw::weibull(60, 2);
  CHECK(age_replacement_cost(law, std::numeric_limits<double>::infinity(), 0, 100) ==
        Approx(100 / life.mean()));
  const double mean_cycle =
      verstat::models::integrate([](double t) { return std::exp(-(t / 60) * (t / 60)); }, 0, 40);
  const double survives = std::exp(-(40.0 / 60) * (40.0 / 60));
  CHECK(age_replacement_cost(law, 40, 30, 100) ==
        Approx((30 * survives + 100 * (1 - survives)) / mean_cycle));
}

TEST_CASE("posterior of a Weibull life: centre and width of the likelihood", "[fit]") {
  std::vector<Observation> lives;
  for (int i = 0; i < 200; ++i) {
    const double u = (i + 0.5) / 200;
    lives.push_back(exact_life(60 * std::pow(-std::log1p(-u), 1 / 2.0)));
  }
  const FittedLaw fit = fit_law(LifeFamily::weibull, lives);
  const std::vector<WeibullDraw> draws = weibull_posterior(lives, 2000, 1, "t");
  double mean = 0;
  double squares = 0;
  int inside = 0;
  const Interval bounds = life_bounds(fit, lives, LifeQuantity::second, 0.95);
  for (const WeibullDraw& d : draws) {
    mean += std::log(d.scale) / 2000;
    inside += bounds.low <= d.shape && d.shape <= bounds.high ? 1 : 0;
  }
  for (const WeibullDraw& d : draws) squares += std::pow(std::log(d.scale) - mean, 2) / 2000;
  CHECK(mean == Approx(std::log(fit.first)).margin(0.01));
  // Standard error of ln scale for complete samples: 1.053 / (shape sqrt(n)) (Bain, Engelhardt 1991).
  CHECK(std::sqrt(squares) == Approx(1.053 / (fit.second * std::sqrt(200.0))).epsilon(0.08));
  CHECK(inside > 1860);
  CHECK(inside < 1940);
  CHECK_THROWS_AS(weibull_posterior({survived(3)}, 100, 1, "t"), FitError);
}

TEST_CASE("two like tools, few edges: more edges help, and never more than the truth would", "[fit]") {
  std::vector<Observation> a;
  std::vector<Observation> b;
  for (const double t : {31.0, 42.0, 55.0, 61.0, 74.0, 90.0}) {
    a.push_back(exact_life(t));
    b.push_back(exact_life(0.93 * t));
  }
  const auto laws_a = weibull_posterior(a, 800, 3, "a");
  const auto laws_b = weibull_posterior(b, 800, 3, "b");
  const std::vector<UnknownGroup> groups = {weibull_group("a", laws_a, 1e9), weibull_group("b", laws_b, 1e9)};
  std::vector<PlanCosts> plans = {{"a", 0, {}}, {"b", 1, {}}};
  for (const WeibullDraw& d : laws_a) plans[0].costs.push_back(age_replacement_cost(d, 40, 50, 150));
  for (const WeibullDraw& d : laws_b) plans[1].costs.push_back(age_replacement_cost(d, 40, 47, 150));
  const ChoiceNow now = choose_now(groups, plans, 3);
  CHECK(now.best_chance[0] + now.best_chance[1] == Approx(1));
  const SampleValue few = value_of_sample(groups, plans, 3, 600, 3);
  const SampleValue many = value_of_sample(groups, plans, 60, 600, 3);
  CHECK(few.value < many.value);
  CHECK(many.value < now.perfect_information + 4 * many.standard_error);
  CHECK(many.value > 0.5 * now.perfect_information);
  CHECK(many.wrong_chance < few.wrong_chance);
  CHECK(many.wrong_chance < 0.25);
  CHECK(value_of_sample(groups, plans, 3, 200, 3).value == value_of_sample(groups, plans, 3, 200, 3).value);
}

TEST_CASE("the value of one and of two new edges is that of integrating over what they may show", "[fit]") {
  // Two laws are possible, 0.45 and 0.55; edges that last 70 min are taken out. Plan A costs 1 whatever the
  // law, plan B depends on it. Nothing is simulated on this side: the loss is integrated over the lives seen.
  const std::vector<WeibullDraw> laws = {{40, 1.5}, {75, 2.5}};
  const std::vector<double> chance = {0.45, 0.55};
  const std::vector<double> cost_b = {1.3, 0.8};
  constexpr double taken_out = 70;
  const auto density = [&](std::size_t h, double t) {
    const double x = std::pow(t / laws[h].scale, laws[h].shape);
    return laws[h].shape / t * x * std::exp(-x);
  };
  const auto good = [&](std::size_t h) {
    return std::exp(-std::pow(taken_out / laws[h].scale, laws[h].shape));
  };
  // The cheaper plan, times the probability of what was seen under each law.
  const auto least = [&](double seen_0, double seen_1) {
    const double w0 = chance[0] * seen_0;
    const double w1 = chance[1] * seen_1;
    return std::min(w0 + w1, w0 * cost_b[0] + w1 * cost_b[1]);
  };
  const double now = least(1, 1);
  constexpr int steps = 2000;
  std::vector<double> f0;
  std::vector<double> f1;
  for (int k = 0; k < steps; ++k) {
    const double t = (k + 0.5) * taken_out / steps;
    f0.push_back(density(0, t) * taken_out / steps);
    f1.push_back(density(1, t) * taken_out / steps);
  }
  f0.push_back(good(0));  // still good when taken out
  f1.push_back(good(1));
  double after_one = 0;
  double after_two = 0;
  for (std::size_t i = 0; i < f0.size(); ++i) {
    after_one += least(f0[i], f1[i]);
    for (std::size_t k = 0; k < f0.size(); ++k) after_two += least(f0[i] * f0[k], f1[i] * f1[k]);
  }
  // The same by simulation; every law stands many times, so that leaving out the truth leaves its like.
  constexpr std::size_t draws = 1000;
  std::vector<WeibullDraw> unknown;
  std::vector<double> costs;
  for (std::size_t d = 0; d < draws; ++d) {
    const std::size_t h = d < 450 ? 0 : 1;
    unknown.push_back(laws[h]);
    costs.push_back(cost_b[h]);
  }
  const std::vector<UnknownGroup> groups = {weibull_group("t", unknown, taken_out)};
  const std::vector<PlanCosts> plans = {{"a", 0, std::vector<double>(draws, 1.0)}, {"b", 0, costs}};
  const double brute_one = now - after_one;
  const double brute_two = now - after_two;
  CHECK(brute_one > 0);
  CHECK(brute_two > brute_one);
  const SampleValue one = value_of_sample(groups, plans, 1, 20'000, 1);
  const SampleValue two = value_of_sample(groups, plans, 2, 20'000, 1);
  INFO(one.value << " +- " << one.standard_error << " of " << brute_one << ", " << two.value << " +- "
                 << two.standard_error << " of " << brute_two);
  CHECK(std::abs(one.value - brute_one) < 3.5 * one.standard_error);
  CHECK(std::abs(two.value - brute_two) < 3.5 * two.standard_error);
  CHECK(one.standard_error < 0.05 * brute_one);
  CHECK(two.standard_error < 0.05 * brute_two);
}
