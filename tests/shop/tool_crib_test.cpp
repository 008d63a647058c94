// Sister tools, shared tools, tool room, regrinding and the crib against queueing theory.
#include <boost/math/distributions/poisson.hpp>

#include "models/reliability/k117_rational_reliability.h"
#include "sim/shop/shop.h"
#include "tests/property.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;

namespace {

// Erlang's loss formula, by its recursion.
double erlang_b(int servers, double load) {
  double b = 1;
  for (int k = 1; k <= servers; ++k) b = load * b / (k + load * b);
  return b;
}

}  // namespace

TEST_CASE("a base stock of S inserts runs out as Erlang's loss formula says, whatever the lead time's law",
          "[long]") {
  // S + 1 inserts are in the machine, on the shelf or on order; the machine waits when all are on order.
  for (const char* lead :
       {R"({"kind":"exponential","rate_per_min":0.0111111111111111})",
        R"({"kind":"uniform","low_min":20,"high_min":160})", R"({"kind":"constant","value_min":90})"}) {
    const auto run = run_cell({fmt::format(
        R"(/inserts/0/crib={{"stock":2,"reorder_point":1,"order_quantity":1,"lead_time":{}}})", lead)});
    check_meets(run, "machine/lathe/state/waiting_tool", erlang_b(3, 90 / cell_life_min));
    check_meets(run, "tool/tool/inserts_fitted",
                (1 - erlang_b(3, 90 / cell_life_min)) * counted_min(tool_cell()) / cell_life_min);
  }
}

TEST_CASE("sister tools: the machine waits when all are in the tool room", "[long]") {
  // n copies, the machine spends one in 60 min, the tool room takes 40: with hands for each M/G/n/n, with one
  // pair of hands M/M/1/n.
  const std::vector<std::string> base = {
      "/tools/0/copies=3", "/simulation/horizon_min=800000",
      R"(/tools/0/change/replace={"kind":"exponential","rate_per_min":0.025})"};
  auto many = base;
  many.push_back("/crews/0/members=3");
  check_meets(run_cell(many), "machine/lathe/state/waiting_tool", erlang_b(3, 40 / cell_life_min));
  many.push_back(R"(/tools/0/change/replace={"kind":"constant","value_min":40})");
  check_meets(run_cell(many), "machine/lathe/state/waiting_tool", erlang_b(3, 40 / cell_life_min));

  const double rho = 40 / cell_life_min;
  const double empty = std::pow(rho, 3) / (1 + rho + rho * rho + rho * rho * rho);
  auto longer = base;
  longer.emplace_back("/simulation/horizon_min=1200000");
  const auto one = run_cell(longer);
  check_meets(one, "machine/lathe/state/waiting_tool", empty);
  // The crew works off the machine: 40 min for each tool that comes.
  check_meets(one, "crew/crew/utilization", (1 - empty) * rho);
}

TEST_CASE("tools shared between machines: the birth-death chain of machines and copies", "[long]") {
  // Two lathes, three copies, 80 min in the tool room with hands for each: k copies away.
  const auto run = run_cell({"/machines/0/count=2", "/tools/0/copies=3", "/tools/0/shared=true",
                             "/crews/0/members=3", "/simulation/horizon_min=600000",
                             R"(/tools/0/presetting={"time":{"kind":"exponential","rate_per_min":0.0125}})"});
  double weight = 1;
  double sum = 0;
  double waiting = 0;
  for (int k = 0; k <= 3; ++k) {
    const int working = std::min(2, 3 - k);
    sum += weight;
    waiting += weight * (2 - working) / 2;
    weight *= working / cell_life_min / ((k + 1) / 80.0);
  }
  check_meets(run, "tool/tool/state/waiting_tool", waiting / sum);
  check_meets(run, "throughput_per_h", 2 * 60 / cell_part_min * (1 - waiting / sum));
}

TEST_CASE("reground drills are used up as the insert of several edges with shrinking lives") {
  models::k117::InsertCycleEdges in;
  const models::LifeLaw life(models::LifeLawKind::weibull, cell_life_min, 0.5);
  in.edges = 5;
  in.scale_min = life.scale();
  in.shape = life.shape();
  in.edge_factor = 0.9;
  in.p_reserve_ok = 0.8;
  in.change_age_min = life.gamma_percent_life(0.6);
  // The card's age is one number of minutes for all edges, as the strategy's is.
  const auto theory = models::k117::insert_cycle_availability_edges(in);
  const auto run = run_cell(
      {"/inserts/0/edge_life/law=weibull", "/inserts/0/edge_life/cv=0.5",
       R"(/tools/0/strategy={"kind":"age","gamma":0.6})", "/inserts/0/reserve_ok_probability=0.8",
       R"(/tools/0/regrind={"time":{"kind":"constant","value_min":0},"max_regrinds":4,"life_factor":0.9})"});
  check_meets(run, "tool/tool/inserts_fitted",
              theory.inserts_per_cutting_hour / 60 * counted_min(tool_cell()));
  CHECK(mean_of(run, "tool/tool/edges/used") / mean_of(run, "tool/tool/inserts_fitted") ==
        Approx(theory.edges_used_per_insert).epsilon(0.005));
}

TEST_CASE("a drill away for regrinding stops its machine unless there is another", "[long]") {
  const std::vector<std::string> one = {
      R"(/tools/0/regrind={"time":{"kind":"exponential","rate_per_min":0.05},"max_regrinds":1000})",
      "/simulation/horizon_min=800000"};
  // Run to failure, every failure reground: on 60 min, off 20 min.
  check_meets(run_cell(one), "machine/lathe/availability", 60.0 / 80);
  auto two = one;
  two.push_back("/tools/0/copies=2");
  check_meets(run_cell(two), "machine/lathe/state/waiting_tool", erlang_b(2, 20.0 / 60));
}

TEST_CASE("an unattended interval passes without a stop with exp(-t/T), and the sisters cover the Poisson",
          "[long]") {
  const auto run = run_cell({"/simulation/unattended_min=90", "/simulation/horizon_min=902000"});
  check_meets(run, "tool/tool/no_stop_share", std::exp(-90 / cell_life_min));
  // Poisson(1.5): at most 3 with 0.934, at most 4 with 0.981.
  CHECK(mean_of(run, "tool/tool/sisters_needed") == 4);
  CHECK(mean_of(run_cell({"/simulation/unattended_min=90", "/tools/0/unattended_target=0.9"}),
                "tool/tool/sisters_needed") == 3);
  // With sisters at hand the changes do not stop the machine: the bound says how sure that is.
  const auto quiet = run_cell({"/simulation/unattended_min=90", "/tools/0/copies=12"});
  CHECK(mean_of(quiet, "tool/tool/no_stop_share") == 1);
  CHECK(mean_of(quiet, "tool/tool/unattended/no_stop_high") == 1);
  const double intervals =
      mean_of(quiet, "tool/tool/unattended/intervals") * static_cast<double>(quiet.values.size());
  constexpr double z = 1.959963984540054;
  CHECK(mean_of(quiet, "tool/tool/unattended/no_stop_low") == Approx(1 / (1 + z * z / intervals)));

  // The interval comes from all replications together and holds the closed form.
  const double low = mean_of(run, "tool/tool/unattended/no_stop_low");
  const double high = mean_of(run, "tool/tool/unattended/no_stop_high");
  const double chance = std::exp(-90 / cell_life_min);
  const double n = mean_of(run, "tool/tool/unattended/intervals") * static_cast<double>(run.values.size());
  CHECK(low < chance);
  CHECK(chance < high);
  CHECK(high - low == Approx(2 * z * std::sqrt(chance * (1 - chance) / n)).epsilon(0.05));

  // Ten intervals cannot show that 95 % of them pass; ten thousand can.
  CHECK(mean_of(run, "tool/tool/sisters_needed_surely") == 4);
  const auto few = run_cell({"/simulation/unattended_min=90", "/simulation/horizon_min=2900"});
  const auto k = *few.index_of("tool/tool/sisters_needed_surely");
  for (const auto& values : few.values) CHECK_FALSE(values[k].has_value());
}

TEST_CASE("the inserts of a week are Poisson, by insert and by grade", "[long]") {
  // Run to failure at a rate of one insert in cell_life_min: 168 in a week, 90 % of the weeks need no more
  // than 185.
  const auto run =
      run_cell({"/simulation/horizon_min=2018000", R"(/inserts/0/grade="P25")", "/inserts/0/edges=1"});
  const double rate = mean_of(run, "insert/insert/consumption_per_week");
  CHECK(rate == Approx(10'080 / cell_life_min).epsilon(0.01));
  const double p90 = mean_of(run, "insert/insert/consumption_week_p90");
  CHECK(p90 ==
        Approx(quantile(boost::math::poisson_distribution<>(10'080 / cell_life_min), 0.9)).epsilon(0.01));
  CHECK(mean_of(run, "grade/P25/consumption_week_p90") == p90);
  CHECK(mean_of(run, "grade/P25/consumption") == mean_of(run, "insert/insert/consumption"));
}

TEST_CASE("after a failure another crew comes") {
  auto cell = tool_cell();
  cell["inserts"][0]["edge_life"]["law"] = "weibull";
  cell["tools"][0]["strategy"] = {{"kind", "age"}, {"gamma", 0.6}};
  cell["tools"][0]["change"]["replace"] = {{"kind", "constant"}, {"value_min", 5}};
  cell["tools"][0]["failure_crew"] = "fitters";
  cell["crews"].push_back({{"name", "fitters"}, {"members", 1}, {"rate_per_min", 2}});
  const auto run = run_with(cell, {});
  CHECK(mean_of(run, "crew/fitters/utilization") ==
        Approx(mean_of(run, "machine/lathe/state/failure_change")));
  CHECK(mean_of(run, "crew/crew/utilization") == Approx(mean_of(run, "machine/lathe/state/planned_change")));
  CHECK(mean_of(run, "crew/fitters/utilization") > 0.02);
}

TEST_CASE("guide pads wear in metres beside the insert, each at its own rate and price", "[long]") {
  const auto gallery =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/deep_hole_drilling.json");
  auto cell = tool_cell();
  cell["operations"][0]["process"] = gallery["process"];
  cell["inserts"][0]["edge_life"] = gallery["edge_life"];
  cell["simulation"]["horizon_min"] = 4e6;
  cell["tools"][0]["elements"] = {
      {{"element", "guide pads"}, {"change", {{"kind", "constant"}, {"value_min", 4}}}, {"price", 25}}};
  const auto scenario = load_with(cell, {});
  const auto plan = scenarios::plan(scenario, scenario.operations[0]);
  REQUIRE(plan.more_elements.size() == 1);
  const auto& pads = plan.more_elements[0];
  const auto run = run_with(cell, {});
  check_meets(run, "tool/tool/element/guide pads/use_min", pads.mean_min);
  check_meets(run, "tool/tool/edge_use_min", plan.edge->mean_min);
  check_meets(run, "cost/elements", 25 * plan.main_time_min / pads.mean_min);
  check_meets(run, "machine/lathe/availability", 1 / (1 + 4 / pads.mean_min));
  // Changed at their gamma-percent life: renewals at min(life, age).
  const auto early = run_with(cell, {"/tools/0/elements/0/gamma=0.8"});
  const models::LifeLaw law(pads.law, pads.mean_min, pads.cv);
  check_meets(early, "tool/tool/element/guide pads/use_min",
              law.restricted_mean(law.gamma_percent_life(0.8)));
}

TEST_CASE("a grinding wheel without inserts is dressed when its time has come", "[long]") {
  const auto gallery =
      scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/operations/elastic_grinding.json");
  auto cell = tool_cell();
  cell["operations"][0]["process"] = gallery["process"];
  cell["inserts"] = nlohmann::json::array();
  cell["tools"][0].erase("insert");
  cell["tools"][0]["elements"] = {
      {{"element", "wheel dressing"}, {"change", {{"kind", "constant"}, {"value_min", 3}}}}};
  const auto scenario = load_with(cell, {});
  const auto plan = scenarios::plan(scenario, scenario.operations[0]);
  const auto run = run_with(cell, {});
  check_meets(run, "machine/lathe/availability", 1 / (1 + 3 / plan.more_elements[0].mean_min));
  check_meets(run, "tool/tool/element/wheel dressing/per_100_parts",
              100 * plan.main_time_min / plan.more_elements[0].mean_min);
}

TEST_CASE("the tool galleries conserve edges, copies and time, on any number of threads", "[threads]") {
  for (const char* name :
       {"tools-face-mill", "tools-unattended", "tools-drills", "tools-elements", "tools-certified-inserts"}) {
    INFO(name);
    const auto text =
        scenarios::read_json_file(std::string(VERSTAT_SOURCE_DIR "/scenarios/gallery/") + name + ".json");
    const auto scenario = load_with(text, {"/simulation/horizon_min=30000", "/simulation/replications=3"});
    shop::Shop shop(scenario, 0);
    (void)shop.run();
    CHECK(shop.audit() == std::vector<std::string>());
    CHECK(shop::run_scenario(scenario, 1).values == shop::run_scenario(scenario, 3).values);
  }
}

namespace {

// One random tool room, run once.
void conserve_all() {
  auto cell = tool_cell();
  const auto chance = [](int percent) { return *rc::gen::inRange(0, 100) < percent; };
  auto& tool = cell["tools"][0];
  auto& insert = cell["inserts"][0];
  cell["simulation"]["horizon_min"] = 3000;
  cell["simulation"]["warmup_min"] = chance(50) ? 500 : 0;
  cell["simulation"]["replications"] = 1;
  cell["simulation"]["seed"] = std::to_string(*rc::gen::inRange(0, 1000000));
  cell["machines"][0]["count"] = *rc::gen::inRange(1, 4);
  insert["edge_life"]["law"] = chance(50) ? "weibull" : "normal";
  insert["edge_life"]["cv"] = 0.3;
  insert["edges"] = *rc::gen::inRange(1, 5);
  insert["reserve_ok_probability"] = 0.6;
  insert["single_edge_probability"] = 0.2;
  if (chance(50))
    insert["crib"] = {{"stock", *rc::gen::inRange(0, 9)},
                      {"reorder_point", *rc::gen::inRange(0, 5)},
                      {"order_quantity", *rc::gen::inRange(1, 6)},
                      {"lead_time", {{"kind", "exponential"}, {"rate_per_min", 0.01}}}};
  const int teeth = chance(50) ? *rc::gen::inRange(2, 7) : 1;
  tool["teeth"] = teeth;
  if (teeth > 1 || chance(30)) {
    tool["strategy"] = {{"kind", "replace_at_failed_teeth"},
                        {"failed_teeth", *rc::gen::inRange(1, teeth + 1)},
                        {"load_sharing", chance(50) ? "local" : "global"},
                        {"reduce_feed", chance(30)},
                        {"replace", chance(50) ? "failed" : "failed_and_older_than"}};
    if (chance(50)) tool["strategy"]["gamma"] = 0.7;
  } else if (chance(50)) {
    tool["strategy"] = {{"kind", "condition_based"},
                        {"every_min", 7},
                        {"sign", {{"kind", "share_of_life"}, {"share", 0.7}}},
                        {"false_alarm_probability", 0.1},
                        {"inspection_min", 0.5}};
  } else {
    tool["strategy"] = {{"kind", "age"}, {"gamma", 0.6}};
  }
  tool["copies"] = *rc::gen::inRange(1, 4);
  tool["shared"] = chance(30);
  if (chance(30)) tool["presetting"] = {{"time", {{"kind", "constant"}, {"value_min", 12}}}};
  if (teeth == 1 && chance(40))
    tool["regrind"] = {{"time", {{"kind", "constant"}, {"value_min", 30}}},
                       {"max_regrinds", *rc::gen::inRange(1, 4)},
                       {"life_factor", 0.9}};
  tool["change"]["replace"]["value_min"] = *rc::gen::inRange(0, 15);
  tool["change"]["swap"]["value_min"] = *rc::gen::inRange(0, 3);
  cell["crews"][0]["rate_per_min"] = 0.5;

  const auto scenario = scenarios::load(cell);
  shop::Shop audited(scenario, 0);
  (void)audited.run();
  const auto broken = audited.audit();
  if (!broken.empty()) RC_FAIL(broken.front());
  const auto run = shop::run_scenario(scenario, 1);
  const auto value = [&](const std::string& kpi) {
    const auto k = run.index_of(kpi);
    RC_ASSERT(k.has_value());
    return run.values[0][*k].value_or(0);
  };
  RC_ASSERT(value("tool/tool/edges/at_start") + value("tool/tool/edges/fitted") +
                value("tool/tool/edges/reground") ==
            value("tool/tool/edges/used") + value("tool/tool/edges/discarded") +
                value("tool/tool/edges/at_end"));
  if (insert.contains("crib")) {
    RC_ASSERT(value("insert/insert/crib/stock_at_start") + value("insert/insert/crib/delivered") ==
              value("insert/insert/crib/issued") + value("insert/insert/crib/stock_at_end"));
    // What was handed out is fitted, but for what waits for hands.
    RC_ASSERT(std::abs(value("insert/insert/crib/issued") - value("insert/insert/consumption")) <=
              3.0 * teeth * 9);
  }
  double states = 0;
  double tool_states = 0;
  double money = 0;
  for (std::size_t k = 0; k < run.kpis.size(); ++k) {
    const std::string& name = run.kpis[k].name;
    const double x = run.values[0][k].value_or(0);
    RC_ASSERT(std::isfinite(x));
    if (name.starts_with("tool/tool/state/")) tool_states += x;
    if (name.starts_with("machine/lathe/state/") || name.starts_with("machine/lathe 1/state/")) states += x;
    if (name.starts_with("cost/")) money += x;
  }
  RC_ASSERT(std::abs(states - 1) < 1e-9);
  RC_ASSERT(std::abs(tool_states - 1) < 1e-9);
  RC_ASSERT(money == value("cost_per_part"));
  RC_ASSERT(value("crew/crew/utilization") <= 1 + 1e-9);
}

}  // namespace

TEST_CASE("edges, inserts, time and money are conserved in random tool rooms") {
  property([] {
    for (int scenario = 0; scenario < 20; ++scenario) conserve_all();
  });
}
