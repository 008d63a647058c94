// M/M/1: customers arrive at rate 0.9, one server works at rate 1. Theory: sojourn 1 / (1 - 0.9) = 10.
#include <cstdio>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

Task<> arrivals(Simulation& sim, Store<double>& queue, RandomStream random, int customers) {
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

int main() {
  Simulation sim;
  Store<double> queue(sim);
  Tally sojourn;
  sim.spawn("arrivals", arrivals(sim, queue, RandomStream(1, "arrivals", "gap"), 1'000'000));
  sim.spawn("server", server(sim, queue, RandomStream(1, "server", "service"), sojourn));
  sim.run();
  std::printf("mean sojourn %.3f of %llu customers\n", sojourn.mean(), 1ULL * sojourn.count());
}
