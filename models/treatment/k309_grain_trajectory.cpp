#include "models/treatment/k309_grain_trajectory.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace verstat::models::k309 {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::int64_t most_grains = 1'000'000;  // their positions are sorted
constexpr double cover_slack_mm = 1e-9;

double mm_s_from_m_min(double speed) {
  return speed * 1000 / 60;
}

Position on_cylinder(const GrainOnCylinder& in, double travel_mm) {
  require(in.direction == 1 || in.direction == -1, "direction", in.direction, "must be 1 or -1");
  const double angle = mm_s_from_m_min(in.speed_m_min) * in.time_s / in.radius_mm;
  return {in.spacing_mm * static_cast<double>(in.grain) + travel_mm, in.radius_mm * std::cos(angle),
          static_cast<double>(in.direction) * in.radius_mm * std::sin(angle)};
}

// Triangle of period 1 between -1 and 1: 0 at 0, 1 at 1/4, -1 at 3/4.
double triangle(double cycles) {
  const double u = cycles - std::floor(cycles);
  if (u < 0.25) return 4 * u;
  return u < 0.75 ? 2 - 4 * u : 4 * u - 4;
}

double largest_gap(const GrainRow& in) {
  std::vector<double> tracks(static_cast<std::size_t>(in.grains));
  for (std::size_t k = 0; k < tracks.size(); ++k)
    tracks[k] = std::fmod(static_cast<double>(k) * in.spacing_mm, in.pitch_mm);
  std::ranges::sort(tracks);
  double gap = tracks.front() + (in.pitch_mm - tracks.back());  // around the circle
  for (std::size_t k = 1; k < tracks.size(); ++k) gap = std::max(gap, tracks[k] - tracks[k - 1]);
  return gap;
}

}  // namespace

Position grain_position(const GrainMove& in) {
  return guarded<&grain_position>(in, [&] { return on_cylinder(in, in.feed_mm_min / 60 * in.time_s); });
}

ScratchPattern scratch_pattern(const Helix& in) {
  return guarded<&scratch_pattern>(in, [&] {
    const double speed_rpm = 1000 * in.speed_m_min / (2 * pi * in.radius_mm);
    const double lay_deg = std::atan2(in.feed_mm_min, 1000 * in.speed_m_min) * 180 / pi;
    return ScratchPattern{speed_rpm, in.feed_mm_min / speed_rpm, lay_deg, 2 * lay_deg};
  });
}

ScratchLength scratch_length(const ScratchTime& in) {
  return guarded<&scratch_length>(in, [&] {
    return ScratchLength{in.time_s * std::hypot(mm_s_from_m_min(in.speed_m_min), in.feed_mm_min / 60)};
  });
}

Frequency oscillation_frequency(const Oscillation& in) {
  return guarded<&oscillation_frequency>(in, [&] {
    double amplitudes_per_cycle = 4;
    if (in.convention == AmplitudeConvention::stroke) amplitudes_per_cycle = 2;
    if (in.convention == AmplitudeConvention::printed) amplitudes_per_cycle = 1;
    return Frequency{in.feed_mm_min / 60 / (amplitudes_per_cycle * in.amplitude_mm)};
  });
}

Position oscillating_grain_position(const OscillatingGrain& in) {
  return guarded<&oscillating_grain_position>(in, [&] {
    const double swing_mm = in.amplitude_mm * triangle(in.frequency_hz * in.time_s + in.phase_cycles);
    return on_cylinder(in, in.mean_feed_mm_min / 60 * in.time_s + swing_mm);
  });
}

TrackGap track_max_gap(const GrainRow& in) {
  return guarded<&track_max_gap>(in, [&] {
    const double gap_mm = largest_gap(in);
    return TrackGap{gap_mm, gap_mm <= in.groove_width_mm + cover_slack_mm};
  });
}

PassTime mao_pass_time(const MaoPasses& in) {
  return guarded<&mao_pass_time>(in, [&] {
    const double travel_mm = in.width_mm + static_cast<double>(in.grains - 1) * in.spacing_mm;
    return PassTime{static_cast<double>(in.passes) * travel_mm / in.feed_mm_min};
  });
}

MaoResult mao_result(const MaoSetting& in) {
  return guarded<&mao_result>(in, [&] {
    const auto within = [](double x, double low, double high) { return low <= x && x <= high; };
    // 1 mm, 1.5 mm and 2000 rpm with 10 % to either side; the limits as decimals, so that they are included.
    const bool in_window = within(in.grain_size_um, 50, 300) && within(in.gap_mm, 0.9, 1.1) &&
                           within(in.amplitude_mm, 1.35, 1.65) && within(in.speed_rpm, 1800, 2200);
    return MaoResult{in_window, 0.05, 0.08};
  });
}

GroundState ground_state(const GroundBearing& in) {
  return guarded<&ground_state>(in, [&] {
    return in.material == BearingMaterial::nickel_composite ? GroundState{0.25, 2} : GroundState{0.31, 7};
  });
}

Roughness roughness_after_mao(const FinishingTime& in) {
  return guarded<&roughness_after_mao>(in, [&] {
    const double left = std::exp(-in.time_min / in.time_constant_min);
    return Roughness{in.ra_final_um + (in.ra_before_um - in.ra_final_um) * left};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K309",
       .title =
           "Prognostics of ferroabrasive grain motion path at the magnetic abrasive treatment of printing "
           "machines' bearings on the base of copper and nickel",
       .authors = "Havrysh A. P., Roik T. A., Melnyk O. O., Vitsiuk Yu. Yu.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Magnetic-abrasive finishing of cylindrical sleeve bearings: the part turns, a brush of "
           "ferro-abrasive grains feeds and oscillates along the axis. Paths of one grain and of a row, "
           "crossed scratches on reversal, coverage, pass time, and the settings published for Ra 0.05 to "
           "0.08 um.",
       .role = "treatment",
       .errata = {
           "The angle in eqs. (1)-(3) is printed V_n t/(2 pi R), which is a number of revolutions; V_n is a "
           "linear speed, so the angle is V_n t/R.",
           "f = V_S/A counts strokes of length A; a cycle covers 2 A (stroke) or 4 A (amplitude).",
           "The copper composite is printed with a letter for the digit 3: DN5M3KF9."}});

  const auto time_and_cylinder = [](auto& f) {
    f.input(&GrainOnCylinder::time_s, "t", "t", "s", non_negative(), "time", 0.1)
        .input(&GrainOnCylinder::radius_mm, "R", "R", "mm", positive(), "radius of the cylinder", 13.5)
        .input(&GrainOnCylinder::speed_m_min, "V_n", "V_n", "m/min", non_negative(), "circumferential speed",
               169.646);
  };
  const auto row = [](auto& f) {
    f.input(&GrainOnCylinder::grain, "k", "k", "1", at_least(0), "index of the grain in the row", 4)
        .input(&GrainOnCylinder::spacing_mm, "dh", "Delta h", "mm", non_negative(), "spacing of the grains",
               0.2)
        .input(&GrainOnCylinder::direction, "direction", "-", "1", closed(-1, 1),
               "direction of rotation, 1 or -1", 1);
  };
  const auto position = [](auto& f) {
    f.output(&Position::x_mm, "x", "x", "mm", any(), "along the axis")
        .output(&Position::y_mm, "y", "y", "mm", any(), "across the axis")
        .output(&Position::z_mm, "z", "z", "mm", any(), "across the axis");
  };
  source
      .function<&grain_position>("grain_position", "Position of a grain on the cylinder.", "eqs. (1)-(3)",
                                 Provenance::repaired)
      .with(time_and_cylinder)
      .input(&GrainMove::feed_mm_min, "V_S", "V_S", "mm/min", any(), "axial feed speed", 300.0)
      .with(row)
      .with(position);
  source
      .function<&scratch_pattern>("scratch_pattern", "Pitch and angles of the scratches.", "from eq. (1)",
                                  Provenance::repaired)
      .input(&Helix::radius_mm, "R", "R", "mm", positive(), "radius of the cylinder", 13.5)
      .input(&Helix::speed_m_min, "V_n", "V_n", "m/min", positive(), "circumferential speed", 169.646)
      .input(&Helix::feed_mm_min, "V_S", "V_S", "mm/min", non_negative(), "axial feed speed", 300.0)
      .output(&ScratchPattern::speed_rpm, "n", "n", "rpm", positive(), "speed of rotation")
      .output(&ScratchPattern::pitch_mm, "pitch", "-", "mm", non_negative(), "axial advance per revolution")
      .output(&ScratchPattern::lay_angle_deg, "lay_angle", "-", "deg", closed(0, 90),
              "between scratch and circumference")
      .output(&ScratchPattern::crossing_angle_deg, "crossing_angle", "-", "deg", closed(0, 180),
              "between scratches of opposite rotation, bisected by the circumference");
  source
      .function<&scratch_length>("scratch_length", "Length of a scratch.", "from eq. (1)",
                                 Provenance::repaired)
      .input(&ScratchTime::time_s, "t", "t", "s", non_negative(), "time", 10.0)
      .input(&ScratchTime::speed_m_min, "V_n", "V_n", "m/min", non_negative(), "circumferential speed",
             169.646)
      .input(&ScratchTime::feed_mm_min, "V_S", "V_S", "mm/min", any(), "axial feed speed", 300.0)
      .output(&ScratchLength::length_mm, "length", "-", "mm", non_negative(), "length of the path");
  source
      .function<&oscillation_frequency>("oscillation_frequency", "Frequency of the axial oscillation.",
                                        "text", Provenance::repaired)
      .input(&Oscillation::feed_mm_min, "V_S", "V_S", "mm/min", non_negative(), "axial speed", 300.0)
      .input(&Oscillation::amplitude_mm, "A", "A", "mm", positive(), "amplitude or stroke", 1.5)
      .optional(&Oscillation::convention, "convention", "-", "-", no_range(), "what A means and f counts")
      .output(&Frequency::frequency_hz, "f", "f", "1/s", non_negative(), "frequency");
  source
      .function<&oscillating_grain_position>("oscillating_grain_position",
                                             "Position of a grain that oscillates along the axis.",
                                             "completion", Provenance::completion)
      .with(time_and_cylinder)
      .input(&OscillatingGrain::mean_feed_mm_min, "V_f", "V_f", "mm/min", any(), "mean axial feed speed",
             300.0)
      .input(&OscillatingGrain::amplitude_mm, "A", "A", "mm", non_negative(), "amplitude", 1.5)
      .input(&OscillatingGrain::frequency_hz, "f", "f", "1/s", non_negative(), "frequency", 5.0)
      .input(&OscillatingGrain::phase_cycles, "phase", "phi", "1", any(), "phase in cycles", 0.0)
      .with(row)
      .with(position)
      .note("Triangular oscillation; the tilt of the brush is left out.");
  source
      .function<&track_max_gap>("track_max_gap", "Largest gap between the tracks of a row of grains.",
                                "completion, from eq. (2)", Provenance::completion)
      .input(&GrainRow::grains, "K", "K", "1", closed(1, static_cast<double>(most_grains)),
             "number of grains", 5)
      .input(&GrainRow::spacing_mm, "dh", "Delta h", "mm", non_negative(), "spacing of the grains", 0.23)
      .input(&GrainRow::pitch_mm, "pitch", "-", "mm", positive(), "axial advance per revolution", 0.15)
      .input(&GrainRow::groove_width_mm, "groove_width", "-", "mm", non_negative(),
             "axial width of a groove: its width over cos(lay_angle)", 0.08)
      .output(&TrackGap::gap_mm, "gap", "-", "mm", non_negative(), "largest gap")
      .output(&TrackGap::covered, "covered", "-", "-", no_range(), "the grooves leave no gap")
      .note("Oscillation is left out.");
  source
      .function<&mao_pass_time>("mao_pass_time", "Time of the finishing passes.", "completion",
                                Provenance::completion)
      .input(&MaoPasses::width_mm, "width", "-", "mm", non_negative(), "width of the surface", 17.0)
      .input(&MaoPasses::grains, "K", "K", "1", at_least(1), "number of grains in the row", 10)
      .input(&MaoPasses::spacing_mm, "dh", "Delta h", "mm", non_negative(), "spacing of the grains", 0.2)
      .input(&MaoPasses::feed_mm_min, "V_S", "V_S", "mm/min", positive(), "axial feed speed", 300.0)
      .input(&MaoPasses::passes, "passes", "-", "1", at_least(0), "number of passes", 4)
      .output(&PassTime::time_min, "t", "t", "min", non_negative(), "time of the passes");
  source
      .function<&mao_result>("mao_result", "Whether a setting lies in the recommended window.", "conclusions",
                             Provenance::paper)
      .input(&MaoSetting::grain_size_um, "grain_size", "-", "um", positive(), "size of the powder", 150.0)
      .input(&MaoSetting::gap_mm, "gap", "delta", "mm", positive(), "working gap", 1.0)
      .input(&MaoSetting::amplitude_mm, "amplitude", "A", "mm", non_negative(), "amplitude of oscillation",
             1.5)
      .input(&MaoSetting::speed_rpm, "n", "nu", "rpm", non_negative(), "speed of the part", 2000.0)
      .output(&MaoResult::in_window, "in_window", "-", "-", no_range(), "the setting lies in the window")
      .output(&MaoResult::ra_min_um, "ra_min", "R_a", "um", positive(), "least roughness, inside the window")
      .output(&MaoResult::ra_max_um, "ra_max", "R_a", "um", positive(),
              "largest roughness, inside the window")
      .note(
          "A result of the paper's simulation; experiments are said to agree. The 10 % to either side of "
          "gap, amplitude and speed are a completion.");
  source
      .function<&ground_state>("ground_state", "Surface of the bearing after grinding.", "text",
                               Provenance::paper)
      .input(&GroundBearing::material, "material", "-", "-", no_range(), "bearing material", "EI929-CaF2")
      .output(&GroundState::ra_um, "ra_before", "R_a", "um", positive(), "roughness")
      .output(&GroundState::hardened_depth_um, "hardened_depth", "-", "um", positive(), "depth of hardening");
  source
      .function<&roughness_after_mao>("roughness_after_mao", "Roughness after a time of finishing.",
                                      "completion", Provenance::completion)
      .input(&FinishingTime::time_min, "t", "t", "min", non_negative(), "time of finishing", 2.0)
      .input(&FinishingTime::ra_before_um, "ra_before", "Ra_0", "um", non_negative(), "roughness before",
             0.25)
      .input(&FinishingTime::ra_final_um, "ra_final", "Ra_f", "um", non_negative(), "roughness in the end",
             0.065)
      .input(&FinishingTime::time_constant_min, "tau", "tau", "min", positive(), "time constant", 1.0)
      .output(&Roughness::ra_um, "ra", "R_a", "um", non_negative(), "roughness")
      .note("The time constant is not in the paper: to be measured.");
}

}  // namespace verstat::models::k309
