#pragma once
// Operation kind "lathe_milling": flats (S4) and polygons (K301) milled from a round blank on a turning
// centre, the part turning about C while the turret moves along X.
//
// Engagement, hence force, changes along every face: a constant feed obeys the worst position, a stabilised
// one keeps the peak force at its limit everywhere. Short blocks of the program limit the feed that the
// control sustains.

#include <cstdint>

#include "models/milling/k301_polygon_milling.h"
#include "models/milling/s4_rotating_tools.h"
#include "operations/kind.h"

namespace verstat::operations {

enum class LatheShape {
  polygon,  ///< closed contour of equal faces in one turn
  flats     ///< separate flats, in layers
};

struct LatheMilling {
  static constexpr const char* kind = "lathe_milling";
  LatheShape shape = LatheShape::polygon;
  std::int64_t faces = 6;
  double apothem_mm = 0;
  double blank_diameter_mm = 0;
  double axial_length_mm = 0;
  double axial_depth_mm = 0;
  std::optional<double> width_of_cut_mm;
  double approach_mm = 0;
  double tool_diameter_mm = 0;
  std::int64_t teeth = 4;
  double helix_deg = 30;
  double tool_speed_rpm = 0;
  models::s4::MillingMode mode = models::s4::MillingMode::up;
  double kc11_mpa = 0;
  double mc = 0.25;
  double force_limit_n = 0;
  models::k301::FeedStrategy feed = models::k301::FeedStrategy::constant;
  double feed_min_mm_min = 1;
  double feed_max_mm_min = 0;
  double x_rate_max_mm_min = 0;
  double c_rate_max_deg_min = 0;
  std::optional<double> block_time_ms;
  std::optional<double> block_length_mm;
  std::optional<double> chord_tolerance_mm;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a specification
/// that contradicts itself.
[[nodiscard]] CutPlan plan(const LatheMilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::LatheShape> {
  static constexpr std::array names{std::pair{operations::LatheShape::polygon, "polygon"},
                                    std::pair{operations::LatheShape::flats, "flats"}};
};
