#pragma once
// Which shops the long-run model covers, and what stops their machines in ways that it can count.

#include <optional>
#include <vector>

#include "scenarios/scenario.h"

namespace verstat::optimize {

/// Throws scenarios::InputError that names the first member of the scenario which only a simulation tells.
void check_covered(const scenarios::Scenario& scenario);

}  // namespace verstat::optimize
