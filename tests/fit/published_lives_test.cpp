// Censored maximum likelihood against published data sets with published estimates.
#include <cmath>
#include <map>

#include <catch2/catch.hpp>

#include "fit/life_analysis.h"
#include "fit/location_scale.h"

using namespace verstat::fit;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Endurance of 23 deep-groove ball bearings, million revolutions: Lieblein, Zelen (1956), as in Lawless,
// Statistical Models and Methods for Lifetime Data, 2nd ed. (2003), example 3.3.1.
std::vector<Observation> ball_bearings() {
  std::vector<Observation> lives;
  for (const double t :
       {17.88, 28.92, 33.00, 41.52, 42.12, 45.60, 48.40,  51.84,  51.96,  54.12,  55.56, 67.80,
        68.64, 68.64, 68.88, 84.12, 93.12, 98.64, 105.12, 105.84, 127.92, 128.04, 173.40})
    lives.push_back(exact_life(t));
  return lives;
}

// Distance to failure of 38 vehicle shock absorbers, km; 27 had not failed: O'Connor (1985), as in Meeker,
// Escobar, Statistical Methods for Reliability Data (1998), table C.2.
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

// 167 turbine parts inspected for cracks, months: Nelson, Applied Life Data Analysis (1982), p. 415.
std::vector<Observation> turbine_parts() {
  struct Reading {
    double from, to;
    int cracked;
  };
  std::vector<Observation> lives;
  for (const Reading& r : {Reading{0, 6.12, 5}, Reading{6.12, 19.92, 16}, Reading{19.92, 29.64, 12},
                           Reading{29.64, 35.40, 18}, Reading{35.40, 39.72, 18}, Reading{39.72, 45.24, 2},
                           Reading{45.24, 52.32, 6}, Reading{52.32, 63.48, 17}, Reading{63.48, infinity, 73}})
    for (int k = 0; k < r.cracked; ++k) lives.push_back(between(r.from, r.to));
  return lives;
}

// Remission of 42 leukaemia patients, weeks, in two groups: Freireich et al. (1963), Gehan (1965). Here they
// stand for two batches.
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

TEST_CASE("ball bearings: all five laws, exact lives", "[fit]") {
  const std::vector<Observation> lives = ball_bearings();
  const FittedLaw weibull = fit_law(LifeFamily::weibull, lives);
  CHECK(weibull.second == Approx(2.102).margin(5e-4));  // Lawless; Thoman, Bain, Antle (1969) print 2.102
  CHECK(weibull.first == Approx(81.88).margin(5e-3 + 5e-3));
  CHECK(weibull.log_likelihood == Approx(-113.69).margin(5e-3 + 5e-3));
  const FittedLaw lognormal = fit_law(LifeFamily::lognormal, lives);
  CHECK(lognormal.first == Approx(4.150).margin(5e-4));
  CHECK(lognormal.second == Approx(0.522).margin(5e-4));
  const FittedLaw gamma = fit_law(LifeFamily::gamma, lives);
  CHECK(gamma.second == Approx(4.025).margin(5e-3));
  CHECK(gamma.first == Approx(17.94).margin(5e-2));
  // Exact lives: mean and standard deviation are the estimates of the normal law, the mean that of the
  // exponential one, and gamma keeps the mean.
  double sum = 0;
  for (const Observation& o : lives) sum += o.low;
  const double mean = sum / 23;
  double squares = 0;
  for (const Observation& o : lives) squares += (o.low - mean) * (o.low - mean);
  const FittedLaw normal = fit_law(LifeFamily::normal, lives);
  CHECK(normal.first == Approx(mean).epsilon(1e-9));
  CHECK(normal.second == Approx(std::sqrt(squares / 23)).epsilon(1e-7));
  CHECK(fit_law(LifeFamily::exponential, lives).first == Approx(mean).epsilon(1e-9));
  CHECK(gamma.mean() == Approx(mean).epsilon(1e-6));
  // A constant failure rate is the one law that bearings refute.
  const LifeRanking ranking = rank_laws(lives);
  CHECK(ranking.laws.back().family == LifeFamily::exponential);
  CHECK(ranking.unfitted.empty());
}

TEST_CASE("shock absorbers: right-censored, with the published intervals", "[fit]") {
  const std::vector<Observation> lives = shock_absorbers();
  REQUIRE(lives.size() == 38);
  const FittedLaw weibull = fit_law(LifeFamily::weibull, lives);
  CHECK(weibull.first == Approx(27719).epsilon(5e-4));  // Meeker, Escobar table 8.1
  CHECK(weibull.second == Approx(3.16).margin(5e-3 + 5e-3));
  const FittedLaw lognormal = fit_law(LifeFamily::lognormal, lives);
  CHECK(lognormal.first == Approx(10.14).margin(5e-3 + 5e-3));
  CHECK(lognormal.second == Approx(0.530).margin(1e-3));
}

TEST_CASE("turbine parts: inspections only", "[fit]") {
  const FittedLaw weibull = fit_law(LifeFamily::weibull, turbine_parts());
  CHECK(weibull.first ==
        Approx(71.690).margin(1e-2));  // Nelson 1982, p. 415; SAS/QC RELIABILITY prints 71.69
  CHECK(weibull.second == Approx(1.4854).margin(5e-4));
}

TEST_CASE("two groups: the ratio of lives, and exponential lives in closed form", "[fit]") {
  const std::vector<Observation> lives = two_batches();
  std::vector<Observation> treated(lives.begin() + 21, lives.end());
  CHECK(fit_law(LifeFamily::exponential, treated).first == Approx(359.0 / 9).epsilon(1e-9));
  const FittedLaw weibull = fit_law(LifeFamily::weibull, treated);
  CHECK(weibull.second == Approx(1.354).margin(1e-3));
  CHECK(weibull.first == Approx(33.77).margin(1e-2));
  const auto report = compare_batches(lives, 0.95);
  REQUIRE(report);
  // The log ratio of lives under a common Weibull shape, 1.267: Venables, Ripley, Modern Applied Statistics
  // with S, 4th ed. (2002), section 13.2, and every package since (their sign is that of the other group).
  REQUIRE(report->family == LifeFamily::weibull);
  REQUIRE(report->ratios.size() == 2);
  CHECK(std::log(report->ratios[1].life_ratio.estimate) == Approx(1.267).margin(5e-4));
  CHECK(report->ratios[1].life_ratio.bounds.low > 1);
  CHECK(report->scale_p_value < 1e-4);
  CHECK(report->shape_p_value > 0.2);
}
