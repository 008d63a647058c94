#include "models/thermal/wedge_conduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/catalogue/error.h"
#include "models/math/gauss_legendre.h"
#include "models/math/solve.h"

namespace verstat::models::thermal {
namespace {

// 1/distance integrated over two parallel lines of the length b, a distance d apart:
// 2 (b arsinh(b/d) - sqrt(b^2 + d^2) + d), written without the cancellation at d >> b.
double line_interaction(double b, double d) {
  const double diagonal = std::sqrt(b * b + d * d);
  const double x = b / d;
  // arsinh(x); the plain logarithm would lose digits of a small x.
  const double arsinh = x > 0.1 ? std::log(x + diagonal / d) : std::asinh(x);
  return 2 * (b * arsinh - b * b / (d + diagonal));
}

// J(0) of a rectangle on itself: the pairs depend on their distance u alone; u = l x^2 tames the logarithm.
double self_interaction(double b, double l) {
  double sum = 0;
  for (const GaussPoint& p : gauss_legendre_24()) {
    const double u = l * p.x * p.x;
    sum += p.weight * 2 * l * p.x * (l - u) * line_interaction(b, u);
  }
  return sum / (std::numbers::pi * b * l);
}

// J(psi): uniform unit source on source_length x b, mean over observer_length x b, planes at the angle psi.
// The planes meet at the edge, where the distance vanishes in proportion to the distances from it: x^2 tames
// the logarithm there.
double interaction(double psi, double b, double source_length, double observer_length) {
  const double twice_cos = 2 * std::cos(psi);
  double sum = 0;
  if (source_length == observer_length) {
    // Of the square only the triangle s <= r counts, twice: r = l x^2, s = v r, so that the distance is r
    // times a smooth function of v and few points do. To 3e-7 of the result for every wedge of 60 to 180 deg.
    static const std::vector<GaussPoint> along = gauss_legendre(12);
    static const std::vector<GaussPoint> across = gauss_legendre(8);
    const double l = source_length;
    for (const GaussPoint& q : across) {
      const double slope = std::sqrt(1 + q.x * q.x - q.x * twice_cos);
      double inner = 0;
      for (const GaussPoint& p : along) {
        const double r = l * p.x * p.x;
        inner += p.weight * 2 * l * p.x * r * line_interaction(b, r * slope);
      }
      sum += q.weight * inner;
    }
    return sum / (std::numbers::pi * b * l);
  }
  static const std::vector<GaussPoint> rule = gauss_legendre(18);
  for (const GaussPoint& p : rule) {
    const double r = source_length * p.x * p.x;
    double inner = 0;
    for (const GaussPoint& q : rule) {
      const double s = observer_length * q.x * q.x;
      const double d = std::sqrt(std::max(0.0, r * r + s * s - r * s * twice_cos));
      inner += q.weight * 2 * observer_length * q.x * line_interaction(b, d);
    }
    sum += p.weight * 2 * source_length * p.x * inner;
  }
  return sum / (2 * std::numbers::pi * b * observer_length);
}

// erf(x) - (1 - exp(-x^2)) / (x sqrt(pi)), x > 0; x/sqrt(pi) for small x.
double mean_response(double x) {
  return std::erf(x) + std::expm1(-x * x) / x * std::numbers::inv_sqrtpi;
}

}  // namespace

WedgeRises wedge_rises(int parts, double b, double l, double h) {
  const double beta = std::numbers::pi / parts;
  // Image k stands at 2 k beta from its own face, at (2k-1) beta from the other; angles psi and 2 pi - psi
  // give the same, so half of them are computed and counted twice.
  const auto folded = [&](double psi) { return psi <= std::numbers::pi ? psi : 2 * std::numbers::pi - psi; };
  const auto own_face = [&](double length) {
    double sum = self_interaction(b, length);
    for (int k = 1; 2 * k <= parts; ++k)
      sum += (2 * k == parts ? 1 : 2) * interaction(folded(2 * k * beta), b, length, length);
    return sum / length;
  };
  WedgeRises rises{own_face(l), 0, 0};
  if (h > 0) {
    rises.m2 = own_face(h);
    for (int k = 0; k < parts; ++k) {
      const int odd = 2 * k - 1;
      // -beta and beta, 3 beta and -3 beta ... come in pairs; pi stands alone when `parts` is odd.
      if (odd < 0 || odd > parts) continue;
      rises.n += (odd == parts ? 1 : 2) * interaction(odd * beta, b, l, h);
    }
    rises.n /= l;
  }
  return rises;
}

WedgeRises wedge_rises_at(double beta_deg, double b, double l, double h) {
  const WedgeRises right = wedge_rises(2, b, l, h);
  if (beta_deg == 90) return right;
  const WedgeRises sharp = wedge_rises(3, b, l, h);
  const double share = std::log(beta_deg / 90) / std::log(60.0 / 90);
  const auto between = [&](double at_90, double at_60) {
    return at_90 == 0 ? 0 : at_90 * std::pow(at_60 / at_90, share);
  };
  return {between(right.m1, sharp.m1), between(right.m2, sharp.m2), between(right.n, sharp.n)};
}

WedgeWarmUp::WedgeWarmUp(double eta) : eta_(eta), last_(1e3 * std::max(1.0, eta)), steady_(0) {
  double low = 0;
  double high = 0.125;
  double sum = 0;
  while (low < last_) {
    const double end = std::min(high, last_);
    sum += integrate_gauss([&](double u) { return integrand(u); }, low, end, gauss_legendre_24());
    ends_.push_back(end);
    sums_.push_back(sum);
    low = end;
    high *= 2;
  }
  steady_ = sum + eta_ * std::pow(std::numbers::pi, -1.5) / last_;
}

double WedgeWarmUp::integrand(double u) const {
  return 2 * std::numbers::inv_sqrtpi * mean_response(1 / u) * mean_response(eta_ / (2 * u));
}

double WedgeWarmUp::at(double fo) const {
  if (!(fo > 0)) return 0;
  const double root = std::sqrt(fo);
  // Beyond the panels the rest of the integral is its leading term.
  if (root >= last_) return 1 - eta_ * std::pow(std::numbers::pi, -1.5) / (root * steady_);
  const auto panel =
      static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), root) - ends_.begin());
  const double low = panel == 0 ? 0 : ends_[panel - 1];
  const double before = panel == 0 ? 0 : sums_[panel - 1];
  const double part = integrate_gauss([&](double u) { return integrand(u); }, low, root, gauss_legendre_24());
  return std::min(1.0, (before + part) / steady_);
}

double WedgeWarmUp::fo_for(double share) const {
  constexpr double low = -80;  // ln Fo
  constexpr double high = 80;
  if (!(share < at(std::exp(high)))) reject("the steady state is approached too slowly to be told apart");
  if (share <= at(std::exp(low))) return std::exp(low);
  return std::exp(find_root([&](double x) { return at(std::exp(x)) - share; }, low, high));
}

}  // namespace verstat::models::thermal
