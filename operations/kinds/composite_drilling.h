#pragma once
// Operation kind "composite_drilling": holes through a laminate with a two-stage step drill, or a plain one.
//
// When a stage breaks through, its thrust pushes the last ply off: the feed at the exit is limited by the
// critical thrust of every stage (K404), and scatter of thrust and ply strength delaminates some holes.

#include <cstdint>

#include "operations/kind.h"

namespace verstat::operations {

enum class LaminateDrill { step, plain };
enum class DelaminationCriterion {
  clamped,  ///< one boundary condition for both stages, K404 (C1)
  printed   ///< K404 eqs. (1), (2): refused beyond the pole of (2)
};

struct CompositeDrilling {
  static constexpr const char* kind = "composite_drilling";
  LaminateDrill drill = LaminateDrill::step;
  double diameter_mm = 0;
  double step_ratio = 0.4;
  double step_length_mm = 5;
  double thickness_mm = 0;
  std::int64_t holes = 1;
  double index_min = 0;
  double approach_mm = 2;
  double overrun_mm = 1;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  std::optional<double> exit_feed_mm_rev;  ///< absent: the feed
  double exit_zone_mm = 1;                 ///< of each stage, before it breaks through

  double elastic_modulus_mpa = 14000;
  double ply_thickness_mm = 0.5;
  double poisson = 0.32;
  double stress_intensity_mpa_m05 = 1.7;
  DelaminationCriterion criterion = DelaminationCriterion::clamped;

  /// Thrust of a stage, c w f^y, w the diameter that it takes.
  double thrust_first_n_mm = 90;
  double thrust_next_n_mm = 45;
  double thrust_exp_feed = 0.8;
  double flank_wear_mm = 0;
  double thrust_growth_per_mm = 0;  ///< relative, per mm of flank wear
  double safety = 1;
  double thrust_cv = 0.1;
  double critical_cv = 0.1;
  std::optional<double> scrap_probability_max;
  std::optional<double> working_relief_min_deg;
};

/// Throws models::ModelError or models::DomainError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const CompositeDrilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::LaminateDrill> {
  using E = operations::LaminateDrill;
  static constexpr std::array names{std::pair{E::step, "step"}, std::pair{E::plain, "plain"}};
};
template <>
struct verstat::models::EnumNames<verstat::operations::DelaminationCriterion> {
  using E = operations::DelaminationCriterion;
  static constexpr std::array names{std::pair{E::clamped, "clamped"}, std::pair{E::printed, "printed"}};
};
