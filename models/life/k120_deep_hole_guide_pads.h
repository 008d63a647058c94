#pragma once
// Dimensional wear of the carbide guide pads of deep-hole drilling heads (K120): the wear spot that walks in
// stages from the lead-in of a pad to its tail, measured against drilled metres.
//
// Patsiora 2011. The fitted coefficients are not printed: a user measures pads and fits them here.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k120 {

struct DrilledLength {
  double hole_diameter_mm = 0;
  double drilled_length_m = 0;
  double feed_mm_rev = 0;
};
struct SlidingPath {
  double path_m;
};
/// Path of a pad point along the hole wall, l = pi D L / s; all inputs > 0. The helix adds less than 1e-6.
/// K120, not printed as a formula: recovered from the 35168 m and 23445 m of the text and Table 1.
[[nodiscard]] SlidingPath pad_sliding_path(const DrilledLength& in);

struct PadPath {
  double hole_diameter_mm = 0;
  double path_m = 0;
  double feed_mm_rev = 0;
};
struct PadLength {
  double drilled_length_m;
};
/// Drilled length in which a pad point slides `path_m`. Inverse of pad_sliding_path.
[[nodiscard]] PadLength pad_length_from_path(const PadPath& in);

struct DrillingRegime {
  double hole_diameter_mm = 0;
  double drilled_length_m = 0;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
};
struct DrillingTime {
  double spindle_rpm;
  double feed_rate_mm_min;
  double time_min;
};
/// Spindle speed n = 1000 v / (pi D), feed rate s n and time 1000 L / (s n); all inputs > 0. COMPLETION
/// (kinematics): equals the sliding path over the cutting speed.
[[nodiscard]] DrillingTime deep_drilling_time(const DrillingRegime& in);

struct PadWearAtLength {
  double drilled_length_m = 0;
  double a_mm_m_b = 0;  // mm per m^b
  double b = 1;
  double c_mm = 0;
  double shift_m = 0;
};
struct PadWear {
  double wear_mm;
};
/// Radial wear of one pad point: 0 up to the shift, then max(0, a (L - shift)^b + c). K120 eq. (1).
/// L >= 0, a > 0, b > 0, shift >= 0, c of any sign. The shift and the zero before it are a COMPLETION.
[[nodiscard]] PadWear pad_radial_wear(const PadWearAtLength& in);

struct PadWearLimit {
  double wear_mm = 0;
  double a_mm_m_b = 0;
  double b = 1;
  double c_mm = 0;
  double shift_m = 0;
};
/// Drilled length at which the wear > 0 is reached; the shift when wear <= c. Inverse of pad_radial_wear.
[[nodiscard]] PadLength pad_length_to_wear(const PadWearLimit& in);

struct RadialWear {
  double wear_mm = 0;
};
struct WearEffect {
  double diameter_loss_mm;
  double insert_overhang_increase_mm;
  bool lead_in_lost;
};
/// What a radial wear h >= 0 does: 2 h less diameter over the pads, h more insert overhang, and the lead-in
/// lost from 0.04 mm on (the cautious end of the printed 0.04-0.05, where "um" is repaired to mm).
[[nodiscard]] WearEffect pad_wear_effect(const RadialWear& in);

struct PadMeasurements {
  std::vector<double> length_m;
  std::vector<double> wear_mm;
};
struct PadWearFit {
  double a_mm_m_b;
  double b;
  double c_mm;
  double rmse_mm;
  bool b_at_limit;  // of the searched 0.10..4.00: a warning that the law does not fit
};
/// Least-squares a, b, c of h = a L^b + c through at least 4 measurements (lengths increasing, positive;
/// wear not all equal). COMPLETION: variable projection, b on the grid 0.10, 0.11 .. 4.00 with the linear
/// least squares of a and c inside, then golden section between the grid neighbours of the first minimum.
[[nodiscard]] PadWearFit fit_pad_wear(const PadMeasurements& in);

struct PadUnderWay {
  double drilled_length_m = 0;
  double a_mm_m_b = 0;
  double b = 1;
  double c_mm = 0;
  double shift_per_point_m = 0;
  double critical_wear_mm = 0.045;  // middle of the printed 0.04-0.05 mm
  double trace_wear_mm = 0.002;
};
struct PadState {
  double wear_at_point_1_mm;
  double wear_at_point_8_mm;
  std::int64_t points_past_critical;
  std::int64_t lead_in_first_point;
  bool replace;
};
/// State of a pad after a drilled length: the ten points follow one law, each shifted by the same length
/// behind its predecessor. Replace when point 8 shows wear. COMPLETION.
[[nodiscard]] PadState pad_state(const PadUnderWay& in);

struct PadSet {
  double a_mm_m_b = 0;
  double b = 1;
  double c_mm = 0;
  double shift_per_point_m = 0;
  double critical_wear_mm = 0.045;
  double trace_wear_mm = 0.002;
  double hole_length_m = 0;
};
struct PadLife {
  double lead_in_shift_starts_m;
  double replace_at_m;
  std::int64_t holes_per_pad_set;
};
/// Drilled length at which the lead-in begins to move, at which the pads are due, and whole holes until then
/// (0 when the pads do not last one hole). COMPLETION.
[[nodiscard]] PadLife pad_life(const PadSet& in);

}  // namespace verstat::models::k120
