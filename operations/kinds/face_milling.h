#pragma once
// Operation kind "face_milling": a plane milled with a mill whose indexable teeth fail one by one (K109).
//
// The mill is pulled at `replace_at_failed_teeth` failed teeth. The survivors take over the chip of the
// failed ones: all of them in equal parts (global), or only the tooth behind the gap (local). The edge life
// of the plan is that of the set of edges, from a fresh mill to its change.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

/// Who takes the chip of a failed tooth.
enum class LoadSharing {
  global,  ///< all survivors in equal parts
  local    ///< the tooth behind the gap
};
/// What the operator does with the table feed when teeth have failed.
enum class FeedAfterFailure {
  keep,   ///< the survivors cut thicker chips
  reduce  ///< in proportion to the working teeth: the load of a tooth stays
};

struct FaceMilling {
  static constexpr const char* kind = "face_milling";
  double mill_diameter_mm = 0;
  std::int64_t teeth = 1;
  double width_mm = 0;
  double length_mm = 0;
  double depth_of_cut_mm = 0;
  std::int64_t passes = 1;
  double cutting_speed_m_min = 0;
  double feed_per_tooth_mm = 0;
  std::int64_t replace_at_failed_teeth = 1;
  LoadSharing sharing = LoadSharing::global;
  FeedAfterFailure feed_after_failure = FeedAfterFailure::keep;
  double load_exponent = 2;
  std::int64_t parts_per_mission = 1;
  std::optional<double> reliability_min;
  std::optional<double> chip_per_tooth_max_mm;
  std::optional<double> kc11_mpa;
  double mc = 0.25;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a specification
/// that contradicts itself.
[[nodiscard]] CutPlan plan(const FaceMilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::LoadSharing> {
  static constexpr std::array names{std::pair{operations::LoadSharing::global, "global"},
                                    std::pair{operations::LoadSharing::local, "local"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::FeedAfterFailure> {
  static constexpr std::array names{std::pair{operations::FeedAfterFailure::keep, "keep"},
                                    std::pair{operations::FeedAfterFailure::reduce, "reduce"}};
};
