// The checks of card K120; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/life/k120_deep_hole_guide_pads.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k120;

TEST_CASE("K120: the sliding path meets the printed 35168 m and 23445 m", "[K120]") {
  CHECK(pad_sliding_path({70, 24, 0.15}).path_m == Approx(35168).epsilon(1e-3));
  CHECK(pad_sliding_path({70, 16, 0.15}).path_m == Approx(23445).epsilon(1e-3));
  CHECK(pad_sliding_path({70, 24, 0.30}).path_m == Approx(pad_sliding_path({70, 24, 0.15}).path_m / 2));
}

TEST_CASE("K120: path and length are inverse, and drilling takes path over speed", "[K120]") {
  verstat::test::property([] {
    const double diameter_mm = *rc::gen::inRange(5, 500);
    const double length_m = *rc::gen::inRange(1, 5000) * 1e-2;
    const double feed = *rc::gen::inRange(1, 100) * 1e-2;
    const double speed = *rc::gen::inRange(5, 200);
    const double path_m = pad_sliding_path({diameter_mm, length_m, feed}).path_m;
    RC_ASSERT(pad_length_from_path({diameter_mm, path_m, feed}).drilled_length_m == Approx(length_m));
    const auto time = deep_drilling_time({diameter_mm, length_m, speed, feed});
    RC_ASSERT(time.time_min == Approx(path_m / speed).epsilon(1e-12));
  });
  CHECK(deep_drilling_time({70, 24, 60, 0.15}).time_min == Approx(586).margin(0.5));
  CHECK(deep_drilling_time({70, 24, 70, 0.15}).time_min == Approx(503).margin(0.5));
}

TEST_CASE("K120: wear is zero up to the shift and grows, and its inverse gives the length back", "[K120]") {
  verstat::test::property([] {
    const double a = *rc::gen::inRange(1, 1000) * 1e-6;
    const double b = *rc::gen::inRange(20, 300) * 1e-2;
    const double c = *rc::gen::inRange(-50, 50) * 1e-4;
    const double shift = *rc::gen::inRange(0, 2000) * 1e-2;
    const double length = *rc::gen::inRange(0, 10000) * 1e-2;
    const double wear = pad_radial_wear({length, a, b, c, shift}).wear_mm;
    RC_ASSERT(length > shift || wear == 0);
    RC_ASSERT(pad_radial_wear({length + 0.5, a, b, c, shift}).wear_mm >= wear);
    if (wear > std::max(0.0, c) + 1e-9)
      RC_ASSERT(pad_length_to_wear({wear, a, b, c, shift}).drilled_length_m == Approx(length).epsilon(1e-6));
  });
  // A step to c just after the shift, not before it.
  CHECK(pad_radial_wear({8, 2e-4, 1.5, 0.003, 8}).wear_mm == 0);
  CHECK(pad_radial_wear({8 + 1e-9, 2e-4, 1.5, 0.003, 8}).wear_mm == Approx(0.003));
}

TEST_CASE("K120: the diameter falls by twice the wear and the lead-in is lost from 0.04 mm", "[K120]") {
  CHECK(pad_wear_effect({0.04}).diameter_loss_mm == Approx(0.08));
  CHECK(pad_wear_effect({0.05}).diameter_loss_mm == Approx(0.1));
  CHECK(pad_wear_effect({0.05}).insert_overhang_increase_mm == 0.05);
  CHECK(pad_wear_effect({0.04}).lead_in_lost);
  CHECK_FALSE(pad_wear_effect({std::nextafter(0.04, 0)}).lead_in_lost);
}

TEST_CASE("K120: the fit reproduces the coefficients of noise-free data", "[K120]") {
  verstat::test::property([] {
    const double a = *rc::gen::inRange(1, 100) * 1e-5;
    const double b = *rc::gen::inRange(30, 350) * 1e-2 + 0.003;
    const double c = *rc::gen::inRange(-20, 50) * 1e-4;
    PadMeasurements data;
    for (const double length : {3.0, 7.0, 12.0, 16.0, 21.0, 24.0, 30.0}) {
      data.length_m.push_back(length);
      data.wear_mm.push_back(a * std::pow(length, b) + c);
    }
    const auto fit = fit_pad_wear(data);
    RC_ASSERT(fit.a_mm_m_b == Approx(a).epsilon(1e-4));
    RC_ASSERT(fit.b == Approx(b).epsilon(1e-4));
    RC_ASSERT(std::abs(fit.c_mm - c) < 1e-7);
    RC_ASSERT(fit.rmse_mm < 1e-7);
    RC_ASSERT(!fit.b_at_limit);
  });
}

TEST_CASE("K120: no power law near the fitted one leaves a smaller error", "[K120]") {
  const PadMeasurements data{{2, 5, 9, 14, 20}, {0.004, 0.009, 0.018, 0.024, 0.041}};
  const auto best = fit_pad_wear(data);
  const auto sse = [&](double a, double b, double c) {
    double sum = 0;
    for (std::size_t k = 0; k < data.length_m.size(); ++k)
      sum += std::pow(a * std::pow(data.length_m[k], b) + c - data.wear_mm[k], 2);
    return sum;
  };
  const double least = sse(best.a_mm_m_b, best.b, best.c_mm);
  CHECK(best.rmse_mm == Approx(std::sqrt(least / 5)));
  for (const double da : {-1e-3, 1e-3})
    for (const double db : {-1e-3, 0.0, 1e-3})
      for (const double dc : {-1e-5, 0.0, 1e-5})
        CHECK(sse(best.a_mm_m_b * (1 + da), best.b + db, best.c_mm + dc) > least);
}

TEST_CASE("K120: a law outside the searched exponents is flagged", "[K120]") {
  PadMeasurements data;
  for (const double length : {1.0, 2.0, 3.0, 4.0}) {
    data.length_m.push_back(length);
    data.wear_mm.push_back(1e-4 * std::pow(length, 6));
  }
  CHECK(fit_pad_wear(data).b_at_limit);
}

TEST_CASE("K120: the state follows the drilled length and agrees with the pad life", "[K120]") {
  verstat::test::property([] {
    const double b = *rc::gen::inRange(80, 250) * 1e-2;
    const double c = *rc::gen::inRange(-20, 20) * 1e-4;
    const double shift = *rc::gen::inRange(0, 1500) * 1e-2;
    const auto state = [&](double length_m) {
      return pad_state(
          {.drilled_length_m = length_m, .a_mm_m_b = 2.5e-4, .b = b, .c_mm = c, .shift_per_point_m = shift});
    };
    const double length = *rc::gen::inRange(0, 20000) * 1e-2;
    const auto now = state(length);
    RC_ASSERT(state(length + 1).points_past_critical >= now.points_past_critical);
    RC_ASSERT(now.wear_at_point_1_mm >= now.wear_at_point_8_mm);
    RC_ASSERT(now.lead_in_first_point == std::min<std::int64_t>(10, now.points_past_critical + 1));
    const double due =
        pad_life({.a_mm_m_b = 2.5e-4, .b = b, .c_mm = c, .shift_per_point_m = shift, .hole_length_m = 1})
            .replace_at_m;
    RC_ASSERT(!state(due * (1 - 1e-9)).replace);
    RC_ASSERT(state(due * (1 + 1e-9) + 1e-9).replace);
  });
  CHECK(pad_state({.drilled_length_m = 0, .a_mm_m_b = 1, .b = 1, .c_mm = 1, .shift_per_point_m = 1})
            .points_past_critical == 0);
}

TEST_CASE("K120: the illustration of the card", "[K120]") {
  const PadSet pads{.a_mm_m_b = 2.5e-4, .b = 1.6, .c_mm = 0, .shift_per_point_m = 8, .hole_length_m = 60};
  CHECK(pad_life(pads).lead_in_shift_starts_m == Approx(25.7).margin(0.05));
  CHECK(pad_life(pads).replace_at_m == Approx(59.7).margin(0.05));
  CHECK(pad_life(pads).holes_per_pad_set == 0);
  // A hole length that divides the life exactly counts in full.
  PadSet whole = pads;
  whole.hole_length_m = pad_life(pads).replace_at_m / 7;
  CHECK(pad_life(whole).holes_per_pad_set == 7);
}

TEST_CASE("K120: bad measurements name themselves", "[K120]") {
  CHECK_THROWS_WITH(fit_pad_wear({{1, 2, 2, 3}, {1, 2, 3, 4}}),
                    "K120.fit_pad_wear: length_m = 2, must increase from entry to entry");
  CHECK_THROWS_WITH(fit_pad_wear({{1, 2, 3, 4}, {0.1, 0.1, 0.1, 0.1}}),
                    "K120.fit_pad_wear: wear_mm = 0.1, must not be the same at every length");
  CHECK_THROWS_WITH(fit_pad_wear({{1, 2, 3, 4, 5}, {1, 2, 3, 4}}),
                    "K120.fit_pad_wear: wear_mm = 4, must have as many entries as length_m");
  CHECK_THROWS_WITH(pad_wear_effect({-0.1}),
                    "K120.pad_wear_effect: wear_mm = -0.1, allowed wear_mm >= 0 (radial wear)");
}
