// The checks of card K201; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/dynamics/k201_bearing_resonance.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k201;

namespace {

constexpr double pi = std::numbers::pi;

// The demonstration data fitted to the printed bands: p(n) and ratio(n).
BandInputs fitted(double damping) {
  BandInputs in;
  for (double n = 34300; n <= 45000; n += 50) {
    const double x = (n - 34300) / 1000;
    in.speed_nodes_rpm.push_back(n);
    in.p_nodes_rad_s.push_back(10880 - 231.56 * x - 2.8806 * x * x);
    in.ratio_nodes.push_back(n < 39000 ? 0.42023 : 0.52126);
  }
  in.cage_ratio = 0.46265872;
  in.harmonic = 4;
  in.damping_ratio = damping;
  in.n_min_rpm = 34300;
  in.n_max_rpm = 45000;
  return in;
}

double width(const SpeedBands& bands) {
  double sum = 0;
  for (const SpeedBand& b : bands.bands) sum += b.n_high_rpm - b.n_low_rpm;
  return sum;
}

SpinningBearing sea35(double rpm) {
  SpinningBearing b;
  b.ball_diameter_mm = 3.17;
  b.pitch_diameter_mm = 41;
  b.contact_angle_deg = 15;
  b.balls = 26;
  b.preload_n = 60;
  b.spindle_speed_rpm = rpm;
  return b;
}

}  // namespace

TEST_CASE("K201: stiffness and natural frequencies of the paper", "[K201]") {
  CHECK(bearing_natural_frequencies({0.015, 12, 12, 1.8}).p1_rad_s == Approx(10880).epsilon(0.007));
  // 12.59 -+ 7.14 N/um in the plane give the printed second and third frequency.
  const RingFrequencies p = bearing_natural_frequencies({0.015, 12.59, 12.59, 1.7756, 7.14});
  CHECK(p.p2_rad_s == Approx(19061.85).epsilon(1e-3));
  CHECK(p.p3_rad_s == Approx(36265.8).epsilon(1e-3));
  CHECK(bearing_natural_frequencies({0.015, 12, 12, -1}).p1_rad_s == 0);
}

TEST_CASE("K201: harmonics of a known stiffness come back", "[K201]") {
  verstat::test::property([] {
    const int n = *rc::gen::inRange(5, 60);
    const int m = *rc::gen::inRange(1, (n + 1) / 2);
    const double amplitude = 0.1 * *rc::gen::inRange(1, 30);
    const double phase = 0.1 * *rc::gen::inRange(-30, 31);
    StiffnessSamples in;
    for (int k = 0; k < n; ++k)
      in.samples_n_per_um.push_back(7 + amplitude * std::cos(2 * pi * m * k / n + phase));
    in.harmonics = (n - 1) / 2;
    RC_PRE(m <= in.harmonics);
    const StiffnessHarmonics h = stiffness_harmonics(in);
    RC_ASSERT(std::abs(h.mean_n_per_um - 7) < 1e-9);
    for (std::int64_t r = 1; r <= in.harmonics; ++r) {
      const auto i = static_cast<std::size_t>(r - 1);
      RC_ASSERT(std::abs(h.amplitudes_n_per_um[i] - (r == m ? amplitude : 0)) < 1e-9);
      if (r == m) RC_ASSERT(std::abs(h.phases_rad[i] - phase) < 1e-8);
    }
  });
}

TEST_CASE("K201: modulation of coinciding modes does not depend on the axes", "[K201]") {
  const StiffnessMatrix mean{12, 12, 1.8, 0, 0, 0};
  const auto turned = [](double deg) {
    // diag(0.9, 0.2) in the plane, turned.
    const double c = std::cos(deg * pi / 180), s = std::sin(deg * pi / 180);
    return StiffnessMatrix{0.9 * c * c + 0.2 * s * s, 0.9 * s * s + 0.2 * c * c, 0.7, 0.7 * s * c, 0, 0};
  };
  for (const double deg : {0.0, 17.0, 45.0, 80.0}) {
    const Modulation m = principal_stiffness_modulation({mean, turned(deg)});
    CHECK(m.kr_n_per_um[0] == Approx(0.7));
    CHECK(m.kr_n_per_um[1] == Approx(0.2));
    CHECK(m.kr_n_per_um[2] == Approx(0.9));
  }
  CHECK_THROWS_WITH(principal_stiffness_modulation({{1, 1, 0, 0, 0, 0}, mean}),
                    Catch::Contains("mean_matrix has the principal stiffness 0"));
}

TEST_CASE("K201: a is 4 at plain resonance, and zone tips follow from it", "[K201]") {
  const double n = parametric_critical_speed({10880, 0.46, 3, 2}).speed_rpm;
  CHECK(mathieu_parameters({10880, n, 0.46, 3, 0.1}).a == Approx(4));
  CHECK(mathieu_parameters({10880, n, 0.46, 3, 0.1}).omega_exc_rad_s == Approx(10880));
  // Constant 10880 rad/s puts the zones where the card says, not where the paper prints them.
  CHECK(parametric_critical_speed({10880, 0.46266, 4, 3}).speed_rpm == Approx(37427).margin(1));
  CHECK(parametric_critical_speed({10880, 0.46266, 4, 2}).speed_rpm == Approx(56141).margin(1));
}

TEST_CASE("K201: without modulation the half trace is cos(pi sqrt(a))", "[K201]") {
  for (double a = 0; a <= 100; a += 3.7) {
    const Floquet f = mathieu_floquet({a, 0});
    CHECK(f.half_trace == Approx(std::cos(pi * std::sqrt(a))).margin(2e-7));
    CHECK(f.growth_per_tau == Approx(0).margin(1e-4));
  }
  CHECK(mathieu_floquet({-2, 0}).growth_per_tau == Approx(std::sqrt(2)).epsilon(1e-6));
}

TEST_CASE("K201: zone borders separate growth from rest", "[K201]") {
  verstat::test::property([] {
    const int zone = *rc::gen::inRange(1, 4);
    const double b = 0.05 * *rc::gen::inRange(20, 60);
    const ZoneEdges e = mathieu_zone_edges({zone, b});
    const double w = e.a_high - e.a_low;
    RC_ASSERT(w > 0);
    RC_ASSERT(mathieu_floquet({0.5 * (e.a_low + e.a_high), b}).unstable == 1);
    RC_ASSERT(mathieu_floquet({e.a_low + 1e-3 * w, b}).unstable == 1);
    RC_ASSERT(mathieu_floquet({e.a_high - 1e-3 * w, b}).unstable == 1);
    RC_ASSERT(mathieu_floquet({e.a_high + 1e-3 * w, b}).unstable == 0);
    const ZoneEdges mirrored = mathieu_zone_edges({zone, -b});
    RC_ASSERT(mirrored.a_low == e.a_low);
  });
}

TEST_CASE("K201: zones close at b = 0, the first is the widest, expansions for small b", "[K201]") {
  for (std::int64_t k = 1; k <= 10; ++k) {
    const ZoneEdges tip = mathieu_zone_edges({k, 0});
    CHECK(tip.a_low == Approx(static_cast<double>(k * k)));
    CHECK(tip.a_high == Approx(static_cast<double>(k * k)));
    if (k > 1) {
      const ZoneEdges narrow = mathieu_zone_edges({k, 0.5});
      const ZoneEdges first = mathieu_zone_edges({1, 0.5});
      CHECK(narrow.a_high - narrow.a_low < first.a_high - first.a_low);
    }
  }
  const double b = 0.05;
  CHECK(mathieu_zone_edges({1, b}).a_low == Approx(1 - b - b * b / 8).margin(5e-6));
  CHECK(mathieu_zone_edges({1, b}).a_high == Approx(1 + b - b * b / 8).margin(5e-6));
  CHECK(mathieu_zone_edges({2, b}).a_low == Approx(4 - b * b / 12).margin(1e-6));
  CHECK(mathieu_zone_edges({2, b}).a_high == Approx(4 + 5 * b * b / 12).margin(1e-6));
  CHECK(mathieu_zone_edges({3, b}).a_low == Approx(9 + b * b / 16 - b * b * b / 64).margin(1e-6));
}

TEST_CASE("K201: damping threshold of zone 1 is kappa = 4 zeta", "[K201]") {
  for (const double p : {500.0, 10880.0}) {
    CHECK(parametric_growth_rate({p, 2 * p, 0.081, 0.02}).unstable == 1);
    CHECK(parametric_growth_rate({p, 2 * p, 0.079, 0.02}).unstable == 0);
  }
  CHECK(parametric_growth_rate({1000, 5000, 0.01, 0.02}).growth_1_s == Approx(-20));
}

TEST_CASE("K201: the fitted data give the printed bands, and damping never widens them", "[K201]") {
  const SpeedBands printed = parametric_speed_bands(fitted(0));
  REQUIRE(printed.bands.size() == 2);
  CHECK(printed.bands[0].zone == 3);
  CHECK(printed.bands[0].n_low_rpm == Approx(35642).margin(1));
  CHECK(printed.bands[0].n_high_rpm == Approx(35880).margin(1));
  CHECK(printed.bands[1].zone == 2);
  CHECK(printed.bands[1].n_low_rpm == Approx(42625).margin(1));
  CHECK(printed.bands[1].n_high_rpm == Approx(43850).margin(1));
  double before = width(printed);
  for (const double zeta : {0.002, 0.005, 0.01, 0.02}) {
    const double now = width(parametric_speed_bands(fitted(zeta)));
    CHECK(now <= before);
    before = now;
  }
}

TEST_CASE("K201: a band open at an end of the range is closed there", "[K201]") {
  BandInputs in = fitted(0);
  in.n_min_rpm = 35700;
  in.n_max_rpm = 35800;
  const SpeedBands inside = parametric_speed_bands(in);
  REQUIRE(inside.bands.size() == 1);
  CHECK(inside.bands[0].n_low_rpm == 35700);
  CHECK(inside.bands[0].n_high_rpm == 35800);
}

TEST_CASE("K201: regimes", "[K201]") {
  CHECK(bearing_excitation_regime({1, 0.3, 0.01}).regime == Regime::parametric);
  CHECK(bearing_excitation_regime({4, 0.01, 0.05}).regime == Regime::forced_resonance);
  CHECK(bearing_excitation_regime({6, 0.01, 0.05}).regime == Regime::quiet);
}

TEST_CASE("K201: forced vibration", "[K201]") {
  CHECK(forced_vibration_amplitude({1, 1000, 1000, 0.05}).amplitude_um == Approx(10));
  CHECK(forced_vibration_amplitude({1, 1e-3, 1000, 0.05}).amplitude_um == Approx(1));
  CHECK_THROWS_WITH(forced_vibration_amplitude({1, 1000, 1000, 0}),
                    "K201.forced_vibration_amplitude: damping_ratio = 0, must be positive at resonance");
}

TEST_CASE("K201: fixed contact angle ties radial to axial stiffness", "[K201]") {
  const StaticStiffness s = bearing_static_stiffness(sea35(1));
  const double cot = 1 / std::tan(15 * pi / 180);
  CHECK(s.radial_n_per_um / s.axial_n_per_um == Approx(0.5 * cot * cot));
  CHECK(0.5 * cot * cot == Approx(6.96).margin(0.005));
}

TEST_CASE("K201: stiffness at speed", "[K201]") {
  CHECK(bearing_stiffness_at_speed(sea35(1000)).radial_n_per_um == Approx(116).margin(0.5));
  CHECK(bearing_stiffness_at_speed(sea35(20000)).radial_n_per_um == Approx(90).margin(0.5));
  CHECK(bearing_stiffness_at_speed(sea35(34300)).radial_n_per_um == Approx(48).margin(0.5));
  CHECK(bearing_stiffness_at_speed(sea35(34300)).axial_n_per_um == Approx(12.1).margin(0.05));
  CHECK(bearing_stiffness_at_speed(sea35(90000)).radial_n_per_um >
        bearing_stiffness_at_speed(sea35(60000)).radial_n_per_um);
  const SpeedStiffness slow = bearing_stiffness_at_speed(sea35(1000));
  CHECK(slow.alpha_inner_deg == Approx(slow.alpha_outer_deg).margin(0.2));
  CHECK(slow.centrifugal_n < 0.02);
  double before = 1e9;
  for (double n = 1000; n <= 37500; n += 500) {
    const double now = bearing_stiffness_at_speed(sea35(n)).radial_n_per_um;
    CHECK(now < before);
    before = now;
  }
  // Axial equilibrium at the inner race.
  const SpeedStiffness fast = bearing_stiffness_at_speed(sea35(30000));
  CHECK(26 * fast.ball_load_inner_n * std::sin(fast.alpha_inner_deg * pi / 180) == Approx(60));
}

TEST_CASE("K201: bad input names itself", "[K201]") {
  CHECK_THROWS_WITH(cage_speed_ratio({41, 41, 15}),
                    "K201.cage_speed_ratio: ball_diameter_mm = 41, must be below pitch_diameter_mm");
  CHECK_THROWS_WITH(stiffness_harmonics({{1, 2, 3, 4}, 2}),
                    "K201.stiffness_harmonics: n_harmonics = 2, must be below half of the 4 samples");
  BandInputs in = fitted(0);
  in.n_min_rpm = 1000;
  CHECK_THROWS_WITH(parametric_speed_bands(in),
                    Catch::StartsWith("K201.parametric_speed_bands: n_min_rpm = 1000, gives a = "));
}
