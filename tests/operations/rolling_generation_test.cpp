#include "operations/kinds/rolling_generation.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/operations/gallery.h"
#include "tests/property.h"

using namespace verstat;
using namespace verstat::operations;
using verstat::test::margin_of;
using verstat::test::value_of;

TEST_CASE("rolling generation: the vertex gouges below 90 degrees unless the slip is limited",
          "[rolling_generation]") {
  const auto gallery = test::Gallery("rolling_generation");
  RollingGeneration spec = gallery.spec<RollingGeneration>();
  const CutPlan limited = plan(spec, gallery.context());
  CHECK(value_of(limited, "gouge_mm") == Approx(0).margin(1e-9));
  CHECK(value_of(limited, "mean_slip") < 1);
  CHECK(value_of(limited, "mean_slip") > 0.9);
  CHECK(limited.feasible());
  spec.corner = CornerControl::plain;
  const CutPlan plain = plan(spec, gallery.context());
  CHECK(value_of(plain, "gouge_mm") == Approx(0.779).margin(5e-4));
  CHECK_FALSE(plain.feasible());
}

TEST_CASE("rolling generation: steps trade facets, rotation and feed bound the time",
          "[rolling_generation]") {
  const auto gallery = test::Gallery("rolling_generation");
  RollingGeneration spec = gallery.spec<RollingGeneration>();
  spec.opposite.reset();
  spec.corner = CornerControl::plain;
  // The dome over its middle, where steps equal in z differ in rotation.
  spec.z_start_mm = 15;
  spec.z_end_mm = 45;
  double before_mm = 1;
  for (const std::int64_t steps : {10, 20, 40, 80}) {
    spec.steps = steps;
    const double facet_mm = value_of(plan(spec, {}), "facet_mm");
    // The longest step is an outermost one; on a circle of radius 30 its turn follows from the abscissas.
    const double width = 30.0 / static_cast<double>(steps);
    const auto angle = [](double z) { return std::asin((z - 25.980762113533157) / 30); };
    const double turn = std::max(angle(15 + width) - angle(15), angle(45) - angle(45 - width));
    CHECK(facet_mm == Approx(30 * (1 / std::cos(turn / 2) - 1)).epsilon(1e-6));
    CHECK(facet_mm < before_mm / 3);  // falls with the square of the step
    before_mm = facet_mm;
  }
  const CutPlan rolled = plan(spec, {});
  CHECK(rolled.main_time_min == Approx(120 * value_of(rolled, "stroke_time_min")));
  CHECK(value_of(rolled, "stroke_time_min") >= value_of(rolled, "profile_length_mm") / 200 * (1 - 1e-12));
  spec.max_rotation_rpm = 0.1;  // now the rotary axis is the slowest
  const CutPlan slow = plan(spec, {});
  CHECK(value_of(slow, "stroke_time_min") == Approx(std::abs(value_of(slow, "rotation_deg")) / 360 / 0.1));
  spec.facet_max_mm = before_mm / 2;
  CHECK(margin_of(plan(spec, {}), "facet_mm") < 0);
}

TEST_CASE("rolling generation: slip spreads the wear along the edge", "[rolling_generation]") {
  const auto gallery = test::Gallery("rolling_generation");
  const EdgeLife edge{};
  test::property([&] {
    RollingGeneration spec = gallery.spec<RollingGeneration>();
    spec.opposite.reset();
    spec.corner = CornerControl::plain;
    spec.slip = 0;
    const double sliding = plan(spec, {&edge, nullptr}).edge->mean_min;
    spec.slip = *rc::gen::inRange(1, 101) * 0.01;
    const CutPlan rolled = plan(spec, {&edge, nullptr});
    const double travel = spec.slip * *rolled.value_of("profile_length_mm");
    RC_ASSERT(std::abs(rolled.edge->mean_min / sliding - (1 + travel / 2)) < 1e-9);
  });
}

TEST_CASE("rolling generation: errors and limits name what is wrong", "[rolling_generation]") {
  RollingGeneration spec = test::Gallery("rolling_generation").spec<RollingGeneration>();
  spec.tool_angle_deg = 65;
  spec.z_start_mm = 0;
  spec.opposite.reset();
  CHECK(test::refusal(spec) == "corner = \"limited_slip\" needs the opposite side that limits it");
  spec.corner = CornerControl::plain;
  CHECK(margin_of(plan(spec, {}), "tool_angle_deg") < 0);
  spec.steps = 7;
  CHECK(test::refusal(spec) == "steps = 7, must be even");
}
