#pragma once
// What the files of K412 share: the check of a contour and its conversion to points.

#include "models/math/turned_contour.h"
#include "models/toolpath/k412_straightening_roll.h"

namespace verstat::models::k412 {

/// Points of a contour. Throws DomainError naming the first point that is wrong: lengths differ, y falls, or
/// a point repeats its neighbour.
[[nodiscard]] TurnedContour checked(const Contour& contour);
[[nodiscard]] Contour to_lists(const TurnedContour& contour);

}  // namespace verstat::models::k412
