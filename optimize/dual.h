#pragma once
// Numbers that carry their derivative with respect to one other number: differentiation by the rules of
// calculus, exact to rounding (Wengert 1964). The formulas of the long run are written once, for both kinds.

#include <cmath>

namespace verstat::optimize {

struct Dual {
  double value = 0;
  double slope = 0;

  Dual() = default;
  Dual(double v, double s = 0) : value(v), slope(s) {}  // NOLINT(google-explicit-constructor)

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.slope * b.value + a.value * b.slope};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return {q, (a.slope - q * b.slope) / b.value};
  }
};

inline double value_of(double x) {
  return x;
}
inline double value_of(const Dual& x) {
  return x.value;
}
inline double slope_of(double) {
  return 0;
}
inline double slope_of(const Dual& x) {
  return x.slope;
}

inline double exponential(double x) {
  return std::exp(x);
}
inline Dual exponential(const Dual& x) {
  const double e = std::exp(x.value);
  return {e, e * x.slope};
}
/// ln(1 + x)
inline double log_one_plus(double x) {
  return std::log1p(x);
}
inline Dual log_one_plus(const Dual& x) {
  return {std::log1p(x.value), x.slope / (1 + x.value)};
}

}  // namespace verstat::optimize
