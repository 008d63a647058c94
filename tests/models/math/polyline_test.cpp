#include "models/math/polyline.h"

#include <array>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "tests/property.h"

using namespace verstat::models;

TEST_CASE("a polyline meets its nodes exactly and keeps its end values outside them", "[math]") {
  constexpr std::array nodes{Node{10, 24}, Node{20, 25}, Node{40, 0.1}};
  for (const Node& node : nodes) CHECK(polyline(nodes, node.x) == node.y);
  CHECK(polyline(nodes, 9.9) == 24);
  CHECK(polyline(nodes, -1e300) == 24);
  CHECK(polyline(nodes, 40.1) == 0.1);
  CHECK(polyline(nodes, 15) == Approx(24.5).epsilon(1e-15));
  CHECK(polyline(nodes, 25) == Approx(25 - 24.9 / 4).epsilon(1e-15));
}

TEST_CASE("a polyline through points of a straight line is that line", "[math]") {
  verstat::test::property([] {
    const auto line = [](double x) { return 3 - 0.25 * x; };
    const std::array nodes{Node{-4, line(-4)}, Node{1, line(1)}, Node{2, line(2)}, Node{16, line(16)}};
    const double x = *rc::gen::inRange(-4000, 16000) * 1e-3;
    RC_ASSERT(std::abs(polyline(nodes, x) - line(x)) < 1e-14);
  });
}
