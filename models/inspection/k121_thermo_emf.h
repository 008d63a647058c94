#pragma once
// Sorting carbide inserts by thermo-EMF (K121): the EMF E between an insert and a hot electrode says how fast
// the insert may cut. Non-destructive, takes seconds; the lowest E belongs to the best inserts.
//
// Babenko, Krasovsky, Khoroshailo, Polupanov 2011. Fitted for T14K8 turning ShKh15; E in mV (COMPLETION, the
// unit is not printed). Where to start: emf_limit_for_regime for incoming inspection, emf_group_plan for
// sorting, multi_insert_set_life for tools with several inserts.

#include <cstdint>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k121 {

/// EMF at which the speed of eq. (2) falls to zero: 501/41 mV.
inline constexpr double emf_end_mv = 501.0 / 41.0;

struct Emf {
  double emf_mv = 0;
};
struct SpeedCoefficient {
  double c_v;
};
/// c_v = (501 - 41 E)/E^0.24, 0 < E < 501/41 mV.   K121 eq. (2), all of E in one factor.
[[nodiscard]] SpeedCoefficient emf_speed_coefficient(const Emf& in);

/// Depth and feed of the cut, and the product of correction factors (without the tool grade, see the card).
struct Cut {
  double depth_mm = 0;
  double feed_mm_rev = 0;
  double k_v = 1;
};
struct SpeedForLife : Emf, Cut {
  double tool_life_min = 0;
};
struct Speed {
  double speed_m_min;
};
/// v = (501 - 41 E) K_v/(T^0.2 t^0.15 S^0.35 E^0.24).   K121 eq. (2) as printed.
[[nodiscard]] Speed emf_cutting_speed(const SpeedForLife& in);

struct LifeAtSpeed : Emf, Cut {
  double speed_m_min = 0;
};
struct ToolLife {
  double tool_life_min;
};
/// Eq. (2) solved for the tool life.
[[nodiscard]] ToolLife emf_tool_life(const LifeAtSpeed& in);

struct Handbook : Cut {
  double c_v = 0;
  double tool_life_min = 0;
  double m = 0;
  double x = 0;
  double y = 0;
};
/// v = C_v K_v/(T^m t^x S^y).   K121 eq. (1).
[[nodiscard]] Speed handbook_cutting_speed(const Handbook& in);

struct Sensitivity {
  double dln_speed_per_mv;
  double dln_life_per_mv;
};
/// d ln v/dE = -41/(501 - 41 E) - 0.24/E and five times that for the life. COMPLETION.
[[nodiscard]] Sensitivity emf_sensitivity(const Emf& in);

struct RoomEmf : Emf {
  double room_c = 0;
  double reference_c = 20;
};
struct ReferenceEmf {
  double emf_ref_mv;
};
/// EMF at the reference temperature of the cold side:  E (100 - T_ref)/(100 - T_room). COMPLETION.
[[nodiscard]] ReferenceEmf emf_room_correction(const RoomEmf& in);

struct RegimeForLimit : Cut {
  double speed_m_min = 0;
  double tool_life_min = 0;
};
struct EmfLimit {
  double emf_limit_mv;
  bool feasible;
};
/// Largest E that still gives the life at the speed; 0 and not feasible when E = 0.05 mV is too slow.
/// COMPLETION (eq. (2) solved for E).
[[nodiscard]] EmfLimit emf_limit_for_regime(const RegimeForLimit& in);

enum class GroupMode {
  quantile,  ///< equal counts
  width      ///< equal bins over mean -2..+2 sd, outer bins open
};
/// A delivery with normally distributed EMF and its sorting into groups.
struct Delivery {
  double emf_mean_mv = 0;
  double emf_sd_mv = 0;
};
struct Sorting : Delivery {
  std::int64_t groups = 5;
  GroupMode mode = GroupMode::quantile;
};
struct Groups {
  std::vector<double> inner_bounds_mv;
  std::vector<double> share;
  std::vector<double> mean_emf_mv;
  double within_variance_share;
};
/// Bounds, shares and mean EMF of the groups, lowest EMF (best group) first. COMPLETION.
[[nodiscard]] Groups emf_sort_groups(const Sorting& in);

struct GroupPlanIn : Sorting, Cut {
  double tool_life_min = 0;
  double common_speed_m_min = 0;
};
struct GroupPlan {
  std::vector<double> speed_at_target_life_m_min;
  std::vector<double> life_at_common_speed_min;
};
/// Speed of each group at equal life, and life of each group at equal speed, at its mean EMF. COMPLETION.
[[nodiscard]] GroupPlan emf_group_plan(const GroupPlanIn& in);

struct ScatterIn : Sorting {
  double life_cv_total = 0;
};
struct LifeScatter {
  double rho;
  double ln_sd_total;
  double ln_sd_between;
  double ln_sd_within;
  double life_cv_within;
};
/// Share of the life scatter that sorting removes (lognormal life, law of total variance). COMPLETION.
[[nodiscard]] LifeScatter emf_life_scatter(const ScatterIn& in);

struct ScreenIn : Delivery, Cut {
  double emf_limit_mv = 0;
  double speed_m_min = 0;
};
struct ScreenedLife {
  double reject_fraction;
  double mean_life_all_min;
  double mean_life_accepted_min;
};
/// Mean life when only inserts with E <= limit are used. COMPLETION.
[[nodiscard]] ScreenedLife emf_screened_life(const ScreenIn& in);

struct InsertSet {
  double median_life_min = 0;
  double ln_sd_between = 0;
  double ln_sd_within = 0;
  std::int64_t inserts = 1;
};
struct SetLife {
  double median_random_min;
  double median_sorted_min;
  double gain;
};
/// Median life of a set of n inserts, which ends with the first of them, drawn at random and from one group.
///   median exp(-u s), u = Phi^-1(2^(-1/n)). COMPLETION.
[[nodiscard]] SetLife multi_insert_set_life(const InsertSet& in);

}  // namespace verstat::models::k121

template <>
struct verstat::models::EnumNames<verstat::models::k121::GroupMode> {
  static constexpr std::array names{std::pair{k121::GroupMode::quantile, "quantile"},
                                    std::pair{k121::GroupMode::width, "width"}};
};
