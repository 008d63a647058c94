// N processes that each delay U(0, 2N) again and again: one event per time unit, N pending.
#include <cmath>
#include <cstddef>

#include <benchmark/benchmark.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

Task<> holder(Simulation& sim, RandomStream& random, double width, std::uint64_t& count) {
  while (true) {
    co_await sim.delay(width * random.uniform());
    ++count;
  }
}

void hold(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  Simulation sim;
  RandomStream random(1, "hold", "delay");
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < n; ++i) {
    sim.spawn("holder", holder(sim, random, 2.0 * static_cast<double>(n), count));
  }
  // Into the steady state: everybody has been held four times on average.
  sim.run_until(4.0 * static_cast<double>(n));
  constexpr double events_per_iteration = 200'000.0;
  const std::uint64_t before = count;
  const double start = sim.now();
  std::uint64_t iterations = 0;
  for (auto _ : state) {
    ++iterations;
    sim.run_until(start + events_per_iteration * static_cast<double>(iterations));
  }
  const double expected = events_per_iteration * static_cast<double>(iterations);
  const double got = static_cast<double>(count - before);
  if (std::abs(got - expected) > 0.02 * expected + 10.0 * std::sqrt(static_cast<double>(n))) {
    state.SkipWithError("wrong number of events");
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(count - before));
  state.counters["ns_per_event"] =
      benchmark::Counter(got * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(hold)->Arg(10)->Arg(1'000)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

}  // namespace
