#pragma once
// Transverse vibration of a stepped Euler-Bernoulli beam by transfer matrices, with the two-dimensional space
// of states that a support allows carried along in orthonormal form: unlike the plain product of matrices,
// nothing is lost to the growth of cosh on the way.

#include <array>
#include <complex>
#include <vector>

namespace verstat::models::dynamics {

struct BeamSegment {
  double length_m;
  double stiffness_n_m2;  // E J
  double mass_kg_m;
};

/// What an end of the beam forbids.
enum class BeamEnd {
  clamped,  // y = theta = 0
  pinned,   // y = M = 0
  sliding   // theta = Q = 0
};

struct Krylov {
  double a, b, c, d;
};
/// (cosh + cos)/2, (sinh + sin)/2, (cosh - cos)/2, (sinh - sin)/2 at x, by series where the differences
/// cancel.
[[nodiscard]] Krylov krylov(double x);

class SteppedBeam {
 public:
  SteppedBeam(std::vector<BeamSegment> segments, BeamEnd start, BeamEnd tip);

  /// Changes sign at every natural angular frequency; scaled, so only sign and zero mean anything.
  [[nodiscard]] double frequency_function(double omega) const;
  /// The `count` lowest natural angular frequencies (rad/s), ascending, to 1e-13 relative. Steps of 0.5 %
  /// from a lower bound of the first; two roots inside a step are found where the function dips towards zero.
  [[nodiscard]] std::vector<double> frequencies(int count) const;

  struct Mode {
    std::vector<double> nodes;  // displacement at the segment ends, start first
    double largest;             // magnitude along the axis
  };
  /// Shape at a natural frequency, any scale; exactly 0 at supported nodes.
  [[nodiscard]] Mode mode(double omega) const;

  /// Displacement (m) at a node per unit harmonic force (N) at a node, with E(1 + i loss_factor).
  [[nodiscard]] std::complex<double> receptance(double omega, double loss_factor, std::size_t node_force,
                                                std::size_t node_response) const;

  /// Whether the support holds the node's displacement at 0.
  [[nodiscard]] bool fixed(std::size_t node) const;
  /// Sum of k L over the segments at a frequency: how many waves of shape fit.
  [[nodiscard]] double wave_length_sum(double omega) const;

 private:
  std::vector<BeamSegment> segments_;
  BeamEnd start_, tip_;
  double total_m_ = 0;
};

}  // namespace verstat::models::dynamics
