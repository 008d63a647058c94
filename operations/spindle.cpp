#include "operations/spindle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/tools/minima.hpp>

#include "models/dynamics/k201_bearing_resonance.h"
#include "models/dynamics/k206_spindle_base_frequencies.h"
#include "models/dynamics/k210_hydrostatic_bearing.h"
#include "models/grinding/k209_grinding_wheel_radial_oscillations.h"
#include "operations/fields.h"

template <>
struct verstat::models::EnumNames<verstat::operations::ToolHolder> {
  using E = operations::ToolHolder;
  static constexpr std::array names{std::pair{E::rigid, "rigid"}, std::pair{E::rocking, "rocking"},
                                    std::pair{E::floating, "floating"}};
};

namespace verstat::models {

using namespace operations;

template <>
struct StructFields<BearingResonance> {
  static std::vector<Field> fields() {
    using S = BearingResonance;
    return {
        may<S>(&S::ball_diameter_mm, "ball_diameter_mm", "mm", open_low(0, 500), "ball diameter"),
        may<S>(&S::pitch_diameter_mm, "pitch_diameter_mm", "mm", open_low(0, 5000), "pitch diameter"),
        may<S>(&S::contact_angle_deg, "contact_angle_deg", "deg", closed(0, 40), "contact angle"),
        may<S>(&S::harmonic, "harmonic", "1", closed(1, 1000),
               "harmonic of the cage speed that modulates the stiffness"),
        may<S>(&S::damping_ratio, "damping_ratio", "1", closed(0, 0.5), "damping over critical damping"),
        entries(need<S>(&S::speed_nodes_rpm, "speed_nodes_rpm", "rpm", open_low(0, 1e6),
                        "speeds at which frequency and modulation are known, rising"),
                1, 1000),
        entries(need<S>(&S::natural_frequency_hz, "natural_frequency_hz", "Hz", open_low(0, 1e5),
                        "natural frequency of the ring at these speeds"),
                1, 1000),
        entries(need<S>(&S::stiffness_ratio, "stiffness_ratio", "1", closed(0, 1),
                        "amplitude of the stiffness over its mean at these speeds"),
                1, 1000),
        may<S>(&S::speed_step_rpm, "speed_step_rpm", "rpm", closed(1, 1e5), "step of the search for bands")};
  }
};

template <>
struct StructFields<ElasticBase> {
  static std::vector<Field> fields() {
    using S = ElasticBase;
    const auto lengths = [](std::vector<double> S::*pointer, const char* name, double low,
                            const char* meaning) {
      return entries(need<S>(pointer, name, "mm", closed(low, 10'000), meaning), 1, 30);
    };
    return {
        lengths(&S::spindle_length_mm, "spindle_length_mm", 0.01, "segments of the spindle, nose first"),
        lengths(&S::spindle_outer_mm, "spindle_outer_mm", 0.01, "their outer diameters"),
        lengths(&S::spindle_inner_mm, "spindle_inner_mm", 0, "their bores"),
        lengths(&S::sleeve_length_mm, "sleeve_length_mm", 0.01, "segments of the sleeve"),
        lengths(&S::sleeve_outer_mm, "sleeve_outer_mm", 0.01, "their outer diameters"),
        lengths(&S::sleeve_inner_mm, "sleeve_inner_mm", 0, "their bores"),
        entries(need<S>(&S::bearing_section, "bearing_section", "-", closed(0, 30),
                        "sections of both rods that bearings join"),
                1, 30),
        entries(need<S>(&S::bearing_k_n_um, "bearing_k_n_um", "N/um", open_low(0, 1e6),
                        "radial stiffness of the bearings"),
                1, 30),
        entries(need<S>(&S::support_section, "support_section", "-", closed(0, 30),
                        "sections of the sleeve that rest on springs"),
                1, 30),
        entries(need<S>(&S::support_k_n_um, "support_k_n_um", "N/um", open_low(0, 1e6),
                        "stiffness of these springs"),
                1, 30),
        may<S>(&S::modulus_gpa, "modulus_gpa", "GPa", open_low(0, 1000), "modulus of elasticity"),
        may<S>(&S::density_kg_m3, "density_kg_m3", "kg/m3", open_low(0, 25'000), "density"),
        may<S>(&S::modes, "modes", "1", closed(1, 10), "natural frequencies that are looked at"),
        may<S>(&S::loss_factor, "loss_factor", "1", closed(0.001, 0.2), "loss factor of rods and springs"),
        may<S>(&S::resonance_margin, "resonance_margin", "1", open(0, 1),
               "half width of a forbidden band over its frequency"),
        may<S>(&S::orientation_factor, "orientation_factor", "1", open_low(0, 1),
               "of the cutting force to the mode")};
  }
};

template <>
struct StructFields<HydrostaticSupport> {
  static std::vector<Field> fields() {
    using S = HydrostaticSupport;
    return {
        may<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 5000), "diameter of the journal"),
        may<S>(&S::length_mm, "length_mm", "mm", open_low(0, 5000), "length of the bearing"),
        may<S>(&S::pockets, "pockets", "1", closed(3, 64), "number of pockets"),
        may<S>(&S::pocket_length_mm, "pocket_length_mm", "mm", open_low(0, 5000), "pocket along the axis"),
        may<S>(&S::pocket_width_mm, "pocket_width_mm", "mm", open_low(0, 5000),
               "pocket along the circumference"),
        may<S>(&S::radial_clearance_um, "radial_clearance_um", "um", open_low(0, 1000), "radial clearance"),
        may<S>(&S::viscosity_pa_s, "viscosity_pa_s", "Pa s", open_low(0, 10), "viscosity of the oil"),
        may<S>(&S::supply_pressure_mpa, "supply_pressure_mpa", "MPa", open_low(0, 100), "supply pressure"),
        may<S>(&S::pressure_ratio, "pressure_ratio", "1", open(0, 1),
               "pocket pressure of a centred shaft over supply pressure"),
        may<S>(&S::feedback_gain, "feedback_gain", "1", closed(0, 100), "of the adaptive supply"),
        may<S>(&S::conductance_max, "conductance_max", "1", closed(1, 1000), "widest opening of a regulator"),
        may<S>(&S::inlet_c, "inlet_c", "degC", closed(-50, 200), "temperature of the oil coming in"),
        may<S>(&S::film_min_um, "film_min_um", "um", open_low(0, 1000), "thinnest film allowed"),
        may<S>(&S::outlet_max_c, "outlet_max_c", "degC", closed(-50, 300), "hottest oil allowed")};
  }
};

template <>
struct StructFields<WheelSeat> {
  static std::vector<Field> fields() {
    using S = WheelSeat;
    return {may<S>(&S::mounting, "mounting", "-", no_range(), "how the wheel is held"),
            may<S>(&S::amplitude_um, "amplitude_um", "um", closed(0, 1000),
                   "vibration at the rotation frequency; not given: as measured for the mounting"),
            may<S>(&S::waviness_max_um, "waviness_max_um", "um", open_low(0, 1000), "highest waviness")};
  }
};

std::vector<Field> StructFields<Spindle>::fields() {
  using S = Spindle;
  return {need<S>(&S::speed_min_rpm, "speed_min_rpm", "rpm", open_low(0, 1e6),
                  "lowest speed that bands are given for"),
          need<S>(&S::speed_max_rpm, "speed_max_rpm", "rpm", open_low(0, 1e6),
                  "highest speed that bands are given for"),
          may<S>(&S::bearings, "bearings", "-", no_range(), "bearings in parametric resonance, K201"),
          may<S>(&S::elastic_base, "elastic_base", "-", no_range(), "rods, bearings and base, K206"),
          may<S>(&S::hydrostatic, "hydrostatic", "-", no_range(), "hydrostatic bearing, K210"),
          may<S>(&S::wheel, "wheel", "-", no_range(), "seat of the grinding wheel, K209"),
          may<S>(&S::holder, "holder", "-", no_range(), "holder of axial tools, K408"),
          may<S>(&S::bearing_bore_mm, "bearing_bore_mm", "mm", open_low(0, 5000),
                 "bore of the rolling bearings: limits the speed"),
          may<S>(&S::machine_error_max_um, "machine_error_max_um", "um", open_low(0, 1e4),
                 "form error that the spindle may add; a third to a fifth of the part tolerance, K210")};
}

}  // namespace verstat::models

namespace verstat::operations {

namespace {

namespace k201 = models::k201;
namespace k206 = models::k206;
namespace k209 = models::k209;
namespace k210 = models::k210;

template <class Unit>
void fill(Unit& to, const ElasticBase& from) {
  to.spindle_length_mm = from.spindle_length_mm;
  to.spindle_outer_mm = from.spindle_outer_mm;
  to.spindle_inner_mm = from.spindle_inner_mm;
  to.sleeve_length_mm = from.sleeve_length_mm;
  to.sleeve_outer_mm = from.sleeve_outer_mm;
  to.sleeve_inner_mm = from.sleeve_inner_mm;
  to.bearing_section = from.bearing_section;
  to.bearing_k_n_um = from.bearing_k_n_um;
  to.support_section = from.support_section;
  to.support_k_n_um = from.support_k_n_um;
  to.e_gpa = from.modulus_gpa;
  to.rho_kg_m3 = from.density_kg_m3;
}

std::vector<SpindleDynamics::Band> parametric_bands(const BearingResonance& b, double low_rpm,
                                                    double high_rpm) {
  k201::BandInputs in;
  in.speed_nodes_rpm = b.speed_nodes_rpm;
  for (const double f : b.natural_frequency_hz) in.p_nodes_rad_s.push_back(2 * std::numbers::pi * f);
  in.ratio_nodes = b.stiffness_ratio;
  in.cage_ratio =
      k201::cage_speed_ratio({b.ball_diameter_mm, b.pitch_diameter_mm, b.contact_angle_deg}).ratio;
  in.harmonic = b.harmonic;
  in.damping_ratio = b.damping_ratio;
  // Mathieu's parameter a = (2 p / Omega)^2 is known up to 100: zones above the tenth are not looked for.
  // They are far narrower than any damping leaves unstable.
  const double highest_rad_s = *std::max_element(in.p_nodes_rad_s.begin(), in.p_nodes_rad_s.end());
  const double tenth_rpm =
      k201::parametric_critical_speed({highest_rad_s, in.cage_ratio, b.harmonic, 10}).speed_rpm;
  low_rpm = std::max(low_rpm, tenth_rpm * (1 + 1e-9));
  if (low_rpm >= high_rpm) return {};
  in.n_min_rpm = low_rpm;
  in.n_max_rpm = high_rpm;
  in.step_rpm = b.speed_step_rpm;
  std::vector<SpindleDynamics::Band> bands;
  for (const auto& band : k201::parametric_speed_bands(in).bands)
    bands.push_back({band.n_low_rpm, band.n_high_rpm});
  return bands;
}

/// The real part of a lightly damped mode is least just above its frequency, at p sqrt(1 + loss factor) for a
/// single one: the search around that point finds it among its neighbours.
double least_real(k206::NoseInputs& nose, double natural_hz, double loss_factor) {
  const auto real_at = [&](double hz) {
    nose.freq_hz = hz;
    return k206::nose_compliance(nose).re_um_n;
  };
  constexpr int bits = 24;  // half of a double's: a minimum is flat
  return boost::math::tools::brent_find_minima(real_at, natural_hz,
                                               natural_hz * std::sqrt(1 + 3 * loss_factor), bits)
      .second;
}

void add_base(const ElasticBase& base, SpindleDynamics& d) {
  k206::UnitFrequencyInputs unit;
  fill(unit, base);
  unit.count = base.modes;
  d.natural_hz = k206::spindle_base_natural_frequencies(unit).p_hz;
  k206::NoseInputs nose;
  fill(nose, base);
  nose.section = 0;
  nose.loss_factor = base.loss_factor;
  nose.freq_hz = 1;  // far below every natural frequency that is looked for
  d.static_um_n = k206::nose_compliance(nose).abs_um_n;
  for (const double hz : d.natural_hz)
    d.least_real_um_n = std::min(d.least_real_um_n, least_real(nose, hz, base.loss_factor));
}

constexpr const char* knob = "spindle_speed_rpm";

void add_bands(CutPlan& plan, const Spindle& spindle, const SpindleDynamics& dynamics) {
  const double speed_rpm = plan.spindle.speed_high_rpm;
  for (const auto& band : dynamics.parametric)
    plan.bands.push_back(
        {knob, speed_rpm, band.low_rpm, band.high_rpm, "rpm", "K201.parametric_speed_bands"});
  if (dynamics.natural_hz.empty()) return;
  k206::ResonanceInputs in;
  in.natural_hz = dynamics.natural_hz;
  in.harmonics = {1};
  if (plan.spindle.teeth > 1) in.harmonics.push_back(static_cast<double>(plan.spindle.teeth));
  in.margin = spindle.elastic_base->resonance_margin;
  in.n_min_rpm = spindle.speed_min_rpm;
  in.n_max_rpm = spindle.speed_max_rpm;
  const auto bands = k206::resonance_speed_bands(in);
  for (std::size_t k = 0; k < bands.n_lo_rpm.size(); ++k)
    plan.bands.push_back(
        {knob, speed_rpm, bands.n_lo_rpm[k], bands.n_hi_rpm[k], "rpm", "K206.resonance_speed_bands"});
}

void add_stable_width(CutPlan& plan, const Spindle& spindle, const SpindleDynamics& dynamics) {
  const SpindleLoad& load = plan.spindle;
  if (load.specific_force_n_mm2 <= 0 || load.width_of_cut_mm <= 0 || dynamics.least_real_um_n >= 0) return;
  const double width_mm =
      k206::chatter_limit_width({load.specific_force_n_mm2, dynamics.least_real_um_n,
                                 spindle.elastic_base ? spindle.elastic_base->orientation_factor : 1})
          .b_lim_mm;
  plan.quantities.push_back({"stable_width_mm", width_mm, "mm", "K206.chatter_limit_width",
                             "width of cut that is stable at any speed on this spindle"});
  plan.limits.push_back(
      {"width_of_cut_mm", load.width_of_cut_mm, width_mm, true, "mm", "K206.chatter_limit_width"});
}

/// Displacement of a hydrostatic spindle under the force, um.
double add_hydrostatic(CutPlan& plan, const HydrostaticSupport& h) {
  k210::Load load;
  load.diameter_mm = h.diameter_mm;
  load.length_mm = h.length_mm;
  load.pockets = h.pockets;
  load.pocket_length_mm = h.pocket_length_mm;
  load.pocket_width_mm = h.pocket_width_mm;
  load.radial_clearance_um = h.radial_clearance_um;
  load.viscosity_pa_s = h.viscosity_pa_s;
  load.supply_pressure_mpa = h.supply_pressure_mpa;
  load.pressure_ratio = h.pressure_ratio;
  load.spindle_rpm = plan.spindle.speed_high_rpm;
  load.feedback_gain = h.feedback_gain;
  load.conductance_max = h.conductance_max;
  load.load_x_n = plan.spindle.normal_force_n;
  const auto shaft = k210::shaft_equilibrium(load);
  k210::LossInputs flow;
  static_cast<k210::Bearing&>(flow) = load;
  flow.flow_l_min = shaft.flow_l_min;
  flow.inlet_c = h.inlet_c;
  const auto losses = k210::bearing_losses(flow);
  plan.quantities.push_back({"spindle_film_um", shaft.h_min_um, "um", "K210.shaft_equilibrium",
                             "thinnest oil film under the cutting force"});
  plan.quantities.push_back(
      {"spindle_oil_c", losses.outlet_c, "degC", "K210.bearing_losses", "oil that leaves the bearing"});
  plan.quantities.push_back({"spindle_losses_kw", losses.friction_kw + losses.pump_kw, "kW",
                             "K210.bearing_losses", "friction and pump"});
  if (h.film_min_um)
    plan.limits.push_back(
        {"spindle_film_um", shaft.h_min_um, *h.film_min_um, false, "um", "K210.shaft_equilibrium"});
  if (h.outlet_max_c)
    plan.limits.push_back(
        {"spindle_oil_c", losses.outlet_c, *h.outlet_max_c, true, "degC", "K210.bearing_losses"});
  return shaft.eccentricity_um;
}

/// Waviness that the seat of the wheel leaves, um.
double add_wheel(CutPlan& plan, const WheelSeat& seat) {
  const SpindleLoad& load = plan.spindle;
  const double amplitude_um =
      seat.amplitude_um
          ? *seat.amplitude_um
          : k209::wheel_vibration_amplitude({seat.mounting, k209::State::grinding, 1}).amplitude_um;
  const auto waviness = k209::flat_grinding_waviness(
      {amplitude_um, load.speed_high_rpm, 1, load.work_speed_m_min, load.wheel_diameter_mm});
  constexpr const char* origin = "K209.flat_grinding_waviness";
  plan.quantities.push_back({"wheel_vibration_um", amplitude_um, "um",
                             seat.amplitude_um ? "given" : "K209.wheel_vibration_amplitude",
                             "oscillation of the wheel at the rotation frequency"});
  plan.quantities.push_back(
      {"waviness_um", waviness.height_um, "um", origin, "waviness of one pass, spark-out lowers it"});
  plan.quantities.push_back({"waviness_length_mm", waviness.wavelength_mm, "mm", origin, "its wavelength"});
  if (load.infeed_mm > 0)
    plan.quantities.push_back({"depth_modulation",
                               k209::depth_modulation({amplitude_um, load.infeed_mm}).ratio, "1",
                               "K209.depth_modulation", "swing of the depth of cut"});
  if (seat.waviness_max_um)
    plan.limits.push_back({"waviness_um", waviness.height_um, *seat.waviness_max_um, true, "um", origin});
  return waviness.height_um;
}

}  // namespace

DynamicsMemo& DynamicsMemo::operator=(const DynamicsMemo& other) {
  if (this != &other) set(other.get());
  return *this;
}

std::shared_ptr<const DynamicsMemo::Entry> DynamicsMemo::get() const {
  const std::lock_guard lock(mutex_);
  return entry_;
}

void DynamicsMemo::set(std::shared_ptr<const Entry> entry) {
  const std::lock_guard lock(mutex_);
  entry_ = std::move(entry);
}

std::vector<double> Spindle::key() const {
  std::vector<double> all{speed_min_rpm, speed_max_rpm, bearings ? 1.0 : 0.0, elastic_base ? 1.0 : 0.0};
  const auto put = [&](const auto& list) {
    all.push_back(static_cast<double>(list.size()));
    for (const auto x : list) all.push_back(static_cast<double>(x));
  };
  if (bearings) {
    const BearingResonance& b = *bearings;
    all.insert(all.end(), {b.ball_diameter_mm, b.pitch_diameter_mm, b.contact_angle_deg,
                           static_cast<double>(b.harmonic), b.damping_ratio, b.speed_step_rpm});
    put(b.speed_nodes_rpm);
    put(b.natural_frequency_hz);
    put(b.stiffness_ratio);
  }
  if (elastic_base) {
    const ElasticBase& e = *elastic_base;
    all.insert(all.end(), {e.modulus_gpa, e.density_kg_m3, static_cast<double>(e.modes), e.loss_factor});
    for (const auto* list :
         {&e.spindle_length_mm, &e.spindle_outer_mm, &e.spindle_inner_mm, &e.sleeve_length_mm,
          &e.sleeve_outer_mm, &e.sleeve_inner_mm, &e.bearing_k_n_um, &e.support_k_n_um})
      put(*list);
    put(e.bearing_section);
    put(e.support_section);
  }
  return all;
}

SpindleDynamics Spindle::dynamics() const {
  std::vector<double> now = key();
  if (const auto known = memo_.get(); known != nullptr && known->key == now) return known->dynamics;
  models::require(speed_min_rpm < speed_max_rpm, "spindle/speed_min_rpm", speed_min_rpm,
                  "must be below speed_max_rpm");
  auto entry = std::make_shared<DynamicsMemo::Entry>();
  entry->key = std::move(now);
  if (bearings) entry->dynamics.parametric = parametric_bands(*bearings, speed_min_rpm, speed_max_rpm);
  if (elastic_base) add_base(*elastic_base, entry->dynamics);
  memo_.set(entry);
  return entry->dynamics;
}

void add_spindle(CutPlan& plan, const Spindle& spindle) {
  const SpindleLoad& load = plan.spindle;
  if (load.speed_high_rpm <= 0) return;  // the operation turns no spindle
  const SpindleDynamics dynamics = spindle.dynamics();
  add_bands(plan, spindle, dynamics);
  add_stable_width(plan, spindle, dynamics);
  if (spindle.bearing_bore_mm)
    plan.limits.push_back({"spindle_speed_dn_rpm", load.speed_high_rpm,
                           k206::max_spindle_speed_dn({*spindle.bearing_bore_mm}).n_max_rpm, true, "rpm",
                           "K206.max_spindle_speed_dn"});

  double error_um = 0;
  bool known = false;
  if (dynamics.static_um_n > 0 && load.normal_force_n > 0) {
    error_um += dynamics.static_um_n * load.normal_force_n;
    known = true;
    plan.quantities.push_back({"spindle_deflection_um", error_um, "um", "K206.nose_compliance",
                               "the nose gives way under the normal force"});
  }
  if (spindle.hydrostatic && load.normal_force_n > 0) {
    const double displacement_um = add_hydrostatic(plan, *spindle.hydrostatic);
    plan.quantities.push_back({"spindle_displacement_um", displacement_um, "um", "K210.shaft_equilibrium",
                               "the shaft gives way in its hydrostatic bearing"});
    error_um += displacement_um;
    known = true;
  }
  if (spindle.wheel && load.wheel_diameter_mm > 0 && load.work_speed_m_min > 0) {
    error_um += add_wheel(plan, *spindle.wheel);
    known = true;
  }
  if (!known) return;
  constexpr const char* sum = "COMPLETION: sum of what the parts of the spindle add, worst case";
  plan.quantities.push_back(
      {"spindle_form_error_um", error_um, "um", sum, "form error that the spindle adds"});
  if (spindle.machine_error_max_um)
    plan.limits.push_back(
        {"spindle_form_error_um", error_um, *spindle.machine_error_max_um, true, "um", sum});
}

void add_machine(CutPlan& plan, const PlanContext& context) {
  if (context.spindle != nullptr) add_spindle(plan, *context.spindle);
  if (context.machine != nullptr && context.machine->safety_clutch)
    add_overload(plan, *context.machine->safety_clutch);
}

}  // namespace verstat::operations
