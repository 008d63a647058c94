#include "models/math/turned_contour.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/catalogue/error.h"

using namespace verstat::models;

TEST_CASE("turned contour: lengths and volumes of a cone", "[math]") {
  const TurnedContour cone{{0, 0}, {3, 4}};
  CHECK(contour_length_mm(cone) == Approx(5));
  CHECK(revolved_volume_mm3(cone) == Approx(std::numbers::pi * 16));
  CHECK(revolved_volume_mm3(TurnedContour{{0, 2}, {0, 5}, {4, 5}}) == Approx(std::numbers::pi * 100));
}

TEST_CASE("turned contour: a mitred offset is parallel to every segment", "[math]") {
  const TurnedContour contour{{0, 10}, {0, 20}, {10, 22}, {30, 18}, {30, 5}};
  const TurnedContour moved = offset_contour_mitred(contour, 1.5);
  REQUIRE(moved.size() == contour.size());
  CHECK(moved[0].axial_mm == Approx(-1.5));  // outwards of the left face
  CHECK(moved[4].axial_mm == Approx(31.5));
  for (std::size_t k = 1; k < contour.size(); ++k) {
    const double dy = contour[k].axial_mm - contour[k - 1].axial_mm;
    const double dx = contour[k].radius_mm - contour[k - 1].radius_mm;
    for (const std::size_t end : {k - 1, k}) {
      const double distance = ((moved[end].radius_mm - contour[end].radius_mm) * dy -
                               (moved[end].axial_mm - contour[end].axial_mm) * dx) /
                              std::hypot(dy, dx);
      CHECK(distance == Approx(1.5));
    }
  }
  CHECK_THROWS_AS(offset_contour_mitred(TurnedContour{{0, 1}, {0, 5}, {0, 2}}, 1), DomainError);
}

TEST_CASE("turned contour: pieces below a radius", "[math]") {
  const TurnedContour contour{{0, 0}, {10, 10}, {20, 0}, {30, 5}, {40, 5}, {50, 0}};
  const auto pieces = pieces_below(contour, 5);
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].back().axial_mm == Approx(5));
  CHECK(pieces[1].front().axial_mm == Approx(15));
  CHECK(pieces[1].back().axial_mm == Approx(30));
  CHECK(pieces[2].front().axial_mm == Approx(40));
  CHECK(pieces_below(contour, 100).size() == 1);
  CHECK(pieces_below(TurnedContour{{0, 5}, {9, 5}}, 5).empty());
  double below = 0;
  for (const auto& piece : pieces) below += contour_length_mm(piece);
  CHECK(below == Approx(2 * std::hypot(5, 5) + std::hypot(10, 5) * 2));
}
