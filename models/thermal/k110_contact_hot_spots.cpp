#include "models/thermal/k110_contact_hot_spots.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k110 {
namespace {

constexpr double zero_celsius_k = 273.15;
constexpr double gas_constant_kj_mol_k = 8.314462618e-3;

}  // namespace

PublishedTemperature published_contact_temperature(const RecordInputs& in) {
  return guarded<&published_contact_temperature>(in, [&] {
    switch (in.record) {
      case Record::ti_ir_s02:
        return PublishedTemperature{1300, 2000};
      case Record::ti_ir_s03:
        return PublishedTemperature{2300, 2300};
      case Record::al_ir:
        return PublishedTemperature{400, 800};
      case Record::ti_fem_a:
        return PublishedTemperature{700, 700};
      case Record::ti_fem_b:
        return PublishedTemperature{1000, 1000};
      case Record::ti_mean:
        return PublishedTemperature{900, 900};
      case Record::al_diamond_mean:
        return PublishedTemperature{200, 300};
    }
    reject("unknown record");
  });
}

Melting melting_temperature(const MaterialInputs& in) {
  return guarded<&melting_temperature>(
      in, [&] { return Melting{in.material == Material::ti_al6_v4 ? 1650.0 : 640.0}; });
}

Severity thermal_severity(const SeverityInputs& in) {
  return guarded<&thermal_severity>(in, [&] {
    require(in.contact_degc >= in.ambient_degc, "contact_temperature_degc", in.contact_degc,
            "must not be below ambient_degc");
    require(in.mean_degc > in.ambient_degc, "mean_temperature_degc", in.mean_degc,
            "must be above ambient_degc");
    return Severity{(in.contact_degc - in.ambient_degc) / (in.mean_degc - in.ambient_degc),
                    (in.contact_degc + zero_celsius_k) / (in.melting_degc + zero_celsius_k),
                    in.melting_degc - in.contact_degc};
  });
}

Interface mean_interface_temperature(const InterfaceInputs& in) {
  return guarded<&mean_interface_temperature>(in, [&] {
    const double speed_mm_s = in.speed_m_min * 1000 / 60;
    const double number = speed_mm_s * in.chip_thickness_mm / in.diffusivity_mm2_s;
    return Interface{number, in.ambient_degc + in.coefficient * in.specific_energy_n_mm2 /
                                                   in.heat_capacity_n_mm2_k * std::cbrt(number)};
  });
}

SpeedLimit speed_limit_by_temperature(const SpeedLimitInputs& in) {
  return guarded<&speed_limit_by_temperature>(in, [&] {
    require(in.limit_degc > in.ambient_degc, "temperature_limit_degc", in.limit_degc,
            "must be above ambient_degc");
    const double cube_root_number = in.heat_capacity_n_mm2_k * (in.limit_degc - in.ambient_degc) /
                                    (in.coefficient * in.specific_energy_n_mm2 * in.hot_spot_factor);
    const double number = cube_root_number * cube_root_number * cube_root_number;
    return SpeedLimit{in.diffusivity_mm2_s / in.chip_thickness_mm * number * 60 / 1000};
  });
}

Flash asperity_flash_temperature(const AsperityInputs& in) {
  return guarded<&asperity_flash_temperature>(in, [&] {
    const double stress_mpa = std::min(in.friction * in.pressure_gpa * 1000, in.shear_limit_mpa);
    const double sliding_m_s = in.sliding_speed_m_min / 60;
    const double flux_w_mm2 = stress_mpa * sliding_m_s;  // MPa m/s = MW/m2 = W/mm2
    // um m/s over mm2/s is a pure number, and W/mm2 um is W/m: the powers of ten cancel in both.
    const double peclet = sliding_m_s * in.spot_radius_um / (2 * in.diffusivity_mm2_s);
    const double rise_k = in.heat_fraction * 2 * flux_w_mm2 * in.spot_radius_um /
                          (in.conductivity_w_mk * std::sqrt(std::numbers::pi * (1.273 + peclet)));
    return Flash{flux_w_mm2, peclet, rise_k};
  });
}

HotZone hot_zone_wear_multiplier(const HotZoneInputs& in) {
  return guarded<&hot_zone_wear_multiplier>(in, [&] {
    require(in.hot_degc >= in.mean_degc, "hot_temperature_degc", in.hot_degc,
            "must not be below mean_temperature_degc");
    const double per_kelvin = 1 / (in.mean_degc + zero_celsius_k) - 1 / (in.hot_degc + zero_celsius_k);
    const double exponent = in.activation_energy_kj_mol / gas_constant_kj_mol_k * per_kelvin;
    return HotZone{std::exp(exponent), 1 + in.hot_area_fraction * std::expm1(exponent)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K110",
       .title = "High-temperature phenomena in the cutting of materials",
       .authors = "Klimenko S. A., Manokhin A. S.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models = "Infrared measurements of the rake-face contact are two to three times hotter than the mean "
                 "cutting temperature. The quoted records, the hot-spot factor, mean interface temperature "
                 "and the speed it limits, flash temperature of an asperity, and the wear a hot zone adds.",
       .role = "thermal",
       .errata = {"The aluminium alloy is printed AlZnNgCu1.5; AlZnMgCu1.5 is meant.",
                  "The text cites figure 2b for the aluminium picture; the caption shows figure 1b."}});

  const Range ambient = closed(-50, 100);
  source
      .function<&published_contact_temperature>("published_contact_temperature",
                                                "A contact temperature that the paper quotes.", "text",
                                                Provenance::paper)
      .input(&RecordInputs::record, "record", "-", "-", no_range(), "record of the data table", "ti_ir_s02")
      .output(&PublishedTemperature::low_degc, "temperature_low_degc", "T", "degC", any(), "lower end")
      .output(&PublishedTemperature::high_degc, "temperature_high_degc", "T", "degC", any(), "upper end")
      .note(
          "Infrared records are an upper bound: emissivity and transmission of window and coating are not "
          "discussed. Do not feed them into a life law calibrated on mean temperatures.");
  source
      .function<&melting_temperature>("melting_temperature", "Melting temperature of the two alloys.", "text",
                                      Provenance::paper)
      .input(&MaterialInputs::material, "material", "-", "-", no_range(), "alloy", "TiAl6V4")
      .output(&Melting::temperature_degc, "melting_temperature_degc", "T_melt", "degC", positive(),
              "melting temperature");
  source
      .function<&thermal_severity>("thermal_severity",
                                   "Contact temperature against the mean and against melting.", "eq. (C1)",
                                   Provenance::completion)
      .input(&SeverityInputs::contact_degc, "contact_temperature_degc", "T_contact", "degC",
             closed(-50, 3000), "contact temperature, not below ambient", 2000.0)
      .input(&SeverityInputs::mean_degc, "mean_temperature_degc", "T_mean", "degC", above(-50),
             "mean temperature, above ambient", 900.0)
      .input(&SeverityInputs::melting_degc, "melting_temperature_degc", "T_melt", "degC", positive(),
             "melting temperature", 1650.0)
      .optional(&SeverityInputs::ambient_degc, "ambient_degc", "T_0", "degC", ambient, "ambient temperature")
      .output(&Severity::hot_spot_factor, "hot_spot_factor", "F_hot", "1", non_negative(),
              "rise of the contact over the mean rise")
      .output(&Severity::homologous_contact, "homologous_contact", "theta_h", "1", non_negative(),
              "contact over melting, absolute temperatures")
      .output(&Severity::melting_margin_degc, "melting_margin_degc", "dT_m", "degC", any(),
              "melting less contact temperature")
      .note("The paper's numbers give factors of 1.8 to 2.8; keep 1 in a production plan without own data.");
  const auto energy = [](auto& f) {
    using In = InterfaceInputs;
    f.input(&In::specific_energy_n_mm2, "specific_cutting_energy_n_mm2", "u", "N/mm2", closed(300, 5000),
            "specific cutting energy", 2030.0)
        .input(&In::heat_capacity_n_mm2_k, "heat_capacity_n_mm2_k", "rho c", "N/(mm2*K)", closed(1.5, 4),
               "volumetric heat capacity, the same number in J/(cm3*K)", 2.33)
        .input(&In::diffusivity_mm2_s, "diffusivity_mm2_s", "a", "mm2/s", closed(2, 100),
               "thermal diffusivity", 2.9);
  };
  source
      .function<&mean_interface_temperature>("mean_interface_temperature",
                                             "Mean tool-chip interface temperature.", "eq. (C2), Cook",
                                             Provenance::completion)
      .with(energy)
      .input(&InterfaceInputs::speed_m_min, "cutting_speed_m_min", "v", "m/min", closed(5, 2000),
             "cutting speed", 75.0)
      .input(&InterfaceInputs::chip_thickness_mm, "chip_thickness_mm", "h", "mm", closed(0.02, 1),
             "uncut chip thickness", 0.1)
      .optional(&InterfaceInputs::ambient_degc, "ambient_degc", "T_0", "degC", ambient, "ambient temperature")
      .optional(&InterfaceInputs::coefficient, "temperature_coefficient", "c_T", "1", positive(),
                "coefficient of Cook's formula")
      .output(&Interface::thermal_number, "thermal_number", "R", "1", positive(), "thermal number v h / a")
      .output(&Interface::mean_degc, "mean_temperature_degc", "T_mean", "degC", any(), "mean temperature")
      .note("For titanium calibrate the coefficient to 0.23-0.25: 0.4 overestimates the quoted 900 degC.");
  source
      .function<&speed_limit_by_temperature>("speed_limit_by_temperature",
                                             "Highest speed within a temperature limit.", "eq. (C3)",
                                             Provenance::completion)
      .input(&SpeedLimitInputs::specific_energy_n_mm2, "specific_cutting_energy_n_mm2", "u", "N/mm2",
             closed(300, 5000), "specific cutting energy", 2030.0)
      .input(&SpeedLimitInputs::heat_capacity_n_mm2_k, "heat_capacity_n_mm2_k", "rho c", "N/(mm2*K)",
             closed(1.5, 4), "volumetric heat capacity, the same number in J/(cm3*K)", 2.33)
      .input(&SpeedLimitInputs::diffusivity_mm2_s, "diffusivity_mm2_s", "a", "mm2/s", closed(2, 100),
             "thermal diffusivity", 2.9)
      .input(&SpeedLimitInputs::chip_thickness_mm, "chip_thickness_mm", "h", "mm", closed(0.02, 1),
             "uncut chip thickness", 0.15)
      .input(&SpeedLimitInputs::limit_degc, "temperature_limit_degc", "T_lim", "degC", above(-50),
             "limit of the contact temperature, above ambient", 1650.0)
      .optional(&SpeedLimitInputs::ambient_degc, "ambient_degc", "T_0", "degC", ambient,
                "ambient temperature")
      .optional(&SpeedLimitInputs::hot_spot_factor, "hot_spot_factor", "F_hot", "1", at_least(1),
                "rise of the hot spots over the mean rise")
      .optional(&SpeedLimitInputs::coefficient, "temperature_coefficient", "c_T", "1", positive(),
                "coefficient of Cook's formula")
      .output(&SpeedLimit::speed_m_min, "speed_limit_m_min", "v_lim", "m/min", non_negative(),
              "highest cutting speed");
  source
      .function<&asperity_flash_temperature>("asperity_flash_temperature",
                                             "Rise of temperature on one real contact spot.",
                                             "eq. (C4), Jaeger, Tian-Kennedy", Provenance::completion)
      .input(&AsperityInputs::pressure_gpa, "contact_pressure_gpa", "p", "GPa", closed(0.1, 10),
             "contact pressure, 1-4 in the paper", 2.0)
      .input(&AsperityInputs::friction, "friction_coefficient", "f", "1", closed(0.05, 1),
             "friction coefficient", 0.3)
      .input(&AsperityInputs::shear_limit_mpa, "shear_limit_mpa", "tau_s", "MPa", positive(),
             "shear strength of the softer body, caps the friction stress", 500.0)
      .input(&AsperityInputs::sliding_speed_m_min, "sliding_speed_m_min", "U", "m/min", positive(),
             "sliding speed: of the chip on the rake face", 100.0)
      .input(&AsperityInputs::spot_radius_um, "spot_radius_um", "r", "um", closed(0.5, 50),
             "radius of the spot", 5.0)
      .input(&AsperityInputs::conductivity_w_mk, "conductivity_w_mk", "k", "W/(m*K)", positive(),
             "conductivity of the body that takes the heat", 6.7)
      .input(&AsperityInputs::diffusivity_mm2_s, "diffusivity_mm2_s", "a", "mm2/s", positive(),
             "diffusivity of that body", 2.9)
      .input(&AsperityInputs::heat_fraction, "heat_fraction", "beta", "1", closed(0, 1),
             "share of the frictional heat entering it", 0.5)
      .output(&Flash::heat_flux_w_mm2, "heat_flux_w_mm2", "q", "W/mm2", non_negative(),
              "frictional heat, before the split")
      .output(&Flash::peclet, "peclet", "Pe", "1", non_negative(), "Peclet number of the spot")
      .output(&Flash::rise_k, "flash_rise_degc", "dT_f", "K", non_negative(),
              "rise above the surrounding surface");
  source
      .function<&hot_zone_wear_multiplier>("hot_zone_wear_multiplier",
                                           "Factor on a thermally activated wear rate by a hot zone.",
                                           "eq. (C5), Arrhenius", Provenance::completion)
      .input(&HotZoneInputs::mean_degc, "mean_temperature_degc", "T_m", "degC", closed(20, 3000),
             "temperature of the contact outside the hot zone", 900.0)
      .input(&HotZoneInputs::hot_degc, "hot_temperature_degc", "T_h", "degC", closed(20, 3000),
             "temperature of the hot zone, not below the mean", 1300.0)
      .input(&HotZoneInputs::hot_area_fraction, "hot_area_fraction", "phi", "1", closed(0, 1),
             "hot share of the contact area", 0.05)
      .input(&HotZoneInputs::activation_energy_kj_mol, "activation_energy_kj_mol", "E", "kJ/mol",
             closed(0, 1000), "activation energy of wear", 80.0)
      .output(&HotZone::local_rate_ratio, "local_rate_ratio", "K", "1", at_least(1),
              "wear rate of the hot zone over the rest")
      .output(&HotZone::mean_rate_multiplier, "mean_rate_multiplier", "M", "1", at_least(1),
              "mean wear rate over that of a contact at the mean temperature")
      .note(
          "Compares with a contact that runs at the mean temperature everywhere: small fractions are "
          "meant.");
}

}  // namespace verstat::models::k110
