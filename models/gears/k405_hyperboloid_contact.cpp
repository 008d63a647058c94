#include "models/gears/k405_hyperboloid_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace verstat::models::k405 {
namespace {

constexpr double pi = std::numbers::pi;

double rad(double deg) {
  return deg * pi / 180;
}

CrossedPair pair_at(const CrossedGears& g, double tool_rpm) {
  const double zg = static_cast<double>(g.gear_teeth);
  const double zt = static_cast<double>(g.tool_teeth);
  CrossedPair p{};
  p.shaft_angle_deg = g.gear_helix_deg + g.tool_helix_deg;
  p.gear_diameter_mm = g.module_mm * zg / std::cos(rad(g.gear_helix_deg));
  p.tool_diameter_mm = g.module_mm * zt / std::cos(rad(g.tool_helix_deg));
  p.centre_distance_mm = 0.5 * (p.gear_diameter_mm + p.tool_diameter_mm);
  p.gear_rpm = tool_rpm * zt / zg;
  p.pitch_gear_m_min = pi * p.gear_diameter_mm * p.gear_rpm / 1000;
  p.sliding_m_min =
      p.pitch_gear_m_min * std::abs(std::sin(rad(p.shaft_angle_deg))) / std::cos(rad(g.tool_helix_deg));
  return p;
}

}  // namespace

ContactVelocities contact_velocities(const ContactPoint& in) {
  return guarded<&contact_velocities>(in, [&] {
    using Vector = Eigen::Vector3d;
    const Vector r(in.x_mm, in.y_mm, in.z_mm);
    const double angle = rad(in.shaft_angle_deg);
    const Vector tool_axis(0, std::sin(angle), std::cos(angle));
    const Vector from_tool(in.x_mm - in.centre_distance_mm, in.y_mm, in.z_mm);
    // rpm and mm to m/min
    const Vector gear = 2 * pi * in.gear_rpm / 1000 * Vector::UnitZ().cross(r);
    const Vector tool = 2 * pi * in.tool_rpm / 1000 * tool_axis.cross(from_tool);
    const Vector rel = tool - gear;
    return ContactVelocities{gear.norm(), tool.norm(), rel.x(), rel.y(), rel.z(), rel.norm()};
  });
}

Angle sliding_contact_angle(const SlidingDirection& in) {
  return guarded<&sliding_contact_angle>(in, [&] {
    const Eigen::Vector3d v(in.vx, in.vy, in.vz);
    const Eigen::Vector3d t(in.tx, in.ty, in.tz);
    if (v.isZero(0)) reject("vx = vy = vz = 0: the relative velocity must not be zero");
    if (t.isZero(0)) reject("tx = ty = tz = 0: the tangent must not be zero");
    const Eigen::Vector3d a = v / v.lpNorm<Eigen::Infinity>();
    const Eigen::Vector3d b = t / t.lpNorm<Eigen::Infinity>();
    return Angle{std::atan2(a.cross(b).norm(), std::abs(a.dot(b))) * 180 / pi};
  });
}

CrossedPair crossed_pair(const CrossedPairInputs& in) {
  return guarded<&crossed_pair>(in, [&] { return pair_at(in, in.tool_rpm); });
}

ToolSpeed tool_speed_for_sliding(const SlidingTarget& in) {
  return guarded<&tool_speed_for_sliding>(in, [&] {
    const CrossedPair at_one_rpm = pair_at(in, 1);
    require(at_one_rpm.shaft_angle_deg != 0, "beta_tool", in.tool_helix_deg,
            "must not be -beta_gear: without a shaft angle nothing slides");
    return ToolSpeed{in.sliding_m_min / at_one_rpm.sliding_m_min};
  });
}

ContactPointSpeeds contact_point_speeds(const ContactPaths& in) {
  return guarded<&contact_point_speeds>(in, [&] {
    const double time_min = in.tool_turn_deg / (360 * in.tool_rpm);
    const double gear = in.gear_path_mm / (1000 * time_min);
    const double tool = in.tool_path_mm / (1000 * time_min);
    return ContactPointSpeeds{gear, tool, gear + tool, tool - gear, 60 * time_min};
  });
}

ReducedCurvature reduced_curvature(const ContactRadii& in) {
  return guarded<&reduced_curvature>(in, [&] {
    const double curvature =
        in.gear_concave ? 1 / in.tool_mm - 1 / in.gear_mm : 1 / in.tool_mm + 1 / in.gear_mm;
    return ReducedCurvature{curvature, curvature == 0 ? 1e300 : 1 / curvature};
  });
}

RollingWindow rolling_window(const RollingInputs& in) {
  return guarded<&rolling_window>(in, [&] {
    require(in.phi_to_deg > in.phi_from_deg, "phi_to", in.phi_to_deg, "must be above phi_from");
    const double window = in.phi_to_deg - in.phi_from_deg;
    return RollingWindow{window, window / (360 * in.tool_rpm) * 60,
                         window * static_cast<double>(in.tool_teeth) / 360};
  });
}

DeviationStatistics surface_deviation(const Deviations& in) {
  return guarded<&surface_deviation>(in, [&] {
    const auto [least, most] = std::minmax_element(in.values.begin(), in.values.end());
    double sum = 0;
    double squares = 0;
    for (const double v : in.values) {
      sum += v;
      squares += v * v;
    }
    const double n = static_cast<double>(in.values.size());
    return DeviationStatistics{*most, *least, *most - *least, sum / n, std::sqrt(squares / n)};
  });
}

GeneratingTime generating_time(const GeneratingInputs& in) {
  return guarded<&generating_time>(in, [&] {
    return GeneratingTime{static_cast<double>(in.passes) * (in.face_width_mm + in.overrun_mm) /
                          (in.axial_feed_mm_rev * in.gear_rpm)};
  });
}

LineContactPressure line_contact_pressure(const LineContact& in) {
  return guarded<&line_contact_pressure>(in, [&] {
    const double compliance = (1 - in.nu1 * in.nu1) / in.e1_mpa + (1 - in.nu2 * in.nu2) / in.e2_mpa;
    const double half = std::sqrt(4 * in.load_n_mm * in.reduced_radius_mm * compliance / pi);
    return LineContactPressure{half, 2 * in.load_n_mm / (pi * half)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K405",
       .title = "Analysis of contact conditions of a hyperboloid tool and the manufactured gear in a surface "
                "modelling system",
       .authors = "Vorontsov B. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Indicators of the contact between a crossed-axes gear-finishing tool and the gear: roll-over, "
           "reduced curvature, sum and sliding velocities and their angle to the contact line. The paper "
           "obtains them graphically; here they are functions.",
       .role = "gears",
       .errata = {}});
  constexpr auto completion = Provenance::completion;
  const auto gears = [](auto& f) {
    f.input(&CrossedGears::module_mm, "m_n", "m_n", "mm", positive(), "normal module", 2.0)
        .input(&CrossedGears::gear_teeth, "z_gear", "z_1", "1", at_least(1), "teeth of the gear", 40)
        .input(&CrossedGears::gear_helix_deg, "beta_gear", "beta_1", "deg", open(-90, 90),
               "helix angle of the gear, right hand positive", 5.0)
        .input(&CrossedGears::tool_teeth, "z_tool", "z_2", "1", at_least(1), "teeth or starts of the tool",
               25)
        .input(&CrossedGears::tool_helix_deg, "beta_tool", "beta_2", "deg", open(-90, 90),
               "helix angle of the tool, right hand positive", 20.0);
  };

  source
      .function<&contact_velocities>("contact_velocities", "Speeds of tool and gear at a point.", "(C1)",
                                     completion)
      .input(&ContactPoint::x_mm, "x", "x", "mm", any(), "point, from the gear axis to the tool axis", 40.0)
      .input(&ContactPoint::y_mm, "y", "y", "mm", any(), "point", 5.0)
      .input(&ContactPoint::z_mm, "z", "z", "mm", any(), "point, along the gear axis", 3.0)
      .input(&ContactPoint::centre_distance_mm, "centre_distance", "A", "mm", positive(), "centre distance",
             65.0)
      .input(&ContactPoint::shaft_angle_deg, "shaft_angle", "Sigma", "deg", any(), "shaft angle", 20.0)
      .input(&ContactPoint::gear_rpm, "n_gear", "n_1", "rpm", any(), "speed of the gear, signed", 100.0)
      .input(&ContactPoint::tool_rpm, "n_tool", "n_2", "rpm", any(),
             "speed of the tool, signed; opposite sign for external mesh", -160.0)
      .output(&ContactVelocities::gear_m_min, "v_gear", "v_1", "m/min", non_negative(), "speed of the gear")
      .output(&ContactVelocities::tool_m_min, "v_tool", "v_2", "m/min", non_negative(), "speed of the tool")
      .output(&ContactVelocities::rel_x_m_min, "v_rel_x", "v_12", "m/min", any(), "tool relative to gear")
      .output(&ContactVelocities::rel_y_m_min, "v_rel_y", "v_12", "m/min", any(), "tool relative to gear")
      .output(&ContactVelocities::rel_z_m_min, "v_rel_z", "v_12", "m/min", any(), "tool relative to gear")
      .output(&ContactVelocities::rel_m_min, "v_rel", "v_12", "m/min", non_negative(), "sliding speed");
  source
      .function<&sliding_contact_angle>(
          "sliding_contact_angle", "Angle between sliding velocity and contact line.", "(C2)", completion)
      .input(&SlidingDirection::vx, "vx", "v_12", "m/min", any(), "relative velocity", 10.0)
      .input(&SlidingDirection::vy, "vy", "v_12", "m/min", any(), "relative velocity", 2.0)
      .input(&SlidingDirection::vz, "vz", "v_12", "m/min", any(), "relative velocity", -30.0)
      .input(&SlidingDirection::tx, "tx", "t", "1", any(), "tangent of the contact line", 0.1)
      .input(&SlidingDirection::ty, "ty", "t", "1", any(), "tangent of the contact line", 0.2)
      .input(&SlidingDirection::tz, "tz", "t", "1", any(), "tangent of the contact line", 1.0)
      .output(&Angle::angle_deg, "angle", "mu", "deg", closed(0, 90), "angle, 90 = sliding across the line");
  source
      .function<&crossed_pair>("crossed_pair", "Geometry and speeds of a crossed helical pair.", "(C3)",
                               completion)
      .with(gears)
      .input(&CrossedPairInputs::tool_rpm, "n_tool", "n_2", "rpm", positive(), "speed of the tool", 300.0)
      .output(&CrossedPair::shaft_angle_deg, "shaft_angle", "Sigma", "deg", open(-180, 180), "shaft angle")
      .output(&CrossedPair::gear_diameter_mm, "d_gear", "d_1", "mm", positive(), "pitch diameter of the gear")
      .output(&CrossedPair::tool_diameter_mm, "d_tool", "d_2", "mm", positive(), "pitch diameter of the tool")
      .output(&CrossedPair::centre_distance_mm, "centre_distance", "A", "mm", positive(), "centre distance")
      .output(&CrossedPair::gear_rpm, "n_gear", "n_1", "rpm", positive(), "speed of the gear")
      .output(&CrossedPair::pitch_gear_m_min, "v_pitch_gear", "v_1", "m/min", positive(),
              "pitch speed of the gear")
      .output(&CrossedPair::sliding_m_min, "v_sliding", "v_s", "m/min", non_negative(),
              "sliding speed at the pitch point, along the tooth");
  source
      .function<&tool_speed_for_sliding>("tool_speed_for_sliding", "Tool speed for a sliding speed.",
                                         "(C3), inverse", completion)
      .with(gears)
      .input(&SlidingTarget::sliding_m_min, "v_sliding", "v_s", "m/min", positive(), "sliding speed", 60.0)
      .output(&ToolSpeed::tool_rpm, "n_tool", "n_2", "rpm", positive(), "speed of the tool");
  source
      .function<&contact_point_speeds>("contact_point_speeds",
                                       "Sum and sliding speed of the contact point on both surfaces.",
                                       "(1), in words", Provenance::reconstructed)
      .input(&ContactPaths::gear_path_mm, "path_gear", "-", "mm", any(), "path on the gear, signed", 0.8)
      .input(&ContactPaths::tool_path_mm, "path_tool", "-", "mm", any(), "path on the tool, signed", 1.1)
      .input(&ContactPaths::tool_turn_deg, "delta_phi_tool", "Delta phi_2", "deg", positive(),
             "rotation of the tool between the contact lines", 5.0)
      .input(&ContactPaths::tool_rpm, "n_tool", "n_2", "rpm", positive(), "speed of the tool", 100.0)
      .output(&ContactPointSpeeds::gear_m_min, "v_gear", "v_g", "m/min", any(), "speed on the gear")
      .output(&ContactPointSpeeds::tool_m_min, "v_tool", "v_t", "m/min", any(), "speed on the tool")
      .output(&ContactPointSpeeds::sum_m_min, "v_sum", "v_Sigma", "m/min", any(), "sum speed")
      .output(&ContactPointSpeeds::slide_m_min, "v_slide", "v_slide", "m/min", any(), "sliding speed")
      .output(&ContactPointSpeeds::time_s, "time", "Delta t", "s", positive(),
              "time between the contact lines");
  source
      .function<&reduced_curvature>("reduced_curvature", "Reduced curvature normal to the contact line.",
                                    "(C4)", completion)
      .input(&ContactRadii::gear_mm, "rho_gear", "rho_g", "mm", positive(), "radius of the gear", 20.0)
      .input(&ContactRadii::tool_mm, "rho_tool", "rho_t", "mm", positive(), "radius of the tool", 15.0)
      .input(&ContactRadii::gear_concave, "gear_concave", "-", "-", no_range(), "the gear is concave", false)
      .output(&ReducedCurvature::curvature_per_mm, "curvature", "1/rho", "1/mm", any(), "reduced curvature")
      .output(&ReducedCurvature::radius_mm, "rho_reduced", "rho", "mm", any(),
              "reduced radius; 1e300 for curvature 0, negative = interference");
  source
      .function<&rolling_window>("rolling_window", "Roll-over of the contact from face to face.", "(C5)",
                                 completion)
      .input(&RollingInputs::phi_from_deg, "phi_from", "phi", "deg", any(), "rotation where contact begins",
             -40.0)
      .input(&RollingInputs::phi_to_deg, "phi_to", "phi", "deg", any(), "rotation where contact ends", 40.0)
      .input(&RollingInputs::tool_rpm, "n_tool", "n_2", "rpm", positive(), "speed of the tool", 100.0)
      .input(&RollingInputs::tool_teeth, "z_tool", "z_t", "1", at_least(1), "teeth or starts of the tool", 9)
      .output(&RollingWindow::window_deg, "window", "-", "deg", positive(), "rotation of the tool in contact")
      .output(&RollingWindow::time_s, "time", "-", "s", positive(), "time in contact")
      .output(&RollingWindow::pairs_in_contact, "pairs_in_contact", "-", "1", positive(),
              "tooth pairs in contact; below 1 the mesh is interrupted");
  source
      .function<&surface_deviation>("surface_deviation", "Statistics of deviations from the model surface.",
                                    "(C6)", completion)
      .input(&Deviations::values, "deviations", "-", "any", any(), "normal deviations",
             Value::List{3.0, -2.0, 5.0, 0.0, -1.0})
      .length(1, 100'000)
      .output(&DeviationStatistics::max, "max", "-", "any", any(), "largest")
      .output(&DeviationStatistics::min, "min", "-", "any", any(), "smallest")
      .output(&DeviationStatistics::range, "range", "-", "any", non_negative(), "range")
      .output(&DeviationStatistics::mean, "mean", "-", "any", any(), "mean")
      .output(&DeviationStatistics::rms, "rms", "-", "any", non_negative(), "root mean square about zero");
  source.function<&generating_time>("generating_time", "Main time of the operation.", "(C7)", completion)
      .input(&GeneratingInputs::face_width_mm, "face_width", "B", "mm", positive(), "face width", 30.0)
      .input(&GeneratingInputs::overrun_mm, "overrun", "-", "mm", non_negative(), "overrun", 6.0)
      .input(&GeneratingInputs::axial_feed_mm_rev, "axial_feed", "s_a", "mm/rev", positive(),
             "axial feed per gear revolution", 0.2)
      .input(&GeneratingInputs::gear_rpm, "n_gear", "n_g", "rpm", positive(), "speed of the gear", 187.5)
      .input(&GeneratingInputs::passes, "passes", "-", "1", at_least(1), "passes", 2)
      .output(&GeneratingTime::time_min, "time", "-", "min", positive(), "main time");
  source
      .function<&line_contact_pressure>("line_contact_pressure", "Hertz pressure in line contact.", "(C8)",
                                        completion)
      .input(&LineContact::load_n_mm, "load_per_length", "q", "N/mm", positive(), "load per length", 100.0)
      .input(&LineContact::reduced_radius_mm, "rho_reduced", "rho", "mm", positive(), "reduced radius", 10.0)
      .input(&LineContact::e1_mpa, "e1", "E_1", "MPa", positive(), "modulus of the gear", 210000.0)
      .input(&LineContact::nu1, "nu1", "nu_1", "1", open_low(-1, 0.5), "Poisson's ratio of the gear", 0.3)
      .input(&LineContact::e2_mpa, "e2", "E_2", "MPa", positive(), "modulus of the tool", 600000.0)
      .input(&LineContact::nu2, "nu2", "nu_2", "1", open_low(-1, 0.5), "Poisson's ratio of the tool", 0.22)
      .output(&LineContactPressure::half_width_mm, "half_width", "a", "mm", positive(),
              "half width of the contact")
      .output(&LineContactPressure::p_max_mpa, "p_max", "p_max", "MPa", positive(), "greatest pressure");
}

}  // namespace verstat::models::k405
