#pragma once
// Tangential force of a helical milling cutter over an engaged arc, with Kienzle's specific force: the total
// over all teeth in dimensionless form, its peak over one tooth pitch and its mean.

#include <array>
#include <cstdint>

namespace verstat::models {

/// Integral of sin^p from 0 to phi, 0 <= phi <= pi, 0 < p <= 1, to about 1e-15; made once, cheap to
/// evaluate: phi^(p+1) times a Chebyshev series in phi^2, mirrored at pi/2.
class SinePowerIntegral {
 public:
  explicit SinePowerIntegral(double p);
  [[nodiscard]] double operator()(double phi) const;
  [[nodiscard]] double power() const { return p_; }

 private:
  static constexpr std::size_t terms = 18;
  double p_;
  double half_ = 0;  // the integral to pi/2
  std::array<double, terms> series_{};
};

/// Force of all teeth in units of kc1.1 * f_z^p * axial depth, p = 1 - mc, when the reference tooth's leading
/// end stands at psi. Angles in radians.
struct ToothLoad {
  const SinePowerIntegral& integral;
  double start;  ///< engaged arc, 0 <= start < exit <= pi
  double exit;
  double lag;  ///< of the trailing end of a tooth: depth * tan(helix) / radius
  std::int64_t teeth;

  [[nodiscard]] double at(double psi) const;
  /// Largest value over one pitch: at the events "a tooth end passes start or exit", or where the slope of a
  /// smooth piece between them falls through zero.
  [[nodiscard]] double peak() const;
  [[nodiscard]] double mean() const;

 private:
  class Slope;
};

}  // namespace verstat::models
