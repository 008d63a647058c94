// Stores and containers: order, capacity, conservation.
#include "sim/kernel/store.h"

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

Task<> put_all(Simulation& sim, Store<int>& store, std::vector<int> items, std::vector<double>& times) {
  for (const int item : items) {
    co_await store.put(item);
    times.push_back(sim.now());
  }
}

Task<> get_every(Simulation& sim, Store<int>& store, double dt, int n, std::vector<int>& got) {
  for (int i = 0; i < n; ++i) {
    co_await sim.delay(dt);
    const int item = co_await store.get();
    got.push_back(item);
  }
}

std::vector<int> drain(Store<int>& store) {
  std::vector<int> out;
  while (auto item = store.try_get()) out.push_back(*item);
  return out;
}

}  // namespace

TEST_CASE("a full store blocks, an empty one too; first in first out", "[store]") {
  Simulation sim;
  Store<int> store(sim, 2);
  std::vector<double> times;
  std::vector<int> got;
  sim.spawn("put", put_all(sim, store, {1, 2, 3, 4}, times));
  sim.spawn("get", get_every(sim, store, 10.0, 4, got));
  sim.run();
  CHECK(times == std::vector<double>{0.0, 0.0, 10.0, 20.0});
  CHECK(got == std::vector<int>{1, 2, 3, 4});
}

TEST_CASE("last in first out, and by priority with ties first in first out", "[store]") {
  Simulation sim;
  Store<int> lifo(sim, Store<int>::unlimited, Discipline::lifo);
  Store<int> priority(sim, Store<int>::unlimited, [](const int& x) { return static_cast<double>(x / 10); });
  for (const int item : {21, 11, 31, 12, 22}) {
    CHECK(lifo.try_put(item));
    CHECK(priority.try_put(item));
  }
  CHECK(drain(lifo) == std::vector<int>{22, 12, 31, 11, 21});
  CHECK(drain(priority) == std::vector<int>{11, 12, 21, 22, 31});
}

TEST_CASE("a filtered get takes the first that passes and lets others by", "[store]") {
  Simulation sim;
  Store<int> store(sim);
  for (const int item : {1, 4, 3, 6}) store.try_put(item);
  std::vector<int> got;
  sim.spawn("even", [](Store<int>& s, std::vector<int>& out) -> Task<> {
    for (int i = 0; i < 3; ++i) {
      const int item = co_await s.get([](int x) { return x % 2 == 0; });
      out.push_back(item);
    }
  }(store, got));
  sim.spawn("any", [](Simulation& sm, Store<int>& s, std::vector<int>& out) -> Task<> {
    co_await sm.delay(1.0);
    for (int i = 0; i < 3; ++i) {
      const int item = co_await s.get();
      out.push_back(item);
    }
  }(sim, store, got));
  sim.spawn("late", [](Simulation& sm, Store<int>& s) -> Task<> {
    co_await sm.delay(2.0);
    co_await s.put(5);  // for any: even waits, too, but does not take it
    co_await s.put(8);
  }(sim, store));
  sim.run();
  CHECK(got == std::vector<int>{4, 6, 1, 3, 5, 8});
}

TEST_CASE("items may be move-only; try_put leaves what does not fit", "[store]") {
  Simulation sim;
  Store<std::unique_ptr<int>> store(sim, 1);
  auto a = std::make_unique<int>(1);
  auto b = std::make_unique<int>(2);
  CHECK(store.try_put(a));
  CHECK(a == nullptr);
  CHECK_FALSE(store.try_put(b));
  CHECK(*b == 2);
  CHECK(**store.try_get() == 1);
}

TEST_CASE("sniper: a getter called off after the hand-over puts the item back in front", "[store]") {
  Simulation sim;
  Store<int> store(sim, 1);
  std::vector<int> got;
  Process getter = sim.spawn("getter", get_every(sim, store, 1.0, 1, got));
  sim.spawn("putter", [](Simulation& s, Store<int>& st, Process g) -> Task<> {
    co_await s.delay(5.0);
    co_await st.put(7);
    CHECK(st.full());  // handed over, but its place is not free yet
    CHECK_FALSE(st.try_put(8));
    g.cancel();
    CHECK(st.size() == 1);
  }(sim, store, getter));
  sim.run();
  CHECK(got.empty());
  CHECK(drain(store) == std::vector<int>{7});
}

TEST_CASE("bad stores are refused", "[store]") {
  Simulation sim;
  CHECK_THROWS_WITH(Store<int>(sim, 0), "store store: capacity is 0, must be >= 1");
  CHECK_THROWS_WITH(Store<int>(sim, 1, Discipline::priority), Catch::Contains("needs a key function"));
}

TEST_CASE("property: random puts, gets, interruptions: every item comes out once, capacity is kept",
          "[store]") {
  const bool passed = rc::check("store", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    RandomStream random(seed, "store", "property");
    Simulation sim;
    const std::size_t capacity = 1 + random.below(4);
    Store<int> store(sim, capacity, random.below(2) == 0 ? Discipline::fifo : Discipline::lifo);
    int put = 0;
    std::vector<int> got;
    std::vector<Process> processes;
    const auto putter = [](Simulation& s, Store<int>& st, RandomStream& u, int& n,
                           std::size_t most) -> Task<> {
      for (int k = 0; k < 20; ++k) {
        co_await s.delay(std::floor(u.uniform(0.0, 3.0)));
        const int item = n++;
        for (bool done = false; !done;) {
          auto tried = co_await interruptible(st.put(item));
          done = !tried.interrupted();
        }
        RC_ASSERT(st.size() <= most);
      }
    };
    const auto getter = [](Simulation& s, Store<int>& st, RandomStream& u, std::vector<int>& out) -> Task<> {
      while (true) {
        auto waited = co_await interruptible(s.delay(std::floor(u.uniform(0.0, 3.0))));
        const int parity = static_cast<int>(u.below(3));
        if (parity < 2) {
          auto item = co_await interruptible(st.get([parity](int x) { return x % 2 == parity; }));
          if (!item.interrupted()) out.push_back(item.value());
        } else {
          auto came = co_await interruptible(first_of(st.get(), s.delay(1.0)));
          if (!came.interrupted() && came.value().index() == 0) out.push_back(came.value().template get<0>());
        }
        (void)waited;
      }
    };
    for (int i = 0; i < 3; ++i) {
      sim.spawn("putter", putter(sim, store, random, put, capacity));
      processes.push_back(sim.spawn("getter", getter(sim, store, random, got)));
    }
    for (int t = 1; t < 400; ++t) {
      sim.run_until(t);
      processes[random.below(3)].interrupt("test");
    }
    std::vector<int> all = drain(store);
    all.insert(all.end(), got.begin(), got.end());
    std::sort(all.begin(), all.end());
    RC_ASSERT(all.size() == 60U);
    for (int i = 0; i < 60; ++i) RC_ASSERT(all[static_cast<std::size_t>(i)] == i);
  });
  CHECK(passed);
}

TEST_CASE("containers keep their level between 0 and capacity, in order of arrival", "[container]") {
  Simulation sim;
  Container tank(sim, 10.0, 2.0);
  std::vector<std::string> log;
  const auto take = [](Simulation& s, Container& c, double amount, std::vector<std::string>& out) -> Task<> {
    co_await c.get(amount);
    out.push_back(detail::text_of(s.now()) + " got " + detail::text_of(amount));
  };
  sim.spawn("big", take(sim, tank, 5.0, log));
  sim.spawn("small", take(sim, tank, 1.0, log));  // there is enough, but big is first
  sim.spawn("fill", [](Simulation& s, Container& c) -> Task<> {
    co_await s.delay(1.0);
    co_await c.put(4.0);
    CHECK(c.level() == 0.0);
    co_await s.delay(1.0);
    co_await c.put(9.0);
    co_await c.put(8.0);
    CHECK(s.now() == 5.0);
  }(sim, tank));
  sim.run_until(4.0);
  CHECK(log == std::vector<std::string>{"1 got 5", "1 got 1"});
  CHECK(tank.level() == 9.0);
  CHECK(tank.waiting_to_put() == 1);
  sim.run_until(5.0);
  sim.spawn("more", take(sim, tank, 7.0, log));
  sim.run();
  CHECK(tank.level() == 10.0);
}

TEST_CASE("containers refuse bad amounts", "[container]") {
  Simulation sim;
  CHECK_THROWS_WITH(Container(sim, -1.0), "container container: capacity is -1, must be >= 0");
  CHECK_THROWS_WITH(Container(sim, 1.0, 2.0, "tank"),
                    "container tank: level is 2, must be from 0 to the capacity 1");
  Container tank(sim, 10.0);
  CHECK_THROWS_WITH(tank.put(11.0),
                    Catch::Contains("put of 11, must be finite and from 0 to the capacity 10"));
  CHECK_THROWS_AS(tank.get(-1.0), SimulationError);
  CHECK_THROWS_AS(tank.get(std::numeric_limits<double>::quiet_NaN()), SimulationError);
}

TEST_CASE("a transfer called off between grant and waking is undone", "[container]") {
  Simulation sim;
  Container tank(sim, 10.0, 0.0);
  Process taker = sim.spawn("taker", [](Container& c) -> Task<> { co_await c.get(4.0); }(tank));
  sim.spawn("p", [](Simulation& s, Container& c, Process t) -> Task<> {
    co_await s.delay(1.0);
    co_await c.put(6.0);
    CHECK(c.level() == 2.0);
    t.cancel();
    CHECK(c.level() == 6.0);
  }(sim, tank, taker));
  sim.run();
  CHECK(tank.level() == 6.0);
}
