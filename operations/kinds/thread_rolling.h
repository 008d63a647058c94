#pragma once
// Operation kind "thread_rolling": an external thread rolled between rollers that plunge into the blank
// (K407). The quality of the blanks drives the force; the rolled thread is stronger than a cut one.

#include <cstdint>

#include "models/treatment/k407_thread_rolling.h"
#include "operations/kind.h"

namespace verstat::operations {

/// How much the blanks of a delivery raise the force, K1..K4 of K407 eq. (4) over those of a good delivery.
struct BlankFactors {
  double form = 1, hardness = 1, diameter = 1, location = 1;
};

struct ThreadRolling {
  static constexpr const char* kind = "thread_rolling";
  double pitch_mm = 0;
  double half_angle_deg = 30;
  double tip_flat_mm = 0;    ///< of the ridges of the roller
  double tip_radius_mm = 0;  ///< above 0: rounded instead of flat
  double profile_height_mm = 0;
  double half_tolerance_mm = 0;
  double minor_diameter_mm = 0;
  double roller_diameter_mm = 0;
  std::int64_t rollers = 2;
  std::vector<double> lead_in_drop_mm;  ///< of each lead-in ridge below the sizing ridges, falling
  std::int64_t sizing_turns = 2;        ///< of ridges
  double rolling_speed_m_min = 0;
  double feed_mm_rev = 0;
  double approach_mm = 0.5;
  double sizing_revolutions = 6;
  double handling_min = 0;
  BlankFactors blanks;
  double force_base = 9.4;  ///< coefficient of the force of good blanks
  std::optional<double> blank_diameter_mm;
  double blank_tolerance_mm = 0.05;
  std::optional<double> radial_force_max_kn;
  models::k407::StrengthProperty strength = models::k407::StrengthProperty::bending_fatigue;
  std::optional<double> strength_factor_min;  ///< that the part needs over a cut thread
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const ThreadRolling& spec, const PlanContext& context);

}  // namespace verstat::operations
