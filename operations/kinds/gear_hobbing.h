#pragma once
// Operation kind "gear_hobbing": cylindrical gears by a hob with axial feed (K101).
//
// The largest chip limits the feed. It is estimated in closed form, or found by the spatial model, which also
// says how the removed volume spreads over the hob teeth and takes seconds rather than microseconds.

#include <cstdint>

#include "models/gears/k101_hobbing_chip_thickness.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class ChipModel {
  hoffmeister,  ///< closed form, K101 (C5)
  spatial       ///< sweep of all hob teeth, K101 eqs. (13)-(15); single-start hobs
};

struct GearHobbing {
  static constexpr const char* kind = "gear_hobbing";
  double module_mm = 0;
  std::int64_t gear_teeth = 0;
  double gear_helix_deg = 0;
  double profile_shift = 0;
  double face_width_mm = 0;
  std::int64_t gears_per_stack = 1;
  double hob_diameter_mm = 0;
  std::int64_t hob_gashes = 10;
  std::int64_t hob_starts = 1;
  std::optional<double> hob_tip_radius_mm;  ///< absent: 0.3 modules
  double pressure_angle_deg = 20;
  double hob_addendum_factor = 1.25;
  models::k101::HobProfile hob_profile = models::k101::HobProfile::convolute;
  double cutting_speed_m_min = 0;
  double axial_feed_mm_rev = 0;
  models::k101::FeedMode feed_mode = models::k101::FeedMode::climb;
  double allowance_mm = 2;  ///< start and stop, each side of the stack

  ChipModel chip_model = ChipModel::hoffmeister;
  double angle_step_deg = 1.5;
  std::optional<double> chip_thickness_max_mm;
  std::optional<double> specific_cutting_force_mpa;
};

/// Throws models::ModelError or models::DomainError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const GearHobbing& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::ChipModel> {
  using E = operations::ChipModel;
  static constexpr std::array names{std::pair{E::hoffmeister, "hoffmeister"},
                                    std::pair{E::spatial, "spatial"}};
};
