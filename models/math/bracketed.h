#pragma once
// Roots of one variable inside a bracket, as templates: model formulas call them thousands of times per
// evaluation, where the call through std::function of solve.h would cost more than the formula.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "models/catalogue/error.h"

namespace verstat::models {

/// Point between `low` and `high` where `f` changes sign, to `abs_tol` (absolute; a few ulp at least).
/// `f_low` = f(low) and `f_high` = f(high) must differ in sign or one be zero, else DomainError.
/// `f` need not be continuous: then the point is a jump. Inverse quadratic steps where they are safe, else
/// bisection (Chandrupatla, Adv. Eng. Software 28 (1997) 145-149).
template <class F>
[[nodiscard]] double bracketed_root(F&& f, double low, double high, double f_low, double f_high,
                                    double abs_tol) {
  if (f_low == 0) return low;
  if (f_high == 0) return high;
  if ((f_low < 0) == (f_high < 0)) reject("no root: the function does not change sign in the bracket");
  double a = high, fa = f_high;
  double b = low, fb = f_low;
  double c = high, fc = f_high;
  double t = std::clamp(fa / (fa - fb), 0.05, 0.95);  // the chord first
  for (int step = 0; step < 400; ++step) {
    const double x = a + t * (b - a);
    const double fx = f(x);
    if ((fx < 0) == (fa < 0)) {
      c = a;
      fc = fa;
    } else {
      c = b;
      fc = fb;
      b = a;
      fb = fa;
    }
    a = x;
    fa = fx;
    const double best = std::abs(fa) < std::abs(fb) ? a : b;
    const double tolerance = abs_tol + 2 * std::numeric_limits<double>::epsilon() * std::abs(best);
    const double least = tolerance / std::abs(b - a);
    if (least > 0.5 || fa == 0) return fa == 0 ? a : best;
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
    else
      t = 0.5;
    t = std::clamp(t, least, 1 - least);
  }
  reject("a root search in a bracket did not converge");
}

template <class F>
[[nodiscard]] double bracketed_root(F&& f, double low, double high, double abs_tol) {
  return bracketed_root(f, low, high, f(low), f(high), abs_tol);
}

/// Root of a function that increases over [low, high]; `f` returns {value, derivative}. Newton steps from
/// `start`, bisection where a step would leave the bracket. A function that has no zero inside gives the end
/// nearest to it. Accurate to `abs_tol`.
template <class F>
[[nodiscard]] double newton_increasing(F&& f, double low, double high, double start, double abs_tol) {
  double x = std::clamp(start, low, high);
  for (int step = 0; step < 200; ++step) {
    const auto [value, derivative] = f(x);
    if (value == 0) return x;
    (value < 0 ? low : high) = x;
    double next = x - value / derivative;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double moved = std::abs(next - x);
    x = next;
    if (moved <= abs_tol + 2 * std::numeric_limits<double>::epsilon() * std::abs(x)) return x;
  }
  return x;
}

}  // namespace verstat::models
