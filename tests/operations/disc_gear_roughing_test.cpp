#include "operations/kinds/disc_gear_roughing.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using operations::DiscGearRoughing;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("disc gear roughing: a pair of cutters against one") {
  GalleryExample<DiscGearRoughing> e;
  const auto pair = e.plan();
  CHECK(pair.feasible());
  e.spec.cutters = 1;
  const auto one = e.plan();
  CHECK(value_of(pair, "strokes") == 21);  // of 41 gaps: whole strokes
  CHECK(value_of(one, "strokes") == 41);
  CHECK(value_of(one, "feed_mm_min") == 120);
  CHECK(value_of(pair, "feed_mm_min") == Approx(96));
  CHECK(value_of(pair, "gap_working_min") == Approx(value_of(one, "gap_working_min") / 0.8));
  CHECK(pair.main_time_min < one.main_time_min);
  CHECK(pair.main_time_min > one.main_time_min / 2);
  // Published forces of module 10 at 110 rpm: 1816 N mean, 3654 N peak, 2.85 kW; pair 3072 N mean, 4777 N
  // peak.
  CHECK(value_of(one, "mean_force_n") == Approx(1816).margin(1));
  CHECK(value_of(one, "peak_force_n") == Approx(3654).margin(1));
  CHECK(value_of(one, "power_kw") == Approx(2.85).margin(0.006));
  CHECK(value_of(pair, "mean_force_n") == Approx(3072).margin(1));
  CHECK(value_of(pair, "peak_force_n") == Approx(4777).margin(5));
  e.spec.cutters = 2;
  e.spec.second_cutter_offset_deg = 0;  // in phase: 6181 N, above the 6000 N allowed
  CHECK(limit_of(e.plan(), "peak_force_n").margin() < 0);
}

TEST_CASE("disc gear roughing: insert consumption by coolant and coating") {
  GalleryExample<DiscGearRoughing> e;
  const auto wet = e.plan();
  CHECK(value_of(wet, "insert_life_min") == Approx(330));
  const double working_min = value_of(wet, "strokes") * value_of(wet, "gap_working_min");
  CHECK(wet.consumables.at(0).value == Approx(working_min / 330 * 60 / 4));
  // The element wears with main time: as many parts as the cutting life holds.
  REQUIRE(wet.edge.has_value());
  CHECK(wet.edge->mean_min / wet.main_time_min == Approx(330 / working_min));
  e.spec.coolant = false;
  const auto dry = e.plan();
  CHECK(value_of(dry, "insert_life_min") == Approx(180));
  CHECK(dry.consumables.at(0).value > wet.consumables.at(0).value);
  e.spec.coated = true;
  CHECK(e.plan().consumables.at(0).value < dry.consumables.at(0).value);
}

TEST_CASE("disc gear roughing: outside the published regimes the regime must be given") {
  GalleryExample<DiscGearRoughing> e;
  e.spec.module_mm = 16;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("module_mm"));
  e.spec.rpm = 80;
  e.spec.feed_mm_min = 90;
  CHECK_THROWS(e.plan());
  e.spec.life_speed_ref_m_min = 80;
  CHECK_NOTHROW(e.plan());
  e.spec.mc.reset();
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("mc") && Catch::Contains("together"));
}

TEST_CASE("disc gear roughing: speed shortens life by the Taylor law") {
  const GalleryExample<DiscGearRoughing> e;
  const double life = value_of(e.plan(), "insert_life_min");
  test::property([&] {
    auto at = e;
    at.spec.kc11_mpa.reset();
    at.spec.mc.reset();
    at.spec.peak_force_max_n.reset();
    const double factor = *rc::gen::inRange(50, 200) / 100.0;
    at.spec.rpm = 110 * factor;
    RC_ASSERT(std::abs(value_of(at.plan(), "insert_life_min") * std::pow(factor, 4) / life - 1) < 1e-9);
  });
}
