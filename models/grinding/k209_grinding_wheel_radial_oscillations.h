#pragma once
// Radial oscillations of a grinding wheel: measured spectra and what they do to the ground face (K209).
//
// Forced oscillations of a diamond wheel in flat plunge grinding come from the eccentric seat of the wheel on
// its flanges. The measured amplitudes for ordinary flanges and for a centring device, the vibration of the
// headstock, the swing of the depth of cut and the waviness that one harmonic leaves.
//
// Azarova, Sidorov, Tsokur 2011. The paper contains no equations: all but frequency and speed is a
// completion.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k209 {

struct Spindle {
  double spindle_rpm = 0;
};
struct Frequency {
  double freq_hz;
};
/// First harmonic, n / 60.
[[nodiscard]] Frequency rotation_frequency(const Spindle& in);

struct Wheel {
  double wheel_diameter_mm = 0;
  double spindle_rpm = 0;
};
struct WheelSpeed {
  double speed_m_s;
};
/// Peripheral speed, pi D n / 60000.
[[nodiscard]] WheelSpeed wheel_speed(const Wheel& in);

enum class Mounting { standard_flange, centring_device };
enum class State { idle, grinding };

struct VibrationCase {
  Mounting mounting = Mounting::standard_flange;
  State state = State::grinding;
  std::int64_t harmonic = 1;
};
struct VibrationAmplitude {
  double amplitude_um;
  std::int64_t exact;  // 1 printed value, 0 upper bound
};
/// Measured amplitude of the wheel axis, K209 data (3D711AF11, 2230 1/min). The device was not measured idle.
[[nodiscard]] VibrationAmplitude wheel_vibration_amplitude(const VibrationCase& in);

struct OscillationInputs {
  double t_s = 0;
  double spindle_rpm = 0;
  std::vector<std::int64_t> harmonic;
  std::vector<double> amplitude_um;
  std::vector<double> phase_deg;
};
struct Displacement {
  double x_um;
};
/// x(t) = sum of A_k cos(2 pi k f t + phi_k). Lists of the same length.
[[nodiscard]] Displacement wheel_radial_displacement(const OscillationInputs& in);

struct WheelOffset {
  double wheel_offset_um = 0;
  double base_um = 0.24;
  double amplitude_at_ref_um = 0.79;
  double ref_offset_um = 100;
};
struct Amplitude {
  double amplitude_um;
};
/// Vibration of the spindle housing at the rotation frequency, linear in the offset (in phase: worst case).
/// COMPLETION.
[[nodiscard]] Amplitude headstock_amplitude(const WheelOffset& in);

struct Unbalance {
  double wheel_mass_kg = 0;
  double offset_um = 0;
  double spindle_rpm = 0;
};
struct Force {
  double force_n;
};
/// Centrifugal force m e omega^2. COMPLETION.
[[nodiscard]] Force unbalance_force(const Unbalance& in);

struct Modulation {
  double amplitude_um = 0;
  double depth_mm = 0;
};
struct Ratio {
  double ratio;
};
/// Swing of the depth of cut, amplitude over depth.
[[nodiscard]] Ratio depth_modulation(const Modulation& in);

struct WavinessInputs {
  double amplitude_um = 0;
  double spindle_rpm = 0;
  std::int64_t harmonic = 1;
  double table_speed_m_min = 0;
  double wheel_diameter_mm = 0;
};
struct Waviness {
  double wavelength_mm;
  double height_um;
  double critical_amplitude_um;
};
/// Waviness of one pass: envelope of a wheel that oscillates with one harmonic. Up to the critical amplitude
/// 1/(k^2 R) the height is 2 A, above it the wheel no longer reaches into the troughs. COMPLETION.
[[nodiscard]] Waviness flat_grinding_waviness(const WavinessInputs& in);

struct Spectrum {
  std::vector<std::int64_t> harmonic;
  std::vector<double> amplitude_um;
  double threshold_um = 0.5;
};
struct Harmonics {
  std::vector<std::int64_t> kept;
};
/// Harmonics with an amplitude of at least the threshold.
[[nodiscard]] Harmonics significant_harmonics(const Spectrum& in);

}  // namespace verstat::models::k209

template <>
struct verstat::models::EnumNames<verstat::models::k209::Mounting> {
  static constexpr std::array names{std::pair{k209::Mounting::standard_flange, "standard_flange"},
                                    std::pair{k209::Mounting::centring_device, "centring_device"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k209::State> {
  static constexpr std::array names{std::pair{k209::State::idle, "idle"},
                                    std::pair{k209::State::grinding, "grinding"}};
};
