#include "models/dynamics/elastic_rod.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "models/catalogue/error.h"

namespace verstat::models {
namespace {

// Stiffness coefficients of a vibrating segment in units of EJ/L^3, EJ/L^2, EJ/L (static: 12, 6, 4, -12, 6,
// 2).
struct DynamicStiffness {
  double force, force_turn, moment_turn, far_force, far_force_turn, far_moment_turn;
  int clamped_below;  // frequencies of the segment with clamped ends that lie below
};

DynamicStiffness dynamic_stiffness(double x) {
  DynamicStiffness k{};
  double d = 0;
  if (x < 2) {
    // Differences of like numbers near 0: power series in x^4, divided by the leading powers of x.
    const double q = x * x * x * x;
    double sum = 0, difference = 0, product = 0, s_plus = 0, c_minus = 0, s_minus = 0;
    // Terms of cosh x cos x, sin x sinh x and of the plain functions.
    double term = 1;   // (-4)^n x^(4n) / (4n)!
    double plain = 1;  // x^(4n) / (4n)!
    for (int n = 0; n < 9; ++n) {
      const double m = 4.0 * n;
      product += 2 * term / ((m + 1) * (m + 2));             // sin sinh / x^2
      sum += 2 * term / (m + 1);                             // (sin cosh + cos sinh) / x
      s_plus += 2 * plain / (m + 1);                         // (sin + sinh) / x
      c_minus += 2 * plain / ((m + 1) * (m + 2));            // (cosh - cos) / x^2
      s_minus += 2 * plain / ((m + 1) * (m + 2) * (m + 3));  // (sinh - sin) / x^3
      const double next = 1 / ((m + 1) * (m + 2) * (m + 3) * (m + 4));
      const double scaled = -4 * term * next;  // next term / x^4
      d -= scaled;                             // (1 - cosh cos) / x^4
      difference -= scaled * (m + 4);          // (sin cosh - cos sinh) / x^3
      term = scaled * q;
      plain *= q * next;
    }
    k = {sum / d, product / d, difference / d, -s_plus / d, c_minus / d, s_minus / d, 0};
  } else {
    // Divided by cosh x, so that nothing overflows.
    const double c = 1 / std::cosh(x);
    const double th = std::tanh(x);
    const double sin = std::sin(x);
    const double cos = std::cos(x);
    d = c - cos;
    const double x2 = x * x;
    k = {x2 * x * (sin + cos * th) / d,
         x2 * sin * th / d,
         x * (sin - cos * th) / d,
         -x2 * x * (sin * c + th) / d,
         x2 * (1 - cos * c) / d,
         x * (th - sin * c) / d,
         0};
    const double half_waves = std::floor(x / std::numbers::pi);
    // Not a number, too, when squares of the members have left the range of numbers on the way here.
    constexpr double most_half_waves = 1e9;
    if (!(half_waves < most_half_waves))
      reject("a segment of this length, diameter and material has no frequencies that can be counted");
    const bool odd = std::fmod(half_waves, 2) != 0;
    k.clamped_below = static_cast<int>(half_waves) - ((d > 0) == odd ? 1 : 0);
  }
  return k;
}

double wave_number(const RodSegment& s, double omega) {
  return std::sqrt(omega * std::sqrt(s.mass_kg_m / s.bending_stiffness_n_m2));
}

}  // namespace

RodSegment round_segment(double length_mm, double outer_mm, double inner_mm, double e_gpa, double rho_kg_m3) {
  const double outer = outer_mm * 1e-3;
  const double inner = inner_mm * 1e-3;
  const double area = std::numbers::pi / 4 * (outer - inner) * (outer + inner);
  return {length_mm * 1e-3, e_gpa * 1e9 * area * (outer * outer + inner * inner) / 16, rho_kg_m3 * area};
}

template <class T>
Krylov<T> krylov(T x) {
  using std::cos, std::cosh, std::sin, std::sinh;
  if (std::abs(x) < 1.5) {
    // S..V hold every fourth term of exp x: no cancellation.
    Krylov<T> k{T(0), T(0), T(0), T(0)};
    T term(1);
    for (int n = 0; n < 28; n += 4) {
      k.s += term;
      term *= x / (n + 1.0);
      k.t += term;
      term *= x / (n + 2.0);
      k.u += term;
      term *= x / (n + 3.0);
      k.v += term;
      term *= x / (n + 4.0);
    }
    return k;
  }
  return {0.5 * (cosh(x) + cos(x)), 0.5 * (sinh(x) + sin(x)), 0.5 * (cosh(x) - cos(x)),
          0.5 * (sinh(x) - sin(x))};
}
template Krylov<double> krylov(double);
template Krylov<std::complex<double>> krylov(std::complex<double>);

template <class T>
TransferMatrix<T> transfer_matrix(const RodSegment& segment, double omega_rad_s, double ref_length_m,
                                  double ref_stiffness_n_m2, T complex_factor) {
  using std::pow, std::sqrt;
  const T lambda = wave_number(segment, omega_rad_s) / sqrt(sqrt(complex_factor));
  const Krylov<T> k = krylov<T>(lambda * segment.length_m);
  const T mu = lambda * ref_length_m;
  const T e = complex_factor * (segment.bending_stiffness_n_m2 / ref_stiffness_n_m2);
  const T mu2 = mu * mu;
  TransferMatrix<T> m;
  m << k.s, k.t / mu, k.u / (e * mu2), k.v / (e * mu2 * mu),  //
      mu * k.v, k.s, k.t / (e * mu), k.u / (e * mu2),         //
      e * mu2 * k.u, e * mu * k.v, k.s, k.t / mu,             //
      e * mu2 * mu * k.t, e * mu2 * k.u, mu * k.v, k.s;
  return m;
}
template TransferMatrix<double> transfer_matrix(const RodSegment&, double, double, double, double);
template TransferMatrix<std::complex<double>> transfer_matrix(const RodSegment&, double, double, double,
                                                              std::complex<double>);

double bending_phase(const std::vector<RodSegment>& rod, double omega_rad_s) {
  double sum = 0;
  for (const RodSegment& s : rod) sum += wave_number(s, omega_rad_s) * s.length_m;
  return sum;
}

template <class T>
RodCompliance<T>::RodCompliance(const std::vector<RodSegment>& rod, const std::vector<GroundSpring>& springs,
                                double omega_rad_s, T complex_factor) {
  double length = 0;
  for (const RodSegment& s : rod) length += s.length_m;
  const double stiffness = rod.front().bending_stiffness_n_m2;
  flexibility_m_n_ = length * length * length / stiffness;
  steps_.assign(rod.size() + 1, TransferMatrix<T>::Identity());
  for (std::size_t k = 0; k < rod.size(); ++k)
    steps_[k + 1] = transfer_matrix<T>(rod[k], omega_rad_s, length, stiffness, complex_factor);
  // A spring adds -k y to the shear: row 4 less k b times row 1.
  for (const GroundSpring& spring : springs) {
    const T kb = complex_factor * (spring.stiffness_n_m * flexibility_m_n_);
    steps_[spring.section].row(3) -= kb * steps_[spring.section].row(0);
  }
  products_.reserve(steps_.size());
  products_.push_back(steps_[0]);
  for (std::size_t k = 1; k < steps_.size(); ++k) products_.push_back(steps_[k] * products_.back());
}

template <class T>
std::vector<T> RodCompliance<T>::under_force_at(std::size_t j) const {
  // Parameters at section 0 from M = Q = 0 at the far end; the force adds b to b Q at section j.
  Eigen::Matrix<T, 4, 1> state(T(0), T(0), T(0), T(1));
  std::vector<T> own(steps_.size(), T(0));
  for (std::size_t k = j + 1; k < steps_.size(); ++k) {
    state = (steps_[k] * state).eval();
    own[k] = state(0);
  }
  const TransferMatrix<T>& a = products_.back();
  const T determinant = a(2, 0) * a(3, 1) - a(3, 0) * a(2, 1);
  const T y0 = (a(2, 1) * state(3) - a(3, 1) * state(2)) / determinant;
  const T turn0 = (a(3, 0) * state(2) - a(2, 0) * state(3)) / determinant;
  for (std::size_t k = 0; k < own.size(); ++k)
    own[k] = (products_[k](0, 0) * y0 + products_[k](0, 1) * turn0 + own[k]) * flexibility_m_n_;
  return own;
}
template class RodCompliance<double>;
template class RodCompliance<std::complex<double>>;

RodSystem::RodSystem(std::vector<RodSegment> rod, std::vector<GroundSpring> springs)
    : rods_{std::move(rod)}, springs_(std::move(springs)) {}

RodSystem::RodSystem(std::vector<RodSegment> first, std::vector<RodSegment> second, std::vector<Link> links,
                     std::vector<GroundSpring> second_springs)
    : rods_{std::move(first), std::move(second)},
      links_(std::move(links)),
      springs_(std::move(second_springs)) {}

std::size_t RodSystem::node(std::size_t rod, std::size_t section) const {
  // Sections of both rods alternate, so that the matrix keeps a narrow band.
  if (rods_.size() == 1) return section;
  const std::size_t other = rods_[1 - rod].size() + 1;
  return section < other ? 2 * section + rod : section + other;
}

int RodSystem::count_below(double freq_hz) const {
  constexpr std::size_t band = 6;  // an entry couples nodes at most two apart, two freedoms each
  using Row = std::array<double, band>;
  std::size_t nodes = 0;
  for (const auto& rod : rods_) nodes += rod.size() + 1;
  std::vector<Row> lower(2 * nodes, Row{});  // lower[i][d] = K(i, i - d)
  const auto add = [&](std::size_t i, std::size_t j, double value) {
    if (i < j) std::swap(i, j);
    lower[i][i - j] += value;
  };

  const double omega = 2 * std::numbers::pi * freq_hz;
  int count = 0;
  for (std::size_t r = 0; r < rods_.size(); ++r)
    for (std::size_t s = 0; s < rods_[r].size(); ++s) {
      const RodSegment& segment = rods_[r][s];
      const DynamicStiffness k = dynamic_stiffness(wave_number(segment, omega) * segment.length_m);
      count += k.clamped_below;
      const double turn = segment.bending_stiffness_n_m2 / segment.length_m;
      const double mixed = turn / segment.length_m;
      const double shift = mixed / segment.length_m;
      const std::size_t a = 2 * node(r, s);
      const std::size_t b = 2 * node(r, s + 1);
      add(a, a, shift * k.force);
      add(a, a + 1, mixed * k.force_turn);
      add(a + 1, a + 1, turn * k.moment_turn);
      add(b, a, shift * k.far_force);
      add(b + 1, a, mixed * k.far_force_turn);
      add(b, a + 1, -mixed * k.far_force_turn);
      add(b + 1, a + 1, turn * k.far_moment_turn);
      add(b, b, shift * k.force);
      add(b, b + 1, -mixed * k.force_turn);
      add(b + 1, b + 1, turn * k.moment_turn);
    }
  for (const GroundSpring& spring : springs_) {
    const std::size_t i = 2 * node(rods_.size() - 1, spring.section);
    add(i, i, spring.stiffness_n_m);
  }
  for (const Link& link : links_) {
    const std::size_t i = 2 * node(0, link.first_section);
    const std::size_t j = 2 * node(1, link.second_section);
    add(i, i, link.stiffness_n_m);
    add(j, j, link.stiffness_n_m);
    add(i, j, -link.stiffness_n_m);
  }

  // Negative eigenvalues = negative pivots (Sylvester). A pivot near zero is harmless: the next one then has
  // the opposite sign and both together still count one.
  for (std::size_t j = 0; j < lower.size(); ++j) {
    double pivot = lower[j][0];
    if (pivot == 0) pivot = 1e-200;
    if (pivot < 0) ++count;
    const std::size_t last = std::min(lower.size(), j + band);
    for (std::size_t i = j + 1; i < last; ++i) {
      const double factor = lower[i][i - j] / pivot;
      if (factor == 0) continue;
      for (std::size_t k = j + 1; k <= i; ++k) lower[i][i - k] -= factor * lower[k][k - j];
    }
  }
  return count;
}

int RodSystem::rigid_motions() const {
  // Rigid motions (y, turn) of every rod that stretch no spring.
  const auto position = [](const std::vector<RodSegment>& rod, std::size_t section) {
    double at = 0, all = 0;
    for (std::size_t k = 0; k < rod.size(); ++k) {
      all += rod[k].length_m;
      if (k < section) at += rod[k].length_m;
    }
    return at / all;
  };
  const auto columns = static_cast<Eigen::Index>(2 * rods_.size());
  Eigen::MatrixXd stretch =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(links_.size() + springs_.size()), columns);
  if (stretch.rows() == 0) return static_cast<int>(columns);
  double ratio = 1;  // turns are measured over each rod's own length
  if (rods_.size() == 2) {
    double first = 0, second = 0;
    for (const RodSegment& s : rods_[0]) first += s.length_m;
    for (const RodSegment& s : rods_[1]) second += s.length_m;
    ratio = second / first;
  }
  Eigen::Index row = 0;
  for (const Link& link : links_) {
    stretch.row(row++) << 1, position(rods_[0], link.first_section), -1,
        -ratio * position(rods_[1], link.second_section);
  }
  for (const GroundSpring& spring : springs_) {
    stretch(row, columns - 2) = 1;
    stretch(row++, columns - 1) = ratio * position(rods_.back(), spring.section);
  }
  Eigen::FullPivLU<Eigen::MatrixXd> lu(stretch);
  lu.setThreshold(1e-9);
  return static_cast<int>(columns - lu.rank());
}

std::vector<double> RodSystem::frequencies_hz(int count, double low_hz, double high_hz) const {
  std::vector<double> found;
  const int skipped = count_below(low_hz);
  const int available = count_below(high_hz) - skipped;
  double from = low_hz;
  for (int mode = 1; mode <= std::min(count, available); ++mode) {
    double low = from;
    double high = high_hz;
    while (high - low > 1e-13 * high) {
      const double middle = 0.5 * (low + high);
      if (!(low < middle && middle < high)) break;
      (count_below(middle) >= skipped + mode ? high : low) = middle;
    }
    found.push_back(0.5 * (low + high));
    from = low;
  }
  return found;
}

}  // namespace verstat::models
