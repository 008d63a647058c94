// Lines and networks: tandem queues, saturated lines, machine repair, age replacement.
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/theory/estimate.h"

using namespace verstat::sim;
using verstat::sim::theory::antithetic_pairs;
using verstat::sim::theory::check_mean;

namespace {

RandomStream stream(std::string_view entity, std::size_t i, std::size_t replication, Sampling sampling) {
  return RandomStream(13, std::string(entity) + std::to_string(i), "time", replication, sampling);
}

using Stores = std::vector<std::unique_ptr<Store<int>>>;

Task<> feed(Simulation& sim, Store<int>& first, double rate, RandomStream random) {
  while (true) {
    co_await sim.delay(random.exponential(1.0 / rate));
    co_await first.put(1);
  }
}

/// `in` null: never starved; `out` null: never blocked.
Task<> station(Simulation& sim, Store<int>* in, Store<int>* out, double mean, RandomStream random,
               double& made) {
  while (true) {
    if (in != nullptr) co_await in->get();
    co_await sim.delay(random.exponential(mean));
    if (out != nullptr) co_await out->put(1);
    ++made;
  }
}

/// A machine that keeps its part until the next machine is free: no buffer in between.
Task<> part(Simulation& sim, std::vector<std::unique_ptr<Resource>>& machines,
            std::vector<RandomStream>& random, double& made, Hold first) {
  Hold here = std::move(first);
  for (std::size_t i = 0; i < machines.size(); ++i) {
    if (i > 0) {
      Hold next = co_await machines[i]->acquire();
      here = std::move(next);  // gives the machine before free
    }
    co_await sim.delay(random[i].exponential(1.0));
  }
  ++made;
}

Task<> endless_supply(Simulation& sim, std::vector<std::unique_ptr<Resource>>& machines,
                      std::vector<RandomStream>& random, double& made) {
  while (true) {
    Hold hold = co_await machines[0]->acquire();
    sim.spawn("part", part(sim, machines, random, made, std::move(hold)));
  }
}

}  // namespace

TEST_CASE("open tandem network (Jackson)", "[theory]") {
  const double lambda = 0.5;
  const std::vector<double> means = {1.0, 0.8, 1.2};
  const auto tallies = antithetic_pairs(30, [&](std::size_t r, Sampling sampling) {
    Simulation sim;
    Stores queues;
    double made = 0.0;
    for (std::size_t i = 0; i < means.size(); ++i) queues.push_back(std::make_unique<Store<int>>(sim));
    for (std::size_t i = 0; i < means.size(); ++i) {
      Store<int>* out = i + 1 < means.size() ? queues[i + 1].get() : nullptr;
      sim.spawn("station",
                station(sim, queues[i].get(), out, means[i], stream("station", i, r, sampling), made));
      queues[i]->enable_statistics();
    }
    sim.spawn("source", feed(sim, *queues[0], lambda, stream("source", 0, r, sampling)));
    sim.run_until(2000.0);
    for (auto& queue : queues) queue->statistics()->reset(2000.0);
    sim.run_until(3.5e5);
    std::vector<double> out;
    for (auto& queue : queues) out.push_back(queue->statistics()->level.mean(sim.now()));
    return out;
  });
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double rho = lambda * means[i];
    check_mean("queue", tallies[i], rho * rho / (1.0 - rho));
  }
}

TEST_CASE("saturated lines without buffers", "[theory]") {
  // Two stations: 2/3; three: 22/39; four: 0.5148 (Hunt, Oper. Res. 4 (1956) 674).
  const std::vector<double> expected = {2.0 / 3.0, 22.0 / 39.0, 0.5148};
  for (std::size_t n = 2; n <= 4; ++n) {
    const auto tallies = antithetic_pairs(20, [&](std::size_t r, Sampling sampling) {
      Simulation sim;
      std::vector<std::unique_ptr<Resource>> machines;
      std::vector<RandomStream> random;
      double made = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        machines.push_back(std::make_unique<Resource>(sim, "machine"));
        random.push_back(stream("machine", i, r, sampling));
      }
      sim.spawn("supply", endless_supply(sim, machines, random, made));
      sim.run_until(500.0);
      made = 0.0;
      sim.run_until(500.0 + 4e4);
      return std::vector<double>{made / 4e4};
    });
    INFO(n << " stations");
    check_mean("throughput", tallies[0], expected[n - 2]);
  }
}

TEST_CASE("saturated two-station lines with a buffer", "[theory]") {
  for (const std::size_t buffer : {1U, 3U, 8U}) {
    const auto tallies = antithetic_pairs(20, [&](std::size_t r, Sampling sampling) {
      Simulation sim;
      Store<int> between(sim, buffer);
      double first = 0.0;
      double made = 0.0;
      sim.spawn("a", station(sim, nullptr, &between, 1.0, stream("station", 0, r, sampling), first));
      sim.spawn("b", station(sim, &between, nullptr, 1.0, stream("station", 1, r, sampling), made));
      sim.run_until(500.0);
      made = 0.0;
      sim.run_until(500.0 + 4e4);
      return std::vector<double>{made / 4e4};
    });
    INFO("buffer " << buffer);
    const double b = static_cast<double>(buffer);
    check_mean("throughput", tallies[0], (b + 2.0) / (b + 3.0));
  }
}

TEST_CASE("machine repair, M/M/c/K/K", "[theory]") {
  const int machines = 6;
  const int crew = 2;
  const double fail = 0.2;  // per machine and time unit
  const double repair = 1.0;
  // Birth and death: k machines are down.
  std::vector<double> p{1.0};
  for (int k = 1; k <= machines; ++k) {
    p.push_back(p.back() * (machines - k + 1) * fail / (std::min(k, crew) * repair));
  }
  double sum = 0.0;
  double down = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) {
    sum += p[k];
    down += p[k] * static_cast<double>(k);
  }
  down /= sum;
  const double rate = (machines - down) * fail;

  const auto tallies = antithetic_pairs(25, [&](std::size_t r, Sampling sampling) {
    Simulation sim;
    Resource repairers(sim, "crew", crew);
    repairers.enable_statistics();
    double repairs = 0.0;
    TimeWeighted broken;
    for (int m = 0; m < machines; ++m) {
      sim.spawn("machine",
                [](Simulation& s, Resource& c, RandomStream u, double f, double rep, double& n,
                   TimeWeighted& b) -> Task<> {
                  while (true) {
                    co_await s.delay(u.exponential(1.0 / f));
                    b.change(s.now(), 1.0);
                    {
                      Hold hold = co_await c.acquire();
                      co_await s.delay(u.exponential(1.0 / rep));
                    }
                    b.change(s.now(), -1.0);
                    ++n;
                  }
                }(sim, repairers, stream("machine", static_cast<std::size_t>(m), r, sampling), fail, repair,
                                    repairs, broken));
    }
    sim.run_until(500.0);
    repairs = 0.0;
    broken.reset(500.0);
    repairers.statistics()->reset(500.0);
    const double end = 1.3e5;
    sim.run_until(end);
    return std::vector<double>{repairs / (end - 500.0), broken.mean(end),
                               repairers.statistics()->length.mean(end)};
  });
  check_mean("repairs", tallies[0], rate);
  check_mean("machines down", tallies[1], down);
  check_mean("waiting for repair", tallies[2], down - rate / repair);
}

TEST_CASE("age replacement: cost rate", "[theory]") {
  // Weibull life, shape 2, scale 1: R(t) = exp(-t^2), integral of R to T = sqrt(pi)/2 erf(T).
  const double age = 0.6;
  const double planned = 1.0;
  const double failed = 5.0;
  const double reliability = std::exp(-age * age);
  const double cycle = 0.5 * std::sqrt(std::numbers::pi) * std::erf(age);
  const double expected = (planned * reliability + failed * (1.0 - reliability)) / cycle;
  const Distribution life = Distribution::weibull(1.0, 2.0);
  const auto tallies = antithetic_pairs(20, [&](std::size_t r, Sampling sampling) {
    Simulation sim;
    double cost = 0.0;
    sim.spawn("unit",
              [](Simulation& s, Distribution law, RandomStream u, double limit, double cp, double cf,
                 double& sum) -> Task<> {
                while (true) {
                  auto came = co_await first_of(s.delay(law.sample(u)), s.delay(limit));
                  sum += came.index() == 0 ? cf : cp;
                }
              }(sim, life, stream("unit", 0, r, sampling), age, planned, failed, cost));
    sim.run_until(3e4);
    return std::vector<double>{cost / 3e4};
  });
  check_mean("cost rate", tallies[0], expected);
}

TEST_CASE("doubling every duration doubles every clock time, bit for bit", "[theory]") {
  const auto run = [](double factor) {
    Simulation sim;
    std::vector<double> times;
    Resource resource(sim, "r", 2);
    Store<int> store(sim, 3);
    for (std::size_t i = 0; i < 5; ++i) {
      sim.spawn(
          "p",
          [](Simulation& s, Resource& r, Store<int>& st, RandomStream u, double f, int me,
             std::vector<double>& out) -> Task<> {
            for (int k = 0; k < 200; ++k) {
              Hold hold = co_await r.acquire(static_cast<int>(u.below(3)));
              auto came = co_await first_of(s.delay(f * u.exponential(1.0)), s.delay(f * u.exponential(2.0)));
              hold.release();
              out.push_back(s.now());
              if (me < 2) {
                co_await st.put(k);
              } else if (came.index() == 0 && !st.empty()) {
                co_await st.get();
              }
              co_await s.delay(f * u.uniform());
            }
          }(sim, resource, store, stream("p", i, 0, Sampling::plain), factor, static_cast<int>(i), times));
    }
    sim.run();
    return times;
  };
  const std::vector<double> once = run(1.0);
  const std::vector<double> twice = run(2.0);
  REQUIRE(once.size() == twice.size());
  REQUIRE(once.size() > 600);
  for (std::size_t i = 0; i < once.size(); ++i) CHECK(2.0 * once[i] == twice[i]);
}
