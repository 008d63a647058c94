#include "operations/kinds/gear_hobbing.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using operations::ChipModel;
using operations::GearHobbing;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("gear hobbing: the chip limits the feed") {
  GalleryExample<GearHobbing> e;
  const auto p = e.plan();
  CHECK(p.feasible());
  CHECK(value_of(p, "chip_thickness_mm") == Approx(0.308).margin(0.0006));
  CHECK(value_of(p, "cutting_depth_mm") == Approx(11.25));
  e.spec.axial_feed_mm_rev = 3;
  const auto fast = e.plan();
  CHECK(fast.main_time_min < p.main_time_min);
  CHECK(limit_of(fast, "chip_thickness_mm").margin() < 0);
  e.spec.hob_gashes = 14;  // more gashes, thinner chips
  CHECK(limit_of(e.plan(), "chip_thickness_mm").margin() > 0);
}

TEST_CASE("gear hobbing: spatial chips of the worked example") {
  GalleryExample<GearHobbing> e;
  e.spec.chip_model = ChipModel::spatial;
  e.spec.angle_step_deg = 3;  // of the card's 1.5: other grids change the numbers by up to 2 %
  const auto p = e.plan();
  CHECK(value_of(p, "chip_thickness_mm") == Approx(0.359).epsilon(0.02));
  CHECK(value_of(p, "chip_volume_per_gap_mm3") == Approx(191.5).epsilon(0.02));
  CHECK(limit_of(p, "chip_thickness_mm").margin() < 0);
  auto estimate = e;
  estimate.spec.chip_model = ChipModel::hoffmeister;
  CHECK(value_of(estimate.plan(), "power_kw") == Approx(value_of(p, "power_kw")).epsilon(0.08));
  e.spec.hob_starts = 2;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("hob_starts") && Catch::Contains("must be 1"));
}

TEST_CASE("gear hobbing: stacking shares the approach, starts divide the time") {
  GalleryExample<GearHobbing> e;
  test::property([&] {
    auto at = e;
    at.spec.gears_per_stack = *rc::gen::inRange(1, 20);
    const double stacked = at.plan().main_time_min;
    ++at.spec.gears_per_stack;
    RC_ASSERT(at.plan().main_time_min < stacked);
    at.spec.gears_per_stack -= 1;
    at.spec.hob_starts = 2;
    RC_ASSERT(std::abs(at.plan().main_time_min / stacked - 0.5) < 1e-12);
  });
  // One gear: travel B + 2 (L + allowance) over feed and blank revolutions.
  e.spec.gears_per_stack = 1;
  const auto p = e.plan();
  const double travel_mm = 40 + 2 * (value_of(p, "approach_length_mm") + 2);
  CHECK(p.main_time_min == Approx(travel_mm / 2 / (value_of(p, "hob_speed_rpm") / 20)));
}
