// The checks of card K112; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/grinding/k112_stone_turning.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k112;

namespace {
constexpr Lathe lathes[] = {Lathe::k1k62m, Lathe::k16b05p, Lathe::k16b16a};
}  // namespace

TEST_CASE("K112: the cross feed is half of the longitudinal feed in every row", "[K112]") {
  for (int group = 1; group <= 5; ++group)
    for (const auto operation : {Operation::rough, Operation::finish}) {
      const auto r = stone_turning_regime({group, operation});
      CHECK(r.cross_feed_min_mm_rev == Approx(r.long_feed_min_mm_rev / 2));
      CHECK(r.cross_feed_max_mm_rev == Approx(r.long_feed_max_mm_rev / 2));
    }
  for (const Lathe machine : lathes) {
    const auto m = machine_characteristics({machine});
    CHECK(m.cross_feed_min_mm_rev == Approx(m.long_feed_min_mm_rev / 2));
    CHECK(m.cross_feed_max_mm_rev == Approx(m.long_feed_max_mm_rev / 2));
    CHECK(m.swing_carriage_mm < m.swing_bed_mm);
  }
}

TEST_CASE("K112: feed rates and pass times of the groups", "[K112]") {
  const auto rate = [](std::int64_t group, bool fast) {
    const auto r = stone_turning_regime({group, Operation::rough});
    return fast ? r.rpm_max * r.long_feed_max_mm_rev : r.rpm_min * r.long_feed_min_mm_rev;
  };
  CHECK(rate(1, false) == Approx(4.0));
  CHECK(rate(2, true) == Approx(7.8));
  CHECK(rate(3, false) == Approx(1.12));
  CHECK(rate(4, true) == Approx(4.0));
  CHECK(rate(5, false) == Approx(0.375));
  CHECK(rate(5, true) == Approx(1.12));
  CHECK(stone_turning_time({100, 0, 1, 1, 0.10, 40}).time_per_pass_min == Approx(25));
  CHECK(stone_turning_time({100, 0, 1, 1, 0.03, 12.5}).time_per_pass_min == Approx(267).margin(0.5));
}

TEST_CASE("K112: speeds of work and wheel", "[K112]") {
  const auto work = [](double rpm) {
    return stone_turning_kinematics({150, rpm, 150, 10, 1}).work_speed_m_min;
  };
  CHECK(work(40) == Approx(18.8).margin(0.05));
  CHECK(work(60) == Approx(28.3).margin(0.05));
  CHECK(work(16) == Approx(7.5).margin(0.05));
  CHECK(work(12.5) == Approx(5.9).margin(0.05));
  // A work that hardly turns leaves the relative speed to the wheel.
  const auto wheel = [](double diameter_mm, double speed_m_s) {
    return stone_turning_kinematics({150, 1e-9, diameter_mm, speed_m_s, 1}).wheel_rpm;
  };
  CHECK(wheel(150, 5) == Approx(637).margin(0.5));
  CHECK(wheel(150, 15) == Approx(1910).margin(0.5));
  CHECK(wheel(350, 5) == Approx(273).margin(0.5));
  CHECK(wheel(350, 15) == Approx(819).margin(0.5));
  // Opposed motion needs the work speed less, climb the work speed more.
  const auto opposed = stone_turning_kinematics({150, 60, 150, 15, 1});
  const auto climb = stone_turning_kinematics({150, 60, 150, 15, 0});
  CHECK(opposed.wheel_speed_m_s + opposed.work_speed_m_min / 60 == Approx(15));
  CHECK(climb.wheel_speed_m_s - climb.work_speed_m_min / 60 == Approx(15));
}

TEST_CASE("K112: only the 1K62M runs group 5, and only at its lowest feed", "[K112]") {
  for (const Lathe machine : lathes)
    CHECK((stone_machine_fit({machine, 5, Operation::rough, 100}).feasible == 1) ==
          (machine == Lathe::k1k62m));
  const auto only = stone_machine_fit({Lathe::k1k62m, 5, Operation::rough, 100});
  CHECK(only.long_feed_low_mm_rev == 0.07);
  CHECK(only.long_feed_high_mm_rev == 0.07);
  for (const std::int64_t group : {3, 4}) {
    const auto small = stone_machine_fit({Lathe::k16b05p, group, Operation::rough, 100});
    CHECK(small.rpm_low == 30);
    CHECK(small.rpm_high == 40);
    const auto middle = stone_machine_fit({Lathe::k16b16a, group, Operation::rough, 100});
    CHECK(middle.rpm_low == 20);
    CHECK(middle.rpm_high == 40);
  }
  const auto never = stone_machine_fit({Lathe::k16b16a, 5, Operation::rough, 100});
  CHECK_FALSE(never.rpm_low.has_value());
  CHECK_FALSE(never.rpm_high.has_value());
  CHECK(stone_machine_fit({Lathe::k16b05p, 1, Operation::finish, 145}).size_ok == 1);
  CHECK(stone_machine_fit({Lathe::k16b05p, 1, Operation::finish, 145.1}).feasible == 0);
}

TEST_CASE("K112: finishing keeps the speeds of roughing", "[K112]") {
  for (int group = 1; group <= 5; ++group) {
    const auto rough = stone_turning_regime({group, Operation::rough});
    const auto finish = stone_turning_regime({group, Operation::finish});
    CHECK(finish.rpm_min == rough.rpm_min);
    CHECK(finish.rpm_max == rough.rpm_max);
    CHECK(finish.long_feed_max_mm_rev == 0.10);
  }
}

TEST_CASE("K112: passes are the least whole number that covers the allowance", "[K112]") {
  verstat::test::property([] {
    const double depth = *rc::gen::inRange(1, 500) * 1e-2;
    const double allowance = *rc::gen::inRange(0, 3000) * 1e-2;
    const auto time = stone_turning_time({100, 10, allowance, depth, 0.1, 50});
    const auto passes = static_cast<double>(time.passes);
    RC_ASSERT(passes * depth >= allowance * (1 - 1e-8) - 1e-8);
    RC_ASSERT((passes - 1) * depth < allowance || time.passes == 0);
    RC_ASSERT(time.main_time_min == Approx(passes * 110 / 5));
  });
  CHECK(stone_turning_time({100, 10, 0, 5, 0.1, 50}).passes == 0);
  CHECK(stone_turning_time({100, 10, 0.3, 0.1, 0.1, 50}).passes == 3);  // 0.3/0.1 is above 3 by rounding
  CHECK(stone_turning_time({100, 10, 5.001, 5, 0.1, 50}).passes == 2);
}

TEST_CASE("K112: removal rate is the volume of the ring over the time of the pass", "[K112]") {
  const double ring = std::numbers::pi / 4 * (150.0 * 150 - 140.0 * 140) * 80;
  const double minutes = stone_turning_time({80, 0, 5, 5, 0.13, 60}).main_time_min;
  CHECK(stone_removal_rate({150, 5, 0.13, 60}).removal_rate_mm3_min == Approx(ring / minutes));
  CHECK(stone_removal_rate({150, 1e-6, 0.13, 60}).removal_rate_mm3_min ==
        Approx(std::numbers::pi * 150 * 1e-6 * 0.13 * 60).epsilon(1e-6));
}

TEST_CASE("K112: a wheel of solid layer holds its whole volume, and carats follow the definition", "[K112]") {
  const auto solid = diamond_wheel_life({100, 10, 50, 50, 1, 1, 1});
  CHECK(solid.layer_volume_mm3 == Approx(std::numbers::pi / 4 * 100 * 100 * 10));
  CHECK(solid.diamond_carat == Approx(2.2 * solid.layer_volume_mm3 / 1000));
  CHECK(solid.parts_per_wheel == Approx(solid.layer_volume_mm3));
  CHECK(stone_plunge_time({3, 0.05, 50, 0}).main_time_min == Approx(1.2));
  CHECK(stone_plunge_time({0, 0.05, 50, 25}).main_time_min == Approx(0.5));
}

TEST_CASE("K112: bad input names itself", "[K112]") {
  CHECK_THROWS_WITH(stone_turning_kinematics({150, 600, 150, 1, 1}),
                    "K112.stone_turning_kinematics: relative_speed_m_s = 1, must be above the work speed in "
                    "opposed motion");
  CHECK_THROWS_WITH(stone_removal_rate({10, 5.1, 0.1, 50}),
                    "K112.stone_removal_rate: depth_mm = 5.1, must not be above half of work_diameter_mm");
  CHECK_THROWS_WITH(diamond_wheel_life({10, 5, 5.1, 100, 0.5, 100, 100}),
                    "K112.diamond_wheel_life: layer_depth_mm = 5.1, must not be above half of "
                    "wheel_diameter_mm");
}
