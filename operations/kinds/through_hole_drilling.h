#pragma once
// Operation kind "through_hole_drilling": through holes of one diameter, drilled one by one or several at a
// time from a multi-spindle head.
//
// What the drill does when it breaks through is a strategy (K113): the feed jump overloads the drill, every
// cure costs time. The point of the drill is standard, slotted (K111) or sharpened (K114); head and drill
// bushings follow K308. The loads can be fitted to runs of a finite-element study or of tests (K410).

#include <cstdint>

#include "models/drilling/k113_through_hole_feed_change.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class DrillPoint {
  standard,         ///< plane-ground chisel edge
  slotted_chisel,   ///< chisel of zero rake in a slot of reverse inclination, K111
  sharpened_chisel  ///< roof-shaped chisel edge with ground flank and face, K114
};
enum class DrillBushing { none, fixed, rotating };

/// Head that drills several holes in one stroke, K308.
struct MultiSpindleHead {
  std::int64_t drills = 2;
  std::int64_t pinion_teeth = 20;
  std::int64_t gear_teeth = 20;
  double gear_module_mm = 2;
  std::optional<double> centre_distance_mm;  ///< of two adjustable spindles
};

/// One simulated or measured run of the drill, K410.
struct DrillRun {
  double diameter_mm = 0;
  double feed_mm_rev = 0;
  double thrust_n = 0;
  double torque_nm = 0;
};

struct ThroughHoleDrilling {
  static constexpr const char* kind = "through_hole_drilling";
  double diameter_mm = 0;
  double thickness_mm = 0;
  std::int64_t holes = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double approach_mm = 2;
  double overrun_mm = 1;
  double index_min = 0;  ///< from stroke to stroke
  std::optional<MultiSpindleHead> head;

  models::k113::ExitStrategy exit_strategy = models::k113::ExitStrategy::constant;
  double feed_divisor = 1.25;
  double exit_zone_fraction = 0.3;  ///< of the diameter
  std::optional<double> spring_rate_n_mm;
  double spring_feed_cap_ratio = 1.85;

  /// Loads of a standard point: P = C D^x S^y; defaults for structural steel.
  double thrust_coefficient_n = 680;
  double thrust_exp_diameter = 1;
  double thrust_exp_feed = 0.7;
  double torque_coefficient_nm = 0.345;
  double torque_exp_diameter = 2;
  double torque_exp_feed = 0.8;
  double load_cv = 0.1;
  /// Simulated or measured runs: the power laws are fitted to them instead (K410).
  std::vector<DrillRun> runs;
  double strength_mpa = 750;  ///< of the steel, for the comparison with the handbook

  DrillPoint point = DrillPoint::standard;
  double half_point_angle_deg = 59;
  double chisel_share = 0.5;  ///< of the thrust of a standard point
  double chisel_force_ratio = 0.4;
  double clearance_periphery_deg = 12;
  double core_ratio = 0.15;  ///< core over drill diameter
  double slot_tilt_deg = 10;
  double slot_width_mm = 0.2;
  double kinematic_clearance_min_deg = 1;
  double chisel_slope_deg = 50;
  double chisel_half_angle_deg = 85;
  double chisel_clearance_deg = 12;
  double chisel_rake_deg = 20;
  double chisel_wedge_min_deg = 40;

  /// Breakthrough: a measured feed jump, or the compliance of the machine.
  std::optional<double> feed_jump;
  std::optional<double> axial_stiffness_n_mm;
  double relieved_share = 0.5;
  std::optional<double> relief_travel_mm;  ///< absent: the height of the point

  /// Strength of the drill.
  std::optional<double> break_torque_nm;
  double break_torque_cv = 0.1;
  std::optional<double> torsion_allow_mpa;
  std::optional<double> overhang_mm;
  std::optional<double> breakage_probability_max;

  DrillBushing bushing = DrillBushing::none;
  double bushing_holes_fixed = 10'000;  ///< holes until a fixed bushing is worn out
  double bushing_slip = 0.02;
  double bushing_return_factor = 0.3;
  double return_feed_mm_rev = 0.8;
};

/// Throws models::ModelError or models::DomainError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const ThroughHoleDrilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::DrillPoint> {
  using E = operations::DrillPoint;
  static constexpr std::array names{std::pair{E::standard, "standard"},
                                    std::pair{E::slotted_chisel, "slotted_chisel"},
                                    std::pair{E::sharpened_chisel, "sharpened_chisel"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::DrillBushing> {
  using E = operations::DrillBushing;
  static constexpr std::array names{std::pair{E::none, "none"}, std::pair{E::fixed, "fixed"},
                                    std::pair{E::rotating, "rotating"}};
};
template <>
struct verstat::models::StructFields<verstat::operations::DrillRun> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::MultiSpindleHead> {
  static std::vector<Field> fields();
};
