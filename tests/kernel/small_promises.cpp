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

TEST_CASE("laws without scatter are steps", "[distribution]") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Distribution& law :
       {Distribution::constant(3.0), Distribution::normal(3.0, 0.0), Distribution::lognormal(3.0, 0.0)}) {
    INFO(law.describe());
    CHECK(law.cdf(2.999) == 0.0);
    CHECK(law.cdf(3.001) == 1.0);
    CHECK(law.quantile(0.0) == Approx(3.0).epsilon(1e-15));
    CHECK(law.quantile(0.3) == Approx(3.0).epsilon(1e-15));
    CHECK(law.quantile(1.0) == Approx(3.0).epsilon(1e-15));
    CHECK(law.mean() == Approx(3.0).epsilon(1e-15));
    CHECK(law.variance() == 0.0);
    CHECK(law.cdf(-infinity) == 0.0);
  }
  CHECK(Distribution::constant(3.0).cdf(3.0) == 1.0);
  CHECK(Distribution::normal(3.0, 0.0).cdf(3.0) == 1.0);
}

TEST_CASE("a discrete law counts what comes twice as one value", "[distribution]") {
  const Distribution dice = Distribution::discrete({2.0, 1.0, 2.0, 5.0}, {1.0, 2.0, 1.0, 4.0});
  CHECK(dice.describe() == "discrete(values 3)");
  CHECK(dice.cdf(0.5) == 0.0);
  CHECK(dice.cdf(1.0) == 0.25);
  CHECK(dice.cdf(2.0) == 0.5);
  CHECK(dice.cdf(4.9) == 0.5);
  CHECK(dice.cdf(5.0) == 1.0);
  CHECK(dice.quantile(0.0) == 1.0);
  CHECK(dice.quantile(1.0) == 5.0);
  CHECK(dice.mean() == Approx(0.25 * 1 + 0.25 * 2 + 0.5 * 5));
}

TEST_CASE("every range of a law is refused with its parameter and value", "[distribution]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  using D = Distribution;
  CHECK_THROWS_WITH(D::triangular(5.0, 5.0, 5.0), "distribution triangular: low = 5, allowed < high = 5");
  CHECK_THROWS_WITH(D::triangular(1.0, 0.5, 5.0), Catch::Contains("mode = 0.5, allowed from low = 1"));
  CHECK_THROWS_WITH(D::normal(1.0, -2.0), "distribution normal: sd = -2, allowed >= 0");
  CHECK_THROWS_WITH(D::truncated_normal(0.0, 1.0, 2.0, 2.0), Catch::Contains("low = 2, allowed < high = 2"));
  CHECK_THROWS_WITH(D::truncated_normal(0.0, 1.0, -80.0, -70.0),
                    Catch::Contains("probability of the interval"));
  CHECK_THROWS_WITH(D::beta(1.0, 1.0, 4.0, 4.0), Catch::Contains("low = 4, allowed < high = 4"));
  CHECK_THROWS_WITH(D::pert(4.0, 4.0, 4.0), Catch::Contains("low = 4, allowed < high = 4"));
  CHECK_THROWS_WITH(D::pert(1.0, 0.0, 4.0), Catch::Contains("mode = 0, allowed from low = 1 to high = 4"));
  CHECK_THROWS_WITH(D::pert(1.0, 9.0, 4.0), Catch::Contains("mode = 9, allowed from low = 1 to high = 4"));
  CHECK_THROWS_WITH(D::lognormal(1.0, -0.5), Catch::Contains("cv = -0.5, allowed finite and >= 0"));
  CHECK_THROWS_WITH(D::weibull_mean_cv(1.0, 30.0), Catch::Contains("cv = 30, allowed from 0.01 to 20"));
  CHECK_THROWS_WITH(D::discrete({1.0, 2.0}, {1.0}), Catch::Contains("2 values and 1 weights"));
  CHECK_THROWS_WITH(D::discrete({1.0}, {-1.0}), Catch::Contains("weight = -1, allowed finite and >= 0"));
  CHECK_THROWS_WITH(D::discrete({1.0, 2.0}, {1e308, 1e308}), Catch::Contains("sum of weights = inf"));
  CHECK_THROWS_WITH(D::empirical({nan, 1.0}, {1.0, 2.0}), Catch::Contains("observation = nan"));
  CHECK_THROWS_WITH(D::empirical({2.0, 1.0}, {1.0, infinity}), Catch::Contains("weight = inf"));
  CHECK_THROWS_WITH(D::empirical({2.0, 1.0}, {-1.0, 1.0}), Catch::Contains("weight = -1"));
  CHECK_THROWS_WITH(D::empirical({2.0, 1.0, 3.0}, {1.5e308, 1.5e308, 1e308}),
                    Catch::Contains("sum of weights = inf"));
}

TEST_CASE("every range of profiles, histograms and resources is refused in words",
          "[arrivals][histogram][resource]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(RateProfile({}, {}), Catch::Contains("0 lengths and 0 rates"));
  CHECK_THROWS_WITH(RateProfile({infinity}, {1.0}), Catch::Contains("length = inf, allowed finite and > 0"));
  CHECK_THROWS_WITH(RateProfile({1.0}, {-1.0}), Catch::Contains("rate = -1, allowed finite and >= 0"));
  CHECK_THROWS_WITH(RateProfile({1.0}, {infinity}), Catch::Contains("rate = inf, allowed finite and >= 0"));
  CHECK(RateProfile({2.0, 3.0}, {0.0, 1.0}).time_of(0.0) == 0.0);
  CHECK_THROWS_WITH(Histogram(1.0, 1.0, 3), Catch::Contains("allowed low < high"));
  CHECK_THROWS_AS(Histogram(-infinity, 1.0, 3), std::invalid_argument);
  CHECK_THROWS_AS(Histogram(0.0, infinity, 3), std::invalid_argument);
  CHECK_THROWS_AS(Histogram(0.0, 1.0, 0), std::invalid_argument);
  Histogram histogram(0.0, 1.0, 3);
  CHECK_THROWS_AS(histogram.add(nan), std::invalid_argument);
  CHECK_THROWS_AS(histogram.merge(Histogram(0.5, 1.0, 3)), std::invalid_argument);
  CHECK_THROWS_AS(histogram.merge(Histogram(0.0, 2.0, 3)), std::invalid_argument);
  CHECK_THROWS_AS(histogram.merge(Histogram(0.0, 1.0, 4)), std::invalid_argument);
  CHECK(histogram.total() == 0);
  Simulation sim;
  CHECK_THROWS_WITH(Resource(sim, "bench", -1), "resource bench: capacity is -1, must be >= 0");
  Resource bench(sim, "bench", 1);
  CHECK_THROWS_WITH(bench.set_capacity(-2), Catch::Contains("capacity is -2, must be >= 0"));
  CHECK_THROWS_WITH(bench.try_acquire(0), Catch::Contains("request for 0 units, must be >= 1"));
  CHECK_THROWS_WITH(Container(sim, -1.0), Catch::Contains("capacity is -1, must be >= 0"));
  CHECK_THROWS_WITH(Container(sim, 5.0, -1.0),
                    Catch::Contains("level is -1, must be from 0 to the capacity 5"));
  CHECK_THROWS_WITH(Container(sim, 5.0, 6.0),
                    Catch::Contains("level is 6, must be from 0 to the capacity 5"));
  Container tank(sim, 5.0);
  CHECK_THROWS_WITH(tank.put(6.0), Catch::Contains("put of 6, must be finite and from 0 to the capacity 5"));
  CHECK_THROWS_WITH(tank.get(-1.0), Catch::Contains("get of -1, must be finite"));
}

TEST_CASE("who gives up waiting for a container leaves his place and what he had been given", "[container]") {
  Simulation sim;
  Container tank(sim, 10.0, 2.0, "tank");
  std::string order;
  sim.spawn("patient", [](Simulation& s, Container& c, std::string& out) -> Task<> {
    const auto came = co_await first_of(c.get(8.0), s.delay(3.0));
    out += came.index() == 0 ? 'A' : 'a';
  }(sim, tank, order));
  sim.spawn("modest", [](Simulation& s, Container& c, std::string& out) -> Task<> {
    co_await s.delay(1.0);
    co_await c.get(1.0);  // there would be enough, but the first stands before
    out += s.now() == 3.0 ? 'm' : '?';
  }(sim, tank, order));
  sim.run();
  CHECK(order == "am");
  CHECK(tank.level() == 1.0);

  // Served and interrupted in the same instant: what he was given flows back.
  Process victim = sim.spawn("victim", [](Container& c, std::string& out) -> Task<> {
    const auto wait = co_await interruptible(c.get(5.0));
    out += wait.interrupted() ? 'v' : 'V';
  }(tank, order));
  sim.spawn("giver", [](Simulation& s, Container& c, Process p) -> Task<> {
    co_await s.delay(1.0);
    co_await c.put(6.0);
    p.interrupt("never mind");
  }(sim, tank, victim));
  sim.run();
  CHECK(order == "amv");
  CHECK(tank.level() == 7.0);
}

TEST_CASE("Simulation refuses what would go wrong inside a process, with its place", "[process]") {
  Simulation sim;
  std::vector<std::string> said;
  const auto refused = [&said](auto&& what) {
    try {
      what();
      said.emplace_back("done");
    } catch (const SimulationError& error) {
      said.emplace_back(error.what());
    }
  };
  sim.spawn("p", [](Simulation& s, decltype(refused)& attempt) -> Task<> {
    co_await s.delay(1.0);
    attempt([&] { s.run(); });
    attempt([&] { s.run_until(5.0); });
    attempt([&] { s.step(); });
  }(sim, refused));
  sim.run();
  CHECK(said == std::vector<std::string>{"t = 1, process p: run() called from inside a process",
                                         "t = 1, process p: run_until() called from inside a process",
                                         "t = 1, process p: step() called from inside a process"});
  said.clear();
  refused([&] { sim.set_budget(0, 5); });
  refused([&] { sim.set_budget(5, 0); });
  refused([&] { sim.spawn("x", 40'000, note_at(sim, said.emplace_back(), 'x', 1.0)); });
  refused([&] { sim.run_until(std::numeric_limits<double>::infinity()); });
  CHECK(said[0] == "set_budget: both budgets must be >= 1");
  CHECK(said[1] == "set_budget: both budgets must be >= 1");
  CHECK_THAT(said[3], Catch::Contains("priority is 40000, must be from -32768 to 32767"));
  CHECK_THAT(said[4], Catch::Contains("run_until(inf), must be finite and >= now"));
}

TEST_CASE("an exception that is none of the standard library's is reported with its place", "[process]") {
  Simulation sim;
  sim.spawn("p", [](Simulation& s) -> Task<> {
    co_await s.delay(1.0);
    throw 7;
  }(sim));
  CHECK_THROWS_WITH(sim.run(), "t = 1, process p: an exception that is no std::exception");
}

TEST_CASE("what a container gave at once flows back when the whole wait is given up", "[container]") {
  Simulation sim;
  Container tank(sim, 10.0, 4.0, "tank");
  bool interrupted = false;
  Process victim = sim.spawn("victim", [](Simulation& s, Container& c, bool& out) -> Task<> {
    const auto wait = co_await interruptible(all_of(c.get(3.0), s.delay(5.0)));
    out = wait.interrupted();
  }(sim, tank, interrupted));
  sim.run_until(1.0);
  CHECK(tank.level() == 1.0);
  victim.interrupt("never mind");
  sim.run();
  CHECK(interrupted);
  CHECK(tank.level() == 4.0);
}
