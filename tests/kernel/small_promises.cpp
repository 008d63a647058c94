// Promises that seeded faults (tools/mutate.mjs) broke without any other test noticing.
#include <limits>
#include <optional>
#include <queue>
#include <string>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include "sim/kernel/event_list.h"
#include "sim/kernel/kernel.h"

using namespace verstat::sim;

namespace {

Task<> note_at(Simulation& sim, std::string& order, char name, double time) {
  co_await sim.delay(time);
  order += name;
}

/// Tries to start a process when it is destroyed.
class Heir {
 public:
  Heir(Simulation& sim, std::string& answer) : sim_(&sim), answer_(&answer) {}
  Heir(const Heir&) = delete;
  Heir& operator=(const Heir&) = delete;
  ~Heir() {
    try {
      sim_->spawn("late", [](Simulation& s) -> Task<> { co_await s.delay(1.0); }(*sim_));
      *answer_ = "started";
    } catch (const SimulationError& error) {
      *answer_ = error.what();
    }
  }

 private:
  Simulation* sim_;
  std::string* answer_;
};

}  // namespace

TEST_CASE("a simulation that is destroyed starts nothing any more", "[process]") {
  std::string answer;
  int served = 0;
  {
    Simulation sim;
    Resource bench(sim, "bench", 1);
    sim.spawn("holder", [](Simulation& s, Resource& b, std::string& out) -> Task<> {
      const Heir heir(s, out);
      const Hold hold = co_await b.acquire();
      co_await s.delay(100.0);
    }(sim, bench, answer));
    sim.spawn("waiter", [](Resource& b, int& n) -> Task<> {
      const Hold hold = co_await b.acquire();
      ++n;
    }(bench, served));
    sim.run_until(1.0);
  }
  CHECK(answer == "spawn(\"late\") while the simulation is destroyed");
  CHECK(served == 0);
}

TEST_CASE("a process that waits to start is interrupted once", "[process]") {
  Simulation sim;
  std::string reason;
  Process victim = sim.spawn("victim", [](Simulation& s, std::string& out) -> Task<> {
    const auto wait = co_await interruptible(s.delay(5.0));
    out = wait.interrupted() ? wait.reason().text() : "none";
  }(sim, reason));
  CHECK(victim.interrupt("first"));
  CHECK_FALSE(victim.interrupt("second"));
  sim.run();
  CHECK(reason == "first");
}

TEST_CASE("a delay among several waits keeps its turn within the instant", "[composite]") {
  Simulation sim;
  std::string order;
  sim.spawn("first", [](Simulation& s, std::string& out) -> Task<> {
    const auto came = co_await first_of(s.delay(1.0), s.delay(2.0));
    out += came.index() == 0 ? 'a' : '?';
  }(sim, order));
  sim.spawn("second", note_at(sim, order, 'b', 1.0));
  sim.spawn("third", [](Simulation& s, std::string& out) -> Task<> {
    co_await all_of(s.delay(0.5), s.delay(1.0));
    out += 'c';
  }(sim, order));
  sim.spawn("fourth", note_at(sim, order, 'd', 1.0));
  sim.run();
  CHECK(order == "abcd");
}

TEST_CASE("statistics switched on late know who waits already", "[resource]") {
  Simulation sim;
  Resource bench(sim, "bench", 1);
  for (int i = 0; i < 3; ++i) {
    sim.spawn("p", [](Simulation& s, Resource& b) -> Task<> {
      const Hold hold = co_await b.acquire();
      co_await s.delay(10.0);
    }(sim, bench));
  }
  sim.run_until(4.0);
  bench.enable_statistics();
  sim.run_until(8.0);
  CHECK(bench.statistics()->length.mean(8.0) == 2.0);
  CHECK(bench.statistics()->level.mean(8.0) == 1.0);
}

TEST_CASE("the statistics of a container: content, who waits and how long", "[container]") {
  Simulation sim;
  Container tank(sim, 10.0, 4.0, "tank");
  tank.enable_statistics();
  sim.spawn("taker", [](Simulation& s, Container& c) -> Task<> {
    co_await s.delay(1.0);
    co_await c.get(8.0);  // there are 4: waits until 3
  }(sim, tank));
  sim.spawn("giver", [](Simulation& s, Container& c) -> Task<> {
    co_await s.delay(3.0);
    co_await c.put(6.0);
    co_await s.delay(1.0);
    co_await c.put(9.0);  // there are 2: waits until the end
  }(sim, tank));
  sim.run_until(5.0);
  const QueueStatistics& statistics = *tank.statistics();
  // 4 until 3, then 10 - 8 = 2; one waits from 1 to 3, another from 4 on.
  CHECK(statistics.level.mean(5.0) == Approx((3 * 4.0 + 2 * 2.0) / 5).epsilon(1e-14));
  CHECK(statistics.length.mean(5.0) == Approx(3.0 / 5).epsilon(1e-14));
  CHECK(statistics.wait.count() == 2);
  CHECK(statistics.wait.mean() == Approx(1.0).epsilon(1e-14));
}

TEST_CASE("a rate profile that ends busy is inverted in its last piece, too", "[arrivals]") {
  const RateProfile day({4.0, 2.0, 2.0}, {1.0, 0.0, 3.0});
  for (double t = 0.05; t < 20.0; t += 0.1) {
    if (day.rate(t) > 0.0) CHECK(day.time_of(day.expected(t)) == Approx(t).epsilon(1e-12));
  }
  CHECK(day.time_of(7.0) == Approx(7.0));
}

TEST_CASE("MSER-5 drops nothing of a constant", "[intervals]") {
  const Truncation truncation = mser5(std::vector<double>(100, 3.0));
  CHECK(truncation.drop == 0);
  CHECK(truncation.reliable);
}

TEST_CASE("replications stop at the least number, and when the precision is just reached", "[replications]") {
  const ReplicationOutcome constant =
      replicate_until(Precision(0.05, 10, 100), 1, [](std::size_t) { return 2.0; });
  CHECK(constant.precise);
  CHECK(constant.results.size() == 10);
  // 1, 3, 1, 3: the width of the first four is the precision asked for.
  const auto alternating = [](std::size_t i) { return i % 2 == 0 ? 1.0 : 3.0; };
  Tally four;
  for (std::size_t i = 0; i < 4; ++i) four.add(alternating(i));
  const double width = confidence_interval(four).relative_half_width();
  const ReplicationOutcome reached = replicate_until(Precision(width, 4, 100), 1, alternating);
  CHECK(reached.precise);
  CHECK(reached.results.size() == 4);
}

TEST_CASE("ten thousand events pushed in bursts leave in order", "[event_list]") {
  // Bursts far larger than what the list was laid out for, with events cancelled and others just pushed.
  using Key = std::tuple<double, detail::EventId, std::uintptr_t>;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    RandomStream random(seed, "events", "burst");
    detail::EventList list;
    std::priority_queue<Key, std::vector<Key>, std::greater<>> model;
    double now = 0.0;
    std::uintptr_t payload = 0;
    const auto pop = [&] {
      const detail::Entry entry = list.pop(now);
      REQUIRE(Key(entry.time, entry.id, entry.payload) == model.top());
      model.pop();
      now = entry.time;
    };
    for (const int burst : {300, 3, 2500, 40, 12'000, 1, 700, 9000}) {
      for (int i = 0; i < burst; ++i) {
        const double time = now + random.exponential(burst % 2 == 0 ? 1.0 : 100.0);
        const detail::EventId id = list.push(time, 0, ++payload);
        model.emplace(time, id, payload);
      }
      for (int i = 0; i < burst / 3; ++i) pop();
      REQUIRE(list.size() == model.size());
    }
    while (!model.empty()) pop();
    CHECK(list.empty());
    CHECK(list.size() == 0);
  }
}
