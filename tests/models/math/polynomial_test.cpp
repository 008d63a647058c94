#include "models/math/polynomial.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

using namespace verstat::models;

TEST_CASE("roots of products of linear factors are found, those outside the range left out", "[math]") {
  CHECK(rc::check([] {
    const int degree = *rc::gen::inRange(1, 6);
    std::vector<double> expected, coefficients{1.0};
    for (int k = 0; k < degree; ++k) {
      // Half a unit apart at least.
      const double root = 2.0 * k - 5 + *rc::gen::inRange(0, 150) * 0.01;
      if (root >= -4 && root <= 4) expected.push_back(root);
      std::vector<double> next(coefficients.size() + 1, 0.0);
      for (std::size_t i = 0; i < coefficients.size(); ++i) {
        next[i] -= root * coefficients[i];
        next[i + 1] += coefficients[i];
      }
      coefficients = next;
    }
    coefficients.push_back(0.0);  // a leading zero does no harm
    const std::vector<double> found = polynomial_roots(coefficients, -4, 4);
    // A root on a bound may fall to either side.
    if (std::any_of(expected.begin(), expected.end(),
                    [](double r) { return std::abs(std::abs(r) - 4) < 1e-6; }))
      return;
    RC_ASSERT(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) RC_ASSERT(std::abs(found[i] - expected[i]) < 1e-9);
  }));
}

TEST_CASE("touching roots count once, constants and the zero polynomial have none", "[math]") {
  CHECK(polynomial_roots({4, -4, 1}, 0, 5) == std::vector<double>{2});
  CHECK(polynomial_roots({1, 0, 1}, -5, 5).empty());
  CHECK(polynomial_roots({3}, -5, 5).empty());
  CHECK(polynomial_roots({1, 1, 1}, 1e-9, 1).empty());  // near zero as well as anywhere
  CHECK(polynomial_roots({0, 0, 0}, -5, 5).empty());
  CHECK(evaluate_polynomial({1, 2, 3}, 2) == 17);
  CHECK(derivative_polynomial({1, 2, 3}) == std::vector<double>{2, 6});
}
