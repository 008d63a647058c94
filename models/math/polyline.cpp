#include "models/math/polyline.h"

#include <algorithm>

namespace verstat::models {

double polyline(std::span<const Node> nodes, double x) {
  const auto right = std::ranges::lower_bound(nodes, x, {}, &Node::x);
  if (right == nodes.begin()) return nodes.front().y;
  if (right == nodes.end()) return nodes.back().y;
  const Node& b = *right;
  if (x == b.x) return b.y;
  const Node& a = *(right - 1);
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

}  // namespace verstat::models
