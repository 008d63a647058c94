#include "operations/kinds/turning.h"

#include <cmath>
#include <numbers>

#include "models/reliability/k117_rational_reliability.h"
#include "models/surface/k411_finish_turning_roughness.h"
#include "models/thermal/k110_contact_hot_spots.h"
#include "models/thermal/k403_unsteady_cutting_temperature.h"
#include "operations/fields.h"
#include "operations/machine_load.h"
#include "operations/taylor.h"

namespace verstat::models {

using operations::Turning;
using operations::TurningContact;
using operations::TurningHeat;
using operations::TurningInsert;
using operations::TurningMaterial;

std::vector<Field> StructFields<TurningMaterial>::fields() {
  using S = TurningMaterial;
  return {may<S>(&S::kc11_n_mm2, "kc11_n_mm2", "N/mm2", closed(50, 20'000), "specific cutting force k_c1.1"),
          may<S>(&S::mc, "mc", "1", open_high(0, 1), "exponent of the chip thickness in Kienzle's relation"),
          may<S>(&S::tensile_strength_mpa, "tensile_strength_mpa", "MPa", closed(100, 3000),
                 "tensile strength; adds the handbook's force components")};
}

std::vector<Field> StructFields<TurningInsert>::fields() {
  using S = TurningInsert;
  return {may<S>(&S::nose_radius_mm, "nose_radius_mm", "mm", closed(0.1, 5), "nose radius"),
          may<S>(&S::kr_deg, "kr_deg", "deg", closed(10, 90), "angle of the main edge to the feed"),
          may<S>(&S::kr1_deg, "kr1_deg", "deg", closed(2, 80), "angle of the minor edge to the feed"),
          may<S>(&S::rake_deg, "rake_deg", "deg", closed(-30, 40), "rake angle"),
          may<S>(&S::inclination_deg, "inclination_deg", "deg", closed(-30, 30),
                 "inclination of the edge, positive when the nose is its lowest point"),
          may<S>(&S::rake_shape, "rake_shape", "-", no_range(), "shape of the rake face")};
}

std::vector<Field> StructFields<TurningHeat>::fields() {
  using S = TurningHeat;
  return {may<S>(&S::flank_wear_mm, "flank_wear_mm", "mm", closed(0, 5), "width of the flank wear land"),
          may<S>(&S::relief_deg, "relief_deg", "deg", closed(0, 30), "relief angle"),
          may<S>(&S::chip_compression, "chip_compression", "1", closed(1.2, 5), "chip compression ratio"),
          may<S>(&S::thrust_ratio, "thrust_ratio", "1", closed(0, 2),
                 "thrust over cutting force of the sharp tool"),
          may<S>(&S::flank_shear_n_mm2, "flank_shear_n_mm2", "N/mm2", closed(0, 5000),
                 "friction stress on the wear land"),
          may<S>(&S::preheating, "preheating", "1", closed(0, 1), "preheating by the previous revolution"),
          may<S>(&S::work_conductivity_w_mk, "work_conductivity_w_mk", "W/(m K)", open_low(0, 1000),
                 "conductivity of the workpiece"),
          may<S>(&S::work_diffusivity_mm2_s, "work_diffusivity_mm2_s", "mm2/s", open_low(0, 1000),
                 "diffusivity of the workpiece"),
          may<S>(&S::tool_conductivity_w_mk, "tool_conductivity_w_mk", "W/(m K)", open_low(0, 3000),
                 "conductivity of the tool"),
          may<S>(&S::tool_diffusivity_mm2_s, "tool_diffusivity_mm2_s", "mm2/s", open_low(0, 3000),
                 "diffusivity of the tool"),
          may<S>(&S::ambient_c, "ambient_c", "degC", closed(-60, 200), "ambient temperature")};
}

std::vector<Field> StructFields<TurningContact>::fields() {
  using S = TurningContact;
  return {need<S>(&S::heat_capacity_n_mm2_k, "heat_capacity_n_mm2_k", "N/(mm2 K)", closed(1.5, 4),
                  "heat capacity of the work material per volume; J/(cm3 K)"),
          need<S>(&S::diffusivity_mm2_s, "diffusivity_mm2_s", "mm2/s", closed(2, 100),
                  "thermal diffusivity of the work material"),
          may<S>(&S::temperature_coefficient, "temperature_coefficient", "1", open_low(0, 10),
                 "coefficient of the mean temperature, to be calibrated (titanium 0.23 to 0.25)"),
          may<S>(&S::hot_spot_factor, "hot_spot_factor", "1", closed(1, 10),
                 "rise of the hot spots over that of the mean (published 1.8 to 2.8)"),
          may<S>(&S::ambient_c, "ambient_c", "degC", closed(-50, 100), "ambient temperature"),
          may<S>(&S::hot_spot_max_c, "hot_spot_max_c", "degC", open_low(0, 3000),
                 "hottest that a spot may become: limits the cutting speed"),
          may<S>(&S::hot_area_fraction, "hot_area_fraction", "1", closed(0, 1),
                 "share of the contact that runs as hot as the spots"),
          may<S>(&S::activation_energy_kj_mol, "activation_energy_kj_mol", "kJ/mol", closed(0, 1000),
                 "of the thermally activated wear; 0: wear does not follow temperature")};
}

template <>
struct StructFields<Turning> {
  static std::vector<Field> fields() {
    using S = Turning;
    return {
        need<S>(&S::diameter_mm, "diameter_mm", "mm", open_low(0, 1e5), "diameter of the cut"),
        need<S>(&S::length_mm, "length_mm", "mm", open_low(0, 1e6), "length of the cut"),
        may<S>(&S::passes, "passes", "1", closed(1, 10'000), "number of passes"),
        need<S>(&S::cutting_speed_m_min, "cutting_speed_m_min", "m/min", closed(0.1, 1e5),
                "cutting speed v_c"),
        need<S>(&S::feed_mm_rev, "feed_mm_rev", "mm/rev", closed(1e-4, 100), "feed f"),
        need<S>(&S::depth_of_cut_mm, "depth_of_cut_mm", "mm", closed(1e-4, 1000), "depth of cut a_p"),
        may<S>(&S::material, "material", "-", no_range(), "work material: adds force and power"),
        may<S>(&S::insert, "insert", "-", no_range(), "corner of the insert: adds section and roughness"),
        may<S>(&S::heat, "heat", "-", no_range(), "heat properties: adds temperatures"),
        may<S>(&S::contact, "contact", "-", no_range(),
               "contact of chip and rake at high temperature: limits speed, shortens life"),
        may<S>(&S::force_max_n, "force_max_n", "N", open_low(0, 1e7), "largest cutting force"),
        may<S>(&S::radial_force_max_n, "radial_force_max_n", "N", open_low(0, 1e7), "largest radial force"),
        may<S>(&S::roughness_max_um, "roughness_max_um", "um", open_low(0, 1000), "largest Ra"),
        may<S>(&S::scrap_above_roughness, "scrap_above_roughness", "-", no_range(),
               "whether a part rougher than the limit is scrap"),
        may<S>(&S::temperature_max_c, "temperature_max_c", "degC", open_low(0, 3000),
               "largest mean temperature of rake and flank")};
  }
};

}  // namespace verstat::models

namespace verstat::operations {

namespace {

constexpr const char* kienzle = "COMPLETION: Kienzle";

struct Section {
  double area_mm2;
  double mean_thickness_mm;
};

/// Uncut chip: of the insert's corner, or of a straight edge square to the feed when none is given.
Section section(const Turning& spec, CutPlan& p) {
  if (!spec.insert) return {spec.feed_mm_rev * spec.depth_of_cut_mm, spec.feed_mm_rev};
  const TurningInsert& insert = *spec.insert;
  const auto s = models::k102::uncut_chip_section({.depth_mm = spec.depth_of_cut_mm,
                                                   .feed_mm_rev = spec.feed_mm_rev,
                                                   .lead_angle_deg = insert.kr_deg,
                                                   .end_angle_deg = insert.kr1_deg,
                                                   .nose_radius_mm = insert.nose_radius_mm});
  p.quantities.push_back({"chip_area_mm2", s.chip_area_mm2, "mm2", "K102.uncut_chip_section",
                          "cross-section of the uncut chip"});
  p.quantities.push_back(
      {"edge_length_mm", s.edge_length_mm, "mm", "K102.uncut_chip_section", "active length of the edge"});
  p.quantities.push_back({"mean_chip_thickness_mm", s.mean_chip_thickness_mm, "mm", "K102.uncut_chip_section",
                          "chip section over edge length"});
  return {s.chip_area_mm2, s.mean_chip_thickness_mm};
}

/// Roughness of the turned surface; the fit is known for feeds of 0.01 to 1.5 mm/rev, and a limit asks for
/// it.
void roughness(const Turning& spec, CutPlan& p) {
  models::k411::FittedSurface surface;
  surface.feed_mm_rev = spec.feed_mm_rev;
  surface.nose_radius_mm = spec.insert->nose_radius_mm;
  surface.kr_deg = spec.insert->kr_deg;
  surface.kr1_deg = spec.insert->kr1_deg;
  const bool fitted = spec.feed_mm_rev >= 0.01 && spec.feed_mm_rev <= 1.5;
  if (!fitted && !spec.roughness_max_um) return;
  const auto fit = models::k411::turning_ra(surface);
  p.quantities.push_back({"roughness_ra_um", fit.ra_um, "um", "K411.turning_ra", "Ra of the turned surface"});
  p.quantities.push_back(
      {"profile_height_um", fit.height_um, "um", "K411.turning_ra", "theoretical height of the profile"});
  p.leave("roughness_ra_um");
  p.leave("profile_height_um");
  if (!spec.roughness_max_um) return;
  models::k411::LimitedSurface limited;
  static_cast<models::k411::TurnedSurface&>(limited) = surface;
  limited.ra_limit_um = *spec.roughness_max_um;
  const double exceeding = models::k411::ra_exceed_probability(limited).probability;
  p.quantities.push_back({"roughness_exceed_probability", exceeding, "1", "K411.ra_exceed_probability",
                          "share of parts rougher than the limit"});
  if (spec.scrap_above_roughness) p.scrap_probability = exceeding;
  p.limits.push_back({"roughness_ra_um", fit.ra_um, *spec.roughness_max_um, true, "um", "K411.turning_ra"});
}

/// Handbook force components; their material factor is the strength over 750 MPa, as the card's authors
/// took it.
void handbook(const Turning& spec, const PlanContext& context, CutPlan& p) {
  const TurningInsert& insert = *spec.insert;
  models::k102::TurningInputs in;
  in.depth_mm = spec.depth_of_cut_mm;
  in.feed_mm_rev = spec.feed_mm_rev;
  in.speed_m_min = spec.cutting_speed_m_min;
  in.nose_radius_mm = insert.nose_radius_mm;
  in.lead_angle_deg = insert.kr_deg;
  in.rake_angle_deg = insert.rake_deg;
  in.inclination_deg = insert.inclination_deg;
  in.material_factor = *spec.material->tensile_strength_mpa / 750;
  const auto force = models::k102::handbook_turning_force(in);
  const auto shape = models::k102::rake_shape_force({insert.rake_shape});
  constexpr const char* origin = "K102.handbook_turning_force";
  const double radial_n = force.py_n * shape.factor_py;
  const double feed_n = force.px_n * shape.factor_px;
  p.spindle.normal_force_n = radial_n;
  p.quantities.push_back(
      {"handbook_force_n", force.pz_n * shape.factor_pz, "N", origin, "main force of the handbook"});
  p.quantities.push_back({"radial_force_n", radial_n, "N", origin, "radial force of the handbook"});
  p.quantities.push_back({"feed_force_n", feed_n, "N", origin, "feed force of the handbook"});
  if (spec.radial_force_max_n)
    p.limits.push_back({"radial_force_n", radial_n, *spec.radial_force_max_n, true, "N", origin});
  limit_feed_force(p, context, feed_n, origin);
}

void force_and_power(const Turning& spec, const PlanContext& context, CutPlan& p) {
  const Section chip = section(spec, p);
  const double shape =
      spec.insert ? models::k102::rake_shape_force({spec.insert->rake_shape}).factor_pz : 1.0;
  const double force_n = spec.material->kc11_n_mm2 * chip.area_mm2 *
                         std::pow(chip.mean_thickness_mm, -spec.material->mc) * shape;
  const double power_kw =
      models::k102::turning_power({.pz_n = force_n, .speed_m_min = spec.cutting_speed_m_min}).power_kw;
  const double torque_nm = force_n * spec.diameter_mm / 2000;
  p.quantities.push_back({"cutting_force_n", force_n, "N", kienzle, "main cutting force"});
  p.quantities.push_back({"power_kw", power_kw, "kW", kienzle, "cutting power"});
  p.quantities.push_back({"torque_nm", torque_nm, "N m", kienzle, "spindle torque"});
  if (spec.force_max_n)
    p.limits.push_back({"cutting_force_n", force_n, *spec.force_max_n, true, "N", kienzle});
  limit_power(p, context, power_kw, kienzle);
  limit_torque(p, context, torque_nm, kienzle);
  p.spindle.specific_force_n_mm2 = force_n / chip.area_mm2;
  p.spindle.width_of_cut_mm = chip.area_mm2 / chip.mean_thickness_mm;
}

void temperatures(const Turning& spec, CutPlan& p) {
  const TurningHeat& heat = *spec.heat;
  models::k403::ContinuousCut cut;
  cut.cutting_speed_m_min = spec.cutting_speed_m_min;
  cut.feed_mm_rev = spec.feed_mm_rev;
  cut.depth_mm = spec.depth_of_cut_mm;
  cut.flank_wear_mm = heat.flank_wear_mm;
  cut.kr_deg = spec.insert ? spec.insert->kr_deg : 90;
  cut.rake_deg = spec.insert ? spec.insert->rake_deg : 0;
  cut.chip_compression = heat.chip_compression;
  cut.kc11_n_mm2 = spec.material->kc11_n_mm2;
  cut.mc = spec.material->mc;
  cut.thrust_ratio = heat.thrust_ratio;
  cut.flank_shear_n_mm2 = heat.flank_shear_n_mm2;
  cut.work_diffusivity_mm2_s = heat.work_diffusivity_mm2_s;
  cut.relief_deg = heat.relief_deg;
  cut.preheating = heat.preheating;
  cut.work_conductivity_w_mk = heat.work_conductivity_w_mk;
  cut.tool_conductivity_w_mk = heat.tool_conductivity_w_mk;
  cut.tool_diffusivity_mm2_s = heat.tool_diffusivity_mm2_s;
  cut.ambient_c = heat.ambient_c;
  const auto theta = models::k403::cutting_temperature(cut);
  constexpr const char* origin = "K403.cutting_temperature";
  p.quantities.push_back(
      {"rake_temperature_c", theta.rake_c, "degC", origin, "rake face; distrust above 1200 degC"});
  p.quantities.push_back({"flank_temperature_c", theta.flank_c, "degC", origin, "worn flank"});
  p.quantities.push_back({"mean_temperature_c", theta.mean_c, "degC", origin, "mean of rake and flank"});
  p.quantities.push_back(
      {"tool_heat_flux_w_mm2", theta.rake_flux_w_mm2, "W/mm2", origin, "heat flux into the rake"});
  if (spec.temperature_max_c)
    p.limits.push_back({"mean_temperature_c", theta.mean_c, *spec.temperature_max_c, true, "degC", origin});
}

/// Mean temperature of the contact, its hot spots and the wear that they add.
void hot_contact(const Turning& spec, CutPlan& p) {
  const TurningContact& contact = *spec.contact;
  models::k110::InterfaceInputs in;
  in.specific_energy_n_mm2 = p.spindle.specific_force_n_mm2;  // energy per volume is force per section
  in.heat_capacity_n_mm2_k = contact.heat_capacity_n_mm2_k;
  in.diffusivity_mm2_s = contact.diffusivity_mm2_s;
  in.speed_m_min = spec.cutting_speed_m_min;
  in.chip_thickness_mm = p.value_of("mean_chip_thickness_mm").value_or(spec.feed_mm_rev);
  in.ambient_degc = contact.ambient_c;
  in.coefficient = contact.temperature_coefficient;
  const double mean_c = models::k110::mean_interface_temperature(in).mean_degc;
  const double hot_c = contact.ambient_c + contact.hot_spot_factor * (mean_c - contact.ambient_c);
  p.quantities.push_back({"contact_temperature_c", mean_c, "degC", "K110.mean_interface_temperature",
                          "mean of the contact of chip and rake"});
  p.quantities.push_back({"hot_spot_temperature_c", hot_c, "degC", "K110.thermal_severity",
                          "of its hot spots, local and short"});
  if (contact.hot_spot_max_c) {
    models::k110::SpeedLimitInputs limit;
    limit.specific_energy_n_mm2 = in.specific_energy_n_mm2;
    limit.heat_capacity_n_mm2_k = in.heat_capacity_n_mm2_k;
    limit.diffusivity_mm2_s = in.diffusivity_mm2_s;
    limit.chip_thickness_mm = in.chip_thickness_mm;
    limit.limit_degc = *contact.hot_spot_max_c;
    limit.ambient_degc = in.ambient_degc;
    limit.hot_spot_factor = contact.hot_spot_factor;
    limit.coefficient = in.coefficient;
    const double speed_m_min = models::k110::speed_limit_by_temperature(limit).speed_m_min;
    p.quantities.push_back({"hot_spot_speed_limit_m_min", speed_m_min, "m/min",
                            "K110.speed_limit_by_temperature",
                            "speed at which the hot spots reach their limit"});
    p.limits.push_back({"cutting_speed_m_min", spec.cutting_speed_m_min, speed_m_min, true, "m/min",
                        "K110.speed_limit_by_temperature"});
  }
  if (contact.hot_area_fraction == 0 || contact.activation_energy_kj_mol == 0) return;
  const double wear = models::k110::hot_zone_wear_multiplier(
                          {mean_c, hot_c, contact.hot_area_fraction, contact.activation_energy_kj_mol})
                          .mean_rate_multiplier;
  p.quantities.push_back({"hot_spot_wear_multiplier", wear, "1", "K110.hot_zone_wear_multiplier",
                          "wear rate over that of a contact at the mean temperature"});
  if (!p.edge) return;
  p.edge->mean_min /= wear;
  p.edge->origin = "K117.mean_life_for_regime, K110.hot_zone_wear_multiplier";
}

/// A limit on something that the given members do not determine is a mistake, not a limit that is met.
void check_limits_have_their_quantities(const Turning& spec) {
  using models::require;
  if (spec.force_max_n)
    require(spec.material.has_value(), "force_max_n", *spec.force_max_n, "needs the member \"material\"");
  if (spec.radial_force_max_n)
    require(spec.insert && spec.material && spec.material->tensile_strength_mpa, "radial_force_max_n",
            *spec.radial_force_max_n, "needs the members \"insert\" and \"material/tensile_strength_mpa\"");
  if (spec.roughness_max_um)
    require(spec.insert.has_value(), "roughness_max_um", *spec.roughness_max_um,
            "needs the member \"insert\"");
  if (spec.scrap_above_roughness)
    require(spec.roughness_max_um.has_value(), "scrap_above_roughness", true,
            "needs the member \"roughness_max_um\"");
  if (spec.temperature_max_c)
    require(spec.heat.has_value(), "temperature_max_c", *spec.temperature_max_c, "needs the member \"heat\"");
  if (spec.heat)
    require(spec.material.has_value(), "heat/flank_wear_mm", spec.heat->flank_wear_mm,
            "needs the member \"material\": heat comes from the cutting force");
  if (spec.contact) {
    require(spec.material.has_value(), "contact/heat_capacity_n_mm2_k", spec.contact->heat_capacity_n_mm2_k,
            "needs the member \"material\": heat comes from the cutting force");
    require(!spec.contact->hot_spot_max_c || *spec.contact->hot_spot_max_c > spec.contact->ambient_c,
            "contact/hot_spot_max_c", spec.contact->hot_spot_max_c.value_or(0), "must be above ambient_c");
  }
}

}  // namespace

CutPlan plan(const Turning& spec, const PlanContext& context) {
  check_limits_have_their_quantities(spec);
  models::k117::TurningPass pass;
  pass.diameter_mm = spec.diameter_mm;
  pass.length_mm = spec.length_mm;
  pass.passes = static_cast<double>(spec.passes);
  pass.speed_m_min = spec.cutting_speed_m_min;
  pass.feed_mm_rev = spec.feed_mm_rev;

  CutPlan p;
  p.set_main_time(models::k117::machining_time_turning(pass).time_min, "K117.machining_time_turning");
  const double spindle_speed_rpm = 1000 * spec.cutting_speed_m_min / (std::numbers::pi * spec.diameter_mm);
  p.quantities.push_back({"spindle_speed_rpm", spindle_speed_rpm, "rpm", "definition", "spindle speed"});
  if (context.edge != nullptr)
    p.edge = taylor_life(*context.edge, spec.cutting_speed_m_min, spec.feed_mm_rev, spec.depth_of_cut_mm);
  limit_spindle_speed(p, context, spindle_speed_rpm, "definition");
  limit_feed_rate(p, context, spindle_speed_rpm * spec.feed_mm_rev, "definition");

  if (spec.material) {
    force_and_power(spec, context, p);
    if (spec.insert && spec.material->tensile_strength_mpa) handbook(spec, context, p);
  } else {
    (void)section(spec, p);
  }
  if (spec.insert) roughness(spec, p);
  if (spec.heat) temperatures(spec, p);
  if (spec.contact) hot_contact(spec, p);
  return p;
}

namespace turning {
void add_to(Kinds& kinds) {
  kinds.add<Turning>("A cylinder turned lengthwise in passes.", {"K117", "K411", "K403", "K102", "K110"});
}
}  // namespace turning

}  // namespace verstat::operations
