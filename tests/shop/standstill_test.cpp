// Machines that block each other for good are found when it happens, and no others.
#include "tests/shop/small_shop.h"

using namespace verstat;
using namespace verstat::test;

namespace {

json machine(const std::string& name, int queue) {
  return {{"name", name}, {"queue_capacity", queue}};
}
json operation(const std::string& name, const std::string& on, double mean_min) {
  return {{"name", name}, {"machine", on}, {"process", duration_process(exponential(mean_min))}};
}
json part(const std::string& name, const json& route, double every_min) {
  return {{"name", name}, {"supply", arrivals(exponential(every_min))}, {"route", route}, {"store", "out"}};
}

// One part goes from the lathe to the mill, the other from the mill to the lathe.
json crossing(int queue) {
  return {{"name", "crossing"},
          {"simulation", {{"horizon_min", 50'000}, {"replications", 4}, {"seed", "3"}}},
          {"machines", {machine("lathe", queue), machine("mill", queue)}},
          {"operations",
           {operation("turn a", "lathe", 2), operation("mill a", "mill", 2), operation("mill b", "mill", 2),
            operation("turn b", "lathe", 2)}},
          {"stores", {{{"name", "out"}}}},
          {"parts", {part("a", {"turn a", "mill a"}, 10), part("b", {"mill b", "turn b"}, 10)}}};
}

}  // namespace

TEST_CASE("two machines that hold parts for each other stand for good", "[shop][standstill]") {
  const auto dead = run(crossing(0));
  REQUIRE(dead.standstills.size() == 4);
  for (std::size_t r = 0; r < 4; ++r) {
    INFO(dead.standstills[r]);
    CHECK(dead.standstills[r].find("replication " + std::to_string(r) + ", from ") == 0);
    CHECK(dead.standstills[r].find(R"("lathe" holds "a" for "mill")") != std::string::npos);
    CHECK(dead.standstills[r].find(R"("mill" holds "b" for "lathe")") != std::string::npos);
    const double share = *dead.values[r][*dead.index_of("standstill_share")];
    CHECK(share > 0.5);
    for (const char* name : {"machine/lathe/state/blocked", "machine/mill/state/blocked"})
      CHECK(*dead.values[r][*dead.index_of(name)] >= share * (1 - 1e-12));
  }

  // A cap of one part of each kind and room for it: nothing can stand.
  json alive = crossing(1);
  for (json& p : alive["parts"]) p["release"] = {{"kind", "conwip"}, {"cap", 1}};
  const auto moving = run(alive);
  CHECK(moving.standstills.empty());
  CHECK(kpi(moving, "standstill_share").mean == 0);
}

TEST_CASE("covers that fill their store keep the bodies out of the machine that makes both",
          "[shop][standstill]") {
  // Pumps are assembled from one cover and one body; both come from the same centre.
  json shop = crossing(0);
  shop["machines"] = {{{"name", "centre"}}, {{"name", "bench"}}};
  shop["operations"] = {operation("cover", "centre", 1), operation("body", "centre", 1),
                        operation("assemble", "bench", 1)};
  shop["stores"] = {{{"name", "out"}}, {{"name", "covers"}, {"capacity", 5}}, {{"name", "bodies"}}};
  json cover = part("cover", {"cover"}, 4);
  cover["store"] = "covers";
  json body = part("body", {"body"}, 8);
  body["store"] = "bodies";
  shop["parts"] = {
      cover,
      body,
      {{"name", "pump"},
       {"supply", {{"kind", "always_available"}}},
       {"steps",
        {{{"name", "assemble"},
          {"operation", "assemble"},
          {"assembles", {{{"part", "cover"}, {"count", 1}}, {{"part", "body"}, {"count", 1}}}}}}},
       {"store", "out"}}};
  const auto dead = run(shop);
  REQUIRE(dead.standstills.size() == 4);
  CHECK(dead.standstills[0].find(R"("centre" holds "cover" for "covers")") != std::string::npos);
  // Covers let in only as fast as they are needed cannot fill the store.
  shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 1}};
  shop["parts"][0]["supply"]["time"] = exponential(16);
  shop["parts"][1]["supply"]["time"] = exponential(8);
  CHECK(run(shop).standstills.empty());
}

TEST_CASE("a line that blocks and fails all day is no standstill", "[shop][standstill]") {
  json line = crossing(0);
  line["parts"].erase(1);
  line["operations"].erase(3);
  line["operations"].erase(2);
  line["machines"][1]["failures"] = {{{"name", "f"},
                                      {"clock", "operating"},
                                      {"time_to_failure", exponential(50)},
                                      {"repair", exponential(50)},
                                      {"effect", "at_once"}}};
  line["parts"][0]["supply"] = always();
  const auto busy = run(line);
  CHECK(busy.standstills.empty());
  CHECK(*kpi(busy, "machine/lathe/state/blocked").mean > 0.5);
}

namespace {

// The lathe is attended by an operator who also mends; the setter changes over lathe and mill.
json two_trades(int operators) {
  json shop = crossing(5);
  for (json& m : shop["machines"]) {
    m.erase("queue_capacity");
    m["setup"] = {{"time", exponential(3)}, {"crew", "setters"}};
  }
  shop["machines"][0]["attendance"] = {{"crew", "operators"}, {"during", "always"}};
  shop["machines"][1]["failures"] = {{{"name", "f"},
                                      {"clock", "calendar"},
                                      {"time_to_failure", exponential(40)},
                                      {"repair", exponential(4)},
                                      {"crew", "operators"},
                                      {"effect", "at_once"}}};
  shop["crews"] = {{{"name", "operators"}, {"members", operators}}, {{"name", "setters"}, {"members", 1}}};
  return shop;
}

}  // namespace

TEST_CASE("machines that keep each other's people stand for good", "[shop][standstill]") {
  const auto dead = run(two_trades(1));
  REQUIRE(dead.standstills.size() == 4);
  INFO(dead.standstills[0]);
  CHECK(dead.standstills[0].find(R"("lathe" keeps one of "operators" and waits for "setters")") !=
        std::string::npos);
  CHECK(dead.standstills[0].find(R"("mill" keeps one of "setters" and waits for "operators")") !=
        std::string::npos);
  CHECK(*kpi(dead, "machine/lathe/state/waiting_crew").mean > 0.5);
  const auto moving = run(two_trades(2));
  CHECK(moving.standstills.empty());
  CHECK(*kpi(moving, "parts_good").mean > 9000);
}

TEST_CASE("whoever is at the machine mends it, nobody waits for himself", "[shop][standstill]") {
  json shop = small_shop(always(), constant(6));
  shop["machines"][0]["loading"] = constant(4);
  shop["machines"][0]["attendance"] = {{"crew", "operator"}, {"during", "loading"}};
  shop["machines"][0]["failures"] = {{{"name", "f"},
                                      {"clock", "calendar"},
                                      {"time_to_failure", exponential(100)},
                                      {"repair", constant(10)},
                                      {"crew", "operator"},
                                      {"effect", "at_once"}}};
  shop["crews"] = {{{"name", "operator"}, {"members", 1}}};
  const auto result = run(shop);
  // On the calendar a failure comes 100 min after the last repair: ten of 110 min are lost.
  CHECK(*kpi(result, "machine/m/state/repair").mean == Approx(10.0 / 110).epsilon(0.03));
  CHECK(*kpi(result, "machine/m/state/waiting_repair").mean == 0);
  CHECK(*kpi(result, "throughput_per_h").mean == Approx(6.0 * 100 / 110).epsilon(0.01));
}
