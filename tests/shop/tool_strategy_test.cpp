// Condition-based and opportunistic changes against quadrature and brute force; sorted and treated inserts.
#include "models/inspection/k119_cutter_certification.h"
#include "models/math/normal.h"
#include "sim/kernel/random_stream.h"
#include "sim/shop/strategy.h"
#include "tests/shop/tool_cell.h"

using namespace verstat;
using namespace verstat::test;

TEST_CASE("condition-based changes: use and failures are those of the delay-time integral", "[long]") {
  // An edge of life X shows its wear from share * X on; looks at multiples of the interval notice it with
  // probability p, so it fails with (1-p)^n, n the looks between the first sign and the failure.
  struct Case {
    double share;
    double every_min;
    double p;
    double cv;
  };
  for (const Case& c : {Case{0.6, 8, 0.7, 0.5}, Case{0.8, 14, 1, 0.3}, Case{0.5, 20, 0.4, 0.7}}) {
    INFO("share " << c.share << " every " << c.every_min << " p " << c.p);
    const models::LifeLaw law(models::LifeLawKind::weibull, cell_life_min, c.cv);
    constexpr int points = 200'000;
    double use_min = 0;
    double failing = 0;
    for (int i = 0; i < points; ++i) {
      const double life = law.quantile((i + 0.5) / points);
      double unnoticed = 1;
      for (double look = std::ceil(c.share * life / c.every_min) * c.every_min; look < life;
           look += c.every_min) {
        if (look == 0) continue;
        use_min += unnoticed * c.p * look / points;
        unnoticed *= 1 - c.p;
      }
      use_min += unnoticed * life / points;
      failing += unnoticed / points;
    }
    const auto run =
        run_cell({"/inserts/0/edge_life/law=weibull", fmt::format("/inserts/0/edge_life/cv={}", c.cv),
                  fmt::format(R"(/tools/0/strategy={{"kind":"condition_based","every_min":{},)"
                              R"("sign":{{"kind":"share_of_life","share":{}}},"detection_probability":{}}})",
                              c.every_min, c.share, c.p)});
    check_meets(run, "tool/tool/edge_use_min", use_min);
    check_meets(run, "tool/tool/failure_share", failing);
    CHECK(mean_of(run, "tool/tool/false_alarms") == 0);
    CHECK(mean_of(run, "tool/tool/worn_found") == mean_of(run, "tool/tool/planned_changes"));
  }
}

TEST_CASE("looking after every N parts, with false alarms and time: brute force part by part") {
  constexpr int every = 2;
  constexpr double share = 0.6, p = 0.8, alarm = 0.05, look_min = 1.5;
  const models::LifeLaw law(models::LifeLawKind::weibull, cell_life_min, 0.5);
  sim::RandomStream lives(5, "brute force", "lives");
  sim::RandomStream looks(5, "brute force", "looks");
  double life = law.quantile(lives.uniform());
  double wear = 0;
  double alarms = 0, found = 0, failures = 0, time_min = 0;
  int since = 0;
  const auto renew = [&] {
    life = law.quantile(lives.uniform());
    wear = 0;
    since = 0;
  };
  constexpr int parts = 4'000'000;
  for (int part = 0; part < parts; ++part) {
    if (since >= every) {
      since = 0;
      time_min += look_min;
      const bool worn = wear >= share * life;
      if (looks.uniform() < (worn ? p : alarm)) {
        ++(worn ? found : alarms);
        renew();
      }
    }
    double left = cell_part_min;
    while (life - wear < left) {
      left -= life - wear;
      ++failures;
      renew();
    }
    wear += left;
    time_min += cell_part_min;
    ++since;
  }
  const auto run = run_cell(
      {"/inserts/0/edge_life/law=weibull", "/inserts/0/edge_life/cv=0.5",
       fmt::format(R"(/tools/0/strategy={{"kind":"condition_based","every_parts":{},"inspection_min":{},)"
                   R"("sign":{{"kind":"share_of_life","share":{}}},"detection_probability":{},)"
                   R"("false_alarm_probability":{}}})",
                   every, look_min, share, p, alarm)});
  const double window_min = counted_min(tool_cell());
  check_meets(run, "tool/tool/failures", failures / time_min * window_min);
  check_meets(run, "tool/tool/worn_found", found / time_min * window_min);
  check_meets(run, "tool/tool/false_alarms", alarms / time_min * window_min, 0.03);
  check_meets(run, "throughput_per_h", 60 * parts / time_min);
}

TEST_CASE("the sign of force growth is the flank wear at which K106 gives the factor") {
  // Flat rake: P_y grows by 15 per mm of flank wear, so 2.5 times at 0.1 mm.
  scenarios::ForceGrowth flat{.factor = 2.5, .wear_limit_mm = 0.15};
  CHECK(shop::share_of_life_shown(flat) == Approx(0.1 / 0.15));
  scenarios::ForceGrowth round{.factor = 4, .wear_limit_mm = 0.15, .cylindrical_rake = true};
  CHECK(shop::share_of_life_shown(round) == Approx(1));
}

TEST_CASE("opportunistic changes: brute force over the stops of two tools") {
  const double window = 0.4;
  const models::LifeLaw unit(models::LifeLawKind::weibull, 1, 0.4);
  const double limit = unit.gamma_percent_life(0.5) * cell_life_min;
  // Two operations, 10 and 15 min, with a tool each.
  struct Edge {
    double part_min;
    double life = 0;
    double wear = 0;
    double changes = 0;
    double joined = 0;
  };
  Edge edges[2] = {{.part_min = cell_part_min}, {.part_min = 1.5 * cell_part_min}};
  sim::RandomStream lives(3, "brute force", "two tools");
  const auto renew = [&](Edge& edge) {
    edge.life = unit.quantile(lives.uniform()) * cell_life_min;
    edge.wear = 0;
    ++edge.changes;
  };
  for (Edge& edge : edges) renew(edge);
  constexpr int parts = 2'000'000;
  for (int part = 0; part < parts; ++part)
    for (int k = 0; k < 2; ++k) {
      Edge& edge = edges[k];
      Edge& other = edges[1 - k];
      double left = edge.part_min;
      for (;;) {
        const double to_stop = std::max(0.0, std::min(edge.life, limit) - edge.wear);
        if (to_stop >= left) break;
        left -= to_stop;
        renew(edge);
        if (other.wear >= (1 - window) * limit) {
          renew(other);
          ++other.joined;
        }
      }
      edge.wear += left;
    }
  auto cell = tool_cell();
  cell["inserts"][0]["edge_life"]["law"] = "weibull";
  cell["inserts"][0]["edge_life"]["cv"] = 0.4;
  cell["tools"][0]["strategy"] = {{"kind", "opportunistic"}, {"gamma", 0.5}, {"window", window}};
  cell["tools"].push_back(cell["tools"][0]);
  cell["tools"][1]["name"] = "second";
  cell["operations"].push_back(cell["operations"][0]);
  cell["operations"][1]["name"] = "turn again";
  cell["operations"][1]["tool"] = "second";
  cell["operations"][1]["process"]["length_mm"] = 1500;
  cell["parts"][0]["route"] = {"turn", "turn again"};
  const auto run = run_with(cell, {});
  const double made = mean_of(run, "parts_good");
  for (int k = 0; k < 2; ++k) {
    const std::string tool = k == 0 ? "tool/tool/" : "tool/second/";
    const double changes = mean_of(run, tool + "planned_changes") + mean_of(run, tool + "failures");
    CHECK(changes / made == Approx(edges[k].changes / parts).epsilon(0.01));
    check_meets(run, tool + "joined_changes", edges[k].joined / parts * made, 0.02);
  }
  // A window of nothing is age replacement.
  auto aged = cell;
  for (int k = 0; k < 2; ++k) {
    cell["tools"][k]["strategy"]["window"] = 0;
    aged["tools"][k]["strategy"] = {{"kind", "age"}, {"gamma", 0.5}};
  }
  CHECK(mean_of(run_with(cell, {}), "throughput_per_h") ==
        Approx(mean_of(run_with(aged, {}), "throughput_per_h")).epsilon(1e-9));
}

TEST_CASE("edges changed in one stop share its time") {
  // Twins that wear alike and never fail on their own are always changed together: one stop, not two.
  auto cell = tool_cell();
  cell["inserts"][0]["edge_life"]["law"] = "weibull";
  cell["inserts"][0]["edge_life"]["cv"] = 0.05;
  cell["tools"][0]["strategy"] = {{"kind", "opportunistic"}, {"gamma", 0.99}, {"window", 0.5}};
  cell["tools"][0]["change"]["stop_min"] = 7;
  cell["tools"].push_back(cell["tools"][0]);
  cell["tools"][1]["name"] = "second";
  cell["operations"].push_back(cell["operations"][0]);
  cell["operations"][1]["name"] = "turn again";
  cell["operations"][1]["tool"] = "second";
  cell["parts"][0]["route"] = {"turn", "turn again"};
  const auto joined = run_with(cell, {});
  const double stops_min = mean_of(joined, "machine/lathe/state/planned_change") * counted_min(cell) +
                           mean_of(joined, "machine/lathe/state/failure_change") * counted_min(cell);
  const double stops = mean_of(joined, "tool/tool/planned_changes") + mean_of(joined, "tool/tool/failures") +
                       mean_of(joined, "tool/second/planned_changes") +
                       mean_of(joined, "tool/second/failures") - mean_of(joined, "tool/tool/joined_changes") -
                       mean_of(joined, "tool/second/joined_changes");
  CHECK(stops_min == Approx(7 * stops).epsilon(0.001));
  CHECK(mean_of(joined, "tool/second/joined_changes") > 0.4 * mean_of(joined, "tool/second/planned_changes"));
}

TEST_CASE("a stop of the machine for another reason is used too") {
  // The machine stops after every third part; an edge in its window, here the whole period, is changed then.
  auto cell = tool_cell();
  cell["inserts"][0]["edge_life"]["law"] = "weibull";
  cell["inserts"][0]["edge_life"]["cv"] = 0.5;
  cell["tools"][0]["strategy"] = {{"kind", "opportunistic"}, {"gamma", 0.2}, {"window", 1}};
  cell["machines"][0]["maintenance"] = {{{"name", "chips"},
                                         {"clock", "parts"},
                                         {"interval", 3},
                                         {"duration", {{"kind", "constant"}, {"value_min", 2}}}}};
  const auto run = run_with(cell, {});
  // Every third part a renewal, early failures in between: H(30 min) by the renewal function.
  const models::LifeLaw law(models::LifeLawKind::weibull, cell_life_min, 0.5);
  const double cycles = counted_min(cell) / (3 * cell_part_min + 2);
  check_meets(run, "tool/tool/failures", cycles * law.renewal_function(3 * cell_part_min));
  CHECK(mean_of(run, "tool/tool/joined_changes") == Approx(cycles).epsilon(0.001));
  CHECK(mean_of(run, "tool/tool/joined_changes") == mean_of(run, "tool/tool/planned_changes"));
}

TEST_CASE("a machine that fails while an edge is changed is repaired when the change is done") {
  // Edges are changed whenever the machine stops for chips; it fails by the calendar, often during a change
  // of 30 min. The fitter is busy with the changes alone and never stands by while others repair.
  auto cell = tool_cell();
  cell["simulation"]["replications"] = 2;
  cell["inserts"][0]["edge_life"]["law"] = "weibull";
  cell["inserts"][0]["edge_life"]["cv"] = 0.05;
  cell["tools"][0]["strategy"] = {{"kind", "opportunistic"}, {"gamma", 0.99}, {"window", 0.9}};
  for (const char* how : {"index", "replace"}) cell["tools"][0]["change"][how]["value_min"] = 30;
  cell["crews"].push_back({{"name", "menders"}, {"members", 1}});
  cell["machines"][0]["maintenance"] = {{{"name", "chips"},
                                         {"clock", "parts"},
                                         {"interval", 2},
                                         {"duration", {{"kind", "constant"}, {"value_min", 2}}}}};
  cell["machines"][0]["failures"] = {{{"name", "belt"},
                                      {"clock", "calendar"},
                                      {"time_to_failure", {{"kind", "exponential"}, {"rate_per_min", 0.01}}},
                                      {"repair", {{"kind", "constant"}, {"value_min", 50}}},
                                      {"crew", "menders"}}};
  const auto run = run_with(cell, {});
  const double changes = mean_of(run, "tool/tool/planned_changes") + mean_of(run, "tool/tool/failures");
  CHECK(mean_of(run, "machine/lathe/failures/belt") > 1000);
  CHECK(mean_of(run, "tool/tool/joined_changes") > 1000);
  CHECK(mean_of(run, "crew/crew/utilization") * counted_min(cell) == Approx(30 * changes).epsilon(0.001));
  CHECK(mean_of(run, "crew/menders/utilization") * counted_min(cell) ==
        Approx(50 * mean_of(run, "machine/lathe/failures/belt")).epsilon(0.002));
}

TEST_CASE("inserts treated by magnetic pulses are the treated inserts, bit for bit") {
  const auto plain = scenarios::read_json_file(VERSTAT_SOURCE_DIR "/scenarios/gallery/heavy-lathe.json");
  const auto prepared = load_with(
      plain, {R"(/inserts/0/preparation={"kind":"insert_preparation","mean_life_min":60,"life_cv":0.7,)"
              R"("treatment":"magnetic_pulse","life_factor":1,"pulse_life_cv":0.4})",
              "/simulation/horizon_min=30000"});
  const auto stated = load_with(plain, {"/inserts/0/edge_life/law=normal", "/inserts/0/edge_life/cv=0.4",
                                        "/simulation/horizon_min=30000"});
  CHECK(shop::run_scenario(prepared, 2).values == shop::run_scenario(stated, 2).values);
}

TEST_CASE("sorted inserts live as K119 says and cost what the rejected ones add") {
  const auto run =
      run_cell({"/inserts/0/edge_life/law=weibull", "/inserts/0/edge_life/cv=0.5", "/inserts/0/edges=4",
                R"(/inserts/0/preparation={"kind":"insert_preparation","mean_life_min":60,"life_cv":0.5,)"
                R"("screening":"strength_test","reject_fraction":0.3,"life_correlation":0.67,)"
                R"("edges_used_by_test":1,"test_cost":2,"salvage_value":1,"edges_per_insert":4})"});
  const auto law = models::k119::weibull_from_mean_cv({.mean_life_min = 60, .life_cv = 0.5});
  const auto accepted = models::k119::screened_life(
      {.shape = law.shape, .scale_min = law.scale_min, .rho = 0.67, .reject_fraction = 0.3});
  check_meets(run, "tool/tool/edge_use_min", accepted.mean_accepted_min);
  // Three edges of an insert are left; its price carries the test and 0.3 / 0.7 rejected ones.
  const double price = (10 + 2 - 0.3 * 1) / 0.7;
  check_meets(run, "cost/inserts", price / 3 * cell_part_min / accepted.mean_accepted_min);
}

TEST_CASE("certified lots: mean life of the accepted is the selection integral", "[long]") {
  // With normal scores, E[exp(sz - s^2/2) | x > c] = Phi(rho s - c) / (1 - p).
  constexpr double s = 0.4, p = 0.25, within = 0.35, correlation = 0.95;
  constexpr int n = 5;
  const double rho = correlation * s / std::sqrt(s * s + within * within / n);
  const double cut = models::normal_quantile(p);
  const double accepted = models::normal_cdf(rho * s - cut) / (1 - p);
  const double rejected = models::normal_cdf(cut - rho * s) / p;
  const std::vector<std::string> lots = {
      fmt::format(R"(/inserts/0/lots={{"lot_size":10,"ln_sd_between":{},"ln_sd_within":{},"sample_size":{},)"
                  R"("test_correlation":{},"reject_fraction":{},"test_cost":3}})",
                  s, within, n, correlation, p),
      "/simulation/horizon_min=1600000"};
  const auto sent_back = run_cell(lots);
  check_meets(sent_back, "tool/tool/edge_use_min", cell_life_min * accepted, 0.015);
  CHECK(mean_of(sent_back, "insert/insert/lots/rejected") / mean_of(sent_back, "insert/insert/lots/tested") ==
        Approx(p).margin(0.0065));  // 72,000 lots: four standard errors
  // Insert, and the samples of 1/(1-p) lots per ten of them.
  const double per_insert = 10 + 3 * n / (10 * (1 - p));
  check_meets(sent_back, "cost/inserts", per_insert * cell_part_min / (cell_life_min * accepted), 0.015);

  auto treated = lots;
  treated.push_back("/inserts/0/lots/rejected=retreat");
  treated.push_back("/inserts/0/lots/retreat_life_factor=1.5");
  check_meets(run_cell(treated), "tool/tool/edge_use_min",
              cell_life_min * ((1 - p) * accepted + p * 1.5 * rejected), 0.015);
}
