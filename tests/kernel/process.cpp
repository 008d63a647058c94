// Processes: order, spawning, joining, interrupting, cancelling, errors, ending early.
#include "sim/kernel/process.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;
using Log = std::vector<std::string>;

namespace {

std::string at(const Simulation& sim, const std::string& what) {
  return detail::text_of(sim.now()) + " " + what;
}

Task<> note_after(Simulation& sim, Log& log, std::string name, double dt, int priority) {
  co_await sim.delay(dt, priority);
  log.push_back(at(sim, name));
}

Task<> sleeper(Simulation& sim, Log& log, double dt) {
  try {
    co_await sim.delay(dt);
    log.push_back(at(sim, "woke"));
  } catch (const Interrupted& interrupted) {
    log.push_back(at(sim, "interrupted by " + interrupted.reason().text()));
  }
  co_await sim.delay(1.0);
  log.push_back(at(sim, "end"));
}

/// Counts how many are alive.
class Witness {
 public:
  explicit Witness(int& alive) : alive_(&alive) { ++*alive_; }
  Witness(const Witness& other) : alive_(other.alive_) { ++*alive_; }
  Witness& operator=(const Witness&) = delete;
  ~Witness() { --*alive_; }

 private:
  int* alive_;
};

}  // namespace

TEST_CASE("within one instant: priority, then order of scheduling", "[process]") {
  Simulation sim;
  Log log;
  sim.spawn("a", note_after(sim, log, "late", 5.0, 1));
  sim.spawn("b", note_after(sim, log, "first", 5.0, 0));
  sim.spawn("c", note_after(sim, log, "second", 5.0, 0));
  sim.spawn("d", note_after(sim, log, "early", 5.0, -1));
  sim.spawn("e", note_after(sim, log, "before", 4.0, 7));
  sim.run();
  CHECK(log == Log{"4 before", "5 early", "5 first", "5 second", "5 late"});
}

TEST_CASE("processes start in order of (priority, spawning)", "[process]") {
  Simulation sim;
  Log log;
  const auto say = [](Log& to, std::string what) -> Task<> {
    to.push_back(what);
    co_return;
  };
  sim.spawn("a", 1, say(log, "third"));
  sim.spawn("b", say(log, "second"));
  sim.spawn("c", -1, say(log, "first"));
  sim.run();
  CHECK(log == Log{"first", "second", "third"});
}

TEST_CASE("a delay that jumps and one that passes the event list execute the same events", "[process]") {
  // Stepping and tracing forbid jumps; run() allows them.
  const auto model = [](int how) {
    Simulation sim;
    Log log;
    for (int i = 0; i < 3; ++i) {
      sim.spawn("p" + std::to_string(i), [](Simulation& s, Log& to, int me) -> Task<> {
        for (int k = 0; k < 20; ++k) {
          co_await s.delay(0.25 * ((k * 7 + me * 5) % 11));
          to.push_back(at(s, std::to_string(me)));
        }
      }(sim, log, i));
    }
    std::size_t traced = 0;
    if (how == 1) {
      while (sim.step()) {
      }
    } else if (how == 2) {
      sim.set_trace([&](const TraceRecord&) { ++traced; });
      sim.run();
      CHECK(traced == sim.events_executed());
    } else {
      sim.run();
    }
    log.push_back(std::to_string(sim.events_executed()));
    return log;
  };
  const Log jumped = model(0);
  CHECK(jumped.size() == 61);
  CHECK(jumped == model(1));
  CHECK(jumped == model(2));
}

TEST_CASE("run_until executes what happens at its time, and no more", "[process]") {
  Simulation sim;
  Log log;
  sim.spawn("a", note_after(sim, log, "a", 1.0, 0));
  sim.spawn("b", note_after(sim, log, "b", 2.0, 0));
  sim.spawn("c", note_after(sim, log, "c", 2.5, 0));
  sim.run_until(2.0);
  CHECK(log == Log{"1 a", "2 b"});
  CHECK(sim.now() == 2.0);
  CHECK(sim.peek() == 2.5);
  sim.run_until(2.25);
  CHECK(sim.now() == 2.25);
  CHECK_THROWS_WITH(sim.run_until(1.0), Catch::Contains("run_until(1), must be finite and >= now"));
  CHECK_THROWS_AS(sim.run_until(std::numeric_limits<double>::quiet_NaN()), SimulationError);
  sim.run();
  CHECK(log.back() == "2.5 c");
  CHECK(sim.peek() == std::numeric_limits<double>::infinity());
  CHECK_FALSE(sim.step());
}

TEST_CASE("a lonely process does not jump past run_until", "[process]") {
  Simulation sim;
  int ticks = 0;
  sim.spawn("clock", [](Simulation& s, int& n) -> Task<> {
    while (true) {
      co_await s.delay(1.0);
      ++n;
    }
  }(sim, ticks));
  sim.run_until(10.0);
  CHECK(ticks == 10);
  sim.run_until(10.5);
  CHECK(ticks == 10);
  CHECK(sim.events_executed() == 11);
}

TEST_CASE("tasks call tasks and return values", "[process]") {
  struct Factorial {
    static Task<long> of(Simulation& sim, int n) {
      co_await sim.delay(1.0);
      if (n <= 1) co_return 1;
      const long rest = co_await of(sim, n - 1);
      co_return rest* n;
    }
  };
  Simulation sim;
  ProcessOf<long> process = sim.spawn("factorial", Factorial::of(sim, 10));
  long joined = 0;
  sim.spawn("reader", [](ProcessOf<long> p, long& out) -> Task<> { out = co_await p; }(process, joined));
  CHECK_FALSE(process.result().has_value());
  sim.run();
  CHECK(sim.now() == 10.0);
  CHECK(joined == 3628800);
  CHECK(process.result() == 3628800);
  CHECK(process.status() == ProcessStatus::done);
}

TEST_CASE("a task that returns at once may be called a million times: the stack does not grow", "[process]") {
  Simulation sim;
  long sum = 0;
  const auto one = [](int i) -> Task<int> { co_return i % 2; };
  sim.spawn("caller", [](decltype(one) f, long& total) -> Task<> {
    for (int i = 0; i < 1'000'000; ++i) {
      const int value = co_await f(i);
      total += value;
    }
  }(one, sum));
  sim.run();
  CHECK(sum == 500'000);
}

TEST_CASE("results may be move-only, arguments and locals are destroyed once", "[process]") {
  int alive = 0;
  {
    Simulation sim;
    const auto make = [](Simulation& s, Witness w) -> Task<std::unique_ptr<Witness>> {
      co_await s.delay(1.0);
      co_return std::make_unique<Witness>(w);
    };
    sim.spawn("p", [](Simulation& s, decltype(make) f, int& n) -> Task<> {
      const Witness local(n);
      std::unique_ptr<Witness> result = co_await f(s, local);
      CHECK(result != nullptr);
      CHECK(n == 2);
      co_await s.delay(1.0);
    }(sim, make, alive));
    sim.run();
    CHECK(alive == 0);
  }
  CHECK(alive == 0);
}

TEST_CASE("an exception leaves run() with process and time, the original nested", "[process]") {
  Simulation sim;
  Log log;
  sim.spawn("mill-2", [](Simulation& s) -> Task<> {
    co_await s.delay(9.5);
    throw std::out_of_range("no such tool");
  }(sim));
  sim.spawn("other", note_after(sim, log, "other", 20.0, 0));
  try {
    sim.run();
    FAIL("no exception");
  } catch (const ProcessError& error) {
    CHECK(std::string(error.what()) == "t = 9.5, process mill-2: no such tool");
    CHECK(error.process() == "mill-2");
    CHECK(error.time() == 9.5);
    CHECK_THROWS_AS(std::rethrow_if_nested(error), std::out_of_range);
  }
  sim.run();  // the others are not hurt
  CHECK(log == Log{"20 other"});
}

TEST_CASE("an exception passes through the callers of a task, who may catch it", "[process]") {
  Simulation sim;
  Log log;
  const auto fails = [](Simulation& s) -> Task<int> {
    co_await s.delay(1.0);
    throw std::runtime_error("inner");
  };
  sim.spawn("p", [](Simulation& s, Log& to, decltype(fails) f) -> Task<> {
    try {
      const int never = co_await f(s);
      to.push_back(std::to_string(never));
    } catch (const std::runtime_error& error) {
      to.push_back(at(s, error.what()));
    }
    const int again = co_await f(s);
    to.push_back(std::to_string(again));
  }(sim, log, fails));
  CHECK_THROWS_WITH(sim.run(), "t = 2, process p: inner");
  CHECK(log == Log{"1 inner"});
}

TEST_CASE("bad delays name process, time and value", "[process]") {
  const auto message = [](double dt, int priority = 0) {
    Simulation sim;
    sim.spawn("lathe", [](Simulation& s, double d, int p) -> Task<> {
      co_await s.delay(2.0);
      co_await s.delay(d, p);
    }(sim, dt, priority));
    try {
      sim.run();
    } catch (const ProcessError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CHECK(message(-0.3) == "t = 2, process lathe: delay is -0.3, must be >= 0");
  CHECK(message(std::numeric_limits<double>::quiet_NaN()) ==
        "t = 2, process lathe: delay is nan, must be >= 0");
  CHECK(message(1.0, 40000) == "t = 2, process lathe: priority is 40000, must be from -32768 to 32767");
  CHECK(message(0.0) == "no error");
  CHECK(message(std::numeric_limits<double>::infinity()) == "no error");
}

TEST_CASE("an interrupted wait ends at once, with the reason", "[process]") {
  Simulation sim;
  Log log;
  Process victim = sim.spawn("victim", sleeper(sim, log, 100.0));
  sim.spawn("villain", [](Simulation& s, Process p) -> Task<> {
    co_await s.delay(3.0);
    CHECK(p.interrupt("breakdown"));
    CHECK_FALSE(p.interrupt("again"));  // still on its way to wake up
  }(sim, victim));
  sim.run();
  CHECK(log == Log{"3 interrupted by breakdown", "4 end"});
  CHECK(sim.now() == 4.0);
  CHECK_FALSE(victim.interrupt("too late"));
}

TEST_CASE("an interruption before the start comes at the first wait", "[process]") {
  Simulation sim;
  Log log;
  Process victim = sim.spawn("victim", sleeper(sim, log, 100.0));
  CHECK(victim.status() == ProcessStatus::waiting_to_start);
  CHECK(victim.interrupt("haste"));
  sim.run();
  CHECK(log == Log{"0 interrupted by haste", "1 end"});
}

TEST_CASE("interruptible() reports instead of throwing", "[process]") {
  Simulation sim;
  Log log;
  Process victim = sim.spawn("victim", [](Simulation& s, Log& to) -> Task<> {
    auto first = co_await interruptible(s.delay(100.0));
    to.push_back(
        at(s, first.interrupted() ? "interrupted " + std::to_string(first.reason().code()) : "done"));
    auto second = co_await interruptible(s.delay(2.0));
    to.push_back(at(s, second.interrupted() ? "interrupted" : "done"));
  }(sim, log));
  sim.spawn("villain", [](Simulation& s, Process p) -> Task<> {
    co_await s.delay(3.0);
    p.interrupt(Reason(42, "shift end"));
  }(sim, victim));
  sim.run();
  CHECK(log == Log{"3 interrupted 42", "5 done"});
}

TEST_CASE("sniper: an interruption at the instant of waking", "[process]") {
  // The villain is scheduled first or second for t = 5; the victim sleeps until 5.
  for (const bool villain_first : {true, false}) {
    Simulation sim;
    Log log;
    std::optional<Process> victim;
    const auto villain = [](Simulation& s, std::optional<Process>& p) -> Task<> {
      co_await s.delay(5.0);
      p->interrupt("sniper");
    };
    if (villain_first) sim.spawn("villain", villain(sim, victim));
    victim = sim.spawn("victim", sleeper(sim, log, 5.0));
    if (!villain_first) sim.spawn("villain", villain(sim, victim));
    // First come, first served: if the victim wakes before, the interruption hits its next wait.
    if (villain_first) {
      sim.run();
      CHECK(log == Log{"5 interrupted by sniper", "6 end"});
    } else {
      CHECK_THROWS_WITH(sim.run(), "t = 5, process victim: interrupted: sniper");
      CHECK(log == Log{"5 woke"});
    }
  }
}

TEST_CASE("an interruption nobody catches is an error", "[process]") {
  Simulation sim;
  Process victim = sim.spawn("victim", [](Simulation& s) -> Task<> { co_await s.delay(9.0); }(sim));
  sim.run_until(1.0);
  victim.interrupt("breakdown");
  CHECK_THROWS_WITH(sim.run(), "t = 1, process victim: interrupted: breakdown");
  CHECK(victim.status() == ProcessStatus::failed);
}

TEST_CASE("a process can neither interrupt nor cancel itself", "[process]") {
  Simulation sim;
  std::optional<Process> self;
  int refused = 0;
  self = sim.spawn("self", [](Simulation& s, std::optional<Process>& me, int& n) -> Task<> {
    co_await s.delay(1.0);
    try {
      me->interrupt("me");
    } catch (const SimulationError&) {
      ++n;
    }
    try {
      me->cancel();
    } catch (const SimulationError&) {
      ++n;
    }
  }(sim, self, refused));
  sim.run();
  CHECK(refused == 2);
}

TEST_CASE("cancelling destroys locals, at any depth, and wakes joiners", "[process]") {
  Simulation sim;
  int alive = 0;
  Log log;
  const auto inner = [](Simulation& s, int& n) -> Task<> {
    const Witness local(n);
    co_await s.delay(100.0);
  };
  Process victim = sim.spawn("victim", [](Simulation& s, int& n, decltype(inner) f) -> Task<> {
    const Witness local(n);
    co_await f(s, n);
  }(sim, alive, inner));
  sim.spawn("joiner", [](Simulation& s, Log& to, Process p) -> Task<> {
    const ProcessStatus status = co_await p;
    to.push_back(at(s, status == ProcessStatus::cancelled ? "cancelled" : "?"));
    const ProcessStatus again = co_await p;  // an ended process is joined at once
    to.push_back(at(s, again == ProcessStatus::cancelled ? "cancelled" : "?"));
  }(sim, log, victim));
  sim.run_until(2.0);
  CHECK(alive == 2);
  CHECK(victim.cancel());
  CHECK(alive == 0);
  CHECK_FALSE(victim.cancel());
  sim.run();
  CHECK(log == Log{"2 cancelled", "2 cancelled"});
  CHECK(sim.now() == 2.0);  // its delay went with it
}

TEST_CASE("cancelling a process that has not started", "[process]") {
  Simulation sim;
  Log log;
  Process never = sim.spawn("never", sleeper(sim, log, 1.0));
  never.cancel();
  sim.run();
  CHECK(log.empty());
  CHECK(sim.events_executed() == 0);
}

TEST_CASE("an abandoned simulation releases every frame", "[process]") {
  int alive = 0;
  std::optional<Process> handle;
  {
    Simulation sim;
    Store<int> store(sim, 1);
    Resource resource(sim, "r");
    Event<int> event(sim);
    for (int i = 0; i < 50; ++i) {
      handle =
          sim.spawn("p" + std::to_string(i),
                    [](Simulation& s, Store<int>& st, Resource& r, Event<int>& e, int& n, int me) -> Task<> {
                      const Witness local(n);
                      co_await s.delay(me);
                      Hold hold = co_await r.acquire();
                      co_await s.delay(3.0);
                      auto came = co_await first_of(st.put(me), e, s.delay(7.0));
                      if (came.index() == 0 && me % 3 == 0) hold.release();
                      const int item = co_await st.get([me](int x) { return x != me; });
                      co_await s.delay(item);
                    }(sim, store, resource, event, alive, i));
    }
    sim.run_until(25.0);
    CHECK(alive > 10);
  }
  CHECK(alive == 0);
  CHECK(handle->ended());
  CHECK(handle->name() == "p49");
}

TEST_CASE("resources may die before or after the simulation", "[process]") {
  for (const double stop : {0.5, 1.5, 2.5, 3.5}) {
    int alive = 0;
    auto sim = std::make_unique<Simulation>();
    auto resource = std::make_unique<Resource>(*sim, "r", 2);
    auto pool = std::make_unique<UnitPool<int>>(*sim, "pool");
    pool->add(7);
    for (int i = 0; i < 4; ++i) {
      sim->spawn("p", [](Simulation& s, Resource& r, UnitPool<int>& p, int& n) -> Task<> {
        const Witness local(n);
        co_await s.delay(1.0);
        Hold hold = co_await r.acquire();
        co_await s.delay(1.0);
        auto unit = co_await p.acquire();
        co_await s.delay(1.0);
      }(*sim, *resource, *pool, alive));
    }
    sim->run_until(stop);
    SECTION("resources first, stop at " + std::to_string(stop)) {
      resource.reset();
      pool.reset();
      sim.reset();
    }
    SECTION("simulation first, stop at " + std::to_string(stop)) {
      sim.reset();
      resource.reset();
      pool.reset();
    }
    sim.reset();
    CHECK(alive == 0);
  }
}

TEST_CASE("after an error in mid-instant everything can still be destroyed in any order", "[process]") {
  // The getter has been handed its item and the event its value, but neither has woken up when run() throws.
  auto sim = std::make_unique<Simulation>();
  auto store = std::make_unique<Store<std::unique_ptr<int>>>(*sim);
  auto event = std::make_unique<Event<std::string>>(*sim);
  auto container = std::make_unique<Container>(*sim, 10.0);
  sim->spawn("getter", [](Store<std::unique_ptr<int>>& s) -> Task<> { auto x = co_await s.get(); }(*store));
  sim->spawn("waiter", [](Event<std::string>& e) -> Task<> { auto x = co_await e; }(*event));
  sim->spawn("drain", [](Container& c) -> Task<> { co_await c.get(3.0); }(*container));
  sim->spawn(
      "bad",
      [](Simulation& s, Store<std::unique_ptr<int>>& st, Event<std::string>& e, Container& c) -> Task<> {
        co_await s.delay(1.0);
        auto item = std::make_unique<int>(3);
        co_await st.put(std::move(item));
        e.succeed("a text that does not fit into the string object itself");
        co_await c.put(5.0);
        throw std::runtime_error("bad");
      }(*sim, *store, *event, *container));
  CHECK_THROWS_AS(sim->run(), ProcessError);
  SECTION("sources first, then on") {
    store.reset();
    event.reset();
    container.reset();
    sim->run();
  }
  SECTION("sources first") {
    store.reset();
    event.reset();
    container.reset();
    sim.reset();
  }
  SECTION("simulation first") {
    sim.reset();
  }
}

TEST_CASE("process records and frames are reused", "[process]") {
  Simulation sim;
  int done = 0;
  sim.spawn("parent", [](Simulation& s, int& n) -> Task<> {
    for (int i = 0; i < 1000; ++i) {
      Process child = s.spawn("child", [](Simulation& inner, int& m) -> Task<> {
        co_await inner.delay(1.0);
        ++m;
      }(s, n));
      const ProcessStatus status = co_await child;
      CHECK(status == ProcessStatus::done);
    }
  }(sim, done));
  sim.run();
  CHECK(done == 1000);
  CHECK(sim.now() == 1000.0);
}

TEST_CASE("the trace names time, priority, process and the order of scheduling", "[process]") {
  Simulation sim;
  Log log;
  Log trace;
  std::vector<std::uint64_t> numbers;
  for (const int priority : {3, -2, 3}) sim.spawn("a", note_after(sim, log, "a", 1.0, priority));
  sim.set_trace([&](const TraceRecord& record) {
    trace.push_back(detail::text_of(record.time) + " " + std::to_string(record.priority) + " " +
                    std::string(record.process));
    numbers.push_back(record.sequence);
  });
  sim.run();
  CHECK(trace == Log{"0 0 a", "0 0 a", "0 0 a", "1 -2 a", "1 3 a", "1 3 a"});
  // Three starts, then three delays, numbered as they were asked for; whatever their priorities.
  const std::uint64_t first = numbers.at(0);
  CHECK(numbers == std::vector<std::uint64_t>{first, first + 1, first + 2, first + 4, first + 3, first + 5});
}
