// Lapping: time grows as the lap wears; resetting it has a best interval.

#include "operations/kinds/lapping.h"

#include "models/surface/k311_lapping_cycle.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

namespace verstat::operations {
namespace {

using test::limit_of;

Lapping example() {
  return test::Gallery("lapping").spec<Lapping>();
}

TEST_CASE("lapping: the example is feasible and survives JSON") {
  CHECK(plan(example(), {}).feasible());
}

TEST_CASE("lapping: two stages by Preston's law") {
  const CutPlan p = plan(example(), {});
  // 0.5 um/(MPa m) x 6 N/20 mm2 x 30 m/min, and a third of it; switch at 2 + 4 - 0.8 - 1.
  CHECK(*p.value_of("forced_rate_um_min") == Approx(4.5));
  CHECK(*p.value_of("finish_rate_um_min") == Approx(1.5));
  CHECK(*p.value_of("switch_allowance_um") == Approx(4.2));
  CHECK(*p.value_of("first_part_min") == Approx(15.8 / 4.5 + 4.2 / 1.5));
  CHECK(*p.value_of("roughness_max_um") == Approx(6 * *p.value_of("roughness_ra_um")));
}

TEST_CASE("lapping: time grows to 1.38 at the end of the lap life") {
  Lapping s = example();
  s.reset_interval_parts = 40;
  const CutPlan p = plan(s, {});
  CHECK(*p.value_of("last_part_min") == Approx(1.38 * *p.value_of("first_part_min")));
  CHECK(p.main_time_min == Approx(1.19 * *p.value_of("first_part_min")));
  double sum_min = 0;
  for (std::int64_t part = 1; part <= 40; ++part)
    sum_min +=
        models::k311::cycle_time_with_lap_wear({part, *p.value_of("first_part_min"), 40, 1.38}).time_min;
  CHECK(p.main_time_min == Approx(sum_min / 40));
  REQUIRE(p.time_law);
  CHECK(mean_min(*p.time_law) == Approx(p.main_time_min));
  REQUIRE(p.more_elements.size() == 1);
  CHECK(p.more_elements[0].mean_min == Approx(sum_min));

  s.reset_interval_parts = 1;
  const CutPlan every = plan(s, {});
  CHECK_FALSE(every.time_law);
  CHECK(every.main_time_min == *every.value_of("first_part_min"));
}

TEST_CASE("lapping: the best reset interval, against every other") {
  Lapping s = example();
  const CutPlan best = plan(s, {});
  const double n = *best.value_of("reset_interval_parts");
  CHECK(n > 1);
  CHECK(n < 40);
  for (std::int64_t k = 1; k <= 40; ++k) {
    s.reset_interval_parts = k;
    CHECK(*plan(s, {}).value_of("piece_time_min") >= *best.value_of("piece_time_min") - 1e-12);
  }
  // The card: t1 10 min, growth 0.38/39, preparation 2, reset 15: 18 parts, 13.66 min.
  s = example();
  s.preston_um_mpa_m *= *best.value_of("first_part_min") / 10;
  const CutPlan card = plan(s, {});
  CHECK(*card.value_of("first_part_min") == Approx(10));
  CHECK(*card.value_of("reset_interval_parts") == 18);
  CHECK(*card.value_of("piece_time_min") == Approx(13.66).margin(0.005));
  CHECK(*card.value_of("piece_time_min") ==
        Approx(card.main_time_min + 2 + 15 / *card.value_of("reset_interval_parts")));
  // A dearer reset waits longer.
  s.reset_min = 40;
  CHECK(*plan(s, {}).value_of("reset_interval_parts") > 18);
}

TEST_CASE("lapping: limits change sign where they should") {
  Lapping s = example();
  s.allowance_um = 9.2 + 1e-6;  // 3 + 8 - 0.8 - 1
  CHECK(limit_of(plan(s, {}), "allowance_um").met());
  s.allowance_um = 9.2 - 1e-6;
  CHECK_FALSE(limit_of(plan(s, {}), "allowance_um").met());
  s = example();
  s.forced_force_n = 8.01;
  CHECK_FALSE(limit_of(plan(s, {}), "force_n").met());
  s = example();
  s.allowance_um = 26;
  CHECK_FALSE(limit_of(plan(s, {}), "web_um").met());  // 70 - 26 < 45
}

TEST_CASE("lapping: bad specifications name the place") {
  Lapping s = example();
  s.reset_interval_parts = 41;
  CHECK(test::refusal(s) == "reset_interval_parts = 41, must not be above parts_per_lap_life");
  s = example();
  s.finish_force_n = 7;
  CHECK(test::refusal(s) == "finish_force_n = 7, must not be above forced_force_n");
  s = example();
  s.grains.reset();
  CHECK(test::refusal(s) == "roughness_ra_max_um = 0.04, needs grains, from which Ra follows");
  nlohmann::json json = test::Gallery("lapping").json.at("process");
  json["grains"]["spacing_um"] = 0;
  CHECK(test::refusal(json).find("grains/spacing_um = 0") != std::string::npos);
}

TEST_CASE("lapping: harder pressing never takes longer") {
  test::property("force", [] {
    Lapping s = example();
    s.grains.reset();
    s.roughness_ra_max_um.reset();
    s.reset_interval_parts = *rc::gen::inRange(1, 41);
    const CutPlan gentle = plan(s, {});
    s.forced_force_n += *rc::gen::inRange(1, 5);
    const CutPlan hard = plan(s, {});
    RC_ASSERT(hard.main_time_min < gentle.main_time_min);
    RC_ASSERT(*hard.value_of("last_part_min") >= *hard.value_of("first_part_min"));
  });
}

}  // namespace
}  // namespace verstat::operations
