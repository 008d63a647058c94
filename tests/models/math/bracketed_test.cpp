#include "models/math/bracketed.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

using namespace verstat::models;

TEST_CASE("bracketed roots agree with known inverses", "[math]") {
  CHECK(rc::check([] {
    const double root = *rc::gen::inRange(-4000, 4000) * 1e-3;
    const double low = root - *rc::gen::inRange(1, 3000) * 1e-3;
    const double high = root + *rc::gen::inRange(1, 3000) * 1e-3;
    const double found = bracketed_root([&](double x) { return std::expm1(x - root); }, low, high, 1e-13);
    RC_ASSERT(std::abs(found - root) < 1e-12);
    // Decreasing, flat at the root.
    const double flat = bracketed_root([&](double x) { return std::pow(root - x, 3); }, low, high, 1e-12);
    RC_ASSERT(std::abs(flat - root) < 1e-11);
    const double newton = newton_increasing(
        [&](double x) {
          return std::pair{std::sinh(x - root), std::cosh(x - root)};
        },
        low, high, high, 1e-14);
    RC_ASSERT(std::abs(newton - root) < 1e-13);
  }));
}

TEST_CASE("a jump is found as the place of the sign change", "[math]") {
  const double jump = bracketed_root([](double x) { return x < 0.3 ? -1.0 : 5.0; }, 0, 1, 1e-13);
  CHECK(jump == Approx(0.3).epsilon(1e-11));
}

TEST_CASE("a bracket without a sign change is refused, Newton stays in its bracket", "[math]") {
  CHECK_THROWS_AS(bracketed_root([](double x) { return 1 + x * x; }, 0, 1, 1e-9), DomainError);
  CHECK(newton_increasing(
            [](double x) {
              return std::pair{x - 5, 1.0};
            },
            0, 1, 0.2, 1e-14) == Approx(1).epsilon(1e-12));
}
