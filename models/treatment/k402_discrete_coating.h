#pragma once
// Wear-resistant coatings deposited as separate islands: heat conduction through the layer, shear on the
// interface from friction and from thermal expansion, and the largest island that holds (K402).
//
// Soroka et al. 2011: finite-element results without formulas; equilibrium and shear lag stand in.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k402 {

enum class Material { tin, t15k6, vk8, air };
enum class FrictionPair { tin_carbon, tin_chromium, tin_alumina, tin_mos_chromium };
enum class CoatingKind { bumpy_nitrided, continuous };

struct ConductingMaterial {
  Material material = Material::tin;
};
struct Conductivity {
  double lambda_w_mk;
};
/// Thermal conductivity used in the study.
[[nodiscard]] Conductivity thermal_conductivity(const ConductingMaterial& in);

struct SlidingPair {
  FrictionPair pair = FrictionPair::tin_carbon;
};
struct Friction {
  double mu;
};
/// Friction coefficient of a coating, literature cited by the paper.
[[nodiscard]] Friction coating_friction(const SlidingPair& in);

struct CoatingVariant {
  CoatingKind kind = CoatingKind::continuous;
};
struct LifeFactor {
  double factor_min, factor_max, factor;
};
/// Wear resistance over that of the continuous coating.
[[nodiscard]] LifeFactor discrete_coating_life_factor(const CoatingVariant& in);

struct CoatingHeat {
  double flux_w_m2 = 0;
  double thickness_um = 0;
  double conductivity_w_mk = 0;
};
struct TemperatureDrop {
  double delta_k;
};
/// Temperature drop over the coating, q h / lambda, eq. (2).
[[nodiscard]] TemperatureDrop coating_temperature_drop(const CoatingHeat& in);

struct CoatedInsert {
  double contact_c = 0;
  double flux_w_m2 = 0;
  double coating_um = 0;
  double coating_w_mk = 0;
  double insert_mm = 0;
  double insert_w_mk = 0;
};
struct FaceTemperatures {
  double interface_c, support_c;
};
/// Temperatures below the coating and at the support face, one-dimensional. COMPLETION (C1).
[[nodiscard]] FaceTemperatures insert_face_temperatures(const CoatedInsert& in);

struct IslandLoad {
  double mu = 0;
  double pressure_mpa = 0;
};
struct MeanShear {
  double tau_mpa;
};
/// Interface shear averaged over an island, mu q: equilibrium, eq. (1).
[[nodiscard]] MeanShear mean_interface_shear(const IslandLoad& in);

struct HeatedCoating {
  double thickness_um = 0;
  double modulus_mpa = 0;
  double poisson = 0;
  double delta_alpha_1_k = 0;  // coating minus substrate
  double delta_t_k = 0;        // contact minus stress-free temperature
};
struct HeatedIsland : HeatedCoating {
  double side_um = 0;
};
struct ThermalShear {
  double tau_max_mpa, sigma_centre_mpa;  // positive: the island is compressed
};
/// Largest interface shear and stress in the middle of a heated island, shear lag. COMPLETION (C2).
[[nodiscard]] ThermalShear interface_thermal_shear(const HeatedIsland& in);

struct IslandSizes {
  double large_um = 0, small_um = 0;
  double thickness_um = 0;
};
struct ShearRatio {
  double ratio;
};
/// Thermal shear of a larger island over a smaller one. COMPLETION.
[[nodiscard]] ShearRatio size_effect(const IslandSizes& in);

struct Island {
  double side_um = 0;
  double thickness_um = 0;
};
/// Thermal shear of an island over that of a continuous coating. COMPLETION (C3), calibrated on the paper.
[[nodiscard]] ShearRatio discrete_shear_ratio(const Island& in);

struct LoadedInterface : IslandLoad {
  double tau_thermal_mpa = 0;
  double adhesion_mpa = 0;
};
struct Delamination {
  double tau_total_mpa;
  double margin;
  bool holds;
};
/// Thermal plus friction shear against adhesion. COMPLETION (C4).
[[nodiscard]] Delamination delamination_margin(const LoadedInterface& in);

struct LoadedCoating : HeatedCoating {
  double mu = 0;
  double pressure_mpa = 0;
  double adhesion_mpa = 0;
};
struct SafeIsland {
  bool feasible;
  double side_um;
};
/// Largest island in 10..200 um that holds. COMPLETION.
[[nodiscard]] SafeIsland largest_safe_island(const LoadedCoating& in);

struct IslandGrid {
  double side = 0, pitch = 0;
};
struct Coverage {
  double share;
};
/// Area share of island tops, (side/pitch)^2.
[[nodiscard]] Coverage island_coverage(const IslandGrid& in);

}  // namespace verstat::models::k402

template <>
struct verstat::models::EnumNames<verstat::models::k402::Material> {
  static constexpr std::array names{
      std::pair{k402::Material::tin, "TiN"}, std::pair{k402::Material::t15k6, "T15K6"},
      std::pair{k402::Material::vk8, "VK8"}, std::pair{k402::Material::air, "air"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k402::FrictionPair> {
  static constexpr std::array names{
      std::pair{k402::FrictionPair::tin_carbon, "TiN-carbon steel"},
      std::pair{k402::FrictionPair::tin_chromium, "TiN-chromium steel"},
      std::pair{k402::FrictionPair::tin_alumina, "TiN-alumina"},
      std::pair{k402::FrictionPair::tin_mos_chromium, "TiN+MoSx-chromium steel"}};
};
template <>
struct verstat::models::EnumNames<verstat::models::k402::CoatingKind> {
  static constexpr std::array names{std::pair{k402::CoatingKind::bumpy_nitrided, "bumpy_nitrided"},
                                    std::pair{k402::CoatingKind::continuous, "continuous"}};
};
