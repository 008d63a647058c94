// The checks of card K209; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k209_grinding_wheel_radial_oscillations.h"
#include "models/math/solve.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k209;

namespace {

double part(double low, double high) {  // one of 1000 steps between
  return low + (high - low) * *rc::gen::inRange(0, 1000) * 1e-3;
}

// The paper's regime with another amplitude.
Waviness waviness(double amplitude_um) {
  return flat_grinding_waviness({amplitude_um, 2230, 1, 6, 250});
}

}  // namespace

TEST_CASE("K209: published frequency, speed and growth of the housing vibration", "[K209]") {
  CHECK(rotation_frequency({2230}).freq_hz == Approx(37.17).margin(5e-3));
  CHECK(wheel_speed({250, 2230}).speed_m_s == Approx(29.2).margin(0.05));
  CHECK(headstock_amplitude({100}).amplitude_um / headstock_amplitude({0}).amplitude_um ==
        Approx(3.3).margin(0.05));
}

TEST_CASE("K209: the table of amplitudes", "[K209]") {
  const auto read = [](Mounting m, State s, std::int64_t h) {
    const VibrationAmplitude a = wheel_vibration_amplitude({m, s, h});
    return std::pair{a.amplitude_um, a.exact};
  };
  using enum Mounting;
  using enum State;
  CHECK(read(standard_flange, idle, 2) == std::pair{0.79, std::int64_t{1}});
  CHECK(read(standard_flange, idle, 3) == std::pair{0.5, std::int64_t{0}});
  CHECK(read(standard_flange, grinding, 3) == std::pair{0.51, std::int64_t{1}});
  CHECK(read(standard_flange, grinding, 4) == std::pair{0.5, std::int64_t{0}});
  CHECK(read(standard_flange, grinding, 6) == std::pair{0.56, std::int64_t{1}});
  CHECK(read(centring_device, grinding, 1) == std::pair{0.9, std::int64_t{1}});
  CHECK(read(centring_device, grinding, 2) == std::pair{0.5, std::int64_t{0}});
  CHECK_THROWS_WITH(read(centring_device, idle, 1),
                    Catch::Contains("the centring device was not measured idle"));
}

TEST_CASE("K209: waviness of the paper's regime", "[K209]") {
  CHECK(waviness(0.9).wavelength_mm == Approx(2.69).margin(5e-3));
  CHECK(waviness(0.9).critical_amplitude_um == Approx(1.467).margin(5e-4));
  CHECK(waviness(0.9).height_um == Approx(1.80).margin(5e-3));
  CHECK(waviness(2.36).height_um == Approx(4.17).margin(5e-3));
}

TEST_CASE("K209: waviness is continuous, grows, and is bounded by 2A and the cusp", "[K209]") {
  const double critical = waviness(1).critical_amplitude_um;
  CHECK(waviness(critical * (1 + 1e-9)).height_um == Approx(2 * critical).epsilon(1e-8));
  verstat::test::property([] {
    const double amplitude = std::exp(part(-3, 25));
    const Waviness w = waviness(amplitude);
    RC_ASSERT(waviness(amplitude * 1.01).height_um >= w.height_um * (1 - 1e-13));
    RC_ASSERT(w.height_um <= 2 * amplitude * (1 + 1e-12));
    RC_ASSERT(w.height_um <= 1000 * w.wavelength_mm * w.wavelength_mm / (8 * 125) * (1 + 1e-12));
  });
  const Waviness far = waviness(1e18);
  CHECK(far.height_um == Approx(far.wavelength_mm * far.wavelength_mm));  // lambda^2 / (8 R), R = 125 mm, um
}

TEST_CASE("K209: waviness is the envelope of the wheel, by brute force", "[K209]") {
  verstat::test::property([] {
    const double amplitude_mm = part(0.1, 10) * 1e-3;
    const double diameter = part(100, 500);
    const WavinessInputs in{amplitude_mm * 1000, part(1000, 4000), *rc::gen::inRange(1, 4), part(2, 20),
                            diameter};
    const Waviness w = flat_grinding_waviness(in);
    const double k = 2 * std::numbers::pi / w.wavelength_mm;
    // Lowest wheel over the middle between two crests of the axis, and over the trough.
    const auto profile = [&](double place) {
      return minimize_global(
                 [&](double x) {
                   return amplitude_mm * std::cos(k * x) + (place - x) * (place - x) / diameter;
                 },
                 place - w.wavelength_mm, place + w.wavelength_mm, 400)
          .value;
    };
    const double height_um = 1000 * (profile(0) - profile(w.wavelength_mm / 2));
    RC_ASSERT(std::abs(w.height_um / height_um - 1) < 1e-5);
  });
}

TEST_CASE("K209: depth swing, unbalance and displacement", "[K209]") {
  CHECK(depth_modulation({0.9, 0.015}).ratio == Approx(0.06));
  CHECK(depth_modulation({2.36, 0.015}).ratio == Approx(0.16).margin(5e-3));
  CHECK(unbalance_force({1.8, 100, 2230}).force_n == Approx(9.8).margin(0.05));
  verstat::test::property([] {
    const double t = part(0, 1);
    const OscillationInputs in{t, 2230, {1, 3}, {2.36, 0.51}, {10, 20}};
    OscillationInputs turn_later = in;
    turn_later.t_s += 1000 * 60.0 / 2230;
    const double x = wheel_radial_displacement(in).x_um;
    RC_ASSERT(std::abs(wheel_radial_displacement(turn_later).x_um - x) < 1e-8);
    RC_ASSERT(std::abs(x) <= 2.36 + 0.51);
  });
}

TEST_CASE("K209: harmonics at the threshold stay", "[K209]") {
  CHECK(significant_harmonics({{1, 2, 3, 4}, {0.9, 0.5, 0.4999, 0.6}, 0.5}).kept ==
        std::vector<std::int64_t>{1, 2, 4});
  CHECK_THROWS_WITH(
      significant_harmonics({{1, 2}, {0.9}, 0.5}),
      "K209.significant_harmonics: amplitude_um = 1, entries: must have as many as harmonic, 2");
}
