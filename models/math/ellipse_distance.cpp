#include "models/math/ellipse_distance.h"

#include <algorithm>
#include <cmath>

namespace verstat::models {

double ellipse_distance(double major, double minor, double x, double y) {
  x = std::abs(x);  // by symmetry in the first quadrant
  y = std::abs(y);
  if (minor <= 1e-12 * major) return std::hypot(std::max(0.0, x - major), y);
  if (y == 0) {
    const double focal_square = (major - minor) * (major + minor);
    if (major * x >= focal_square) return std::abs(x - major);
    const double share = major * x / focal_square;  // foot at (major * share, minor * sqrt(1 - share^2))
    return std::hypot(major * share - x, minor * std::sqrt((1 - share) * (1 + share)));
  }
  // The foot is (x r / (s + r), y / (s + 1)) with r = (major / minor)^2, where s solves
  //   (r u / (s + r))^2 + (v / (s + 1))^2 = 1,  u = x / major, v = y / minor.
  // The left side falls and is convex for s > -1, so Newton's steps from the left approach the root from one
  // side.
  const double r = (major / minor) * (major / minor);
  const double u = r * x / major;
  const double v = y / minor;
  double s = std::max(v - 1, u - r);
  for (int k = 0; k < 200; ++k) {
    const double a = u / (s + r);
    const double b = v / (s + 1);
    const double excess = (a - 1) * (a + 1) + b * b;
    if (!(excess > 0)) break;
    const double next = s + excess / (2 * (a * a / (s + r) + b * b / (s + 1)));
    if (!(next > s)) break;
    s = next;
  }
  return std::hypot(r * x / (s + r) - x, y / (s + 1) - y);
}

}  // namespace verstat::models
