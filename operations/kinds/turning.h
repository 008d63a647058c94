#pragma once
// Operation kind "turning": a cylinder turned lengthwise in passes.
//
// Main time and edge life from K117. What more is known about the cut adds to the plan: the insert gives the
// chip section (K102) and the roughness (K411), the material the cutting force and power of Kienzle
// (COMPLETION) and the forces of the handbook (K102), the heat properties the temperatures (K403).

#include <cstdint>

#include "models/cutting/k102_insert_nose_radius_forces.h"
#include "operations/kind.h"

namespace verstat::operations {

/// Specific cutting force of the work material, and its strength. COMPLETION (textbook).
struct TurningMaterial {
  double kc11_n_mm2 = 2000;                    ///< k_c1.1, of a chip 1 mm thick and 1 mm wide
  double mc = 0.25;                            ///< exponent of the chip thickness
  std::optional<double> tensile_strength_mpa;  ///< adds the handbook's force components
};

/// Cutting corner of an indexable insert in its holder. Angles of both edges against the feed direction.
struct TurningInsert {
  double nose_radius_mm = 0.8;
  double kr_deg = 90;
  double kr1_deg = 10;
  double rake_deg = 0;
  double inclination_deg = 0;  ///< handbook's sign: positive when the nose is the lowest point of the edge
  models::k102::RakeShape rake_shape = models::k102::RakeShape::flat;
};

/// What the temperatures of the cutting zone depend on, besides the regime. Defaults: steel 45, T5K10.
struct TurningHeat {
  double flank_wear_mm = 0.1;  ///< at which the temperature is asked
  double relief_deg = 10;
  double chip_compression = 2;
  double thrust_ratio = 0.5;
  double flank_shear_n_mm2 = 250;
  double preheating = 0.1;
  double work_conductivity_w_mk = 40;
  double work_diffusivity_mm2_s = 8;
  double tool_conductivity_w_mk = 37.7;
  double tool_diffusivity_mm2_s = 14;
  double ambient_c = 20;
};

/// Contact of chip and rake face at high temperature, K110: what the mean and its hot spots allow.
struct TurningContact {
  double heat_capacity_n_mm2_k = 0;  ///< of the work material, per volume
  double diffusivity_mm2_s = 0;      ///< of the work material
  double temperature_coefficient = 0.4;
  double hot_spot_factor = 1;  ///< local over mean rise; published 1.8 to 2.8
  double ambient_c = 20;
  std::optional<double> hot_spot_max_c;
  double hot_area_fraction = 0;         ///< of the contact that runs at the hot spots' temperature
  double activation_energy_kj_mol = 0;  ///< of the wear; with a hot area it shortens the edge's life
};

struct Turning {
  static constexpr const char* kind = "turning";
  double diameter_mm = 0;
  double length_mm = 0;
  std::int64_t passes = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_of_cut_mm = 0;
  std::optional<TurningMaterial> material;
  std::optional<TurningInsert> insert;
  std::optional<TurningHeat> heat;           ///< needs material
  std::optional<TurningContact> contact;     ///< needs material
  std::optional<double> force_max_n;         ///< on the cutting force; needs material
  std::optional<double> radial_force_max_n;  ///< needs insert and the material's strength
  std::optional<double> roughness_max_um;    ///< on Ra; needs insert
  bool scrap_above_roughness = false;        ///< parts above roughness_max_um are scrap
  std::optional<double> temperature_max_c;   ///< on the mean of the contacts; needs heat
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for a limit on a
/// quantity that the given members do not determine.
[[nodiscard]] CutPlan plan(const Turning& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::StructFields<verstat::operations::TurningMaterial> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::TurningInsert> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::TurningContact> {
  static std::vector<Field> fields();
};
template <>
struct verstat::models::StructFields<verstat::operations::TurningHeat> {
  static std::vector<Field> fields();
};
