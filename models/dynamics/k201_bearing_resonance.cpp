#include "models/dynamics/k201_bearing_resonance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "models/dynamics/mathieu.h"

namespace verstat::models::k201 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double rad_per_deg = pi / 180;
constexpr double a_max = 100;  // range of the Floquet integration
constexpr double b_max = 20;
constexpr double most_grid_speeds = 20'000;

MathieuParameters parameters(double p, double omega_exc, double stiffness_ratio) {
  const double a = 4 * p * p / (omega_exc * omega_exc);
  return {omega_exc, a, 0.5 * a * stiffness_ratio};
}

double excitation(double speed_rpm, double cage_ratio, std::int64_t harmonic) {
  return static_cast<double>(harmonic) * 2 * pi * speed_rpm / 60 * cage_ratio;
}

// Net growth of y = exp(-zeta p t) times a solution with a' = a (1 - zeta^2), 1/s.
double net_growth(const MathieuParameters& m, double p, double damping) {
  const double growth = mathieu_stability(m.a * (1 - damping * damping), m.b).growth;
  return 0.5 * m.omega_exc_rad_s * growth - damping * p;
}

void require_floquet_range(const MathieuParameters& m, std::string_view input, double value,
                           std::string_view place) {
  require(m.a <= a_max, input, value,
          fmt::format("gives a = {:.6g}{}, must not exceed {}", m.a, place, a_max));
  require(m.b <= b_max, input, value,
          fmt::format("gives b = {:.6g}{}, must not exceed {}", m.b, place, b_max));
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto k = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
  return y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]);
}

Eigen::Matrix3d matrix(const StiffnessMatrix& m) {
  Eigen::Matrix3d c;
  c << m.xx, m.xy, m.xz, m.xy, m.yy, m.yz, m.xz, m.yz, m.zz;
  return c;
}

double cage_ratio(double ball_mm, double pitch_mm, double angle_deg) {
  return 0.5 * (1 - ball_mm * std::cos(angle_deg * rad_per_deg) / pitch_mm);
}

void require_ball_fits(double ball_mm, double pitch_mm) {
  require(ball_mm < pitch_mm, "ball_diameter_mm", ball_mm, "must be below pitch_diameter_mm");
}

enum class Race { inner, outer };
// Hertz contact stiffness K of Q = K delta^1.5, N/mm^1.5 (Hamrock and Brewe's fit), steel on steel.
double race_stiffness(const PreloadedBearing& b, Race race) {
  constexpr double modulus_n_mm2 = 206000;
  constexpr double poisson = 0.3;
  const double gamma = b.ball_diameter_mm * std::cos(b.contact_angle_deg * rad_per_deg) / b.pitch_diameter_mm;
  const double rx = b.ball_diameter_mm / 2 * (race == Race::inner ? 1 - gamma : 1 + gamma);
  const double ry = b.groove_ratio * b.ball_diameter_mm / (2 * b.groove_ratio - 1);
  const double r = 1 / (1 / rx + 1 / ry);
  const double k = 1.0339 * std::pow(ry / rx, 0.636);
  const double second = 1.0003 + 0.5968 * rx / ry;
  const double first = 1.5277 + 0.6023 * std::log(ry / rx);
  const double e = modulus_n_mm2 / (1 - poisson * poisson);
  return pi * k * e * std::sqrt(2 * second * r / (9 * first * first * first));
}

// Equilibrium of one ball at a trial outer contact angle (Jones).
struct BallState {
  double alpha_inner, load_inner, load_outer, approach_inner, approach_outer;
};
BallState ball_state(double alpha_outer, double axial_n, double centrifugal_n, double k_inner,
                     double k_outer) {
  BallState s{};
  s.load_outer = axial_n / std::sin(alpha_outer);
  s.alpha_inner = std::atan2(axial_n, s.load_outer * std::cos(alpha_outer) - centrifugal_n);
  s.load_inner = axial_n / std::sin(s.alpha_inner);
  s.approach_inner = std::cbrt(s.load_inner / k_inner * (s.load_inner / k_inner));
  s.approach_outer = std::cbrt(s.load_outer / k_outer * (s.load_outer / k_outer));
  return s;
}

// Stiffness of one contact in the radial-axial plane.
Eigen::Matrix2d contact_matrix(double k, double approach, double load, double distance, double angle) {
  const Eigen::Vector2d n(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d t(-std::sin(angle), std::cos(angle));
  return 1.5 * k * std::sqrt(approach) * n * n.transpose() + load / (distance + approach) * t * t.transpose();
}

}  // namespace

Ratio cage_speed_ratio(const BallBearing& in) {
  return guarded<&cage_speed_ratio>(in, [&] {
    require_ball_fits(in.ball_diameter_mm, in.pitch_diameter_mm);
    return Ratio{cage_ratio(in.ball_diameter_mm, in.pitch_diameter_mm, in.contact_angle_deg)};
  });
}

StiffnessHarmonics stiffness_harmonics(const StiffnessSamples& in) {
  return guarded<&stiffness_harmonics>(in, [&] {
    const std::vector<double>& s = in.samples_n_per_um;
    const std::size_t n = s.size();
    require(in.harmonics < (static_cast<std::int64_t>(n) + 1) / 2, "n_harmonics", in.harmonics,
            fmt::format("must be below half of the {} samples", n));
    std::vector<double> cosine(n), sine(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 2 * pi * static_cast<double>(k) / static_cast<double>(n);
      cosine[k] = std::cos(angle);
      sine[k] = std::sin(angle);
    }
    StiffnessHarmonics out{0, {}, {}};
    for (const double x : s) out.mean_n_per_um += x;
    out.mean_n_per_um /= static_cast<double>(n);
    for (std::size_t m = 1; m <= static_cast<std::size_t>(in.harmonics); ++m) {
      double a = 0;
      double b = 0;
      std::size_t turn = 0;  // m k modulo n
      for (std::size_t k = 0; k < n; ++k) {
        a += (s[k] - out.mean_n_per_um) * cosine[turn];
        b += (s[k] - out.mean_n_per_um) * sine[turn];
        turn = (turn + m) % n;
      }
      const double scale = 2 / static_cast<double>(n);
      out.amplitudes_n_per_um.push_back(scale * std::hypot(a, b));
      out.phases_rad.push_back(std::atan2(-b, a));
    }
    return out;
  });
}

RingFrequencies bearing_natural_frequencies(const RingStiffness& in) {
  return guarded<&bearing_natural_frequencies>(in, [&] {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        matrix({in.c_xx, in.c_yy, in.c_zz, in.c_xy, in.c_xz, in.c_yz}), Eigen::EigenvaluesOnly);
    const auto frequency = [&](int k) {
      const double stiffness = solver.eigenvalues()(k) * 1e6;  // N/m
      return stiffness > 0 ? std::sqrt(stiffness / in.mass_kg) : 0;
    };
    return RingFrequencies{frequency(0), frequency(1), frequency(2)};
  });
}

Modulation principal_stiffness_modulation(const ModulationInputs& in) {
  return guarded<&principal_stiffness_modulation>(in, [&] {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix(in.mean));
    const Eigen::Vector3d& k0 = solver.eigenvalues();
    if (!(k0(0) > 0))
      throw DomainError("mean_matrix",
                        fmt::format("mean_matrix has the principal stiffness {}, all three must "
                                    "be positive",
                                    k0(0)));
    const Eigen::Matrix3d& u = solver.eigenvectors();
    const Eigen::Matrix3d seen = u.transpose() * matrix(in.harmonic) * u;
    const double tolerance = 1e-9 * k0(2);
    Modulation out;
    for (Eigen::Index first = 0; first < 3;) {
      Eigen::Index size = 1;
      while (first + size < 3 && k0(first + size) - k0(first + size - 1) <= tolerance) ++size;
      std::vector<double> moduli;
      if (size == 1) {
        moduli.push_back(std::abs(seen(first, first)));
      } else {
        const Eigen::MatrixXd block = seen.block(first, first, size, size);
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> group(block, Eigen::EigenvaluesOnly);
        for (Eigen::Index k = 0; k < size; ++k) moduli.push_back(std::abs(group.eigenvalues()(k)));
        std::sort(moduli.begin(), moduli.end());
      }
      for (Eigen::Index k = 0; k < size; ++k) {
        const double mean = k0(first + k);
        const double amplitude = moduli[static_cast<std::size_t>(k)];
        out.k0_n_per_um.push_back(mean);
        out.kr_n_per_um.push_back(amplitude);
        out.ratio.push_back(amplitude / mean);
      }
      first += size;
    }
    return out;
  });
}

MathieuParameters mathieu_parameters(const MathieuInputs& in) {
  return guarded<&mathieu_parameters>(in, [&] {
    return parameters(in.natural_frequency_rad_s,
                      excitation(in.spindle_speed_rpm, in.cage_ratio, in.harmonic), in.stiffness_ratio);
  });
}

Speed parametric_critical_speed(const ZoneTip& in) {
  return guarded<&parametric_critical_speed>(in, [&] {
    return Speed{60 * in.natural_frequency_rad_s /
                 (pi * static_cast<double>(in.zone) * static_cast<double>(in.harmonic) * in.cage_ratio)};
  });
}

Floquet mathieu_floquet(const MathieuPoint& in) {
  return guarded<&mathieu_floquet>(in, [&] {
    const MathieuStability s = mathieu_stability(in.a, in.b);
    return Floquet{s.half_trace, s.unstable ? 1 : 0, s.growth};
  });
}

ZoneEdges mathieu_zone_edges(const ZoneAt& in) {
  return guarded<&mathieu_zone_edges>(in, [&] {
    const auto [low, high] = mathieu_zone_borders(static_cast<int>(in.zone), in.b);
    return ZoneEdges{low, high};
  });
}

Growth parametric_growth_rate(const GrowthInputs& in) {
  return guarded<&parametric_growth_rate>(in, [&] {
    const MathieuParameters m =
        parameters(in.natural_frequency_rad_s, in.omega_exc_rad_s, in.stiffness_ratio);
    require_floquet_range(m, "omega_exc_rad_s", in.omega_exc_rad_s, "");
    const double growth = net_growth(m, in.natural_frequency_rad_s, in.damping_ratio);
    return Growth{growth, growth > 0 ? 1 : 0};
  });
}

SpeedBands parametric_speed_bands(const BandInputs& in) {
  return guarded<&parametric_speed_bands>(in, [&] {
    const auto& nodes = in.speed_nodes_rpm;
    const auto same = [&](const std::vector<double>& list, const char* name) {
      if (list.size() != nodes.size())
        throw DomainError(name,
                          fmt::format("{} has {} entries, must have as many as speed_nodes_rpm, that is "
                                      "{}",
                                      name, list.size(), nodes.size()));
    };
    same(in.p_nodes_rad_s, "p_nodes_rad_s");
    same(in.ratio_nodes, "ratio_nodes");
    for (std::size_t k = 1; k < nodes.size(); ++k)
      require(nodes[k - 1] < nodes[k], fmt::format("speed_nodes_rpm/{}", k), nodes[k], "must be ascending");
    require(in.n_min_rpm < in.n_max_rpm, "n_min_rpm", in.n_min_rpm, "must be below n_max_rpm");
    const double span = in.n_max_rpm - in.n_min_rpm;
    require(span / in.step_rpm <= most_grid_speeds, "step_rpm", in.step_rpm,
            fmt::format("asks for more than {} speeds between n_min_rpm and n_max_rpm", most_grid_speeds));

    const auto frequency = [&](double n) { return interpolate(nodes, in.p_nodes_rad_s, n); };
    const auto grows = [&](double n) {
      const double p = frequency(n);
      const MathieuParameters m =
          parameters(p, excitation(n, in.cage_ratio, in.harmonic), interpolate(nodes, in.ratio_nodes, n));
      require_floquet_range(m, "n_min_rpm", in.n_min_rpm, fmt::format(" at {:.6g} rpm", n));
      return net_growth(m, p, in.damping_ratio) > 0;
    };
    const auto edge = [&](double low, double high, bool low_grows) {
      while (high - low > 1e-3) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) break;
        (grows(middle) == low_grows ? low : high) = middle;
      }
      return 0.5 * (low + high);
    };

    SpeedBands out;
    const auto close = [&](double low, double high) {
      const double middle = 0.5 * (low + high);
      const double zone = std::round(2 * frequency(middle) / excitation(middle, in.cage_ratio, in.harmonic));
      out.bands.push_back({static_cast<std::int64_t>(zone), low, high});
    };
    double before = in.n_min_rpm;
    bool growing = grows(before);
    double start = before;
    for (std::int64_t k = 1; before < in.n_max_rpm; ++k) {
      const double here = std::min(in.n_min_rpm + static_cast<double>(k) * in.step_rpm, in.n_max_rpm);
      const bool now = grows(here);
      if (now != growing) {
        const double at = edge(before, here, growing);
        if (now)
          start = at;
        else
          close(start, at);
      }
      growing = now;
      before = here;
    }
    if (growing) close(start, in.n_max_rpm);
    return out;
  });
}

RegimeState bearing_excitation_regime(const RegimeInputs& in) {
  return guarded<&bearing_excitation_regime>(in, [&] {
    const double zeta = in.damping_ratio;
    if (mathieu_stability(in.a * (1 - zeta * zeta), in.b).growth > zeta * std::sqrt(in.a))
      return RegimeState{Regime::parametric};
    if (std::abs(std::sqrt(in.a) / 2 - 1) < in.resonance_tolerance)
      return RegimeState{Regime::forced_resonance};
    return RegimeState{Regime::quiet};
  });
}

Amplitude forced_vibration_amplitude(const ForcedInputs& in) {
  return guarded<&forced_vibration_amplitude>(in, [&] {
    const double rho = in.omega_exc_rad_s / in.natural_frequency_rad_s;
    const double response = std::hypot((1 - rho) * (1 + rho), 2 * in.damping_ratio * rho);
    require(response > 0, "damping_ratio", in.damping_ratio, "must be positive at resonance");
    return Amplitude{in.excitation_um / response};
  });
}

StaticStiffness bearing_static_stiffness(const PreloadedBearing& in) {
  return guarded<&bearing_static_stiffness>(in, [&] {
    require_ball_fits(in.ball_diameter_mm, in.pitch_diameter_mm);
    const double k = std::pow(std::pow(race_stiffness(in, Race::inner), -2.0 / 3) +
                                  std::pow(race_stiffness(in, Race::outer), -2.0 / 3),
                              -1.5);
    const double z = static_cast<double>(in.balls);
    const double sin = std::sin(in.contact_angle_deg * rad_per_deg);
    const double cos = std::cos(in.contact_angle_deg * rad_per_deg);
    const double load = in.preload_n / (z * sin);
    const double one = z * std::cbrt(k * k) * std::cbrt(load) / 1000;  // N/um
    return StaticStiffness{1.5 * one * sin * sin, 0.75 * one * cos * cos};
  });
}

SpeedStiffness bearing_stiffness_at_speed(const SpinningBearing& in) {
  return guarded<&bearing_stiffness_at_speed>(in, [&] {
    require_ball_fits(in.ball_diameter_mm, in.pitch_diameter_mm);
    const double d = in.ball_diameter_mm;
    const double z = static_cast<double>(in.balls);
    const double k_inner = race_stiffness(in, Race::inner);
    const double k_outer = race_stiffness(in, Race::outer);
    const double mass_kg = pi / 6 * d * d * d * in.ball_density_kg_mm3;
    const double cage_rad_s =
        2 * pi * in.spindle_speed_rpm / 60 * cage_ratio(d, in.pitch_diameter_mm, in.contact_angle_deg);
    const double centrifugal = 0.5 * mass_kg * in.pitch_diameter_mm / 1000 * cage_rad_s * cage_rad_s;
    const double axial = in.preload_n / z;
    const double distance = (in.groove_ratio - 0.5) * d;
    const double free = 2 * distance * std::cos(in.contact_angle_deg * rad_per_deg);
    const auto state = [&](double alpha_outer) {
      return ball_state(alpha_outer, axial, centrifugal, k_inner, k_outer);
    };
    const auto gap = [&](double alpha_outer) {
      const BallState s = state(alpha_outer);
      return (distance + s.approach_inner) * std::cos(s.alpha_inner) +
             (distance + s.approach_outer) * std::cos(alpha_outer) - free;
    };
    double low = 0;
    double high = 0;
    double before = gap(0.25 * rad_per_deg);
    for (int k = 2; k <= 260 && high == 0; ++k) {
      const double here = gap(0.25 * k * rad_per_deg);
      if (before > 0 && here <= 0) {
        low = 0.25 * (k - 1) * rad_per_deg;
        high = 0.25 * k * rad_per_deg;
      }
      before = here;
    }
    if (high == 0)
      throw DomainError(
          "spindle_speed_rpm",
          fmt::format("spindle_speed_rpm = {}, no equilibrium: the centrifugal load {:.4g} N of a "
                      "ball is too large for preload_n = {}",
                      in.spindle_speed_rpm, centrifugal, in.preload_n));
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (gap(middle) > 0 ? low : high) = middle;
    }
    const double alpha_outer = 0.5 * (low + high);
    const BallState s = state(alpha_outer);
    const Eigen::Matrix2d inner =
        contact_matrix(k_inner, s.approach_inner, s.load_inner, distance, s.alpha_inner);
    const Eigen::Matrix2d outer =
        contact_matrix(k_outer, s.approach_outer, s.load_outer, distance, alpha_outer);
    const Eigen::Matrix2d sum = inner + outer;
    const Eigen::Matrix2d series = inner * sum.inverse() * outer;
    return SpeedStiffness{z * series(1, 1) / 1000,
                          z / 2 * series(0, 0) / 1000,
                          s.alpha_inner / rad_per_deg,
                          alpha_outer / rad_per_deg,
                          s.load_inner,
                          centrifugal};
  });
}

}  // namespace verstat::models::k201
