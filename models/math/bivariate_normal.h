#pragma once

namespace verstat::models {

/// Phi_2(h, k; rho) = P(X < h, Y < k) of two standard normal variables with correlation |rho| < 1, to about
/// 1e-15 absolute:  Phi(h) Phi(k) + 1/(2 pi) integral over 0..asin(rho) of
/// exp(-(h^2 + k^2 - 2 h k sin t)/(2 cos^2 t)) dt.  Infinite h or k are allowed.
[[nodiscard]] double bivariate_normal_cdf(double h, double k, double rho);

}  // namespace verstat::models
