#include "models/math/normal_interval.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/property.h"

using namespace verstat::models;

TEST_CASE("a normal interval meets tabulated values, far tails too", "[math]") {
  CHECK(normal_between(-1, 1) == Approx(0.6826894921370859).epsilon(1e-14));
  CHECK(normal_between(-40, -1.959963984540054) == Approx(0.025).epsilon(1e-12));
  CHECK(normal_between(10, 40) == Approx(7.619853024160527e-24).epsilon(1e-12));
  CHECK(normal_between(2, 2) == 0);
}

TEST_CASE("a normal interval and its mirror image have the same probability", "[math]") {
  verstat::test::property([] {
    const double low = *rc::gen::inRange(-8000, 8000) * 1e-3;
    const double high = low + *rc::gen::inRange(1, 5000) * 1e-3;
    const double p = normal_between(low, high);
    RC_ASSERT(p > 0);
    RC_ASSERT(std::abs(p - normal_between(-high, -low)) <= 1e-13 * p + 1e-16);
  });
}
