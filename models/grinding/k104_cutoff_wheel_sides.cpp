#include "models/grinding/k104_cutoff_wheel_sides.h"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/beta.hpp>

#include "models/math/policy.h"
#include "models/math/polyline.h"

namespace verstat::models::k104 {
namespace {

constexpr double mm_per_m = 1000;

// Table 1 reduced to a wheel of 300 mm: pipe diameter, layer, mm.
constexpr std::array layer_of_300_mm_wheel{Node{33.5, 0.080}, Node{42.3, 0.110}, Node{48, 0.135},
                                           Node{60, 0.155},   Node{75.5, 0.175}, Node{88.5, 0.200}};

double base_layer_mm(double workpiece_diameter_mm) {
  const Node& first = layer_of_300_mm_wheel.front();
  const Node& last = layer_of_300_mm_wheel.back();
  if (workpiece_diameter_mm < first.x) return first.y * workpiece_diameter_mm / first.x;
  if (workpiece_diameter_mm > last.x) return last.y * workpiece_diameter_mm / last.x;
  return polyline(layer_of_300_mm_wheel, workpiece_diameter_mm);
}

// Gamma(m+1) Gamma(k) / Gamma(k+m+1)
double gamma_ratio(double k, double m) {
  return boost::math::beta(m + 1, k, MathPolicy());
}

double coefficient(double k, double m, double median_exponent) {
  return median_exponent * std::exp2(k - 1.5) * (k + m + 1) / (k * gamma_ratio(k, m));
}

// c(1.5, 0.5) = 6 ln 2 / (1.5 Gamma(1.5)^2) with Gamma(1.5)^2 = pi/4
constexpr double parabolic_coefficient = 16 * std::numbers::ln2 / std::numbers::pi;

}  // namespace

SideLayer side_layer_thickness(const CutoffPair& in) {
  return guarded<&side_layer_thickness>(in, [&] {
    const double d_mm = in.workpiece_diameter_mm;
    const double wheel_mm = std::clamp(in.wheel_diameter_mm, 300.0, 600.0);
    return SideLayer{std::clamp(base_layer_mm(d_mm) - 5e-5 * (wheel_mm - 300), 0.002 * d_mm, 0.003 * d_mm)};
  });
}

SideFeed side_feed(const SideFeedInputs& in) {
  return guarded<&side_feed>(
      in, [&] { return SideFeed{in.layer_mm * in.radial_feed_mm_s / in.workpiece_diameter_mm}; });
}

Removal side_removal_exponent(const SideContact& in) {
  return guarded<&side_removal_exponent>(in, [&] {
    const double path_mm = in.side_feed_mm_s * in.contact_time_s;
    require(path_mm <= in.active_depth_mm * (1 + 1e-9), "contact_time_s", in.contact_time_s,
            "must not carry side_feed_mm_s * contact_time_s beyond active_depth_mm");
    const double k = in.k;
    const double m = in.m;
    const double profile = 2 * std::numbers::sqrt2 * std::pow(in.grain_tip_radius_mm, 1 - m);  // C_b
    // (V_y tau)^(k+m+1) / H_u^k, without the overflow of the single powers
    const double paths = std::pow(path_mm / in.active_depth_mm, k) * std::pow(path_mm, m + 1);
    const double a = mm_per_m * k * in.chip_coefficient * profile * gamma_ratio(k, m) * in.grain_density_mm2 *
                     in.wheel_speed_m_s * paths / ((k + m + 1) * in.side_feed_mm_s);
    return Removal{a, -std::expm1(-a)};
  });
}

Coefficient density_coefficient(const ProfileExponents& in) {
  return guarded<&density_coefficient>(
      in, [&] { return Coefficient{coefficient(in.k, in.m, in.median_exponent)}; });
}

GrainDensity max_side_grain_density(const SideGrains& in) {
  return guarded<&max_side_grain_density>(in, [&] {
    const double side_feed_mm_s = in.layer_mm * in.radial_feed_mm_s / in.workpiece_diameter_mm;
    return GrainDensity{coefficient(in.k, in.m, std::numbers::ln2) * side_feed_mm_s /
                        (in.chip_coefficient * in.grain_tip_radius_mm * in.grain_tip_radius_mm *
                         std::pow(in.relative_depth, in.m + 1) * mm_per_m * in.wheel_speed_m_s)};
  });
}

RelativeDepth relative_cut_depth(const WheelInCut& in) {
  return guarded<&relative_cut_depth>(in, [&] {
    const double depth_power_1_5 =
        parabolic_coefficient * in.layer_mm * in.radial_feed_mm_s /
        (in.grain_density_mm2 * in.workpiece_diameter_mm * in.grain_tip_radius_mm * in.grain_tip_radius_mm *
         in.chip_coefficient * mm_per_m * in.wheel_speed_m_s);
    return RelativeDepth{std::pow(depth_power_1_5, 2.0 / 3)};
  });
}

RadialFeed min_radial_feed(const WheelForDepth& in) {
  return guarded<&min_radial_feed>(in, [&] {
    const double feed_mm_s = in.grain_density_mm2 * in.workpiece_diameter_mm * in.grain_tip_radius_mm *
                             in.grain_tip_radius_mm * std::pow(in.relative_depth, 1.5) * in.chip_coefficient *
                             mm_per_m * in.wheel_speed_m_s / (parabolic_coefficient * in.layer_mm);
    return RadialFeed{feed_mm_s, 60 * feed_mm_s};
  });
}

GrainRegime grain_cut_regime(const GrainDepth& in) {
  return guarded<&grain_cut_regime>(in, [&] {
    if (in.relative_depth < 0.04) return GrainRegime{CutRegime::plastic};
    if (in.relative_depth < 0.08) return GrainRegime{CutRegime::transition};
    if (in.relative_depth < 0.25) return GrainRegime{CutRegime::cutting};
    return GrainRegime{CutRegime::intensive_cutting};
  });
}

TimeAndKerf cutoff_time_and_kerf(const Cutoff& in) {
  return guarded<&cutoff_time_and_kerf>(in, [&] {
    return TimeAndKerf{in.workpiece_diameter_mm / in.radial_feed_mm_s / 60,
                       in.wheel_thickness_mm + in.layer_mm};
  });
}

namespace {

void layer(auto& f, auto pointer) {
  f.input(pointer, "side_layer_mm", "dh", "mm", positive(), "layer that the wheel's sides take in one cut",
          0.165);
}
void radial_feed(auto& f, auto pointer) {
  f.input(pointer, "radial_feed_mm_s", "S_y", "mm/s", positive(), "radial feed, usually 0.5-30", 10.0);
}
void workpiece(auto& f, auto pointer) {
  f.input(pointer, "workpiece_diameter_mm", "d", "mm", positive(), "diameter of the workpiece", 75.5);
}
void tip_radius(auto& f, auto pointer) {
  f.input(pointer, "grain_tip_radius_mm", "rho", "mm", positive(), "tip radius of a grain, usually 0.01-0.15",
          0.05);
}
void depth(auto& f, auto pointer) {
  f.input(pointer, "relative_depth", "t/rho", "1", positive(), "relative depth, usually 0.01-0.5", 0.08);
}
void wheel_speed(auto& f, auto pointer) {
  f.input(pointer, "wheel_speed_m_s", "V_k", "m/s", positive(), "wheel speed, usually 20-120", 80.0);
}
void density(auto& f, auto pointer) {
  f.input(pointer, "grain_density_mm2", "n", "1/mm2", positive(), "grains on the side per mm2", 0.02);
}
void chip(auto& f, auto pointer) {
  f.optional(pointer, "chip_coefficient", "K_c", "1", positive(), "chip-formation coefficient");
}
void exponents(auto& f, auto k, auto m) {
  f.optional(k, "k", "k", "1", positive(), "exponent of the grain heights, usually 1 or more")
      .optional(m, "m", "m", "1", positive(), "exponent of the grain profile, usually 0.3-1");
}
constexpr const char* measure_rho =
    "rho is typically 0.02-0.1 mm for wheel grits of 0.3-1.2 mm and must be measured; results far outside "
    "the "
    "usual ranges are not backed by the source.";

void describe_layer(Source& source) {
  source
      .function<&side_layer_thickness>("side_layer_thickness",
                                       "Layer that the wheel's sides take in one cut.", "Table 1",
                                       Provenance::completion)
      .input(&CutoffPair::workpiece_diameter_mm, "workpiece_diameter_mm", "d", "mm", closed(20, 120),
             "diameter of the pipe", 75.5)
      .input(&CutoffPair::wheel_diameter_mm, "wheel_diameter_mm", "D_k", "mm", positive(),
             "diameter of the wheel; 300..600, clamped outside", 500.0)
      .output(&SideLayer::layer_mm, "side_layer_mm", "dh", "mm", positive(), "side layer")
      .note(
          "Measured as kerf width minus wheel thickness, so presumably of both sides: pass half of it on if "
          "one side is meant.");
  source
      .function<&side_feed>("side_feed", "Side feed of the wheel into the kerf wall.", "before eq. (4)",
                            Provenance::reconstructed)
      .with([](auto& f) { layer(f, &SideFeedInputs::layer_mm); })
      .with([](auto& f) { radial_feed(f, &SideFeedInputs::radial_feed_mm_s); })
      .with([](auto& f) { workpiece(f, &SideFeedInputs::workpiece_diameter_mm); })
      .output(&SideFeed::feed_mm_s, "side_feed_mm_s", "S_x", "mm/s", positive(), "side feed");
  source
      .function<&side_removal_exponent>("side_removal_exponent",
                                        "Probability that side grains remove the kerf wall.", "eq. (1)",
                                        Provenance::reconstructed)
      .with([](auto& f) { density(f, &SideContact::grain_density_mm2); })
      .with([](auto& f) { wheel_speed(f, &SideContact::wheel_speed_m_s); })
      .input(&SideContact::side_feed_mm_s, "side_feed_mm_s", "V_y", "mm/s", positive(), "side feed", 0.02)
      .input(&SideContact::contact_time_s, "contact_time_s", "tau", "s", non_negative(), "contact time", 0.2)
      .input(&SideContact::active_depth_mm, "active_depth_mm", "H_u", "mm", positive(),
             "depth of the active layer of grains", 0.008)
      .with([](auto& f) { tip_radius(f, &SideContact::grain_tip_radius_mm); })
      .with([](auto& f) { chip(f, &SideContact::chip_coefficient); })
      .with([](auto& f) { exponents(f, &SideContact::k, &SideContact::m); })
      .output(&Removal::exponent, "removal_exponent", "a", "1", non_negative(), "removal exponent")
      .output(&Removal::probability, "removal_probability", "P", "1", probability(), "removal probability")
      .note("The profile constant C_b is recovered from eq. (3) for m = 1/2 and completed for other m.")
      .note(measure_rho);
  source
      .function<&density_coefficient>("density_coefficient", "Coefficient of the admissible grain density.",
                                      "eqs. (3), (4)", Provenance::paper)
      .with([](auto& f) { exponents(f, &ProfileExponents::k, &ProfileExponents::m); })
      .optional(&ProfileExponents::median_exponent, "median_exponent", "ln 2", "1", positive(),
                "removal exponent at the mean line of the profile")
      .output(&Coefficient::coefficient, "coefficient", "c", "1", positive(), "coefficient");
}

void describe_density(Source& source) {
  source
      .function<&max_side_grain_density>("max_side_grain_density",
                                         "Largest number of side grains that still cut.", "eqs. (3), (4)",
                                         Provenance::repaired)
      .with([](auto& f) { layer(f, &SideGrains::layer_mm); })
      .with([](auto& f) { radial_feed(f, &SideGrains::radial_feed_mm_s); })
      .with([](auto& f) { workpiece(f, &SideGrains::workpiece_diameter_mm); })
      .with([](auto& f) { tip_radius(f, &SideGrains::grain_tip_radius_mm); })
      .with([](auto& f) { depth(f, &SideGrains::relative_depth); })
      .with([](auto& f) { wheel_speed(f, &SideGrains::wheel_speed_m_s); })
      .with([](auto& f) { chip(f, &SideGrains::chip_coefficient); })
      .with([](auto& f) { exponents(f, &SideGrains::k, &SideGrains::m); })
      .output(&GrainDensity::density_mm2, "max_grain_density_mm2", "n", "1/mm2", positive(),
              "largest grain density")
      .note("The whole layer is taken by one side, as published; pass half of it if it is of both sides.")
      .note(measure_rho);
  source
      .function<&relative_cut_depth>("relative_cut_depth", "Relative depth that the side grains reach.",
                                     "eq. (4), inverted", Provenance::repaired)
      .with([](auto& f) { density(f, &WheelInCut::grain_density_mm2); })
      .with([](auto& f) { layer(f, &WheelInCut::layer_mm); })
      .with([](auto& f) { radial_feed(f, &WheelInCut::radial_feed_mm_s); })
      .with([](auto& f) { workpiece(f, &WheelInCut::workpiece_diameter_mm); })
      .with([](auto& f) { tip_radius(f, &WheelInCut::grain_tip_radius_mm); })
      .with([](auto& f) { wheel_speed(f, &WheelInCut::wheel_speed_m_s); })
      .with([](auto& f) { chip(f, &WheelInCut::chip_coefficient); })
      .output(&RelativeDepth::relative_depth, "relative_depth", "t/rho", "1", positive(), "relative depth")
      .note(measure_rho);
  source
      .function<&min_radial_feed>("min_radial_feed", "Smallest radial feed at which the side grains cut.",
                                  "eq. (4), inverted", Provenance::repaired)
      .with([](auto& f) { density(f, &WheelForDepth::grain_density_mm2); })
      .with([](auto& f) { layer(f, &WheelForDepth::layer_mm); })
      .with([](auto& f) { workpiece(f, &WheelForDepth::workpiece_diameter_mm); })
      .with([](auto& f) { tip_radius(f, &WheelForDepth::grain_tip_radius_mm); })
      .with([](auto& f) { depth(f, &WheelForDepth::relative_depth); })
      .with([](auto& f) { wheel_speed(f, &WheelForDepth::wheel_speed_m_s); })
      .with([](auto& f) { chip(f, &WheelForDepth::chip_coefficient); })
      .output(&RadialFeed::feed_mm_s, "min_radial_feed_mm_s", "S_y", "mm/s", positive(),
              "smallest radial feed")
      .output(&RadialFeed::feed_mm_min, "min_radial_feed_mm_min", "S_y", "mm/min", positive(),
              "smallest radial feed")
      .note("Upper limits of the feed (power, strength of the wheel) are not in the source.")
      .note(measure_rho);
  source
      .function<&grain_cut_regime>("grain_cut_regime", "What a grain does at a relative depth.", "(0)",
                                   Provenance::paper)
      .input(&GrainDepth::relative_depth, "relative_depth", "t/rho", "1", non_negative(), "relative depth",
             0.09)
      .output(&GrainRegime::regime, "regime", "-", "-", no_range(), "regime of cutting");
  source
      .function<&cutoff_time_and_kerf>("cutoff_time_and_kerf", "Main time and kerf width of a cut.",
                                       "completion", Provenance::completion)
      .with([](auto& f) { workpiece(f, &Cutoff::workpiece_diameter_mm); })
      .with([](auto& f) { radial_feed(f, &Cutoff::radial_feed_mm_s); })
      .input(&Cutoff::wheel_thickness_mm, "wheel_thickness_mm", "-", "mm", positive(),
             "thickness of the wheel", 4.0)
      .with([](auto& f) { layer(f, &Cutoff::layer_mm); })
      .output(&TimeAndKerf::main_time_min, "main_time_min", "t", "min", positive(), "main time")
      .output(&TimeAndKerf::kerf_width_mm, "kerf_width_mm", "-", "mm", positive(), "width of the kerf");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K104",
       .title = "Analytical calculation of design elements of the side surfaces of cut-off wheels",
       .authors = "Novoselov Yu. K., Levchenko Ye. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "In abrasive cut-off the two sides of the wheel take a thin layer from the kerf walls. If too "
           "many grains stand there, each penetrates too little, rubs and burns the part. From the "
           "probability that randomly placed grains remove material follow the largest density of side "
           "grains and, inverted, the smallest radial feed. Still to be confirmed by experiment.",
       .role = "grinding",
       .errata = {
           "Eq. (1) is printed with \"<=\" for \"=\"; the profile constant C_b is not defined in print and "
           "recovered from eq. (3).",
           "Substitutions before eq. (3): t_f = S_x tau must read S_x tau = t with t_f = 2t.",
           "Eqs. (2)-(4) hold with wheel speed and feed in one unit; with V_k in m/s a factor 1000 belongs "
           "in the denominator.",
           "The range t/rho = 0.004-0.08 printed with eq. (3) must read 0.04-0.08.",
           "The text says n must fall when d grows: with its own layer of about 0.0025 d it hardly "
           "depends on d."}});
  describe_layer(source);
  describe_density(source);
}

}  // namespace verstat::models::k104
