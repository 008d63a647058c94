#include "operations/kinds/stone_turning.h"

#include <numbers>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using models::k112::Lathe;
using models::k112::Operation;
using verstat::test::limit_of;
using verstat::test::refusal;
using verstat::test::value_of;

namespace {

StoneTurning example() {
  return test::Gallery("stone_turning").spec<StoneTurning>();
}

double part(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1001) * 1e-3;
}

}  // namespace

TEST_CASE("stone turning: group 5 runs on the 1K62M only, and there at its smallest feed") {
  const test::Gallery gallery("stone_turning");
  const CutPlan p = gallery.file.process.plan(gallery.context());
  CHECK(p.feasible());
  CHECK(value_of(p, "long_feed_low_mm_rev") == 0.07);
  CHECK(value_of(p, "long_feed_high_mm_rev") == 0.07);
  CHECK(value_of(p, "passes") == 2);
  CHECK(p.main_time_min == Approx(2 * 105 / (0.07 * 15)));

  for (const Lathe lathe : {Lathe::k16b05p, Lathe::k16b16a}) {
    StoneTurning t = example();
    t.lathe = lathe;
    const CutPlan other = plan(t, {});
    CHECK(value_of(other, "lathe_eligible") == 0);
    CHECK_FALSE(other.feasible());
    CHECK_FALSE(limit_of(other, "lathe_speed_min_rpm").met());
    CHECK(limit_of(other, "group_speed_max_rpm").met());
  }
}

TEST_CASE("stone turning: the groups' windows by the margins of the plan") {
  struct Row {
    std::int64_t group;
    double rpm_low, rpm_high, feed_low, feed_high;
  };
  for (const Row row : {Row{1, 40, 60, 0.10, 0.13}, Row{2, 40, 60, 0.10, 0.13}, Row{3, 16, 40, 0.07, 0.10},
                        Row{4, 16, 40, 0.07, 0.10}, Row{5, 12.5, 16, 0.03, 0.07}}) {
    StoneTurning t = example();
    t.group = row.group;
    const auto met = [&](double rpm, double feed) {
      t.spindle_speed_rpm = rpm;
      t.feed_mm_rev = feed;
      return plan(t, {}).feasible();
    };
    CHECK(met(row.rpm_low, row.feed_high));
    CHECK(met(row.rpm_high, row.feed_high));
    CHECK_FALSE(met(row.rpm_low * 0.99, row.feed_high));
    CHECK_FALSE(met(row.rpm_high * 1.01, row.feed_high));
    CHECK_FALSE(met(row.rpm_high, row.feed_high * 1.01));
    CHECK_FALSE(met(row.rpm_high, row.feed_low * 0.99));
  }
}

TEST_CASE("stone turning: a part that does not pass over the carriage is refused") {
  StoneTurning t = example();
  t.diameter_mm = 200;
  CHECK(limit_of(plan(t, {}), "lathe_swing_mm").met());
  t.diameter_mm = 201;
  CHECK_FALSE(limit_of(plan(t, {}), "lathe_swing_mm").met());
  CHECK(value_of(plan(t, {}), "lathe_eligible") == 0);
}

TEST_CASE("stone turning: a plunge is judged by the cross feed") {
  StoneTurning t = example();
  t.group = 1;
  t.feed_path = StoneFeed::plunge;
  t.length_mm = 10;
  t.spindle_speed_rpm = 50;
  t.feed_mm_rev = 0.06;
  t.sparkout_revs = 3;
  const CutPlan p = plan(t, {});
  CHECK(p.feasible());
  CHECK(p.main_time_min == Approx(8 / (0.06 * 50) + 3 / 50.0));
  t.feed_mm_rev = 0.10;  // good lengthwise, too much across
  CHECK_FALSE(limit_of(plan(t, {}), "group_feed_max_mm_rev").met());
}

TEST_CASE("stone turning: the wheel's life and its diamond keep the books of volume") {
  const StoneTurning t = example();
  const CutPlan p = plan(t, {});
  // Ring of 120 mm outside and 104 inside, 100 mm long.
  const double stone_mm3 = std::numbers::pi / 4 * (120 * 120 - 104 * 104) * 100;
  CHECK(value_of(p, "stone_volume_mm3") == Approx(stone_mm3));
  const double layer_mm3 = std::numbers::pi / 4 * (150 * 150 - 140 * 140) * 10;
  const double parts = 0.9 * layer_mm3 * 500 / stone_mm3;
  CHECK(value_of(p, "parts_per_wheel") == Approx(parts));
  REQUIRE(p.edge);
  CHECK(p.edge->mean_min == Approx(parts * p.main_time_min));
  REQUIRE(p.consumables.size() == 2);
  CHECK(p.consumables[0].value == Approx(1 / parts));
  CHECK(p.consumables[1].value == Approx(4.4 * layer_mm3 / 1000 / parts));
}

TEST_CASE("stone turning: time falls with feed and speed, climb needs the faster wheel") {
  test::property([] {
    StoneTurning t = example();
    t.feed_mm_rev = part(0.02, 0.2);
    t.spindle_speed_rpm = part(10, 60);
    const CutPlan slow = plan(t, {});
    t.motion = StoneMotion::climb;
    RC_ASSERT(*plan(t, {}).value_of("wheel_speed_m_s") > *slow.value_of("wheel_speed_m_s"));
    t.feed_mm_rev *= 1.1;
    t.spindle_speed_rpm *= 1.1;
    RC_ASSERT(std::abs(plan(t, {}).main_time_min * 1.21 / slow.main_time_min - 1) < 1e-12);
  });
}

TEST_CASE("stone turning: bad specifications are named") {
  StoneTurning t = example();
  t.allowance_per_side_mm = 60;
  CHECK(refusal(t) == "allowance_per_side_mm = 60, must be below half the diameter");
  t = example();
  t.group = 6;
  CHECK(refusal(t).find("group = 6, allowed 1 <= group <= 5") != std::string::npos);
}
