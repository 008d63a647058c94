#pragma once
// Interchangeability of joints (K307): snap gauges for the distance of two hole axes with a dependent
// (maximum material) position tolerance, their pass probability and wear; thermal assembly; reduced
// deviations for the control of small batches.
//
// Martynov 2011. Lengths in mm, temperatures in degC.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k307 {

struct GaugeDesign {
  double distance_mm = 0;                           // L, nominal distance of the axes
  double d1_min_mm = 0, d2_min_mm = 0;              // least diameters of the holes
  double tolerance_mm = 0;                          // T_p > 0, position tolerance of the axes
  double deviation_1_mm = 0, deviation_2_mm = 0;    // F, basic deviation of the new element; F >= W
  double wear_value_1_mm = 0, wear_value_2_mm = 0;  // W >= 0
};
struct GaugeSizes {
  double b_max_mm;
  double b_min_mm;
  double b_wear_mm;  // at the end of wear
  double tolerance_mm;
  double wear_allowance_mm;  // from the wear limit to the nearest size of a new gauge
};
/// Gauge over the far walls of the holes: B_W = L + (D1 + D2)/2 - T_p, B_min and B_max above it by the mean
/// W and F. K307, formulas of the text.
[[nodiscard]] GaugeSizes gauge_outer_span(const GaugeDesign& in);
/// Gauge over the near walls, the mirror image: B_W = L - (D1 + D2)/2 + T_p, new sizes below it. COMPLETION.
[[nodiscard]] GaugeSizes gauge_inner_span(const GaugeDesign& in);

struct GaugedPart {
  double distance_mm = 0;       // C, actual distance of the axes
  double d1_mm = 0, d2_mm = 0;  // actual diameters
  double b_outer_mm = 0, b_inner_mm = 0;
};
struct GaugeVerdict {
  bool accept;
};
/// Whether both gauges enter: C + (D1 + D2)/2 >= B_outer and C - (D1 + D2)/2 <= B_inner. A fit to within
/// 1e-9 mm counts as equality, which accepts. The inner half is COMPLETION.
[[nodiscard]] GaugeVerdict gauge_accepts(const GaugedPart& in);

struct HolePair {
  double d1_mm = 0, d2_mm = 0;
  double d1_min_mm = 0, d2_min_mm = 0;
  double tolerance_mm = 0;
};
struct CenterDeviation {
  double deviation_mm;
};
/// Permitted +- deviation of the axis distance with gauges at the wear limit: T_p and half of what the holes
/// exceed their least diameters by.
[[nodiscard]] CenterDeviation allowed_center_deviation(const HolePair& in);

struct GaugedProcess {
  double distance_mean_mm = 0, distance_sigma_mm = 0;  // sigma > 0
  double d1_mean_mm = 0, d1_sigma_mm = 0;
  double d2_mean_mm = 0, d2_sigma_mm = 0;
  double b_outer_mm = 0, b_inner_mm = 0;
};
struct PassProbability {
  double p;
};
/// Probability that a part passes both gauges, distance and diameters normal and independent. COMPLETION.
[[nodiscard]] PassProbability gauge_pass_probability(const GaugedProcess& in);

struct GaugeWear {
  double size_mm = 0;
  double wear_limit_mm = 0;
  double wear_per_check_um = 0;
};
struct GaugeLife {
  std::int64_t checks;
};
/// Checks left to the wear limit. COMPLETION. Which side of the limit is new is for the caller to know.
[[nodiscard]] GaugeLife gauge_life_checks(const GaugeWear& in);

struct ShrinkFit {
  double diameter_mm = 0;
  double interference_mm = 0;
  double clearance_mm = 0;
  double expansion_1_k = 0;
  double room_c = 20;
};
struct Temperature {
  double temperature_c;
};
/// Temperature at which the hub slides on with a clearance: t_room + (delta + clearance)/(alpha d).
/// COMPLETION.
[[nodiscard]] Temperature heating_temperature(const ShrinkFit& in);

struct SeizedHub {
  double length_mm = 0;
  double expansion_1_k = 0;
  double seizing_c = 0;
  double room_c = 20;
};
struct AxialGap {
  double gap_mm;
};
/// Gap at the shoulder when the hub seizes at its far end, an upper bound: alpha l (t_seize - t_room).
/// COMPLETION.
[[nodiscard]] AxialGap axial_gap(const SeizedHub& in);

struct MeasuredSize {
  double size_mm = 0;
  double lower_mm = 0, upper_mm = 0;
};
struct ReducedDeviation {
  double deviation;
};
/// Deviation from the middle of the tolerance in halves of it: -1 and +1 at the limits. COMPLETION.
[[nodiscard]] ReducedDeviation reduced_deviation(const MeasuredSize& in);

}  // namespace verstat::models::k307
