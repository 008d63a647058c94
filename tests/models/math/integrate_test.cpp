// The quadrature means the same on short and on long intervals.
#include <cmath>

#include <catch2/catch.hpp>

#include "models/catalogue/error.h"
#include "models/math/solve.h"

using namespace verstat::models;

TEST_CASE("integrals over very short intervals are their length times the value there") {
  for (double length = 1; length > 1e-13; length /= 7) {
    INFO(length);
    // Of e^x from 1: e (e^length - 1). Of sqrt from 0 the same interval, to the digits its root allows.
    const double high = 1 + length;
    CHECK(integrate([](double x) { return std::exp(x); }, 1, high) ==
          Approx(std::exp(1.0) * std::expm1(high - 1)).epsilon(1e-12));
    CHECK(integrate([](double x) { return x * x * x; }, 0, length) ==
          Approx(std::pow(length, 4) / 4).epsilon(1e-12));
  }
}

TEST_CASE("integrals over long intervals are held to the same tolerance") {
  for (double length = 1; length < 1e9; length *= 11) {
    INFO(length);
    CHECK(integrate([&](double x) { return std::exp(-x / length); }, 0, length) ==
          Approx(length * -std::expm1(-1.0)).epsilon(1e-12));
  }
  // A step is no smooth function: refused rather than misjudged, however long the interval.
  for (const double length : {1.0, 1e3, 1e6})
    CHECK_THROWS_AS(integrate([&](double x) { return x < length / 3 ? 0.0 : 1.0; }, 0, length, 1e-13),
                    DomainError);
  CHECK(integrate([](double x) { return x; }, 2, 1) == Approx(-1.5));
  CHECK(integrate([](double x) { return x; }, 3, 3) == 0);
}
