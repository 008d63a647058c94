#include "models/drilling/k114_sharpened_chisel_edge.h"

#include <cmath>

#include "models/math/trig_degrees.h"

namespace verstat::models::k114 {
namespace {

double alpha_min_deg(const Edge& in) {
  return atan2_deg(cos_deg(in.phi_c_deg) * sin_deg(in.psi_deg), cos_deg(in.psi_deg));
}

}  // namespace

Clearance chisel_edge_clearance(const FlankSetting& in) {
  return guarded<&chisel_edge_clearance>(in, [&] {
    const double up = sin_deg(in.phi_c_deg) * cos_deg(in.eps1_deg) +
                      cos_deg(in.phi_c_deg) * sin_deg(in.eps1_deg) * sin_deg(in.psi_deg);
    return Clearance{atan2_deg(up, sin_deg(in.eps1_deg) * cos_deg(in.psi_deg))};
  });
}

Rake chisel_edge_rake(const FaceSetting& in) {
  return guarded<&chisel_edge_rake>(in, [&] {
    require(in.sign == 1 || in.sign == -1, "sign", in.sign, "must be 1 or -1 (the printed sign)");
    const double up =
        sin_deg(in.phi_c_deg) * cos_deg(in.eps2_deg) +
        static_cast<double>(in.sign) * cos_deg(in.phi_c_deg) * sin_deg(in.eps2_deg) * sin_deg(in.psi_deg);
    return Rake{atan2_deg(sin_deg(in.eps2_deg) * cos_deg(in.psi_deg), up)};
  });
}

Limits chisel_edge_limits(const Edge& in) {
  return guarded<&chisel_edge_limits>(in, [&] {
    const double alpha = alpha_min_deg(in);
    return Limits{alpha, 90 - alpha};
  });
}

Settings chisel_edge_setting_angles(const Targets& in) {
  return guarded<&chisel_edge_setting_angles>(in, [&] {
    // (4) with numerator and denominator multiplied by the cosine of the target, so that 90 deg is no pole.
    const double sin_phi = sin_deg(in.phi_c_deg);
    const double cos_psi = cos_deg(in.psi_deg);
    const double roof = cos_deg(in.phi_c_deg) * sin_deg(in.psi_deg);
    const double sin_alpha = sin_deg(in.alpha_target_deg);
    const double cos_alpha = cos_deg(in.alpha_target_deg);
    const double sin_gamma = sin_deg(in.gamma_target_deg);
    const double cos_gamma = cos_deg(in.gamma_target_deg);
    const double alpha_min = alpha_min_deg(in);
    return Settings{atan2_deg(sin_phi * cos_alpha, cos_psi * sin_alpha - roof * cos_alpha),
                    atan2_deg(sin_phi * sin_gamma, cos_psi * cos_gamma - roof * sin_gamma),
                    in.alpha_target_deg >= alpha_min && in.gamma_target_deg <= 90 - alpha_min &&
                        in.alpha_target_deg + in.gamma_target_deg < 90};
  });
}

Rake flat_flank_chisel_rake(const OnePlanePoint& in) {
  return guarded<&flat_flank_chisel_rake>(in, [&] {
    const double phi_deg = in.two_phi_deg / 2;
    return Rake{-atan2_deg(sin_deg(phi_deg) * sin_deg(in.psi_deg), cos_deg(phi_deg))};
  });
}

TwoPlaneChisel two_plane_chisel_plan_angle(const TwoPlanePoint& in) {
  return guarded<&two_plane_chisel_plan_angle>(in, [&] {
    const double phi_deg = in.two_phi_deg / 2;
    const double a = cos_deg(phi_deg) / sin_deg(phi_deg);
    const double w = in.core_ratio;
    const double tan_alpha = sin_deg(in.alpha_periphery_deg) / cos_deg(in.alpha_periphery_deg);
    const double sin_psi = sin_deg(in.psi_deg);
    const double cos_psi = cos_deg(in.psi_deg);
    const double b1 = (tan_alpha - a * w) / std::sqrt((1 - w) * (1 + w));
    return TwoPlaneChisel{atan2_deg(1, a * cos_psi - b1 * sin_psi), b1, 2 * a * cos_psi / sin_psi - b1};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K114",
       .title = "Research of geometrical parameters of spiral drills with sharp chisel edge and reverse "
                "angle of slope of chisel edge",
       .authors = "Kovaleva L. I., Rodin R. P., Plivak A. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "A point grind whose chisel edge is a roof-shaped line with two extra planes on each half: "
                 "clearance and rake of the chisel edge by the setting angles, settings for wanted angles "
                 "and whether they can be reached, conventional points to compare with.",
       .role = "drilling",
       .errata = {"Eq. (2) is printed with a minus before its last term; only the plus gives the paper's own "
                  "recommendation (eps2 = 30.4 deg) and the monotone growth that the text states.",
                  "The studied range of phi_c is stated as 10-80 deg; the printed extremes belong to 35-85.",
                  "The rake -53.7 deg is printed for a point angle of 120 deg; it belongs to 118 deg."}});

  const auto edge = [](auto& f, double psi, double phi_c) {
    f.input(&Edge::psi_deg, "psi_deg", "psi", "deg", open(0, 90), "slope of the chisel edge in plan", psi)
        .input(&Edge::phi_c_deg, "phi_c_deg", "phi_c", "deg", open_low(0, 90),
               "angle between each half of the chisel edge and the axis, 90 = horizontal", phi_c);
  };
  const auto usual_edge = [&](auto& f) { edge(f, 50.0, 85.0); };
  source
      .function<&chisel_edge_clearance>("chisel_edge_clearance",
                                        "Clearance in the section normal to the chisel edge.",
                                        "eq. (1), compact form (1c)", Provenance::paper)
      .with(usual_edge)
      .input(&FlankSetting::eps1_deg, "eps1_deg", "eps_1", "deg", closed(0, 90),
             "setting angle of the flank plane", 86.0)
      .output(&Clearance::alpha_c_deg, "alpha_c_deg", "alpha_c", "deg", closed(0, 90), "clearance");
  source
      .function<&chisel_edge_rake>("chisel_edge_rake", "Rake in the section normal to the chisel edge.",
                                   "eq. (2), corrected (2c)", Provenance::repaired)
      .with(usual_edge)
      .input(&FaceSetting::eps2_deg, "eps2_deg", "eps_2", "deg", closed(0, 90),
             "setting angle of the face plane", 30.4)
      .optional(&FaceSetting::sign, "sign", "s", "1", closed(-1, 1),
                "1 as corrected, -1 as printed (eps2 counted to the other side of the axis)")
      .output(&Rake::gamma_c_deg, "gamma_c_deg", "gamma_c", "deg", closed(0, 180),
              "rake; above 90 only with the printed sign");
  source
      .function<&chisel_edge_limits>("chisel_edge_limits", "Least clearance and largest rake of the edge.",
                                     "eq. (3)", Provenance::completion)
      .with(usual_edge)
      .output(&Limits::alpha_min_deg, "alpha_min_deg", "alpha_min", "deg", closed(0, 90),
              "clearance at eps_1 = 90")
      .output(&Limits::gamma_max_deg, "gamma_max_deg", "gamma_max", "deg", closed(0, 90),
              "rake at eps_2 = 90");
  source
      .function<&chisel_edge_setting_angles>("chisel_edge_setting_angles",
                                             "Setting angles for a wanted clearance and rake.", "eq. (4)",
                                             Provenance::completion)
      .with(usual_edge)
      .input(&Targets::alpha_target_deg, "alpha_target_deg", "alpha_c", "deg", closed(0, 90),
             "wanted clearance", 12.0)
      .input(&Targets::gamma_target_deg, "gamma_target_deg", "gamma_c", "deg", closed(0, 90), "wanted rake",
             20.0)
      .output(&Settings::eps1_deg, "eps1_deg", "eps_1", "deg", closed(0, 180),
              "setting angle of the flank plane; above 90 when not feasible")
      .output(&Settings::eps2_deg, "eps2_deg", "eps_2", "deg", closed(0, 180),
              "setting angle of the face plane; above 90 when not feasible")
      .output(&Settings::feasible, "feasible", "-", "-", no_range(),
              "the targets are within the limits and leave a wedge")
      .note(
          "The strength of the wedge, 90 - alpha_c - gamma_c, is not treated; keep it above 40 deg for "
          "hard work materials.");
  source
      .function<&flat_flank_chisel_rake>("flat_flank_chisel_rake",
                                         "Chisel rake of the conventional one-plane point.", "eq. (5)",
                                         Provenance::completion)
      .input(&OnePlanePoint::two_phi_deg, "two_phi_deg", "2 phi", "deg", closed(90, 150), "point angle",
             118.0)
      .input(&OnePlanePoint::psi_deg, "psi_deg", "psi", "deg", open(0, 180), "chisel angle in plan", 55.0)
      .output(&Rake::gamma_c_deg, "gamma_c_deg", "gamma_c", "deg", closed(-90, 0), "rake")
      .note(
          "On a real one-plane point the chisel angle follows from the clearance and the core; here it is "
          "taken as given.");
  source
      .function<&two_plane_chisel_plan_angle>("two_plane_chisel_plan_angle",
                                              "Half angle of the chisel edge of a two-plane ground point.",
                                              "eq. (6)", Provenance::completion)
      .input(&TwoPlanePoint::two_phi_deg, "two_phi_deg", "2 phi", "deg", closed(90, 150), "point angle",
             120.0)
      .input(&TwoPlanePoint::psi_deg, "psi_deg", "psi", "deg", open(0, 90), "chisel angle in plan", 55.0)
      .input(&TwoPlanePoint::alpha_periphery_deg, "alpha_periphery_deg", "alpha_p", "deg", closed(0, 30),
             "clearance at the periphery", 12.0)
      .input(&TwoPlanePoint::core_ratio, "core_ratio", "2d/D", "1", open_high(0, 1),
             "core over drill diameter", 0.15)
      .output(&TwoPlaneChisel::phi_c_deg, "phi_c_deg", "phi_c", "deg", closed(0, 180),
              "half angle of the chisel edge; above 90 the centre is recessed")
      .output(&TwoPlaneChisel::flank1_slope, "flank1_slope", "b_1", "1", any(), "slope of the first plane")
      .output(&TwoPlaneChisel::flank2_slope, "flank2_slope", "b_2", "1", any(), "slope of the second plane");
}

}  // namespace verstat::models::k114
