// Tools with teeth that fail one by one, against the closed forms of K109 and brute force.
#include "models/reliability/k109_face_mill_replacement.h"
#include "sim/kernel/random_stream.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;
namespace k109 = models::k109;

namespace {

// Change times and costs of the cell whose mill is compared with K109.policy_cost.
const std::vector<std::string> costs = {"/inserts/0/price=10",
                                        "/tools/0/change/replace/value_min=1",
                                        "/tools/0/change/positioning_min=2",
                                        "/tools/0/change/failure_extra_min=9",
                                        "/tools/0/regrind_planned=5",
                                        "/tools/0/failure_damage=70",
                                        "/machines/0/rate_per_min=1.5"};

shop::RunResult run_mill(std::int64_t teeth, const std::string& strategy, const std::string& law, double cv,
                         std::vector<std::string> changes) {
  changes.push_back(fmt::format("/tools/0/teeth={}", teeth));
  changes.push_back(fmt::format(R"(/tools/0/strategy={{"kind":"replace_at_failed_teeth",{}}})", strategy));
  changes.push_back("/inserts/0/edge_life/law=" + law);
  changes.push_back(fmt::format("/inserts/0/edge_life/cv={}", cv));
  return run_cell(changes);
}

double mean_to_nth(std::int64_t n, std::int64_t teeth, double beta, double alpha) {
  k109::NthFailure in;
  in.n = n;
  in.teeth = teeth;
  in.t_mean_min = cell_life_min;
  in.beta = beta;
  in.alpha = alpha;
  return k109::mean_time_to_nth_failure(in).t_mean_min;
}

}  // namespace

TEST_CASE("a mill pulled at m failed teeth or at an age costs what K109.policy_cost says") {
  struct Case {
    const char* sharing;
    const char* law;
    double beta;
    double alpha;
    double gamma;
  };
  // (C9) is exact for the shop where the hazard model and the exposure model coincide: exponential lives with
  // any load exponent, and any life law without load sharing.
  for (const Case& c : {Case{"global", "exponential", 1, 2, 0.5}, Case{"global", "exponential", 1, 1, 0.2},
                        Case{"none", "weibull", 2, 0, 0.7}, Case{"none", "weibull", 1.5, 0, 0.3}}) {
    INFO(c.sharing << " beta " << c.beta << " alpha " << c.alpha << " gamma " << c.gamma);
    const double cv = models::weibull_cv(c.beta);
    const models::LifeLaw life(models::LifeLawKind::weibull, cell_life_min, cv);
    k109::Policy in;
    in.t_mean_min = cell_life_min;
    in.beta = c.beta;
    in.alpha = c.alpha;
    in.teeth = 6;
    in.failed_allowed = 2;
    in.t_planned_min = life.gamma_percent_life(c.gamma);
    in.edge_cost = 10;
    in.planned_cost = 5;
    in.unplanned_cost = 70;
    in.machine_rate_per_min = 1.5;
    in.change_planned_min = 6 + 2;
    in.change_unplanned_min = 6 + 2 + 9;
    const k109::PolicyCost theory = k109::policy_cost(in);
    const auto run =
        run_mill(6,
                 fmt::format(R"("failed_teeth":3,"load_sharing":"{}","load_exponent":{},"gamma":{})",
                             c.sharing, c.alpha, c.gamma),
                 c.law, cv, costs);
    check_meets(run, "cost_per_part", theory.cost_per_cutting_min * cell_part_min);
    check_meets(run, "tool/tool/insert_cycle_availability", theory.availability);
    check_meets(run, "tool/tool/failure_share", theory.p_unplanned);
  }
}

TEST_CASE("the mean time to the m-th failure under load is (C7) of K109", "[long]") {
  for (const double alpha : {0.0, 1.0, 2.0}) {
    INFO("alpha " << alpha);
    const auto run =
        run_mill(10, fmt::format(R"("failed_teeth":4,"load_sharing":"global","load_exponent":{})", alpha),
                 "weibull", models::weibull_cv(2), {});
    const double cycle_min = mean_to_nth(4, 10, 2, alpha);
    // Changes take no time: failures per minute of calendar are one per cycle.
    check_meets(run, "tool/tool/failures", counted_min(tool_cell()) / cycle_min);
    check_meets(run, "tool/tool/inserts_fitted", 10 * counted_min(tool_cell()) / cycle_min);
  }
}

TEST_CASE("with local sharing the tooth behind the gap goes next: brute force with K109.failure_times") {
  constexpr int samples = 60'000;
  constexpr std::size_t teeth = 8;
  const models::LifeLaw life(models::LifeLawKind::weibull, cell_life_min, models::weibull_cv(2));
  sim::RandomStream stream(11, "brute force", "tooth lives");
  double sum = 0;
  double squares = 0;
  for (int k = 0; k < samples; ++k) {
    k109::ToothLives in;
    in.alpha = 2;
    in.rule = k109::SharingRule::local;
    for (std::size_t i = 0; i < teeth; ++i) in.lives_min.push_back(life.quantile(stream.uniform()));
    const double third_min = k109::failure_times(in).times_min[2];
    sum += third_min;
    squares += third_min * third_min;
  }
  const double mean = sum / samples;
  const double error = std::sqrt((squares / samples - mean * mean) / samples);
  const auto run = run_mill(8, R"("failed_teeth":3,"load_sharing":"local","load_exponent":2)", "weibull",
                            models::weibull_cv(2), {});
  const shop::Estimate& failures = estimate_of(run, "tool/tool/failures");
  const double simulated = counted_min(tool_cell()) / *failures.mean;
  const double simulated_error = simulated * *failures.half_width / 2.093 / *failures.mean;
  INFO("simulated " << simulated << ", brute force " << mean);
  CHECK(std::abs(simulated - mean) < 4 * std::hypot(error, simulated_error));
  CHECK(std::hypot(error, simulated_error) < 0.01 * mean);
  // The neighbours suffer: sooner than with the load spread evenly.
  CHECK(mean + 4 * error < mean_to_nth(3, 8, 2, 2));
}

TEST_CASE("reduced feed spares the survivors and costs throughput") {
  // Teeth fail as if nothing were shared; between failures j and j+1 the mill does (z-j)/z of its work.
  constexpr std::int64_t z = 6;
  double cycle_min = 0;
  double work_min = 0;
  for (std::int64_t j = 0; j < 4; ++j) {
    const double after = mean_to_nth(j + 1, z, 2, 0);
    work_min += (after - cycle_min) * static_cast<double>(z - j) / static_cast<double>(z);
    cycle_min = after;
  }
  const auto run =
      run_mill(z, R"("failed_teeth":4,"reduce_feed":true)", "weibull", models::weibull_cv(2), {});
  check_meets(run, "tool/tool/failures", counted_min(tool_cell()) / cycle_min);
  check_meets(run, "throughput_per_h", 60 / cell_part_min * work_min / cycle_min);
}

TEST_CASE("replacing failed teeth alone renews each tooth by itself") {
  // Eight renewal processes side by side: edges used per minute is teeth / mean life, whatever the law.
  const auto run = run_mill(8, R"("failed_teeth":1,"load_sharing":"none","replace":"failed")", "weibull",
                            models::weibull_cv(2), {});
  check_meets(run, "tool/tool/edges/used", 8 * counted_min(tool_cell()) / cell_life_min);
  CHECK(mean_of(run, "tool/tool/edges_unspent") == 0);
}

TEST_CASE("failed_and_older_than lies between failed and all, and is each of them at its ends") {
  const auto with = [](const std::string& replace) {
    return run_mill(6, R"("failed_teeth":2,"load_sharing":"local",)" + replace, "weibull", 0.5,
                    {"/simulation/horizon_min=30000", "/simulation/replications=5"});
  };
  const auto all = with(R"("replace":"all")");
  const auto failed = with(R"("replace":"failed")");
  CHECK(with(R"("replace":"failed_and_older_than","older_than":0)").values == all.values);
  CHECK(with(R"("replace":"failed_and_older_than","older_than":99)").values == failed.values);
  const auto between = with(R"("replace":"failed_and_older_than","older_than":0.5)");
  CHECK(mean_of(failed, "tool/tool/failures") > mean_of(between, "tool/tool/failures"));
  CHECK(mean_of(between, "tool/tool/failures") > mean_of(all, "tool/tool/failures"));
  // Who replaces more throws more away, and younger edges at that.
  CHECK(mean_of(failed, "tool/tool/edges_unspent") == 0);
  CHECK(mean_of(between, "tool/tool/life_left_share") < mean_of(all, "tool/tool/life_left_share"));
}

TEST_CASE("a mill of one tooth is the single tool, bit for bit") {
  const std::vector<std::string> weibull = {"/inserts/0/edge_life/law=weibull",
                                            "/simulation/horizon_min=30000"};
  auto mill = weibull;
  mill.push_back(R"(/tools/0/strategy={"kind":"replace_at_failed_teeth","failed_teeth":1,"gamma":0.6})");
  auto age = weibull;
  age.push_back(R"(/tools/0/strategy={"kind":"age","gamma":0.6})");
  CHECK(run_cell(mill).values == run_cell(age).values);
}

TEST_CASE("the shop follows the teeth of a face-milling operation, not its mean mill", "[long]") {
  // The plan of the operation gives the life of the mill to its fourth failure and the mean slowdown; a tool
  // of ten teeth plays the same through. Both are exact for equal sharing, so they meet.
  const auto gallery =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/face_milling.json");
  auto cell = tool_cell();
  cell["operations"][0]["process"] = gallery["process"];
  cell["operations"][0]["process"]["feed_after_failure"] = "reduce";
  cell["inserts"][0]["edge_life"] = gallery["edge_life"];
  const auto mean_mill = load_with(cell, {});
  const auto whole = scenarios::plan(mean_mill, mean_mill.operations[0]);
  const auto run = run_with(
      cell, {"/tools/0/teeth=10",
             R"(/tools/0/strategy={"kind":"replace_at_failed_teeth","failed_teeth":4,"reduce_feed":true})"});
  check_meets(run, "throughput_per_h", 60 / whole.main_time_min);
  check_meets(run, "tool/tool/failures", counted_min(cell) / whole.edge->mean_min);
}
