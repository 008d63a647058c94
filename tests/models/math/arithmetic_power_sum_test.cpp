#include "models/math/arithmetic_power_sum.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/property.h"

using verstat::models::arithmetic_power_sum;

TEST_CASE("power sum: equals the plain sum for any exponent and length", "[math]") {
  verstat::test::property([] {
    const double u = *rc::gen::inRange(1, 100000) * 1e-4;
    const double step = *rc::gen::inRange(0, 3000) * 1e-3;
    const int terms = *rc::gen::inRange(0, 3000);
    const double p = *rc::gen::inRange(-9, 60) * 0.1;
    double plain = 0;
    for (int i = 0; i < terms; ++i)
      if (const double t = u - i * step; t > 0) plain += std::pow(t, p);
    // Whether a term that should be zero survives as 1e-17 is rounding, and its small power is not small.
    RC_PRE(step == 0 || std::abs(u / step - std::round(u / step)) > 1e-6);
    RC_ASSERT(std::abs(arithmetic_power_sum(u, step, terms, p) - plain) <= 1e-11 * plain + 1e-12);
  });
}

TEST_CASE("power sum: whole numbers have closed forms", "[math]") {
  CHECK(arithmetic_power_sum(100, 1, 100, 1) == Approx(5050).epsilon(1e-15));
  CHECK(arithmetic_power_sum(1000, 1, 1000, 2) == Approx(1000.0 * 1001 * 2001 / 6).epsilon(1e-14));
  CHECK(arithmetic_power_sum(2, 0, 1'000'000'000'000, 3) == Approx(8e12).epsilon(1e-15));
}
