#include "models/milling/ball_end_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k406::energy {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double mpa_per_kgf_mm2 = 9.80665;
constexpr double golden = 0.6180339887498949;

}  // namespace

Flow flow(double x, double stress_scale) {
  const double fourth_root = std::sqrt(std::sqrt(x));
  return {x, 106.7 * std::sqrt(x) + 13.64, 48.8 * std::sqrt(fourth_root) + 28.586,
          stress_scale * mpa_per_kgf_mm2 * (1.586 / fourth_root + 67.703)};
}

Edge::Edge(double normal_rake, double inclination)
    : normal_rake_(normal_rake),
      inclination_(inclination),
      sin_rake_(std::sin(normal_rake)),
      cos_rake_(std::cos(normal_rake)),
      sin_inclination_(std::sin(inclination)),
      cos_inclination_(std::cos(inclination)) {}

double Edge::sin_effective_rake(double sin_eta, double cos_eta) const {
  return std::clamp(sin_rake_ * cos_inclination_ * cos_eta + sin_eta * sin_inclination_, -1.0, 1.0);
}

Angles Edge::angles(const Flow& state, double eta) const {
  // Without inclination and flow the rake is the normal rake itself, not the arcsine of its sine.
  const double rake = inclination_ == 0 && eta == 0
                          ? normal_rake_
                          : std::asin(sin_effective_rake(std::sin(eta), std::cos(eta)));
  const double shear = state.shear_constant_deg * degree + 0.375 * rake;
  return {rake, shear, state.angle_sum_deg * degree - shear + rake};
}

double Edge::area_factor(double eta, double effective_rake, double shear) const {
  const double cos_effective = std::cos(effective_rake);
  const double along_normal = std::sin(shear) * std::cos(eta) * cos_rake_ / cos_effective;
  const double along_edge =
      -std::cos(shear) * sin_inclination_ +
      std::sin(shear) * (std::sin(eta) - std::sin(effective_rake) * sin_inclination_) / cos_effective;
  return std::sqrt(std::max(0.0, 1 - along_edge * along_edge)) / along_normal;
}

Edge::Power Edge::power(const Flow& state, double eta) const {
  Power p{};
  p.angles = angles(state, eta);
  const auto& [rake, shear, friction] = p.angles;
  p.area_factor = area_factor(eta, rake, shear);
  p.friction_area_factor = p.area_factor * std::sin(friction) / std::cos(state.angle_sum_deg * degree);
  const double slip = std::cos(shear - rake);
  p.shear = state.shear_stress_mpa * p.area_factor * std::cos(rake) / slip;
  p.friction = state.shear_stress_mpa * p.friction_area_factor * std::sin(shear) / slip;
  return p;
}

Edge::Forces Edge::least_power(const Flow& state) const {
  // A left-hand edge is the mirror image of a right-hand one.
  if (inclination_ < 0) {
    Forces mirrored = Edge(normal_rake_, -inclination_).least_power(state);
    mirrored.eta = -mirrored.eta;
    mirrored.k_t = -mirrored.k_t;
    return mirrored;
  }
  constexpr int nodes = 111;  // one degree apart
  constexpr double eta_low = -50;
  const auto total = [&](double eta_deg) { return power(state, eta_deg * degree).total(); };
  int best = 0;
  double best_total = total(eta_low);
  for (int k = 1; k < nodes; ++k)
    if (const double here = total(eta_low + k); here < best_total) {
      best = k;
      best_total = here;
    }
  double low = eta_low + std::max(best - 1, 0);
  double high = eta_low + std::min(best + 1, nodes - 1);
  double a = high - golden * (high - low);
  double b = low + golden * (high - low);
  double at_a = total(a);
  double at_b = total(b);
  while (high - low > 1e-7) {
    if (at_a <= at_b) {
      high = b;
      b = a;
      at_b = at_a;
      a = high - golden * (high - low);
      at_a = total(a);
    } else {
      low = a;
      a = b;
      at_a = at_b;
      b = low + golden * (high - low);
      at_b = total(b);
    }
  }
  const double eta = (low + high) / 2 * degree;
  const Power p = power(state, eta);
  const double sin_eta = std::sin(eta);
  const double cos_eta = std::cos(eta);
  // Eq. (21)-(24) per uncut thickness and edge length, then per chip section t db, db = L cos i.
  const double friction = state.shear_stress_mpa * p.friction_area_factor;
  const double normal =
      (p.total() - friction * std::sin(p.angles.effective_rake)) / (cos_rake_ * cos_inclination_);
  const double third = friction * (sin_eta * cos_inclination_ - sin_rake_ * sin_inclination_ * cos_eta) -
                       normal * cos_rake_ * sin_inclination_;
  const double away = friction * cos_rake_ * cos_eta - normal * sin_rake_;
  const double per_section = 1 / cos_inclination_;
  return {eta,
          p.angles,
          p.total() * per_section,
          third * per_section,
          away * per_section,
          friction * per_section,
          normal * per_section,
          p.angles.friction > 0 && p.angles.shear < 60 * degree && state.angle_sum_deg < 85 &&
              (eta / degree) * (inclination_ / degree) >= -1e-9};
}

}  // namespace verstat::models::k406::energy
