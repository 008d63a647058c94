// K409: what the functions are to a user; the formulas are in the k409_*.cpp files beside.
#include "models/maintenance/k409_repair_service.h"

namespace verstat::models::k409 {
namespace {

Value numbers(std::initializer_list<double> values) {
  Value::List list;
  for (const double v : values) list.emplace_back(v);
  return list;
}

void describe_regression(Source& source) {
  source
      .function<&wage_fund_regression>("wage_fund_regression", "Wage fund by the printed regression.",
                                       "eq. (3)", Provenance::paper)
      .input(&OutputAndHeadcount::output, "x1", "x_1", "1", non_negative(), "monthly output, paper's unit",
             4343.0)
      .input(&OutputAndHeadcount::headcount, "x2", "x_2", "1", non_negative(), "headcount", 450.0)
      .output(&WageFund::wage_fund, "wage_fund", "y", "thousand UAH/month", any(), "wage fund")
      .note("A worked example only: the sums behind the coefficients are impossible. Not for forecasting.");
  const auto sums = [](auto& f) {
    f.input(&NormalSums::observations, "n", "n", "1", at_least(3), "number of observations", 12)
        .input(&NormalSums::x1, "sum_x1", "Sx1", "1", any(), "sum of x1", 52118.0)
        .input(&NormalSums::x2, "sum_x2", "Sx2", "1", any(), "sum of x2", 5399.0)
        .input(&NormalSums::x1x1, "sum_x1x1", "Sx1x1", "1", any(), "sum of x1^2", 228183961.0)
        .input(&NormalSums::x1x2, "sum_x1x2", "Sx1x2", "1", any(), "sum of x1 x2", 11670.0)
        .input(&NormalSums::x2x2, "sum_x2x2", "Sx2x2", "1", any(), "sum of x2^2", 2429101.0)
        .input(&NormalSums::y, "sum_y", "Sy", "1", any(), "sum of y", 11670.0)
        .input(&NormalSums::x1y, "sum_x1y", "Sx1y", "1", any(), "sum of x1 y", 50214155.0)
        .input(&NormalSums::x2y, "sum_x2y", "Sx2y", "1", any(), "sum of x2 y", 5174250.0);
  };
  source
      .function<&regression_from_sums>("regression_from_sums", "Two-factor regression from its sums.",
                                       "eq. (1)", Provenance::repaired)
      .with(sums)
      .output(&Coefficients::a0, "a0", "a_0", "1", any(), "constant")
      .output(&Coefficients::a1, "a1", "a_1", "1", any(), "coefficient of x1")
      .output(&Coefficients::a2, "a2", "a_2", "1", any(), "coefficient of x2")
      .note("Solves impossible sums as well: ask normal_sums_diagnostics first.");
  source
      .function<&normal_sums_diagnostics>("normal_sums_diagnostics",
                                          "Whether the sums of a regression can come from data.",
                                          "completion", Provenance::completion)
      .with(sums)
      .output(&SumsDiagnostics::mean_x1, "mean_x1", "-", "1", any(), "mean of x1")
      .output(&SumsDiagnostics::mean_x2, "mean_x2", "-", "1", any(), "mean of x2")
      .output(&SumsDiagnostics::mean_y, "mean_y", "-", "1", any(), "mean of y")
      .output(&SumsDiagnostics::s11, "S11", "S_11", "1", any(), "centred sum of x1^2")
      .output(&SumsDiagnostics::s22, "S22", "S_22", "1", any(), "centred sum of x2^2")
      .output(&SumsDiagnostics::s12, "S12", "S_12", "1", any(), "centred sum of x1 x2")
      .output(&SumsDiagnostics::r12, "r12", "r_12", "1", any(),
              "implied correlation of x1 and x2; beyond +-1 for impossible sums")
      .output(&SumsDiagnostics::feasible, "feasible", "-", "-", no_range(), "the sums are possible");
  source
      .function<&ols_two_factor>("ols_two_factor", "Two-factor regression from raw data, with diagnostics.",
                                 "completion", Provenance::completion)
      .input(&TwoFactorData::x1, "x1", "x_1", "1", any(), "first factor",
             numbers({3900, 4100, 4250, 4400, 4380, 4500}))
      .length(4, 100'000)
      .input(&TwoFactorData::x2, "x2", "x_2", "1", any(), "second factor",
             numbers({430, 436, 441, 447, 445, 452}))
      .length(4, 100'000)
      .input(&TwoFactorData::y, "y", "y", "1", any(), "explained quantity",
             numbers({890, 915, 930, 955, 948, 980}))
      .length(4, 100'000)
      .output(&TwoFactorFit::a0, "a0", "a_0", "1", any(), "constant")
      .output(&TwoFactorFit::a1, "a1", "a_1", "1", any(), "coefficient of x1")
      .output(&TwoFactorFit::a2, "a2", "a_2", "1", any(), "coefficient of x2")
      .output(&TwoFactorFit::r_squared, "r_squared", "R^2", "1", probability(), "share of variance explained")
      .output(&TwoFactorFit::vif, "vif", "VIF", "1", at_least(1), "variance inflation of both factors")
      .output(&TwoFactorFit::se_a1, "se_a1", "-", "1", non_negative(), "standard error of a1")
      .output(&TwoFactorFit::se_a2, "se_a2", "-", "1", non_negative(), "standard error of a2")
      .output(&TwoFactorFit::elasticity_x1, "elasticity_x1", "e_1", "%/%", any(),
              "elasticity to x1, at the means")
      .output(&TwoFactorFit::elasticity_x2, "elasticity_x2", "e_2", "%/%", any(),
              "elasticity to x2, at the means");
  source
      .function<&elasticity>("elasticity", "Elasticity of a linear regression.", "text after eq. (3)",
                             Provenance::repaired)
      .input(&SlopeAndMeans::slope, "a", "a_j", "1", any(), "coefficient of the factor", 0.00325)
      .input(&SlopeAndMeans::x_mean, "x_mean", "-", "1", any(), "mean of the factor", 4343.17)
      .input(&SlopeAndMeans::y_mean, "y_mean", "-", "1", any(), "mean of the explained quantity, not zero",
             972.5)
      .output(&Elasticity::elasticity, "elasticity", "e_j", "%/%", any(), "percent of y per percent of x");
}

constexpr std::string_view exponential_note =
    "Exponential life and repair: pessimistic for regular repair times when crews are scarce.";

void describe_queue(Source& source) {
  const auto machines = [](auto& f) {
    f.input(&Machines::machines, "n_machines", "N", "1", closed(1, 500), "number of machines", 20);
  };
  const auto crews = [](auto& f) {
    f.input(&RepairPool::crews, "n_crews", "c", "1", closed(1, 500), "number of repair crews", 2);
  };
  const auto times = [](auto& f) {
    f.input(&Machines::mtbf_h, "mtbf_h", "MTBF", "h", positive(),
            "mean operating time between failures of one machine", 80.0)
        .input(&Machines::mttr_h, "mttr_h", "MTTR", "h", positive(), "mean repair time without waiting", 6.0);
  };
  source
      .function<&machine_repair_queue>("machine_repair_queue",
                                       "Availability and waiting of machines that share repair crews.",
                                       "completion (Palm)", Provenance::completion)
      .with(machines)
      .with(crews)
      .with(times)
      .output(&QueueState::availability, "availability", "A", "1", probability(), "share of machines up")
      .output(&QueueState::mean_down, "mean_down", "L", "1", non_negative(), "mean number of machines down")
      .output(&QueueState::mean_waiting, "mean_waiting", "L_q", "1", non_negative(),
              "mean number of machines waiting for a crew")
      .output(&QueueState::failures_per_h, "failures_per_h", "Lambda", "1/h", non_negative(),
              "failures per hour of all machines")
      .output(&QueueState::mean_downtime_h, "mean_downtime_h", "-", "h", positive(),
              "wait and repair per failure")
      .output(&QueueState::mean_wait_h, "mean_wait_h", "W_q", "h", non_negative(),
              "mean wait over all failures")
      .output(&QueueState::crew_utilization, "crew_utilization", "-", "1", probability(),
              "busy share of a crew")
      .output(&QueueState::p_wait, "p_wait", "-", "1", probability(), "a failing machine has to wait")
      .output(&QueueState::p_all_up, "p_all_up", "p_0", "1", probability(), "all machines are up")
      .note(exponential_note);
  source
      .function<&crew_cost_rate>("crew_cost_rate", "Cost per hour of a number of repair crews.", "completion",
                                 Provenance::completion)
      .with(machines)
      .with(crews)
      .with(times)
      .input(&CrewCosts::crew_cost_per_h, "crew_cost_per_h", "c_crew", "money/h", non_negative(),
             "cost of one crew", 40.0)
      .input(&CrewCosts::downtime_cost_per_h, "downtime_cost_per_h", "c_down", "money/h", non_negative(),
             "cost of one machine down", 150.0)
      .input(&CrewCosts::spares_per_repair, "spares_per_repair", "c_spare", "money", non_negative(),
             "spare parts per repair", 200.0)
      .output(&CrewCostRate::downtime_cost_per_h_total, "downtime_cost_per_h_total", "-", "money/h",
              non_negative(), "downtime of all machines")
      .output(&CrewCostRate::crew_cost_per_h_total, "crew_cost_per_h_total", "-", "money/h", non_negative(),
              "all crews")
      .output(&CrewCostRate::spares_cost_per_h, "spares_cost_per_h", "-", "money/h", non_negative(),
              "spare parts")
      .output(&CrewCostRate::total_cost_per_h, "total_cost_per_h", "K", "money/h", non_negative(), "sum")
      .output(&CrewCostRate::availability, "availability", "A", "1", probability(), "share of machines up")
      .note(exponential_note);
  source
      .function<&optimal_crew_size>("optimal_crew_size", "Cheapest number of repair crews.", "completion",
                                    Provenance::completion)
      .with(machines)
      .with(times)
      .input(&CrewSizing::crew_cost_per_h, "crew_cost_per_h", "c_crew", "money/h", non_negative(),
             "cost of one crew", 40.0)
      .input(&CrewSizing::downtime_cost_per_h, "downtime_cost_per_h", "c_down", "money/h", non_negative(),
             "cost of one machine down", 150.0)
      .input(&CrewSizing::spares_per_repair, "spares_per_repair", "c_spare", "money", non_negative(),
             "spare parts per repair", 200.0)
      .output(&BestCrew::crews, "n_crews", "c", "1", at_least(1),
              "number of crews, the smallest of equal ones")
      .output(&BestCrew::total_cost_per_h, "total_cost_per_h", "K", "money/h", non_negative(),
              "cost per hour")
      .output(&BestCrew::availability, "availability", "A", "1", probability(), "share of machines up")
      .note("Keep crew utilization below about 0.85 as a plausibility bound.");
  source
      .function<&crew_for_availability>("crew_for_availability", "Fewest crews that reach an availability.",
                                        "completion", Provenance::completion)
      .with(machines)
      .with(times)
      .input(&AvailabilityTarget::target, "availability_target", "A", "1", open_low(0, 1),
             "availability wanted", 0.9)
      .output(&CrewCount::crews, "n_crews", "c", "1", non_negative(), "number of crews; 0: unreachable")
      .note("No crew reaches more than MTBF/(MTBF + MTTR).");
  source
      .function<&maintenance_wage_fund>("maintenance_wage_fund",
                                        "Headcount, wage fund and hourly cost of repair crews.", "completion",
                                        Provenance::completion)
      .input(&CrewStaffing::crews, "n_crews", "c", "1", at_least(1), "crews per shift", 2)
      .input(&CrewStaffing::workers_per_crew, "workers_per_crew", "w", "1", at_least(1),
             "workers of one crew", 2)
      .input(&CrewStaffing::shifts, "shifts", "s", "1", at_least(1), "shifts", 2)
      .input(&CrewStaffing::attendance, "attendance", "-", "1", open_low(0, 1), "share of days present", 0.9)
      .input(&CrewStaffing::monthly_wage, "monthly_wage", "-", "money", non_negative(), "wage of one worker",
             2161.0)
      .input(&CrewStaffing::bonus_fraction, "bonus_fraction", "-", "1", non_negative(), "bonus over wage",
             0.2)
      .input(&CrewStaffing::social_fraction, "social_fraction", "-", "1", non_negative(),
             "social charges over the wage fund", 0.37)
      .input(&CrewStaffing::hours_per_month, "hours_per_month", "-", "h", positive(), "hours of one shift",
             166.7)
      .output(&CrewWages::headcount, "headcount", "-", "1", at_least(1), "workers on the payroll, rounded up")
      .output(&CrewWages::wage_fund_month, "wage_fund_month", "-", "money/month", non_negative(), "wage fund")
      .output(&CrewWages::employer_cost_month, "employer_cost_month", "-", "money/month", non_negative(),
              "wage fund with social charges")
      .output(&CrewWages::crew_cost_per_h, "crew_cost_per_h", "c_crew", "money/h", non_negative(),
              "cost of one crew on shift");
  source
      .function<&break_even_bonus>("break_even_bonus", "Largest bonus that a shorter repair pays back.",
                                   "completion", Provenance::completion)
      .with(machines)
      .with(crews)
      .with(times)
      .input(&RepairBonus::mttr_reduction, "mttr_reduction", "delta", "1", open_high(0, 1),
             "share by which the repair gets shorter", 0.15)
      .input(&RepairBonus::downtime_cost_per_h, "downtime_cost_per_h", "c_down", "money/h", non_negative(),
             "cost of one machine down", 150.0)
      .input(&RepairBonus::base_wage_cost_per_h_total, "base_wage_cost_per_h_total", "-", "money/h",
             positive(), "base wages of all crews", 80.0)
      .output(&BreakEvenBonus::saving_per_h, "saving_per_h", "-", "money/h", non_negative(), "downtime saved")
      .output(&BreakEvenBonus::bonus_fraction_max, "bonus_fraction_max", "-", "1", non_negative(),
              "bonus over base wages that the saving pays")
      .note("Spare parts are not counted.");
  source
      .function<&shop_cost_per_part>("shop_cost_per_part", "Cost per good part of machines that share crews.",
                                     "completion", Provenance::completion)
      .with(machines)
      .with(crews)
      .with(times)
      .input(&ShopCosts::cycle_time_min, "cycle_time_min", "t_cycle", "min", positive(),
             "time per part on one machine, tool changes included", 12.0)
      .input(&ShopCosts::yield_fraction, "yield_fraction", "-", "1", open_low(0, 1), "good parts of all",
             0.98)
      .input(&ShopCosts::machine_cost_per_h, "machine_cost_per_h", "c_mach", "money/h", non_negative(),
             "cost of one machine", 60.0)
      .input(&ShopCosts::crew_cost_per_h, "crew_cost_per_h", "c_crew", "money/h", non_negative(),
             "cost of one crew", 40.0)
      .input(&ShopCosts::spares_per_repair, "spares_per_repair", "c_spare", "money", non_negative(),
             "spare parts per repair", 200.0)
      .input(&ShopCosts::pm_fraction, "pm_fraction", "pm", "1", open_high(0, 1),
             "share of calendar time in planned maintenance", 0.02)
      .input(&ShopCosts::material_cost, "material_cost", "-", "money", non_negative(),
             "material of one blank", 15.0)
      .output(&ShopPartCost::effective_availability, "effective_availability", "A_eff", "1", probability(),
              "availability less planned maintenance")
      .output(&ShopPartCost::good_parts_per_h, "good_parts_per_h", "-", "1/h", non_negative(),
              "good parts of all machines")
      .output(&ShopPartCost::conversion_cost_per_part, "conversion_cost_per_part", "-", "money",
              non_negative(), "machines and maintenance per good part")
      .output(&ShopPartCost::cost_per_part, "cost_per_part", "-", "money", non_negative(),
              "with material, per good part")
      .output(&ShopPartCost::maintenance_cost_per_part, "maintenance_cost_per_part", "-", "money",
              non_negative(), "crews and spare parts per good part")
      .note(exponential_note);
}

void describe_preventive(Source& source) {
  const auto machine = [](auto& f) {
    f.input(&AgeingMachine::shape, "shape", "b", "1", positive(), "Weibull shape of the life", 2.5)
        .input(&AgeingMachine::mtbf_h, "mtbf_h", "MTBF", "h", positive(), "mean life, operating hours", 400.0)
        .input(&AgeingMachine::t_pm_h, "t_pm_h", "t_p", "h", non_negative(), "duration of preventive work",
               3.0)
        .input(&AgeingMachine::t_cm_h, "t_cm_h", "t_c", "h", non_negative(), "duration of a repair", 16.0)
        .input(&AgeingMachine::cost_pm, "cost_pm", "c_p", "money", non_negative(), "cost of preventive work",
               300.0)
        .input(&AgeingMachine::cost_cm, "cost_cm", "c_c", "money", non_negative(), "cost of a repair", 1500.0)
        .input(&AgeingMachine::downtime_cost_per_h, "downtime_cost_per_h", "c_down", "money/h",
               non_negative(), "cost of downtime", 100.0);
  };
  source
      .function<&pm_age_policy>("pm_age_policy", "Preventive replacement at a fixed age.", "completion",
                                Provenance::completion)
      .input(&AgePolicy::interval_h, "interval_h", "T", "h", positive(),
             "age of preventive replacement, operating hours; 1e9 and more: never", 250.0)
      .with(machine)
      .output(&AgePolicyResult::availability, "availability", "A", "1", probability(), "share of time up")
      .output(&AgePolicyResult::cost_per_calendar_h, "cost_per_calendar_h", "C", "money/h", non_negative(),
              "maintenance and downtime per calendar hour")
      .output(&AgePolicyResult::failure_fraction, "failure_fraction", "1-R", "1", probability(),
              "share of cycles that end in failure")
      .output(&AgePolicyResult::mean_up_h, "mean_up_h", "M", "h", non_negative(), "mean time up per cycle")
      .output(&AgePolicyResult::pm_time_fraction, "pm_time_fraction", "-", "1", probability(),
              "share of calendar time in preventive work")
      .output(&AgePolicyResult::cm_time_fraction, "cm_time_fraction", "-", "1", probability(),
              "share of calendar time in repair");
  source
      .function<&pm_optimal_age>("pm_optimal_age", "Best age of preventive replacement.", "completion",
                                 Provenance::completion)
      .with(machine)
      .optional(&AgeSearch::criterion, "criterion", "-", "-", no_range(), "what is to be best")
      .output(&OptimalAge::interval_h, "interval_h", "T", "h", positive(), "best age; 1e9: run to failure")
      .output(&OptimalAge::cost_per_calendar_h, "cost_per_calendar_h", "C", "money/h", non_negative(),
              "cost at the best age")
      .output(&OptimalAge::availability, "availability", "A", "1", probability(),
              "availability at the best age")
      .output(&OptimalAge::run_to_failure_cost_per_h, "run_to_failure_cost_per_h", "-", "money/h",
              non_negative(), "cost without preventive work")
      .output(&OptimalAge::run_to_failure_availability, "run_to_failure_availability", "-", "1",
              probability(), "availability without preventive work")
      .note("Searched between 0.01 and 4 mean lives; never for shapes up to 1.");
  source
      .function<&overhaul_minimal_repair>("overhaul_minimal_repair",
                                          "Best overhaul interval with minimal repair in between.",
                                          "completion (Barlow-Hunter)", Provenance::completion)
      .input(&OverhauledMachine::shape, "shape", "b", "1", above(1), "exponent of the cumulative failures",
             2.2)
      .input(&OverhauledMachine::scale_h, "scale_h", "eta", "h", positive(),
             "time of the first expected failure", 1000.0)
      .input(&OverhauledMachine::cost_overhaul, "cost_overhaul", "c_o", "money", positive(),
             "cost of an overhaul", 5000.0)
      .input(&OverhauledMachine::cost_minimal_repair, "cost_minimal_repair", "c_m", "money", positive(),
             "cost of a minimal repair", 800.0)
      .output(&OverhaulPlan::interval_h, "interval_h", "T*", "h", positive(), "overhaul interval")
      .output(&OverhaulPlan::cost_per_h, "cost_per_h", "C", "money/h", positive(), "cost per operating hour")
      .output(&OverhaulPlan::repairs_per_cycle, "repairs_per_cycle", "-", "1", positive(),
              "minimal repairs between overhauls")
      .note("Durations are neglected.");
  source
      .function<&planned_repair_labour>("planned_repair_labour", "Labour by planned-preventive-repair norms.",
                                        "completion", Provenance::completion)
      .input(&RepairCycle::repair_units, "repair_units", "R", "1", non_negative(),
             "sum of repair-complexity units", 10.0)
      .input(&RepairCycle::inspections, "n_inspection", "n_i", "1", non_negative(), "inspections per cycle",
             9.0)
      .input(&RepairCycle::minor_repairs, "n_minor", "n_m", "1", non_negative(), "minor repairs per cycle",
             6.0)
      .input(&RepairCycle::medium_repairs, "n_medium", "n_M", "1", non_negative(), "medium repairs per cycle",
             2.0)
      .input(&RepairCycle::overhauls, "n_overhaul", "n_o", "1", non_negative(), "overhauls per cycle", 1.0)
      .input(&RepairCycle::cycle_h, "cycle_h", "-", "h", positive(), "length of the repair cycle", 24000.0)
      .input(&RepairCycle::operating_h_per_year, "operating_h_per_year", "-", "h", positive(),
             "operating hours per year", 4000.0)
      .input(&RepairCycle::hours_per_worker_year, "hours_per_worker_year", "-", "h", positive(),
             "working hours of one worker per year", 1840.0)
      .optional(&RepairCycle::load_factor, "load_factor", "-", "1", positive(), "performance of norms")
      .output(&RepairLabour::labour_h_per_cycle, "labour_h_per_cycle", "-", "h", non_negative(),
              "labour per cycle")
      .output(&RepairLabour::labour_h_per_year, "labour_h_per_year", "-", "h", non_negative(),
              "labour per year")
      .output(&RepairLabour::workers, "workers", "-", "1", non_negative(), "workers, not rounded")
      .note("Norms of the unified system of planned preventive repair; replace by plant norms.");
}

}  // namespace

void describe(Catalogue& catalogue) {
  Source& source = catalogue.source(
      {.id = "K409",
       .title = "Opportunities for improving the management of the repair service of machine-building "
                "enterprises in current economic conditions",
       .authors = "Kovalenko G. A., Shashko V. A.",
       .published = "Tool reliability and optimization of technological systems, issue 28, Kramatorsk, 2011",
       .models =
           "How a plant's repair service is run: a two-factor regression of the wage fund on output and "
           "headcount (printed with impossible sums), completed by the models a shop needs for the purpose: "
           "repair crews as a finite-source queue, crew cost and size, wages, and preventive against "
           "corrective maintenance.",
       .role = "maintenance",
       .errata = {
           "The third normal equation of (1) starts with a0 sum x1; it must be a0 sum x2.",
           "System (2) repeats sum y = 11670 as sum x1 x2, which should be about 2.345e7: the implied "
           "correlation of the factors is -18111. Its sum x2 y is impossible too, and the headcount did not "
           "vary, so the coefficient of headcount cannot be estimated.",
           "The printed elasticities 1.5 and 1.1 % per 1 % are 100 times too large for the printed "
           "coefficients, which give 0.0145 and 0.0094."}});
  describe_regression(source);
  describe_queue(source);
  describe_preventive(source);
}

}  // namespace verstat::models::k409
