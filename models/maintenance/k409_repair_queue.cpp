// K409, section B: repair crews as a finite-source queue, and what they cost.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "models/maintenance/k409_repair_service.h"

namespace verstat::models::k409 {
namespace {

// Stationary probabilities of n = 0..N machines down. The plain products overflow within the allowed range,
// so logarithms are summed and the largest subtracted.
std::vector<double> down_probabilities(std::int64_t machines, std::int64_t crews, double mtbf_h,
                                       double mttr_h) {
  std::vector<double> p(static_cast<std::size_t>(machines) + 1);
  const double log_ratio = std::log(mttr_h) - std::log(mtbf_h);
  double log_p = 0;
  double largest = 0;
  p[0] = 0;
  for (std::int64_t n = 0; n < machines; ++n) {
    log_p +=
        std::log(static_cast<double>(machines - n) / static_cast<double>(std::min(n + 1, crews))) + log_ratio;
    p[static_cast<std::size_t>(n) + 1] = log_p;
    largest = std::max(largest, log_p);
  }
  double sum = 0;
  for (double& x : p) {
    x = std::exp(x - largest);
    sum += x;
  }
  for (double& x : p) x /= sum;
  return p;
}

struct Balance {
  double availability;
  double down;
  double waiting;
  double in_repair;
  double failures_per_h;
  double all_up;
};

Balance balance(const Machines& in, std::int64_t crews) {
  const std::vector<double> p = down_probabilities(in.machines, crews, in.mtbf_h, in.mttr_h);
  Balance out{};
  double up = 0;  // summed itself: N - L would cancel when nearly all machines are down
  for (std::int64_t n = 0; n <= in.machines; ++n) {
    const double probability = p[static_cast<std::size_t>(n)];
    const auto repaired = static_cast<double>(std::min(n, crews));
    up += static_cast<double>(in.machines - n) * probability;
    out.down += static_cast<double>(n) * probability;
    out.in_repair += repaired * probability;
    if (n > crews) out.waiting += static_cast<double>(n - crews) * probability;
  }
  out.availability = up / static_cast<double>(in.machines);
  out.failures_per_h = up / in.mtbf_h;
  out.all_up = p[0];
  return out;
}

// Arrival theorem: a failing machine sees the stationary state of the other N - 1.
double waiting_probability(const RepairPool& in) {
  if (in.machines <= in.crews) return 0;
  const std::vector<double> p = down_probabilities(in.machines - 1, in.crews, in.mtbf_h, in.mttr_h);
  double sum = 0;
  for (auto n = static_cast<std::size_t>(in.crews); n < p.size(); ++n) sum += p[n];
  return std::min(sum, 1.0);
}

struct Prices {
  double crew_per_h;
  double downtime_per_h;
  double spares_per_repair;
};

CrewCostRate cost_rate(const Balance& state, std::int64_t crews, const Prices& prices) {
  const double downtime = state.down * prices.downtime_per_h;
  const double crew = static_cast<double>(crews) * prices.crew_per_h;
  const double spares = state.failures_per_h * prices.spares_per_repair;
  return {downtime, crew, spares, downtime + crew + spares, state.availability};
}

}  // namespace

QueueState machine_repair_queue(const RepairPool& in) {
  return guarded<&machine_repair_queue>(in, [&] {
    const Balance state = balance(in, in.crews);
    const double wait_h = state.waiting > 0 ? state.waiting / state.failures_per_h : 0.0;
    return QueueState{.availability = state.availability,
                      .mean_down = state.down,
                      .mean_waiting = state.waiting,
                      .failures_per_h = state.failures_per_h,
                      .mean_downtime_h = wait_h + in.mttr_h,
                      .mean_wait_h = wait_h,
                      .crew_utilization = state.in_repair / static_cast<double>(in.crews),
                      .p_wait = waiting_probability(in),
                      .p_all_up = state.all_up};
  });
}

CrewCostRate crew_cost_rate(const CrewCosts& in) {
  return guarded<&crew_cost_rate>(in, [&] {
    return cost_rate(balance(in, in.crews), in.crews,
                     {in.crew_cost_per_h, in.downtime_cost_per_h, in.spares_per_repair});
  });
}

BestCrew optimal_crew_size(const CrewSizing& in) {
  return guarded<&optimal_crew_size>(in, [&] {
    const Prices prices{in.crew_cost_per_h, in.downtime_cost_per_h, in.spares_per_repair};
    BestCrew best{};
    for (std::int64_t crews = 1; crews <= in.machines; ++crews) {
      const CrewCostRate rate = cost_rate(balance(in, crews), crews, prices);
      // Costs that differ only by rounding are ties: the smaller crew stays.
      if (best.crews == 0 || rate.total_cost_per_h < best.total_cost_per_h * (1 - 1e-12))
        best = {crews, rate.total_cost_per_h, rate.availability};
    }
    return best;
  });
}

CrewCount crew_for_availability(const AvailabilityTarget& in) {
  return guarded<&crew_for_availability>(in, [&] {
    const auto reaches = [&](std::int64_t crews) {
      return balance(in, crews).availability >= in.target - 1e-12;
    };
    if (!reaches(in.machines)) return CrewCount{0};
    // Availability rises with the number of crews: bisection for the first that is enough.
    std::int64_t too_few = 0;
    std::int64_t enough = in.machines;
    while (enough - too_few > 1) {
      const std::int64_t middle = too_few + (enough - too_few) / 2;
      (reaches(middle) ? enough : too_few) = middle;
    }
    return CrewCount{enough};
  });
}

CrewWages maintenance_wage_fund(const CrewStaffing& in) {
  return guarded<&maintenance_wage_fund>(in, [&] {
    const double on_shift = static_cast<double>(in.crews) * static_cast<double>(in.workers_per_crew) *
                            static_cast<double>(in.shifts);
    // 1e-9 keeps a headcount that is whole from being rounded up.
    const double headcount = std::ceil(on_shift / in.attendance - 1e-9);
    require(headcount < 1e15, "n_crews", in.crews, "asks for more than 1e15 workers");
    const double fund = headcount * in.monthly_wage * (1 + in.bonus_fraction);
    const double cost = fund * (1 + in.social_fraction);
    return CrewWages{
        static_cast<std::int64_t>(headcount), fund, cost,
        cost / (static_cast<double>(in.crews) * static_cast<double>(in.shifts) * in.hours_per_month)};
  });
}

BreakEvenBonus break_even_bonus(const RepairBonus& in) {
  return guarded<&break_even_bonus>(in, [&] {
    Machines faster = in;
    faster.mttr_h = (1 - in.mttr_reduction) * in.mttr_h;
    const double saved_machines = balance(in, in.crews).down - balance(faster, in.crews).down;
    const double saving = saved_machines * in.downtime_cost_per_h;
    return BreakEvenBonus{saving, saving / in.base_wage_cost_per_h_total};
  });
}

ShopPartCost shop_cost_per_part(const ShopCosts& in) {
  return guarded<&shop_cost_per_part>(in, [&] {
    const Balance state = balance(in, in.crews);
    const double working = 1 - in.pm_fraction;
    const auto machines = static_cast<double>(in.machines);
    const double effective = state.availability * working;
    const double good_per_h = machines * effective * 60 / in.cycle_time_min * in.yield_fraction;
    const double maintenance = (static_cast<double>(in.crews) * in.crew_cost_per_h +
                                state.failures_per_h * working * in.spares_per_repair) /
                               good_per_h;
    const double conversion = machines * in.machine_cost_per_h / good_per_h + maintenance;
    return ShopPartCost{.effective_availability = effective,
                        .good_parts_per_h = good_per_h,
                        .conversion_cost_per_part = conversion,
                        .cost_per_part = conversion + in.material_cost / in.yield_fraction,
                        .maintenance_cost_per_part = maintenance};
  });
}

}  // namespace verstat::models::k409
