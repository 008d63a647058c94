#pragma once
// Several objectives, all to be minimised: which points nobody beats, how good they are together, which one
// is the knee.

#include <functional>
#include <vector>

#include "optimize/search.h"

namespace verstat::optimize {

/// True when `a` is at least as good everywhere and better somewhere.
[[nodiscard]] bool dominates(const std::vector<double>& a, const std::vector<double>& b);
/// Positions of the points that no other dominates, the first of equals only.
[[nodiscard]] std::vector<std::size_t> nondominated(const std::vector<std::vector<double>>& points);

/// Volume dominated by the points and bounded by `reference`; points not better than the reference everywhere
/// add nothing. Exact, by slicing along the last objective; any number of objectives >= 1.
[[nodiscard]] double hypervolume(const std::vector<std::vector<double>>& points,
                                 const std::vector<double>& reference);

/// The point of a front (at least one) farthest below the plane through the best points of each objective,
/// with every objective scaled to its range on the front: where giving up a little of one stops paying.
[[nodiscard]] std::size_t knee(const std::vector<std::vector<double>>& front);

/// All objectives and margins of a point.
struct ManyMeasured {
  std::vector<double> objectives;  ///< infinite: undefined
  std::vector<double> margins;
};

struct FrontPoint {
  std::vector<double> x;
  std::vector<double> objectives;
};

struct Front {
  std::vector<FrontPoint> points;  ///< sorted by the first objective
  std::vector<double> reference;   ///< the worst of every objective on the front, and a tenth of its range
  double hypervolume = 0;
  std::size_t knee = 0;
};

/// Front by the epsilon-constraint method: each objective alone first, then the first objective under bounds
/// on the others, `points` >= 2 of them per objective, every search warm-started from its neighbour
/// (Haimes 1971; Miettinen, Nonlinear Multiobjective Optimization, 1999, ch. 3.2). Empty when nothing is
/// feasible.
[[nodiscard]] Front pareto_front(const std::function<ManyMeasured(const std::vector<double>&)>& measure,
                                 const std::vector<Dimension>& dimensions, const std::vector<double>& start,
                                 std::size_t objectives, int points, const SearchOptions& options);

}  // namespace verstat::optimize
