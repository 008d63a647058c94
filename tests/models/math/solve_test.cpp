#include "models/math/solve.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "models/catalogue/error.h"

using namespace verstat::models;

TEST_CASE("a root is found between values of opposite sign, to the last digits", "[math]") {
  CHECK(find_root([](double x) { return std::cos(x) - x; }, 0, 1, 1e-15) ==
        Approx(0.7390851332151607).epsilon(1e-14));
  CHECK(find_root([](double x) { return 2 - std::exp(x); }, -3, 30, 1e-15) ==
        Approx(std::numbers::ln2).epsilon(1e-14));
  // The tolerance is relative to the root, however small it is.
  CHECK(find_root([](double x) { return std::expm1(x + 1e-9); }, -1, 1, 1e-12) ==
        Approx(-1e-9).epsilon(1e-11));
  // Values whose product underflows have opposite signs nevertheless.
  CHECK(find_root([](double x) { return 1e-200 * (x - 3); }, 0, 10, 1e-15) == Approx(3.0).epsilon(1e-14));
}

TEST_CASE("a root at an end of the range is that end", "[math]") {
  const auto line = [](double x) { return x - 2; };
  CHECK(find_root(line, 2, 5, 1e-12) == 2);
  CHECK(find_root(line, -5, 2, 1e-12) == 2);
}

TEST_CASE("a wide tolerance is kept and used", "[math]") {
  int calls = 0;
  const auto counted = [&calls](double x) {
    ++calls;
    return std::cos(x) - x;
  };
  const double rough = find_root(counted, 0, 1, 1e-2);
  const int rough_calls = calls;
  CHECK(std::abs(rough - 0.7390851332151607) <= 1e-2);
  calls = 0;
  CHECK(find_root(counted, 0, 1, 1e-15) == Approx(0.7390851332151607).epsilon(1e-14));
  CHECK(rough_calls < calls);
}

TEST_CASE("without a change of sign there is no root, in words", "[math]") {
  CHECK_THROWS_WITH(find_root([](double x) { return x * x + 1; }, -1, 2, 1e-12),
                    Catch::Contains("no root between -1 and 2: the function does not change sign"));
  CHECK_THROWS_AS(find_root([](double) { return std::nan(""); }, -1, 2, 1e-12), DomainError);
}

TEST_CASE("the minimum of a valley, inside or at an end", "[math]") {
  const Minimum inside = minimize_unimodal([](double x) { return 5 + (x - 3) * (x - 3); }, 0, 10, 1e-12);
  CHECK(inside.x == Approx(3.0).epsilon(1e-7));
  CHECK(inside.value == Approx(5.0).epsilon(1e-14));
  const Minimum low = minimize_unimodal([](double x) { return std::exp(x); }, 2, 10, 1e-12);
  CHECK(low.x == 2);
  CHECK(low.value == std::exp(2.0));
  const Minimum high = minimize_unimodal([](double x) { return -x; }, 2, 10, 1e-12);
  CHECK(high.x == 10);
  CHECK(high.value == -10);
}

TEST_CASE("the lowest of several valleys is found, ends included", "[math]") {
  // Valleys near -2, 1 and 4, each a little lower to the right.
  const auto valleys = [](double x) { return 1 - std::cos(2 * std::numbers::pi / 3 * (x - 1)) - 0.05 * x; };
  const Minimum inner = minimize_global(valleys, -3, 5, 40, 1e-12);
  // 2 pi / 3 sin(2 pi / 3 (x - 1)) = 0.05
  CHECK(inner.x ==
        Approx(4 + std::asin(0.05 * 3 / (2 * std::numbers::pi)) * 3 / (2 * std::numbers::pi)).epsilon(1e-7));
  CHECK(inner.value == Approx(valleys(inner.x)).epsilon(1e-14));
  const Minimum first = minimize_global([&](double x) { return valleys(x) + x; }, -3, 5, 40, 1e-12);
  CHECK(first.x ==
        Approx(-2 - std::asin(0.95 * 3 / (2 * std::numbers::pi)) * 3 / (2 * std::numbers::pi)).epsilon(1e-7));
  const Minimum end = minimize_global([](double x) { return std::sin(x) - x; }, 0, 7, 10, 1e-12);
  CHECK(end.x == 7);
  const Minimum first_cell = minimize_global([](double x) { return (x - 0.1) * (x - 0.1); }, 0, 10, 10);
  CHECK(first_cell.x == Approx(0.1).epsilon(1e-6));
  CHECK(minimize_global([](double) { return 4.0; }, 1, 9).x == 1);  // the first of equal ones
}
