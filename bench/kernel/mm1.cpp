// A million customers through an unlimited store: the common yardstick of simulation kernels.
#include <cmath>

#include <benchmark/benchmark.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

constexpr int customers = 1'000'000;

Task<> arrivals(Simulation& sim, Store<double>& queue, RandomStream random) {
  for (int i = 0; i < customers; ++i) {
    co_await sim.delay(random.exponential(1.0 / 0.9));
    co_await queue.put(sim.now());
  }
}

Task<> server(Simulation& sim, Store<double>& queue, RandomStream random, Tally& sojourn) {
  while (true) {
    const double arrived = co_await queue.get();
    co_await sim.delay(random.exponential(1.0));
    sojourn.add(sim.now() - arrived);
  }
}

void mm1(benchmark::State& state) {
  std::uint64_t events = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    Simulation sim;
    Store<double> queue(sim);
    Tally sojourn;
    ++seed;
    sim.spawn("arrivals", arrivals(sim, queue, RandomStream(seed, "arrivals", "gap")));
    sim.spawn("server", server(sim, queue, RandomStream(seed, "server", "service"), sojourn));
    sim.run();
    events += sim.events_executed();
    // Theory: 10. The standard deviation of the mean of a million is about 0.19.
    if (sojourn.count() != customers || std::abs(sojourn.mean() - 10.0) > 1.0)
      state.SkipWithError("wrong answer");
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(events));
}
BENCHMARK(mm1)->Unit(benchmark::kMillisecond);

}  // namespace
