#include "models/math/circle_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/catalogue/error.h"

namespace verstat::models {

CircleFit fit_circle(std::span<const PlanePoint> points) {
  const auto n = static_cast<double>(points.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const auto& [x, y] : points) {
    mean_x += x / n;
    mean_y += y / n;
  }
  // About the centroid the normal equations keep their digits.
  double uu = 0, uv = 0, vv = 0, u_square = 0, v_square = 0;
  for (const auto& [x, y] : points) {
    const double u = x - mean_x;
    const double v = y - mean_y;
    const double square = u * u + v * v;
    uu += u * u;
    uv += u * v;
    vv += v * v;
    u_square += u * square;
    v_square += v * square;
  }
  const double determinant = uu * vv - uv * uv;
  if (points.size() < 3 || !(determinant > 1e-14 * (uu + vv) * (uu + vv)))
    reject("points on a line have no circle");
  const double center_u = (u_square * vv - v_square * uv) / (2 * determinant);
  const double center_v = (v_square * uu - u_square * uv) / (2 * determinant);
  CircleFit fit{mean_x + center_u, mean_y + center_v,
                std::sqrt(center_u * center_u + center_v * center_v + (uu + vv) / n), 0, 0};
  double least = std::numeric_limits<double>::infinity();
  double largest = -least;
  double square_sum = 0;
  for (const auto& [x, y] : points) {
    const double deviation = std::hypot(x - fit.center_x, y - fit.center_y) - fit.radius;
    least = std::min(least, deviation);
    largest = std::max(largest, deviation);
    square_sum += deviation * deviation;
  }
  fit.form_error = largest - least;
  fit.rms_error = std::sqrt(square_sum / n);
  return fit;
}

}  // namespace verstat::models
