#pragma once
// Operation kind "coating": a lot of inserts coated with titanium nitride, continuous or in separate islands
// (K402). Islands outlive a continuous coating as long as friction and heat do not shear them off.

#include <cstdint>

#include "models/treatment/k402_discrete_coating.h"
#include "operations/kind.h"

namespace verstat::operations {

/// What the lot is before.
enum class CoatingBase {
  uncoated,   ///< a continuous coating alone brings the life ratio of K119
  continuous  ///< the life factor is over that of a continuous coating
};

struct Coating {
  static constexpr const char* kind = "coating";
  models::k402::CoatingKind coating = models::k402::CoatingKind::bumpy_nitrided;
  CoatingBase delivered = CoatingBase::continuous;
  double island_side_um = 40;
  double island_pitch_um = 60;
  double thickness_um = 4;
  double modulus_mpa = 440'000;
  double poisson = 0.25;
  double delta_alpha_1_k = 3e-6;  ///< coating minus insert
  double contact_temperature_c = 800;
  double stress_free_temperature_c = 20;
  models::k402::FrictionPair pair = models::k402::FrictionPair::tin_carbon;
  double contact_pressure_mpa = 300;
  double adhesion_mpa = 500;
  double heat_flux_w_m2 = 1e5;
  double insert_thickness_mm = 4.76;
  models::k402::Material insert_material = models::k402::Material::t15k6;

  double cycle_min = 0;  ///< of a batch
  double handling_min = 0;
  std::int64_t batch_size = 1;
  double life_cv = 0.5;  ///< of the lot as delivered; coating is not known to change it
  double breakage_fraction = 0;
  double cost_per_insert = 0;
};

/// Throws models::ModelError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const Coating& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::CoatingBase> {
  using E = operations::CoatingBase;
  static constexpr std::array names{std::pair{E::uncoated, "uncoated"},
                                    std::pair{E::continuous, "continuous"}};
};
