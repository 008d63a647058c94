#include "models/dynamics/stepped_beam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "models/catalogue/error.h"
#include "models/math/solve.h"

namespace verstat::models::dynamics {
namespace {

template <class T>
struct KrylovOf {
  T a, b, c, d;
};

template <class T>
KrylovOf<T> krylov_of(T x) {
  using std::abs;
  if (abs(x) < 1) {  // x^n/n!, every fourth n: the next term is below 1e-17
    const T x4 = x * x * x * x;
    const auto series = [&](T first, int n) {
      T term = first;
      T sum = first;
      for (int k = 0; k < 4; ++k) {
        term *= x4 / static_cast<double>((n + 1) * (n + 2) * (n + 3) * (n + 4));
        n += 4;
        sum += term;
      }
      return sum;
    };
    return {series(T(1), 0), series(x, 1), series(x * x / 2.0, 2), series(x * x * x / 6.0, 3)};
  }
  using std::cos;
  using std::cosh;
  using std::sin;
  using std::sinh;
  const T ch = cosh(x), sh = sinh(x), c = cos(x), s = sin(x);
  return {(ch + c) / 2.0, (sh + s) / 2.0, (ch - c) / 2.0, (sh - s) / 2.0};
}

template <class T>
using State = std::array<T, 4>;  // y kappa, theta, M/(kappa EJ0), Q/(kappa^2 EJ0): of one size

double conjugate(double x) {
  return x;
}
std::complex<double> conjugate(std::complex<double> x) {
  return std::conj(x);
}

template <class T>
T dot(const State<T>& p, const State<T>& q) {
  T sum = 0;
  for (std::size_t i = 0; i < 4; ++i) sum += conjugate(p[i]) * q[i];
  return sum;
}

// Two orthonormal states that span what the support allows, and how they follow from the pair before:
// carried pair = basis * upper, upper = {{r00, r01}, {0, r11}} with positive diagonal (orientation is kept).
template <class T>
struct Pair {
  State<T> p, q;
};
template <class T>
struct Upper {
  double r00, r11;
  T r01;
};

template <class T>
Upper<T> orthonormalize(Pair<T>& pair) {
  Upper<T> r{};
  r.r00 = std::sqrt(std::real(dot(pair.p, pair.p)));
  for (T& x : pair.p) x /= r.r00;
  // Twice: one pass of Gram-Schmidt leaves a rest when the two are nearly parallel.
  for (int pass = 0; pass < 2; ++pass) {
    const T along = dot(pair.p, pair.q);
    r.r01 += along;
    for (std::size_t i = 0; i < 4; ++i) pair.q[i] -= along * pair.p[i];
  }
  r.r11 = std::sqrt(std::real(dot(pair.q, pair.q)));
  for (T& x : pair.q) x /= r.r11;
  return r;
}

// Coefficients in the basis before from those in the basis after the step.
template <class T>
std::array<T, 2> back(const Upper<T>& r, const std::array<T, 2>& c) {
  const T second = c[1] / r.r11;
  return {(c[0] - r.r01 * second) / r.r00, second};
}

// Which two of (y, theta, M, Q) an end leaves free.
std::array<std::size_t, 2> free_of(BeamEnd end) {
  switch (end) {
    case BeamEnd::clamped:
      return {2, 3};
    case BeamEnd::pinned:
      return {1, 3};
    case BeamEnd::sliding:
      return {0, 2};
  }
  reject("there is no such support");
}
std::array<std::size_t, 2> held_of(BeamEnd end) {
  const auto free = free_of(end);
  std::array<std::size_t, 2> held{};
  std::size_t k = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != free[0] && i != free[1]) held[k++] = i;
  return held;
}

template <class T>
Pair<T> allowed_by(BeamEnd end) {
  const auto free = free_of(end);
  Pair<T> pair{};
  pair.p[free[0]] = T(1);
  pair.q[free[1]] = T(1);
  return pair;
}

// Transfer over a length, with r = k/kappa and e = EJ/EJ0 of the segment. Backwards: B and D change sign.
template <class T>
class Transfer {
 public:
  Transfer(const KrylovOf<T>& f, T r, T e, double direction) {
    const T b = direction * f.b, d = direction * f.d;
    t_ = {State<T>{f.a, b / r, f.c / (r * r * e), d / (r * r * r * e)},
          State<T>{r * d, f.a, b / (r * e), f.c / (r * r * e)},
          State<T>{r * r * e * f.c, r * e * d, f.a, b / r},
          State<T>{r * r * r * e * b, r * r * e * f.c, r * d, f.a}};
  }
  [[nodiscard]] State<T> operator()(const State<T>& z) const {
    State<T> out{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j) out[i] += t_[i][j] * z[j];
    return out;
  }

 private:
  std::array<State<T>, 4> t_{};
};

template <class T>
T complex_power(T x, double y) {
  using std::pow;
  return pow(x, y);
}

// The beam at one frequency, for real (natural vibration) or complex (damped) stiffness.
template <class T>
class Walk {
 public:
  // A step spans at most `widest` in k x, so that cosh grows little between two orthonormalizations.
  Walk(const std::vector<BeamSegment>& segments, double omega, T damping, double total_m, double widest)
      : segments_(segments), damping_(damping), widest_(widest) {
    const BeamSegment& first = segments.front();
    const double k = std::sqrt(omega) * std::pow(first.mass_kg_m / first.stiffness_n_m2, 0.25);
    kappa_ = std::max(k, 1 / total_m);
    omega_ = omega;
  }
  [[nodiscard]] double kappa() const { return kappa_; }
  [[nodiscard]] double unit_force_jump() const {
    return 1 / (kappa_ * kappa_ * segments_.front().stiffness_n_m2);
  }

  // Calls step(pair, upper) after every step from one node to another; the pair is changed in place.
  template <class F>
  void carry(Pair<T>& pair, std::size_t from, std::size_t to, F&& step) const {
    const bool forward = to > from;
    for (std::size_t node = from; node != to; node += forward ? 1 : std::size_t(-1)) {
      const BeamSegment& s = segments_[forward ? node : node - 1];
      const T k = std::sqrt(omega_) * complex_power(T(s.mass_kg_m) / (s.stiffness_n_m2 * damping_), 0.25);
      const auto parts =
          static_cast<std::size_t>(std::max(1.0, std::ceil(std::abs(k) * s.length_m / widest_)));
      const Transfer<T> transfer(krylov_of<T>(k * (s.length_m / static_cast<double>(parts))), k / kappa_,
                                 s.stiffness_n_m2 / segments_.front().stiffness_n_m2 * damping_,
                                 forward ? 1.0 : -1.0);
      for (std::size_t i = 0; i < parts; ++i) {
        pair.p = transfer(pair.p);
        pair.q = transfer(pair.q);
        const Upper<T> upper = orthonormalize(pair);
        step(pair, upper);
      }
    }
  }

 private:
  const std::vector<BeamSegment>& segments_;
  T damping_;
  double widest_;
  double kappa_ = 0;
  double omega_ = 0;
};

constexpr double coarse = 2.5;
constexpr double fine = 0.2;

}  // namespace

Krylov krylov(double x) {
  const auto f = krylov_of<double>(x);
  return {f.a, f.b, f.c, f.d};
}

SteppedBeam::SteppedBeam(std::vector<BeamSegment> segments, BeamEnd start, BeamEnd tip)
    : segments_(std::move(segments)), start_(start), tip_(tip) {
  for (const BeamSegment& s : segments_) total_m_ += s.length_m;
}

bool SteppedBeam::fixed(std::size_t node) const {
  if (node == 0) return start_ != BeamEnd::sliding;
  return node == segments_.size() && tip_ != BeamEnd::sliding;
}

double SteppedBeam::wave_length_sum(double omega) const {
  double sum = 0;
  for (const BeamSegment& s : segments_)
    sum += std::sqrt(omega) * std::pow(s.mass_kg_m / s.stiffness_n_m2, 0.25) * s.length_m;
  return sum;
}

double SteppedBeam::frequency_function(double omega) const {
  const Walk<double> walk(segments_, omega, 1.0, total_m_, coarse);
  auto pair = allowed_by<double>(start_);
  walk.carry(pair, 0, segments_.size(), [](const auto&, const auto&) {});
  const auto held = held_of(tip_);
  return pair.p[held[0]] * pair.q[held[1]] - pair.q[held[0]] * pair.p[held[1]];
}

std::vector<double> SteppedBeam::frequencies(int count) const {
  double softest = segments_.front().stiffness_n_m2, heaviest = segments_.front().mass_kg_m;
  double stiffest = softest, lightest = heaviest;
  for (const BeamSegment& s : segments_) {
    softest = std::min(softest, s.stiffness_n_m2);
    stiffest = std::max(stiffest, s.stiffness_n_m2);
    heaviest = std::max(heaviest, s.mass_kg_m);
    lightest = std::min(lightest, s.mass_kg_m);
  }
  // Rayleigh: the beam vibrates faster than a uniform one, softest and heaviest throughout, on the loosest
  // supports (sliding and pinned, lambda = pi/2), and slower than the stiffest and lightest, clamped at both
  // ends.
  const double square_m = total_m_ * total_m_;
  double low = 0.98 * std::pow(std::numbers::pi / 2, 2) * std::sqrt(softest / heaviest) / square_m;
  const double last =
      1.02 * std::pow((count + 0.5) * std::numbers::pi + 0.02, 2) * std::sqrt(stiffest / lightest) / square_m;
  if (!(low > 0) || !std::isfinite(last))
    reject("stiffness and mass of the tool are beyond the range of numbers");
  const auto value = [this](double omega) { return frequency_function(omega); };
  std::vector<double> roots;
  const auto add = [&](double from, double to) {
    if (static_cast<int>(roots.size()) < count) roots.push_back(find_root(value, from, to));
  };
  double before = low;
  double at_before = value(low);
  double at_low = at_before;
  while (static_cast<int>(roots.size()) < count) {
    if (low > last) reject("the natural frequencies could not be separated");
    const double high = low * 1.005;
    const double at_high = value(high);
    if (std::signbit(at_low) != std::signbit(at_high)) {
      add(low, high);
    } else if (std::abs(at_low) < std::abs(at_before) && std::abs(at_low) < std::abs(at_high) &&
               std::signbit(at_before) == std::signbit(at_low)) {
      // A dip without a change of sign: two roots may lie inside it.
      const double sign = std::signbit(at_low) ? -1 : 1;
      const Minimum dip = minimize_unimodal([&](double w) { return sign * value(w); }, before, high, 1e-8);
      if (dip.value < 0) {
        add(before, dip.x);
        add(dip.x, high);
      }
    }
    before = low;
    at_before = at_low;
    low = high;
    at_low = at_high;
  }
  return roots;
}

SteppedBeam::Mode SteppedBeam::mode(double omega) const {
  const Walk<double> walk(segments_, omega, 1.0, total_m_, fine);
  struct Step {
    Pair<double> pair;
    Upper<double> upper;
  };
  std::vector<Step> steps;
  std::vector<std::size_t> step_of_node;  // steps taken when node 1, 2, ... is reached
  const auto start = allowed_by<double>(start_);
  auto pair = start;
  for (std::size_t node = 0; node < segments_.size(); ++node) {
    walk.carry(pair, node, node + 1, [&](const auto& p, const auto& r) { steps.push_back({p, r}); });
    step_of_node.push_back(steps.size());
  }
  // The combination that the tip holds in both conditions; of the two rows the larger.
  const auto held = held_of(tip_);
  std::array<double, 2> c{};
  double size = 0;
  for (std::size_t row : held)
    if (const double here = std::hypot(pair.p[row], pair.q[row]); here > size) {
      size = here;
      c = {pair.q[row] / here, -pair.p[row] / here};
    }
  Mode out{std::vector<double>(segments_.size() + 1, 0.0), 0};
  for (std::size_t done = steps.size(); done > 0; --done) {
    const Pair<double>& at = steps[done - 1].pair;
    const double y = c[0] * at.p[0] + c[1] * at.q[0];
    out.largest = std::max(out.largest, std::abs(y));
    for (std::size_t node = 0; node < step_of_node.size(); ++node)
      if (step_of_node[node] == done) out.nodes[node + 1] = y;
    c = back(steps[done - 1].upper, c);
  }
  out.nodes[0] = c[0] * start.p[0] + c[1] * start.q[0];
  out.largest = std::max(out.largest, std::abs(out.nodes[0]));
  for (std::size_t node = 0; node < out.nodes.size(); ++node)
    if (fixed(node)) out.nodes[node] = 0;
  return out;
}

std::complex<double> SteppedBeam::receptance(double omega, double loss_factor, std::size_t node_force,
                                             std::size_t node_response) const {
  using C = std::complex<double>;
  if (fixed(node_force) || fixed(node_response)) return 0;
  const Walk<C> walk(segments_, omega, C(1, loss_factor), total_m_, coarse);
  const std::size_t last = segments_.size();
  // Left of the force the states that the start allows, right of it those that the tip allows.
  const bool response_left = node_response <= node_force;
  std::vector<Upper<C>> uppers;  // of the steps between response and force
  const auto nothing = [](const auto&, const auto&) {};
  const auto record = [&](const auto&, const auto& r) { uppers.push_back(r); };
  auto left = allowed_by<C>(start_);
  auto right = allowed_by<C>(tip_);
  Pair<C> at_response{};
  if (response_left) {
    walk.carry(left, 0, node_response, nothing);
    at_response = left;
    walk.carry(left, node_response, node_force, record);
    walk.carry(right, last, node_force, nothing);
  } else {
    walk.carry(left, 0, node_force, nothing);
    walk.carry(right, last, node_response, nothing);
    at_response = right;
    walk.carry(right, node_response, node_force, record);
  }
  // right * b - left * a = jump of Q by the force.
  Eigen::Matrix4cd m;
  Eigen::Vector4cd jump = Eigen::Vector4cd::Zero();
  jump(3) = walk.unit_force_jump();
  for (std::size_t i = 0; i < 4; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    m(row, 0) = -left.p[i];
    m(row, 1) = -left.q[i];
    m(row, 2) = right.p[i];
    m(row, 3) = right.q[i];
  }
  const Eigen::FullPivLU<Eigen::Matrix4cd> lu(m);
  if (!lu.isInvertible()) reject("the undamped tool is at a natural frequency: its response has no limit");
  const Eigen::Vector4cd x = lu.solve(jump);
  std::array<C, 2> c = response_left ? std::array<C, 2>{x(0), x(1)} : std::array<C, 2>{x(2), x(3)};
  for (auto r = uppers.rbegin(); r != uppers.rend(); ++r) c = back(*r, c);
  return (c[0] * at_response.p[0] + c[1] * at_response.q[0]) / walk.kappa();
}

}  // namespace verstat::models::dynamics
