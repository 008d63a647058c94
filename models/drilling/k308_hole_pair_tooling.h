#pragma once
// Tooling for drilling and checking pairs of holes with different centre distances (K308): a drill bushing
// that turns with the drill, a two-spindle head with an adjustable centre distance, a checking fixture.
//
// Dynia 2011. No numeric result is published.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k308 {

struct RotatingBushing {
  double slip_factor = 1.3;    // middle of the printed 1.2-1.4
  double return_factor = 0.3;  // value lost in print
  double radius_mm = 0;
  double feed_mm_rev = 0;
  double return_feed_mm_rev = 0;
};
struct WearRatio {
  double ratio;
  double life_gain;
};
/// Wear of a bushing that turns with the drill over that of a fixed one, K308 eq. (1):
///   k3 = k1 (1 + k2) / (sqrt(4 pi^2 r^2 + S1^2)/S1 + k2 sqrt(4 pi^2 r^2 + S2^2)/S2)
/// k1 > 0 factor for the lag of the bushing, 0 <= k2 <= 1 factor for the smaller normal force on the return
/// stroke, drill radius r, feeds S1 and S2 of cutting and return > 0. Optimistic: almost complete
/// entrainment.
[[nodiscard]] WearRatio bushing_wear_ratio(const RotatingBushing& in);

struct BushingStroke {
  double radius_mm = 0;
  double feed_mm_rev = 0;
  double depth_mm = 0;
  double slip = 0;
};
struct SlidingPath {
  double path_mm;
};
/// Sliding of the drill margin along the bushing wall in one stroke, depth * sqrt((2 pi r s)^2 + S^2) / S:
/// slip s = 1 for a fixed bushing, 0 for a fully entrained one. Between them COMPLETION.
[[nodiscard]] SlidingPath sliding_path(const BushingStroke& in);

struct SlippingBushing {
  double slip = 0;
  double return_factor = 0.3;
  double radius_mm = 0;
  double feed_mm_rev = 0;
  double return_feed_mm_rev = 0;
};
/// As bushing_wear_ratio, from the share of circumferential sliding 0..1 instead of the factor k1.
/// COMPLETION. For planning take a slip of 0.01-0.05.
[[nodiscard]] WearRatio bushing_wear_ratio_slip(const SlippingBushing& in);

struct FixedBushingLife {
  double holes_fixed = 0;
  double wear_ratio = 0;
};
struct BushingLife {
  double holes;
};
/// Holes until a bushing with the wear ratio k3 > 0 is worn out, wear proportional to path. COMPLETION.
[[nodiscard]] BushingLife bushing_life(const FixedBushingLife& in);

struct SetupErrors {
  double locating_mm = 0;
  double clamping_mm = 0;
  double fixture_mm = 0;
};
struct SetupError {
  double error_mm;
};
/// Error of setting up, the root of the sum of squares of its components >= 0. K308 eq. (2).
[[nodiscard]] SetupError setup_error(const SetupErrors& in);

struct GaugeErrors {
  double lever_manufacture_mm = 0;
  double lever_clearance_mm = 0;
  double disproportion_mm = 0;
  double contact_shift_mm = 0;
  double direct_transmission_mm = 0;
};
struct GaugeError {
  double error_mm;
};
/// Error of the measuring device, the root of the sum of squares. K308 eq. (3), repaired: printed 2/p for
/// p^2.
[[nodiscard]] GaugeError gauge_error(const GaugeErrors& in);

struct SpindleArms {
  double pinion_diameter_mm = 0;
  double gear_diameter_mm = 0;
  double angle_deg = 0;
};
struct CentreDistance {
  double distance_mm;
};
/// Distance of the two spindles, (d_pinion + d_gear) sin(phi/2), phi 0..180 deg between their arms, both
/// gears in mesh with the central pinion. COMPLETION (geometry).
[[nodiscard]] CentreDistance head_center_distance(const SpindleArms& in);

struct SpindleDistance {
  double pinion_diameter_mm = 0;
  double gear_diameter_mm = 0;
  double distance_mm = 0;
};
struct HeadAngle {
  double angle_deg;
  bool ok;
};
/// Angle between the arms for a centre distance, 180 deg when it is out of reach; `ok` when the gears clear
/// each other (d_gear <= A) and reach (A <= d_pinion + d_gear). COMPLETION. Tip circles ask two modules more.
[[nodiscard]] HeadAngle head_angle(const SpindleDistance& in);

struct MultiSpindleJob {
  double depth_mm = 0;
  double approach_mm = 0;
  double overrun_mm = 0;
  double feed_mm_rev = 0;
  double machine_rpm = 0;
  std::int64_t pinion_teeth = 0;
  std::int64_t gear_teeth = 0;
  std::int64_t holes = 0;
  std::int64_t drills = 0;
  double index_min = 0;
};
struct MultiSpindleTime {
  double spindle_rpm;
  std::int64_t strokes;
  double time_min;
};
/// Drill speed n z_pinion/z_gear, strokes ceil(holes/drills) and main time with indexing between strokes.
/// COMPLETION.
[[nodiscard]] MultiSpindleTime multi_spindle_drilling(const MultiSpindleJob& in);

struct Inspection {
  double value_mm = 0;
  double lower_mm = 0;
  double upper_mm = 0;
  double error_mm = 0;
  double deviations = 3;
};
struct Acceptance {
  double probability;
};
/// Probability that a part of true value x is measured inside the limits (both included) when the measuring
/// error is normal with sigma = eps/k; without error 1 inside, 0 outside. COMPLETION.
[[nodiscard]] Acceptance inspection_accept_probability(const Inspection& in);

}  // namespace verstat::models::k308
