#include "scenarios/capacity.h"

#include <algorithm>

#include <fmt/format.h>

#include "scenarios/calendar.h"
#include "scenarios/check.h"
#include "scenarios/route.h"

namespace verstat::scenarios {

std::optional<double> arrival_rate_per_min(const Scenario& scenario, const PartType& part) {
  const auto batch = static_cast<double>(part.batch_size);
  if (const auto* arrivals = std::get_if<Interarrival>(&part.supply)) return batch / mean_min(arrivals->time);
  if (const auto* profile = std::get_if<WeeklyProfile>(&part.supply)) {
    double batches = 0;
    for (const RatePeriod& period : profile->rates) batches += period.per_h * (period.to_h - period.from_h);
    return batch * batches / minutes_per_week;
  }
  if (const auto* list = std::get_if<OrderList>(&part.supply)) {
    double parts = 0;
    for (const Order& order : list->orders)
      if (order.arrives_min <= scenario.simulation.horizon_min) parts += static_cast<double>(order.quantity);
    return parts / scenario.simulation.horizon_min;
  }
  return std::nullopt;
}

std::vector<double> static_utilization(const Scenario& scenario) {
  std::vector<double> asked(scenario.machines.size(), 0.0);
  for (const PartType& part : scenario.parts) {
    const auto rate = arrival_rate_per_min(scenario, part);
    if (!rate) continue;
    const Route route = route_of(scenario, part);
    std::vector<double> lost;
    for (const RouteStep& step : route) {
      const Operation& operation = scenario.operations[step.operation];
      double kept = 1 - plan(scenario, operation).scrap_probability;
      if (operation.quality) kept *= 1 - operation.quality->scrap_probability;
      lost.push_back(1 - kept);
    }
    const std::vector<double> visits = expected_visits(route, lost);
    for (std::size_t k = 0; k < route.size(); ++k) {
      const Operation& operation = scenario.operations[route[k].operation];
      const auto groups = groups_of(scenario, operation);
      for (const std::size_t g : groups) {
        const Machine& machine = scenario.machines[g];
        double time_min = plan(scenario, operation, machine).main_time_min;
        if (machine.loading) time_min += mean_min(*machine.loading);
        if (machine.unloading) time_min += mean_min(*machine.unloading);
        asked[g] += *rate * visits[k] * time_min / static_cast<double>(groups.size());
      }
    }
  }
  for (std::size_t g = 0; g < asked.size(); ++g) {
    const Machine& machine = scenario.machines[g];
    const Calendar* calendar = find_named(scenario.calendars, machine.calendar);
    const double open = calendar == nullptr ? 1.0 : WorkingTime(*calendar).open_share();
    asked[g] /= static_cast<double>(machine.count) * open;
  }
  return asked;
}

void check_capacity(const Scenario& s) {
  if (s.simulation.allow_overload) return;
  const std::vector<double> load = static_utilization(s);
  const auto worst = std::max_element(load.begin(), load.end());
  if (*worst <= 1) return;
  const auto g = static_cast<std::size_t>(worst - load.begin());
  throw InputError(
      fmt::format("/machines/{}/count", g),
      fmt::format(
          "/machines/{}/count = {}, the demand asks for {:.0f} % of the time of \"{}\", the bottleneck, "
          "before any failure or tool change: add machines, cut faster, or let fewer parts arrive "
          "(simulation/allow_overload = true simulates it all the same)",
          g, s.machines[g].count, 100 * *worst, s.machines[g].name));
}

}  // namespace verstat::scenarios
