#pragma once
// Repair service of a machine-building plant (K409): the wage-fund regression of the paper with the tests
// that show why it cannot be used, and the standard models a shop needs instead: repair crews as a finite
// source queue, wages of the crews, preventive replacement by age, overhauls with minimal repair.
//
// Kovalenko, Shashko 2011. Money in any one currency, times in hours. "Never" is 1e9 h.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/catalogue/catalogue.h"

namespace verstat::models::k409 {

inline constexpr double never_h = 1e9;

// ---- A. Regression of the wage fund (k409_regression.cpp) ----

struct OutputAndHeadcount {
  double output = 0;
  double headcount = 0;
};
struct WageFund {
  double wage_fund;
};
/// Regression with the printed coefficients, 949.216 + 0.00325 x1 + 0.0203 x2. K409 eq. (3).
/// An example only: the sums behind it are impossible (see normal_sums_diagnostics).
[[nodiscard]] WageFund wage_fund_regression(const OutputAndHeadcount& in);

struct NormalSums {
  std::int64_t observations = 0;  // n >= 3
  double x1 = 0, x2 = 0, x1x1 = 0, x1x2 = 0, x2x2 = 0, y = 0, x1y = 0, x2y = 0;
};
struct Coefficients {
  double a0, a1, a2;
};
/// Solves the normal equations, also of impossible sums; a singular matrix is an error.
/// K409 eq. (1), third line repaired: it starts with a0 sum x2.
[[nodiscard]] Coefficients regression_from_sums(const NormalSums& in);

struct SumsDiagnostics {
  double mean_x1, mean_x2, mean_y;
  double s11, s22, s12;  // centred sums
  double r12;            // implied correlation; 0 unless s11, s22 > 0, beyond +-1 for impossible sums
  bool feasible;         // s11, s22 > 0 and |r12| <= 1 + 1e-9
};
/// Whether sums can come from data at all, before anything is solved. COMPLETION.
[[nodiscard]] SumsDiagnostics normal_sums_diagnostics(const NormalSums& in);

struct TwoFactorData {
  std::vector<double> x1, x2, y;  // equal length >= 4
};
struct TwoFactorFit {
  double a0, a1, a2;
  double r_squared;
  double vif;  // variance inflation, the same for both factors
  double se_a1, se_a2;
  double elasticity_x1, elasticity_x2;  // at the means, % per %
};
/// Ordinary least squares y = a0 + a1 x1 + a2 x2 from raw data, by QR of the centred columns. COMPLETION.
/// Error when 1, x1, x2 are linearly dependent or y is constant.
[[nodiscard]] TwoFactorFit ols_two_factor(const TwoFactorData& in);

struct SlopeAndMeans {
  double slope = 0;
  double x_mean = 0;
  double y_mean = 0;
};
struct Elasticity {
  double elasticity;
};
/// Elasticity a x_mean / y_mean, % per %. The paper's 1.5 and 1.1 are 100 times too large.
[[nodiscard]] Elasticity elasticity(const SlopeAndMeans& in);

// ---- B. Repair crews (k409_repair_queue.cpp, k409_repair_cost.cpp) ----

struct Machines {
  std::int64_t machines = 1;  // 1..500
  double mtbf_h = 0;          // operating hours of one machine
  double mttr_h = 0;          // repair alone, without the wait
};
struct RepairPool : Machines {
  std::int64_t crews = 1;  // 1..500
};
struct QueueState {
  double availability;
  double mean_down;
  double mean_waiting;
  double failures_per_h;   // of all machines
  double mean_downtime_h;  // wait + repair
  double mean_wait_h;      // over all failures
  double crew_utilization;
  double p_wait;  // a failing machine has to wait
  double p_all_up;
};
/// Stationary state of N machines and c crews with exponential times, M/M/c//N (Palm). COMPLETION:
///   p_{n+1} = p_n (N - n) lambda / (min(n + 1, c) mu).
/// Pessimistic for more regular repair times when crews are scarce, exact for any of them when c >= N.
[[nodiscard]] QueueState machine_repair_queue(const RepairPool& in);

struct CrewCosts : RepairPool {
  double crew_cost_per_h = 0;      // one crew
  double downtime_cost_per_h = 0;  // one machine
  double spares_per_repair = 0;
};
struct CrewCostRate {
  double downtime_cost_per_h_total;
  double crew_cost_per_h_total;
  double spares_cost_per_h;
  double total_cost_per_h;
  double availability;
};
/// Cost per hour of a crew size, K(c) = L c_down + c c_crew + Lambda c_spare. COMPLETION.
[[nodiscard]] CrewCostRate crew_cost_rate(const CrewCosts& in);

struct CrewSizing : Machines {
  double crew_cost_per_h = 0;
  double downtime_cost_per_h = 0;
  double spares_per_repair = 0;
};
struct BestCrew {
  std::int64_t crews;
  double total_cost_per_h;
  double availability;
};
/// Cheapest number of crews in 1..N, the smallest of equal ones. COMPLETION.
[[nodiscard]] BestCrew optimal_crew_size(const CrewSizing& in);

struct AvailabilityTarget : Machines {
  double target = 0;  // 0 < target <= 1
};
struct CrewCount {
  std::int64_t crews;  // 0: no crew reaches the target
};
/// Fewest crews with A >= target - 1e-12. No crew exceeds MTBF/(MTBF + MTTR). COMPLETION.
[[nodiscard]] CrewCount crew_for_availability(const AvailabilityTarget& in);

struct CrewStaffing {
  std::int64_t crews = 1;
  std::int64_t workers_per_crew = 1;
  std::int64_t shifts = 1;
  double attendance = 1;    // 0 < attendance <= 1
  double monthly_wage = 0;  // one worker
  double bonus_fraction = 0;
  double social_fraction = 0;
  double hours_per_month = 0;  // of one shift
};
struct CrewWages {
  std::int64_t headcount;
  double wage_fund_month;
  double employer_cost_month;
  double crew_cost_per_h;  // one crew on shift
};
/// Headcount, wage fund and the hourly cost of a crew that follows from them. COMPLETION.
[[nodiscard]] CrewWages maintenance_wage_fund(const CrewStaffing& in);

struct RepairBonus : RepairPool {
  double mttr_reduction = 0;  // 0 <= reduction < 1
  double downtime_cost_per_h = 0;
  double base_wage_cost_per_h_total = 0;  // of all crews
};
struct BreakEvenBonus {
  double saving_per_h;
  double bonus_fraction_max;
};
/// Largest bonus, as a share of the base wage bill, that a shorter repair pays back. COMPLETION.
[[nodiscard]] BreakEvenBonus break_even_bonus(const RepairBonus& in);

struct ShopCosts : RepairPool {
  double cycle_time_min = 0;
  double yield_fraction = 1;  // 0 < yield <= 1
  double machine_cost_per_h = 0;
  double crew_cost_per_h = 0;
  double spares_per_repair = 0;
  double pm_fraction = 0;    // share of calendar time in planned maintenance
  double material_cost = 0;  // per blank
};
struct ShopPartCost {
  double effective_availability;
  double good_parts_per_h;
  double conversion_cost_per_part;
  double cost_per_part;
  double maintenance_cost_per_part;
};
/// Cost per good part of identical machines in parallel. COMPLETION.
[[nodiscard]] ShopPartCost shop_cost_per_part(const ShopCosts& in);

// ---- C. Preventive against corrective maintenance (k409_preventive.cpp) ----

struct AgeingMachine {
  double shape = 0;   // Weibull b
  double mtbf_h = 0;  // mean life
  double t_pm_h = 0;
  double t_cm_h = 0;
  double cost_pm = 0;
  double cost_cm = 0;
  double downtime_cost_per_h = 0;
};
struct AgePolicy : AgeingMachine {
  double interval_h = never_h;  // operating hours; >= 1e9: never
};
struct AgePolicyResult {
  double availability;
  double cost_per_calendar_h;
  double failure_fraction;  // of the cycles end in failure
  double mean_up_h;
  double pm_time_fraction;  // shares of calendar time
  double cm_time_fraction;
};
/// Age replacement of a Weibull life with durations, renewal-reward. COMPLETION:
///   A(T) = M/(M + R t_p + (1 - R) t_c),  M(T) = MTBF P(1/b, (T/eta)^b).
[[nodiscard]] AgePolicyResult pm_age_policy(const AgePolicy& in);

enum class AgeCriterion { cost, availability };
struct AgeSearch : AgeingMachine {
  AgeCriterion criterion = AgeCriterion::cost;
};
struct OptimalAge {
  double interval_h;  // 1e9: run to failure
  double cost_per_calendar_h;
  double availability;
  double run_to_failure_cost_per_h;
  double run_to_failure_availability;
};
/// Best age of preventive replacement in 0.01..4 MTBF, or never when that is no worse or shape <= 1.
/// COMPLETION.
[[nodiscard]] OptimalAge pm_optimal_age(const AgeSearch& in);

struct OverhauledMachine {
  double shape = 0;  // > 1
  double scale_h = 0;
  double cost_overhaul = 0;
  double cost_minimal_repair = 0;
};
struct OverhaulPlan {
  double interval_h;
  double cost_per_h;
  double repairs_per_cycle;
};
/// Overhaul interval with minimal repair between overhauls, durations neglected. COMPLETION
/// (Barlow-Hunter): T* = eta (c_o/(c_m (b - 1)))^(1/b).
[[nodiscard]] OverhaulPlan overhaul_minimal_repair(const OverhauledMachine& in);

struct RepairCycle {
  double repair_units = 0;  // sum of repair-complexity units
  double inspections = 0, minor_repairs = 0, medium_repairs = 0, overhauls = 0;  // per repair cycle
  double cycle_h = 0;
  double operating_h_per_year = 0;
  double hours_per_worker_year = 0;
  double load_factor = 1;
};
struct RepairLabour {
  double labour_h_per_cycle;
  double labour_h_per_year;
  double workers;  // not rounded
};
/// Labour by planned-preventive-repair norms per complexity unit: inspection 0.85 h, minor repair 6.1,
/// medium repair 23.5, overhaul 35. COMPLETION; replace by plant norms where available.
[[nodiscard]] RepairLabour planned_repair_labour(const RepairCycle& in);

}  // namespace verstat::models::k409

template <>
struct verstat::models::EnumNames<verstat::models::k409::AgeCriterion> {
  static constexpr std::array names{std::pair{k409::AgeCriterion::cost, "cost"},
                                    std::pair{k409::AgeCriterion::availability, "availability"}};
};
