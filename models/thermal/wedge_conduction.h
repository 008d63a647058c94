#pragma once
// Exact conduction in a cutting wedge heated on rectangles of its two faces next to the edge: mean steady
// rises by the method of images, and the warm-up of the 90 degree wedge. Faces adiabatic outside the
// sources, wedge infinite, ambient temperature far away.

#include <vector>

namespace verstat::models::thermal {

/// Dimensionless mean rises: a flux q over l x b of the rake raises it by q l/lambda * m1 and the flank
/// contact (h x b) by q l/lambda * n; a flux over the flank raises it by q h/lambda * m2, the rake by
/// q h/lambda * n (reciprocity: one n for both).
struct WedgeRises {
  double m1, m2, n;
};

/// Wedge of beta = pi/`parts` (parts = 2: 90 degrees, 3: 60 degrees), b width along the edge, l length on the
/// rake, h length on the flank (0: m2 = n = 0), any common unit. Images: 2*parts sources around the edge.
/// 24 Gauss points per variable, 1e-5.
[[nodiscard]] WedgeRises wedge_rises(int parts, double b, double l, double h);

/// Any wedge angle in degrees: ln of each rise linear in ln(beta) through 90 and 60 degrees.
[[nodiscard]] WedgeRises wedge_rises_at(double beta_deg, double b, double l, double h);

/// Warm-up m(Fo) of the mean temperature of a rectangle (eta = width/length) at the edge of a 90 degree wedge
/// under constant flux, as a share of the steady rise. Fo = diffusivity * time / length^2.
/// One object serves any number of Fo for one eta.
class WedgeWarmUp {
 public:
  explicit WedgeWarmUp(double eta);
  /// 0 for fo <= 0; rises to 1.
  [[nodiscard]] double at(double fo) const;
  /// Inverse: the Fo at which the share m in (0, 1) is reached. Throws DomainError for m too close to 1.
  [[nodiscard]] double fo_for(double share) const;

 private:
  [[nodiscard]] double integrand(double u) const;
  double eta_;
  double last_;                      // sqrt(Fo) of the last panel end
  double steady_;                    // Theta(infinity)
  std::vector<double> ends_, sums_;  // panel ends in sqrt(Fo) and the integral up to each
};

}  // namespace verstat::models::thermal
