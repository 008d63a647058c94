#include "models/dynamics/k201_bearing_resonance.h"

namespace verstat::models::k201 {
namespace {

Value numbers(std::initializer_list<double> values) {
  Value::List list;
  for (const double v : values) list.emplace_back(v);
  return list;
}

void describe_stiffness(Source& source) {
  source
      .function<&cage_speed_ratio>("cage_speed_ratio", "Cage speed over spindle speed.", "rolling kinematics",
                                   Provenance::completion)
      .optional(&BallBearing::ball_diameter_mm, "ball_diameter_mm", "d_w", "mm", positive(),
                "ball diameter, below the pitch diameter")
      .optional(&BallBearing::pitch_diameter_mm, "pitch_diameter_mm", "D_pw", "mm", positive(),
                "pitch diameter")
      .optional(&BallBearing::contact_angle_deg, "contact_angle_deg", "alpha", "deg", closed(0, 40),
                "contact angle")
      .output(&Ratio::ratio, "ratio", "omega_c/omega", "1", closed(0, 0.5), "cage speed over spindle speed");
  source
      .function<&stiffness_harmonics>("stiffness_harmonics",
                                      "Harmonics of a stiffness element over one cage revolution.", "eq. (4)",
                                      Provenance::paper)
      .input(&StiffnessSamples::samples_n_per_um, "samples_n_per_um", "c_ij", "N/um", any(),
             "stiffness at equally spaced cage angles",
             numbers({12.9, 12.5, 12.0, 11.5, 11.2, 11.4, 12.1, 12.7}))
      .length(3, 10'000)
      .input(&StiffnessSamples::harmonics, "n_harmonics", "n", "1", at_least(1),
             "harmonics wanted, below half of the samples", 3)
      .output(&StiffnessHarmonics::mean_n_per_um, "mean_n_per_um", "c_0", "N/um", any(), "mean")
      .output(&StiffnessHarmonics::amplitudes_n_per_um, "amplitudes_n_per_um", "c_m", "N/um", non_negative(),
              "amplitudes")
      .output(&StiffnessHarmonics::phases_rad, "phases_rad", "phi_m", "rad", any(),
              "phases; arbitrary for a zero amplitude");
  source
      .function<&bearing_natural_frequencies>("bearing_natural_frequencies",
                                              "Natural frequencies of the ring on the bearing stiffness.",
                                              "eqs. (1), (2)", Provenance::paper)
      .input(&RingStiffness::mass_kg, "mass_kg", "m", "kg", positive(), "mass of the inner ring", 0.015)
      .input(&RingStiffness::c_xx, "c_xx", "c_xx", "N/um", any(), "radial stiffness", 12.0)
      .input(&RingStiffness::c_yy, "c_yy", "c_yy", "N/um", any(), "radial stiffness", 12.0)
      .input(&RingStiffness::c_zz, "c_zz", "c_zz", "N/um", any(), "axial stiffness", 1.8)
      .optional(&RingStiffness::c_xy, "c_xy", "c_xy", "N/um", any(), "cross stiffness")
      .optional(&RingStiffness::c_xz, "c_xz", "c_xz", "N/um", any(), "cross stiffness")
      .optional(&RingStiffness::c_yz, "c_yz", "c_yz", "N/um", any(), "cross stiffness")
      .output(&RingFrequencies::p1_rad_s, "p1_rad_s", "p_1", "rad/s", non_negative(), "lowest frequency")
      .output(&RingFrequencies::p2_rad_s, "p2_rad_s", "p_2", "rad/s", non_negative(), "second frequency")
      .output(&RingFrequencies::p3_rad_s, "p3_rad_s", "p_3", "rad/s", non_negative(), "third frequency");
  const auto elements = [](double xx, double yy, double zz, double xy) {
    return Value::Map{{"xx", xx}, {"yy", yy}, {"zz", zz}, {"xy", xy}, {"xz", 0.0}, {"yz", 0.0}};
  };
  source
      .function<&principal_stiffness_modulation>("principal_stiffness_modulation",
                                                 "Principal stiffness and its modulation by one harmonic.",
                                                 "eqs. (5), (6)", Provenance::paper)
      .input(&ModulationInputs::mean, "mean_matrix", "c_0", "N/um", no_range(), "mean stiffness matrix",
             elements(12.6, 12.6, 1.8, 7.1))
      .input(&ModulationInputs::harmonic, "harmonic_matrix", "c_r", "N/um", no_range(),
             "amplitudes of the harmonic, elements in phase", elements(0.6, 0.3, 0.7, 0.4))
      .output(&Modulation::k0_n_per_um, "k0_n_per_um", "K_0l", "N/um", positive(),
              "mean principal stiffness, ascending")
      .output(&Modulation::kr_n_per_um, "kr_n_per_um", "K_rl", "N/um", non_negative(),
              "amplitude of the harmonic in the mode")
      .output(&Modulation::ratio, "ratio", "K_rl/K_0l", "1", non_negative(), "modulation")
      .note("Where mean eigenvalues coincide the modes are those that also diagonalize the harmonic.");
}

void describe_mathieu(Source& source) {
  const auto frequency = [](auto& f, auto pointer) {
    f.input(pointer, "natural_frequency_rad_s", "p_l", "rad/s", positive(), "natural frequency", 10880.0);
  };
  const auto cage = [](auto& f, auto pointer) {
    f.input(pointer, "cage_ratio", "omega_c/omega", "1", positive(), "cage speed over spindle speed",
            0.46266);
  };
  const auto harmonic = [](auto& f, auto pointer) {
    f.input(pointer, "harmonic", "r", "1", at_least(1), "harmonic of the cage frequency", 4);
  };
  const auto damping = [](auto& f, auto pointer) {
    f.input(pointer, "damping_ratio", "zeta", "1", closed(0, 0.2), "damping ratio; 0.01-0.05 usual", 0.02);
  };
  source
      .function<&mathieu_parameters>("mathieu_parameters", "Parameters of Mathieu's equation.", "eq. (8)",
                                     Provenance::paper)
      .with([&](auto& f) { frequency(f, &MathieuInputs::natural_frequency_rad_s); })
      .input(&MathieuInputs::spindle_speed_rpm, "spindle_speed_rpm", "n", "rpm", positive(), "spindle speed",
             34300.0)
      .with([&](auto& f) {
        cage(f, &MathieuInputs::cage_ratio);
        harmonic(f, &MathieuInputs::harmonic);
      })
      .input(&MathieuInputs::stiffness_ratio, "stiffness_ratio", "K_rl/K_0l", "1", closed(0, 1),
             "modulation of the stiffness", 0.42)
      .output(&MathieuParameters::omega_exc_rad_s, "omega_exc_rad_s", "omega_r", "rad/s", positive(),
              "excitation frequency")
      .output(&MathieuParameters::a, "a", "a_l", "1", positive(), "parameter a")
      .output(&MathieuParameters::b, "b", "b_l", "1", non_negative(), "parameter b");
  source
      .function<&parametric_critical_speed>("parametric_critical_speed",
                                            "Spindle speed at the tip of an instability zone.",
                                            "eq. (8), a = k^2", Provenance::paper)
      .with([&](auto& f) {
        frequency(f, &ZoneTip::natural_frequency_rad_s);
        cage(f, &ZoneTip::cage_ratio);
        harmonic(f, &ZoneTip::harmonic);
      })
      .input(&ZoneTip::zone, "zone", "k", "1", at_least(1), "instability zone", 3)
      .output(&Speed::speed_rpm, "speed_rpm", "n", "rpm", positive(), "spindle speed");
  source
      .function<&mathieu_floquet>("mathieu_floquet", "Stability of Mathieu's equation.", "eq. (7)",
                                  Provenance::paper)
      .input(&MathieuPoint::a, "a", "a", "1", closed(-5, 100), "parameter a", 1.0)
      .input(&MathieuPoint::b, "b", "b", "1", closed(-20, 20), "parameter b", 0.1)
      .output(&Floquet::half_trace, "half_trace", "H", "1", any(),
              "half trace of the monodromy matrix over pi")
      .output(&Floquet::unstable, "unstable", "-", "-", closed(0, 1), "the vibration grows")
      .output(&Floquet::growth_per_tau, "growth_per_tau", "-", "1", non_negative(),
              "exponent of growth per unit of tau");
  source
      .function<&mathieu_zone_edges>("mathieu_zone_edges", "Borders of a zone of the Ince-Strutt diagram.",
                                     "eq. (7)", Provenance::completion)
      .input(&ZoneAt::zone, "zone", "k", "1", closed(1, 10), "instability zone", 2)
      .input(&ZoneAt::b, "b", "b", "1", closed(-20, 20), "parameter b", 1.5)
      .output(&ZoneEdges::a_low, "a_low", "b_k", "1", any(), "lower border")
      .output(&ZoneEdges::a_high, "a_high", "a_k", "1", any(), "upper border");
  source
      .function<&parametric_growth_rate>("parametric_growth_rate", "Net growth rate of the vibration.",
                                         "completion", Provenance::completion)
      .with([&](auto& f) { frequency(f, &GrowthInputs::natural_frequency_rad_s); })
      .input(&GrowthInputs::omega_exc_rad_s, "omega_exc_rad_s", "omega_r", "rad/s", positive(),
             "excitation frequency", 21760.0)
      .input(&GrowthInputs::stiffness_ratio, "stiffness_ratio", "K_rl/K_0l", "1", closed(0, 1),
             "modulation of the stiffness", 0.4)
      .with([&](auto& f) { damping(f, &GrowthInputs::damping_ratio); })
      .output(&Growth::growth_1_s, "growth_1_s", "g", "1/s", any(), "growth rate; negative decays")
      .output(&Growth::unstable, "unstable", "-", "-", closed(0, 1), "the vibration grows")
      .note("The parameters must stay in a <= 100, b <= 20.");
  source
      .function<&parametric_speed_bands>("parametric_speed_bands",
                                         "Spindle speeds at which the vibration grows by itself.",
                                         "eqs. (7), (8)", Provenance::completion)
      .input(&BandInputs::speed_nodes_rpm, "speed_nodes_rpm", "n", "rpm", positive(),
             "speeds of the nodes, ascending", numbers({34300, 35642, 35880, 37500}))
      .length(1, 10'000)
      .input(&BandInputs::p_nodes_rad_s, "p_nodes_rad_s", "p_l", "rad/s", positive(),
             "natural frequency in the nodes", numbers({10880, 10564, 10507, 10110}))
      .length(1, 10'000)
      .input(&BandInputs::ratio_nodes, "ratio_nodes", "K_rl/K_0l", "1", closed(0, 1),
             "modulation of the stiffness in the nodes", numbers({0.42, 0.42, 0.42, 0.44}))
      .length(1, 10'000)
      .with([&](auto& f) {
        cage(f, &BandInputs::cage_ratio);
        harmonic(f, &BandInputs::harmonic);
        damping(f, &BandInputs::damping_ratio);
      })
      .input(&BandInputs::n_min_rpm, "n_min_rpm", "-", "rpm", positive(), "lowest speed", 35000.0)
      .input(&BandInputs::n_max_rpm, "n_max_rpm", "-", "rpm", positive(), "highest speed", 36500.0)
      .optional(&BandInputs::step_rpm, "step_rpm", "-", "rpm", positive(), "step of the scan")
      .output(&SpeedBands::bands, "bands", "-", "rpm", no_range(), "forbidden bands, ascending")
      .note("A band narrower than the step can be missed.")
      .note("Every harmonic stands on its own; combination resonances are not modelled.");
  source
      .function<&bearing_excitation_regime>("bearing_excitation_regime",
                                            "Whether the bearing excites parametric or plain vibration.",
                                            "conclusions 1-3", Provenance::completion)
      .input(&RegimeInputs::a, "a", "a", "1", open_low(0, 100), "parameter a", 4.0)
      .input(&RegimeInputs::b, "b", "b", "1", closed(-20, 20), "parameter b", 0.2)
      .with([&](auto& f) { damping(f, &RegimeInputs::damping_ratio); })
      .optional(&RegimeInputs::resonance_tolerance, "resonance_tolerance", "-", "1", non_negative(),
                "distance from plain resonance that still counts")
      .output(&RegimeState::regime, "regime", "-", "-", no_range(), "regime");
  source
      .function<&forced_vibration_amplitude>("forced_vibration_amplitude",
                                             "Amplitude of the forced vibration of the ring.", "completion",
                                             Provenance::completion)
      .input(&ForcedInputs::excitation_um, "excitation_amplitude_um", "e_r", "um", non_negative(),
             "amplitude of the kinematic excitation", 0.1)
      .input(&ForcedInputs::omega_exc_rad_s, "omega_exc_rad_s", "omega_r", "rad/s", positive(),
             "excitation frequency", 10000.0)
      .with([&](auto& f) { frequency(f, &ForcedInputs::natural_frequency_rad_s); })
      .input(&ForcedInputs::damping_ratio, "damping_ratio", "zeta", "1", non_negative(),
             "damping ratio, positive at resonance", 0.02)
      .output(&Amplitude::amplitude_um, "amplitude_um", "y", "um", non_negative(), "amplitude");
}

void describe_contact(Source& source) {
  const auto bearing = [](auto& f) {
    f.input(&PreloadedBearing::ball_diameter_mm, "ball_diameter_mm", "d_w", "mm", positive(),
            "ball diameter, below the pitch diameter", 3.17)
        .input(&PreloadedBearing::pitch_diameter_mm, "pitch_diameter_mm", "D_pw", "mm", positive(),
               "pitch diameter", 41.0)
        .input(&PreloadedBearing::contact_angle_deg, "contact_angle_deg", "alpha", "deg", closed(5, 40),
               "contact angle", 15.0)
        .input(&PreloadedBearing::balls, "balls", "z", "1", at_least(1), "number of balls", 26)
        .input(&PreloadedBearing::preload_n, "preload_n", "Q_0", "N", positive(), "axial preload", 60.0)
        .optional(&PreloadedBearing::groove_ratio, "groove_ratio", "f", "1", above(0.5),
                  "groove radius over ball diameter");
  };
  source
      .function<&bearing_static_stiffness>("bearing_static_stiffness",
                                           "Stiffness of a preloaded bearing at rest.",
                                           "completion (Hertz, Hamrock-Brewe)", Provenance::completion)
      .with(bearing)
      .output(&StaticStiffness::axial_n_per_um, "c_axial_n_per_um", "c_zz", "N/um", positive(),
              "axial stiffness")
      .output(&StaticStiffness::radial_n_per_um, "c_radial_n_per_um", "c_xx", "N/um", positive(),
              "radial stiffness");
  source
      .function<&bearing_stiffness_at_speed>("bearing_stiffness_at_speed",
                                             "Stiffness of a preloaded bearing at speed.",
                                             "completion (Jones)", Provenance::completion)
      .with(bearing)
      .input(&SpinningBearing::spindle_speed_rpm, "spindle_speed_rpm", "n", "rpm", positive(),
             "spindle speed", 34300.0)
      .optional(&SpinningBearing::ball_density_kg_mm3, "ball_density_kg_mm3", "rho", "kg/mm3", positive(),
                "density of the balls")
      .output(&SpeedStiffness::axial_n_per_um, "c_axial_n_per_um", "c_zz", "N/um", any(), "axial stiffness")
      .output(&SpeedStiffness::radial_n_per_um, "c_radial_n_per_um", "c_xx", "N/um", any(),
              "radial stiffness")
      .output(&SpeedStiffness::alpha_inner_deg, "alpha_inner_deg", "alpha_i", "deg", any(),
              "contact angle at the inner race")
      .output(&SpeedStiffness::alpha_outer_deg, "alpha_outer_deg", "alpha_o", "deg", any(),
              "contact angle at the outer race")
      .output(&SpeedStiffness::ball_load_inner_n, "ball_load_inner_n", "Q_i", "N", positive(),
              "load of a ball on the inner race")
      .output(&SpeedStiffness::centrifugal_n, "centrifugal_n", "F_c", "N", non_negative(),
              "centrifugal load of a ball")
      .note(
          "Does not reproduce the paper's stiffness at 34 300 rpm (1.8 and 12 N/um); prefer measured "
          "tables.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K201",
       .title = "Dynamics of spindle angular-contact ball bearings",
       .authors = "Danylchenko Yu. M., Kolomiiets V. I.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "A preloaded angular-contact ball bearing whose stiffness varies with the cage: natural "
                 "frequencies, instability zones of Mathieu's equation, growth rates with damping and the "
                 "forbidden spindle speeds.",
       .role = "dynamics",
       .errata = {"The printed speed bands cannot follow from the constant frequency named in the caption of "
                  "Fig. 3; they need a frequency that falls with speed."}});
  describe_stiffness(source);
  describe_mathieu(source);
  describe_contact(source);
}

}  // namespace verstat::models::k201
