#pragma once
// Roughness and defect layer in combined (abrasive and electrochemical) surface grinding (K302).
//
// Grain tips lie over the depth of the wheel by a power law; the grooves of many grains overlap at random, so
// every level of the surface has a probability of having been removed. From it follow the median depth, Ra,
// Rmax and Rz; electrochemical dissolution flattens the layer; a recursion follows the heat-affected layer
// from pass to pass.
//
// Bratan, Revenko 2011. Heights and depths in um, G and Theta in powers of mm; wheel diameter is the
// equivalent diameter (surface grinding: the wheel's own). Valid while the depth stays within the wheel
// layer.

#include <cstdint>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k302 {

struct MarkGeometry {
  double profile_exponent = 0;   // m of the groove width law b = C_B t^m
  double tip_exponent = 0;       // chi of the tip-depth law
  double chip_coefficient = 0;   // K_C
  double width_coefficient = 0;  // C_B, mm^(1-m)
  double grains_per_mm2 = 0;
  double wheel_speed_m_s = 0;
  double work_speed_m_min = 0;
  bool up_grinding = true;
  double wheel_diameter_mm = 0;
  double wheel_layer_mm = 0;
};
struct MarkIntensity {
  double nu;
  double g_per_mm_nu;
  double theta;  // mm^-(chi + 3/2)
};
/// Exponent nu = m + chi + 1/2, intensity G of abrasive marks (mm^-nu) and intensity Theta of tips per length
/// (mm^-(chi+3/2)); K302, text of eqs. (4) and (12). Lengths > 0, 0 < K_C <= 1; the work may not overtake the
/// wheel in down grinding.
[[nodiscard]] MarkIntensity abrasive_mark_intensity(const MarkGeometry& in);

struct MarkField {
  double g_per_mm_nu = 0;
  double nu = 0;
  double shift_um = 0;  // Q, displacement of the surface per contact
  std::int64_t contacts = 1;
  std::int64_t sparkout_contacts = 0;
};
struct MedianDepth {
  double median_depth_um;
};
/// Distance W_m from the deepest valley to the mean line: G S_nu(W_m) = ln 2, K302 eq. (7) with i from 0 and
/// spark-out contacts (completion).
[[nodiscard]] MedianDepth median_depth(const MarkField& in);

struct MarkFieldAtDepth : MarkField {
  double median_depth_um = 0;
};
struct RoughnessRa {
  double ra_um;
};
/// Ra = 2 / (pi G nu S_{nu-1}(W_m)), K302 eq. (6). W_m > 0 from median_depth, or half the layer (eq. 8).
[[nodiscard]] RoughnessRa roughness_ra(const MarkFieldAtDepth& in);

struct LevelInProfile : MarkFieldAtDepth {
  double height_um = 0;
};
struct LevelRemoval {
  double probability_removed;
  double density_per_um;
};
/// Probability that the level y above the mean line has been removed, F = 1 - exp(-G S_nu(W_m + y)), and its
/// density; K302 eq. (4). Both 0 at and below the deepest reach.
[[nodiscard]] LevelRemoval profile_distribution(const LevelInProfile& in);

struct ExactRoughness {
  double ra_um;
  double rq_um;
  double mean_depth_um;
};
/// Ra, Rq and mean depth by integrating eq. (4), without the assumption of a normal profile.
[[nodiscard]] ExactRoughness roughness_ra_exact(const MarkField& in);

struct SteadyLayer : MarkField {
  double beta = 0.99;
};
struct SteadyLayerHeight {
  double mechanical_height_um;
  double actual_depth_um;
};
/// Height of the layer in which the removal probability grows to beta, and the depth that brings it:
/// G S_nu(H) = -ln(1 - beta), t_f = H + Q. COMPLETION C1. 0 < beta < 1.
[[nodiscard]] SteadyLayerHeight layer_height_steady(const SteadyLayer& in);

struct LayerRemoval {
  double actual_depth_um = 0;
  double mechanical_removal_um = 0;
  double dissolved_peak_um = 0;
  double dissolved_valley_um = 0;
};
struct LayerHeight {
  double mechanical_height_um;
  double layer_height_um;
};
/// H_mech = t_f - Q_mech and H = H_mech - (Q_peak - Q_valley), the latter not below 0; K302 eqs. (1), (2).
[[nodiscard]] LayerHeight roughness_layer(const LayerRemoval& in);

struct Flattening {
  double ra_mechanical_um = 0;
  double mechanical_height_um = 0;
  double dissolved_peak_um = 0;
  double dissolved_valley_um = 0;
};
/// Ra after dissolution, lowered as the layer is. COMPLETION C2 (in place of eqs. 9 and 10).
[[nodiscard]] RoughnessRa combined_ra(const Flattening& in);

struct ProfileExtremes {
  double layer_height_um = 0;
  double theta = 0;
  double tip_exponent = 0;
  double base_length_mm = 0;
};
struct ExtremeRoughness {
  double rmax_um;
  double rz_um;
};
/// Expected Rmax and Rz over the base length, K302 eqs. (11), (12) with 1/(Theta l) for the printed Q/l.
/// Negative when the layer is too thin for the order statistics.
[[nodiscard]] ExtremeRoughness roughness_extremes(const ProfileExtremes& in);

struct ProfileExtremesChi15 {
  double layer_height_um = 0;
  double actual_depth_um = 0;
  double grains_per_mm2 = 0;
  double wheel_speed_m_s = 0;
  double work_speed_m_min = 0;
  bool up_grinding = true;
  double wheel_diameter_mm = 0;
  double base_length_mm = 0;
};
/// The same for tips with chi = 1.5 and a wheel layer as deep as the cut, K302 eqs. (13), (14);
/// constant 2.948 as printed (exactly 2.94704).
[[nodiscard]] ExtremeRoughness roughness_extremes_chi15(const ProfileExtremesChi15& in);

struct TipExponent {
  double tip_exponent = 0;
};
struct ExtremeCoefficients {
  double rmax;
  double rz;
};
/// Coefficients c of R = H - c [V_u H_u^chi / (n_3 (V_K +- V_u) sqrt(D) l)]^(1/(chi + 1/2)) for Rmax and Rz.
[[nodiscard]] ExtremeCoefficients extreme_height_coefficients(const TipExponent& in);

struct Dissolution {
  double volume_equivalent_mm3_a_min = 0;
  double efficiency = 0;
  double conductivity_s_m = 0;
  double voltage_v = 0;
  double peak_gap_um = 0;
  double layer_height_um = 0;
  double exposure_s = 0;
};
struct DissolvedDepth {
  double peak_um;
  double valley_um;
};
/// Depth dissolved at peaks and valleys by Faraday's law at a constant gap. COMPLETION C3.
[[nodiscard]] DissolvedDepth electrochemical_removal(const Dissolution& in);

struct HeatSource {
  double alpha_um_mm2_j = 0;
  double xi = 0;
  double flux_w_mm2 = 0;
  double threshold_flux_w_mm2 = 0;
  double half_width_mm = 0;
  double source_speed_m_min = 0;
  double heat_share = 0;
};
struct DefectFromWork {
  double depth_um;
  double specific_work_j_mm2;
};
/// Depth of the defect layer from the heat per area, h = alpha xi (q - q_0)_+ h_q / V, and the specific work
/// W = q h_q / (K V); K302 eq. (15), with the speed of the work as V.
[[nodiscard]] DefectFromWork defect_depth_specific_work(const HeatSource& in);

struct SurfaceHeating {
  double surface_c = 0;
  double transform_c = 0;
  double ambient_c = 0;
  double diffusivity_mm2_s = 0;
  double source_time_s = 0;
};
struct DefectFromTemperature {
  double depth_um;
  double depth_exact_um;
};
/// Depth to which the transformation temperature reaches: K302 eq. (16) with the sign repaired, and the exact
/// half-space solution 2 sqrt(a tau) erfc^-1(T_tr / T) (completion). Both 0 for T <= T_tr.
[[nodiscard]] DefectFromTemperature defect_depth_temperature(const SurfaceHeating& in);

struct DefectBeforePass {
  double previous_um = 0;
  double removed_um = 0;
  double introduced_um = 0;
};
struct DefectDepth {
  double depth_um;
};
/// h_i = max{0, h_{i-1} - removed, introduced}, K302 eq. (17).
[[nodiscard]] DefectDepth defect_depth_after_pass(const DefectBeforePass& in);

struct DefectTarget {
  double initial_um = 0;
  double removed_um = 0;
  double introduced_um = 0;
  double target_um = 0;
};
struct PassCount {
  std::int64_t passes;
};
/// Equal passes until the defect layer is no deeper than the target; -1 when it never is. COMPLETION.
[[nodiscard]] PassCount passes_to_reach_defect(const DefectTarget& in);

}  // namespace verstat::models::k302
