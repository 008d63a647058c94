#pragma once
// Distance of a point from an ellipse.

namespace verstat::models {

/// Shortest distance of the point (x, y) from the ellipse with centre 0 and half axes `major` along x and
/// `minor` along y, major >= minor >= 0 (minor 0: a segment). Not signed.
[[nodiscard]] double ellipse_distance(double major, double minor, double x, double y);

}  // namespace verstat::models
