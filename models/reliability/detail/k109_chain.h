#pragma once
// The failure chain of K109 (C3): teeth fail one after the other, each stage exponential in the cumulative
// hazard L of a tooth at nominal load.

#include <cstdint>
#include <vector>

namespace verstat::models::k109::detail {

/// phi_j = (z/(z-j))^alpha, the load factor of each survivor with j failed teeth.
[[nodiscard]] double load_factor(std::int64_t teeth, std::int64_t failed, double alpha);

/// Rates a_j = (z-j) phi_j of the stages j = first..last.
[[nodiscard]] std::vector<double> stage_rates(std::int64_t teeth, std::int64_t first, std::int64_t last,
                                              double alpha);

/// Where the chain stands after exposure L when it starts in the first stage.
struct Occupancy {
  std::vector<double> stage;  ///< probability of each stage
  double absorbed;            ///< probability of having left the last one
  [[nodiscard]] double alive() const;
};
/// Pure-birth chain with the given rates (> 0) after exposure L >= 0 (infinity allowed), by uniformization;
/// stiff cases by squaring the transition matrix of a short step.
[[nodiscard]] Occupancy run_chain(const std::vector<double>& rates, double exposure);

}  // namespace verstat::models::k109::detail
