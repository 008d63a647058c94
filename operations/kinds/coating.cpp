#include "operations/kinds/coating.h"

#include "models/inspection/k119_cutter_certification.h"
#include "operations/fields.h"

template <>
struct verstat::models::StructFields<verstat::operations::Coating> {
  static std::vector<Field> fields() {
    using S = operations::Coating;
    return {
        may<S>(&S::coating, "coating", "-", no_range(), "islands or a continuous layer"),
        may<S>(&S::delivered, "delivered", "-", no_range(), "what the lot is before"),
        may<S>(&S::island_side_um, "island_side_um", "um", open_low(0, 1e5), "side of an island"),
        may<S>(&S::island_pitch_um, "island_pitch_um", "um", open_low(0, 1e5), "distance of the islands"),
        may<S>(&S::thickness_um, "thickness_um", "um", open_low(0, 1000), "thickness of the coating"),
        may<S>(&S::modulus_mpa, "modulus_mpa", "MPa", open_low(0, 2e6), "modulus of the coating"),
        may<S>(&S::poisson, "poisson", "1", closed(0, 0.49), "its Poisson ratio"),
        may<S>(&S::delta_alpha_1_k, "delta_alpha_1_k", "1/K", closed(-1e-4, 1e-4),
               "thermal expansion of coating minus insert"),
        may<S>(&S::contact_temperature_c, "contact_temperature_c", "degC", closed(-50, 2000),
               "temperature of the contact"),
        may<S>(&S::stress_free_temperature_c, "stress_free_temperature_c", "degC", closed(-50, 2000),
               "temperature without thermal stress"),
        may<S>(&S::pair, "pair", "-", no_range(), "coating and work material"),
        may<S>(&S::contact_pressure_mpa, "contact_pressure_mpa", "MPa", closed(0, 1e4), "contact pressure"),
        may<S>(&S::adhesion_mpa, "adhesion_mpa", "MPa", open_low(0, 1e4), "shear strength of the bond"),
        may<S>(&S::heat_flux_w_m2, "heat_flux_w_m2", "W/m2", closed(0, 1e9), "heat flux into the insert"),
        may<S>(&S::insert_thickness_mm, "insert_thickness_mm", "mm", open_low(0, 100), "insert thickness"),
        may<S>(&S::insert_material, "insert_material", "-", no_range(), "carbide of the insert"),
        need<S>(&S::cycle_min, "cycle_min", "min", closed(0, 1e5), "time of a batch"),
        may<S>(&S::handling_min, "handling_min", "min", closed(0, 1e5), "handling of a batch"),
        may<S>(&S::batch_size, "batch_size", "1", closed(1, 1'000'000), "inserts of a batch"),
        may<S>(&S::life_cv, "life_cv", "1", closed(0.05, 2), "scatter of the lives as delivered"),
        may<S>(&S::breakage_fraction, "breakage_fraction", "1", probability(),
               "share of lives that end by breakage"),
        may<S>(&S::cost_per_insert, "cost_per_insert", "money", closed(0, 1e9), "cost of coating an insert")};
  }
};

namespace verstat::operations {

namespace {

namespace k402 = models::k402;

/// Does the bond hold? A continuous coating stands the shear of an island divided by what islands save.
void bond(const Coating& spec, CutPlan& p) {
  const bool islands = spec.coating == k402::CoatingKind::bumpy_nitrided;
  k402::HeatedIsland heated;
  heated.thickness_um = spec.thickness_um;
  heated.modulus_mpa = spec.modulus_mpa;
  heated.poisson = spec.poisson;
  heated.delta_alpha_1_k = spec.delta_alpha_1_k;
  heated.delta_t_k = spec.contact_temperature_c - spec.stress_free_temperature_c;
  heated.side_um = spec.island_side_um;
  const auto shear = k402::interface_thermal_shear(heated);
  const double saved = k402::discrete_shear_ratio({spec.island_side_um, spec.thickness_um}).ratio;
  const double thermal_mpa = islands ? shear.tau_max_mpa : shear.tau_max_mpa / saved;
  const double mu = k402::coating_friction({spec.pair}).mu;
  k402::LoadedInterface loaded;
  loaded.mu = mu;
  loaded.pressure_mpa = spec.contact_pressure_mpa;
  loaded.tau_thermal_mpa = thermal_mpa;
  loaded.adhesion_mpa = spec.adhesion_mpa;
  const auto held = k402::delamination_margin(loaded);
  auto& q = p.quantities;
  q.push_back({"thermal_shear_mpa", thermal_mpa, "MPa", "K402.interface_thermal_shear",
               "largest shear on the interface by heat"});
  q.push_back({"friction_shear_mpa", k402::mean_interface_shear({mu, spec.contact_pressure_mpa}).tau_mpa,
               "MPa", "K402.mean_interface_shear", "mean shear on the interface by friction"});
  q.push_back(
      {"interface_shear_mpa", held.tau_total_mpa, "MPa", "K402.delamination_margin", "both together"});
  p.limits.push_back({"interface_shear_mpa", held.tau_total_mpa, spec.adhesion_mpa, true, "MPa",
                      "K402.delamination_margin"});
  if (!islands) return;
  k402::LoadedCoating coating;
  static_cast<k402::HeatedCoating&>(coating) = heated;
  coating.mu = mu;
  coating.pressure_mpa = spec.contact_pressure_mpa;
  coating.adhesion_mpa = spec.adhesion_mpa;
  const auto largest = k402::largest_safe_island(coating);
  if (largest.feasible)
    q.push_back({"island_side_max_um", largest.side_um, "um", "K402.largest_safe_island",
                 "largest island in 10 to 200 um that holds"});
  q.push_back({"coverage", k402::island_coverage({spec.island_side_um, spec.island_pitch_um}).share, "1",
               "K402.island_coverage", "share of the face that the islands cover"});
}

}  // namespace

CutPlan plan(const Coating& spec, const PlanContext&) {
  const bool islands = spec.coating == k402::CoatingKind::bumpy_nitrided;
  models::require(!islands || spec.island_side_um <= spec.island_pitch_um, "island_side_um",
                  spec.island_side_um, "must not be above island_pitch_um");
  models::require(
      spec.insert_material == k402::Material::t15k6 || spec.insert_material == k402::Material::vk8,
      "insert_material", "given", "must be a carbide: T15K6 or VK8");
  const double over_continuous = k402::discrete_coating_life_factor({spec.coating}).factor;
  const double over_uncoated =
      spec.delivered == CoatingBase::uncoated
          ? models::k119::treatment_variant({.variant = models::k119::Treatment::tin}).life_ratio
          : 1;
  const char* origin = spec.delivered == CoatingBase::uncoated
                           ? "K402.discrete_coating_life_factor, K119.treatment_variant"
                           : "K402.discrete_coating_life_factor";
  const auto below = k402::insert_face_temperatures(
      {.contact_c = spec.contact_temperature_c,
       .flux_w_m2 = spec.heat_flux_w_m2,
       .coating_um = spec.thickness_um,
       .coating_w_mk = k402::thermal_conductivity({k402::Material::tin}).lambda_w_mk,
       .insert_mm = spec.insert_thickness_mm,
       .insert_w_mk = k402::thermal_conductivity({spec.insert_material}).lambda_w_mk});

  CutPlan p;
  p.quantities.reserve(12);
  p.set_main_time((spec.cycle_min + spec.handling_min) / static_cast<double>(spec.batch_size),
                  "definition: batch time over batch");
  const double factor = over_continuous * over_uncoated;
  p.quantities.push_back({"life_factor", factor, "1", origin, "mean life over that as delivered"});
  p.quantities.push_back({"interface_temperature_c", below.interface_c, "degC",
                          "K402.insert_face_temperatures", "under the coating"});
  bond(spec, p);
  p.lot = PreparedLot{.law = models::LifeLawKind::weibull,
                      .life_factor = factor,
                      .cv = spec.life_cv,
                      .breakage_fraction = spec.breakage_fraction,
                      .added_cost_per_insert = spec.cost_per_insert,
                      .origin = origin};
  return p;
}

namespace coating {
void add_to(Kinds& kinds) {
  kinds.add<Coating>("Inserts coated in islands or continuously: a lot with longer lives.", {"K402", "K119"});
}
}  // namespace coating

}  // namespace verstat::operations
