#pragma once
// Designs of experiments over a few factors, and what they say: main effects, interactions, a tornado.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace verstat::optimize {

/// Points in coded units: -1 is the low end of a factor, +1 the high end.
struct Design {
  std::vector<std::vector<double>> points;
  /// Of a two-level fraction: 3, 4 or 5 and more (no main effect is confused with an interaction of fewer
  /// than resolution - 1 factors); 0 where the word has no meaning.
  int resolution = 0;
};

/// All combinations of `levels[k]` >= 2 evenly spaced levels, the first factor fastest. At most 1e6 points.
[[nodiscard]] Design full_factorial(const std::vector<int>& levels);
/// 2^q points for `factors` <= 2^q - 1 factors, 2 <= factors <= 31: the generators of the largest resolution
/// that a search over words finds, and of equals the fewest shortest words. q from 2 to 10.
[[nodiscard]] Design fractional_factorial(int factors, int q);
/// `points` >= 2, every factor once in every n-th part of its range, placed at random inside it (McKay,
/// Beckman, Conover, Technometrics 21 (1979) 239).
[[nodiscard]] Design latin_hypercube(int factors, int points, std::uint64_t seed);
/// The first `points` of the Sobol sequence after its zero point.
[[nodiscard]] Design sobol(int factors, int points);
/// The centre, then every factor low and high with the others at the centre.
[[nodiscard]] Design one_at_a_time(int factors);

/// The change of the response when a factor goes from low to high; for an interaction, half the difference of
/// one factor's effect at the two ends of the other.
struct Effect {
  std::vector<std::size_t> factors;  ///< one, or two for an interaction
  double effect = 0;
  std::optional<double> half_width;               ///< over replications
  std::vector<std::vector<std::size_t>> aliases;  ///< effects that this design cannot tell from it
};

/// Least squares with all main effects and as many two-factor interactions as the design can tell apart,
/// replication by replication, so that common random numbers count. responses[i][r]: point i, replication r.
/// Replications with a missing value (NaN) are left out. Throws std::invalid_argument when shapes do not
/// match or no replication is complete.
[[nodiscard]] std::vector<Effect> effects(const Design& design,
                                          const std::vector<std::vector<double>>& responses,
                                          double confidence);

}  // namespace verstat::optimize
