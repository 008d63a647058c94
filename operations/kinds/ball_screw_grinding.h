#pragma once
// Operation kind "ball_screw_grinding": the circular-arc helical groove of a ball screw or nut, ground by a
// wheel whose axis crosses that of the part (K203).
//
// Either a narrow wheel of smaller profile radius, tilted more at every pass so that the groove arc grows to
// its radius, or a copying wheel as wide as the groove along the helix. The plan gives the settings of the
// last pass, the form error, passes and time, and the dressings that either wheel asks for.

#include <cstdint>

#include "models/grinding/k203_crossed_axis_groove_grinding.h"
#include "operations/dressing.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class ThreadPart { screw, nut };
/// How the wheel is dressed: a plain arc (torus), or the exact profile that the final settings need.
enum class WheelArc { toroidal, exact };

struct BallScrewGrinding : DressingLaw {
  static constexpr const char* kind = "ball_screw_grinding";
  // part
  ThreadPart part = ThreadPart::screw;
  double center_radius_mm = 0;   // of the groove arc's centre about the part axis
  double profile_radius_mm = 0;  // of the groove arc, positive
  double lead_mm = 0;
  double thread_length_mm = 0;
  double phi_max_deg = 40;  // half angle of the groove arc
  double stock_mm = 0;
  // regime
  models::k203::Method method = models::k203::Method::narrow;
  double infeed_mm = 0;
  std::int64_t sparkout_passes = 0;
  double overrun_mm = 0;
  double part_speed_rpm = 0;
  double return_speed_ratio = 1;
  double setting_time_min = 0;
  std::optional<double> specific_energy_j_mm3;
  // wheel
  double wheel_outer_radius_mm = 0;
  double wheel_profile_radius_mm = 0;
  double wheel_width_mm = 0;
  double wheel_speed_m_s = 30;
  WheelArc wheel_arc = WheelArc::exact;
  double grain_ratio = 5;
  double grinding_ratio = 0;
  double wear_limit_mm = 0;
  double dressing_time_min = 0;
  // limits
  std::optional<double> form_error_max_um;
  std::optional<double> tilt_max_deg;
  std::int64_t section_points = 21;
};

/// Throws models::ModelError for values outside the models' ranges (a groove radius that no tilt reaches, a
/// wheel that undercuts), models::DomainError for a wheel that does not fit the method.
[[nodiscard]] CutPlan plan(const BallScrewGrinding& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::ThreadPart> {
  static constexpr std::array names{std::pair{operations::ThreadPart::screw, "screw"},
                                    std::pair{operations::ThreadPart::nut, "nut"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::WheelArc> {
  static constexpr std::array names{std::pair{operations::WheelArc::toroidal, "toroidal"},
                                    std::pair{operations::WheelArc::exact, "exact"}};
};
