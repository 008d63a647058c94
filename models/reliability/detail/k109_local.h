#pragma once
// Local load sharing of K109 (C4) as a Markov chain over the patterns of working teeth.

#include <vector>

namespace verstat::models::k109::detail {

/// States are the patterns of working teeth up to rotation, in the order of their number of failures (4116 of
/// them for 16 teeth); more than `failed_allowed` failures are absorbed.
class LocalSharing {
 public:
  /// teeth 1..16, failed_allowed 0..teeth-1, alpha >= 0.
  LocalSharing(int teeth, int failed_allowed, double alpha);

  /// Probability of not being absorbed after exposure L = -ln R_z, started with all teeth working.
  [[nodiscard]] double reliability(double exposure) const;

 private:
  struct Inflow {
    int from;
    double rate;
  };
  [[nodiscard]] unsigned full() const { return (1U << teeth_) - 1; }
  /// The smallest of the rotations of a pattern.
  [[nodiscard]] unsigned canonical(unsigned pattern) const;
  /// Pitches from the tooth to the nearest working one that cuts before it; z for a lone tooth.
  [[nodiscard]] int gap_before(unsigned pattern, int tooth) const;
  void add(unsigned pattern, std::vector<int>& index);
  [[nodiscard]] double by_uniformization(double fastest, double exposure) const;
  [[nodiscard]] double by_implicit_steps(double fastest, double exposure) const;

  int teeth_;
  std::vector<double> total_;                // rate of leaving each state
  std::vector<std::vector<Inflow>> inflow_;  // from states with one failure less
};

}  // namespace verstat::models::k109::detail
