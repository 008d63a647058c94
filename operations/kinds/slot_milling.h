#pragma once
// Operation kind "slot_milling": a T-slot (or another nearly closed profile slot) in one pass (K105).
//
// Chips that do not get out are cut again and add up to a quarter to the lateral force, hence to the form
// error of the slot. A device that takes them out is equipment that a shop can buy.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

enum class ChipEvacuation {
  none,   ///< chips circulate with the cutter
  device  ///< takes `evacuation_efficiency` of the chips that would meet the tool again
};

struct SlotMilling {
  static constexpr const char* kind = "slot_milling";
  double cutter_diameter_mm = 0;
  double throat_width_mm = 0;
  double head_height_mm = 0;
  double stem_diameter_mm = 0;
  double overhang_mm = 0;
  double elastic_modulus_mpa = 210'000;
  std::int64_t teeth = 6;
  double spindle_speed_rpm = 0;
  double table_feed_mm_min = 0;
  double length_mm = 0;
  double approach_mm = 0;
  std::int64_t slots = 1;
  double kc11_mpa = 0;
  double mc = 0.25;
  std::optional<double> lateral_force_n;
  double reinteraction_share = 0.63;
  ChipEvacuation evacuation = ChipEvacuation::none;
  double evacuation_efficiency = 0.5;
  std::optional<double> side_error_max_um;
  std::optional<double> face_error_max_um;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const SlotMilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::ChipEvacuation> {
  static constexpr std::array names{std::pair{operations::ChipEvacuation::none, "none"},
                                    std::pair{operations::ChipEvacuation::device, "device"}};
};
