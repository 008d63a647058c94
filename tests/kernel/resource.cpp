// Resources and pools of units: who is served when, and nobody ever twice.
#include "sim/kernel/resource.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "sim/kernel/kernel.h"

using namespace verstat::sim;
using Log = std::vector<std::string>;

namespace {

std::string at(const Simulation& sim, const std::string& what) {
  return detail::text_of(sim.now()) + " " + what;
}

Task<> use(Simulation& sim, Resource& resource, Log& log, std::string name, double start, double hold_time,
           int priority, int units) {
  co_await sim.delay(start);
  Hold hold = co_await resource.acquire(priority, units);
  log.push_back(at(sim, name + " in"));
  co_await sim.delay(hold_time);
  log.push_back(at(sim, name + " out"));
}

/// Works `work` time units, urgent or not, going on after pre-emptions.
Task<> preemptible(Simulation& sim, Resource& resource, Log& log, std::string name, double start, double work,
                   int priority) {
  co_await sim.delay(start);
  while (work > 0.0) {
    Hold hold = co_await resource.preempt(priority);
    const double began = sim.now();
    log.push_back(at(sim, name + " in"));
    auto done = co_await interruptible(sim.delay(work));
    work -= sim.now() - began;
    if (done.interrupted()) {
      CHECK(done.reason().code() == Reason::preempted);
      CHECK_FALSE(hold);
      log.push_back(at(sim, name + " evicted"));
    }
  }
  log.push_back(at(sim, name + " out"));
}

}  // namespace

TEST_CASE("requests are served by priority, then arrival", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r");
  Log log;
  sim.spawn("a", use(sim, resource, log, "a", 0.0, 10.0, 0, 1));
  sim.spawn("b", use(sim, resource, log, "b", 1.0, 1.0, 5, 1));
  sim.spawn("c", use(sim, resource, log, "c", 2.0, 1.0, 0, 1));
  sim.spawn("d", use(sim, resource, log, "d", 3.0, 1.0, 5, 1));
  sim.spawn("e", use(sim, resource, log, "e", 4.0, 1.0, -1, 1));
  sim.run();
  CHECK(log == Log{"0 a in", "10 a out", "10 e in", "11 e out", "11 c in", "12 c out", "12 b in", "13 b out",
                   "13 d in", "14 d out"});
}

TEST_CASE("who needs several units is not overtaken within its priority", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r", 3);
  Log log;
  sim.spawn("a", use(sim, resource, log, "a", 0.0, 5.0, 0, 2));
  sim.spawn("b", use(sim, resource, log, "b", 1.0, 5.0, 0, 3));
  sim.spawn("c", use(sim, resource, log, "c", 2.0, 5.0, 0, 1));
  sim.spawn("d", use(sim, resource, log, "d", 3.0, 0.5, -1, 1));  // more urgent: may
  sim.run();
  CHECK(log == Log{"0 a in", "3 d in", "3.5 d out", "5 a out", "5 b in", "10 b out", "10 c in", "15 c out"});
  CHECK(resource.in_use() == 0);
}

TEST_CASE("sniper: nobody gets in between release and waking", "[resource]") {
  // The holder releases at 5; the sniper arrives at 5, before or after it in the event list; the waiter has
  // been waiting since 1.
  for (const bool sniper_first : {true, false}) {
    Simulation sim;
    Resource resource(sim, "r");
    Log log;
    int inside = 0;
    const auto user = [](Simulation& s, Resource& r, Log& to, std::string name, double start,
                         double hold_time, int& n) -> Task<> {
      co_await s.delay(start);
      Hold hold = co_await r.acquire();
      CHECK(++n == 1);
      to.push_back(at(s, name));
      co_await s.delay(hold_time);
      --n;
    };
    if (sniper_first) sim.spawn("sniper", user(sim, resource, log, "sniper", 5.0, 1.0, inside));
    sim.spawn("holder", user(sim, resource, log, "holder", 0.0, 5.0, inside));
    sim.spawn("waiter", user(sim, resource, log, "waiter", 1.0, 1.0, inside));
    if (!sniper_first) sim.spawn("sniper", user(sim, resource, log, "sniper", 5.0, 1.0, inside));
    sim.run();
    CHECK(log == Log{"0 holder", "5 waiter", "6 sniper"});
  }
}

TEST_CASE("sniper: the waiter is cancelled at the instant it was granted", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r");
  Log log;
  sim.spawn("holder", use(sim, resource, log, "holder", 0.0, 5.0, 0, 1));
  Process waiter = sim.spawn("waiter", use(sim, resource, log, "waiter", 1.0, 1.0, 0, 1));
  sim.spawn("next", use(sim, resource, log, "next", 2.0, 1.0, 0, 1));
  sim.spawn("sniper", [](Simulation& s, Process w) -> Task<> {
    co_await s.delay(5.0);
    w.cancel();
  }(sim, waiter));
  sim.run();
  CHECK(log == Log{"0 holder in", "5 holder out", "5 next in", "6 next out"});
}

TEST_CASE("a hold is movable and gives back once", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r", 2);
  Hold a = resource.try_acquire();
  Hold b = resource.try_acquire();
  CHECK_FALSE(resource.try_acquire());
  Hold c = std::move(a);
  CHECK_FALSE(a);  // NOLINT: moved from on purpose
  CHECK(resource.in_use() == 2);
  c = std::move(b);
  CHECK(resource.in_use() == 1);
  c.release();
  c.release();
  CHECK(resource.in_use() == 0);
}

TEST_CASE("pre-emption evicts the least urgent, who may come back", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r", 2);
  Log log;
  sim.spawn("a", preemptible(sim, resource, log, "a", 0.0, 10.0, 5));
  sim.spawn("b", preemptible(sim, resource, log, "b", 1.0, 10.0, 5));
  sim.spawn("c", preemptible(sim, resource, log, "c", 2.0, 3.0, 1));  // evicts b, the last to come
  sim.spawn("d", preemptible(sim, resource, log, "d", 3.0, 1.0, 0));  // evicts a: c is more urgent
  sim.spawn("e", preemptible(sim, resource, log, "e", 3.5, 1.0, 1));  // nobody less urgent: waits
  sim.run();
  CHECK(log == Log{"0 a in", "1 b in", "2 c in", "2 b evicted", "3 d in", "3 a evicted", "4 d out", "4 e in",
                   "5 c out", "5 e out", "5 b in", "5 a in", "12 a out", "14 b out"});
}

TEST_CASE("pre-emption at the instant of the grant puts the granted one back in front", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r");
  Log log;
  sim.spawn("holder", use(sim, resource, log, "holder", 0.0, 5.0, 3, 1));
  sim.spawn("waiter", use(sim, resource, log, "waiter", 1.0, 1.0, 3, 1));
  sim.spawn("behind", use(sim, resource, log, "behind", 2.0, 1.0, 3, 1));
  sim.run_until(3.0);  // its delay shall end after that of the holder, at the same time
  sim.spawn("urgent", preemptible(sim, resource, log, "urgent", 2.0, 1.0, 0));
  sim.run();
  CHECK(log == Log{"0 holder in", "5 holder out", "5 urgent in", "6 urgent out", "6 waiter in",
                   "7 waiter out", "7 behind in", "8 behind out"});
}

TEST_CASE("who is evicted while it waits for more of the same does not let others be evicted in vain",
          "[resource]") {
  // 2 urgent, 3 others; "big" wants 4 and waits for the urgent ones. When they leave, two of three must go:
  // the first of them gives up a request behind "big", and the queue is looked at in the middle of it all.
  Simulation sim;
  Resource resource(sim, "r", 5);
  Log log;
  sim.spawn("urgent", use(sim, resource, log, "urgent", 0.0, 5.0, 0, 2));
  sim.spawn("greedy", [](Simulation& s, Resource& r, Log& to) -> Task<> {
    Hold hold = co_await r.acquire(9, 1);
    co_await s.delay(2.0);
    auto more = co_await interruptible(r.acquire(9, 1));
    to.push_back(at(s, more.interrupted() ? "greedy evicted" : "greedy has more"));
  }(sim, resource, log));
  sim.spawn("b", preemptible(sim, resource, log, "b", 0.0, 8.0, 5));
  sim.spawn("c", preemptible(sim, resource, log, "c", 0.0, 8.0, 3));
  sim.spawn("big", [](Simulation& s, Resource& r, Log& to) -> Task<> {
    co_await s.delay(1.0);
    Hold hold = co_await r.preempt(1, 4);
    to.push_back(at(s, "big in"));
    co_await s.delay(1.0);
    to.push_back(at(s, "big out"));
  }(sim, resource, log));
  sim.run();
  CHECK(log == Log{"0 urgent in", "0 b in", "0 c in", "5 urgent out", "5 greedy evicted", "5 b evicted",
                   "5 big in", "6 big out", "6 b in", "8 c out", "9 b out"});
}

TEST_CASE("a process does not evict itself", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r");
  Log log;
  sim.spawn("p", [](Simulation& s, Resource& r, Log& to) -> Task<> {
    Hold low = co_await r.acquire(5);
    auto came = co_await first_of(r.preempt(0), s.delay(3.0));
    to.push_back(at(s, std::to_string(came.index())));
    CHECK(low);
  }(sim, resource, log));
  sim.run();
  CHECK(log == Log{"3 1"});
}

TEST_CASE("capacity follows the shifts", "[resource]") {
  Simulation sim;
  Resource crew(sim, "crew", 0);
  Log log;
  sim.spawn("a", use(sim, crew, log, "a", 0.0, 5.0, 0, 1));
  sim.spawn("b", use(sim, crew, log, "b", 0.0, 5.0, 0, 1));
  sim.spawn("c", use(sim, crew, log, "c", 0.0, 5.0, 0, 1));
  sim.spawn("shifts", [](Simulation& s, Resource& r) -> Task<> {
    co_await s.delay(1.0);
    r.set_capacity(2);
    co_await s.delay(1.0);
    r.set_capacity(1);  // both finish
    CHECK(r.in_use() == 2);
    CHECK(r.free_units() == 0);
  }(sim, crew));
  sim.run();
  CHECK(log == Log{"1 a in", "1 b in", "6 a out", "6 b out", "6 c in", "11 c out"});
}

TEST_CASE("a shrinking capacity may pre-empt", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r", 2);
  Log log;
  sim.spawn("a", preemptible(sim, resource, log, "a", 0.0, 4.0, 1));
  sim.spawn("b", preemptible(sim, resource, log, "b", 0.0, 4.0, 2));
  sim.spawn("shifts", [](Simulation& s, Resource& r) -> Task<> {
    co_await s.delay(1.0);
    r.set_capacity(1, Resource::OnShrink::preempt);
    co_await s.delay(1.0);
    r.set_capacity(2);
  }(sim, resource));
  sim.run();
  CHECK(log == Log{"0 a in", "0 b in", "1 b evicted", "2 b in", "4 a out", "5 b out"});
}

TEST_CASE("resource statistics: level, queue, waits, from when they are enabled", "[resource]") {
  Simulation sim;
  Resource resource(sim, "r");
  Log log;
  CHECK(resource.statistics() == nullptr);
  resource.enable_statistics();
  sim.spawn("a", use(sim, resource, log, "a", 0.0, 4.0, 0, 1));
  sim.spawn("b", use(sim, resource, log, "b", 1.0, 2.0, 0, 1));
  sim.spawn("c", use(sim, resource, log, "c", 8.0, 1.0, 0, 1));
  sim.run_until(10.0);
  const QueueStatistics& statistics = *resource.statistics();
  CHECK(statistics.level.mean(10.0) == Approx(0.7).epsilon(1e-14));
  CHECK(statistics.length.mean(10.0) == Approx(0.3).epsilon(1e-14));
  CHECK(statistics.wait.count() == 3);
  CHECK(statistics.wait.mean() == Approx(1.0).epsilon(1e-14));
  CHECK(statistics.wait.max() == 3.0);
  resource.statistics()->reset(10.0);
  sim.run_until(12.0);
  CHECK(resource.statistics()->level.mean(12.0) == 0.0);
}

TEST_CASE("bad requests name the resource", "[resource]") {
  Simulation sim;
  CHECK_THROWS_WITH(Resource(sim, "crew", -1), "resource crew: capacity is -1, must be >= 0");
  Resource crew(sim, "crew", 1);
  CHECK_THROWS_WITH(crew.acquire(0, 0), Catch::Contains("resource crew: request for 0 units, must be >= 1"));
  CHECK_THROWS_WITH(crew.try_acquire(-2), Catch::Contains("request for -2 units"));
  CHECK_THROWS_WITH(crew.set_capacity(-3), Catch::Contains("capacity is -3"));
}

TEST_CASE("property: random use, interruption, cancellation, capacity changes: conserved and never too many",
          "[resource]") {
  const bool passed = rc::check("resource", [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    Simulation sim;
    RandomStream random(seed, "resource", "property");
    Resource resource(sim, "r", 3);
    resource.enable_statistics();
    int inside = 0;
    std::vector<Process> processes;
    const auto worker = [](Simulation& s, Resource& r, RandomStream& u, int& n) -> Task<> {
      for (int k = 0; k < 10; ++k) {
        try {
          co_await s.delay(std::floor(u.uniform(0.0, 4.0)));
          const int priority = static_cast<int>(u.below(3));
          const int units = 1 + static_cast<int>(u.below(2));
          Hold hold;
          if (u.below(2) == 0) {
            hold = co_await r.preempt(priority, units);
          } else if (u.below(2) == 0) {
            hold = co_await r.acquire(priority, units);
          } else {
            auto came =
                co_await first_of(r.preempt(priority, units), s.delay(std::floor(u.uniform(0.0, 3.0))));
            if (came.index() == 0) hold = std::move(came.template get<0>());
          }
          const int held = hold.units();
          n += held;
          auto slept = co_await interruptible(s.delay(std::floor(u.uniform(0.0, 4.0))));
          n -= held;
          if (!slept.interrupted()) RC_ASSERT(hold.units() == held);
        } catch (const Interrupted&) {
        }
      }
    };
    for (int i = 0; i < 8; ++i)
      processes.push_back(sim.spawn("w" + std::to_string(i), worker(sim, resource, random, inside)));
    for (int t = 1; t < 200 && !sim.empty(); ++t) {
      sim.run_until(t);
      RC_ASSERT(resource.in_use() >= 0);
      RC_ASSERT(resource.in_use() == inside);
      const std::uint64_t what = random.below(6);
      Process& who = processes[random.below(processes.size())];
      if (what == 0) who.interrupt("test");
      if (what == 1 && random.below(4) == 0 && who.status() == ProcessStatus::running) {
        // A cancelled worker cannot count itself out.
        sim.run_until(t + 0.25);
        who.interrupt("last");
        sim.run_until(t + 0.5);
      }
      if (what == 2) resource.set_capacity(1 + static_cast<int>(random.below(4)));
      if (what == 3) resource.set_capacity(2, Resource::OnShrink::preempt);
      sim.run_until(t + 0.75);
      if (what == 3) RC_ASSERT(resource.in_use() <= 2);
      RC_ASSERT(resource.in_use() == inside);
      RC_ASSERT(!(resource.free_units() >= 2 && resource.queue_length() > 0));
    }
  });
  CHECK(passed);
}

// ------------------------------------------------------------------------------------------- unit pools

namespace {

struct Worker {
  std::string name;
  int skill;
};

Task<> hire(Simulation& sim, UnitPool<Worker>& pool, Log& log, double start, int skill, double hold_time) {
  co_await sim.delay(start);
  auto who = co_await pool.acquire([skill](const Worker& w) { return w.skill >= skill; });
  log.push_back(at(sim, who->name));
  co_await sim.delay(hold_time);
}

}  // namespace

TEST_CASE("a pool gives the first unit that suits, and lets others by when none does", "[unit_pool]") {
  Simulation sim;
  UnitPool<Worker> crew(sim, "crew");
  crew.add(Worker{"ann", 1});
  crew.add(Worker{"bob", 2});
  crew.enable_statistics();
  Log log;
  sim.spawn("1", hire(sim, crew, log, 0.0, 2, 5.0));
  sim.spawn("2", hire(sim, crew, log, 1.0, 2, 1.0));  // needs bob
  sim.spawn("3", hire(sim, crew, log, 2.0, 1, 1.0));  // passes by
  sim.run();
  CHECK(log == Log{"0 bob", "2 ann", "5 bob"});
  CHECK(crew.in_use() == 0);
  CHECK(crew.statistics()->level.area(sim.now()) == Approx(7.0).epsilon(1e-14));
  CHECK(crew.statistics()->wait.mean() == Approx(4.0 / 3.0).epsilon(1e-14));
}

TEST_CASE("units go off and on shift; new units serve who waits", "[unit_pool]") {
  Simulation sim;
  UnitPool<Worker> crew(sim, "crew");
  const std::size_t ann = crew.add(Worker{"ann", 1});
  Log log;
  sim.spawn("1", hire(sim, crew, log, 0.0, 1, 2.0));
  sim.spawn("2", hire(sim, crew, log, 1.0, 1, 2.0));
  sim.spawn("3", hire(sim, crew, log, 1.5, 3, 2.0));
  sim.run_until(1.75);
  crew.set_available(ann, false);
  sim.run_until(4.0);
  CHECK(log == Log{"0 ann"});
  CHECK_FALSE(crew.is_held(ann));
  crew.add(Worker{"cleo", 3});
  sim.run_until(5.0);
  crew.set_available(ann, true);
  sim.run();
  CHECK(log == Log{"0 ann", "4 cleo", "6 cleo"});
}

TEST_CASE("sniper: a unit granted to a process that is interrupted in the same instant goes to the next",
          "[unit_pool]") {
  Simulation sim;
  UnitPool<Worker> crew(sim, "crew");
  crew.add(Worker{"ann", 1});
  Log log;
  sim.spawn("1", hire(sim, crew, log, 0.0, 1, 5.0));
  Process second = sim.spawn("2", hire(sim, crew, log, 1.0, 1, 1.0));
  sim.spawn("3", hire(sim, crew, log, 2.0, 1, 1.0));
  sim.spawn("sniper", [](Simulation& s, Process p) -> Task<> {
    co_await s.delay(5.0);
    p.cancel();
  }(sim, second));
  sim.run();
  CHECK(log == Log{"0 ann", "5 ann"});
  CHECK(sim.now() == 6.0);
}
