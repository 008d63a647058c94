// The shop: events a second and memory per machine, for a plant that grows tenfold twice.
#include "sim/shop/shop.h"

#include <string>

#include <benchmark/benchmark.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "scenarios/load.h"

namespace {

using nlohmann::json;

// Lines of five machines each, with failures, a repair crew, wearing tools and a setter per four lines.
json plant(int machines) {
  const json process = {{"kind", "turning"},   {"diameter_mm", 80},         {"length_mm", 200},
                        {"passes", 1},         {"cutting_speed_m_min", 60}, {"feed_mm_rev", 0.5},
                        {"depth_of_cut_mm", 3}};
  json shop = {{"name", "plant"},
               {"simulation", {{"horizon_min", 43'200}, {"replications", 1}}},
               {"stores", {{{"name", "s"}}}},
               {"inserts",
                {{{"name", "i"},
                  {"price", 10},
                  {"edge_life",
                   {{"mean_ref_min", 60},
                    {"cutting_speed_ref_m_min", 60},
                    {"feed_ref_mm_rev", 1},
                    {"depth_of_cut_ref_mm", 10}}}}}}};
  const int lines = machines / 5;
  for (int line = 0; line < lines; ++line) {
    const std::string crew = "crew " + std::to_string(line / 4);
    if (line % 4 == 0) shop["crews"].push_back({{"name", crew}, {"members", 2}});
    json part = {
        {"name", "p" + std::to_string(line)},
        {"store", "s"},
        {"supply", {{"kind", "interarrival"}, {"time", {{"kind", "exponential"}, {"rate_per_min", 0.2}}}}}};
    for (int k = 0; k < 5; ++k) {
      const std::string id = std::to_string(line) + "." + std::to_string(k);
      shop["machines"].push_back({{"name", "m" + id},
                                  {"failures",
                                   {{{"name", "f"},
                                     {"time_to_failure", {{"kind", "exponential"}, {"rate_per_min", 0.001}}},
                                     {"repair", {{"kind", "exponential"}, {"rate_per_min", 0.05}}},
                                     {"crew", crew}}}}});
      shop["tools"].push_back({{"name", "t" + id}, {"insert", "i"}, {"crew", crew}});
      shop["operations"].push_back(
          {{"name", "o" + id}, {"machine", "m" + id}, {"tool", "t" + id}, {"process", process}});
      part["route"].push_back("o" + id);
    }
    shop["parts"].push_back(part);
  }
  return shop;
}

double resident_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void plant_of(benchmark::State& state) {
  const auto scenario = verstat::scenarios::load(plant(static_cast<int>(state.range(0))));
  const double before = resident_bytes();
  double events = 0;
  for (auto _ : state) {
    verstat::shop::Shop shop(scenario, 0);
    benchmark::DoNotOptimize(shop.run());
    events += static_cast<double>(shop.events_executed());
  }
  state.counters["events_per_s"] = benchmark::Counter(events, benchmark::Counter::kIsRate);
  state.counters["ns_per_event"] =
      benchmark::Counter(events * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes_per_machine"] = (resident_bytes() - before) / static_cast<double>(state.range(0));
}
// 20 stations of three machines, 40 tools, 8 crews and 30 part types with routes of five steps, for one year.
json year() {
  json shop = plant(20);
  shop["simulation"] = {{"horizon_min", 525'600}, {"replications", 1}, {"max_events", 1'000'000'000}};
  shop["crews"].clear();
  for (int c = 0; c < 8; ++c)
    shop["crews"].push_back({{"name", "crew " + std::to_string(c)}, {"members", 2}});
  const json process = shop["operations"][0]["process"];
  shop["tools"].clear();
  shop["operations"].clear();
  shop["parts"].clear();
  for (int m = 0; m < 20; ++m) {
    json& machine = shop["machines"][static_cast<std::size_t>(m)];
    machine["count"] = 3;
    machine["failures"][0]["crew"] = "crew " + std::to_string(m % 8);
    for (int t = 0; t < 2; ++t) {
      const std::string id = std::to_string(m) + "." + std::to_string(t);
      shop["tools"].push_back(
          {{"name", "t" + id}, {"insert", "i"}, {"crew", "crew " + std::to_string((m + t) % 8)}});
      shop["operations"].push_back(
          {{"name", "o" + id}, {"machine", machine["name"]}, {"tool", "t" + id}, {"process", process}});
    }
  }
  for (int p = 0; p < 30; ++p) {
    json part = {
        {"name", "p" + std::to_string(p)},
        {"store", "s"},
        {"supply", {{"kind", "interarrival"}, {"time", {{"kind", "exponential"}, {"rate_per_min", 0.1}}}}}};
    for (int k = 0; k < 5; ++k)
      part["route"].push_back("o" + std::to_string((p + 7 * k) % 20) + "." + std::to_string(p % 2));
    shop["parts"].push_back(part);
  }
  return shop;
}

void year_of_a_shop(benchmark::State& state) {
  const auto scenario = verstat::scenarios::load(year());
  double events = 0;
  for (auto _ : state) {
    verstat::shop::Shop shop(scenario, 0);
    benchmark::DoNotOptimize(shop.run());
    events += static_cast<double>(shop.events_executed());
  }
  state.counters["events"] = events;
  state.counters["events_per_s"] = benchmark::Counter(events, benchmark::Counter::kIsRate);
}
BENCHMARK(year_of_a_shop)->Unit(benchmark::kSecond)->Iterations(1);

BENCHMARK(plant_of)->Arg(20)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
