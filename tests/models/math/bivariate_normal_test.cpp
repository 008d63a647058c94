#include "models/math/bivariate_normal.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/math/normal.h"
#include "models/math/solve.h"

using namespace verstat::models;

TEST_CASE("bivariate normal law: quadrature over the conditional law, symmetry and limits", "[math]") {
  CHECK(rc::check([] {
    const double h = *rc::gen::inRange(-500, 501) * 0.01;
    const double k = *rc::gen::inRange(-500, 501) * 0.01;
    const double rho = *rc::gen::inRange(-995, 996) * 0.001;
    const double got = bivariate_normal_cdf(h, k, rho);
    const double spread = std::sqrt(1 - rho * rho);
    // P(X < h, Y < k) = integral of phi(x) Phi((k - rho x)/sqrt(1 - rho^2)) over x < h.
    const double slow = integrate(
        [&](double x) { return normal_density(x) * normal_cdf((k - rho * x) / spread); }, -9, h, 1e-12);
    RC_ASSERT(std::abs(got - slow) < 2e-13);
    RC_ASSERT(std::abs(got - bivariate_normal_cdf(k, h, rho)) < 1e-15);
    RC_ASSERT(std::abs(normal_cdf(h) - got - bivariate_normal_cdf(h, -k, -rho)) < 1e-14);
  }));
  CHECK(bivariate_normal_cdf(0, 0, 0.5) == Approx(1.0 / 3).epsilon(1e-15));  // 1/4 + asin(rho)/(2 pi)
  CHECK(bivariate_normal_cdf(INFINITY, 0.3, 0.7) == normal_cdf(0.3));
}
