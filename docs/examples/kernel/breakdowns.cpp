// Six machines that break down, two repairers: how many parts, and how busy is the crew?
#include <cstdio>
#include <string>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

struct Shop {
  explicit Shop(Simulation& s) : sim(s) { crew.enable_statistics(); }
  Simulation& sim;
  Resource crew{sim, "repair crew", 2};
  Distribution up_h = Distribution::exponential(5.0);
  Distribution repair_h = Distribution::exponential(1.0);
  double part_h = 0.1;
  int parts = 0;
};

Task<> make_parts(Shop& shop) {
  while (true) {
    co_await shop.sim.delay(shop.part_h);
    ++shop.parts;
  }
}

Task<> machine(Shop& shop, RandomStream life, RandomStream repair) {
  while (true) {
    // The machine works until it breaks down; the part in work is lost.
    auto came = co_await first_of(make_parts(shop), shop.sim.delay(shop.up_h.sample(life)));
    if (came.index() == 1) {
      Hold repairer = co_await shop.crew.acquire();
      co_await shop.sim.delay(shop.repair_h.sample(repair));
    }
  }
}

int main() {
  Simulation sim;
  Shop shop(sim);
  for (int i = 1; i <= 6; ++i) {
    const std::string name = "machine " + std::to_string(i);
    sim.spawn(name, machine(shop, RandomStream(1, name, "life"), RandomStream(1, name, "repair")));
  }
  const double year_h = 8760.0;
  sim.run_until(year_h);
  std::printf("parts per hour %.2f, crew busy %.3f, mean wait for repair %.3f h\n", shop.parts / year_h,
              shop.crew.statistics()->level.mean(year_h) / 2.0, shop.crew.statistics()->wait.mean());
}
