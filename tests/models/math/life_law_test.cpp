// The life laws against closed forms, quadrature and their own definitions.
#include "models/math/life_law.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/catalogue/error.h"
#include "models/math/normal.h"
#include "models/math/solve.h"

using namespace verstat::models;

namespace {

LifeLaw arbitrary_law() {
  const double mean = *rc::gen::inRange(1, 1000) * 0.37;
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      return {LifeLawKind::weibull, mean, *rc::gen::inRange(50, 2000) * 1e-3};
    case 1:
      return {LifeLawKind::normal, mean, *rc::gen::inRange(50, 450) * 1e-3};
    case 2:
      return {LifeLawKind::lognormal, mean, *rc::gen::inRange(50, 2000) * 1e-3};
    case 3:
      return {LifeLawKind::gamma, mean, *rc::gen::inRange(50, 2000) * 1e-3};
    default:
      return {LifeLawKind::exponential, mean, 1};
  }
}

}  // namespace

TEST_CASE("Weibull shape and coefficient of variation are inverse over the whole range", "[math]") {
  for (int k = 0; k <= 2000; ++k) {
    const double cv = 1e-4 * std::pow(10 / 1e-4, k / 2000.0);
    INFO(cv);
    CHECK(weibull_cv(weibull_shape(cv)) == Approx(cv).epsilon(2e-12));
  }
  // Both forms of the coefficient of variation meet where one takes over.
  CHECK(weibull_cv(1 / 0.030000001) == Approx(weibull_cv(1 / 0.029999999)).epsilon(1e-7));
  CHECK(weibull_cv(1e4) == Approx(M_PI / std::sqrt(6.0) * 1e-4).epsilon(1e-3));  // Gumbel limit
  CHECK(weibull_shape(1) == 1);
  CHECK(weibull_shape(std::nextafter(1.0, 0.0)) >= 1);
  CHECK(weibull_shape(std::nextafter(1.0, 2.0)) <= 1);
  CHECK(weibull_shape(std::sqrt(5.0)) == Approx(0.5).epsilon(1e-13));           // Gamma(5)/Gamma(3)^2 - 1
  CHECK(weibull_shape(std::sqrt(4 / M_PI - 1)) == Approx(2.0).epsilon(1e-13));  // Rayleigh
}

TEST_CASE("the density is the slope of the failure probability, the hazard their ratio", "[math]") {
  CHECK(rc::check([] {
    const LifeLaw law = arbitrary_law();
    const double t = law.mean() * *rc::gen::inRange(5, 250) * 0.01;
    const double h = 1e-5 * t;
    const double slope = (law.failure_probability(t + h) - law.failure_probability(t - h)) / (2 * h);
    RC_ASSERT(std::abs(slope - law.density(t)) < 1e-6 * law.density(t) + 1e-9 / law.mean());
    RC_ASSERT(std::abs(law.reliability(t) + law.failure_probability(t) - 1) < 1e-15);
    if (law.reliability(t) > 1e-300)
      RC_ASSERT(std::abs(law.hazard(t) * law.reliability(t) / law.density(t) - 1) < 1e-10);
  }));
}

TEST_CASE("the restricted mean is the integral of the reliability and keeps its bounds", "[math]") {
  CHECK(rc::check([] {
    const LifeLaw law = arbitrary_law();
    const double tau = law.mean() * std::pow(10.0, *rc::gen::inRange(-60, 8) * 0.1);
    const double m = law.restricted_mean(tau);
    // In s with t = tau s^4 the integrand is smooth also where the hazard is infinite at 0.
    const double integral = integrate(
        [&](double s) { return law.reliability(tau * s * s * s * s) * 4 * tau * s * s * s; }, 0, 1, 1e-12);
    RC_ASSERT(std::abs(m - integral) < 2e-9 * integral);
    RC_ASSERT(m <= tau);
    RC_ASSERT(m <= law.mean_life() * (1 + 1e-15));
  }));
  const LifeLaw normal(LifeLawKind::normal, 60, 0.4);
  CHECK(normal.mean_life() / 60 == Approx(1.0008).margin(5e-5));
  CHECK(normal.restricted_mean(std::numeric_limits<double>::infinity()) == normal.mean_life());
}

TEST_CASE("gamma-percent life and quantile invert the reliability", "[math]") {
  CHECK(rc::check([] {
    const LifeLaw law = arbitrary_law();
    const double gamma = *rc::gen::inRange(1, 999) * 1e-3;
    const double t = law.gamma_percent_life(gamma);
    if (t > 0) RC_ASSERT(std::abs(law.reliability(t) - gamma) < 1e-12);
    RC_ASSERT(std::abs(law.quantile(1 - gamma) - t) <= 1e-11 * law.mean());
  }));
  const LifeLaw scattered(LifeLawKind::normal, 60, 0.45);
  CHECK(scattered.gamma_percent_life(0.98) > 0);
  CHECK(scattered.gamma_percent_life(0.9870) == 0);  // above Phi(1/0.45) = 0.98687
}

TEST_CASE("with_mean stretches time and nothing else", "[math]") {
  CHECK(rc::check([] {
    const LifeLaw law = arbitrary_law();
    const LifeLaw twice = law.with_mean(2 * law.mean());
    const double t = law.mean() * *rc::gen::inRange(1, 300) * 0.01;
    RC_ASSERT(std::abs(twice.reliability(2 * t) - law.reliability(t)) < 1e-14);
    RC_ASSERT(std::abs(twice.restricted_mean(2 * t) / law.restricted_mean(t) - 2) < 1e-13);
  }));
}

TEST_CASE("normal tails: Mills ratio and quantile", "[math]") {
  CHECK(normal_quantile(0.975) == Approx(1.959963984540054).epsilon(1e-14));
  CHECK(normal_hazard(std::nextafter(20.0, 0.0)) == Approx(normal_hazard(20.0)).epsilon(1e-12));
  CHECK(normal_hazard(1000) == Approx(1000 + 1e-3 - 2e-9).epsilon(1e-14));  // z + 1/z - 2/z^3
  CHECK(LifeLaw(LifeLawKind::normal, 60, 0.05).hazard(600) == Approx(60.0055).epsilon(1e-4));
}

TEST_CASE("renewal function: exponential closed form, short and long intervals", "[math]") {
  CHECK(LifeLaw(LifeLawKind::exponential, 60, 1).renewal_function(90) == Approx(1.5).epsilon(1e-6));
  CHECK(LifeLaw(LifeLawKind::exponential, 60, 1).renewal_function(3000) == Approx(50).epsilon(1e-4));
  const LifeLaw weibull(LifeLawKind::weibull, 60, 0.7);
  CHECK(weibull.renewal_function(20) == Approx(0.1705).margin(5e-5));
  CHECK(weibull.renewal_function(45) == Approx(0.5182).margin(5e-5));
  CHECK(weibull.renewal_function(90) == Approx(1.2448).margin(5e-5));
  // Long intervals: T/mean - (1 - CV^2)/2.
  CHECK(weibull.renewal_function(1200) == Approx(20 - (1 - 0.49) / 2).epsilon(1e-4));
  // Renewal equation H = F + H*F, at a coarse grid for the convolution: first order in its step.
  const LifeLaw normal(LifeLawKind::normal, 1, 0.4);
  double right = normal.failure_probability(1.2);
  constexpr int n = 200;
  for (int k = 0; k < n; ++k) {
    const double dh = normal.renewal_function(1.2 * (k + 1) / n) - normal.renewal_function(1.2 * k / n);
    right += dh * normal.failure_probability(1.2 - 1.2 * (k + 0.5) / n);
  }
  CHECK(normal.renewal_function(1.2) == Approx(right).epsilon(1e-3));
}

TEST_CASE("lognormal and gamma lives: closed forms, moments, hazards in the far tail", "[math]") {
  // Gamma with cv 1 is exponential, with cv 1/2 the sum of four exponentials.
  const LifeLaw one(LifeLawKind::gamma, 60, 1);
  const LifeLaw exponential(LifeLawKind::exponential, 60, 1);
  const LifeLaw erlang(LifeLawKind::gamma, 60, 0.5);
  for (const double t : {0.0, 1e-3, 7.0, 60.0, 400.0}) {
    CHECK(one.reliability(t) == Approx(exponential.reliability(t)).epsilon(1e-13));
    CHECK(one.hazard(t) == Approx(1.0 / 60).epsilon(1e-12));
    CHECK(one.restricted_mean(t) == Approx(exponential.restricted_mean(t)).epsilon(1e-12));
    const double x = t / 15;
    CHECK(erlang.reliability(t) == Approx(std::exp(-x) * (1 + x + x * x / 2 + x * x * x / 6)).epsilon(1e-13));
  }
  const LifeLaw lognormal(LifeLawKind::lognormal, 60, 0.5);
  const double log_sd = std::sqrt(std::log(1.25));
  CHECK(lognormal.shape() == Approx(log_sd).epsilon(1e-15));
  CHECK(lognormal.scale() == Approx(60 * std::exp(-log_sd * log_sd / 2)).epsilon(1e-14));
  CHECK(lognormal.gamma_percent_life(0.5) == Approx(lognormal.scale()).epsilon(1e-14));
  CHECK(lognormal.reliability(0) == 1);
  CHECK(lognormal.hazard(0) == 0);
  // Mean and scatter of the lives that quantile() draws.
  for (const LifeLaw& law : {lognormal, erlang, LifeLaw(LifeLawKind::gamma, 60, 1.4)}) {
    double mean = 0;
    double squares = 0;
    constexpr int n = 200'000;
    for (int k = 0; k < n; ++k) {
      const double life = law.quantile((k + 0.5) / n);
      mean += life / n;
      squares += life * life / n;
    }
    CHECK(mean == Approx(60).epsilon(1e-4));
    CHECK(std::sqrt(squares - mean * mean) / mean == Approx(law.cv()).epsilon(3e-3));
    CHECK(law.restricted_mean(std::numeric_limits<double>::infinity()) == 60);
  }
  // Where R underflows the hazard goes on: over the seam without a jump, and to 1/scale.
  const double seam = 15 * 470;
  CHECK(erlang.reliability(seam * 1.02) < 1e-200);
  CHECK(erlang.reliability(seam * 0.95) > 1e-200);
  for (double x = 440; x < 500; x += 0.25) {
    const double closed = (x * x * x / 6) / (1 + x + x * x / 2 + x * x * x / 6);
    CHECK(erlang.hazard(15 * x) * 15 == Approx(closed).epsilon(1e-11));
  }
  CHECK(erlang.hazard(1e7) * 15 == Approx(1).epsilon(1e-5));
  CHECK(std::isfinite(lognormal.hazard(1e30)));
  CHECK_THROWS_WITH(LifeLaw(LifeLawKind::gamma, 60, 0.005),
                    "cv = 0.005, allowed 0.01 <= cv <= 10 for the gamma law");
  CHECK_THROWS_AS(LifeLaw(LifeLawKind::lognormal, 60, 11), DomainError);
}

TEST_CASE("life laws refuse what they cannot be", "[math]") {
  CHECK_THROWS_WITH(LifeLaw(LifeLawKind::normal, 60, 0.7),
                    "cv = 0.7, allowed 0.05 <= cv <= 0.45 for the normal law");
  CHECK_THROWS_AS(LifeLaw(LifeLawKind::weibull, 0, 0.7), DomainError);
  CHECK_THROWS_AS(LifeLaw(LifeLawKind::weibull, std::nan(""), 0.7), DomainError);
  CHECK_THROWS_AS(LifeLaw::weibull(60, 0.1), DomainError);
}

TEST_CASE("the hazard of a new tool of gamma life: none, that of chance, or without bound", "[math]") {
  CHECK(LifeLaw(LifeLawKind::gamma, 40, 0.5).hazard(0) == 0);
  CHECK(LifeLaw(LifeLawKind::gamma, 40, 1).hazard(0) == Approx(1.0 / 40).epsilon(1e-14));
  CHECK(std::isinf(LifeLaw(LifeLawKind::gamma, 40, 2).hazard(0)));
}
