#pragma once
// Turning of natural stone on a lathe with a driven diamond wheel (K112): recommended regimes by
// machinability group, the lathes that can run them, times, removal rate and wheel consumption.
//
// Peglovskyi, Sidorko, Liakhov 2011: tables, no equation. The formulas are completions.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k112 {

enum class Operation { rough, finish };
enum class Lathe { k1k62m, k16b05p, k16b16a };

struct StoneOperation {
  std::int64_t group = 1;
  Operation operation = Operation::rough;
};
struct Regime {
  double rpm_min;
  double rpm_max;
  double long_feed_min_mm_rev;
  double long_feed_max_mm_rev;
  double cross_feed_min_mm_rev;
  double cross_feed_max_mm_rev;
};
/// Recommended window for the machinability group 1..5, parts up to 150 mm diameter. K112 Table 3 and the
/// finish feeds after it; the speeds for finishing are those of roughing (COMPLETION).
[[nodiscard]] Regime stone_turning_regime(const StoneOperation& in);

struct LatheName {
  Lathe machine = Lathe::k1k62m;
};
struct LatheData {
  double swing_bed_mm;
  double swing_carriage_mm;
  double rpm_min;
  double rpm_max;
  double long_feed_min_mm_rev;
  double long_feed_max_mm_rev;
  double cross_feed_min_mm_rev;
  double cross_feed_max_mm_rev;
  double mass_kg;
};
/// The lathes of K112 Table 1; the upper feeds of 16B05P are repaired (0.35 and 0.175, a lost zero place).
[[nodiscard]] LatheData machine_characteristics(const LatheName& in);

struct StoneOnLathe {
  Lathe machine = Lathe::k1k62m;
  std::int64_t group = 1;
  Operation operation = Operation::rough;
  double work_diameter_mm = 0;
};
struct LatheFit {
  std::int64_t feasible;
  std::int64_t size_ok;
  std::int64_t rpm_ok;
  std::int64_t long_feed_ok;
  std::int64_t cross_feed_ok;
  std::optional<double> rpm_low;  // null when the windows do not meet
  std::optional<double> rpm_high;
  std::optional<double> long_feed_low_mm_rev;
  std::optional<double> long_feed_high_mm_rev;
};
/// Whether the lathe can run the group: the part passes over the carriage, and the closed windows of speed
/// and longitudinal feed of Tables 1 and 3 meet. The cross feed is reported but does not decide. Flags are 0
/// or 1.
[[nodiscard]] LatheFit stone_machine_fit(const StoneOnLathe& in);

struct WheelOnStone {
  double work_diameter_mm = 0;
  double rpm = 0;
  double wheel_diameter_mm = 0;
  double relative_speed_m_s = 0;
  std::int64_t conventional = 1;
};
struct Speeds {
  double work_speed_m_min;
  double wheel_speed_m_s;
  double wheel_rpm;
};
/// Work speed, and the wheel speed that gives the relative speed in opposed (1) or climb (0) motion. K112
/// (C1), COMPLETION. Error when the work alone is already as fast as the required relative speed.
[[nodiscard]] Speeds stone_turning_kinematics(const WheelOnStone& in);

struct LongitudinalPasses {
  double length_mm = 0;
  double approach_mm = 0;
  double allowance_per_side_mm = 0;
  double depth_per_pass_mm = 0;
  double long_feed_mm_rev = 0;
  double rpm = 0;
};
struct PassTime {
  std::int64_t passes;
  double time_per_pass_min;
  double main_time_min;
};
/// Whole passes (0 for no allowance), time of one and of all. K112 (C2), COMPLETION.
[[nodiscard]] PassTime stone_turning_time(const LongitudinalPasses& in);

struct Plunge {
  double allowance_per_side_mm = 0;
  double cross_feed_mm_rev = 0;
  double rpm = 0;
  double sparkout_revs = 0;
};
struct PlungeTime {
  double main_time_min;
};
/// Time of radial forming with spark-out, a/(S n) + N/n. K112 (C3), COMPLETION.
[[nodiscard]] PlungeTime stone_plunge_time(const Plunge& in);

struct StonePass {
  double work_diameter_mm = 0;
  double depth_mm = 0;
  double long_feed_mm_rev = 0;
  double rpm = 0;
};
struct RemovalRate {
  double removal_rate_mm3_min;
};
/// Removal rate pi (D - t) t S n of a pass of depth t <= D/2 on the diameter D. K112 (C4), COMPLETION.
[[nodiscard]] RemovalRate stone_removal_rate(const StonePass& in);

struct DiamondWheel {
  double wheel_diameter_mm = 0;
  double rim_width_mm = 0;
  double layer_depth_mm = 0;
  double concentration_percent = 0;
  double usable_fraction = 0;
  double grinding_ratio = 0;
  double stone_volume_per_part_mm3 = 0;
};
struct WheelLife {
  double layer_volume_mm3;
  double diamond_carat;
  double parts_per_wheel;
};
/// Volume of the diamond layer of a straight wheel, its diamond (100 % = 4.4 carat/cm3) and the parts it
/// lasts for a grinding ratio in mm3 of stone per mm3 of layer. K112 (C5), COMPLETION.
[[nodiscard]] WheelLife diamond_wheel_life(const DiamondWheel& in);

}  // namespace verstat::models::k112

template <>
struct verstat::models::EnumNames<verstat::models::k112::Operation> {
  static constexpr std::array names{std::pair{k112::Operation::rough, "rough"},
                                    std::pair{k112::Operation::finish, "finish"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k112::Lathe> {
  static constexpr std::array names{std::pair{k112::Lathe::k1k62m, "1K62M"},
                                    std::pair{k112::Lathe::k16b05p, "16B05P"},
                                    std::pair{k112::Lathe::k16b16a, "16B16A"}};
};
