#pragma once
// NLopt behind one door: bounded minimisation under graded constraints with our own incumbent, seeds and
// limits.
//
// Debian's NLopt 2.7.1 may return the last or an infeasible point, calls a NaN a success, and seeds itself
// per thread: so every variable is scaled to [0, 1], every evaluation is looked at here, and the best
// feasible one is the answer.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace verstat::optimize {

struct Bounds {
  double low = 0;
  double high = 1;
};

/// What is known of a point.
struct Measured {
  double value = 0;             ///< to be minimised; infinite or NaN: the point is undefined
  std::vector<double> margins;  ///< of the constraints: >= 0 when met, graded, about 1 in size
};
/// Margins above this count as met: constraints are approached from both sides.
inline constexpr double margin_tolerance = 1e-8;
/// Sum of what is missing to the constraints; infinite for an undefined point.
[[nodiscard]] double violation(const Measured& m);

/// Derivatives of a point with respect to every variable.
struct MeasuredSlopes {
  std::vector<double> value;
  std::vector<std::vector<double>> margins;  ///< one list per constraint
};
/// None where they are not known.
using Slopes = std::function<std::optional<MeasuredSlopes>(const std::vector<double>&)>;

/// Every call is an evaluation. Margins are always the same in number.
using Measure = std::function<Measured(const std::vector<double>&)>;

struct SearchOptions {
  /// Empty: global DIRECT-L over the box, then local searches from the best point, from the start and from
  /// scattered points: by SLSQP where there are `slopes`, at last (and without slopes always) by BOBYQA
  /// (Sbplx for one variable), with constraints by COBYLA and SLSQP. Else the name of an NLopt algorithm,
  /// such as "GN_CRS2_LM" or "LD_MMA".
  std::string algorithm;
  std::string local_algorithm;  ///< finishes after `algorithm`; inner searches of MLSL and AUGLAG
  int max_evaluations = 4000;
  double relative_precision = 1e-8;  ///< of the variables, relative to their bounds
  int starts = 2;                    ///< scattered points, when `algorithm` is empty
  bool global = true;                ///< false: local search from the start alone
  bool differences = true;           ///< false: the default finishes without SLSQP (noisy or dear measures)
  std::uint64_t seed = 1;
  Slopes slopes = {};  ///< exact gradients; where there are none, central differences
};

struct SearchResult {
  std::vector<double> x;
  Measured measured;
  bool feasible = false;
  int evaluations = 0;
};
/// Feasible before infeasible, then the smaller value; among infeasible ones the smaller violation.
[[nodiscard]] bool better(const SearchResult& a, const SearchResult& b);

/// Minimises over the box from `start` (brought into the box). Deterministic: the same arguments give the
/// same evaluations. Gradients that an algorithm asks for are the `slopes` of the options, else central
/// differences over 1e-6 of the bounds, counted as evaluations. Algorithms that know no constraints get an
/// exact penalty. What `measure` throws comes out unchanged. Throws std::invalid_argument for an unknown
/// algorithm, naming it.
[[nodiscard]] SearchResult minimize(const Measure& measure, const std::vector<Bounds>& bounds,
                                    const std::vector<double>& start, const SearchOptions& options);

/// True when `algorithm` can be given to SearchOptions.
[[nodiscard]] bool known_algorithm(const std::string& algorithm);
/// All of them, in NLopt's order.
[[nodiscard]] std::vector<std::string> algorithms();

/// A coordinate of a mixed search: continuous, whole numbers in order, or categories without order.
struct Dimension {
  Bounds bounds;
  bool discrete = false;
  bool ordered = true;
};

/// As `minimize`, with whole numbers and categories: all settings when they are few, each with its own
/// continuous search; else a neighbourhood search (one coordinate to a neighbouring whole number or another
/// category, then two at a time), warm-started, from the start and from scattered settings.
[[nodiscard]] SearchResult minimize_mixed(const Measure& measure, const std::vector<Dimension>& dimensions,
                                          const std::vector<double>& start, const SearchOptions& options);

}  // namespace verstat::optimize
