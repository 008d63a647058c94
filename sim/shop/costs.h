#pragma once
// Money: every amount is booked once, under one heading, so that the parts add up to the whole.

#include <array>
#include <cstdint>
#include <string_view>

#include "sim/shop/state_clock.h"

namespace verstat::shop {

/// What money is spent on. Machine minutes are booked by the state of the machine: for a heading that is also
/// a state, wages of the crew at work on it are added.
enum class Cost : std::uint8_t {
  machining,         ///< machine minutes in the cut
  other_operations,  ///< machine minutes of operations given as durations
  loading,
  setup,
  planned_change,
  failure_change,
  waiting_crew,
  waiting_tool,
  repair,
  waiting_repair,
  maintenance,
  overload_reset,
  warm_up,
  blocked,
  idle,
  off,
  labour,     ///< crews paid by the shift, and attendance of machines
  transport,  ///< vehicles and their drivers
  inserts,
  regrinding,
  damage,  ///< holders, shims and rework after failures
  spares,
  operations,  ///< per part, besides machine and people: gauges, laboratory
  scrap,
  escapes,  ///< defective parts that left the shop
  tardiness,
  lost_demand,
  energy,
  tool_swap,
  tool_room,  ///< crews at tools off the machines
  elements    ///< guide pads, dressings and other second elements
};
inline constexpr std::size_t cost_headings = 31;
[[nodiscard]] std::string_view name_of(Cost cost);
[[nodiscard]] std::string_view meaning_of(Cost cost);
/// The heading of a machine minute in this state; machine minutes outside the calendar cost nothing.
[[nodiscard]] Cost heading_of(MachineState state);

class Costs {
 public:
  void book(Cost heading, double amount) { amounts_[static_cast<std::size_t>(heading)] += amount; }
  [[nodiscard]] double operator[](Cost heading) const { return amounts_[static_cast<std::size_t>(heading)]; }
  void reset() { amounts_.fill(0); }

 private:
  std::array<double, cost_headings> amounts_{};
};

}  // namespace verstat::shop
