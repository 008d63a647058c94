#pragma once
// Transverse vibration of a rod made of uniform Euler-Bernoulli segments: transfer matrices (method of
// initial parameters) for compliances, and the exact dynamic stiffness with Wittrick and Williams' count of
// the natural frequencies below a frequency. SI units.
//
// Transfer matrices are accurate for slow vibration and lose exp(sum of lambda L) in digits as the frequency
// grows; the count has no poles, misses no close pair and keeps its digits at any frequency.

#include <complex>
#include <cstddef>
#include <vector>

#include <Eigen/Dense>

namespace verstat::models {

struct RodSegment {
  double length_m;
  double bending_stiffness_n_m2;  ///< E J
  double mass_kg_m;               ///< rho A
};

/// Segment of a round bar or tube. Lengths in mm, inner diameter 0 for a solid bar.
[[nodiscard]] RodSegment round_segment(double length_mm, double outer_mm, double inner_mm, double e_gpa,
                                       double rho_kg_m3);

/// Krylov functions S = (cosh + cos)/2, T = (sinh + sin)/2, U = (cosh - cos)/2, V = (sinh - sin)/2.
template <class T>
struct Krylov {
  T s, t, u, v;
};
template <class T>
[[nodiscard]] Krylov<T> krylov(T x);

template <class T>
using TransferMatrix = Eigen::Matrix<T, 4, 4>;

/// Dimensionless transfer matrix of one segment for the state {y, l phi, a M, b Q}, a = l^2/EJ, b = l^3/EJ
/// of the reference. `complex_factor` multiplies E: 1, or 1 + i eta for hysteretic damping.
template <class T>
[[nodiscard]] TransferMatrix<T> transfer_matrix(const RodSegment& segment, double omega_rad_s,
                                                double ref_length_m, double ref_stiffness_n_m2,
                                                T complex_factor);

/// Sum of lambda L over the segments: transfer matrices lose exp of it in relative accuracy.
[[nodiscard]] double bending_phase(const std::vector<RodSegment>& rod, double omega_rad_s);

struct GroundSpring {
  std::size_t section;
  double stiffness_n_m;
};

/// Compliances of one rod with free ends and springs to the ground, at one frequency.
template <class T>
class RodCompliance {
 public:
  /// `complex_factor` multiplies E and the springs: 1, or 1 + i eta.
  RodCompliance(const std::vector<RodSegment>& rod, const std::vector<GroundSpring>& springs,
                double omega_rad_s, T complex_factor);
  /// Displacement (m) of every section under a unit harmonic force (1 N) at section j.
  [[nodiscard]] std::vector<T> under_force_at(std::size_t j) const;

 private:
  std::vector<TransferMatrix<T>> steps_;     // [0] the spring at section 0, [k] from section k-1 to k
  std::vector<TransferMatrix<T>> products_;  // from section 0 to k
  double flexibility_m_n_;                   // b = l^3/EJ
};

/// Rods joined by springs (bearings) and resting on springs.
class RodSystem {
 public:
  struct Link {
    std::size_t first_section;   ///< of rod 0
    std::size_t second_section;  ///< of rod 1
    double stiffness_n_m;
  };
  /// A single rod.
  RodSystem(std::vector<RodSegment> rod, std::vector<GroundSpring> springs);
  /// Two rods; springs carry the second. Links must join equal sections.
  RodSystem(std::vector<RodSegment> first, std::vector<RodSegment> second, std::vector<Link> links,
            std::vector<GroundSpring> second_springs);
  /// Number of natural frequencies below `freq_hz` > 0, those of rigid motion (0 Hz) included.
  [[nodiscard]] int count_below(double freq_hz) const;
  /// Number of motions at 0 Hz.
  [[nodiscard]] int rigid_motions() const;
  /// The first `count` natural frequencies between low and high, ascending, with their multiplicity.
  [[nodiscard]] std::vector<double> frequencies_hz(int count, double low_hz, double high_hz) const;

 private:
  [[nodiscard]] std::size_t node(std::size_t rod, std::size_t section) const;

  std::vector<std::vector<RodSegment>> rods_;
  std::vector<Link> links_;
  std::vector<GroundSpring> springs_;  // of the last rod
};

}  // namespace verstat::models
