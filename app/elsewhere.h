#pragma once
// Where replications are simulated: on threads of this process, or on other machines. `verstat` has the
// threads alone; `verstat-mpi` puts its ranks here before the program starts.

#include <functional>

#include "sim/shop/run.h"

namespace verstat::app {

/// Runs the replications `first` ... of a scenario; `check` is called now and then and throws when the study
/// must end. Results do not depend on where they are computed.
using Elsewhere = std::function<shop::RunResult(const scenarios::Scenario& scenario, std::uint64_t first,
                                                std::int64_t count, const shop::Progress& check)>;

/// Empty: nowhere else. Set once, before any thread starts.
[[nodiscard]] Elsewhere& elsewhere();

/// On the other machines when there are any, else on `threads` threads.
[[nodiscard]] shop::RunResult simulate_anywhere(const scenarios::Scenario& scenario, std::uint64_t first,
                                                std::int64_t count, int threads, const shop::Progress& check);

}  // namespace verstat::app
