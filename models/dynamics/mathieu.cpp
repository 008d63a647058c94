#include "models/dynamics/mathieu.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace verstat::models {
namespace {

// Eigenvalue number `index` (ascending from 0) of the symmetric tridiagonal matrix.
double tridiagonal_eigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside, int index) {
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal, beside, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()(index);
}

}  // namespace

MathieuStability mathieu_stability(double a, double b) {
  const int steps = std::abs(a) + 2 * std::abs(b) <= 25 ? 400 : 2000;
  const double h = std::numbers::pi / steps;
  // Both fundamental solutions side by side: (1, 0) and (0, 1).
  double y[2] = {1, 0};
  double v[2] = {0, 1};
  double start = -(a + 2 * b);
  for (int n = 0; n < steps; ++n) {
    const double middle = -(a + 2 * b * std::cos(2 * (n + 0.5) * h));
    const double end = -(a + 2 * b * std::cos(2 * (n + 1) * h));
    for (int s = 0; s < 2; ++s) {
      const double k1v = start * y[s];
      const double k1y = v[s];
      const double k2v = middle * (y[s] + 0.5 * h * k1y);
      const double k2y = v[s] + 0.5 * h * k1v;
      const double k3v = middle * (y[s] + 0.5 * h * k2y);
      const double k3y = v[s] + 0.5 * h * k2v;
      const double k4v = end * (y[s] + h * k3y);
      const double k4y = v[s] + h * k3v;
      y[s] += h / 6 * (k1y + 2 * k2y + 2 * k3y + k4y);
      v[s] += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    }
    start = end;
  }
  const double half_trace = 0.5 * (y[0] + v[1]);
  const bool unstable = std::abs(half_trace) > 1 + 1e-9;
  return {half_trace, unstable, unstable ? std::acosh(std::abs(half_trace)) / std::numbers::pi : 0};
}

std::pair<double, double> mathieu_zone_borders(int zone, double b) {
  const double q = std::abs(b);
  const int j = zone / 2;
  const Eigen::Index rows = j + 25;
  Eigen::VectorXd diagonal(rows);
  Eigen::VectorXd beside = Eigen::VectorXd::Constant(rows - 1, q);
  double first = 0, second = 0;
  if (zone % 2 == 1) {
    for (Eigen::Index k = 0; k < rows; ++k) diagonal(k) = static_cast<double>((2 * k + 1) * (2 * k + 1));
    diagonal(0) = 1 - q;
    first = tridiagonal_eigenvalue(diagonal, beside, j);
    diagonal(0) = 1 + q;
    second = tridiagonal_eigenvalue(diagonal, beside, j);
  } else {
    for (Eigen::Index k = 0; k < rows; ++k) diagonal(k) = static_cast<double>(4 * (k + 1) * (k + 1));
    first = tridiagonal_eigenvalue(diagonal, beside, j - 1);
    for (Eigen::Index k = 0; k < rows; ++k) diagonal(k) = static_cast<double>(4 * k * k);
    beside(0) = std::numbers::sqrt2 * q;
    second = tridiagonal_eigenvalue(diagonal, beside, j);
  }
  return std::minmax(first, second);
}

}  // namespace verstat::models
