// What the usual sentences of a model cost: seizing, creating, blocking, interrupting.
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

void report(benchmark::State& state, std::uint64_t items) {
  state.SetItemsProcessed(static_cast<std::int64_t>(items));
  state.counters["ns_per_item"] = benchmark::Counter(
      static_cast<double>(items) * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

Task<> user(Simulation& sim, Resource& resource, int times, int& done) {
  for (int i = 0; i < times; ++i) {
    Hold hold = co_await resource.acquire();
    co_await sim.delay(1.0);
    ++done;
  }
}

/// Ten processes share a resource with three units; one item is one seize, delay, release.
void seize_release(benchmark::State& state) {
  std::uint64_t items = 0;
  for (auto _ : state) {
    Simulation sim;
    Resource resource(sim, "machine", 3);
    int done = 0;
    for (int i = 0; i < 10; ++i) sim.spawn("user", user(sim, resource, 10'000, done));
    sim.run();
    items += 100'000;
    if (done != 100'000 || std::abs(sim.now() - 100'000.0 / 3.0) > 10.0) state.SkipWithError("wrong answer");
  }
  report(state, items);
}
BENCHMARK(seize_release)->Unit(benchmark::kMillisecond);

Task<> short_life(Simulation& sim, std::uint64_t& ended) {
  co_await sim.delay(1.0);
  ++ended;
}

Task<> creator(Simulation& sim, int times, std::uint64_t& ended) {
  for (int i = 0; i < times; ++i) {
    sim.spawn("short", short_life(sim, ended));
    co_await sim.delay(0.1);
  }
}

/// One item is one process spawned, started, delayed once, ended.
void create_destroy(benchmark::State& state) {
  std::uint64_t items = 0;
  for (auto _ : state) {
    Simulation sim;
    std::uint64_t ended = 0;
    sim.spawn("creator", creator(sim, 100'000, ended));
    sim.run();
    items += ended;
    if (ended != 100'000) state.SkipWithError("wrong answer");
  }
  report(state, items);
}
BENCHMARK(create_destroy)->Unit(benchmark::kMillisecond);

Task<> station(Simulation& sim, Store<int>* in, Store<int>* out, RandomStream random, std::uint64_t& made) {
  while (true) {
    int part = 0;
    if (in != nullptr) part = co_await in->get();
    co_await sim.delay(random.exponential(1.0));
    if (out != nullptr) co_await out->put(part);
    ++made;
  }
}

/// Ten stations in line, buffers of five between them, the first never starved; one item is one part made.
void tandem(benchmark::State& state) {
  std::uint64_t items = 0;
  std::uint64_t seed = 0;
  for (auto _ : state) {
    Simulation sim;
    std::vector<std::unique_ptr<Store<int>>> buffers;
    std::vector<std::uint64_t> made(10, 0);
    ++seed;
    for (int i = 0; i < 9; ++i) buffers.push_back(std::make_unique<Store<int>>(sim, 5));
    for (std::size_t i = 0; i < 10; ++i) {
      Store<int>* in = i == 0 ? nullptr : buffers[i - 1].get();
      Store<int>* out = i == 9 ? nullptr : buffers[i].get();
      sim.spawn("station", station(sim, in, out, RandomStream(seed, std::to_string(i), "time"), made[i]));
    }
    constexpr double end = 20'000.0;
    sim.run_until(end);
    items += made[9];
    // Parts are neither lost nor made: the stations differ by what lies between them.
    const double rate = static_cast<double>(made[9]) / end;
    if (made[0] < made[9] || made[0] > made[9] + 9 * 7 || rate < 0.70 || rate > 0.82) {
      state.SkipWithError("wrong answer");
    }
  }
  report(state, items);
}
BENCHMARK(tandem)->Unit(benchmark::kMillisecond);

Task<> patient(Simulation& sim, std::uint64_t& woken) {
  while (true) {
    auto slept = co_await interruptible(sim.delay(1e6));
    if (slept.interrupted()) ++woken;
  }
}

Task<> impatient(Simulation& sim, std::uint64_t& woken) {
  while (true) {
    try {
      co_await sim.delay(1e6);
    } catch (const Interrupted&) {
      ++woken;
    }
  }
}

Task<> disturber(Simulation& sim, std::vector<Process>& victims, int times) {
  for (int i = 0; i < times; ++i) {
    co_await sim.delay(1.0);
    victims[static_cast<std::size_t>(i) % victims.size()].interrupt();
  }
  for (Process& victim : victims) victim.cancel();
}

/// A hundred sleepers are woken in turn, with an answer (0) or an exception (1); one item is one
/// interruption.
void interrupts(benchmark::State& state) {
  std::uint64_t items = 0;
  for (auto _ : state) {
    Simulation sim;
    std::uint64_t woken = 0;
    std::vector<Process> victims;
    for (int i = 0; i < 100; ++i) {
      victims.push_back(
          sim.spawn("victim", state.range(0) == 0 ? patient(sim, woken) : impatient(sim, woken)));
    }
    sim.spawn("disturber", disturber(sim, victims, 50'000));
    sim.run();
    items += woken;
    // The last one is woken, too, unless it is cancelled within the same instant.
    if (woken < 49'999) state.SkipWithError("wrong answer");
  }
  report(state, items);
}
BENCHMARK(interrupts)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// Independent replications on one and two threads.
void replications(benchmark::State& state) {
  for (auto _ : state) {
    const std::vector<double> results =
        run_replications(16, static_cast<unsigned>(state.range(0)), [](std::size_t i) {
          Simulation sim;
          Resource resource(sim, "machine", 3);
          Tally wait;
          for (std::size_t k = 0; k < 10; ++k) {
            sim.spawn("user", [](Simulation& s, Resource& r, RandomStream u, Tally& out) -> Task<> {
              for (int n = 0; n < 4000; ++n) {
                co_await s.delay(u.exponential(2.0));
                const double asked = s.now();
                Hold hold = co_await r.acquire();
                out.add(s.now() - asked);
                co_await s.delay(u.exponential(1.0));
              }
            }(sim, resource, RandomStream(1, std::to_string(k), "user", i), wait));
          }
          sim.run();
          return wait.mean();
        });
    if (results.size() != 16 || results[3] <= 0.0) state.SkipWithError("wrong answer");
  }
}
BENCHMARK(replications)->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

}  // namespace
