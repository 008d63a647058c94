#include "models/math/circle_fit.h"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/catalogue/error.h"
#include "tests/property.h"

using namespace verstat::models;

TEST_CASE("circle fit: points of an arc give its centre and radius", "[math]") {
  verstat::test::property([] {
    const double x = *rc::gen::inRange(-100, 100);
    const double y = *rc::gen::inRange(-100, 100);
    const double radius = *rc::gen::inRange(1, 100);
    const double half_angle = *rc::gen::inRange(10, 300) * 0.01;
    std::vector<PlanePoint> arc;
    for (int k = 0; k <= 20; ++k) {
      const double angle = half_angle * (k - 10) / 10;
      arc.push_back({x + radius * std::sin(angle), y + radius * std::cos(angle)});
    }
    const CircleFit fit = fit_circle(arc);
    RC_ASSERT(std::abs(fit.radius - radius) < 1e-9 * radius);
    RC_ASSERT(std::abs(fit.center_x - x) < 1e-8);
    RC_ASSERT(std::abs(fit.center_y - y) < 1e-8);
    RC_ASSERT(fit.form_error < 1e-10);
  });
}

TEST_CASE("circle fit: the algebraic sum of squares cannot be lowered", "[math]") {
  const std::vector<PlanePoint> points{{0, 1}, {1, 0.2}, {-1, 0.1}, {0.7, 0.8}, {-0.6, 0.7}, {0.1, -1.2}};
  const auto sum = [&](double cx, double cy, double r) {
    double s = 0;
    for (const auto& [x, y] : points) {
      const double residual = (x - cx) * (x - cx) + (y - cy) * (y - cy) - r * r;
      s += residual * residual;
    }
    return s;
  };
  const CircleFit fit = fit_circle(points);
  const double best = sum(fit.center_x, fit.center_y, fit.radius);
  for (const double step : {1e-3, -1e-3}) {
    CHECK(sum(fit.center_x + step, fit.center_y, fit.radius) > best);
    CHECK(sum(fit.center_x, fit.center_y + step, fit.radius) > best);
    CHECK(sum(fit.center_x, fit.center_y, fit.radius + step) > best);
  }
}

TEST_CASE("circle fit: a line has no circle", "[math]") {
  CHECK_THROWS_AS(fit_circle(std::vector<PlanePoint>{{0, 0}, {1, 2}, {2, 4}, {3, 6}}), DomainError);
}
