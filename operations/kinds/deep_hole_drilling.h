#pragma once
// Operation kind "deep_hole_drilling": a deep hole from the solid with an insert head on guide pads.
//
// The insert wears with cutting minutes, the guide pads with drilled metres (K120): two elements that are
// replaced independently.

#include "operations/kind.h"

namespace verstat::operations {

enum class PadCriterion {
  lead_in_lost,  ///< the contact begins to jump back from the lead-in
  tail_marked    ///< the wear spot has reached the tail of the pad
};

struct DeepHoleDrilling {
  static constexpr const char* kind = "deep_hole_drilling";
  double hole_diameter_mm = 0;
  double hole_length_mm = 0;
  double cutting_speed_m_min = 0;
  double feed_mm_rev = 0;
  double approach_mm = 0;

  /// Radial wear of a pad point, a L^b + c with L in metres, each point shifted behind its predecessor: from
  /// the shop's measurements, by K120.fit_pad_wear. None is published.
  double pad_wear_a_mm_m_b = 0;
  double pad_wear_b = 1;
  double pad_wear_c_mm = 0;
  double pad_shift_m = 0;
  double pad_critical_wear_mm = 0.045;
  double pad_trace_wear_mm = 0.002;
  double pad_life_cv = 0.7;
  PadCriterion pad_criterion = PadCriterion::tail_marked;

  std::optional<double> specific_cutting_force_mpa;
  std::optional<double> diameter_loss_max_mm;
};

/// Throws models::ModelError or models::DomainError for values outside the models' ranges.
[[nodiscard]] CutPlan plan(const DeepHoleDrilling& spec, const PlanContext& context);

}  // namespace verstat::operations

template <>
struct verstat::models::EnumNames<verstat::operations::PadCriterion> {
  using E = operations::PadCriterion;
  static constexpr std::array names{std::pair{E::lead_in_lost, "lead_in_lost"},
                                    std::pair{E::tail_marked, "tail_marked"}};
};
