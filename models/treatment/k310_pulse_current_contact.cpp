#include "models/treatment/k310_pulse_current_contact.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verstat::models::k310 {
namespace {

constexpr double lorenz_v2_k2 = 2.4e-8;  // printed under eq. (2)
constexpr double zero_celsius_k = 273.15;

double heat_power_kw(double current_a, double resistance_mohm) {
  return current_a * current_a * resistance_mohm * 1e-6;
}

}  // namespace

HeatPower contact_heat_power(const ContactCurrent& in) {
  return guarded<&contact_heat_power>(
      in, [&] { return HeatPower{heat_power_kw(in.current_a, in.resistance_mohm)}; });
}

Temperature constriction_temperature(const ConstrictionVoltageDrop& in) {
  return guarded<&constriction_temperature>(in, [&] {
    const double body_k = in.body_temperature_c + zero_celsius_k;
    return Temperature{std::sqrt(body_k * body_k + in.voltage_v * in.voltage_v / (4 * lorenz_v2_k2)) -
                       zero_celsius_k};
  });
}

Voltage constriction_voltage(const ConstrictionTemperature& in) {
  return guarded<&constriction_voltage>(in, [&] {
    require(in.temperature_c >= in.body_temperature_c, "T", in.temperature_c, "must not be below T_body");
    const double spot_k = in.temperature_c + zero_celsius_k;
    const double body_k = in.body_temperature_c + zero_celsius_k;
    return Voltage{2 * std::sqrt(lorenz_v2_k2 * (spot_k * spot_k - body_k * body_k))};
  });
}

Resistance constriction_resistance(const Constriction& in) {
  return guarded<&constriction_resistance>(in, [&] {
    return Resistance{1000 * in.resistivity_uohm_m / (2 * static_cast<double>(in.spots) * in.spot_radius_um)};
  });
}

SpecificPower specific_power(const LoadedSpots& in) {
  return guarded<&specific_power>(in, [&] {
    const double radius_mm = in.spot_radius_um * 1e-3;
    const double contact_mm2 = static_cast<double>(in.spots) * std::numbers::pi * radius_mm * radius_mm;
    return SpecificPower{heat_power_kw(in.current_a, in.resistance_mohm) / contact_mm2};
  });
}

CurrentDensity current_density(const CurrentThroughArea& in) {
  return guarded<&current_density>(in, [&] { return CurrentDensity{100 * in.current_a / in.area_mm2}; });
}

Energy pulse_energy(const Pulse& in) {
  return guarded<&pulse_energy>(
      in, [&] { return Energy{in.current_a * in.current_a * in.resistance_mohm * in.pulse_us * 1e-9}; });
}

SettlingState quasi_steady(const SettlingTime& in) {
  return guarded<&quasi_steady>(in, [&] {
    require(in.settling_min_us <= in.settling_max_us, "t_min", in.settling_min_us, "must not be above t_max");
    if (in.pulse_us < in.settling_min_us) return SettlingState{Settling::transient};
    if (in.pulse_us > in.settling_max_us) return SettlingState{Settling::steady};
    return SettlingState{Settling::intermediate};
  });
}

SetupFeasibility setup_feasible(const SetupRegime& in) {
  return guarded<&setup_feasible>(in, [&] {
    const double current_a = std::abs(in.current_a);
    const double voltage_v = in.output_voltage_v;
    return SetupFeasibility{.generates = voltage_v >= 30 && voltage_v <= 450 && current_a <= 300 &&
                                         in.pulse_us >= 10 && in.pulse_us <= 1e5,
                            .measurable = voltage_v >= 0 && voltage_v <= 500 && current_a <= 200};
  });
}

TreatmentTime treatment_time(const TreatedArea& in) {
  return guarded<&treatment_time>(in, [&] {
    // 1e-9 keeps a spot count that is whole by design from being rounded up.
    const double spots = std::max(1.0, std::ceil(in.area_mm2 / (in.spot_area_mm2 * (1 - in.overlap)) - 1e-9));
    const double pulses = spots * static_cast<double>(in.pulses_per_spot);
    require(pulses < 1e15, "area", in.area_mm2, "asks for more than 1e15 pulses");
    return TreatmentTime{static_cast<std::int64_t>(pulses), pulses / (60 * in.frequency_hz)};
  });
}

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K310",
       .title =
           "Working out of an experimental installation for researches of parameters of the electric current",
       .authors = "Zhartovskyi O. V., Shyshkin A. V.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "A pulse generator and measuring chain for current through the few real contact spots between an "
           "electrode and a workpiece: heat power in the contact and temperature of the constriction, the "
           "basis of electro-contact coating against wear and of diffusion welding.",
       .role = "treatment",
       .errata = {
           "Eq. (2) is printed as T - T0 = L (U/4)^2, which has the unit V^4/K^2; the Kohlrausch relation "
           "T^2 - T0^2 = U^2/(4 L) is the only one with these symbols and meets the known softening and "
           "melting points of copper contacts."}});

  const auto current = [](auto& f) {
    f.input(&ContactCurrent::current_a, "I", "I", "A", any(), "current through the contact", 200.0)
        .input(&ContactCurrent::resistance_mohm, "R", "R_per", "mOhm", non_negative(),
               "constriction resistance", 1.0);
  };
  const auto spots = [](auto& f) {
    f.input(&LoadedSpots::spot_radius_um, "a", "a", "um", positive(), "radius of a contact spot", 50.0)
        .input(&LoadedSpots::spots, "n", "n", "1", at_least(1), "number of contact spots", 10);
  };

  source
      .function<&contact_heat_power>("contact_heat_power", "Heat power released in the contact.", "eq. (1)",
                                     Provenance::paper)
      .with(current)
      .output(&HeatPower::power_kw, "P", "P", "kW", non_negative(), "heat power");
  source
      .function<&constriction_temperature>("constriction_temperature",
                                           "Highest temperature of the contact spot at a given voltage drop.",
                                           "eq. (2)", Provenance::repaired)
      .input(&ConstrictionVoltageDrop::voltage_v, "U", "U", "V", non_negative(),
             "voltage drop in the constriction", 0.12)
      .input(&ConstrictionVoltageDrop::body_temperature_c, "T_body", "T_0", "degC", at_least(-273.15),
             "temperature of the body", 20.0)
      .output(&Temperature::temperature_c, "T", "T", "degC", at_least(-273.15), "temperature of the spot")
      .note("Steady state; an upper bound for pulses shorter than 0.1-5 ms.");
  source
      .function<&constriction_voltage>("constriction_voltage",
                                       "Voltage drop that heats the spot to a temperature.",
                                       "eq. (2), inverse", Provenance::repaired)
      .input(&ConstrictionTemperature::temperature_c, "T", "T", "degC", at_least(-273.15),
             "temperature of the spot", 1083.0)
      .input(&ConstrictionTemperature::body_temperature_c, "T_body", "T_0", "degC", at_least(-273.15),
             "temperature of the body", 20.0)
      .output(&Voltage::voltage_v, "U", "U", "V", non_negative(), "voltage drop in the constriction");
  source
      .function<&constriction_resistance>("constriction_resistance",
                                          "Resistance of n equal round contact spots.", "completion (Holm)",
                                          Provenance::completion)
      .input(&Constriction::resistivity_uohm_m, "rho", "rho", "uOhm*m", positive(),
             "resistivity of both members (unlike members: the mean)", 0.2)
      .input(&Constriction::spot_radius_um, "a", "a", "um", positive(), "radius of a contact spot", 50.0)
      .input(&Constriction::spots, "n", "n", "1", at_least(1), "number of contact spots", 1)
      .output(&Resistance::resistance_mohm, "R", "R_per", "mOhm", positive(), "constriction resistance");
  source
      .function<&specific_power>("specific_power", "Heat power per area of real contact.", "completion",
                                 Provenance::completion)
      .with(current)
      .with(spots)
      .output(&SpecificPower::specific_power_kw_mm2, "p", "p", "kW/mm2", non_negative(), "specific power");
  source
      .function<&current_density>("current_density", "Current density over an area.", "definition",
                                  Provenance::completion)
      .input(&CurrentThroughArea::current_a, "I", "I", "A", any(), "current", 200.0)
      .input(&CurrentThroughArea::area_mm2, "area", "A", "mm2", positive(), "area", 0.01)
      .output(&CurrentDensity::density_a_cm2, "j", "j", "A/cm2", any(), "current density");
  source
      .function<&pulse_energy>("pulse_energy", "Heat of one rectangular pulse.", "eq. (1) times pulse length",
                               Provenance::paper)
      .with(current)
      .input(&Pulse::pulse_us, "tau", "tau", "us", non_negative(), "pulse length", 1000.0)
      .output(&Energy::energy_j, "E", "E", "J", non_negative(), "heat of the pulse");
  source
      .function<&quasi_steady>("quasi_steady", "Whether the spot settles within the pulse.", "text",
                               Provenance::reconstructed)
      .input(&SettlingTime::pulse_us, "tau", "tau", "us", non_negative(), "pulse length", 50.0)
      .optional(&SettlingTime::settling_min_us, "t_min", "t_min", "us", positive(), "shortest settling time")
      .optional(&SettlingTime::settling_max_us, "t_max", "t_max", "us", positive(), "longest settling time")
      .output(&SettlingState::state, "state", "-", "-", no_range(), "state at the end of the pulse");
  source
      .function<&setup_feasible>("setup_feasible",
                                 "Whether the published set-up can make and record the pulse.",
                                 "data of the set-up", Provenance::paper)
      .input(&SetupRegime::output_voltage_v, "U", "U", "V", any(), "output voltage of the generator", 100.0)
      .input(&SetupRegime::current_a, "I", "I", "A", any(), "current", 100.0)
      .input(&SetupRegime::pulse_us, "tau", "tau", "us", non_negative(), "pulse length", 100.0)
      .output(&SetupFeasibility::generates, "generates", "-", "-", no_range(),
              "the generator delivers the pulse")
      .output(&SetupFeasibility::measurable, "measurable", "-", "-", no_range(), "the sensors record it");
  source
      .function<&treatment_time>("treatment_time", "Pulses and time to cover an area with overlapping spots.",
                                 "completion", Provenance::completion)
      .input(&TreatedArea::area_mm2, "area", "A", "mm2", positive(), "area to treat", 1000.0)
      .input(&TreatedArea::spot_area_mm2, "spot_area", "A_s", "mm2", positive(), "area of one spot", 4.0)
      .input(&TreatedArea::overlap, "overlap", "-", "1", open_high(0, 1), "share of a spot covered again",
             0.3)
      .input(&TreatedArea::pulses_per_spot, "pulses_per_spot", "-", "1", at_least(1), "pulses on one spot", 2)
      .input(&TreatedArea::frequency_hz, "frequency", "f", "Hz", positive(), "pulse frequency", 5.0)
      .output(&TreatmentTime::pulses, "pulses", "-", "1", at_least(1), "number of pulses")
      .output(&TreatmentTime::time_min, "t", "t", "min", positive(), "treatment time");
}

}  // namespace verstat::models::k310
