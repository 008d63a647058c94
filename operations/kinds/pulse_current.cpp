#include "operations/kinds/pulse_current.h"

#include "models/treatment/k310_pulse_current_contact.h"
#include "operations/fields.h"
#include "operations/machine_load.h"

template <>
struct verstat::models::StructFields<verstat::operations::PulseCurrent> {
  static std::vector<Field> fields() {
    using S = operations::PulseCurrent;
    return {need<S>(&S::area_mm2, "area_mm2", "mm2", open_low(0, 1e8), "area that is treated"),
            need<S>(&S::spot_area_mm2, "spot_area_mm2", "mm2", open_low(0, 1e6), "area that a pulse treats"),
            may<S>(&S::overlap, "overlap", "1", open_high(0, 1), "overlap of neighbouring spots"),
            may<S>(&S::pulses_per_spot, "pulses_per_spot", "1", closed(1, 100'000), "pulses on each spot"),
            need<S>(&S::frequency_hz, "frequency_hz", "Hz", open_low(0, 1e6), "pulses per second"),
            need<S>(&S::current_a, "current_a", "A", open_low(0, 1e6), "current of a pulse"),
            need<S>(&S::pulse_us, "pulse_us", "us", open_low(0, 1e7), "length of a pulse"),
            need<S>(&S::generator_voltage_v, "generator_voltage_v", "V", open_low(0, 1e5),
                    "voltage of the generator"),
            need<S>(&S::resistivity_uohm_m, "resistivity_uohm_m", "uOhm m", open_low(0, 1e3),
                    "mean resistivity of electrode and part"),
            need<S>(&S::contact_radius_um, "contact_radius_um", "um", open_low(0, 1e4),
                    "radius of a real contact spot"),
            may<S>(&S::contacts, "contacts", "1", closed(1, 1'000'000), "real contact spots at a time"),
            may<S>(&S::body_temperature_c, "body_temperature_c", "degC", closed(-50, 1000),
                   "temperature of the part"),
            need<S>(&S::bonding_temperature_c, "bonding_temperature_c", "degC", closed(0, 1e4),
                    "temperature that bonding needs"),
            need<S>(&S::boiling_temperature_c, "boiling_temperature_c", "degC", closed(0, 1e4),
                    "temperature that would spoil the spot"),
            may<S>(&S::life_factor, "life_factor", "1", closed(0.01, 100),
                   "mean life of a coated tool or part over that as delivered, to be measured"),
            may<S>(&S::life_law, "life_law", "-", no_range(), "life law of coated tools"),
            may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2), "scatter of their lives"),
            may<S>(&S::breakage_fraction, "breakage_fraction", "1", probability(),
                   "share of their lives that end by breakage"),
            may<S>(&S::cost_per_piece, "cost_per_piece", "money", closed(0, 1e9),
                   "of treating a tool of the lot")};
  }
};

namespace verstat::operations {

namespace k310 = models::k310;

CutPlan plan(const PulseCurrent& spec, const PlanContext& context) {
  models::require(spec.bonding_temperature_c < spec.boiling_temperature_c, "bonding_temperature_c",
                  spec.bonding_temperature_c, "must be below boiling_temperature_c");
  const auto time = k310::treatment_time({.area_mm2 = spec.area_mm2,
                                          .spot_area_mm2 = spec.spot_area_mm2,
                                          .overlap = spec.overlap,
                                          .pulses_per_spot = spec.pulses_per_spot,
                                          .frequency_hz = spec.frequency_hz});
  const double resistance_mohm =
      k310::constriction_resistance({spec.resistivity_uohm_m, spec.contact_radius_um, spec.contacts})
          .resistance_mohm;
  const k310::ContactCurrent contact{spec.current_a, resistance_mohm};
  const double drop_v = spec.current_a * resistance_mohm / 1000;
  const double temperature_c =
      k310::constriction_temperature({drop_v, spec.body_temperature_c}).temperature_c;
  k310::Pulse pulse;
  static_cast<k310::ContactCurrent&>(pulse) = contact;
  pulse.pulse_us = spec.pulse_us;
  k310::LoadedSpots spots;
  static_cast<k310::ContactCurrent&>(spots) = contact;
  spots.spot_radius_um = spec.contact_radius_um;
  spots.spots = spec.contacts;
  const double energy_j = k310::pulse_energy(pulse).energy_j;
  const auto state = k310::quasi_steady({.pulse_us = spec.pulse_us}).state;
  const auto setup = k310::setup_feasible({spec.generator_voltage_v, spec.current_a, spec.pulse_us});

  CutPlan p;
  p.quantities.reserve(14);
  p.set_main_time(time.time_min, "K310.treatment_time");
  auto& q = p.quantities;
  q.push_back({"pulses", static_cast<double>(time.pulses), "1", "K310.treatment_time", "pulses of a part"});
  q.push_back({"contact_resistance_mohm", resistance_mohm, "mOhm", "K310.constriction_resistance",
               "resistance of the cold contact spots"});
  q.push_back({"voltage_drop_v", drop_v, "V", "definition", "over the contact spots"});
  q.push_back({"spot_temperature_c", temperature_c, "degC", "K310.constriction_temperature",
               "highest temperature of a spot; an upper bound for short pulses"});
  q.push_back({"settled", static_cast<double>(state), "1", "K310.quasi_steady",
               "2: the spot reaches it, 1: perhaps, 0: the pulse is too short"});
  q.push_back({"heat_power_kw", k310::contact_heat_power(contact).power_kw, "kW", "K310.contact_heat_power",
               "heat in the contact while a pulse lasts"});
  q.push_back({"specific_power_kw_mm2", k310::specific_power(spots).specific_power_kw_mm2, "kW/mm2",
               "K310.specific_power", "heat per area of real contact"});
  q.push_back({"pulse_energy_j", energy_j, "J", "K310.pulse_energy", "heat of a pulse"});
  q.push_back({"current_density_a_cm2",
               k310::current_density({spec.current_a, spec.spot_area_mm2}).density_a_cm2, "A/cm2",
               "K310.current_density", "over the treated spot"});
  q.push_back({"measurable", setup.measurable ? 1.0 : 0.0, "1", "K310.setup_feasible",
               "1: the sensors of the published set-up can record the pulse"});
  p.limits.push_back({"bonding_temperature_c", temperature_c, spec.bonding_temperature_c, false, "degC",
                      "K310.constriction_temperature"});
  p.limits.push_back({"boiling_temperature_c", temperature_c, spec.boiling_temperature_c, true, "degC",
                      "K310.constriction_temperature"});
  p.limits.push_back({"setup_generates", setup.generates ? 1.0 : 0.0, 1, false, "1",
                      "K310.setup_feasible: the published generator"});
  q.push_back({"life_factor", spec.life_factor, "1", "given; K310 has no data",
               "mean life of a coated tool or part over that as delivered"});
  p.leave("life_factor");
  p.lot = PreparedLot{.law = spec.life_law,
                      .life_factor = spec.life_factor,
                      .cv = spec.life_cv,
                      .breakage_fraction = spec.breakage_fraction,
                      .added_cost_per_insert = spec.cost_per_piece,
                      .origin = "given; K310 has no data"};
  limit_power(p, context, energy_j * spec.frequency_hz / 1000, "K310.pulse_energy");
  p.consumables.push_back({"heat_j", energy_j * static_cast<double>(time.pulses), "J", "K310.pulse_energy",
                           "heat brought into the contact"});
  return p;
}

namespace pulse_current {
void add_to(Kinds& kinds) {
  kinds.add<PulseCurrent>("A surface coated or welded spot by spot with current pulses.", {"K310"});
}
}  // namespace pulse_current

}  // namespace verstat::operations
