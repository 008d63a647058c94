#include "operations/kinds/rolling_generation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/milling/rolling_profile.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

template <>
struct verstat::models::StructFields<verstat::operations::RollingGeneration> {
  static std::vector<Field> fields() {
    using S = operations::RollingGeneration;
    return {
        need<S>(&S::profile, "profile", "-", no_range(), "worked side, convex"),
        may<S>(&S::opposite, "opposite", "-", no_range(), "side on the other flank of the corner"),
        need<S>(&S::tool_angle_deg, "tool_angle_deg", "deg", open(0, 180), "angle between the edges alpha"),
        may<S>(&S::corner_angle_deg, "corner_angle_deg", "deg", open(0, 180),
               "smallest angle between the sides of the profile; the tool must fit into it"),
        need<S>(&S::z_start_mm, "z_start_mm", "mm", any(), "start of the stroke"),
        need<S>(&S::z_end_mm, "z_end_mm", "mm", any(), "end of the stroke, above the start"),
        may<S>(&S::steps, "steps", "1", closed(2, 10'000), "steps of the program, equal in z, even"),
        may<S>(&S::slip, "slip", "1", closed(0, 1), "1 rolls, 0 slides"),
        may<S>(&S::corner, "corner", "-", no_range(), "what is done near the opposite side"),
        may<S>(&S::strokes, "strokes", "1", closed(1, 1'000'000), "strokes side by side"),
        need<S>(&S::feed_mm_min, "feed_mm_min", "mm/min", open_low(0, 1e5), "feed along the profile"),
        need<S>(&S::max_rotation_rpm, "max_rotation_rpm", "rpm", open_low(0, 1e4),
                "largest speed of the rotary axis"),
        need<S>(&S::max_axis_feed_mm_min, "max_axis_feed_mm_min", "mm/min", open_low(0, 1e6),
                "largest feed of the linear axes"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e5),
                "cutting speed of the disc tool"),
        need<S>(&S::feed_per_tooth_mm, "feed_per_tooth_mm", "mm", open_low(0, 10), "feed per tooth"),
        need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", open_low(0, 100), "depth of cut"),
        may<S>(&S::contact_width_mm, "contact_width_mm", "mm", open_low(0, 100),
               "width of the contact on the edge"),
        may<S>(&S::facet_max_mm, "facet_max_mm", "mm", above(0), "allowed height of the facets"),
        may<S>(&S::gouge_max_mm, "gouge_max_mm", "mm", open_low(0, 10),
               "allowed cut of the vertex into the opposite side")};
  }
};

namespace verstat::operations {

namespace s2 = models::s2;

namespace {

// Below this a step is straight: no facet, and no radius to compute one from.
constexpr double straight_deg = 1e-9;

// Largest facet of the stroke: each step turns the edge from one tangent to the next, with the mean radius
// of the profile between them.
double largest_facet_mm(const s2::Stroke& stroke) {
  const s2::ProfileSide side(stroke.profile, "profile");
  const double width_mm = (stroke.z_end_mm - stroke.z_start_mm) / static_cast<double>(stroke.steps);
  const auto tangent_deg = [&](double z_mm) { return std::atan(side.slope(z_mm)) * 180 / std::numbers::pi; };
  double largest_mm = 0;
  double from_mm = stroke.z_start_mm;
  double from_deg = tangent_deg(from_mm);
  for (std::int64_t k = 1; k <= stroke.steps; ++k) {
    const double to_mm =
        k == stroke.steps ? stroke.z_end_mm : stroke.z_start_mm + static_cast<double>(k) * width_mm;
    const double to_deg = tangent_deg(to_mm);
    const double turn_deg = std::abs(to_deg - from_deg);
    if (turn_deg >= straight_deg) {
      const double radius_mm = side.arc_length(from_mm, to_mm) * 180 / (std::numbers::pi * turn_deg);
      largest_mm = std::max(largest_mm, s2::facet_error({radius_mm, turn_deg}).facet_error_mm);
    }
    from_mm = to_mm;
    from_deg = to_deg;
  }
  return largest_mm;
}

}  // namespace

CutPlan plan(const RollingGeneration& spec, const PlanContext& context) {
  models::require(spec.z_start_mm < spec.z_end_mm, "z_end_mm", spec.z_end_mm, "must be above z_start_mm");
  models::require(spec.steps % 2 == 0, "steps", spec.steps, "must be even");
  const bool limited = spec.corner == CornerControl::limited_slip;
  if (limited && !spec.opposite)
    models::reject("corner = \"limited_slip\" needs the opposite side that limits it");

  s2::TimedStroke stroke;
  stroke.profile = spec.profile;
  stroke.tool_angle_deg = spec.tool_angle_deg;
  stroke.z_start_mm = spec.z_start_mm;
  stroke.z_end_mm = spec.z_end_mm;
  stroke.steps = spec.steps;
  stroke.slip = spec.slip;
  stroke.feed_mm_min = spec.feed_mm_min;
  stroke.max_rotation_rpm = spec.max_rotation_rpm;
  stroke.max_axis_feed_mm_min = spec.max_axis_feed_mm_min;
  const double stroke_min = s2::rolling_time(stroke).time_min;
  const s2::StrokeMotion whole = s2::rolling_path(stroke);
  const double facet_mm = largest_facet_mm(stroke);

  double mean_slip = spec.slip;
  double gouge_mm = 0;
  if (spec.opposite) {
    s2::CornerStroke corner;
    static_cast<s2::Stroke&>(corner) = stroke;
    corner.opposite = *spec.opposite;
    if (limited) {
      const s2::LimitedStroke held = s2::rolling_path_limited(corner);
      mean_slip = held.mean_slip;
      gouge_mm = held.max_gouge_mm;
    } else {
      gouge_mm = s2::vertex_gouge(corner).max_gouge_mm;
    }
  }
  const s2::WearSpread spread = s2::edge_wear_spread({mean_slip, whole.arc_length_mm, spec.contact_width_mm});

  CutPlan p;
  p.quantities.reserve(12);
  p.set_main_time(static_cast<double>(spec.strokes) * stroke_min, "S2.rolling_time");
  p.quantities.push_back({"stroke_time_min", stroke_min, "min", "S2.rolling_time", "time of one stroke"});
  p.quantities.push_back(
      {"profile_length_mm", whole.arc_length_mm, "mm", "S2.rolling_path", "length of the worked side"});
  p.quantities.push_back(
      {"rotation_deg", whole.rotation_deg, "deg", "S2.rolling_path", "turn of the part in a stroke"});
  p.quantities.push_back({"table_travel_z_mm", whole.s_z_mm, "mm", "S2.rolling_path",
                          "travel of the table along Z, without limiting"});
  p.quantities.push_back({"table_travel_y_mm", whole.s_y_mm, "mm", "S2.rolling_path",
                          "travel of the table along Y, without limiting"});
  p.quantities.push_back(
      {"facet_mm", facet_mm, "mm", "S2.facet_error", "largest facet that the steps leave"});
  p.quantities.push_back({"mean_slip", mean_slip, "1", limited ? "S2.rolling_path_limited" : "given",
                          "mean slip over the stroke"});
  p.quantities.push_back(
      {"life_factor", spread.life_factor, "1", "S2.edge_wear_spread", "gain in tool life over pure sliding"});
  if (spec.opposite) {
    const char* origin = limited ? "S2.rolling_path_limited" : "S2.vertex_gouge";
    p.quantities.push_back({"gouge_mm", gouge_mm, "mm", origin, "cut of the vertex into the opposite side"});
    p.limits.push_back({"gouge_mm", gouge_mm, spec.gouge_max_mm, true, "mm", origin});
  }
  if (spec.facet_max_mm)
    p.limits.push_back({"facet_mm", facet_mm, *spec.facet_max_mm, true, "mm", "S2.facet_error"});
  if (spec.corner_angle_deg)
    p.limits.push_back(
        {"tool_angle_deg", spec.tool_angle_deg, *spec.corner_angle_deg, true, "deg", "S2.coordination_kind"});
  MachineLoad load;
  load.feed_rate_mm_min = spec.feed_mm_min;
  add_machine_limits(p, context, load);
  if (context.edge != nullptr) {
    // The life of the shop's data is that of an edge that cuts with one spot; rolling spreads the wear.
    p.edge =
        taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_per_tooth_mm, spec.depth_of_cut_mm);
    p.edge->mean_min *= spread.life_factor;
    p.edge->origin = "K117.mean_life_for_regime, S2.edge_wear_spread";
  }
  return p;
}

namespace rolling_generation {
void add_to(Kinds& kinds) {
  kinds.add<RollingGeneration>("A die profile generated by a straight edge that rolls on it.", {"S2"});
}
}  // namespace rolling_generation

}  // namespace verstat::operations
