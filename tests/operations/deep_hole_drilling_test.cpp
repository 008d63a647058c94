#include "operations/kinds/deep_hole_drilling.h"

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using operations::DeepHoleDrilling;
using operations::PadCriterion;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("deep-hole drilling: pads live in metres, inserts in minutes") {
  GalleryExample<DeepHoleDrilling> e;
  const auto p = e.plan();
  CHECK(p.feasible());
  // The illustration of the card: first jump at 25.7 m, replacement at 59.7 m.
  CHECK(value_of(p, "lead_in_shift_starts_m") == Approx(25.7).margin(0.05));
  CHECK(value_of(p, "pad_life_m") == Approx(59.7).margin(0.05));
  REQUIRE(p.more_elements.size() == 1);
  REQUIRE(p.edge.has_value());
  const double holes = p.more_elements[0].mean_min / p.main_time_min;
  CHECK(holes == Approx(59.7 / 2).epsilon(0.001));
  CHECK(p.consumables.at(0).value == Approx(1 / holes));

  // Twice the speed: half the time of a hole and far fewer holes of an edge, but as many holes of the pads.
  e.spec.cutting_speed_m_min *= 2;
  const auto fast = e.plan();
  CHECK(fast.main_time_min == Approx(p.main_time_min / 2));
  CHECK(fast.more_elements[0].mean_min / fast.main_time_min == Approx(holes));
  CHECK(fast.edge->mean_min / fast.main_time_min < 0.2 * p.edge->mean_min / p.main_time_min);
}

TEST_CASE("deep-hole drilling: the run of the paper") {
  GalleryExample<DeepHoleDrilling> e;
  e.spec.hole_length_mm = 24'000;
  e.spec.approach_mm = 0;
  const auto p = e.plan();
  CHECK(value_of(p, "pad_sliding_path_m") == Approx(35168).epsilon(0.001));
  CHECK(p.main_time_min == Approx(586).margin(1));
  e.spec.cutting_speed_m_min = 70;
  CHECK(e.plan().main_time_min == Approx(503).margin(1));
}

TEST_CASE("deep-hole drilling: criterion and limits") {
  GalleryExample<DeepHoleDrilling> e;
  const auto tail = e.plan();
  e.spec.pad_criterion = PadCriterion::lead_in_lost;
  const auto lead_in = e.plan();
  CHECK(value_of(lead_in, "pad_life_m") < value_of(tail, "pad_life_m"));
  CHECK(value_of(lead_in, "diameter_loss_mm") == Approx(2 * 0.045));
  e.spec.diameter_loss_max_mm = 0.089;
  CHECK(limit_of(e.plan(), "diameter_loss_mm").margin() < 0);
  e.spec.diameter_loss_max_mm = 0.091;
  CHECK(limit_of(e.plan(), "diameter_loss_mm").margin() > 0);
  e.spec.hole_length_mm = 30'000;  // longer than the lead-in lasts
  CHECK(limit_of(e.plan(), "holes_per_pad_set").margin() < 0);
  e.spec.pad_wear_c_mm = 0.05;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("pad_wear_c_mm"));
}

TEST_CASE("deep-hole drilling: the feed does not change the metres of the pads") {
  const GalleryExample<DeepHoleDrilling> e;
  test::property([&] {
    auto at = e;
    at.spec.feed_mm_rev = *rc::gen::inRange(5, 60) / 100.0;
    const auto p = at.plan();
    RC_ASSERT(value_of(p, "pad_life_m") == value_of(e.plan(), "pad_life_m"));
    // Power and main time trade against each other at a constant specific force.
    RC_ASSERT(std::abs(value_of(p, "power_kw") * p.main_time_min /
                           (value_of(e.plan(), "power_kw") * e.plan().main_time_min) -
                       1) < 1e-9);
  });
}
