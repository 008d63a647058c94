#pragma once
// Lapping of the thin elastic web of accelerometer pendulums (K311): how form, roughness, defect layer and
// allowance move from pass to pass, which limits end the forced stage, what a piece takes and costs while the
// lap wears, and a probabilistic model of the grains under the lap.
//
// Sazonov 2011. Lengths of the surface layer in um, times in min unless the name says otherwise. Inputs carry
// the symbols of the card in JSON; members carry their units.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k311 {

struct LappingPasses {
  std::vector<double> radii_um;
  std::vector<std::vector<double>> removals_um;  // one list per pass, one removal per radius
  std::int64_t sign = -1;
  double roughness_max_um = 0;
  double defect_depth_um = 0;
  double allowance_um = 0;
  double web_um = 0;
  double roughness_floor_um = 0;
  double defect_floor_um = 0;
  std::int64_t sides = 1;
};
struct LappedState {
  std::vector<double> radii_um;
  double form_deviation_um;
  double roughness_max_um;
  double defect_depth_um;
  double allowance_um;
  double web_um;
};
/// State after the passes, eqs. (1)-(5). Removals >= 0; sign -1 as printed, +1 for a concave groove; 1 or 2
/// lapped sides. The floors of roughness and defect depth and `sides` are COMPLETION: (3) as printed runs
/// below zero. A negative allowance means that too much was removed. Errors: no radius, a pass of another
/// length.
[[nodiscard]] LappedState lapping_cycle(const LappingPasses& in);

struct CycleState {
  double roughness_max_um = 0;
  double defect_depth_um = 0;
  double allowance_um = 0;
  double roughness_final_um = 0;
  double defect_final_um = 0;
  double force_n = 0;
  double force_max_n = 0;
  double speed_m_min = 0;
  double speed_max_m_min = 0;
};
struct CycleVerdict {
  bool roughness_ok;
  bool defect_ok;
  bool force_ok;
  bool speed_ok;
  bool ok;
};
/// In-process limits (9)-(12), equality allowed (slack 1e-12 um in (9), (10)). (10) repaired: printed with
/// h_dj on both sides; the defect depth of the finished part stands on the right.
[[nodiscard]] CycleVerdict cycle_constraints(const CycleState& in);

struct FinishedPart {
  double web_um = 0;
  double web_min_um = 0;
  double web_max_um = 0;
  double form_deviation_um = 0;
  double form_max_um = 0;
  double roughness_max_um = 0;
  double roughness_final_um = 0;
  double roughness_ra_um = 0;
  double roughness_ra_max_um = 0;
  double defect_depth_um = 0;
  double defect_final_um = 0;
};
struct Verdict {
  bool ok;
};
/// End conditions (7), (8); equality passes.
[[nodiscard]] Verdict final_conditions(const FinishedPart& in);

struct ForcedStage {
  double roughness_forced_um = 0;
  double defect_forced_um = 0;
  double roughness_final_um = 0;
  double defect_final_um = 0;
};
struct Allowance {
  double allowance_um;
};
/// Least allowance at which the forced stage must end: max(0, R_f - R_d, R_f + h_f - R_d - h_d), the exact
/// consequence of (9), (10).
[[nodiscard]] Allowance switch_allowance(const ForcedStage& in);

struct TwoStages {
  double allowance_um = 0;
  double rate_forced_um_min = 0;
  double rate_finish_um_min = 0;
  double allowance_switch_um = 0;
};
struct StageTimes {
  double forced_min;
  double finish_min;
  double total_min;
};
/// Times of the forced and the finishing stage. COMPLETION. An allowance below the switching one leaves only
/// the second stage.
[[nodiscard]] StageTimes two_stage_time(const TwoStages& in);

struct Piece {
  double allowance_um = 0;
  double rate_um_min = 0;
  double infeed_factor = 1;
  double preparation_min = 0;
  double change_min = 0;
  double changes = 0;  // per batch
  double parts = 1;    // per batch
};
struct PieceTime {
  double time_min;
};
/// Piece time, eq. (13): t = Pi K / Q + T_p + T_c n_c / n_parts.
[[nodiscard]] PieceTime piece_time(const Piece& in);

struct PieceExpense {
  double machine_rate_per_min = 0;
  double time_min = 0;
  double paste_g_mm3 = 0;
  double allowance_um = 0;
  double width_mm = 0;
  double length_mm = 0;
  double paste_price_per_g = 0;
  double changes = 0;
  double reset_cost = 0;
  double parts = 1;
};
struct PieceCost {
  double cost;
};
/// Cost of a part, eq. (14), repaired: the lap resets are divided by the parts of the batch, as in (13).
[[nodiscard]] PieceCost piece_cost(const PieceExpense& in);

struct GrainSizes {
  double mean_size_um = 0;
  double mean_in_lap_um = 0;
  double mean_in_gap_um = 0;
  double sd_size_um = 0;
  double sd_in_lap_um = 0;
  double sd_in_gap_um = 0;
};
struct DepthParameters {
  double mean_um;
  double sd_um;
};
/// Mean and standard deviation of the depth of grain penetration a = d - u_1 - u_2. Table 1, row 1.
[[nodiscard]] DepthParameters grain_depth_parameters(const GrainSizes& in);

/// Normal law of the penetration depth, truncated to 0..t_f.
struct DepthLaw {
  double mean_um = 0;
  double sd_um = 0;
  double greatest_um = 0;
};
struct DepthAt : DepthLaw {
  double depth_um = 0;
};
struct Density {
  double density_per_um;
};
/// Density of the penetration depth, zero outside 0..t_f. Table 1, row 1; the normalization mu to 0..t_f is a
/// COMPLETION. Error when the law has no mass in 0..t_f that a double can hold.
[[nodiscard]] Density grain_depth_pdf(const DepthAt& in);

struct GrainContact : DepthLaw {
  double grain_um = 0;
  double spacing_um = 0;
  double shape_factor = 2;
  double speed_m_min = 0;
  double time_s = 0;
};
struct GrainContactLevel : GrainContact {
  double level_um = 0;
};
struct Probability {
  double probability;
};
/// Probability that no grain has touched the level y below the outermost line, Table 1, row 2, repaired:
///   P = exp(-(chi V t / l_0^2) * integral over a in y..t_f of sqrt((a - y)(d - a + y)) f(a)).
/// Printed with a positive exponent and the density at a - y. Errors: t_f > d.
[[nodiscard]] Probability non_removal_probability(const GrainContactLevel& in);

struct LappedRoughness {
  double mean_removal_um;
  double ra_um;
  double r_max_um;
};
/// Mean removal, Ra (exact mean absolute deviation) and R_max = 6 Ra of a surface that started flat. Table 1,
/// rows 1-3.
[[nodiscard]] LappedRoughness lapped_roughness(const GrainContact& in);

struct LapContact : DepthLaw {
  double width_mm = 0;
  double length_mm = 0;
  double spacing_um = 0;
  double grain_um = 0;
  double hardness_mpa = 0;
  double contact_fraction = 0.5;
  double material_probability = 1;
};
struct LappingForce {
  double grains;
  double force_n;
};
/// Grains in contact and total normal force. Table 1, row 4, repaired (the total on the left side, a stray l
/// dropped); the force of a single grain, c pi a (d - a) HV, is a COMPLETION.
[[nodiscard]] LappingForce lapping_force(const LapContact& in);

struct LapLife {
  std::int64_t part = 1;
  double first_min = 0;
  std::int64_t parts_per_life = 2;
  double ratio = 1.38;
};
struct CycleTime {
  double time_min;
};
/// Cycle time of part j of a lap life, growing linearly to `ratio` at the last part (printed: 1.38).
/// COMPLETION (linear). Error: j outside 1..n_life.
[[nodiscard]] CycleTime cycle_time_with_lap_wear(const LapLife& in);

struct LapReset {
  double first_min = 0;
  double growth = 0;  // per part, relative
  double preparation_min = 0;
  double change_min = 0;
  std::int64_t parts_max = 1;
};
struct BestReset {
  std::int64_t parts;
  double time_min;
};
/// Parts between lap resets with the least mean piece time t_1 (1 + g (n - 1) / 2) + T_p + T_c / n,
/// n = 1..n_max; the smallest n within 1e-12 min of it. COMPLETION (renewal-reward).
[[nodiscard]] BestReset best_lap_reset(const LapReset& in);

struct PrestonInputs {
  double coefficient_um_mpa_m = 0;
  double force_n = 0;
  double area_mm2 = 0;
  double speed_m_min = 0;
};
struct RemovalRate {
  double rate_um_min;
};
/// Preston's removal rate, Q = k (P / A) V. COMPLETION.
[[nodiscard]] RemovalRate preston_rate(const PrestonInputs& in);

}  // namespace verstat::models::k311
