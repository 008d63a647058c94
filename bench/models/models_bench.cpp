// Speed of process models and plans. Every benchmark checks its answer once: a faster wrong answer fails.
//   bench_models                       closed-form functions through the C++ call, plans of the gallery
#include <cmath>
#include <filesystem>

#include <benchmark/benchmark.h>

#include "models/reliability/k117_rational_reliability.h"
#include "models/treatment/k310_pulse_current_contact.h"
#include "scenarios/json_text.h"
#include "scenarios/plan_json.h"

using namespace verstat;

namespace {

void expect(benchmark::State& state, double got, double expected, double rel_tol = 1e-6) {
  if (std::abs(got - expected) > rel_tol * std::abs(expected)) state.SkipWithError("wrong answer");
}

void part_cost(benchmark::State& state) {
  models::k117::PartCostIn in;
  in.gamma = 0.64;
  in.speed_m_min = 60;
  expect(state, models::k117::part_cost(in).part_cost, 146.7971611);
  for (auto _ : state) {
    in.speed_m_min = 60 + 1e-9 * static_cast<double>(state.iterations() & 1);
    benchmark::DoNotOptimize(models::k117::part_cost(in));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(part_cost);

void joint_optimum(benchmark::State& state) {
  const models::k117::JointOptimumIn in;
  expect(state, models::k117::joint_speed_gamma_optimum(in).part_cost, 125.41, 1e-4);  // K117 check 9
  for (auto _ : state) benchmark::DoNotOptimize(models::k117::joint_speed_gamma_optimum(in));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(joint_optimum);

void contact_heat(benchmark::State& state) {
  const models::k310::ContactCurrent in{200, 1};
  expect(state, models::k310::contact_heat_power(in).power_kw, 0.04);
  for (auto _ : state) benchmark::DoNotOptimize(models::k310::contact_heat_power(in));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}
BENCHMARK(contact_heat);

void plan_of(benchmark::State& state, const std::string& file) {
  const auto operation = scenarios::load_operation(scenarios::read_json_file(file));
  const double main_time_min = operation.plan().main_time_min;
  for (auto _ : state) {
    const auto plan = operation.plan();
    if (plan.main_time_min != main_time_min) state.SkipWithError("the plan changed");
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()));
}

const int registered = [] {
  for (const auto& entry : std::filesystem::directory_iterator("scenarios/gallery/operations"))
    benchmark::RegisterBenchmark(("plan/" + entry.path().stem().string()).c_str(), plan_of,
                                 entry.path().string());
  return 0;
}();

}  // namespace

BENCHMARK_MAIN();
