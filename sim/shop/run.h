#pragma once
// A scenario run in replications, and two runs compared pair by pair.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"
#include "sim/shop/kpis.h"

namespace verstat::shop {

/// Mean over replications with the half-width of its confidence interval.
struct Estimate {
  std::optional<double> mean;        ///< none when no replication has a value
  std::optional<double> half_width;  ///< none with fewer than two values
  std::int64_t samples = 0;
};
/// Student interval of the values that exist. `confidence` in (0, 1).
[[nodiscard]] Estimate estimate(const std::vector<std::optional<double>>& values, double confidence = 0.95);

struct RunResult {
  std::vector<KpiInfo> kpis;
  /// values[r][k]: KPI k in replication r.
  std::vector<std::vector<std::optional<double>>> values;
  std::vector<Estimate> estimates;  ///< one per KPI, 95 %
  std::uint64_t events = 0;
  /// Per replication: a hash of the times of all its events in their order. Empty in a result that was read.
  std::vector<std::uint64_t> courses = {};
  /// With Checks::on: which process went on when, over all replications in their order.
  std::optional<std::uint64_t> event_order = {};
  /// With Checks::on: laws of conservation that do not hold, in words. Empty when all is well.
  std::vector<std::string> broken_laws = {};
  /// Machines that blocked each other for good: replication, time and who waits for whom.
  std::vector<std::string> standstills = {};

  /// Index of the KPI with this name; none when there is none.
  [[nodiscard]] std::optional<std::size_t> index_of(const std::string& kpi) const;
};

/// Fingerprint of a run, 16 hexadecimal digits: every bit of every KPI of every replication under its name,
/// the number of events, and when each of them happened, in their order. Empty when the result was read and
/// not computed. The same for any number of threads or ranks; bits are promised per version and platform.
[[nodiscard]] std::string fingerprint_of(const RunResult& result);

/// Called after every finished replication, from any thread but never twice at once.
using Progress = std::function<void(std::int64_t done, std::int64_t of)>;

/// Whether the laws of conservation (parts, stores, spares, edges, machine time, crews) are checked from the
/// state of the shop after every replication, and the order of events is recorded.
enum class Checks { off, on };

/// Values that one answer may hold: KPIs times replications, 16 bytes each.
inline constexpr std::size_t most_values = 100'000'000;

/// Runs all replications of the scenario on `threads` >= 1 threads. The result does not depend on `threads`.
/// Throws sim::BudgetError when the scenario asks for more events or memory than it may.
[[nodiscard]] RunResult run_scenario(const scenarios::Scenario& scenario, int threads,
                                     const Progress& progress = {}, Checks checks = Checks::off);

/// The replications `first` to `first` + `count` - 1 alone, count >= 1, whatever the scenario says: what
/// run_scenario gives for them, for studies that add replications as they need them.
[[nodiscard]] RunResult run_replications(const scenarios::Scenario& scenario, std::uint64_t first,
                                         std::int64_t count, int threads, const Progress& progress = {},
                                         Checks checks = Checks::off);

/// KPI of b minus KPI of a, replication by replication (common random numbers).
/// Both runs must have the same number of replications and the KPI. Throws std::invalid_argument.
[[nodiscard]] Estimate paired_difference(const RunResult& a, const RunResult& b, const std::string& kpi,
                                         double confidence = 0.95);

}  // namespace verstat::shop
