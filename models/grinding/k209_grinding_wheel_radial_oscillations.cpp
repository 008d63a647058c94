#include "models/grinding/k209_grinding_wheel_radial_oscillations.h"

#include <cmath>
#include <numbers>

#include "models/math/solve.h"

namespace verstat::models::k209 {
namespace {

using std::numbers::pi;

constexpr double um_mm = 1000;
constexpr double unresolved_um = 0.5;  // bound of every harmonic that is not printed

struct MeasuredAmplitude {
  Mounting mounting;
  State state;
  std::int64_t harmonic;
  double amplitude_um;
};
// Printed amplitudes of the wheel axis; 0.9 of the device is "not above 0.9" in the text and 0.9 in the
// conclusions.
constexpr MeasuredAmplitude measured[] = {{Mounting::standard_flange, State::idle, 1, 2.07},
                                          {Mounting::standard_flange, State::idle, 2, 0.79},
                                          {Mounting::standard_flange, State::grinding, 1, 2.36},
                                          {Mounting::standard_flange, State::grinding, 2, 0.81},
                                          {Mounting::standard_flange, State::grinding, 3, 0.51},
                                          {Mounting::standard_flange, State::grinding, 5, 0.57},
                                          {Mounting::standard_flange, State::grinding, 6, 0.56},
                                          {Mounting::centring_device, State::grinding, 1, 0.9}};

void require_as_many(std::size_t entries, std::string_view input, std::size_t harmonics) {
  require(entries == harmonics, input, static_cast<std::int64_t>(entries),
          "entries: must have as many as harmonic, " + std::to_string(harmonics));
}

// u in (0, pi) with sin(u)/u = share, 0 < share < 1; pi when the share is below what a double tells from 0.
double sinc_root(double share) {
  const auto excess = [share](double u) { return (u == 0 ? 1 : std::sin(u) / u) - share; };
  if (excess(pi) >= 0) return pi;
  return find_root(excess, 0, pi);
}

}  // namespace

Frequency rotation_frequency(const Spindle& in) {
  return guarded<&rotation_frequency>(in, [&] { return Frequency{in.spindle_rpm / 60}; });
}

WheelSpeed wheel_speed(const Wheel& in) {
  return guarded<&wheel_speed>(
      in, [&] { return WheelSpeed{pi * in.wheel_diameter_mm * in.spindle_rpm / 60000}; });
}

VibrationAmplitude wheel_vibration_amplitude(const VibrationCase& in) {
  return guarded<&wheel_vibration_amplitude>(in, [&] {
    require(in.mounting == Mounting::standard_flange || in.state == State::grinding, "state", "idle",
            "must be \"grinding\": the centring device was not measured idle");
    for (const MeasuredAmplitude& m : measured)
      if (m.mounting == in.mounting && m.state == in.state && m.harmonic == in.harmonic)
        return VibrationAmplitude{m.amplitude_um, 1};
    return VibrationAmplitude{unresolved_um, 0};
  });
}

Displacement wheel_radial_displacement(const OscillationInputs& in) {
  return guarded<&wheel_radial_displacement>(in, [&] {
    require_as_many(in.amplitude_um.size(), "amplitude_um", in.harmonic.size());
    require_as_many(in.phase_deg.size(), "phase_deg", in.harmonic.size());
    double sum = 0;
    for (std::size_t k = 0; k < in.harmonic.size(); ++k) {
      // Whole turns are dropped first, so that late times keep their phase.
      const double turns =
          std::remainder(static_cast<double>(in.harmonic[k]) * in.spindle_rpm / 60 * in.t_s, 1);
      sum += in.amplitude_um[k] * std::cos(2 * pi * turns + in.phase_deg[k] * pi / 180);
    }
    return Displacement{sum};
  });
}

Amplitude headstock_amplitude(const WheelOffset& in) {
  return guarded<&headstock_amplitude>(in, [&] {
    return Amplitude{in.base_um +
                     (in.amplitude_at_ref_um - in.base_um) * in.wheel_offset_um / in.ref_offset_um};
  });
}

Force unbalance_force(const Unbalance& in) {
  return guarded<&unbalance_force>(in, [&] {
    const double omega = 2 * pi * in.spindle_rpm / 60;
    return Force{in.wheel_mass_kg * in.offset_um * 1e-6 * omega * omega};
  });
}

Ratio depth_modulation(const Modulation& in) {
  return guarded<&depth_modulation>(in, [&] { return Ratio{in.amplitude_um / um_mm / in.depth_mm}; });
}

Waviness flat_grinding_waviness(const WavinessInputs& in) {
  return guarded<&flat_grinding_waviness>(in, [&] {
    const double frequency_hz = static_cast<double>(in.harmonic) * in.spindle_rpm / 60;
    const double wavelength_mm = in.table_speed_m_min * 1000 / 60 / frequency_hz;
    const double wave_number = 2 * pi / wavelength_mm;
    const double critical_mm = 2 / (wave_number * wave_number * in.wheel_diameter_mm);
    const double amplitude_mm = in.amplitude_um / um_mm;
    double height_mm = 2 * amplitude_mm;
    if (amplitude_mm > critical_mm) {
      const double u = sinc_root(critical_mm / amplitude_mm);
      const double c = std::cos(u / 2);
      height_mm = 2 * amplitude_mm * c * c + u * u * critical_mm / 2;  // A (1 + cos u) + u^2 / (2 k^2 R)
    }
    return Waviness{wavelength_mm, um_mm * height_mm, um_mm * critical_mm};
  });
}

Harmonics significant_harmonics(const Spectrum& in) {
  return guarded<&significant_harmonics>(in, [&] {
    require_as_many(in.amplitude_um.size(), "amplitude_um", in.harmonic.size());
    Harmonics out;
    for (std::size_t k = 0; k < in.harmonic.size(); ++k)
      if (in.amplitude_um[k] >= in.threshold_um) out.kept.push_back(in.harmonic[k]);
    return out;
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K209",
       .title = "Determination of parameters of radial oscillations of the grinding wheel accompanying the "
                "processing",
       .authors = "Azarova N. V., Sidorov V. A., Tsokur V. P.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011, "
                    "pp. 189-194",
       .models =
           "Forced radial oscillations of a diamond wheel in flat plunge grinding from the eccentric seat of "
           "the wheel: measured spectra for ordinary flanges and for a centring device, and the waviness, "
           "depth swing and forces that follow.",
       .role = "grinding",
       .errata = {"The first harmonic of the centring device is \"not above 0.9\" in the text and 0.9 in the "
                  "conclusions: taken as 0.9."}});

  const auto spindle = [](auto& f, auto member) {
    f.input(member, "spindle_rpm", "n", "1/min", positive(), "spindle speed", 2230.0);
  };
  const auto spectrum = [](auto& f, auto harmonics, auto amplitudes) {
    f.input(harmonics, "harmonic", "k", "1", at_least(1), "numbers of the harmonics",
            Value::List{1, 2, 3, 5, 6})
        .input(amplitudes, "amplitude_um", "A_k", "um", non_negative(), "their amplitudes",
               Value::List{2.36, 0.81, 0.51, 0.57, 0.56});
  };

  source
      .function<&rotation_frequency>("rotation_frequency", "First harmonic.", "definition", Provenance::paper)
      .with([&](auto& f) { spindle(f, &Spindle::spindle_rpm); })
      .output(&Frequency::freq_hz, "freq_hz", "f", "Hz", positive(), "frequency");
  source
      .function<&wheel_speed>("wheel_speed", "Peripheral speed of the wheel.", "definition",
                              Provenance::paper)
      .input(&Wheel::wheel_diameter_mm, "wheel_diameter_mm", "D", "mm", positive(), "wheel diameter", 250.0)
      .with([&](auto& f) { spindle(f, &Wheel::spindle_rpm); })
      .output(&WheelSpeed::speed_m_s, "speed_m_s", "v_k", "m/s", positive(), "speed");
  source
      .function<&wheel_vibration_amplitude>("wheel_vibration_amplitude",
                                            "Measured amplitude of the wheel axis.", "data of the paper",
                                            Provenance::paper)
      .input(&VibrationCase::mounting, "mounting", "-", "-", no_range(), "how the wheel is mounted",
             "standard_flange")
      .input(&VibrationCase::state, "state", "-", "-", no_range(),
             "idle or grinding; the device only grinding", "grinding")
      .input(&VibrationCase::harmonic, "harmonic", "h", "1", at_least(1), "number of the harmonic", 1)
      .output(&VibrationAmplitude::amplitude_um, "amplitude_um", "A", "um", non_negative(), "amplitude")
      .output(&VibrationAmplitude::exact, "exact", "-", "1", closed(0, 1),
              "1: printed value, 0: upper bound 0.5 um")
      .note("One machine, one wheel, 2230 1/min: other speeds need a transfer function.");
  source
      .function<&wheel_radial_displacement>("wheel_radial_displacement", "Displacement of the wheel in time.",
                                            "sum of harmonics", Provenance::completion)
      .input(&OscillationInputs::t_s, "t_s", "t", "s", any(), "time", 0.003)
      .with([&](auto& f) {
        spindle(f, &OscillationInputs::spindle_rpm);
        spectrum(f, &OscillationInputs::harmonic, &OscillationInputs::amplitude_um);
      })
      .input(&OscillationInputs::phase_deg, "phase_deg", "phi_k", "deg", any(), "their phases",
             Value::List{0.0, 30.0, 60.0, 90.0, 120.0})
      .output(&Displacement::x_um, "x_um", "x", "um", any(), "displacement")
      .note("The paper gives no phases.");
  source
      .function<&headstock_amplitude>("headstock_amplitude", "Vibration of the spindle housing.",
                                      "completion, linear", Provenance::completion)
      .input(&WheelOffset::wheel_offset_um, "wheel_offset_um", "e", "um", non_negative(),
             "offset of the wheel axis", 40.0)
      .optional(&WheelOffset::base_um, "base_um", "A_0", "um", non_negative(), "amplitude without offset")
      .optional(&WheelOffset::amplitude_at_ref_um, "amplitude_at_ref_um", "A_ref", "um", non_negative(),
                "amplitude at the reference offset")
      .optional(&WheelOffset::ref_offset_um, "ref_offset_um", "e_ref", "um", positive(), "reference offset")
      .output(&Amplitude::amplitude_um, "amplitude_um", "A_head", "um", any(), "amplitude")
      .note("In phase, the worst case: the true sum is a vector sum.");
  source
      .function<&unbalance_force>("unbalance_force", "Centrifugal force of an offset wheel.", "m e omega^2",
                                  Provenance::completion)
      .input(&Unbalance::wheel_mass_kg, "wheel_mass_kg", "m", "kg", positive(), "mass of the wheel", 1.8)
      .input(&Unbalance::offset_um, "offset_um", "e", "um", non_negative(), "offset of the wheel axis", 100.0)
      .with([&](auto& f) { spindle(f, &Unbalance::spindle_rpm); })
      .output(&Force::force_n, "force_n", "F", "N", non_negative(), "force");
  source
      .function<&depth_modulation>("depth_modulation", "Relative swing of the depth of cut.", "A / t",
                                   Provenance::completion)
      .input(&Modulation::amplitude_um, "amplitude_um", "A", "um", non_negative(), "amplitude", 0.9)
      .input(&Modulation::depth_mm, "depth_mm", "t", "mm", positive(), "depth of cut", 0.015)
      .output(&Ratio::ratio, "ratio", "A/t", "1", non_negative(), "swing over depth");
  source
      .function<&flat_grinding_waviness>("flat_grinding_waviness", "Waviness that one harmonic leaves.",
                                         "completion, envelope", Provenance::completion)
      .input(&WavinessInputs::amplitude_um, "amplitude_um", "A", "um", positive(), "amplitude", 2.36)
      .with([&](auto& f) { spindle(f, &WavinessInputs::spindle_rpm); })
      .input(&WavinessInputs::harmonic, "harmonic", "h", "1", at_least(1), "number of the harmonic", 1)
      .input(&WavinessInputs::table_speed_m_min, "table_speed_m_min", "v_t", "m/min", positive(),
             "table speed", 6.0)
      .input(&WavinessInputs::wheel_diameter_mm, "wheel_diameter_mm", "D", "mm", positive(), "wheel diameter",
             250.0)
      .output(&Waviness::wavelength_mm, "wavelength_mm", "lambda", "mm", positive(), "length of a wave")
      .output(&Waviness::height_um, "height_um", "h", "um", positive(), "height of the waves")
      .output(&Waviness::critical_amplitude_um, "critical_amplitude_um", "A_cr", "um", positive(),
              "amplitude above which the wheel no longer reaches the troughs")
      .note(
          "One pass at constant phase without spark-out, amplitude below the depth of cut: an additive "
          "waviness term, never Ra.");
  source
      .function<&significant_harmonics>("significant_harmonics", "Harmonics that matter.", "conclusions",
                                        Provenance::paper)
      .with([&](auto& f) { spectrum(f, &Spectrum::harmonic, &Spectrum::amplitude_um); })
      .optional(&Spectrum::threshold_um, "threshold_um", "-", "um", non_negative(),
                "smallest amplitude that is kept")
      .output(&Harmonics::kept, "kept", "-", "1", at_least(1), "harmonics kept");
}

}  // namespace verstat::models::k209
