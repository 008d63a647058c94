#pragma once
// The grain model of K311 behind the public functions: a normal law of the penetration depth truncated to
// 0..t_f, and the mean number of scratches over a level.

#include "models/surface/k311_lapping_cycle.h"

namespace verstat::models::k311::grains {

/// The truncated law, normalized once. Throws DomainError when no mass is left in 0..t_f.
class TruncatedNormal {
 public:
  explicit TruncatedNormal(const DepthLaw& law);
  [[nodiscard]] double density(double depth_um) const;  ///< 1/um, zero outside 0..t_f
  [[nodiscard]] double greatest() const { return greatest_um_; }
  /// Integral of g(z) f(level + z) dz over z in [0, reach], given as g(from, to) on panels. The panels meet
  /// at the mode and keep to where the density is within exp(-40) of its largest value.
  template <class G>
  [[nodiscard]] double expectation_above(double level_um, double reach_um, G&& g) const;

 private:
  double mean_um_;
  double sd_um_;
  double greatest_um_;
  double scale_per_um_;
};

/// Mean half chord that grains cut at the level y = t_f - below_deepest: integral of
/// sqrt((a - y)(d - a + y)) f(a) over a in y..t_f, um; zero for a level below the deepest point.
[[nodiscard]] double mean_half_chord_um(const TruncatedNormal& law, double below_deepest_um, double grain_um);
/// Mean of a (d - a), um^2: pi times it is the contact area of a sliding sphere.
[[nodiscard]] double mean_cap_um2(const TruncatedNormal& law, double grain_um);
/// Exponent factor chi V t / l_0^2, 1/um.
[[nodiscard]] double sweep_per_um(const GrainContact& contact);
/// Mean removal and Ra of a flat surface lapped by the contact.
[[nodiscard]] LappedRoughness roughness(const GrainContact& contact);

}  // namespace verstat::models::k311::grains
