// The checks of card K105; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/milling/k105_tslot_chip_reinteraction.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k105;

TEST_CASE("K105: shares add up to 1", "[K105]") {
  verstat::test::property([] {
    const auto count = [] { return static_cast<std::int64_t>(*rc::gen::inRange(0, 2000)); };
    const ChipCounts in{count(), count(), count(), count() + 1};
    const ChipShares s = chip_group_shares(in);
    RC_ASSERT(std::abs(s.untouched + s.section + s.lengthwise + s.broken - 1) < 1e-14);
    RC_ASSERT(std::abs(s.reinteraction - (s.section + s.lengthwise + s.broken)) < 1e-14);
  });
  CHECK(chip_group_shares({536, 203, 209, 482}).reinteraction == Approx(0.6252).margin(5e-5));
}

TEST_CASE("K105: arcs add up to a turn, with and without a throat", "[K105]") {
  for (double b = 0; b < 21; b += 1.5) {
    const SlotEngagement e = t_slot_engagement({21, b});
    CHECK(e.throat_idle_deg + e.rear_idle_deg + 2 * e.cut_each_deg == Approx(360));
    CHECK(e.cutting_fraction == Approx(2 * e.cut_each_deg / 360));
  }
  CHECK(t_slot_engagement({21, 0}).cutting_fraction == 0.5);
  CHECK(t_slot_engagement({21, 20.9999999}).cut_each_deg == Approx(0).margin(0.01));
  CHECK(t_slot_engagement({21, 12}).throat_idle_deg == Approx(69.70).margin(0.005));
  CHECK(t_slot_engagement({21, 12}).cutting_fraction == Approx(0.306).margin(0.0005));
}

TEST_CASE("K105: the paper's regimes", "[K105]") {
  CHECK(t_slot_pass({21, 315, 160, 120, 6}).cutting_speed_m_min == Approx(20.8).margin(0.05));
  CHECK(t_slot_pass({21, 255, 160, 120, 6}).cutting_speed_m_min == Approx(16.8).margin(0.05));
  CHECK(t_slot_pass({21, 315, 160, 120, 6}).time_min == Approx(0.75));
  // Every tooth cuts twice per revolution.
  const Pass p = t_slot_pass({21, 200, 100, 50, 7});
  CHECK(p.chips == Approx(2 * 7 * 200 * 0.5));
  CHECK(p.feed_mm_tooth * p.chips / 2 == Approx(50));
}

TEST_CASE("K105: re-cuts are geometric", "[K105]") {
  for (const double q : {0.1, 0.375, 0.9}) {
    double sum = 0;
    double mean = 0;
    for (std::int64_t k = 0; k < 1000; ++k) {
      const double p = chip_recirculation({q, k}).p_exactly_k;
      sum += p;
      mean += static_cast<double>(k) * p;
    }
    CHECK(sum == Approx(1));
    CHECK(mean == Approx(chip_recirculation({q, 0}).mean_recuts));
  }
  CHECK(chip_recirculation({1, 0}).p_exactly_k == 1);
  CHECK(chip_recirculation({1, 3}).p_exactly_k == 0);
  CHECK(chip_recirculation({1, 0}).mean_recuts == 0);
  CHECK(chip_recirculation({0.375, 0}).mean_recuts == Approx(1.67).margin(0.005));
}

TEST_CASE("K105: the pocket holds what Little's law says", "[K105]") {
  // X <- Bin(X + 1, 1 - q) just after every idle arc, by brute force.
  constexpr double q = 0.375;
  std::mt19937 random(1);
  const auto stays = [&random] { return static_cast<double>(random()) / 4294967296.0 >= q; };
  std::int64_t in_pocket = 0;
  double sum = 0;
  constexpr int arcs = 400'000;
  for (int arc = 0; arc < arcs; ++arc) {
    std::int64_t next = 0;
    for (std::int64_t c = 0; c <= in_pocket; ++c) next += stays() ? 1 : 0;
    in_pocket = next;
    sum += static_cast<double>(in_pocket);
  }
  CHECK(sum / arcs == Approx(chip_recirculation({q, 0}).mean_resident_chips).epsilon(0.02));
}

TEST_CASE("K105: the form error scales with force, overhang cubed and stem to the fourth", "[K105]") {
  const FormError base = t_slot_form_error({400, 0, 25, 10, 21, 210000});
  CHECK(t_slot_form_error({400, 0.25, 25, 10, 21, 210000}).side_um == Approx(1.25 * base.side_um));
  CHECK(t_slot_form_error({400, 0, 50, 10, 21, 210000}).side_um == Approx(8 * base.side_um));
  CHECK(t_slot_form_error({400, 0, 25, 20, 21, 210000}).side_um == Approx(base.side_um / 16));
  CHECK(t_slot_form_error({400, 0, 25, 10, 42, 210000}).face_um == Approx(2 * base.face_um));
  // Cantilever: tilt = 3/2 of shift over length.
  CHECK(base.tilt_deg * 3.14159265358979 / 180 == Approx(1.5 * base.side_um / 1000 / 25));
  CHECK(repeated_chip_force({400, 0.25}).total_n == Approx(500));
}

TEST_CASE("K105: bad input names itself", "[K105]") {
  CHECK_THROWS_WITH(chip_group_shares({0, 0, 0, 0}),
                    "K105.chip_group_shares: n1 = 0, at least one of n1 to n4 must be above 0");
  CHECK_THROWS_WITH(chip_dimensions({4}),
                    "K105.chip_dimensions: group = 4, allowed 1 <= group <= 3 (group of chips; "
                    "group 4, broken up, has no sizes)");
  CHECK_THROWS_WITH(t_slot_engagement({21, 21}),
                    Catch::Contains("throat_width = 21, must be below d_cutter"));
}
