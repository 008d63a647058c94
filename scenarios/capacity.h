#pragma once
// Static workload: what the demand asks of every machine group, without waiting, failures or tool changes.

#include <vector>

#include "scenarios/scenario.h"

namespace verstat::scenarios {

/// Long-run arrivals of a part type, parts per minute; none when blanks are always available or the release
/// is capped: then the shop takes what it can.
[[nodiscard]] std::optional<double> arrival_rate_per_min(const Scenario& scenario, const PartType& part);

/// Machine minutes asked for / machine minutes there are, one per machine group: main, loading and unloading
/// times inside the machine's calendar. An operation that several groups can do is shared evenly. A lower
/// bound of what is needed.
[[nodiscard]] std::vector<double> static_utilization(const Scenario& scenario);

}  // namespace verstat::scenarios
