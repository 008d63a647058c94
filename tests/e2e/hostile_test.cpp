// Scenarios that want too much end with one line, soon, in little memory: neither a hang nor the end of the
// machine.
#include <algorithm>
#include <chrono>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/e2e/command.h"

using nlohmann::json;
using verstat::test::Answer;
using verstat::test::read_file;
using verstat::test::Workspace;

namespace {

constexpr double patience_s = 20;

// A machine that takes blanks as fast as it can.
json plain_shop() {
  return json::parse(R"({
    "name": "hostile",
    "simulation": {"horizon_min": 100000, "replications": 1, "max_events": 1000000, "allow_overload": true},
    "machines": [{"name": "m"}],
    "operations": [{"name": "work", "machine": "m",
                    "process": {"kind": "duration", "time": {"kind": "constant", "value_min": 1}}}],
    "stores": [{"name": "out"}],
    "parts": [{"name": "p", "supply": {"kind": "always_available"}, "route": ["work"], "store": "out"}]})");
}

Answer run_within_limits(const std::string& file, const Workspace& w, const std::string& more = "") {
  const auto start = std::chrono::steady_clock::now();
  // 3 GiB of addresses: a shop that grows without end meets its own limit before this one.
  Answer a = verstat::test::call("run " + file + " --threads 2 --db " + w.file("none.db") + " " + more,
                                 "ulimit -v 3145728; timeout 20");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  CHECK(took.count() < patience_s);
  return a;
}

void check_refused(const json& shop, const std::string& says, const std::string& more = "") {
  const Workspace w;
  std::ofstream(w.file("shop.json")) << shop.dump();
  const Answer a = run_within_limits(w.file("shop.json"), w, more);
  INFO(says);
  CHECK(a.exit_code == 2);
  CHECK(a.out.empty());
  CHECK(a.err.starts_with("error: "));
  CHECK(std::count(a.err.begin(), a.err.end(), '\n') == 1);
  CHECK_THAT(a.err, Catch::Contains(says));
  CHECK_FALSE(std::filesystem::exists(w.file("none.db")));
}

json distribution(const char* kind, const char* member, double value) {
  return {{"kind", kind}, {member, value}};
}

}  // namespace

TEST_CASE("the plain shop behind the hostile ones runs") {
  const Workspace w;
  std::ofstream(w.file("shop.json")) << plain_shop().dump();
  CHECK(run_within_limits(w.file("shop.json"), w).exit_code == 0);
}

TEST_CASE("billions of machines, stops, vehicles, plans, steps, places") {
  json shop = plain_shop();
  shop["machines"][0]["count"] = 1'000'000'000;
  check_refused(shop, "/machines/0/count = 1000000000, allowed 1 <= count <= 10000");

  shop = plain_shop();
  for (int k = 0; k < 3; ++k) {
    const std::string name = "m" + std::to_string(k);
    shop["machines"][static_cast<std::size_t>(k)] = {{"name", name}, {"count", 10'000}};
  }
  shop["operations"][0].erase("machine");
  shop["operations"][0]["machines"] = {"m0", "m1", "m2"};
  check_refused(shop, "/machines/2/count = 10000, makes 30000 machines in all, the most is 20000");

  shop = plain_shop();
  shop["machines"][0]["count"] = 10'000;
  for (int k = 0; k < 30; ++k)
    shop["machines"][0]["failures"].push_back({{"name", "f" + std::to_string(k)},
                                               {"time_to_failure", distribution("constant", "value_min", 50)},
                                               {"repair", distribution("constant", "value_min", 1)}});
  check_refused(shop, "makes 300000 failure modes and maintenance jobs on all machines");

  shop = plain_shop();
  shop["operations"][0].erase("machine");
  shop["operations"][0]["capability"] = "any";
  for (std::size_t k = 0; k < 3000; ++k)
    shop["machines"][k] = {{"name", "m" + std::to_string(k)}, {"capabilities", {"any"}}};
  for (std::size_t k = 0; k < 3000; ++k) {
    shop["operations"][k] = shop["operations"][0];
    shop["operations"][k]["name"] = "o" + std::to_string(k);
  }
  check_refused(shop, "pairs of operation and machine group, the most is 50000");

  shop = plain_shop();
  shop["parts"][0]["route"] = std::vector<std::string>(1000, "work");
  for (std::size_t k = 1; k < 30; ++k) {
    shop["parts"][k] = shop["parts"][0];
    shop["parts"][k]["name"] = "p" + std::to_string(k);
  }
  check_refused(shop, "makes 21000 steps in all routes, the most is 20000");

  shop = plain_shop();
  for (std::size_t k = 0; k < 20'000; ++k)
    shop["layout"][k] = {{"from", "m"}, {"to", "place " + std::to_string(k)}, {"length_m", 1}};
  check_refused(shop, "is one place too many, the most is 1000");

  shop = plain_shop();
  for (std::size_t k = 0; k < 5; ++k)
    shop["transport"][k] = {{"name", "t" + std::to_string(k)},
                            {"carrier", {{"kind", "vehicles"}, {"count", 10'000}}}};
  check_refused(shop, "/transport/1/carrier/count = 10000, makes too many vehicles");
}

TEST_CASE("the largest shop that is allowed is built in bounded memory") {
  json shop = plain_shop();
  shop["machines"][0]["count"] = 10'000;
  shop["simulation"]["horizon_min"] = 5;
  const Workspace w;
  std::ofstream(w.file("shop.json")) << shop.dump();
  CHECK(run_within_limits(w.file("shop.json"), w, "--json").exit_code == 0);
}

TEST_CASE("durations next to nothing: the event budget") {
  json shop = plain_shop();
  shop["operations"][0]["process"]["time"]["value_min"] = 0;
  check_refused(shop, "must take at least 1e-6 min");
  shop["operations"][0]["process"]["time"]["value_min"] = 1e-6;
  check_refused(shop, "more than 1000000 events (/simulation/max_events)");

  shop = plain_shop();
  shop["machines"][0]["failures"] = {{{"name", "f"},
                                      {"time_to_failure", distribution("constant", "value_min", 1e-300)},
                                      {"repair", distribution("constant", "value_min", 0)}}};
  check_refused(shop, "/machines/0/failures/0/time_to_failure = mean 1e-300 min");

  shop = plain_shop();
  shop["machines"][0]["loading"] = distribution("constant", "value_min", 1e-300);
  shop["machines"][0]["maintenance"] = {{{"name", "f"},
                                         {"clock", "operating"},
                                         {"interval", 1e-9},
                                         {"duration", distribution("constant", "value_min", 0)}}};
  check_refused(shop, "t = 0, more than 1000000 events (/simulation/max_events)");
  // A clock that stands still is found out before a large budget is spent.
  shop["simulation"]["max_events"] = 10'000'000'000;
  check_refused(shop, "the clock stands still: 5000000 events at one instant");
}

TEST_CASE("customers and failures that come without end are refused before the run") {
  json shop = plain_shop();
  shop["stores"][0]["demand"] = distribution("constant", "value_min", 1e-300);
  check_refused(shop, "/stores/0/demand = mean 1e-300 min, must have a mean of at least 1e-6 min");
  // Within what is allowed, the budget counts them.
  shop["stores"][0]["demand"] = distribution("constant", "value_min", 1e-6);
  check_refused(shop, "more than 1000000 events (/simulation/max_events)");
}

TEST_CASE("arrivals faster than any machine: the memory budget") {
  json shop = plain_shop();
  shop["simulation"]["max_events"] = 1'000'000'000;
  shop["parts"][0]["supply"] = {{"kind", "interarrival"},
                                {"time", distribution("exponential", "rate_per_min", 1e6)}};
  check_refused(shop, "more than 1000000 batches wait in the shop, part \"p\" the last");

  shop["parts"][0]["supply"] = {{"kind", "weekly_profile"},
                                {"rates", {{{"from_h", 0}, {"to_h", 168}, {"per_h", 1e6}}}}};
  check_refused(shop, "more than 1000000 batches wait in the shop, part \"p\" the last");

  shop["parts"][0]["supply"] = {{"kind", "orders"}, {"orders", json::array()}};
  for (int k = 0; k < 1000; ++k)
    shop["parts"][0]["supply"]["orders"].push_back({{"arrives_min", 0}, {"quantity", 1'000'000}});
  shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 1}};
  check_refused(shop, "more than 1000000 batches wait in the shop, part \"p\" the last");

  shop = plain_shop();
  shop["parts"][0]["release"] = {{"kind", "conwip"}, {"cap", 1'000'000}};
  shop["parts"][1] = shop["parts"][0];
  shop["parts"][1]["name"] = "q";
  check_refused(shop, "more than 1000000 batches wait in the shop, part \"q\" the last");
}

TEST_CASE("blanks that set free each other multiply no further than can be counted") {
  json shop = plain_shop();
  for (std::size_t k = 0; k < 2; ++k) {
    const char* const other = k == 0 ? "p1" : "p0";
    shop["parts"][k] = {
        {"name", "p" + std::to_string(k)},
        {"supply", {{"kind", "always_available"}}},
        {"steps",
         {{{"name", "s"}, {"operation", "work"}, {"yields", {{{"part", other}, {"count", 1'000'000}}}}}}},
        {"store", "out"}};
  }
  shop["machines"][0]["count"] = 2;
  shop["simulation"]["horizon_min"] = 1e9;
  check_refused(shop, "events");
  shop["parts"][0]["batch_size"] = 100'000;
  shop["operations"][0]["process"]["time"]["value_min"] = 0.001;
  check_refused(shop, "a batch of 100000000000 pieces of part \"p1\", the most is 1000000000");
}

TEST_CASE("rework for ever") {
  json shop = plain_shop();
  shop["parts"][0].erase("route");
  shop["parts"][0]["steps"] = {
      {{"name", "s"},
       {"operation", "work"},
       {"next", {{{"to", "s"}, {"probability", 1 - 1e-12}}, {{"to", ""}, {"probability", 1e-12}}}}}};
  shop["operations"][0]["process"]["time"]["value_min"] = 1e-6;
  check_refused(shop, "more than 1000000 events");
  shop["parts"][0]["steps"][0]["next"] = {{{"to", "s"}, {"probability", 1}}};
  check_refused(shop, "every way leads back into the loop");
  shop["parts"][0]["steps"] = {
      {{"name", "s"}, {"operation", "work"}, {"rework", "s"}, {"rework_limit", 1000}}};
  shop["operations"][0]["quality"] = {{"scrap_probability", 1}};
  check_refused(shop, "more than 1000000 events");
}

TEST_CASE("events in the past") {
  json shop = plain_shop();
  shop["parts"][0]["supply"] = {{"kind", "orders"},
                                {"orders", {{{"arrives_min", 10}}, {{"arrives_min", 5}}}}};
  check_refused(shop, "/parts/0/supply/orders/1/arrives_min = 5, must not be before the order above it");
  shop["parts"][0]["supply"]["orders"] = {{{"arrives_min", -1}}};
  check_refused(shop, "/parts/0/supply/orders/0/arrives_min = -1");
  shop = plain_shop();
  shop["machines"][0]["loading"] = distribution("constant", "value_min", -1);
  check_refused(shop, "/machines/0/loading/value_min = -1");
}

TEST_CASE("names that would play with the terminal are shown without their control characters") {
  json shop = plain_shop();
  shop["parts"][0]["store"] = "\x1b[2Jout\nerror: all is well";
  check_refused(shop, "[2Jout error: all is well");
  const Answer a = verstat::test::call("$(printf 'r\\033[1mn')");
  CHECK(a.exit_code == 2);
  CHECK(a.err.find('\x1b') == std::string::npos);
}

TEST_CASE("more values than memory holds") {
  json shop = plain_shop();
  shop["machines"][0]["count"] = 10'000;
  shop["simulation"]["horizon_min"] = 5;
  check_refused(shop, "100000 replications of", "--replications 100000");
}

TEST_CASE("JSON without end and without bottom") {
  const Workspace w;
  const auto refused = [&](const std::string& text, const std::string& says) {
    std::ofstream(w.file("text.json")) << text;
    const Answer a = run_within_limits(w.file("text.json"), w);
    CHECK(a.exit_code == 2);
    CHECK_THAT(a.err, Catch::Contains(says));
  };
  refused(std::string(10'000'000, '['), "is nested deeper than 64 levels");
  refused(std::string(70'000'000, ' '), "is larger than 64 MiB");
  refused("{\"name\": \"" + std::string(50'000'000, 'a') + "\"}", "/");
  std::string wide = "{\"name\": \"x\", \"machines\": [0";
  for (int k = 0; k < 4'000'000; ++k) wide += ",0";
  refused(wide + "]}", "/machines");
  const Answer endless = run_within_limits("/dev/zero", w);
  CHECK(endless.exit_code == 2);
  CHECK_THAT(endless.err, Catch::Contains("is larger than 64 MiB"));
}

TEST_CASE("money beyond counting ends with the name of the KPI, nothing is stored") {
  json shop = json::parse(read_file("scenarios/gallery/heavy-lathe.json"));
  shop["tools"][0]["periods_planned"] = 1e-300;
  check_refused(shop, "cost_per_part = ", "--replications 2");
}
