#include "models/grinding/k302_combined_grinding_roughness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "models/math/arithmetic_power_sum.h"
#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::models::k302 {
namespace {

constexpr double um_mm = 1000;

double gamma(double x) {
  return boost::math::tgamma(x, MathPolicy());
}

// (V_K +- V_u) / V_u; plus when wheel and work run against each other.
double speed_ratio(double wheel_speed_m_s, double work_speed_m_min, bool up_grinding) {
  const double work_speed_m_s = work_speed_m_min / 60;
  require(up_grinding || work_speed_m_s < wheel_speed_m_s, "work_speed_m_min", work_speed_m_min,
          "must stay below the wheel speed in down grinding");
  return (wheel_speed_m_s + (up_grinding ? work_speed_m_s : -work_speed_m_s)) / work_speed_m_s;
}

// S_p(u) of eq. (4), u in mm: the last contact, n - 1 older ones each shifted by Q, and the spark-out
// contacts.
double reach_sum(const MarkField& in, double u_mm, double p) {
  if (!(u_mm > 0)) return 0;
  return static_cast<double>(in.sparkout_contacts) * std::pow(u_mm, p) +
         arithmetic_power_sum(u_mm, in.shift_um / um_mm, in.contacts, p);
}

// Height u (mm) above the deepest reach with G S_nu(u) = level. S grows with u, and one contact alone reaches
// the level at (level / G)^(1/nu), so the root is not above that.
double depth_at(const MarkField& in, double level) {
  const double single_mm = std::pow(level / in.g_per_mm_nu, 1 / in.nu);
  const double share = static_cast<double>(in.contacts) + static_cast<double>(in.sparkout_contacts);
  if (in.shift_um == 0 || share == 1) return single_mm * std::pow(share, -1 / in.nu);
  return find_root([&](double u) { return in.g_per_mm_nu * reach_sum(in, u, in.nu) - level; }, 0,
                   single_mm * (1 + 1e-9));
}

// Gauss quadrature in equal panels. Where an older contact sets in, S is only as smooth as u^nu, so many low
// panels serve better than one high rule.
template <class F>
double integrate_panels(const F& f, double high, int panels) {
  double sum = 0;
  for (int k = 0; k < panels; ++k)
    sum += boost::math::quadrature::gauss<double, 15, MathPolicy>::integrate(f, high * k / panels,
                                                                             high * (k + 1) / panels);
  return sum;
}

// sum over the five highest of the mean positions of Poisson events: Gamma(i + 1/alpha) / (i-1)!
double five_order_statistics(double inverse_alpha) {
  double sum = 0;
  double factorial = 1;
  for (int i = 1; i <= 5; ++i) {
    sum += gamma(i + inverse_alpha) / factorial;
    factorial *= i;
  }
  return sum;
}

}  // namespace

MarkIntensity abrasive_mark_intensity(const MarkGeometry& in) {
  return guarded<&abrasive_mark_intensity>(in, [&] {
    const double m = in.profile_exponent;
    const double chi = in.tip_exponent;
    const double tips = gamma(chi + 1) *
                        speed_ratio(in.wheel_speed_m_s, in.work_speed_m_min, in.up_grinding) *
                        in.grains_per_mm2 * std::sqrt(std::numbers::pi * in.wheel_diameter_mm) /
                        std::pow(in.wheel_layer_mm, chi);
    return MarkIntensity{.nu = m + chi + 0.5,
                         .g_per_mm_nu = gamma(m + 1) * in.chip_coefficient * in.width_coefficient * tips /
                                        gamma(m + chi + 1.5),
                         .theta = tips / gamma(chi + 1.5)};
  });
}

MedianDepth median_depth(const MarkField& in) {
  return guarded<&median_depth>(in, [&] { return MedianDepth{um_mm * depth_at(in, std::numbers::ln2)}; });
}

RoughnessRa roughness_ra(const MarkFieldAtDepth& in) {
  return guarded<&roughness_ra>(in, [&] {
    const double marks = in.g_per_mm_nu * in.nu * reach_sum(in, in.median_depth_um / um_mm, in.nu - 1);
    return RoughnessRa{um_mm * 2 / (std::numbers::pi * marks)};
  });
}

LevelRemoval profile_distribution(const LevelInProfile& in) {
  return guarded<&profile_distribution>(in, [&] {
    const double u_mm = (in.median_depth_um + in.height_um) / um_mm;
    if (u_mm <= 0) return LevelRemoval{0, 0};
    const double marks = in.g_per_mm_nu * reach_sum(in, u_mm, in.nu);
    return LevelRemoval{-std::expm1(-marks),
                        in.nu * in.g_per_mm_nu * reach_sum(in, u_mm, in.nu - 1) * std::exp(-marks) / um_mm};
  });
}

ExactRoughness roughness_ra_exact(const MarkField& in) {
  return guarded<&roughness_ra_exact>(in, [&] {
    const auto left = [&](double u) { return std::exp(-in.g_per_mm_nu * reach_sum(in, u, in.nu)); };
    const double top_mm = depth_at(in, 40);  // e^-40 of the material is left above
    const double mean_mm = integrate_panels(left, top_mm, 160);
    const double square_mm2 = integrate_panels([&](double u) { return 2 * u * left(u); }, top_mm, 160);
    const double ra_mm = 2 * integrate_panels([&](double u) { return 1 - left(u); }, mean_mm, 80);
    return ExactRoughness{um_mm * ra_mm, um_mm * std::sqrt(std::max(0.0, square_mm2 - mean_mm * mean_mm)),
                          um_mm * mean_mm};
  });
}

SteadyLayerHeight layer_height_steady(const SteadyLayer& in) {
  return guarded<&layer_height_steady>(in, [&] {
    const double height_um = um_mm * depth_at(in, -std::log1p(-in.beta));
    return SteadyLayerHeight{height_um, height_um + in.shift_um};
  });
}

LayerHeight roughness_layer(const LayerRemoval& in) {
  return guarded<&roughness_layer>(in, [&] {
    const double mechanical_um = in.actual_depth_um - in.mechanical_removal_um;
    return LayerHeight{mechanical_um,
                       std::max(0.0, mechanical_um - (in.dissolved_peak_um - in.dissolved_valley_um))};
  });
}

RoughnessRa combined_ra(const Flattening& in) {
  return guarded<&combined_ra>(in, [&] {
    const double flattened = (in.dissolved_peak_um - in.dissolved_valley_um) / in.mechanical_height_um;
    return RoughnessRa{in.ra_mechanical_um * std::max(0.0, 1 - flattened)};
  });
}

ExtremeRoughness roughness_extremes(const ProfileExtremes& in) {
  return guarded<&roughness_extremes>(in, [&] {
    const double inverse_alpha = 1 / (in.tip_exponent + 0.5);
    const double unit_um = um_mm * std::pow(in.theta * in.base_length_mm, -inverse_alpha);
    return ExtremeRoughness{in.layer_height_um - 2 * gamma(1 + inverse_alpha) * unit_um,
                            in.layer_height_um - 0.4 * five_order_statistics(inverse_alpha) * unit_um};
  });
}

ExtremeRoughness roughness_extremes_chi15(const ProfileExtremesChi15& in) {
  return guarded<&roughness_extremes_chi15>(in, [&] {
    const double depth_mm = in.actual_depth_um / um_mm;
    const double unit_um =
        um_mm *
        std::sqrt(depth_mm * std::sqrt(depth_mm) /
                  (in.grains_per_mm2 * speed_ratio(in.wheel_speed_m_s, in.work_speed_m_min, in.up_grinding) *
                   std::sqrt(in.wheel_diameter_mm) * in.base_length_mm));
    return ExtremeRoughness{in.layer_height_um - 2 * std::sqrt(2.0 / 3) * unit_um,
                            in.layer_height_um - 2.948 * unit_um};
  });
}

ExtremeCoefficients extreme_height_coefficients(const TipExponent& in) {
  return guarded<&extreme_height_coefficients>(in, [&] {
    const double chi = in.tip_exponent;
    const double inverse_alpha = 1 / (chi + 0.5);
    const double k =
        std::pow(boost::math::tgamma_ratio(chi + 1.5, chi + 1, MathPolicy()) * std::numbers::inv_sqrtpi,
                 inverse_alpha);
    return ExtremeCoefficients{2 * gamma(1 + inverse_alpha) * k,
                               0.4 * five_order_statistics(inverse_alpha) * k};
  });
}

DissolvedDepth electrochemical_removal(const Dissolution& in) {
  return guarded<&electrochemical_removal>(in, [&] {
    // um of depth times um of gap: 1e-3 S/mm per S/m, 60 s in a minute, 1e6 um2 in a mm2.
    const double depth_gap_um2 = in.efficiency * in.volume_equivalent_mm3_a_min * in.conductivity_s_m * 1e-3 *
                                 in.voltage_v * in.exposure_s / 60 * 1e6;
    return DissolvedDepth{depth_gap_um2 / in.peak_gap_um,
                          depth_gap_um2 / (in.peak_gap_um + in.layer_height_um)};
  });
}

DefectFromWork defect_depth_specific_work(const HeatSource& in) {
  return guarded<&defect_depth_specific_work>(in, [&] {
    const double exposure_s = in.half_width_mm / (in.source_speed_m_min * 1000 / 60);
    return DefectFromWork{
        in.alpha_um_mm2_j * in.xi * std::max(0.0, in.flux_w_mm2 - in.threshold_flux_w_mm2) * exposure_s,
        in.flux_w_mm2 * exposure_s / in.heat_share};
  });
}

DefectFromTemperature defect_depth_temperature(const SurfaceHeating& in) {
  return guarded<&defect_depth_temperature>(in, [&] {
    require(in.transform_c > in.ambient_c, "transform_temp_c", in.transform_c, "must be above ambient_c");
    if (in.surface_c <= in.transform_c) return DefectFromTemperature{0, 0};
    const double surface_k = in.surface_c - in.ambient_c;  // rises above ambient
    const double transform_k = in.transform_c - in.ambient_c;
    const double diffusion_um = um_mm * 2 * std::sqrt(in.diffusivity_mm2_s * in.source_time_s);
    const double excess_k = in.surface_c - in.transform_c;
    return DefectFromTemperature{
        diffusion_um * std::sqrt(excess_k / surface_k * std::log1p(excess_k / (2 * transform_k))),
        diffusion_um * boost::math::erfc_inv(transform_k / surface_k, MathPolicy())};
  });
}

DefectDepth defect_depth_after_pass(const DefectBeforePass& in) {
  return guarded<&defect_depth_after_pass>(in, [&] {
    return DefectDepth{std::max({0.0, in.previous_um - in.removed_um, in.introduced_um})};
  });
}

PassCount passes_to_reach_defect(const DefectTarget& in) {
  return guarded<&passes_to_reach_defect>(in, [&] {
    if (in.initial_um <= in.target_um) return PassCount{0};
    if (in.introduced_um > in.target_um || in.removed_um == 0) return PassCount{-1};
    const double passes = std::ceil((in.initial_um - in.target_um) / in.removed_um - 1e-9);
    require(passes < 1e15, "removed_um", in.removed_um, "asks for more than 1e15 passes");
    return PassCount{static_cast<std::int64_t>(passes)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K302",
       .title = "Prediction of surface quality when combined grinding",
       .authors = "Bratan S. M., Revenko D. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Flat grinding, optionally with electrochemical dissolution in the zone: grooves of many grains "
           "overlap at random, so every level of the surface has a probability of having been removed. From "
           "it follow the roughness layer, Ra, Rmax and Rz; two formulas give the depth of the heat-affected "
           "layer and a recursion follows it from pass to pass.",
       .role = "grinding",
       .errata = {
           "Eqs. (4), (6), (7), (9) print the sum from i = 1; the last contact reaches the deepest level and "
           "enters with i = 0. A contact that ends below the level contributes nothing.",
           "Eq. (4) prints F = P(M) without the exponential that follows from its density.",
           "Eqs. (9), (10) hold G fixed while electrochemistry lowers H, so that Ra rises; eq. (10) also has "
           "0.399 for 3/8 and lost a factor 1/2. Not implemented: eqs. (6), (7) for the mechanical profile "
           "and "
           "completion C2 for the flattening stand instead.",
           "Eqs. (11), (12) print Q/l for 1/(Theta l); eq. (13) prints sqrt(D l) for sqrt(D) l; the constant "
           "of eq. (14) is 2.94704, printed 2.948.",
           "Eq. (15) prints the wheel speed; the source moves over the part with the work speed.",
           "Eq. (16) prints ln((T - T_tr)/(2 T_tr)), negative for every real grinding temperature; the plus "
           "sign makes it zero at T = T_tr and close to the exact solution."}});

  const auto field = [](auto& f) {
    f.input(&MarkField::g_per_mm_nu, "g", "G", "mm^-nu", positive(), "intensity of abrasive marks", 1.76281e6)
        .input(&MarkField::nu, "nu", "nu", "1", positive(), "exponent m + chi + 1/2", 2.5)
        .input(&MarkField::shift_um, "shift_um", "Q", "um", non_negative(),
               "displacement of the surface per contact", 0.5)
        .input(&MarkField::contacts, "contacts", "n", "1", at_least(1),
               "contacts of the surface with the wheel", 1000)
        .optional(&MarkField::sparkout_contacts, "sparkout_contacts", "n_0", "1", non_negative(),
                  "further contacts without displacement");
  };
  const auto depth = [](auto& f) {
    f.input(&MarkFieldAtDepth::median_depth_um, "w_m_um", "W_m", "um", positive(),
            "distance from the deepest valley to the mean line", 2.17);
  };
  const auto removal = [](auto& f) {
    f.input(&DefectTarget::removed_um, "removed_um", "Delta h", "um", non_negative(),
            "stock removed in the pass", 15.0)
        .input(&DefectTarget::introduced_um, "introduced_um", "h_intr", "um", non_negative(),
               "defect layer the pass itself brings", 10.0);
  };
  const std::string thin =
      "May be negative when the layer is too thin for the order statistics: not applicable.";

  source
      .function<&abrasive_mark_intensity>("abrasive_mark_intensity",
                                          "Intensity of abrasive marks and of grain tips.",
                                          "text of eqs. (4) and (12)", Provenance::paper)
      .input(&MarkGeometry::profile_exponent, "profile_exp", "m", "1", non_negative(),
             "exponent of the groove width b = C_B t^m: 0.5 rounded tip, 1 cone", 0.5)
      .input(&MarkGeometry::tip_exponent, "tip_exp", "chi", "1", positive(), "exponent of the tip-depth law",
             1.5)
      .input(&MarkGeometry::chip_coefficient, "chip_coefficient", "K_C", "1", open_low(0, 1),
             "share of a groove that leaves as chip", 0.9)
      .input(&MarkGeometry::width_coefficient, "width_coefficient", "C_B", "mm^(1-m)", positive(),
             "coefficient of the groove width", 0.283)
      .input(&MarkGeometry::grains_per_mm2, "grains_per_mm2", "n_3", "1/mm2", positive(),
             "grains per area within the wheel layer", 20.0)
      .input(&MarkGeometry::wheel_speed_m_s, "wheel_speed_m_s", "V_K", "m/s", positive(), "wheel speed", 30.0)
      .input(&MarkGeometry::work_speed_m_min, "work_speed_m_min", "V_u", "m/min", positive(), "work speed",
             10.0)
      .input(&MarkGeometry::up_grinding, "up_grinding", "-", "-", no_range(),
             "wheel and work run against each other", true)
      .input(&MarkGeometry::wheel_diameter_mm, "wheel_diameter_mm", "D", "mm", positive(),
             "equivalent wheel diameter", 250.0)
      .input(&MarkGeometry::wheel_layer_mm, "wheel_layer_mm", "H_u", "mm", positive(),
             "depth of the wheel layer that holds the tips", 0.03)
      .output(&MarkIntensity::nu, "nu", "nu", "1", above(0.5), "exponent of the removal probability")
      .output(&MarkIntensity::g_per_mm_nu, "g", "G", "mm^-nu", non_negative(), "intensity of abrasive marks")
      .output(&MarkIntensity::theta, "theta", "Theta", "mm^-(chi+3/2)", non_negative(),
              "intensity of tips per length")
      .note("Valid while the depth stays within the wheel layer.");
  source
      .function<&median_depth>("median_depth", "Distance from the deepest valley to the mean line.",
                               "eq. (7)", Provenance::repaired)
      .with(field)
      .output(&MedianDepth::median_depth_um, "w_m_um", "W_m", "um", non_negative(), "median depth")
      .note("Sum from i = 0; spark-out contacts are a completion.");
  source
      .function<&roughness_ra>("roughness_ra", "Ra of the mechanical profile taken as normal.", "eq. (6)",
                               Provenance::repaired)
      .with(field)
      .with(depth)
      .output(&RoughnessRa::ra_um, "ra_um", "Ra", "um", non_negative(), "roughness")
      .note(
          "With W_m from eq. (7) 0.6-5 % above the exact Ra; with half the layer (eq. 8) up to several "
          "times.");
  source
      .function<&profile_distribution>("profile_distribution", "Probability that a level has been removed.",
                                       "eq. (4)", Provenance::repaired)
      .with(field)
      .with(depth)
      .input(&LevelInProfile::height_um, "y_um", "y", "um", any(), "height above the mean line, + outwards",
             0.5)
      .output(&LevelRemoval::probability_removed, "prob_removed", "F", "1", probability(),
              "probability that the level is removed")
      .output(&LevelRemoval::density_per_um, "density_per_um", "f", "1/um", non_negative(),
              "density of the profile height");
  source
      .function<&roughness_ra_exact>("roughness_ra_exact", "Ra, Rq and mean depth without normality.",
                                     "definition, eq. (4)", Provenance::completion)
      .with(field)
      .output(&ExactRoughness::ra_um, "ra_um", "Ra", "um", non_negative(), "mean deviation")
      .output(&ExactRoughness::rq_um, "rq_um", "Rq", "um", non_negative(), "root mean square deviation")
      .output(&ExactRoughness::mean_depth_um, "mean_depth_um", "mu", "um", non_negative(),
              "mean height above the deepest reach");
  source
      .function<&layer_height_steady>("layer_height_steady", "Height of the roughness layer in steady work.",
                                      "completion C1", Provenance::completion)
      .with(field)
      .optional(&SteadyLayer::beta, "beta", "beta", "1", open(0, 1),
                "removal probability that bounds the layer")
      .output(&SteadyLayerHeight::mechanical_height_um, "h_mech_um", "H_mech", "um", non_negative(),
              "height of the layer")
      .output(&SteadyLayerHeight::actual_depth_um, "actual_depth_um", "t_f", "um", non_negative(),
              "actual depth, H + Q");
  source
      .function<&roughness_layer>("roughness_layer", "Height of the roughness layer from depth and removal.",
                                  "eqs. (1), (2)", Provenance::paper)
      .input(&LayerRemoval::actual_depth_um, "actual_depth_um", "t_f", "um", non_negative(), "actual depth",
             8.0)
      .input(&LayerRemoval::mechanical_removal_um, "mech_removal_um", "Q_mech", "um", non_negative(),
             "mechanical removal", 3.0)
      .input(&LayerRemoval::dissolved_peak_um, "ec_peak_um", "Q_ec,peak", "um", non_negative(),
             "dissolved at the peaks", 1.5)
      .input(&LayerRemoval::dissolved_valley_um, "ec_valley_um", "Q_ec,valley", "um", non_negative(),
             "dissolved in the valleys", 0.6)
      .output(&LayerHeight::mechanical_height_um, "h_mech_um", "H_mech", "um", any(),
              "layer left by grinding; negative when more is removed than the depth")
      .output(&LayerHeight::layer_height_um, "h_layer_um", "H", "um", non_negative(),
              "layer after dissolution");
  source
      .function<&combined_ra>("combined_ra", "Ra after electrochemical flattening.", "completion C2",
                              Provenance::completion)
      .input(&Flattening::ra_mechanical_um, "ra_mech_um", "Ra_mech", "um", non_negative(),
             "Ra of the mechanical profile", 1.0)
      .input(&Flattening::mechanical_height_um, "h_mech_um", "H_mech", "um", positive(),
             "height of the mechanical layer", 5.0)
      .input(&Flattening::dissolved_peak_um, "ec_peak_um", "Q_ec,peak", "um", non_negative(),
             "dissolved at the peaks", 1.5)
      .input(&Flattening::dissolved_valley_um, "ec_valley_um", "Q_ec,valley", "um", non_negative(),
             "dissolved in the valleys", 0.5)
      .output(&RoughnessRa::ra_um, "ra_um", "Ra", "um", non_negative(), "roughness")
      .note("Replaces eqs. (9), (10), which raise Ra when dissolution lowers the layer.");
  source
      .function<&roughness_extremes>("roughness_extremes", "Expected Rmax and Rz over the base length.",
                                     "eqs. (11), (12)", Provenance::repaired)
      .input(&ProfileExtremes::layer_height_um, "h_layer_um", "H", "um", non_negative(), "layer height", 6.0)
      .input(&ProfileExtremes::theta, "theta", "Theta", "mm^-(chi+3/2)", positive(),
             "intensity of tips per length", 1.3e7)
      .input(&ProfileExtremes::tip_exponent, "tip_exp", "chi", "1", positive(),
             "exponent of the tip-depth law", 1.5)
      .input(&ProfileExtremes::base_length_mm, "base_length_mm", "l", "mm", positive(), "base length", 0.8)
      .output(&ExtremeRoughness::rmax_um, "rmax_um", "R_max", "um", any(), "largest height")
      .output(&ExtremeRoughness::rz_um, "rz_um", "R_z", "um", any(), "ten-point height")
      .note(thin);
  source
      .function<&roughness_extremes_chi15>("roughness_extremes_chi15",
                                           "Rmax and Rz for chi = 1.5 and a wheel layer as deep as the cut.",
                                           "eqs. (13), (14)", Provenance::repaired)
      .input(&ProfileExtremesChi15::layer_height_um, "h_layer_um", "H", "um", non_negative(), "layer height",
             6.0)
      .input(&ProfileExtremesChi15::actual_depth_um, "actual_depth_um", "t_f", "um", non_negative(),
             "actual depth", 8.0)
      .input(&ProfileExtremesChi15::grains_per_mm2, "grains_per_mm2", "n_3", "1/mm2", positive(),
             "grains per area", 20.0)
      .input(&ProfileExtremesChi15::wheel_speed_m_s, "wheel_speed_m_s", "V_K", "m/s", positive(),
             "wheel speed", 30.0)
      .input(&ProfileExtremesChi15::work_speed_m_min, "work_speed_m_min", "V_u", "m/min", positive(),
             "work speed", 10.0)
      .input(&ProfileExtremesChi15::up_grinding, "up_grinding", "-", "-", no_range(),
             "wheel and work run against each other", true)
      .input(&ProfileExtremesChi15::wheel_diameter_mm, "wheel_diameter_mm", "D", "mm", positive(),
             "equivalent wheel diameter", 250.0)
      .input(&ProfileExtremesChi15::base_length_mm, "base_length_mm", "l", "mm", positive(), "base length",
             0.8)
      .output(&ExtremeRoughness::rmax_um, "rmax_um", "R_max", "um", any(), "largest height")
      .output(&ExtremeRoughness::rz_um, "rz_um", "R_z", "um", any(), "ten-point height")
      .note(thin)
      .note("Constant 2.948 of Rz as printed; exactly 2.94704.");
  source
      .function<&extreme_height_coefficients>("extreme_height_coefficients",
                                              "Coefficients of Rmax and Rz for any tip exponent.",
                                              "eqs. (11)-(14)", Provenance::repaired)
      .input(&TipExponent::tip_exponent, "tip_exp", "chi", "1", positive(), "exponent of the tip-depth law",
             1.5)
      .output(&ExtremeCoefficients::rmax, "c_rmax", "c_Rmax", "1", positive(), "coefficient of Rmax")
      .output(&ExtremeCoefficients::rz, "c_rz", "c_Rz", "1", positive(), "coefficient of Rz");
  source
      .function<&electrochemical_removal>("electrochemical_removal",
                                          "Depth dissolved at peaks and valleys at a constant gap.",
                                          "completion C3 (Faraday)", Provenance::completion)
      .input(&Dissolution::volume_equivalent_mm3_a_min, "volume_equivalent_mm3_a_min", "k_v", "mm3/(A*min)",
             non_negative(), "volume dissolved per charge; iron 2.21", 2.21)
      .input(&Dissolution::efficiency, "efficiency", "eta", "1", non_negative(), "current efficiency", 0.8)
      .input(&Dissolution::conductivity_s_m, "conductivity_s_m", "kappa", "S/m", non_negative(),
             "conductivity of the electrolyte", 10.0)
      .input(&Dissolution::voltage_v, "voltage_v", "U", "V", non_negative(), "voltage net of over-potential",
             6.0)
      .input(&Dissolution::peak_gap_um, "peak_gap_um", "delta_peak", "um", positive(), "gap at the peaks",
             20.0)
      .input(&Dissolution::layer_height_um, "h_layer_um", "H_mech", "um", non_negative(),
             "height of the layer before dissolution", 5.0)
      .input(&Dissolution::exposure_s, "exposure_s", "t", "s", non_negative(), "time under current", 0.02)
      .output(&DissolvedDepth::peak_um, "ec_peak_um", "Q_ec,peak", "um", non_negative(), "dissolved at peaks")
      .output(&DissolvedDepth::valley_um, "ec_valley_um", "Q_ec,valley", "um", non_negative(),
              "dissolved in valleys")
      .note("The gap is taken as constant: for removal well below the gap.");
  source
      .function<&defect_depth_specific_work>("defect_depth_specific_work",
                                             "Depth of the defect layer from the heat per area.", "eq. (15)",
                                             Provenance::repaired)
      .input(&HeatSource::alpha_um_mm2_j, "alpha_um_mm2_j", "alpha", "um*mm2/J", non_negative(),
             "depth per heat", 20.0)
      .input(&HeatSource::xi, "xi", "xi", "1", non_negative(), "coefficient of the material", 1.0)
      .input(&HeatSource::flux_w_mm2, "q_w_mm2", "q", "W/mm2", non_negative(), "peak heat flux", 40.0)
      .input(&HeatSource::threshold_flux_w_mm2, "q0_w_mm2", "q_0", "W/mm2", non_negative(),
             "flux below which nothing changes", 15.0)
      .input(&HeatSource::half_width_mm, "half_width_mm", "h_q", "mm", positive(), "half-width of the source",
             1.5)
      .input(&HeatSource::source_speed_m_min, "source_speed_m_min", "V", "m/min", positive(),
             "speed of the source over the part: the work speed", 10.0)
      .input(&HeatSource::heat_share, "heat_share", "K", "1", open_low(0, 1),
             "share of the work that becomes heat of the part, 0.8-0.9", 0.85)
      .output(&DefectFromWork::depth_um, "depth_um", "h", "um", non_negative(), "depth of the defect layer")
      .output(&DefectFromWork::specific_work_j_mm2, "specific_work_j_mm2", "W", "J/mm2", non_negative(),
              "specific surface work")
      .note("A triangular source with the peak q; a uniform one brings twice the heat.");
  source
      .function<&defect_depth_temperature>("defect_depth_temperature",
                                           "Depth of the defect layer from the surface temperature.",
                                           "eq. (16)", Provenance::repaired)
      .input(&SurfaceHeating::surface_c, "surface_temp_c", "T", "degC", any(), "surface temperature", 1200.0)
      .input(&SurfaceHeating::transform_c, "transform_temp_c", "T_tr", "degC", any(),
             "transformation temperature", 750.0)
      .optional(&SurfaceHeating::ambient_c, "ambient_c", "-", "degC", any(),
                "ambient; 0 reproduces the paper's use of T")
      .input(&SurfaceHeating::diffusivity_mm2_s, "diffusivity_mm2_s", "a", "mm2/s", positive(), "diffusivity",
             8.0)
      .input(&SurfaceHeating::source_time_s, "source_time_s", "tau", "s", non_negative(),
             "time under the source, usually 2 h_q / V_u", 0.01)
      .output(&DefectFromTemperature::depth_um, "depth_um", "h", "um", non_negative(), "depth by eq. (16)")
      .output(&DefectFromTemperature::depth_exact_um, "depth_exact_um", "h", "um", non_negative(),
              "exact half-space solution (completion)");
  source
      .function<&defect_depth_after_pass>(
          "defect_depth_after_pass", "Depth of the defect layer after a pass.", "eq. (17)", Provenance::paper)
      .input(&DefectBeforePass::previous_um, "previous_um", "h_{i-1}", "um", non_negative(),
             "depth before the pass", 60.0)
      .input(&DefectBeforePass::removed_um, "removed_um", "Delta h", "um", non_negative(),
             "stock removed in the pass", 15.0)
      .input(&DefectBeforePass::introduced_um, "introduced_um", "h_intr", "um", non_negative(),
             "defect layer the pass itself brings", 10.0)
      .output(&DefectDepth::depth_um, "depth_um", "h_i", "um", non_negative(), "depth after the pass");
  source
      .function<&passes_to_reach_defect>("passes_to_reach_defect",
                                         "Passes until the defect layer is no deeper than the target.",
                                         "eq. (17) repeated", Provenance::completion)
      .input(&DefectTarget::initial_um, "initial_um", "h_0", "um", non_negative(), "depth before the passes",
             60.0)
      .with(removal)
      .input(&DefectTarget::target_um, "target_um", "h_target", "um", non_negative(), "depth to reach", 12.0)
      .output(&PassCount::passes, "passes", "-", "1", at_least(-1), "number of passes; -1: never");
}

}  // namespace verstat::models::k302
