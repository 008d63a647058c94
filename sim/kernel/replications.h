#pragma once
// Independent replications on several threads.

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace verstat::sim {

namespace detail {
/// Calls `job(i)` for every i < n, on `threads` threads (0: as many as the machine has). When jobs throw, the
/// exception of the lowest i is rethrown; jobs below it have all run.
void run_jobs(std::size_t n, unsigned threads, const std::function<void(std::size_t)>& job);
}  // namespace detail

/// Runs `replication(i)` for i = 0 ... n - 1 on a pool of `threads` threads (0: one per processor) and
/// returns the results by index. Which thread ran what, and when, does not show in the result as long as a
/// replication depends on nothing but its index. If replications throw, the exception of the lowest index
/// comes out.
template <class Replication>
auto run_replications(std::size_t n, unsigned threads, Replication replication)
    -> std::vector<std::invoke_result_t<Replication&, std::size_t>> {
  using Result = std::invoke_result_t<Replication&, std::size_t>;
  std::vector<std::optional<Result>> slots(n);
  detail::run_jobs(n, threads, [&](std::size_t i) { slots[i].emplace(replication(i)); });
  std::vector<Result> results;
  results.reserve(n);
  for (std::optional<Result>& slot : slots) results.push_back(std::move(*slot));
  return results;
}

}  // namespace verstat::sim
