// Censored maximum likelihood against published data sets with published estimates. Data and estimates of the
// four sets of Meeker, Escobar, Statistical Methods for Reliability Data (Wiley, 1998), stand in the package
// SMRD of Freels, Meeker, Escobar (github.com/Auburngrads/SMRD): its README (shock absorbers) and the files
// bearingcage.R, heatexchanger.R and lzbearing.R in inst/test_objs/wqmmlesss, which keep estimates and
// covariances to seven digits.
#include <cmath>
#include <functional>

#include <catch2/catch.hpp>

#include "fit/life_analysis.h"
#include "fit/location_scale.h"

using namespace verstat::fit;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void add(std::vector<Observation>& lives, const Observation& life, int count) {
  for (int k = 0; k < count; ++k) lives.push_back(life);
}

// Endurance of 23 deep-groove ball bearings, million revolutions: Lieblein, Zelen, J. Res. NBS 57 (1956) 273;
// lzbearing.R. (Other tables print 48.48 or 48.80 for 48.40.)
std::vector<Observation> ball_bearings() {
  std::vector<Observation> lives;
  for (const double t :
       {17.88, 28.92, 33.00, 41.52, 42.12, 45.60, 48.40,  51.84,  51.96,  54.12,  55.56, 67.80,
        68.64, 68.64, 68.88, 84.12, 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40})
    lives.push_back(exact_life(t));
  return lives;
}

// Distance to failure of 38 vehicle shock absorbers, km; 27 had not failed: Meeker, Escobar table C.2;
// README.
std::vector<Observation> shock_absorbers() {
  std::vector<Observation> lives;
  for (const double t : {6700, 9120, 12200, 13150, 14300, 17520, 20100, 20900, 22700, 26510, 27490})
    lives.push_back(exact_life(t));
  for (const double t :
       {6950,  7820,  8790,  9660,  9820,  11310, 11690, 11850, 11880, 12140, 12870, 13330, 13470, 14040,
        17540, 17890, 18450, 18960, 18980, 19410, 20100, 20150, 20320, 23490, 27410, 27890, 28100})
    lives.push_back(survived(t));
  return lives;
}

// Hours of 1703 aircraft engine bearing cages, 6 failed: bearingcage.R.
std::vector<Observation> bearing_cages() {
  struct Count {
    double hours;
    int still_good;
  };
  std::vector<Observation> lives;
  for (const double t : {230, 334, 423, 990, 1009, 1510}) lives.push_back(exact_life(t));
  for (const Count& c : {Count{50, 288}, Count{150, 148}, Count{250, 124}, Count{350, 111}, Count{450, 106},
                         Count{550, 99}, Count{650, 110}, Count{750, 114}, Count{850, 119}, Count{950, 127},
                         Count{1050, 123}, Count{1150, 93}, Count{1250, 47}, Count{1350, 41}, Count{1450, 27},
                         Count{1550, 11}, Count{1650, 6}, Count{1850, 1}, Count{2050, 2}})
    add(lives, survived(c.hours), c.still_good);
  return lives;
}

// Cracks found at yearly inspections of 300 heat exchanger tubes in three plants: heatexchanger.R.
std::vector<Observation> heat_exchangers() {
  std::vector<Observation> lives;
  add(lives, between(0, 1), 1 + 2 + 1);
  add(lives, between(1, 2), 2 + 3);
  add(lives, between(2, 3), 2);
  add(lives, survived(1), 99);
  add(lives, survived(2), 95);
  add(lives, survived(3), 95);
  return lives;
}

// Remission of 42 leukaemia patients, weeks, in two groups: Gehan, Biometrika 52 (1965) 203, as in the data
// set gehan of the R package MASS. Here they stand for two batches.
std::vector<Observation> two_batches() {
  std::vector<Observation> lives;
  for (const double t : {1, 1, 2, 2, 3, 4, 4, 5, 5, 8, 8, 8, 8, 11, 11, 12, 12, 15, 17, 22, 23})
    lives.push_back(exact_life(t));
  for (const double t : {6, 6, 6, 7, 10, 13, 16, 22, 23}) lives.push_back(exact_life(t));
  for (const double t : {6, 9, 10, 11, 17, 19, 20, 25, 32, 32, 34, 35}) lives.push_back(survived(t));
  for (std::size_t i = 21; i < lives.size(); ++i) lives[i].batch = 1;
  return lives;
}

}  // namespace

TEST_CASE("ball bearings: exact lives", "[fit]") {
  const std::vector<Observation> lives = ball_bearings();
  const FittedLaw lognormal = fit_law(LifeFamily::lognormal, lives);
  CHECK(lognormal.first == Approx(4.15038251876831).epsilon(1e-6));
  CHECK(lognormal.second == Approx(0.521686494350433).epsilon(1e-6));
  CHECK(lognormal.log_likelihood == Approx(-113.128555297852).epsilon(1e-6));
  // The other laws have no estimates in those files; these are identities of exact lives: mean and standard
  // deviation are the estimates of the normal law, the mean that of the exponential one, gamma keeps the
  // mean.
  double sum = 0;
  for (const Observation& o : lives) sum += o.low;
  const double mean = sum / 23;
  double squares = 0;
  for (const Observation& o : lives) squares += (o.low - mean) * (o.low - mean);
  const FittedLaw normal = fit_law(LifeFamily::normal, lives);
  CHECK(normal.first == Approx(mean).epsilon(1e-9));
  CHECK(normal.second == Approx(std::sqrt(squares / 23)).epsilon(1e-7));
  CHECK(fit_law(LifeFamily::exponential, lives).first == Approx(mean).epsilon(1e-9));
  CHECK(fit_law(LifeFamily::gamma, lives).mean() == Approx(mean).epsilon(1e-6));
  // A constant failure rate is the one law that bearings refute.
  const LifeRanking ranking = rank_laws(lives);
  CHECK(ranking.laws.back().family == LifeFamily::exponential);
  CHECK(ranking.unfitted.empty());
}

TEST_CASE("shock absorbers: right-censored, with the published intervals", "[fit]") {
  const std::vector<Observation> lives = shock_absorbers();
  REQUIRE(lives.size() == 38);
  const FittedLaw weibull = fit_law(LifeFamily::weibull, lives);
  CHECK(weibull.first == Approx(27718.72).epsilon(1e-6));
  CHECK(weibull.second == Approx(3.16).margin(5e-3));
  // Published standard errors: 3046.02 of the scale, 0.73 of the shape, from the information like these.
  CensoredData data{.x = Eigen::MatrixXd::Ones(38, 1), .low = {}, .high = {}};
  for (const Observation& o : lives) {
    data.low.push_back(std::log(o.low));
    data.high.push_back(std::log(o.high));
  }
  const RegressionFit fit = fit_regression(ErrorLaw::smallest_extreme_value, data);
  CHECK(27718.72 * std::sqrt(fit.covariance(0, 0)) == Approx(3046.02).epsilon(1e-5));
  CHECK(weibull.second * std::sqrt(fit.covariance(1, 1)) == Approx(0.73).margin(5e-3));
  // The bounds by the likelihood, against a search of the best shape for each scale and the other way round.
  const auto best = [&](const std::function<double(double)>& log_of) {
    double low = -1;
    double high = 1;
    for (int k = 0; k < 100; ++k) {
      const double left = low + (high - low) / 3;
      const double right = high - (high - low) / 3;
      if (log_of(left) < log_of(right))
        low = left;
      else
        high = right;
    }
    return log_of(low);
  };
  const auto at = [&](double scale, double shape) {
    return log_likelihood({.family = LifeFamily::weibull, .first = scale, .second = shape}, lives);
  };
  const Interval scale = life_bounds(weibull, lives, LifeQuantity::first, 0.95);
  const Interval shape = life_bounds(weibull, lives, LifeQuantity::second, 0.95);
  CHECK(scale.low < 27718.72);
  CHECK(scale.high > 27718.72);
  constexpr double chi_square_95 = 3.841458820694124;
  for (const double bound : {scale.low, scale.high})
    CHECK(2 * (weibull.log_likelihood -
               best([&](double x) { return at(bound, weibull.second * std::exp(x)); })) ==
          Approx(chi_square_95).epsilon(1e-5));
  for (const double bound : {shape.low, shape.high})
    CHECK(2 * (weibull.log_likelihood -
               best([&](double x) { return at(weibull.first * std::exp(x), bound); })) ==
          Approx(chi_square_95).epsilon(1e-5));
}

TEST_CASE("bearing cages: 6 failures of 1703", "[fit]") {
  const std::vector<Observation> lives = bearing_cages();
  REQUIRE(lives.size() == 1703);
  const FittedLaw lognormal = fit_law(LifeFamily::lognormal, lives);
  CHECK(lognormal.first == Approx(10.7540531158447).epsilon(1e-5));
  CHECK(lognormal.second == Approx(1.55426752567291).epsilon(1e-5));
  CHECK(lognormal.log_likelihood == Approx(-76.5879669189453).epsilon(1e-6));
}

TEST_CASE("heat exchangers: intervals and censoring from either side", "[fit]") {
  const std::vector<Observation> lives = heat_exchangers();
  REQUIRE(lives.size() == 300);
  const FittedLaw lognormal = fit_law(LifeFamily::lognormal, lives);
  CHECK(lognormal.first == Approx(3.73756718635559).epsilon(1e-5));
  CHECK(lognormal.second == Approx(1.69628572463989).epsilon(1e-5));
  CHECK(lognormal.log_likelihood == Approx(-54.3504676818848).epsilon(1e-6));
}

TEST_CASE("two groups: the ratio of lives under one shape, by a route of its own", "[fit]") {
  const std::vector<Observation> lives = two_batches();
  std::vector<Observation> treated(lives.begin() + 21, lives.end());
  CHECK(fit_law(LifeFamily::exponential, treated).first == Approx(359.0 / 9).epsilon(1e-9));
  const auto report = compare_batches(lives, 0.95);
  REQUIRE(report);
  REQUIRE(report->family == LifeFamily::weibull);
  REQUIRE(report->ratios.size() == 2);
  // Given the shape b the scales are (sum t^b / failures)^(1/b); what is left is one number to search.
  const auto scale = [&](std::size_t batch, double b) {
    double sum = 0;
    double failures = 0;
    for (const Observation& o : lives)
      if (o.batch == batch) {
        sum += std::pow(o.low, b);
        failures += o.failed() ? 1 : 0;
      }
    return std::pow(sum / failures, 1 / b);
  };
  const auto log_likelihood = [&](double b) {
    double sum = 0;
    for (const Observation& o : lives) {
      const double a = scale(o.batch, b);
      sum -= std::pow(o.low / a, b);
      if (o.failed()) sum += std::log(b / a) + (b - 1) * std::log(o.low / a);
    }
    return sum;
  };
  double low = 0.5;
  double high = 4;
  for (int k = 0; k < 80; ++k) {
    const double left = low + (high - low) / 3;
    const double right = high - (high - low) / 3;
    if (log_likelihood(left) < log_likelihood(right))
      low = left;
    else
      high = right;
  }
  CHECK(report->ratios[1].life_ratio.estimate == Approx(scale(1, low) / scale(0, low)).epsilon(1e-6));
  CHECK(report->ratios[1].life_ratio.bounds.low > 1);
  CHECK(report->scale_p_value < 1e-4);
  CHECK(report->shape_p_value > 0.2);
}
