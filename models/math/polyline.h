#pragma once
// Tables of papers read between their rows.

#include <span>

namespace verstat::models {

struct Node {
  double x;
  double y;
};

/// Linear between the nodes (at least one, x increasing), the end values outside them. Exact at the nodes.
[[nodiscard]] double polyline(std::span<const Node> nodes, double x);

}  // namespace verstat::models
