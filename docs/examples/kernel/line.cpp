// Two machines with a buffer of three between them. Theory: (b + 2) / (b + 3) = 5/6 parts per time unit.
#include <cstdio>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

Task<> first_machine(Simulation& sim, Store<int>& buffer, RandomStream random) {
  for (int part = 0;; ++part) {
    co_await sim.delay(random.exponential(1.0));
    co_await buffer.put(part);  // blocked while the buffer is full
  }
}

Task<> second_machine(Simulation& sim, Store<int>& buffer, RandomStream random, int& finished) {
  while (true) {
    co_await buffer.get();  // starved while it is empty
    co_await sim.delay(random.exponential(1.0));
    ++finished;
  }
}

double throughput(std::size_t replication) {
  Simulation sim;
  Store<int> buffer(sim, 3);
  int finished = 0;
  sim.spawn("first", first_machine(sim, buffer, RandomStream(1, "first", "work", replication)));
  sim.spawn("second", second_machine(sim, buffer, RandomStream(1, "second", "work", replication), finished));
  sim.run_until(1000.0);  // warm-up
  finished = 0;
  sim.run_until(21000.0);
  return finished / 20000.0;
}

int main() {
  const ReplicationOutcome outcome = replicate_until(Precision(0.005, 10, 500), 0, throughput);
  std::printf("throughput %.4f +- %.4f (%zu replications)\n", outcome.interval.mean,
              outcome.interval.half_width, outcome.results.size());
}
