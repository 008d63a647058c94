#pragma once
// Heat fluxes into the tool and temperatures of rake and flank from the start of a cut to the steady state,
// in continuous and interrupted cutting; the speed that a temperature limit allows (K403).
//
// Ivchenko, Petryaeva, Polyakova 2011 (Reznikov's heat balance). Rises above ambient in kelvin; heat fluxes
// per area of contact, positive into the tool. Index d = workpiece, u = tool.

#include "models/catalogue/catalogue.h"

namespace verstat::models::k403 {

/// How a quantity is computed: by the paper's formula (repaired) or by the exact conduction solution.
enum class Model { exact, paper };

struct FourierNumber {
  double fo = 0;
};
struct WarmUp {
  double m;
};
/// Share of the steady rise at the dimensionless time Fo, eq. (1): 4e-3 Fo up to 200, 0.147 Fo^0.32 up to
/// 400, then 1; 0 for Fo <= 0. Starts too slowly (a constant flux heats as sqrt(Fo)): for reproduction only.
[[nodiscard]] WarmUp m_fo_paper(const FourierNumber& in);

struct WedgeContact {
  double width_mm = 0;
  double rake_length_mm = 0;
  double flank_length_mm = 0;
  double wedge_deg = 90;
  Model model = Model::exact;
};
struct WedgeFunctions {
  double m1, m2;  // own contact: rake, flank
  double n1, n2;  // the other contact: flank from rake, rake from flank
};
/// Influence functions of the wedge, "paper" eq. (5), (6), repaired; "exact" images (C4), (C5).
[[nodiscard]] WedgeFunctions wedge_functions(const WedgeContact& in);

struct ChipSide {
  double cutting_speed_m_min = 0;
  double chip_compression = 2;
  double rake_length_mm = 0;
  double flank_length_mm = 0;
  double m = 1;
  double m1 = 0;
  double shear_flux_w_mm2 = 0;
  double rake_flux_w_mm2 = 0;
  double flank_flux_w_mm2 = 0;
  double chip_share = 1;
  double flank_temperature_share = 1;
  double preheating = 0.1;
  double work_conductivity_w_mk = 40;
  double work_diffusivity_mm2_s = 8;
  double tool_conductivity_w_mk = 37.7;
};
struct ChipSideCoefficients {
  double k1_k, k2_k;          // temperatures with no heat entering the tool
  double k3_m2k_w, k4_m2k_w;  // drop per heat flux into the tool
};
/// K1..K4 under eq. (2).
[[nodiscard]] ChipSideCoefficients chip_side_coefficients(const ChipSide& in);

struct HeatBalance {
  double k1_k = 0, k2_k = 0;
  double k3_m2k_w = 0, k4_m2k_w = 0;
  double rake_length_mm = 0;
  double flank_length_mm = 0;
  double m = 1;
  double m2 = 0, n1 = 0, n2 = 0;
  double tool_conductivity_w_mk = 37.7;
};
struct HeatFluxes {
  double rake_w_mm2, flank_w_mm2;
};
/// Fluxes into the tool through rake and flank from equal temperatures on both sides, eq. (2), repaired.
[[nodiscard]] HeatFluxes heat_fluxes(const HeatBalance& in);

struct HeatedContact {
  double rake_flux_w_mm2 = 0, flank_flux_w_mm2 = 0;
  double rake_length_mm = 0;
  double flank_length_mm = 0;
  double m = 1;
  double m1 = 0, m2 = 0, n1 = 0, n2 = 0;
  double tool_conductivity_w_mk = 37.7;
};
struct ContactTemperatures {
  double rake, flank, mean;  // rises or degC, as the function says
};
/// Mean rises of rake, flank and both (weighted by their lengths), eq. (3), (4).
[[nodiscard]] ContactTemperatures contact_temperatures(const HeatedContact& in);

struct ChipFormation {
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double depth_mm = 0;
  double flank_wear_mm = 0;
  double kr_deg = 60;
  double rake_deg = 0;
  double chip_compression = 2.0;
  double kc11_n_mm2 = 2000;
  double mc = 0.25;
  double thrust_ratio = 0.5;
  double flank_shear_n_mm2 = 250;
  double work_diffusivity_mm2_s = 8.0;
};
struct HeatSources {
  double cutting_force_n;
  double rake_friction_n;
  double chip_thickness_mm;
  double chip_width_mm;
  double rake_length_mm;
  double shear_angle_deg;
  double shear_flux_w_mm2;
  double rake_flux_w_mm2;
  double flank_flux_w_mm2;
  double chip_share;               // of the shear heat
  double flank_temperature_share;  // dimensionless temperature under the flank
};
/// Forces, contact and heat sources: Kienzle, Merchant, Abuladze, Boothroyd, (C1)-(C3). COMPLETION.
[[nodiscard]] HeatSources heat_sources(const ChipFormation& in);

struct WedgeFourier {
  double fo = 0;
  double eta = 1;
};
/// Exact warm-up of a rectangle (eta = width/length) at the edge of a 90 degree wedge, (C6). COMPLETION.
[[nodiscard]] WarmUp m_fo_exact(const WedgeFourier& in);

struct PeriodicContact {
  double fo_cut = 0;
  double fo_period = 1;
  double eta = 1;
};
/// Warm-up at the end of a contact in the periodic state, pulses of constant flux superposed, (C7).
/// COMPLETION.
[[nodiscard]] WarmUp m_periodic(const PeriodicContact& in);

struct CuttingZone : ChipFormation {
  double relief_deg = 10;
  double preheating = 0.1;
  double work_conductivity_w_mk = 40;
  double tool_conductivity_w_mk = 37.7;
  double tool_diffusivity_mm2_s = 14.0;
  double ambient_c = 20;
};
struct ContinuousCut : CuttingZone {
  double time_s = -1;
  Model m_model = Model::exact;
  Model wedge = Model::exact;
  double fo_scale = 1;
};
struct CuttingTemperature {
  double rake_c, flank_c, mean_c;
  double rake_flux_w_mm2, flank_flux_w_mm2;
  double m;
};
/// Temperatures and fluxes at a time after the start of the cut (negative: steady). COMPLETION around
/// eq. (2)-(4).
[[nodiscard]] CuttingTemperature cutting_temperature(const ContinuousCut& in);

struct InterruptedCut : CuttingZone {
  double contact_s = 0;
  double period_s = 1;
};
/// Peak (end of a contact) of interrupted cutting in the periodic state. COMPLETION.
[[nodiscard]] CuttingTemperature interrupted_cutting_temperature(const InterruptedCut& in);

struct Settling : CuttingZone {
  double fraction = 0.95;
  Model m_model = Model::exact;
  Model wedge = Model::exact;
  double fo_scale = 1;
};
struct SettlingTime {
  double time_s;
};
/// Time at which the rise of the mean temperature first reaches a fraction of its steady value. COMPLETION.
[[nodiscard]] SettlingTime settling_time(const Settling& in);

struct TemperatureLimit : CuttingZone {
  double limit_c = 0;
};
struct SpeedLimit {
  bool feasible;
  double speed_m_min;
};
/// Largest speed in 10..600 m/min whose steady mean temperature keeps the limit. COMPLETION.
[[nodiscard]] SpeedLimit speed_for_temperature(const TemperatureLimit& in);

}  // namespace verstat::models::k403

template <>
struct verstat::models::EnumNames<verstat::models::k403::Model> {
  static constexpr std::array names{std::pair{k403::Model::exact, "exact"},
                                    std::pair{k403::Model::paper, "paper"}};
};
