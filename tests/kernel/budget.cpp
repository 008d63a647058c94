// A model that asks for more events than it was granted ends, wherever its events come from.
#include <catch2/catch.hpp>

#include "sim/kernel/simulation.h"

using namespace verstat::sim;

namespace {

Task<void> tick(Simulation& sim, double every) {
  for (;;) co_await sim.delay(every);
}

}  // namespace

TEST_CASE("the event budget ends jumps and events of the list alike, at the same event") {
  for (const int processes : {1, 3}) {
    Simulation sim;
    for (int k = 0; k < processes; ++k) sim.spawn("tick", tick(sim, 1.0));
    sim.set_budget(1000, 1000);
    CHECK_THROWS_AS(sim.run_until(1e9), BudgetError);
    CHECK(sim.events_executed() == 1000);
    // The starts of the processes are events, too.
    CHECK(sim.now() == Approx((1000 - processes) / processes).margin(1.01));
  }
}

TEST_CASE("a run within its budget never hears of it") {
  Simulation free_one;
  free_one.spawn("tick", tick(free_one, 1.0));
  free_one.run_until(500);
  Simulation sim;
  sim.spawn("tick", tick(sim, 1.0));
  sim.set_budget(501, 100);
  sim.run_until(500);
  CHECK(sim.events_executed() == 501);
  CHECK(sim.events_executed() == free_one.events_executed());
  CHECK_THROWS_WITH(sim.run_until(501.5), Catch::Contains("more than 501 events"));
}

TEST_CASE("a clock that stands still is found out, one that moves is not") {
  Simulation still;
  still.spawn("tick", tick(still, 0.0));
  still.set_budget(1'000'000, 100);
  CHECK_THROWS_WITH(still.run_until(1), Catch::Contains("the clock stands still: 100 events at one instant"));
  CHECK(still.events_executed() <= 200);
  Simulation slow;
  slow.spawn("tick", tick(slow, 1e-6));
  slow.set_budget(1'000'000, 100);
  CHECK_NOTHROW(slow.run_until(0.5));
  CHECK_THROWS_AS(slow.set_budget(0, 1), SimulationError);
}
