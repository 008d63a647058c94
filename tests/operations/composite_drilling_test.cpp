#include "operations/kinds/composite_drilling.h"

#include <cmath>

#include "models/drilling/k404_step_drill_delamination.h"
#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using operations::CompositeDrilling;
using operations::DelaminationCriterion;
using operations::LaminateDrill;
using test::GalleryExample;
using test::limit_of;
using test::value_of;

TEST_CASE("composite drilling: the step drill stays below the critical thrust where the plain one does not") {
  GalleryExample<CompositeDrilling> e;
  const auto step = e.plan();
  CHECK(step.feasible());
  e.spec.drill = LaminateDrill::plain;
  const auto plain = e.plan();
  CHECK_FALSE(plain.feasible());
  CHECK(limit_of(plain, "thrust_first_n").margin() < 0);
  CHECK(plain.scrap_probability > 10 * step.scrap_probability);
  CHECK(value_of(plain, "exit_feed_limit_mm_rev") < value_of(step, "exit_feed_limit_mm_rev"));
}

TEST_CASE("composite drilling: forces are those of the models") {
  GalleryExample<CompositeDrilling> e;
  e.spec.criterion = DelaminationCriterion::printed;
  const auto p = e.plan();
  // G_IC D of the default ply, about the value of the paper: 61.5 N for the first stage, 131.1 N at 0.4.
  namespace k404 = models::k404;
  const double gd = k404::bending_stiffness({14000, 0.5, 0.32}).stiffness_n_mm *
                    k404::energy_release_rate({1.7, 14000, 0.32}).g_ic_n_mm;
  CHECK(value_of(p, "critical_thrust_first_n") == k404::critical_thrust_first_stage({gd, 0.32}).thrust_n);
  CHECK(value_of(p, "critical_thrust_first_n") == Approx(61.5).epsilon(0.05));
  CHECK(value_of(p, "critical_thrust_next_n") == Approx(131.1).epsilon(0.05));
  CHECK(value_of(p, "thrust_first_n") == Approx(90 * 4 * std::pow(0.06, 0.8)));
  CHECK(value_of(p, "first_diameter_mm") == Approx(4));
  e.spec.step_ratio = 0.7;  // beyond the pole of the printed formula, 0.637
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("step_ratio") && Catch::Contains("clamped"));
}

TEST_CASE("composite drilling: at the feed limit thrust meets the allowed thrust") {
  GalleryExample<CompositeDrilling> e;
  const double feed = value_of(e.plan(), "exit_feed_limit_mm_rev");
  e.spec.exit_feed_mm_rev = 0.999 * feed;
  CHECK(limit_of(e.plan(), "exit_feed_mm_rev").margin() > 0);
  e.spec.exit_feed_mm_rev = 1.001 * feed;
  const auto above = e.plan();
  CHECK(limit_of(above, "exit_feed_mm_rev").margin() < 0);
  CHECK(std::min(limit_of(above, "thrust_first_n").margin(), limit_of(above, "thrust_next_n").margin()) < 0);
}

TEST_CASE("composite drilling: no other ratio allows more feed than the best one") {
  const GalleryExample<CompositeDrilling> e;
  namespace k404 = models::k404;
  const double gd = k404::bending_stiffness({14000, 0.5, 0.32}).stiffness_n_mm *
                    k404::energy_release_rate({1.7, 14000, 0.32}).g_ic_n_mm;
  const auto best = k404::best_step_ratio({gd, 0.32, 10, 90, 45, 0.8, 1.2});
  test::property([&] {
    auto at = e;
    at.spec.step_ratio = *rc::gen::inRange(10, 91) / 100.0;
    RC_ASSERT(value_of(at.plan(), "exit_feed_limit_mm_rev") <= best.feed_max_mm_rev * (1 + 1e-6));
  });
}

TEST_CASE("composite drilling: wear raises thrust and scrap; a slow exit costs time") {
  GalleryExample<CompositeDrilling> e;
  const auto sharp = e.plan();
  e.spec.flank_wear_mm = 0.2;
  e.spec.thrust_growth_per_mm = 2;
  const auto worn = e.plan();
  CHECK(value_of(worn, "thrust_next_n") == Approx(1.4 * value_of(sharp, "thrust_next_n")));
  CHECK(worn.scrap_probability > sharp.scrap_probability);
  e.spec.exit_feed_mm_rev.reset();
  const auto fast = e.plan();
  CHECK(fast.main_time_min < worn.main_time_min);
  CHECK(fast.scrap_probability > worn.scrap_probability);
  e.spec.exit_feed_mm_rev = 0.06;
  e.spec.exit_zone_mm = 100;
  CHECK_THROWS_WITH(e.plan(), Catch::Contains("exit_zone_mm"));
}
