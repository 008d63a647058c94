#pragma once
// Operation kind "reaming": a hole finished with a reamer or a boring bar, a stepped elastic tool in a rigid,
// rocking or floating holder (K408). The teeth must not shake the tool at its natural frequency.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

/// How the tip of the tool is held by the hole.
enum class ToolTip { pinned, clamped };

struct Reaming {
  static constexpr const char* kind = "reaming";
  double diameter_mm = 0;
  double length_mm = 0;
  double approach_mm = 3;
  double overrun_mm = 15;
  double allowance_mm = 0.2;  ///< on the diameter
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  std::int64_t teeth = 8;
  /// The tool from the holder end to the tip.
  std::vector<double> segment_length_mm;
  std::vector<double> segment_outer_mm;
  std::vector<double> segment_inner_mm;  ///< empty: no bore
  std::vector<double> inertia_factor;    ///< of fluted segments, empty: 1
  std::vector<double> area_factor;       ///< likewise
  ToolTip tip = ToolTip::pinned;
  double modulus_gpa = 210;
  double density_kg_m3 = 7850;
  double margin = 0.2;              ///< tooth frequency below the first natural one
  std::optional<double> torque_nm;  ///< measured or from a handbook
};

/// The holder is that of the machine's spindle, rigid when the machine declares none.
/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const Reaming& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::ToolTip> {
  using E = operations::ToolTip;
  static constexpr std::array names{std::pair{E::pinned, "pinned"}, std::pair{E::clamped, "clamped"}};
};
