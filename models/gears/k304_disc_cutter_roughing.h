#pragma once
// Rough cutting of gears and racks with assembled carbide disc cutters and a split cutting scheme (K304):
// time per gap and per part, the tabulated regimes, tool life, and the force of inserts that share the gap.
//
// Mironenko, Klochko, Lebedinskii 2011. The cutter of the paper: D 285 mm, 30 inserts = 5 groups of 6
// positions. Forces and insert layout are completions.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k304 {

struct CutterRotation {
  double diameter_mm = 285;
  double rpm = 0;
};
struct CutterSpeed {
  double cutting_speed_m_min;
};
/// V = pi D n / 1000. K304 Table 1.
[[nodiscard]] CutterSpeed disc_cutter_speed(const CutterRotation& in);

struct CutterAtSpeed {
  double diameter_mm = 285;
  double cutting_speed_m_min = 0;
};
struct CutterRpm {
  double rpm;
};
/// n = 1000 V/(pi D). K304 Table 1.
[[nodiscard]] CutterRpm disc_cutter_rpm(const CutterAtSpeed& in);

struct CutterFeed {
  double feed_mm_min = 0;
  double rpm = 0;
  std::int64_t teeth_in_line = 5;  // inserts per position
};
struct CutterFeeds {
  double feed_mm_rev;
  double feed_mm_tooth;
};
/// S_o = S_m/n = S_z z_f. K304 Table 1, "S_z S_f" repaired.
[[nodiscard]] CutterFeeds disc_cutter_feeds(const CutterFeed& in);

struct RegimeChoice {
  double module_mm = 0;    // 8, 10 or 12
  double hardness_hb = 0;  // <= 240
  bool paired = false;
};
struct Regime {
  double rpm;
  double feed_mm_min;
  double speed_printed_m_min;
  double speed_actual_m_min;
};
/// Regime of K304 Table 2: first column to HB 217, second to HB 240; a pair of cutters takes 0.8 of the feed.
/// The printed speed does not match the printed rpm at D = 285; both are given.
[[nodiscard]] Regime recommended_regime(const RegimeChoice& in);

struct GapStroke {
  double travel_mm = 0;  // with approach and overrun
  double feed_mm_min = 0;
  double return_feed_mm_min = 0;
  double indexing_min = 0;
};
struct GapTime {
  double working_min;
  double return_min;
  double per_gap_min;
};
/// Working stroke, return and indexing of one gap. K304 Table 1.
[[nodiscard]] GapTime gap_time(const GapStroke& in);

struct GearGaps {
  double per_gap_min = 0;
  std::int64_t gaps = 1;
  std::int64_t cutters = 1;  // at work at once
};
struct RoughingTime {
  double main_time_min;
  std::int64_t strokes;
  double main_time_whole_strokes_min;
};
/// Main time T_oi z/k as printed, and with whole strokes ceil(z/k) (COMPLETION, for the shop). K304 Table 1.
[[nodiscard]] RoughingTime gear_roughing_time(const GearGaps& in);

struct LifeConditions {
  bool coolant = false;
  bool coated = false;
};
struct LifeRange {
  double life_low_min;
  double life_high_min;
  double life_mid_min;
};
/// Tool life to 1 mm flank wear: 180 min dry, 300-360 min with coolant; coating low x 1.3, high x 1.5.
[[nodiscard]] LifeRange disc_cutter_life(const LifeConditions& in);

struct CutterPass {
  double face_width_mm = 0;
  double depth_mm = 0;  // below the diameter
  double diameter_mm = 285;
  double clearance_mm = 0;  // each side
  bool full_exit = false;   // the cutter leaves the part completely
};
struct CutterTravel {
  double approach_mm;
  double travel_mm;
};
/// Approach sqrt(t (D - t)) and travel b + approach (twice on a full exit) + 2 clearances. COMPLETION.
[[nodiscard]] CutterTravel disc_cutter_travel(const CutterPass& in);

struct SpeedChange {
  double life_ref_min = 0;
  double speed_ref_m_min = 0;
  double speed_m_min = 0;
  double taylor_exponent = 0;  // m in V T^m = const, usually 0.2-0.35
};
struct Life {
  double life_min;
};
/// Taylor: T = T_ref (V_ref/V)^(1/m). COMPLETION.
[[nodiscard]] Life life_at_speed(const SpeedChange& in);

struct InsertUse {
  double life_min = 0;
  double working_min = 0;  // per stroke
  std::int64_t gaps = 1;
  std::int64_t cutters = 1;
  std::int64_t inserts_per_cutter = 30;
  std::int64_t edges_per_insert = 1;
};
struct InsertConsumption {
  double gaps_per_life;
  double changes_per_part;
  double inserts_per_part;
};
/// Long-run means, not rounded: k T/T_p, ceil(z/k) T_p/T, changes x inserts x k/edges. COMPLETION.
[[nodiscard]] InsertConsumption insert_consumption(const InsertUse& in);

struct GapShape {
  double module_mm = 0;
  double depth_mm = 0;
  double allowance_mm = 0.8;  // left on the tooth thickness
  double pressure_angle_deg = 20;
};
struct GapSection {
  double bottom_width_mm;
  double top_width_mm;
  double flank_length_mm;
  double area_mm2;
  double profile_length_mm;
};
/// Straight-sided section of the roughed gap; error when the bottom width is not positive. COMPLETION.
[[nodiscard]] GapSection rack_gap_section(const GapShape& in);

struct InsertLayout {
  std::vector<double> widths_mm;  // projected on the cutter axis
  std::vector<double> lead_angles_deg;
  std::vector<double> radial_offsets_mm;  // of the middle of the edge from the cutter's largest radius
};
/// Split of the gap among six positions a to f: two halves of the bottom, lower and upper halves of both
/// flanks. COMPLETION; the paper does not say which flank insert cuts lower.
[[nodiscard]] InsertLayout split_profile_inserts(const GapShape& in);

struct SplitCut : InsertLayout {
  std::int64_t groups = 5;
  double diameter_mm = 285;
  double depth_mm = 0;
  double feed_mm_min = 0;
  double rpm = 0;
  double kc11_mpa = 0;
  double mc = 0;
  double second_cutter_offset_deg = -1;  // negative: one cutter
};
struct SplitForce {
  double peak_force_n;
  double mean_force_n;
  double min_force_n;
  double peak_to_mean;
  std::int64_t inserts_in_contact_max;
  double mean_power_kw;
};
/// Tangential force of all inserts in contact, summed as a scalar over 7200 midpoints of one period
/// (Kienzle). COMPLETION.
[[nodiscard]] SplitForce split_scheme_force(const SplitCut& in);

}  // namespace verstat::models::k304
