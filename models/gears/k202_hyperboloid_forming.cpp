#include "models/gears/k202_hyperboloid_forming.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k202 {
namespace {

constexpr double pi = std::numbers::pi;

double rad(double deg) {
  return deg * pi / 180;
}

GearPoint to_gear(const ToolPoint& p) {
  const double phi1 = rad(p.phi1_deg);
  const double phi2 = phi1 * p.ratio_u21;
  const double gamma = rad(p.shaft_angle_deg);
  const double x = p.x1_mm * std::cos(phi1) - p.y1_mm * std::sin(phi1) + p.center_distance_mm;
  const double y = p.x1_mm * std::sin(phi1) + p.y1_mm * std::cos(phi1);
  const double across = y * std::cos(gamma) - p.z1_mm * std::sin(gamma);
  return {x * std::cos(phi2) + across * std::sin(phi2), -x * std::sin(phi2) + across * std::cos(phi2),
          y * std::sin(gamma) + p.z1_mm * std::cos(gamma)};
}

InvoluteProfile involute(double module_mm, std::int64_t teeth, double pressure_deg, double t) {
  const double r1 = module_mm * static_cast<double>(teeth) / 2;
  const double alpha = rad(pressure_deg);
  const double rb = r1 * std::cos(alpha);
  const double w = t - (std::tan(alpha) - alpha);
  const double c = std::cos(w);
  const double s = std::sin(w);
  return {r1 - rb * (c + t * s), -rb * (s - t * c), -rb * t * c,
          -rb * t * s,           -rb * (c - t * s), -rb * (s + t * c)};
}

double mu_of(const ContactInputs& in) {
  const double phi1 = rad(in.phi1_deg);
  const double c = std::cos(phi1);
  const double s = std::sin(phi1);
  const double x = in.x1_mm * c - in.y1_mm * s;
  const double y = in.x1_mm * s + in.y1_mm * c;
  const double nx = in.nx * c - in.ny * s;
  const double ny = in.nx * s + in.ny * c;
  if (nx == 0) reject("the rotated normal has no x component: no axial position is in contact");
  const double gamma = rad(in.shaft_angle_deg);
  const double u = in.ratio_u21;
  return ((x * ny - y * nx) * (1 - u * std::cos(gamma)) - u * in.center_distance_mm * std::cos(gamma) * ny) /
         (u * std::sin(gamma) * nx);
}

Setup setup_of(const GearPair& g) {
  const double z1 = static_cast<double>(g.tool_teeth);
  const double z2 = static_cast<double>(g.gear_teeth);
  const double r1 = g.module_mm * z1 / 2;
  const double r2 = g.module_mm * z2 / (2 * std::cos(rad(g.shaft_angle_deg)));
  return {r1, r2, r1 + r2, -z1 / z2};
}

}  // namespace

GearPoint tool_to_gear_transform(const ToolPoint& in) {
  return guarded<&tool_to_gear_transform>(in, [&] { return to_gear(in); });
}

SurfaceGeometry producing_surface_geometry(const ProfileDerivatives& in) {
  return guarded<&producing_surface_geometry>(in, [&] {
    const double length = std::hypot(in.df1, in.df2);
    if (!(length > 0)) reject("df1 = df2 = 0: the profile has no tangent there");
    const double l1 = (in.df2 / length) * in.d2f1 - (in.df1 / length) * in.d2f2;
    const double e1 = length * length;
    return SurfaceGeometry{.nx = in.df2 / length,
                           .ny = -in.df1 / length,
                           .nz = 0,
                           .e1 = e1,
                           .f1 = 0,
                           .g1 = 1,
                           .l1 = l1,
                           .m1 = 0,
                           .n1 = 0,
                           .k_mu = l1 / e1,
                           .k_lambda = 0};
  });
}

Curvature normal_curvature(const Direction& in) {
  return guarded<&normal_curvature>(in, [&] {
    if (in.dlambda == 0 && in.dmu == 0) reject("dlambda = dmu = 0: a direction is needed");
    // Scaled, so that a short or long direction neither vanishes nor overflows.
    const double scale = std::max(std::abs(in.dlambda), std::abs(in.dmu));
    const double lambda = in.dlambda / scale;
    const double mu = in.dmu / scale;
    return Curvature{in.l1 * lambda * lambda / (in.e1 * lambda * lambda + in.g1 * mu * mu)};
  });
}

BlankRadius hyperboloid_blank_radius(const BlankSection& in) {
  return guarded<&hyperboloid_blank_radius>(in, [&] {
    require(in.tool_radius_mm < in.center_distance_mm, "tool_radius_mm", in.tool_radius_mm,
            "must be below center_distance_mm");
    return BlankRadius{
        std::hypot(in.center_distance_mm - in.tool_radius_mm, in.z2_mm * std::tan(rad(in.shaft_angle_deg)))};
  });
}

Setup generating_setup(const GearPair& in) {
  return guarded<&generating_setup>(in, [&] { return setup_of(in); });
}

CuttingSpeed sliding_cutting_speed(const SlidingInputs& in) {
  return guarded<&sliding_cutting_speed>(in, [&] {
    return CuttingSpeed{2 * pi * in.tool_pitch_radius_mm * in.tool_speed_rpm *
                        std::tan(rad(in.shaft_angle_deg)) / 1000};
  });
}

InvoluteProfile involute_tool_profile(const InvoluteInputs& in) {
  return guarded<&involute_tool_profile>(
      in, [&] { return involute(in.module_mm, in.tool_teeth, in.pressure_angle_deg, in.t); });
}

ContactMu contact_mu(const ContactInputs& in) {
  return guarded<&contact_mu>(in, [&] {
    require(in.ratio_u21 != 0, "ratio_u21", in.ratio_u21, "must not be 0");
    return ContactMu{mu_of(in)};
  });
}

ToothPoint gear_tooth_point(const ToothInputs& in) {
  return guarded<&gear_tooth_point>(in, [&] {
    const Setup setup = setup_of(in);
    const InvoluteProfile f = involute(in.module_mm, in.tool_teeth, in.pressure_angle_deg, in.t);
    const double x1 = f.f1_mm - setup.tool_pitch_radius_mm;
    const double mu = mu_of({.x1_mm = x1,
                             .y1_mm = f.f2_mm,
                             .nx = f.df2,
                             .ny = -f.df1,
                             .phi1_deg = in.phi1_deg,
                             .ratio_u21 = setup.ratio_u21,
                             .center_distance_mm = setup.center_distance_mm,
                             .shaft_angle_deg = in.shaft_angle_deg});
    const GearPoint p = to_gear(
        {x1, f.f2_mm, mu, in.phi1_deg, setup.ratio_u21, setup.center_distance_mm, in.shaft_angle_deg});
    return ToothPoint{p.x2_mm, p.y2_mm, p.z2_mm, mu};
  });
}

GenerationTime gear_generation_time(const GenerationInputs& in) {
  return guarded<&gear_generation_time>(in, [&] {
    const double gear_rpm =
        in.tool_speed_rpm * static_cast<double>(in.tool_teeth) / static_cast<double>(in.gear_teeth);
    const double travel = (in.face_width_mm + in.overrun_mm) / std::cos(rad(in.shaft_angle_deg));
    return GenerationTime{gear_rpm, travel,
                          static_cast<double>(in.passes) * travel / (in.feed_mm_rev * gear_rpm)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K202",
       .title = "Problems of helical gear wheels shape formation",
       .authors = "Vitrenko V. A., Voronov A. E., Kashura M. A., Kuznetsova M. N.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Cutting of gears for crossed-axis drives on a hobbing machine with a non-relieved cylindrical "
           "gear as the tool: rolling at the ratio of the tooth numbers and travel along the straight "
           "generator of the hyperboloid blank.",
       .role = "gears",
       .errata = {"Eq. (1) sets a matrix equal to a vector; M21 = M2p Mp0 M01, r2 = M21 r1.",
                  "Eq. (2) has signs in its second line that do not preserve lengths, and a repeated label; "
                  "repaired.",
                  "Eq. (4) lacks the term f2 j.",
                  "Eq. (7) prints n_y with the opposite sign, which is not orthogonal to the surface.",
                  "Eq. (11) has the sign of the opposite normal."}});

  const auto position = [](auto& f, auto phi, auto ratio, auto distance) {
    f.input(phi, "phi1_deg", "phi_1", "deg", any(), "rotation of the tool", 2.0)
        .input(ratio, "ratio_u21", "u_21", "1", any(), "phi2 / phi1, negative for external meshing", -0.5)
        .input(distance, "center_distance_mm", "a_w", "mm", any(), "shortest distance of the axes", 96.2);
  };
  const auto crossing = [](auto& f, auto pointer, Range range) {
    f.input(pointer, "shaft_angle_deg", "gamma", "deg", range, "crossing angle of the axes", 25.0);
  };
  const auto teeth = [](auto& f, auto tool, auto gear) {
    f.input(tool, "tool_teeth", "z_1", "1", at_least(12), "teeth of the tool", 20)
        .input(gear, "gear_teeth", "z_2", "1", at_least(12), "teeth of the gear", 40);
  };
  const auto involute_fields = [](auto& f, auto angle, auto t) {
    f.input(angle, "pressure_angle_deg", "alpha", "deg", closed(14.5, 25), "pressure angle", 20.0)
        .input(t, "t", "t", "1", open(0, 1.2), "roll parameter, tan(alpha) at the pitch circle", 0.4);
  };
  const Range wide = closed(0, 89);
  const Range crossed = closed(1, 89);

  source
      .function<&tool_to_gear_transform>("tool_to_gear_transform", "Point of the tool in the gear's frame.",
                                         "eq. (2)", Provenance::repaired)
      .input(&ToolPoint::x1_mm, "x1_mm", "x_1", "mm", any(), "point of the tool", -30.0)
      .input(&ToolPoint::y1_mm, "y1_mm", "y_1", "mm", any(), "point of the tool", 0.5)
      .input(&ToolPoint::z1_mm, "z1_mm", "z_1", "mm", any(), "point of the tool, along its axis", 3.0)
      .with([&](auto& f) {
        position(f, &ToolPoint::phi1_deg, &ToolPoint::ratio_u21, &ToolPoint::center_distance_mm);
        crossing(f, &ToolPoint::shaft_angle_deg, any());
      })
      .output(&GearPoint::x2_mm, "x2_mm", "x_2", "mm", any(), "point in the gear's frame")
      .output(&GearPoint::y2_mm, "y2_mm", "y_2", "mm", any(), "point in the gear's frame")
      .output(&GearPoint::z2_mm, "z2_mm", "z_2", "mm", any(), "point in the gear's frame, along its axis");
  source
      .function<&producing_surface_geometry>("producing_surface_geometry",
                                             "Normal, quadratic forms and curvatures of the tool tooth.",
                                             "eqs. (5)-(11)", Provenance::repaired)
      .input(&ProfileDerivatives::df1, "df1", "f_1'", "mm", any(), "derivative of the profile", -9.64)
      .input(&ProfileDerivatives::df2, "df2", "f_2'", "mm", any(), "derivative of the profile", -3.51)
      .input(&ProfileDerivatives::d2f1, "d2f1", "f_1''", "mm", any(), "second derivative", -22.98)
      .input(&ProfileDerivatives::d2f2, "d2f2", "f_2''", "mm", any(), "second derivative", -19.28)
      .output(&SurfaceGeometry::nx, "nx", "n_x1", "1", closed(-1, 1), "unit normal")
      .output(&SurfaceGeometry::ny, "ny", "n_y1", "1", closed(-1, 1), "unit normal")
      .output(&SurfaceGeometry::nz, "nz", "n_z1", "1", closed(0, 0), "unit normal")
      .output(&SurfaceGeometry::e1, "e1", "E_1", "mm2", non_negative(), "first quadratic form")
      .output(&SurfaceGeometry::f1, "f1", "F_1", "mm", any(), "first quadratic form")
      .output(&SurfaceGeometry::g1, "g1", "G_1", "1", any(), "first quadratic form")
      .output(&SurfaceGeometry::l1, "l1", "L_1", "mm", any(), "second quadratic form")
      .output(&SurfaceGeometry::m1, "m1", "M_1", "1", any(), "second quadratic form")
      .output(&SurfaceGeometry::n1, "n1", "N_1", "1/mm", any(), "second quadratic form")
      .output(&SurfaceGeometry::k_mu, "k_mu", "K_mu", "1/mm", any(), "curvature of the profile")
      .output(&SurfaceGeometry::k_lambda, "k_lambda", "K_lambda", "1/mm", any(), "curvature along the axis");
  source
      .function<&normal_curvature>("normal_curvature", "Normal curvature of the tool tooth in a direction.",
                                   "eq. (10)", Provenance::paper)
      .input(&Direction::l1, "l1", "L_1", "mm", any(), "second quadratic form", -0.1)
      .input(&Direction::e1, "e1", "E_1", "mm2", positive(), "first quadratic form", 4.0)
      .input(&Direction::g1, "g1", "G_1", "1", positive(), "first quadratic form", 1.0)
      .input(&Direction::dlambda, "dlambda", "d lambda", "1", any(), "step along the profile", 1.0)
      .input(&Direction::dmu, "dmu", "d mu", "mm", any(), "step along the axis", 0.5)
      .output(&Curvature::k, "k", "K", "1/mm", any(), "normal curvature");
  source
      .function<&hyperboloid_blank_radius>("hyperboloid_blank_radius", "Radius of the hyperboloid blank.",
                                           "from eq. (2)", Provenance::completion)
      .input(&BlankSection::z2_mm, "z2_mm", "z_2", "mm", any(), "axial position", 20.0)
      .input(&BlankSection::center_distance_mm, "center_distance_mm", "a_w", "mm", positive(),
             "shortest distance of the axes", 93.378)
      .input(&BlankSection::tool_radius_mm, "tool_radius_mm", "r", "mm", positive(),
             "pitch, tip or root radius of the tool, below the centre distance", 30.0)
      .with([&](auto& f) { crossing(f, &BlankSection::shaft_angle_deg, wide); })
      .output(&BlankRadius::radius_mm, "radius_mm", "rho", "mm", positive(), "radius of the blank")
      .note(
          "The whole tool cylinder leaves a smaller radius away from the throat; a blank turned to the "
          "hyperboloid of the tool root loses that much tip clearance.");
  source
      .function<&generating_setup>("generating_setup", "Radii, centre distance and ratio of a pair.",
                                   "completion", Provenance::completion)
      .input(&GearPair::module_mm, "module_mm", "m", "mm", positive(), "normal module", 3.0)
      .with([&](auto& f) {
        teeth(f, &GearPair::tool_teeth, &GearPair::gear_teeth);
        crossing(f, &GearPair::shaft_angle_deg, crossed);
      })
      .output(&Setup::tool_pitch_radius_mm, "tool_pitch_radius_mm", "r_1", "mm", positive(),
              "pitch radius of the tool")
      .output(&Setup::gear_throat_radius_mm, "gear_throat_radius_mm", "r_2", "mm", positive(),
              "throat pitch radius of the gear")
      .output(&Setup::center_distance_mm, "center_distance_mm", "a_w", "mm", positive(), "centre distance")
      .output(&Setup::ratio_u21, "ratio_u21", "u_21", "1", below(0), "ratio of the rotations");
  source
      .function<&sliding_cutting_speed>("sliding_cutting_speed", "Cutting speed at the pitch point.",
                                        "from eq. (2)", Provenance::completion)
      .input(&SlidingInputs::tool_pitch_radius_mm, "tool_pitch_radius_mm", "r_1", "mm", positive(),
             "pitch radius of the tool", 30.0)
      .input(&SlidingInputs::tool_speed_rpm, "tool_speed_rpm", "n_1", "rpm", positive(), "speed of the tool",
             500.0)
      .with([&](auto& f) { crossing(f, &SlidingInputs::shaft_angle_deg, wide); })
      .output(&CuttingSpeed::vc_m_min, "vc_m_min", "v_c", "m/min", non_negative(), "cutting speed");
  source
      .function<&involute_tool_profile>("involute_tool_profile", "Involute profile of the tool.",
                                        "completion", Provenance::completion)
      .input(&InvoluteInputs::module_mm, "module_mm", "m", "mm", positive(), "normal module", 3.0)
      .input(&InvoluteInputs::tool_teeth, "tool_teeth", "z_1", "1", at_least(12), "teeth of the tool", 20)
      .with([&](auto& f) { involute_fields(f, &InvoluteInputs::pressure_angle_deg, &InvoluteInputs::t); })
      .output(&InvoluteProfile::f1_mm, "f1_mm", "f_1", "mm", any(), "profile, 0 at the pitch point")
      .output(&InvoluteProfile::f2_mm, "f2_mm", "f_2", "mm", any(), "profile, 0 at the pitch point")
      .output(&InvoluteProfile::df1, "df1", "f_1'", "mm", any(), "first derivative")
      .output(&InvoluteProfile::df2, "df2", "f_2'", "mm", any(), "first derivative")
      .output(&InvoluteProfile::d2f1, "d2f1", "f_1''", "mm", any(), "second derivative")
      .output(&InvoluteProfile::d2f2, "d2f2", "f_2''", "mm", any(), "second derivative");
  source
      .function<&contact_mu>("contact_mu", "Axial position at which a profile point is in contact.",
                             "meshing condition", Provenance::completion)
      .input(&ContactInputs::x1_mm, "x1_mm", "x_1", "mm", any(), "point of the profile", -29.5)
      .input(&ContactInputs::y1_mm, "y1_mm", "y_1", "mm", any(), "point of the profile", 0.3)
      .input(&ContactInputs::nx, "nx", "n_x1", "1", any(), "normal, any length", 0.34)
      .input(&ContactInputs::ny, "ny", "n_y1", "1", any(), "normal, any length", 0.94)
      .with([&](auto& f) {
        position(f, &ContactInputs::phi1_deg, &ContactInputs::ratio_u21, &ContactInputs::center_distance_mm);
        crossing(f, &ContactInputs::shaft_angle_deg, crossed);
      })
      .output(&ContactMu::mu_mm, "mu_mm", "mu", "mm", any(), "axial position")
      .note("Only positions within the tool's width are real contact.");
  source
      .function<&gear_tooth_point>("gear_tooth_point", "Point of the generated tooth surface.",
                                   "eqs. (2), (3), (7) and meshing", Provenance::completion)
      .input(&ToothInputs::module_mm, "module_mm", "m", "mm", positive(), "normal module", 3.0)
      .with([&](auto& f) {
        teeth(f, &ToothInputs::tool_teeth, &ToothInputs::gear_teeth);
        f.input(&ToothInputs::pressure_angle_deg, "pressure_angle_deg", "alpha", "deg", closed(14.5, 25),
                "pressure angle", 20.0);
        crossing(f, &ToothInputs::shaft_angle_deg, crossed);
      })
      .input(&ToothInputs::t, "t", "t", "1", open(0, 1.2), "roll parameter, tan(alpha) at the pitch circle",
             0.4)
      .input(&ToothInputs::phi1_deg, "phi1_deg", "phi_1", "deg", any(), "rotation of the tool", 2.0)
      .output(&ToothPoint::x2_mm, "x2_mm", "x_2", "mm", any(), "point in the gear's frame")
      .output(&ToothPoint::y2_mm, "y2_mm", "y_2", "mm", any(), "point in the gear's frame")
      .output(&ToothPoint::z2_mm, "z2_mm", "z_2", "mm", any(), "point in the gear's frame, along its axis")
      .output(&ToothPoint::mu_mm, "mu_mm", "mu", "mm", any(), "axial position on the tool")
      .note("Undercut and tip interference are not treated: reject points where mu(t) turns back.");
  source
      .function<&gear_generation_time>("gear_generation_time", "Main time to generate a gear.", "completion",
                                       Provenance::completion)
      .input(&GenerationInputs::face_width_mm, "face_width_mm", "b", "mm", positive(), "face width", 25.0)
      .input(&GenerationInputs::overrun_mm, "overrun_mm", "Delta", "mm", non_negative(), "overrun", 8.0)
      .with([&](auto& f) { crossing(f, &GenerationInputs::shaft_angle_deg, crossed); })
      .input(&GenerationInputs::feed_mm_rev, "feed_mm_rev", "s", "mm/rev", positive(),
             "feed along the generator per gear revolution", 0.3)
      .input(&GenerationInputs::tool_speed_rpm, "tool_speed_rpm", "n_1", "rpm", positive(),
             "speed of the tool", 500.0)
      .with([&](auto& f) { teeth(f, &GenerationInputs::tool_teeth, &GenerationInputs::gear_teeth); })
      .input(&GenerationInputs::passes, "passes", "i", "1", at_least(1), "passes", 3)
      .output(&GenerationTime::gear_speed_rpm, "gear_speed_rpm", "n_2", "rpm", positive(),
              "speed of the gear")
      .output(&GenerationTime::travel_mm, "travel_mm", "-", "mm", positive(), "travel of a pass")
      .output(&GenerationTime::time_min, "time_min", "T", "min", positive(), "main time");
}

}  // namespace verstat::models::k202
