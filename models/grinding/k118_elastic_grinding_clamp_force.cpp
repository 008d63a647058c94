#include "models/grinding/k118_elastic_grinding_clamp_force.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/solve.h"

namespace verstat::models::k118 {
namespace {

constexpr double um_mm = 1000;
constexpr double zero_celsius_k = 273;  // the paper's offset: 1153 K = 880 degC
constexpr double least_depth_um = 1;
constexpr double largest_depth_um = 60;
constexpr double degree = std::numbers::pi / 180;

ContactGeometry geometry(const WheelContact& in, double depth_um) {
  ContactGeometry g{};
  const double depth_mm = depth_um / um_mm;
  const double speed_ratio = 60 * in.wheel_speed_m_s / in.work_speed_m_min;
  g.grain_diameter_um = 6090 / std::cbrt(in.grains_per_carat);
  g.grain_spacing_body_mm = 10 / std::cbrt(4.4 * in.concentration_pct * in.grains_per_carat / 100);
  g.grain_spacing_surface_mm = g.grain_spacing_body_mm * in.k_l;
  g.active_share = -std::expm1(-std::pow(depth_um, in.weibull_m) / in.weibull_x0_um_m);
  g.k_height = 1 / std::sqrt(g.active_share);
  g.k_kinematic = in.kd_intercept + in.kd_slope * speed_ratio;
  require(g.k_kinematic > 0, "kd_intercept", in.kd_intercept,
          "must make K_d = kd_intercept + kd_slope * 60 V_k / V_d positive");
  g.grain_pitch_mm = g.grain_spacing_surface_mm * g.k_height * g.k_kinematic;
  require(2 * depth_mm <= in.wheel_radius_mm, "wheel_radius_mm", in.wheel_radius_mm,
          "must be at least twice the depth of cut");
  g.contact_length_mm = std::sqrt(2 * in.wheel_radius_mm * depth_mm);
  // One grain takes the whole depth at most: the advance counts up to the contact length.
  const double advance_mm = std::min(g.grain_pitch_mm / speed_ratio, g.contact_length_mm);
  const double s2 = advance_mm * (advance_mm - 2 * g.contact_length_mm);
  const double radius_mm = in.wheel_radius_mm;
  g.chip_thickness_max_um = um_mm * -s2 / (radius_mm + std::sqrt(std::max(0.0, radius_mm * radius_mm + s2)));
  g.contact_area_mm2 = in.width_mm * g.contact_length_mm;
  g.active_grains = g.contact_area_mm2 * in.k_contact * g.active_share /
                    (g.grain_spacing_surface_mm * g.grain_spacing_surface_mm);
  return g;
}

// Width of a cone with rounded tip at a depth, um.
double tip_width_um(double depth_um, double radius_um, double half_angle_rad) {
  const double round_to_um = radius_um * (1 - std::sin(half_angle_rad));
  const double round_um = std::min(depth_um, round_to_um);
  return 2 * (std::sqrt(round_um * (2 * radius_um - round_um)) +
              (depth_um - round_um) * std::tan(half_angle_rad));
}

GrainCut cut(const WheelContact& wheel, const GrainCutting& in, double depth_um, const ContactGeometry& g) {
  const double chip_um = g.chip_thickness_max_um + in.roughness_rz_um / 2;
  require(chip_um < g.grain_diameter_um, "grains_per_carat", wheel.grains_per_carat,
          "makes the grains finer than the chip is thick");
  const double rake_rad = -std::asin(1 - 2 * chip_um / g.grain_diameter_um);
  const double shear_rad = std::atan2(std::cos(rake_rad), in.shrinkage - std::sin(rake_rad));
  const double stress_ratio = 1 + 2 * (std::numbers::pi / 4 - shear_rad);
  const double action_rad = std::atan(stress_ratio) - shear_rad;
  const double wear_flat_um = 0.22 * g.grain_diameter_um * std::pow(in.time_after_dress_min, 0.047);
  const double tip_mm = tip_width_um(depth_um, in.tip_radius_um, in.cone_angle_deg / 2 * degree) / um_mm;
  const double spaced_mm = g.grain_spacing_surface_mm * g.grain_spacing_surface_mm /
                           (g.grain_pitch_mm * g.active_share * wheel.k_contact);
  const double cut_mm = std::min(spaced_mm, tip_mm);
  // Resultant of the shear plane per mm of width and unit of flow stress, inclined at omega.
  const double shear_um = std::sqrt(1 + stress_ratio * stress_ratio) * chip_um / std::sin(shear_rad);
  const double flat_um = in.k_flank * stress_ratio * wear_flat_um;
  const double width_mm2 = cut_mm * g.active_grains / um_mm;
  return {.chip_thickness_um = chip_um,
          .rake_deg = rake_rad / degree,
          .shear_angle_deg = shear_rad / degree,
          .stress_ratio = stress_ratio,
          .action_angle_deg = action_rad / degree,
          .wear_flat_um = wear_flat_um,
          .tip_width_mm = tip_mm,
          .cut_width_mm = cut_mm,
          .normal_factor_mm2 = (shear_um * std::sin(action_rad) + flat_um) * width_mm2,
          .tangential_factor_mm2 = (shear_um * std::cos(action_rad) + in.friction * flat_um) * width_mm2};
}

double peclet(double work_speed_m_min, double contact_length_mm, double diffusivity_m2_s) {
  return work_speed_m_min / 60 * (contact_length_mm * 1e-3) / (4 * diffusivity_m2_s);
}

// Rise per newton of tangential force, eq. (4), in SI units.
double rise_per_newton(const HeatPath& heat, double wheel_speed_m_s, double work_speed_m_min,
                       double contact_length_mm, double width_mm) {
  const double h = peclet(work_speed_m_min, contact_length_mm, heat.diffusivity_m2_s);
  const double area_m2 = contact_length_mm * width_mm * 1e-6;
  return 4 * heat.diffusivity_m2_s * heat.heat_fraction * wheel_speed_m_s * std::sqrt(h) *
         std::numbers::inv_sqrtpi / (heat.conductivity_w_mk * (work_speed_m_min / 60) * area_m2);
}

ElasticState state(const ElasticWithoutDepth& in, double depth_um) {
  const double ambient_k = in.ambient_c + zero_celsius_k;
  require(in.flow_alpha_mpa_k * ambient_k < in.flow_c_mpa, "flow_c_mpa", in.flow_c_mpa,
          "must leave a positive flow stress at ambient temperature");
  const ContactGeometry g = geometry(in, depth_um);
  const GrainCut grain = cut(in, in, depth_um, g);
  const double k =
      rise_per_newton(in, in.wheel_speed_m_s, in.work_speed_m_min, g.contact_length_mm, in.width_mm);
  const double factor_mm2 = in.k_cal * grain.tangential_factor_mm2;
  // T = T_0 + k A (C - alpha T); the rise is written so that no heat leaves exactly the ambient temperature.
  const double rise_k = k * factor_mm2 * (in.flow_c_mpa - in.flow_alpha_mpa_k * ambient_k) /
                        (1 + k * factor_mm2 * in.flow_alpha_mpa_k);
  const double flow_mpa = in.flow_c_mpa - in.flow_alpha_mpa_k * (ambient_k + rise_k);
  const double tangential_n = factor_mm2 * flow_mpa;
  return {.temperature_c = in.ambient_c + rise_k,
          .flow_stress_mpa = flow_mpa,
          .clamp_force_n = in.k_cal * grain.normal_factor_mm2 * flow_mpa,
          .tangential_force_n = tangential_n,
          .power_kw = tangential_n * in.wheel_speed_m_s / 1000,
          .removal_rate_mm3_min = depth_um / um_mm * in.width_mm * in.work_speed_m_min * 1000};
}

}  // namespace

ContactGeometry grinding_contact_geometry(const ContactInputs& in) {
  return guarded<&grinding_contact_geometry>(in, [&] { return geometry(in, in.depth_um); });
}

GrainCut grinding_grain_cut(const GrainCutInputs& in) {
  return guarded<&grinding_grain_cut>(in,
                                      [&] { return cut(in, in, in.depth_um, geometry(in, in.depth_um)); });
}

ForcesAtTemperature clamp_force_at_temperature(const ForceInputs& in) {
  return guarded<&clamp_force_at_temperature>(in, [&] {
    const double flow_mpa = in.flow_c_mpa - in.flow_alpha_mpa_k * (in.temperature_c + zero_celsius_k);
    require(flow_mpa > 0, "temperature_degc", in.temperature_c,
            "must stay below C/alpha - 273, where the flow stress ends");
    const GrainCut grain = cut(in, in, in.depth_um, geometry(in, in.depth_um));
    return ForcesAtTemperature{flow_mpa, in.k_cal * grain.normal_factor_mm2 * flow_mpa,
                               in.k_cal * grain.tangential_factor_mm2 * flow_mpa};
  });
}

TemperatureRise grinding_temperature_rise(const RiseInputs& in) {
  return guarded<&grinding_temperature_rise>(in, [&] {
    const double k =
        rise_per_newton(in, in.wheel_speed_m_s, in.work_speed_m_min, in.contact_length_mm, in.width_mm);
    return TemperatureRise{k * in.tangential_force_n,
                           peclet(in.work_speed_m_min, in.contact_length_mm, in.diffusivity_m2_s)};
  });
}

ForceLimit tangential_force_limit(const ForceLimitInputs& in) {
  return guarded<&tangential_force_limit>(in, [&] {
    require(in.heat_fraction > 0, "heat_fraction", in.heat_fraction,
            "must be positive: without heat no force is a limit");
    const double k =
        rise_per_newton(in, in.wheel_speed_m_s, in.work_speed_m_min, in.contact_length_mm, in.width_mm);
    return ForceLimit{in.allowed_rise_k / k,
                      peclet(in.work_speed_m_min, in.contact_length_mm, in.diffusivity_m2_s)};
  });
}

ElasticState elastic_grinding_state(const ElasticInputs& in) {
  return guarded<&elastic_grinding_state>(in, [&] { return state(in, in.depth_um); });
}

DepthFromClamp elastic_depth_from_clamp(const ClampInputs& in) {
  return guarded<&elastic_depth_from_clamp>(in, [&] {
    const auto excess_n = [&](double depth_um) {
      return state(in, depth_um).clamp_force_n - in.clamp_force_n;
    };
    require(excess_n(least_depth_um) <= 0, "clamp_force_n", in.clamp_force_n,
            "is below the force of a depth of 1 um");
    require(excess_n(largest_depth_um) >= 0, "clamp_force_n", in.clamp_force_n,
            "is above the force of a depth of 60 um");
    const double depth_um = find_root(excess_n, least_depth_um, largest_depth_um);
    const ElasticState at = state(in, depth_um);
    return DepthFromClamp{depth_um, at.temperature_c, at.tangential_force_n};
  });
}

ThermalLimit thermal_limit_state(const ThermalLimitInputs& in) {
  return guarded<&thermal_limit_state>(in, [&] {
    const auto excess_k = [&](double depth_um) { return state(in, depth_um).temperature_c - in.critical_c; };
    if (excess_k(largest_depth_um) < 0)
      return ThermalLimit{largest_depth_um, state(in, largest_depth_um).clamp_force_n, false};
    const double depth_um = excess_k(least_depth_um) >= 0
                                ? least_depth_um
                                : find_root(excess_k, least_depth_um, largest_depth_um);
    return ThermalLimit{depth_um, state(in, depth_um).clamp_force_n, true};
  });
}

GrindingTime elastic_grinding_time(const PassInputs& in) {
  return guarded<&elastic_grinding_time>(in, [&] {
    const double passes = std::max(0.0, std::ceil(in.allowance_um / in.depth_um - 1e-9));
    require(passes < 1e15, "allowance_um", in.allowance_um, "asks for more than 1e15 passes");
    return GrindingTime{static_cast<std::int64_t>(passes),
                        passes * in.stroke_length_mm / (1000 * in.work_speed_m_min)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K118",
       .title =
           "Determination of the force pressing a specimen against the cutting surface of the wheel, limited "
           "by the temperature of phase and structural transformations, when grinding by the elastic scheme",
       .authors = "Burdin A. V., Matyukha P. G.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Plunge surface grinding of flat knives with a metal-bonded diamond wheel by the elastic scheme: "
           "the part is pressed to the wheel with a set force, and depth, removal rate and temperature "
           "follow. "
           "Sums the forces of all grains in contact; the limit is the clamp force at which the surface "
           "reaches the transformation point.",
       .role = "grinding",
       .errata = {
           "V_d in K_d and in the chip thickness is in m/min, not 0.1 m/s: otherwise the pitch exceeds the "
           "circumference of the wheel.",
           "L = sqrt(2 R t) 10^-3 is printed; 10^-3 converts the depth and belongs under the root.",
           "b_c prints a_z where the sphere-cone transition h_0 must stand.",
           "The chip thickness turns down and negative for grains farther apart than the contact is long; "
           "the "
           "advance is limited to the contact length.",
           "Eq. (5) prints the heat fraction under the root; eq. (4) solved for the force has it outside.",
           "alpha of steel 60S2 is printed 0.332; only 0.432 gives the ratio of the two published forces.",
           "Eq. (6) is the force at the given depth if the zone were at Ac3, no limit by itself: the limit "
           "solves force and temperature together."}});

  const auto wheel_speeds = [](auto& f) {
    f.optional(&WheelContact::wheel_speed_m_s, "wheel_speed_m_s", "V_k", "m/s", positive(), "wheel speed")
        .optional(&WheelContact::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(),
                  "work speed");
  };
  const auto depth = [](auto& f) {
    f.optional(&DepthOfCut::depth_um, "depth_um", "t_phi", "um", closed(least_depth_um, largest_depth_um),
               "depth of cut");
  };
  const auto contact = [&](auto& f) {
    f.optional(&WheelContact::wheel_radius_mm, "wheel_radius_mm", "R_k", "mm", positive(), "wheel radius")
        .with(wheel_speeds)
        .optional(&WheelContact::width_mm, "width_mm", "b", "mm", positive(), "width of the ground face")
        .optional(&WheelContact::concentration_pct, "concentration_pct", "K", "%", closed(25, 200),
                  "concentration of grains; 100 % is 4.4 carat/cm3")
        .optional(&WheelContact::grains_per_carat, "grains_per_carat", "N_z", "1/carat", positive(),
                  "grains in a carat")
        .optional(&WheelContact::weibull_m, "weibull_m", "m", "1", positive(), "shape of the grain heights")
        .optional(&WheelContact::weibull_x0_um_m, "weibull_x0", "X_0", "um^m", positive(),
                  "scale of the grain heights")
        .optional(&WheelContact::kd_intercept, "kd_intercept", "alpha_d", "1", any(),
                  "intercept of the kinematic coefficient")
        .optional(&WheelContact::kd_slope, "kd_slope", "beta_d", "1", any(),
                  "slope of the kinematic coefficient over 60 V_k/V_d")
        .optional(&WheelContact::k_l, "k_l", "K_1", "1", at_least(1),
                  "spacing on the surface over spacing in the body")
        .optional(&WheelContact::k_contact, "k_contact", "K_k", "1", closed(0, 1),
                  "share of grains in contact");
  };
  const auto grain = [](auto& f) {
    f.optional(&GrainCutting::roughness_rz_um, "roughness_rz_um", "R_z", "um", closed(0, 20),
               "roughness of the surface being cut (completion: not given)")
        .optional(&GrainCutting::shrinkage, "shrinkage", "K_L", "1", above(1), "chip shrinkage")
        .optional(&GrainCutting::time_after_dress_min, "time_after_dress_min", "T", "min", positive(),
                  "time since dressing")
        .optional(&GrainCutting::k_flank, "k_flank", "kappa_3", "1", positive(),
                  "coefficient of the wear-flat force")
        .optional(&GrainCutting::friction, "friction", "mu", "1", closed(0, 1), "friction on the wear flat")
        .optional(&GrainCutting::tip_radius_um, "tip_radius_um", "rho", "um", positive(),
                  "radius of the grain tip (completion: not given)")
        .optional(&GrainCutting::cone_angle_deg, "cone_angle_deg", "epsilon", "deg", open(0, 180),
                  "apex angle of the grain (completion: not given)");
  };
  const auto flow = [](auto& f) {
    f.optional(&Steel::flow_c_mpa, "flow_c_mpa", "C", "MPa", positive(), "flow stress at 0 K")
        .optional(&Steel::flow_alpha_mpa_k, "flow_alpha_mpa_k", "alpha", "MPa/K", positive(),
                  "fall of the flow stress per kelvin");
  };
  const auto calibration = [](auto& f) {
    f.optional(&Steel::k_cal, "k_cal", "-", "1", positive(),
               "calibration of the forces: 1.33 reproduces Table 2, 1 is the printed formula");
  };
  const auto heat = [](auto& f) {
    f.optional(&HeatPath::conductivity_w_mk, "conductivity_w_mk", "lambda", "W/(m*K)", positive(),
               "thermal conductivity")
        .optional(&HeatPath::diffusivity_m2_s, "diffusivity_m2_s", "a", "m2/s", positive(),
                  "thermal diffusivity")
        .optional(&HeatPath::heat_fraction, "heat_fraction", "alpha_B", "1", closed(0, 1),
                  "share of the heat that enters the part");
  };
  const auto heat_inputs = [&](auto& f) {
    f.optional(&HeatInputs::wheel_speed_m_s, "wheel_speed_m_s", "V_k", "m/s", positive(), "wheel speed")
        .optional(&HeatInputs::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed")
        .input(&HeatInputs::contact_length_mm, "contact_length_mm", "L", "mm", positive(), "contact length",
               1.9365)
        .optional(&HeatInputs::width_mm, "width_mm", "b", "mm", positive(), "width of the ground face")
        .with(heat);
  };
  const auto elastic = [&](auto& f) {
    f.with(contact)
        .with(grain)
        .with(flow)
        .with(calibration)
        .optional(&ElasticWithoutDepth::ambient_c, "ambient_degc", "-", "degC", closed(-50, 100),
                  "ambient temperature");
    f.with(heat);
  };
  const std::string calibrate =
      "heat_fraction and k_cal are handbook-order values: calibrate both on the real machine.";
  const std::string monotone = "Force and temperature grow with the depth on 1..60 um.";

  source
      .function<&grinding_contact_geometry>("grinding_contact_geometry",
                                            "Wheel surface, chip thickness and arc of contact.",
                                            "unnumbered, before eq. (1)", Provenance::repaired)
      .with(contact)
      .with(depth)
      .output(&ContactGeometry::grain_diameter_um, "grain_diameter_um", "d_cp", "um", positive(),
              "mean grain diameter")
      .output(&ContactGeometry::grain_spacing_body_mm, "grain_spacing_body_mm", "S_zr", "mm", positive(),
              "spacing of grains in the body")
      .output(&ContactGeometry::grain_spacing_surface_mm, "grain_spacing_surface_mm", "S_zn", "mm",
              positive(), "spacing of grains on the surface")
      .output(&ContactGeometry::active_share, "active_share", "F", "1", open_low(0, 1),
              "share of grains high enough to cut")
      .output(&ContactGeometry::k_height, "k_height", "K_c", "1", at_least(1), "coefficient of grain heights")
      .output(&ContactGeometry::k_kinematic, "k_kinematic", "K_d", "1", positive(), "kinematic coefficient")
      .output(&ContactGeometry::grain_pitch_mm, "grain_pitch_mm", "l_phi", "mm", positive(),
              "pitch of grains that cut in one track")
      .output(&ContactGeometry::chip_thickness_max_um, "chip_thickness_max_um", "a_zmax", "um", positive(),
              "largest chip thickness")
      .output(&ContactGeometry::contact_length_mm, "contact_length_mm", "L", "mm", positive(),
              "contact length")
      .output(&ContactGeometry::contact_area_mm2, "contact_area_mm2", "S", "mm2", positive(), "contact area")
      .output(&ContactGeometry::active_grains, "active_grains", "z_p", "1", non_negative(),
              "grains that cut at a time, not rounded");
  source
      .function<&grinding_grain_cut>("grinding_grain_cut",
                                     "Cut of one grain and force factors of all grains.",
                                     "brackets of eq. (1)", Provenance::repaired)
      .with(contact)
      .with(depth)
      .with(grain)
      .output(&GrainCut::chip_thickness_um, "chip_thickness_um", "a_z", "um", positive(),
              "chip thickness with roughness")
      .output(&GrainCut::rake_deg, "rake_deg", "gamma", "deg", closed(-90, 90), "rake of the grain")
      .output(&GrainCut::shear_angle_deg, "shear_angle_deg", "beta", "deg", closed(0, 90), "shear angle")
      .output(&GrainCut::stress_ratio, "stress_ratio", "M", "1", any(), "normal over shear stress")
      .output(&GrainCut::action_angle_deg, "action_angle_deg", "omega", "deg", any(), "action angle")
      .output(&GrainCut::wear_flat_um, "wear_flat_um", "l_3", "um", positive(), "wear flat")
      .output(&GrainCut::tip_width_mm, "tip_width_mm", "b_c", "mm", positive(),
              "width of the tip at the depth")
      .output(&GrainCut::cut_width_mm, "cut_width_mm", "S_x", "mm", positive(), "width of one cut")
      .output(&GrainCut::normal_factor_mm2, "normal_factor_mm2", "G_n", "mm2", any(),
              "normal force over flow stress")
      .output(&GrainCut::tangential_factor_mm2, "tangential_factor_mm2", "G_t", "mm2", any(),
              "tangential force over flow stress (completion)")
      .note(
          "The tip width caps the cut below about 10.5 um at the defaults: sensitive to tip radius and "
          "angle.");
  source
      .function<&clamp_force_at_temperature>("clamp_force_at_temperature",
                                             "Clamp force at a depth if the zone were at a temperature.",
                                             "eq. (6)", Provenance::repaired)
      .with(contact)
      .with(depth)
      .with(grain)
      .with(flow)
      .input(&ForceInputs::temperature_c, "temperature_degc", "T_Ac3", "degC", above(-273),
             "temperature of the zone", 880.0)
      .with(calibration)
      .output(&ForcesAtTemperature::flow_stress_mpa, "flow_stress_mpa", "tau", "MPa", positive(),
              "flow stress")
      .output(&ForcesAtTemperature::clamp_force_n, "clamp_force_n", "P_n", "N", any(), "clamp force")
      .output(&ForcesAtTemperature::tangential_force_n, "tangential_force_n", "P_zk", "N", any(),
              "tangential force")
      .note("Not a burn limit by itself: nothing here makes the temperature come about.");
  source
      .function<&grinding_temperature_rise>("grinding_temperature_rise",
                                            "Temperature rise of the ground surface.", "eq. (4)",
                                            Provenance::paper)
      .input(&RiseInputs::tangential_force_n, "tangential_force_n", "P_zk", "N", non_negative(),
             "tangential force", 1.8)
      .with(heat_inputs)
      .output(&TemperatureRise::temperature_rise_k, "temperature_rise_k", "T_max", "K", non_negative(),
              "rise")
      .output(&TemperatureRise::peclet_h, "peclet_h", "H", "1", positive(), "dimensionless half-width")
      .note("H = V_d L/(4a) is a completion; the form holds for H above 2 or so.");
  source
      .function<&tangential_force_limit>("tangential_force_limit",
                                         "Tangential force that brings the allowed rise.", "eq. (5)",
                                         Provenance::repaired)
      .input(&ForceLimitInputs::allowed_rise_k, "allowed_rise_k", "T_Ac3", "K", non_negative(),
             "allowed rise: critical temperature less ambient", 860.0)
      .with(heat_inputs)
      .output(&ForceLimit::tangential_force_n, "tangential_force_n", "P_zk", "N", non_negative(),
              "tangential force")
      .output(&ForceLimit::peclet_h, "peclet_h", "H", "1", positive(), "dimensionless half-width");
  source
      .function<&elastic_grinding_state>("elastic_grinding_state",
                                         "Temperature, forces and power for a given depth.",
                                         "completion, eqs. (1) and (4)", Provenance::completion)
      .with(elastic)
      .with(depth)
      .output(&ElasticState::temperature_c, "temperature_degc", "T", "degC", any(), "surface temperature")
      .output(&ElasticState::flow_stress_mpa, "flow_stress_mpa", "tau", "MPa", positive(), "flow stress")
      .output(&ElasticState::clamp_force_n, "clamp_force_n", "P_n", "N", any(), "clamp force")
      .output(&ElasticState::tangential_force_n, "tangential_force_n", "P_zk", "N", any(), "tangential force")
      .output(&ElasticState::power_kw, "power_kw", "-", "kW", any(), "cutting power")
      .output(&ElasticState::removal_rate_mm3_min, "removal_rate_mm3_min", "-", "mm3/min", positive(),
              "removal rate")
      .note(calibrate);
  source
      .function<&elastic_depth_from_clamp>("elastic_depth_from_clamp",
                                           "Depth of cut that a set clamp force produces.", "completion",
                                           Provenance::completion)
      .input(&ClampInputs::clamp_force_n, "clamp_force_n", "P_n", "N", positive(), "set clamp force", 5.0)
      .with(elastic)
      .output(&DepthFromClamp::depth_um, "depth_um", "t_phi", "um", closed(least_depth_um, largest_depth_um),
              "depth of cut")
      .output(&DepthFromClamp::temperature_c, "temperature_degc", "T", "degC", any(), "surface temperature")
      .output(&DepthFromClamp::tangential_force_n, "tangential_force_n", "P_zk", "N", any(),
              "tangential force")
      .note(monotone)
      .note(calibrate);
  source
      .function<&thermal_limit_state>(
          "thermal_limit_state", "Largest depth and clamp force without reaching a critical temperature.",
          "completion", Provenance::completion)
      .input(&ThermalLimitInputs::critical_c, "critical_degc", "T_Ac3", "degC", above(-273),
             "critical temperature", 300.0)
      .with(elastic)
      .output(&ThermalLimit::depth_um, "depth_um", "t_phi", "um", closed(least_depth_um, largest_depth_um),
              "largest depth")
      .output(&ThermalLimit::clamp_force_n, "clamp_force_n", "P_n", "N", any(), "its clamp force")
      .output(&ThermalLimit::limited, "limited", "-", "-", no_range(),
              "the critical temperature is reached within 1..60 um")
      .note(monotone)
      .note(calibrate);
  source
      .function<&elastic_grinding_time>("elastic_grinding_time", "Passes and main time for an allowance.",
                                        "completion", Provenance::completion)
      .input(&PassInputs::allowance_um, "allowance_um", "-", "um", non_negative(), "stock to remove", 200.0)
      .optional(&PassInputs::depth_um, "depth_um", "t_phi", "um", closed(least_depth_um, largest_depth_um),
                "depth of cut per pass")
      .input(&PassInputs::stroke_length_mm, "stroke_length_mm", "-", "mm", positive(), "length of a stroke",
             120.0)
      .optional(&PassInputs::work_speed_m_min, "work_speed_m_min", "V_d", "m/min", positive(), "work speed")
      .output(&GrindingTime::passes, "passes", "-", "1", non_negative(), "number of passes")
      .output(&GrindingTime::time_min, "time_min", "-", "min", non_negative(), "main time")
      .note("No spark-out, no reversal.");
}

}  // namespace verstat::models::k118
