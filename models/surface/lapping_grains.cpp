#include "models/surface/lapping_grains.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::models::k311::grains {
namespace {

// Over a panel of the bell, at most five sigmas wide, and over a panel of the profile.
using Bell = boost::math::quadrature::gauss<double, 15, MathPolicy>;
using Gauss = boost::math::quadrature::gauss<double, 20, MathPolicy>;
constexpr double most_scratches = 40;  // beyond, P < 5e-18: nothing is left

}  // namespace

TruncatedNormal::TruncatedNormal(const DepthLaw& law)
    : mean_um_(law.mean_um), sd_um_(law.sd_um), greatest_um_(law.greatest_um), scale_per_um_(0) {
  // Mirrored when the mean lies below the range, so that the difference of two tails keeps its digits.
  double low = -mean_um_ / sd_um_;
  double high = (greatest_um_ - mean_um_) / sd_um_;
  if (low + high < 0) {
    const double mirrored = -low;
    low = -high;
    high = mirrored;
  }
  const double mass = 0.5 * (std::erfc(low / std::numbers::sqrt2) - std::erfc(high / std::numbers::sqrt2));
  if (!(mass > 1e-290))
    reject("no grain penetrates 0..t_f: the mean depth m is too many sigma away from this range");
  scale_per_um_ = 1 / (std::sqrt(2 * std::numbers::pi) * sd_um_ * mass);
}

double TruncatedNormal::density(double depth_um) const {
  if (depth_um < 0 || depth_um > greatest_um_) return 0;
  const double z = (depth_um - mean_um_) / sd_um_;
  return scale_per_um_ * std::exp(-0.5 * z * z);
}

template <class G>
double TruncatedNormal::expectation_above(double level_um, double reach_um, G&& g) const {
  if (!(reach_um > 0)) return 0;
  const double mode = std::clamp(mean_um_ - level_um, 0.0, reach_um);
  const double away = mean_um_ - level_um - mode;
  const double width = std::hypot(away, std::sqrt(80.0) * sd_um_);
  const double low = std::max(0.0, mean_um_ - level_um - width);
  const double high = std::min(reach_um, mean_um_ - level_um + width);
  double sum = 0;
  // Two panels on either side of the mode: 15 points each hold the bell to 1e-12.
  const auto side = [&](double from, double to) {
    if (!(to > from)) return;
    const double middle = 0.5 * (from + to);
    sum += g(from, middle) + g(middle, to);
  };
  side(low, mode);
  side(mode, high);
  return sum;
}

double mean_half_chord_um(const TruncatedNormal& law, double below_deepest_um, double grain_um) {
  // z = a - y = d sin^2(phi) takes the square roots out of both ends of the chord.
  const double level_um = law.greatest() - below_deepest_um;
  // A grain that sinks in by less than half of itself is far from the second root: s = sin(phi) itself
  // serves, without a sine at every point.
  return law.expectation_above(level_um, below_deepest_um, [&](double from, double to) {
    const auto density = [&](double s) {
      return law.density(std::min(level_um + grain_um * s * s, law.greatest()));
    };
    if (to < 0.5 * grain_um)
      return Bell::integrate(
          [&](double s) { return 2 * grain_um * grain_um * s * s * std::sqrt(1 - s * s) * density(s); },
          std::sqrt(from / grain_um), std::sqrt(to / grain_um));
    const auto angle = [&](double z) { return std::asin(std::sqrt(std::min(z / grain_um, 1.0))); };
    return Bell::integrate(
        [&](double phi) {
          const double s = std::sin(phi);
          return 2 * grain_um * grain_um * s * s * (1 - s * s) * density(s);
        },
        angle(from), angle(to));
  });
}

double mean_cap_um2(const TruncatedNormal& law, double grain_um) {
  return law.expectation_above(0, law.greatest(), [&](double from, double to) {
    return Bell::integrate([&](double a) { return a * (grain_um - a) * law.density(a); }, from, to);
  });
}

double sweep_per_um(const GrainContact& contact) {
  const double speed_um_s = contact.speed_m_min * 1e6 / 60;
  return contact.shape_factor * speed_um_s * contact.time_s / (contact.spacing_um * contact.spacing_um);
}

LappedRoughness roughness(const GrainContact& contact) {
  const TruncatedNormal law(contact);
  const double greatest = contact.greatest_um;
  const double sweep = sweep_per_um(contact);
  // Levels are counted from the deepest point upwards, w = t_f - y = v^2: a long contact squeezes the whole
  // profile into a thin layer there, and scratches grow with w^1.5.
  const auto scratches = [&](double v) { return sweep * mean_half_chord_um(law, v * v, contact.grain_um); };
  const double top = std::sqrt(greatest);
  const double at_top = scratches(top);
  // Panels end where the mean number of scratches passes these marks and where the bell bends, so that every
  // panel is smooth at its own scale.
  std::vector<double> cuts{0, top};
  const bool cleared = at_top > most_scratches;
  for (const double mark : {most_scratches, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.2, 0.05, 1e-3})
    if (at_top > mark) cuts.push_back(find_root([&](double v) { return scratches(v) - mark; }, 0, top, 1e-9));
  const double cleared_from = cleared ? cuts[2] : top;
  for (const double sigmas : {-8.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 8.0})
    if (const double w = greatest - (contact.mean_um + sigmas * contact.sd_um); w > 0 && w < greatest)
      cuts.push_back(std::sqrt(w));
  std::sort(cuts.begin(), cuts.end());

  // Removal: mean of 1 - P over y.
  double removal = cleared ? greatest - cleared_from * cleared_from : 0;
  for (std::size_t k = 0; k + 1 < cuts.size() && cuts[k] < cleared_from; ++k)
    removal +=
        Gauss::integrate([&](double v) { return -2 * v * std::expm1(-scratches(v)); }, cuts[k], cuts[k + 1]);
  // Ra: twice the area of P above the mean line, between the mean line and the cleared layer.
  const double mean_line = std::sqrt(std::max(0.0, greatest - removal));
  double peaks = 0;
  for (std::size_t k = 0; k + 1 < cuts.size() && cuts[k] < cleared_from; ++k)
    if (cuts[k + 1] > mean_line)
      peaks += Gauss::integrate([&](double v) { return 2 * v * std::exp(-scratches(v)); },
                                std::max(cuts[k], mean_line), cuts[k + 1]);
  const double ra = 2 * peaks;
  return {removal, ra, 6 * ra};
}

}  // namespace verstat::models::k311::grains
