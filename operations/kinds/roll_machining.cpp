#include "operations/kinds/roll_machining.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

namespace verstat::models {

using operations::RollCut;
using operations::RollFacing;
using operations::RollFinish;
using operations::RollGrinding;
using operations::RollMachining;

std::vector<Field> StructFields<RollCut>::fields() {
  using S = RollCut;
  return {need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e4),
                  "constant surface speed"),
          need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 100), "feed"),
          need<S>(&S::depth_max_mm, "depth_max_mm", "mm", closed(1e-2, 100), "largest depth of a pass")};
}

std::vector<Field> StructFields<RollFinish>::fields() {
  using S = RollFinish;
  return {need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e4),
                  "constant surface speed"),
          need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-3, 100), "feed")};
}

std::vector<Field> StructFields<RollFacing>::fields() {
  using S = RollFacing;
  return {need<S>(&S::allowance_mm, "allowance_mm", "mm", closed(0, 1000), "axial allowance of each face"),
          may<S>(&S::inner_diameter_mm, "inner_diameter_mm", "mm", closed(0, 1e4),
                 "diameter at which the facing ends"),
          need<S>(&S::cut, "cut", "-", no_range(), "regime")};
}

std::vector<Field> StructFields<RollGrinding>::fields() {
  using S = RollGrinding;
  return {
      may<S>(&S::wheel_width_mm, "wheel_width_mm", "mm", open_low(0, 1000), "width of the wheel"),
      may<S>(&S::reserve, "reserve", "1", closed(1, 2), "reserve k_z on the allowance (paper 1.1 to 1.3)"),
      may<S>(&S::dressed_radius_mm, "dressed_radius_mm", "mm", open_low(0, 1e9),
             "radius to which the wheel is dressed; absent: the largest allowed"),
      may<S>(&S::scallop_um, "scallop_um", "um", open_low(0, 1000), "height of the ridges left"),
      may<S>(&S::feed_max_mm_rev, "feed_max_mm_rev", "mm/rev", open_low(0, 1000),
             "largest feed along the roll"),
      may<S>(&S::infeed_mm, "infeed_mm", "mm", open_low(0, 10), "infeed of a pass"),
      may<S>(&S::sparkout_passes, "sparkout_passes", "1", closed(0, 1000), "passes of spark-out"),
      may<S>(&S::work_speed_m_min, "work_speed_m_min", "m/min", open_low(0, 1000), "speed of the work")};
}

template <>
struct StructFields<RollMachining> {
  static std::vector<Field> fields() {
    using S = RollMachining;
    return {
        may<S>(&S::stage, "stage", "-", no_range(), "the whole roll, its turning or its grinding"),
        need<S>(&S::throat_diameter_mm, "throat_diameter_mm", "mm", open_low(0, 1e4), "throat diameter"),
        need<S>(&S::pipe_diameter_mm, "pipe_diameter_mm", "mm", open_low(0, 1e4),
                "diameter of the pipe that the roll straightens"),
        may<S>(&S::crossing_angle_deg, "crossing_angle_deg", "deg", closed(5, 90),
               "angle between the axes of roll and pipe"),
        need<S>(&S::half_length_mm, "half_length_mm", "mm", open_low(0, 1e4),
                "half the length of the working profile"),
        may<S>(&S::fillet_radius_mm, "fillet_radius_mm", "mm", open_low(0, 1000), "fillet to the faces"),
        may<S>(&S::profile_points, "profile_points", "1", closed(3, 2001), "points of the profile, odd"),
        may<S>(&S::arc_points, "arc_points", "1", closed(1, 1000), "points of a fillet"),
        need<S>(&S::blank_diameter_mm, "blank_diameter_mm", "mm", open_low(0, 1e4), "diameter of the blank"),
        may<S>(&S::finish_allowance_mm, "finish_allowance_mm", "mm", closed(0, 50),
               "allowance of finish turning, per side"),
        may<S>(&S::grind_allowance_mm, "grind_allowance_mm", "mm", closed(0, 10),
               "allowance of grinding, per side"),
        may<S>(&S::spindle_speed_max_rpm, "spindle_speed_max_rpm", "rpm", open_low(0, 1e5),
               "largest spindle speed of roughing and facing"),
        may<S>(&S::finish_speed_max_rpm, "finish_speed_max_rpm", "rpm", open_low(0, 1e5),
               "largest spindle speed of finish turning"),
        may<S>(&S::approach_mm, "approach_mm", "mm", closed(0, 1000), "approach of a pass"),
        may<S>(&S::overrun_mm, "overrun_mm", "mm", closed(0, 1000), "overrun of a cylinder pass"),
        may<S>(&S::rapid_mm_min, "rapid_mm_min", "mm/min", open_low(0, 1e6), "rapid speed"),
        need<S>(&S::rough, "rough", "-", no_range(), "roughing"),
        need<S>(&S::finish, "finish", "-", no_range(), "finish turning"),
        need<S>(&S::facing, "facing", "-", no_range(), "facing of both ends"),
        may<S>(&S::grinding, "grinding", "-", no_range(), "profile grinding"),
        may<S>(&S::handling_min, "handling_min", "min", closed(0, 1e5), "handling per set-up of a piece"),
        may<S>(&S::setups, "setups", "1", closed(0, 1000), "set-ups of a piece"),
        may<S>(&S::setup_min, "setup_min", "min", closed(0, 1e5), "machine set-up, each, once a batch"),
        may<S>(&S::programming_min, "programming_min", "min", closed(0, 1e6),
               "programming, once a batch (paper: 15 to 25)"),
        may<S>(&S::batch, "batch", "1", closed(1, 1'000'000), "rolls in a batch"),
        may<S>(&S::chord_error_max_um, "chord_error_max_um", "um", open_low(0, 1000),
               "largest error of the polyline against the profile")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k412 = models::k412;

k412::ContourSampling sampling(const RollMachining& spec) {
  k412::ContourSampling s;
  s.throat_diameter_mm = spec.throat_diameter_mm;
  s.pipe_diameter_mm = spec.pipe_diameter_mm;
  s.crossing_angle_deg = spec.crossing_angle_deg;
  s.half_length_mm = spec.half_length_mm;
  s.n_points = spec.profile_points;
  s.fillet_radius_mm = spec.fillet_radius_mm;
  s.arc_points = spec.arc_points;
  return s;
}

k412::Contour finishing_contour(const RollMachining& spec, const k412::Contour& contour) {
  k412::OffsetInput in;
  in.y_mm = contour.y_mm;
  in.x_radius_mm = contour.x_radius_mm;
  in.offset_mm = spec.grind_allowance_mm;
  return k412::offset_contour(in);
}

struct Times {
  double rough_main_min = 0;
  double rough_rapid_min = 0;
  double finish_main_min = 0;
  double facing_main_min = 0;
  double grind_main_min = 0;
};

void roughing(const RollMachining& spec, const k412::Contour& contour, Times& times, CutPlan& p) {
  k412::RoughTurning in;
  in.y_mm = contour.y_mm;
  in.x_radius_mm = contour.x_radius_mm;
  in.blank_diameter_mm = spec.blank_diameter_mm;
  in.finish_allowance_mm = spec.finish_allowance_mm;
  in.grind_allowance_mm = spec.grind_allowance_mm;
  in.max_depth_mm = spec.rough.depth_max_mm;
  in.feed_mm_rev = spec.rough.feed_mm_rev;
  in.speed_m_min = spec.rough.cutting_speed_m_min;
  in.max_rpm = spec.spindle_speed_max_rpm;
  in.approach_mm = spec.approach_mm;
  in.overrun_mm = spec.overrun_mm;
  in.rapid_mm_min = spec.rapid_mm_min;
  const auto rough = k412::rough_turning_plan(in);
  times.rough_main_min = rough.main_time_min;
  times.rough_rapid_min = rough.rapid_time_min;
  constexpr const char* origin = "K412.rough_turning_plan";
  const auto add = [&](const char* name, double value, const char* unit, const char* meaning) {
    p.quantities.push_back({name, value, unit, origin, meaning});
  };
  add("rough_time_min", rough.main_time_min, "min", "main time of both phases of roughing");
  add("rough_rapid_min", rough.rapid_time_min, "min", "rapid returns of roughing");
  add("rough_cut_length_mm", rough.cut_length_mm, "mm", "toolpath of roughing, in the cut");
  add("cylinder_passes", static_cast<double>(rough.cylinder_passes), "1", "down to the crest");
  add("cylinder_depth_mm", rough.cylinder_depth_mm, "mm", "of a cylinder pass");
  add("contour_passes", static_cast<double>(rough.contour_passes), "1", "along equidistants");
  add("contour_depth_mm", rough.contour_depth_mm, "mm", "of a contour pass");
  add("removed_cm3", rough.removed_cm3, "cm3", "metal removed by roughing");
}

void finishing(const RollMachining& spec, const k412::Contour& contour, Times& times, CutPlan& p) {
  k412::PassInput in;
  static_cast<k412::Contour&>(in) = finishing_contour(spec, contour);
  in.feed_mm_rev = spec.finish.feed_mm_rev;
  in.speed_m_min = spec.finish.cutting_speed_m_min;
  in.max_rpm = spec.finish_speed_max_rpm;
  const auto pass = k412::contour_pass_time(in);
  times.finish_main_min = pass.main_time_min;
  constexpr const char* origin = "K412.contour_pass_time";
  p.quantities.push_back(
      {"finish_time_min", pass.main_time_min, "min", origin, "main time of finish turning"});
  p.quantities.push_back({"finish_path_mm", pass.length_mm, "mm", origin, "toolpath of finish turning"});
}

void facing(const RollMachining& spec, Times& times, CutPlan& p) {
  const auto face = k412::facing_time({.outer_diameter_mm = spec.blank_diameter_mm,
                                       .inner_diameter_mm = spec.facing.inner_diameter_mm,
                                       .allowance_mm = spec.facing.allowance_mm,
                                       .max_depth_mm = spec.facing.cut.depth_max_mm,
                                       .feed_mm_rev = spec.facing.cut.feed_mm_rev,
                                       .speed_m_min = spec.facing.cut.cutting_speed_m_min,
                                       .max_rpm = spec.spindle_speed_max_rpm,
                                       .approach_mm = spec.approach_mm});
  times.facing_main_min = 2 * face.main_time_min;
  p.quantities.push_back(
      {"facing_time_min", times.facing_main_min, "min", "K412.facing_time", "main time of both faces"});
}

/// Mean diameter of the finished contour along its length.
double mean_diameter_mm(const k412::Contour& contour, double length_mm) {
  double sum = 0;
  for (std::size_t k = 1; k < contour.y_mm.size(); ++k)
    sum += (contour.x_radius_mm[k] + contour.x_radius_mm[k - 1]) *
           std::hypot(contour.y_mm[k] - contour.y_mm[k - 1],
                      contour.x_radius_mm[k] - contour.x_radius_mm[k - 1]);
  return sum / length_mm;
}

void grinding(const RollMachining& spec, const k412::RollContour& contour, double curvature_radius_mm,
              Times& times, CutPlan& p) {
  const RollGrinding& g = spec.grinding;
  const double largest_mm = k412::dressing_radius_for_wheel({.wheel_width_mm = g.wheel_width_mm,
                                                             .allowance_mm = spec.grind_allowance_mm,
                                                             .reserve = g.reserve,
                                                             .profile_radius_mm = curvature_radius_mm})
                                .radius_mm;
  constexpr const char* origin = "K412.dressing_radius_for_wheel";
  p.quantities.push_back({"dressing_radius_max_mm", largest_mm, "mm", origin,
                          "largest radius that does not grind with the wheel's side"});
  // A wheel dressed flatter than allowed still has a time: the limit says that it must not be used.
  const double radius_mm = g.dressed_radius_mm.value_or(largest_mm);
  p.quantities.push_back({"dressing_radius_mm", radius_mm, "mm", origin, "to which the wheel is dressed"});
  if (g.dressed_radius_mm)
    p.limits.push_back({"dressing_radius_mm", radius_mm, largest_mm, true, "mm", origin});
  const double scallop_feed_mm_rev =
      k412::grinding_feed_for_scallop({.wheel_radius_mm = radius_mm,
                                       .profile_radius_mm = curvature_radius_mm,
                                       .scallop_um = g.scallop_um})
          .feed_mm_rev;
  const double feed_mm_rev = std::min(scallop_feed_mm_rev, g.feed_max_mm_rev);
  p.quantities.push_back({"grinding_feed_mm_rev", feed_mm_rev, "mm/rev", "K412.grinding_feed_for_scallop",
                          "along the roll, for the height of the ridges"});
  const auto time =
      k412::profile_grinding_time({.contour_length_mm = contour.length_mm,
                                   .mean_diameter_mm = mean_diameter_mm(contour, contour.length_mm),
                                   .allowance_mm = spec.grind_allowance_mm,
                                   .infeed_mm = g.infeed_mm,
                                   .sparkout_passes = g.sparkout_passes,
                                   .feed_mm_rev = feed_mm_rev,
                                   .work_speed_m_min = g.work_speed_m_min});
  times.grind_main_min = time.main_time_min;
  constexpr const char* by_time = "K412.profile_grinding_time";
  p.quantities.push_back({"grinding_time_min", time.main_time_min, "min", by_time, "main time of grinding"});
  p.quantities.push_back(
      {"grinding_passes", static_cast<double>(time.passes), "1", by_time, "with spark-out"});
  p.quantities.push_back({"work_speed_rpm", time.work_rpm, "rpm", by_time, "of the roll in grinding"});
}

void profile_error(const RollMachining& spec, double curvature_radius_mm, CutPlan& p) {
  const double spacing_mm = 2 * spec.half_length_mm / static_cast<double>(spec.profile_points - 1);
  const double error_um = 1000 * spacing_mm * spacing_mm / (8 * curvature_radius_mm);
  constexpr const char* origin = "COMPLETION: chord error";
  p.quantities.push_back(
      {"chord_error_um", error_um, "um", origin, "of the polyline against the profile at the throat"});
  if (spec.chord_error_max_um)
    p.limits.push_back({"chord_error_um", error_um, *spec.chord_error_max_um, true, "um", origin});
}

/// Constant surface speed: slowest on the blank, fastest at the throat or where facing ends.
void spindle_speeds(const RollMachining& spec, const PlanContext& context, CutPlan& p) {
  const auto rpm = [](double speed_m_min, double diameter_mm, double cap_rpm) {
    // At the centre of a face the speed is the cap.
    return std::min(cap_rpm, 1000 * speed_m_min / (std::numbers::pi * std::max(diameter_mm, 1e-9)));
  };
  const double rough_m_min = spec.rough.cutting_speed_m_min;
  const double finish_m_min = spec.finish.cutting_speed_m_min;
  const double face_m_min = spec.facing.cut.cutting_speed_m_min;
  double highest_rpm = std::max(rpm(rough_m_min, spec.throat_diameter_mm, spec.spindle_speed_max_rpm),
                                rpm(finish_m_min, spec.throat_diameter_mm, spec.finish_speed_max_rpm));
  double lowest_rpm = std::min(rpm(rough_m_min, spec.blank_diameter_mm, spec.spindle_speed_max_rpm),
                               rpm(finish_m_min, spec.blank_diameter_mm, spec.finish_speed_max_rpm));
  if (spec.facing.allowance_mm > 0) {
    highest_rpm =
        std::max(highest_rpm, rpm(face_m_min, spec.facing.inner_diameter_mm, spec.spindle_speed_max_rpm));
    lowest_rpm = std::min(lowest_rpm, rpm(face_m_min, spec.blank_diameter_mm, spec.spindle_speed_max_rpm));
  }
  limit_spindle_speed(p, context, lowest_rpm, highest_rpm, "definition");
}

}  // namespace

CutPlan plan(const RollMachining& spec, const PlanContext& context) {
  const k412::ContourSampling points = sampling(spec);
  const k412::RollContour contour = k412::roll_contour(points);
  const double curvature_radius_mm = k412::roll_profile(points).throat_curvature_radius_mm;
  const bool turned = spec.stage != RollStage::grinding;
  const bool ground = spec.stage != RollStage::turning && spec.grind_allowance_mm > 0;

  CutPlan p;
  Times t;
  p.quantities.push_back(
      {"max_diameter_mm", contour.max_diameter_mm, "mm", "K412.roll_contour", "at the crest of the fillet"});
  p.quantities.push_back(
      {"contour_length_mm", contour.length_mm, "mm", "K412.roll_contour", "from face to face"});
  p.quantities.push_back({"throat_curvature_radius_mm", curvature_radius_mm, "mm", "K412.roll_profile",
                          "of the axial section at the throat"});
  profile_error(spec, curvature_radius_mm, p);
  if (turned) {
    roughing(spec, contour, t, p);
    finishing(spec, contour, t, p);
    facing(spec, t, p);
  }
  if (ground) grinding(spec, contour, curvature_radius_mm, t, p);

  const auto part = k412::roll_part_time({.rough_main_min = t.rough_main_min,
                                          .rough_rapid_min = t.rough_rapid_min,
                                          .finish_main_min = t.finish_main_min,
                                          .facing_main_min = t.facing_main_min,
                                          .grind_main_min = t.grind_main_min,
                                          .handling_min = spec.handling_min,
                                          .setups = spec.setups,
                                          .setup_min = spec.setup_min,
                                          .programming_min = spec.programming_min,
                                          .batch = spec.batch});
  constexpr const char* origin = "K412.roll_part_time";
  p.quantities.push_back(
      {"piece_time_min", part.piece_min, "min", origin, "with rapid returns and handling"});
  p.quantities.push_back({"time_per_part_min", part.per_part_min, "min", origin,
                          "with the part's share of set-up and programming"});
  p.set_main_time(part.main_min, origin);

  if (turned) {
    if (context.edge != nullptr)  // the roughing edge: it does nearly all of the turning
      p.edge = taylor_life(*context.edge, spec.rough.cutting_speed_m_min, spec.rough.feed_mm_rev,
                           spec.rough.depth_max_mm);
    spindle_speeds(spec, context, p);
  }
  return p;
}

models::k412::Program finishing_program(const RollMachining& spec, std::int64_t tool, double clearance_mm) {
  k412::ProgramInput in;
  static_cast<k412::Contour&>(in) = finishing_contour(spec, k412::roll_contour(sampling(spec)));
  in.feed_mm_rev = spec.finish.feed_mm_rev;
  in.speed_m_min = spec.finish.cutting_speed_m_min;
  in.max_rpm = spec.finish_speed_max_rpm;
  in.tool = tool;
  in.clearance_mm = clearance_mm;
  return k412::gcode_contour(in);
}

namespace roll_machining {
void add_to(Kinds& kinds) {
  kinds.add<RollMachining>("A pipe-straightening roll turned and ground from its profile.", {"K412", "K117"});
}
}  // namespace roll_machining

}  // namespace verstat::operations
