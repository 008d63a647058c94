#include "models/thermal/k403_unsteady_cutting_temperature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/math/solve.h"
#include "models/thermal/wedge_conduction.h"

namespace verstat::models::k403 {
namespace {

constexpr double kc1 = 0.77;  // distribution of the friction flux on the rake, text under eq. (2)
constexpr double kc2 = 0.55;  // on the flank
constexpr double speed_low_m_min = 10;
constexpr double speed_high_m_min = 600;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}

// Eq. (1) and its inverse: the first Fo at which the share is reached or passed.
double paper_warm_up(double fo) {
  if (fo <= 0) return 0;
  if (fo <= 200) return 4e-3 * fo;
  if (fo <= 400) return 0.147 * std::pow(fo, 0.32);
  return 1;
}
double paper_fo_for(double share) {
  if (share <= 0.8) return share / 4e-3;
  return std::clamp(std::pow(share / 0.147, 1 / 0.32), 200.0, 400.0);
}

WedgeFunctions paper_wedge(double b, double l, double h, double beta_deg) {
  const double eta1 = std::max(1.0, b / l);
  const auto own = [&](double eta) {
    return (4.88 + 2.64 * std::sqrt(eta) * std::log10(eta)) * std::pow(10 / beta_deg, 0.85);
  };
  const double other =
      (0.04 + 0.02 * std::pow(eta1, 0.6) * std::log10(eta1)) * 1863 / (beta_deg * (1 + 0.38 * h / l));
  return {own(eta1), h > 0 ? own(std::max(1.0, b / h)) : 0, other, other};
}

WedgeFunctions wedge(Model model, double b, double l, double h, double beta_deg) {
  if (model == Model::paper) return paper_wedge(b, l, h, beta_deg);
  const thermal::WedgeRises rises = thermal::wedge_rises_at(beta_deg, b, l, h);
  return {rises.m1, rises.m2, rises.n, rises.n};
}

ChipSideCoefficients coefficients(const ChipSide& in) {
  const double speed_m_s = in.cutting_speed_m_min / 60;
  const double diffusivity = in.work_diffusivity_mm2_s * 1e-6;
  const double lambda = in.work_conductivity_w_mk;
  const double rake_m = in.rake_length_mm * 1e-3;
  const double flank_m = in.flank_length_mm * 1e-3;
  const double k = in.chip_compression;
  // Heat carried by the moving chip and by the moving surface under a contact of the length x: sqrt(om x /
  // V).
  const double bulk = (1 + in.preheating) * diffusivity * k * in.chip_share * in.shear_flux_w_mm2 * 1e6 /
                      (lambda * speed_m_s);
  const double rake_layer = std::sqrt(diffusivity * k * rake_m / speed_m_s) / lambda;
  const double flank_layer = std::sqrt(diffusivity * flank_m / speed_m_s) / lambda;
  return {bulk + kc1 * in.rake_flux_w_mm2 * 1e6 * rake_layer,
          bulk * in.flank_temperature_share + kc2 * in.flank_flux_w_mm2 * 1e6 * flank_layer,
          1.82 * kc2 * flank_layer,
          1.3 * kc1 * rake_layer + in.m1 * in.m * rake_m / in.tool_conductivity_w_mk};
}

HeatFluxes fluxes(const HeatBalance& in) {
  constexpr double to_w_mm2 = 1e-6;
  if (in.flank_length_mm == 0) return {in.k1_k / in.k4_m2k_w * to_w_mm2, 0};
  if (in.m == 0) {
    require(in.k3_m2k_w > 0, "k3", in.k3_m2k_w, "must be above 0 when h > 0 and m = 0");
    return {in.k1_k / in.k4_m2k_w * to_w_mm2, in.k2_k / in.k3_m2k_w * to_w_mm2};
  }
  const double lambda = in.tool_conductivity_w_mk;
  const double l = in.rake_length_mm * 1e-3;
  const double mh = in.m * in.flank_length_mm * 1e-3;
  const double rake = (in.k1_k * in.k3_m2k_w * lambda - in.k2_k * in.n2 * mh + in.k1_k * in.m2 * mh) /
                      (in.k3_m2k_w * in.k4_m2k_w * lambda + in.m2 * in.k4_m2k_w * mh -
                       in.n1 * in.n2 * in.m * l * mh / lambda);
  // From the balance on the flank: no 0/0 for a small m h.
  const double flank = (in.k2_k - in.n1 * in.m * l * rake / lambda) / (in.k3_m2k_w + in.m2 * mh / lambda);
  return {rake * to_w_mm2, flank * to_w_mm2};
}

ContactTemperatures rises(const HeatedContact& in) {
  const double l = in.rake_length_mm;
  const double h = in.flank_length_mm;
  // W/mm2 * mm / (W/(m K)) = 1e3 K
  const double from_rake = 1e3 * in.rake_flux_w_mm2 * l / in.tool_conductivity_w_mk;
  const double from_flank = 1e3 * in.flank_flux_w_mm2 * h / in.tool_conductivity_w_mk;
  const double rake = (from_rake * in.m1 + from_flank * in.n2) * in.m;
  if (h == 0) return {rake, 0, rake};
  const double flank = (from_flank * in.m2 + from_rake * in.n1) * in.m;
  return {rake, flank, (rake * l + flank * h) / (l + h)};
}

// (exp(t) erfc(sqrt t) - 1 + 2 sqrt(t/pi)) / t, 1 at t = 0.
double relaxed_share(double t) {
  const double x = std::sqrt(t);
  if (x < 1) {  // sum of (-x)^k / Gamma(k/2 + 2): no cancellation
    double sum = 0;
    double power = 1;
    for (int k = 0; k < 40; ++k) {
      sum += power / std::tgamma(0.5 * k + 2);
      power *= -x;
    }
    return sum;
  }
  double scaled_erfc = 0;  // exp(x^2) erfc(x)
  if (x < 20) {
    scaled_erfc = std::exp(t) * std::erfc(x);
  } else {
    const double y = 1 / (2 * t);
    scaled_erfc =
        std::numbers::inv_sqrtpi / x * (1 - y * (1 - 3 * y * (1 - 5 * y * (1 - 7 * y * (1 - 9 * y)))));
  }
  return (scaled_erfc - 1 + 2 * x * std::numbers::inv_sqrtpi) / t;
}

HeatSources sources(const ChipFormation& in) {
  const double kr = radians(in.kr_deg);
  const double gamma = radians(in.rake_deg);
  const double k = in.chip_compression;
  const double speed_m_s = in.cutting_speed_m_min / 60;
  const double speed_mm_s = speed_m_s * 1000;
  HeatSources out{};
  out.chip_thickness_mm = in.feed_mm_rev * std::sin(kr);
  out.chip_width_mm = in.depth_mm / std::sin(kr);
  const double a = out.chip_thickness_mm;
  const double b = out.chip_width_mm;
  out.rake_length_mm = a * (k * (1 - std::tan(gamma)) + 1 / std::cos(gamma));
  require(out.rake_length_mm > 0, "gamma", in.rake_deg,
          "leaves no contact with the chip: k (1 - tan gamma) + 1/cos gamma must be above 0");
  const double sharp_force = in.kc11_n_mm2 * b * std::pow(a, 1 - in.mc);
  out.rake_friction_n = sharp_force * (std::sin(gamma) + in.thrust_ratio * std::cos(gamma));
  require(out.rake_friction_n >= 0, "gamma", in.rake_deg,
          "makes the friction on the rake negative: tan(gamma) must not be below -thrust_ratio");
  const double phi = std::atan(std::cos(gamma) / (k - std::sin(gamma)));
  out.shear_angle_deg = phi * 180 / std::numbers::pi;
  const double l = out.rake_length_mm;
  out.rake_flux_w_mm2 = out.rake_friction_n * speed_m_s / (k * l * b);
  out.shear_flux_w_mm2 = (sharp_force * speed_m_s - out.rake_friction_n * speed_m_s / k) / (a * b * k);
  require(out.shear_flux_w_mm2 >= 0, "thrust_ratio", in.thrust_ratio,
          "leaves no power for shearing: friction on the rake would take more than the cut has");
  const bool worn = in.flank_wear_mm > 0;
  out.flank_flux_w_mm2 = worn ? in.flank_shear_n_mm2 * speed_m_s : 0;
  out.cutting_force_n = sharp_force + in.flank_shear_n_mm2 * in.flank_wear_mm * b;
  const double thermal_number = speed_mm_s * a / in.work_diffusivity_mm2_s * std::tan(phi);
  const double to_work = thermal_number <= 10 ? 0.5 - 0.35 * std::log10(thermal_number)
                                              : 0.3 - 0.15 * std::log10(thermal_number);
  out.chip_share = 1 - std::clamp(to_work, 0.0, 1.0);
  const double depth_ratio = std::sin(phi) * std::cos(phi);
  out.flank_temperature_share = worn ? relaxed_share(speed_mm_s * in.flank_wear_mm /
                                                     in.work_diffusivity_mm2_s * depth_ratio * depth_ratio)
                                     : 1;
  return out;
}

// Everything of a cut that does not depend on time.
class HeatedCut {
 public:
  HeatedCut(const CuttingZone& in, Model wedge_model) : HeatedCut(in, sources(in), wedge_model) {}
  HeatedCut(const CuttingZone& in, const HeatSources& found, Model wedge_model)
      : HeatedCut(in, found,
                  wedge(wedge_model, found.chip_width_mm, found.rake_length_mm, in.flank_wear_mm,
                        checked_wedge_deg(in))) {}
  HeatedCut(const CuttingZone& in, const HeatSources& found, const WedgeFunctions& functions)
      : in_(in), sources_(found), wedge_(functions) {}

  [[nodiscard]] static double checked_wedge_deg(const CuttingZone& in) {
    const double beta = 90 - in.rake_deg - in.relief_deg;
    require(beta >= 30 && beta <= 120, "alpha", in.relief_deg,
            "must leave a wedge angle 90 - gamma - alpha of 30 to 120 deg");
    return beta;
  }
  [[nodiscard]] const HeatSources& heat() const { return sources_; }
  [[nodiscard]] const WedgeFunctions& functions() const { return wedge_; }
  [[nodiscard]] double eta() const { return sources_.chip_width_mm / sources_.rake_length_mm; }
  [[nodiscard]] double fo(double time_s) const {
    return in_.tool_diffusivity_mm2_s * time_s / (sources_.rake_length_mm * sources_.rake_length_mm);
  }
  [[nodiscard]] CuttingTemperature at(double m) const {
    const double l = sources_.rake_length_mm;
    const double h = in_.flank_wear_mm;
    const ChipSideCoefficients k = coefficients({.cutting_speed_m_min = in_.cutting_speed_m_min,
                                                 .chip_compression = in_.chip_compression,
                                                 .rake_length_mm = l,
                                                 .flank_length_mm = h,
                                                 .m = m,
                                                 .m1 = wedge_.m1,
                                                 .shear_flux_w_mm2 = sources_.shear_flux_w_mm2,
                                                 .rake_flux_w_mm2 = sources_.rake_flux_w_mm2,
                                                 .flank_flux_w_mm2 = sources_.flank_flux_w_mm2,
                                                 .chip_share = sources_.chip_share,
                                                 .flank_temperature_share = sources_.flank_temperature_share,
                                                 .preheating = in_.preheating,
                                                 .work_conductivity_w_mk = in_.work_conductivity_w_mk,
                                                 .work_diffusivity_mm2_s = in_.work_diffusivity_mm2_s,
                                                 .tool_conductivity_w_mk = in_.tool_conductivity_w_mk});
    const HeatFluxes q = fluxes({.k1_k = k.k1_k,
                                 .k2_k = k.k2_k,
                                 .k3_m2k_w = k.k3_m2k_w,
                                 .k4_m2k_w = k.k4_m2k_w,
                                 .rake_length_mm = l,
                                 .flank_length_mm = h,
                                 .m = m,
                                 .m2 = wedge_.m2,
                                 .n1 = wedge_.n1,
                                 .n2 = wedge_.n2,
                                 .tool_conductivity_w_mk = in_.tool_conductivity_w_mk});
    const ContactTemperatures t = rises({.rake_flux_w_mm2 = q.rake_w_mm2,
                                         .flank_flux_w_mm2 = q.flank_w_mm2,
                                         .rake_length_mm = l,
                                         .flank_length_mm = h,
                                         .m = m,
                                         .m1 = wedge_.m1,
                                         .m2 = wedge_.m2,
                                         .n1 = wedge_.n1,
                                         .n2 = wedge_.n2,
                                         .tool_conductivity_w_mk = in_.tool_conductivity_w_mk});
    return {t.rake + in_.ambient_c, t.flank + in_.ambient_c, t.mean + in_.ambient_c,
            q.rake_w_mm2,           q.flank_w_mm2,           m};
  }
  [[nodiscard]] double mean_rise(double m) const { return at(m).mean_c - in_.ambient_c; }

 private:
  CuttingZone in_;
  HeatSources sources_;
  WedgeFunctions wedge_;
};

// (C7): contact of fo_cut in every fo_period, 200 pulses summed, the rest taken as a continuous flux.
double periodic_warm_up(double fo_cut, double fo_period, double eta) {
  constexpr int pulses = 200;
  const thermal::WedgeWarmUp warm_up(eta);
  double m = warm_up.at(fo_cut);
  for (int j = 1; j <= pulses; ++j) m += warm_up.at(j * fo_period + fo_cut) - warm_up.at(j * fo_period);
  m += fo_cut / fo_period * (1 - warm_up.at((pulses + 0.5) * fo_period + 0.5 * fo_cut));
  return std::min(m, 1.0);
}

}  // namespace

WarmUp m_fo_paper(const FourierNumber& in) {
  return guarded<&m_fo_paper>(in, [&] { return WarmUp{paper_warm_up(in.fo)}; });
}

WedgeFunctions wedge_functions(const WedgeContact& in) {
  return guarded<&wedge_functions>(
      in, [&] { return wedge(in.model, in.width_mm, in.rake_length_mm, in.flank_length_mm, in.wedge_deg); });
}

ChipSideCoefficients chip_side_coefficients(const ChipSide& in) {
  return guarded<&chip_side_coefficients>(in, [&] { return coefficients(in); });
}

HeatFluxes heat_fluxes(const HeatBalance& in) {
  return guarded<&heat_fluxes>(in, [&] { return fluxes(in); });
}

ContactTemperatures contact_temperatures(const HeatedContact& in) {
  return guarded<&contact_temperatures>(in, [&] { return rises(in); });
}

HeatSources heat_sources(const ChipFormation& in) {
  return guarded<&heat_sources>(in, [&] { return sources(in); });
}

WarmUp m_fo_exact(const WedgeFourier& in) {
  return guarded<&m_fo_exact>(in, [&] { return WarmUp{thermal::WedgeWarmUp(in.eta).at(in.fo)}; });
}

WarmUp m_periodic(const PeriodicContact& in) {
  return guarded<&m_periodic>(in, [&] {
    require(in.fo_cut <= in.fo_period, "fo_cut", in.fo_cut, "must not be above fo_period");
    return WarmUp{periodic_warm_up(in.fo_cut, in.fo_period, in.eta)};
  });
}

CuttingTemperature cutting_temperature(const ContinuousCut& in) {
  return guarded<&cutting_temperature>(in, [&] {
    const HeatedCut cut(in, in.wedge);
    if (in.time_s < 0) return cut.at(1);
    const double fo = in.fo_scale * cut.fo(in.time_s);
    return cut.at(in.m_model == Model::paper ? paper_warm_up(fo) : thermal::WedgeWarmUp(cut.eta()).at(fo));
  });
}

CuttingTemperature interrupted_cutting_temperature(const InterruptedCut& in) {
  return guarded<&interrupted_cutting_temperature>(in, [&] {
    require(in.contact_s <= in.period_s, "t_cut", in.contact_s, "must not be above t_period");
    const HeatedCut cut(in, Model::exact);
    return cut.at(periodic_warm_up(cut.fo(in.contact_s), cut.fo(in.period_s), cut.eta()));
  });
}

SettlingTime settling_time(const Settling& in) {
  return guarded<&settling_time>(in, [&] {
    const HeatedCut cut(in, in.wedge);
    const double target = in.fraction * cut.mean_rise(1);
    if (!(target > 0)) reject("the steady rise of the mean temperature is not positive");
    // The rise need not be monotone in m when the flank drains heat: the first crossing is sought in steps.
    constexpr int steps = 400;
    double low = 0;
    double high = 1;
    for (int k = 1; k <= steps; ++k) {
      high = static_cast<double>(k) / steps;
      if (cut.mean_rise(high) >= target) break;
      low = high;
    }
    const double share = find_root([&](double m) { return cut.mean_rise(m) - target; }, low, high);
    const double fo =
        in.m_model == Model::paper ? paper_fo_for(share) : thermal::WedgeWarmUp(cut.eta()).fo_for(share);
    return SettlingTime{fo / (in.fo_scale * cut.fo(1.0))};
  });
}

SpeedLimit speed_for_temperature(const TemperatureLimit& in) {
  return guarded<&speed_for_temperature>(in, [&] {
    CuttingZone zone = in;
    zone.cutting_speed_m_min = speed_low_m_min;
    // Contact and wedge do not depend on the speed.
    const HeatedCut slow(zone, Model::exact);
    const auto excess = [&](double speed) {
      zone.cutting_speed_m_min = speed;
      return HeatedCut(zone, sources(zone), slow.functions()).at(1).mean_c - in.limit_c;
    };
    if (excess(speed_low_m_min) > 0) return SpeedLimit{false, 0};
    if (excess(speed_high_m_min) <= 0) return SpeedLimit{true, speed_high_m_min};
    return SpeedLimit{true, find_root(excess, speed_low_m_min, speed_high_m_min)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K403",
       .title = "Study of heat fluxes and temperatures in the cutting zone under unsteady heat exchange",
       .authors = "Ivchenko T. G., Petryaeva I. A., Polyakova E. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Heat balance of a cutting wedge: shear heat and friction on rake and worn flank, the fluxes that "
           "enter the tool from equal temperatures on both sides of each contact, and the warm-up of the "
           "wedge from the start of the cut, for continuous and interrupted cutting.",
       .role = "thermal",
       .errata = {
           "Denominator of eq. (2): the factor m is missing in M2 K4 h; it follows from the balance.",
           "K2 is printed with T_u; T_d, the temperature under the flank, is meant.",
           "Wedge functions: the printed exponent of the wedge angle has the wrong sign and the angle no "
           "unit; with tens of degrees and -0.85 they meet the exact wedge to 5 % for b/l = 2..5.",
           "The special functions B of the mutual influence are not given; a fit with N1 = N2 "
           "(reciprocity) stands in.",
           "m(Fo) starts linearly, which no conduction solution does; kept for reproduction, the exact "
           "warm-up stands beside it."}});

  const auto conditions = [](auto& f) {
    f.input(&ChipFormation::feed_mm_rev, "s", "s", "mm/rev", positive(), "feed", 0.4)
        .input(&ChipFormation::depth_mm, "t", "t", "mm", positive(), "depth of cut", 1.0)
        .input(&ChipFormation::flank_wear_mm, "h", "h", "mm", non_negative(), "width of the flank wear land",
               0.1);
  };
  const auto regime = [&](auto& f) {
    f.input(&ChipFormation::cutting_speed_m_min, "v", "V", "m/min", positive(), "cutting speed", 80.0);
    conditions(f);
  };
  const auto formation = [](auto& f) {
    f.optional(&ChipFormation::kr_deg, "kr", "kappa_r", "deg", open(0, 180), "edge angle")
        .optional(&ChipFormation::rake_deg, "gamma", "gamma", "deg", open(-90, 90), "rake angle")
        .optional(&ChipFormation::chip_compression, "k", "k", "1", closed(1.2, 5), "chip compression ratio")
        .optional(&ChipFormation::kc11_n_mm2, "kc11", "k_c1.1", "N/mm2", positive(), "specific cutting force")
        .optional(&ChipFormation::mc, "mc", "m_c", "1", open_high(0, 1), "exponent of the chip thickness")
        .optional(&ChipFormation::thrust_ratio, "thrust_ratio", "chi", "1", non_negative(),
                  "thrust over cutting force of the sharp tool")
        .optional(&ChipFormation::flank_shear_n_mm2, "tau_flank", "tau_fl", "N/mm2", non_negative(),
                  "friction stress on the wear land")
        .optional(&ChipFormation::work_diffusivity_mm2_s, "om_d", "omega_d", "mm2/s", positive(),
                  "diffusivity of the workpiece");
  };
  const auto zone = [&](auto& f) {
    formation(f);
    f.optional(&CuttingZone::relief_deg, "alpha", "alpha", "deg", open(-90, 90), "relief angle")
        .optional(&CuttingZone::preheating, "c", "c", "1", non_negative(),
                  "preheating by the previous revolution")
        .optional(&CuttingZone::work_conductivity_w_mk, "lam_d", "lambda_d", "W/(m K)", positive(),
                  "conductivity of the workpiece")
        .optional(&CuttingZone::tool_conductivity_w_mk, "lam_u", "lambda_u", "W/(m K)", positive(),
                  "conductivity of the tool")
        .optional(&CuttingZone::tool_diffusivity_mm2_s, "om_u", "omega_u", "mm2/s", positive(),
                  "diffusivity of the tool")
        .optional(&CuttingZone::ambient_c, "ambient", "-", "degC", at_least(-273.15), "ambient temperature");
  };
  const auto temperatures = [](auto& f) {
    f.output(&CuttingTemperature::rake_c, "theta_rake", "Theta_1", "degC", any(),
             "mean temperature of the rake")
        .output(&CuttingTemperature::flank_c, "theta_flank", "Theta_2", "degC", any(),
                "mean temperature of the flank, ambient when there is no wear")
        .output(&CuttingTemperature::mean_c, "theta_mean", "Theta", "degC", any(),
                "mean of both, weighted by their lengths")
        .output(&CuttingTemperature::rake_flux_w_mm2, "q1", "q_1", "W/mm2", any(), "flux into the rake")
        .output(&CuttingTemperature::flank_flux_w_mm2, "q2", "q_2", "W/mm2", any(), "flux into the flank")
        .output(&CuttingTemperature::m, "m", "m", "1", closed(0, 1), "share of the steady influence reached")
        .note("Defaults: steel 45 cut by T5K10. Valid for 20-250 m/min in steel; distrust above 1200 degC.")
        .note("The mean falls with wear because the cooler flank weighs more: for wear use theta_rake.");
  };
  const auto models = [](auto& f) {
    f.optional(&ContinuousCut::m_model, "m_model", "-", "-", no_range(), "warm-up: exact or eq. (1)")
        .optional(&ContinuousCut::wedge, "wedge", "-", "-", no_range(),
                  "wedge functions: exact or eq. (5), (6)")
        .optional(&ContinuousCut::fo_scale, "fo_scale", "-", "1", positive(), "multiplies Fo");
  };

  source
      .function<&m_fo_paper>("m_fo_paper", "Share of the steady rise at a dimensionless time.", "eq. (1)",
                             Provenance::paper)
      .input(&FourierNumber::fo, "fo", "Fo", "1", any(), "Fourier number", 150.0)
      .output(&WarmUp::m, "m", "m", "1", closed(0, 1), "share of the steady rise")
      .note("Starts linearly; conduction starts as sqrt(Fo). Use m_fo_exact for prediction.");
  source
      .function<&wedge_functions>("wedge_functions", "Influence functions of the cutting wedge.",
                                  "eq. (5), (6); exact: images", Provenance::repaired)
      .input(&WedgeContact::width_mm, "b", "b", "mm", positive(), "width along the edge", 2.0)
      .input(&WedgeContact::rake_length_mm, "l", "l", "mm", positive(), "contact length on the rake", 1.0)
      .input(&WedgeContact::flank_length_mm, "h", "h", "mm", non_negative(), "contact length on the flank",
             0.1)
      .input(&WedgeContact::wedge_deg, "beta", "beta", "deg", closed(30, 120), "wedge angle (good for 50-95)",
             80.0)
      .input(&WedgeContact::model, "model", "-", "-", no_range(), "exact or paper", "exact")
      .output(&WedgeFunctions::m1, "m1", "M_1", "1", positive(), "rake on itself")
      .output(&WedgeFunctions::m2, "m2", "M_2", "1", non_negative(), "flank on itself, 0 without wear")
      .output(&WedgeFunctions::n1, "n1", "N_1", "1", non_negative(), "rake on the flank")
      .output(&WedgeFunctions::n2, "n2", "N_2", "1", non_negative(), "flank on the rake")
      .note("\"paper\" is good to 6 % for b/l = 2..5 and unusable above 10; prefer \"exact\".");
  source
      .function<&chip_side_coefficients>("chip_side_coefficients",
                                         "Temperatures and thermal resistances of the chip and work side.",
                                         "K1..K4 under eq. (2)", Provenance::repaired)
      .input(&ChipSide::cutting_speed_m_min, "v", "V", "m/min", positive(), "cutting speed", 80.0)
      .input(&ChipSide::chip_compression, "k", "k", "1", closed(1.2, 5), "chip compression ratio", 2.0)
      .input(&ChipSide::rake_length_mm, "l", "l", "mm", positive(), "contact length on the rake", 1.0)
      .input(&ChipSide::flank_length_mm, "h", "h", "mm", non_negative(), "width of the flank wear land", 0.1)
      .input(&ChipSide::m, "m", "m", "1", closed(0, 1), "warm-up", 0.5)
      .input(&ChipSide::m1, "m1", "M_1", "1", non_negative(), "influence function of the rake", 0.75)
      .input(&ChipSide::shear_flux_w_mm2, "q_d", "q_d", "W/mm2", non_negative(), "heat of the shear zone",
             1300.0)
      .input(&ChipSide::rake_flux_w_mm2, "q_1t", "q_1T", "W/mm2", non_negative(), "friction on the rake",
             290.0)
      .input(&ChipSide::flank_flux_w_mm2, "q_2t", "q_2T", "W/mm2", non_negative(), "friction on the flank",
             333.0)
      .input(&ChipSide::chip_share, "b_chip", "b'", "1", closed(0, 1), "share of shear heat in the chip",
             0.92)
      .input(&ChipSide::flank_temperature_share, "t_d", "T_d", "1", closed(0, 1),
             "dimensionless temperature of the work under the flank", 0.43)
      .input(&ChipSide::preheating, "c", "c", "1", non_negative(), "preheating by the previous revolution",
             0.1)
      .input(&ChipSide::work_conductivity_w_mk, "lam_d", "lambda_d", "W/(m K)", positive(),
             "conductivity of the workpiece", 40.0)
      .input(&ChipSide::work_diffusivity_mm2_s, "om_d", "omega_d", "mm2/s", positive(),
             "diffusivity of the workpiece", 8.0)
      .input(&ChipSide::tool_conductivity_w_mk, "lam_u", "lambda_u", "W/(m K)", positive(),
             "conductivity of the tool", 37.7)
      .output(&ChipSideCoefficients::k1_k, "k1", "K_1", "K", non_negative(),
              "rise of the rake with no heat entering the tool")
      .output(&ChipSideCoefficients::k2_k, "k2", "K_2", "K", non_negative(),
              "rise of the flank with no heat entering the tool")
      .output(&ChipSideCoefficients::k3_m2k_w, "k3", "K_3", "m2 K/W", non_negative(),
              "resistance of the work side")
      .output(&ChipSideCoefficients::k4_m2k_w, "k4", "K_4", "m2 K/W", positive(),
              "resistance of chip and tool at the rake");
  source
      .function<&heat_fluxes>("heat_fluxes", "Heat fluxes into the tool through rake and flank.", "eq. (2)",
                              Provenance::repaired)
      .input(&HeatBalance::k1_k, "k1", "K_1", "K", any(), "rise of the rake with no heat entering", 1006.0)
      .input(&HeatBalance::k2_k, "k2", "K_2", "K", any(), "rise of the flank with no heat entering", 282.0)
      .input(&HeatBalance::k3_m2k_w, "k3", "K_3", "m2 K/W", non_negative(), "resistance of the work side",
             6.1e-7)
      .input(&HeatBalance::k4_m2k_w, "k4", "K_4", "m2 K/W", positive(), "resistance of chip and tool", 1.3e-5)
      .input(&HeatBalance::rake_length_mm, "l", "l", "mm", positive(), "contact length on the rake", 1.0)
      .input(&HeatBalance::flank_length_mm, "h", "h", "mm", non_negative(), "width of the flank wear land",
             0.1)
      .input(&HeatBalance::m, "m", "m", "1", closed(0, 1), "warm-up", 0.5)
      .input(&HeatBalance::m2, "m2", "M_2", "1", non_negative(), "influence of the flank on itself", 2.1)
      .input(&HeatBalance::n1, "n1", "N_1", "1", non_negative(), "influence of the rake on the flank", 0.8)
      .input(&HeatBalance::n2, "n2", "N_2", "1", non_negative(), "influence of the flank on the rake", 0.8)
      .input(&HeatBalance::tool_conductivity_w_mk, "lam_u", "lambda_u", "W/(m K)", positive(),
             "conductivity of the tool", 37.7)
      .output(&HeatFluxes::rake_w_mm2, "q1", "q_1", "W/mm2", any(), "flux into the rake")
      .output(&HeatFluxes::flank_w_mm2, "q2", "q_2", "W/mm2", any(),
              "flux into the flank, negative = out of it");
  source
      .function<&contact_temperatures>("contact_temperatures", "Mean temperature rises of rake and flank.",
                                       "eq. (3), (4)", Provenance::paper)
      .input(&HeatedContact::rake_flux_w_mm2, "q1", "q_1", "W/mm2", any(), "flux into the rake", 98.0)
      .input(&HeatedContact::flank_flux_w_mm2, "q2", "q_2", "W/mm2", any(), "flux into the flank", -223.0)
      .input(&HeatedContact::rake_length_mm, "l", "l", "mm", positive(), "contact length on the rake", 1.0)
      .input(&HeatedContact::flank_length_mm, "h", "h", "mm", non_negative(), "width of the flank wear land",
             0.1)
      .input(&HeatedContact::m, "m", "m", "1", closed(0, 1), "warm-up", 0.5)
      .input(&HeatedContact::m1, "m1", "M_1", "1", non_negative(), "influence of the rake on itself", 0.75)
      .input(&HeatedContact::m2, "m2", "M_2", "1", non_negative(), "influence of the flank on itself", 2.1)
      .input(&HeatedContact::n1, "n1", "N_1", "1", non_negative(), "influence of the rake on the flank", 0.8)
      .input(&HeatedContact::n2, "n2", "N_2", "1", non_negative(), "influence of the flank on the rake", 0.8)
      .input(&HeatedContact::tool_conductivity_w_mk, "lam_u", "lambda_u", "W/(m K)", positive(),
             "conductivity of the tool", 37.7)
      .output(&ContactTemperatures::rake, "theta_rake", "Theta_1", "K", any(), "rise of the rake")
      .output(&ContactTemperatures::flank, "theta_flank", "Theta_2", "K", any(),
              "rise of the flank, 0 without wear")
      .output(&ContactTemperatures::mean, "theta_mean", "Theta", "K", any(), "mean rise");
  source
      .function<&heat_sources>("heat_sources", "Forces, contact lengths and heat sources of a cut.",
                               "completion (C1)-(C3)", Provenance::completion)
      .with(regime)
      .with(formation)
      .output(&HeatSources::cutting_force_n, "p_z", "P_z", "N", positive(), "cutting force")
      .output(&HeatSources::rake_friction_n, "rake_friction", "F", "N", non_negative(),
              "friction force on the rake")
      .output(&HeatSources::chip_thickness_mm, "a", "a", "mm", positive(), "uncut chip thickness")
      .output(&HeatSources::chip_width_mm, "b", "b", "mm", positive(), "width of cut along the edge")
      .output(&HeatSources::rake_length_mm, "l", "l", "mm", positive(), "contact length on the rake")
      .output(&HeatSources::shear_angle_deg, "phi", "phi", "deg", closed(0, 90), "shear angle")
      .output(&HeatSources::shear_flux_w_mm2, "q_d", "q_d", "W/mm2", non_negative(), "heat of the shear zone")
      .output(&HeatSources::rake_flux_w_mm2, "q_1t", "q_1T", "W/mm2", non_negative(),
              "friction heat on the rake")
      .output(&HeatSources::flank_flux_w_mm2, "q_2t", "q_2T", "W/mm2", non_negative(),
              "friction heat on the flank")
      .output(&HeatSources::chip_share, "b_chip", "b'", "1", closed(0, 1), "share of shear heat in the chip")
      .output(&HeatSources::flank_temperature_share, "t_d", "T_d", "1", closed(0, 1),
              "dimensionless temperature of the work under the flank")
      .note(
          "The temperature level depends mostly on kc11, k and thrust_ratio: calibrate thrust_ratio by one "
          "measured temperature.");
  source
      .function<&m_fo_exact>("m_fo_exact", "Exact share of the steady rise at a dimensionless time.",
                             "completion (C6)", Provenance::completion)
      .input(&WedgeFourier::fo, "fo", "Fo", "1", any(), "Fourier number", 5.0)
      .input(&WedgeFourier::eta, "eta", "eta", "1", closed(0.2, 50), "width over contact length", 2.0)
      .output(&WarmUp::m, "m", "m", "1", closed(0, 1), "share of the steady rise");
  source
      .function<&m_periodic>("m_periodic",
                             "Share of the steady rise at the end of a contact, periodic state.",
                             "completion (C7)", Provenance::completion)
      .input(&PeriodicContact::fo_cut, "fo_cut", "Fo_c", "1", non_negative(), "Fourier number of a contact",
             0.5)
      .input(&PeriodicContact::fo_period, "fo_period", "Fo_p", "1", positive(),
             "Fourier number of the period", 2.0)
      .input(&PeriodicContact::eta, "eta", "eta", "1", closed(0.2, 50), "width over contact length", 2.0)
      .output(&WarmUp::m, "m", "m", "1", closed(0, 1), "share of the steady rise");
  source
      .function<&cutting_temperature>("cutting_temperature",
                                      "Temperatures of rake and flank in a continuous cut.",
                                      "eq. (2)-(4) with completions", Provenance::completion)
      .with(regime)
      .input(&ContinuousCut::time_s, "time", "tau", "s", any(), "time from the start, negative: steady", 4.0)
      .with(models)
      .with(zone)
      .with(temperatures);
  source
      .function<&interrupted_cutting_temperature>("interrupted_cutting_temperature",
                                                  "Peak temperatures of an interrupted cut.",
                                                  "eq. (2)-(4) with completions", Provenance::completion)
      .with(regime)
      .input(&InterruptedCut::contact_s, "t_cut", "t_c", "s", non_negative(), "time of a contact", 0.01)
      .input(&InterruptedCut::period_s, "t_period", "t_p", "s", positive(), "period of the contacts", 0.05)
      .with(zone)
      .with(temperatures);
  source
      .function<&settling_time>("settling_time", "Time until the mean temperature has settled.", "completion",
                                Provenance::completion)
      .with(regime)
      .optional(&Settling::fraction, "fraction", "-", "1", open(0, 1), "fraction of the steady rise")
      .optional(&Settling::m_model, "m_model", "-", "-", no_range(), "warm-up: exact or eq. (1)")
      .optional(&Settling::wedge, "wedge", "-", "-", no_range(), "wedge functions: exact or eq. (5), (6)")
      .optional(&Settling::fo_scale, "fo_scale", "-", "1", positive(), "multiplies Fo")
      .with(zone)
      .output(&SettlingTime::time_s, "time", "tau", "s", positive(), "time")
      .note(
          "Measured 4 s lie between the warm-up of the wedge (exact 0.07 s) and the slow heating of insert "
          "and "
          "holder, which the model does not hold.");
  source
      .function<&speed_for_temperature>("speed_for_temperature",
                                        "Largest cutting speed under a limit of the mean temperature.",
                                        "completion", Provenance::completion)
      .input(&TemperatureLimit::limit_c, "theta_limit", "Theta_lim", "degC", at_least(-273.15),
             "limit of the steady mean temperature", 850.0)
      .with(conditions)
      .with(zone)
      .output(&SpeedLimit::feasible, "feasible", "-", "-", no_range(), "10 m/min keeps the limit")
      .output(&SpeedLimit::speed_m_min, "v_max", "v", "m/min", closed(0, 600),
              "largest speed in 10..600, 0 when infeasible");
}

}  // namespace verstat::models::k403
