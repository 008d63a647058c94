#pragma once
// Operation kind "tool_steel_finishing": a cylinder of hardened tool steel finished by grinding or by hard
// turning with boron nitride (K116). What differs is what the surface is worth afterwards: fatigue limit,
// life at a working stress, retained austenite and the tempered zone.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

enum class SteelFinish {
  grinding_abrasive,
  grinding_boron_nitride,  ///< wheel Geksanit-A
  turning_boron_nitride    ///< cutter Geksanit-R
};

struct ToolSteelFinishing {
  static constexpr const char* kind = "tool_steel_finishing";
  SteelFinish finish = SteelFinish::turning_boron_nitride;
  double diameter_mm = 0;
  double length_mm = 0;
  double surface_speed_m_min = 0;  ///< of the part: cutting speed in turning, work speed in grinding
  double feed_mm_rev = 0;
  std::int64_t passes = 1;
  std::optional<double> working_stress_mpa;     ///< amplitude in service
  std::optional<double> fatigue_limit_min_mpa;  ///< at 1e7 cycles
  std::optional<double> tempered_depth_max_um;
  /// A lot of tools that fail by fatigue at the working stress.
  double life_cv = 0.7;
  double breakage_fraction = 0;
  double cost_per_tool = 0;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a fatigue limit
/// wanted of a finish without a fatigue curve.
[[nodiscard]] CutPlan plan(const ToolSteelFinishing& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::SteelFinish> {
  using E = operations::SteelFinish;
  static constexpr std::array names{std::pair{E::grinding_abrasive, "grinding_abrasive"},
                                    std::pair{E::grinding_boron_nitride, "grinding_boron_nitride"},
                                    std::pair{E::turning_boron_nitride, "turning_boron_nitride"}};
};
