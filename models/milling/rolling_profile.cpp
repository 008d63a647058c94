#include "models/milling/rolling_profile.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <boost/math/quadrature/gauss.hpp>
#include <fmt/format.h>

#include "models/math/policy.h"
#include "models/math/polynomial.h"
#include "models/milling/s2_rolling_generation.h"

namespace verstat::models::s2 {
namespace {

double needed(const std::optional<double>& value, std::string_view name, std::string_view member) {
  if (value) return *value;
  throw DomainError(fmt::format("{}/{}", name, member),
                    fmt::format("{}/{} is missing, an arc needs zc, yc and r", name, member));
}

// Integral of a smooth function by halving until both halves agree with the whole: steps may be as short as
// micrometres, and the integrand is far from singular.
template <class F>
double smooth_integral(const F& f, double low, double high, int depth = 0) {
  using Rule = boost::math::quadrature::gauss<double, 15, MathPolicy>;
  const double middle = 0.5 * (low + high);
  const double whole = Rule::integrate(f, low, high);
  const double halves = Rule::integrate(f, low, middle) + Rule::integrate(f, middle, high);
  if (std::abs(halves - whole) <= 1e-13 * std::abs(halves) || !std::isfinite(halves) || depth >= 12)
    return halves;
  return smooth_integral(f, low, middle, depth + 1) + smooth_integral(f, middle, high, depth + 1);
}

}  // namespace

ProfileSide::ProfileSide(const Profile& profile, std::string_view name)
    : z_min_(profile.z_min), z_max_(profile.z_max) {
  const auto place = [&](std::string_view member) { return fmt::format("{}/{}", name, member); };
  require(z_min_ < z_max_, place("z_min"), z_min_, "must be below z_max");
  switch (profile.kind) {
    case ProfileKind::poly:
      if (profile.coeff.empty())
        throw DomainError(place("coeff"), place("coeff") + " is missing, a polynomial needs coefficients");
      add_piece(0, z_min_, z_max_, profile.coeff);
      break;
    case ProfileKind::arc:
      arc_ = true;
      zc_ = needed(profile.zc, name, "zc");
      yc_ = needed(profile.yc, name, "yc");
      r_ = needed(profile.r, name, "r");
      require(z_min_ > zc_ - r_, place("z_min"), z_min_, "must be above zc - r");
      require(z_max_ < zc_ + r_, place("z_max"), z_max_, "must be below zc + r");
      break;
    case ProfileKind::points:
      if (profile.z.size() < 2) throw DomainError(place("z"), place("z") + " must hold at least two points");
      if (profile.y.size() != profile.z.size())
        throw DomainError(place("y"), fmt::format("{} has {} entries, must have as many as z, {}", place("y"),
                                                  profile.y.size(), profile.z.size()));
      for (std::size_t k = 1; k < profile.z.size(); ++k)
        require(profile.z[k] > profile.z[k - 1], place("z/") + std::to_string(k), profile.z[k],
                "must be above the point before it");
      require(z_min_ >= profile.z.front(), place("z_min"), z_min_, "must not lie outside the points");
      require(z_max_ <= profile.z.back(), place("z_max"), z_max_, "must not lie outside the points");
      add_spline(profile.z, profile.y);
      break;
  }
}

void ProfileSide::add_piece(double origin, double from, double to, std::vector<double> coefficients) {
  std::vector<double> slope = derivative_polynomial(coefficients);
  pieces_.push_back({origin, from, to, std::move(coefficients), std::move(slope)});
}

// Natural cubic spline; second derivatives by the tridiagonal (Thomas) elimination.
void ProfileSide::add_spline(const std::vector<double>& z, const std::vector<double>& y) {
  const std::size_t n = z.size();
  std::vector<double> second(n, 0.0), factor(n, 0.0);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double left = z[k] - z[k - 1], right = z[k + 1] - z[k];
    const double jump = 6 * ((y[k + 1] - y[k]) / right - (y[k] - y[k - 1]) / left);
    const double pivot = 2 * (left + right) - left * factor[k - 1];
    factor[k] = right / pivot;
    second[k] = (jump - left * second[k - 1]) / pivot;
  }
  for (std::size_t k = n - 1; k-- > 1;) second[k] -= factor[k] * second[k + 1];
  second[0] = 0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double from = std::max(z[k], z_min_), to = std::min(z[k + 1], z_max_);
    if (!(from < to)) continue;
    const double h = z[k + 1] - z[k];
    add_piece(z[k], from, to,
              {y[k], (y[k + 1] - y[k]) / h - h * (2 * second[k] + second[k + 1]) / 6, second[k] / 2,
               (second[k + 1] - second[k]) / (6 * h)});
  }
}

const ProfileSide::Piece& ProfileSide::piece_at(double z_mm) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), z_mm,
                                      [](double z, const Piece& piece) { return z < piece.from; });
  return after == pieces_.begin() ? *after : *(after - 1);
}

double ProfileSide::y(double z_mm) const {
  if (arc_) return yc_ + std::sqrt((r_ - (z_mm - zc_)) * (r_ + (z_mm - zc_)));
  const Piece& piece = piece_at(z_mm);
  return evaluate_polynomial(piece.coefficients, z_mm - piece.origin);
}

double ProfileSide::slope(double z_mm) const {
  if (arc_) return -(z_mm - zc_) / std::sqrt((r_ - (z_mm - zc_)) * (r_ + (z_mm - zc_)));
  const Piece& piece = piece_at(z_mm);
  return evaluate_polynomial(piece.slope_coefficients, z_mm - piece.origin);
}

double ProfileSide::arc_length(double from_mm, double to_mm) const {
  if (to_mm < from_mm) return -arc_length(to_mm, from_mm);
  if (arc_) return r_ * (std::asin((to_mm - zc_) / r_) - std::asin((from_mm - zc_) / r_));
  double length_mm = 0;
  for (const Piece& piece : pieces_) {
    const double from = std::max(from_mm, piece.from), to = std::min(to_mm, piece.to);
    if (!(from < to)) continue;
    length_mm += smooth_integral(
        [&](double z) {
          return std::hypot(1.0, evaluate_polynomial(piece.slope_coefficients, z - piece.origin));
        },
        from, to);
  }
  return length_mm;
}

std::optional<double> ProfileSide::nearest_with_slope(double slope, double z_mm) const {
  std::optional<double> nearest;
  const auto offer = [&](double z) {
    // A point computed for an end of the range may miss it by rounding.
    const double inside = std::clamp(z, z_min_, z_max_);
    if (std::abs(z - inside) > 1e-12 * (1 + std::abs(z))) return;
    z = inside;
    if (!nearest || std::abs(z - z_mm) < std::abs(*nearest - z_mm)) nearest = z;
  };
  if (arc_) {
    offer(zc_ - r_ * slope / std::hypot(1.0, slope));
    return nearest;
  }
  for (const Piece& piece : pieces_) {
    std::vector<double> miss = piece.slope_coefficients;
    if (miss.empty()) miss.push_back(0);
    miss[0] -= slope;
    for (const double root : polynomial_roots(miss, piece.from - piece.origin, piece.to - piece.origin))
      offer(root + piece.origin);
  }
  // A straight stretch along the edge: every point of it has the slope, the nearest is z itself.
  if (!nearest && std::abs(std::atan(this->slope(z_mm)) - std::atan(slope)) < 1e-12) nearest = z_mm;
  return nearest;
}

std::optional<double> ProfileSide::last_on_line(double z0_mm, double y0_mm, double slope,
                                                double upper_mm) const {
  const double upper = std::min(upper_mm, z_max_);
  if (!(upper >= z_min_)) return std::nullopt;
  if (arc_) {
    const double secant = std::hypot(1.0, slope);
    const double uz = 1 / secant, uy = slope / secant;
    const double dz = z0_mm - zc_, dy = y0_mm - yc_;
    const double miss_mm = dz * uy - dy * uz;  // distance of the centre from the line
    if (std::abs(miss_mm) > r_) return std::nullopt;
    const double half_chord_mm = std::sqrt((r_ - miss_mm) * (r_ + miss_mm));
    const double along_mm = -(dz * uz + dy * uy);
    for (const double t : {along_mm + half_chord_mm, along_mm - half_chord_mm}) {
      const double z = z0_mm + t * uz;
      if (z >= z_min_ && z <= upper && y0_mm + t * uy >= yc_) return z;
    }
    return std::nullopt;
  }
  for (auto piece = pieces_.rbegin(); piece != pieces_.rend(); ++piece) {
    if (piece->from > upper) continue;
    std::vector<double> miss = piece->coefficients;
    miss.resize(std::max<std::size_t>(miss.size(), 2), 0.0);
    miss[0] -= y0_mm + slope * (piece->origin - z0_mm);
    miss[1] -= slope;
    const std::vector<double> roots =
        polynomial_roots(miss, piece->from - piece->origin, std::min(piece->to, upper) - piece->origin);
    if (!roots.empty()) return roots.back() + piece->origin;
  }
  return std::nullopt;
}

}  // namespace verstat::models::s2
