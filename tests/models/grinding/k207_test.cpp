// The checks of card K207; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <complex>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k207_longitudinal_feed_controller.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k207;

namespace {

double part(double low, double high) {  // one of 1000 steps between
  return low + (high - low) * *rc::gen::inRange(0, 1000) * 1e-3;
}

StepInputs loop(double gain, double pole, std::int64_t delay, std::int64_t samples) {
  StepInputs in;
  in.plant_gain = gain;
  in.plant_pole = pole;
  in.delay = delay;
  in.n_samples = samples;
  return in;
}

// Largest gain with all roots inside the unit circle, by halving.
double largest_stable_gain(std::int64_t delay) {
  double low = 0.1;
  double high = 20;
  for (int k = 0; k < 50; ++k) {
    const double middle = (low + high) / 2;
    (feed_loop_spectral_radius(loop(middle, 0.9091867638508087, delay, 1)).rho < 1 ? low : high) = middle;
  }
  return low;
}

}  // namespace

TEST_CASE("K207: feed and pass time are inverse", "[K207]") {
  verstat::test::property([] {
    const double length = part(10, 1000);
    const double time = part(0.5, 60);
    const double feed = longitudinal_feed({length, time}).feed_m_min;
    RC_ASSERT(std::abs(longitudinal_pass_time({length, feed}).pass_time_s / time - 1) < 1e-14);
  });
}

TEST_CASE("K207: entropy interval is exp(H)/2 of its law, linear in sigma", "[K207]") {
  // Entropy by summing -f ln f of the densities with standard deviation 1.
  const auto interval = [](auto density, double half) {
    double entropy = 0;
    constexpr int cells = 400000;
    for (int k = 0; k < cells; ++k) {
      const double f = density(half * (2 * (k + 0.5) / cells - 1));
      if (f > 0) entropy -= f * std::log(f) * 2 * half / cells;
    }
    return std::exp(entropy) / 2;
  };
  const double root6 = std::sqrt(6.0);
  const auto of = [](ErrorLaw law) { return entropy_interval({1, law}).delta_e; };
  CHECK(of(ErrorLaw::triangular) ==
        Approx(interval([&](double x) { return (1 - std::abs(x) / root6) / root6; }, root6)).epsilon(1e-8));
  CHECK(of(ErrorLaw::normal) ==
        Approx(interval([](double x) { return std::exp(-x * x / 2) / std::sqrt(2 * std::numbers::pi); }, 12))
            .epsilon(1e-8));
  CHECK(
      of(ErrorLaw::laplace) ==
      Approx(interval(
                 [](double x) { return std::exp(-std::abs(x) * std::numbers::sqrt2) / std::numbers::sqrt2; },
                 40))
          .epsilon(1e-6));
  CHECK(of(ErrorLaw::uniform) < of(ErrorLaw::laplace));
  CHECK(of(ErrorLaw::laplace) < of(ErrorLaw::triangular));
  CHECK(of(ErrorLaw::triangular) < of(ErrorLaw::normal));
  CHECK(entropy_interval({3, ErrorLaw::normal}).delta_e == Approx(3 * of(ErrorLaw::normal)));
}

TEST_CASE("K207: the drive polynomial is the loop of four lags behind the motor", "[K207]") {
  verstat::test::property([] {
    const DriveLags in{part(0.01, 1), part(0.01, 1), part(0.01, 1), part(0.01, 1), part(0.01, 1)};
    const DrivePolynomial d = drive_polynomial(in);
    const double p = part(0.1, 10);
    const double value = (((d.a4 * p + d.a3) * p + d.a2) * p + d.a1) * p + d.a0;
    const double lags =
        (in.tau_mc_s * p + 1) * (in.t_mc_s * p + 1) * (in.t_e_s * p + 1) * (in.t_em_s * p + 1);
    RC_ASSERT(std::abs(value / ((in.t_m_s * p + 1) * (lags - 1) / p) - 1) < 1e-10);
  });
}

TEST_CASE("K207: the blocks are their transfer functions on the imaginary axis", "[K207]") {
  verstat::test::property([] {
    BlockAtFrequency in;
    in.freq_hz = part(0.01, 40);
    in.k = part(-3, 3.001);
    in.tau_s = part(0.001, 0.3);
    in.delta_e = part(0.1, 2);
    const std::complex<double> p(0, 2 * std::numbers::pi * in.freq_hz);
    const auto same = [&](Block block, std::complex<double> expected) {
      in.block = block;
      const FrequencyResponse r = feed_channel_block(in);
      RC_ASSERT(r.phase_deg > -180 && r.phase_deg <= 180);
      const auto got = std::polar(r.magnitude, r.phase_deg * std::numbers::pi / 180);
      RC_ASSERT(std::abs(got - expected) < 1e-9 * std::max(1.0, std::abs(expected)));
    };
    const std::complex<double> late = std::exp(-p * *in.tau_s);
    same(Block::input, in.delta_e * *in.k * late);
    same(Block::hold, (1.0 - late) / p);
    same(Block::regulator, (1.0 - late) / *in.tau_s);
  });
}

TEST_CASE("K207: D is the start of the long division B F / A only as repaired", "[K207]") {
  verstat::test::property([] {
    const PlantModel plant{{part(0.2, 2), part(-2, -0.2), part(0.1, 1)},
                           {part(-1, 1), part(-1, 1), part(-1, 1), part(-1, 1)},
                           0.3,
                           0.4,
                           Variant::repaired};
    const RegulatorPolynomials r = regulator_polynomials(plant);
    const auto& [b, f, a] = std::tie(plant.b, r.f, plant.a);
    const double q0 = b[0] * f[0];
    const double q1 = b[1] * f[0] + b[0] * f[1] - a[0] * q0;
    const double q2 = b[2] * f[0] + b[1] * f[1] + b[0] * f[2] - a[0] * q1 - a[1] * q0;
    RC_ASSERT(std::abs(r.g[0] - q0) < 1e-12);
    RC_ASSERT(std::abs(r.g[1] - q1) < 1e-12);
    RC_ASSERT(std::abs(r.g[2] - q2) < 1e-12);
  });
}

TEST_CASE("K207: spectral radius of known roots", "[K207]") {
  // A D = (1 - 0.5 z^-1)(1 + 0.8 z^-1), no feedback.
  CHECK(closed_loop_spectral_radius({{-0.5}, {}, {2, 1.6}, {}, 1}).rho == Approx(0.8));
  CHECK(closed_loop_spectral_radius({{}, {}, {3}, {1}, 4}).rho == 0);
  // 1 + 0.64 z^-2: roots +-0.8 j; with a delay of 4 the fourth root.
  CHECK(closed_loop_spectral_radius({{}, {0.64}, {1}, {1}, 2}).rho == Approx(0.8));
  CHECK(closed_loop_spectral_radius({{}, {0.4096}, {1}, {1}, 4}).rho == Approx(0.8));
}

TEST_CASE("K207: controller (14) integrates and delays", "[K207]") {
  const RegulatorGains g = regulator_gains({});
  CHECK(g.k_i == Approx(0.23134).margin(5e-6));
  CHECK(g.k_p == Approx(2.09626).margin(5e-6));
  CHECK(g.k_d == Approx(-2.20053).margin(5e-6));
  CHECK(g.zero_1 == Approx(-19.05).margin(5e-3));
  CHECK(g.zero_2 == Approx(0.90919).margin(5e-6));
  verstat::test::property([] {
    RegulatorInputs in;
    in.u_prev = part(-2, 2);
    in.e0 = part(-2, 2);
    in.e1 = part(-2, 2);
    in.e2 = part(-2, 2);
    const RegulatorGains k = regulator_gains({});
    const double regrouped =
        in.u_prev + k.k_p * (in.e0 - in.e1) + k.k_i * in.e0 + k.k_d * (in.e0 - 2 * in.e1 + in.e2);
    RC_ASSERT(std::abs(regulator_step(in).u - regrouped) < 1e-12);
  });
  CHECK(regulator_gains({1, -3, 2, 1}).zero_2 == Approx(2));
}

TEST_CASE("K207: the default loop overshoots a little and leaves no error", "[K207]") {
  const auto at = [](std::int64_t delay) {
    return feed_channel_step_response(loop(1, 0.9091867638508087, delay, 400));
  };
  CHECK(at(2).overshoot_pct == Approx(8.83).margin(5e-3));
  CHECK(at(2).settle_samples == 14);
  CHECK(at(2).steady_error == Approx(0).margin(1e-9));
  CHECK(at(1).overshoot_pct == Approx(0).margin(1e-9));
  CHECK(at(3).overshoot_pct == Approx(30).margin(0.5));
  CHECK(at(4).overshoot_pct == Approx(53).margin(0.5));
}

TEST_CASE("K207: stability limits, and responses that agree with the roots", "[K207]") {
  CHECK(largest_stable_gain(1) == Approx(4.550).margin(6e-4));
  CHECK(largest_stable_gain(2) == Approx(2.747).margin(6e-4));
  CHECK(largest_stable_gain(3) == Approx(1.960).margin(6e-4));
  CHECK(largest_stable_gain(4) == Approx(1.522).margin(6e-4));
  CHECK(feed_loop_spectral_radius(loop(1, 0.715, 2, 1)).rho > 1);
  CHECK(feed_loop_spectral_radius(loop(1, 0.719, 2, 1)).rho < 1);
  verstat::test::property([] {
    const StepInputs in = loop(part(0.3, 2), part(0.75, 0.97), *rc::gen::inRange(1, 4), 600);
    const double rho = feed_loop_spectral_radius(in).rho;
    RC_PRE(rho < 0.97);
    RC_ASSERT(std::abs(feed_channel_step_response(in).steady_error) < 1e-3);  // pole of (14) at z = 1
    // The same polynomial from the general function.
    const double gain = in.plant_gain * (1 - in.plant_pole) / in.d0;
    const double general =
        closed_loop_spectral_radius({{-in.plant_pole}, {gain}, {1, -1}, {in.n0, in.n1, in.n2}, in.delay}).rho;
    RC_ASSERT(std::abs(general - rho) < 1e-6);
  });
}

TEST_CASE("K207: time of passes during a change of feed", "[K207]") {
  FeedChange in;
  in.length_mm = 200;
  in.feed_from_m_min = in.feed_to_m_min = 5;
  in.n_passes = 17;
  CHECK(feed_change_time(in).time_min == Approx(17 * 0.2 / 5));
  in.feed_from_m_min = 4;
  in.n_passes = 1;
  CHECK(feed_change_time(in).time_min == Approx(0.2 / 4));
  in.feed_from_m_min = 20;
  in.feed_to_m_min = 1;
  in.n_passes = 30;
  CHECK_THROWS_WITH(feed_change_time(in), Catch::Contains("feed_to_m_min = 1, makes the feed overshoot"));
}

TEST_CASE("K207: a dead band leaves an error inside it", "[K207]") {
  StepInputs in = loop(1, 0.9091867638508087, 2, 400);
  in.dead_band = 0.05;
  const StepResponse r = feed_channel_step_response(in);
  CHECK(std::abs(r.steady_error) <= 0.05);
  CHECK(std::abs(r.steady_error) > 1e-6);
}

TEST_CASE("K207: bad input names itself", "[K207]") {
  BlockAtFrequency in;
  in.freq_hz = 1;
  CHECK_THROWS_WITH(feed_channel_block(in), Catch::Contains("K207.feed_channel_block: tau_s = "));
  CHECK_THROWS_WITH(feed_channel_block(in), Catch::Contains("must be given for this block"));
  CHECK_THROWS_WITH(regulator_gains({1, 1, 1, 1}),
                    "K207.regulator_gains: n1 = 1, must leave the zeros of n0 z^2 + n1 z + n2 real");
  CHECK_THROWS_WITH(regulator_polynomials({{1, 0, 1}, {1, 1, 1, 1}, 1, 1}),
                    Catch::Contains("a/1 = 0, must not be 0"));
}
