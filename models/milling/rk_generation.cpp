#include "models/milling/rk_generation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/math/bracketed.h"
#include "models/milling/s3_rk_profile_cutter.h"

namespace verstat::models::s3 {
namespace {

using std::numbers::pi;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double angle_tol = 1e-14;
constexpr double scan_step = 0.25 * pi / 180;  // of the paper's algorithm, beyond the limits

}  // namespace

void require_convex(const RkHole& hole) {
  const auto n = static_cast<double>(hole.lobes);
  require(hole.mean_radius_mm > (n * n - 1) * hole.eccentricity_mm, "eccentricity_mm", hole.eccentricity_mm,
          "must be below mean_radius_mm / (lobes^2 - 1): the profile would not be convex");
}

double RkGeneration::max_cutter_radius_mm(const RkHole& hole) {
  const auto n = static_cast<double>(hole.lobes);
  const double m_mm = (n - 1) * hole.eccentricity_mm;
  const double p_mm = hole.mean_radius_mm - (n - 1) * m_mm;
  return 0.5 * (p_mm + std::sqrt((p_mm - 2 * m_mm) * (p_mm + 2 * m_mm)));
}

double RkGeneration::min_cutter_radius_mm(const RkHole& hole) {
  return hole.eccentricity_mm +
         (hole.mean_radius_mm - hole.eccentricity_mm) / static_cast<double>(hole.lobes);
}

RkGeneration::RkGeneration(const RkCutter& in)
    : r_mm_(in.mean_radius_mm),
      e_mm_(in.eccentricity_mm),
      n_(static_cast<double>(in.lobes)),
      a_mm_(in.mean_radius_mm - in.cutter_radius_mm),
      grows_(true) {
  require_convex(in);
  require(in.cutter_radius_mm < r_mm_, "cutter_radius_mm", in.cutter_radius_mm,
          "must be below mean_radius_mm");
  require(a_mm_ > (n_ - 1) * e_mm_, "cutter_radius_mm", in.cutter_radius_mm,
          "must be below mean_radius_mm - (lobes - 1) eccentricity_mm: the normals miss the pitch circle");
  const double max_mm = max_cutter_radius_mm(in);
  grows_ = in.cutter_radius_mm <= max_mm && in.cutter_radius_mm >= min_cutter_radius_mm(in);
  if (in.cutter_radius_mm <= max_mm) return;
  constexpr int cells = 128;
  const auto slope = [&](double t) { return tooth_angle_slope(t); };
  for (int k = 0; k < cells; ++k) {
    const double low = pi / n_ * k / cells;
    const double high = pi / n_ * (k + 1) / cells;
    const double slope_low = slope(low), slope_high = slope(high);
    if ((slope_low < 0) != (slope_high < 0))
      turn_backs_.push_back(bracketed_root(slope, low, high, slope_low, slope_high, angle_tol));
  }
}

double RkGeneration::lead(double t) const {
  return -std::asin((n_ - 1) * e_mm_ * std::sin(n_ * t) / a_mm_);
}

// In the frame of the normal the cutter point is (h - a cos lead, h'/N) from the cutter's centre.
double RkGeneration::tooth_angle(double t) const {
  const double beta = lead(t);
  const double u_mm = r_mm_ + e_mm_ * std::cos(n_ * t) - a_mm_ * std::cos(beta);
  const double w_mm = -e_mm_ * std::sin(n_ * t);
  return n_ * t + std::remainder((n_ - 1) * beta + std::atan2(w_mm, u_mm), 2 * pi);
}

double RkGeneration::tooth_radius_mm(double t) const {
  return std::hypot(r_mm_ + e_mm_ * std::cos(n_ * t) - a_mm_ * std::cos(lead(t)), e_mm_ * std::sin(n_ * t));
}

double RkGeneration::pitch_arm_mm(double t) const {
  const double pitch_radius_mm = n_ * a_mm_ / (n_ - 1);
  return std::abs(r_mm_ + e_mm_ * std::cos(n_ * t) - pitch_radius_mm * std::cos(lead(t)));
}

double RkGeneration::tooth_angle_slope(double t) const {
  const double c = std::cos(n_ * t), s = std::sin(n_ * t);
  const double beta = lead(t);
  const double beta_slope = -(n_ - 1) * n_ * e_mm_ * c / (a_mm_ * std::cos(beta));
  const double u_mm = r_mm_ + e_mm_ * c - a_mm_ * std::cos(beta);
  const double u_slope = -n_ * e_mm_ * s + a_mm_ * std::sin(beta) * beta_slope;
  const double w_mm = -e_mm_ * s;
  const double w_slope = -n_ * e_mm_ * c;
  return n_ + (n_ - 1) * beta_slope + (u_mm * w_slope - w_mm * u_slope) / (u_mm * u_mm + w_mm * w_mm);
}

double RkGeneration::parameter(double theta) const {
  const double turns = std::round(theta / (2 * pi));
  const double target = theta - 2 * pi * turns;
  const double centre = target / n_;
  double t = std::numeric_limits<double>::quiet_NaN();
  const auto miss = [&](double x) { return tooth_angle(x) - target; };
  if (turn_backs_.empty()) {
    // One root, in the same half lobe as theta/N.
    t = newton_increasing(
        [&](double x) {
          return std::pair{miss(x), tooth_angle_slope(x)};
        },
        centre - pi / n_, centre + pi / n_, centre, angle_tol);
    if (!(std::abs(miss(t)) < 1e-9)) t = std::numeric_limits<double>::quiet_NaN();
  } else {
    const double low = centre - 0.9 * pi / n_;
    const double high = centre + 0.9 * pi / n_;
    std::vector<double> ends{low, high};
    for (const double b : turn_backs_)
      for (const double end : {b, -b, 2 * pi / n_ - b, b - 2 * pi / n_})
        if (end > low && end < high) ends.push_back(end);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double miss_low = miss(ends[k]), miss_high = miss(ends[k + 1]);
      if (miss_low != 0 && miss_high != 0 && (miss_low < 0) == (miss_high < 0)) continue;
      const double root = bracketed_root(miss, ends[k], ends[k + 1], miss_low, miss_high, angle_tol);
      if (std::abs(miss(root)) < 1e-9 && !(std::abs(root - centre) >= std::abs(t - centre))) t = root;
    }
  }
  if (std::isnan(t)) reject("no profile point is cut by a tooth at this angle: the cutter is too small");
  return t + 2 * pi * turns / n_;
}

double RkGeneration::track_polar(const Tooth& tooth, double psi) const {
  return (tooth.theta - psi) / n_ +
         std::atan2(tooth.radius_mm * std::sin(psi), a_mm_ + tooth.radius_mm * std::cos(psi));
}

double RkGeneration::track_radius_mm(const Tooth& tooth, double psi) const {
  return std::hypot(a_mm_ + tooth.radius_mm * std::cos(psi), tooth.radius_mm * std::sin(psi));
}

Tooth RkGeneration::tooth(double theta) const {
  Tooth made{};
  made.theta = theta;
  made.t = parameter(theta);
  made.radius_mm = tooth_radius_mm(made.t);
  made.psi = std::remainder(theta - n_ * (made.t + lead(made.t)), 2 * pi);
  made.polar =
      made.t + std::atan2(-n_ * e_mm_ * std::sin(n_ * made.t), r_mm_ + e_mm_ * std::cos(n_ * made.t));
  // The polar angle grows with psi while (N - 2) a rho cos psi > a^2 - (N - 1) rho^2.
  const double rho_mm = made.radius_mm;
  const double left = (n_ - 2) * a_mm_ * rho_mm;
  const double right = a_mm_ * a_mm_ - (n_ - 1) * rho_mm * rho_mm;
  if (n_ == 2)
    made.psi_max = rho_mm > a_mm_ ? pi : -1;
  else if (right <= -left)
    made.psi_max = pi;
  else
    made.psi_max = right >= left ? -1 : std::acos(right / left);
  return made;
}

double RkGeneration::psi_at(const Tooth& tooth, double polar, double start) const {
  const double rho_mm = tooth.radius_mm;
  return newton_increasing(
      [&](double psi) {
        const double x_mm = a_mm_ + rho_mm * std::cos(psi), y_mm = rho_mm * std::sin(psi);
        const double slope =
            -1 / n_ + rho_mm * (rho_mm + a_mm_ * std::cos(psi)) / (x_mm * x_mm + y_mm * y_mm);
        return std::pair{(tooth.theta - psi) / n_ + std::atan2(y_mm, x_mm) - polar, slope};
      },
      -tooth.psi_max, tooth.psi_max, start, angle_tol);
}

double RkGeneration::profile_radius_mm(double polar) const {
  const double t = newton_increasing(
      [&](double x) {
        const double h_mm = r_mm_ + e_mm_ * std::cos(n_ * x);
        const double dh_mm = -n_ * e_mm_ * std::sin(n_ * x);
        const double rho_mm = r_mm_ - (n_ * n_ - 1) * e_mm_ * std::cos(n_ * x);
        return std::pair{x + std::atan2(dh_mm, h_mm) - polar, h_mm * rho_mm / (h_mm * h_mm + dh_mm * dh_mm)};
      },
      polar - pi / 2, polar + pi / 2, polar, angle_tol);
  return std::hypot(r_mm_ + e_mm_ * std::cos(n_ * t), n_ * e_mm_ * std::sin(n_ * t));
}

Cusp RkGeneration::cusp(const Tooth& first, const Tooth& second) const {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto contact = [&](const Tooth& tooth) {
    const double h_mm = r_mm_ + e_mm_ * std::cos(n_ * tooth.t);
    const double dh_mm = -n_ * e_mm_ * std::sin(n_ * tooth.t);
    return std::pair{h_mm * std::cos(tooth.t) - dh_mm * std::sin(tooth.t),
                     h_mm * std::sin(tooth.t) + dh_mm * std::cos(tooth.t)};
  };
  const auto [x1_mm, y1_mm] = contact(first);
  const auto [x2_mm, y2_mm] = contact(second);
  Cusp out{infinite, none, std::hypot(x2_mm - x1_mm, y2_mm - y1_mm)};
  if (std::abs(first.psi) >= first.psi_max || std::abs(second.psi) >= second.psi_max) return out;

  const double low = std::max(first.polar, track_polar(second, -second.psi_max));
  const double high = std::min(second.polar, track_polar(first, first.psi_max));
  const bool whole = low == first.polar && high == second.polar;
  if (!(low < high)) {
    // Contacts in reverse order (above the undercut limit): one tooth cuts away the other's.
    if (first.polar >= second.polar) out.height_mm = 0;
    return out;
  }
  // The tracks fall from their contacts towards each other; x from the low end keeps the root off zero.
  double psi1 = first.psi, psi2 = second.psi;
  const auto gap_mm = [&](double x) {
    psi1 = psi_at(first, low + x, psi1);
    psi2 = psi_at(second, low + x, psi2);
    return track_radius_mm(first, psi1) - track_radius_mm(second, psi2);
  };
  const double gap_low_mm = gap_mm(0), gap_high_mm = gap_mm(high - low);
  if (gap_low_mm != 0 && gap_high_mm != 0 && (gap_low_mm < 0) == (gap_high_mm < 0)) {
    if (whole) out.height_mm = 0;
    return out;
  }
  out.polar = low + bracketed_root(gap_mm, 0, high - low, gap_low_mm, gap_high_mm, angle_tol);
  out.height_mm = profile_radius_mm(out.polar) - track_radius_mm(first, psi_at(first, out.polar, psi1));
  return out;
}

double RkGeneration::pitch_reaching(const Tooth& from, double tolerance_mm, double guess) const {
  return grows_ ? pitch_by_growth(from, tolerance_mm, guess) : pitch_by_scan(from, tolerance_mm);
}

// Between the limits of the cutter radius the only crossing of the tolerance is the first.
double RkGeneration::pitch_by_growth(const Tooth& from, double tolerance_mm, double guess) const {
  const auto excess = [&](double pitch) {
    const double height_mm = cusp(from, tooth(from.theta + pitch)).height_mm;
    // The root of the height is nearly straight in the pitch.
    return std::isinf(height_mm) ? infinite : std::sqrt(std::max(height_mm, 0.0)) - std::sqrt(tolerance_mm);
  };
  double low = 0, excess_low = -std::sqrt(tolerance_mm);
  double high = std::min(guess, 2 * pi), excess_high = excess(high);
  while (excess_high < 0) {
    if (high >= 2 * pi) return 2 * pi;
    low = high;
    excess_low = excess_high;
    high = std::min(1.5 * high, 2 * pi);
    excess_high = excess(high);
  }
  while (std::isinf(excess_high)) {
    const double middle = 0.5 * (low + high);
    if (high - low < angle_tol * 10) return high;
    const double excess_middle = excess(middle);
    if (excess_middle < 0) {
      low = middle;
      excess_low = excess_middle;
    } else {
      high = middle;
      excess_high = excess_middle;
    }
  }
  return bracketed_root([&](double pitch) { return std::min(excess(pitch), 1e6); }, low, high, excess_low,
                        excess_high, angle_tol);
}

double RkGeneration::pitch_by_scan(const Tooth& from, double tolerance_mm) const {
  const auto excess = [&](double pitch) {
    return std::min(cusp(from, tooth(from.theta + pitch)).height_mm - tolerance_mm, 1e6);
  };
  double low = 0, excess_low = -tolerance_mm;
  for (int k = 1; k <= 1440; ++k) {
    const double high = k * scan_step;
    const double excess_high = excess(high);
    if (excess_high >= 0) return bracketed_root(excess, low, high, excess_low, excess_high, angle_tol);
    low = high;
    excess_low = excess_high;
  }
  return 2 * pi;
}

}  // namespace verstat::models::s3
