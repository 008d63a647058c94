// The bare event list: pop one, push one a random time later.
#include "sim/kernel/event_list.h"

#include <cstddef>

#include <benchmark/benchmark.h>

#include "sim/kernel/random_stream.h"

using namespace verstat::sim;

namespace {

void push_pop(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  detail::EventList list;
  RandomStream random(1, "list", "time");
  double now = 0.0;
  const double width = 2.0 * static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) list.push(width * random.uniform(), 0, 8);
  const auto once = [&] {
    const detail::Entry entry = list.pop(now);
    if (entry.time < now) state.SkipWithError("wrong order");
    now = entry.time;
    list.push(now + width * random.uniform(), 0, 8);
  };
  for (std::size_t i = 0; i < 4 * n; ++i) once();
  for (auto _ : state) once();
  if (list.size() != n) state.SkipWithError("wrong size");
}
BENCHMARK(push_pop)->Arg(10)->Arg(1'000)->Arg(100'000)->Arg(1'000'000);

/// Schedules and takes back, with n others pending.
void push_cancel(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  detail::EventList list;
  RandomStream random(1, "list", "time");
  const double width = 2.0 * static_cast<double>(n);
  for (std::size_t i = 0; i < n; ++i) list.push(width * random.uniform(), 0, 8);
  for (auto _ : state) list.cancel(list.push(width * random.uniform(), 0, 8));
  if (list.size() != n) state.SkipWithError("wrong size");
}
BENCHMARK(push_cancel)->Arg(10)->Arg(1'000)->Arg(100'000);

}  // namespace
