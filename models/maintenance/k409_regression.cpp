// K409, section A: the two-factor regression, from sums and from raw data.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "models/maintenance/k409_repair_service.h"

namespace verstat::models::k409 {
namespace {

// The normal matrix squares the condition of the data: the extra digits of long double keep its solution.
using Row = std::array<long double, 4>;  // three coefficients and the right side

// Pivots below this, relative to rows and columns scaled to 1, are rounding: the matrix is singular.
constexpr long double singular = 1e-14L;

std::array<double, 3> solve_normal(std::array<Row, 3> rows) {
  std::array<long double, 3> column_scale{};
  for (Row& row : rows) {
    const long double scale = std::max({std::abs(row[0]), std::abs(row[1]), std::abs(row[2])});
    if (scale == 0) reject("the normal equations are singular: a row is zero");
    for (long double& x : row) x /= scale;
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (const Row& row : rows) column_scale[j] = std::max(column_scale[j], std::abs(row[j]));
    if (column_scale[j] == 0) reject("the normal equations are singular: a column is zero");
    for (Row& row : rows) row[j] /= column_scale[j];
  }
  std::array<std::size_t, 3> unknown{0, 1, 2};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot_row = k, pivot_column = k;
    for (std::size_t i = k; i < 3; ++i)
      for (std::size_t j = k; j < 3; ++j)
        if (std::abs(rows[i][j]) > std::abs(rows[pivot_row][pivot_column])) {
          pivot_row = i;
          pivot_column = j;
        }
    if (!(std::abs(rows[pivot_row][pivot_column]) > singular))
      reject("the normal equations are singular: 1, x1 and x2 must be linearly independent");
    std::swap(rows[k], rows[pivot_row]);
    std::swap(unknown[k], unknown[pivot_column]);
    for (Row& row : rows) std::swap(row[k], row[pivot_column]);
    for (std::size_t i = k + 1; i < 3; ++i) {
      const long double factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < 4; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  std::array<double, 3> solution{};
  std::array<long double, 3> x{};
  for (std::size_t k = 3; k-- > 0;) {
    long double rest = rows[k][3];
    for (std::size_t j = k + 1; j < 3; ++j) rest -= rows[k][j] * x[j];
    x[k] = rest / rows[k][k];
    solution[unknown[k]] = static_cast<double>(x[k] / column_scale[unknown[k]]);
  }
  return solution;
}

using Column = std::vector<double>;

double mean(const Column& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

Column centred(Column x, double about) {
  for (double& v : x) v -= about;
  return x;
}

double dot(const Column& a, const Column& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

double norm(const Column& a) {
  return std::sqrt(dot(a, a));
}

// a - factor * b
Column minus(Column a, double factor, const Column& b) {
  for (std::size_t k = 0; k < a.size(); ++k) a[k] -= factor * b[k];
  return a;
}

// Part of a column that is left after a constant was taken out; below this it is rounding.
constexpr double dependent = 1e-13;

}  // namespace

WageFund wage_fund_regression(const OutputAndHeadcount& in) {
  return guarded<&wage_fund_regression>(
      in, [&] { return WageFund{949.216 + 0.00325 * in.output + 0.0203 * in.headcount}; });
}

Coefficients regression_from_sums(const NormalSums& in) {
  return guarded<&regression_from_sums>(in, [&] {
    const auto n = static_cast<long double>(in.observations);
    const auto a = solve_normal({Row{n, in.x1, in.x2, in.y}, Row{in.x1, in.x1x1, in.x1x2, in.x1y},
                                 Row{in.x2, in.x1x2, in.x2x2, in.x2y}});
    return Coefficients{a[0], a[1], a[2]};
  });
}

SumsDiagnostics normal_sums_diagnostics(const NormalSums& in) {
  return guarded<&normal_sums_diagnostics>(in, [&] {
    const auto n = static_cast<double>(in.observations);
    const auto about_means = [n](long double ab, long double a, long double b) {
      return static_cast<double>(ab - a * b / static_cast<long double>(n));
    };
    SumsDiagnostics out{.mean_x1 = in.x1 / n,
                        .mean_x2 = in.x2 / n,
                        .mean_y = in.y / n,
                        .s11 = about_means(in.x1x1, in.x1, in.x1),
                        .s22 = about_means(in.x2x2, in.x2, in.x2),
                        .s12 = about_means(in.x1x2, in.x1, in.x2),
                        .r12 = 0,
                        .feasible = false};
    if (out.s11 > 0 && out.s22 > 0) {
      out.r12 = out.s12 / std::sqrt(out.s11) / std::sqrt(out.s22);
      out.feasible = std::abs(out.r12) <= 1 + 1e-9;
    }
    return out;
  });
}

TwoFactorFit ols_two_factor(const TwoFactorData& in) {
  return guarded<&ols_two_factor>(in, [&] {
    const auto size = [](const Column& x) { return static_cast<std::int64_t>(x.size()); };
    require(in.x2.size() == in.x1.size(), "x2", size(in.x2), "entries: must be as many as of x1");
    require(in.y.size() == in.x1.size(), "y", size(in.y), "entries: must be as many as of x1");
    if (std::ranges::min(in.y) == std::ranges::max(in.y))
      reject("y is constant: there is nothing to explain");
    const double m1 = mean(in.x1), m2 = mean(in.x2), my = mean(in.y);
    require(my != 0, "y", my, "is its mean: must not be zero, the elasticities are taken there");

    // QR of [1 x1 x2]: the column of ones is taken out by centring, x1 out of x2 by Gram-Schmidt.
    const Column c1 = centred(in.x1, m1);
    const Column c2 = centred(in.x2, m2);
    const Column cy = centred(in.y, my);
    const double n1 = norm(c1), n2 = norm(c2);
    if (!(n1 > dependent * norm(in.x1))) reject("x1 is constant: 1, x1 and x2 are linearly dependent");
    if (!(n2 > dependent * norm(in.x2))) reject("x2 is constant: 1, x1 and x2 are linearly dependent");
    Column q1 = c1;
    for (double& v : q1) v /= n1;
    const double along = dot(q1, c2);
    Column q2 = minus(c2, along, q1);
    const double across = norm(q2);
    const double sine = across / n2;  // 1 - r12^2 = sine^2
    if (!(sine > dependent)) reject("x2 follows x1: 1, x1 and x2 are linearly dependent");
    for (double& v : q2) v /= across;

    const double y1 = dot(q1, cy);
    const Column without_1 = minus(cy, y1, q1);
    const double y2 = dot(q2, without_1);
    const Column residual = minus(without_1, y2, q2);
    const double a2 = y2 / across;
    const double a1 = (y1 - along * a2) / n1;
    const double sse = dot(residual, residual);
    const double s = std::sqrt(sse / static_cast<double>(in.y.size() - 3));
    return TwoFactorFit{.a0 = my - a1 * m1 - a2 * m2,
                        .a1 = a1,
                        .a2 = a2,
                        .r_squared = 1 - sse / dot(cy, cy),
                        .vif = 1 / (sine * sine),
                        .se_a1 = s / (n1 * sine),
                        .se_a2 = s / across,
                        .elasticity_x1 = a1 * m1 / my,
                        .elasticity_x2 = a2 * m2 / my};
  });
}

Elasticity elasticity(const SlopeAndMeans& in) {
  return guarded<&elasticity>(in, [&] {
    require(in.y_mean != 0, "y_mean", in.y_mean, "must not be zero");
    return Elasticity{in.slope * in.x_mean / in.y_mean};
  });
}

}  // namespace verstat::models::k409
