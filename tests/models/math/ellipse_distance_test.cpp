#include "models/math/ellipse_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/property.h"

using verstat::models::ellipse_distance;

TEST_CASE("ellipse distance: brute force over the whole ellipse", "[math]") {
  verstat::test::property([] {
    const double major = *rc::gen::inRange(1, 1000) * 0.1;
    const double minor = major * *rc::gen::inRange(0, 101) * 0.01;
    const double x = *rc::gen::inRange(-1500, 1500) * 0.1;
    const double y = *rc::gen::inRange(-1500, 1500) * 0.1;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 20000; ++k) {
      const double angle = 2 * std::numbers::pi * k / 20000;
      nearest = std::min(nearest, std::hypot(major * std::cos(angle) - x, minor * std::sin(angle) - y));
    }
    // The polygon is never nearer than the ellipse, and farther by half a step at most.
    const double exact = ellipse_distance(major, minor, x, y);
    RC_ASSERT(exact <= nearest + 1e-9);
    RC_ASSERT(exact >= nearest - major * std::numbers::pi / 20000);
  });
}

TEST_CASE("ellipse distance: axes, points on the curve, circle", "[math]") {
  CHECK(ellipse_distance(5, 3, 7, 0) == Approx(2));
  CHECK(ellipse_distance(5, 3, 0, 1) == Approx(2));
  CHECK(ellipse_distance(5, 3, 0, 0) == Approx(3));
  CHECK(ellipse_distance(4, 4, 3, 4) == Approx(1));
  CHECK(ellipse_distance(5, 0, 3, 2) == Approx(2));
  for (double angle = 0.01; angle < 1.57; angle += 0.1)
    CHECK(ellipse_distance(5, 3, 5 * std::cos(angle), 3 * std::sin(angle)) == Approx(0).margin(1e-12));
}
