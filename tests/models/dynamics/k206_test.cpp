// The checks of card K206; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/dynamics/elastic_rod.h"
#include "models/dynamics/k206_spindle_base_frequencies.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k206;

namespace {

// The stand-in geometry calibrated to the published frequencies.
UnitFrequencyInputs unit(double seat_n_um, std::int64_t count) {
  UnitFrequencyInputs in;
  in.spindle_length_mm = {67.8, 12, 35.5, 12, 73.1};
  in.spindle_outer_mm = {14, 20, 35, 20, 10};
  in.spindle_inner_mm = {0, 0, 0, 0, 0};
  in.sleeve_length_mm = {17.3, 12, 35.5, 12, 173.2};
  in.sleeve_outer_mm = {65, 65, 65, 65, 65};
  in.sleeve_inner_mm = {42, 42, 52, 42, 42};
  in.bearing_section = {1, 2, 3, 4};
  in.bearing_k_n_um = {113, 113, 113, 113};
  in.support_section = {1, 4};
  in.support_k_n_um = {seat_n_um, seat_n_um};
  in.count = count;
  return in;
}

RodFrequencyInputs spindle(std::vector<std::int64_t> sections, std::int64_t count) {
  const UnitFrequencyInputs u = unit(1, 1);
  RodFrequencyInputs in;
  in.length_mm = u.spindle_length_mm;
  in.outer_mm = u.spindle_outer_mm;
  in.inner_mm = u.spindle_inner_mm;
  in.support_k_n_um.assign(sections.size(), 113);
  in.support_section = std::move(sections);
  in.count = count;
  return in;
}

InfluenceInputs influence(std::int64_t i, std::int64_t j, double freq_hz) {
  InfluenceInputs in;
  static_cast<SupportedRod&>(in) = spindle({1, 4}, 1);
  in.i = i;
  in.j = j;
  in.freq_hz = freq_hz;
  return in;
}

NoseInputs nose(double freq_hz, double loss) {
  NoseInputs in;
  static_cast<SeatedUnit&>(in) = unit(400, 1);
  in.freq_hz = freq_hz;
  in.loss_factor = loss;
  return in;
}

}  // namespace

TEST_CASE("K206: the published frequencies within 1 %", "[K206]") {
  const auto free = rod_natural_frequencies(spindle({}, 2)).p_hz;
  CHECK(free[0] == Approx(1592).epsilon(0.01));
  CHECK(free[1] == Approx(3929).epsilon(0.01));
  const auto rigid = rod_natural_frequencies(spindle({1, 2, 3, 4}, 2)).p_hz;
  CHECK(rigid[0] == Approx(1279).epsilon(0.01));
  CHECK(rigid[1] == Approx(1841).epsilon(0.01));
  const auto whole = spindle_base_natural_frequencies(unit(400, 2)).p_hz;
  CHECK(whole[0] == Approx(583).epsilon(0.01));
  CHECK(whole[1] == Approx(1296).epsilon(0.01));
}

TEST_CASE("K206: the table of the stand-in geometry", "[K206]") {
  const auto check = [](double k, double p1, double p2, double p3) {
    const auto p = spindle_base_natural_frequencies(unit(k, 3)).p_hz;
    CHECK(p[0] == Approx(p1).margin(0.05));
    CHECK(p[1] == Approx(p2).margin(0.05));
    CHECK(p[2] == Approx(p3).margin(0.05));
  };
  check(0.15, 12.2, 62.0, 1290.2);
  check(10, 99.3, 504.3, 1290.3);
  check(60, 240.8, 1197.6, 1293.6);
  check(120, 336.6, 1288.7, 1584.7);
  check(400, 582.8, 1289.5, 1808.3);
  check(1e6, 1288.6, 1495.2, 1840.5);
}

TEST_CASE("K206: the closest pair is found, 1269.8 and 1307.1 Hz near 70 N/um", "[K206]") {
  double gap = 1e9, lower = 0, upper = 0;
  for (double k = 60; k <= 80; k += 0.5) {
    const auto p = spindle_base_natural_frequencies(unit(k, 3)).p_hz;
    if (p[2] - p[1] < gap) {
      gap = p[2] - p[1];
      lower = p[1];
      upper = p[2];
    }
  }
  CHECK(lower == Approx(1269.8).epsilon(2e-3));
  CHECK(upper == Approx(1307.1).epsilon(2e-3));
}

TEST_CASE("K206: a uniform free bar, in one piece and in several", "[K206]") {
  const double radius = 0.01;
  const double ratio = std::sqrt(210e9 * radius * radius / 4 / 7850) / (2 * std::numbers::pi * 0.25 * 0.25);
  RodFrequencyInputs in;
  in.count = 3;
  for (const std::vector<double>& cuts :
       {std::vector<double>{250}, std::vector<double>{100, 20, 130}, std::vector<double>{1, 249}}) {
    in.length_mm = cuts;
    in.outer_mm.assign(cuts.size(), 20);
    in.inner_mm.assign(cuts.size(), 0);
    const auto p = rod_natural_frequencies(in).p_hz;
    CHECK(p[0] == Approx(4.730040744862704 * 4.730040744862704 * ratio).epsilon(1e-8));
    CHECK(p[1] == Approx(7.853204624095838 * 7.853204624095838 * ratio).epsilon(1e-8));
    CHECK(p[2] == Approx(10.995607838001671 * 10.995607838001671 * ratio).epsilon(1e-8));
  }
}

TEST_CASE("K206: a section whose stiffness is no number any more is refused", "[K206]") {
  RodFrequencyInputs in;
  in.count = 2;
  in.length_mm = {17.3, 173.2};
  in.outer_mm = {65, 1.7e308};
  in.inner_mm = {42, 42};
  CHECK_THROWS_AS(rod_natural_frequencies(in), ModelError);
}

TEST_CASE("K206: frequencies are the sign changes of the determinants", "[K206]") {
  // Delta of the rod alone, from the transfer matrices: an independent route to the same zeros.
  const UnitFrequencyInputs u = unit(1, 1);
  std::vector<RodSegment> rod;
  double length = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    rod.push_back(round_segment(u.spindle_length_mm[k], u.spindle_outer_mm[k], 0, 210, 7850));
    length += rod.back().length_m;
  }
  const auto delta = [&](double f) {
    TransferMatrix<double> a = TransferMatrix<double>::Identity();
    for (const RodSegment& s : rod)
      a = (transfer_matrix<double>(s, 2 * std::numbers::pi * f, length, rod[0].bending_stiffness_n_m2, 1.0) *
           a)
              .eval();
    return a(2, 0) * a(3, 1) - a(3, 0) * a(2, 1);
  };
  const auto p = rod_natural_frequencies(spindle({}, 10)).p_hz;
  REQUIRE(p.size() >= 4);
  std::size_t changes = 0;
  for (double f = 1; f < 19999; f *= 1.002)
    if (delta(f) * delta(std::min(f * 1.002, 20000.0)) < 0) ++changes;
  CHECK(changes == p.size());
  for (const double f : p) CHECK(delta(f * (1 - 1e-7)) * delta(f * (1 + 1e-7)) < 0);
}

TEST_CASE("K206: reciprocity and the static limit", "[K206]") {
  verstat::test::property([] {
    const std::int64_t i = *rc::gen::inRange(0, 6);
    const std::int64_t j = *rc::gen::inRange(0, 6);
    const double f = *rc::gen::inRange(5, 9000);
    const double ij = harmonic_influence(influence(i, j, f)).alpha_um_n;
    const double ji = harmonic_influence(influence(j, i, f)).alpha_um_n;
    RC_ASSERT(std::abs(ij - ji) <= 1e-8 * (std::abs(ij) + std::abs(ji)) + 1e-9);
  });
  CHECK(harmonic_influence(influence(1, 1, 0.01)).alpha_um_n == Approx(1.0 / 113).epsilon(1e-6));
}

TEST_CASE("K206: stiffer is faster, heavier is slower, and scaling laws hold", "[K206]") {
  const auto base = spindle_base_natural_frequencies(unit(50, 3)).p_hz;
  UnitFrequencyInputs in = unit(50, 3);
  in.bearing_k_n_um[2] *= 1.5;
  const auto bearing = spindle_base_natural_frequencies(in).p_hz;
  in = unit(50, 3);
  in.rho_kg_m3 *= 1.1;
  const auto heavy = spindle_base_natural_frequencies(in).p_hz;
  in = unit(50, 3);
  in.e_gpa *= 4;
  for (auto* k : {&in.bearing_k_n_um, &in.support_k_n_um})
    for (double& v : *k) v *= 4;
  const auto stiff = spindle_base_natural_frequencies(in).p_hz;
  in = unit(50, 3);
  for (auto* list : {&in.spindle_length_mm, &in.spindle_outer_mm, &in.spindle_inner_mm, &in.sleeve_length_mm,
                     &in.sleeve_outer_mm, &in.sleeve_inner_mm, &in.bearing_k_n_um, &in.support_k_n_um})
    for (double& v : *list) v *= 2;
  const auto large = spindle_base_natural_frequencies(in).p_hz;
  const auto on_base = rod_natural_frequencies(spindle({1, 2, 3, 4}, 3)).p_hz;
  for (std::size_t n = 0; n < 3; ++n) {
    CHECK(bearing[n] >= base[n] * (1 - 1e-12));
    CHECK(heavy[n] < base[n]);
    CHECK(stiff[n] == Approx(2 * base[n]).epsilon(1e-9));
    CHECK(large[n] == Approx(base[n] / 2).epsilon(1e-9));
    CHECK(base[n] <= on_base[n]);
  }
  const double soft = spindle_base_natural_frequencies(unit(0.15, 1)).p_hz[0];
  const double firm = spindle_base_natural_frequencies(unit(10, 1)).p_hz[0];
  CHECK(firm / soft == Approx(8.15).margin(0.005));
}

TEST_CASE("K206: rigid motions are counted by the springs", "[K206]") {
  const RodSegment s = round_segment(100, 20, 0, 210, 7850);
  const std::vector<RodSegment> rod{s, s, s};
  CHECK(RodSystem(rod, {}).rigid_motions() == 2);
  CHECK(RodSystem(rod, {{1, 1e6}}).rigid_motions() == 1);
  CHECK(RodSystem(rod, {{1, 1e6}, {1, 1e6}}).rigid_motions() == 1);
  CHECK(RodSystem(rod, {{0, 1e6}, {3, 1e6}}).rigid_motions() == 0);
  CHECK(RodSystem(rod, rod, {{1, 1, 1e8}}, {}).rigid_motions() == 3);
  CHECK(RodSystem(rod, rod, {{1, 1, 1e8}}, {{0, 1e6}, {3, 1e6}}).rigid_motions() == 1);
  CHECK(RodSystem(rod, rod, {{1, 1, 1e8}, {2, 2, 1e8}, {3, 3, 1e8}}, {}).rigid_motions() == 2);
  for (const double k : {1e3, 1e6, 1e9}) CHECK(RodSystem(rod, {{1, k}}).count_below(1e-3) == 1);
  CHECK(RodSystem(rod, {}).count_below(0.01) == 2);
}

TEST_CASE("K206: sections need not be as many on both rods, and equal rods count twice", "[K206]") {
  // Two equal free rods on very soft bearings: every bending frequency comes as a near pair.
  const RodSegment s = round_segment(100, 20, 0, 210, 7850);
  const RodSystem twin({s, s}, {s, s, s, s, s}, {{1, 1, 1.0}}, {});
  const RodSystem first({s, s}, {});
  const RodSystem second({s, s, s, s, s}, {});
  for (const double f : {10.0, 1500.0, 3000.0, 9000.0})
    CHECK(twin.count_below(f) == first.count_below(f) + second.count_below(f));
  const RodSystem equal({s, s}, {s, s}, {{1, 1, 1e-3}}, {});
  const auto p = equal.frequencies_hz(4, 10, 20000);
  REQUIRE(p.size() == 4);
  CHECK(p[0] == Approx(p[1]).epsilon(1e-6));
  CHECK(p[2] == Approx(p[3]).epsilon(1e-6));
}

TEST_CASE("K206: the required mount stiffness just meets its target", "[K206]") {
  verstat::test::property([] {
    MountTarget in;
    static_cast<SpindleUnit&>(in) = unit(1, 1);
    in.target_hz = *rc::gen::inRange(20, 900);
    in.mode = *rc::gen::inRange(1, 3);
    in.k_lo_n_um = 0.01;
    in.k_hi_n_um = 1e5;
    const double k = required_mount_stiffness(in).k_n_um;
    const auto mode = static_cast<std::size_t>(in.mode - 1);
    RC_ASSERT(spindle_base_natural_frequencies(unit(k * 1.0001, 2)).p_hz[mode] > in.target_hz);
    RC_ASSERT(spindle_base_natural_frequencies(unit(k * 0.9999, 2)).p_hz[mode] < in.target_hz);
  });
}

TEST_CASE("K206: damping takes energy out, and the compliance peaks at the first frequency", "[K206]") {
  const double p1 = spindle_base_natural_frequencies(unit(400, 1)).p_hz[0];
  for (const double f : {50.0, 300.0, p1, 900.0, 2500.0}) CHECK(nose_compliance(nose(f, 0.03)).im_um_n < 0);
  CHECK(nose_compliance(nose(p1, 0.03)).abs_um_n > nose_compliance(nose(0.9 * p1, 0.03)).abs_um_n);
  CHECK(nose_compliance(nose(p1, 0.03)).abs_um_n > nose_compliance(nose(1.1 * p1, 0.03)).abs_um_n);
  // Without damping the compliance changes sign through a pole at the natural frequency of the whole.
  CHECK(nose_compliance(nose(p1 * (1 - 1e-6), 0)).re_um_n > 100);
  CHECK(nose_compliance(nose(p1 * (1 + 1e-6), 0)).re_um_n < -100);
}

TEST_CASE("K206: bands are cut, dropped and joined", "[K206]") {
  const SpeedBands touching = resonance_speed_bands({{100, 150}, {1}, 0.2, 0, 1e6});
  REQUIRE(touching.n_lo_rpm.size() == 1);
  CHECK(touching.n_lo_rpm[0] == Approx(4800));
  CHECK(touching.n_hi_rpm[0] == Approx(10800));
  CHECK(resonance_speed_bands({{100}, {1}, 0.2, 8000, 9000}).n_lo_rpm.empty());
}

TEST_CASE("K206: bad input names itself", "[K206]") {
  UnitFrequencyInputs in = unit(1, 1);
  in.bearing_section[3] = 6;
  CHECK_THROWS_WITH(spindle_base_natural_frequencies(in),
                    "K206.spindle_base_natural_frequencies: bearing_section/3 = 6, must be a section 0..5");
  in = unit(1, 1);
  in.sleeve_inner_mm[2] = 65;
  CHECK_THROWS_WITH(
      spindle_base_natural_frequencies(in),
      "K206.spindle_base_natural_frequencies: sleeve_inner_mm/2 = 65, must be below the outer diameter");
  CHECK_THROWS_WITH(
      chatter_limit_width({2000, 0.01, 1}),
      Catch::StartsWith("K206.chatter_limit_width: min_re_um_n = 0.01, allowed min_re_um_n < 0"));
  CHECK_THROWS_WITH(harmonic_influence(influence(0, 0, 1e6)),
                    Catch::Contains("too high for transfer matrices"));
}
