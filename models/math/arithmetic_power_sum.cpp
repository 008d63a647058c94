#include "models/math/arithmetic_power_sum.h"

#include <algorithm>
#include <cmath>

namespace verstat::models {
namespace {

constexpr double direct_terms = 16;

// Terms of the Euler-Maclaurin correction at t for the function t^p: the odd derivatives weighted with
// B_2k / (2k)!.
double derivative_terms(double t, double p) {
  constexpr double weights[] = {1.0 / 12,           -1.0 / 720,     1.0 / 30240,
                                -1.0 / 1209600,     1.0 / 47900160, -691.0 / 1307674368000.0,
                                1.0 / 74724249600.0};
  double derivative = p * std::pow(t, p - 1);
  double sum = 0;
  double order = 1;
  for (const double weight : weights) {
    sum += weight * derivative;
    derivative *= (p - order) * (p - order - 1) / (t * t);
    order += 2;
  }
  return sum;
}

}  // namespace

double arithmetic_power_sum(double u, double step, std::int64_t terms, double p) {
  if (!(u > 0) || terms <= 0) return 0;
  const double all = static_cast<double>(terms);
  if (step <= 0 || u / step > 1e15 * all) return all * std::pow(u, p);
  // In units of the step: x, x-1, ..., down to the last positive one.
  const double x = u / step;
  const double count = std::min(all, std::ceil(x));
  const double last = x - (count - 1);  // smallest term
  double sum = 0;
  const double direct = std::min(count, direct_terms);
  for (double j = 0; j < direct; ++j) sum += std::pow(last + j, p);
  if (count > direct) {
    const double from = last + direct;
    const double to = x;
    const double integral =
        p == -1 ? std::log(to / from) : (std::pow(to, p + 1) - std::pow(from, p + 1)) / (p + 1);
    sum += integral + (std::pow(from, p) + std::pow(to, p)) / 2 + derivative_terms(to, p) -
           derivative_terms(from, p);
  }
  return std::pow(step, p) * sum;
}

}  // namespace verstat::models
