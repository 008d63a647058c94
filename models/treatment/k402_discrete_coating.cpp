#include "models/treatment/k402_discrete_coating.h"

#include <algorithm>
#include <cmath>

namespace verstat::models::k402 {
namespace {

constexpr double side_low_um = 10, side_high_um = 200;
constexpr double reference_half_side_um = 60;  // of the 120 um island of the calibration
constexpr double continuous_over_120 = 1.6;    // continuous film over islands of 120 um, (C3)

// Interface transfer parameter, 1/um, (C3).
double transfer(double thickness_um) {
  return 0.104 / std::sqrt(thickness_um);
}

double full_stress(const HeatedCoating& in) {
  return in.modulus_mpa / (1 - in.poisson) * in.delta_alpha_1_k * in.delta_t_k;
}

}  // namespace

Conductivity thermal_conductivity(const ConductingMaterial& in) {
  return guarded<&thermal_conductivity>(in, [&]() -> Conductivity {
    switch (in.material) {
      case Material::tin:
        return {12.5};
      case Material::t15k6:
        return {23};
      case Material::vk8:
        return {50.2};
      case Material::air:
        return {0.02553};
    }
    reject("there is no such material");
  });
}

Friction coating_friction(const SlidingPair& in) {
  return guarded<&coating_friction>(in, [&]() -> Friction {
    switch (in.pair) {
      case FrictionPair::tin_carbon:
        return {0.9};
      case FrictionPair::tin_chromium:
        return {0.6};
      case FrictionPair::tin_alumina:
        return {0.35};
      case FrictionPair::tin_mos_chromium:
        return {0.15};
    }
    reject("there is no such pair");
  });
}

LifeFactor discrete_coating_life_factor(const CoatingVariant& in) {
  return guarded<&discrete_coating_life_factor>(in, [&] {
    return in.kind == CoatingKind::bumpy_nitrided ? LifeFactor{2.5, 3, 2.75} : LifeFactor{1, 1, 1};
  });
}

TemperatureDrop coating_temperature_drop(const CoatingHeat& in) {
  return guarded<&coating_temperature_drop>(
      in, [&] { return TemperatureDrop{in.flux_w_m2 * in.thickness_um * 1e-6 / in.conductivity_w_mk}; });
}

FaceTemperatures insert_face_temperatures(const CoatedInsert& in) {
  return guarded<&insert_face_temperatures>(in, [&] {
    const double interface_c = in.contact_c - in.flux_w_m2 * in.coating_um * 1e-6 / in.coating_w_mk;
    return FaceTemperatures{interface_c, interface_c - in.flux_w_m2 * in.insert_mm * 1e-3 / in.insert_w_mk};
  });
}

MeanShear mean_interface_shear(const IslandLoad& in) {
  return guarded<&mean_interface_shear>(in, [&] { return MeanShear{in.mu * in.pressure_mpa}; });
}

ThermalShear interface_thermal_shear(const HeatedIsland& in) {
  return guarded<&interface_thermal_shear>(in, [&] {
    const double k = transfer(in.thickness_um);
    const double half = k * in.side_um / 2;
    const double stress = full_stress(in);
    // 1 - 1/cosh x = tanh(x/2) tanh(x), which keeps the digits of small islands.
    return ThermalShear{stress * in.thickness_um * k * std::tanh(half),
                        stress * std::tanh(half / 2) * std::tanh(half)};
  });
}

ShearRatio size_effect(const IslandSizes& in) {
  return guarded<&size_effect>(in, [&] {
    require(in.large_um >= in.small_um, "d_large", in.large_um, "must not be below d_small");
    const double k = transfer(in.thickness_um);
    return ShearRatio{std::tanh(k * in.large_um / 2) / std::tanh(k * in.small_um / 2)};
  });
}

ShearRatio discrete_shear_ratio(const Island& in) {
  return guarded<&discrete_shear_ratio>(in, [&] {
    const double k = transfer(in.thickness_um);
    return ShearRatio{std::tanh(k * in.side_um / 2) /
                      (continuous_over_120 * std::tanh(reference_half_side_um * k))};
  });
}

Delamination delamination_margin(const LoadedInterface& in) {
  return guarded<&delamination_margin>(in, [&] {
    const double total = std::abs(in.tau_thermal_mpa) + in.mu * in.pressure_mpa;
    require(total > 0, "tau_thermal", in.tau_thermal_mpa, "and mu q must not both be 0");
    return Delamination{total, in.adhesion_mpa / total, total <= in.adhesion_mpa};
  });
}

SafeIsland largest_safe_island(const LoadedCoating& in) {
  return guarded<&largest_safe_island>(in, [&] {
    const double k = transfer(in.thickness_um);
    const double saturated = std::abs(full_stress(in)) * in.thickness_um * k;
    const double left = in.adhesion_mpa - in.mu * in.pressure_mpa;
    const auto holds = [&](double side) { return saturated * std::tanh(k * side / 2) <= left; };
    if (!holds(side_low_um)) return SafeIsland{false, 0};
    if (holds(side_high_um)) return SafeIsland{true, side_high_um};
    return SafeIsland{true, std::clamp(2 / k * std::atanh(left / saturated), side_low_um, side_high_um)};
  });
}

Coverage island_coverage(const IslandGrid& in) {
  return guarded<&island_coverage>(in, [&] {
    require(in.side <= in.pitch, "side", in.side, "must not be above pitch");
    const double share = in.side / in.pitch;
    return Coverage{share * share};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K402",
       .title = "Stress-strain state control in the system substrate - PVD coating under thermobaric loading",
       .authors = "Soroka O. B., Selin O. M., Klimenko S. A., Kopeikina M. Yu., Manokhin A. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A TiN coating deposited as square islands on carbide or high-speed steel: temperature drop over "
           "the "
           "coating, interface shear from friction and from unequal thermal expansion, dependence on island "
           "size and thickness, and whether the coating stays on.",
       .role = "treatment",
       .errata = {
           "Modulus of TiN: printed 4.4 GPa, 440 GPa is meant.",
           "Printed: the interface shear of islands up to 40 um practically does not depend on friction. Its "
           "mean must equal mu q by equilibrium; the statement is not used.",
           "Convection is printed in W/(m K); W/(m2 K) is meant."}});
  const Range side = closed(10, 200);
  const Range thickness = closed(1, 8);
  const auto coating = [&](auto& f) {
    f.input(&HeatedCoating::thickness_um, "h", "h", "um", thickness, "thickness of the coating", 4.0)
        .input(&HeatedCoating::modulus_mpa, "e_coat", "E_c", "MPa", positive(), "modulus of the coating",
               440000.0)
        .input(&HeatedCoating::poisson, "nu_coat", "nu_c", "1", open_high(0, 0.5),
               "Poisson's ratio of the coating", 0.25)
        .input(&HeatedCoating::delta_alpha_1_k, "delta_alpha", "delta alpha", "1/K", any(),
               "expansion of the coating minus that of the substrate", 3e-6)
        .input(&HeatedCoating::delta_t_k, "delta_t", "delta T", "K", any(),
               "contact minus stress-free temperature", 780.0);
  };
  const auto load = [](auto& f, auto mu, auto q) {
    f.input(mu, "mu", "mu", "1", non_negative(), "friction coefficient", 0.35)
        .input(q, "q", "q", "MPa", non_negative(), "normal pressure", 300.0);
  };
  const char* const nominal =
      "A nominal value for comparing coatings: the elastic stress at the edge of an island is singular.";

  source
      .function<&thermal_conductivity>("thermal_conductivity", "Thermal conductivity used in the study.",
                                       "data", Provenance::paper)
      .input(&ConductingMaterial::material, "material", "-", "-", no_range(), "material", "TiN")
      .output(&Conductivity::lambda_w_mk, "lambda", "lambda", "W/(m K)", positive(), "conductivity");
  source
      .function<&coating_friction>("coating_friction", "Friction coefficient of a coating.", "data",
                                   Provenance::paper)
      .input(&SlidingPair::pair, "pair", "-", "-", no_range(), "coating and work", "TiN-chromium steel")
      .output(&Friction::mu, "mu", "mu", "1", positive(), "friction coefficient");
  source
      .function<&discrete_coating_life_factor>("discrete_coating_life_factor",
                                               "Wear resistance over that of a continuous coating.", "data",
                                               Provenance::paper)
      .input(&CoatingVariant::kind, "kind", "-", "-", no_range(), "coating", "bumpy_nitrided")
      .output(&LifeFactor::factor_min, "factor_min", "-", "1", positive(), "lower end")
      .output(&LifeFactor::factor_max, "factor_max", "-", "1", positive(), "upper end")
      .output(&LifeFactor::factor, "factor", "-", "1", positive(), "middle");
  source
      .function<&coating_temperature_drop>("coating_temperature_drop", "Temperature drop over the coating.",
                                           "eq. (2)", Provenance::completion)
      .input(&CoatingHeat::flux_w_m2, "q", "q", "W/m2", non_negative(), "heat flux", 1e5)
      .input(&CoatingHeat::thickness_um, "h", "h", "um", positive(), "thickness of the coating", 3.0)
      .input(&CoatingHeat::conductivity_w_mk, "lam", "lambda", "W/(m K)", positive(), "conductivity", 12.5)
      .output(&TemperatureDrop::delta_k, "delta_t", "delta T", "K", non_negative(), "temperature drop");
  source
      .function<&insert_face_temperatures>("insert_face_temperatures",
                                           "Temperatures under the coating and at the support face.",
                                           "completion (C1)", Provenance::completion)
      .input(&CoatedInsert::contact_c, "t_contact", "t_c", "degC", at_least(-273.15), "contact temperature",
             800.0)
      .input(&CoatedInsert::flux_w_m2, "q", "q", "W/m2", non_negative(), "heat flux", 1e5)
      .input(&CoatedInsert::coating_um, "h_coat", "h_c", "um", positive(), "thickness of the coating", 3.0)
      .input(&CoatedInsert::coating_w_mk, "lam_coat", "lambda_c", "W/(m K)", positive(),
             "conductivity of the coating", 12.5)
      .input(&CoatedInsert::insert_mm, "h_insert", "H", "mm", positive(), "thickness of the insert", 4.76)
      .input(&CoatedInsert::insert_w_mk, "lam_insert", "lambda_s", "W/(m K)", positive(),
             "conductivity of the insert", 23.0)
      .output(&FaceTemperatures::interface_c, "t_interface", "t", "degC", any(),
              "temperature under the coating")
      .output(&FaceTemperatures::support_c, "t_support", "t", "degC", any(),
              "temperature of the support face");
  source
      .function<&mean_interface_shear>("mean_interface_shear",
                                       "Mean interface shear of an island under friction.", "eq. (1)",
                                       Provenance::completion)
      .with([&](auto& f) { load(f, &IslandLoad::mu, &IslandLoad::pressure_mpa); })
      .output(&MeanShear::tau_mpa, "tau_mean", "tau", "MPa", non_negative(), "mean shear")
      .note("Exact by equilibrium, whatever the size of the island; the largest shear is higher.");
  source
      .function<&interface_thermal_shear>("interface_thermal_shear", "Interface shear of a heated island.",
                                          "completion (C2)", Provenance::completion)
      .input(&HeatedIsland::side_um, "d", "D", "um", side, "side of the island", 40.0)
      .with(coating)
      .output(&ThermalShear::tau_max_mpa, "tau_max", "tau_max", "MPa", any(),
              "largest shear, + for compression")
      .output(&ThermalShear::sigma_centre_mpa, "sigma_centre", "sigma_c", "MPa", any(),
              "stress in the middle")
      .note(nominal);
  source
      .function<&size_effect>("size_effect", "Thermal shear of a larger island over a smaller one.",
                              "completion", Provenance::completion)
      .input(&IslandSizes::large_um, "d_large", "D_1", "um", side, "side of the larger island", 120.0)
      .input(&IslandSizes::small_um, "d_small", "D_2", "um", side, "side of the smaller island", 40.0)
      .input(&IslandSizes::thickness_um, "h", "h", "um", thickness, "thickness of the coating", 4.0)
      .output(&ShearRatio::ratio, "ratio", "-", "1", at_least(1), "ratio");
  source
      .function<&discrete_shear_ratio>("discrete_shear_ratio",
                                       "Thermal shear of an island over a continuous coating.",
                                       "completion (C3)", Provenance::completion)
      .input(&Island::side_um, "d", "D", "um", side, "side of the island", 40.0)
      .input(&Island::thickness_um, "h", "h", "um", thickness, "thickness of the coating", 4.0)
      .output(&ShearRatio::ratio, "ratio", "-", "1", positive(), "ratio")
      .note("Calibrated on the printed ranges; not continuous for ever larger islands.");
  source
      .function<&delamination_margin>("delamination_margin", "Adhesion over thermal and friction shear.",
                                      "completion (C4)", Provenance::completion)
      .input(&LoadedInterface::tau_thermal_mpa, "tau_thermal", "tau_T", "MPa", any(), "thermal shear", 220.0)
      .with([&](auto& f) { load(f, &LoadedInterface::mu, &LoadedInterface::pressure_mpa); })
      .input(&LoadedInterface::adhesion_mpa, "adhesion", "tau_adh", "MPa", positive(), "adhesion strength",
             500.0)
      .output(&Delamination::tau_total_mpa, "tau_total", "tau", "MPa", positive(),
              "thermal plus friction shear")
      .output(&Delamination::margin, "margin", "-", "1", positive(), "adhesion over shear")
      .output(&Delamination::holds, "holds", "-", "-", no_range(), "the coating stays on")
      .note(nominal);
  source
      .function<&largest_safe_island>("largest_safe_island", "Largest island that stays on.",
                                      "completion (C4)", Provenance::completion)
      .with(coating)
      .with([&](auto& f) { load(f, &LoadedCoating::mu, &LoadedCoating::pressure_mpa); })
      .input(&LoadedCoating::adhesion_mpa, "adhesion", "tau_adh", "MPa", positive(), "adhesion strength",
             340.0)
      .output(&SafeIsland::feasible, "feasible", "-", "-", no_range(), "an island of 10 um holds")
      .output(&SafeIsland::side_um, "d", "D", "um", closed(0, 200), "side, 0 when infeasible, at most 200")
      .note(nominal);
  source
      .function<&island_coverage>("island_coverage", "Area share of island tops.", "geometry",
                                  Provenance::completion)
      .input(&IslandGrid::side, "side", "-", "mm", positive(), "side of the island tops", 0.2)
      .input(&IslandGrid::pitch, "pitch", "-", "mm", positive(), "pitch, in the unit of the side", 0.33)
      .output(&Coverage::share, "coverage", "-", "1", probability(), "area share");
}

}  // namespace verstat::models::k402
