// One station: M/M/1, M/M/c, M/G/1, loss, priorities, and the Lindley recursion.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/theory/estimate.h"

using namespace verstat::sim;
using verstat::sim::theory::antithetic_pairs;
using verstat::sim::theory::check_mean;

namespace {

constexpr double warm_up = 2000.0;

struct Station {
  Station(Simulation& s, int servers) : sim(s), server(s, "server", servers) {}
  Simulation& sim;
  Resource server;
  Tally sojourn;
  TimeWeighted inside;
  double start = warm_up;
};

Task<> customer(Station& st, double service, int priority) {
  const double arrived = st.sim.now();
  st.inside.change(arrived, 1.0);
  {
    Hold hold = co_await st.server.acquire(priority);
    co_await st.sim.delay(service);
  }
  st.inside.change(st.sim.now(), -1.0);
  if (arrived >= st.start) st.sojourn.add(st.sim.now() - arrived);
}

Task<> source(Station& st, Distribution gap, Distribution service, RandomStream gaps, RandomStream services) {
  while (true) {
    co_await st.sim.delay(gap.sample(gaps));
    st.sim.spawn("customer", customer(st, service.sample(services), 0));
  }
}

/// Mean wait, mean queue, utilization of a G/G/c station from the end of the warm-up to `end`.
std::vector<double> run_station(const Distribution& gap, const Distribution& service, int servers, double end,
                                std::size_t replication, Sampling sampling) {
  Simulation sim;
  Station st(sim, servers);
  st.server.enable_statistics();
  sim.spawn("source", source(st, gap, service, RandomStream(11, "source", "gap", replication, sampling),
                             RandomStream(11, "server", "service", replication, sampling)));
  sim.run_until(warm_up);
  st.server.statistics()->reset(warm_up);
  sim.run_until(end);
  const QueueStatistics& statistics = *st.server.statistics();
  return {statistics.wait.mean(), statistics.length.mean(end), statistics.level.mean(end) / servers,
          st.sojourn.mean()};
}

double erlang_c(int servers, double load) {
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; k < servers; ++k) sum += term *= load / k;
  const double last = term * load / servers / (1.0 - load / servers);
  return last / (sum + last);
}

}  // namespace

TEST_CASE("M/M/1", "[theory]") {
  const double lambda = 0.5;
  const auto tallies = antithetic_pairs(40, [&](std::size_t i, Sampling sampling) {
    return run_station(Distribution::exponential(1.0 / lambda), Distribution::exponential(1.0), 1, 3e5, i,
                       sampling);
  });
  const double rho = lambda;
  check_mean("wait", tallies[0], rho / (1.0 - rho));
  check_mean("queue", tallies[1], rho * rho / (1.0 - rho));
  check_mean("utilization", tallies[2], rho);
  check_mean("sojourn", tallies[3], 1.0 / (1.0 - rho));
}

TEST_CASE("M/M/c", "[theory]") {
  const int c = 3;
  const double lambda = 1.8;  // utilization 0.6
  const auto tallies = antithetic_pairs(30, [&](std::size_t i, Sampling sampling) {
    return run_station(Distribution::exponential(1.0 / lambda), Distribution::exponential(1.0), c, 1.6e5, i,
                       sampling);
  });
  const double wait = erlang_c(c, lambda) / (c - lambda);
  check_mean("wait", tallies[0], wait);
  check_mean("queue", tallies[1], lambda * wait);
  check_mean("utilization", tallies[2], lambda / c);
  check_mean("sojourn", tallies[3], 1.0 + wait);
}

TEST_CASE("M/G/1: Pollaczek-Khinchine", "[theory]") {
  const double lambda = 0.5;
  const std::vector<Distribution> services = {Distribution::constant(1.0), Distribution::uniform(0.2, 1.8),
                                              Distribution::weibull_mean_cv(1.0, 0.7),
                                              Distribution::discrete({0.5, 3.0}, {0.8, 0.2})};
  for (const Distribution& service : services) {
    INFO(service.describe());
    const auto tallies = antithetic_pairs(30, [&](std::size_t i, Sampling sampling) {
      return run_station(Distribution::exponential(1.0 / lambda), service, 1, 2.5e5, i, sampling);
    });
    const double second_moment = service.variance() + service.mean() * service.mean();
    const double wait = lambda * second_moment / (2.0 * (1.0 - lambda * service.mean()));
    check_mean("wait", tallies[0], wait);
    check_mean("queue", tallies[1], lambda * wait);
    check_mean("sojourn", tallies[3], wait + service.mean());
  }
}

TEST_CASE("G/G/1 customer by customer: the Lindley recursion", "[theory]") {
  // The same draws through the kernel and through W' = max(0, W + S - A): no statistics, only rounding.
  const Distribution gap = Distribution::weibull(1.0, 0.8);
  const Distribution service = Distribution::lognormal(0.9, 1.5);
  constexpr int n = 20'000;
  struct Served {
    std::vector<double> waits;
  };
  Served served;
  Simulation sim;
  Resource server(sim, "server");
  sim.spawn("source", [](Simulation& s, Resource& r, Distribution g, Distribution v, Served& out) -> Task<> {
    RandomStream gaps(3, "source", "gap");
    RandomStream services(3, "server", "service");
    for (int i = 0; i < n; ++i) {
      co_await s.delay(g.sample(gaps));
      s.spawn("customer", [](Simulation& in, Resource& res, double time, Served& to) -> Task<> {
        const double arrived = in.now();
        Hold hold = co_await res.acquire();
        to.waits.push_back(in.now() - arrived);
        co_await in.delay(time);
      }(s, r, v.sample(services), out));
    }
  }(sim, server, gap, service, served));
  sim.run();
  REQUIRE(served.waits.size() == n);
  RandomStream gaps(3, "source", "gap");
  RandomStream services(3, "server", "service");
  double wait = 0.0;
  double worst = 0.0;
  double clock = gap.sample(gaps);
  for (const double simulated : served.waits) {
    worst = std::max(worst, std::abs(simulated - wait));
    const double next_gap = gap.sample(gaps);
    wait = std::max(0.0, wait + service.sample(services) - next_gap);
    clock += next_gap;
  }
  // Rounding of clock values, accumulated over a busy period.
  CHECK(worst < 1e-9 * clock / 20'000.0);
}

TEST_CASE("Little's law holds in every run, to rounding", "[theory]") {
  Simulation sim;
  Station st(sim, 2);
  st.start = 0.0;
  sim.spawn("source", [](Station& station) -> Task<> {
    RandomStream random(5, "source", "gap");
    for (int i = 0; i < 5000; ++i) {
      co_await station.sim.delay(random.exponential(1.0));
      station.sim.spawn("customer", customer(station, random.exponential(1.7), 0));
    }
  }(st));
  sim.run();  // until it is empty again
  CHECK(st.sojourn.count() == 5000);
  CHECK(st.inside.area(sim.now()) == Approx(st.sojourn.sum()).epsilon(1e-10));
}

TEST_CASE("M/M/1/K: loss", "[theory]") {
  const double rho = 0.8;
  const int room = 5;
  const auto tallies = antithetic_pairs(30, [&](std::size_t i, Sampling sampling) {
    Simulation sim;
    Store<int> queue(sim, room - 1);  // and one in service: at most K in the system
    std::array<double, 3> count{};    // arrived, lost, served
    sim.spawn(
        "source",
        [](Simulation& s, Store<int>& q, double rate, RandomStream u, std::array<double, 3>& n) -> Task<> {
          while (true) {
            co_await s.delay(u.exponential(1.0 / rate));
            ++n[0];
            if (!q.try_put(1)) ++n[1];
          }
        }(sim, queue, rho, RandomStream(7, "source", "gap", i, sampling), count));
    sim.spawn("server", [](Simulation& s, Store<int>& q, RandomStream u, std::array<double, 3>& n) -> Task<> {
      while (true) {
        co_await q.get();
        co_await s.delay(u.exponential(1.0));
        ++n[2];
      }
    }(sim, queue, RandomStream(7, "server", "service", i, sampling), count));
    sim.run_until(warm_up);
    count = {};
    const double span = 2e5;
    sim.run_until(warm_up + span);
    return std::vector<double>{count[1] / count[0], count[2] / span};
  });
  const double loss = (1.0 - rho) * std::pow(rho, room) / (1.0 - std::pow(rho, room + 1));
  check_mean("loss", tallies[0], loss);
  check_mean("throughput", tallies[1], rho * (1.0 - loss));
}

namespace {

struct Classes {
  Classes(Simulation& s, bool p) : sim(s), server(s, "server"), preemptive(p) {}
  Simulation& sim;
  Resource server;
  bool preemptive;
  std::array<Tally, 2> sojourn;
};

Task<> class_customer(Classes& st, int priority, double service) {
  const double arrived = st.sim.now();
  double left = service;
  while (left > 0.0) {
    Hold hold;
    if (st.preemptive) {
      hold = co_await st.server.preempt(priority);
    } else {
      hold = co_await st.server.acquire(priority);
    }
    const double began = st.sim.now();
    auto done = co_await interruptible(st.sim.delay(left));
    if (!done.interrupted()) break;
    left -= st.sim.now() - began;
  }
  if (arrived >= warm_up) st.sojourn[static_cast<std::size_t>(priority)].add(st.sim.now() - arrived);
}

Task<> class_source(Classes& st, int priority, double rate, RandomStream gaps, RandomStream services) {
  while (true) {
    co_await st.sim.delay(gaps.exponential(1.0 / rate));
    st.sim.spawn("customer", class_customer(st, priority, services.exponential(1.0)));
  }
}

std::vector<Tally> two_classes(bool preemptive) {
  return antithetic_pairs(40, [&](std::size_t i, Sampling sampling) {
    Simulation sim;
    Classes st(sim, preemptive);
    for (int priority = 0; priority < 2; ++priority) {
      const std::string name = "class " + std::to_string(priority);
      sim.spawn(name, class_source(st, priority, priority == 0 ? 0.2 : 0.35,
                                   RandomStream(9, name, "gap", i, sampling),
                                   RandomStream(9, name, "service", i, sampling)));
    }
    sim.run_until(1.5e5);
    return std::vector<double>{st.sojourn[0].mean(), st.sojourn[1].mean()};
  });
}

}  // namespace

TEST_CASE("M/M/1 with two priorities, not pre-emptive (Cobham)", "[theory]") {
  const auto tallies = two_classes(false);
  const double rest = 0.55;  // mean residual service: sum of rho_k / mu
  check_mean("urgent", tallies[0], 1.0 + rest / (1.0 - 0.2));
  check_mean("other", tallies[1], 1.0 + rest / ((1.0 - 0.2) * (1.0 - 0.55)));
}

TEST_CASE("M/M/1 with two priorities, pre-emptive resume", "[theory]") {
  const auto tallies = two_classes(true);
  check_mean("urgent", tallies[0], 1.0 / (1.0 - 0.2));
  check_mean("other", tallies[1], 1.0 / (1.0 - 0.2) + 0.55 / ((1.0 - 0.2) * (1.0 - 0.55)));
}
