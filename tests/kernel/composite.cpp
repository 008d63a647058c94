// Waiting for several things at once.
#include "sim/kernel/composite.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

/// Runs `body` as a process of a fresh simulation to the end and returns the final time.
template <class Body>
double run(Body body) {
  Simulation sim;
  sim.spawn("body", body(sim));
  sim.run();
  return sim.now();
}

Task<int> answer(Simulation& sim, double dt, int value) {
  co_await sim.delay(dt);
  co_return value;
}

Task<> succeed_at(Simulation& sim, Event<int>& event, double dt, int value) {
  co_await sim.delay(dt);
  event.succeed(value);
}

}  // namespace

TEST_CASE("first_of names the branch that came and withdraws the others", "[composite]") {
  Simulation sim;
  Resource busy(sim, "busy", 0);
  Store<int> empty(sim);
  Signal signal(sim);
  Gate gate(sim);
  sim.spawn("p", [](Simulation& s, Resource& r, Store<int>& st, Signal& sg, Gate& g) -> Task<> {
    auto came = co_await first_of(r.acquire(), st.get(), sg, g, s.delay(9.0), s.delay(2.0));
    CHECK(came.index() == 5);
    CHECK(s.now() == 2.0);
    CHECK(r.queue_length() == 0);
    CHECK(st.waiting_to_get() == 0);
    CHECK(sg.waiting() == 0);
    CHECK(g.waiting() == 0);
    CHECK(s.events_pending() == 0);
  }(sim, busy, empty, signal, gate));
  sim.run();
  CHECK(sim.now() == 2.0);
}

TEST_CASE("first_of of things that are ready takes the first written, and only that", "[composite]") {
  Simulation sim;
  Resource free(sim, "free");
  Store<int> store(sim);
  store.try_put(7);
  sim.spawn("p", [](Simulation& s, Resource& r, Store<int>& st) -> Task<> {
    auto came = co_await first_of(s.delay(0.0), st.get(), r.acquire());
    CHECK(came.index() == 1);
    CHECK(came.get<1>() == 7);
    CHECK(r.in_use() == 0);
    CHECK(st.empty());
    CHECK_THROWS_AS(came.get<2>(), std::bad_variant_access);
  }(sim, free, store));
  sim.run();
  CHECK(sim.now() == 0.0);
}

TEST_CASE("of two branches that come at one instant the one scheduled first wins", "[composite]") {
  run([](Simulation& sim) -> Task<> {
    auto a = co_await first_of(sim.delay(1.0), sim.delay(1.0));
    CHECK(a.index() == 0);
    auto b = co_await first_of(sim.delay(1.0, 1), sim.delay(1.0, 0));
    CHECK(b.index() == 1);
  });
}

TEST_CASE("first_of of a task cancels it when it loses and gives its value when it wins", "[composite]") {
  const double end = run([](Simulation& sim) -> Task<> {
    auto won = co_await first_of(answer(sim, 1.0, 42), sim.delay(5.0));
    CHECK(won.index() == 0);
    CHECK(won.get<0>() == 42);
    auto lost = co_await first_of(answer(sim, 100.0, 42), sim.delay(5.0));
    CHECK(lost.index() == 1);
    CHECK(sim.now() == 6.0);
  });
  CHECK(end == 6.0);  // the task at 101 is gone
}

TEST_CASE("the exception of a task branch comes out of the wait", "[composite]") {
  run([](Simulation& sim) -> Task<> {
    const auto fails = [](Simulation& s) -> Task<> {
      co_await s.delay(1.0);
      throw std::runtime_error("inside");
    };
    std::string text;
    try {
      auto came = co_await first_of(fails(sim), sim.delay(5.0));
      text = std::to_string(came.index());
    } catch (const std::runtime_error& error) {
      text = error.what();
    }
    CHECK(text == "inside");
    CHECK(sim.now() == 1.0);
    CHECK(sim.events_pending() == 0);
  });
}

TEST_CASE("a task branch may itself trigger the branch that beats it", "[composite]") {
  Simulation sim;
  Event<> stop(sim);
  int after = 0;
  sim.spawn("p", [](Simulation& s, Event<>& e, int& n) -> Task<> {
    const auto job = [](Simulation& inner, Event<>& ev, int& m) -> Task<> {
      co_await inner.delay(1.0);
      ev.succeed();
      ++m;  // runs on until its next wait
      co_await inner.delay(1.0);
      m += 100;
    };
    auto came = co_await first_of(job(s, e, n), e);
    CHECK(came.index() == 1);
    CHECK(s.now() == 1.0);
    co_await s.delay(10.0);
  }(sim, stop, after));
  sim.run();
  CHECK(after == 1);
  CHECK(sim.now() == 11.0);
}

TEST_CASE("a task branch cannot cancel the process it is part of", "[composite]") {
  Simulation sim;
  std::optional<Process> parent;
  parent = sim.spawn("p", [](Simulation& s, std::optional<Process>& me) -> Task<> {
    const auto job = [](Simulation& inner, std::optional<Process>& p) -> Task<> {
      co_await inner.delay(1.0);
      p->cancel();
    };
    auto came = co_await first_of(job(s, me), s.delay(5.0));
    CHECK(came.index() == 9);
  }(sim, parent));
  CHECK_THROWS_WITH(sim.run(), Catch::Contains("a process cannot cancel itself"));
}

TEST_CASE("all_of waits for the last and collects", "[composite]") {
  Simulation sim;
  Event<int> event(sim);
  sim.spawn("e", succeed_at(sim, event, 3.0, 5));
  ProcessOf<int> process = sim.spawn("a", answer(sim, 4.0, 6));
  sim.spawn("p", [](Simulation& s, Event<int>& e, ProcessOf<int> p) -> Task<> {
    auto [delay, from_event, from_process, from_task] =
        co_await all_of(s.delay(1.0), e, p, answer(s, 2.0, 7));
    CHECK(s.now() == 4.0);
    CHECK(from_event == 5);
    CHECK(from_process == 6);
    CHECK(from_task == 7);
    // All of what is over already does not wait.
    auto again = co_await all_of(e, p);
    CHECK(std::get<0>(again) == 5);
    CHECK(s.now() == 4.0);
    (void)delay;
  }(sim, event, process));
  sim.run();
  CHECK(sim.now() == 4.0);
}

TEST_CASE("composites nest", "[composite]") {
  run([](Simulation& sim) -> Task<> {
    auto came =
        co_await first_of(all_of(sim.delay(1.0), sim.delay(9.0)), all_of(sim.delay(2.0), sim.delay(3.0)));
    CHECK(came.index() == 1);
    CHECK(sim.now() == 3.0);
    CHECK(sim.events_pending() == 0);
    auto all = co_await all_of(first_of(sim.delay(1.0), sim.delay(2.0)), sim.delay(1.5));
    CHECK(std::get<0>(all).index() == 0);
    CHECK(sim.now() == 4.5);
    CHECK(sim.events_pending() == 0);
  });
}

TEST_CASE("cancelling or interrupting a process in a composite gives everything back", "[composite]") {
  for (const bool cancel : {true, false}) {
    Simulation sim;
    Resource resource(sim, "r", 2);
    Store<int> store(sim);
    store.try_put(1);
    Process process = sim.spawn("p", [](Simulation& s, Resource& r, Store<int>& st) -> Task<> {
      try {
        auto got = co_await all_of(r.acquire(), st.get(), s.delay(100.0));
        CHECK(std::get<1>(got) == 0);
      } catch (const Interrupted&) {
      }
    }(sim, resource, store));
    sim.run_until(1.0);
    CHECK(resource.in_use() == 1);
    CHECK(store.empty());
    if (cancel) {
      process.cancel();
    } else {
      process.interrupt();
    }
    CHECK(resource.in_use() == 0);
    CHECK(store.size() == 1);
    sim.run();
    CHECK(sim.now() == 1.0);
  }
}

TEST_CASE("sniper: interrupted between the coming of a branch and the waking", "[composite]") {
  Simulation sim;
  Resource resource(sim, "r", 1);
  bool interrupted = false;
  sim.spawn("holder", [](Simulation& s, Resource& r) -> Task<> {
    Hold hold = co_await r.acquire();
    co_await s.delay(5.0);
  }(sim, resource));
  Process waiter = sim.spawn("waiter", [](Simulation& s, Resource& r, bool& flag) -> Task<> {
    try {
      auto came = co_await first_of(r.acquire(), s.delay(100.0));
      CHECK(came.index() == 7);
    } catch (const Interrupted&) {
      flag = true;
    }
  }(sim, resource, interrupted));
  // Scheduled for t = 5 after the holder: the grant has been made, the waiter has not woken up yet.
  sim.spawn("sniper", [](Simulation& s, Process w, Resource& r) -> Task<> {
    co_await s.delay(5.0);
    CHECK(r.in_use() == 1);
    w.interrupt("sniper");
    CHECK(r.in_use() == 0);
  }(sim, waiter, resource));
  sim.run();
  CHECK(interrupted);
  CHECK(sim.now() == 5.0);
}

TEST_CASE("interruptible() also wraps composites", "[composite]") {
  Simulation sim;
  Event<int> event(sim);
  Process process = sim.spawn("p", [](Simulation& s, Event<int>& e) -> Task<> {
    auto first = co_await interruptible(first_of(e, s.delay(50.0)));
    CHECK(first.interrupted());
    CHECK(first.reason().text() == "why");
    CHECK(s.events_pending() == 1);  // only the event that will succeed
    auto second = co_await interruptible(first_of(e, s.delay(50.0)));
    CHECK_FALSE(second.interrupted());
    CHECK(second.value().index() == 0);
    CHECK(second.value().get<0>() == 9);
  }(sim, event));
  sim.spawn("e", succeed_at(sim, event, 3.0, 9));
  sim.run_until(1.0);
  process.interrupt("why");
  sim.run();
  CHECK(sim.now() == 3.0);
}

TEST_CASE("events: value for all, before and after; once only; reset", "[event]") {
  Simulation sim;
  Event<int> event(sim);
  int sum = 0;
  const auto reader = [](Simulation& s, Event<int>& e, double dt, int& total) -> Task<> {
    co_await s.delay(dt);
    const int value = co_await e;
    total += value;
  };
  for (const double dt : {0.0, 1.0, 2.0, 9.0}) sim.spawn("reader", reader(sim, event, dt, sum));
  sim.spawn("e", succeed_at(sim, event, 2.0, 5));
  sim.run();
  CHECK(sum == 20);
  CHECK(event.value() == 5);
  CHECK_THROWS_WITH(event.succeed(6), Catch::Contains("second time"));
  event.reset();
  CHECK_FALSE(event.happened());
  event.succeed(6);
  CHECK(event.value() == 6);
}

TEST_CASE("a signal wakes whom it finds; wait_until holds on waking", "[event]") {
  Simulation sim;
  Signal changed(sim);
  int tokens = 0;
  int taken = 0;
  int most = 0;
  for (int i = 0; i < 3; ++i) {
    sim.spawn("taker", [](Simulation& s, Signal& c, int& n, int& t, int& m) -> Task<> {
      co_await c.wait_until([&] { return n > 0; });
      CHECK(n > 0);
      --n;
      ++t;
      m = std::max(m, t);
      co_await s.delay(1.0);
    }(sim, changed, tokens, taken, most));
  }
  sim.spawn("giver", [](Simulation& s, Signal& c, int& n, int& t) -> Task<> {
    co_await s.delay(1.0);
    n = 2;
    c.notify();  // all three see a token now, the third finds none left when its turn comes
    co_await s.delay(1.0);
    CHECK(t == 2);
    CHECK(c.waiting() == 1);
    n = 1;
    c.notify();
  }(sim, changed, tokens, taken));
  sim.run();
  CHECK(taken == 3);
  CHECK(tokens == 0);
}

TEST_CASE("a gate lets pass while open", "[event]") {
  Simulation sim;
  Gate gate(sim);
  std::vector<double> passed;
  const auto walker = [](Simulation& s, Gate& g, double dt, std::vector<double>& out) -> Task<> {
    co_await s.delay(dt);
    co_await g;
    out.push_back(s.now());
  };
  for (const double dt : {0.0, 4.5, 6.0}) sim.spawn("walker", walker(sim, gate, dt, passed));
  sim.spawn("keeper", [](Simulation& s, Gate& g) -> Task<> {
    co_await s.delay(4.0);
    g.open();
    co_await s.delay(1.0);
    g.close();
    co_await s.delay(5.0);
    g.open();
    g.close();
  }(sim, gate));
  sim.run();
  CHECK(passed == std::vector<double>{4.0, 4.5, 10.0});
}
