#pragma once
// Oblique cutting at least power, the inner mathematics of K406 without checks of inputs. Angles in radians.

namespace verstat::models::k406::energy {

/// Fits (14)-(16) that do not depend on the effective rake.
struct Flow {
  double x;
  double shear_constant_deg;  // phi_e - 0.375 alpha_e
  double angle_sum_deg;       // phi_e + beta - alpha_e
  double shear_stress_mpa;    // tau
};
[[nodiscard]] Flow flow(double x, double stress_scale);

struct Angles {
  double effective_rake, shear, friction;  // alpha_e, phi_e, beta
};
/// One element of a straight edge: normal rake and inclination fixed, chip-flow angle free.
class Edge {
 public:
  Edge(double normal_rake, double inclination);
  /// alpha_e, eq. (17): sine first, to save an arcsine and its sine.
  [[nodiscard]] double sin_effective_rake(double sin_eta, double cos_eta) const;
  [[nodiscard]] Angles angles(const Flow& state, double eta) const;
  /// A_s / (t L), (C1).
  [[nodiscard]] double area_factor(double eta, double effective_rake, double shear) const;

  struct Power {
    Angles angles;
    double area_factor, friction_area_factor;
    double shear, friction;  // N/mm2
    [[nodiscard]] double total() const { return shear + friction; }
  };
  [[nodiscard]] Power power(const Flow& state, double eta) const;

  struct Forces {
    double eta;
    Angles angles;
    double k_m, k_t, k_v, k_f, k_n;
    bool valid;
  };
  /// At the eta in -50..60 degrees of least power.
  [[nodiscard]] Forces least_power(const Flow& state) const;

 private:
  double normal_rake_, inclination_;
  double sin_rake_, cos_rake_, sin_inclination_, cos_inclination_;
};

}  // namespace verstat::models::k406::energy
