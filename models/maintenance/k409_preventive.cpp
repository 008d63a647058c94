// K409, section C: preventive replacement by age, overhauls, planned-repair labour.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <boost/math/special_functions/gamma.hpp>

#include "models/maintenance/k409_repair_service.h"
#include "models/math/policy.h"
#include "models/math/solve.h"

namespace verstat::models::k409 {
namespace {

// One machine; what does not depend on the interval is computed once.
class Ageing {
 public:
  explicit Ageing(const AgeingMachine& machine)
      : m_(machine),
        log_scale_(std::log(machine.mtbf_h) - boost::math::lgamma(1 + 1 / machine.shape, MathPolicy())) {}

  [[nodiscard]] AgePolicyResult at(double interval_h) const {
    double survived = 0;
    double failed = 1;
    double up_h = m_.mtbf_h;
    if (interval_h < never_h) {
      // Through the logarithm: the scale itself underflows for very small shapes.
      const double hazard = std::exp(m_.shape * (std::log(interval_h) - log_scale_));
      survived = std::exp(-hazard);
      failed = -std::expm1(-hazard);
      up_h = mean_up_h(interval_h, hazard);
    }
    const double pm_h = survived * m_.t_pm_h;
    const double cm_h = failed * m_.t_cm_h;
    const double cycle_h = up_h + pm_h + cm_h;
    const double cost = survived * m_.cost_pm + failed * m_.cost_cm + m_.downtime_cost_per_h * (pm_h + cm_h);
    return {up_h / cycle_h, cost / cycle_h, failed, up_h, pm_h / cycle_h, cm_h / cycle_h};
  }

 private:
  // Integral of the survival over 0..interval, `hazard` = (interval/scale)^shape.
  [[nodiscard]] double mean_up_h(double interval_h, double hazard) const {
    if (hazard < 1e-17) return interval_h;  // survival is 1 to rounding
    if (std::isinf(hazard)) return m_.mtbf_h;
    return std::min(interval_h, m_.mtbf_h * boost::math::gamma_p(1 / m_.shape, hazard, MathPolicy()));
  }

  AgeingMachine m_;
  double log_scale_;
};

constexpr int grid_cells = 400;
constexpr double grid_low = 0.01;  // of the mean life
constexpr double grid_high = 4;

struct Candidate {
  double interval_h;
  AgePolicyResult result;
};

// Best interval of the grid, refined between its neighbours unless it is an end.
template <class Objective>
Candidate best_age(const Ageing& ageing, double mtbf_h, Objective&& objective) {
  const auto node_h = [mtbf_h](int k) {
    return mtbf_h * grid_low * std::pow(grid_high / grid_low, static_cast<double>(k) / grid_cells);
  };
  const auto value = [&](double interval_h) { return objective(ageing.at(interval_h)); };
  int best = 0;
  double least = value(node_h(0));
  for (int k = 1; k <= grid_cells; ++k)
    if (const double here = value(node_h(k)); here < least) {
      least = here;
      best = k;
    }
  double interval_h = node_h(best);
  if (best > 0 && best < grid_cells) {
    const Minimum inner = minimize_unimodal(value, node_h(best - 1), node_h(best + 1));
    if (inner.value <= least) interval_h = inner.x;
  }
  return {interval_h, ageing.at(interval_h)};
}

}  // namespace

AgePolicyResult pm_age_policy(const AgePolicy& in) {
  return guarded<&pm_age_policy>(in, [&] { return Ageing(in).at(in.interval_h); });
}

OptimalAge pm_optimal_age(const AgeSearch& in) {
  return guarded<&pm_optimal_age>(in, [&] {
    const Ageing ageing(in);
    const AgePolicyResult run = ageing.at(never_h);
    const auto chosen = [&run](double interval_h, const AgePolicyResult& result) {
      return OptimalAge{interval_h, result.cost_per_calendar_h, result.availability, run.cost_per_calendar_h,
                        run.availability};
    };
    // A life that does not age gains nothing from replacement. A search would be misled where downtime for
    // maintenance is cheaper per hour than running: it would count endless maintenance as cheap.
    if (in.shape <= 1) return chosen(never_h, run);
    if (in.criterion == AgeCriterion::cost) {
      const Candidate best =
          best_age(ageing, in.mtbf_h, [](const AgePolicyResult& r) { return r.cost_per_calendar_h; });
      if (run.cost_per_calendar_h <= best.result.cost_per_calendar_h * (1 + 1e-9))
        return chosen(never_h, run);
      return chosen(best.interval_h, best.result);
    }
    // The time lost is minimised rather than the availability maximised: it keeps more digits.
    const Candidate best = best_age(
        ageing, in.mtbf_h, [](const AgePolicyResult& r) { return r.pm_time_fraction + r.cm_time_fraction; });
    if (run.availability >= best.result.availability * (1 - 1e-9)) return chosen(never_h, run);
    return chosen(best.interval_h, best.result);
  });
}

OverhaulPlan overhaul_minimal_repair(const OverhauledMachine& in) {
  return guarded<&overhaul_minimal_repair>(in, [&] {
    const double repairs = in.cost_overhaul / (in.cost_minimal_repair * (in.shape - 1));
    const double interval_h = in.scale_h * std::pow(repairs, 1 / in.shape);
    return OverhaulPlan{interval_h, (in.cost_overhaul + in.cost_minimal_repair * repairs) / interval_h,
                        repairs};
  });
}

RepairLabour planned_repair_labour(const RepairCycle& in) {
  return guarded<&planned_repair_labour>(in, [&] {
    // Hours per repair-complexity unit, unified system of planned preventive repair.
    const double cycle_labour_h = in.repair_units * (0.85 * in.inspections + 6.1 * in.minor_repairs +
                                                     23.5 * in.medium_repairs + 35.0 * in.overhauls);
    const double year_labour_h = cycle_labour_h * in.operating_h_per_year / in.cycle_h;
    return RepairLabour{cycle_labour_h, year_labour_h,
                        year_labour_h / (in.hours_per_worker_year * in.load_factor)};
  });
}

}  // namespace verstat::models::k409
