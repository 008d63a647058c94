#include "models/milling/s2_rolling_generation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/milling/rolling_profile.h"

namespace verstat::models::s2 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;
constexpr double on_curve_mm = 1e-9;  // a contact this near the opposite side lies on it

struct Point {
  double z;
  double y;
};
Point rotated(Point p, double angle) {
  return {p.z * std::cos(angle) - p.y * std::sin(angle), p.z * std::sin(angle) + p.y * std::cos(angle)};
}

// Slope angle of the edge to OZ.
double edge_angle_rad(const Worked& in) {
  return (90 - in.tool_angle_deg / 2) * rad_per_deg;
}

void require_on_side(const ProfileSide& side, std::string_view name, double z_mm) {
  require(side.covers(z_mm), name, z_mm, "must lie between z_min and z_max of the profile");
}

// Rolling along a side from z_start: where part and vertex stand when the contact is at z.
class Rolling {
 public:
  Rolling(const ProfileSide& side, const Stroke& in)
      : side_(side), edge_rad_(edge_angle_rad(in)), start_mm_(in.z_start_mm) {
    require_on_side(side, "z_start_mm", in.z_start_mm);
    require_on_side(side, "z_end_mm", in.z_end_mm);
    require(in.z_end_mm > in.z_start_mm, "z_end_mm", in.z_end_mm, "must be above z_start_mm");
    anchor_ = rotated(point(start_mm_), rotation_rad(start_mm_));
  }

  [[nodiscard]] Point point(double z_mm) const { return {z_mm, side_.y(z_mm)}; }
  [[nodiscard]] double rotation_rad(double z_mm) const { return edge_rad_ - std::atan(side_.slope(z_mm)); }
  [[nodiscard]] double turned_deg(double z_mm) const {
    return (rotation_rad(z_mm) - rotation_rad(start_mm_)) / rad_per_deg;
  }
  // Translation of the part when the contact lies `offset_mm` from the vertex.
  [[nodiscard]] Point translation(double z_mm, double offset_mm) const {
    const Point turned = rotated(point(z_mm), rotation_rad(z_mm));
    return {anchor_.z + offset_mm * std::cos(edge_rad_) - turned.z,
            anchor_.y + offset_mm * std::sin(edge_rad_) - turned.y};
  }
  // Tool vertex in the frame of the part.
  [[nodiscard]] Point vertex(double z_mm, double offset_mm) const {
    const double kappa = std::atan(side_.slope(z_mm));
    return {z_mm - offset_mm * std::cos(kappa), side_.y(z_mm) - offset_mm * std::sin(kappa)};
  }

 private:
  const ProfileSide& side_;
  double edge_rad_;
  double start_mm_;
  Point anchor_{};
};

double step_z(const Stroke& in, std::int64_t step) {
  if (step == in.steps) return in.z_end_mm;
  return in.z_start_mm +
         (in.z_end_mm - in.z_start_mm) * static_cast<double>(step) / static_cast<double>(in.steps);
}

// Farthest the vertex may lie behind the contact; none when the tangent meets no opposite side.
std::optional<double> offset_cap_mm(const ProfileSide& side, const ProfileSide& opposite, double z_mm) {
  const double y_mm = side.y(z_mm), slope = side.slope(z_mm);
  if (opposite.covers(z_mm) && std::abs(opposite.y(z_mm) - y_mm) <= on_curve_mm) return 0;
  const std::optional<double> met_mm = opposite.last_on_line(z_mm, y_mm, slope, z_mm);
  if (!met_mm) return std::nullopt;
  return (z_mm - *met_mm) * std::hypot(1.0, slope);
}

double penetration_mm(const ProfileSide& opposite, Point vertex) {
  return opposite.covers(vertex.z) ? opposite.y(vertex.z) - vertex.y : 0;
}

// What a stroke past a corner does, with or without the limit on the vertex.
struct CornerRun {
  double offset_mm = 0;
  double length_mm = 0;
  double least_slip = std::numeric_limits<double>::infinity();
  double gouge_mm = 0;
};

CornerRun run_past_corner(const CornerStroke& in, const ProfileSide& side, const ProfileSide& opposite,
                          const Rolling& rolling, bool limited) {
  CornerRun run;
  run.gouge_mm = std::max(0.0, penetration_mm(opposite, rolling.point(in.z_start_mm)));
  double before_mm = in.z_start_mm;
  for (std::int64_t i = 1; i <= in.steps; ++i) {
    const double z_mm = step_z(in, i);
    const double step_mm = side.arc_length(before_mm, z_mm);
    const double offset_before_mm = run.offset_mm;
    run.length_mm += step_mm;
    run.offset_mm += in.slip * step_mm;
    if (limited)
      if (const auto cap_mm = offset_cap_mm(side, opposite, z_mm))
        run.offset_mm = std::min(run.offset_mm, *cap_mm);
    run.least_slip = std::min(run.least_slip, (run.offset_mm - offset_before_mm) / step_mm);
    run.gouge_mm = std::max(run.gouge_mm, penetration_mm(opposite, rolling.vertex(z_mm, run.offset_mm)));
    before_mm = z_mm;
  }
  return run;
}

}  // namespace

ConcaveMotion concave_arc_motion(const ConcaveArc& in) {
  return guarded<&concave_arc_motion>(in, [&] {
    const double radius_mm = in.part_radius_mm + in.tool_arc_radius_mm;
    const double phi = in.rotation_deg * rad_per_deg;
    const double rate_mm_min = radius_mm * in.angular_speed_deg_s * rad_per_deg * 60;
    return ConcaveMotion{radius_mm * std::cos(phi), radius_mm * std::sin(phi), -rate_mm_min * std::sin(phi),
                         rate_mm_min * std::cos(phi)};
  });
}

TransferMotion rolling_transfer(const Transfer& in) {
  return guarded<&rolling_transfer>(in, [&] {
    const ProfileSide side(in.profile, "profile");
    require_on_side(side, "z2_mm", in.z2_mm);
    const double edge = edge_angle_rad(in);
    const std::optional<double> z1_mm = side.nearest_with_slope(std::tan(edge), in.z2_mm);
    require(z1_mm.has_value(), "tool_angle_deg", in.tool_angle_deg,
            "no point of the profile has the slope of the edge: start rolling_path from a known contact");
    const Point a1{*z1_mm, side.y(*z1_mm)}, a2{in.z2_mm, side.y(in.z2_mm)};
    const double rotation = edge - std::atan(side.slope(in.z2_mm));
    const Point turned = rotated(a2, rotation);
    const double chord_mm = std::copysign(std::hypot(a2.z - a1.z, a2.y - a1.y), a2.z - a1.z);
    const double length_mm = in.arc_mode == ArcMode::chord ? chord_mm : side.arc_length(a1.z, a2.z);
    const double slide_z_mm = a1.z - turned.z, slide_y_mm = a1.y - turned.y;
    return TransferMotion{.rotation_deg = rotation / rad_per_deg,
                          .z1_mm = a1.z,
                          .y1_mm = a1.y,
                          .z2_rot_mm = turned.z,
                          .y2_rot_mm = turned.y,
                          .ds_z1_mm = slide_z_mm,
                          .ds_y1_mm = slide_y_mm,
                          .arc_length_mm = length_mm,
                          .ds_z_mm = slide_z_mm + in.slip * length_mm * std::cos(edge),
                          .ds_y_mm = slide_y_mm + in.slip * length_mm * std::sin(edge)};
  });
}

StrokeMotion rolling_path(const Stroke& in) {
  return guarded<&rolling_path>(in, [&] {
    require(in.steps % 2 == 0, "steps", in.steps, "must be even");
    const ProfileSide side(in.profile, "profile");
    const Rolling rolling(side, in);
    const double middle_mm = step_z(in, in.steps / 2);
    const double half_mm = side.arc_length(in.z_start_mm, middle_mm);
    const double length_mm = half_mm + side.arc_length(middle_mm, in.z_end_mm);
    const Point end = rolling.translation(in.z_end_mm, in.slip * length_mm);
    const Point middle = rolling.translation(middle_mm, in.slip * half_mm);
    return StrokeMotion{{rolling.turned_deg(in.z_end_mm), end.z, end.y, in.slip * length_mm, length_mm},
                        rolling.turned_deg(middle_mm),
                        middle.z,
                        middle.y};
  });
}

VertexLimit vertex_limit(const Corner& in) {
  return guarded<&vertex_limit>(in, [&] {
    const ProfileSide side(in.profile, "profile");
    const ProfileSide opposite(in.opposite, "opposite");
    require_on_side(side, "z2_mm", in.z2_mm);
    const double kappa = std::atan(side.slope(in.z2_mm));
    const double rotation = edge_angle_rad(in) - kappa;
    VertexLimit out{rotation / rad_per_deg, false, std::nullopt, std::nullopt, std::nullopt};
    if (const auto cap_mm = offset_cap_mm(side, opposite, in.z2_mm)) {
      const Point vertex = rotated(
          {in.z2_mm - *cap_mm * std::cos(kappa), side.y(in.z2_mm) - *cap_mm * std::sin(kappa)}, rotation);
      out.limited = true;
      out.max_offset_mm = *cap_mm;
      out.vertex_z_mm = vertex.z;
      out.vertex_y_mm = vertex.y;
    }
    return out;
  });
}

Gouge vertex_gouge(const CornerStroke& in) {
  return guarded<&vertex_gouge>(in, [&] {
    const ProfileSide side(in.profile, "profile");
    const ProfileSide opposite(in.opposite, "opposite");
    return Gouge{run_past_corner(in, side, opposite, Rolling(side, in), false).gouge_mm};
  });
}

LimitedStroke rolling_path_limited(const CornerStroke& in) {
  return guarded<&rolling_path_limited>(in, [&] {
    const ProfileSide side(in.profile, "profile");
    const ProfileSide opposite(in.opposite, "opposite");
    const Rolling rolling(side, in);
    const CornerRun run = run_past_corner(in, side, opposite, rolling, true);
    const Point end = rolling.translation(in.z_end_mm, run.offset_mm);
    return LimitedStroke{{rolling.turned_deg(in.z_end_mm), end.z, end.y, run.offset_mm, run.length_mm},
                         run.offset_mm / run.length_mm,
                         run.least_slip,
                         run.gouge_mm};
  });
}

Coordination coordination_kind(const SectionAndTool& in) {
  return guarded<&coordination_kind>(in, [&] {
    const bool fits = in.tool_angle_deg <= in.side_angle_deg;
    switch (in.section) {
      case Section::concave_arc:
        return Coordination{1, fits};
      case Section::junction:
        return Coordination{in.side_angle_deg < 90 ? 3 : 2, fits};
      case Section::convex:
      case Section::straight:
        break;
    }
    return Coordination{2, fits};
  });
}

FacetError facet_error(const FacetStep& in) {
  return guarded<&facet_error>(in, [&] {
    const double half = in.rotation_step_deg / 2 * rad_per_deg;
    const double sine = std::sin(half / 2);
    return FacetError{in.curvature_radius_mm * 2 * sine * sine / std::cos(half)};
  });
}

RotationStep rotation_step_for_tolerance(const FacetTolerance& in) {
  return guarded<&rotation_step_for_tolerance>(in, [&] {
    // 2 acos(1/(1 + s)) in half angles, without cancellation at small s.
    const double s = in.tolerance_mm / in.curvature_radius_mm;
    return RotationStep{4 * std::atan(std::sqrt(s / (2 + s))) / rad_per_deg};
  });
}

StrokeTime rolling_time(const TimedStroke& in) {
  return guarded<&rolling_time>(in, [&] {
    const ProfileSide side(in.profile, "profile");
    const Rolling rolling(side, in);
    double time_min = 0, offset_mm = 0, z_before_mm = in.z_start_mm;
    Point before = rolling.translation(z_before_mm, 0);
    for (std::int64_t i = 1; i <= in.steps; ++i) {
      const double z_mm = step_z(in, i);
      const double step_mm = side.arc_length(z_before_mm, z_mm);
      offset_mm += in.slip * step_mm;
      const Point here = rolling.translation(z_mm, offset_mm);
      const double turn = std::abs(rolling.rotation_rad(z_mm) - rolling.rotation_rad(z_before_mm));
      time_min += std::max({step_mm / in.feed_mm_min, turn / (2 * pi * in.max_rotation_rpm),
                            std::abs(here.z - before.z) / in.max_axis_feed_mm_min,
                            std::abs(here.y - before.y) / in.max_axis_feed_mm_min});
      before = here;
      z_before_mm = z_mm;
    }
    return StrokeTime{time_min};
  });
}

WearSpread edge_wear_spread(const EdgeTravel& in) {
  return guarded<&edge_wear_spread>(in, [&] {
    const double travel_mm = std::abs(in.slip) * in.arc_length_mm;
    return WearSpread{travel_mm, 1 + travel_mm / in.contact_width_mm};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "S2",
       .title = "Kinematic model with three nonlinear forming motions for shaping complex surfaces",
       .authors = "Ambrosimov S. K., Kharlamov G. A., Cherepenko A. A.",
       .published =
           "Bulletin of the South Ural State University, ser. Mechanical Engineering, vol. 16, no. 3, "
           "2016, pp. 63-71",
       .models =
           "Milling of dies and moulds by a disc tool with a wedge section. The part turns and the table "
           "translates along Z and Y, so that the straight edge stays tangent to the profile and rolls on it "
           "without slip, with slip, or slides. Three kinds of coordination: concave arc, convex and "
           "straight "
           "parts, neighbourhood of a sharp corner.",
       .role = "milling",
       .errata = {
           "Eq. (3): V_y is printed with a minus; the derivative of (2) is positive.",
           "Eq. (12): the second line is lost; it is the tangent at A2, as the text says.",
           "The translation is that of the table with the part: with this reading p = 1 gives no sliding at "
           "the contact."}});

  const Value dome =
      Value::Map{{"kind", "arc"}, {"zc", 25.980762113533157}, {"yc", -15.0}, {"r", 30.0}, {"z_min", 0.0},
                 {"z_max", 52.98}};
  const Value mirrored = Value::Map{{"kind", "arc"}, {"zc", -25.980762113533157}, {"yc", -15.0},
                                    {"r", 30.0},     {"z_min", -52.98},           {"z_max", 0.0}};
  const Value arch =
      Value::Map{{"kind", "arc"}, {"zc", 12.0}, {"yc", 20.0}, {"r", 30.0}, {"z_min", -17.9}, {"z_max", 41.9}};

  const auto worked = [](const Value& profile) {
    return [profile](auto& f) {
      f.input(&Worked::profile, "profile", "f", "mm", no_range(), "worked side y = f(z), convex", profile)
          .input(&Worked::tool_angle_deg, "tool_angle_deg", "alpha", "deg", open(0, 180),
                 "included angle of the tool", 40.0);
    };
  };
  const auto stroke = [](double start_mm, double end_mm) {
    return [start_mm, end_mm](auto& f) {
      f.input(&Stroke::z_start_mm, "z_start_mm", "-", "mm", any(), "contact at the start", start_mm)
          .input(&Stroke::z_end_mm, "z_end_mm", "-", "mm", any(), "contact at the end, above the start",
                 end_mm)
          .input(&Stroke::steps, "steps", "n", "1", closed(2, 100'000), "equal steps in z", 20)
          .input(&Stroke::slip, "slip", "p", "1", any(), "1 rolling, 0 sliding", 1.0);
    };
  };
  const auto stroke_end = [](auto& f) {
    f.output(&StrokeEnd::rotation_deg, "rotation_deg", "phi", "deg", any(), "rotation of the part")
        .output(&StrokeEnd::s_z_mm, "s_z_mm", "S_z", "mm", any(), "translation of the part along Z")
        .output(&StrokeEnd::s_y_mm, "s_y_mm", "S_y", "mm", any(), "translation of the part along Y")
        .output(&StrokeEnd::vertex_offset_mm, "vertex_offset_mm", "c", "mm", any(),
                "distance of the contact from the tool vertex")
        .output(&StrokeEnd::arc_length_mm, "arc_length_mm", "L", "mm", positive(),
                "length along the profile");
  };
  const auto opposite = [&](auto pointer) {
    return [pointer, mirrored](auto& f) {
      f.input(pointer, "opposite", "f_B", "mm", no_range(), "opposite side y = f_B(z)", mirrored);
    };
  };
  const std::string convex_note = "The worked side must be convex; this is not tested.";

  source
      .function<&concave_arc_motion>("concave_arc_motion",
                                     "Motion for a concave arc of the tool's own radius.", "eqs. (2), (3)",
                                     Provenance::repaired)
      .input(&ConcaveArc::part_radius_mm, "part_radius_mm", "R_A", "mm", positive(),
             "radius to the contact on the part", 40.0)
      .input(&ConcaveArc::tool_arc_radius_mm, "tool_arc_radius_mm", "r_0", "mm", positive(),
             "radius at the tool vertex", 5.0)
      .input(&ConcaveArc::rotation_deg, "rotation_deg", "phi", "deg", any(), "rotation from OZ", 30.0)
      .input(&ConcaveArc::angular_speed_deg_s, "angular_speed_deg_s", "omega", "deg/s", any(),
             "angular speed", 30.0)
      .output(&ConcaveMotion::s_z_mm, "s_z_mm", "S_z", "mm", any(), "along Z")
      .output(&ConcaveMotion::s_y_mm, "s_y_mm", "S_y", "mm", any(), "along Y")
      .output(&ConcaveMotion::v_z_mm_min, "v_z_mm_min", "V_z", "mm/min", any(), "its rate")
      .output(&ConcaveMotion::v_y_mm_min, "v_y_mm_min", "V_y", "mm/min", any(), "its rate");
  source
      .function<&rolling_transfer>("rolling_transfer", "Motion that carries the contact to a point.",
                                   "eqs. (5)-(11)", Provenance::reconstructed)
      .with(worked(arch))
      .input(&Transfer::z2_mm, "z2_mm", "z_2", "mm", any(), "the contact to reach", 0.0)
      .input(&Transfer::slip, "slip", "p", "1", any(), "1 rolling, 0 sliding", 1.0)
      .input(&Transfer::arc_mode, "arc_mode", "-", "-", no_range(), "length by chord (paper) or exact",
             "exact")
      .output(&TransferMotion::rotation_deg, "rotation_deg", "Delta phi", "deg", any(),
              "rotation of the part")
      .output(&TransferMotion::z1_mm, "z1_mm", "z_1", "mm", any(), "contact before the rotation")
      .output(&TransferMotion::y1_mm, "y1_mm", "y_1", "mm", any(), "contact before the rotation")
      .output(&TransferMotion::z2_rot_mm, "z2_rot_mm", "z_2'", "mm", any(), "new contact, rotated")
      .output(&TransferMotion::y2_rot_mm, "y2_rot_mm", "y_2'", "mm", any(), "new contact, rotated")
      .output(&TransferMotion::ds_z1_mm, "ds_z1_mm", "Delta S_z1", "mm", any(), "motion without rolling")
      .output(&TransferMotion::ds_y1_mm, "ds_y1_mm", "Delta S_y1", "mm", any(), "motion without rolling")
      .output(&TransferMotion::arc_length_mm, "arc_length_mm", "L", "mm", any(),
              "length along the profile, negative when z2 < z1")
      .output(&TransferMotion::ds_z_mm, "ds_z_mm", "Delta S_z", "mm", any(), "translation along Z")
      .output(&TransferMotion::ds_y_mm, "ds_y_mm", "Delta S_y", "mm", any(), "translation along Y")
      .note("Translations are those of the table with the part relative to a fixed tool.")
      .note(convex_note);
  source
      .function<&rolling_path>("rolling_path", "Motion along a whole side, relative to the start.",
                               "eqs. (5)-(11)", Provenance::reconstructed)
      .with(worked(arch))
      .with(stroke(-14.0, 5.0))
      .with(stroke_end)
      .output(&StrokeMotion::mid_rotation_deg, "mid_rotation_deg", "phi", "deg", any(),
              "rotation after half of the steps")
      .output(&StrokeMotion::mid_s_z_mm, "mid_s_z_mm", "S_z", "mm", any(), "translation then")
      .output(&StrokeMotion::mid_s_y_mm, "mid_s_y_mm", "S_y", "mm", any(), "translation then")
      .note("The number of steps must be even.")
      .note(convex_note);
  source
      .function<&vertex_limit>("vertex_limit", "Farthest the tool vertex may lie from the contact.",
                               "eq. (12)", Provenance::reconstructed)
      .with(worked(dome))
      .with(opposite(&Corner::opposite))
      .input(&Corner::z2_mm, "z2_mm", "z_2", "mm", any(), "the contact", 3.0)
      .output(&VertexLimit::rotation_deg, "rotation_deg", "Delta phi", "deg", any(), "rotation of the part")
      .output(&VertexLimit::limited, "limited", "-", "-", no_range(), "the opposite side sets a limit")
      .output(&VertexLimit::max_offset_mm, "max_offset_mm", "-", "mm", non_negative(),
              "largest distance of the vertex; null when not limited")
      .output(&VertexLimit::vertex_z_mm, "vertex_z_mm", "z_B", "mm", any(),
              "limiting vertex after the rotation; null when not limited")
      .output(&VertexLimit::vertex_y_mm, "vertex_y_mm", "y_B", "mm", any(),
              "limiting vertex after the rotation; null when not limited")
      .note("The vertex is taken as sharp: with a radius the limit is conservative.");
  source
      .function<&vertex_gouge>("vertex_gouge",
                               "Penetration of the vertex into the opposite side without limiting.",
                               "eqs. (1), (12)", Provenance::reconstructed)
      .with(worked(dome))
      .with(opposite(&CornerStroke::opposite))
      .with(stroke(0.0, 6.0))
      .output(&Gouge::max_gouge_mm, "max_gouge_mm", "-", "mm", non_negative(), "deepest over the steps");
  source
      .function<&rolling_path_limited>("rolling_path_limited",
                                       "Path with the slip reduced where the vertex would gouge.",
                                       "eqs. (1), (12)", Provenance::reconstructed)
      .with(worked(dome))
      .with(opposite(&CornerStroke::opposite))
      .with(stroke(0.0, 6.0))
      .with(stroke_end)
      .output(&LimitedStroke::mean_slip, "mean_slip", "-", "1", any(), "slip over the whole stroke")
      .output(&LimitedStroke::min_step_slip, "min_step_slip", "-", "1", any(), "least slip of a step")
      .output(&LimitedStroke::max_gouge_mm, "max_gouge_mm", "-", "mm", non_negative(),
              "penetration that is left");
  source
      .function<&coordination_kind>("coordination_kind", "Kind of coordination for a section.", "text",
                                    Provenance::paper)
      .input(&SectionAndTool::section, "section", "-", "-", no_range(), "section of the profile", "junction")
      .input(&SectionAndTool::side_angle_deg, "side_angle_deg", "beta", "deg", open(0, 360),
             "angle between the sides", 80.0)
      .input(&SectionAndTool::tool_angle_deg, "tool_angle_deg", "alpha", "deg", open(0, 180),
             "included angle of the tool", 60.0)
      .output(&Coordination::kind, "kind", "-", "1", closed(1, 3), "kind of coordination")
      .output(&Coordination::tool_fits, "tool_fits", "-", "-", no_range(), "alpha <= beta");
  source
      .function<&facet_error>("facet_error", "Height left between two successive tangents.", "completion",
                              Provenance::completion)
      .input(&FacetStep::curvature_radius_mm, "curvature_radius_mm", "r", "mm", positive(),
             "radius of curvature", 30.0)
      .input(&FacetStep::rotation_step_deg, "rotation_step_deg", "Delta phi", "deg", open_high(0, 180),
             "rotation between the tangents", 1.0)
      .output(&FacetError::facet_error_mm, "facet_error_mm", "e", "mm", non_negative(), "facet error");
  source
      .function<&rotation_step_for_tolerance>("rotation_step_for_tolerance",
                                              "Rotation step that leaves a facet error.", "completion",
                                              Provenance::completion)
      .input(&FacetTolerance::curvature_radius_mm, "curvature_radius_mm", "r", "mm", positive(),
             "radius of curvature", 30.0)
      .input(&FacetTolerance::tolerance_mm, "tolerance_mm", "e", "mm", positive(), "allowed facet error",
             0.005)
      .output(&RotationStep::rotation_step_deg, "rotation_step_deg", "Delta phi", "deg", positive(),
              "rotation step");
  source
      .function<&rolling_time>("rolling_time", "Time of one generating stroke under axis limits.",
                               "completion", Provenance::completion)
      .with(worked(arch))
      .with(stroke(-14.0, 5.0))
      .input(&TimedStroke::feed_mm_min, "feed_mm_min", "v", "mm/min", positive(), "feed along the profile",
             200.0)
      .input(&TimedStroke::max_rotation_rpm, "max_rotation_rpm", "n_max", "rpm", positive(),
             "largest speed of rotation", 5.0)
      .input(&TimedStroke::max_axis_feed_mm_min, "max_axis_feed_mm_min", "V_max", "mm/min", positive(),
             "largest feed of Z and of Y", 2000.0)
      .output(&StrokeTime::time_min, "time_min", "-", "min", positive(), "time of the stroke");
  source
      .function<&edge_wear_spread>("edge_wear_spread", "Travel of the contact along the edge.", "completion",
                                   Provenance::completion)
      .input(&EdgeTravel::slip, "slip", "p", "1", any(), "1 rolling, 0 sliding", 1.0)
      .input(&EdgeTravel::arc_length_mm, "arc_length_mm", "L", "mm", non_negative(),
             "length along the profile", 40.0)
      .input(&EdgeTravel::contact_width_mm, "contact_width_mm", "b", "mm", positive(),
             "width of the contact along the edge", 5.0)
      .output(&WearSpread::contact_travel_mm, "contact_travel_mm", "-", "mm", non_negative(),
              "travel of the contact")
      .output(&WearSpread::life_factor, "life_factor", "-", "1", at_least(1),
              "gain in tool life over pure sliding");
}

}  // namespace verstat::models::s2

std::vector<verstat::models::Field> verstat::models::StructFields<verstat::models::s2::Profile>::fields() {
  using s2::Profile;
  return {member<Profile>(&Profile::kind, "kind", "-", "-", no_range(), "kind of curve"),
          member<Profile>(&Profile::coeff, "coeff", "c", "mm", any(), "poly: c0, c1, ... of c0 + c1 z + ...",
                          false),
          member<Profile>(&Profile::zc, "zc", "-", "mm", any(), "arc: z of the centre", false),
          member<Profile>(&Profile::yc, "yc", "-", "mm", any(), "arc: y of the centre", false),
          member<Profile>(&Profile::r, "r", "-", "mm", positive(), "arc: radius, of the upper half", false),
          member<Profile>(&Profile::z, "z", "-", "mm", any(), "points: z, ascending", false),
          member<Profile>(&Profile::y, "y", "-", "mm", any(), "points: y", false),
          member<Profile>(&Profile::z_min, "z_min", "-", "mm", any(), "start of the used range"),
          member<Profile>(&Profile::z_max, "z_max", "-", "mm", any(), "end of the used range")};
}
