// Answers of simulation-optimization that are known, found by studies that only simulate.
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include "tests/optimize/studies.h"

using namespace verstat;
using namespace verstat::optimize;
using nlohmann::json;
using verstat::test::Studied;

namespace {

// Throughput of three exponential machines in line with `places` between them, blanks always at hand: the
// Markov chain of the parts between first and second, second and third machine (those in work and blocked
// included), solved by its stationary equations. Blocking after service.
double line_throughput(std::array<double, 3> rates, std::array<int, 2> places) {
  // State: parts that left machine 1 and are not through machine 2 (a), through 2 and not through 3 (b).
  // a counts the finished part that blocks machine 1 when a = places + 2; b likewise.
  const int most_a = places[0] + 2;
  const int most_b = places[1] + 2;
  const auto index = [&](int a, int b) { return static_cast<std::size_t>(a * (most_b + 1) + b); };
  const std::size_t n = static_cast<std::size_t>((most_a + 1) * (most_b + 1));
  std::vector<double> p(n, 1.0 / static_cast<double>(n));
  // Machine 1 works while a <= places + 1, machine 2 while a >= 1 and it is not blocked (b <= places + 1),
  // machine 3 while b >= 1. A part finished by machine 2 while b is full of machine 3's queue stays in
  // machine 2: counted in b, it holds machine 2.
  const double total = rates[0] + rates[1] + rates[2];
  for (int round = 0; round < 20'000; ++round) {
    std::vector<double> next(n, 0.0);
    for (int a = 0; a <= most_a; ++a)
      for (int b = 0; b <= most_b; ++b) {
        const double here = p[index(a, b)];
        double stay = 1;
        const auto go = [&](double rate, int to_a, int to_b) {
          next[index(to_a, to_b)] += here * rate / total;
          stay -= rate / total;
        };
        // A blocked part of machine 2 keeps it: then the queue before it holds one part fewer in work.
        const bool blocked_2 = b == most_b;
        // Parts before machine 2 when it is blocked: none of them is in it, so places hold one less.
        const int room_a = blocked_2 ? most_a - 1 : most_a;
        if (a < room_a) go(rates[0], a + 1, b);
        if (a > 0 && !blocked_2) go(rates[1], a - 1, b + 1);
        if (b > 0) go(rates[2], a, b - 1);
        next[index(a, b)] += here * stay;
      }
    double moved = 0;
    for (std::size_t k = 0; k < n; ++k) moved += std::abs(next[k] - p[k]);
    p.swap(next);
    if (moved < 1e-13) break;
  }
  double working = 0;
  for (int a = 0; a <= most_a; ++a)
    for (int b = 1; b <= most_b; ++b) working += p[index(a, b)];
  return rates[2] * working;
}

json line(std::array<double, 3> mean_min, std::array<int, 2> places) {
  json shop = {
      {"name", "line"},
      {"simulation", {{"horizon_min", 12'000}, {"warmup_min", 500}, {"replications", 5}, {"seed", "3"}}},
      {"stores", {{{"name", "finished"}}}},
      {"machines", json::array()},
      {"operations", json::array()},
      {"parts",
       {{{"name", "part"},
         {"supply", {{"kind", "always_available"}}},
         {"route", {"work 1", "work 2", "work 3"}},
         {"store", "finished"}}}}};
  for (int k = 0; k < 3; ++k) {
    json machine = {{"name", fmt::format("machine {}", k + 1)}, {"rate_per_min", 1.0}};
    if (k > 0) machine["queue_capacity"] = places[static_cast<std::size_t>(k - 1)];
    shop["machines"].push_back(machine);
    shop["operations"].push_back(
        {{"name", fmt::format("work {}", k + 1)},
         {"machine", fmt::format("machine {}", k + 1)},
         {"process",
          {{"kind", "duration"},
           {"time",
            {{"kind", "exponential"}, {"rate_per_min", 1 / mean_min[static_cast<std::size_t>(k)]}}}}}});
  }
  return shop;
}

// Every option is simulated, then the best ones are told apart.
json study_of(const std::string& pointer, const json& options) {
  return {
      {"name", "known answer"},
      {"scenario", "shop.json"},
      {"variables",
       {{{"name", "option"}, {"pointer", pointer}, {"type", "categorical"}, {"options", options}}}},
      {"objective", {{"kpi", "throughput_per_h"}, {"direction", "maximize"}}},
      {"simulation", {{"trials", options.size()}, {"first_replications", 6}, {"levels", 1}}},
      {"choice",
       {{"finalists", 3}, {"first_replications", 10}, {"max_replications", 150}, {"indifference", 0.001}}}};
}

}  // namespace

TEST_CASE("buffers of a balanced line: shared evenly between the two gaps") {
  // Six places between three equal machines.
  json options = json::array();
  std::vector<double> theory;
  for (int first = 0; first <= 6; ++first) {
    options.push_back(line({1, 1, 1}, {first, 6 - first})["machines"]);
    theory.push_back(60 * line_throughput({1, 1, 1}, {first, 6 - first}));
  }
  // The chain knows it already: symmetric, and largest in the middle (reversibility, concavity).
  for (int first = 0; first <= 6; ++first)
    CHECK(theory[static_cast<std::size_t>(first)] ==
          Approx(theory[static_cast<std::size_t>(6 - first)]).epsilon(1e-6));
  REQUIRE(std::max_element(theory.begin(), theory.end()) - theory.begin() == 3);
  // Started from the worst.
  const Studied a(study_of("/machines", options), line({1, 1, 1}, {0, 6}));
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == 3);
  CHECK(a.answer.best->stage == "choice");
  CHECK(a.answer.best->value == Approx(theory[3]).epsilon(0.006));
}

TEST_CASE("bowl phenomenon: the machine in the middle of an unbuffered line gets less work") {
  // Three exponential machines, no places between them, 3 min of work in all: moving work from the middle to
  // the ends raises the throughput, up to a point (Hillier, Boling 1966).
  const std::vector<double> middles{1.15, 1.0, 0.83, 0.6, 0.4};
  json options = json::array();
  std::vector<double> theory;
  for (const double middle : middles) {
    const double end = (3 - middle) / 2;
    options.push_back(line({end, middle, end}, {0, 0})["operations"]);
    theory.push_back(60 * line_throughput({1 / end, 1 / middle, 1 / end}, {0, 0}));
  }
  CHECK(theory[1] == Approx(60 * 22.0 / 39).epsilon(1e-6));  // 0.5641 for the balanced line
  REQUIRE(std::max_element(theory.begin(), theory.end()) - theory.begin() == 2);
  const Studied a(study_of("/operations", options), line({0.925, 1.15, 0.925}, {0, 0}));
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == 2);
  CHECK(a.answer.best->value > theory[1]);
  CHECK(a.answer.best->value == Approx(theory[2]).epsilon(0.006));
}

TEST_CASE("base stock: the smallest store that serves 94.6 % of the customers from the shelf") {
  // One machine works while there is room in the store, one part every 1.25 min on the average; a customer
  // comes every 1.5 min, takes a part or goes away. The finished part that finds the store full waits in the
  // machine: a birth and death chain of capacity + 1 states above zero.
  const double made = 1 / 1.25;
  const double asked = 1 / 1.5;
  const auto fill_rate = [&](int capacity) {
    double sum = 0;
    double term = 1;
    for (int k = 0; k <= capacity + 1; ++k) {
      sum += term;
      term *= made / asked;
    }
    return 1 - 1 / sum;
  };
  int best = 1;
  while (fill_rate(best) < 0.946) ++best;
  CHECK(fill_rate(best) > 0.951);  // away from the border on both sides, so that noise decides nothing
  CHECK(fill_rate(best - 1) < 0.941);
  json shop = line({1.25, 1.25, 1.25}, {0, 0});
  shop["machines"] = {shop["machines"][0]};
  shop["operations"] = {shop["operations"][0]};
  shop["parts"][0]["route"] = {"work 1"};
  shop["stores"] = json::parse(
      R"([{"name": "finished", "capacity": 20, "demand": {"kind": "exponential", "rate_per_min": 0.6666666666666666}}])");
  shop["simulation"]["horizon_min"] = 30'000;
  json study = study_of("/stores/0/capacity", json::array({1, 2}));
  study["variables"] = json::parse(
      R"([{"name": "base stock", "pointer": "/stores/0/capacity", "type": "integer", "low": 1, "high": 24}])");
  study["objective"] = {{"kpi", "store/finished/mean_level"}};
  study["constraints"] =
      json::parse(R"([{"kpi": "store/finished/fill_rate", "at_least": 0.946, "confidence": 0.9}])");
  study["simulation"] = {{"trials", 60}, {"first_replications", 10}, {"levels", 1}, {"neighbourhood", 1.0}};
  const Studied a(study, shop);
  REQUIRE(a.answer.best);
  CHECK(a.answer.best->x[0] == best);
}
