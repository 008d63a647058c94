#pragma once
// Operation kind "roll_machining": a roll of a pipe-straightening machine, from its profile to its machining
// (K412): facing, roughing in two phases, finish turning, profile grinding. Profile and allowances give the
// toolpaths, the toolpaths give the times; the wheel's dressing radius and its feed follow from the
// curvature.

#include "models/toolpath/k412_straightening_roll.h"
#include "operations/kind.h"

namespace verstat::operations {

/// Which machine's share of the roll the operation is.
enum class RollStage { complete, turning, grinding };

/// Speed, feed and depth of a turning pass.
struct RollCut {
  double cutting_speed_m_min = 0;  ///< constant surface speed up to the largest spindle speed
  double feed_mm_rev = 0;
  double depth_max_mm = 0;
};

struct RollFinish {
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
};

struct RollFacing {
  double allowance_mm = 0;  ///< axial, each face
  double inner_diameter_mm = 0;
  RollCut cut;
};

struct RollGrinding {
  double wheel_width_mm = 40;
  double reserve = 1.2;                     ///< k_z on the allowance (paper 1.1 to 1.3)
  std::optional<double> dressed_radius_mm;  ///< absent: the largest that does not grind with the wheel's side
  double scallop_um = 1;
  double feed_max_mm_rev = 20;
  double infeed_mm = 0.02;
  std::int64_t sparkout_passes = 2;
  double work_speed_m_min = 20;
};

struct RollMachining {
  static constexpr const char* kind = "roll_machining";
  RollStage stage = RollStage::complete;
  double throat_diameter_mm = 0;
  double pipe_diameter_mm = 0;
  double crossing_angle_deg = 30;
  double half_length_mm = 0;
  double fillet_radius_mm = 12;
  std::int64_t profile_points = 121;
  std::int64_t arc_points = 12;
  double blank_diameter_mm = 0;
  double finish_allowance_mm = 0.8;
  double grind_allowance_mm = 0.3;
  double spindle_speed_max_rpm = 800;  ///< of roughing and facing
  double finish_speed_max_rpm = 1200;
  double approach_mm = 3;
  double overrun_mm = 3;
  double rapid_mm_min = 4000;
  RollCut rough;
  RollFinish finish;
  RollFacing facing;
  RollGrinding grinding;
  double handling_min = 0;  ///< per set-up of a piece
  std::int64_t setups = 1;
  double setup_min = 0;        ///< of the machine, each set-up, once a batch
  double programming_min = 0;  ///< once a batch (paper: 15 to 25 min)
  std::int64_t batch = 1;
  std::optional<double> chord_error_max_um;  ///< of the profile's polyline
};

/// Throws models::ModelError for values outside the models' ranges: a blank below the roughed cylinder.
[[nodiscard]] CutPlan plan(const RollMachining& spec, const PlanContext& context);

/// The NC program of the finishing pass, along the contour that leaves the grinding allowance.
/// `tool` 1..99; `clearance_mm` >= 0. K412.gcode_contour.
[[nodiscard]] models::k412::Program finishing_program(const RollMachining& spec, std::int64_t tool,
                                                      double clearance_mm);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::RollStage> {
  static constexpr std::array names{std::pair{operations::RollStage::complete, "complete"},
                                    std::pair{operations::RollStage::turning, "turning"},
                                    std::pair{operations::RollStage::grinding, "grinding"}};
};
template <>
struct verstat::models::StructFields<verstat::operations::RollCut> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::RollFinish> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::RollFacing> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::RollGrinding> {
  static std::vector<Field> fields();
};
