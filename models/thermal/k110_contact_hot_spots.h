#pragma once
// High-temperature phenomena at the tool-chip contact (K110): published contact temperatures, how far hot
// spots exceed the mean, mean interface temperature and the speed it limits, flash temperature of an
// asperity, and the wear that a hot zone adds.
//
// Klimenko, Manokhin 2011. The paper prints no equation: all but the two look-ups are COMPLETIONS.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k110 {

enum class Record { ti_ir_s02, ti_ir_s03, al_ir, ti_fem_a, ti_fem_b, ti_mean, al_diamond_mean };
struct RecordInputs {
  Record record = Record::ti_ir_s02;
};
struct PublishedTemperature {
  double low_degc;
  double high_degc;
};
/// One contact temperature that the paper quotes; both ends equal when it gives one value.
[[nodiscard]] PublishedTemperature published_contact_temperature(const RecordInputs& in);

enum class Material { ti_al6_v4, al_zn_mg_cu1_5 };
struct MaterialInputs {
  Material material = Material::ti_al6_v4;
};
struct Melting {
  double temperature_degc;
};
/// Melting temperature of the two alloys, as quoted.
[[nodiscard]] Melting melting_temperature(const MaterialInputs& in);

struct SeverityInputs {
  double contact_degc = 0;
  double mean_degc = 0;
  double melting_degc = 0;
  double ambient_degc = 20;
};
struct Severity {
  double hot_spot_factor;
  double homologous_contact;
  double melting_margin_degc;
};
/// Contact temperature against the mean (as rises above ambient) and against melting. COMPLETION (C1).
[[nodiscard]] Severity thermal_severity(const SeverityInputs& in);

struct InterfaceInputs {
  double specific_energy_n_mm2 = 0;
  double heat_capacity_n_mm2_k = 0;
  double diffusivity_mm2_s = 0;
  double speed_m_min = 0;
  double chip_thickness_mm = 0;
  double ambient_degc = 20;
  double coefficient = 0.4;
};
struct Interface {
  double thermal_number;
  double mean_degc;
};
/// Mean tool-chip interface temperature, T = T_0 + c u/(rho c) (v h/a)^(1/3). COMPLETION (C2), Cook.
[[nodiscard]] Interface mean_interface_temperature(const InterfaceInputs& in);

struct SpeedLimitInputs {
  double specific_energy_n_mm2 = 0;
  double heat_capacity_n_mm2_k = 0;
  double diffusivity_mm2_s = 0;
  double chip_thickness_mm = 0;
  double limit_degc = 0;
  double ambient_degc = 20;
  double hot_spot_factor = 1;
  double coefficient = 0.4;
};
struct SpeedLimit {
  double speed_m_min;
};
/// Highest speed at which mean rise times hot-spot factor stays within a limit. COMPLETION (C3), the inverse
/// of (C2); not clamped to its speed range.
[[nodiscard]] SpeedLimit speed_limit_by_temperature(const SpeedLimitInputs& in);

struct AsperityInputs {
  double pressure_gpa = 0;
  double friction = 0;
  double shear_limit_mpa = 0;  // of the softer body
  double sliding_speed_m_min = 0;
  double spot_radius_um = 0;
  double conductivity_w_mk = 0;
  double diffusivity_mm2_s = 0;  // of the body that takes the heat
  double heat_fraction = 0;
};
struct Flash {
  double heat_flux_w_mm2;
  double peclet;
  double rise_k;
};
/// Rise of temperature on one contact spot, 2 beta q r / (k sqrt(pi (1.273 + Pe))). COMPLETION (C4), Jaeger's
/// source in the interpolation of Tian and Kennedy.
[[nodiscard]] Flash asperity_flash_temperature(const AsperityInputs& in);

struct HotZoneInputs {
  double mean_degc = 0;
  double hot_degc = 0;
  double hot_area_fraction = 0;
  double activation_energy_kj_mol = 0;
};
struct HotZone {
  double local_rate_ratio;
  double mean_rate_multiplier;
};
/// Factor on a thermally activated wear rate when a fraction of the contact is hotter than the rest.
/// COMPLETION (C5), Arrhenius.
[[nodiscard]] HotZone hot_zone_wear_multiplier(const HotZoneInputs& in);

}  // namespace verstat::models::k110

template <>
struct verstat::models::EnumNames<verstat::models::k110::Record> {
  using E = k110::Record;
  static constexpr std::array names{std::pair{E::ti_ir_s02, "ti_ir_s02"},
                                    std::pair{E::ti_ir_s03, "ti_ir_s03"},
                                    std::pair{E::al_ir, "al_ir"},
                                    std::pair{E::ti_fem_a, "ti_fem_a"},
                                    std::pair{E::ti_fem_b, "ti_fem_b"},
                                    std::pair{E::ti_mean, "ti_mean"},
                                    std::pair{E::al_diamond_mean, "al_diamond_mean"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k110::Material> {
  static constexpr std::array names{std::pair{k110::Material::ti_al6_v4, "TiAl6V4"},
                                    std::pair{k110::Material::al_zn_mg_cu1_5, "AlZnMgCu1.5"}};
};
