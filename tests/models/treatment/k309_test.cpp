// The checks of card K309; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/treatment/k309_grain_trajectory.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k309;
using verstat::test::property;

namespace {

double ratio(int low, int high) {
  return *rc::gen::inRange(low, high) * 0.01;
}

}  // namespace

TEST_CASE("K309: a grain stays on the cylinder and closes a turn one pitch on", "[K309]") {
  property([] {
    const double radius = ratio(100, 5000), speed = ratio(100, 30000), feed = ratio(100, 300000);
    const double time = ratio(0, 1000);
    const auto grain = static_cast<std::int64_t>(*rc::gen::inRange(0, 50));
    const auto at = [&](double t, std::int64_t direction) {
      return grain_position({{t, radius, speed, grain, 0.2, direction}, feed});
    };
    const ScratchPattern pattern = scratch_pattern({radius, speed, feed});
    const Position now = at(time, 1);
    const Position turn_later = at(time + 60 / pattern.speed_rpm, 1);
    RC_ASSERT(std::abs(std::hypot(now.y_mm, now.z_mm) - radius) < 1e-9);
    RC_ASSERT(std::abs(turn_later.y_mm - now.y_mm) < 1e-6);
    RC_ASSERT(std::abs(turn_later.z_mm - now.z_mm) < 1e-6);
    RC_ASSERT(std::abs(turn_later.x_mm - now.x_mm - pattern.pitch_mm) < 1e-6);
    const Position mirrored = at(time, -1);
    RC_ASSERT(mirrored.x_mm == now.x_mm && mirrored.y_mm == now.y_mm && mirrored.z_mm == -now.z_mm);
    // The scratch of one turn is the hypotenuse of circumference and pitch.
    const double turn = scratch_length({60 / pattern.speed_rpm, speed, feed}).length_mm;
    RC_ASSERT(std::abs(turn - std::hypot(2 * std::numbers::pi * radius, pattern.pitch_mm)) < 1e-9 * turn);
    RC_ASSERT(std::abs(pattern.crossing_angle_deg - 2 * pattern.lay_angle_deg) < 1e-12);
  });
}

TEST_CASE("K309: 2000 rpm on the sleeve and in its bore", "[K309]") {
  CHECK(scratch_pattern({13.5, 169.6, 300}).speed_rpm == Approx(2000).margin(1));
  CHECK(scratch_pattern({6.5, 81.7, 300}).speed_rpm == Approx(2000).margin(1));
}

TEST_CASE("K309: an oscillating grain moves at the axial speed its frequency came from", "[K309]") {
  property([] {
    const double speed_mm_min = ratio(1000, 100000), amplitude = ratio(10, 500);
    const double f = oscillation_frequency({speed_mm_min, amplitude}).frequency_hz;
    CHECK(oscillation_frequency({speed_mm_min, amplitude, AmplitudeConvention::printed}).frequency_hz ==
          Approx(4 * f));
    CHECK(oscillation_frequency({speed_mm_min, amplitude, AmplitudeConvention::stroke}).frequency_hz ==
          Approx(2 * f));
    const auto x = [&](double t) {
      return oscillating_grain_position({{t, 13.5, 100, 0, 0.2, 1}, 0, amplitude, f, 0}).x_mm;
    };
    const double quarter_s = 0.25 / f;
    RC_ASSERT(std::abs(x(0)) < 1e-12);
    RC_ASSERT(std::abs(x(quarter_s) - amplitude) < 1e-9);
    RC_ASSERT(std::abs(x(3 * quarter_s) + amplitude) < 1e-9);
    RC_ASSERT(std::abs(x(quarter_s / 2) / (quarter_s / 2) - speed_mm_min / 60) < 1e-6);
    // Without oscillation it is the plain helix.
    const Position plain = grain_position({{1.3, 13.5, 100, 3, 0.2, -1}, 250});
    const Position still = oscillating_grain_position({{1.3, 13.5, 100, 3, 0.2, -1}, 250, 0, f, 0.3});
    RC_ASSERT(plain.x_mm == still.x_mm && plain.y_mm == still.y_mm && plain.z_mm == still.z_mm);
  });
}

TEST_CASE("K309: more grains never widen the gap, and it never falls below an even share", "[K309]") {
  property([] {
    const double pitch = ratio(5, 300), spacing = ratio(0, 300);
    CHECK(track_max_gap({1, spacing, pitch, 0}).gap_mm == Approx(pitch));
    double last = pitch;
    for (std::int64_t grains = 1; grains <= 40; ++grains) {
      const double gap = track_max_gap({grains, spacing, pitch, 0}).gap_mm;
      RC_ASSERT(gap <= last + 1e-12);
      RC_ASSERT(gap >= pitch / static_cast<double>(grains) - 1e-12);
      RC_ASSERT(track_max_gap({grains, spacing, pitch, gap}).covered);
      last = gap;
    }
  });
}

TEST_CASE("K309: roughness falls from the first to the last value", "[K309]") {
  CHECK(roughness_after_mao({0, 0.25, 0.065, 1}).ra_um == 0.25);
  CHECK(roughness_after_mao({100, 0.25, 0.065, 1}).ra_um == Approx(0.065).epsilon(1e-14));
  CHECK(roughness_after_mao({1, 0.25, 0.065, 1}).ra_um > roughness_after_mao({2, 0.25, 0.065, 1}).ra_um);
}

TEST_CASE("K309: the window includes its limits", "[K309]") {
  CHECK(mao_result({50, 0.9, 1.35, 1800}).in_window);
  CHECK(mao_result({300, 1.1, 1.65, 2200}).in_window);
  CHECK_FALSE(mao_result({300, 1.1001, 1.65, 2200}).in_window);
  CHECK_FALSE(mao_result({49.9, 1, 1.5, 2000}).in_window);
  CHECK_FALSE(mao_result({150, 1, 1.66, 2000}).in_window);
  CHECK_FALSE(mao_result({150, 1, 1.5, 1799}).in_window);
}

TEST_CASE("K309: bad input names itself", "[K309]") {
  CHECK_THROWS_WITH(grain_position({{0.1, 13.5, 100, 0, 0.2, 0}, 300}),
                    "K309.grain_position: direction = 0, must be 1 or -1");
  CHECK_THROWS_WITH(mao_pass_time({17, 10, 0.2, 0, 4}),
                    "K309.mao_pass_time: V_S = 0, allowed V_S > 0 (axial feed speed)");
}
