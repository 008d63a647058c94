// The simulated insert cycle and its cost against the closed forms of K117, strategy by strategy. Every check
// is a confidence interval at a fixed seed, with a standard error that would show a fault of 1 %.
#include <cmath>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "models/reliability/k117_rational_reliability.h"
#include "scenarios/load.h"
#include "sim/shop/run.h"

using namespace verstat;
using nlohmann::json;

namespace {

// The heavy-lathe cell with one setter per lathe, so that nobody waits, and changes on top.
shop::RunResult run_cell(const std::vector<std::string>& changes, const char* file = "heavy-lathe.json") {
  std::vector<scenarios::Change> all = {scenarios::parse_change("/crews/0/members=2"),
                                        scenarios::parse_change("/simulation/horizon_min=610000"),
                                        scenarios::parse_change("/simulation/replications=20")};
  for (const std::string& change : changes) all.push_back(scenarios::parse_change(change));
  const json text = scenarios::read_json_file(std::string(VERSTAT_SOURCE_DIR "/scenarios/gallery/") + file);
  return shop::run_scenario(scenarios::load(scenarios::apply(text, all)), 2);
}

void check_meets(const shop::RunResult& run, const std::string& kpi, double theory) {
  const auto k = run.index_of(kpi);
  REQUIRE(k);
  const shop::Estimate& e = run.estimates[*k];
  const double standard_error = *e.half_width / 2.093;  // Student quantile for 19 degrees of freedom
  INFO(kpi << " simulated " << *e.mean << " +- " << *e.half_width << ", theory " << theory);
  CHECK(std::abs(*e.mean - theory) < 4 * standard_error);
  CHECK(4 * standard_error < 0.01 * theory);  // the check would notice 1 %
}

double mean_of(const shop::RunResult& run, const std::string& kpi) {
  return *run.estimates[*run.index_of(kpi)].mean;
}

}  // namespace

TEST_CASE("insert-cycle availability is K_r of K117, run to failure and scheduled", "[long]") {
  struct Case {
    const char* strategy;
    double age_min;  // of an edge with mean life 60 min
    double p_reserve_ok, p_single_edge, rate_replace, failure_extra;
  };
  const models::LifeLaw life(models::LifeLawKind::weibull, 60, 0.7);
  const double t_50 = life.gamma_percent_life(0.5);
  const double t_80 = life.gamma_percent_life(0.8);
  for (const Case& c : {Case{R"({"kind":"run_to_failure"})", 1e9, 1, 0, 0.3, 0},
                        Case{R"({"kind":"run_to_failure"})", 1e9, 0.7, 0.25, 0.1, 6},
                        Case{R"({"kind":"age","gamma":0.5})", t_50, 1, 0, 0.3, 0},
                        Case{R"({"kind":"age","gamma":0.8})", t_80, 0.7, 0.25, 0.1, 6}}) {
    INFO(c.strategy << " p_reserve_ok " << c.p_reserve_ok);
    models::k117::InsertCycle cycle;
    cycle.scale1_min = cycle.scale2_min = life.scale();
    cycle.shape1 = cycle.shape2 = life.shape();
    cycle.change_age1_min = cycle.change_age2_min = c.age_min;
    cycle.p_reserve_ok = c.p_reserve_ok;
    cycle.p_single_edge = c.p_single_edge;
    cycle.rate_replace_per_min = c.rate_replace;
    cycle.failure_extra_min = c.failure_extra;
    const auto theory = models::k117::insert_cycle_availability(cycle);
    const auto run =
        run_cell({fmt::format("/tools/0/strategy={}", c.strategy), "/tools/0/change/positioning_min=0",
                  fmt::format("/tools/0/change/failure_extra_min={}", c.failure_extra),
                  fmt::format("/tools/0/change/replace/rate_per_min={}", c.rate_replace),
                  fmt::format("/inserts/0/reserve_ok_probability={}", c.p_reserve_ok),
                  fmt::format("/inserts/0/single_edge_probability={}", c.p_single_edge)});
    check_meets(run, "tool/roughing tool/insert_cycle_availability", theory.availability);
    check_meets(run, "machine/lathe 1/availability", theory.availability);  // blanks are always there
    // Failures per insert: two counts and a ratio of the same closed form.
    const double failures =
        mean_of(run, "tool/roughing tool/failures") / mean_of(run, "tool/roughing tool/inserts_fitted");
    CHECK(failures == Approx(theory.failures_per_insert).epsilon(0.01));
  }
}

TEST_CASE("with one setter for two lathes availability falls, and the loss is the waiting for the setter",
          "[long]") {
  const auto alone = run_cell({});
  const auto shared = run_cell({"/crews/0/members=1"});
  const auto difference =
      shop::paired_difference(alone, shared, "tool/roughing tool/insert_cycle_availability");
  CHECK(*difference.mean + 5 * *difference.half_width < 0);
  CHECK(mean_of(alone, "tool/roughing tool/waiting_crew_share") == 0);
  CHECK(mean_of(shared, "tool/roughing tool/waiting_crew_share") > 0.005);
  CHECK(mean_of(shared, "machine/lathe 1/state/waiting_crew") > 0.005);
  // The change times themselves are the same: without the waiting the availability is that of the lone lathe.
  const double a = mean_of(shared, "tool/roughing tool/insert_cycle_availability");
  const double w = mean_of(shared, "tool/roughing tool/waiting_crew_share");
  CHECK(a / (1 - w) == Approx(mean_of(alone, "tool/roughing tool/insert_cycle_availability")).epsilon(0.005));
}

TEST_CASE("simulated cost per part of every strategy is K117.part_cost", "[long]") {
  using models::k117::Strategy;
  struct Case {
    const char* name;
    Strategy strategy;
    double gamma;
    double speed;
    bool treated;
  };
  for (const Case& c :
       {Case{"run_to_failure", Strategy::run_to_failure, 0.5, 60, false},
        Case{"age", Strategy::age, 0.64, 60, false}, Case{"age", Strategy::age, 0.8205, 51, true},
        Case{"age", Strategy::age, 0.95, 60, false}, Case{"part_count", Strategy::part_count, 0.5, 50, false},
        Case{"part_count", Strategy::part_count, 0.9, 60, false},
        Case{"part_count", Strategy::part_count, 0.7, 55, true},
        Case{"block", Strategy::block, 0.64, 60, false}, Case{"block", Strategy::block, 0.3, 60, true}}) {
    INFO(c.name << " gamma " << c.gamma << " V " << c.speed << (c.treated ? " treated" : ""));
    models::k117::PartCostIn in;
    in.strategy = c.strategy;
    in.gamma = c.gamma;
    in.speed_m_min = c.speed;
    if (c.treated) {
      in.law = models::LifeLawKind::normal;
      in.cv = 0.4;
    }
    const auto theory = models::k117::part_cost(in);
    const std::string strategy = c.strategy == Strategy::run_to_failure
                                     ? R"({"kind":"run_to_failure"})"
                                     : fmt::format(R"({{"kind":"{}","gamma":{}}})", c.name, c.gamma);
    const auto run = run_cell({"/tools/0/strategy=" + strategy,
                               fmt::format("/operations/0/process/cutting_speed_m_min={}", c.speed)},
                              c.treated ? "heavy-lathe-treated.json" : "heavy-lathe.json");
    check_meets(run, "cost_per_part", theory.part_cost);
    check_meets(run, "cost/machining", theory.machining_cost);
    check_meets(run, "throughput_per_h", 2 * 60 / theory.time_per_part_min * mean_of(run, "quality_ratio"));
  }
}

TEST_CASE("an insert booked when it is fitted costs price over edges used") {
  // K117 section E: both bookings agree when R/K_1 + (1-R)/K_2 = 1/K_eff; with a reserve edge that always
  // holds, two edges are used per insert.
  const auto run = run_cell({"/tools/0/insert_booking=at_fitting"});
  models::k117::PartCostIn in;
  in.gamma = 0.64;
  in.speed_m_min = 60;
  in.periods_planned = in.periods_failure = 2;
  check_meets(run, "cost_per_part", models::k117::part_cost(in).part_cost);
}

TEST_CASE("times and money add up in every replication") {
  const auto run =
      run_cell({"/simulation/replications=5", "/crews/0/members=1", "/simulation/horizon_min=50000"});
  for (const auto& values : run.values) {
    double states = 0;
    double cost = 0;
    for (std::size_t k = 0; k < run.kpis.size(); ++k) {
      const std::string& name = run.kpis[k].name;
      if (name.starts_with("machine/lathe 2/state/")) states += *values[k];
      if (name.starts_with("cost/")) cost += *values[k];
    }
    CHECK(states == Approx(1).epsilon(1e-12));
    CHECK(cost == *values[*run.index_of("cost_per_part")]);  // to the last bit
  }
}

TEST_CASE("the same seed gives the same bits on any number of threads, another seed does not", "[threads]") {
  const json text = scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
  const auto small =
      scenarios::load(scenarios::apply(text, {scenarios::parse_change("/simulation/horizon_min=30000")}));
  const auto one = shop::run_scenario(small, 1);
  for (int threads : {2, 8}) CHECK(shop::run_scenario(small, threads).values == one.values);
  auto other = small;
  other.simulation.seed.value += 1;
  CHECK(shop::run_scenario(other, 2).values != one.values);
}
