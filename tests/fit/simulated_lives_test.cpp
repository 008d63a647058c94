// Lives drawn from known laws: bias, coverage of the intervals, tests that keep their level.
#include <cmath>
#include <numeric>

#include <catch2/catch.hpp>

#include "fit/fit_error.h"
#include "fit/life_analysis.h"
#include "sim/kernel/random_stream.h"

using namespace verstat::fit;
using verstat::sim::RandomStream;

namespace {

// n lives of a law, taken out at `planned` when still good.
std::vector<Observation> draw(const FittedLaw& law, std::size_t n, double planned, RandomStream& stream) {
  std::vector<Observation> lives;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = law.quantile(stream.uniform());
    lives.push_back(t <= planned ? exact_life(t) : survived(planned));
  }
  return lives;
}

struct Share {
  int hits = 0, of = 0;
  void add(bool hit) {
    hits += hit ? 1 : 0;
    ++of;
  }
  [[nodiscard]] double value() const { return static_cast<double>(hits) / of; }
};

}  // namespace

TEST_CASE("every law under planned changes: no bias, and every interval covers in 93 to 97 %", "[fit]") {
  struct Case {
    FittedLaw truth;
    double planned;  // 20 to 30 % are still good then
    double shape_bias_low, shape_bias_high;
  };
  // Maximum likelihood of the Weibull shape is biased upwards by about 1.4 / n (Ross, IEEE Trans. Diel. 1994;
  // n counts failures), that of a standard deviation downwards by about 3 / (4 n), of the gamma shape upwards
  // by 3 / n for complete samples (Choi, Wette, Technometrics 1969).
  for (const Case& c : {Case{{.family = LifeFamily::weibull, .first = 60, .second = 1.6}, 70, 0, 0.03},
                        Case{{.family = LifeFamily::lognormal, .first = 4, .second = 0.5}, 75, -0.02, 0.005},
                        Case{{.family = LifeFamily::normal, .first = 60, .second = 15}, 70, -0.02, 0.005},
                        Case{{.family = LifeFamily::gamma, .first = 15, .second = 4}, 75, 0, 0.06},
                        Case{{.family = LifeFamily::exponential, .first = 60}, 80, -1e-9, 1e-9}}) {
    const FittedLaw& truth = c.truth;
    const double t_90 = truth.gamma_percent_life(0.9);
    Share first, second, mean, gamma_life;
    double bias_mean = 0;
    double bias_second = 0;
    constexpr int repeats = 1000;
    for (int k = 0; k < repeats; ++k) {
      RandomStream stream(7, "edges", name_of(truth.family), static_cast<std::uint64_t>(k));
      const std::vector<Observation> lives = draw(truth, 100, c.planned, stream);
      const FittedLaw fit = fit_law(truth.family, lives);
      bias_mean += std::log(fit.mean() / truth.mean()) / repeats;
      bias_second += std::log(fit.second / truth.second) / repeats;
      const auto covers = [&](LifeQuantity quantity, double value, double p = 0.5) {
        const Interval b = life_bounds(fit, lives, quantity, 0.95, p);
        return b.low <= value && value <= b.high;
      };
      first.add(covers(LifeQuantity::first, truth.first));
      gamma_life.add(covers(LifeQuantity::quantile, t_90, 0.1));
      mean.add(covers(LifeQuantity::mean, truth.mean()));
      if (fit.parameters() == 2) second.add(covers(LifeQuantity::second, truth.second));
    }
    INFO(name_of(truth.family) << ": " << first.value() << " " << (second.of > 0 ? second.value() : 0.95)
                               << " " << mean.value() << " " << gamma_life.value() << "; bias " << bias_mean
                               << " " << bias_second);
    // 1000 repeats: the standard error of a coverage of 95 % is 0.7 %.
    for (const Share& share : {first, second, mean, gamma_life}) {
      if (share.of == 0) continue;
      CHECK(share.value() > 0.93);
      CHECK(share.value() < 0.97);
    }
    CHECK(std::abs(bias_mean) < 0.01);
    CHECK(bias_second > c.shape_bias_low);
    CHECK(bias_second < c.shape_bias_high);
  }
}

TEST_CASE("exponential lives: the profile bounds are those of the Poisson likelihood", "[fit]") {
  std::vector<Observation> lives = {exact_life(10), exact_life(25), exact_life(40), survived(50),
                                    survived(50)};
  const FittedLaw fit = fit_law(LifeFamily::exponential, lives);
  CHECK(fit.first == Approx(175.0 / 3).epsilon(1e-10));
  const Interval b = life_bounds(fit, lives, LifeQuantity::first, 0.95);
  for (const double mean : {b.low, b.high}) {
    // 2 (l(estimate) - l(mean)) = chi-square quantile, in closed form.
    const double drop = 2 * (-3 * std::log(fit.first) - 3 - (-3 * std::log(mean) - 175 / mean));
    CHECK(drop == Approx(3.841458820694124).epsilon(1e-6));
  }
  CHECK(b.low < fit.first);
  CHECK(b.high > fit.first);
}

TEST_CASE("inspections every ten minutes lose little and bias nothing", "[fit]") {
  const FittedLaw truth{.family = LifeFamily::weibull, .first = 60, .second = 2};
  double log_scale = 0;
  double log_shape = 0;
  Share scale, shape, gamma_life;
  constexpr int repeats = 1000;
  for (int k = 0; k < repeats; ++k) {
    RandomStream stream(3, "edges", "inspected", static_cast<std::uint64_t>(k));
    std::vector<Observation> lives;
    for (int i = 0; i < 100; ++i) {
      const double t = truth.quantile(stream.uniform());
      const double low = 10 * std::floor(t / 10);
      lives.push_back(between(low, low + 10));
    }
    const FittedLaw fit = fit_law(LifeFamily::weibull, lives);
    log_scale += std::log(fit.first / truth.first) / repeats;
    log_shape += std::log(fit.second / truth.second) / repeats;
    const auto covers = [&](LifeQuantity quantity, double value, double p = 0.5) {
      const Interval b = life_bounds(fit, lives, quantity, 0.95, p);
      return b.low <= value && value <= b.high;
    };
    scale.add(covers(LifeQuantity::first, truth.first));
    shape.add(covers(LifeQuantity::second, truth.second));
    gamma_life.add(covers(LifeQuantity::quantile, truth.gamma_percent_life(0.9), 0.1));
  }
  // Standard errors: 0.053 / sqrt(1000) = 0.0017 of ln scale, 0.08 / sqrt(1000) = 0.0025 of ln shape.
  CHECK(std::abs(log_scale) < 0.007);
  CHECK(log_shape > 0);
  CHECK(log_shape < 0.025);
  INFO(scale.value() << " " << shape.value() << " " << gamma_life.value());
  for (const Share& share : {scale, shape, gamma_life}) {
    CHECK(share.value() > 0.93);
    CHECK(share.value() < 0.97);
  }
  // Very narrow intervals are exact lives.
  std::vector<Observation> narrow;
  std::vector<Observation> exact;
  for (const double t : {12.0, 30.0, 31.0, 44.0, 61.0, 90.0}) {
    narrow.push_back(between(t - 1e-5, t + 1e-5));
    exact.push_back(exact_life(t));
  }
  for (const LifeFamily family : life_families) {
    INFO(name_of(family));
    CHECK(fit_law(family, narrow).first == Approx(fit_law(family, exact).first).epsilon(1e-5));
    CHECK(fit_law(family, narrow).second == Approx(fit_law(family, exact).second).epsilon(1e-4));
  }
}

TEST_CASE("the test of fit keeps its level and sees two causes behind one law", "[fit]") {
  const FittedLaw truth{.family = LifeFamily::weibull, .first = 60, .second = 1.6};
  Share refused;
  for (int k = 0; k < 300; ++k) {
    RandomStream stream(5, "edges", "level", static_cast<std::uint64_t>(k));
    const std::vector<Observation> lives = draw(truth, 40, 80, stream);
    const GoodnessTest test = goodness_of_fit(fit_law(LifeFamily::weibull, lives), lives, 99, 1);
    refused.add(test.p_value <= 0.1);
  }
  INFO(refused.value());
  CHECK(refused.value() > 0.05);  // 10 % expected, standard error 1.7 %
  CHECK(refused.value() < 0.155);
  // Half of the edges chip at once, half wear: no Weibull law.
  RandomStream stream(5, "edges", "mixture");
  std::vector<Observation> lives;
  for (int i = 0; i < 60; ++i)
    lives.push_back(exact_life(i % 2 == 0 ? 2 + stream.uniform() : 70 + 10 * stream.uniform()));
  CHECK(goodness_of_fit(fit_law(LifeFamily::weibull, lives), lives, 199, 1).p_value < 0.02);
}

TEST_CASE("competing causes: each law is found behind the other", "[fit]") {
  RandomStream stream(9, "edges", "causes");
  const FittedLaw wear{.family = LifeFamily::weibull, .first = 70, .second = 3};
  const FittedLaw chip{.family = LifeFamily::exponential, .first = 120};
  std::vector<Observation> lives;
  for (int i = 0; i < 4000; ++i) {
    const double worn = wear.quantile(stream.uniform());
    const double chipped = chip.quantile(stream.uniform());
    Observation o = exact_life(std::min(worn, chipped));
    o.cause = worn < chipped ? 0 : 1;
    lives.push_back(o);
  }
  const FittedLaw found_wear = fit_law(LifeFamily::weibull, lives_of_cause(lives, 0));
  CHECK(found_wear.first == Approx(70).epsilon(0.02));
  CHECK(found_wear.second == Approx(3).epsilon(0.05));
  const FittedLaw found_chip = fit_law(LifeFamily::exponential, lives_of_cause(lives, 1));
  CHECK(found_chip.first == Approx(120).epsilon(0.08));
  LifeAnalysisOptions options;
  options.goodness_samples = 19;
  const LifeAnalysis a = analyse_lives(lives, options);
  REQUIRE(a.causes.size() == 2);
  // Without censoring the incidences are the shares of the causes.
  const double worn_share = static_cast<double>(std::count_if(lives.begin(), lives.end(),
                                                              [](const auto& o) { return o.cause == 0; })) /
                            4000;
  CHECK(a.causes[0].incidence == Approx(worn_share).epsilon(1e-9));
  CHECK(a.causes[0].incidence + a.causes[1].incidence == Approx(1).epsilon(1e-9));
  // R = R_wear R_chip at the gamma-percent life of both together.
  REQUIRE(a.gamma_percent_life_of_causes);
  const double t = *a.gamma_percent_life_of_causes;
  CHECK((1 - wear.cdf(t)) * (1 - chip.cdf(t)) == Approx(0.9).margin(0.01));
}

TEST_CASE("batches: equal ones are told apart in 5 % of the cases, different ones nearly always", "[fit]") {
  const FittedLaw truth{.family = LifeFamily::weibull, .first = 60, .second = 2};
  Share equal, different, covered;
  for (int k = 0; k < 1000; ++k) {
    RandomStream stream(13, "edges", "batches", static_cast<std::uint64_t>(k));
    std::vector<Observation> lives = draw(truth, 80, 90, stream);
    for (std::size_t i = 0; i < 80; ++i) lives[i].batch = i % 2;
    equal.add(compare_batches(lives, 0.95)->scale_p_value < 0.05);
    for (Observation& o : lives)
      if (o.batch == 1) {
        o.low *= 0.6;
        o.high *= 0.6;
      }
    const auto report = compare_batches(lives, 0.95);
    different.add(report->scale_p_value < 0.05);
    const Interval& b = report->ratios[1].life_ratio.bounds;
    covered.add(b.low <= 0.6 && 0.6 <= b.high);
  }
  INFO(equal.value() << " " << different.value() << " " << covered.value());
  CHECK(equal.value() > 0.03);
  CHECK(equal.value() < 0.07);
  CHECK(different.value() > 0.95);
  CHECK(covered.value() > 0.93);
  CHECK(covered.value() < 0.97);
}

TEST_CASE("product limit, median ranks and the Weibull plot", "[fit]") {
  // Kaplan-Meier of the treated group of Gehan (1965), as every textbook has it (survfit of the R package
  // survival prints the same): 0.857 after 6, 0.807 after 7, 0.753, 0.690, 0.627, 0.538, 0.448.
  std::vector<Observation> treated;
  for (const double t : {6, 6, 6, 7, 10, 13, 16, 22, 23}) treated.push_back(exact_life(t));
  for (const double t : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) treated.push_back(survived(t));
  const auto steps = product_limit(treated);
  const std::vector<double> published = {0.857, 0.807, 0.753, 0.690, 0.627, 0.538, 0.448};
  REQUIRE(steps.size() == published.size());
  for (std::size_t k = 0; k < steps.size(); ++k)
    CHECK(steps[k].survival == Approx(published[k]).margin(5.1e-4));
  // Median ranks of five: 0.1294, 0.3138, 0.5, 0.6862, 0.8706; 5 % and 95 % ranks of the first 0.0102, 0.4507
  // (Johnson 1951; Abernethy, The New Weibull Handbook, appendix I).
  std::vector<Observation> five;
  for (const double t : {10, 20, 30, 40, 50}) five.push_back(exact_life(t));
  const auto points = median_ranks(five);
  const std::vector<double> ranks = {0.1294, 0.3138, 0.5, 0.6862, 0.8706};
  for (std::size_t k = 0; k < 5; ++k) CHECK(points[k].median == Approx(ranks[k]).margin(5.1e-5));
  CHECK(points[0].low == Approx(0.0102).margin(5.1e-5));
  CHECK(points[0].high == Approx(0.4507).margin(5.1e-5));
  // Johnson's adjusted ranks: a censored life after the first failure of five lifts the next ones by
  // (6 - 1) / (1 + 3) = 1.25.
  five[1] = survived(20);
  const auto adjusted = median_ranks(five);
  CHECK(adjusted[1].rank == Approx(2.25));
  CHECK(adjusted[2].rank == Approx(3.5));
  // Points exactly on a line give its law back.
  std::vector<PlotPoint> line;
  for (const double p : {0.1, 0.4, 0.8})
    line.push_back({50 * std::pow(-std::log1p(-p), 1 / 1.7), 0, p, 0, 0});
  CHECK(rank_regression(line).shape == Approx(1.7).epsilon(1e-12));
  CHECK(rank_regression(line).scale == Approx(50).epsilon(1e-12));
}

TEST_CASE("what cannot be fitted is said", "[fit]") {
  CHECK_THROWS_AS(fit_law(LifeFamily::weibull, {survived(10), survived(20)}), FitError);
  CHECK_THROWS_AS(fit_law(LifeFamily::weibull, {exact_life(10), exact_life(10)}), FitError);
  CHECK_THROWS_AS(fit_law(LifeFamily::gamma, {exact_life(10), exact_life(10), exact_life(10)}), FitError);
  CHECK_THROWS_WITH(fit_law(LifeFamily::lognormal, {exact_life(10), survived(20)}),
                    Catch::Contains("fewer than two different failures"));
  CHECK(fit_law(LifeFamily::exponential, {exact_life(10), survived(20)}).first == Approx(30));
  CHECK_THROWS_AS(analyse_lives({survived(3)}, {}), FitError);
  // One cause behind all, one batch without a failure: no comparison.
  std::vector<Observation> lives = {exact_life(3), exact_life(5), survived(9)};
  lives[2].batch = 1;
  CHECK_FALSE(compare_batches(lives, 0.95));
  CHECK_FALSE(analyse_lives(lives, {}).batches_not_compared.empty());
  // A batch for every edge is no batch.
  std::vector<Observation> singles;
  for (std::size_t i = 0; i < 200; ++i) {
    singles.push_back(exact_life(10 + static_cast<double>(i)));
    singles.back().batch = i;
  }
  LifeAnalysisOptions quick;
  quick.goodness_samples = 19;
  CHECK(analyse_lives(singles, quick).batches_not_compared == "more than 30 batches with failures");
}
