#pragma once
// Parametric resonance of spindle angular-contact ball bearings (K201): the bearing's stiffness varies as the
// cage turns, and at some speeds the vibration of the inner ring grows by itself. Mathieu's equation, its
// instability zones, growth rates with damping, forbidden speed bands, and a Hertz/Jones stiffness for
// bearings that were not measured.
//
// Danylchenko, Kolomiiets 2011. Frequencies in rad/s, stiffness in N/um, angles in degrees.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k201 {

struct BallBearing {
  double ball_diameter_mm = 3.17;
  double pitch_diameter_mm = 41;
  double contact_angle_deg = 15;
};
struct Ratio {
  double ratio;
};
/// Cage speed over spindle speed, rotating inner ring: (1 - d cos(alpha) / D) / 2. COMPLETION (rolling).
/// 0 < d < D, 0..40 deg.
[[nodiscard]] Ratio cage_speed_ratio(const BallBearing& in);

struct StiffnessSamples {
  std::vector<double> samples_n_per_um;
  std::int64_t harmonics = 1;
};
struct StiffnessHarmonics {
  double mean_n_per_um;
  std::vector<double> amplitudes_n_per_um;
  std::vector<double> phases_rad;
};
/// Fourier form (4) of stiffness samples at equal cage angles over one revolution; 1 <= harmonics < N/2. The
/// phase of a zero harmonic is arbitrary.
[[nodiscard]] StiffnessHarmonics stiffness_harmonics(const StiffnessSamples& in);

struct RingStiffness {
  double mass_kg = 0;
  double c_xx = 0, c_yy = 0, c_zz = 0;  // N/um
  double c_xy = 0, c_xz = 0, c_yz = 0;
};
struct RingFrequencies {
  double p1_rad_s, p2_rad_s, p3_rad_s;
};
/// Natural frequencies of the ring on the stiffness matrix, ascending, eqs. (1), (2); 0 for an eigenvalue
/// that is not positive.
[[nodiscard]] RingFrequencies bearing_natural_frequencies(const RingStiffness& in);

struct StiffnessMatrix {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;  // N/um
};
struct ModulationInputs {
  StiffnessMatrix mean;
  StiffnessMatrix harmonic;
};
struct Modulation {
  std::vector<double> k0_n_per_um;
  std::vector<double> kr_n_per_um;
  std::vector<double> ratio;
};
/// Mean principal stiffness and amplitude of a harmonic in every mode, eqs. (5), (6), modes ascending in K_0.
/// Where mean eigenvalues coincide (within 1e-9 of the largest) the modes also diagonalize the harmonic.
/// Error when a K_0 is not positive.
[[nodiscard]] Modulation principal_stiffness_modulation(const ModulationInputs& in);

struct MathieuInputs {
  double natural_frequency_rad_s = 0;
  double spindle_speed_rpm = 0;
  double cage_ratio = 0;
  std::int64_t harmonic = 1;
  double stiffness_ratio = 0;
};
struct MathieuParameters {
  double omega_exc_rad_s;
  double a;
  double b;
};
/// Parameters of Mathieu's equation for the excitation at r omega_c, eq. (8).
[[nodiscard]] MathieuParameters mathieu_parameters(const MathieuInputs& in);

struct ZoneTip {
  double natural_frequency_rad_s = 0;
  double cage_ratio = 0;
  std::int64_t harmonic = 1;
  std::int64_t zone = 1;
};
struct Speed {
  double speed_rpm;
};
/// Speed at the tip of instability zone k (a = k^2): n = 60 p / (pi k r ratio). From eq. (8).
[[nodiscard]] Speed parametric_critical_speed(const ZoneTip& in);

struct MathieuPoint {
  double a = 0;
  double b = 0;
};
struct Floquet {
  double half_trace;
  int unstable;
  double growth_per_tau;
};
/// Stability of y'' + (a + 2 b cos 2 tau) y = 0, eq. (7), by the monodromy matrix over pi (Runge-Kutta 4).
/// -5 <= a <= 100, |b| <= 20.
[[nodiscard]] Floquet mathieu_floquet(const MathieuPoint& in);

struct ZoneAt {
  std::int64_t zone = 1;
  double b = 0;
};
struct ZoneEdges {
  double a_low;
  double a_high;
};
/// Borders of zone k = 1..10 of the Ince-Strutt diagram: the Mathieu characteristic values b_k, a_k at q =
/// |b|.
[[nodiscard]] ZoneEdges mathieu_zone_edges(const ZoneAt& in);

struct GrowthInputs {
  double natural_frequency_rad_s = 0;
  double omega_exc_rad_s = 0;
  double stiffness_ratio = 0;
  double damping_ratio = 0;
};
struct Growth {
  double growth_1_s;
  int unstable;
};
/// Net exponential growth rate with viscous damping, 1/s; negative decays. COMPLETION (exact).
[[nodiscard]] Growth parametric_growth_rate(const GrowthInputs& in);

struct BandInputs {
  std::vector<double> speed_nodes_rpm;
  std::vector<double> p_nodes_rad_s;
  std::vector<double> ratio_nodes;
  double cage_ratio = 0;
  std::int64_t harmonic = 1;
  double damping_ratio = 0;
  double n_min_rpm = 0;
  double n_max_rpm = 0;
  double step_rpm = 20;
};
struct SpeedBand {
  std::int64_t zone = 0;
  double n_low_rpm = 0;
  double n_high_rpm = 0;
};
struct SpeedBands {
  std::vector<SpeedBand> bands;
};
/// Speed bands in which the vibration grows; p(n) and K_r/K_0(n) piecewise linear in the nodes, constant
/// outside. A band narrower than the step can be missed.
[[nodiscard]] SpeedBands parametric_speed_bands(const BandInputs& in);

enum class Regime { parametric, forced_resonance, quiet };
struct RegimeInputs {
  double a = 0;
  double b = 0;
  double damping_ratio = 0;
  double resonance_tolerance = 0.05;
};
struct RegimeState {
  Regime regime;
};
/// Conclusions 1-3: growth beats damping, or plain resonance |sqrt(a)/2 - 1| < tolerance, or neither.
[[nodiscard]] RegimeState bearing_excitation_regime(const RegimeInputs& in);

struct ForcedInputs {
  double excitation_um = 0;
  double omega_exc_rad_s = 0;
  double natural_frequency_rad_s = 0;
  double damping_ratio = 0;
};
struct Amplitude {
  double amplitude_um;
};
/// Amplitude under kinematic excitation through the spring, damper to the ground. COMPLETION. Error without
/// damping at resonance.
[[nodiscard]] Amplitude forced_vibration_amplitude(const ForcedInputs& in);

struct PreloadedBearing {
  double ball_diameter_mm = 0;
  double pitch_diameter_mm = 0;
  double contact_angle_deg = 0;
  std::int64_t balls = 1;
  double preload_n = 0;
  double groove_ratio = 0.52;
};
struct StaticStiffness {
  double axial_n_per_um;
  double radial_n_per_um;
};
/// Stiffness at rest with a fixed contact angle 5..40 deg (Hertz, Hamrock-Brewe). COMPLETION.
[[nodiscard]] StaticStiffness bearing_static_stiffness(const PreloadedBearing& in);

struct SpinningBearing : PreloadedBearing {
  double spindle_speed_rpm = 0;
  double ball_density_kg_mm3 = 7.8e-6;
};
struct SpeedStiffness {
  double axial_n_per_um;
  double radial_n_per_um;
  double alpha_inner_deg;
  double alpha_outer_deg;
  double ball_load_inner_n;
  double centrifugal_n;
};
/// Quasi-static stiffness at speed with constant axial preload (Jones). COMPLETION; does not reproduce the
/// paper's bearing. Error when the centrifugal load is too large for the preload.
[[nodiscard]] SpeedStiffness bearing_stiffness_at_speed(const SpinningBearing& in);

}  // namespace verstat::models::k201

template <>
struct verstat::models::EnumNames<verstat::models::k201::Regime> {
  static constexpr std::array names{std::pair{k201::Regime::parametric, "parametric"},
                                    std::pair{k201::Regime::forced_resonance, "forced_resonance"},
                                    std::pair{k201::Regime::quiet, "quiet"}};
};

template <>
struct verstat::models::StructFields<verstat::models::k201::StiffnessMatrix> {
  static std::vector<Field> fields() {
    using M = k201::StiffnessMatrix;
    const auto element = [](double M::*pointer, const char* name) {
      return member<M>(pointer, name, std::string("c_") + name, "N/um", any(),
                       std::string("stiffness element ") + name);
    };
    return {element(&M::xx, "xx"), element(&M::yy, "yy"), element(&M::zz, "zz"),
            element(&M::xy, "xy"), element(&M::xz, "xz"), element(&M::yz, "yz")};
  }
};

template <>
struct verstat::models::StructFields<verstat::models::k201::SpeedBand> {
  static std::vector<Field> fields() {
    using B = k201::SpeedBand;
    return {member<B>(&B::zone, "zone", "k", "1", at_least(0), "instability zone"),
            member<B>(&B::n_low_rpm, "n_low_rpm", "n", "rpm", positive(), "lower end"),
            member<B>(&B::n_high_rpm, "n_high_rpm", "n", "rpm", positive(), "upper end")};
  }
};
