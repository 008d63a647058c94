#pragma once
// Operation kind "inspection": parts with several types of defect pass a set of checks, each of which finds
// some of them (K205). The set is given, or the one of the least cost per part that does not escape with a
// defect.

#include <cstdint>
#include <string>

#include "operations/kind.h"

namespace verstat::operations {

struct DefectType {
  std::string name;
  double share = 0;  ///< of all defects
};
struct CheckOperation {
  std::string name;
  double time_min = 0;
  double cost = 0;
  double false_alarm = 0;         ///< probability of rejecting a good part
  std::vector<double> detection;  ///< per type of defect
};

struct Inspection {
  static constexpr const char* kind = "inspection";
  double defective_share = 0;
  double part_cost = 0;  ///< of a part before the inspection
  std::vector<DefectType> defects;
  std::vector<CheckOperation> checks;
  std::optional<std::vector<std::string>> chosen;  ///< names of checks; not given: the cheapest set
  std::optional<double> escape_probability_max;
};

/// Throws models::ModelError for values outside the models' ranges, models::DomainError for lists that do not
/// fit together.
[[nodiscard]] CutPlan plan(const Inspection& spec, const PlanContext& context);

}  // namespace verstat::operations
