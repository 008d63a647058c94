#include "models/milling/s1_cam_milling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::s1 {
namespace {

using std::numbers::pi;

constexpr double rad_per_deg = pi / 180;

constexpr double square(double x) {
  return x * x;
}

// One arc of the cam in terms of the normal angle u >= 0: h = radius + distance cos(u + phase).
struct Arc {
  double radius_mm;
  double distance_mm;  // of its centre from the base centre
  double phase_rad;
  double from_rad;  // the normal angles it covers
  double to_rad;
};

struct Support {
  double h_mm;
  double dh_mm_rad;
  double rho_mm;
};

// The cam's arcs and joints, from nose to base.
class CamArcs {
 public:
  explicit CamArcs(const Cam& cam) {
    const double r_flank_mm = cam.r_flank_mm;
    require(r_flank_mm > std::max(cam.r_base_mm, cam.r_nose_mm), "cam/r_flank_mm", r_flank_mm,
            "must be larger than r_base_mm and r_nose_mm");
    const double a_mm = r_flank_mm - cam.r_base_mm;
    const double b_mm = r_flank_mm - cam.r_nose_mm;
    const double d_mm = cam.centre_distance_mm;
    const double cos_chi = (d_mm * d_mm + (a_mm - b_mm) * (a_mm + b_mm)) / (2 * d_mm * a_mm);
    require(std::abs(cos_chi) < 1, "cam/centre_distance_mm", d_mm,
            "the arcs do not join: no flank arc touches both base and nose");
    const double chi = std::acos(cos_chi);
    const double sin_chi = std::sqrt((1 - cos_chi) * (1 + cos_chi));
    base_joint_rad = pi - chi;
    nose_joint_rad = std::atan2(a_mm * sin_chi, d_mm - a_mm * cos_chi);
    require(nose_joint_rad > 0 && nose_joint_rad < base_joint_rad && base_joint_rad < pi,
            "cam/centre_distance_mm", d_mm, "the arcs do not join: the flank would have no length");
    arcs[0] = {cam.r_nose_mm, d_mm, 0, 0, nose_joint_rad};
    arcs[1] = {r_flank_mm, a_mm, chi, nose_joint_rad, base_joint_rad};
    arcs[2] = {cam.r_base_mm, 0, 0, base_joint_rad, pi};
    lift_mm = d_mm + cam.r_nose_mm - cam.r_base_mm;
  }

  [[nodiscard]] double perimeter_mm() const {
    double half_mm = 0;
    for (const Arc& arc : arcs) half_mm += arc.radius_mm * (arc.to_rad - arc.from_rad);
    return 2 * half_mm;
  }

  [[nodiscard]] Support support(double normal_deg) const {
    const double wrapped_deg = std::remainder(normal_deg, 360);
    const double u = std::abs(wrapped_deg) * rad_per_deg;
    // 1e-12 rad: a joint given in degrees stays on the arc nearer the nose.
    const Arc& arc = u <= nose_joint_rad + 1e-12 ? arcs[0] : u <= base_joint_rad + 1e-12 ? arcs[1] : arcs[2];
    const double slope = -arc.distance_mm * std::sin(u + arc.phase_rad);
    return {arc.radius_mm + arc.distance_mm * std::cos(u + arc.phase_rad),
            (wrapped_deg < 0 ? -slope : slope) + 0.0,  // no negative zero
            arc.radius_mm};
  }

  std::array<Arc, 3> arcs;
  double nose_joint_rad = 0;
  double base_joint_rad = 0;
  double lift_mm = 0;
};

PartPoint in_part_frame(const ToolPlacement& in, double tool_angle_rad) {
  const double alpha = in.orientation_deg * rad_per_deg;
  const double part = in.part_angle_deg * rad_per_deg;
  const double across_mm = in.x_mm - in.tool_radius_mm * std::sin(tool_angle_rad);
  const double x_mm = across_mm * std::cos(alpha) + in.tool_z_mm * std::sin(alpha);
  const double y_mm = in.y_mm + in.tool_radius_mm * std::cos(tool_angle_rad);
  const double z_mm = -across_mm * std::sin(alpha) + in.tool_z_mm * std::cos(alpha) + in.z_mm;
  return {x_mm * std::cos(part) - y_mm * std::sin(part), x_mm * std::sin(part) + y_mm * std::cos(part), z_mm};
}

// Contour feed of the usual scheme per radian of part rotation, at normal angle u on the arc.
double feed_per_radian_mm(const Arc& arc, double u, double tool_radius_mm) {
  const double q_mm =
      arc.radius_mm + tool_radius_mm + arc.distance_mm * std::cos(u + arc.phase_rad);  // h + R
  const double slope_mm = arc.distance_mm * std::sin(u + arc.phase_rad);
  return arc.radius_mm * (q_mm * q_mm + slope_mm * slope_mm) / (q_mm * (arc.radius_mm + tool_radius_mm));
}

// 1 - cos(atan(tangent)) without cancellation.
double versine_of(double tangent) {
  const double secant = std::sqrt(1 + tangent * tangent);
  return tangent * tangent / (secant * (1 + secant));
}

double sin_squared(double angle_deg) {
  return square(std::sin(angle_deg * rad_per_deg));
}

constexpr double ra_of_rz = 4 / (9 * std::numbers::sqrt3);  // of a parabolic profile

}  // namespace

PartPoint tool_point_in_part(const ToolPoint& in) {
  return guarded<&tool_point_in_part>(in, [&] { return in_part_frame(in, in.tool_angle_deg * rad_per_deg); });
}

ContactPoint contact_point(const MovingTool& in) {
  return guarded<&contact_point>(in, [&] {
    const double alpha = in.orientation_deg * rad_per_deg;
    const double over = in.x_mm * std::cos(alpha) + in.tool_z_mm * std::sin(alpha) + in.dy_mm_rad;
    const double under = in.y_mm * std::cos(alpha) - in.dx_mm_rad + in.dz_mm_rad * std::sin(alpha);
    require(under != 0, "y_mm", in.y_mm,
            "y cos(orientation) - dx + dz sin(orientation) must not be zero: the contact is undefined");
    const double tool_angle_rad = pi - std::atan(over / under);
    return ContactPoint{in_part_frame(in, tool_angle_rad), tool_angle_rad / rad_per_deg};
  });
}

CamGeometry cam_geometry(const CamOnly& in) {
  return guarded<&cam_geometry>(in, [&] {
    const CamArcs cam(in.cam);
    return CamGeometry{cam.nose_joint_rad / rad_per_deg, cam.base_joint_rad / rad_per_deg, cam.lift_mm,
                       cam.perimeter_mm()};
  });
}

CamSupport cam_support(const CamAtNormal& in) {
  return guarded<&cam_support>(in, [&] {
    const Support s = CamArcs(in.cam).support(in.normal_angle_deg);
    const double normal = std::remainder(in.normal_angle_deg, 360) * rad_per_deg;
    return CamSupport{s.h_mm, s.dh_mm_rad, s.rho_mm,
                      s.h_mm * std::cos(normal) - s.dh_mm_rad * std::sin(normal),
                      s.h_mm * std::sin(normal) + s.dh_mm_rad * std::cos(normal)};
  });
}

ToolSetting cam_tool_setting(const CamSetting& in) {
  return guarded<&cam_tool_setting>(in, [&] {
    const Support s = CamArcs(in.cam).support(in.normal_angle_deg);
    const double vertical_mm = 0.0 - s.dh_mm_rad;
    return ToolSetting{s.h_mm + in.tool_radius_mm, vertical_mm,
                       vertical_mm / std::cos(in.orientation_deg * rad_per_deg)};
  });
}

RotationLaw cam_rotation_law(const CamFeed& in) {
  return guarded<&cam_rotation_law>(in, [&] {
    const Support s = CamArcs(in.cam).support(in.normal_angle_deg);
    const double omega_rad_min = in.contour_feed_mm_min / s.rho_mm;
    return RotationLaw{omega_rad_min / (2 * pi), s.dh_mm_rad * omega_rad_min,
                       (s.h_mm - s.rho_mm) * omega_rad_min};
  });
}

CamTime cam_milling_time(const CamPass& in) {
  return guarded<&cam_milling_time>(in, [&] {
    const double revolutions = (in.width_mm + in.overrun_mm) / in.axial_feed_mm_rev;
    return CamTime{revolutions, revolutions * CamArcs(in.cam).perimeter_mm() / in.contour_feed_mm_min};
  });
}

ConventionalState conventional_state(const UniformRotation& in) {
  return guarded<&conventional_state>(in, [&] {
    const Support s = CamArcs(in.cam).support(in.normal_angle_deg);
    const double q_mm = s.h_mm + in.tool_radius_mm;
    const double centre_mm = std::hypot(q_mm, s.dh_mm_rad);
    return ConventionalState{
        in.normal_angle_deg + std::atan2(s.dh_mm_rad, q_mm) / rad_per_deg, centre_mm,
        in.tool_radius_mm * s.dh_mm_rad / centre_mm,
        2 * pi * in.part_speed_rpm * s.rho_mm * square(centre_mm) / (q_mm * (s.rho_mm + in.tool_radius_mm))};
  });
}

FeedNonuniformity conventional_feed_nonuniformity(const CamAndTool& in) {
  return guarded<&conventional_feed_nonuniformity>(in, [&] {
    const CamArcs cam(in.cam);
    double least_mm = feed_per_radian_mm(cam.arcs[0], 0, in.tool_radius_mm);
    double most_mm = least_mm;
    for (const Arc& arc : cam.arcs)
      for (const double u : {arc.from_rad, arc.to_rad}) {
        const double feed_mm = feed_per_radian_mm(arc, u, in.tool_radius_mm);
        least_mm = std::min(least_mm, feed_mm);
        most_mm = std::max(most_mm, feed_mm);
      }
    return FeedNonuniformity{most_mm / least_mm, 2 * pi * most_mm / cam.perimeter_mm()};
  });
}

FormError tool_wear_form_error(const WornTool& in) {
  return guarded<&tool_wear_form_error>(in, [&] {
    const CamArcs cam(in.cam);
    if (in.scheme == WearScheme::normal_contact) return FormError{0};
    double steepest = 0;
    for (const Arc& arc : cam.arcs) {
      const double k_mm = arc.radius_mm + in.tool_radius_mm;
      const auto tangent = [&](double w) {
        return std::abs(arc.distance_mm * std::sin(w) / (k_mm + arc.distance_mm * std::cos(w)));
      };
      steepest =
          std::max({steepest, tangent(arc.from_rad + arc.phase_rad), tangent(arc.to_rad + arc.phase_rad)});
      if (arc.distance_mm >= k_mm) continue;
      // Inside an arc the slope is stationary where the line of centres touches the circle of its centre.
      const double w = std::acos(-arc.distance_mm / k_mm);
      if (w > arc.from_rad + arc.phase_rad && w < arc.to_rad + arc.phase_rad)
        steepest = std::max(steepest, tangent(w));
    }
    return FormError{in.radius_loss_mm * versine_of(steepest)};
  });
}

AxialRoughness axial_roughness(const AxialCut& in) {
  return guarded<&axial_roughness>(in, [&] {
    const double sin2 = sin_squared(in.orientation_deg);
    const double reach_mm =
        in.tool_radius_mm + in.part_radius_mm * square(std::cos(in.orientation_deg * rad_per_deg));
    AxialRoughness out{};
    // An angle too small for its radius to be a number is as good as zero.
    if (const double radius_mm = reach_mm / sin2; std::isfinite(radius_mm))
      out.effective_radius_mm = radius_mm;
    out.rz_um = 1000 * square(in.axial_feed_mm_rev) * sin2 / (8 * reach_mm);
    out.ra_um = ra_of_rz * out.rz_um;
    return out;
  });
}

Orientation max_orientation_for_roughness(const RoughnessLimit& in) {
  return guarded<&max_orientation_for_roughness>(in, [&] {
    const double ra_mm = in.ra_limit_um / 1000;
    const double feed_term_mm2 = ra_of_rz * square(in.axial_feed_mm_rev) / 8;  // s^2/(18 sqrt 3)
    const double sin2 =
        ra_mm * (in.tool_radius_mm + in.part_radius_mm) / (feed_term_mm2 + ra_mm * in.part_radius_mm);
    return Orientation{std::asin(std::sqrt(std::min(1.0, sin2))) / rad_per_deg};
  });
}

Roundness roundness_deviation(const ToothFacets& in) {
  return guarded<&roundness_deviation>(in, [&] {
    const double fz_mm = in.contour_feed_mm_min / (in.tool_speed_rpm * static_cast<double>(in.teeth));
    const double curvature_per_mm =
        1 / in.part_radius_mm +
        square(std::cos(in.orientation_deg * rad_per_deg)) / (in.tool_diameter_mm / 2);
    return Roundness{fz_mm, 1000 * square(fz_mm) / 8 * curvature_per_mm};
  });
}

AllowanceSplit allowance_split(const RoughingCut& in) {
  return guarded<&allowance_split>(in, [&] {
    const double cos2 = square(std::cos(in.orientation_deg * rad_per_deg));
    const double height_mm = square(in.edge_length_mm) * sin_squared(in.orientation_deg) /
                             (2 * (in.part_radius_mm + in.tool_radius_mm * cos2));
    const double periphery_mm = std::min(in.allowance_mm, height_mm);
    return AllowanceSplit{periphery_mm, in.allowance_mm - periphery_mm};
  });
}

RemovalRate material_removal_rate(const MeanCut& in) {
  return guarded<&material_removal_rate>(
      in, [&] { return RemovalRate{in.allowance_mm * in.axial_feed_mm_rev * in.contour_feed_mm_min}; });
}

namespace {

Value example_cam() {
  return Value::Map{
      {"r_base_mm", 18.0}, {"r_nose_mm", 8.0}, {"centre_distance_mm", 18.0}, {"r_flank_mm", 60.0}};
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "S1",
       .title =
           "Modular three-dimensional modelling of allowance removal and shaping in milling of cams with "
           "an oriented tool",
       .authors = "Sliednikova O., Vynnyk V., Skliar V., Aksonova O.",
       .published = "Technical Sciences and Technologies (Chernihiv), no. 2(16), 2019, pp. 34-43",
       .models =
           "Rough and finish milling of the cams of a camshaft in one setting with a cylindrical cutter, "
           "shorter than the cam, whose axis crosses the cam's. The part turns non-uniformly and the cutter "
           "moves so that the contact stays in one horizontal plane: contour feed and depth are constant "
           "along the contour.",
       .role = "milling",
       .errata = {
           "Eq. (7) is printed with the part angle in the module of the tool surface and a stray leading "
           "matrix; corrected by putting (2) and (4) into (1).",
           "In the printed order of modules the shift X is made in the tilted frame: its vertical part is X "
           "cos(alpha) and it moves the tool along the part axis too; the setting gives both values, and Z = "
           "Z_feed + X_model sin(alpha) keeps the cut in place along the cam."}});

  const auto cam = [](auto& f) {
    f.input(&CamOnly::cam, "cam", "-", "mm", no_range(), "three-arc cam", example_cam());
  };
  const auto cam_at_normal = [&](auto& f) {
    f.with(cam).input(&CamAtNormal::normal_angle_deg, "normal_angle_deg", "Theta", "deg", any(),
                      "direction of the cam's outward normal, from the nose", 57.0);
  };
  const auto settings = [](auto& f) {
    f.input(&ToolPlacement::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(), "radius of the cutter",
            40.0)
        .input(&ToolPlacement::orientation_deg, "orientation_deg", "alpha", "deg", any(),
               "crossing angle of the axes", 25.0)
        .input(&ToolPlacement::x_mm, "x_mm", "X", "mm", any(), "setting X, in the tilted frame", 3.0)
        .input(&ToolPlacement::y_mm, "y_mm", "Y", "mm", any(), "setting Y, horizontal distance of the axes",
               60.0)
        .input(&ToolPlacement::z_mm, "z_mm", "Z", "mm", any(), "setting Z, along the part axis", 2.0)
        .input(&ToolPlacement::part_angle_deg, "part_angle_deg", "Theta_D", "deg", any(), "angle of the part",
               40.0);
  };
  const auto tool_z = [](auto& f) {
    f.input(&ToolPlacement::tool_z_mm, "tool_z_mm", "Z_k", "mm", any(),
            "height on the tool axis, from the pivot section", 5.0);
  };
  const auto part_point = [](auto& f) {
    f.output(&PartPoint::x_part_mm, "x_part_mm", "x", "mm", any(), "x in the part frame")
        .output(&PartPoint::y_part_mm, "y_part_mm", "y", "mm", any(), "y in the part frame")
        .output(&PartPoint::z_part_mm, "z_part_mm", "z", "mm", any(), "z in the part frame");
  };

  source
      .function<&tool_point_in_part>("tool_point_in_part", "Point of the cutter surface in the part frame.",
                                     "eq. (7)", Provenance::repaired)
      .with(tool_z)
      .input(&ToolPoint::tool_angle_deg, "tool_angle_deg", "theta_f", "deg", any(), "angle on the cutter",
             170.0)
      .with(settings)
      .with(part_point);
  source
      .function<&contact_point>("contact_point",
                                "Where one height of the cutter touches the surface it generates.", "eq. (8)",
                                Provenance::paper)
      .with(tool_z)
      .with(settings)
      .input(&MovingTool::dx_mm_rad, "dx_mm_rad", "X'", "mm/rad", any(), "derivative of X by the part angle",
             3.0)
      .input(&MovingTool::dy_mm_rad, "dy_mm_rad", "Y'", "mm/rad", any(), "derivative of Y by the part angle",
             -5.0)
      .input(&MovingTool::dz_mm_rad, "dz_mm_rad", "Z'", "mm/rad", any(), "derivative of Z by the part angle",
             0.08)
      .output(&ContactPoint::tool_angle_deg, "tool_angle_deg", "theta_f", "deg", closed(90, 270),
              "angle of the contact on the cutter; near 180 deg it faces the part")
      .with(part_point)
      .note("The printed condition is solved in closed form; the tool radius cancels in the angle.");
  source
      .function<&cam_geometry>("cam_geometry", "Joints of the arcs, lift and contour length of a cam.",
                               "completion C1", Provenance::completion)
      .with(cam)
      .output(&CamGeometry::nose_joint_deg, "nose_joint_deg", "Theta_n", "deg", open(0, 180),
              "normal direction at the joint of nose and flank")
      .output(&CamGeometry::base_joint_deg, "base_joint_deg", "Theta_b", "deg", open(0, 180),
              "normal direction at the joint of flank and base")
      .output(&CamGeometry::lift_mm, "lift_mm", "-", "mm", any(), "lift over the base circle")
      .output(&CamGeometry::perimeter_mm, "perimeter_mm", "L", "mm", positive(), "length of the contour");
  source
      .function<&cam_support>("cam_support", "Cam point with a given outward normal.", "completion C1",
                              Provenance::completion)
      .with(cam_at_normal)
      .output(&CamSupport::support_mm, "support_mm", "h", "mm", positive(), "support function")
      .output(&CamSupport::support_derivative_mm_rad, "support_derivative_mm_rad", "h'", "mm/rad", any(),
              "its derivative by the normal angle")
      .output(&CamSupport::curvature_radius_mm, "curvature_radius_mm", "rho", "mm", positive(),
              "radius of curvature")
      .output(&CamSupport::x_mm, "x_mm", "x", "mm", any(), "towards the nose")
      .output(&CamSupport::y_mm, "y_mm", "y", "mm", any(), "across");
  source
      .function<&cam_tool_setting>("cam_tool_setting",
                                   "Cutter position that puts the contact into the horizontal plane.",
                                   "text; derived from eq. (8)", Provenance::completion)
      .with(cam_at_normal)
      .input(&CamSetting::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(), "radius of the cutter",
             40.0)
      .input(&CamSetting::orientation_deg, "orientation_deg", "alpha", "deg", open(-90, 90),
             "crossing angle of the axes", 20.0)
      .output(&ToolSetting::y_mm, "y_mm", "Y", "mm", positive(), "horizontal distance of the axes")
      .output(&ToolSetting::x_vertical_mm, "x_vertical_mm", "X_v", "mm", any(),
              "vertical distance of the axes, for the machine")
      .output(&ToolSetting::x_model_mm, "x_model_mm", "X", "mm", any(),
              "X of eq. (5), a shift in the tilted frame")
      .note("On the section concentric with the shaft X = 0 and Y is constant, as the paper states.");
  source
      .function<&cam_rotation_law>("cam_rotation_law",
                                   "Rotation and axis feeds that keep the contour feed constant.", "derived",
                                   Provenance::completion)
      .with(cam_at_normal)
      .input(&CamFeed::contour_feed_mm_min, "contour_feed_mm_min", "v_s", "mm/min", positive(),
             "feed along the contour", 1500.0)
      .output(&RotationLaw::part_speed_rpm, "part_speed_rpm", "n", "rpm", positive(), "speed of the part")
      .output(&RotationLaw::feed_y_mm_min, "feed_y_mm_min", "v_Y", "mm/min", any(), "feed of the Y axis")
      .output(&RotationLaw::feed_x_mm_min, "feed_x_mm_min", "v_X", "mm/min", any(), "feed of the X axis")
      .note("Speed and feeds jump at the joints of the arcs: the machine must ramp there.");
  source
      .function<&cam_milling_time>("cam_milling_time", "Main time of one cam at constant contour feed.",
                                   "derived", Provenance::completion)
      .with(cam)
      .input(&CamPass::width_mm, "width_mm", "-", "mm", positive(), "width of the cam", 20.0)
      .input(&CamPass::overrun_mm, "overrun_mm", "-", "mm", non_negative(), "overrun along the axis", 2.0)
      .input(&CamPass::axial_feed_mm_rev, "axial_feed_mm_rev", "s", "mm/rev", positive(),
             "axial feed per revolution of the part (paper: 0.5 and 1)", 1.0)
      .input(&CamPass::contour_feed_mm_min, "contour_feed_mm_min", "v_s", "mm/min", positive(),
             "feed along the contour", 1500.0)
      .output(&CamTime::revolutions, "revolutions", "-", "1", positive(), "revolutions of the part")
      .output(&CamTime::time_min, "time_min", "-", "min", positive(), "main time");
  source
      .function<&conventional_state>(
          "conventional_state", "The usual scheme: tool centre in the plane of the axes, uniform rotation.",
          "derived", Provenance::completion)
      .with(cam_at_normal)
      .input(&UniformRotation::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(),
             "radius of the cutter", 60.0)
      .input(&UniformRotation::part_speed_rpm, "part_speed_rpm", "n", "rpm", positive(), "speed of the part",
             10.0)
      .output(&ConventionalState::part_angle_deg, "part_angle_deg", "-", "deg", any(),
              "angle of the part at which this point is cut")
      .output(&ConventionalState::centre_distance_mm, "centre_distance_mm", "A", "mm", positive(),
              "distance of the axes")
      .output(&ConventionalState::contact_offset_mm, "contact_offset_mm", "-", "mm", any(),
              "distance of the contact from the plane of the axes")
      .output(&ConventionalState::contour_feed_mm_min, "contour_feed_mm_min", "v", "mm/min", positive(),
              "feed along the contour");
  source
      .function<&conventional_feed_nonuniformity>("conventional_feed_nonuniformity",
                                                  "Swing of the contour feed in the usual scheme, and the "
                                                  "time it costs.",
                                                  "derived", Provenance::completion)
      .with(cam)
      .input(&CamAndTool::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(), "radius of the cutter",
             60.0)
      .output(&FeedNonuniformity::max_to_min_feed, "max_to_min_feed", "-", "1", at_least(1),
              "largest over smallest contour feed")
      .output(&FeedNonuniformity::time_factor, "time_factor", "-", "1", at_least(1),
              "time of the usual scheme over the stabilised one at equal peak feed");
  source
      .function<&tool_wear_form_error>("tool_wear_form_error",
                                       "Form error left when tool wear is corrected by a constant offset.",
                                       "derived", Provenance::completion)
      .with(cam)
      .input(&CamAndTool::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(), "radius of the cutter",
             60.0)
      .input(&WornTool::radius_loss_mm, "radius_loss_mm", "-", "mm", non_negative(), "loss of radius by wear",
             0.1)
      .input(&WornTool::scheme, "scheme", "-", "-", no_range(), "how the cutter is guided", "centre_plane")
      .output(&FormError::form_error_mm, "form_error_mm", "-", "mm", non_negative(), "form error")
      .note("First order in the loss: 2 % high against a brute-force envelope at a loss of 0.2 mm.");
  const auto crossed = [](auto& f) {
    f.input(&CrossedContact::tool_radius_mm, "tool_radius_mm", "R", "mm", positive(), "radius of the cutter",
            40.0)
        .input(&CrossedContact::part_radius_mm, "part_radius_mm", "rho", "mm", positive(),
               "local radius of the cam", 18.0);
  };
  source
      .function<&axial_roughness>("axial_roughness", "Geometric roughness along the axis of the cam.",
                                  "derived; trends of Fig. 8", Provenance::completion)
      .with(crossed)
      .input(&AxialCut::orientation_deg, "orientation_deg", "alpha", "deg", closed(-90, 90),
             "crossing angle of the axes", 20.0)
      .input(&AxialCut::axial_feed_mm_rev, "axial_feed_mm_rev", "s", "mm/rev", positive(),
             "axial feed per revolution of the part", 1.0)
      .output(&AxialRoughness::effective_radius_mm, "effective_radius_mm", "R_eff", "mm", positive(),
              "radius of the tool that would leave the same profile; null at alpha = 0")
      .output(&AxialRoughness::rz_um, "rz_um", "Rz", "um", non_negative(), "height of the cusps")
      .output(&AxialRoughness::ra_um, "ra_um", "Ra", "um", non_negative(), "mean deviation")
      .note(
          "Holds with Z = Z_feed + X_model sin(alpha); brute force on base, flank and nose agrees to 1e-5.");
  source
      .function<&max_orientation_for_roughness>("max_orientation_for_roughness",
                                                "Largest crossing angle that keeps the roughness limit.",
                                                "derived", Provenance::completion)
      .with(crossed)
      .input(&RoughnessLimit::axial_feed_mm_rev, "axial_feed_mm_rev", "s", "mm/rev", positive(),
             "axial feed per revolution of the part", 1.0)
      .input(&RoughnessLimit::ra_limit_um, "ra_limit_um", "Ra", "um", positive(), "largest allowed Ra", 0.1)
      .output(&Orientation::orientation_deg, "orientation_deg", "alpha", "deg", closed(0, 90),
              "largest crossing angle; 90 when any is allowed");
  source
      .function<&roundness_deviation>("roundness_deviation", "Height of the facets left by the teeth.",
                                      "completion C2; trends of Fig. 9, 10", Provenance::completion)
      .input(&ToothFacets::contour_feed_mm_min, "contour_feed_mm_min", "v_s", "mm/min", positive(),
             "feed along the contour", 2000.0)
      .input(&ToothFacets::tool_speed_rpm, "tool_speed_rpm", "n", "rpm", positive(), "speed of the cutter",
             3000.0)
      .input(&ToothFacets::teeth, "teeth", "z", "1", at_least(1), "number of teeth", 8)
      .input(&ToothFacets::tool_diameter_mm, "tool_diameter_mm", "D", "mm", positive(),
             "diameter of the cutter", 80.0)
      .input(&ToothFacets::part_radius_mm, "part_radius_mm", "rho", "mm", positive(),
             "local radius of the cam", 18.0)
      .input(&ToothFacets::orientation_deg, "orientation_deg", "alpha", "deg", closed(-90, 90),
             "crossing angle of the axes", 20.0)
      .output(&Roundness::feed_per_tooth_mm, "feed_per_tooth_mm", "f_z", "mm", positive(), "feed per tooth")
      .output(&Roundness::roundness_deviation_um, "roundness_deviation_um", "delta", "um", positive(),
              "height of the facets");
  source
      .function<&allowance_split>("allowance_split",
                                  "Part of the allowance removed by the periphery and by the end face.",
                                  "completion C3", Provenance::completion)
      .input(&RoughingCut::allowance_mm, "allowance_mm", "t", "mm", positive(), "allowance", 0.5)
      .input(&RoughingCut::edge_length_mm, "edge_length_mm", "l", "mm", non_negative(),
             "periphery along the tool axis from the pivot to the end face", 8.0)
      .with(crossed)
      .input(&RoughingCut::orientation_deg, "orientation_deg", "alpha", "deg", closed(-90, 90),
             "crossing angle of the axes", 20.0)
      .output(&AllowanceSplit::periphery_mm, "periphery_mm", "-", "mm", non_negative(),
              "removed by the periphery")
      .output(&AllowanceSplit::end_face_mm, "end_face_mm", "-", "mm", non_negative(),
              "removed by the end face")
      .note("Second order in the edge length: 0.1 % high at 20 deg, 0.5 % at 30 deg, 2 % at 60 deg.");
  source
      .function<&material_removal_rate>("material_removal_rate", "Mean material removal rate.", "derived",
                                        Provenance::completion)
      .input(&MeanCut::allowance_mm, "allowance_mm", "t", "mm", positive(), "allowance", 0.5)
      .input(&MeanCut::axial_feed_mm_rev, "axial_feed_mm_rev", "s", "mm/rev", positive(), "axial feed", 1.0)
      .input(&MeanCut::contour_feed_mm_min, "contour_feed_mm_min", "v_s", "mm/min", positive(),
             "feed along the contour", 1500.0)
      .output(&RemovalRate::removal_rate_mm3_min, "removal_rate_mm3_min", "Q", "mm3/min", positive(),
              "mean removal rate");
}

}  // namespace verstat::models::s1

std::vector<verstat::models::Field> verstat::models::StructFields<verstat::models::s1::Cam>::fields() {
  using s1::Cam;
  return {member<Cam>(&Cam::r_base_mm, "r_base_mm", "-", "mm", positive(), "radius of the base circle"),
          member<Cam>(&Cam::r_nose_mm, "r_nose_mm", "-", "mm", positive(), "radius of the nose"),
          member<Cam>(&Cam::centre_distance_mm, "centre_distance_mm", "d", "mm", positive(),
                      "distance of base centre and nose centre"),
          member<Cam>(&Cam::r_flank_mm, "r_flank_mm", "-", "mm", positive(), "radius of the convex flanks")};
}
