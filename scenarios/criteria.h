#pragma once
// How the shop is judged as a whole: settings of the criteria of efficiency (K205).

#include "models/criteria/k205_hierarchical_efficiency.h"

namespace verstat::scenarios {

/// Adds the ten criteria of a run to its KPIs; with best and worst values also their hierarchy.
struct CriteriaSettings {
  double mission_min = 480;        ///< windows of the machines, with or without a failure
  double operator_load_limit = 1;  ///< load of the busiest crew at which the socio-ergonomic index is zero
  models::k205::Bests best;        ///< of a criterion; together with worst
  models::k205::Worsts worst;
  models::k205::LocalWeights local_weights;
  models::k205::GroupWeights group_weights;
  models::k205::Form local_form = models::k205::Form::additive;
  models::k205::Form global_form = models::k205::Form::multiplicative;
  models::k205::Minima minimum;  ///< least normalized values

  /// Whether any criterion has a best and a worst value.
  [[nodiscard]] bool has_hierarchy() const;
  /// The hierarchy of these values: those without a best value are left out.
  [[nodiscard]] models::k205::Hierarchy hierarchy(const models::k205::Criteria& values) const;
};

}  // namespace verstat::scenarios

template <>
struct verstat::models::StructFields<verstat::scenarios::CriteriaSettings> {
  static std::vector<Field> fields();
};
