#include "models/milling/helical_tooth_load.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <boost/math/special_functions/beta.hpp>

#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::models {
namespace {

using std::numbers::pi;

constexpr double straight_lag = 1e-9;    // below it the teeth count as straight
constexpr double arc_end_slack = 1e-12;  // a tooth at an end of the arc is inside whatever the rounding

double square(double x) {
  return x * x;
}

}  // namespace

SinePowerIntegral::SinePowerIntegral(double p) : p_(p) {
  // Integral of sin^p to phi <= pi/2 = B(sin^2 phi; (p+1)/2, 1/2) / 2.
  const auto exact = [p](double phi) {
    return 0.5 * boost::math::beta(0.5 * (p + 1), 0.5, std::min(1.0, square(std::sin(phi))), MathPolicy());
  };
  half_ = exact(pi / 2);
  std::array<double, terms> values{};
  constexpr auto count = static_cast<double>(terms);
  for (std::size_t k = 0; k < terms; ++k) {
    const double node = std::cos(pi * (static_cast<double>(k) + 0.5) / count);
    const double phi = pi / 2 * std::sqrt(0.5 * (node + 1));
    values[k] = exact(phi) / std::pow(phi, p + 1);
  }
  for (std::size_t j = 0; j < terms; ++j) {
    double sum = 0;
    for (std::size_t k = 0; k < terms; ++k)
      sum += values[k] * std::cos(pi * static_cast<double>(j) * (static_cast<double>(k) + 0.5) / count);
    series_[j] = sum * (j == 0 ? 1 : 2) / count;
  }
}

double SinePowerIntegral::operator()(double phi) const {
  if (phi > pi / 2) return 2 * half_ - (*this)(std::max(0.0, pi - phi));
  if (phi <= 0) return 0;
  const double x = 2 * square(phi / (pi / 2)) - 1;
  double b1 = 0, b2 = 0;
  for (std::size_t j = terms - 1; j > 0; --j) {
    const double b0 = series_[j] + 2 * x * b1 - b2;
    b2 = b1;
    b1 = b0;
  }
  return std::pow(phi, p_ + 1) * (series_[0] + x * b1 - b2);
}

double ToothLoad::at(double psi) const {
  const double pitch = 2 * pi / static_cast<double>(teeth);
  double sum = 0;
  if (lag < straight_lag) {
    for (double j = std::max(0.0, std::ceil((start - psi - arc_end_slack) / pitch));; ++j) {
      const double angle = psi + j * pitch;
      if (angle > exit + arc_end_slack) return sum;
      sum += std::pow(std::max(0.0, std::sin(angle)), integral.power());
    }
  }
  const auto tooth = [&](double j) {
    const double from = std::max(psi + j * pitch - lag, start);
    const double to = std::min(psi + j * pitch, exit);
    return to > from ? integral(to) - integral(from) : 0.0;
  };
  // Teeth j with psi_j - lag < exit; those that span the whole arc need no integral of their own.
  const double first = std::max(0.0, std::ceil((start - psi) / pitch));
  const double last = std::floor((exit + lag - psi) / pitch);
  const double whole_first = std::max(first, std::ceil((exit - psi) / pitch));
  const double whole_last = std::floor((start + lag - psi) / pitch);
  if (whole_last >= whole_first) {
    for (double j = first; j < whole_first; ++j) sum += tooth(j);
    sum += (whole_last - whole_first + 1) * (integral(exit) - integral(start));
    for (double j = whole_last + 1; j <= last; ++j) sum += tooth(j);
  } else {
    for (double j = first; j <= last; ++j) sum += tooth(j);
  }
  return sum / lag;
}

// Slope of the load of helical teeth, times the lag, between two events: leading ends in the arc add the
// force at their angle, trailing ends take it away. Which ends are in the arc does not change between events.
class ToothLoad::Slope {
 public:
  Slope(const ToothLoad& load, double inside) : power_(load.integral.power()) {
    const double pitch = 2 * pi / static_cast<double>(load.teeth);
    const auto in_arc = [&](double angle) { return angle > load.start && angle < load.exit; };
    const double first = std::floor((load.start - inside) / pitch);
    const double last = std::ceil((load.exit + load.lag - inside) / pitch);
    for (double j = std::max(0.0, first); j <= last; ++j) {
      if (in_arc(inside + j * pitch)) leading_.push_back(j * pitch);
      if (in_arc(inside + j * pitch - load.lag)) trailing_.push_back(j * pitch - load.lag);
    }
  }
  [[nodiscard]] bool constant() const { return leading_.empty() && trailing_.empty(); }
  [[nodiscard]] double at(double psi) const {
    double sum = 0;
    for (const double offset : leading_) sum += force(psi + offset);
    for (const double offset : trailing_) sum -= force(psi + offset);
    return sum;
  }

 private:
  [[nodiscard]] double force(double angle) const { return std::pow(std::max(0.0, std::sin(angle)), power_); }
  double power_;
  std::vector<double> leading_;
  std::vector<double> trailing_;
};

double ToothLoad::peak() const {
  const double pitch = 2 * pi / static_cast<double>(teeth);
  std::vector<double> events{0, pitch};
  const auto add = [&](double angle) { events.push_back(angle - pitch * std::floor(angle / pitch)); };
  add(start);
  add(exit);
  if (lag >= straight_lag) {
    add(start + lag);
    add(exit + lag);
  }
  std::sort(events.begin(), events.end());

  double best = 0;
  for (const double event : events) best = std::max(best, at(event));
  for (std::size_t k = 0; k + 1 < events.size(); ++k) {
    if (events[k + 1] - events[k] < 1e-12) continue;
    if (lag < straight_lag) {  // a sum of concave terms: one maximum
      best = std::max(
          best,
          -minimize_unimodal([&](double psi) { return -at(psi); }, events[k], events[k + 1], 1e-7).value);
      continue;
    }
    const Slope slope(*this, (events[k] + events[k + 1]) / 2);
    if (slope.constant()) continue;
    const double length = events[k + 1] - events[k];
    const int cells = length > 0.1 ? 12 : 6;
    double before_psi = events[k];
    double before = slope.at(before_psi);
    for (int i = 1; i <= cells; ++i) {
      const double psi = i == cells ? events[k + 1] : events[k] + length * i / cells;
      const double here = slope.at(psi);
      if (before > 0 && here < 0)
        best = std::max(best, at(find_root([&](double x) { return slope.at(x); }, before_psi, psi, 1e-9)));
      before_psi = psi;
      before = here;
    }
  }
  return best;
}

double ToothLoad::mean() const {
  return static_cast<double>(teeth) / (2 * pi) * (integral(exit) - integral(start));
}

}  // namespace verstat::models
