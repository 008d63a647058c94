#include "models/math/gauss_legendre.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models {

std::vector<GaussPoint> gauss_legendre(std::size_t points) {
  const auto n = static_cast<double>(points);
  std::vector<GaussPoint> rule;
  rule.reserve(points);
  for (std::size_t k = 0; k < points; ++k) {
    double x = -std::cos(std::numbers::pi * (static_cast<double>(k) + 0.75) / (n + 0.5));
    double slope = 1;
    for (int step = 0; step < 100; ++step) {
      double before = 1;
      double value = x;
      for (std::size_t j = 2; j <= points; ++j) {
        const auto d = static_cast<double>(j);
        const double next = ((2 * d - 1) * x * value - (d - 1) * before) / d;
        before = value;
        value = next;
      }
      slope = n * (x * value - before) / (x * x - 1);
      const double move = value / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    rule.push_back({(1 + x) / 2, 1 / ((1 - x * x) * slope * slope)});
  }
  return rule;
}

const std::vector<GaussPoint>& gauss_legendre_24() {
  static const std::vector<GaussPoint> rule = gauss_legendre(24);
  return rule;
}

}  // namespace verstat::models
