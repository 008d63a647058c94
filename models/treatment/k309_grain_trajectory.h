#pragma once
// Magnetic-abrasive finishing of sleeve bearings (K309): paths of ferro-abrasive grains over the turning
// cylinder, the pattern and coverage of their scratches, pass time, and the published window of settings.
//
// Havrysh, Roik, Melnyk, Vitsiuk 2011.

#include <array>
#include <cstdint>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k309 {

struct GrainOnCylinder {
  double time_s = 0;
  double radius_mm = 0;
  double speed_m_min = 0;      // circumferential
  std::int64_t grain = 0;      // index in the row
  double spacing_mm = 0;       // of the grains in the row
  std::int64_t direction = 1;  // of rotation, +1 or -1
};
struct GrainMove : GrainOnCylinder {
  double feed_mm_min = 0;  // axial
};
struct Position {
  double x_mm;  // along the axis
  double y_mm;
  double z_mm;
};
/// Point of grain k at a time: x = k dh + V_S t, y = R cos(V_n t/R), z = +-R sin(V_n t/R).
/// K309 eqs. (1)-(3), repaired: printed V_n t/(2 pi R), which is revolutions, not an angle.
[[nodiscard]] Position grain_position(const GrainMove& in);

struct Helix {
  double radius_mm = 0;
  double speed_m_min = 0;
  double feed_mm_min = 0;
};
struct ScratchPattern {
  double speed_rpm;
  double pitch_mm;
  double lay_angle_deg;       // between scratch and circumference
  double crossing_angle_deg;  // between scratches of opposite rotation
};
/// Helix of one grain and its crossing with that of the opposite rotation. From eq. (1), repaired.
[[nodiscard]] ScratchPattern scratch_pattern(const Helix& in);

struct ScratchTime {
  double time_s = 0;
  double speed_m_min = 0;
  double feed_mm_min = 0;
};
struct ScratchLength {
  double length_mm;
};
/// Path of a grain, t sqrt(V_n^2 + V_S^2).
[[nodiscard]] ScratchLength scratch_length(const ScratchTime& in);

enum class AmplitudeConvention { printed, stroke, amplitude };
struct Oscillation {
  double feed_mm_min = 0;  // axial speed
  double amplitude_mm = 0;
  AmplitudeConvention convention = AmplitudeConvention::amplitude;
};
struct Frequency {
  double frequency_hz;
};
/// Frequency of the axial oscillation. Printed f = V_S/A counts strokes of length A; a cycle is 2 A when A is
/// the stroke and 4 A when it is the amplitude.
[[nodiscard]] Frequency oscillation_frequency(const Oscillation& in);

struct OscillatingGrain : GrainOnCylinder {
  double mean_feed_mm_min = 0;
  double amplitude_mm = 0;
  double frequency_hz = 0;
  double phase_cycles = 0;
};
/// As grain_position, with a triangular oscillation along the axis around the mean feed. COMPLETION.
[[nodiscard]] Position oscillating_grain_position(const OscillatingGrain& in);

struct GrainRow {
  std::int64_t grains = 1;
  double spacing_mm = 0;
  double pitch_mm = 0;
  double groove_width_mm = 0;  // along the axis
};
struct TrackGap {
  double gap_mm;
  bool covered;
};
/// Largest axial distance between neighbouring tracks of a row of grains. COMPLETION.
[[nodiscard]] TrackGap track_max_gap(const GrainRow& in);

struct MaoPasses {
  double width_mm = 0;
  std::int64_t grains = 1;
  double spacing_mm = 0;
  double feed_mm_min = 0;
  std::int64_t passes = 1;
};
struct PassTime {
  double time_min;
};
/// Time of the passes of the row over a width, passes (width + (K - 1) dh)/V_S. COMPLETION.
[[nodiscard]] PassTime mao_pass_time(const MaoPasses& in);

struct MaoSetting {
  double grain_size_um = 0;
  double gap_mm = 0;
  double amplitude_mm = 0;
  double speed_rpm = 0;
};
struct MaoResult {
  bool in_window;
  double ra_min_um, ra_max_um;  // valid only inside the window
};
/// Whether a setting lies in the recommended window, and the roughness published for it. K309 conclusions.
[[nodiscard]] MaoResult mao_result(const MaoSetting& in);

enum class BearingMaterial { nickel_composite, copper_composite };
struct GroundBearing {
  BearingMaterial material = BearingMaterial::nickel_composite;
};
struct GroundState {
  double ra_um;
  double hardened_depth_um;
};
/// Surface after grinding, before finishing. K309 text; the middle of the printed 0.30-0.32.
[[nodiscard]] GroundState ground_state(const GroundBearing& in);

struct FinishingTime {
  double time_min = 0;
  double ra_before_um = 0;
  double ra_final_um = 0;
  double time_constant_min = 0;
};
struct Roughness {
  double ra_um;
};
/// Roughness after a time of finishing, Ra_f + (Ra_0 - Ra_f) exp(-t/tau). COMPLETION.
[[nodiscard]] Roughness roughness_after_mao(const FinishingTime& in);

}  // namespace verstat::models::k309

template <>
struct verstat::models::EnumNames<verstat::models::k309::AmplitudeConvention> {
  using Convention = k309::AmplitudeConvention;
  static constexpr std::array names{std::pair{Convention::printed, "printed"},
                                    std::pair{Convention::stroke, "stroke"},
                                    std::pair{Convention::amplitude, "amplitude"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k309::BearingMaterial> {
  using Material = k309::BearingMaterial;
  static constexpr std::array names{std::pair{Material::nickel_composite, "EI929-CaF2"},
                                    std::pair{Material::copper_composite, "DN5M3KF9"}};
};
