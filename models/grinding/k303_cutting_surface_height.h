#pragma once
// Height of irregularities on the cutting surface in plunge grinding (K303).
//
// Inside the contact arc the work is covered by comma-shaped grooves of grains of different height. Step by
// step along the arc the grooves fill a cross-section of the work; the depth at which its top is 90 % covered
// is Rmax of the cutting surface (inside the arc, not of the finished part). Safe work without rubbing of the
// bond: Rmax < grain protrusion.
//
// Matyukha, Gabitov 2011 (internal plunge grinding); external and flat grinding are a completion through the
// equivalent diameter.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k303 {

enum class GrindingKind { internal, external, surface };

struct WheelAndWork {
  double wheel_radius_mm = 0;
  double work_radius_mm = 0;  // of the bore or shaft; without meaning for `surface`
  GrindingKind kind = GrindingKind::internal;
};
/// Relief of the wheel face and how finely the arc is cut into steps.
struct WheelSet : WheelAndWork {
  double wheel_speed_m_s = 0;
  double grain_spacing_mm = 0;
  double tip_radius_um = 0;
  double tip_angle_deg = 0;
  double weibull_x0_um_m = 0;
  double weibull_m = 0;
  double interval_um = 0.12;
  double coverage = 0.9;
};
struct CuttingRegime : WheelSet {
  double work_speed_m_min = 0;
  double depth_mm = 0;
};

struct CuttingSurface {
  double rmax_um;
  std::int64_t interval_number;
  std::int64_t saturated;  // 1: the coverage is never reached, Rmax is the depth
  double position_mm;
  double coverage_reached;
};
/// Largest Rmax along the arc; K303 eqs. (1)-(9), sum of grooves per interval. At most 10000 intervals in the
/// depth.
[[nodiscard]] CuttingSurface cutting_surface_roughness(const CuttingRegime& in);

struct SurfaceAlongArc {
  std::vector<double> position_mm;
  std::vector<double> rmax_um;
};
/// Rmax along the whole arc: the top layer leaves once it is covered, and the count starts afresh on the new
/// top.
[[nodiscard]] SurfaceAlongArc cutting_surface_profile(const CuttingRegime& in);

struct ResidualHeight {
  double rmax_um;
  double final_height_um;
  double arc_length_mm;
};
/// Largest Rmax and the height left at the end of the arc of whole intervals.
[[nodiscard]] ResidualHeight residual_height(const CuttingRegime& in);

struct ArcOfCut : WheelAndWork {
  double depth_mm = 0;
};
struct ContactArc {
  double equivalent_diameter_mm;
  double arc_length_mm;
};
/// Equivalent diameter and chord length sqrt(De t) of the contact. Internal: work radius above wheel radius.
[[nodiscard]] ContactArc contact_arc(const ArcOfCut& in);

struct GrainTip {
  double depth_um = 0;
  double tip_radius_um = 0;
  double tip_angle_deg = 0;
};
struct ScratchWidth {
  double width_um;
};
/// Width of the groove of a rounded cone at a depth, K303 eq. (9).
[[nodiscard]] ScratchWidth scratch_width(const GrainTip& in);

struct TipLayer {
  std::int64_t layer = 1;
  double interval_um = 0;
  double weibull_m = 0;
  double weibull_x0_um_m = 0;
};
struct LayerProbability {
  double probability;
};
/// Share of grains whose tips lie in the i-th layer under the wheel face, K303 eq. (8).
[[nodiscard]] LayerProbability tip_layer_probability(const TipLayer& in);

struct IntervalSearch : WheelAndWork {
  double work_speed_m_min = 0;
  double wheel_width_mm = 0;
  double step_um = 0;
  double wheel_speed_m_s = 0;
  double grain_spacing_mm = 0;
  double weibull_x0_um_m = 0;
  double weibull_m = 0;
};
struct MinimumInterval {
  double interval_um;
  double grain_count;
};
/// Smallest multiple of the step for which at least one grain of the first layer passes, K303 eq. (10).
[[nodiscard]] MinimumInterval minimum_interval(const IntervalSearch& in);

struct SpeedSearch : WheelSet {
  double protrusion_um = 0;
  double depth_mm = 0;
  double speed_low_m_min = 0;
  double speed_high_m_min = 0;
};
struct MaxWorkSpeed {
  double work_speed_m_min;
};
/// Largest work speed with Rmax < protrusion, by bisection between low and high; 0 when already the low end
/// is too fast. COMPLETION.
[[nodiscard]] MaxWorkSpeed max_work_speed_for_protrusion(const SpeedSearch& in);

struct DepthSearch : WheelSet {
  double protrusion_um = 0;
  double work_speed_m_min = 0;
};
struct MaxDepth {
  double depth_mm;
};
/// Largest whole multiple of the interval up to 0.1 mm with Rmax < protrusion; 0 when there is none.
/// COMPLETION.
[[nodiscard]] MaxDepth max_depth_for_protrusion(const DepthSearch& in);

struct SpeedAndDepth {
  double work_speed_m_min = 0;
  double depth_mm = 0;
};
struct RemovalRate {
  double q_mm3_mm_min;
};
/// Volume per minute and mm of wheel width, 1000 V_d t_f.
[[nodiscard]] RemovalRate specific_removal_rate(const SpeedAndDepth& in);

}  // namespace verstat::models::k303

template <>
struct verstat::models::EnumNames<verstat::models::k303::GrindingKind> {
  static constexpr std::array names{std::pair{k303::GrindingKind::internal, "internal"},
                                    std::pair{k303::GrindingKind::external, "external"},
                                    std::pair{k303::GrindingKind::surface, "surface"}};
};
