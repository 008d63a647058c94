// The checks of card K117; its reference points run in tests/models/catalogue/reference_points_test.cpp.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "models/reliability/k117_rational_reliability.h"

using namespace verstat::models;
using namespace verstat::models::k117;

namespace {

double cost_at(double gamma, Accounting accounting = Accounting::scheduled, double period_min = 60) {
  PeriodEconomyAtGamma in;
  in.gamma = gamma;
  in.accounting = accounting;
  in.period_min = period_min;
  return part_cost_at_gamma(in).part_cost;
}

// Long-run figures of a two-edge insert, played state by state.
struct Played {
  double availability = 0;
  double availability_error = 0;
  double failures = 0;
};
Played play(const InsertCycle& in, int inserts) {
  std::mt19937_64 bits(7);
  const auto u = [&] { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; };
  const LifeLaw edge1 = LifeLaw::weibull(in.scale1_min, in.shape1);
  const LifeLaw edge2 = LifeLaw::weibull(in.scale2_min, in.shape2);
  double up = 0;
  double down = 0;
  double uu = 0;
  double dd = 0;
  double ud = 0;
  int failures = 0;
  for (int k = 0; k < inserts; ++k) {
    double up_here = 0;
    double down_here = 0;
    const bool single = u() < in.p_single_edge;
    const double life1 = edge1.quantile(u());
    bool next = true;
    if (life1 <= in.change_age1_min) {
      ++failures;
      down_here += in.failure_extra_min;
      next = u() < in.p_reserve_ok;
    }
    up_here += std::min(life1, in.change_age1_min);
    if (next && !single) {
      down_here += -std::log(u()) / in.rate_index_per_min;
      const double life2 = edge2.quantile(u());
      if (life2 <= in.change_age2_min) {
        ++failures;
        down_here += in.failure_extra_min;
      }
      up_here += std::min(life2, in.change_age2_min);
    }
    down_here += -std::log(u()) / in.rate_replace_per_min;
    up += up_here;
    down += down_here;
    uu += up_here * up_here;
    dd += down_here * down_here;
    ud += up_here * down_here;
  }
  const double n = inserts;
  const double k_r = up / (up + down);
  // Delta method for the ratio: variance of (1-K) up - K down per cycle.
  const double var = (1 - k_r) * (1 - k_r) * uu / n + k_r * k_r * dd / n - 2 * k_r * (1 - k_r) * ud / n;
  return {k_r, std::sqrt(var / n) / ((up + down) / n), failures / n};
}

}  // namespace

TEST_CASE("K117 check 1: series, quadrature and incomplete gamma agree", "[K117]") {
  for (const auto& [tau, printed] : {std::pair{20.0, 18.63937}, {60.0, 43.51535}}) {
    const double series = weibull_restricted_mean_series({tau, 66.18, 1.4513, 60}).restricted_mean_min;
    const double closed = LifeLaw::weibull(66.18, 1.4513).restricted_mean(tau);
    CHECK(series == Approx(closed).epsilon(1e-12));
    CHECK(series == Approx(printed).margin(5e-6));
  }
  CHECK_THROWS_WITH(weibull_restricted_mean_series({600, 66.18, 1.4513, 60}),
                    Catch::Contains("tau_min = 600, must keep (tau/scale)^shape <= 15"));
}

TEST_CASE("K117 check 2: availability agrees with play and with the printed figures", "[K117]") {
  InsertCycle in;
  in.scale1_min = in.scale2_min = 66.18;
  in.shape1 = in.shape2 = 1.4513;
  CHECK(insert_cycle_availability(in).availability == Approx(0.947368).margin(5e-7));
  in.change_age1_min = 40;
  in.change_age2_min = 30;
  in.scale2_min = 50;
  in.shape2 = 1.8;
  in.p_reserve_ok = 0.7;
  in.p_single_edge = 0.25;
  in.rate_replace_per_min = 0.1;
  in.failure_extra_min = 6;
  const InsertAvailability out = insert_cycle_availability(in);
  CHECK(out.availability == Approx(0.76186).margin(5e-6));
  CHECK(out.failures_per_insert == Approx(0.6005).margin(5e-5));
  const Played played = play(in, 200'000);
  CHECK(played.availability_error < 1e-3);
  CHECK(std::abs(played.availability - out.availability) < 4 * played.availability_error);
  CHECK(played.failures == Approx(out.failures_per_insert).epsilon(0.01));
  // The embedded chain from the transition matrix of the state list.
  const double r1 = LifeLaw::weibull(66.18, 1.4513).reliability(40);
  const double s = r1 + (1 - r1) * 0.7;
  const auto chain =
      semi_markov_steady_state(
          {{{0, 0, 0, s, 1 - s}, {0, 0, 0, 0, 1}, {0, 0, 0, 0, 1}, {0, 0, 1, 0, 0}, {0.75, 0.25, 0, 0, 0}},
           {1, 1, 1, 1, 1}})
          .embedded;
  const double expected[] = {out.pi1, out.pi2, out.pi3, out.pi4, out.pi5};
  for (std::size_t k = 0; k < 5; ++k) CHECK(chain[k] == Approx(expected[k]).epsilon(1e-12));
}

TEST_CASE("K117 check 3: availability limits", "[K117]") {
  InsertCycle in;
  in.scale1_min = 40;
  in.scale2_min = 70;
  in.shape1 = in.shape2 = 1;
  CHECK(insert_cycle_availability(in).availability == Approx(110 / (110 + 2 / 0.3)).epsilon(1e-13));
  // Run to failure: only the mean counts.
  in.shape1 = 2.3;
  in.scale1_min = 40 / std::tgamma(1 + 1 / 2.3);
  CHECK(insert_cycle_availability(in).availability == Approx(110 / (110 + 2 / 0.3)).epsilon(1e-12));
  in.rate_index_per_min = in.rate_replace_per_min = 1e12;
  CHECK(insert_cycle_availability(in).availability == Approx(1).epsilon(1e-12));
  CHECK(rc::check([] {
    InsertCycle two;
    two.scale1_min = *rc::gen::inRange(5, 200);
    two.scale2_min = two.scale1_min * *rc::gen::inRange(1, 200) * 0.01;
    two.shape1 = two.shape2 = *rc::gen::inRange(30, 500) * 0.01;
    two.change_age1_min = two.change_age2_min = *rc::gen::inRange(5, 200);
    two.p_reserve_ok = *rc::gen::inRange(0, 101) * 0.01;
    two.failure_extra_min = *rc::gen::inRange(0, 20);
    InsertCycleEdges edges;
    edges.edges = 2;
    edges.scale_min = two.scale1_min;
    edges.edge_factor = two.scale2_min / two.scale1_min;
    edges.shape = two.shape1;
    edges.change_age_min = two.change_age1_min;
    edges.p_reserve_ok = two.p_reserve_ok;
    edges.failure_extra_min = two.failure_extra_min;
    RC_ASSERT(std::abs(insert_cycle_availability(two).availability -
                       insert_cycle_availability_edges(edges).availability) < 1e-13);
    // required_restoration_rate inverts the availability without failure_extra.
    two.failure_extra_min = 0;
    AvailabilityTarget target{static_cast<TwoEdgeInsert>(two), 0.9};
    two.rate_index_per_min = two.rate_replace_per_min = required_restoration_rate(target).rate_per_min;
    RC_ASSERT(std::abs(insert_cycle_availability(two).availability - 0.9) < 1e-12);
  }));
}

TEST_CASE("K117: semi-Markov chains may have transient states but one recurrent class only", "[K117]") {
  const auto out = semi_markov_steady_state({{{0.5, 0.5, 0}, {0, 0, 1}, {0, 1, 0}}, {3, 1, 4}});
  CHECK(out.embedded == std::vector<double>{0, 0.5, 0.5});
  CHECK(out.time_fraction[2] == Approx(0.8));
  CHECK_THROWS_WITH(semi_markov_steady_state({{{1, 0}, {0, 1}}, {1, 1}}),
                    Catch::Contains("one recurrent class"));
  CHECK_THROWS_WITH(semi_markov_steady_state({{{0.5, 0.4}, {0, 1}}, {1, 1}}),
                    Catch::Contains("is the sum of a row"));
  CHECK_THROWS_WITH(semi_markov_steady_state({{{0.5, 0.5}, {0, 1}}, {1, 0}}), Catch::Contains("m_min is 0"));
  CHECK(rc::check([] {
    const std::size_t n = *rc::gen::inRange<std::size_t>(2, 7);
    SemiMarkov in;
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<double> row;
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j) sum += row.emplace_back(*rc::gen::inRange(1, 100));
      for (double& p : row) p /= sum;
      in.transitions.push_back(row);
      in.mean_sojourn_min.push_back(*rc::gen::inRange(1, 50));
    }
    const auto steady = semi_markov_steady_state(in);
    for (std::size_t j = 0; j < n; ++j) {
      double next = 0;
      for (std::size_t i = 0; i < n; ++i) next += steady.embedded[i] * in.transitions[i][j];
      RC_ASSERT(std::abs(next - steady.embedded[j]) < 1e-14);
    }
  }));
}

TEST_CASE("K117 check 4: derivatives are finite differences, and cousins meet", "[K117]") {
  CHECK(rc::check([] {
    PeriodEconomyAtGamma in;
    in.gamma = *rc::gen::inRange(42, 98) * 0.01;
    in.cv = *rc::gen::inRange(20, 120) * 0.01;
    in.mu = *rc::gen::inRange(20, 80) * 0.1;
    in.damage_cost = *rc::gen::inRange(0, 400);
    in.life_offset_min = *rc::gen::inRange(0, 10);
    const double h = 2e-4 * (1 - in.gamma);
    const PartCostAtGamma here = part_cost_at_gamma(in);
    auto moved = in;
    moved.gamma = in.gamma + h;
    const PartCostAtGamma right = part_cost_at_gamma(moved);
    moved.gamma = in.gamma - h;
    const PartCostAtGamma left = part_cost_at_gamma(moved);
    const double slope = (right.part_cost - left.part_cost) / (2 * h);
    const double curvature = (*right.slope - *left.slope) / (2 * h);
    RC_ASSERT(std::abs(slope - *here.slope) < 1e-5 * (std::abs(*here.slope) + here.part_cost));
    RC_ASSERT(std::abs(curvature - *here.curvature) <
              1e-5 * (std::abs(*here.curvature) + std::abs(*here.slope) + here.part_cost));
  }));
  CHECK(rc::check([] {
    PeriodEconomyAtGamma fixed;
    fixed.gamma = *rc::gen::inRange(41, 98) * 0.01;
    fixed.accounting = *rc::gen::element(Accounting::scheduled, Accounting::renewal);
    const PartCostAtGamma at = part_cost_at_gamma(fixed);
    PartCostIn free;
    free.gamma = fixed.gamma;
    free.accounting = fixed.accounting;
    free.speed_m_min = at.speed_m_min;
    const PartCost cost = part_cost(free);
    RC_ASSERT(std::abs(cost.part_cost / at.part_cost - 1) < 1e-12);
    RC_ASSERT(std::abs(cost.change_age_min - 60) < 1e-9);
    RC_ASSERT(std::abs(cost.mean_life_min / at.mean_life_min - 1) < 1e-12);
  }));
}

TEST_CASE("K117 check 5: scheduled accounting meets the paper's 0.64 and 0.80-0.82", "[K117]") {
  const RationalGamma best = rational_gamma_cost({});
  CHECK(best.gamma == Approx(0.6400).margin(5e-5));
  CHECK(best.gamma_knee == Approx(0.817).margin(5e-4));
  CHECK(best.part_cost == Approx(125.87).margin(5e-3));
  for (const auto& [gamma, cost] : {std::pair{0.4, 127.19},
                                    {0.5, 126.46},
                                    {0.64, 125.87},
                                    {0.78, 127.23},
                                    {0.81, 128.13},
                                    {0.9, 134.31},
                                    {0.95, 144.22}})
    CHECK(cost_at(gamma) == Approx(cost).margin(5e-3));
  for (const auto& [gamma, curvature] :
       {std::pair{0.64, 88.0}, {0.78, 322.0}, {0.81, 453.0}, {0.9, 1910.0}}) {
    PeriodEconomyAtGamma in;
    in.gamma = gamma;
    CHECK(*part_cost_at_gamma(in).curvature == Approx(curvature).margin(0.5));
  }
  CHECK(cost_at(best.gamma_knee) == Approx(1.02 * best.part_cost).epsilon(1e-9));
}

TEST_CASE("K117 check 6: renewal accounting, expenditure and consumption", "[K117]") {
  GammaSearch renewal;
  renewal.accounting = Accounting::renewal;
  CHECK(rational_gamma_cost(renewal).gamma == Approx(0.775).margin(5e-4));
  CHECK(rational_gamma_expenditure({}).gamma == Approx(0.777).margin(5e-4));
  ConsumptionSearch in;
  in.edges = 8;
  in.law = LifeLawKind::normal;
  in.cv = 0.4;
  in.p_reserve_ok = 0.5;
  CHECK(rational_gamma_consumption(in).gamma == Approx(0.778).margin(5e-4));
  in.law = LifeLawKind::weibull;
  in.cv = 0.7;
  in.p_reserve_ok = 0;
  CHECK(rational_gamma_consumption(in).gamma == Approx(0.766).margin(5e-4));
  in.edges = 4;
  in.cv = 0.4;
  CHECK(rational_gamma_consumption(in).gamma == Approx(0.772).margin(5e-4));
  // Stationarity of the expenditure: (k/b) A_v/(gamma (-ln gamma)) = C_f.
  const double gamma = rational_gamma_expenditure({}).gamma;
  const double made = reliability_expenditure({{}, gamma}).manufacture;
  const double b = weibull_from_moments({}).shape;
  CHECK(made / b / (gamma * -std::log(gamma)) == Approx(164.5).epsilon(1e-6));
}

TEST_CASE("K117 check 7: sensitivity of the rational level", "[K117]") {
  struct Row {
    double cv, t_failure, damage, mu, rate, scheduled, renewal;
  };
  for (const Row& row : {Row{0.4, 15, 72, 5, 3, 0.850, 0.874}, Row{0.5, 15, 72, 5, 3, 0.795, 0.840},
                         Row{0.7, 30, 72, 5, 3, 0.774, 0.832}, Row{0.7, 15, 300, 5, 3, 0.896, 0.909},
                         Row{0.7, 15, 120, 4, 3, 0.664, 0.780}, Row{0.7, 15, 72, 5, 6, 0.40, 0.675},
                         Row{0.7, 15, 0, 5, 3, 0.40, 0.591}}) {
    GammaSearch in;
    in.cv = row.cv;
    in.t_change_failure_min = row.t_failure;
    in.damage_cost = row.damage;
    in.mu = row.mu;
    in.machine_rate_per_min = row.rate;
    CHECK(rational_gamma_cost(in).gamma == Approx(row.scheduled).margin(5.1e-4));
    in.accounting = Accounting::renewal;
    CHECK(rational_gamma_cost(in).gamma == Approx(row.renewal).margin(5.1e-4));
  }
}

TEST_CASE("K117: the failure penalty makes gamma a minimum", "[K117]") {
  CHECK(rc::check([] {
    PenaltyCalibration in;
    in.gamma = *rc::gen::inRange(50, 99) * 0.01;
    in.shape = 1.4512636664716478;
    const double failure = failure_penalty_for_gamma(in).failure_cost;
    PeriodEconomyAtGamma at;
    at.gamma = in.gamma;
    at.damage_cost = failure - 164.5 + 72;
    if (at.damage_cost < 0) RC_DISCARD();
    const PartCostAtGamma out = part_cost_at_gamma(at);
    RC_ASSERT(std::abs(*out.slope) < 1e-9 * *out.curvature);
    RC_ASSERT(*out.curvature > 0);
  }));
  CHECK_THROWS_WITH(failure_penalty_for_gamma({0.42, 1.45126, 5, 60, 3, 37.5}),
                    Catch::Contains("gamma = 0.42, must be above exp(1/(shape mu) - 1)"));
}

TEST_CASE("K117 check 8: the optimal change age against brute force", "[K117]") {
  OptimalAge best = optimal_age_replacement({});
  CHECK(best.change_age_min == Approx(54.5).margin(0.05));
  CHECK(best.gamma == Approx(0.470).margin(5e-4));
  CHECK(best.cost_rate_per_min == Approx(2.551).margin(5e-4));
  CHECK(best.run_to_failure_cost_rate_per_min == Approx(2.742).margin(5e-4));
  OptimalAgeIn normal;
  normal.law = LifeLawKind::normal;
  normal.cv = 0.4;
  best = optimal_age_replacement(normal);
  CHECK(best.change_age_min == Approx(38.0).margin(0.05));
  CHECK(best.gamma == Approx(0.821).margin(5e-4));
  CHECK(best.cost_rate_per_min == Approx(1.689).margin(5e-4));

  CHECK(rc::check([] {
    OptimalAgeIn in;
    in.law = *rc::gen::element(LifeLawKind::weibull, LifeLawKind::normal, LifeLawKind::exponential);
    in.mean_min = *rc::gen::inRange(1, 300);
    in.cv =
        in.law == LifeLawKind::normal ? *rc::gen::inRange(5, 46) * 0.01 : *rc::gen::inRange(5, 151) * 0.01;
    in.planned_cost = *rc::gen::inRange(0, 200);
    in.failure_cost = *rc::gen::inRange(0, 400);
    const OptimalAge found = optimal_age_replacement(in);
    double brute = found.run_to_failure_cost_rate_per_min;
    AgeReplacement at;
    static_cast<LifeLawIn&>(at) = in;
    static_cast<OutcomeCosts&>(at) = in;
    for (int k = 0; k <= 400; ++k) {
      at.change_age_min = in.mean_min * 0.01 * std::pow(600.0, k / 400.0);
      brute = std::min(brute, age_replacement_cost_rate(at).cost_rate_per_min);
    }
    RC_ASSERT(found.cost_rate_per_min <= brute * (1 + 1e-12));
    at.change_age_min = found.change_age_min;
    RC_ASSERT(std::abs(age_replacement_cost_rate(at).cost_rate_per_min - found.cost_rate_per_min) <=
              1e-12 * found.cost_rate_per_min);
    const bool never = in.law == LifeLawKind::exponential || (in.law == LifeLawKind::weibull && in.cv >= 1) ||
                       in.failure_cost <= in.planned_cost;
    if (never) RC_ASSERT(found.change_age_min == no_schedule_min);
  }));
}

TEST_CASE("K117 check 9: the joint optimum against brute force", "[K117]") {
  JointOptimumIn in;
  const JointOptimum weibull = joint_speed_gamma_optimum(in);
  CHECK(weibull.gamma == Approx(0.470).margin(5e-4));
  CHECK(weibull.speed_m_min == Approx(46.97).margin(5e-3));
  CHECK(weibull.part_cost == Approx(125.41).margin(5e-3));
  in.law = LifeLawKind::normal;
  in.cv = 0.4;
  const JointOptimum normal = joint_speed_gamma_optimum(in);
  CHECK(normal.gamma == Approx(0.821).margin(6e-4));
  CHECK(normal.speed_m_min == Approx(51.0).margin(0.05));
  CHECK(normal.part_cost == Approx(115.48).margin(5e-3));
  CHECK(1 - normal.part_cost / weibull.part_cost == Approx(0.079).margin(5e-4));
  double brute = 1e300;
  for (int i = 1; i < 98; ++i)
    for (int j = 0; j <= 200; ++j) {
      PartCostIn at;
      at.law = in.law;
      at.cv = in.cv;
      at.gamma = 0.01 * (i + 1);
      at.speed_m_min = 30 + 0.2 * j;
      brute = std::min(brute, part_cost(at).part_cost);
    }
  CHECK(brute >= normal.part_cost * (1 - 1e-12));
  CHECK(brute == Approx(normal.part_cost).epsilon(1e-4));
  // Eq. (7) at the optimal change age has its minimum at the joint optimum.
  GammaSearch period;
  period.accounting = Accounting::renewal;
  period.period_min = weibull.change_age_min;
  CHECK(weibull.change_age_min == Approx(185.369).margin(5e-4));
  CHECK(rational_gamma_cost(period).gamma == Approx(weibull.gamma).epsilon(1e-5));
  CHECK(rational_gamma_cost(period).part_cost == Approx(weibull.part_cost).epsilon(1e-10));
}

TEST_CASE("K117: part count changes at whole parts, and inside a part that outlasts the age", "[K117]") {
  PartCostIn in;
  in.strategy = Strategy::part_count;
  in.gamma = 0.9;
  in.speed_m_min = 55;
  const PartCost inside = part_cost(in);  // T_gamma = 21.7 min, t0 = 28.6 min
  CHECK(inside.change_age_min < inside.machining_time_min);
  in.strategy = Strategy::age;
  CHECK(part_cost(in).part_cost == Approx(inside.part_cost).epsilon(1e-12));
  // A part that fits exactly three times is not lost to rounding.
  in.strategy = Strategy::part_count;
  const double age = inside.change_age_min;
  in.length_mm = 1000 * age / 3 / inside.machining_time_min;
  CHECK(part_cost(in).change_age_min == Approx(age).epsilon(1e-12));
}

TEST_CASE("K117 check 11 and section F: gamma-percent lives", "[K117]") {
  for (const auto& [gamma, ratio] :
       {std::pair{0.5, 1.167}, {0.64, 1.354}, {0.8, 1.691}, {0.9, 2.083}, {0.95, 2.401}}) {
    PulseTreatment in;
    in.gamma = gamma;
    CHECK(pulse_treatment_effect(in).gamma_life_ratio == Approx(ratio).margin(5.1e-4));
  }
  CHECK(rc::check([] {
    PeriodAtGamma in;
    in.law = *rc::gen::element(LifeLawKind::weibull, LifeLawKind::normal, LifeLawKind::exponential);
    in.cv = *rc::gen::inRange(5, 46) * 0.01;
    in.gamma = *rc::gen::inRange(1, 98) * 0.01;
    const double mean_min = required_mean_life(in).mean_min;
    GammaPercent back{{{mean_min, in.cv}, in.law}, in.gamma};
    const double life_min = gamma_percent_life(back).life_min;
    RC_ASSERT(std::abs(life_min - 60) < 1e-10);
    back.gamma += 0.005;
    RC_ASSERT(gamma_percent_life(back).life_min < life_min);
  }));
}

TEST_CASE("K117: speed and mean life are inverse", "[K117]") {
  CHECK(rc::check([] {
    LifeWanted wanted;
    wanted.mean_min = *rc::gen::inRange(1, 600);
    wanted.feed_mm_rev = *rc::gen::inRange(1, 40) * 0.05;
    wanted.depth_mm = *rc::gen::inRange(1, 40) * 0.5;
    Regime at;
    at.speed_m_min = speed_for_mean_life(wanted).speed_m_min;
    at.feed_mm_rev = wanted.feed_mm_rev;
    at.depth_mm = wanted.depth_mm;
    RC_ASSERT(std::abs(mean_life_for_regime(at).mean_min / wanted.mean_min - 1) < 1e-12);
  }));
}

TEST_CASE("K117: bad input names itself", "[K117]") {
  PartCostIn in;
  in.speed_m_min = 55;
  CHECK_THROWS_WITH(part_cost(in),
                    "K117.part_cost: gamma is missing: every strategy but run_to_failure needs it");
  in.strategy = Strategy::run_to_failure;
  CHECK(part_cost(in).change_age_min == 0);
  in.law = LifeLawKind::normal;
  CHECK_THROWS_WITH(part_cost(in), "K117.part_cost: cv = 0.7, allowed 0.05 <= cv <= 0.45 for the normal law");
  PeriodEconomyAtGamma low;
  low.gamma = 0.3;
  CHECK_THROWS_WITH(part_cost_at_gamma(low), Catch::Contains("allowed 0.40 <= gamma <= 0.99 in scheduled"));
  CHECK_THROWS_WITH(life_reliability({{{60, 1.2}, LifeLawKind::weibull}, 0}),
                    Catch::Contains("t_min = 0, must be above 0"));
  CHECK_THROWS_WITH(required_mean_life({LifeLawKind::normal, 60, 0.995, 0.4}),
                    Catch::Contains("gamma = 0.995, must be below Phi(1/cv)"));
}

TEST_CASE("lognormal and gamma lives: the optimal age is the best of all ages", "[k117]") {
  // The lognormal hazard rises and falls: the condition of the optimum has two roots, or none.
  for (const LifeLawKind kind : {LifeLawKind::lognormal, LifeLawKind::gamma})
    for (const double cv : {0.2, 0.5, 0.9, 1.3})
      for (const double failure : {1.2, 4.0, 30.0}) {
        INFO(static_cast<int>(kind) << " cv " << cv << " failure " << failure);
        OptimalAgeIn in;
        in.law = kind;
        in.cv = cv;
        in.mean_min = 60;
        in.planned_cost = 1;
        in.failure_cost = failure;
        const OptimalAge best = optimal_age_replacement(in);
        const LifeLaw law(kind, 60, cv);
        double least = failure / 60;
        for (double age = 0.6; age <= 360; age *= 1.002) {
          const double fails = law.failure_probability(age);
          least = std::min(least, ((1 - fails) + fails * failure) / law.restricted_mean(age));
        }
        CHECK(best.cost_rate_per_min <= least * (1 + 1e-12));
        CHECK(best.cost_rate_per_min >= least * (1 - 2e-5));
      }
}
