#pragma once
// Thermo-friction machining of flat steel surfaces with a smooth rotating disc: the published ranges of
// regime and surface state, and completions on them for hardness and stress over depth, feed limit, power,
// time and the allowance of the following operation (K305).
//
// Pokintelitsa 2011: purely experimental, no equations; curves are lost, ranges are kept.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k305 {

enum class Quantity {
  width_low_band,
  width_high_band,
  depth,
  feed_low_band,
  feed_high_band,
  spindle,
  roughness_rz,
  hardening_factor,
  hardened_depth,
  base_hardness_depth,
  heat_affected_depth,
  fine_structure_depth,
  unchanged_structure_depth,
  active_layer_depth,
  residual_alloy,
  residual_alloy_depth,
  residual_45_surface,
  residual_45_tension_depth,
  residual_45_subsurface,
  residual_45_depth,
  drive_power,
  disc_diameter
};
enum class Steel { steel_45, steel_12kh13, steel_12kh18n12t, steel_38khgn, steel_09kh15n8yu };

struct PublishedQuantity {
  Quantity quantity = Quantity::depth;
};
struct PublishedRange {
  double low, high;
};
/// Range of a quantity as printed; its unit is part of the name.
[[nodiscard]] PublishedRange published_ranges(const PublishedQuantity& in);

struct MachinedSteel {
  Steel steel = Steel::steel_45;
};
struct SurfaceTemperature {
  double low_c, high_c;
};
/// Range of the surface temperature of a steel.
[[nodiscard]] SurfaceTemperature surface_temperature(const MachinedSteel& in);

struct Disc {
  double diameter_mm = 500;
  double spindle_rpm = 0;
};
struct DiscSpeed {
  double speed_m_s;
};
/// Rim speed pi D n / 60000.
[[nodiscard]] DiscSpeed disc_speed(const Disc& in);

struct DiscRegime {
  double width_mm = 0;
  double depth_mm = 0;
  double feed_mm_min = 0;
  double spindle_rpm = 0;
};
struct Envelope {
  int in_envelope;  // 1 or 0
};
/// Whether a regime lies inside the published ranges, ends included; the feed is judged by the width band.
[[nodiscard]] Envelope regime_in_envelope(const DiscRegime& in);

struct RimSpeed {
  double speed_m_s = 0;
};
struct StressTrend {
  int trend;  // -1: compression falls with speed, +1: it rises
};
/// Trend of compressive stress with disc speed: -1 up to 50 m/s, +1 above.
[[nodiscard]] StressTrend compressive_stress_trend(const RimSpeed& in);

struct HardenedPoint {
  double depth_um = 0;
  double factor = 1;
};
struct HardnessRatio {
  double ratio;
};
/// Hardness over base hardness: the factor to 200 um, then linear to 1 at 600 um. COMPLETION.
[[nodiscard]] HardnessRatio hardness_ratio(const HardenedPoint& in);

struct StressedPoint {
  Steel steel = Steel::steel_45;
  double depth_um = 0;
  double level = 0;
};
struct ResidualStress {
  double stress_mpa;  // + tension
};
/// Residual stress below the surface, piecewise linear through the printed ends; `level` 0 = mild, 1 = severe
/// end of the ranges. Steels 45 and 09Kh15N8Yu only. COMPLETION.
[[nodiscard]] ResidualStress residual_stress(const StressedPoint& in);

struct MachinedSection {
  double width_mm = 0;
  double depth_mm = 0;
};
struct FeedLimit {
  double feed_mm_min;
};
/// Feed at the edge of the published regimes: bilinear in logarithms between four corners. COMPLETION.
[[nodiscard]] FeedLimit feed_limit(const MachinedSection& in);

struct RemovalInputs {
  double width_mm = 0;
  double depth_mm = 0;
  double feed_mm_min = 0;
  double specific_energy_j_mm3 = 0;
  double drive_power_kw = 14;
  double efficiency = 1;
};
struct RemovalAndPower {
  double removal_mm3_min;
  double power_kw;
  double energy_limit_j_mm3;
};
/// Removal rate, cutting power and the specific energy that loads the drive fully. COMPLETION.
[[nodiscard]] RemovalAndPower removal_and_power(const RemovalInputs& in);

struct PassInputs {
  double length_mm = 0;
  double part_width_mm = 0;
  double disc_width_band_mm = 0;
  double overlap_mm = 0;
  double run_in_out_mm = 0;
  double stock_mm = 0;
  double depth_mm = 0;
  double feed_mm_min = 0;
};
struct PassTime {
  std::int64_t passes;
  double main_time_min;
};
/// Rows times layers, and the main time. COMPLETION.
[[nodiscard]] PassTime pass_time(const PassInputs& in);

struct LayerLeft {
  double rz_um = 0;
  double hardened_depth_um = 0;
  bool keep_hardened = false;
  double positioning_error_um = 0;
};
struct Allowance {
  double allowance_um;
};
/// Smallest allowance of the following operation. COMPLETION.
[[nodiscard]] Allowance following_allowance(const LayerLeft& in);

}  // namespace verstat::models::k305

template <>
struct verstat::models::EnumNames<verstat::models::k305::Quantity> {
  using Q = k305::Quantity;
  static constexpr std::array names{std::pair{Q::width_low_band, "width_low_band_mm"},
                                    std::pair{Q::width_high_band, "width_high_band_mm"},
                                    std::pair{Q::depth, "depth_mm"},
                                    std::pair{Q::feed_low_band, "feed_low_band_mm_min"},
                                    std::pair{Q::feed_high_band, "feed_high_band_mm_min"},
                                    std::pair{Q::spindle, "spindle_rpm"},
                                    std::pair{Q::roughness_rz, "roughness_rz_um"},
                                    std::pair{Q::hardening_factor, "hardening_factor"},
                                    std::pair{Q::hardened_depth, "hardened_depth_um"},
                                    std::pair{Q::base_hardness_depth, "base_hardness_depth_um"},
                                    std::pair{Q::heat_affected_depth, "heat_affected_depth_um"},
                                    std::pair{Q::fine_structure_depth, "fine_structure_depth_um"},
                                    std::pair{Q::unchanged_structure_depth, "unchanged_structure_depth_um"},
                                    std::pair{Q::active_layer_depth, "active_layer_depth_um"},
                                    std::pair{Q::residual_alloy, "residual_alloy_mpa"},
                                    std::pair{Q::residual_alloy_depth, "residual_alloy_depth_um"},
                                    std::pair{Q::residual_45_surface, "residual_45_surface_mpa"},
                                    std::pair{Q::residual_45_tension_depth, "residual_45_tension_depth_um"},
                                    std::pair{Q::residual_45_subsurface, "residual_45_subsurface_mpa"},
                                    std::pair{Q::residual_45_depth, "residual_45_depth_um"},
                                    std::pair{Q::drive_power, "drive_power_kw"},
                                    std::pair{Q::disc_diameter, "disc_diameter_mm"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k305::Steel> {
  using S = k305::Steel;
  static constexpr std::array names{std::pair{S::steel_45, "45"}, std::pair{S::steel_12kh13, "12Kh13"},
                                    std::pair{S::steel_12kh18n12t, "12Kh18N12T"},
                                    std::pair{S::steel_38khgn, "38KhGN"},
                                    std::pair{S::steel_09kh15n8yu, "09Kh15N8Yu"}};
};
