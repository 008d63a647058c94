#pragma once
// Replacement strategies: small policies that answer one question each, above all when to change an edge that
// still cuts.

#include <limits>
#include <memory>

#include "models/math/life_law.h"
#include "scenarios/scenario.h"
#include "sim/kernel/pooled.h"

namespace verstat::shop {

/// What a strategy may look at. Wear is counted in mean lives, so that it adds up over regimes (linear
/// damage).
struct ToolView {
  double edge_wear = 0;        ///< cutting since all edges of the tool were changed, in mean lives
  double wear_since_plan = 0;  ///< cutting of the tool since its last planned change, in mean lives
  double mean_life_min = 0;    ///< of an edge at the present regime
  double main_time_min = 0;    ///< of one part in the present operation
  double cut_since_inspection_min = 0;
};

class Strategy : public sim::Pooled {
 public:
  Strategy() = default;
  Strategy(const Strategy&) = delete;
  Strategy& operator=(const Strategy&) = delete;
  virtual ~Strategy() = default;
  /// Cutting minutes until the planned change; infinity when none is planned, zero or less when it is due.
  [[nodiscard]] virtual double cutting_to_change_min(const ToolView& tool) const = 0;
  /// Cutting minutes until the next inspection.
  [[nodiscard]] virtual double cutting_to_inspection_min(const ToolView&) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Whether the edges are changed when the machine stops for something else.
  [[nodiscard]] virtual bool joins_stop(const ToolView&) const { return false; }
};

/// The strategy of a scenario for edges whose life follows `unit_life`, a law with mean 1.
[[nodiscard]] std::unique_ptr<Strategy> make_strategy(const scenarios::Strategy& spec,
                                                      const models::LifeLaw& unit_life);

/// Share of its own life from which a worn edge shows the sign: for the growth of the radial force, which is
/// linear in the flank wear (K106 C1), the wear that gives the factor over the wear limit; above 1 when the
/// force never grows that much.
[[nodiscard]] double share_of_life_shown(const scenarios::WearSign& sign);

}  // namespace verstat::shop
