// Parts on their way: queueing theory for queues, buffers, release, routes, transport and stores.
#include "tests/shop/small_shop.h"

using namespace verstat::test;

TEST_CASE("a group of machines is an M/M/c queue", "[shop][flow]") {
  // Erlang C for three machines at 80 %: P(wait) = 0.6472, Lq = 2.5888.
  json shop = small_shop(arrivals(exponential(1.25)), exponential(3));
  shop["machines"][0]["count"] = 3;
  const auto result = run(shop);
  check_truth(result, "queue/m/mean_length", 2.5888, 0.1);
  check_truth(result, "throughput_per_h", 48, 0.01);
  check_truth(result, "lead_time_min", 2.5888 * 1.25 + 3, 0.05);
  check_truth(result, "lead_time/queue_min", 2.5888 * 1.25, 0.1);
  check_truth(result, "work_in_process", 2.5888 + 2.4, 0.1);
  check_audit(shop);
}

TEST_CASE("lead times: the phases add up to the whole", "[shop][flow]") {
  json shop = small_shop(arrivals(exponential(2)), exponential(1.5));
  shop["machines"][0]["queue_capacity"] = 3;
  const auto result = run(shop);
  for (const auto& replication : result.values) {
    double sum = 0;
    for (const char* phase : {"release", "components", "queue", "machine", "blocked", "transport"})
      sum += *replication[*result.index_of("lead_time/" + std::string(phase) + "_min")];
    CHECK(sum == Approx(*replication[*result.index_of("lead_time_min")]).epsilon(1e-9));
  }
}

TEST_CASE("two machines with a buffer of b between them are an M/M/1/(b+3) queue", "[shop][flow][long]") {
  // Exponential times of the same mean, blocking after service: the second machine starves with probability
  // 1 / (b + 3); throughput (b + 2) / (b + 3).
  for (const int buffer : {0, 2}) {
    json shop = small_shop(always(), exponential(1));
    shop["machines"].push_back({{"name", "n"}, {"queue_capacity", buffer}});
    shop["operations"].push_back(
        {{"name", "q"}, {"machine", "n"}, {"process", duration_process(exponential(1))}});
    shop["parts"][0]["route"] = {"o", "q"};
    const auto result = run(shop);
    check_truth(result, "throughput_per_h", 60.0 * (buffer + 2) / (buffer + 3), 0.01);
    check_truth(result, "machine/m/state/blocked", 1.0 / (buffer + 3), 0.05);
    check_truth(result, "machine/n/state/idle", 1.0 / (buffer + 3), 0.05);
    check_audit(shop);
  }
}

TEST_CASE("CONWIP with n batches over two equal machines: mean-value analysis", "[shop][flow][long]") {
  for (const int cap : {1, 4}) {
    json shop = small_shop(always(), exponential(1));
    shop["machines"].push_back({{"name", "n"}});
    shop["operations"].push_back(
        {{"name", "q"}, {"machine", "n"}, {"process", duration_process(exponential(1))}});
    shop["parts"][0]["route"] = {"o", "q"};
    shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", cap}};
    const auto result = run(shop);
    check_truth(result, "throughput_per_h", 60.0 * cap / (cap + 1), 0.01);
    CHECK(mean(result, "work_in_process") == Approx(cap).epsilon(1e-9));
    check_audit(shop);
  }
}

TEST_CASE("a station threshold keeps its queue filled and no more", "[shop][flow]") {
  json shop = small_shop(always(), exponential(1));
  shop["parts"][0]["release"] = {{"kind", "station_threshold"}, {"machine", "m"}, {"queue", 2}};
  const auto result = run(shop);
  CHECK(mean(result, "queue/m/mean_length") == Approx(2).margin(1e-3));
  check_truth(result, "machine/m/state/working", 1, 0.001);
}

TEST_CASE("parts that come back with probability p make a queue with more load", "[shop][flow]") {
  // Jackson: load = rate x service / (1 - p) = 0.5 / 0.75; number in system = load / (1 - load).
  json shop = small_shop(arrivals(exponential(2)), exponential(1));
  shop["parts"][0].erase("route");
  shop["parts"][0]["steps"] = {
      {{"name", "work"},
       {"operation", "o"},
       {"next", {{{"to", ""}, {"probability", 0.75}}, {{"to", "work"}, {"probability", 0.25}}}}}};
  const auto result = run(shop);
  const double load = 0.5 / 0.75;
  check_truth(result, "work_in_process", load / (1 - load), 0.1);
  check_truth(result, "machine/m/state/working", load, 0.02);
  check_audit(shop);
}

TEST_CASE("alternative machines share the work", "[shop][flow]") {
  json shop = small_shop(arrivals(exponential(1)), exponential(1.6));
  shop["machines"].push_back({{"name", "n"}, {"capabilities", {"milling"}}});
  shop["machines"][0]["capabilities"] = {"milling", "drilling"};
  shop["operations"][0].erase("machine");
  SECTION("in turn: two queues with Erlang-2 arrivals") {
    shop["operations"][0]["machines"] = {"m", "n"};
    shop["operations"][0]["choice"] = "in_turn";
    // E2/M/1: sigma solves sigma = (a / (a + 1/s (1 - sigma)))^2 with a = 1, s = 1.6; W = sigma s / (1 -
    // sigma).
    double sigma = 0.5;
    for (int k = 0; k < 200; ++k) sigma = std::pow(1 / (1 + (1 - sigma) / 1.6), 2);
    const auto result = run(shop);
    check_truth(result, "lead_time/queue_min", sigma * 1.6 / (1 - sigma), 0.1);
  }
  SECTION("shortest queue: better than in turn, not better than one queue") {
    shop["operations"][0]["capability"] = "milling";
    const auto result = run(shop);
    // M/M/2 at 80 %: Wq = 1.6 x 0.64 / 0.36.
    const double one_queue = 1.6 * 0.64 / 0.36;
    CHECK(mean(result, "lead_time/queue_min") > one_queue);
    CHECK(mean(result, "lead_time/queue_min") < 1.35 * one_queue);
    check_audit(shop);
  }
}

TEST_CASE("batches: set-up once, parts one after the other", "[shop][flow]") {
  json shop = small_shop(always(), constant(2));
  shop["parts"][0]["batch_size"] = 5;
  shop["machines"][0]["loading"] = constant(0.5);
  shop["machines"][0]["unloading"] = constant(0.25);
  const auto result = run(shop);
  CHECK(mean(result, "throughput_per_h") == Approx(60 / 2.75).epsilon(1e-3));
  CHECK(mean(result, "lead_time_min") == Approx(5 * 2.75));
  CHECK(mean(result, "machine/m/state/loading") == Approx(0.75 / 2.75).epsilon(1e-3));
}

TEST_CASE("set-ups follow the matrix, least_setup avoids them", "[shop][flow]") {
  json shop = small_shop(arrivals(constant(10)), constant(2));
  shop["operations"].push_back({{"name", "q"}, {"machine", "m"}, {"process", duration_process(constant(2))}});
  shop["parts"].push_back(
      {{"name", "r"}, {"supply", arrivals(constant(10))}, {"route", {"q"}}, {"store", "s"}});
  shop["machines"][0]["setup"] = {{"time", constant(9)},
                                  {"times",
                                   {{{"from", "o"}, {"to", "q"}, {"time", constant(1)}},
                                    {{"from", "*"}, {"to", "o"}, {"time", constant(2)}}}}};
  SECTION("first come, first served: two set-ups per pair") {
    const auto result = run(shop);
    CHECK(mean(result, "machine/m/state/setup") == Approx(0.3).epsilon(1e-3));
    CHECK(mean(result, "machine/m/setups") == Approx(20'000).epsilon(1e-3));
  }
  SECTION("an overloaded machine saves set-ups by taking its family first") {
    shop["parts"][0]["supply"] = arrivals(constant(5));
    shop["parts"][1]["supply"] = arrivals(constant(5));
    shop["machines"][0]["dispatch"] = "least_setup";
    const auto result = run(shop);
    CHECK(mean(result, "throughput_per_h") == Approx(24).epsilon(1e-2));
    shop["machines"][0]["dispatch"] = "fifo";
    CHECK(mean(run(shop), "throughput_per_h") == Approx(60 * 2 / 7.0).epsilon(1e-2));
  }
}

TEST_CASE("shortest processing time first: Phipps", "[shop][flow]") {
  // Two kinds of parts, 1 min and 4 min, each with Poisson arrivals every 8 min: rho1 = 1/8, rho2 = 1/2.
  // Under SPT the short ones have priority (Cobham): W1 = W0 / (1 - rho1), W2 = W0 / ((1 - rho1) (1 - rho)).
  json shop = small_shop(arrivals(exponential(8)), constant(1));
  shop["operations"].push_back({{"name", "q"}, {"machine", "m"}, {"process", duration_process(constant(4))}});
  shop["parts"].push_back(
      {{"name", "r"}, {"supply", arrivals(exponential(8))}, {"route", {"q"}}, {"store", "s"}});
  shop["machines"][0]["dispatch"] = "spt";
  const double w0 = (1.0 / 8) * (1.0 + 16.0) / 2;
  const auto result = run(shop);
  check_truth(result, "part/p/lead_time_min", 1 + w0 / (1 - 0.125), 0.05);
  check_truth(result, "part/r/lead_time_min", 4 + w0 / ((1 - 0.125) * (1 - 0.625)), 0.05);
  SECTION("the same by priorities") {
    shop["machines"][0]["dispatch"] = "priority";
    shop["parts"][0]["priority"] = -1;
    const auto again = run(shop);
    CHECK(mean(again, "part/p/lead_time_min") == mean(result, "part/p/lead_time_min"));
  }
}

TEST_CASE("earliest due date and critical ratio: who is due first goes first", "[shop][flow]") {
  // An order for 4 min due late and one for 4 min due early come while the machine is busy.
  json shop = small_shop({{"kind", "orders"},
                          {"orders",
                           {{{"arrives_min", 0}, {"quantity", 1}, {"due_min", 4}},
                            {{"arrives_min", 1}, {"quantity", 1}, {"due_min", 20}},
                            {{"arrives_min", 2}, {"quantity", 1}, {"due_min", 8}}}}},
                         constant(4));
  shop["simulation"] = {{"horizon_min", 100}, {"replications", 1}};
  for (const char* rule : {"edd", "critical_ratio"}) {
    shop["machines"][0]["dispatch"] = rule;
    CHECK(mean(run(shop), "part/p/late_share") == 0);
  }
  shop["machines"][0]["dispatch"] = "fifo";
  const auto fifo = run(shop);
  CHECK(mean(fifo, "part/p/late_share") == Approx(1.0 / 3));
  CHECK(mean(fifo, "part/p/tardiness_min") == Approx(4.0 / 3));
}

TEST_CASE("assembly takes parts from stores, disassembly sets blanks free", "[shop][flow]") {
  json shop = small_shop(always(), constant(3));
  shop["machines"].push_back({{"name", "bench"}});
  shop["machines"].push_back({{"name", "saw"}});
  shop["operations"].push_back(
      {{"name", "assemble"}, {"machine", "bench"}, {"process", duration_process(constant(1))}});
  shop["operations"].push_back(
      {{"name", "saw up"}, {"machine", "saw"}, {"process", duration_process(constant(6))}});
  shop["stores"] = {{{"name", "s"}, {"capacity", 10}}, {{"name", "out"}}};
  // A bar is sawn into two blanks; a product is made of two finished parts.
  shop["parts"] = {
      {{"name", "bar"},
       {"supply", always()},
       {"store", "out"},
       {"steps", {{{"name", "saw"}, {"operation", "saw up"}, {"yields", {{{"part", "p"}, {"count", 2}}}}}}}},
      {{"name", "p"},
       {"supply", {{"kind", "orders"}, {"orders", {{{"arrives_min", 0}}}}}},
       {"route", {"o"}},
       {"store", "s"}},
      {{"name", "product"},
       {"supply", always()},
       {"store", "out"},
       {"steps",
        {{{"name", "join"}, {"operation", "assemble"}, {"assembles", {{{"part", "p"}, {"count", 2}}}}}}}}};
  shop["simulation"] = {{"horizon_min", 60'000}, {"warmup_min", 600}, {"replications", 1}};
  const auto result = run(shop);
  CHECK(mean(result, "part/product/throughput_per_h") == Approx(10).epsilon(1e-3));
  CHECK(mean(result, "part/p/throughput_per_h") == Approx(20).epsilon(1e-3));
  check_audit(shop);
}

TEST_CASE("carriers: a conveyor's capacity and a crane's round trip bound the flow", "[shop][flow]") {
  json shop = small_shop(always(), constant(1));
  shop["machines"].push_back({{"name", "n"}});
  shop["operations"].push_back({{"name", "q"}, {"machine", "n"}, {"process", duration_process(constant(1))}});
  shop["parts"][0]["route"] = {"o", "q"};
  SECTION("conveyor") {
    shop["transport"] = {{{"name", "belt"},
                          {"from", "m"},
                          {"carrier", {{"kind", "conveyor"}, {"capacity", 2}, {"time_min", 5}}}}};
    const auto result = run(shop);
    CHECK(mean(result, "throughput_per_h") == Approx(24).epsilon(1e-3));
    CHECK(mean(result, "lead_time/transport_min") == Approx(5));
  }
  SECTION("delay") {
    shop["transport"] = {
        {{"name", "boy"}, {"to", "n"}, {"carrier", {{"kind", "delay"}, {"time", constant(7)}}}}};
    CHECK(mean(run(shop), "lead_time_min") == Approx(9));
  }
  SECTION("crane: 30 m there and 30 m back at 20 m/min, half a minute at each end") {
    shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 20}};
    shop["transport"] = {{{"name", "crane"},
                          {"to", "n"},
                          {"carrier",
                           {{"kind", "vehicles"},
                            {"count", 1},
                            {"speed_m_min", 20},
                            {"pick_up_min", 0.5},
                            {"set_down_min", 0.5}}}}};
    shop["layout"] = {{{"from", "m"}, {"to", "door"}, {"length_m", 10}},
                      {{"from", "door"}, {"to", "n"}, {"length_m", 20}}};
    const auto result = run(shop);
    CHECK(mean(result, "throughput_per_h") == Approx(15).epsilon(1e-3));
    CHECK(mean(result, "transport/crane/utilization") == Approx(1).epsilon(1e-3));
    check_audit(shop);
    shop["layout"][1]["to"] = "elsewhere";
    CHECK_THROWS_WITH(run(shop), Catch::Contains("\"crane\"") &&
                                     Catch::Contains("\"n\", which the layout does not mention"));
  }
}

TEST_CASE("arrivals by the week, orders from a list", "[shop][flow]") {
  json shop = small_shop(
      {{"kind", "weekly_profile"},
       {"rates",
        {{{"from_h", 6}, {"to_h", 14}, {"per_h", 4}}, {{"from_h", 30}, {"to_h", 38}, {"per_h", 2}}}}},
      constant(5));
  shop["simulation"] = {{"horizon_min", 504'000}, {"replications", 10}};
  check_truth(run(shop), "part/p/good", 50 * 48, 0.05);
}

TEST_CASE("stores: customers take parts, a full store blocks", "[shop][flow]") {
  // Production by an exponential machine into a store of s parts, Poisson customers: level is an M/M/1/(s+1)
  // queue seen from the other side (the machine holds one finished part when blocked).
  json shop = small_shop(always(), exponential(1));
  shop["stores"][0] = {{"name", "s"}, {"capacity", 4}, {"demand", exponential(1)}};
  // Production 1/min, demand 1/min, states 0..5 (five: full and blocked): the store is empty with 1/6.
  const auto result = run(shop);
  check_truth(result, "store/s/fill_rate", 1 - 1.0 / 6, 0.02);
  check_truth(result, "machine/m/state/blocked", 1.0 / 6, 0.05);
  check_audit(shop);
}

TEST_CASE("a slow machine starves the one behind it and blocks the one before it", "[shop]") {
  json shop = small_shop(always(), constant(1));
  shop["machines"] = {
      {{"name", "a"}}, {{"name", "slow"}, {"queue_capacity", 1}}, {{"name", "c"}, {"queue_capacity", 1}}};
  shop["operations"].clear();
  for (const auto& [name, time_min] : {std::pair{"a", 1.0}, {"slow", 4.0}, {"c", 1.0}})
    shop["operations"].push_back(
        {{"name", name}, {"machine", name}, {"process", duration_process(constant(time_min))}});
  shop["parts"][0]["route"] = {"a", "slow", "c"};
  const auto result = run(shop);
  CHECK(*kpi(result, "limits/a/blocked_by/slow").mean == Approx(0.75).epsilon(1e-3));
  CHECK(*kpi(result, "limits/c/starved_by/slow").mean == Approx(0.75).epsilon(1e-3));
  CHECK(*kpi(result, "limits/slow/starved_by/a").mean == Approx(0).margin(1e-3));
  CHECK(*kpi(result, "limits/slow/blocked_by/c").mean == 0);
  CHECK(*kpi(result, "limits/a/starved_by/(supply)").mean == 0);
}

// One machine, attended by one operator in shifts of eight hours from midnight, for a hundred days.
static json attended_by_day(const char* part_at_shift_end) {
  json shop = small_shop(always(), constant(50));
  shop["calendars"] = {
      {{"name", "day"},
       {"shifts",
        {{{"days", {"monday", "tuesday", "wednesday", "thursday", "friday", "saturday", "sunday"}},
          {"from_h", 0},
          {"to_h", 8}}}}}};
  shop["crews"] = {{{"name", "operator"}, {"calendar", "day"}, {"rate_per_min", 1}}};
  shop["machines"][0]["attendance"] = {{"crew", "operator"}, {"during", "always"}};
  shop["machines"][0]["calendar"] = "day";
  shop["machines"][0]["part_at_shift_end"] = part_at_shift_end;
  shop["simulation"]["horizon_min"] = 144'000;
  shop["simulation"]["warmup_min"] = 0;
  return shop;
}

TEST_CASE("crew states sum to the calendar time, jobs after the shift are overtime", "[shop]") {
  // One attended machine, parts of 50 min, shifts of eight hours from midnight, the last part is finished.
  const json shop = attended_by_day("finish");
  const auto result = run(shop);
  // Ten parts of 50 min a day: eight hours and twenty minutes.
  CHECK(*kpi(result, "crew/operator/state/working").mean == Approx(480.0 / 1440));
  CHECK(*kpi(result, "crew/operator/state/overtime").mean == Approx(20.0 / 1440));
  CHECK(*kpi(result, "crew/operator/state/free").mean == Approx(0).margin(1e-12));
  CHECK(*kpi(result, "crew/operator/state/off_shift").mean == Approx(940.0 / 1440));
}

TEST_CASE("who tends a part that waits for the morning is at home meanwhile", "[shop]") {
  // Parts of 50 min in shifts of eight hours that pause at the end: nine whole parts and one over two days.
  const json shop = attended_by_day("pause");
  const auto result = run(shop);
  CHECK(*kpi(result, "parts_good").mean == 960);
  CHECK(*kpi(result, "crew/operator/utilization").mean == Approx(1));
  CHECK(*kpi(result, "crew/operator/state/overtime").mean == Approx(0).margin(1e-12));
  CHECK(*kpi(result, "cost/labour").mean == Approx(50));
}
