#pragma once
// Current pulses through the few real contact spots between an electrode and a workpiece: electro-contact
// coating and diffusion welding (K310). The heat of a pulse, the temperature of the constriction, and whether
// the published set-up can make and record the regime.
//
// Zhartovskyi, Shyshkin 2011. Inputs carry the symbols of the card in JSON; members carry their units.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k310 {

struct ContactCurrent {
  double current_a = 0;
  double resistance_mohm = 0;
};
struct HeatPower {
  double power_kw;
};
/// Heat released in the constriction, P = I^2 R. Current any sign, resistance >= 0. K310 eq. (1).
[[nodiscard]] HeatPower contact_heat_power(const ContactCurrent& in);

struct ConstrictionVoltageDrop {
  double voltage_v = 0;
  double body_temperature_c = 20;
};
struct Temperature {
  double temperature_c;
};
/// Highest temperature of a quasi-steady constriction with the voltage drop U >= 0:
///   T^2 - T_0^2 = U^2 / (4 L) in kelvin, L = 2.4e-8 V^2/K^2.   K310 eq. (2), repaired: printed L (U/4)^2.
/// Upper bound for pulses shorter than the settling time.
[[nodiscard]] Temperature constriction_temperature(const ConstrictionVoltageDrop& in);

struct ConstrictionTemperature {
  double temperature_c = 0;
  double body_temperature_c = 20;
};
struct Voltage {
  double voltage_v;
};
/// Voltage drop that heats the constriction to T >= T_body. Inverse of constriction_temperature.
[[nodiscard]] Voltage constriction_voltage(const ConstrictionTemperature& in);

struct Constriction {
  double resistivity_uohm_m = 0;  // of unlike members: the mean
  double spot_radius_um = 0;
  std::int64_t spots = 1;
};
struct Resistance {
  double resistance_mohm;
};
/// Constriction resistance of n equal independent round spots, R = rho / (2 n a). COMPLETION (Holm).
/// The cold resistivity underestimates a hot spot.
[[nodiscard]] Resistance constriction_resistance(const Constriction& in);

struct LoadedSpots : ContactCurrent {
  double spot_radius_um = 0;
  std::int64_t spots = 1;
};
struct SpecificPower {
  double specific_power_kw_mm2;
};
/// Heat power per area of real contact, p = P / (n pi a^2). COMPLETION.
[[nodiscard]] SpecificPower specific_power(const LoadedSpots& in);

struct CurrentThroughArea {
  double current_a = 0;
  double area_mm2 = 0;
};
struct CurrentDensity {
  double density_a_cm2;
};
/// Current density j = I / area.
[[nodiscard]] CurrentDensity current_density(const CurrentThroughArea& in);

struct Pulse : ContactCurrent {
  double pulse_us = 0;
};
struct Energy {
  double energy_j;
};
/// Heat of one rectangular pulse, E = I^2 R tau.
[[nodiscard]] Energy pulse_energy(const Pulse& in);

enum class Settling { transient, intermediate, steady };
struct SettlingTime {
  double pulse_us = 0;
  double settling_min_us = 100;
  double settling_max_us = 5000;
};
struct SettlingState {
  Settling state;
};
/// Whether the spot reaches its steady temperature within the pulse; both limits count as intermediate.
[[nodiscard]] SettlingState quasi_steady(const SettlingTime& in);

struct SetupRegime {
  double output_voltage_v = 0;  // of the generator, not the drop in the constriction
  double current_a = 0;
  double pulse_us = 0;
};
struct SetupFeasibility {
  bool generates;
  bool measurable;
};
/// Whether the published set-up can generate the pulse and whether its sensors can record it.
[[nodiscard]] SetupFeasibility setup_feasible(const SetupRegime& in);

struct TreatedArea {
  double area_mm2 = 0;
  double spot_area_mm2 = 0;
  double overlap = 0;
  std::int64_t pulses_per_spot = 1;
  double frequency_hz = 0;
};
struct TreatmentTime {
  std::int64_t pulses;
  double time_min;
};
/// Pulses and time to cover an area spot by spot with overlapping spots. COMPLETION.
[[nodiscard]] TreatmentTime treatment_time(const TreatedArea& in);

}  // namespace verstat::models::k310

template <>
struct verstat::models::EnumNames<verstat::models::k310::Settling> {
  static constexpr std::array names{std::pair{k310::Settling::transient, "transient"},
                                    std::pair{k310::Settling::intermediate, "intermediate"},
                                    std::pair{k310::Settling::steady, "steady"}};
};
