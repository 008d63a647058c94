// The checks of card K409; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <cmath>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/maintenance/k409_repair_service.h"
#include "tests/property.h"

using namespace verstat::models;
using namespace verstat::models::k409;
using verstat::test::property;

namespace {

const NormalSums printed{.observations = 12,
                         .x1 = 52118,
                         .x2 = 5399,
                         .x1x1 = 228183961,
                         .x1x2 = 11670,
                         .x2x2 = 2429101,
                         .y = 11670,
                         .x1y = 50214155,
                         .x2y = 5174250};

RepairPool pool(std::int64_t machines, std::int64_t crews, double mtbf_h, double mttr_h) {
  return {{machines, mtbf_h, mttr_h}, crews};
}

NormalSums sums_of(const TwoFactorData& data) {
  NormalSums s;
  s.observations = static_cast<std::int64_t>(data.y.size());
  for (std::size_t k = 0; k < data.y.size(); ++k) {
    const double a = data.x1[k], b = data.x2[k], y = data.y[k];
    s.x1 += a;
    s.x2 += b;
    s.x1x1 += a * a;
    s.x1x2 += a * b;
    s.x2x2 += b * b;
    s.y += y;
    s.x1y += a * y;
    s.x2y += b * y;
  }
  return s;
}

TwoFactorData random_observations() {
  TwoFactorData data;
  const auto n = static_cast<std::size_t>(*rc::gen::inRange(5, 30));
  for (std::size_t k = 0; k < n; ++k) {
    data.x1.push_back(*rc::gen::inRange(-1000, 1000));
    data.x2.push_back(*rc::gen::inRange(-1000, 1000));
    data.y.push_back(3000 + *rc::gen::inRange(-1000, 1000));
  }
  return data;
}

const AgeingMachine ageing{.shape = 2.5,
                           .mtbf_h = 400,
                           .t_pm_h = 3,
                           .t_cm_h = 16,
                           .cost_pm = 300,
                           .cost_cm = 1500,
                           .downtime_cost_per_h = 100};

}  // namespace

TEST_CASE("K409: the printed sums are consistent arithmetic on impossible input", "[K409]") {
  const SumsDiagnostics d = normal_sums_diagnostics(printed);
  CHECK_FALSE(d.feasible);
  CHECK(d.r12 == Approx(-18111).margin(1));
  CHECK(wage_fund_regression({d.mean_x1, d.mean_x2}).wage_fund == Approx(972.46).margin(0.005));
  const Coefficients a = regression_from_sums(printed);
  CHECK(a.a0 == Approx(949.2167).margin(5e-5));
  CHECK(elasticity({a.a1, d.mean_x1, d.mean_y}).elasticity == Approx(0.0145).margin(5e-5));
  CHECK(elasticity({a.a2, d.mean_x2, d.mean_y}).elasticity == Approx(0.0094).margin(5e-5));
}

TEST_CASE("K409: raw data and their sums give the same regression, and residuals are orthogonal", "[K409]") {
  property([] {
    const TwoFactorData data = random_observations();
    const NormalSums sums = sums_of(data);
    const SumsDiagnostics d = normal_sums_diagnostics(sums);
    RC_PRE(d.s11 > 1 && d.s22 > 1 && std::abs(d.r12) < 0.99);
    RC_ASSERT(d.feasible);
    const TwoFactorFit fit = ols_two_factor(data);
    const Coefficients a = regression_from_sums(sums);
    RC_ASSERT(std::abs(fit.a0 - a.a0) < 1e-8 * (1 + std::abs(a.a0)));
    RC_ASSERT(std::abs(fit.a1 - a.a1) < 1e-8 * (1 + std::abs(a.a1)));
    RC_ASSERT(std::abs(fit.a2 - a.a2) < 1e-8 * (1 + std::abs(a.a2)));
    RC_ASSERT(std::abs(fit.vif - 1 / (1 - d.r12 * d.r12)) < 1e-8 * fit.vif);
    double along_one = 0, along_x1 = 0, along_x2 = 0;
    for (std::size_t k = 0; k < data.y.size(); ++k) {
      const double residual = data.y[k] - fit.a0 - fit.a1 * data.x1[k] - fit.a2 * data.x2[k];
      along_one += residual;
      along_x1 += residual * data.x1[k];
      along_x2 += residual * data.x2[k];
    }
    RC_ASSERT(std::abs(along_one) < 1e-6);
    RC_ASSERT(std::abs(along_x1) < 1e-3);
    RC_ASSERT(std::abs(along_x2) < 1e-3);
  });
}

TEST_CASE("K409: dependent factors are rejected, from data and from sums", "[K409]") {
  const TwoFactorData twice{{1, 2, 3, 5}, {2, 4, 6, 10}, {1, 2, 2, 3}};
  CHECK_THROWS_WITH(ols_two_factor(twice),
                    "K409.ols_two_factor: x2 follows x1: 1, x1 and x2 are linearly dependent");
  CHECK_THROWS_WITH(regression_from_sums(sums_of(twice)),
                    "K409.regression_from_sums: the normal equations are singular: 1, x1 and x2 must be "
                    "linearly independent");
  CHECK_THROWS_WITH(ols_two_factor({{1, 2, 3, 5}, {450, 450, 450, 450}, {1, 2, 2, 3}}),
                    "K409.ols_two_factor: x2 is constant: 1, x1 and x2 are linearly dependent");
  CHECK_THROWS_WITH(ols_two_factor({{1, 2, 3, 5}, {1, 0, 0, 1}, {2, 2, 2, 2}}),
                    "K409.ols_two_factor: y is constant: there is nothing to explain");
}

TEST_CASE("K409: enough crews leave machines independent", "[K409]") {
  property([] {
    const auto machines = static_cast<std::int64_t>(*rc::gen::inRange(1, 40));
    const auto spare = static_cast<std::int64_t>(*rc::gen::inRange(0, 5));
    const double mtbf_h = *rc::gen::inRange(1, 1000);
    const double mttr_h = *rc::gen::inRange(1, 100);
    const QueueState q = machine_repair_queue(pool(machines, machines + spare, mtbf_h, mttr_h));
    RC_ASSERT(std::abs(q.availability - mtbf_h / (mtbf_h + mttr_h)) < 1e-12);
    RC_ASSERT(q.mean_wait_h == 0);
    RC_ASSERT(q.p_wait == 0);
  });
}

TEST_CASE("K409: more crews and rarer failures raise the availability; flows balance", "[K409]") {
  property([] {
    const auto machines = static_cast<std::int64_t>(*rc::gen::inRange(2, 60));
    const auto crews = static_cast<std::int64_t>(*rc::gen::inRange(1, static_cast<int>(machines)));
    const double mtbf_h = *rc::gen::inRange(5, 500);
    const double mttr_h = *rc::gen::inRange(1, 50);
    const QueueState q = machine_repair_queue(pool(machines, crews, mtbf_h, mttr_h));
    const double one_more = machine_repair_queue(pool(machines, crews + 1, mtbf_h, mttr_h)).availability;
    RC_ASSERT(one_more >= q.availability - 1e-14);
    // Where hardly any machine waits the gain is below rounding.
    if (q.p_wait > 1e-9) RC_ASSERT(one_more > q.availability);
    RC_ASSERT(machine_repair_queue(pool(machines, crews, 1.1 * mtbf_h, mttr_h)).availability >
              q.availability);
    // Crews at work and machines waiting are the machines down; crews mend what fails (Little).
    const double busy = q.crew_utilization * static_cast<double>(crews);
    RC_ASSERT(std::abs(busy + q.mean_waiting - q.mean_down) < 1e-9);
    RC_ASSERT(std::abs(busy - q.failures_per_h * mttr_h) < 1e-9);
    RC_ASSERT(std::abs(q.mean_down - q.failures_per_h * q.mean_downtime_h) < 1e-9);
  });
}

TEST_CASE("K409: the machines of the card wait as simulated", "[K409]") {
  CHECK(machine_repair_queue(pool(10, 1, 50, 4)).availability == Approx(0.8476).margin(5e-5));
  CHECK(machine_repair_queue(pool(10, 1, 50, 4)).availability == Approx(0.8466).epsilon(0.003));
}

TEST_CASE("K409: the cheapest crew is the cheapest of all", "[K409]") {
  const double costs[] = {1116, 438, 392, 419, 456};
  for (std::int64_t crews = 1; crews <= 5; ++crews)
    CHECK(crew_cost_rate({pool(20, crews, 80, 6), 40, 150, 200}).total_cost_per_h ==
          Approx(costs[crews - 1]).margin(0.5));
  property([] {
    const auto machines = static_cast<std::int64_t>(*rc::gen::inRange(1, 30));
    const double mtbf_h = *rc::gen::inRange(5, 200);
    const double mttr_h = *rc::gen::inRange(1, 30);
    const double crew = *rc::gen::inRange(1, 100);
    const double down = *rc::gen::inRange(0, 300);
    const double spares = *rc::gen::inRange(0, 300);
    const BestCrew best = optimal_crew_size({{machines, mtbf_h, mttr_h}, crew, down, spares});
    for (std::int64_t c = 1; c <= machines; ++c) {
      const double cost =
          crew_cost_rate({pool(machines, c, mtbf_h, mttr_h), crew, down, spares}).total_cost_per_h;
      const double margin = c < best.crews ? 0.0 : 1e-12 * cost;
      RC_ASSERT(cost + margin >= best.total_cost_per_h);
      RC_ASSERT((c >= best.crews || cost > best.total_cost_per_h));
    }
  });
  CHECK(optimal_crew_size({{20, 80, 6}, 0, 0, 0}).crews == 1);  // all equal: the smallest
}

TEST_CASE("K409: the smallest crew for an availability", "[K409]") {
  property([] {
    const auto machines = static_cast<std::int64_t>(*rc::gen::inRange(1, 40));
    const double mtbf_h = *rc::gen::inRange(5, 200);
    const double mttr_h = *rc::gen::inRange(1, 30);
    const double target = *rc::gen::inRange(1, 1001) * 1e-3;
    const std::int64_t crews = crew_for_availability({{machines, mtbf_h, mttr_h}, target}).crews;
    std::int64_t first = 0;
    for (std::int64_t c = machines; c >= 1; --c)
      if (machine_repair_queue(pool(machines, c, mtbf_h, mttr_h)).availability >= target - 1e-12) first = c;
    RC_ASSERT(crews == first);
  });
  CHECK(crew_for_availability({{6, 30, 5}, 0.86}).crews == 0);
}

TEST_CASE("K409: wages follow the headcount; no faster repair, no bonus", "[K409]") {
  const CrewWages one = maintenance_wage_fund({2, 2, 2, 1, 2161, 0.2, 0.37, 166.7});
  const CrewWages two = maintenance_wage_fund({4, 2, 2, 1, 2161, 0.2, 0.37, 166.7});
  CHECK(two.wage_fund_month == Approx(2 * one.wage_fund_month));
  CHECK(two.crew_cost_per_h == Approx(one.crew_cost_per_h));
  const RepairPool machines = pool(20, 2, 80, 6);
  CHECK(break_even_bonus({machines, 0, 150, 80}).saving_per_h == 0);
  const double less = break_even_bonus({machines, 0.1, 150, 80}).bonus_fraction_max;
  CHECK(less > 0);
  CHECK(break_even_bonus({machines, 0.2, 150, 80}).bonus_fraction_max > less);
}

TEST_CASE("K409: the shares of time make one, and never is running to failure", "[K409]") {
  property([] {
    AgePolicy policy{ageing, *rc::gen::inRange(1, 4000) * 1.0};
    policy.shape = *rc::gen::inRange(3, 60) * 0.1;
    const AgePolicyResult r = pm_age_policy(policy);
    RC_ASSERT(std::abs(r.availability + r.pm_time_fraction + r.cm_time_fraction - 1) < 1e-12);
    RC_ASSERT(r.mean_up_h <= policy.mtbf_h * (1 + 1e-12));
  });
  CHECK(pm_age_policy({ageing, 1e9}).availability == Approx(400.0 / 416).epsilon(1e-14));
  // Long before "never" the survival has died out.
  CHECK(pm_age_policy({ageing, 1e5}).cost_per_calendar_h ==
        Approx(pm_age_policy({ageing, 1e9}).cost_per_calendar_h).epsilon(1e-12));
  // Exponential life in closed form: M = MTBF (1 - exp(-T/MTBF)).
  AgePolicy memoryless{ageing, 300};
  memoryless.shape = 1;
  CHECK(pm_age_policy(memoryless).mean_up_h == Approx(400 * -std::expm1(-0.75)).epsilon(1e-13));
}

TEST_CASE("K409: the best age beats a fine grid; sharper ageing lowers the cost", "[K409]") {
  AgeSearch search{ageing, AgeCriterion::cost};
  double last = 7.45;
  for (const auto& [shape, cost] : {std::pair{1.5, 6.62}, {2.5, 4.57}, {4.0, 3.37}}) {
    search.shape = shape;
    const OptimalAge best = pm_optimal_age(search);
    CHECK(best.cost_per_calendar_h == Approx(cost).margin(0.006));
    CHECK(best.run_to_failure_cost_per_h == Approx(7.45).margin(0.005));
    CHECK(best.cost_per_calendar_h < last);
    last = best.cost_per_calendar_h;
    AgePolicy policy{search, 0};
    for (policy.interval_h = 4; policy.interval_h < 1600; policy.interval_h *= 1.003)
      CHECK(pm_age_policy(policy).cost_per_calendar_h >= best.cost_per_calendar_h * (1 - 1e-12));
  }
  search.criterion = AgeCriterion::availability;
  const OptimalAge up = pm_optimal_age(search);
  CHECK(up.availability > up.run_to_failure_availability);
  search.shape = 1;
  CHECK(pm_optimal_age(search).interval_h == never_h);
  // Preventive work as dear and as long as a repair is never worth it.
  AgeSearch dear{ageing, AgeCriterion::cost};
  dear.t_pm_h = dear.t_cm_h;
  dear.cost_pm = dear.cost_cm;
  CHECK(pm_optimal_age(dear).interval_h == never_h);
}

TEST_CASE("K409: the overhaul interval is a minimum", "[K409]") {
  property([] {
    const double shape = *rc::gen::inRange(11, 50) * 0.1;
    const double overhaul = *rc::gen::inRange(1, 10000);
    const double repair = *rc::gen::inRange(1, 1000);
    const OverhaulPlan best = overhaul_minimal_repair({shape, 1000, overhaul, repair});
    const auto cost = [&](double t) { return (overhaul + repair * std::pow(t / 1000, shape)) / t; };
    RC_ASSERT(std::abs(cost(best.interval_h) - best.cost_per_h) < 1e-9 * best.cost_per_h);
    RC_ASSERT(cost(0.9 * best.interval_h) > best.cost_per_h);
    RC_ASSERT(cost(1.1 * best.interval_h) > best.cost_per_h);
  });
}

TEST_CASE("K409: bad input names itself", "[K409]") {
  CHECK_THROWS_WITH(
      machine_repair_queue(pool(501, 1, 50, 4)),
      "K409.machine_repair_queue: n_machines = 501, allowed 1 <= n_machines <= 500 (number of machines)");
  CHECK_THROWS_WITH(elasticity({1, 1, 0}), "K409.elasticity: y_mean = 0, must not be zero");
}
