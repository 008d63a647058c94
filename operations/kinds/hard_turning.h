#pragma once
// Operation kind "hard_turning": a shaped part of hardened steel turned with a round CBN or ceramic insert.
//
// The part is a chain of straight segments, machined in order. Forces follow K106: they grow with wear, the
// radial one far faster than the main one, so that the radial force and what it bends decide when the edge is
// spent, not the power. The point of the edge that forms the surface moves along the edge with the slope;
// where it lands on a notch worn by another segment the surface suffers: K107 forbids those feeds and depths.

#include <cstdint>
#include <vector>

#include "models/cutting/k106_cylindrical_rake_hard_turning.h"
#include "operations/kind.h"

namespace verstat::operations {

/// A straight segment of the profile.
struct ProfileSegment {
  double length_mm = 0;  ///< along the generatrix
  double slope_deg = 0;  ///< against the axis; rising outwards in the direction of feed: positive
};

struct HardTurning {
  static constexpr const char* kind = "hard_turning";
  double diameter_mm = 0;                ///< mean, for the spindle speed
  std::vector<ProfileSegment> segments;  ///< in the order of machining
  std::int64_t passes = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;      ///< along the generatrix
  double depth_of_cut_mm = 0;  ///< normal to the generatrix
  double insert_radius_mm = 3.5;
  models::k106::Rake rake = models::k106::Rake::cylindrical;
  models::k106::ToolMaterial tool_material = models::k106::ToolMaterial::cbn;
  double flank_wear_mm = 0.15;             ///< of the edge when it is taken out: forces are judged there
  std::optional<double> cutting_time_min;  ///< of the edge since it was new: adds the growth with time
  double notch_half_width_mm = 0.05;       ///< along the edge
  bool persistent_edge = true;             ///< the edge has already cut whole parts
  double clash_scrap_probability = 0;      ///< of a part when feed or depth is forbidden
  std::optional<double> least_concave_radius_mm;
  std::optional<double> length_between_centres_mm;  ///< adds the deflection of the part
  double elastic_modulus_mpa = 210'000;
  std::optional<double> radial_force_max_n;
  std::optional<double> deflection_max_um;
  std::optional<double> scallop_max_um;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for contradictions.
[[nodiscard]] CutPlan plan(const HardTurning& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::StructFields<verstat::operations::ProfileSegment> {
  static std::vector<Field> fields();
};
