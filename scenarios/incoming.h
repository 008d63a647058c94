#pragma once
// The state in which a part goes from one operation to the next: what the operation before leaves becomes an
// input of the process after it, and the drawing's requirements are held against what is left last.

#include <map>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::scenarios {

/// The process of the operation with the members that `incoming` names taken from the plans of the operations
/// before it. Throws models::ModelError or models::DomainError when one of those cannot be planned, or when a
/// member would leave its range.
[[nodiscard]] operations::Process received(const Scenario& scenario, const Operation& operation);

/// Plans of operations that hand something on, by name: each is made once, however many ways lead to it.
using PlansBefore = std::map<std::string, operations::CutPlan>;
/// The same for who plans several operations of an unchanged scenario.
[[nodiscard]] operations::Process received(const Scenario& scenario, const Operation& operation,
                                           PlansBefore& before);
/// The plan of an operation on a machine, from what is planned before it (scenario.h has it without).
[[nodiscard]] operations::CutPlan plan(const Scenario& scenario, const Operation& operation,
                                       const Machine& machine, PlansBefore& before);

/// Steps of the part's route after which the quantity is not left again, ascending: there it is decided
/// whether a part meets a requirement on it. The part must be one of a checked scenario.
[[nodiscard]] std::vector<std::size_t> last_steps_that_leave(const Scenario& scenario, std::size_t part,
                                                             const std::string& quantity);

/// Probability that a part which leaves the operation falls short of the requirement: its quantity is normal
/// with the plan's scatter and that of the requirement; without any scatter it is 0 or 1.
[[nodiscard]] double share_that_fails(const Requirement& requirement, const operations::CutPlan& plan);

}  // namespace verstat::scenarios
