#include "models/surface/k116_tool_steel_surface.h"

#include <cmath>
#include <numbers>

#include "models/math/polyline.h"

namespace verstat::models::k116 {
namespace {

constexpr double unit_stress_mpa = 10;  // 1 kgf/mm2

struct FatigueCurve {
  double a, m;
};
// Table 3; the constants A are put together from two cells of the print, row 4 repaired from 36.73.
FatigueCurve curve(FatigueFinish finish) {
  switch (finish) {
    case FatigueFinish::grinding_abrasive:
      return {28.56, 12.33};
    case FatigueFinish::turning_geksanit_r_50:
      return {53.31, 24.15};
    case FatigueFinish::turning_geksanit_r_100:
      return {36.97, 15.88};
    case FatigueFinish::turning_geksanit_r_200:
      break;
  }
  return {38.73, 17.00};
}

// Table 3: limits used at 50, 100 and 200 m/min.
constexpr std::array turned_limit_mpa{Node{50, 827}, Node{100, 770}, Node{200, 735}};

// Table 1: depth in um, retained austenite in %.
constexpr std::array abrasive_austenite{Node{10, 24}, Node{20, 25},  Node{30, 23}, Node{40, 23},
                                        Node{80, 29}, Node{120, 30}, Node{160, 30}};
constexpr std::array geksanit_austenite{Node{10, 32}, Node{20, 27},  Node{30, 26}, Node{40, 29},
                                        Node{80, 30}, Node{120, 30}, Node{160, 30}};
// Table 2: cutting speed in m/min, retained austenite in %.
constexpr std::array turned_austenite{Node{20, 23}, Node{40, 21}, Node{80, 30}, Node{120, 30}, Node{250, 30}};

}  // namespace

FatigueLife fatigue_life_cycles(const FatigueLoad& in) {
  return guarded<&fatigue_life_cycles>(in, [&] {
    const auto [a, m] = curve(in.finish);
    return FatigueLife{std::pow(10, a - m * std::log10(in.stress_mpa / unit_stress_mpa))};
  });
}

FatigueLimit fatigue_limit(const FatigueBase& in) {
  return guarded<&fatigue_limit>(in, [&] {
    const auto [a, m] = curve(in.finish);
    return FatigueLimit{unit_stress_mpa * std::pow(10, (a - std::log10(in.cycles)) / m)};
  });
}

FatigueLimit turned_fatigue_limit_vs_speed(const TurningSpeed& in) {
  return guarded<&turned_fatigue_limit_vs_speed>(
      in, [&] { return FatigueLimit{polyline(turned_limit_mpa, in.cutting_speed_m_min)}; });
}

Austenite austenite_after_grinding(const GroundLayer& in) {
  return guarded<&austenite_after_grinding>(in, [&] {
    return Austenite{
        polyline(in.wheel == Wheel::abrasive ? abrasive_austenite : geksanit_austenite, in.depth_um)};
  });
}

Austenite austenite_after_turning(const TurningSpeed& in) {
  return guarded<&austenite_after_turning>(
      in, [&] { return Austenite{polyline(turned_austenite, in.cutting_speed_m_min)}; });
}

DepthRange tempered_zone_depth(const LayerChoice& in) {
  return guarded<&tempered_zone_depth>(in, [&]() -> DepthRange {
    switch (in.finish) {
      case LayerFinish::abrasive_wheel:
        return {30, 650};
      case LayerFinish::geksanit_a_wheel:
        return {30, 300};
      case LayerFinish::geksanit_r_turning:
        break;
    }
    return {8, 12};
  });
}

Austenite retained_austenite_percent(const LineIntensities& in) {
  return guarded<&retained_austenite_percent>(in, [&] {
    require(in.alpha > 0 || in.gamma > 0, "S_alpha", in.alpha, "must not be 0 together with S_gamma");
    return Austenite{in.gamma / (0.66 * in.alpha + in.gamma) * 100};
  });
}

StressSum xray_principal_stress_sum(const LineShift& in) {
  return guarded<&xray_principal_stress_sum>(in, [&] {
    constexpr double radians_per_degree = std::numbers::pi / 180;
    return StressSum{in.e_modulus_mpa / in.poisson / std::tan(in.bragg_angle_deg * radians_per_degree) *
                     (in.shift_deg * radians_per_degree)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K116",
       .title =
           "Dependence of physical and mechanical condition of alloyed tool steel on the type of machining",
       .authors = "Volkogon V. M., Antoniuk V. S., Fedoran Yu. A., Kotliar D. A., Kravchuk A. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "Hardened tool steel KhVSG (HRC 54-56) after abrasive grinding, grinding with Geksanit-A wheels "
           "and hard turning with Geksanit-R cutters: tempered zones, retained austenite, residual "
           "stresses and fatigue in rotating bending. Hard turning leaves the shallowest altered layer "
           "and a fatigue limit 31-48 % above abrasive grinding.",
       .role = "surface",
       .errata = {
           "Eq. (3) is printed ln N = A + M ln sigma with A split into two cells. Only decimal logarithms, "
           "a falling line and stress in kgf/mm2 give the printed limits at 1e7 cycles, in all four rows.",
           "Table 3, row 1: the limit is printed 660 MPa; the text says 560 and 32 % below row 2.",
           "Table 3, row 4: A must be 38.73; 36.73 as printed would give 561 MPa for a limit of 735.",
           "The conclusion \"austenite minimal at 40-80 m/min\" contradicts Table 2; one sentence puts "
           "the tension after grinding in the gamma phase instead of alpha."}});

  const auto finish = [](auto& f, auto pointer) {
    f.input(pointer, "finish", "-", "-", no_range(), "finishing method, with the cutting speed in m/min",
            "turning_geksanit_r_100");
  };
  const auto speed = [](auto& f, std::string meaning) {
    f.input(&TurningSpeed::cutting_speed_m_min, "V_m_min", "V", "m/min", positive(), std::move(meaning),
            75.0);
  };
  source
      .function<&fatigue_life_cycles>("fatigue_life_cycles", "Mean fatigue life at a stress.", "eq. (3)",
                                      Provenance::repaired)
      .with([&](auto& f) { finish(f, &FatigueLoad::finish); })
      .input(&FatigueLoad::stress_mpa, "stress_MPa", "sigma", "MPa", closed(500, 1000), "stress amplitude",
             900.0)
      .output(&FatigueLife::cycles, "cycles", "N", "1", positive(), "cycles to failure")
      .note("Only the sloping branch is known: outside 1e5..1e7 cycles the value is an extrapolation.")
      .note("Only correlation coefficients are given of the scatter; no value is proposed.");
  source
      .function<&fatigue_limit>("fatigue_limit_MPa", "Fatigue limit for a base of cycles.",
                                "eq. (3), inverse", Provenance::repaired)
      .with([&](auto& f) { finish(f, &FatigueBase::finish); })
      .optional(&FatigueBase::cycles, "cycles", "N", "1", closed(1e5, 1e7), "base")
      .output(&FatigueLimit::limit_mpa, "fatigue_limit_MPa", "sigma_N", "MPa", positive(), "fatigue limit")
      .note("From the fitted curve, so 827.18 for the printed 827.");
  source
      .function<&turned_fatigue_limit_vs_speed>("turned_fatigue_limit_vs_speed",
                                                "Fatigue limit at 1e7 cycles after hard turning at a speed.",
                                                "completion from Table 3", Provenance::completion)
      .with([&](auto& f) { speed(f, "cutting speed; 50..200, clamped outside"); })
      .output(&FatigueLimit::limit_mpa, "fatigue_limit_MPa", "sigma_N", "MPa", closed(735, 827),
              "fatigue limit")
      .note("Feed 0.07 mm/rev, depth 0.25 mm; no effect of either is known.");
  source
      .function<&austenite_after_grinding>("austenite_after_grinding",
                                           "Retained austenite at a depth after grinding.", "Table 1",
                                           Provenance::paper)
      .input(&GroundLayer::wheel, "wheel", "-", "-", no_range(), "wheel", "abrasive_wheel")
      .input(&GroundLayer::depth_um, "depth_um", "-", "um", non_negative(),
             "depth under the surface; 10..160, clamped outside", 50.0)
      .output(&Austenite::percent, "austenite_pct", "f_gamma", "%", closed(0, 100), "retained austenite")
      .note("Linear between the depths of the table (completion).");
  source
      .function<&austenite_after_turning>("austenite_after_turning",
                                          "Retained austenite after hard turning at a speed.", "Table 2",
                                          Provenance::paper)
      .with([&](auto& f) { speed(f, "cutting speed; 20..250, clamped outside"); })
      .output(&Austenite::percent, "austenite_pct", "f_gamma", "%", closed(0, 100), "retained austenite")
      .note("Linear between the speeds of the table (completion).");
  source
      .function<&tempered_zone_depth>("tempered_zone_depth", "Depth of the high-temperature-tempered zone.",
                                      "text", Provenance::paper)
      .input(&LayerChoice::finish, "finish", "-", "-", no_range(), "finishing method", "abrasive_wheel")
      .output(&DepthRange::from_um, "depth_from_um", "-", "um", positive(), "the zone begins")
      .output(&DepthRange::to_um, "depth_to_um", "-", "um", positive(), "the zone ends");
  source
      .function<&retained_austenite_percent>("retained_austenite_percent",
                                             "Retained austenite from X-ray line intensities.", "eq. (1)",
                                             Provenance::paper)
      .input(&LineIntensities::alpha, "S_alpha", "S_alpha", "1", non_negative(),
             "integral intensity of the (110) alpha line", 100.0)
      .input(&LineIntensities::gamma, "S_gamma", "S_gamma", "1", non_negative(),
             "integral intensity of the (111) gamma line", 28.0)
      .output(&Austenite::percent, "austenite_pct", "f_gamma", "%", closed(0, 100), "retained austenite");
  source
      .function<&xray_principal_stress_sum>(
          "xray_principal_stress_sum", "Sum of the principal residual stresses from an X-ray line shift.",
          "eq. (2)", Provenance::paper)
      .input(&LineShift::e_modulus_mpa, "E_MPa", "E", "MPa", positive(), "modulus of elasticity", 210000.0)
      .input(&LineShift::poisson, "poisson", "mu", "1", open_low(0, 0.5), "Poisson's ratio", 0.28)
      .input(&LineShift::bragg_angle_deg, "theta_deg", "Theta", "deg", open(0, 90),
             "Bragg angle, half of the diffractometer angle", 57.0)
      .input(&LineShift::shift_deg, "dtheta_deg", "dTheta", "deg", any(),
             "shift of the Bragg angle, machined minus initial", 0.05)
      .output(&StressSum::sum_mpa, "stress_sum_MPa", "sigma_1 + sigma_2", "MPa", any(),
              "sum of the principal stresses, tension positive")
      .note("Normal incidence is implied, not stated.");
}

}  // namespace verstat::models::k116
